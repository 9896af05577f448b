"""A jacquard of sixteen million crossings: opened, drawn on, changed as a whole, taken back and saved while the window
goes on. In the real window.

What is judged is the processor time of the window's thread, beside what other jobs take on the same machine at the same
time: the same work on a cloth of a few crossings, and what reading and writing the large one takes a program of its own.
"""

import os
import resource
import statistics
import subprocess

from small_cloth import small_cloth
from window_driver import expect, read_json, run, window

PROGRAM = os.environ["LOOMLIGHT"]
WIDTH, HEIGHT = 800, 520
SIDES = {"Small": 8, "Big": 4000}


def cloth(home, name):
    side = SIDES[name]
    rows = ["".join("#" if (7 * end + 3 * pick + (pick * end >> 9)) % 8 < 3 else "." for end in range(side))
            for pick in range(0, side, 40)]
    return small_cloth(home, name, weave=[rows[pick // 40] for pick in range(side)])


def read_and_written_ms(file):
    """What of the processor the whole cloth takes a program of its own, ms."""
    def spent():
        times = resource.getrusage(resource.RUSAGE_CHILDREN)
        return 1e3 * (times.ru_utime + times.ru_stime)

    before = spent()
    subprocess.run([PROGRAM, "convert", file, file + ".again.json"], stdout=subprocess.DEVNULL, check=True)
    return spent() - before


class Designer:
    """Does one step after the other, and notes what the edits among them take."""

    def __init__(self, editor):
        self.editor = editor
        self.edits = []  # processor time of the window's thread, ms, frames, and those of them that were drawn

    def spent_ms(self):
        """What the window's thread has had of the processor."""
        window = self.editor.process.pid
        with open(f"/proc/{window}/task/{window}/schedstat", encoding="ascii") as times:
            return 1e-6 * int(times.read().split()[0])

    def step(self, what, act, done=lambda: True):
        act()
        self.editor.wait_until(what, done)

    def edit(self, what, act):
        def counts():
            facts = self.editor.dump()["facts"]
            return [self.spent_ms(), int(facts["frame"]), int(facts["drawn_frames"])]

        revision, before = self.editor.number("revision"), counts()
        self.step(what, act, lambda: self.editor.number("revision") > revision)
        self.edits.append([after - then for after, then in zip(counts(), before)])


def type_file(editor, file):
    editor.key("ctrl+o")
    editor.name_file(file)


def choose(editor, command):
    editor.click("menu.weave")
    editor.click("menu." + command)


def work_through(designer, file, name):
    editor = designer.editor
    designer.step("open", lambda: type_file(editor, file),
                  lambda: editor.fact("name") == name and editor.fact("dialog") == "none")
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


def edits(editor, name):
    """What they take on that cloth."""
    designer = Designer(editor)
    file = cloth(editor.home, name)
    work_through(designer, file, name)
    expect(len(read_json(file)["weave"]) == SIDES[name], "it was not saved as a whole")
    return designer.edits


def test():
    with window(WIDTH, HEIGHT, samples=1) as editor:  # the picture is not judged
        editor.start(PROGRAM, [small_cloth(editor.home, "First")])
        editor.wait_until("a picture", lambda: editor.number("shown_samples") > 0)
        small, big = (edits(editor, name) for name in SIDES)
        longest_ms, whole_ms = editor.number("longest_frame_ms"), read_and_written_ms(cloth(editor.home, "Big"))
        # Of the small cloth: what a frame takes, and what to draw it takes besides.
        drawing_ms, frame_ms = statistics.linear_regression([drawn / frames for _, frames, drawn in small],
                                                            [spent / frames for spent, frames, _ in small])
        more_ms = statistics.median(spent - frames * frame_ms - drawn * drawing_ms for spent, frames, drawn in big)
        # Going through all crossings once, which many edits are, takes half as much.
        expect(more_ms < whole_ms / 12, f"the window's thread works for {more_ms:.0f} ms at an edit of the large cloth, "
                                        f"beside drawing; reading and writing all of it takes {whole_ms:.0f} ms")
        expect(longest_ms < whole_ms, f"the window's thread was busy for {longest_ms} ms of the processor in a frame; "
                                      f"reading and writing the cloth takes {whole_ms:.0f} ms")


run(test)
