"""Nothing of the designer's is lost by a key too many: questions about unsaved work, files that would be replaced, and
settings from one session to the next. In the real window."""

import os

from small_cloth import small_cloth
from window_driver import expect, read_json, run, window

PROGRAM = os.environ["LOOMLIGHT"]
WIDTH, HEIGHT = 800, 520


def small_fabric(home, name):
    render = {"width": 24, "height": 16, "samples_per_pixel": 1, "resolution": 1}
    return small_cloth(home, name, render=render)


def spoil(editor):
    editor.click("draft.cell_0_0")
    editor.wait_until("the cloth is edited", lambda: editor.fact("dirty") == "yes")


def asked(editor):
    editor.wait_until("the editor asks", lambda: "has changes that are not saved" in editor.fact("message"))


def enter_saves_before_anything_else(editor, file):
    spoil(editor)
    editor.key("ctrl+n")
    asked(editor)
    editor.key("Escape")
    editor.wait_until("the question is gone", lambda: editor.fact("dialog") == "none")
    expect((editor.fact("name"), editor.fact("dirty")) == ("One", "yes"), "escape did something")
    before = read_json(file)["weave"]
    editor.key("ctrl+n")
    asked(editor)
    editor.key("Return")
    editor.wait_until("a new cloth is there", lambda: editor.fact("name") != "One")
    expect(read_json(file)["weave"] != before, "work was thrown away by a key")


def saving_first_may_take_a_name(editor, other):
    """A new cloth has no file yet: it is asked for, and then the other one opens."""
    spoil(editor)
    editor.key("ctrl+o")
    editor.name_file(other)
    asked(editor)
    editor.key("Return")
    editor.wait_until("a file is asked for", lambda: "browser.name" in editor.widgets())
    file = os.path.join(editor.home, "begun.json")
    editor.name_file(file)
    editor.wait_until("the other one is open", lambda: editor.fact("name") == "Two")
    expect(os.path.exists(file), "what was there was not saved")


def a_name_that_is_taken(editor, taken):
    old = read_json(taken)
    editor.key("ctrl+shift+s")
    editor.name_file(taken)
    editor.key("Return")
    editor.key("Return")
    expect(read_json(taken) == old, "a key that was pressed again replaced a file")
    editor.click("browser.ok")
    editor.wait_until("it is replaced by its button", lambda: editor.fact("file") == taken)
    expect(read_json(taken)["name"] == "Two", "it was not replaced")


def snapshots_beside_each_other(editor):
    for name in ("Two.png", "Two 2.png"):
        editor.key("ctrl+p")
        editor.click("snapshot.start")
        editor.wait_until("the snapshot is there", lambda: editor.fact("snapshot.outcome").startswith("Saved"))
        expect(editor.fact("snapshot.outcome").endswith("/" + name), editor.fact("snapshot.outcome"))
        editor.click("snapshot.close")
        editor.wait_until("the dialog closes", lambda: editor.fact("dialog") == "none")


def settings_last(editor, file):
    editor.wait_until("the picture has samples", lambda: editor.number("shown_samples") > 0)
    editor.key("n")
    editor.wait_until("the picture is denoised", lambda: editor.fact("denoised") == "yes")
    editor.key("ctrl+q")
    expect(editor.wait_for_end() == 0, editor.log())
    expect(not os.listdir(os.path.join(editor.home, "state", "loomlight")), "a good end leaves nothing to be taken up")
    editor.start(PROGRAM, [file])
    editor.wait_until("it is denoised again", lambda: editor.fact("denoised") == "yes")


def mailed_draft(home):
    file = os.path.join(home, "draft.wif.txt")
    with open(file, "w", encoding="ascii") as text:
        text.write("[WIF]\nVersion=1.1\n[WEAVING]\nShafts=2\nTreadles=2\n[WARP]\nThreads=2\n[WEFT]\nThreads=2\n"
                   "[THREADING]\n1=1\n2=2\n[TIEUP]\n1=1\n2=2\n[TREADLING]\n1=1\n2=2\n[TEXT]\nTitle=By mail\n")
    return file


def a_killed_editor_leaves_its_work(editor):
    """Also where a later process has its number, as after a restart of the machine."""
    editor.wait_for_picture()
    state = os.path.join(editor.home, "state", "loomlight")
    spoil(editor)
    editor.wait_until("a copy is kept", lambda: any(name.endswith(".json") for name in os.listdir(state)))
    editor.process.kill()
    editor.process.wait()
    (copy,) = [name for name in os.listdir(state) if name.endswith(".json")]
    weave = read_json(os.path.join(state, copy))["weave"]
    os.rename(os.path.join(state, copy), os.path.join(state, f"autosave-{os.getpid()}.json"))
    editor.start(PROGRAM, [mailed_draft(editor.home)])  # which has a dialog of its own
    editor.click("wif.close")
    editor.wait_until("it is offered", lambda: "Take it up again?" in editor.fact("message"))
    editor.key("Return")
    editor.wait_until("it is taken up", lambda: editor.fact("dirty") == "yes" and editor.fact("name") == "Two")
    expect(editor.fact("file") == "", "it would be saved into a file that was not its own")
    again = os.path.join(editor.home, "again.json")
    editor.key("ctrl+s")
    editor.name_file(again)
    editor.wait_until("it is saved", lambda: editor.fact("dirty") == "no")
    expect(read_json(again)["weave"] == weave, "another cloth was taken up")


def a_text_is_read_as_what_it_is(editor):
    """WIF drafts come by mail as texts; what is none of ours is named."""
    draft = mailed_draft(editor.home)
    editor.key("ctrl+o")
    editor.name_file(draft)
    editor.wait_until("the draft is open", lambda: editor.fact("name") == "By mail")
    editor.click("wif.close")
    editor.wait_until("the dialog closes", lambda: editor.fact("dialog") == "none")
    for ending, said in (("abc", "a draft (.wif, .plm, .dtx, .twa)"), ("wpo", "as WIF in WeavePoint")):
        other = os.path.join(editor.home, f"draft.{ending}")
        os.rename(draft, other)
        draft = other
        editor.key("ctrl+o")
        editor.name_file(other)
        editor.wait_until("the editor says what it reads", lambda: said in editor.fact("message"))
        editor.key("Return")
        editor.wait_until("the message is gone", lambda: editor.fact("dialog") == "none")


def test():
    with window(WIDTH, HEIGHT, samples=1) as editor:  # the picture is not judged
        one, two = small_fabric(editor.home, "One"), small_fabric(editor.home, "Two")
        editor.start(PROGRAM, [one])
        editor.wait_for_picture()
        enter_saves_before_anything_else(editor, one)
        saving_first_may_take_a_name(editor, two)
        editor.wait_for_picture()
        a_name_that_is_taken(editor, one)
        snapshots_beside_each_other(editor)
        settings_last(editor, one)
        a_killed_editor_leaves_its_work(editor)
        a_text_is_read_as_what_it_is(editor)


run(test)
