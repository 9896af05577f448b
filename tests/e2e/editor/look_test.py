"""The editor in three sizes: whatever is opened, no label, choice or button loses its end, and nothing leaves the
window. Its interface can be made larger or smaller."""

import os

from window_driver import expect, read_json, run, window, write_json

PROGRAM = os.environ["LOOMLIGHT"]
SAMPLES = os.path.join(os.environ["LOOMLIGHT_ROOT"], "samples")
SIZES = ((1280, 720, 1), (1920, 1080, 1), (2560, 1440, 2))  # width, height, scale
PAGES = ("tab.fibre", "tab.cloth", "tab.scene", "tab.yarn", "draft.tab_loom", "draft.tab_colours",
         "draft.tab_structures")
MENUS = {"menu.file": "menu.quit", "menu.edit": "menu.undo", "menu.weave": "menu.invert", "menu.view": "menu.fit",
         "menu.help": "menu.about"}
DIALOGS = {("menu.file", "menu.snapshot"): "snapshot.close", ("menu.edit", "menu.preferences"): "preferences.close",
           ("menu.weave", "menu.structures"): "structures.close", ("menu.help", "menu.keys"): "keys.close",
           ("menu.file", "menu.presets"): "presets.close", ("menu.edit", "menu.colourways"): "colourways.close"}


def light_fabric(home):
    fabric = read_json(os.path.join(SAMPLES, "denim.json"))
    fabric["drape"] = {"kind": "flat", "width_mm": 4, "height_mm": 4}
    fabric["light"] = {"kind": "headlight"}  # the longest name of a light
    fabric["render"] = {"resolution": 1}
    return write_json(home, "cloth.json", fabric)


def looks_whole(editor, where):
    dump = editor.dump()
    clipped = {name: text for name, text in dump["facts"].items() if name.startswith("clipped.")}
    expect(not clipped, f"{where} at {editor.width} x {editor.height}: clipped {clipped}")


def inside(editor, widget):
    x0, y0, x1, y1 = editor.widgets()[widget]
    expect(0 <= x0 < x1 <= editor.width and 0 <= y0 < y1 <= editor.height,
           f"{widget} at {x0, y0, x1, y1} leaves the window of {editor.width} x {editor.height}")


def visit_pages(editor):
    looks_whole(editor, "the first sight")
    for page in PAGES:
        editor.click(page)
        looks_whole(editor, page)


def visit_menus(editor):
    for menu, item in MENUS.items():
        editor.click(menu)
        editor.centre(item)
        inside(editor, item)
        looks_whole(editor, menu)
        editor.key("Escape")
        editor.wait_until("Esc shuts the menu", lambda item=item: item not in editor.widgets())


def visit_dialogs(editor):
    for path, close in DIALOGS.items():
        for item in path:
            editor.click(item)
        editor.centre(close)
        inside(editor, close)
        looks_whole(editor, path[-1])
        editor.key("Escape")
        editor.wait_until("Esc closes the dialog", lambda close=close: close not in editor.widgets())


def look_at(width, height, scale):
    with window(width, height) as editor:
        editor.scale = scale
        editor.start(PROGRAM, [light_fabric(editor.home)])
        visit_pages(editor)
        if (width, height, scale) == SIZES[0]:  # the tightest
            visit_menus(editor)
            visit_dialogs(editor)
            views(editor)
            resize(editor)


def views(editor):
    """1, 2 and 3 look from above, aslant and along the cloth; ? lists the keys."""
    for key in ("3", "2", "1"):
        generation = editor.number("generation")
        editor.key(key)
        editor.wait_until(f"{key} turns the cloth",
                          lambda generation=generation: editor.number("generation") > generation)
    editor.act("key", "question")
    editor.centre("keys.close")
    editor.key("Escape")
    editor.wait_until("Esc closes the list", lambda: "keys.close" not in editor.widgets())


def resize(editor):
    """Smaller and larger than the monitor asks for, and back; larger as far as leaves room for the cloth."""
    def height():
        x0, y0, x1, y1 = editor.widgets()["preferences.size"]
        return y1 - y0

    editor.click("menu.edit")
    editor.click("menu.preferences")
    editor.centre("preferences.size")
    usual = height()
    editor.click("preferences.size/75 %")
    editor.wait_until("rows are three quarters as high", lambda: abs(height() - 0.75 * usual) <= 1)
    looks_whole(editor, "a smaller interface")
    editor.click("preferences.size/200 %")
    editor.wait_until("rows are higher", lambda: height() > usual)
    x0, _, x1, _ = editor.widgets()["viewport"]
    expect(x1 - x0 > 0.4 * editor.width, "a large interface leaves no room for the cloth")
    looks_whole(editor, "a larger interface")
    editor.click("preferences.size/100 %")
    editor.wait_until("rows are as high as before", lambda: height() == usual)
    editor.key("Escape")
    editor.wait_until("Esc closes the dialog", lambda: "preferences.size" not in editor.widgets())


def test():
    for size in SIZES:
        look_at(*size)


run(test)
