"""Six things that designers sit down to do, each in few actions, as ActionCount counts them; the time that the editor
takes is nobody's action. Every task ends with the cloth that was asked for, in its file. In the real window."""

import json
import os
import subprocess
import sys

from window_driver import Failure, expect, read_json, window

PROGRAM = os.environ["LOOMLIGHT"]
SAMPLES = os.path.join(os.environ["LOOMLIGHT_ROOT"], "samples")
WIDTH, HEIGHT = 900, 600
SAMPLES_A_PIXEL = 1  # no task looks at the picture

TWILL = ["#..#", "##..", ".##.", "..##"]
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


def answered(editor):
    editor.wait_until("nothing is typed", lambda: editor.fact("text_input") == "no")


def enter(editor, field, value):
    """A click that opens the field, and the value with its Enter."""
    editor.click(field)
    editor.type(value)
    editor.key("Return")


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


def new(editor):
    editor.key("ctrl+n")
    editor.wait_until("there is a new cloth", lambda: editor.fact("file") == "" and editor.fact("dirty") == "no")


def dye(editor, colour):
    """What is looked at on the page of fibres, by the colour that the cloth should have."""
    editor.wait_until("the cloth is measured",
                      lambda: not editor.fact("fibre.cloth_colour_remark").startswith("Measuring"))
    enter(editor, "fibre.colour_code", colour)
    editor.wait_until("the colour is reached",
                      lambda: editor.fact("fibre.cloth_colour_remark").startswith("Reached"))
    answered(editor)


def a_houndstooth_from_new(editor):
    new(editor)
    editor.click("structure/Twill 2/2")
    editor.click("draft.tab_colours")
    enter(editor, "draft.warp_order", "4A 4B")
    enter(editor, "draft.weft_order", "4A 4B")
    editor.click("tab.fibre")
    dye(editor, "#39353c")
    answered(editor)
    editor.key("bracketright")
    dye(editor, "#9c9482")
    cloth = save_as(editor, "houndstooth.json")
    expect(sorted(cloth["weave"]) == sorted(TWILL), f"no 2/2 twill: {cloth['weave']}")
    for order in (cloth["warp_sequence"], cloth["weft_sequence"]):
        expect(order == [0, 0, 0, 0, 1, 1, 1, 1], f"no order of a houndstooth: {order}")
    fibres = [cloth["fibres"][cloth["yarns"][yarn]["fibre"]] for yarn in (0, 1)]
    expect(fibres[0] != fibres[1], "both yarns are of one colour")


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


def a_silk_satin_of_a_wanted_colour(editor):
    new(editor)
    editor.key("ctrl+b")
    enter(editor, "presets.search", "charm")
    editor.click("presets.card/Charmeuse")
    editor.key("Return")
    quiet(editor)
    editor.click("tab.fibre")
    editor.click("fibre.dyed/Piece")
    dye(editor, "#8c4453")
    cloth = save_as(editor, "satin.json")
    expect(all("silk" in fibre["name"] for fibre in cloth["fibres"]), f"no silk: {cloth['fibres']}")
    dyes = {json.dumps(fibre["absorption_per_mm"]) for fibre in cloth["fibres"]}
    expect(len(dyes) == 1, "the piece has not one dye")
    report = subprocess.run([PROGRAM, "info", os.path.join(editor.home, "satin.json"), "--json"], check=True,
                            capture_output=True, text=True).stdout
    expect(json.loads(report)["max_warp_float"] >= 4, "no satin")


def a_picture_woven(editor):
    file = os.path.join(editor.home, "rings.png")
    subprocess.run(["convert", "-size", "48x48", "xc:white", "-fill", "black", "-draw", "circle 24,24 24,8",
                    "-fill", "white", "-draw", "circle 24,24 24,16", file], check=True)
    open_file(editor, file)
    editor.wait_until("the picture is read", lambda: editor.fact("picture.state") == "ready")
    editor.key("Return")
    quiet(editor)
    cloth = save_as(editor, "rings.json")
    rows = cloth["weave"]
    expect(len(rows) >= 16 and len(rows[0]) >= 16, f"a weave of {len(rows[0])} x {len(rows)}")
    middle = rows[len(rows) // 2]
    expect(len({middle.count("#"), rows[0].count("#")}) == 2, "there is no ring in the weave")


def own_mesh_environment_and_tile(editor):
    mesh = os.path.join(SAMPLES, "folded_cloth.obj")
    light = os.path.join(editor.home, "studio.exr")
    cloth = os.path.join(SAMPLES, "denim.json")
    subprocess.run([PROGRAM, "render", cloth, "-o", light, "--size", "32x16", "--spp", "1", "--resolution", "1"],
                   check=True, capture_output=True)
    open_file(editor, mesh)
    quiet(editor)
    open_file(editor, light)
    quiet(editor)
    editor.key("ctrl+e")
    editor.wait_until("the tile's size is known", lambda: editor.fact("tile.size_mm").endswith("mm"))
    enter(editor, "tile.size", "32")  # what is soon rendered
    answered(editor)
    editor.key("Return")
    editor.wait_until("the tile is written", lambda: editor.fact("tile.outcome").startswith("Written"))

    def check():
        tiles = [name for name in os.listdir(editor.home) if name.endswith("tile.json")]
        expect(len(tiles) == 1, f"there is no tile: {os.listdir(editor.home)}")
        tile = read_json(os.path.join(editor.home, tiles[0]))
        expect(max(tile["width_px"], tile["height_px"]) == 32, "a tile of another size")
        editor.key("Return")
        quiet(editor)
        saved = save_as(editor, "scene.json")
        expect(saved["drape"]["kind"] == "mesh", f"the drape is {saved['drape']}")
        expect(saved["drape"]["file"].endswith("folded_cloth.obj"), f"the mesh is {saved['drape']}")
        expect(saved["light"]["file"] == "studio.exr", f"the light is {saved['light']}")  # as it lies beside the cloth

    return check


def wrong_values(editor):
    """No count: nothing that is wrong is taken, it is said what is, and what was stays."""
    before = editor.number("revision")
    editor.click("tab.cloth")
    for value in ("9999", "-3", "many", "1,234"):
        enter(editor, "cloth.ends_per_cm", value)
        answered(editor)
        expect(editor.number("revision") == before, f"{value} ends were taken")
    editor.click("draft.tab_colours")
    for order, problem in (("6A 4Z", "There is no yarn"), ("4A 2(B", "Expected"), ("0A", "Expected")):
        editor.click("draft.warp_order")
        editor.key("ctrl+a")
        editor.type(order)
        editor.key("Return")
        editor.wait_until(f"{order} is refused aloud",
                          lambda said=problem: editor.fact("draft.warp_order_problem").startswith(said))
        expect(editor.number("revision") == before, f"{order} was taken")
    open_missing = os.path.join(editor.home, "not there.json")
    editor.key("Escape")
    editor.key("ctrl+o")
    editor.wait_until("a name is asked for", lambda: "browser.name" in editor.widgets())
    editor.type(open_missing)
    editor.key("Return")
    editor.wait_until("it is said that there is none", lambda: "browser.problem" in editor.widgets())
    editor.click("browser.cancel")
    quiet(editor)
    expect(editor.fact("dirty") == "no", "a wrong value is an edit")


def within(editor, most, task):
    counted = editor.input.actions
    before = counted.count
    check = task(editor)
    taken = counted.count - before
    print(f"{task.__name__}: {taken} actions", flush=True)
    expect(taken <= most, f"{task.__name__} took {taken} actions, {most} at most")
    if check:
        check()


TASKS = ((a_houndstooth_from_new, 15), (an_opened_draft_changed, 12), (a_silk_satin_of_a_wanted_colour, 12),
         (a_picture_woven, 6), (own_mesh_environment_and_tile, 8))


def main(chosen):
    """One after the other in one window, each beside a cloth that has no file yet."""
    with window(WIDTH, HEIGHT, SAMPLES_A_PIXEL) as editor:
        editor.start(PROGRAM)
        for task, most in TASKS:
            if not chosen or task.__name__ in chosen:
                new(editor)
                within(editor, most, task)
        if not chosen or "wrong_values" in chosen:
            wrong_values(editor)


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except Failure as failure:
        print(f"FAILED: {failure}", file=sys.stderr)
        sys.exit(1)
