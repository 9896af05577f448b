"""Which processor the program needs: it starts on every one, and where AVX2 is missing says so in a line.

The dynamic loader and the program ask glibc what the processor has, and glibc can be told to deny a part of it
(GLIBC_TUNABLES), so that this shows on every machine. What only looks the same, an illegal instruction on the way to that
line, shows on an emulated processor, where there is one (package qemu-user-static). So does that pictures are the same
bytes on processors that round otherwise where they may, as in their estimates of 1 / x; and those of all fibres of a piece,
which are not, are told apart. That packages, which have libraries for both kinds, render the same bytes by each is for
tests/package_room."""

import functools
import os
import platform
import re
import shutil
import subprocess
import unittest

from harness import LOOMLIGHT, SMALL, CommandLineTest, main

WITHOUT_AVX2 = {**os.environ, "GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX2"}
EMULATOR = shutil.which("qemu-x86_64-static") or shutil.which("qemu-x86_64")
SANITIZED = "LOOMLIGHT_SANITIZED" in os.environ


@functools.cache
def another_maker_s(level):
    """Nothing where the emulator lacks what the program says that it needs. One that dies there is a failure."""
    another = (EMULATOR, "-cpu", "Nehalem" if level == "x86-64" else "Haswell")
    started = subprocess.run([*another, LOOMLIGHT, "--version"], capture_output=True, text=True)
    if started.returncode == 0:
        return another
    if "lacks AVX2" in started.stderr:
        return ()
    raise AssertionError(f"it does not start on an emulated processor: status {started.returncode}: {started.stderr}")


@unittest.skipUnless(platform.machine() == "x86_64", "about x86-64")
class Processor(CommandLineTest):
    def level(self, **options):
        """The instruction set of the library that the loader takes."""
        return re.search(r"^instruction set: (\S+)", self.run_program("--version", **options), re.MULTILINE)[1]

    def expect_line(self, **options):
        """What is said without AVX2: that pictures take longer, or, by a library that cannot do without, that it ends."""
        if self.level() == "x86-64":
            line = self.run_program("--version", messages=True, **options)
            self.assertIn("take", line)
        else:
            line = self.run_program("--version", status=1, **options)
            self.assertIn("LOOMLIGHT_LEVEL", line)
        self.assertRegex(line, r"^loomlight: this processor lacks AVX2[^\n]*\n$")

    def another_maker_s(self):
        """The words before a command by which it runs on an emulated processor, whose estimates are no maker's."""
        # QEMU 7.2 dies in a gather of AVX2 as Clang writes it (from 2 GB beyond its table, by negative indices), which
        # processors do.
        if self.level() != "x86-64" and "compiler: Clang" in self.run_program("--version"):
            self.skipTest("the emulator dies in gathers that Clang has compiled for AVX2")
        another = another_maker_s(self.level())
        if not another:
            self.skipTest("the emulator has no AVX2")
        return another

    def test_without_avx2(self):
        self.expect_line(env=WITHOUT_AVX2)

    @unittest.skipUnless(EMULATOR, "no emulator of processors is installed (package qemu-user-static)")
    @unittest.skipIf(SANITIZED, "sanitizers ask for more memory than the emulator gives")
    def test_on_a_processor_of_2008(self):
        self.expect_line(before=(EMULATOR, "-cpu", "Nehalem"))

    @unittest.skipUnless(EMULATOR, "no emulator of processors is installed (package qemu-user-static)")
    @unittest.skipIf(SANITIZED, "sanitizers ask for more memory than the emulator gives")
    def test_another_maker_s_processor_renders_the_same_bytes_but_of_a_tree_of_fibres(self):
        """In few runs, since to start the emulator takes longer than to render."""
        another = self.another_maker_s()
        drapes = ("flat", "cylinder", "folds")
        fabrics = [self.fabric(f"{drape}.json", drape={**SMALL["drape"], "kind": drape}) for drape in drapes]
        fibres = self.fabric("fibres.json", render={**SMALL["render"], "method": "fibres"})
        words = ("render", *fabrics, fibres, "--spp", 4, "--samples", 3, "-o")
        self.run_program(*words, "here_{}.exr")
        self.run_program(*words, "another_{}.exr", before=another)
        bricks = ("render", fibres, "--fibres-extent", "bricks", "--spp", 4, "-o")
        self.run_program(*bricks, "here_bricks.exr")
        self.run_program(*bricks, "another_bricks.exr", before=another)
        for name in (*drapes, "bricks"):
            with self.subTest(name):
                self.assertEqual(self.bytes_of(f"another_{name}.exr"), self.bytes_of(f"here_{name}.exr"))
        self.run_program("render", fibres, "--spp", 4, "--samples-from", 3, "-o", "rest.exr")
        self.run_program("merge", "here_fibres.exr", "rest.exr", "-o", "merged.exr")
        message = self.run_program("merge", "rest.exr", "another_fibres.exr", "-o", "refused.exr", status=1)
        self.assertIn("another_fibres.exr: expected samples of the same kind of processor as rest.exr", message)

    def test_with_avx2_nothing_is_said(self):
        if self.level() == "x86-64-v3":
            self.assertEqual(self.run_program("--version", messages=True), "")


main()
