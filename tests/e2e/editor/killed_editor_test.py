"""An editor that is killed (kill -9) while it saves, keeps a copy of unsaved work, a view or a preset, or writes its
settings: the file is as it was or as it was saved, what was kept is whole or not there, the next editor starts, and
offers what was not saved.

  LOOMLIGHT_KILLS=1000 ...    as many as that in place of the few of an ordinary run
"""

import os
import random
import struct
import time
import zlib

from small_cloth import small_cloth
from window_driver import expect, read_json, run, window

PROGRAM = os.environ["LOOMLIGHT"]
KILLS = int(os.environ.get("LOOMLIGHT_KILLS", "6"))
WIDTH, HEIGHT = 960, 600
LONGEST_S = 0.5  # from an action to the kill


def answer_what_is_asked(editor, taken_up):
    """An editor that finds unsaved work offers it; it is taken up, or thrown away."""
    editor.wait_until("it is clear whether there was unsaved work",
                      lambda: editor.fact("message") != "" or editor.number("frame") > 3)
    if "Take it up again?" not in editor.fact("message"):
        return False
    editor.click("message.answer_2" if taken_up else "message.answer_1")
    editor.wait_until("it is answered", lambda: editor.fact("dialog") == "none")
    return taken_up


def expect_whole_png(file):
    with open(file, "rb") as png:
        data = png.read()
    expect(data[:8] == b"\x89PNG\r\n\x1a\n", f"{file} is no PNG")
    place, kind = 8, b""
    while kind != b"IEND":
        expect(place + 12 <= len(data), f"{file} is torn at {len(data)} bytes")
        length, kind = struct.unpack(">I4s", data[place:place + 8])
        end = place + 8 + length
        expect(data[end:end + 4] == struct.pack(">I", zlib.crc32(data[place + 4:end])), f"{file} is torn at {place}")
        place = end + 4


def names_in(folder):
    return os.listdir(folder) if os.path.isdir(folder) else []


def expect_whole_files(folder, begins, ends, check):
    """Of these names; writers that were killed may leave other ones."""
    found = [name for name in names_in(folder) if name.startswith(begins) and name.endswith(ends) and name[0] != "."]
    for name in found:
        check(os.path.join(folder, name))
    return len(found)


def test():
    chance = random.Random(1)
    with window(WIDTH, HEIGHT) as editor:
        file = small_cloth(editor.home, "Killed")
        state = os.path.join(editor.home, "state", "loomlight")
        data = os.path.join(editor.home, "data", "loomlight")
        offered = views = presets = 0
        for _ in range(KILLS):
            editor.start(PROGRAM, [file])
            offered += answer_what_is_asked(editor, chance.random() < 0.5)
            before = read_json(file)["weave"]
            editor.click("draft.cell_0_0")
            editor.wait_until("the cloth is edited", lambda: editor.fact("dirty") == "yes")
            action = chance.choice(("save", "keep", "settings", "view", "preset"))
            if action == "save":
                editor.input.key("ctrl", 1)
                editor.input.key("s", 1)
            elif action == "keep":
                editor.wait_until("a copy is kept", lambda: os.path.isdir(state) and os.listdir(state))
            elif action == "view":
                editor.wait_until("the edited cloth is shown", lambda: editor.number("shown_samples") > 0 and
                                  editor.fact("shown_generation") == editor.fact("generation"))
                there = names_in(os.path.join(data, "views"))
                editor.input.key("k", 1)
                editor.wait_until("its picture is being written",
                                  lambda: names_in(os.path.join(data, "views")) != there)
            elif action == "preset":
                editor.key("ctrl+b")
                editor.move(*editor.centre("presets.keep"))
                editor.input.button(1, 1)
                editor.input.button(1, 0)
            else:
                editor.key("n")
            time.sleep(chance.uniform(0, LONGEST_S))
            editor.process.kill()
            editor.process.wait()
            for key in ("s", "k", "ctrl"):
                editor.input.key(key, 0)
            after = read_json(file)["weave"]  # which reads: it is whole
            expect(after == before or action == "save", f"a file that was not saved is another after '{action}'")
            expect_whole_files(state, "autosave-", ".json", read_json)
            views = max(views, expect_whole_files(os.path.join(data, "views"), "", ".png", expect_whole_png))
            presets = max(presets, expect_whole_files(os.path.join(data, "presets"), "", ".json", read_json))
        editor.start(PROGRAM, [file])
        answer_what_is_asked(editor, False)
        editor.key("ctrl+q")
        if editor.process.poll() is None and editor.fact("message"):
            editor.click("message.answer_1")
        expect(editor.wait_for_end() == 0, editor.log())
        print(f"{KILLS} kills; unsaved work was taken up {offered} times; "
              f"{views} views and {presets} presets were kept")


run(test)
