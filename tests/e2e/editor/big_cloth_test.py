"""A jacquard of sixteen million crossings: opened, drawn on, changed as a whole, taken back and saved while the window
goes on. In the real window."""

import json
import os

from window_driver import expect, read_json, run, window

PROGRAM = os.environ["LOOMLIGHT"]
WIDTH, HEIGHT = 960, 600
SIDE = 4000


def big_fabric(home):
    rows = ["".join("#" if (7 * end + 3 * pick + (pick * end >> 9)) % 8 < 3 else "." for end in range(SIDE))
            for pick in range(0, SIDE, 40)]
    fabric = {
        "loomlight_version": 1, "name": "Big", "weave": [rows[pick // 40] for pick in range(SIDE)],
        "fibres": [{"name": "coarse", "radius_um": 20}], "drape": {"kind": "flat", "width_mm": 4, "height_mm": 4},
        "light": {"kind": "dome"}, "camera": {"distance_mm": 16, "elevation_deg": 75}, "render": {"resolution": 1},
    }
    file = os.path.join(home, "big.json")
    with open(file, "w", encoding="utf-8") as text:
        json.dump(fabric, text, indent=1)
    return file


class Designer:
    """Does one step after the other, and counts them."""

    def __init__(self, editor):
        self.editor, self.steps = editor, 0

    def step(self, what, act, done=lambda: True):
        self.steps += 1
        act()
        self.editor.wait_until(what, done)

    def edit(self, what, act):
        revision = self.editor.number("revision")
        self.step(what, act, lambda: self.editor.number("revision") > revision)


def type_file(editor, file):
    editor.key("ctrl+o")
    editor.click("browser.name")
    editor.key("ctrl+a")
    editor.type(file)
    editor.key("Return")


def choose(editor, command):
    editor.click("menu.weave")
    editor.click("menu." + command)


def work_through(designer, file):
    editor = designer.editor
    designer.step("open", lambda: type_file(editor, file),
                  lambda: editor.fact("name") == "Big" and editor.fact("dialog") == "none")
    x, y = editor.centre("draft.canvas")
    designer.step("look", lambda: editor.move(x, y))
    designer.step("zoom", lambda: editor.wheel(x, y, away=True, clicks=12))
    designer.step("pan", lambda: editor.drag((x, y), (x + 60, y + 40), 2))
    designer.edit("paint", lambda: editor.drag((x, y), (x + 40, y + 20)))
    designer.step("select", lambda: editor.key("ctrl+a"))
    designer.step("copy", lambda: editor.key("ctrl+c"))
    for what, key in (("invert", "ctrl+i"), ("paste", "ctrl+v"), ("shift", "Left")):
        designer.edit(what, lambda key=key: editor.key(key))
    for command in ("mirror_ends", "mirror_picks", "turn"):
        designer.edit(command, lambda command=command: choose(editor, command))
    for _ in range(3):
        designer.edit("undo", lambda: editor.key("ctrl+z"))
    designer.edit("redo", lambda: editor.key("ctrl+shift+z"))
    designer.step("save", lambda: editor.key("ctrl+s"), lambda: editor.fact("dirty") == "no")


def test():
    with window(WIDTH, HEIGHT) as editor:
        file = big_fabric(editor.home)
        editor.start(PROGRAM)
        editor.wait_until("a picture", lambda: editor.number("shown_samples") > 0)
        designer = Designer(editor)
        # Over all of it: a frame may come late, when its step is long done.
        before = editor.number("slow_frames")
        work_through(designer, file)
        slow = editor.number("slow_frames") - before
        expect(len(read_json(file)["weave"]) == SIDE, "it was not saved as a whole")
        # What a busy machine adds is a frame here and there; work in the window's thread would be in nearly every step.
        expect(slow <= designer.steps // 3,
               f"{slow} frames in {designer.steps} steps took more than 33 ms of the processor: the window stood still")


run(test)
