"""`trace`: the path of one sample of one pixel, in words."""

from harness import CommandLineTest, main


class Trace(CommandLineTest):
    def test_it_tells_the_path_that_a_picture_holds(self):
        fabric = self.fabric()
        told = self.run_program("trace", fabric, "--pixel", "16,12", "--sample", "3", "--light", "dome")
        lines = told.splitlines()
        self.assertTrue(lines[0].startswith("pixel 16,12 of 32 x 24, sample 3, "), lines[0])
        self.assertTrue(lines[1].startswith("event 1: "), told)
        self.assertIn("sum ", told)
        self.run_program("render", fabric, "-o", "picture.exr", "--light", "dome")
        again = self.run_program("trace", "picture.exr", "--pixel", "16,12", "--sample", "3")
        self.assertEqual(again, told)
        other = self.run_program("trace", "picture.exr", "--pixel", "16,12", "--sample", "4")
        self.assertNotEqual(other.splitlines()[1:], lines[1:])

    def test_a_pixel_or_sample_that_is_not_there_is_one_clear_line(self):
        fabric = self.fabric()
        for words, said in (
            (("--pixel", "32,0", "--sample", "0"), "--pixel: expected X from 0 to 31 and Y from 0 to 23, got 32,0"),
            (("--pixel", "middle", "--sample", "0"), "--pixel: expected X,Y"),
            (("--pixel", "-1,0", "--sample", "0"), "--pixel: expected X,Y"),
            (("--pixel", "1,1", "--sample", "-1"), "--sample: expected"),
            (("--pixel", "1,1", "--sample", "1048576"), "--sample: expected"),
            (("--pixel", "1,1"), "--sample"),
        ):
            with self.subTest(words=words):
                message = self.run_program("trace", fabric, *words, status=2)
                self.assertIn(said, message)
                self.assertEqual(len(message.splitlines()), 2, "the other says where to find help")


main()
