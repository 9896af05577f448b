"""`colour` says what a spectrophotometer and a light booth say of a cloth."""

import json
import math

from dye_test import CLOSED
from harness import CommandLineTest, main

GREY = [12] * 36


def bell(centre_nm, width_nm, height):
    """A dye that absorbs around a wavelength."""
    return [round(height * math.exp(-(((380 + 10 * j - centre_nm) / width_nm) ** 2)), 4) for j in range(36)]


class Colour(CommandLineTest):
    def cloth(self, absorption):
        fabric = {**CLOSED, "fibres": [{"name": "fibre", "radius_um": 9, "absorption_per_mm": absorption}]}
        return self.fabric(**fabric)

    def measured(self, absorption, *words):
        return json.loads(self.run_program("colour", self.cloth(absorption), "--json", *words))

    def test_white_is_white_under_every_lamp(self):
        said = self.measured([0, 0, 0], "--illuminant", "D65,D50,A,F2,F7,F11,LED-B1,LED-B5,2856 K")
        self.assertEqual(len(said["illuminants"]), 9)
        for under in said["illuminants"]:
            self.assertLess(math.hypot(under["lab"]["a"], under["lab"]["b"]), 0.05, under)
        self.assertGreater(min(said["reflectance"]), 0.5)
        self.assertLess(max(said["reflectance"]) - min(said["reflectance"]), 1e-5)

    def test_three_equal_numbers_are_a_flat_spectrum(self):
        three, bands = self.measured([12, 12, 12]), self.measured({"bands": GREY})
        for one, other in zip(three["reflectance"], bands["reflectance"]):
            self.assertAlmostEqual(one, other, delta=1e-4)

    def test_a_cloth_passes_beside_itself_and_fails_beside_another(self):
        self.cloth([20, 8, 2]).rename(self.folder / "standard.json")
        same = json.loads(
            self.run_program("colour", "standard.json", "--standard", "standard.json", "--json", "--observer", "2")
        )
        for under in same["illuminants"]:
            self.assertEqual((under["ciede2000"], under["cmc_2_1"], under["metamerism_index"]), (0, 0, 0))
            self.assertTrue(under["passes"])
        said = self.run_program("colour", self.cloth([24, 8, 2]), "--standard", "standard.json", status=1)
        self.assertEqual(said, "", "it is no error")
        said = self.run_program("colour", self.cloth([24, 8, 2]), "--standard", "standard.json", "--tolerance", "50")
        self.assertIn("pass", said)

    def test_dyes_that_match_by_day_part_in_the_shop(self):
        # Two recipes of other dyes for nearly one brown: the index tells apart what the lamp does from what was off.
        one = {"dyes": [{"name": "brown", "amount_percent": 1, "absorption_per_mm": bell(420, 150, 30)}]}
        other = {
            "dyes": [
                {"name": "yellow", "amount_percent": 1, "absorption_per_mm": bell(440, 40, 30)},
                {"name": "red", "amount_percent": 1, "absorption_per_mm": bell(520, 30, 14)},
                {"name": "blue", "amount_percent": 1, "absorption_per_mm": bell(610, 30, 4)},
            ]
        }
        self.cloth(one).rename(self.folder / "standard.json")
        said = json.loads(
            self.run_program("colour", self.cloth(other), "--standard", "standard.json", "--json", "--tolerance", "100")
        )
        d65, f11, a = said["illuminants"]
        self.assertAlmostEqual(d65["metamerism_index"], 0, delta=1e-6)
        self.assertGreater(f11["metamerism_index"], 0.3)
        self.assertGreater(a["metamerism_index"], 0.3)

    def test_what_it_cannot_use_is_said(self):
        said = self.run_program("colour", self.cloth([1, 2, 3]), "--illuminant", "D66", status=1)
        self.assertIn("D65", said)
        (self.folder / "lamp.txt").write_text("400 1\n500 x\n")
        said = self.run_program("colour", self.cloth([1, 2, 3]), "--illuminant", "lamp.txt", status=1)
        self.assertIn("lamp.txt", said)
        self.run_program("colour", self.cloth([1, 2, 3]), "--observer", "5", status=2)


main()
