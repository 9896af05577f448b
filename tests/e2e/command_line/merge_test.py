"""What is rendered in parts, by ranges of samples and windows of pixels, is put together to the bytes of one run."""

import os
import re
import signal

from harness import HANGS_S, CommandLineTest, main


class Merge(CommandLineTest):
    def setUp(self):
        super().setUp()
        drape = {"kind": "cylinder", "width_mm": 4, "height_mm": 4, "radius_mm": 3}
        self.scene = {"drape": drape, "light": {"kind": "sky"}}
        self.cloth = self.fabric(**self.scene)

    def render(self, output, *options, cloth=None, spp=7, **more):
        self.run_program("render", cloth or self.cloth, "-o", output, "--spp", spp, *options, **more)
        return self.bytes_of(output)

    def part(self, output, first, samples, *options, **more):
        self.render(output, "--samples-from", first, "--samples", samples, *options, **more)
        return output

    def refused(self, *parts):
        return self.run_program("merge", *parts, "-o", "refused.exr", status=1)

    def test_ranges_of_samples(self):
        parts = [self.part("a.exr", 3, 2), self.part("b.exr", 0, 3, "--threads", 1), self.part("c.exr", 5, 2)]
        self.run_program("merge", *parts, "-o", "merged.exr")
        self.assertEqual(self.bytes_of("merged.exr"), self.render("whole.exr"))
        self.run_program("merge", *parts, "-o", "sums.exr", "--keep-sums")
        self.assertEqual(self.bytes_of("sums.exr"), self.render("whole-sums.exr", "--keep-sums"))
        self.run_program("merge", *parts, "-o", "merged.png", "--exposure", 1)
        self.assertEqual(self.bytes_of("merged.png"), self.render("whole.png", "--exposure", 1))

    def test_windows_of_pixels(self):
        crops = ("0,0,32x5", "0,5,13x19", "13,5,19x19")
        parts = [f"{i}.exr" for i in range(3)]
        for part, crop in zip(parts, crops):
            self.render(part, "--crop", crop)
        self.run_program("merge", *parts, "-o", "merged.exr")
        self.assertEqual(self.bytes_of("merged.exr"), self.render("whole.exr"))

    def test_windows_and_ranges_by_stages(self):
        left, right = ("--crop", "0,0,16x24"), ("--crop", "16,0,16x24")
        self.part("a.exr", 0, 4, *left)
        self.part("b.exr", 4, 3, *left)
        self.part("c.exr", 0, 6, *right)
        self.part("d.exr", 6, 1, *right)
        said = self.run_program("merge", "a.exr", "d.exr", "-o", "some.exr", "--partial")
        self.assertIn("samples 4 to 6 of the pixels 0,0,16x24", said)
        self.assertIn("samples 0 to 5 of the pixels 16,0,16x24", said)
        self.run_program("merge", "c.exr", "some.exr", "b.exr", "-o", "merged.exr")
        self.assertEqual(self.bytes_of("merged.exr"), self.render("whole.exr"))

    def test_a_finished_picture_gets_more_samples(self):
        self.render("first.exr", "--keep-sums", spp=4)
        self.part("more.exr", 4, 3)
        self.run_program("merge", "first.exr", "more.exr", "-o", "merged.exr")
        self.assertEqual(self.bytes_of("merged.exr"), self.render("whole.exr"))

    def test_what_is_missing_is_told_and_nothing_is_written(self):
        self.part("a.exr", 0, 2)
        self.part("b.exr", 5, 2, "--crop", "0,0,32x10")
        message = self.refused("a.exr", "b.exr")
        self.assertIn("samples 2 to 4 of the pixels 0,0,32x10", message)
        self.assertIn("samples 2 to 6 of the pixels 0,10,32x14", message)
        self.assertFalse((self.folder / "refused.exr").exists())

    def test_samples_that_are_there_twice_are_refused(self):
        self.part("a.exr", 0, 4)
        self.part("b.exr", 3, 4)
        message = self.refused("a.exr", "b.exr")
        for said in ("a.exr", "b.exr", "samples 0 to 3", "samples 3 to 6"):
            self.assertIn(said, message)

    def test_parts_of_another_picture_are_refused(self):
        self.part("a.exr", 0, 4)
        yarns = self.fabric("other.json", ends_per_cm=21, **self.scene)
        for said, options, cloth in (
            ("seed", ("--seed", 2), None),
            ("max_depth", ("--max-depth", 5), None),
            ("width", ("--size", "33x24"), None),
            ("camera", ("--view", "top"), None),
            ("ends_per_cm", (), yarns),
        ):
            with self.subTest(said=said):
                self.render("b.exr", "--samples-from", 4, *options, cloth=cloth)
                message = self.refused("a.exr", "b.exr")
                for word in ("a.exr", "b.exr", said):
                    self.assertIn(word, message)

    def test_a_mesh_that_has_changed_is_another_picture(self):
        mesh = self.folder / "mesh.obj"
        corners = "v -2 -2 0\nv 2 -2 0\nv 2 2 {}\nv -2 2 0\n"
        square = corners + "vt 0 0\nvt 4 0\nvt 4 4\nvt 0 4\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n"
        mesh.write_text(square.format(0))
        self.part("a.exr", 0, 4, "--drape", mesh, "--view", "0,60,14")
        mesh.write_text(square.format(1))
        self.part("b.exr", 4, 3, "--drape", mesh, "--view", "0,60,14")
        self.assertIn("mesh", self.refused("a.exr", "b.exr"))

    def test_an_environment_that_has_changed_is_another_picture(self):
        light = ("--light", "ibl:surroundings.exr")
        self.render("surroundings.exr", "--size", "32x16", spp=1)
        self.part("a.exr", 0, 4, *light)
        self.render("surroundings.exr", "--size", "32x16", "--seed", 2, spp=1)
        self.part("b.exr", 4, 3, *light)
        self.assertIn("environment", self.refused("a.exr", "b.exr"))

    def test_a_spectrum_of_lamps_that_has_changed_is_another_picture(self):
        lamp, options = self.folder / "lamp.txt", ("--illuminant", "lamp.txt")
        lamp.write_text("380 1\n780 2\n")
        self.part("a.exr", 0, 4, *options)
        lamp.write_text("380 1\n780 3\n")
        self.part("b.exr", 4, 3, *options)
        self.assertIn("spectrum of the lamps", self.refused("a.exr", "b.exr"))

    def test_parts_by_another_build_of_the_program_are_refused(self):
        self.part("a.exr", 0, 4)
        self.part("b.exr", 4, 3)
        said = re.search(rb'"program":"([^"]+)"', self.bytes_of("b.exr"))[1]
        another = said[:-1] + (b"x" if said[-1:] != b"x" else b"y")
        (self.folder / "b.exr").write_bytes(self.bytes_of("b.exr").replace(said, another))
        message = self.refused("a.exr", "b.exr")
        for word in ("a.exr", "b.exr", "the same program", said.decode(), another.decode()):
            self.assertIn(word, message)

    def of_another_processor(self, part):
        """Has a part say that a processor of another kind made it; returns the two kinds."""
        kind = re.search(rb'"processor":"([0-9a-f]{16})"', self.bytes_of(part))[1]
        another = kind[::-1] if kind != kind[::-1] else b"0" * 16
        (self.folder / part).write_bytes(self.bytes_of(part).replace(kind, another))
        return kind.decode(), another.decode()

    def test_a_tree_of_fibres_is_of_one_kind_of_processor(self):
        options = ("--method", "fibres")
        self.part("a.exr", 0, 4, *options)
        self.part("b.exr", 4, 3, *options)
        self.run_program("merge", "a.exr", "b.exr", "-o", "merged.exr")
        self.assertEqual(self.bytes_of("merged.exr"), self.render("whole.exr", *options))
        kinds = self.of_another_processor("b.exr")
        message = self.refused("a.exr", "b.exr")
        for word in ("a.exr", "b.exr", "kind of processor", *kinds):
            self.assertIn(word, message)

    def test_tables_of_visibility_are_of_one_kind_of_processor(self):
        options, own = ("--estimator", "report"), {"env": {**os.environ, "XDG_CACHE_HOME": str(self.folder)}}
        self.part("a.exr", 0, 4, *options, **own)
        self.part("b.exr", 4, 3, *options, **own)
        self.run_program("merge", "a.exr", "b.exr", "-o", "merged.exr")
        self.of_another_processor("b.exr")
        self.assertIn("kind of processor", self.refused("a.exr", "b.exr"))
        self.run_program("render", "--resume", "a.exr", "-o", "longer.exr", "--samples", 5, **own)
        self.of_another_processor("a.exr")
        message = self.run_program("render", "--resume", "a.exr", "-o", "longer.exr", "--samples", 5, status=1, **own)
        self.assertIn("begun by another kind of processor", message)

    def test_volume_close_ups_and_bricks_are_of_any_processor(self):
        near = self.fabric("near.json", camera={"distance_mm": 0.7})
        for cloth, options in ((None, ()), (near, ()), (None, ("--method", "fibres", "--fibres-extent", "bricks"))):
            with self.subTest(options, cloth=cloth):
                self.part("a.exr", 0, 4, *options, cloth=cloth)
                self.assertIsNone(re.search(b'"processor"', self.bytes_of("a.exr")))
                self.part("b.exr", 4, 3, *options, cloth=cloth)
                self.run_program("merge", "a.exr", "b.exr", "-o", "merged.exr")
                self.assertEqual(self.bytes_of("merged.exr"), self.render("whole.exr", *options, cloth=cloth))

    def test_what_one_kind_of_processor_began_and_another_went_on_with_is_refused(self):
        self.part("a.exr", 0, 2, "--method", "fibres")
        self.run_program("render", "--resume", "a.exr", "-o", "same.exr", "--samples", 4)
        self.part("b.exr", 4, 3, "--method", "fibres")
        self.run_program("merge", "same.exr", "b.exr", "-o", "merged.exr")
        another, _ = self.of_another_processor("a.exr")
        message = self.run_program("render", "--resume", "a.exr", "-o", "both.exr", "--samples", 4, status=1)
        self.assertRegex(message, r"a\.exr: begun by another kind of processor, \w+, this one is " + another)
        self.assertFalse((self.folder / "both.exr").exists())

    def test_a_picture_that_one_kind_of_processor_began_may_be_gone_on_with_by_another(self):
        self.render("a.exr", "--method", "fibres", "--keep-sums", spp=4)
        self.of_another_processor("a.exr")
        message = self.run_program("render", "--resume", "a.exr", "-o", "both.exr", "--spp", 7, "--keep-sums",
                                   messages=True)
        self.assertIn("another kind of processor", message)
        self.assertIn("both.exr: expected samples of one kind of processor", self.refused("both.exr"))

    def test_other_fibres_are_another_picture(self):
        fibres = ("--method", "fibres", "--drape", "flat", "--fibres-extent")
        self.part("a.exr", 0, 4, *fibres, "piece")
        self.part("b.exr", 4, 3, *fibres, "bricks")
        self.assertIn("fibres", self.refused("a.exr", "b.exr"))

    def test_what_is_no_part_is_refused(self):
        self.render("slim.exr")
        self.assertIn("slim.exr", self.refused("slim.exr"))
        self.assertIn("absent.exr", self.refused("absent.exr"))
        self.assertIn("--partial", self.run_program("merge", "slim.exr", "-o", "a.png", "--partial", status=2))

    def test_a_stopped_part_is_refused_until_it_is_finished(self):
        words = ("render", self.cloth, "-o", "b.exr", "--size", "64x48", "--spp", 1000000, "--samples-from", 0)
        stopped = self.start_at_work("rendering", *words)
        stopped.send_signal(signal.SIGINT)
        self.assertEqual(stopped.wait(timeout=HANGS_S), 130)
        self.assertIn("not finished", self.refused("b.exr"))

    def test_a_part_is_gone_on_with(self):
        self.part("a.exr", 2, 2, "--crop", "3,4,20x10")
        message = self.run_program("render", "--resume", "a.exr", "-o", "b.exr", "--samples-from", 3, status=2)
        self.assertIn("--samples-from", message)
        self.run_program("render", "--resume", "a.exr", "-o", "b.exr", "--samples", 5)
        self.part("c.exr", 2, 5, "--crop", "3,4,20x10")
        self.assertEqual(self.bytes_of("b.exr"), self.bytes_of("c.exr"))

    def test_parts_beyond_the_picture(self):
        for option, words in (
            ("--crop", ("--crop", "30,0,8x8")),
            ("--crop", ("--crop", "-1,0,8x8")),
            ("--crop", ("--crop", "1,0,0x8")),
            ("--samples-from", ("--samples-from", 7)),
            ("--samples:", ("--samples-from", 3, "--samples", 5)),
        ):
            with self.subTest(words=words):
                message = self.run_program("render", self.cloth, "-o", "a.exr", "--spp", 7, *words, status=2)
                self.assertIn(option, message)


main()
