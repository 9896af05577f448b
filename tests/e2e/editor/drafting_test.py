"""A weaver at the draft: threading, tie-up, treadling and drawdown edited by mouse, each following the others."""

import os

from window_driver import Failure, expect, read_json, run, window, write_json

PROGRAM = os.environ["LOOMLIGHT"]
SAMPLES = os.path.join(os.environ["LOOMLIGHT_ROOT"], "samples")
WIDTH, HEIGHT = 1280, 720
TWILL = ["..##", ".##.", "##..", "#..#"]  # 2/2, the first pick last


def small_fabric(home):
    fabric = read_json(os.path.join(SAMPLES, "blue_cloth.json"))
    fabric["weave"] = TWILL
    fabric["drape"] = {"kind": "flat", "width_mm": 4, "height_mm": 4}
    fabric["light"] = {"kind": "dome"}
    fabric["camera"] = {"distance_mm": 16}
    fabric["render"] = {"resolution": 1}
    return write_json(home, "cloth.json", fabric)


def numbers(entry):
    """Of a line of a draft: one number, none as 0, or several."""
    return [n for n in (entry if isinstance(entry, list) else [entry]) if n]


def weave_of(fabric):
    """As drawn, the first pick last; a fabric with a draft has no weave beside it."""
    if "draft" not in fabric:
        return fabric["weave"]
    draft, rows = fabric["draft"], []
    for pick in draft.get("liftplan") or draft["treadling"]:
        lifted = set(numbers(pick))
        if not draft.get("liftplan"):
            lifted = {shaft for treadle in lifted for shaft in numbers(draft["tie_up"][treadle - 1])}
        rows.append("".join("#" if lifted & set(numbers(end)) else "." for end in draft["threading"]))
    return rows[::-1]


class Weaver:
    """Clicks cells of the draft by number, and reads what the editor saves."""

    def __init__(self, editor, file):
        self.editor, self.file = editor, file

    def saved(self):
        return self.editor.saved(self.file)

    def revision(self):
        return self.editor.number("revision")

    def crossing(self, pick, end):
        """Of the drawdown, from 0."""
        x0, y0, x1, y1 = self.editor.widgets()["draft.cell_0_0"]
        return (x0 + x1) / 2 + end * (x1 - x0), (y0 + y1) / 2 - pick * (y1 - y0)

    def select(self, first, last):
        """From crossing to crossing, pick and end each, with Ctrl held."""
        self.editor.act("keydown", "ctrl")
        self.editor.drag(self.crossing(*first), self.crossing(*last))
        self.editor.act("keyup", "ctrl")

    def number(self, table, line, number):
        """Of a line, from 0, in the threading, tie-up or treadling."""
        x0, y0, x1, y1 = self.editor.widgets()[f"draft.{table}_0_1"]
        x, y, w, h = (x0 + x1) / 2, (y0 + y1) / 2, x1 - x0, y1 - y0
        return (x + (number - 1) * w, y - line * h) if table == "treadling" else (x + line * w, y - (number - 1) * h)

    def edits(self, what, act):
        """Does it and waits for the fabric to follow."""
        revision = self.revision()
        act()
        self.editor.wait_until(what, lambda: self.revision() > revision)

    def shows(self, kind, shafts=None):
        self.editor.wait_until(f"the draft is shown as {kind} on {shafts or 'any'} shafts",
                               lambda: self.editor.fact("draft.kind") == kind
                               and shafts in (None, self.editor.fact("draft.shafts")))


def edit_parts(weaver):
    editor = weaver.editor
    weaver.shows("treadles", "4")
    weaver.edits("a click hangs an end on another shaft",
                 lambda: editor.click_at(*weaver.number("threading", 0, 3)))
    fabric = weaver.saved()
    expect(fabric["draft"]["threading"] == [3, 2, 3, 4], f"threading is {fabric['draft']['threading']}")
    expect([row[0] for row in weave_of(fabric)] == [row[2] for row in TWILL], "the first end does not weave as the third")
    weaver.edits("undo", lambda: editor.key("ctrl+z"))

    weaver.edits("a drag threads several ends",
                 lambda: editor.drag(weaver.number("threading", 0, 4), weaver.number("threading", 3, 1), steps=6))
    expect(weaver.saved()["draft"]["threading"] == [4, 3, 2, 1], "the drag did not thread the ends backwards")
    weaver.edits("undo", lambda: editor.key("ctrl+z"))

    weaver.edits("a click ties a shaft", lambda: editor.click_at(*weaver.number("tieup", 0, 3)))
    expect(weaver.saved()["draft"]["tie_up"][0] == [1, 3, 4], "the tie-up did not get its third shaft")
    weaver.edits("a right drag unties",
                 lambda: editor.drag(weaver.number("tieup", 0, 1), weaver.number("tieup", 0, 4), button=3, steps=6))
    fabric = weaver.saved()
    expect(fabric["draft"]["tie_up"][0] in ([], 0), f"the tie-up has {fabric['draft']['tie_up'][0]}")
    expect(weave_of(fabric)[3] == "....", "a treadle that is tied to nothing lifts something")
    weaver.edits("undo", lambda: editor.key("ctrl+z"))
    weaver.edits("undo", lambda: editor.key("ctrl+z"))

    weaver.edits("a click presses another treadle", lambda: editor.click_at(*weaver.number("treadling", 1, 4)))
    fabric = weaver.saved()
    expect(fabric["draft"]["treadling"] == [1, 4, 3, 4], f"treadling is {fabric['draft']['treadling']}")
    expect(weave_of(fabric)[2] == weave_of(fabric)[0], "the second pick does not weave as the fourth")


def paint_drawdown(weaver):
    editor = weaver.editor
    weaver.edits("a click turns a crossing over", lambda: editor.click_at(*weaver.crossing(0, 1)))
    fabric = weaver.saved()
    expect("draft" in fabric, "painting lost the draft")
    draft = fabric["draft"]
    expect(draft["threading"][0] == 1 and draft["threading"][2:] == [3, 4], f"shafts were renumbered: {draft}")
    weaver.shows("treadles")


def lift(weaver):
    editor = weaver.editor
    before = weave_of(weaver.saved())
    editor.click("draft.tab_loom")
    editor.click("loom.kind")
    weaver.edits("a liftplan replaces tie-up and treadling", lambda: editor.click("loom.kind/Liftplan"))
    fabric = weaver.saved()
    expect(weave_of(fabric) == before and len(fabric["draft"]["liftplan"]) == 4, f"no liftplan: {fabric.get('draft')}")
    weaver.edits("a click lifts a shaft", lambda: editor.click_at(*weaver.number("treadling", 0, 4)))
    expect(weave_of(weaver.saved()) != before, "the liftplan did not change the weave")
    editor.click("loom.kind")
    weaver.edits("treadles come back", lambda: editor.click("loom.kind/Treadles"))
    weaver.shows("treadles")


def outgrow_the_loom(weaver):
    """A loom of three shafts cannot weave a twill, and that is said; four can."""
    editor = weaver.editor
    editor.click("draft.tab_structures")
    weaver.edits("a structure replaces the weave", lambda: editor.click("structure/Plain"))
    weaver.shows("treadles", "2")
    editor.click("draft.tab_loom")
    editor.move(*editor.centre("loom.shafts"))
    for _ in range(5):
        editor.act("click", 5)
    editor.click("loom.most_shafts")
    editor.type("3")
    editor.key("Return")
    editor.click("draft.tab_structures")
    weaver.edits("another structure", lambda: editor.click("structure/Twill 2/2"))
    weaver.shows("jacquard")
    expect("more than 3 shafts" in editor.fact("draft.remark"), f"it is not said why: {editor.fact('draft.remark')}")
    weaver.edits("undo brings the draft back", lambda: editor.key("ctrl+z"))
    weaver.shows("treadles", "2")


def select_and_edit(weaver):
    editor = weaver.editor
    editor.click("draft.tab_structures")
    weaver.edits("a structure", lambda: editor.click("structure/Satin 8"))
    editor.wait_until("the whole repeat is shown", lambda: "draft.cell_0_0" in editor.widgets())
    before = weave_of(weaver.saved())
    editor.click("draft.select")
    editor.drag(weaver.crossing(1, 1), weaver.crossing(2, 3))
    editor.wait_until("a drag selects", lambda: editor.fact("draft.selection") == "1 1 2 3")
    expect(weave_of(weaver.saved()) == before, "selecting changed the weave")
    editor.key("ctrl+c")
    weaver.edits("Delete lays the weft on top", lambda: editor.key("Delete"))
    after = weave_of(weaver.saved())
    expect(after[6][1:4] == after[5][1:4] == "...", f"there is warp left: {after}")
    weaver.edits("what was copied is pasted", lambda: editor.key("ctrl+v"))
    expect(weave_of(weaver.saved()) == before, "the copy is another")
    weaver.edits("Ctrl+I inverts", lambda: editor.key("ctrl+i"))
    inverted = before[6][1:4].translate(str.maketrans("#.", ".#"))
    expect(weave_of(weaver.saved())[6][1:4] == inverted, "the selection was not inverted")
    weaver.edits("a structure fills the selection", lambda: editor.click("structure/Plain"))
    rows = weave_of(weaver.saved())
    expect(rows[6][1:4] == "#.#" and rows[5][1:4] == ".#.", f"no plain weave in the selection: {rows}")
    editor.key("Escape")
    editor.wait_until("Escape selects nothing", lambda: editor.fact("draft.selection") == "none")
    editor.key("ctrl+a")
    editor.wait_until("Ctrl+A selects all", lambda: editor.fact("draft.selection") == "0 0 8 8")
    weaver.edits("an arrow shifts", lambda: editor.key("Right"))
    expect(weave_of(weaver.saved()) == [row[-1] + row[:-1] for row in rows], "the weave did not go to the right")
    editor.click("menu.weave")
    weaver.edits("the menu mirrors", lambda: editor.click("menu.mirror_ends"))
    expect(weave_of(weaver.saved()) == [(row[-1] + row[:-1])[::-1] for row in rows], "the weave is not mirrored")
    the_right_button_asks(weaver)
    editor.key("Escape")
    editor.click("draft.select")


def the_right_button_asks(weaver):
    """While selecting: what to do with the selection, or with a crossing outside of it."""
    editor = weaver.editor
    before = weave_of(weaver.saved())
    editor.click_at(*weaver.crossing(2, 2), button=3)
    weaver.edits("the menu inverts the selection", lambda: editor.click("menu.invert"))
    rows = weave_of(weaver.saved())
    expect(rows == [row.translate(str.maketrans("#.", ".#")) for row in before], f"not all was inverted: {rows}")
    weaver.edits("undo", lambda: editor.key("ctrl+z"))
    editor.key("Escape")
    editor.wait_until("nothing is selected", lambda: editor.fact("draft.selection") == "none")
    editor.click_at(*weaver.crossing(3, 2), button=3)
    editor.wait_until("the crossing there is selected", lambda: editor.fact("draft.selection") == "3 2 1 1")
    weaver.edits("that one is inverted", lambda: editor.click("menu.invert"))
    rows = weave_of(weaver.saved())
    changed = [(p, e) for p in range(8) for e in range(8) if rows[7 - p][e] != before[7 - p][e]]
    expect(changed == [(3, 2)], f"inverted: {changed}")
    weaver.edits("undo", lambda: editor.key("ctrl+z"))


def strokes(weaver):
    """On a satin of 8: Shift keeps to a line, the right button lays the weft over."""
    editor = weaver.editor
    before = weave_of(weaver.saved())
    editor.act("keydown", "shift")
    weaver.edits("a stroke", lambda: editor.drag(weaver.crossing(0, 0), weaver.crossing(2, 6), steps=6))
    editor.act("keyup", "shift")
    rows = weave_of(weaver.saved())
    expect(rows[7][:7] == ("." if before[7][0] == "#" else "#") * 7, f"the stroke painted {rows[7]}")
    expect(rows[:7] == before[:7], "the stroke left its line")
    weaver.edits("a right drag", lambda: editor.drag(weaver.crossing(3, 0), weaver.crossing(3, 7), button=3, steps=6))
    expect(weave_of(weaver.saved())[4] == "." * 8, "there is still warp over")
    weaver.edits("undo", lambda: editor.key("ctrl+z"))
    weaver.edits("undo", lambda: editor.key("ctrl+z"))
    expect(weave_of(weaver.saved()) == before, "undo does not bring the satin back")


def arrange(weaver):
    """By keys and menus: shift each way, cut, fill, turn, mirror, and make a part the repeat."""
    editor = weaver.editor
    rows = weave_of(weaver.saved())
    editor.key("ctrl+a")
    for key, after in (("Left", lambda r: [row[1:] + row[0] for row in r]), ("Up", lambda r: r[1:] + r[:1]),
                       ("Down", lambda r: r[-1:] + r[:-1]), ("Right", lambda r: [row[-1] + row[:-1] for row in r])):
        weaver.edits(key, lambda: editor.key(key))
        rows = after(rows)
        expect(weave_of(weaver.saved()) == rows, f"{key} does not shift that way")
    weaver.edits("Ctrl+X cuts", lambda: editor.key("ctrl+x"))
    expect(weave_of(weaver.saved()) == ["." * 8] * 8, "there is warp left")
    weaver.edits("undo", lambda: editor.key("ctrl+z"))
    for item, after in (("mirror_picks", lambda r: r[::-1]),
                        ("turn", lambda r: ["".join(row[i] for row in r[::-1]) for i in range(8)])):
        editor.click("menu.weave")
        weaver.edits(item, lambda: editor.click("menu." + item))
        rows = after(rows)
        expect(weave_of(weaver.saved()) == rows, f"{item}: {weave_of(weaver.saved())}, not {rows}")
    editor.key("Escape")
    weaver.select((0, 0), (1, 3))
    editor.wait_until("Ctrl and drag select", lambda: editor.fact("draft.selection") == "0 0 2 4")
    editor.key("ctrl+c")
    editor.key("ctrl+a")
    weaver.edits("the copy is laid side by side", lambda: editor.key("ctrl+shift+v"))
    expect(weave_of(weaver.saved()) == [row[:4] * 2 for row in rows[6:]] * 4, "the copy does not fill the repeat")
    editor.key("Escape")
    weaver.select((0, 0), (1, 3))
    editor.click("menu.weave")
    weaver.edits("the selection becomes the repeat", lambda: editor.click("menu.crop"))
    expect(weave_of(weaver.saved()) == [row[:4] for row in rows[6:]], "the repeat is another part")
    weaver.edits("undo", lambda: editor.key("ctrl+z"))
    weaver.edits("undo", lambda: editor.key("ctrl+z"))
    expect(weave_of(weaver.saved()) == rows, "undo does not bring the repeat back")


def set_the_loom(weaver):
    """Shed, repeat, corner, side and zoom: the cloth stays, but for the repeat."""
    editor = weaver.editor
    before = weave_of(weaver.saved())
    editor.click("draft.tab_loom")
    weaver.edits("the shed sinks", lambda: editor.click("loom.shed/Sinking"))
    fabric = weaver.saved()
    expect(fabric["draft"]["rising_shed"] is False and weave_of_sinking(fabric) == before, "the cloth became another")
    weaver.edits("undo", lambda: editor.key("ctrl+z"))

    scroll_to(editor, "loom.shafts", "draft.picks")
    editor.click("draft.ends")
    editor.type("12")
    weaver.edits("a larger repeat", lambda: editor.key("Return"))
    expect(weave_of(weaver.saved()) == [row + row[:4] for row in before], "it does not go on as the old one")
    weaver.edits("undo", lambda: editor.key("ctrl+z"))

    editor.key("shift+f")
    at_left = editor.widgets()["draft.cell_0_0"]
    editor.click("draft.back")
    editor.wait_until("the back begins at the other side", lambda: editor.widgets()["draft.cell_0_0"][0] > at_left[2])
    editor.click("draft.back")
    editor.wait_until("the face is back", lambda: editor.widgets()["draft.cell_0_0"] == at_left)
    scroll_to(editor, "draft.ends", "draft.corner")
    editor.click("draft.corner")
    editor.click("draft.corner/Top right")
    editor.wait_until("the first thread is at the top right", lambda: editor.widgets()["draft.cell_0_0"][0] > at_left[2]
                      and editor.widgets()["draft.cell_0_0"][3] < at_left[1])
    expect(weave_of(weaver.saved()) == before, "the corner changed the cloth")
    editor.click("draft.corner")
    editor.click("draft.corner/Bottom left")
    editor.wait_until("the first thread is back", lambda: editor.widgets()["draft.cell_0_0"] == at_left)

    editor.move(*weaver.crossing(4, 4))
    editor.act("click", 4)
    editor.wait_until("the wheel zooms", lambda: editor.widgets()["draft.cell_0_0"] != at_left)
    zoomed = editor.widgets()["draft.cell_0_0"]
    weaver.edits("a crossing is turned over", lambda: editor.click_at(*weaver.crossing(4, 4)))
    editor.key("shift+f")
    editor.wait_until("Shift+F shows the whole repeat", lambda: editor.widgets()["draft.cell_0_0"] == at_left)
    weaver.edits("undo", lambda: editor.key("ctrl+z"))
    editor.wait_until("undo shows where it happened", lambda: editor.widgets()["draft.cell_0_0"] == zoomed)
    editor.key("shift+f")


def weave_of_sinking(fabric):
    """What is tied goes down: a crossing is warp over unless a shaft of the end is pulled."""
    return [row.translate(str.maketrans("#.", ".#")) for row in weave_of(fabric)]


def scroll_to(editor, over, wanted):
    """Turns the wheel over a row of a list until another row is there."""
    editor.move(*editor.centre(over))
    for _ in range(12):
        widgets = editor.widgets()
        if wanted in widgets and widgets[wanted][3] < HEIGHT - 60:
            return
        editor.act("click", 5)
    raise Failure(f"{wanted} does not come into sight over {over}")


def choose_structure(weaver):
    editor = weaver.editor
    editor.click("menu.weave")
    editor.click("menu.structures")
    editor.click("library/Satin")
    editor.wait_until("satin is chosen", lambda: editor.fact("structures.name") == "Satin 8, move 3")
    editor.click("structures.Ends")
    editor.type("6")
    editor.key("Return")
    editor.wait_until("it is said that there is no such satin", lambda: "no satin" in editor.fact("structures.problem"))
    editor.click("library/Twill")
    editor.click("structures.Over")
    editor.type("3")
    editor.key("Return")
    weaver.edits("a twill is applied", lambda: editor.click("structures.apply"))
    editor.click("library/Houndstooth")
    weaver.edits("houndstooth is applied", lambda: editor.click("structures.apply"))
    editor.click("structures.close")
    fabric = weaver.saved()
    expect(fabric["warp_sequence"] == fabric["weft_sequence"] == [0, 0, 0, 0, 1, 1, 1, 1], "no stripes of four and four")
    expect(weave_of(fabric) == ["#..#", "..##", ".##.", "##.."], f"no 2/2 twill under them: {weave_of(fabric)}")
    weaver.edits("undo", lambda: editor.key("ctrl+z"))
    expect(weave_of(weaver.saved())[0].count("#") == 3, "the twill 3/2 is gone")


def press_the_keys_of_the_list(weaver):
    """Those of the window that no other test presses."""
    editor = weaver.editor
    for opens, closes in (("F1", "Escape"), ("shift+slash", "Return")):
        editor.key(opens)
        editor.wait_until("the list of keys is shown", lambda: "keys.close" in editor.widgets())
        editor.key(closes)
        editor.wait_until("the list is gone", lambda: editor.fact("dialog") == "none")
    editor.key("Tab")
    editor.wait_until("Tab hides the panels", lambda: "draft.select" not in editor.widgets())
    editor.key("Tab")
    editor.wait_until("Tab brings them back", lambda: "draft.select" in editor.widgets())
    for key, elevation in (("2", 35), ("3", 12), ("1", 90)):
        editor.key(key)
        camera = weaver.saved()["camera"]
        expect(camera.get("elevation_deg", 90) == elevation, f"key {key} looks from {camera}")


def test():
    with window(WIDTH, HEIGHT) as editor:
        file = small_fabric(editor.home)
        editor.start(PROGRAM, [file])
        weaver = Weaver(editor, file)
        edit_parts(weaver)
        paint_drawdown(weaver)
        lift(weaver)
        select_and_edit(weaver)
        strokes(weaver)
        arrange(weaver)
        set_the_loom(weaver)
        choose_structure(weaver)
        outgrow_the_loom(weaver)
        press_the_keys_of_the_list(weaver)


run(test)
