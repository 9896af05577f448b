"""A program that is killed (kill -9) at any moment while it writes leaves the old file or the new one, never a torn one,
of every kind that it writes.

  LOOMLIGHT_KILLS=1000 ...    as many as that in place of the few of an ordinary run
"""

import io
import json
import os
import random
import re
import subprocess
import time
import unittest
import zipfile

from harness import HANGS_S, LOOMLIGHT, SMALL, CommandLineTest, main

KILLS = int(os.environ.get("LOOMLIGHT_KILLS", "30"))
SEED = 1
OLD = b"the old file, of another length" * 1000


def without_date(content):
    """A PDF says when it was made."""
    return re.sub(rb"D:[0-9]{14}Z", b"", content)


def without_time(name, content):
    """A hand-over says it as well, and its archive in each part: of one that is whole, the parts."""
    if name.endswith(".u3m"):
        return re.sub(rb'"[0-9-]{10}T[0-9:]{8}Z"', b"", content)
    if not name.endswith(".u3ma") or not zipfile.is_zipfile(io.BytesIO(content)):
        return content
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        return [(part, without_time(part, archive.read(part))) for part in archive.namelist()]


class Killed(CommandLineTest):
    def writers(self):
        """The words before the name of the file that is written, and its ending; large enough to take some time."""
        wide = self.fabric("wide.json", weave=["#." * 150, ".#" * 150] * 150)
        for ending in ("json", "wif", "png", "pdf"):
            yield ("convert", wide), ending
        picture = ("render", self.fabric("small.json"), "--size", "32x24", "--spp", 1, "--threads", 1, "-o")
        for ending in ("png", "exr"):
            yield picture, ending

    def start(self, words, file):
        return subprocess.Popen([LOOMLIGHT, *map(str, words), file], cwd=self.folder, stdin=subprocess.DEVNULL,
                                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def whole_files(self, words, file):
        """What it writes when nobody kills it, and how long that takes."""
        began = time.monotonic()
        process = self.start(words, file)
        self.assertEqual(process.wait(timeout=HANGS_S), 0, words)
        return without_date(self.bytes_of(file)), time.monotonic() - began

    def test_a_file_is_the_old_one_or_the_new_one(self):
        chance = random.Random(SEED)
        writers = list(self.writers())
        left_old = 0
        for words, ending in writers:
            with self.subTest(words=words[0], ending=ending):
                file = "written." + ending
                new, longest_s = self.whole_files(words, file)
                again, took_s = self.whole_files(words, file)
                self.assertEqual(new, again, "two runs write two files")
                for i in range(-(-KILLS // len(writers))):
                    (self.folder / file).write_bytes(OLD)
                    process = self.start(words, file)
                    # The first as soon as it can be. Most of the time is for what comes before the writing: half of the
                    # others fall into the end.
                    if i > 0:
                        least = 0 if chance.random() < 0.5 else 0.7
                        time.sleep(chance.uniform(least, 1.1) * max(longest_s, took_s))
                    process.kill()
                    process.wait()
                    found = without_date(self.bytes_of(file))
                    self.assertIn(found, (OLD, new), f"torn: {len(found)} bytes")
                    left_old += found == OLD
                # What the killed ones left beside it does not hold up the next.
                self.assertEqual(self.whole_files(words, file)[0], new)
        # One may end before it is killed, where the machine is busy; at least half of those killed at once do not.
        self.assertGreaterEqual(2 * left_old, len(writers), "they had ended before they were killed")

    def test_a_file_that_is_written_over_and_over_is_whole(self):
        """As settings and copies of unsaved work are."""
        one, other = self.fabric("one.json", name="One"), self.fabric("other.json", name="Other")
        self.run_program("convert", one, "kept.json")
        chance = random.Random(SEED + 1)
        for i in range(max(10, KILLS // 10)):
            process = self.start(("convert", (one, other)[i % 2]), "kept.json")
            time.sleep(chance.uniform(0, 0.05))
            process.kill()
            process.wait()
            kept = json.loads(self.bytes_of("kept.json"))
            self.assertIn(kept["name"], ("One", "Other"))
            self.assertEqual(kept["weave"], SMALL["weave"])

    def test_files_that_belong_together_are_put_in_their_places_together(self):
        """All files of a tile are made in a folder of their own, and moved when the last is finished: each is the old one
        or the new one, and once one is new, each other is new too, or lies whole in that folder. Whether a kill comes
        while they are moved, so that some are old and some new, is a matter of luck: it is tried for a while and told,
        and asked of nobody."""
        words = ("tile", self.fabric("small.json"), "--size", 320, "--spp", 1, "--threads", 1, "-o")
        self.put_in_their_places_together(words, max(10, KILLS // 3))

    @unittest.skipUnless("LOOMLIGHT_KILLS" in os.environ, "takes seconds a kill")
    def test_so_are_those_of_a_hand_over(self):
        words = ("handover", self.fabric("small.json"), "--size", 24, "--measure", 2, "--spp", 1, "--free-twist", "-o")
        self.put_in_their_places_together(words, max(4, KILLS // 50))

    def put_in_their_places_together(self, words, least):
        """Kills it at least so often, and on for a while until once it is killed while files are moved."""
        def files(folder):
            return {name: without_time(name, file.read_bytes()) for file in folder.rglob("*") if file.is_file()
                    for name in [str(file.relative_to(folder))]}

        def left_whole():
            """What lies in the folders of the killed ones as it will be in its place."""
            for folder in (self.folder / "out").glob(".small_twill.unfinished-*"):
                yield from (name for name, content in files(folder).items() if content == new.get(name))

        def inode(name):
            return (self.folder / "out" / name).stat().st_ino

        def made():
            began = time.monotonic()
            self.assertEqual(self.start(words, "out").wait(timeout=HANGS_S), 0)
            return files(self.folder / "out"), time.monotonic() - began

        new, took_s = made()
        self.assertGreater(len(new), 2)
        chance, between = random.Random(SEED + 2), 0
        placed = new.keys()
        for i in range(10 * least):
            if i >= least and between > 0:
                break
            for name in placed:
                (self.folder / "out" / name).write_bytes(OLD)
            before = {name: inode(name) for name in new}
            process = self.start(words, "out")
            if i < least and chance.random() < 0.5:
                time.sleep(chance.uniform(0.3, 1.05) * took_s)
            else:  # the moment in which they are moved is too short to be met by chance
                while process.poll() is None and all(inode(name) == before[name] for name in new):
                    pass
            process.kill()
            process.wait()
            found = {name: content for name, content in files(self.folder / "out").items() if name in new}
            self.assertEqual(found.keys(), new.keys())
            placed = {name for name in new if found[name] != OLD}
            self.assertEqual([name for name in placed if found[name] != new[name]], [], "torn")
            if placed:
                self.assertGreaterEqual(placed.union(left_whole()), new.keys())
                between += placed != new.keys()
        print(f"{between} were killed while their files were moved")
        self.assertEqual(made()[0], new, "what the killed ones left is in the way, or is left")


main()
