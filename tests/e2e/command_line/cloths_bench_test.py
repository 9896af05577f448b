"""`bench cloths` and `info` say the same of the wardrobe, and the table keeps its word: within bounds, or why not."""

import csv
import json

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


if __name__ == "__main__":
    main()
