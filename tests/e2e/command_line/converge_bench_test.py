"""The quick form of `bench converge`: every way of sampling is measured, and converges. Times are not judged."""

import csv

from harness import CommandLineTest, main


class ConvergeBench(CommandLineTest):
    def rows(self, name):
        with open(self.folder / "out" / name, newline="") as file:
            return list(csv.DictReader(file))

    def test_page_and_tables(self):
        self.run_program("bench", "converge", "--quick", "-o", "out")
        self.assertTrue((self.folder / "out/converge.md").exists())
        lights = {"sun and sky", "white dome", "headlight"}
        self.assertEqual({row["light"] for row in self.rows("converge_summary.csv")}, lights)
        errors = {}
        for row in self.rows("converge.csv"):
            errors.setdefault((row["light"], row["sampling"]), {})[int(row["samples"])] = float(row["relMSE"])
        dome = errors["white dome", "all on"]
        self.assertLess(dome[4], dome[1])
        self.assertIn(("sun and sky", "lamps not looked for"), errors)
        self.assertNotIn(("headlight", "lamps not looked for"), errors)  # nothing else finds a point


main()
