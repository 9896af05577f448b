"""`convert` between fabrics and weave bitmaps."""

import json

from harness import SMALL, CommandLineTest, main, read_png


class Convert(CommandLineTest):
    def test_a_weave_survives_the_way_through_a_bitmap(self):
        self.run_program("convert", self.fabric(), "weave.png")
        width, height, rows = read_png(self.folder / "weave.png")
        self.assertEqual((width, height), (4, 4))
        drawn = ["".join("#" if max(pixel) < 128 else "." for pixel in row) for row in rows]
        self.assertEqual(drawn, SMALL["weave"])
        self.run_program("convert", "weave.png", "back.json")
        self.assertEqual(json.loads(self.bytes_of("back.json"))["weave"], SMALL["weave"])

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

    def test_a_picture_gives_its_fabric_back(self):
        self.run_program("render", self.fabric(), "-o", "picture.exr")
        self.run_program("convert", "picture.exr", "again.json")
        self.assertEqual(json.loads(self.bytes_of("again.json"))["name"], "small twill")

    def test_other_formats_are_refused_by_name(self):
        fabric = self.fabric()
        for output in ("a.wif", "a", "a.jpg"):
            message = self.run_program("convert", fabric, output, status=1)
            self.assertIn(output + ": expected", message)
            self.assertIn(".json", message)


main()
