"""Disks that take nothing and files that are none: the editor says so, goes on, and the work is saved elsewhere. In the
real window; what it writes beside the cloth and its settings is tried without one (headless/editor/full_disk_test.cpp).
"""

import os
import resource

from window_driver import expect, read_json, run, window, write_json

PROGRAM = os.environ["LOOMLIGHT"]
WIDTH, HEIGHT = 900, 720
# Bytes that a file may have on the disk that stands in for a full one: enough for what tests are told of the widgets. The
# cloth needs more, and so do settings with a file of this name among the recent ones.
FULL_AFTER = 50_000
LONG_NAME = "/gone" * 12_000


def long_fabric(home):
    fabric = {
        "loomlight_version": 1, "name": "Long", "description": "a long story " * 5_000, "weave": ["#.", ".#"],
        "fibres": [{"name": "coarse", "radius_um": 20}],
        "drape": {"kind": "flat", "width_mm": 4, "height_mm": 4},
        "light": {"kind": "dome"}, "camera": {"distance_mm": 16, "elevation_deg": 75}, "render": {"resolution": 1},
    }
    return write_json(home, "long.json", fabric)


def fill_disk(editor, full):
    hard = resource.prlimit(editor.process.pid, resource.RLIMIT_FSIZE)[1]
    resource.prlimit(editor.process.pid, resource.RLIMIT_FSIZE, (FULL_AFTER if full else hard, hard))


def answer(editor, said, index=0):
    """A message is up that says this; it is answered."""
    editor.wait_until(f"the editor says: {said}", lambda: said in editor.fact("message"))
    editor.click(f"message.answer_{index}")
    editor.wait_until("the message is gone", lambda: editor.fact("dialog") == "none")


def spoil_its_own_folders(editor):
    """What the editor keeps for itself is as hostile as anything else on a disk."""
    presets, views = (os.path.join(editor.home, "data", "loomlight", name) for name in ("presets", "views"))
    state = os.path.join(editor.home, "state", "loomlight")
    for folder in (presets, views, state):
        os.makedirs(folder)
    os.mkfifo(os.path.join(presets, "pipe.json"))
    os.symlink("loop.json", os.path.join(presets, "loop.json"))
    os.mkdir(os.path.join(presets, "tags"))
    for file in (os.path.join(presets, "binary.json"), os.path.join(views, "broken.png")):
        with open(file, "wb") as binary:
            binary.write(bytes(range(256)) * 100)
    os.mkfifo(os.path.join(views, "pipe.png"))
    os.mkfifo(os.path.join(state, "autosave-2000000000.json"))  # of a process that cannot be


def left_work_that_is_none(editor):
    editor.wait_until("what was left is offered", lambda: "Take it up again?" in editor.fact("message"))
    editor.click("message.answer_2")
    answer(editor, "expected a regular file")


def spoilt_folders(editor):
    editor.key("ctrl+b")
    editor.wait_until("the presets are shown", lambda: "presets.card/Denim" in editor.widgets())
    kept = [name for name in editor.widgets() if name in ("presets.card/pipe", "presets.card/loop", "presets.card/binary")]
    expect(not kept, f"files that are none are offered: {kept}")
    editor.click("presets.keep")
    editor.wait_until("a preset is kept all the same", lambda: "presets.card/Long" in editor.widgets())
    editor.click("presets.close")
    editor.wait_until("the browser closes", lambda: editor.fact("dialog") == "none")
    expect("snapshot.item_0" not in editor.widgets(), "a picture that is none is a kept view")


def full_disk(editor, file):
    old = read_json(file)
    editor.click("draft.cell_0_0")
    editor.wait_until("the cloth is edited", lambda: editor.fact("dirty") == "yes")
    fill_disk(editor, True)
    editor.drag_widget("yarn.ply_twist_per_m", 40)
    editor.wait_until("the editor says that no copy is kept", lambda: "File too large" in editor.fact("autosave_problem"))
    editor.key("ctrl+s")
    answer(editor, "File too large")
    expect(editor.fact("dirty") == "yes", "work that is not on the disk counts as saved")
    expect(read_json(file) == old, "the old file is gone")
    expect(sorted(os.listdir(os.path.dirname(file))) == ["long.json"], "something was left beside the file")


def quit_does_not_lose_it(editor):
    editor.key("ctrl+q")
    editor.click("message.answer_2")  # Save
    answer(editor, "File too large")
    expect(editor.process.poll() is None, "the editor ended with work that it could not save")


def read_only_place(editor):
    editor.key("ctrl+shift+s")
    editor.name_file("/sys/cloth.json")
    answer(editor, "/sys/cloth.json")
    expect(editor.fact("dirty") == "yes", "work that is not on the disk counts as saved")


def elsewhere(editor, folder):
    fill_disk(editor, False)
    file = os.path.join(folder, "elsewhere.json")
    editor.key("ctrl+shift+s")
    editor.name_file(file)
    editor.wait_until("the cloth is saved elsewhere", lambda: editor.fact("dirty") == "no")
    editor.wait_until("all is safe", lambda: editor.fact("autosave_problem") == "")
    expect(read_json(file)["weave"] != read_json(os.path.join(folder, "long.json"))["weave"], "the edit is not in it")


def first_file_that_is_none(editor, folder):
    """The window is there all the same, and another file can be opened."""
    broken = os.path.join(folder, "broken.json")
    with open(broken, "w", encoding="utf-8") as file:
        file.write('{"loomlight_version": 1, "weave": [')
    editor.start(PROGRAM, [broken])
    editor.wait_until("the editor says so", lambda: "broken.json: line 1" in editor.fact("message"))
    editor.click("message.answer_0")
    os.remove(broken)


def open_cloth(editor, file):
    editor.key("ctrl+o")
    editor.name_file(file)
    editor.wait_until("the cloth is open", lambda: editor.fact("name") == "Long")


def files_that_are_none(editor, folder):
    os.mkfifo(os.path.join(folder, "pipe.json"))
    os.symlink("/dev/zero", os.path.join(folder, "endless.wif"))
    os.symlink("loop.json", os.path.join(folder, "loop.json"))
    with open(os.path.join(folder, "binary.wif"), "wb") as file:
        file.write(bytes(range(256)) * 100)
    with open(os.path.join(folder, "cut.png"), "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0")
    revision = editor.number("revision")
    for name in ("pipe.json", "endless.wif", "binary.wif", "cut.png"):
        editor.key("ctrl+o")
        editor.name_file(os.path.join(folder, name))
        answer(editor, name)
    editor.key("ctrl+o")
    editor.name_file(os.path.join(folder, "loop.json"))
    editor.key("Escape")
    editor.key("Escape")
    editor.wait_until("the browser is closed", lambda: editor.fact("dialog") == "none")
    expect(editor.number("revision") == revision, "a file that is none became the cloth")


def settings_that_are_not_kept(editor):
    """The session ends all the same, and its log says so."""
    with open(editor.settings_file, "rb") as file:
        before = file.read()
    fill_disk(editor, True)
    editor.key("ctrl+q")
    expect(editor.wait_for_end() == 0, f"the editor ended with {editor.process.returncode}\n{editor.log()}")
    expect(f"{editor.settings_file}: cannot be written: File too large" in editor.log(), f"no word of it: {editor.log()}")
    with open(editor.settings_file, "rb") as file:
        expect(file.read() == before, "the old settings are gone")
    expect(os.listdir(os.path.dirname(editor.settings_file)) == ["editor.json"], "something was left beside the settings")


def test():
    with window(WIDTH, HEIGHT, samples=1) as editor:  # the picture is not judged
        editor.write_settings({"hints_seen": True, "viewport_samples": 1, "recent": [LONG_NAME]})
        folder = os.path.join(editor.home, "cloths")
        os.mkdir(folder)
        file = long_fabric(folder)
        spoil_its_own_folders(editor)
        first_file_that_is_none(editor, folder)
        left_work_that_is_none(editor)
        open_cloth(editor, file)
        spoilt_folders(editor)
        full_disk(editor, file)
        quit_does_not_lose_it(editor)
        read_only_place(editor)
        elsewhere(editor, folder)
        files_that_are_none(editor, folder)
        settings_that_are_not_kept(editor)


run(test)
