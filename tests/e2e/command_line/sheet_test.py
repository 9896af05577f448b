"""`sheet`: the page that goes to a mill."""

from harness import CommandLineTest, main


class Sheet(CommandLineTest):
    def test_colourways_have_a_page_of_their_own(self):
        self.run_program("sheet", self.fabric(), "-o", "ways.pdf", "--colourways", "--spp", "1")
        self.assertTrue(self.bytes_of("ways.pdf").startswith(b"%PDF-"))

    def test_it_judges_by_standards(self):
        for name in ("book.csv", "a=b.csv"):
            rows = ["nm (%),navy,brown"] + [f"{nm},5,{nm / 20}" for nm in range(400, 710, 20)]
            (self.folder / name).write_text("\n".join(rows))
        words = ("sheet", self.fabric(), "-o", "sheet.pdf", "--spp", "1", "--width", "140")
        standards = ("--standard", "book.csv:brown", "--standard", "blue=book.csv:navy", "--standard", "warp=a=b.csv")
        said = self.run_both(*words, *standards, "--tolerance", "2")
        self.assertIn("a=b.csv: the first of 2 swatches is taken", said.stderr)
        self.assertTrue(self.bytes_of("sheet.pdf").startswith(b"%PDF-"))
        for standard, expected in (
            ("red=book.csv", "--standard: expected one of the fabric's yarns and fibres"),
            ("book.csv:red", "expected one of its swatches, 'navy', 'brown'; got 'red'"),
            ("none.csv", "none.csv"),
            ("blue=none.csv", "none.csv"),
        ):
            with self.subTest(standard=standard):
                self.assertIn(expected, self.run_program(*words, "--standard", standard, status=1))
        self.run_program(*words, "--colourways", "--standard", "book.csv", status=2)

    def test_a_draft_has_the_sett_of_its_file_where_that_is_asked_for(self):
        self.run_program("convert", self.fabric(ends_per_cm=31, picks_per_cm=27), "draft.wif")
        self.run_program("convert", "draft.wif", "sized.json", "--wif-sizes", "file")

        def page(source, sizes):
            self.run_program("sheet", source, "--wif-sizes", sizes, "--colourways", "-o", "page.pdf", "--spp", "1")
            return self.bytes_of("page.pdf")

        as_its_file_says = page("draft.wif", "file")
        self.assertEqual(as_its_file_says, page("sized.json", "file"))
        self.assertNotEqual(as_its_file_says, page("draft.wif", "keep"))

    def test_it_is_a_pdf(self):
        self.assertIn(".pdf", self.run_program("sheet", self.fabric(), "-o", "sheet.txt", status=1))


main()
