"""The truth lens and the picture of local visibility: opened, dragged, switched and closed in the real window."""

import os

from window_driver import difference, expect, picture_statistics, read_json, run, window, write_json

PROGRAM = os.environ["LOOMLIGHT"]
SAMPLES = os.path.join(os.environ["LOOMLIGHT_ROOT"], "samples")
WIDTH, HEIGHT = 1024, 720


def small_fabric(home):
    """A few coarse fibres: laid in a moment, by a slow machine too."""
    fabric = read_json(os.path.join(SAMPLES, "black_and_white_cloth.json"))
    for fibre in fabric["fibres"]:
        fibre["radius_um"] = 20
    fabric["drape"] = {"kind": "flat", "width_mm": 6, "height_mm": 6}
    fabric["light"] = {"kind": "dome"}
    fabric["camera"] = {"distance_mm": 28, "elevation_deg": 80}
    fabric["render"] = {"resolution": 2, "max_depth": 8}
    return write_json(home, "cloth.json", fabric)


def place(editor):
    """Left, top, right and bottom edge of the lens."""
    return [round(edge) for edge in editor.widgets().get("lens", (0, 0, 0, 0))]


def size(editor):
    x0, y0, x1, y1 = place(editor)
    return x1 - x0, y1 - y0


def cropped(editor, name):
    return editor.screenshot(name, "lens")


def open_lens(editor):
    editor.click("view.lens")
    editor.wait_until("the tool is chosen", lambda: editor.fact("lens_tool") == "chosen")
    x, y = editor.centre("viewport")
    revision = editor.number("generation")
    editor.drag((x - 90, y - 50), (x + 70, y + 70))
    editor.wait_until("a drag places a lens of 160 by 120 pixels", lambda: size(editor) == (160, 120))
    expect(editor.number("generation") == revision, "placing the lens moved the camera")
    editor.wait_until("the lens shows fibres", lambda: editor.number("lens_samples") >= 1)
    expect("lens.caption" in editor.widgets(), "the lens says nothing of what it shows")
    _, deviation = picture_statistics(cropped(editor, "fibres"))
    expect(deviation > 0.05, f"the lens shows no cloth: deviation {deviation}")


def compare(editor):
    before = cropped(editor, "before")
    editor.click("lens.difference")
    editor.wait_until("both pictures can be compared", lambda: editor.fact("lens_difference") == "known")
    editor.wait_until("the difference is drawn",
                      lambda: difference(before, cropped(editor, "difference")) > 0.05)
    editor.click("lens.fibres")


def move_and_resize(editor):
    x0, y0, x1, y1 = place(editor)
    editor.drag_widget("lens.bar", 40, 30)
    editor.wait_until("the bar moves the lens", lambda: place(editor) == [x0 + 40, y0 + 30, x1 + 40, y1 + 30])
    x0, y0, x1, y1 = place(editor)
    editor.drag((x1, y1), (x1 + 20, y1 - 30))
    editor.wait_until("pulling a corner moves two edges", lambda: place(editor) == [x0, y0, x1 + 20, y1 - 30])
    editor.wait_until("the lens shows fibres there", lambda: editor.number("lens_samples") >= 1)


def edit_under_it(editor):
    generation = editor.number("generation")
    editor.click("draft.cell_0_0")
    editor.wait_until("an edit changes the cloth", lambda: editor.number("generation") > generation)
    editor.wait_until("the lens follows the edit",
                      lambda: editor.number("lens_generation") == editor.number("generation"))
    x0, y0, x1, y1 = place(editor)
    generation = editor.number("generation")
    editor.drag(((x0 + x1) / 2, (y0 + y1) / 2), ((x0 + x1) / 2 + 30, (y0 + y1) / 2 + 20))
    editor.wait_until("the camera moves through the lens", lambda: editor.number("generation") > generation)
    editor.wait_until("the lens follows the camera",
                      lambda: editor.number("lens_generation") == editor.number("generation"))


def close_lens(editor):
    editor.click("lens.close")
    editor.wait_until("the lens closes", lambda: "lens" not in editor.widgets() and editor.fact("lens") == "closed")
    editor.key("l")
    editor.wait_until("its key chooses the tool", lambda: editor.fact("lens_tool") == "chosen")
    editor.click("viewport")
    editor.wait_until("its key and a click open it again", lambda: "lens" in editor.widgets())
    editor.key("Escape")
    editor.wait_until("Escape closes it", lambda: "lens" not in editor.widgets())


def look_at_wide_cloth(editor):
    """Fibres are laid for each kind of cell once: of cloth on a cylinder, a foot wide, within next to no memory."""
    editor.click("menu.edit")
    editor.click("menu.preferences")
    editor.wheel(*editor.centre("preferences.lengths"), clicks=12)  # to the end of the page
    editor.click("preferences.fibre_memory")
    editor.key("ctrl+a")
    editor.type("0.1")
    editor.key("Return")
    editor.click("preferences.close")
    editor.click("tab.scene")
    editor.click("view.drape")
    editor.click("view.drape/Cylinder")
    editor.click("drape.width_mm")
    editor.type("300")
    editor.key("Return")
    editor.wait_for_picture()
    editor.key("l")
    editor.wait_until("the tool is chosen", lambda: editor.fact("lens_tool") == "chosen")
    editor.click("viewport")
    editor.wait_until("its fibres are shown", lambda: editor.number("lens_samples") >= 1
                      and editor.number("lens_generation") == editor.number("generation"))
    expect("lens.trouble" not in editor.widgets(), "the lens speaks of trouble")
    editor.key("Escape")


def look_at_visibility(editor):
    editor.click("tab.yarn")
    expect(editor.fact("visibility") == "none", "tables were baked that nobody looks at")
    editor.click("inspector.yarn_1")
    x, y = editor.centre("viewport")
    places = [(x + 7 * i, y + 5 * i) for i in range(-8, 9)]  # over several crossings, so over both yarns
    for place in places:
        editor.click_at(*place)
        if editor.fact("yarn") == "0":
            break
    expect(editor.fact("yarn") == "0", "clicks on the cloth do not choose the yarn that is seen there")
    x, y = editor.centre("yarn.ply_twist_per_m")
    editor.wheel(x, y, clicks=12)  # to the end of the page
    editor.click("visibility.fold")
    editor.wait_until("a picture of the table is shown", lambda: editor.fact("visibility") in ("early", "finished"))
    editor.wait_until("the bake ends", lambda: editor.fact("visibility") == "finished")
    editor.wait_until("the status bar speaks of it no more", lambda: "status.background" not in editor.widgets())
    mean, deviation = picture_statistics(editor.screenshot("visibility", "visibility.picture"))
    expect(mean > 0.1 and deviation > 0.1, f"the picture is empty: mean {mean}, deviation {deviation}")


def test():
    with window(WIDTH, HEIGHT, samples=2) as editor:  # a difference is known from two on
        editor.start(PROGRAM, [small_fabric(editor.home)])
        editor.wait_for_picture()
        open_lens(editor)
        compare(editor)
        move_and_resize(editor)
        edit_under_it(editor)
        close_lens(editor)
        look_at_wide_cloth(editor)
        look_at_visibility(editor)
        expect(editor.fact("dirty") == "yes", "there is unsaved work")
        editor.leave()


run(test)
