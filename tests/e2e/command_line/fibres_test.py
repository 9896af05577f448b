"""`--method fibres`: the truth that the volume is measured against, and what it takes."""

import json
import re

from harness import CommandLineTest, main


class Fibres(CommandLineTest):
    def test_it_says_beforehand_what_it_will_take_and_afterwards_what_it_took(self):
        self.run_program("render", self.fabric(), "-o", "a.png", "--method", "fibres", "--stats", "stats.json")
        stats = json.loads(self.bytes_of("stats.json"))
        self.assertEqual(stats["method"], "fibres")
        taken = stats["bytes"]["geometry"] + stats["bytes"]["accelerator"]
        self.assertGreater(stats["bytes"]["geometry"], 20 * stats["counts"]["segments"], "points and indices")
        self.assertGreater(stats["bytes"]["accelerator"], stats["counts"]["segments"])
        self.assertGreater(stats["seconds"]["accelerate"], 0)
        message = self.run_program("render", self.fabric(), "-o", "a.png", "--method", "fibres", messages=True)
        said = re.search(r"([0-9.e+]+) fibre segments will take about ([0-9.]+) GB", message)
        self.assertAlmostEqual(float(said.group(1)) / stats["counts"]["segments"], 1, delta=0.05)
        self.assertGreater(1e9 * float(said.group(2)) + 5e6, taken)

    def test_a_limit_refuses_before_anything_is_made(self):
        message = self.run_program(
            "render", self.fabric(), "-o", "a.png", "--method", "fibres", "--memory-limit", 0.001, status=1
        )
        self.assertRegex(message, "fibre segments.*GiB.*expected at most")
        self.assertFalse((self.folder / "a.png").exists())

    def test_of_a_piece_beyond_the_limit_bricks_are_laid_and_that_is_said(self):
        words = ("render", self.fabric(drape={"kind": "flat", "width_mm": 24, "height_mm": 24}), "-o", "a.png")
        words += ("--method", "fibres", "--spp", 1, "--size", "16x16", "--memory-limit", 0.15)
        self.assertIn("brick by brick", self.run_program(*words, messages=True))
        self.assertIn("brick by brick", self.run_program(*words, "--drape", "cylinder", messages=True))
        self.assertIn("this piece has", self.run_program(*words, "--fibres-extent", "piece", status=1))

    def test_one_repeat_can_be_asked_of_flat_pieces_only(self):
        words = ("render", self.fabric(drape={"kind": "flat", "width_mm": 24, "height_mm": 24}), "-o", "a.png")
        words += ("--method", "fibres", "--spp", 1, "--size", "16x16", "--fibres-extent")
        self.assertIn("side by side", self.run_program(*words, "repeat", messages=True))
        self.assertIn("flat", self.run_program(*words, "repeat", "--drape", "cylinder", status=1))
        self.assertIn("--fibres-extent", self.run_program(*words, "half", status=2))

    def test_the_picture_is_the_same_for_any_number_of_threads(self):
        for threads in (1, 3):
            self.run_program(
                "render", self.fabric(), "-o", f"{threads}.exr", "--method", "fibres", "--threads", threads
            )
        self.assertEqual(self.bytes_of("1.exr"), self.bytes_of("3.exr"))


main()
