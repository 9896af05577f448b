"""An editor that is killed (kill -9) while it saves, keeps a copy of unsaved work, or writes its settings: the file is as
it was or as it was saved, the next editor starts, and offers what was not saved.

  LOOMLIGHT_KILLS=1000 ...    as many as that in place of the few of an ordinary run
"""

import os
import random
import time

from small_cloth import small_cloth
from window_driver import expect, read_json, run, window

PROGRAM = os.environ["LOOMLIGHT"]
KILLS = int(os.environ.get("LOOMLIGHT_KILLS", "6"))
WIDTH, HEIGHT = 960, 600
LONGEST_S = 0.5  # from an action to the kill


def answer_what_is_asked(editor, taken_up):
    """An editor that finds unsaved work offers it; it is taken up, or thrown away."""
    editor.wait_until("it is clear whether there was unsaved work",
                      lambda: editor.fact("message") != "" or editor.number("frame") > 3)
    if "Take it up again?" not in editor.fact("message"):
        return False
    editor.click("message.answer_2" if taken_up else "message.answer_1")
    editor.wait_until("it is answered", lambda: editor.fact("dialog") == "none")
    return taken_up


def test():
    chance = random.Random(1)
    with window(WIDTH, HEIGHT) as editor:
        file = small_cloth(editor.home, "Killed")
        state = os.path.join(editor.home, "state", "loomlight")
        offered = 0
        for _ in range(KILLS):
            editor.start(PROGRAM, [file])
            offered += answer_what_is_asked(editor, chance.random() < 0.5)
            before = read_json(file)["weave"]
            editor.click("draft.cell_0_0")
            editor.wait_until("the cloth is edited", lambda: editor.fact("dirty") == "yes")
            action = chance.choice(("save", "keep", "settings"))
            if action == "save":
                editor.input.key("ctrl", 1)
                editor.input.key("s", 1)
            elif action == "keep":
                editor.wait_until("a copy is kept", lambda: os.path.isdir(state) and os.listdir(state))
            else:
                editor.key("n")
            time.sleep(chance.uniform(0, LONGEST_S))
            editor.process.kill()
            editor.process.wait()
            for key in ("s", "ctrl"):
                editor.input.key(key, 0)
            after = read_json(file)["weave"]  # which reads: it is whole
            expect(after == before or action == "save", f"a file that was not saved is another after '{action}'")
            for kept in os.listdir(state) if os.path.isdir(state) else ():
                if kept.startswith("autosave-") and kept.endswith(".json"):
                    read_json(os.path.join(state, kept))
        editor.start(PROGRAM, [file])
        answer_what_is_asked(editor, False)
        editor.key("ctrl+q")
        if editor.process.poll() is None and editor.fact("message"):
            editor.click("message.answer_1")
        expect(editor.wait_for_end() == 0, editor.log())
        print(f"{KILLS} kills; unsaved work was taken up {offered} times")


run(test)
