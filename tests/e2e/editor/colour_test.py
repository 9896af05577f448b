"""Colour as a designer works with it: the colour that the cloth should have, orders of yarns and stripes by chance, and
several colourways of one construction side by side. In the real window."""

import os

from window_driver import expect, picture_statistics, run, window, write_json

PROGRAM = os.environ["LOOMLIGHT"]
WIDTH, HEIGHT = 900, 720


def small_fabric(home):
    fabric = {
        "loomlight_version": 1, "name": "Colour trial", "weave": ["##..", ".##.", "..##", "#..#"],
        "ends_per_cm": 30, "picks_per_cm": 26, "warp_sequence": [0, 0, 1], "weft_sequence": [0],
        "yarns": [{"name": "light", "count_tex": 24, "fibre": 0}, {"name": "dark", "count_tex": 24, "fibre": 1}],
        "fibres": [{"name": "ecru", "radius_um": 9, "absorption_per_mm": [2, 3, 5]},
                   {"name": "navy", "radius_um": 9, "absorption_per_mm": [60, 40, 12]}],
        "drape": {"kind": "flat", "width_mm": 5, "height_mm": 5},
        "light": {"kind": "dome"}, "camera": {"distance_mm": 14, "elevation_deg": 75}, "render": {"resolution": 1},
    }
    return write_json(home, "trial.json", fabric)


def pick_the_cloths_colour(editor, file):
    editor.click("tab.fibre")
    editor.wait_until("the cloth's colour is measured",
                      lambda: editor.fact("fibre.cloth_colour_remark").startswith("Pick"))
    revision = editor.number("revision")
    editor.click("fibre.cloth_colour")
    editor.centre("fibre.cloth_colour/picker")
    x0, y0, x1, y1 = editor.widgets()["fibre.cloth_colour/picker"]
    # In the field of saturation and value, which fills the picker's upper left.
    side = min(x1 - x0, y1 - y0)
    editor.drag((x0 + 0.3 * side, y0 + 0.35 * side), (x0 + 0.5 * side, y0 + 0.4 * side))
    editor.wait_until("the fibre is dyed for it", lambda: editor.number("revision") > revision)
    editor.key("Escape")
    editor.wait_until("the colour is reached",
                      lambda: editor.fact("fibre.cloth_colour_remark").startswith("Reached"))
    dyed = editor.saved(file)["fibres"]
    expect(dyed[0]["absorption_per_mm"] != [2, 3, 5], "the fibre was not dyed")
    expect(dyed[1]["absorption_per_mm"] == [60, 40, 12], "the other fibre was dyed too")
    editor.key("ctrl+z")
    editor.wait_until("one step of undo takes the dye back", lambda: editor.fact("dirty") == "yes")
    expect(editor.saved(file)["fibres"][0]["absorption_per_mm"] == [2, 3, 5], "undo left some of the dye")


def ask_for_too_much(editor):
    editor.click("fibre.cloth_colour")
    editor.centre("fibre.cloth_colour/picker")
    x0, y0, x1, y1 = editor.widgets()["fibre.cloth_colour/picker"]
    editor.drag((x0 + 30, y0 + 30), (x0 - 5, y0 - 5))  # the corner of white
    editor.wait_until("the editor says what cannot be",
                      lambda: "nearest" in editor.fact("fibre.cloth_colour_remark"))
    editor.key("Escape")


def scroll_to(editor, widget):
    """The page of colours is longer than its room."""
    x0, _, x1, y1 = editor.widgets()["draft.tab_colours"]
    for _ in range(30):
        if editor.widgets()[widget][3] < HEIGHT - 240:
            return
        editor.wheel((x0 + x1) / 2, y1 + 60)


def order_yarns(editor, file):
    editor.click("draft.tab_colours")
    editor.centre("order.widen")
    scroll_to(editor, "order.widen")
    for tool, expected in (("order.mirror", [0, 0, 1, 0]), ("order.reverse", [0, 1, 0, 0]),
                           ("order.widen", [0, 0, 1, 1, 0, 0, 0, 0])):
        revision = editor.number("revision")
        editor.click(tool)
        editor.wait_until(f"{tool} edits the fabric", lambda: editor.number("revision") > revision)
        sequence = editor.saved(file)["warp_sequence"]
        expect(sequence == expected, f"{tool} made {sequence}")
    scroll_to(editor, "order.chance")
    editor.click("order.chance")
    scroll_to(editor, "order.random")
    revision = editor.number("revision")
    editor.click("order.random")
    editor.wait_until("stripes are drawn", lambda: editor.number("revision") > revision)
    sequence = editor.saved(file)["warp_sequence"]
    expect(len(sequence) == 96 and set(sequence) == {0, 1}, f"no stripes: {sequence}")


def compare_colourways(editor, file):
    editor.click("menu.edit")
    editor.click("menu.colourways")
    editor.click("colourways.keep")
    editor.wait_until("the present colours are kept", lambda: "colourways.card_1" in editor.widgets())
    editor.click("colourways.name")
    editor.key("ctrl+a")
    editor.type("Night")
    editor.click("colourways.copy")
    editor.wait_until("there is another one", lambda: "colourways.card_2" in editor.widgets())

    def rendered():
        return picture_statistics(editor.screenshot("card", "colourways.card_1"))[1] > 0.05
    editor.wait_until("its picture is rendered", rendered)
    editor.click("colourways.card_2")
    editor.click("colourways.remove")
    editor.wait_until("it is removed", lambda: "colourways.card_2" not in editor.widgets())
    editor.click("colourways.use")
    editor.click("colourways.close")
    editor.wait_until("the dialog closes", lambda: editor.fact("dialog") == "none")
    colourways = editor.saved(file)["colourways"]
    expect([c["name"] for c in colourways] == ["Night"], f"colourways: {colourways}")


def test():
    with window(WIDTH, HEIGHT) as editor:
        file = small_fabric(editor.home)
        editor.start(PROGRAM, [file])
        editor.wait_for_picture()
        editor.wait_until("the yarn is seen close up", lambda: editor.fact("yarn.close_up") == "there")
        pick_the_cloths_colour(editor, file)
        ask_for_too_much(editor)
        order_yarns(editor, file)
        compare_colourways(editor, file)


run(test)
