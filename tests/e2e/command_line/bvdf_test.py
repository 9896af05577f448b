"""`bvdf` bakes local visibility: tables, the picture of Fig. 8, and a cache between runs."""

import os
import signal

from harness import HANGS_S, CommandLineTest, main, read_png


class Bvdf(CommandLineTest):
    def setUp(self):
        super().setUp()
        self.environment = {**os.environ, "XDG_CACHE_HOME": str(self.folder / "cache")}

    def bvdf(self, *words, status=0):
        return self.run_program("bvdf", *words, status=status, env=self.environment)

    def cached(self):
        return sorted((self.folder / "cache" / "loomlight" / "bvdf").glob("*"))

    def test_it_writes_tables_and_their_picture(self):
        said = self.bvdf(self.fabric(), "-o", "t.exr", "--rays", "100000")
        self.assertIn("2 tables", said)
        self.assertGreater(len(self.bytes_of("t.exr")), 10_000)
        width, height, rows = read_png(self.folder / "t.png")
        # A row of eight squares a table; white at the normal of the first, where light comes from the eye.
        self.assertAlmostEqual(width / height, 8 / 2, delta=0.3)
        self.assertGreater(rows[7][7][0], 240)
        self.assertLess(min(pixel[0] for row in rows for pixel in row), 150)

    def test_the_second_time_it_comes_from_the_cache_the_same(self):
        fabric = self.fabric()
        self.bvdf(fabric, "-o", "a.exr", "--rays", "100000")
        self.assertEqual(len(self.cached()), 1)
        kept = self.cached()[0].read_bytes()
        self.bvdf(fabric, "-o", "b.exr", "--rays", "100000", "--threads", "1")
        self.assertEqual(self.bytes_of("a.exr"), self.bytes_of("b.exr"))
        self.cached()[0].write_bytes(kept[: len(kept) // 2])
        self.bvdf(fabric, "-o", "c.exr", "--rays", "100000")
        self.assertEqual(self.bytes_of("a.exr"), self.bytes_of("c.exr"))
        self.assertEqual(self.cached()[0].read_bytes(), kept)

    def test_other_names_and_numbers_are_refused(self):
        fabric = self.fabric()
        self.assertIn("expected", self.bvdf(fabric, "-o", "t.txt", status=1))
        self.assertIn("--rays", self.bvdf(fabric, "-o", "t.exr", "--rays", "0", status=2))
        self.assertIn("missing.json", self.bvdf("missing.json", "-o", "t.exr", status=1))

    def test_an_interrupt_ends_it_and_leaves_nothing(self):
        program = self.start_at_work(
            "baking local visibility",
            *("bvdf", self.fabric(), "-o", "t.exr", "--rays", "100000000000"),
            env=self.environment,
        )
        program.send_signal(signal.SIGINT)
        self.assertEqual(program.wait(timeout=HANGS_S), 130)
        self.assertFalse((self.folder / "t.exr").exists())
        self.assertFalse((self.folder / "cache").exists())


main()
