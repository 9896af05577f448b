"""The quick form of `bench clear`: edits are looked at with and without shared light. Times are not judged."""

import csv

from harness import CommandLineTest, main


class ClearBench(CommandLineTest):
    def rows(self, name):
        with open(self.folder / "out" / name, newline="") as file:
            return list(csv.DictReader(file))

    def test_page_and_tables(self):
        self.run_program("bench", "clear", "--quick", "--only", "open,colour", "--seconds", "0.3", "-o", "out")
        self.assertTrue((self.folder / "out/clear.md").exists())
        rows = self.rows("clear.csv")
        self.assertEqual(
            [(row["edit"], row["light shared"]) for row in rows],
            [("open", "no"), ("open", "yes"), ("colour", "no"), ("colour", "yes")],
        )
        course = self.rows("clear_course.csv")
        for row in rows:
            flips = [float(point["FLIP"]) for point in course
                     if (point["edit"], point["light shared"]) == (row["edit"], row["light shared"])]
            self.assertGreater(len(flips), 0)
            self.assertTrue(all(0 <= flip <= 1 for flip in flips))
            # One is written with three digits, the other with four.
            self.assertLess(abs(float(row["its FLIP"]) - flips[0]), 0.00056)

    def test_first_picture_is_waited_for(self):
        self.run_program("bench", "clear", "--quick", "--only", "open", "--seconds", "0.001", "-o", "out")
        for row in self.rows("clear.csv"):
            self.assertGreater(float(row["first picture, s"]), 0.001)

    def test_noise_of_the_reference_is_told(self):
        """A sixteenth of the variance is a quarter of the noise, of which FLIP makes half at most: it grows with the
        power of .7 of a difference."""
        noise = {}
        for samples in 8, 128:
            self.run_program("bench", "clear", "--quick", "--only", "open", "--seconds", "0.001", "--share", "on",
                             "--reference", str(samples), "-o", "out")
            (row,) = self.rows("clear.csv")
            noise[samples] = float(row["FLIP of the reference"])
        self.assertGreater(noise[128], 0)
        self.assertLess(noise[128], 0.5 * noise[8])

    def targets(self):
        return {row["what"]: row for row in self.rows("clear_targets.csv")}

    def test_targets(self):
        """They are of the pictures that share their light, at the time that is theirs."""
        self.run_program("bench", "clear", "--quick", "--only", "flat,open,colour", "--seconds", "1.5", "-o", "out")
        shared = [row for row in self.rows("clear.csv") if row["light shared"] == "yes"]
        self.assertEqual(len(shared), 2)
        # Where no picture is there by then, nothing of it is seen.
        flips = [1 if row["FLIP after 1 s"] == "-" else float(row["FLIP after 1 s"]) for row in shared]
        targets = self.targets()
        for what, expected in (("mean", sum(flips) / 2), ("worst", max(flips))):
            row = targets[f"flat and cylinder after 1 s: FLIP, {what}"]
            # The mean of two that are rounded to three digits, rounded itself.
            self.assertAlmostEqual(float(row["ours"]), expected, delta=0.00101)
            if abs(expected - 0.05) > 0.00101:
                self.assertEqual(row["at least met"], "yes" if expected < 0.05 else "no")
        back = max(float(row["worst step back"]) for row in shared)
        self.assertEqual(targets["worst step back"]["ours"], f"{back:.2f} x")

    def test_what_was_not_looked_at_reaches_no_target(self):
        """Another drape, no drag, and a second later than anybody looked."""
        self.run_program("bench", "clear", "--quick", "--only", "flat,open", "--seconds", "0.3", "-o", "out")
        targets = self.targets()
        for what in ("flat and cylinder after 1 s: FLIP, mean", "folds and skirts after 3 s: FLIP, worst",
                     "in a drag: FLIP, worst"):
            self.assertEqual((targets[what]["ours"], targets[what]["at least met"]), ("-", "no"))

    def test_size(self):
        self.run_program("bench", "clear", "--quick", "--only", "open", "--seconds", "0.001", "--share", "on",
                         "--size", "48x64", "-o", "out")
        self.assertIn("Pictures of 48 x 64", (self.folder / "out/clear.md").read_text())
        self.assertGreater(len(self.rows("clear_course.csv")), 0)

    def test_size_that_has_no_room_for_windows(self):
        said = self.run_program("bench", "clear", "--quick", "--size", "640x47", status=2)
        self.assertIn("--size: expected 48x48 to 4096x4096, got 640x47", said)

    def test_unknown_name(self):
        said = self.run_program("bench", "clear", "--quick", "--only", "velvet", status=1)
        self.assertIn("velvet", said)


main()
