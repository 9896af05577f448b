"""Bad files: status 1 and a message with file, place and what was expected; never a crash, a hang or a full memory."""

import json
import os
import pathlib
import resource

from harness import SMALL, CommandLineTest, main


MEMORY_LIMIT = 6 << 30  # bytes; no file in these tests may need more than this, whatever it says


def limit_addresses():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY_LIMIT, MEMORY_LIMIT))


def limited():
    """Options of a process that ends when it wants more. A sanitizer reserves terabytes of addresses, and has a limit of
    its own for what is used of them."""
    if "LOOMLIGHT_SANITIZED" not in os.environ:
        return {"preexec_fn": limit_addresses}
    limit = f"hard_rss_limit_mb={MEMORY_LIMIT >> 20}"
    options = {name: ":".join(filter(None, (os.environ.get(name), limit))) for name in ("ASAN_OPTIONS", "TSAN_OPTIONS")}
    return {"env": {**os.environ, **options}}


def changed(path, value):
    """The small fabric with one value changed."""
    fabric = json.loads(json.dumps(SMALL))
    place = fabric
    for key in path[:-1]:
        place = place[key]
    place[path[-1]] = value
    return json.dumps(fabric)


class BadInput(CommandLineTest):
    def refused(self, *words):
        message = self.run_program(*words, status=1, **limited())
        self.assertTrue(message.startswith("loomlight: "), message)
        self.assertLess(len(message), 2000)
        return message

    def test_values_out_of_range_are_named_with_their_place(self):
        for path, value, place in (
            (("yarns", 1, "plies"), 9, "yarns[1].plies"),
            (("yarns", 0, "ply_twist_per_m"), -3, "yarns[0].ply_twist_per_m"),
            (("yarns", 0, "fibre"), 2, "yarns[0].fibre"),
            (("yarns", 0), "cotton", "yarns[0]"),
            (("yarns",), [], "yarns"),
            (("fibres", 0, "radius_um"), 1e300, "fibres[0].radius_um"),
            (("fibres", 1, "absorption_per_mm"), [1, 2], "fibres[1].absorption_per_mm"),
            (("ends_per_cm",), "twenty", "ends_per_cm"),
            (("warp_sequence",), [0, 7], "warp_sequence[1]"),
            (("warp_spacing",), [1, 20], "warp_spacing[1]"),
            (("weave",), ["#.", "#"], "weave"),
            (("weave",), [], "weave"),
            (("render", "width"), 10**9, "render.width"),
            (("render", "resolution"), 3, "render.resolution"),
            (("drape", "kind"), "tent", "drape.kind"),
            (("drape", "width_mm"), None, "drape.width_mm"),
            (("light",), {"kind": "sky", "elevation_deg": -10}, "light"),
            (("loomlight_version",), 999, "version"),
        ):
            with self.subTest(place=place, value=value):
                (self.folder / "bad.json").write_text(changed(path, value))
                message = self.refused("render", "bad.json", "-o", "a.png")
                self.assertIn("bad.json", message)
                self.assertIn(place, message)
                self.assertFalse((self.folder / "a.png").exists())

    def test_what_is_no_fabric_at_all(self):
        for name, content in (
            ("empty", b""),
            ("garbage", bytes(range(256)) * 40),
            ("half", json.dumps(SMALL).encode()[:200]),
            ("deep", b"[" * 1000000),
            ("list", b"[1, 2, 3]"),
            ("null", b"null"),
            ("zeros", b"\0" * 100000),
            ("number", b"1e999999999"),
            ("twice", b'{"loomlight_version": 1, "loomlight_version": 1}'),
            ("not-utf8", b'{"loomlight_version": 1, "name": "\xff\xfe"}'),
        ):
            with self.subTest(name=name):
                (self.folder / "bad.json").write_bytes(content)
                self.assertIn("bad.json", self.refused("info", "bad.json"))

    def test_files_that_are_none(self):
        (self.folder / "folder.json").mkdir()
        os.symlink("/dev/zero", self.folder / "endless.json")
        os.symlink("loop.json", self.folder / "loop.json")
        for name in ("missing.json", "folder.json", "endless.json", "loop.json", "cloth.txt"):
            with self.subTest(name=name):
                self.assertIn(name, self.refused("info", name))

    def test_drafts_of_other_programs_are_told_the_way_out(self):
        (self.folder / "towel.wpo").write_bytes(b"WP")
        self.assertIn("which WeavePoint can save", self.refused("info", "towel.wpo"))

    def test_pictures_that_are_none(self):
        self.run_program("render", self.fabric(), "-o", "good.exr")
        good = self.bytes_of("good.exr")
        for name, content in (("cut.exr", good[: len(good) // 2]), ("empty.exr", b""), ("text.exr", b"picture")):
            with self.subTest(name=name):
                (self.folder / name).write_bytes(content)
                self.assertIn(name, self.refused("render", name, "-o", "a.png"))
        (self.folder / "bad.png").write_bytes(b"\x89PNG\r\n\x1a\nrest")
        self.assertIn("bad.png", self.refused("convert", "bad.png", "a.json"))

    def test_meshes_and_environments(self):
        fabric = self.fabric()
        (self.folder / "bad.obj").write_text("v 0 0\nf 1 2 3\n")
        (self.folder / "bad.exr").write_text("no picture")
        for option, value in (
            ("--drape", "missing.obj"),
            ("--drape", "bad.obj"),
            ("--light", "ibl:missing.exr"),
            ("--light", "ibl:bad.exr"),
        ):
            with self.subTest(value=value):
                message = self.refused("render", fabric, "-o", "a.png", option, value)
                self.assertIn(value.split(":")[-1], message)

    def test_pictures_that_cannot_be_written(self):
        fabric = self.fabric()
        for output in ("a.gif", "a", "no/such/folder/a.png", "."):
            with self.subTest(output=output):
                self.assertIn(output, self.refused("render", fabric, "-o", output))

    def test_what_cannot_be_written_is_known_before_the_long_work(self):
        fabric = self.fabric()
        (self.folder / "taken.png").mkdir()
        (self.folder / "taken.json").mkdir()
        for output, stats in (("taken.png", "a.json"), ("a.png", "taken.json"), ("a.png", "no/folder/a.json")):
            with self.subTest(output=output, stats=stats):
                long = ("--spp", 1048576, "--size", "1024x1024")
                message = self.refused("render", fabric, "-o", output, "--stats", stats, *long)
                self.assertIn(output if output.startswith("taken") else stats, message)
                self.assertFalse((self.folder / "a.png").exists())

    def test_fabrics_that_ask_for_too_much(self):
        huge = {"width": 16384, "height": 16384, "samples_per_pixel": 1048576}
        self.fabric("huge.json", render=huge)
        self.refused("render", "huge.json", "-o", "a.png")
        self.assertFalse(list(pathlib.Path(self.folder).glob("a.png*")))


main()
