"""Files dragged onto the window: a cloth, and something that is none. In the real window."""

import os

from drag_and_drop import drop_file
from small_cloth import small_cloth
from window_driver import Failure, expect, run, window

PROGRAM = os.environ["LOOMLIGHT"]
WIDTH, HEIGHT = 960, 600


def drop(editor, file):
    target = editor.input.window_called("Loomlight")
    if target is None:
        raise Failure("there is no window")
    drop_file(editor.environment["DISPLAY"], target, file, WIDTH // 2, HEIGHT // 2)


def test():
    with window(WIDTH, HEIGHT, samples=1) as editor:  # the picture is not judged
        editor.start(PROGRAM, [small_cloth(editor.home, "first")])
        editor.wait_for_picture()
        drop(editor, small_cloth(editor.home, "a cloth, dropped"))
        editor.wait_until("the dropped cloth is open", lambda: editor.fact("name") == "a cloth, dropped")
        expect(editor.fact("dirty") == "no", "what was dropped is a file")
        notes = os.path.join(editor.home, "notes.txt")
        with open(notes, "w", encoding="utf-8") as file:
            file.write("no cloth")
        drop(editor, notes)
        editor.wait_until("the editor says what is wrong", lambda: "notes.txt" in editor.fact("message"))
        editor.click("message.answer_0")
        editor.wait_until("the message is gone", lambda: editor.fact("dialog") == "none")
        expect(editor.fact("name") == "a cloth, dropped", "the cloth is another one")
        what_is_dropped_on_a_question_waits(editor)


def what_is_dropped_on_a_question_waits(editor):
    """An answer is for what it was asked about, never for the file that came meanwhile."""
    editor.click("draft.cell_0_0")
    editor.wait_until("a copy is kept", lambda: any(name.endswith(".json") for name in os.listdir(editor.state)))
    editor.process.kill()
    editor.process.wait()
    editor.start(PROGRAM, [os.path.join(editor.home, "first.json")])
    editor.wait_until("the work is offered", lambda: "Take it up again?" in editor.fact("message"))
    late = small_cloth(editor.home, "late")
    drop(editor, late)
    editor.click("message.answer_1")  # throw away
    editor.wait_until("the dropped cloth is open", lambda: editor.fact("name") == "late")
    expect(os.path.exists(late), "the designer's own file was thrown away")
    expect(not any(name.endswith(".json") for name in os.listdir(editor.state)), "the copy is still there")


run(test)
