"""A designer's first minutes: change the weave, a yarn and a fibre, watch the cloth follow, save, take a snapshot, look
around, undo, and leave. With the real program, its real window, and real mouse and key events."""

import os
import subprocess

from window_driver import difference, expect, picture_statistics, read_json, run, window, write_json

PROGRAM = os.environ["LOOMLIGHT"]
SAMPLES = os.path.join(os.environ["LOOMLIGHT_ROOT"], "samples")
WIDTH, HEIGHT = 1280, 720


def small_fabric(home):
    """A light copy of the sample: a small flat piece at low resolution, so that a slow machine keeps up."""
    fabric = read_json(os.path.join(SAMPLES, "blue_cloth.json"))
    fabric["drape"] = {"kind": "flat", "width_mm": 6, "height_mm": 6}
    fabric["light"] = {"kind": "dome"}
    fabric["camera"] = {"distance_mm": 40, "elevation_deg": 70}
    fabric["render"] = {"width": 40, "height": 30, "samples_per_pixel": 2, "resolution": 2}
    return write_json(home, "cloth.json", fabric)


def change_weave(editor):
    before = editor.screenshot("before", "viewport")
    mean, deviation = picture_statistics(before)
    expect(mean > 0.05 and deviation > 0.01, f"the viewport shows no cloth: mean {mean}, deviation {deviation}")
    editor.click("draft.cell_0_0")
    editor.wait_until("a click in the draft edits the fabric", lambda: editor.fact("dirty") == "yes")
    editor.wait_for_picture()


def change_yarn(editor):
    revision = editor.number("revision")
    editor.drag_widget("yarn.ply_twist_per_m", 40)
    editor.wait_until("dragging the twist edits the fabric", lambda: editor.number("revision") > revision)
    x, y = editor.centre("yarn.plies")
    editor.wheel(x, y, clicks=12)  # to the end of the page
    revision = editor.number("revision")
    editor.click("yarn.packing")
    editor.type("0.61")
    editor.key("Return")
    editor.wait_until("a typed number edits the fabric", lambda: editor.number("revision") > revision)
    revision = editor.number("revision")
    editor.click("yarn.flattening")
    editor.type("99")
    editor.key("Return")
    expect(editor.number("revision") == revision, "a number out of range was taken")
    editor.wait_for_picture()


def change_fibre(editor):
    editor.click("tab.fibre")
    revision = editor.number("revision")
    editor.click("fibre.preset")
    editor.click("fibre.preset/wool")
    editor.wait_until("a fibre preset edits the fabric", lambda: editor.number("revision") > revision)
    editor.wait_for_picture()


def save(editor, file, original):
    editor.key("ctrl+s")
    editor.wait_until("the fabric is saved", lambda: editor.fact("dirty") == "no")
    now = read_json(file)
    rows, old_rows = now["weave"], original["weave"]
    changed = [(p, e) for p, row in enumerate(rows) for e, cell in enumerate(row) if cell != old_rows[p][e]]
    expect(changed == [(len(rows) - 1, 0)], f"expected the crossing of pick 1 and end 1 to change, got {changed}")
    twist, old_twist = now["yarns"][0]["ply_twist_per_m"], original["yarns"][0]["ply_twist_per_m"]
    expect(twist > old_twist, f"the twist went from {old_twist} to {twist}")
    expect(now["yarns"][0]["packing"] == 0.61, f"packing is {now['yarns'][0]['packing']}, 0.61 was typed")
    expect(now["yarns"][0]["flattening"] == original["yarns"][0]["flattening"], "a refused number was saved")
    fibre, old = (f["fibres"][f["yarns"][0]["fibre"]] for f in (now, original))
    expect(fibre["scale_tilt_deg"] == 2.5 and fibre["radius_um"] != old["radius_um"], f"no wool: {fibre}")


def save_elsewhere(editor):
    file = os.path.join(editor.home, "second.json")
    editor.key("ctrl+shift+s")
    editor.wait_until("the file browser opens", lambda: "browser.name" in editor.widgets())
    editor.name_file(file)
    editor.wait_until("the second file is written", lambda: editor.fact("file") == file)
    expect(read_json(file)["loomlight_version"] == 1, "the second file is no fabric")


def take_snapshot(editor):
    editor.key("ctrl+p")
    file = os.path.join(editor.home, "shot.png")
    editor.click("snapshot.file")
    editor.key("ctrl+a")
    editor.type(file)
    editor.click("snapshot.start")
    editor.wait_until("the snapshot is there", lambda: editor.fact("snapshot.outcome").startswith("Saved"))
    size = subprocess.run(["identify", "-format", "%w %h", file], check=True, capture_output=True, text=True).stdout
    expect(size == "40 30", f"the snapshot is {size}, not 40 30")
    expect(picture_statistics(file)[1] > 0.01, "the snapshot is empty")
    editor.click("snapshot.close")
    editor.wait_until("the dialog closes", lambda: editor.fact("dialog") == "none")


def look_around(editor):
    editor.wait_for_picture()
    before = editor.screenshot("front", "viewport")
    generation = editor.number("generation")
    editor.drag_widget("viewport", 90, -40)
    editor.wait_until("orbiting asks for another picture", lambda: editor.number("generation") > generation)
    editor.wait_for_picture()
    expect(editor.fact("dirty") == "no", "looking around counts as unsaved work")
    change = difference(before, editor.screenshot("side", "viewport"))
    expect(change > 0.02, f"the picture did not follow the orbit: difference {change}")


def undo(editor):
    revision = editor.number("revision")
    editor.key("ctrl+z")
    editor.wait_until("undo edits the fabric", lambda: editor.number("revision") > revision)
    editor.wait_until("undone work is unsaved work", lambda: editor.fact("dirty") == "yes")
    editor.key("ctrl+shift+z")
    editor.wait_until("redo brings back what was saved", lambda: editor.fact("dirty") == "no")


def leave(editor):
    editor.click("structure/Plain")
    editor.wait_until("a structure edits the fabric", lambda: editor.fact("dirty") == "yes")
    editor.leave()


def test():
    with window(WIDTH, HEIGHT) as editor:
        file = small_fabric(editor.home)
        original = read_json(file)
        editor.start(PROGRAM, [file])
        editor.wait_for_picture()
        change_weave(editor)
        change_yarn(editor)
        change_fibre(editor)
        save(editor, file, original)
        save_elsewhere(editor)
        take_snapshot(editor)
        look_around(editor)
        undo(editor)
        leave(editor)


run(test)
