"""What the editor is set to: units of the trade and the usual piece, kept from one session to the next. In the real
window."""

import os

from small_cloth import small_cloth
from window_driver import expect, read_json, run, window

PROGRAM = os.environ["LOOMLIGHT"]
WIDTH, HEIGHT = 1280, 720


def small_fabric(home):
    return small_cloth(home, "Shirting", ends_per_cm=30, picks_per_cm=27, fibres=[{"name": "cotton"}],
                       yarns=[{"name": "Ne 30", "count_tex": 19.683}])


def set_units(editor):
    editor.click("menu.edit")
    editor.click("menu.preferences")
    editor.click("preferences.count_system")
    editor.click("preferences.count_system/Ne (cotton count)")
    editor.click("preferences.twist_unit/TM")
    editor.click("preferences.lengths/inch")
    for field, number in (("piece_length", "60"), ("piece_width", "140")):
        editor.click("preferences." + field)
        editor.type(number)
        editor.key("Return")
    escape_leaves_one_thing(editor)


def escape_leaves_one_thing(editor):
    """An open list, then a number that is being typed, then the dialog."""
    editor.click("preferences.count_system")
    editor.wait_until("the list is open", lambda: "preferences.count_system/Ne (cotton count)" in editor.widgets())
    editor.key("Escape")
    editor.wait_until("the list closes", lambda: "preferences.count_system/Ne (cotton count)" not in editor.widgets())
    editor.click("preferences.piece_length")
    editor.type("70")
    editor.key("Escape")
    editor.wait_until("the number is left", lambda: editor.fact("text_input") == "no")
    expect(editor.fact("dialog") == "open", "Escape was meant for the list and for the number")
    editor.key("Escape")
    editor.wait_until("the dialog closes", lambda: editor.fact("dialog") == "none")


def units_are_used(editor):
    editor.click("tab.cloth")
    editor.wait_until("counts are cotton counts", lambda: editor.fact("cloth.warp_count") == "30.0 Ne")
    expect(editor.fact("cloth.per_cm") == "30.0 \u00d7 27.0", f"setts are to the inch: {editor.fact('cloth.per_cm')}")
    expect(editor.fact("cloth.repeat").endswith(" in"), f"the repeat: {editor.fact('cloth.repeat')}")


def a_sett_in_inches(editor):
    editor.click("cloth.ends_per_cm")
    editor.type("76.2")
    editor.key("Return")
    expect(editor.fact("dirty") == "no", "what was there already is no edit")
    editor.click("cloth.picks_per_cm")
    editor.type("50.8")
    editor.key("Return")
    editor.wait_until("typed inches become centimetres", lambda: editor.fact("cloth.per_cm") == "30.0 \u00d7 20.0")


def leave(editor):
    editor.key("ctrl+q")
    if editor.fact("dirty") == "yes":
        editor.click("message.answer_1")
    expect(editor.wait_for_end() == 0, editor.log())


def test():
    with window(WIDTH, HEIGHT) as editor:
        file = small_fabric(editor.home)
        editor.start(PROGRAM, [file])
        editor.wait_for_picture()
        set_units(editor)
        units_are_used(editor)
        a_sett_in_inches(editor)
        leave(editor)
        kept = read_json(editor.settings_file)
        expect((kept["count_unit"], kept["piece_length_m"], kept["piece_width_cm"]) == ("Ne", 60, 140), f"kept: {kept}")
        editor.start(PROGRAM, [file])
        units_are_used(editor)


run(test)
