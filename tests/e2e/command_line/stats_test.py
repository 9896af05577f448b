"""`--stats` and `bench` report counts and times of every stage."""

import json

from harness import CommandLineTest, main


class Stats(CommandLineTest):
    def test_a_render_reports_every_stage(self):
        self.run_program("render", self.fabric(), "-o", "a.png", "--threads", 2, "--stats", "stats.json")
        stats = json.loads(self.bytes_of("stats.json"))
        self.assertEqual(
            {key: stats[key] for key in ("method", "width", "height", "samples_per_pixel", "threads")},
            {"method": "volume", "width": 32, "height": 24, "samples_per_pixel": 4, "threads": 2},
        )
        self.assertEqual(set(stats["seconds"]), {"geometry", "voxelise", "accelerate", "bvdf", "render", "total"})
        self.assertEqual(
            set(stats["counts"]),
            {"segments", "bricks", "voxels", "components", "paths", "events", "rays", "steps"},
        )
        self.assertEqual(set(stats["bytes"]), {"geometry", "accelerator", "volume", "bvdf", "peak_rss"})
        counts, seconds = stats["counts"], stats["seconds"]
        self.assertEqual(counts["paths"], 32 * 24 * 4)
        self.assertGreater(counts["events"], 0)
        self.assertGreaterEqual(counts["rays"], counts["events"])
        self.assertGreaterEqual(counts["components"], counts["voxels"])
        self.assertGreater(counts["segments"], 0)
        self.assertGreater(stats["bytes"]["volume"], 0)
        self.assertGreater(stats["bytes"]["peak_rss"], stats["bytes"]["volume"])
        self.assertGreaterEqual(seconds["total"] + 1e-9, sum(seconds[key] for key in seconds if key != "total"))

    def test_bench_measures_every_resolution(self):
        words = ("bench", "volume", self.fabric(), "--rounds", 1, "--resolutions", "1,2,4")
        rows = json.loads(self.run_program(*words, "--json"))
        self.assertEqual([row["resolution"] for row in rows], [1, 2, 4])
        for coarse, fine in zip(rows, rows[1:]):
            self.assertGreater(fine["voxels"], coarse["voxels"])
        for row in rows:
            self.assertGreater(row["paths_per_second_per_core"], 0)
        table = self.run_program(*words).splitlines()
        self.assertEqual(len(table), 2 + 3)
        self.assertEqual(len({line.count("|") for line in table}), 1)


main()
