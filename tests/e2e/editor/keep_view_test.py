"""Views that are kept: a strip of them, two compared, one brought back. In the real window."""

import os
import struct
import subprocess

from small_cloth import small_cloth
from window_driver import difference, expect, picture_statistics, run, window

PROGRAM = os.environ["LOOMLIGHT"]
WIDTH, HEIGHT = 1280, 720


def small_fabric(home):
    return small_cloth(home, "First", ends_per_cm=20, picks_per_cm=20,
                       drape={"kind": "flat", "width_mm": 6, "height_mm": 6},
                       fibres=[{"name": "coarse", "radius_um": 20, "absorption_per_mm": [20, 6, 2]}])


def keep_two(editor):
    expect("snapshot.item_0" not in editor.widgets(), "an empty strip takes room from the cloth")
    editor.key("k")
    editor.wait_until("the view is kept", lambda: "snapshot.item_0" in editor.widgets())
    kept = editor.screenshot("kept", "snapshot.item_0")
    _, deviation = picture_statistics(kept)
    expect(deviation > 0.03, f"the kept view is empty: {deviation}")
    editor.wait_until("it gets better with its picture",
                      lambda: difference(kept, editor.screenshot("better", "snapshot.item_0")) > 0.002)
    editor.wait_for_picture()
    editor.click("tab.cloth")
    revision = editor.number("revision")
    editor.click("cloth.ends_per_cm")
    editor.type("9")
    editor.key("Return")
    editor.wait_until("the cloth is another one", lambda: editor.number("revision") > revision)
    editor.wait_for_picture()
    editor.click("snapshot.keep")
    editor.wait_until("the other one is kept too", lambda: "snapshot.item_1" in editor.widgets())


def compare(editor):
    editor.click("snapshot.item_0")
    editor.click("snapshot.item_1")
    editor.click("snapshot.compare")
    editor.centre("compare.picture")
    slider = editor.screenshot("slider", "compare.picture")
    editor.drag_widget("compare.slider", 150)
    moved = editor.screenshot("moved", "compare.picture")
    expect(difference(slider, moved) > 0.01, "the slider shows nothing else")
    editor.click("compare.way/Difference")
    editor.wait_until("the difference is another picture",
                      lambda: difference(moved, editor.screenshot("difference", "compare.picture")) > 0.02)
    editor.click("compare.way/Side by side")
    editor.click("compare.close")
    editor.wait_until("the dialog closes", lambda: editor.fact("dialog") == "none")


def print_with_a_scale(editor):
    """A print of 12 x 9 mm at 127 dpi is 60 x 45 pixels, and has a band below for bar and caption."""
    kept = sum(name.startswith("snapshot.item_") for name in editor.widgets())
    editor.key("ctrl+p")
    file = os.path.join(editor.home, "print.png")
    editor.click("snapshot.size_in/Print, mm")
    for field, number in (("width_mm", "12"), ("height_mm", "9"), ("dpi", "127"), ("samples_per_pixel", "2")):
        editor.click("snapshot." + field)
        editor.type(number)
        editor.key("Return")
    editor.wait_until("the pixels follow", lambda: editor.fact("snapshot.pixels") == "60 \u00d7 45")
    editor.click("snapshot.scale_bar/On")
    editor.click("snapshot.caption")
    editor.type("No. 7")
    editor.click("snapshot.file")
    editor.key("ctrl+a")
    editor.type(file)
    editor.click("snapshot.start")
    editor.wait_until("the print is there", lambda: editor.fact("snapshot.outcome").startswith("Saved"))
    size = subprocess.run(["identify", "-format", "%w %h", file], check=True, capture_output=True, text=True).stdout
    width, height = (int(n) for n in size.split())
    expect(width == 60 and 45 < height < 80, f"the print is {size}")
    with open(file, "rb") as png:
        expect(b"pHYs" + struct.pack(">IIB", 5000, 5000, 1) in png.read(), "127 dpi, 5000 pixels a metre, are not in it")
    editor.click("snapshot.close")
    editor.wait_until("the dialog closes", lambda: editor.fact("dialog") == "none")
    expect(sum(name.startswith("snapshot.item_") for name in editor.widgets()) == kept + 1,
           "what is rendered to a file joins the strip")


def restore(editor):
    revision = editor.number("revision")
    editor.click("snapshot.item_1")  # chosen no more
    editor.click("snapshot.restore")
    editor.wait_until("the first cloth is back", lambda: editor.number("revision") > revision)
    expect(editor.fact("cloth.per_inch").startswith("51 "), f"to the inch: {editor.fact('cloth.per_inch')}")
    editor.click("snapshot.remove")
    editor.wait_until("a view is removed", lambda: "snapshot.item_1" not in editor.widgets())
    editor.key("ctrl+z")
    editor.wait_until("undo takes the restored cloth back",
                      lambda: editor.fact("cloth.per_inch").startswith("23 "))


def test():
    with window(WIDTH, HEIGHT) as editor:
        editor.start(PROGRAM, [small_fabric(editor.home)])
        editor.wait_for_picture()
        keep_two(editor)
        compare(editor)
        restore(editor)
        print_with_a_scale(editor)


run(test)
