"""Whatever somebody does, in whatever order: the editor goes on, answers, and takes all of it back. Actions are drawn
from a seed; each part of them begins on the cloth as it was saved and is undone in the end.

  LOOMLIGHT_SOAK_ACTIONS=10000 LOOMLIGHT_SOAK_SEED=7 ...    as many as that, and others
"""

import os
import random
import statistics
import string
import subprocess
import time

from small_cloth import small_cloth
from window_driver import Failure, expect, read_json, run, window

PROGRAM = os.environ["LOOMLIGHT"]
WIDTH, HEIGHT = 960, 600
ACTIONS = int(os.environ.get("LOOMLIGHT_SOAK_ACTIONS", "120"))
SEED = int(os.environ.get("LOOMLIGHT_SOAK_SEED", "1"))
ACTIONS_A_PART = 40
MOST_UNDONE = 10 * ACTIONS_A_PART  # an action is one step, or a few where a drag passes from one field to the next
FRAMES_TO_OPEN = 4  # that a number which was clicked needs, to hear the keys
FEWEST_PARTS = 40  # that tell a leak from caches that fill
MOST_GROWTH = 1.1  # of the memory, from the third quarter of the run to the last

# What ends the editor, begins another document, saves this one, or leads out of its own home.
NOT_TOUCHED = ("menu.quit", "menu.new", "menu.open", "menu.recent", "menu.save", "menu.save_as", "menu.sheet",
               "colourways.print", "menu.export", "menu.help", "browser.", "recover.")
KEYS = [*string.ascii_lowercase, *string.digits, "Tab", "shift+Tab", "Return", "Escape", "Delete", "Left", "Right", "Up",
        "Down", "bracketleft", "bracketright", "space", "ctrl+z", "ctrl+shift+z", "ctrl+c", "ctrl+v", "ctrl+x", "ctrl+a",
        "ctrl+0", "ctrl+1"]
TEXTS = ["1", "0", "-1", "7.5", "1e9", "99999999999999999999", "nan", "3A 4B", "4(2A 2B)", "2/60 Nm", "#1a2b3c", "",
         "Lab 50 10 10", "a name that goes on and on and on and on", "1,5", "0.0000001"]


def is_touched(name):
    return not name.startswith(NOT_TOUCHED)


def memory_mb(process):
    """What the editor itself has of the machine's memory."""
    with open(f"/proc/{process.pid}/status", encoding="ascii") as status:
        for line in status:
            if line.startswith("VmRSS:"):
                return int(line.split()[1]) / 1024
    raise Failure("the editor has no memory")


def expect_no_leak(memory):
    """Caches fill for long, in steps, and what is shown takes more or less: a leak moves the medians of the later
    quarters apart."""
    quarter = len(memory) // 4
    if len(memory) < FEWEST_PARTS:
        return
    before, after = statistics.median(memory[-2 * quarter:-quarter]), statistics.median(memory[-quarter:])
    expect(after < MOST_GROWTH * before, f"memory grows from {before:.0f} to {after:.0f} MB")


class Hand:
    """Does what is drawn, with what is on the screen, and keeps account of it."""

    def __init__(self, editor, seed):
        self.editor, self.random = editor, random.Random(seed)
        self.done = []

    def anywhere_in(self, rect):
        """But for the window's first row and column: GLFW takes a motion to (0, 0) for one that it made itself."""
        x0, y0, x1, y1 = rect
        x, y = self.random.uniform(x0, x1), self.random.uniform(y0, y1)
        return min(max(x, 1), WIDTH - 1), min(max(y, 1), HEIGHT - 1)

    def act(self):
        widgets = {name: rect for name, rect in self.editor.widgets().items() if is_touched(name)}
        name = self.random.choice(sorted(widgets))
        kind = self.random.choices(("click", "drag", "wheel", "key", "write", "right click"), (40, 15, 8, 22, 12, 3))[0]
        self.done.append(f"{kind} {name}")
        place = self.anywhere_in(widgets[name])
        if kind == "click":
            self.editor.click_at(*place)
        elif kind == "right click":
            self.editor.click_at(*place, 3)
        elif kind == "drag":
            end = self.anywhere_in((place[0] - 150, place[1] - 80, place[0] + 150, place[1] + 80))
            self.editor.drag(place, end, steps=self.random.randint(1, 5))
        elif kind == "wheel":
            self.editor.wheel(*place, away=self.random.random() < 0.5, clicks=self.random.randint(1, 4))
        elif kind == "key":
            key = self.random.choice(KEYS)
            self.done[-1] = f"key {key}"
            self.editor.key(key)
        else:
            self.editor.click_at(*place)
            if self.editor.fact("text_input") == "yes":
                text = self.random.choice(TEXTS)
                self.done[-1] += f": {text}"
                self.editor.key("ctrl+a")
                self.editor.act(self.editor.input.type, text, answered=True)
                self.editor.key(self.random.choice(("Return", "Escape", "Tab")))
        if any(shown.startswith("browser.") for shown in self.editor.widgets()):
            self.editor.key("Escape")  # files are for other tests

    def rest(self):
        """Until the picture is finished: then the editor hands back what it no longer needs."""
        self.editor.wait_until("the picture is at rest", lambda: self.editor.fact("phase") in ("converged", "idle"))
        time.sleep(0.5)

    def settle(self):
        """A number that was clicked opens some frames later, and would not hear an Escape before."""
        frame = self.editor.number("frame")
        self.editor.wait_until("what was begun is there", lambda: self.editor.number("frame") >= frame + FRAMES_TO_OPEN
                               or self.editor.fact("sleeps_then") == "yes")

    def open_again(self, file):
        """Where a menu was walked by keys, or a drag ended on it, another cloth may have been begun."""
        self.editor.key("ctrl+o")
        self.editor.name_file(file)
        self.editor.wait_until("the cloth is open again", lambda: self.editor.fact("file") == file
                               and self.editor.fact("dialog") == "none")

    def come_back(self):
        """Closes whatever is open, and undoes."""
        self.settle()
        for _ in range(8):
            if self.editor.fact("dialog") == "none" and self.editor.fact("text_input") == "no":
                break
            self.editor.key("Escape")
        expect(self.editor.fact("dialog") == "none", "a dialog does not close by Escape")
        self.editor.key("Escape")
        for _ in range(MOST_UNDONE):
            if self.editor.fact("dirty") == "no":
                return
            late = self.editor.fact("dialog") != "none"  # a message of work that ended only now
            self.editor.key("Escape" if late else "ctrl+z")
        raise Failure(f"{MOST_UNDONE} steps back are not at the start; facts: {self.editor.dump()['facts']}")


def test():
    with window(WIDTH, HEIGHT, samples=1) as editor:  # the picture is not judged
        file = small_cloth(editor.home, "Soaked", camera={"distance_mm": 32, "elevation_deg": 75})
        subprocess.run([PROGRAM, "convert", file, file], check=True, stdout=subprocess.DEVNULL)  # to the program's own form
        start = read_json(file)
        editor.start(PROGRAM, [file])
        file = editor.fact("file")
        hand = Hand(editor, SEED)
        memory, opened_again = [], 0
        try:
            for part in range(max(1, ACTIONS // ACTIONS_A_PART)):
                hand.done.clear()
                for _ in range(ACTIONS_A_PART):
                    hand.act()
                hand.come_back()
                expect(editor.fact("error") == "", editor.fact("error"))
                if editor.fact("file") != file:
                    hand.open_again(file)
                    opened_again += 1
                hand.rest()
                memory.append(memory_mb(editor.process))
                print(f"part {part}: {memory[-1]:.0f} MB", flush=True)
        except Failure as failure:
            raise Failure(f"seed {SEED}, part {part}: {failure}\nafter: " + "; ".join(hand.done[-60:])) from failure
        editor.key("ctrl+s")
        editor.wait_until("it is saved", lambda: editor.fact("dialog") == "none")
        saved = read_json(file)
        no_edits = ("camera", "render")  # to look at it, and to choose how large its pictures are
        changed = [key for key in {**start, **saved} if key not in no_edits and start.get(key) != saved.get(key)]
        expect(not changed, f"undone to the start, the cloth has another {', '.join(changed)}")
        expect_no_leak(memory)
        print(f"{len(memory) * ACTIONS_A_PART} actions; the cloth was opened again {opened_again} times")


run(test)
