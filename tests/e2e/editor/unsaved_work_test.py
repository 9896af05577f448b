"""What lasts from the end of one editor to the next, in the real window: settings, and work that was left behind, which
is offered behind the dialog of a draft that the program begins with. How else nothing is lost is tried without a window
(headless/editor/unsaved_work_test.cpp)."""

import os
import shutil

from small_cloth import small_cloth
from window_driver import expect, run, window

PROGRAM = os.environ["LOOMLIGHT"]
WIDTH, HEIGHT = 800, 520


def copy_of_unsaved_work(editor):
    """As the editor keeps it, so that a good end has one to remove. Returns it out of the editor's reach."""
    editor.click("draft.cell_0_0")
    editor.wait_until("the cloth is edited", lambda: editor.fact("dirty") == "yes")
    copies = []

    def is_kept():
        copies[:] = [name for name in os.listdir(editor.state) if name.endswith(".json")]
        return copies

    editor.wait_until("a copy is kept", is_kept)
    left = os.path.join(editor.home, "left.json")
    shutil.copy(os.path.join(editor.state, copies[0]), left)
    return left


def a_good_end(editor):
    editor.wait_until("the picture has samples", lambda: editor.number("shown_samples") > 0)
    editor.key("n")
    editor.wait_until("the picture is denoised", lambda: editor.fact("denoised") == "yes")
    expect(editor.fact("dirty") == "yes", "there is unsaved work")
    editor.leave()
    expect(not os.listdir(editor.state), "a good end leaves nothing to be taken up")


def mailed_draft(home):
    file = os.path.join(home, "draft.wif.txt")
    with open(file, "w", encoding="ascii") as text:
        text.write("[WIF]\nVersion=1.1\n[WEAVING]\nShafts=2\nTreadles=2\n[WARP]\nThreads=2\n[WEFT]\nThreads=2\n"
                   "[THREADING]\n1=1\n2=2\n[TIEUP]\n1=1\n2=2\n[TREADLING]\n1=1\n2=2\n[TEXT]\nTitle=By mail\n")
    return file


def the_next_start(editor, left):
    """Beside a copy that a killed editor has left."""
    os.rename(left, os.path.join(editor.state, f"autosave-{os.getpid()}.json"))
    editor.start(PROGRAM, [mailed_draft(editor.home)])  # which has a dialog of its own
    editor.click("wif.close")
    editor.wait_until("it is offered", lambda: "Take it up again?" in editor.fact("message"))
    editor.key("Return")
    editor.wait_until("it is taken up", lambda: editor.fact("dirty") == "yes" and editor.fact("name") == "One")
    editor.wait_until("it is denoised again", lambda: editor.fact("denoised") == "yes")


def test():
    with window(WIDTH, HEIGHT, samples=1) as editor:  # the picture is not judged
        file = small_cloth(editor.home, "One")
        editor.start(PROGRAM, [file])
        left = copy_of_unsaved_work(editor)
        a_good_end(editor)
        the_next_start(editor, left)


run(test)
