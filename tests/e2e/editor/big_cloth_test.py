"""A jacquard of sixteen million crossings: opened, drawn on, changed as a whole, taken back and saved while the window
goes on. In the real window."""

import json
import os

from window_driver import expect, read_json, run, window

PROGRAM = os.environ["LOOMLIGHT"]
WIDTH, HEIGHT = 1280, 720
SIDE = 4000
BETWEEN_S = 60  # what a step may take at most on a busy machine


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


def step(editor, what, act, done):
    """Does it; says how many frames a person would have noticed."""
    before = editor.number("slow_frames")
    act()
    editor.wait_until(what, done, BETWEEN_S)
    return editor.number("slow_frames") - before


def edit(editor, what, *keys):
    revision = editor.number("revision")
    return step(editor, what, lambda: editor.key(*keys), lambda: editor.number("revision") > revision)


def open_file(editor, file):
    def act():
        editor.key("ctrl+o")
        editor.click("browser.name")
        editor.key("ctrl+a")
        editor.type(file)
        editor.key("Return")
    return step(editor, "open", act, lambda: editor.fact("name") == "Big" and editor.fact("dialog") == "none")


def test():
    with window(WIDTH, HEIGHT) as editor:
        file = big_fabric(editor.home)
        editor.start(PROGRAM)
        editor.wait_until("a picture", lambda: editor.number("shown_samples") > 0, 120)
        slow = open_file(editor, file)
        slow += step(editor, "look", lambda: editor.move(200, 300), lambda: True)
        x, y = editor.centre("draft.canvas") if "draft.canvas" in editor.widgets() else (200, 300)
        slow += step(editor, "zoom", lambda: [editor.click_at(x, y, 4) for _ in range(12)], lambda: True)
        slow += step(editor, "pan", lambda: editor.drag((x, y), (x + 60, y + 40), 2), lambda: True)
        revision = editor.number("revision")
        slow += step(editor, "paint", lambda: editor.drag((x, y), (x + 40, y + 20)),
                     lambda: editor.number("revision") > revision)
        slow += step(editor, "select", lambda: editor.key("ctrl+a"), lambda: True)
        slow += step(editor, "copy", lambda: editor.key("ctrl+c"), lambda: True)
        slow += edit(editor, "invert", "ctrl+i")
        slow += edit(editor, "paste", "ctrl+v")
        slow += edit(editor, "shift", "Left")
        for command in ("mirror_ends", "mirror_picks", "turn"):
            revision = editor.number("revision")
            def act():
                editor.click("menu.weave")
                editor.click("menu." + command)
            slow += step(editor, command, act, lambda: editor.number("revision") > revision)
        for _ in range(3):
            slow += edit(editor, "undo", "ctrl+z")
        slow += edit(editor, "redo", "ctrl+shift+z")
        slow += step(editor, "save", lambda: editor.key("ctrl+s"), lambda: editor.fact("dirty") == "no")
        expect(len(read_json(file)["weave"]) == SIDE, "it was not saved as a whole")
        expect(slow <= 3, f"{slow} frames took more than 33 ms of the processor: the window stood still")


run(test)
