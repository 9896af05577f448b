"""`handover`: a cloth in the formats of other programs."""

import json
import zipfile

from harness import CommandLineTest, main, read_png

FEW = ("--size", "32", "--spp", "1", "--measure", "2", "--free-twist")


class Handover(CommandLineTest):
    def test_a_folder_holds_all_formats_and_the_error_of_the_fit(self):
        said = self.run_program("handover", self.fabric(), "-o", "out", *FEW)
        self.assertIn("RMS over directions", said)
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
