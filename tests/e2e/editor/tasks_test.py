"""A draft of another program is opened, changed and saved in few actions, as ActionCount counts them; the time that the
editor takes is nobody's action. Tab, typing, Ctrl+O and Ctrl+S are keys of the real window; other tasks are done
without one (headless/editor/tasks_test.cpp)."""

import os

from small_cloth import small_cloth
from window_driver import expect, read_json, run, window

PROGRAM = os.environ["LOOMLIGHT"]
WIDTH, HEIGHT = 900, 600
SAMPLES_A_PIXEL = 1  # nobody looks at the picture
MOST_ACTIONS = 12

POINT_TWILL = """[WIF]
Version=1.1
Date=April 20, 1997
Developers=wif@mhsoft.com
Source Program=Handmade
[CONTENTS]
WEAVING=true
WARP=true
WEFT=true
TIEUP=true
THREADING=true
TREADLING=true
[WEAVING]
Shafts=4
Treadles=4
Rising Shed=true
[WARP]
Threads=6
[WEFT]
Threads=4
[TIEUP]
1=1,2
2=2,3
3=3,4
4=1,4
[THREADING]
1=1
2=2
3=3
4=4
5=3
6=2
[TREADLING]
1=1
2=2
3=3
4=4
"""


def quiet(editor):
    editor.wait_until("no dialog is open", lambda: editor.fact("dialog") == "none")


def open_file(editor, file):
    editor.key("ctrl+o")
    editor.wait_until("a name is asked for", lambda: "browser.name" in editor.widgets())
    editor.type(file)
    editor.key("Return")
    editor.wait_until("the file is named", lambda: "browser.name" not in editor.widgets())


def save_as(editor, name):
    """Of a cloth that has no file yet."""
    file = os.path.join(editor.home, name)
    editor.key("ctrl+s")
    editor.wait_until("a name is asked for", lambda: "browser.name" in editor.widgets())
    editor.type(file)
    editor.key("Return")
    editor.wait_until("it is saved", lambda: editor.fact("file") == file and editor.fact("dirty") == "no")
    quiet(editor)
    return read_json(file)


def an_opened_draft_changed(editor):
    file = os.path.join(editor.home, "point.wif")
    with open(file, "w", encoding="utf-8") as draft:
        draft.write(POINT_TWILL)
    open_file(editor, file)
    editor.wait_until("the draft is open", lambda: "wif.close" in editor.widgets())
    editor.key("Return")
    quiet(editor)
    editor.click("draft.tieup_0_1")
    editor.click("tab.cloth")
    editor.click("cloth.ends_per_cm")
    editor.type("31")
    editor.key("Tab")
    editor.type("27")
    editor.key("Return")
    editor.click("draft.treadling_0_1")
    cloth = save_as(editor, "point.json")
    expect((cloth["ends_per_cm"], cloth["picks_per_cm"]) == (31, 27), "another sett than was typed")
    expect(cloth["draft"]["treadling"] != [1, 2, 3, 4], "the treadling is not changed")
    expect(cloth["draft"]["tie_up"][0] in (2, [2]), f"the tie-up is not changed: {cloth['draft']['tie_up']}")


def test():
    with window(WIDTH, HEIGHT, SAMPLES_A_PIXEL) as editor:
        editor.start(PROGRAM, [small_cloth(editor.home, "small")])
        counted = editor.input.actions
        before = counted.count
        an_opened_draft_changed(editor)
        taken = counted.count - before
        print(f"an opened draft changed: {taken} actions", flush=True)
        expect(taken <= MOST_ACTIONS, f"it took {taken} actions, {MOST_ACTIONS} at most")


run(test)
