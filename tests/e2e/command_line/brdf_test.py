"""`brdf`: a patch of cloth, measured from a half-dome of cameras."""

import csv

from harness import CommandLineTest, main, read_png


class Brdf(CommandLineTest):
    def measure(self, *options, fabric=None):
        """The rows of the CSV: azimuth, inclination and three reflectance factors."""
        self.run_program("brdf", fabric or self.fabric(), "-o", "dome", "--cameras", "8x4", "--spp", 400, *options)
        with open(self.folder / "dome.csv", newline="") as file:
            return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]

    def test_it_writes_values_a_picture_and_a_table(self):
        rows = self.measure()
        self.assertEqual(len(rows), 8 * 4)
        self.assertEqual([row["inclination_deg"] for row in rows[::8]], [11.25, 33.75, 56.25, 78.75])
        self.assertEqual([row["azimuth_deg"] for row in rows[:3]], [22.5, 67.5, 112.5])
        self.assertTrue(self.bytes_of("dome.exr").startswith(b"\x76\x2f\x31\x01"))
        width, height, pixels = read_png(self.folder / "dome.png")
        self.assertEqual((width, height), (256, 256))
        self.assertEqual(pixels[0][0][3], 0, "nothing beyond the rim")
        self.assertEqual(pixels[128][128][3], 255)

    def test_white_cloth_is_as_white_as_its_surroundings(self):
        fibres = [{"name": "white", "radius_um": 9}] * 2
        # So close that nothing is seen through it.
        yarns = [{"name": "warp", "fibre": 0, "count_tex": 40}, {"name": "weft", "fibre": 1, "count_tex": 40}]
        white = self.fabric("white.json", fibres=fibres, yarns=yarns, ends_per_cm=40, picks_per_cm=40)
        for row in self.measure("--light", "furnace", fabric=white):
            for channel in ("red", "green", "blue"):
                self.assertAlmostEqual(row[channel], 1, delta=0.005)

    def test_a_blue_warp_reflects_blue(self):
        rows = self.measure("--light", "dome")
        self.assertGreater(sum(row["blue"] for row in rows), 1.1 * sum(row["red"] for row in rows))

    def test_fibres_agree_with_the_volume(self):
        for angle in (30, 150):
            means = {}
            for method in ("volume", "fibres"):
                rows = self.measure("--light-angle", angle, "--method", method, "--resolution", 8)
                means[method] = sum(row["green"] for row in rows) / len(rows)
            self.assertAlmostEqual(means["volume"] / means["fibres"], 1, delta=0.3)

    def test_what_it_cannot_measure_it_says(self):
        for option, value, said in (
            ("--light-angle", "90", "--light-angle: expected"),
            ("--light-angle", "200", "--light-angle: expected"),
            ("--light", "ibl", "--light: expected"),
            ("--cameras", "64", "--cameras: expected"),
            ("--cameras", "0x4", "--cameras: expected"),
        ):
            with self.subTest(option=option, value=value):
                words = ("brdf", self.fabric(), "-o", "dome", option, value)
                self.assertIn(said, self.run_program(*words, status=2))
        both = ("brdf", self.fabric(), "-o", "dome", "--light-angle", "10", "--light", "dome")
        self.assertIn("--light-angle", self.run_program(*both, status=2))


main()
