"""`convert --cloth-colour` dyes fibres for the colour that the cloth is to have."""

import json
import math
import re

from harness import CLOSED, CommandLineTest, main, read_png

WALKS = 8192  # at the least
# What other walks than those of the dye may say: three standard errors of 0.3 each, of both together.
NEAR = r"off by (0\.[0-9]|1\.[0-2]) \(CIEDE2000"


def linear(channel):
    """Of light, for a channel of sRGB in 0..255."""
    value = channel / 255
    return value / 12.92 if value <= 0.04045 else ((value + 0.055) / 1.055) ** 2.4


def channels(text):
    return [int(text[i : i + 2], 16) for i in (1, 3, 5)]


class Dye(CommandLineTest):
    def seen_from_above(self, fabric):
        """What the cloth sends back of a white sky: the mean of a picture, linear, of more paths than the dye had walks."""
        self.run_program("render", fabric, "-o", "a.png", "--light", "dome", "--spp", 16, "--exposure", -1)
        width, height, rows = read_png(self.folder / "a.png")
        return [2 * sum(linear(pixel[c]) for row in rows for pixel in row) / (width * height) for c in range(3)]

    def dyes(self, name):
        return [fibre["absorption_per_mm"] for fibre in json.loads(self.bytes_of(name))["fibres"]]

    def test_the_cloth_has_the_colour_that_was_wanted(self):
        wanted = "#b4643c"
        said = self.run_program("convert", self.fabric(**CLOSED), "dyed.json", "--cloth-colour", "a=b=" + wanted)
        self.assertRegex(said, f"a=b: {wanted} is wanted, the cloth shows #[0-9a-f]{{6}}, {NEAR}")
        for channel, seen in zip(channels(wanted), self.seen_from_above("dyed.json")):
            expected = linear(channel)
            deviation = math.sqrt(expected * (1 - expected) / WALKS)  # at most: a walk's light is from 0 to 1
            self.assertLess(abs(seen - expected), 4 * deviation)

    def test_fibres_are_dyed_together(self):
        wishes = ("--cloth-colour", "blue=#406080", "--cloth-colour", "2=#807050")
        said = self.run_program("convert", self.fabric(), "dyed.json", *wishes)
        self.assertEqual(len(re.findall(NEAR, said)), 2, said)
        dyes = self.dyes("dyed.json")
        self.assertNotEqual(dyes[1], [0, 0, 0])
        # Either is right beside the other: dyed again alone, it stays.
        for i in (0, 1):
            said = self.run_program("convert", "dyed.json", "again.json", *wishes[2 * i : 2 * i + 2])
            self.assertRegex(said, NEAR)
            again = self.dyes("again.json")
            self.assertEqual(again[1 - i], dyes[1 - i])
            for one, other in zip(again[i], dyes[i]):
                self.assertAlmostEqual(one, other, delta=2e-3 * other)

    def test_a_piece_is_dyed_alike(self):
        wanted = "#5a6e3c"
        yarn = CLOSED["yarns"][0]
        blue = {"name": "blue", "radius_um": 18, "absorption_per_mm": [20, 8, 1]}
        two = {"yarns": [yarn, {**yarn, "fibre": 1}], "weft_sequence": [1], "fibres": [*CLOSED["fibres"], blue]}
        said = self.run_program("convert", self.fabric(**{**CLOSED, **two}), "dyed.json", "--cloth-colour", "piece=" + wanted)
        self.assertRegex(said, f"the piece: {wanted} is wanted, the cloth shows #[0-9a-f]{{6}}, {NEAR}")
        one, other = self.dyes("dyed.json")
        self.assertEqual(one, other)
        for channel, seen in zip(channels(wanted), self.seen_from_above("dyed.json")):
            expected = linear(channel)
            self.assertLess(abs(seen - expected), 4 * math.sqrt(expected * (1 - expected) / WALKS))

    def test_what_cannot_be_had_is_said_and_the_nearest_is_taken(self):
        for wanted, why in (("#ffffff", "lighter than this cloth"), ("#000000", "darker than fibres"),
                            ("#ff0000", "lighter and darker than this fibre")):
            with self.subTest(wanted=wanted):
                said = self.run_program("convert", self.fabric(), "dyed.json", "--cloth-colour", "2=" + wanted)
                self.assertRegex(said, f"white: {wanted} cannot be had, it is {why}.*: the nearest under D65 is #[0-9a-f]{{6}}, "
                                       r"off by [1-9][0-9]*\.[0-9] \(CIEDE2000\)")
                dye = self.dyes("dyed.json")[1]
                if wanted == "#ffffff":
                    self.assertEqual(min(dye), 0)
                if wanted == "#000000":
                    self.assertGreater(min(dye), 10)

    def swatch(self, reflectance):
        bands = range(380, 740, 10)
        rows = ["name," + ",".join(map(str, bands)), "pink," + ",".join(f"{100 * reflectance(nm):.3f}" for nm in bands)]
        (self.folder / "pink.csv").write_text("\n".join(rows) + "\n")
        return "pink.csv"

    def off(self, lamp, *options):
        """CIEDE2000 of the dyed cloth under a lamp, as the program says and as `colour` measures it."""
        said = self.run_program("convert", self.fabric(), "dyed.json", "--cloth-colour", "piece=pink.csv", *options)
        self.assertRegex(said, f"cannot be had, .* the nearest under {lamp} is .*under {lamp}, 10 degrees")
        measured = json.loads(self.run_both("colour", "dyed.json", "--standard", "pink.csv", "--illuminant", "D65,F11",
                                            "--json", status=3).stdout)
        under = {each["name"]: each["ciede2000"] for each in measured["illuminants"]}
        self.assertAlmostEqual(float(re.search(r"off by ([0-9.]+)", said)[1]), under[lamp], delta=0.7)
        return under

    def test_a_swatch_out_of_reach_is_nearest_under_the_lamp_that_is_named(self):
        self.swatch(lambda nm: 0.6 + 0.35 * math.exp(-(((nm - 690) / 90) ** 2)))
        daylight, tube = self.off("D65"), self.off("F11", "--illuminant", "F11")
        self.assertLess(daylight["D65"], tube["D65"] + 0.1)
        self.assertLess(tube["F11"], daylight["F11"] + 0.1)
        said = self.run_program("convert", self.fabric(), "dyed.json", "--cloth-colour", "piece=#ffffff", "--illuminant",
                                "A", status=2)
        self.assertIn("--illuminant: expected --cloth-colour with a measured swatch", said)
        said = self.run_program("convert", self.fabric(), "dyed.json", "--cloth-colour", "piece=pink.csv", "--illuminant",
                                "D66", status=1)
        self.assertIn("D66", said)

    def test_a_colour_is_reached_beside_a_dye_that_is_known_in_bands(self):
        bands = [200 * math.exp(-(((nm - 560) / 25) ** 2)) for nm in range(380, 740, 10)]
        yarn = CLOSED["yarns"][0]
        thin = {"name": "plain", "radius_um": 9}  # of such a cloth little light is left to follow
        narrow = {**thin, "name": "narrow",
                  "absorption_per_mm": {"bands": {"from_nm": 380, "step_nm": 10, "values": bands}}}
        two = {"yarns": [yarn, {**yarn, "fibre": 1}], "weft_sequence": [1], "fibres": [thin, narrow]}
        said = self.run_program("convert", self.fabric(**{**CLOSED, **two}), "dyed.json", "--cloth-colour", "1=#806040")
        self.assertRegex(said, NEAR)

    def test_slips_are_named_and_nothing_is_written(self):
        fibres = [{"name": name, "radius_um": 9} for name in ("face", "back", "same", "same")]
        fabric = self.fabric(fibres=fibres)
        for wishes, expected, status in (
            (["red=#102030"], "one of the fabric's fibres, 1 'face', 2 'back', 3 'same', 4 'same', or 'piece' for all; got 'red'", 1),
            (["piece=#102030", "face=#203040"], "one colour for each fibre, got two for fibre 1 'face'", 1),
            (["5=#102030"], "got '5'", 1),
            (["0=#102030"], "got '0'", 1),
            (["same=#102030"], "several are named 'same'", 1),
            (["1=#102030", "face=#203040"], "one colour for each fibre, got two for fibre 1 'face'", 1),
            (["3=#102030"], "a fibre that lies on the face, where it shows its colour, got fibre 3 'same'", 1),
            (["1=red"], "expected FIBRE=#RRGGBB", 2),
            (["#102030"], "expected FIBRE=#RRGGBB", 2),
            (["1=#10203"], "expected FIBRE=#RRGGBB", 2),
            (["=#102030"], "expected FIBRE=#RRGGBB", 2),
        ):
            with self.subTest(wishes=wishes):
                words = [word for wish in wishes for word in ("--cloth-colour", wish)]
                said = self.run_program("convert", fabric, "dyed.json", *words, status=status)
                self.assertIn("--cloth-colour: expected", said)
                self.assertIn(expected, said)
                self.assertFalse((self.folder / "dyed.json").exists())


main()
