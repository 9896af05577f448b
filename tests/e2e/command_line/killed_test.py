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
import zipfile

from harness import HANGS_S, LOOMLIGHT, SMALL, CommandLineTest, main

KILLS = int(os.environ.get("LOOMLIGHT_KILLS", "30"))
SEED = 1


def without_date(content):
    """A PDF says when it was made, and so does a material; an archive says it of every file in it."""
    if content.startswith(b"PK"):
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            return {name: without_date(archive.read(name)) for name in archive.namelist()}
    return re.sub(rb"D:[0-9]{14}Z|[0-9-]{10}T[0-9:]{8}Z", b"", content)


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
        for words, ending in writers:
            with self.subTest(words=words[0], ending=ending):
                file = "written." + ending
                new, longest_s = self.whole_files(words, file)
                again, took_s = self.whole_files(words, file)
                self.assertEqual(new, again, "two runs write two files")
                old = b"the old file, of another length" * 1000
                for i in range(-(-KILLS // len(writers))):
                    (self.folder / file).write_bytes(old)
                    process = self.start(words, file)
                    if i > 0:  # Most of the time is for what comes before the writing: half of them fall into the end.
                        least = 0 if chance.random() < 0.5 else 0.7
                        time.sleep(chance.uniform(least, 1.1) * max(longest_s, took_s))
                    process.kill()
                    process.wait()
                    found = without_date(self.bytes_of(file))
                    self.assertIn(found, (old, new) if i > 0 else (old,), f"torn: {len(found)} bytes")
                # What the killed ones left beside it does not hold up the next.
                self.assertEqual(self.whole_files(words, file)[0], new)

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

    def test_a_hand_over_is_of_whole_files(self):
        """Those of before while it is made; in the instant in which they are put in their places each is of either."""

        def words(cloth):
            return ("handover", cloth, "--size", 16, "--spp", 1, "--measure", 1, "--free-twist", "--threads", 1, "-o")

        def files():
            folder = self.folder / "out"
            return {str(file.relative_to(folder)): without_date(file.read_bytes()) for file in folder.rglob("*")
                    if file.is_file() and not any(part.startswith(".") for part in file.relative_to(folder).parts)}

        olive = self.fabric("olive.json", fibres=[{"radius_um": 9, "absorption_per_mm": [9, 4, 30]}] * 2)
        found = []
        for cloth in (self.fabric("white.json"), olive):
            began = time.monotonic()
            self.assertEqual(self.start(words(cloth), "out").wait(timeout=HANGS_S), 0)
            took_s = time.monotonic() - began
            found.append(files())
        new, old = found
        self.assertEqual(new.keys(), old.keys())
        self.assertTrue(new != old)
        chance = random.Random(SEED + 2)
        for _ in range(max(4, KILLS // 10)):
            process = self.start(words("white.json"), "out")
            time.sleep(chance.uniform(0.3, 1.05) * took_s)
            process.kill()
            process.wait()
            for name, content in files().items():
                self.assertTrue(content in (old[name], new[name]), f"{name} is torn: {len(content)} bytes")
        self.assertEqual(self.start(words("white.json"), "out").wait(timeout=HANGS_S), 0)
        self.assertTrue(files() == new)
        self.assertEqual(list((self.folder / "out").glob(".*")), [], "nothing is left of the killed ones")


main()
