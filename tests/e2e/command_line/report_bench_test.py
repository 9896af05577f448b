"""The quick forms of `bench table1` and `bench figures`: complete folders, and the orderings that must hold."""

import csv
import re

from harness import CommandLineTest, main


class ReportBench(CommandLineTest):
    def table(self, name):
        with open(self.folder / name, newline="") as file:
            return list(csv.DictReader(file))

    def expect_whole(self, page):
        """Every picture that the page shows is there."""
        text = (self.folder / page).read_text()
        shown = re.findall(r"!\[.*?\]\((.*?)\)", text)
        self.assertGreater(len(shown), 2)
        for name in shown:
            self.assertTrue((self.folder / page).with_name(name).exists(), name)

    def test_table_1(self):
        self.run_program("bench", "table1", "--quick", "-o", "out", timeout=280)
        self.expect_whole("out/table1.md")
        for cloth in ("blue", "colourful", "black_and_white", "green"):
            with self.subTest(cloth=cloth):
                costs = {row["method"]: row for row in self.table(f"out/{cloth}_costs.csv")}
                bytes_of = [float(costs[f"resolution {r}"]["MB"]) for r in (8, 4, 2, 1)]
                self.assertEqual(bytes_of, sorted(bytes_of, reverse=True))
                self.assertGreater(float(costs["fibres"]["MB"]), bytes_of[0])
                rms = {
                    row["method"]: float(row["RMS without noise, %"])
                    for row in self.table(f"out/{cloth}_errors.csv")
                    if row["light"] == "dome"
                }
                # Nearer than 4 against 2 noise has a say.
                self.assertLess(rms["resolution 8"], rms["resolution 2"])
                self.assertLess(rms["resolution 4"], rms["resolution 1"])
        self.assertEqual(len(self.table("out/table1_ratios.csv")), 1 + 4)
        # Ours beats the report's estimator, which beats none; over all cloths and lights, so that noise has little say.
        flip = {}
        for cloth in ("blue", "colourful", "black_and_white", "green"):
            for row in self.table(f"out/{cloth}_errors.csv"):
                flip[row["method"]] = flip.get(row["method"], 0) + float(row["mean FLIP"])
        self.assertLess(flip["resolution 8"], flip["resolution 8, report's estimator"])
        self.assertLess(flip["resolution 8, report's estimator"], flip["resolution 8, no estimator"])

    def test_figures(self):
        self.run_program("bench", "figures", "--quick", "-o", "out", timeout=280)
        self.expect_whole("out/figures.md")
        for row in self.table("out/fig1.csv"):
            self.assertGreater(float(row["fibre segments it stands for"]), 1e10)
            self.assertLess(float(row["MB of volume"]), 4000)
        # How far the mean colour is off where all depends on local visibility.
        off = {
            row["estimator"]: sum(abs(float(row[c + ", %"])) for c in ("red", "green", "blue"))
            for row in self.table("out/fig7.csv")
            if row["light"] == "headlight"
        }
        self.assertLess(off["report"], off["volume only"])
        self.assertLess(off["loomlight"], off["volume only"])
        self.assertEqual(
            [row["light"] for row in self.table("out/fig11-14.csv")],
            ["above", "45 degrees", "behind, 45 degrees", "dome"],
        )


main()
