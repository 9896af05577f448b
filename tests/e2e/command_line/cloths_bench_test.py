"""`bench cloths` and `info` say the same of the wardrobe, and the table keeps its word: within bounds, or why not."""

import csv
import json
import statistics

from harness import SAMPLES, CommandLineTest, main


class ClothsBench(CommandLineTest):
    def test_the_table(self):
        said = self.run_program("bench", "cloths", "-o", "out")
        page = (self.folder / "out/cloths.md").read_text()
        with open(self.folder / "out/cloths.csv", newline="") as file:
            header, *rows = csv.reader(file)
        files = {json.loads(file.read_text())["name"]: file for file in (SAMPLES / "cloths").iterdir()}
        self.assertEqual({row[0] for row in rows}, set(files))
        for row in rows:
            with self.subTest(cloth=row[0]):
                line = "| " + " | ".join(row) + " |"
                self.assertIn(line, page)
                self.assertIn(line, said)
                mass, thickness = (int(row[i].rstrip(" %")) for i in (3, 6))
                self.assertLessEqual(abs(mass), 5)
                self.assertEqual(abs(thickness) > 20, row[-1] != "", "a reason where there must be one")
        for name in ("Poplin", "Georgette"):  # `info` also makes voxels: two are enough
            row = next(row for row in rows if row[0] == name)
            info = json.loads(self.run_program("info", files[name], "--json"))
            self.assertAlmostEqual(info["areal_mass_g_m2"], float(row[2]), delta=0.1)
            self.assertAlmostEqual(info["thickness_mm"], float(row[5]), delta=0.01)
            self.assertAlmostEqual(info["cover_fraction"], float(row[7]), delta=0.006)
            self.assertAlmostEqual(info["area_covered"], float(row[8]), delta=0.006)
        self.assertNotIn("cover, trade", header, "it quotes none")
        off = [int(row[6].rstrip(" %")) for row in rows]
        median, thinner = statistics.median(off), sum(row[6].startswith("-") for row in rows)
        self.assertIn(f"In the median our cloths are {abs(median)} % {'thinner' if median < 0 else 'thicker'} than the "
                      f"trade's, and {thinner} of {len(rows)} are thinner.", page)
        self.assertIn("were chosen by hand for each cloth", page)


if __name__ == "__main__":
    main()
