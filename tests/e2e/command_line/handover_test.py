"""`handover`: a cloth in the formats of other programs."""

import json
import os
import subprocess
import sys
import zipfile

from harness import HANGS_S, ROOT, CommandLineTest, main, read_png

FEW = ("--size", "32", "--spp", "1", "--measure", "2", "--free-twist")


class Handover(CommandLineTest):
    def test_a_folder_holds_all_formats_and_the_error_of_the_fit(self):
        said = self.run_program("handover", self.fabric(), "-o", "out", *FEW)
        self.assertIn("RMS over directions", said)
        self.assertIn("small_twill.jfab: experimental", said)
        self.assertRegex(self.run_program("--help"), r"\.jfab\s+\(experimental\)")
        folder = self.folder / "out"
        for ending in (".u3m", ".u3ma", ".glb", "_back.glb", ".mtlx", "_back.mtlx", ".jfab", ".handover.json"):
            self.assertTrue((folder / f"small_twill{ending}").stat().st_size > 0, ending)
        sidecar = json.loads((folder / "small_twill.handover.json").read_text())
        for side in ("front", "back"):
            fit = sidecar["sides"][side]["fit"]
            self.assertGreater(fit["reflected"]["mean_reflectance_factor"], 0)
            self.assertGreaterEqual(fit["reflected"]["rms_error"], 0)
            for told in sidecar["sides"][side]["maps"].values():
                width, height, _ = read_png(folder / told["file"])
                self.assertEqual((width, height), (sidecar["width_px"], sidecar["height_px"]))
        with zipfile.ZipFile(folder / "small_twill.u3ma") as archive:
            self.assertIsNone(archive.testzip())
            self.assertEqual(archive.read("small_twill.u3m"), (folder / "small_twill.u3m").read_bytes())
        with self.subTest("heights of both sides are millimetres that add up to the thickness"):
            self.heights_add_up(sidecar)
        with self.subTest("the public validators that are here find nothing wrong"):
            self.validators_pass(folder)

    def validators_pass(self, folder):
        """Those that tests/handover/run asks; the schema of U3M is not in the tree, and may be named."""
        schema = os.environ.get("LOOMLIGHT_U3M_SCHEMA")
        done = subprocess.run([sys.executable, "-B", ROOT / "tests/handover/check_formats.py", folder, "small_twill",
                               *([schema] if schema else [])], capture_output=True, text=True, timeout=HANGS_S)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        if schema:
            self.assertIn("passed: small_twill.u3m by the schema of U3M", done.stdout)

    def heights_add_up(self, sidecar):
        """Those of front and back, mm, come to the thickness: of a run that is there already, as a fit takes long."""

        def heights_mm(side):
            told = sidecar["sides"][side]["maps"]["height"]
            _, _, rows = read_png(self.folder / "out" / told["file"])
            scale = (told["white_mm"] - told["black_mm"]) / 65535
            return [[told["black_mm"] + scale * pixel[0] for pixel in row] for row in rows]

        front, back = heights_mm("front"), heights_mm("back")
        self.assertGreater(len({height for row in front for height in row}), 256, "8 bits have no more")
        thickest_mm = max(f + b for above, below in zip(front, back) for f, b in zip(above, reversed(below)))
        self.assertGreater(thickest_mm, 0.95 * sidecar["thickness_mm"])
        self.assertLess(thickest_mm, 1.3 * sidecar["thickness_mm"], "it has hairs, which no thickness counts")

    def test_mass_and_thickness_are_those_of_the_draft(self):
        """A tile few pixels wide stretches the cloth, to have square pixels."""
        fabric = self.fabric(warp_sequence=[0], weft_sequence=[0] * 24 + [1] * 24,
                             drape={"kind": "flat", "width_mm": 30, "height_mm": 30})
        self.run_program("handover", fabric, "-o", "out", "--size", "48", *FEW[2:])
        sidecar = json.loads((self.folder / "out" / "small_twill.handover.json").read_text())
        self.assertGreater(abs(sidecar["width_mm"] / sidecar["width_px"] / sidecar["height_mm"] * 48 - 1), 0.05)
        cloth = json.loads(self.run_program("info", fabric, "--json"))
        physics = json.loads((self.folder / "out" / "small_twill.u3m").read_text())["material"]["physics"]
        for name, other in (("areal_mass_g_m2", "weight"), ("thickness_mm", "thickness")):
            self.assertAlmostEqual(sidecar[name], cloth[name], places=6, msg=name)
            self.assertAlmostEqual(physics[other], cloth[name], places=6, msg=other)

    def test_maps_that_take_too_much_memory_are_refused_before_they_are_traced(self):
        said = self.run_program("handover", self.fabric(), "-o", "out", "--size", "512", "--spp", "1000000",
                                "--memory-limit", "0.005", status=1)
        self.assertRegex(said, r"small twill: expected a tile whose longer side has at most \d+ pixels, got 512")
        self.assertFalse((self.folder / "out").exists())

    def test_every_colourway_has_a_folder(self):
        fabric = self.fabric(colourways=[{"name": "Rust", "absorption_per_mm": [[1, 8, 20], [2, 9, 30]]}])
        self.run_program("handover", fabric, "-o", "out", "--colourways", *FEW)
        self.assertTrue((self.folder / "out/small_twill.u3m").exists())
        rust = json.loads((self.folder / "out/Rust/small_twill_Rust.u3m").read_text())
        self.assertEqual(rust["material"]["name"], "small twill Rust")

    def test_bad_words_and_places_are_refused(self):
        fabric = self.fabric()
        self.assertIn("--measure", self.run_program("handover", fabric, "-o", "out", "--measure", "0", status=2))
        (self.folder / "file").write_text("in the way")
        self.assertIn("file", self.run_program("handover", fabric, "-o", "file/out", status=1))


main()
