"""Files that are none, or not what their name says, and disks that take nothing: every kind of file in and out ends with
status 1 and a message that names it, in no time and little memory; what was there before a failed write is still there.
"""

import json
import os
import resource
import struct
import subprocess
import zlib

from harness import HANGS_S, SMALL, CommandLineTest, main

MEMORY_LIMIT = 6 << 30  # bytes
FULL_AFTER = 64  # bytes that a file may have on the disk that stands in for a full one


def limit_memory():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY_LIMIT, MEMORY_LIMIT))


def fill_the_disk(after=FULL_AFTER):
    resource.setrlimit(resource.RLIMIT_FSIZE, (after, after))


def png_header(width, height):
    """As much of a PNG as says how large it is."""
    body = b"IHDR" + struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + struct.pack(">I", 13) + body + struct.pack(">I", zlib.crc32(body))


class HostileFiles(CommandLineTest):
    def refused(self, *words, **options):
        message = self.run_program(*words, status=1, **options)
        self.assertRegex(message, r"(?m)^loomlight: ")
        self.assertLess(len(message), 2000)
        return message

    def refused_in_little_memory(self, *words):
        """A sanitizer reserves terabytes of addresses: no limit there."""
        limited = {} if "LOOMLIGHT_SANITIZED" in os.environ else {"preexec_fn": limit_memory}
        return self.refused(*words, **limited)

    def readers(self):
        """Every kind of file that is read, and the words that read it."""
        fabric = self.fabric("ok.json")
        for kind in ("json", "wif", "png", "exr"):
            yield kind, lambda name: ("info", name)
        for kind in ("obj", "ply", "off"):
            yield kind, lambda name: ("render", fabric, "-o", "a.png", "--drape", name)
        yield "exr", lambda name: ("render", fabric, "-o", "a.png", "--light", f"ibl:{name}")
        for kind in ("png", "exr"):
            yield kind, lambda name: ("compare", name, name)
        yield "exr", lambda name: ("render", fabric, "-o", "a.exr", "--resume", name)

    def writers(self):
        """Every kind of file that is written, by its name's ending, and the words that write it."""
        fabric = self.fabric("ok.json")
        self.run_program("render", fabric, "-o", "part.exr", "--spp", "1", "--keep-sums")
        for kind in ("json", "loomlight", "png", "wif", "pdf", "tif", "bmp"):
            yield "." + kind, lambda name: ("convert", fabric, name)
        yield ".png", lambda name: ("convert", "--draft", fabric, name)
        for kind in ("png", "exr"):
            yield "." + kind, lambda name: ("render", fabric, "-o", name, "--size", "32x24", "--spp", "1")
            yield "." + kind, lambda name: ("merge", "part.exr", "-o", name)
        yield ".pdf", lambda name: ("sheet", fabric, "-o", name, "--spp", "1")
        yield ".pdf", lambda name: ("sheet", "--colourways", fabric, "-o", name, "--spp", "1")
        yield ".png", lambda name: ("thumbnail", fabric, "-o", name)
        yield ".png", lambda name: ("compare", "part.exr", "part.exr", "-o", name)
        yield ".exr", lambda name: ("brdf", fabric, "-o", name, "--cameras", "2x2", "--spp", "1")
        yield ".exr", lambda name: ("bvdf", fabric, "-o", name, "--rays", "1")

    def sets(self):
        """The words that write several files into a folder, but for the number behind them, and all that it has then."""
        fabric = self.fabric("ok.json")
        for number, (words, name) in enumerate((
            (("tile", "--size", "24", "--spp"), ""),
            (("brdf", "--cameras", "2x2", "--spp"), "/dome"),
            (("bvdf", "--rays"), "/tables.exr"),
            (("handover", "--size", "24", "--measure", "4", "--spp"), ""),
        )):
            folder = self.folder / f"set{number}"
            folder.mkdir()
            words = (words[0], fabric, "-o", folder.name + name, *words[1:])
            self.run_program(*words, "1")
            yield words, folder

    def files(self, folder):
        return {str(file.relative_to(folder)): file.read_bytes() for file in folder.rglob("*") if file.is_file()}

    def humble(self):
        """Before a program: from root nothing is protected, unless he gives up that right."""
        return ("setpriv", "--bounding-set=-dac_override,-dac_read_search") if os.geteuid() == 0 else ()

    def sound(self, kind):
        """The bytes of a file of that kind as it should be."""
        if kind in ("wif", "png"):
            self.run_program("convert", self.fabric("ok.json"), f"sound.{kind}")
            return self.bytes_of(f"sound.{kind}")
        if kind == "exr":
            self.run_program("render", self.fabric("ok.json"), "-o", "sound.exr", "--spp", "1")
            return self.bytes_of("sound.exr")
        square = "0 0 0 0 0\n1 0 0 1 0\n1 1 0 1 1\n0 1 0 0 1\n"
        return {
            "json": json.dumps(SMALL),
            "obj": "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\n",
            "ply": "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
            "property float texture_u\nproperty float texture_v\nelement face 1\n"
            "property list uchar int vertex_indices\nend_header\n" + square + "4 0 1 2 3\n",
            "off": "STOFF\n4 1 0\n" + square + "4 0 1 2 3\n",
        }[kind].encode()

    def test_what_is_no_regular_file_is_named_and_never_waited_for(self):
        for number, (kind, words) in enumerate(self.readers()):
            for what in ("missing", "folder", "pipe", "endless", "loop", "way"):
                name = f"{what}{number}.{kind}"
                file = self.folder / name
                if what == "folder":
                    file.mkdir()
                elif what == "pipe":
                    os.mkfifo(file)
                elif what == "endless":
                    os.symlink("/dev/zero", file)
                elif what == "loop":
                    os.symlink(name, file)
                elif what == "way":
                    name = f"ok.json/{name}"  # through a file
                with self.subTest(words=words(name)):
                    self.assertIn(name, self.refused_in_little_memory(*words(name)))

    def test_what_is_not_what_its_name_says(self):
        for number, (kind, words) in enumerate(self.readers()):
            for what, content in (
                ("empty", b""),
                ("binary", bytes(range(256)) * 64),
                ("zeros", bytes(100000)),
                ("utf16", "\ufeffnothing of this kind at all\n".encode("utf-16-le") * 40),
                ("marked", b"\xef\xbb\xbf" + b"no such thing\n" * 100),
            ):
                name = f"{what}{number}.{kind}"
                (self.folder / name).write_bytes(content)
                with self.subTest(words=words(name)):
                    self.assertIn(name, self.refused_in_little_memory(*words(name)))

    def test_files_too_large_to_be_meant(self):
        """A terabyte that takes no room on the disk, with a sound beginning."""
        for number, (kind, words) in enumerate(self.readers()):
            name = f"huge{number}.{kind}"
            (self.folder / name).write_bytes(self.sound(kind)[:64])
            try:
                os.truncate(self.folder / name, 1 << 40)
            except OSError:
                os.truncate(self.folder / name, 16 << 30)  # as much as this file system takes
            with self.subTest(words=words(name)):
                self.assertIn(name, self.refused_in_little_memory(*words(name)))

    def test_pictures_that_claim_to_be_huge(self):
        for width, height in ((1 << 31, 1), (65536, 65536), (0, 0), (16384, 16384)):
            (self.folder / "claims.png").write_bytes(png_header(width, height))
            with self.subTest(width=width, height=height):
                self.assertIn("claims.png", self.refused_in_little_memory("convert", "claims.png", "a.json"))

    def test_truncated_files_are_read_or_refused(self):
        """What ends early may still mean something where a format has no end; it never ends in anything but 0 or 1."""
        for number, (kind, words) in enumerate(self.readers()):
            whole = self.sound(kind)
            for eighths in (1, 4, 7):
                name = f"cut{number}_{eighths}.{kind}"
                (self.folder / name).write_bytes(whole[: len(whole) * eighths // 8])
                with self.subTest(words=words(name)):
                    if kind in ("json", "png", "exr", "ply"):
                        self.assertIn(name, self.refused_in_little_memory(*words(name)))
                    else:
                        self.run_either(*words(name))

    def run_either(self, *words):
        try:
            self.run_program(*words)
        except AssertionError:
            self.refused(*words)

    def test_a_full_disk_leaves_the_old_file(self):
        for number, (ending, words) in enumerate(self.writers()):
            name = f"old{number}{ending}"
            (self.folder / name).write_bytes(b"what was there")
            with self.subTest(words=words(name)):
                before = os.listdir(self.folder)
                message = self.refused(*words(name), preexec_fn=fill_the_disk)
                self.assertIn(name, message)
                self.assertIn("File too large", message)
                self.assertEqual(self.bytes_of(name), b"what was there")
                self.assertEqual(sorted(os.listdir(self.folder)), sorted(before), "something was left beside it")

    def test_a_disk_that_is_full_after_the_picture_takes_no_counts(self):
        words = ("render", self.fabric(name=""), "-o", "a.png", "--size", "1x1", "--spp", "1", "--stats")
        self.run_program(*words, "stats.json")
        picture, stats = self.bytes_of("a.png"), self.bytes_of("stats.json")
        self.assertLess(len(picture), len(stats))
        message = self.refused(*words, "stats.json", preexec_fn=lambda: fill_the_disk(len(picture)))
        self.assertIn("stats.json", message)
        self.assertIn("File too large", message)
        self.assertEqual(self.bytes_of("stats.json"), stats)
        self.assertEqual(self.bytes_of("a.png"), picture)

    def test_sets_that_cannot_be_written_are_the_old_ones(self):
        """None of their files changes: on a full disk, or where one of them is write-protected."""
        for words, folder in self.sets():
            before = self.files(folder)
            with self.subTest(words=words):
                half = max(map(len, before.values())) // 2
                for after in [half] if words[0] == "handover" else [FULL_AFTER, half]:  # which takes long
                    message = self.refused(*words, "2", preexec_fn=lambda: fill_the_disk(after))
                    self.assertIn("File too large", message)
                    self.assertEqual(self.files(folder), before, f"full after {after} bytes of a file")
                for name in before:
                    (folder / name).chmod(0o444)
                    self.assertIn(name, self.refused(*words, "2", before=self.humble()))
                    self.assertEqual(self.files(folder), before, name)
                    (folder / name).chmod(0o644)

    def test_frames_that_cannot_be_written_are_the_old_ones(self):
        """Each is a file by itself: the others are rendered."""
        words = ("render", self.fabric(), "-o", "#.png", "--turn", "camera:3", "--size", "32x24", "--spp", "1")
        for frame in "123":
            (self.folder / f"{frame}.png").write_bytes(b"mine")
        before = self.files(self.folder)
        message = self.refused(*words, preexec_fn=fill_the_disk)
        for frame in "123":
            self.assertIn(f"{frame}.png: cannot be written: File too large", message)
        self.assertEqual(self.files(self.folder), before)
        (self.folder / "2.png").chmod(0o444)
        self.assertIn("2.png: cannot be written", self.refused(*words, before=self.humble()))
        after = self.files(self.folder)
        self.assertEqual(after.keys(), before.keys(), "something was left beside them")
        self.assertEqual({name for name in before if after[name] == before[name]}, {"fabric.json", "2.png"})

    def test_places_that_take_no_files(self):
        for number, (ending, words) in enumerate(self.writers()):
            folder, pipe, loop = (f"{what}{number}{ending}" for what in ("folder", "pipe", "loop"))
            (self.folder / folder).mkdir()
            os.mkfifo(self.folder / pipe)
            os.symlink(loop, self.folder / loop)
            os.symlink("/dev/full", self.folder / f"full{number}{ending}")
            for name in (folder, pipe, loop, f"full{number}{ending}", f"/sys/loomlight{ending}",
                         f"no/folder/a{ending}", f"ok.json/a{ending}"):
                with self.subTest(words=words(name)):
                    message = self.refused(*words(name))
                    # A set of files is made in its folder before any of them has its name.
                    self.assertTrue(name in message or message.startswith("loomlight: /sys: "), message)
            self.assertTrue((self.folder / folder).is_dir())
            self.assertTrue((self.folder / pipe).is_fifo())
            self.assertTrue((self.folder / loop).is_symlink())

    def test_write_protected_files_are_not_replaced(self):
        for number, (ending, words) in enumerate(self.writers()):
            name = f"mine{number}{ending}"
            (self.folder / name).write_bytes(b"mine")
            (self.folder / name).chmod(0o444)
            with self.subTest(words=words(name)):
                self.assertIn(name, self.refused(*words(name), before=self.humble()))
                self.assertEqual(self.bytes_of(name), b"mine")

    def test_output_that_does_not_arrive_is_no_success(self):
        fabric = self.fabric()
        with open("/dev/full", "wb") as full:
            message = self.run_to(full, "info", fabric)
        self.assertIn("No space left on device", message)

    def run_to(self, out, *words):
        """As run_program, but to another place; returns stderr of a run that fails."""
        done = subprocess.run([os.environ["LOOMLIGHT"], *map(str, words)], cwd=self.folder, stdin=subprocess.DEVNULL,
                              stdout=out, stderr=subprocess.PIPE, text=True, timeout=HANGS_S)
        self.assertEqual(done.returncode, 1, done.stderr)
        return done.stderr


main()
