"""The browser of presets: kept, found, renamed, duplicated, removed and brought back; cloths, yarns, fibres and colours
apart. In the real window."""

import os

from window_driver import expect, picture_statistics, read_json, run, window, write_json

PROGRAM = os.environ["LOOMLIGHT"]
WIDTH, HEIGHT = 1280, 720


def small_fabric(home):
    fabric = {
        "loomlight_version": 1, "name": "Rust check", "weave": ["#.", ".#"], "ends_per_cm": 14, "picks_per_cm": 14,
        "fibres": [{"name": "coarse", "radius_um": 20, "absorption_per_mm": [4, 14, 30]}],
        "drape": {"kind": "flat", "width_mm": 6, "height_mm": 6},
        "light": {"kind": "dome"}, "camera": {"distance_mm": 16, "elevation_deg": 75}, "render": {"resolution": 1},
    }
    return write_json(home, "rust.json", fabric)


def card(editor, name):
    return f"presets.card/{name}" in editor.widgets()


def search(editor, text):
    editor.click("presets.search")
    editor.key("ctrl+a")
    editor.type(text)


def keep_and_change(editor):
    editor.key("ctrl+b")
    editor.wait_until("the browser shows cloths", lambda: card(editor, "Denim"))
    editor.click("presets.keep")
    editor.wait_until("the cloth is kept", lambda: card(editor, "Rust check"))
    editor.wait_until("it is pictured",
                      lambda: picture_statistics(editor.screenshot("card", "presets.card/Rust check"))[1] > 0.1, 120)
    search(editor, "rus")
    editor.wait_until("others are hidden", lambda: not card(editor, "Denim") and card(editor, "Rust check"))
    editor.click("presets.card/Rust check")
    editor.click("presets.duplicate")
    editor.wait_until("there is a duplicate", lambda: card(editor, "Rust check 2"))
    editor.click("presets.card/Rust check 2")
    editor.click("presets.name")
    editor.key("ctrl+a")
    editor.type("Rusty")
    editor.click("presets.rename")
    editor.wait_until("it has another name", lambda: card(editor, "Rusty") and not card(editor, "Rust check 2"))
    editor.click("presets.card/Rusty")
    editor.click("presets.remove")
    editor.wait_until("it is removed", lambda: not card(editor, "Rusty"))
    editor.click("presets.undo")
    editor.wait_until("undo brings it back", lambda: card(editor, "Rusty"))
    editor.click("presets.undo")
    editor.wait_until("undo takes the name back", lambda: card(editor, "Rust check 2") and not card(editor, "Rusty"))
    expect(editor.fact("dirty") == "no", "what is kept is no edit of the cloth")


def tag_and_find(editor):
    """Also what came with the program, and the tags go with what they are of."""
    editor.click("presets.search")
    editor.key("ctrl+a", "Delete")
    editor.wait_until("all are shown", lambda: card(editor, "Denim") and card(editor, "Rust check 2"))
    for name in ("Denim", "Rust check 2"):
        editor.click("presets.card/" + name)
        editor.click("presets.tags")
        editor.key("ctrl+a")
        editor.type("winter, client A")
        editor.click("presets.tag")
    search(editor, "winter")
    editor.wait_until("tags are searched", lambda: card(editor, "Denim") and card(editor, "Rust check 2")
                      and not card(editor, "Rust check") and not card(editor, "Sheer silk"))
    editor.click("presets.card/Rust check 2")
    editor.click("presets.duplicate")
    editor.wait_until("a duplicate has its tags", lambda: card(editor, "Rust check 2 2"))
    editor.click("presets.undo")
    editor.click("presets.undo")
    editor.wait_until("undo takes the tags off", lambda: not card(editor, "Rust check 2") and card(editor, "Denim"))


def tags_go_with_what_they_are_of(editor):
    """Of what is removed no tag is left for another of that name, until it is brought back."""
    tags = lambda: read_json(os.path.join(editor.home, "data", "loomlight", "presets", "tags"))
    search(editor, "rust")
    editor.wait_until("both are shown", lambda: card(editor, "Rust check") and card(editor, "Rust check 2"))
    editor.click("presets.card/Rust check 2")
    editor.click("presets.tags")
    editor.key("ctrl+a")
    editor.type("autumn")
    editor.click("presets.tag")
    editor.wait_until("it is tagged", lambda: tags().get("Rust check 2") == "autumn")
    editor.click("presets.remove")
    editor.wait_until("its tags go with it", lambda: "Rust check 2" not in tags())
    editor.click("presets.undo")
    editor.wait_until("they come back with it", lambda: tags().get("Rust check 2") == "autumn")
    editor.wait_until("it comes back", lambda: card(editor, "Rust check 2"))


def use_a_yarn(editor):
    search(editor, "silk 20")
    editor.click("presets.kind/Yarns")
    editor.wait_until("yarns are found", lambda: card(editor, "Silk 20/22 den"))
    editor.click("presets.card/Silk 20/22 den")
    editor.click("presets.use")
    editor.wait_until("the browser closes", lambda: editor.fact("dialog") == "none")
    editor.wait_until("the cloth has another yarn", lambda: editor.fact("dirty") == "yes")
    editor.click("tab.cloth")
    editor.wait_until("it is of silk", lambda: editor.fact("cloth.warp_count") == "2.3 tex")
    editor.key("ctrl+z")
    editor.wait_until("undo takes it out", lambda: editor.fact("dirty") == "no")


def use_colours(editor):
    """Those of a cloth that came with the program, and the designer's own, which bring them back."""
    editor.key("ctrl+b")
    editor.click("presets.kind/Colours")
    editor.click("presets.search")
    editor.key("ctrl+a", "Delete")
    editor.click("presets.keep")
    editor.wait_until("the cloth's colours are kept", lambda: card(editor, "Rust check"))
    for colours in ("Denim", "Rust check"):
        editor.click("presets.card/" + colours)
        editor.click("presets.use")
        editor.wait_until("the browser closes", lambda: editor.fact("dialog") == "none")
        editor.wait_until("the cloth is dyed", lambda: editor.fact("dirty") == "yes")
        editor.key("ctrl+b")
        editor.wait_until("the browser opens", lambda: "presets.close" in editor.widgets())
    editor.click("presets.close")
    editor.wait_until("the browser closes", lambda: editor.fact("dialog") == "none")
    dyed = editor.saved(os.path.join(editor.home, "rust.json"))["fibres"][0]["absorption_per_mm"]
    expect(dyed == [4, 14, 30], f"the designer's own colours did not come back: {dyed}")


def use_a_cloth(editor):
    editor.key("ctrl+b")
    editor.wait_until("the browser opens", lambda: "presets.kind/Fabrics" in editor.widgets())
    editor.click("presets.kind/Fabrics")
    search(editor, "denim")
    editor.click("presets.card/Denim")
    editor.click("presets.use")
    editor.wait_until("the cloth is denim", lambda: editor.fact("name") == "Denim")


def keep_from_the_menu(editor):
    editor.click("menu.file")
    editor.click("menu.save_preset")
    editor.wait_until("the editor says so", lambda: '"Denim" is among the presets now.' in editor.fact("message"))
    editor.click("message.answer_0")
    editor.wait_until("the message is gone", lambda: editor.fact("dialog") == "none")


def test():
    with window(WIDTH, HEIGHT) as editor:
        editor.start(PROGRAM, [small_fabric(editor.home)])
        editor.wait_for_picture()
        keep_and_change(editor)
        tag_and_find(editor)
        tags_go_with_what_they_are_of(editor)
        use_a_yarn(editor)
        use_colours(editor)
        use_a_cloth(editor)
        keep_from_the_menu(editor)


run(test)
