"""Yarn and fibre as spinners and mills speak of them: counts typed in their systems, twist, diameter, a blend, and what
follows for the cloth. In the real window."""

import os

from window_driver import expect, run, window, write_json

PROGRAM = os.environ["LOOMLIGHT"]
WIDTH, HEIGHT = 1280, 900


def print_cloth(home):
    """The reference cloth of the trade: Ne 30/1, 76 x 68 to the inch."""
    fabric = {
        "loomlight_version": 1, "name": "Print cloth", "weave": ["#.", ".#"],
        "ends_per_cm": 76 / 2.54, "picks_per_cm": 68 / 2.54,
        "yarns": [{"name": "ring-spun", "count_tex": 590.5 / 30, "ply_twist_per_m": 860}],
        "fibres": [{"name": "cotton"}],
        "drape": {"kind": "flat", "width_mm": 5, "height_mm": 5},
        "light": {"kind": "dome"}, "camera": {"distance_mm": 14, "elevation_deg": 75}, "render": {"resolution": 1},
    }
    return write_json(home, "print_cloth.json", fabric)


def type_into(editor, field, text):
    revision = editor.number("revision")
    editor.click(field)
    editor.type(text)
    editor.key("Return")
    editor.wait_until(f"{text} is taken by {field}", lambda: editor.number("revision") > revision)


def choose(editor, field, name):
    editor.click(field)
    editor.click(f"{field}/{name}")


def read_the_cloth(editor):
    editor.click("tab.cloth")
    editor.wait_until("cover is shown", lambda: editor.fact("cloth.cover") == "20.1")
    expect(editor.fact("cloth.per_inch") == "76 \u00d7 68", f"to the inch: {editor.fact('cloth.per_inch')}")
    editor.wait_until("mass is measured", lambda: editor.fact("cloth.mass").endswith("g/m\u00b2"))
    mass = float(editor.fact("cloth.mass").split()[0])
    crimp = [float(editor.fact(f"cloth.crimp_{s}").split()[0]) for s in ("warp", "weft")]
    asked = 0.1 * 590.5 / 30 * (76 / 2.54 * (1 + crimp[0] / 100) + 68 / 2.54 * (1 + crimp[1] / 100))
    expect(abs(mass - asked) < 1, f"{mass} g/m2 with crimps {crimp}, {asked:.1f} expected")
    expect(editor.fact("cloth.balance") == "50 %", "plain weave shows as much warp as weft")
    expect(editor.fact("cloth.warp_float").startswith("1 "), f"float: {editor.fact('cloth.warp_float')}")


def reckon_a_piece(editor):
    x, y = editor.centre("cloth.repeat")
    for _ in range(12):
        editor.click_at(x, y, 5)
    before = editor.fact("cloth.need_warp")
    editor.click("cloth.piece_length")
    editor.type("100")
    editor.key("Return")
    editor.wait_until("a longer piece takes more yarn", lambda: editor.fact("cloth.need_warp") != before)
    warp_km = float(editor.fact("cloth.need_warp").split()[0])
    ends = 150 * 76 / 2.54
    expect(0.99 < warp_km / (0.1 * ends) < 1.3, f"{ends:.0f} ends of 100 m are {warp_km} km")
    expect(editor.fact("dirty") == "no", "reckoning edits nothing")


def spin(editor, file):
    editor.click("tab.yarn")
    type_into(editor, "yarn.count_tex", "30/2 Ne")
    yarn = editor.saved(file)["yarns"][0]
    expect(yarn["plies"] == 2 and abs(yarn["count_tex"] - 2 * 590.5 / 30) < 1e-6, f"30/2 Ne became {yarn}")
    type_into(editor, "yarn.count_tex", "30/2/3 Ne")
    type_into(editor, "yarn.cable_twist_per_m", "365 t/m")
    yarn = editor.saved(file)["yarns"][0]
    expect((yarn["plies"], yarn["cords"], yarn["cable_twist_per_m"]) == (2, 3, 365), f"no cable of 30/2/3: {yarn}")
    expect(abs(yarn["count_tex"] - 6 * 590.5 / 30) < 1e-6, f"30/2/3 Ne became {yarn['count_tex']} tex")
    editor.wait_for_picture()
    type_into(editor, "yarn.count_tex", "30/2 Ne")
    expect(editor.saved(file)["yarns"][0]["cords"] == 1, "30/2 Ne is no cable any more")
    choose(editor, "yarn.count_system", "Nm (km per kg)")
    type_into(editor, "yarn.count_tex", "60")
    yarn = editor.saved(file)["yarns"][0]
    expect(abs(yarn["count_tex"] - 2 * 1000 / 60) < 1e-6, f"60 /2 Nm became {yarn['count_tex']} tex")
    type_into(editor, "yarn.ply_twist_per_m", "4 TM")
    twist = editor.saved(file)["yarns"][0]["ply_twist_per_m"]
    expect(abs(twist - 957 * 4 / (1000 / 60) ** 0.5) < 1, f"4 TM became {twist} turns/m")
    type_into(editor, "yarn.diameter_mm", "0.3")
    yarn = editor.saved(file)["yarns"][0]
    packing = yarn["count_tex"] / (1.52 * (0.3 / 0.03568) ** 2)
    expect(abs(yarn["packing"] - packing) < 0.005, f"0.3 mm became packing {yarn['packing']}, not {packing:.3f}")
    type_into(editor, "yarn.count_tex", "167 dtex f48")
    fabric = editor.saved(file)
    radius_um = (1e3 * 16.7 / 48 / (3.14159265 * 1.52)) ** 0.5
    expect((fabric["yarns"][0]["count_tex"], fabric["yarns"][0]["plies"]) == (16.7, 1), f"f48 is {fabric['yarns'][0]}")
    expect(abs(fabric["fibres"][0]["radius_um"] - radius_um) < 0.01, f"48 filaments are {fabric['fibres'][0]}")
    editor.key("ctrl+z")


def blend(editor, file):
    choose(editor, "yarn.blend_fibre", "A new fibre")
    type_into(editor, "yarn.blend_share", "30")
    editor.click("tab.fibre")
    editor.click("fibre.of_blend/Second")
    choose(editor, "fibre.preset", "wool")
    fabric = editor.saved(file)
    yarn, fibres = fabric["yarns"][0], fabric["fibres"]
    expect(yarn["blend_fibre"] == 1 and abs(yarn["blend_share"] - 0.3) < 1e-9, f"no blend: {yarn}")
    expect(len(fibres) == 2 and fibres[1]["scale_tilt_deg"] == 2.5 and fibres[0]["scale_tilt_deg"] == 0,
           f"the second fibre is no wool: {fibres}")
    editor.wait_for_picture()
    expect(editor.fact("error") == "", editor.fact("error"))


def take_from_the_trade(editor, file):
    editor.click("tab.yarn")
    choose(editor, "yarn.preset", "Silk 20/22 den")
    fabric = editor.saved(file)
    yarn = fabric["yarns"][0]
    expect(abs(yarn["count_tex"] - 21 / 9) < 0.01 and "blend_fibre" not in yarn, f"no silk: {yarn}")
    expect(yarn["name"] == "ring-spun", "the yarn's name is the designer's")
    editor.key("ctrl+z")
    editor.wait_until("undo takes it back", lambda: editor.fact("dirty") == "yes")


def test():
    with window(WIDTH, HEIGHT) as editor:
        file = print_cloth(editor.home)
        editor.start(PROGRAM, [file])
        editor.wait_for_picture()
        read_the_cloth(editor)
        reckon_a_piece(editor)
        spin(editor, file)
        blend(editor, file)
        take_from_the_trade(editor, file)


run(test)
