"""A picture is a function of fabric, settings, seed and samples: the same bytes, however it came about."""

from harness import CommandLineTest, main

# 4 mm x 4 mm, with texture coordinates in mm.
SQUARE = """v -2 -2 0\nv 2 -2 0\nv 2 2 0\nv -2 2 0
vt 0 0\nvt 4 0\nvt 4 4\nvt 0 4
f 1/1 2/2 3/3\nf 1/1 3/3 4/4
"""


class Reproduce(CommandLineTest):
    def setUp(self):
        super().setUp()
        drape = {"kind": "cylinder", "width_mm": 4, "height_mm": 4, "radius_mm": 3}
        self.cloth = self.fabric(drape=drape, light={"kind": "sky"})

    def render(self, output, *options):
        self.run_program("render", self.cloth, "-o", output, "--spp", 7, *options)
        return self.bytes_of(output)

    def test_any_number_of_threads(self):
        one = self.render("1.exr", "--threads", 1)
        self.assertEqual(one, self.render("2.exr", "--threads", 2))
        self.assertEqual(one, self.render("3.exr", "--threads", 3))

    def test_another_seed_is_another_picture(self):
        self.assertNotEqual(self.render("1.exr"), self.render("2.exr", "--seed", 2))

    def test_samples_split_over_runs(self):
        whole = self.render("whole.exr", "--keep-sums")
        self.run_program("render", self.cloth, "-o", "a.exr", "--spp", 3, "--keep-sums", "--threads", 1)
        self.run_program("render", self.cloth, "-o", "b.exr", "--spp", 5, "--keep-sums", "--resume", "a.exr")
        self.assertEqual(whole, self.render("c.exr", "--keep-sums", "--resume", "b.exr"))
        # Without sums the picture is the same as well, only smaller.
        slim = self.render("slim.exr")
        self.assertEqual(slim, self.render("d.exr", "--resume", "b.exr"))
        self.assertLess(len(slim), len(whole))

    def test_going_on_needs_no_fabric(self):
        self.run_program("render", self.cloth, "-o", "a.exr", "--spp", 3, "--keep-sums")
        self.run_program("render", "--resume", "a.exr", "-o", "b.exr", "--spp", 7)
        self.assertEqual(self.render("whole.exr"), self.bytes_of("b.exr"))

    def test_going_on_with_another_picture_is_refused(self):
        self.run_program("render", self.cloth, "-o", "a.exr", "--spp", 3, "--keep-sums")
        message = self.run_program(
            "render", self.cloth, "-o", "b.exr", "--spp", 7, "--seed", 9, "--resume", "a.exr", status=1
        )
        self.assertIn("a.exr", message)
        self.assertIn("seed", message)
        message = self.run_program("render", "--resume", "a.exr", "-o", "b.exr", "--spp", 3, status=2)
        self.assertIn("--spp", message)
        self.run_program("render", self.cloth, "-o", "slim.exr", "--spp", 3)
        message = self.run_program("render", "--resume", "slim.exr", "-o", "b.exr", "--spp", 7, status=1)
        self.assertIn("slim.exr", message)

    def test_going_on_with_other_files_or_fibres_is_refused(self):
        """What a fabric's files held when the first samples were traced is on record, whatever they are called."""
        mesh, lamp = self.folder / "mesh.obj", self.folder / "lamp.txt"
        even = "380 1\n780 1\n"
        fibres = ("--method", "fibres", "--drape", "flat", "--fibres-extent")
        for said, change, before, after in (
            ("mesh", (mesh, SQUARE.replace("v 2 2 0", "v 2 2 1")), ("--drape", mesh), ("--drape", mesh)),
            ("lamps", (lamp, "380 1\n780 2\n"), ("--illuminant", lamp), ("--illuminant", lamp)),
            ("fibres", None, (*fibres, "piece"), (*fibres, "bricks")),
        ):
            with self.subTest(said=said):
                mesh.write_text(SQUARE)
                lamp.write_text(even)
                render = ("render", self.cloth, "--view", "0,60,14", "--keep-sums")
                self.run_program(*render, "-o", "a.exr", "--spp", 2, *before)
                goes_on = (*render, "-o", "b.exr", "--spp", 3, "--resume", "a.exr", *after)
                if change:
                    self.run_program(*goes_on)
                    change[0].write_text(change[1])
                message = self.run_program(*goes_on, status=1)
                self.assertIn("a.exr", message)
                self.assertIn(said, message)

    def test_a_picture_renders_itself_again(self):
        first = self.render("first.exr", "--light", "directional:-60,40", "--view", "20,40", "--resolution", 1)
        self.cloth.unlink()
        self.run_program("render", "first.exr", "-o", "second.exr")
        self.assertEqual(first, self.bytes_of("second.exr"))

    def test_a_picture_knows_its_mesh_from_anywhere(self):
        (self.folder / "there").mkdir()
        (self.folder / "there/mesh.obj").write_text(SQUARE)
        there = ("--drape", "there/mesh.obj")
        for picture in ("there/beside.exr", "apart.exr"):
            with self.subTest(picture=picture):
                self.run_program("render", self.cloth, "-o", picture, *there, "--keep-sums", "--spp", 2)
                (self.folder / "elsewhere").mkdir(exist_ok=True)
                again = self.folder / picture.replace(".exr", "-again.exr")
                words = ("render", self.folder / picture, "-o", again)
                self.run_program(*words, "--keep-sums", cwd=self.folder / "elsewhere")
                self.assertEqual(self.bytes_of(picture), again.read_bytes())
                # The same mesh by another name is still the same picture's.
                self.run_program("render", self.cloth, *there, "--spp", 3, "--resume", picture, "-o", "more.exr")


main()
