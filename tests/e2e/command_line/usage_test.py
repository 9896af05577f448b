"""A wrong command line: status 2, and a message that names what is wrong."""

from harness import CommandLineTest, main


class Usage(CommandLineTest):
    def test_options_are_held_to_their_ranges(self):
        for option, value in (
            ("--size", "640"),
            ("--size", "0x10"),
            ("--size", "99999x10"),
            ("--spp", "0"),
            ("--spp", "many"),
            ("--seed", "-1"),
            ("--threads", "0"),
            ("--view", "sideways"),
            ("--drape", "cilinder"),
            ("--light", "moon"),
            ("--method", "magic"),
            ("--resolution", "3"),
            ("--max-depth", "0"),
            ("--event-law", "other"),
            ("--exposure", "nan"),
            ("--tone", "cinema"),
            ("--grain", "91"),
            ("--uv-scale", "0"),
        ):
            with self.subTest(option=option, value=value):
                message = self.run_program("render", "a.json", "-o", "a.png", option, value, status=2)
                self.assertIn(option + ": expected", message)
                self.assertIn(value, message)

    def test_words_that_are_missing_or_too_many(self):
        for words, said in (
            (("render", "a.json"), "--output"),
            (("render", "-o", "a.png"), "FABRIC"),
            (("render", "a.json", "b.json", "-o", "a.png"), "b.json"),
            (("render", "a.json", "-o", "a.png", "--colour", "red"), "--colour"),
            (("info",), "FABRIC"),
            (("convert", "a.json"), "OUT"),
            (("bench", "races", "a.json"), "races"),
        ):
            with self.subTest(words=words):
                self.assertIn(said, self.run_program(*words, status=2))

    def test_help_and_version(self):
        self.assertIn("render", self.run_program("--help"))
        self.assertIn("--resolution", self.run_program("render", "--help"))

    def test_version_says_what_was_built_of_what(self):
        lines = self.run_program("--version").splitlines()
        self.assertRegex(lines[0], r"^loomlight \d+\.\d+\.\d+$")
        facts = dict(line.split(": ", 1) for line in lines[1:])
        said = ["commit", "compiler", "instruction set", "vectors", "kind of processor", "libraries"]
        self.assertEqual(list(facts), said)
        self.assertRegex(facts["commit"], r"^([0-9a-f]{7,40}(-dirty)?|unknown)$")
        self.assertRegex(facts["compiler"], r"^(GCC|Clang) \d+\.\d+")
        self.assertRegex(facts["instruction set"], r"^(x86-64|AArch64)")
        # Found out on this processor: never less than what the build needs.
        self.assertRegex(facts["vectors"], r"^AVX[23]" if "AVX2" in facts["instruction set"] else r"^[A-Z0-9_]+$")
        self.assertRegex(facts["kind of processor"], r"^[0-9a-f]{16}$")
        libraries = facts["libraries"].split(", ")
        for library in libraries:
            self.assertRegex(library, r"^\S.* \d+\.\d+[.\d]*$")
        names = {library.rsplit(" ", 1)[0] for library in libraries}
        self.assertLessEqual({"Embree", "oneTBB", "Highway", "OpenEXR", "OpenMesh", "GLM", "fmt", "CLI11", "cairo", "qpdf",
                              "Little CMS", "libpng", "pugixml", "zlib", "libzip"}, names)
        if "edit" in self.run_program("--help").split():
            self.assertLessEqual({"Dear ImGui", "GLFW", "FreeType"}, names)


main()
