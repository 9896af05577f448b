"""`tile`: maps for other programs."""

import json
import os
import re
import struct

from harness import CommandLineTest, main, read_png


class Tile(CommandLineTest):
    def test_all_maps_have_the_size_that_the_sidecar_says(self):
        self.run_program("tile", self.fabric(), "-o", "maps", "--size", "48", "--spp", "2")
        sidecar = json.loads((self.folder / "maps" / "small_twill.json").read_text())
        self.assertEqual(max(sidecar["width_px"], sidecar["height_px"]), 48)
        self.assertAlmostEqual(sidecar["width_mm"], sidecar["ends"] * 10 / 20)
        self.assertAlmostEqual(sidecar["height_mm"], sidecar["picks"] * 10 / 18)
        self.assertGreater(sidecar["areal_mass_g_m2"], 1)
        self.assertGreater(sidecar["thickness_mm"], 0.05)
        for name in ("base_color", "normal", "height", "opacity", "yarn"):
            width, height, rows = read_png(self.folder / "maps" / sidecar["maps"][name]["file"])
            self.assertEqual((width, height), (sidecar["width_px"], sidecar["height_px"]), name)
            if name in ("normal", "height"):
                self.assertGreater(max(max(pixel) for row in rows for pixel in row), 255, f"{name}: 16 bits")
            self.assertGreater(len({pixel for row in rows for pixel in row}), 1, name)
            content = (self.folder / "maps" / sidecar["maps"][name]["file"]).read_bytes()
            place = content.index(b"pHYs") + 4
            pixels_per_m = struct.unpack(">I", content[place:place + 4])[0]
            self.assertAlmostEqual(pixels_per_m * sidecar["width_mm"] / 1000, width, delta=0.5, msg=name)
        self.assertTrue((self.folder / "maps" / sidecar["maps"]["all"]["file"]).read_bytes().startswith(b"v/1\x01"))

    def test_mass_and_thickness_are_those_of_the_draft(self):
        """A tile four pixels wide stretches the cloth by a tenth, to have square pixels."""
        fabric = self.fabric(warp_sequence=[0], weft_sequence=[0] * 24 + [1] * 24,
                             drape={"kind": "flat", "width_mm": 30, "height_mm": 30})
        self.run_program("tile", fabric, "-o", "maps", "--size", "48", "--free-twist", "--spp", "1")
        sidecar = json.loads((self.folder / "maps" / "small_twill.json").read_text())
        self.assertEqual((sidecar["ends"], sidecar["picks"]), (4, 48))
        self.assertGreater(abs(sidecar["width_mm"] / sidecar["width_px"] / sidecar["height_mm"] * 48 - 1), 0.05)
        cloth = json.loads(self.run_program("info", fabric, "--json"))
        for name in ("areal_mass_g_m2", "thickness_mm"):
            self.assertAlmostEqual(sidecar[name], cloth[name], places=6, msg=name)

    def test_maps_that_take_too_much_memory_are_refused_before_they_are_traced(self):
        said = self.run_program("tile", self.fabric(), "-o", "maps", "--size", "512", "--spp", "1000000", "--memory-limit",
                                "0.005", status=1)
        most = int(re.search(r"small twill: expected a tile whose longer side has at most (\d+) pixels, got 512", said)[1])
        self.run_program("tile", self.fabric(), "-o", "maps", "--size", most, "--spp", "1", "--memory-limit", "0.005")

    def test_a_draft_has_the_sett_of_its_file_where_that_is_asked_for(self):
        self.run_program("convert", self.fabric(ends_per_cm=31, picks_per_cm=27), "draft.wif")
        widths = {}
        for sizes in ("file", "keep"):
            self.run_program("tile", "draft.wif", "--wif-sizes", sizes, "-o", sizes, "--size", "24", "--spp", "1")
            sidecar = json.loads(next((self.folder / sizes).glob("*.json")).read_text())
            widths[sizes] = sidecar["width_mm"] / sidecar["ends"]
        self.assertAlmostEqual(widths["file"], 10 / 31, delta=0.002)
        self.assertGreater(abs(widths["keep"] - widths["file"]), 0.01)

    def test_a_file_s_name_need_not_be_utf_8(self):
        """As it comes from an old disk; the cloth in it has no name, and is called after it."""
        self.run_program("convert", self.fabric(name=""), "draft.wif")
        draft = os.fsdecode(b"caf\xe9.wif")
        (self.folder / "draft.wif").rename(self.folder / draft)
        self.assertIn("caf\ufffd", json.loads(self.run_program("info", draft, "--json"))["name"])
        self.run_program("tile", draft, "-o", "maps", "--size", "24", "--spp", "1")
        sidecar, = (self.folder / "maps").glob("*.json")
        self.assertIn("base_color", json.loads(sidecar.read_text())["maps"])

    def test_yarns_are_called_alike_everywhere(self):
        nameless = [{"name": "", "fibre": fibre, "count_tex": tex} for fibre, tex in ((0, 16), (1, 20))]
        fabric = self.fabric(yarns=nameless)
        self.run_program("tile", fabric, "-o", "maps", "--size", "24", "--spp", "1")
        sidecar = json.loads((self.folder / "maps" / "small_twill.json").read_text())
        called = [yarn["name"] for yarn in sidecar["maps"]["yarn"]["yarns"]]
        self.assertRegex(called[0], r"^[a-z ]+ 16 tex$")
        need = json.loads(self.run_program("info", fabric, "--json"))["yarn_need"]
        self.assertEqual([yarn["name"] for yarn in need["yarns"]], called)
        self.assertIn(called[0], self.run_program("info", fabric))
        traced = [self.run_program("trace", fabric, "--pixel", f"{x},12", "--sample", 0) for x in range(4, 28, 4)]
        self.assertTrue(any(f"'{name}' of" in text for text in traced for name in called), traced)

    def test_the_same_tile_has_the_same_bytes(self):
        for folder in ("a", "b"):
            self.run_program("tile", self.fabric(), "-o", folder, "--size", "24", "--spp", "1")
        for file in (self.folder / "a").iterdir():
            self.assertEqual(file.read_bytes(), (self.folder / "b" / file.name).read_bytes(), file.name)

    def test_a_colourway_changes_the_colours_alone(self):
        fabric = self.fabric(colourways=[{"name": "Rust", "absorption_per_mm": [[1, 8, 20], [2, 9, 30]]}])
        for folder, words in (("a", ()), ("b", ("--colourway", "Rust"))):
            self.run_program("tile", fabric, "-o", folder, "--size", "24", "--spp", "1", *words)
        for map_name, same in (("basecolor", False), ("opacity", True), ("height", True)):
            file = f"small_twill_{map_name}.png"
            self.assertEqual(self.bytes_of("a/" + file) == self.bytes_of("b/" + file), same, map_name)
        said = self.run_program("tile", fabric, "-o", "c", "--colourway", "Moss", status=1)
        self.assertIn("colourway 'Moss': expected one of 'Rust'", said)

    def test_bad_words_and_places_are_refused(self):
        fabric = self.fabric()
        self.assertIn("--size", self.run_program("tile", fabric, "-o", "maps", "--size", "3", status=2))
        (self.folder / "file").write_text("in the way")
        self.assertIn("file", self.run_program("tile", fabric, "-o", "file/maps", status=1))


main()
