"""A first file that is none and a disk that takes nothing: the program's window opens, goes on, and ends well. What
else the editor says of disks and files is tried without a window (headless/editor/disk_test.cpp, full_disk_test.cpp
and odd_files_test.cpp)."""

import os
import resource

from small_cloth import small_cloth
from window_driver import expect, read_json, run, window

PROGRAM = os.environ["LOOMLIGHT"]
WIDTH, HEIGHT = 900, 720
# Bytes that a file may have on the disk that stands in for a full one: enough for what tests are told of the widgets.
# The cloth needs more, and so do settings with a file of this name among the recent ones.
FULL_AFTER = 50_000
LONG_NAME = "/gone" * 12_000


def fill_disk(editor, full):
    hard = resource.prlimit(editor.process.pid, resource.RLIMIT_FSIZE)[1]
    resource.prlimit(editor.process.pid, resource.RLIMIT_FSIZE, (FULL_AFTER if full else hard, hard))


def answer(editor, said):
    """A message is up that says this; it is answered."""
    editor.wait_until(f"the editor says: {said}", lambda: said in editor.fact("message"))
    editor.click("message.answer_0")
    editor.wait_until("the message is gone", lambda: editor.fact("dialog") == "none")


def first_file_that_is_none(editor, folder):
    """The window is there all the same, and another file can be opened."""
    broken = os.path.join(folder, "broken.json")
    with open(broken, "w", encoding="utf-8") as file:
        file.write('{"loomlight_version": 1, "weave": [')
    editor.start(PROGRAM, [broken])
    answer(editor, "broken.json: line 1")
    os.remove(broken)


def open_cloth(editor, file):
    editor.key("ctrl+o")
    editor.name_file(file)
    editor.wait_until("the cloth is open", lambda: editor.fact("name") == "Long")


def full_disk(editor, file):
    """The program is told of it as of an error; the signal for it would end the program."""
    old = read_json(file)
    editor.click("draft.cell_0_0")
    editor.wait_until("the cloth is edited", lambda: editor.fact("dirty") == "yes")
    fill_disk(editor, True)
    editor.key("ctrl+s")
    answer(editor, "File too large")
    expect(editor.fact("dirty") == "yes", "work that is not on the disk counts as saved")
    expect(read_json(file) == old, "the old file is gone")
    expect(sorted(os.listdir(os.path.dirname(file))) == ["long.json"], "something was left beside the file")
    fill_disk(editor, False)
    expect(editor.saved(file)["weave"] != old["weave"], "the edit is not in it")


def settings_that_are_not_kept(editor):
    """The session ends all the same, and its log says so."""
    with open(editor.settings_file, "rb") as file:
        before = file.read()
    fill_disk(editor, True)
    editor.key("ctrl+q")
    expect(editor.wait_for_end() == 0, f"the editor ended with {editor.process.returncode}\n{editor.log()}")
    said = f"{editor.settings_file}: cannot be written: File too large"
    expect(said in editor.log(), f"no word of it: {editor.log()}")
    with open(editor.settings_file, "rb") as file:
        expect(file.read() == before, "the old settings are gone")
    folder = os.path.dirname(editor.settings_file)
    expect(os.listdir(folder) == ["editor.json"], "something was left beside the settings")


def test():
    with window(WIDTH, HEIGHT, samples=1) as editor:  # the picture is not judged
        editor.write_settings({"hints_seen": True, "viewport_samples": 1, "recent": [LONG_NAME]})
        folder = os.path.join(editor.home, "cloths")
        os.mkdir(folder)
        file = small_cloth(folder, "Long", description="a long story " * 5_000)
        first_file_that_is_none(editor, folder)
        open_cloth(editor, file)
        full_disk(editor, file)
        settings_that_are_not_kept(editor)


run(test)
