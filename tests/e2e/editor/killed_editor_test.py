"""An editor that is killed (kill -9) while it saves, keeps a copy of unsaved work, a view or a preset, or writes its
settings or a snapshot: the file is as it was or as it was saved, what was kept is whole or not there, the next editor
starts, and offers what was not saved.

  LOOMLIGHT_KILLS=1000 ...    as many as that in place of the few of an ordinary run
"""

import contextlib
import os
import random
import struct
import time
import zlib

from folder_watch import ANY_CHANGE, FolderWatch
from small_cloth import small_cloth
from window_driver import HANGS_S, expect, read_json, run, window

PROGRAM = os.environ["LOOMLIGHT"]
KILLS = int(os.environ.get("LOOMLIGHT_KILLS", "6"))
WIDTH, HEIGHT = 960, 600
ACTIONS = ("keep", "save", "settings", "view", "preset", "snapshot")
# With so many each action comes sixteen times: one in five waits for its end, all but 3 % of such series do so once.
ENOUGH_KILLS = 16 * len(ACTIONS)
LONGEST_S = {"keep": 0.05, "save": 0.05, "preset": 0.05}  # from an action to the kill
LONGEST_OF_OTHERS_S = 0.5
LONGEST_INTO_A_FILE_S = 0.002  # from the first change of a file to the kill
SIDE = 1024  # crossings: a file of 1 MB takes longer to write than a kill to come


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


def stamp_of(file):
    """Another one when the file was replaced or written, be it with the same content."""
    expect(os.path.exists(file), f"{file} is gone")
    status = os.stat(file)
    return status.st_ino, status.st_mtime_ns


def names_in(folder):
    return os.listdir(folder) if os.path.isdir(folder) else []


def read_and_remove(file):
    """Hundreds of them would otherwise be read again after each kill."""
    read_json(file)
    os.remove(file)


def expect_whole_files(folder, begins, ends, check):
    """Of these names; writers that were killed may leave other ones."""
    found = [name for name in names_in(folder) if name.startswith(begins) and name.endswith(ends) and name[0] != "."]
    for name in found:
        check(os.path.join(folder, name))
    return len(found)


def weave_of(file):
    return read_json(file)["weave"]


def is_edited(weave, before):
    """In one crossing."""
    changed = [pair for pair in zip(weave, before) if pair[0] != pair[1]]
    return len(weave) == len(before) and len(changed) == 1 and sum(a != b for a, b in zip(*changed[0])) == 1


def copies_in(state):
    """Names and weaves of the copies of unsaved work, from the oldest to the newest; the editor may remove some."""
    found = []
    for name in names_in(state):
        if name.startswith("autosave-") and name.endswith(".json"):
            copy = os.path.join(state, name)
            with contextlib.suppress(FileNotFoundError):
                found.append((os.stat(copy).st_mtime_ns, name, weave_of(copy)))
    return [(name, weave) for _, name, weave in sorted(found)]


def start(editor, file, left, takes_up):
    """Starts the editor, which has to offer the newest of the copies that are left, and answers it. Returns whether one
    was taken up."""
    editor.start(PROGRAM, [file])
    if not left:
        editor.wait_until("it has looked for unsaved work", lambda: editor.number("frame") > 3)
        expect("Take it up again?" not in editor.fact("message"), "work is offered that nobody has left")
        return False
    editor.wait_until("unsaved work is offered", lambda: "Take it up again?" in editor.fact("message"))
    editor.click("message.answer_2" if takes_up else "message.answer_1")
    editor.wait_until("it is answered", lambda: editor.fact("dialog") == "none")
    if takes_up:
        editor.wait_until("it is taken up", lambda: editor.fact("dirty") == "yes" and editor.fact("file") == "")
    else:
        editor.wait_until("it is thrown away", lambda: left[-1][0] not in names_in(editor.state))
    return takes_up


def save_as(editor, file, weave):
    editor.key("ctrl+s")
    editor.name_file(file)
    editor.wait_until("it is saved", lambda: editor.fact("dirty") == "no")
    expect(weave_of(file) == weave, "other work was taken up than was left")


def click_at_once(editor, widget):
    """Returns before a frame is drawn with it."""
    editor.move(*editor.centre(widget))
    editor.input.button(1, 1)
    editor.input.button(1, 0)


def begin(editor, action, left, before, chance, has_file):
    """Does what the kill is to come into, and returns when it is to come: at any moment, as soon as a file changes, or,
    now and then, when all is done, however long that takes."""
    views, presets = (os.path.join(editor.data, name) for name in ("views", "presets"))
    folder = {"keep": editor.state, "save": has_file and editor.cloths, "preset": presets}.get(action)
    moment = chance.choices(("any", "file", "done"), (2, 2, 1))[0]
    longest_s, done = LONGEST_S.get(action, LONGEST_OF_OTHERS_S), None
    if action == "preset":
        editor.key("ctrl+b")
    with contextlib.closing(FolderWatch(folder, ANY_CHANGE)) if folder else contextlib.nullcontext() as watch:
        if action == "save":
            editor.input.key("ctrl", 1)
            editor.input.key("s", 1)
            done = has_file and (lambda: editor.fact("dirty") == "no")
        elif action == "keep":
            known = dict(left)
            click_at_once(editor, "draft.canvas")
            done = lambda: any(name not in known and is_edited(weave, before)
                               for name, weave in copies_in(editor.state))
        elif action == "view":
            editor.wait_until("the edited cloth is shown", lambda: editor.number("shown_samples") > 0 and
                              editor.fact("shown_generation") == editor.fact("generation"))
            there = names_in(views)
            editor.input.key("k", 1)
            editor.wait_until("its picture is being written", lambda: names_in(views) != there)
        elif action == "preset":
            there = names_in(presets)
            click_at_once(editor, "presets.keep")
            done = lambda: any(name not in there and name.endswith(".json") for name in names_in(presets))
        elif action == "snapshot":
            editor.key("ctrl+p")
            editor.click("snapshot.file")
            editor.key("ctrl+a")
            editor.type(editor.picture)
            editor.key("Return")
            there = stamp_of(editor.picture)
            click_at_once(editor, "snapshot.start")
            done = lambda: stamp_of(editor.picture) != there
        else:
            editor.key("n")
        if watch and moment == "file":
            watch.wait(HANGS_S)
            longest_s = LONGEST_INTO_A_FILE_S
    if done and moment == "done":
        editor.wait_until("it is done", done)
    time.sleep(chance.uniform(0, longest_s))


def kill(editor):
    editor.process.kill()
    editor.process.wait()
    for key in ("s", "k", "ctrl"):
        editor.input.key(key, 0)


def expect_copies(action, left, before, worked_on, taken_up, has_file):
    """After the kill: those that were there before are as they were, and new ones hold what was worked on, edited,
    or as it was taken up. Of work that has no file there is one."""
    def is_of_it(weave):
        return is_edited(weave, worked_on) or (taken_up and weave == worked_on)

    known = dict(before)
    for name, weave in left:
        expect(weave == known[name] if name in known else is_of_it(weave), f"a copy holds other work after '{action}'")
    expect(has_file or (left and is_of_it(left[-1][1])), f"work is lost after '{action}'")


def test():
    chance = random.Random(1)
    with window(WIDTH, HEIGHT, samples=1) as editor:  # the picture is not judged
        # Of which a snapshot is soon rendered.
        editor.cloths = os.path.join(editor.home, "cloths")
        os.mkdir(editor.cloths)
        file = small_cloth(editor.cloths, "Killed", weave=["#." * (SIDE // 2), ".#" * (SIDE // 2)] * (SIDE // 2),
                           render={"resolution": 1, "width": 64, "height": 48, "samples_per_pixel": 1},
                           description="a long story " * 5_000)
        os.makedirs(os.path.join(editor.data, "presets"))
        editor.picture = os.path.join(editor.home, "snapshot.png")
        with open(editor.picture, "w", encoding="utf-8") as old:  # which is replaced by the button, not by Return
            old.write("what was there")
        offered = saved = views = presets = snapshots = 0
        left, kept = [], False
        for i in range(KILLS):
            offered += bool(left)
            taken_up = start(editor, file, left, kept or chance.random() < 0.5)
            weave = left[-1][1] if taken_up else weave_of(file)
            has_file = not taken_up
            if taken_up and (kept or chance.random() < 0.5):
                file = os.path.join(editor.cloths, f"taken_up_{i}.json")
                save_as(editor, file, weave)
                has_file = True
            in_file = weave_of(file)
            action = ACTIONS[i % len(ACTIONS)]
            if action != "keep":
                editor.click("draft.canvas")
                editor.wait_until("the cloth is edited", lambda: editor.fact("dirty") == "yes")
            picture = stamp_of(editor.picture)
            begin(editor, action, left, weave, chance, has_file)
            kill(editor)
            kept = action == "keep"
            expect(os.path.exists(file), f"the file is gone after '{action}'")
            after = weave_of(file)  # which reads: it is whole
            may_be_saved = action == "save" and has_file
            expect(after == in_file or (may_be_saved and is_edited(after, weave)),
                   f"the file holds another cloth after '{action}'")
            saved += after != in_file
            if stamp_of(editor.picture) != picture:
                expect(action == "snapshot", f"a snapshot is another one after '{action}'")
                expect_whole_png(editor.picture)
                snapshots += 1
            before, left = left, copies_in(editor.state)
            expect_copies(action, left, before, weave, taken_up, has_file)
            views = max(views, expect_whole_files(os.path.join(editor.data, "views"), "", ".png", expect_whole_png))
            presets += expect_whole_files(os.path.join(editor.data, "presets"), "", ".json", read_and_remove)
        offered += bool(left)
        if start(editor, file, left, True):
            save_as(editor, os.path.join(editor.home, "taken_up_last.json"), left[-1][1])
        editor.key("ctrl+q")
        expect(editor.wait_for_end() == 0, editor.log())
        print(f"{KILLS} kills; unsaved work was offered {offered} times, and saved {saved} times before the kill; "
              f"{views} views and {presets} presets were kept, and {snapshots} snapshots written")
        if KILLS >= ENOUGH_KILLS:
            for what, times in (("offered", offered), ("saved", saved), ("kept as a view", views),
                                ("kept as a preset", presets), ("a snapshot", snapshots)):
                expect(times > 0, f"in {KILLS} kills nothing was {what}")


run(test)
