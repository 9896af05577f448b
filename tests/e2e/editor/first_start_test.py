"""The first start and what lasts to the next: a cloth and three hints, files that were used lately, views that were
kept. In the real window."""

import os

from small_cloth import small_cloth
from window_driver import expect, picture_statistics, read_json, run, window

PROGRAM = os.environ["LOOMLIGHT"]
WIDTH, HEIGHT = 1280, 720


def small_fabric(home, name):
    return small_cloth(home, name, ends_per_cm=20, picks_per_cm=20,
                       drape={"kind": "flat", "width_mm": 6, "height_mm": 6},
                       camera={"distance_mm": 24, "elevation_deg": 75},
                       fibres=[{"name": "coarse", "radius_um": 20, "absorption_per_mm": [20, 6, 2]}])


def a_cloth_and_three_hints(editor):
    os.remove(editor.settings_file)
    editor.start(PROGRAM)
    editor.wait_until("the first cloth is on the screen", lambda: editor.number("shown_generation") > 0)
    mean, deviation = picture_statistics(editor.screenshot("first", "viewport"))
    expect(deviation > 0.05, f"the first cloth is a grey screen: {mean}, {deviation}")
    expect([editor.fact("hints." + name) for name in ("drew", "turned", "set")] == ["open"] * 3, "three hints are open")
    editor.click("draft.cell_0_0")
    editor.wait_until("drawing is ticked off", lambda: editor.fact("hints.drew") == "done")
    editor.drag_widget("viewport", 60, 10)
    editor.wait_until("turning is ticked off", lambda: editor.fact("hints.turned") == "done")
    editor.drag_widget("yarn.ply_twist_per_m", 40)
    editor.wait_until("all is done, and the card goes", lambda: "hints.close" not in editor.widgets())
    editor.leave()


def never_again(editor):
    editor.start(PROGRAM, [small_fabric(editor.home, "One")])
    editor.wait_for_picture()
    expect("hints.close" not in editor.widgets(), "the hints are back")
    expect(read_json(editor.settings_file)["hints_seen"], "nobody remembers that they were seen")


def keep_a_view(editor):
    editor.key("k")
    editor.wait_until("the view is kept", lambda: "snapshot.item_0" in editor.widgets())
    editor.leave()


def open_recent(editor, name):
    editor.click("menu.file")
    editor.click("menu.recent")
    editor.click("menu.recent/" + name)


def files_and_views_last(editor):
    two = small_fabric(editor.home, "Two")
    editor.start(PROGRAM, [two])
    editor.wait_until("the kept view is there", lambda: "snapshot.item_0" in editor.widgets())
    editor.wait_for_picture()
    _, deviation = picture_statistics(editor.screenshot("kept", "snapshot.item_0"))
    expect(deviation > 0.03, f"the kept view is empty: {deviation}")
    open_recent(editor, "one.json")
    editor.wait_until("the first file is open", lambda: editor.fact("name") == "One")
    os.remove(two)
    open_recent(editor, "two.json")
    editor.wait_until("the editor says that it is missing", lambda: two in editor.fact("message"))
    editor.click("message.answer_1")
    editor.wait_until("the message is gone", lambda: editor.fact("dialog") == "none")
    editor.click("menu.file")
    editor.click("menu.recent")
    editor.centre("menu.recent/one.json")
    expect("menu.recent/two.json" not in editor.widgets(), "what is forgotten is still in the list")
    editor.key("Escape", "Escape", "Escape")
    editor.click("snapshot.item_0")
    editor.click("snapshot.remove")
    editor.wait_until("the view is removed", lambda: "snapshot.item_0" not in editor.widgets())
    editor.leave()
    editor.start(PROGRAM, [os.path.join(editor.home, "one.json")])
    editor.wait_for_picture()
    views = os.path.join(editor.data, "views")
    before = set(os.listdir(views))
    editor.key("k")
    # One worker reads what was kept and writes what is kept anew, in this order.
    editor.wait_until("another view is on the disk",
                      lambda: any(name.endswith(".png") for name in set(os.listdir(views)) - before))
    editor.wait_until("it is shown", lambda: "snapshot.item_0" in editor.widgets())
    expect("snapshot.item_1" not in editor.widgets(), "a removed view is back")


def test():
    with window(WIDTH, HEIGHT) as editor:
        a_cloth_and_three_hints(editor)
        never_again(editor)
        keep_a_view(editor)
        files_and_views_last(editor)


run(test)
