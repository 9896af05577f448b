"""`render` makes pictures of every sample, on every kind of surface, under every light."""

import json

from harness import SAMPLES, CommandLineTest, main, read_png


class Render(CommandLineTest):
    def picture(self, fabric, *options):
        self.run_program("render", fabric, "-o", "out.png", "--size", "32x24", "--spp", 4, *options)
        width, height, rows = read_png(self.folder / "out.png")
        self.assertEqual((width, height), (32, 24))
        return [pixel for row in rows for pixel in row]

    def soon_laid(self, sample):
        """The sample; or, of the two whose thick yarns take many seconds to be laid, a copy of a quarter of the fibres."""
        if sample.stem not in ("carpet", "blanket"):
            return sample
        fabric = json.loads(sample.read_text())
        for fibre in fabric["fibres"]:
            fibre["radius_um"] *= 2
        copy = self.folder / sample.name
        copy.write_text(json.dumps(fabric))
        return copy

    def test_every_sample_lies_flat_and_on_a_cylinder(self):
        samples = sorted(SAMPLES.glob("*.json"))
        self.assertGreaterEqual(len(samples), 7)
        for sample in map(self.soon_laid, samples):
            for drape in ("flat", "cylinder"):
                with self.subTest(sample=sample.name, drape=drape):
                    pixels = self.picture(sample, "--resolution", 2, "--drape", drape)
                    self.assertGreater(len(set(pixels)), 50, "a cloth has texture")

    def test_every_light_shows_the_cloth(self):
        fabric = self.fabric()
        seen = set()
        lights = ("ibl", "sky:40,60", "overcast", "window", "booth", "dome", "furnace", "back", "point",
                  "directional:-90,60")
        for light in lights:
            with self.subTest(light=light):
                pixels = self.picture(fabric, "--light", light, "--view", "top")
                middle = pixels[12 * 32 + 8 : 12 * 32 + 24]
                self.assertGreater(max(max(pixel[:3]) for pixel in middle), 30, "some light comes back")
                seen.add(tuple(pixels))
        self.assertEqual(len(seen), len(lights), "no light looks like another")

    def test_views_differ(self):
        fabric = self.fabric()
        views = ("front", "top", "side", "close", "macro", "20,35", "20,35,40")
        self.assertEqual(len({tuple(self.picture(fabric, "--view", view)) for view in views}), len(views))

    def test_a_fabric_is_seen_in_another_of_its_colourways(self):
        fabric = self.fabric(colourways=[{"name": "Rust", "absorption_per_mm": [[1, 8, 20], [2, 9, 30]]}])
        self.assertNotEqual(self.picture(fabric, "--colourway", "Rust"), self.picture(fabric))
        said = self.run_program("render", fabric, "-o", "a.png", "--colourway", "Moss", status=1)
        self.assertIn(f"{fabric}: colourway 'Moss': expected one of 'Rust'", said)
        said = self.run_program("render", self.fabric(), "-o", "a.png", "--colourway", "Moss", status=1)
        self.assertIn("which has none", said)

    def test_exposure_brightens_a_png_and_leaves_an_exr(self):
        fabric = self.fabric()
        dark = self.picture(fabric, "--light", "dome", "--exposure", -2)
        bright = self.picture(fabric, "--light", "dome", "--exposure", 1)
        self.assertGreater(sum(map(sum, bright)), sum(map(sum, dark)))
        for stops in (-2, 1):
            self.run_program("render", fabric, "-o", f"{stops}.exr", "--exposure", stops)
        self.assertEqual(self.bytes_of("-2.exr"), self.bytes_of("1.exr"))

    def test_the_plain_tone_has_no_curve(self):
        # Three stops up, the brightest of the white yarns have up to eight times the light of white.
        fabric = self.fabric()
        options = ("--light", "dome", "--exposure", 3)
        plain = self.picture(fabric, *options, "--tone", "plain")
        filmic = self.picture(fabric, *options, "--tone", "filmic")
        self.assertEqual(filmic, self.picture(fabric, *options), "which is the usual")
        knee = 217  # 0.7 of white is just above it
        for bent, straight in zip(filmic, plain):
            if max(bent) <= knee:
                self.assertEqual(straight, bent, "what is dark is not bent")
            else:
                self.assertTrue(all(s >= b for s, b in zip(straight, bent)), (straight, bent))
        self.assertEqual(max(map(max, plain)), 255, "what is brighter than white is cut off")
        self.assertLess(max(map(max, filmic)), 255, "which the curve never reaches")
        self.assertTrue(any(max(bent) <= knee for bent in filmic))
        for tone in ("plain", "filmic"):
            self.run_program("render", fabric, "-o", f"{tone}.exr", "--tone", tone)
        self.assertEqual(self.bytes_of("plain.exr"), self.bytes_of("filmic.exr"))

    def test_a_log_has_plain_lines(self):
        fabric = self.fabric()
        text = self.run_program("render", fabric, "-o", "out.png")
        self.assertEqual(len(text.splitlines()), 1)
        self.assertIn("out.png: 32 x 24, 4 samples per pixel", text)

    def test_a_weave_bitmap_is_cloth_too(self):
        self.run_program("convert", self.fabric(), "weave.png")
        self.assertGreater(len(set(self.picture("weave.png", "--resolution", 2))), 50)


main()
