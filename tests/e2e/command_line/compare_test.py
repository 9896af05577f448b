"""`compare` measures a picture against its reference, and says by what yardstick."""

import json
import math
import struct

from harness import CommandLineTest, main, read_png


def exr(width, height, colour):
    """An uncompressed EXR of float channels; `colour` gives r, g and b of x and y."""

    def attribute(name, kind, value):
        return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<I", len(value)) + value

    window = struct.pack("<4i", 0, 0, width - 1, height - 1)
    channels = b"".join(name + b"\0" + struct.pack("<iB3xii", 2, 0, 1, 1) for name in (b"B", b"G", b"R")) + b"\0"
    header = struct.pack("<II", 20000630, 2)
    header += attribute("channels", "chlist", channels)
    header += attribute("compression", "compression", b"\0")
    header += attribute("dataWindow", "box2i", window) + attribute("displayWindow", "box2i", window)
    header += attribute("lineOrder", "lineOrder", b"\0")
    header += attribute("pixelAspectRatio", "float", struct.pack("<f", 1))
    header += attribute("screenWindowCenter", "v2f", struct.pack("<2f", 0, 0))
    header += attribute("screenWindowWidth", "float", struct.pack("<f", 1)) + b"\0"
    row_bytes = 12 * width
    first = len(header) + 8 * height
    offsets = b"".join(struct.pack("<Q", first + y * (8 + row_bytes)) for y in range(height))
    rows = b""
    for y in range(height):
        pixels = [colour(x, y) for x in range(width)]
        rows += struct.pack("<iI", y, row_bytes)
        for channel in (2, 1, 0):
            rows += struct.pack(f"<{width}f", *(pixel[channel] for pixel in pixels))
    return header + offsets + rows


class Compare(CommandLineTest):
    def picture(self, name, colour, size=(24, 16)):
        (self.folder / name).write_bytes(exr(*size, colour if callable(colour) else lambda x, y: colour))
        return name

    def measures(self, *words):
        return json.loads(self.run_program("compare", *words, "--json"))

    def test_known_pictures_have_known_measures(self):
        self.picture("a.exr", (0.55, 0.4, 0.2))
        self.picture("r.exr", (0.5, 0.5, 0.2))
        found = self.measures("a.exr", "r.exr")
        self.assertEqual((found["width"], found["height"]), (24, 16))
        self.assertAlmostEqual(found["rmse"], math.sqrt(0.0125 / 3), places=6)
        self.assertAlmostEqual(found["relative_mse"], 0.0125 / (0.25 + 0.01 * 0.16) / 3, places=6)
        for channel, percent in enumerate((10, -20, 0)):
            self.assertAlmostEqual(found["mean_difference_percent"][channel], percent, places=4)
        self.assertEqual((found["exposure_stops"], found["pixels_per_degree"]), (0, 67))
        self.assertTrue(0 < found["flip_mean"] <= found["flip_largest"] <= 1)
        self.assertIsNone(found["yardstick"])
        self.assertIsNone(found["noise_free_bias"])

    def test_two_seeds_of_each_measure_under_the_noise(self):
        fabric = self.fabric()
        for seed in range(1, 5):
            self.run_program("render", fabric, "-o", f"{seed}.exr", "--seed", seed)
        words = ("1.exr", "2.exr", "--again", "3.exr", "4.exr")
        found = self.measures(*words)
        self.assertGreater(found["relative_mse"], 0)
        self.assertLess(abs(found["noise_free_bias"]), 0.2 * found["relative_mse"])
        self.assertIn("noise-free bias", self.run_program("compare", *words))
        message = self.run_program("compare", "1.exr", "2.exr", "--again", "1.exr", "3.exr", status=1)
        self.assertIn("another seed", message)

    def test_the_yardstick_stands_beside_what_is_measured(self):
        self.picture("a.exr", (0.30, 0.3, 0.3))
        self.picture("r.exr", (0.33, 0.3, 0.3))
        self.picture("y.exr", (0.36, 0.3, 0.3))
        found = self.measures("a.exr", "r.exr", "--yardstick", "y.exr", "r.exr")
        self.assertEqual((found["yardstick"]["picture"], found["yardstick"]["reference"]), ("y.exr", "r.exr"))
        self.assertAlmostEqual(found["yardstick"]["mean_difference_percent"][0], 100 / 11, places=4)
        table = self.run_program("compare", "a.exr", "r.exr", "--yardstick", "y.exr", "r.exr")
        self.assertIn("yardstick: y.exr against r.exr", table)
        self.assertIn("yardstick: none", self.run_program("compare", "a.exr", "r.exr"))

    def test_the_heat_map_shows_where_and_says_its_range(self):
        self.picture("a.exr", lambda x, y: (0.6, 0.3, 0.3) if x < 24 else (0.3, 0.3, 0.3), size=(64, 16))
        self.picture("r.exr", (0.3, 0.3, 0.3), size=(64, 16))
        said = self.run_program("compare", "a.exr", "r.exr", "-o", "heat.png", "--range", "0.5")
        self.assertIn("heat.png: FLIP from 0 (black) to 0.5 (white)", said)
        width, height, rows = read_png(self.folder / "heat.png")
        self.assertEqual((width, height), (64, 16))
        self.assertGreater(sum(rows[8][4]), 150)
        self.assertEqual(rows[8][60], (0, 0, 0))
        self.assertIn(b"FLIP from 0 (black) to 0.5 (white)", self.bytes_of("heat.png"))

    def test_pixels_that_are_not_finite_are_reported_and_left_out(self):
        self.picture("a.exr", lambda x, y: (math.nan if (x, y) == (3, 2) else 0.5, 0.5, 0.5))
        self.picture("r.exr", (0.4, 0.4, 0.4))
        found = self.measures("a.exr", "r.exr")
        self.assertEqual((found["non_finite_pixels"], found["reference_non_finite_pixels"]), (1, 0))
        self.assertAlmostEqual(found["rmse"], 0.1, places=6)

    def test_black_references_give_no_ratio(self):
        self.picture("a.exr", (0.1, 0.1, 0.1))
        self.picture("r.exr", (0, 0, 0))
        self.assertIsNone(self.measures("a.exr", "r.exr")["relative_mse"])

    def test_what_cannot_be_compared_is_named(self):
        self.picture("a.exr", (0.1, 0.1, 0.1))
        self.picture("small.exr", (0.1, 0.1, 0.1), size=(5, 4))
        self.picture("hole.exr", (math.inf, 0, 0))
        (self.folder / "text.exr").write_text("no picture")
        for words, said in (
            (("a.exr", "small.exr"), "5 x 4"),
            (("a.exr", "a.exr", "--yardstick", "small.exr", "small.exr"), "5 x 4"),
            (("a.exr", "missing.exr"), "missing.exr"),
            (("a.exr", "text.exr"), "text.exr"),
            (("a.exr", "hole.exr"), "finite"),
            (("a.exr", "a.exr", "-o", "heat.jpg"), "heat.jpg"),
        ):
            with self.subTest(words=words):
                self.assertIn(said, self.run_program("compare", *words, status=1))


main()
