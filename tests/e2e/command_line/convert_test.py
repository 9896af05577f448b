"""`convert` between fabrics, drafts and weave bitmaps."""

import json
import subprocess
import zipfile

from harness import SMALL, CommandLineTest, main, read_png, write_png


class Convert(CommandLineTest):
    def test_a_weave_survives_the_way_through_a_bitmap(self):
        self.run_program("convert", self.fabric(), "weave.png")
        width, height, rows = read_png(self.folder / "weave.png")
        self.assertEqual((width, height), (4, 4))
        drawn = ["".join("#" if max(pixel) < 128 else "." for pixel in row) for row in rows]
        self.assertEqual(drawn, SMALL["weave"])
        self.run_program("convert", "weave.png", "back.json")
        self.assertEqual(json.loads(self.bytes_of("back.json"))["weave"], SMALL["weave"])

    def test_looms_get_one_bit_a_crossing(self):
        weave = ["#........#", ".#........", "..##......"]  # of ten ends: a row is more than a byte
        fabric = self.fabric(weave=weave, ends_per_cm=24, picks_per_cm=18)
        for name in ("weave.tif", "weave.tiff", "weave.bmp"):
            with self.subTest(name=name):
                self.run_program("convert", fabric, name)
                file = str(self.folder / name)
                described = subprocess.run(["identify", "-format", "%w %h %z %[type]", file], capture_output=True,
                                           text=True, check=True).stdout
                self.assertEqual(described, "10 3 1 Bilevel")
                bits = subprocess.run(["convert", file, "-compress", "none", "pbm:-"], capture_output=True, text=True,
                                      check=True).stdout.split()[3:]
                self.assertEqual("".join(bits), "".join(weave).replace("#", "1").replace(".", "0"))
        self.assertIn("weave.ep", self.run_program("convert", fabric, "weave.ep", status=1))

    def test_like_gives_all_but_the_weave(self):
        self.run_program("convert", self.fabric(), "weave.png")
        other = self.fabric("other.json", weave=["#.", ".#"], name="plain")
        self.run_program("convert", "weave.png", "dressed.json", "--like", other)
        dressed = json.loads(self.bytes_of("dressed.json"))
        self.assertEqual(dressed["weave"], SMALL["weave"])
        self.assertEqual([yarn["name"] for yarn in dressed["yarns"]], ["warp", "weft"])

    def test_a_fabric_is_written_in_full_and_keeps_what_is_not_known(self):
        fabric = self.fabric(owner="somebody")
        self.run_program("convert", fabric, "a.json")
        written = json.loads(self.bytes_of("a.json"))
        self.assertEqual(written["owner"], "somebody")
        self.assertIn("max_depth", written["render"])
        self.run_program("convert", "a.json", "b.json")
        self.assertEqual(self.bytes_of("a.json"), self.bytes_of("b.json"))

    def test_a_fabric_is_the_same_by_either_ending(self):
        self.run_program("convert", self.fabric(), "a.json")
        self.run_program("convert", "a.json", "b.Loomlight")
        self.assertEqual(self.bytes_of("a.json"), self.bytes_of("b.Loomlight"))
        self.run_program("convert", "b.Loomlight", "c.json", "--like", "b.Loomlight")
        self.assertEqual(self.bytes_of("a.json"), self.bytes_of("c.json"))

    def test_a_picture_gives_its_fabric_back(self):
        self.run_program("render", self.fabric(), "-o", "picture.exr")
        self.run_program("convert", "picture.exr", "again.json")
        self.assertEqual(json.loads(self.bytes_of("again.json"))["name"], "small twill")

    def test_a_fabric_becomes_a_draft_and_comes_back(self):
        fabric = self.fabric()
        said = self.run_program("convert", fabric, "a.wif", messages=True)
        self.assertIn("4 shafts and 4 treadles", said)
        text = self.bytes_of("a.wif").decode("ascii")
        self.assertTrue(text.startswith("[WIF]\r\nVersion=1.1\r\n"))
        self.run_program("convert", "a.wif", "b.json")
        draft = json.loads(self.bytes_of("b.json"))["draft"]
        self.assertEqual(draft["treadling"], [1, 2, 3, 4])
        self.run_program("convert", "a.wif", "weave.png")
        self.run_program("convert", fabric, "expected.png")
        self.assertEqual(read_png(self.folder / "weave.png"), read_png(self.folder / "expected.png"))

    def said_of(self, draft, *options):
        """What converting the text of a WIF draft says; the fabric is a.json."""
        (self.folder / "a.wif").write_text(draft)
        return self.run_program("convert", "a.wif", "a.json", *options, messages=True)

    def test_a_draft_says_which_option_takes_more_of_it(self):
        draft = ("[WIF]\n[CONTENTS]\nNOTES=true\n[WEAVING]\nShafts=2\nTreadles=2\nRising Shed=1\n[WARP]\nThreads=2\nUnits=cm\nSpacing=.1\n"
                 "[WEFT]\nThreads=50\n[THREADING]\n1=1\n2=2\n[TIEUP]\n1=1\n2=2\n[TREADLING]\n1=1\n2=2\n")
        said = self.said_of(draft)
        self.assertIn("--wif-threads named cuts it to the 2 ends and 2 picks", said)
        self.assertIn("--wif-sizes file takes", said)
        self.assertLess(said.index("--wif-sizes file takes"), said.index("[CONTENTS]"), "of the cloth before the file")
        said = self.said_of(draft, "--wif-threads", "named", "--wif-sizes", "file")
        self.assertNotIn("--wif", said)
        fabric = json.loads(self.bytes_of("a.json"))
        self.assertEqual(fabric["draft"]["treadling"], [1, 2])
        self.assertEqual(fabric["ends_per_cm"], 10)

    def test_wif_by_the_ending_of_pixeloom_is_read(self):
        self.run_program("convert", self.fabric(), "a.wif")
        text = self.bytes_of("a.wif").replace(b"[THREADING]\r\n", b"[THREADING]\r\n;[4]Ground\r\n")
        (self.folder / "b.plm").write_bytes(text)
        self.run_program("convert", "a.wif", "a.png")
        self.run_program("convert", "b.plm", "b.png")
        self.assertEqual(read_png(self.folder / "a.png"), read_png(self.folder / "b.png"))

    def test_a_draft_of_thick_yarns_says_which_option_takes_them(self):
        draft = ("[WIF]\n[WEAVING]\nShafts=2\nTreadles=2\nRising Shed=1\n[WARP]\nThreads=2\nUnits=cm\n"
                 "Thickness=.1\n[WEFT]\nThreads=2\n[THREADING]\n1=1\n2=2\n[TIEUP]\n1=1\n2=2\n[TREADLING]\n1=1\n2=2\n")
        said = self.said_of(draft)
        self.assertIn("The file's warp yarn is 1 mm thick", said)
        self.assertIn("--wif-sizes file takes", said)

    def test_a_text_draft_of_fiberworks_becomes_a_wif_draft(self):
        (self.folder / "a.dtx").write_text("@@StartDTX\n@@Info\n%%shafts 2\n%%treadles 2\n%%ends 3\n%%picks 2\n"
                                           "@@Threading\n1 2 1\n@@Tieup\n01\n10\n@@Treadling\n2 1\n@@EndDTX\n")
        self.run_program("convert", "a.dtx", "a.wif")
        self.assertIn(b"[TREADLING]\r\n1=2\r\n2=1\r\n", self.bytes_of("a.wif"))

    def test_an_archive_of_tempoweave_is_read_as_the_draft_in_it(self):
        self.run_program("convert", self.fabric(), "a.wif")
        with zipfile.ZipFile(self.folder / "b.twa", "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr("writeup.html", "<p>of another program</p>")
            archive.write(self.folder / "a.wif", "twamain.waf")
        self.run_program("convert", "b.twa", "b.wif")
        self.assertEqual(self.bytes_of("a.wif"), self.bytes_of("b.wif"))

    def test_a_structure_by_its_name_takes_the_place_of_the_weave(self):
        self.run_program("convert", self.fabric(), "a.json", "--structure", "satin,5,2")
        self.run_program("convert", "a.json", "satin.png")
        self.assertEqual(read_png(self.folder / "satin.png")[:2], (5, 5))
        made = json.loads(self.bytes_of("a.json"))
        self.assertEqual([yarn["name"] for yarn in made["yarns"]], ["warp", "weft"])
        self.run_program("convert", "a.json", "b.json", "--structure", "Houndstooth")
        self.assertEqual(json.loads(self.bytes_of("b.json"))["warp_sequence"], [0] * 4 + [1] * 4)
        for wrong, expected in (("velvet", "one of Plain, Warp rib"), ("satin,6,2", "satin,6,2"),
                                ("satin,8,3,0,1", "at most 3 numbers"), ("plain,4", "at most 0 numbers"),
                                ("satin,many", "Satin: Ends: expected")):
            with self.subTest(wrong=wrong):
                said = self.run_program("convert", "a.json", "c.json", "--structure", wrong, status=2)
                self.assertIn(expected, said)

    def test_the_colours_of_a_picture_are_woven_as_structures(self):
        dark, middle, light = (20, 10, 30), (200, 40, 40), (250, 250, 240)
        # Light above, dark at the left below, the third colour at the right.
        write_png(self.folder / "a.png", [[light] * 16] * 8 + [[dark] * 8 + [middle] * 8] * 8)
        words = ("--weave-colour", "twill,3,1", "--weave-colour", "plain", "--weave-colour", "twill,1,3")
        said = self.run_program("convert", "a.png", "b.json", *words)
        self.assertIn("#140a1e, 25.0 %: Twill 3/1", said)
        self.assertIn("#fafaf0, 50.0 %: Twill 1/3", said)
        fabric = json.loads(self.bytes_of("b.json"))
        self.assertEqual(fabric["name"], "a")
        rows = fabric["weave"]  # the last pick first
        self.assertEqual([len(rows), len(rows[0])], [16, 16])
        self.assertEqual(["".join(rows[:8]).count("#"), "".join(r[:8] for r in rows[8:]).count("#"),
                          "".join(r[8:] for r in rows[8:]).count("#")], [32, 48, 32])
        self.run_program("convert", "a.png", "c.json", *words, "--repeat", "8x4", "--like", "b.json")
        self.assertEqual([len(row) for row in json.loads(self.bytes_of("c.json"))["weave"]], [8] * 4)
        for wrong, expected, status in ((words + ("--weave-colour", "plain"), "expected 4 colours", 1),
                                        (words + ("--structure", "plain"), "expected no --structure", 2),
                                        (("--repeat", "8x4"), "expected --weave-colour as well", 2),
                                        (("--weave-colour", "houndstooth"), "expected a structure of one colour", 2),
                                        (("--weave-colour", "velvet"), "--weave-colour: expected one of Plain", 2)):
            with self.subTest(wrong=wrong):
                self.assertIn(expected, self.run_program("convert", "a.png", "d.json", *wrong, status=status))
        self.assertIn("expected a picture (.png)", self.run_program("convert", "b.json", "d.json", *words, status=1))

    def test_private_sections_of_a_draft_survive_the_way_through_a_fabric(self):
        self.run_program("convert", self.fabric(), "a.wif")
        text = self.bytes_of("a.wif") + b"[PRIVATE OTHER PROGRAM]\r\n; kept\r\n x = y\r\n"
        (self.folder / "b.wif").write_bytes(text)
        self.run_program("convert", "b.wif", "c.json")
        self.run_program("convert", "c.json", "d.wif")
        self.assertIn(b"[PRIVATE OTHER PROGRAM]\r\n; kept\r\n x = y\r\n", self.bytes_of("d.wif"))

    def test_sizes_of_a_draft_are_taken_only_where_wanted(self):
        self.run_program("convert", self.fabric(), "a.wif")
        for words, picks_per_cm in (((), 26), (("--wif-sizes", "keep"), 26), (("--wif-sizes", "file"), 18)):
            self.run_program("convert", "a.wif", "b.json", *words)
            self.assertEqual(json.loads(self.bytes_of("b.json"))["picks_per_cm"], picks_per_cm)

    def test_what_was_wrong_in_a_draft_is_said(self):
        self.run_program("convert", self.fabric(), "a.wif")
        text = self.bytes_of("a.wif").replace(b"Shafts=4", b"Shafts=many")
        (self.folder / "b.wif").write_bytes(text)
        said = self.run_program("convert", "b.wif", "c.json", messages=True)
        self.assertIn("b.wif: line ", said)
        self.assertIn("[WEAVING] Shafts=many: The number of shafts should stand here", said)
        (self.folder / "story.wif").write_text("You are in a maze of twisty little passages.\n")
        self.assertIn("story.wif: expected a WIF draft", self.run_program("convert", "story.wif", "c.json", status=1))

    def test_a_draft_is_drawn_for_print(self):
        fabric = self.fabric()
        self.run_program("convert", fabric, "a.pdf")
        self.assertTrue(self.bytes_of("a.pdf").startswith(b"%PDF-"))
        self.run_program("convert", fabric, "draft.png", "--draft")
        width, height, rows = read_png(self.folder / "draft.png")
        # 16 pixels a crossing, a margin of 16 and a title of 28; the drawdown is below bar, gap, threading and gap.
        left, top = 16 + 2 * 16, 16 + 28 + (2 + 4 + 1) * 16
        drawn = ["".join("#" if max(rows[top + 16 * y + 8][left + 16 * x + 8]) < 128 else "." for x in range(4))
                 for y in range(4)]
        self.assertEqual(drawn, SMALL["weave"])
        self.assertGreaterEqual(width, left + (4 + 1 + 4) * 16)
        self.assertIn("expected", self.run_program("convert", fabric, "no/such/folder/a.pdf", status=1))

    def test_other_formats_are_refused_by_name(self):
        fabric = self.fabric()
        for output in ("a.dtx", "a", "a.jpg"):
            message = self.run_program("convert", fabric, output, status=1)
            self.assertIn(output + ": expected", message)
            self.assertIn(".json", message)


main()
