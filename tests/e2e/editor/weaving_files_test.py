"""Weaving files and weave pictures: opened by dialog and by name, their sizes chosen, their warnings shown, exported."""

import json
import os
import subprocess

from window_driver import expect, read_json, run, window

PROGRAM = os.environ["LOOMLIGHT"]
SAMPLES = os.path.join(os.environ["LOOMLIGHT_ROOT"], "samples")
WIDTH, HEIGHT = 1280, 720

WEAVING = """[WIF]
Version=1.1
Date=April 20, 1997
Developers=wif@mhsoft.com
Source Program=Handmade
[CONTENTS]
WEAVING=true
WARP=true
WEFT=true
TEXT=true
TIEUP=true
THREADING=true
TREADLING=true
[TEXT]
Title=Rosepath
[WEAVING]
Shafts=four
Treadles=4
Rising Shed=true
[WARP]
Threads=6
Units=Centimeters
Spacing=0.1
Thickness=0.1
[WEFT]
Threads=4
Units=Centimeters
Spacing=0.125
Thickness=0.1
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


def write(folder, name, text):
    file = os.path.join(folder, name)
    with open(file, "w", encoding="ascii") as out:
        out.write(text)
    return file


def plain_cloth(home):
    fabric = read_json(os.path.join(SAMPLES, "blue_cloth.json"))
    fabric["drape"] = {"kind": "flat", "width_mm": 4, "height_mm": 4}
    fabric["render"] = {"resolution": 1}
    return write(home, "cloth.json", json.dumps(fabric))


def name_file(editor, file):
    editor.wait_until("the file browser opens", lambda: "browser.name" in editor.widgets())
    editor.click("browser.name")
    editor.key("ctrl+a")
    editor.type(file)
    editor.key("Return")


def saved_as(editor, file):
    editor.key("ctrl+shift+s")
    name_file(editor, file)
    editor.wait_until("the cloth is saved", lambda: editor.fact("file") == file)
    return read_json(file)


def answer(editor):
    editor.wait_until("a message is shown", lambda: "message.answer_0" in editor.widgets())
    editor.click("message.answer_0")
    editor.wait_until("the message closes", lambda: editor.fact("dialog") == "none")


def open_weaving(editor, home):
    editor.key("ctrl+o")
    name_file(editor, write(home, "rosepath.wif", WEAVING))
    editor.wait_until("the weaving file is opened", lambda: editor.fact("name") == "Rosepath")
    expect(editor.number("wif.warnings") >= 1, "nothing is said of Shafts=four")
    revision = editor.number("revision")
    editor.click("wif.sizes/Use the file's")
    editor.wait_until("the file's sizes are used", lambda: editor.number("revision") > revision)
    editor.screenshot("dialog")
    editor.click("wif.close")
    fabric = saved_as(editor, os.path.join(home, "rosepath.json"))
    expect((fabric["ends_per_cm"], fabric["picks_per_cm"]) == (10, 8), "the cloth has another sett than the file")
    expect(fabric["draft"]["threading"] == [1, 2, 3, 4, 3, 2], f"threading is {fabric['draft']['threading']}")
    expect(fabric["drape"]["width_mm"] == 4, "the drape is not the designer's own")


def look_before_opening(editor, home):
    """The list is filtered and gone through by keys; a file is seen before it is opened; Esc leaves at once."""
    editor.key("ctrl+o")
    name_file(editor, home)
    editor.click("browser.filter")
    editor.type("PATH.WIF")
    editor.click("browser.name")
    editor.key("Down")
    editor.wait_until("the draft is seen", lambda: editor.fact("browser.preview") == "picture")
    expect("6 ends, 4 picks, 4 shafts" in editor.fact("browser.about"), f"it says: {editor.fact('browser.about')}")
    editor.key("Escape")
    editor.wait_until("the dialog closes", lambda: editor.fact("dialog") == "none")


def export(editor, item, file):
    """File > Export > item, to that file."""
    editor.click("menu.file")
    editor.click("menu.export")
    editor.click(item)
    name_file(editor, file)
    answer(editor)
    return file


def export_weaving(editor, home):
    file = export(editor, "menu.export_wif", os.path.join(home, "out.wif"))
    with open(file, encoding="ascii") as text:
        lines = text.read().split("\n")
    expect("Shafts=4" in lines and "5=3" in lines and "Title=Rosepath" in lines, "the export is no rosepath")


def bitmaps(editor, home):
    editor.click("menu.file")
    editor.click("menu.export")
    editor.click("menu.export_bitmap")
    file = os.path.join(home, "weave.png")
    name_file(editor, file)
    answer(editor)
    size = subprocess.run(["identify", "-format", "%w %h", file], check=True, capture_output=True, text=True).stdout
    expect(size == "6 4", f"the weave is {size} pixels")
    # Back through the dialog: two colours are point paper, a crossing for each pixel.
    editor.click("draft.tab_structures")
    editor.click("structure/Plain")
    editor.key("ctrl+o")
    name_file(editor, file)
    editor.wait_until("two colours are found", lambda: editor.fact("picture.colours") == "2")
    editor.click("picture.weave")
    editor.wait_until("the dialog closes", lambda: editor.fact("dialog") == "none")
    fabric = saved_as(editor, os.path.join(home, "again.json"))
    expect(fabric["draft"]["threading"] == [1, 2, 3, 4, 3, 2], f"another weave came back: {fabric['draft']}")


def jacquard(editor, home):
    """A picture of three colours: a structure for each."""
    picture = os.path.join(home, "rings.png")
    subprocess.run(["convert", "-size", "96x64", "xc:white", "-fill", "navy", "-draw", "circle 40,32 40,10", "-fill",
                    "orange", "-draw", "circle 48,32 48,24", "+antialias", picture], check=True)
    editor.click("menu.weave")
    editor.click("menu.picture")
    name_file(editor, picture)
    editor.wait_until("the dialog shows four colours", lambda: editor.fact("picture.colours") == "4")
    editor.screenshot("picture")
    editor.click("picture.colours")
    editor.type("3")
    editor.key("Return")
    editor.wait_until("the palette is reduced", lambda: editor.fact("picture.colours") == "3")
    editor.click("picture.structure_2")
    editor.click("picture.structure_2/Plain")
    editor.click("picture.ends")
    editor.type("192")
    editor.key("Return")
    editor.click("picture.proportions")
    revision = editor.number("revision")
    editor.click("picture.weave")
    editor.wait_until("the picture is woven", lambda: editor.number("revision") > revision)
    fabric = saved_as(editor, os.path.join(home, "rings.json"))
    rows = fabric["weave"]
    expect(len(rows[0]) == 192, f"the weave has {len(rows[0])} ends")
    expect(len(rows) == round(192 * 64 / 96 * 8 / 10), f"the weave has {len(rows)} picks")
    expect(rows[0][:6] in ("#.#.#.", ".#.#.#"), f"the ground is not plain: {rows[0][:6]}")
    expect(editor.fact("draft.kind") == "jacquard", "a loom of 32 shafts weaves rings")


def export_others(editor, home):
    file = export(editor, "menu.export_draft", os.path.join(home, "draft.pdf"))
    with open(file, "rb") as pdf:
        expect(pdf.read(5) == b"%PDF-", "the draft is no PDF")
    editor.click("menu.file")
    editor.click("menu.export")
    editor.click("menu.export_tile")
    editor.move(*editor.centre("tile.size"))  # by then the dialog has its size
    for field, value in (("tile.size", "32"), ("tile.samples", "1")):
        editor.click(field)
        editor.type(value)
        editor.key("Return")
    editor.click("tile.file")
    editor.key("ctrl+a")
    editor.type(os.path.join(home, "tile.json"))
    editor.click("tile.start")
    editor.wait_until("the tile is written", lambda: editor.fact("tile.outcome").startswith("Written"), 90)
    editor.click("tile.close")
    editor.wait_until("the dialog closes", lambda: editor.fact("dialog") == "none")
    tile = read_json(os.path.join(home, "tile.json"))
    expect(max(tile["width_px"], tile["height_px"]) == 32, f"the tile is {tile['width_px']} x {tile['height_px']}")
    expect(os.path.exists(os.path.join(home, tile["maps"]["normal"]["file"])), "there is no map of normals")


def refuse(editor, home):
    editor.key("ctrl+o")
    name_file(editor, write(home, "story.wif", "You are in a maze of twisty little passages.\n"))
    answer(editor)
    expect(editor.fact("name") == "Rosepath", "a file that is no weaving file took the cloth away")


def test():
    with window(WIDTH, HEIGHT) as editor:
        editor.start(PROGRAM, [plain_cloth(editor.home)])
        open_weaving(editor, editor.home)
        look_before_opening(editor, editor.home)
        export_weaving(editor, editor.home)
        bitmaps(editor, editor.home)
        export_others(editor, editor.home)
        refuse(editor, editor.home)
        jacquard(editor, editor.home)
        editor.key("ctrl+q")
        expect(editor.wait_for_end() == 0, "the editor does not end")


run(test)
