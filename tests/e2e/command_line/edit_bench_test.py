"""The quick form of `bench edit`: every kind of edit voxelises what it must and no more. Times are not judged."""

import csv
import json

from harness import CommandLineTest, main

NOTHING = ("colour sequence", "absorption", "refractive index", "light", "camera", "drape")


class EditBench(CommandLineTest):
    def test_counts(self):
        out = self.run_program("bench", "edit", "--quick", "--json", "-o", "out")
        cloths = json.loads(out)
        self.assertEqual([cloth["cloth"] for cloth in cloths], ["twill_8", "dobby_64", "jacquard_160"])
        for cloth in cloths:
            edits = {edit["edit"]: edit for edit in cloth["edits"]}
            self.assertLessEqual(edits["paint one crossing"]["made"]["bricks"], 64)
            for name in NOTHING:
                self.assertEqual(edits[name]["made"]["bricks"], 0, name)
            # A plied yarn is as high as a single of its count: the yarns that it crosses may keep their fibres.
            self.assertGreater(edits["ply"]["made"]["bricks"], 0)
            for name in ("tex", "sett"):
                self.assertEqual(edits[name]["made"]["bricks"], edits[name]["full_build"]["bricks"], name)
            for name, edit in edits.items():
                with self.subTest(cloth=cloth["cloth"], edit=name):
                    self.assertLessEqual(edit["made"]["bricks"], edit["full_build"]["bricks"])
                    self.assertEqual(edit["undone"]["bricks"], 0)
                    self.assertEqual(edit["redone"]["bricks"], 0)
                    for way in ("made", "undone", "redone"):
                        volume = edit[way]["volume_seconds"]["median"]
                        picture = edit[way]["first_picture_seconds"]["median"]
                        self.assertGreater(volume, 0)
                        self.assertGreater(picture, 0)
                    self.assertGreater(edit["full_build"]["seconds"], 0)
                    self.assertGreater(edit["alone_seconds"], 0)
            self.assertEqual(cloth["stroke"]["crossings"], 20)
        self.assertTrue((self.folder / "out/edit.md").exists())
        with open(self.folder / "out/edit_targets.csv", newline="") as file:
            self.assertEqual(len(list(csv.DictReader(file))), 6)


main()
