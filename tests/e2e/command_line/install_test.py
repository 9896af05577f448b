"""`cmake --install` makes a tree that can be moved, and what it says of the program is true of it."""

import os
import re
import subprocess

from harness import HANGS_S, LOOMLIGHT, ROOT, CommandLineTest, main, read_png

BUILD = os.environ["LOOMLIGHT_BUILD"]
COMMAND = re.compile(r"^  ([a-z]\w*) ", re.MULTILINE)


def commands_in_help():
    said = subprocess.run([LOOMLIGHT, "--help"], stdout=subprocess.PIPE, text=True, check=True).stdout
    return COMMAND.findall(said[said.index("Subcommands:"):])


class Install(CommandLineTest):
    def install(self, prefix):
        subprocess.run(["cmake", "--install", BUILD, "--prefix", str(prefix)], stdout=subprocess.DEVNULL, check=True)

    def run_in(self, prefix, *words):
        done = subprocess.run([prefix / "bin" / "loomlight", *words], cwd=self.folder, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, timeout=HANGS_S)
        self.assertEqual(done.returncode, 0, done.stdout)
        return done.stdout

    def test_an_installed_tree_can_be_moved(self):
        first, second = self.folder / "here", self.folder / "some where else"
        self.install(first)
        self.assertIn(str(first / "share/loomlight/samples"), self.run_in(first, "--help"))
        first.rename(second)
        self.assertIn(str(second / "share/loomlight/samples"), self.run_in(second, "--help"))
        samples = second / "share" / "loomlight" / "samples"
        for folder in (samples, samples / "cloths", samples / "swatches"):
            self.assertEqual({file.name for file in folder.iterdir() if file.is_file()},
                             {file.name for file in (ROOT / folder.relative_to(samples.parent)).iterdir() if file.is_file()})
        self.run_in(second, "render", str(samples / "denim.json"), "-o", "a.png", "--size", "32x24", "--spp", "1",
                    "--drape", str(samples / "folded_cloth.obj"))
        link = self.folder / "loomlight"
        link.symlink_to(second / "bin" / "loomlight")
        done = subprocess.run([link, "--help"], stdout=subprocess.PIPE, text=True, check=True)
        self.assertIn(str(samples), done.stdout)

    def test_a_program_alone_works_and_names_no_samples(self):
        self.install(self.folder)
        (self.folder / "share" / "loomlight" / "samples").rename(self.folder / "elsewhere")
        self.assertNotIn("begin with", self.run_in(self.folder, "--help"))

    def test_the_manual_knows_every_command(self):
        manual = (ROOT / "app" / "package" / "loomlight.1.in").read_text()
        described = re.findall(r"^\.TP\n\.B (\w+)$", manual, re.MULTILINE)
        self.assertEqual(described, commands_in_help())


class Thumbnail(CommandLineTest):
    def test_it_is_a_png_whatever_its_name(self):
        fabric = self.fabric("cloth.loomlight")
        self.run_program("thumbnail", fabric, "-o", "picture", "--size", "64")
        width, height, rows = read_png(self.folder / "picture")
        self.assertEqual((width, height), (64, 64))
        # A balanced twill of a blue warp and a white weft: half of it is each.
        colours = {}
        for row in rows:
            for pixel in row:
                colours[pixel] = colours.get(pixel, 0) + 1
        self.assertEqual(sorted(colours.values()), [32 * 64, 32 * 64])
        blue, white = sorted(colours, key=sum)
        # As the cloth shows them: each with some light of the other.
        self.assertGreater(blue[2], 1.3 * blue[0])
        self.assertGreater(white[0], blue[0] + 32)

    def test_it_says_what_is_wrong(self):
        (self.folder / "broken.loomlight").write_text("{")
        self.assertIn("broken.loomlight", self.run_program("thumbnail", "broken.loomlight", "-o", "a", status=1))
        self.assertFalse((self.folder / "a").exists())


if __name__ == "__main__":
    main()
