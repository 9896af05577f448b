"""`colour` says what a spectrophotometer and a light booth say of a cloth."""

import json
import math

from harness import CLOSED, CommandLineTest, main

GREY = [12] * 36

# Light is traced until the colour is known equally well, whatever the cloth: a thin one takes a tenth as long.
YARN = CLOSED["yarns"][0]
THIN_FIBRE = {"name": "fibre", "radius_um": 9}
THIN = {**CLOSED, "fibres": [THIN_FIBRE]}


def bell(centre_nm, width_nm, height):
    """A dye that absorbs around a wavelength."""
    return [round(height * math.exp(-(((380 + 10 * j - centre_nm) / width_nm) ** 2)), 4) for j in range(36)]


def without_progress(messages):
    """A machine that is slow today also hears how far the work has come."""
    return [line for line in messages.splitlines() if not line.startswith("tracing light")]


class Colour(CommandLineTest):
    def cloth(self, absorption, construction=THIN):
        fibre = {**construction["fibres"][0], "absorption_per_mm": absorption}
        return self.fabric(**{**construction, "fibres": [fibre]})

    def measured(self, absorption, *words):
        return json.loads(self.run_program("colour", self.cloth(absorption), "--json", *words))

    def test_white_is_white_under_every_lamp(self):
        lamps = "D65,D50,A,F2,F7,F11,LED-B1,LED-B5,2856 K"
        white = self.cloth([0, 0, 0], CLOSED)  # through a thin one half of the light would go
        said = json.loads(self.run_program("colour", white, "--json", "--illuminant", lamps))
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
        said = self.run_program("colour", self.cloth([24, 8, 2]), "--standard", "standard.json", status=3)
        self.assertEqual(without_progress(said), [], "it is no error")
        self.run_program("colour", self.cloth([24, 8, 2]), "--standard", "none.json", status=1)
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

    def swatch_file(self, name="book.csv", said="values in %"):
        rows = [f"nm ({said}),navy,brown"] + [f"{nm},{6 - nm / 200:.3f},{nm / 20:.3f}" for nm in range(400, 710, 10)]
        (self.folder / name).write_text("\n".join(rows))
        return name

    def test_two_yarns_are_set_beside_each_other(self):
        # Navy warp and brown weft: each alone is nearer to a cloth of its own dye than the piece is.
        fibres = [
            {"name": "navy", "radius_um": 9, "absorption_per_mm": [30, 20, 6]},
            {"name": "brown", "radius_um": 9, "absorption_per_mm": [4, 10, 30]},
            {"name": "hidden", "radius_um": 9},
        ]
        yarns = [{**YARN, "name": name, "fibre": fibre} for name, fibre in (("warp", 0), ("brown", 1), ("twin", 0))]
        self.fabric(**{**THIN, "fibres": fibres, "yarns": yarns, "weft_sequence": [1]}).rename(self.folder / "two.json")
        words = ("--json", "--tolerance", 100, "--illuminant", "D65")
        said = json.loads(
            self.run_program("colour", "two.json", "--part", "warp", "--standard-part", "brown", *words)
        )
        self.assertEqual((said["part"], said["standard"]["part"]), ("yarn 1 'warp'", "yarn 2 'brown'"))
        under = said["illuminants"][0]
        sample, standard = under["lab"], under["standard_lab"]
        self.assertLess(sample["b"], 0)
        self.assertGreater(standard["b"], 0)
        self.assertGreater(under["cmc_2_1"], 10)
        delta = under["delta"]
        self.assertAlmostEqual(delta["L"], sample["L"] - standard["L"], delta=1e-9)
        chroma = math.hypot(sample["a"], sample["b"]) - math.hypot(standard["a"], standard["b"])
        self.assertAlmostEqual(delta["C"], chroma, delta=1e-9)
        self.assertAlmostEqual(
            math.hypot(*delta.values()), math.hypot(*(sample[c] - standard[c] for c in "Lab")), delta=1e-9
        )
        for part, other in (("navy", "warp"), ("1", "yarn 1")):
            said = json.loads(self.run_program("colour", "two.json", "--part", part, *words))
            self.assertEqual(said["part"], "fibre 1 'navy'", "a fibre that two yarns are spun of is not one of them")
            self.assertNotIn("standard", said)
            said = json.loads(self.run_program("colour", "two.json", "--part", other, *words))
            self.assertEqual(said["part"], "yarn 1 'warp'")
        text = self.run_program("colour", "two.json", "--part", "warp", "--standard-part", "brown", status=3, messages=True)
        self.assertEqual(without_progress(text), [], "a FAIL is no error")
        said = self.run_program("colour", "two.json", "--part", "red", status=1)
        self.assertIn("yarn 1 'warp', yarn 2 'brown', yarn 3 'twin', 1 'navy', 2 'brown', 3 'hidden', or 'piece'", said)
        said = self.run_program("colour", "two.json", "--part", "hidden", status=1)
        self.assertIn("lies on the face, where it shows its colour, got fibre 3 'hidden'", said)
        said = self.run_program("colour", self.swatch_file(), "--part", "navy", status=1)
        self.assertIn("expected a fabric", said)

    def test_a_swatch_of_several_is_chosen_by_its_name(self):
        self.swatch_file()
        names = {}
        for choice in ("book.csv", "book.csv:navy", "book.csv:brown", "book.csv:2"):
            done = self.run_both("colour", choice, "--json")
            names[choice] = json.loads(done.stdout)["name"]
            self.assertEqual("the first of 2" in done.stderr, choice == "book.csv")
        self.assertEqual(list(names.values()), ["navy", "navy", "brown", "brown"])
        said = self.run_program("colour", "book.csv:red", status=1)
        self.assertIn("book.csv: expected one of its swatches, 'navy', 'brown'; got 'red'", said)
        self.swatch_file("a:navy.csv")
        said = json.loads(self.run_program("colour", "a:navy.csv:brown", "--json"))
        self.assertEqual(said["name"], "brown", "a colon in the name of a file parts nothing")
        self.assertIn("none.csv", self.run_program("colour", "none.csv:navy", status=1))
        said = self.run_program("convert", self.cloth([1, 2, 3]), "a.json", "--cloth-colour", "1=book.csv:red", status=1)
        self.assertIn("got 'red'", said)

    def test_it_says_whether_the_specular_is_in_a_measurement(self):
        sci, sce = self.swatch_file("sci.csv", "% SCI"), self.swatch_file("sce.csv", "% SCE")
        done = self.run_both("colour", sci + ":navy", "--standard", sce + ":navy")
        self.assertIn("navy (SCI, specular included), by the CIE observer", done.stdout)
        self.assertIn("against navy (SCE, specular excluded)", done.stdout)
        self.assertIn("were measured in different ways", done.stderr)
        self.assertNotIn("different ways", self.run_both("colour", sci, "--standard", sci).stderr)
        self.assertEqual(json.loads(self.run_program("colour", sce, "--json"))["specular"], "excluded")

    def test_what_it_cannot_use_is_said(self):
        said = self.run_program("colour", self.cloth([1, 2, 3]), "--illuminant", "D66", status=1)
        self.assertIn("D65", said)
        (self.folder / "lamp.txt").write_text("400 1\n500 x\n")
        said = self.run_program("colour", self.cloth([1, 2, 3]), "--illuminant", "lamp.txt", status=1)
        self.assertIn("lamp.txt", said)
        self.run_program("colour", self.cloth([1, 2, 3]), "--observer", "5", status=2)


main()
