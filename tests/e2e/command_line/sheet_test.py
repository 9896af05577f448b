"""`sheet`: the page that goes to a mill."""

from harness import CommandLineTest, main


class Sheet(CommandLineTest):
    def test_a_fabric_becomes_a_page(self):
        self.run_program("sheet", self.fabric(), "-o", "sheet.pdf", "--spp", "1", "--width", "140")
        self.assertTrue(self.bytes_of("sheet.pdf").startswith(b"%PDF-"))

    def test_colourways_have_a_page_of_their_own(self):
        self.run_program("sheet", self.fabric(), "-o", "ways.pdf", "--colourways", "--spp", "1")
        self.assertTrue(self.bytes_of("ways.pdf").startswith(b"%PDF-"))

    def test_it_is_a_pdf(self):
        self.assertIn(".pdf", self.run_program("sheet", self.fabric(), "-o", "sheet.txt", status=1))


main()
