"""Many pictures of one command: turns of the camera and the light, lists of fabrics, progress for other programs."""

import json
import os
import signal

from harness import HANGS_S, SMALL, CommandLineTest, main


class Batch(CommandLineTest):
    def test_frames_are_the_pictures_that_they_name(self):
        light = {"kind": "sky", "azimuth_deg": 100, "elevation_deg": 30}
        cloth = self.fabric(light=light)
        self.run_program("render", cloth, "-o", "light.####.exr", "--turn", "light:4,80", "--frames", "2..3")
        self.assertEqual(sorted(file.name for file in self.folder.glob("light*")), ["light.0002.exr", "light.0003.exr"])
        self.run_program("render", cloth, "-o", "alone.exr", "--light", "sky:140,30")
        self.assertEqual(self.bytes_of("light.0003.exr"), self.bytes_of("alone.exr"))

        self.run_program("render", cloth, "-o", "camera.#.exr", "--turn", "camera:2", "--method", "fibres")
        turned = self.fabric(camera={**SMALL["camera"], "azimuth_deg": 90}, light=light)
        self.run_program("render", turned, "-o", "alone.exr", "--method", "fibres")
        self.assertEqual(self.bytes_of("camera.2.exr"), self.bytes_of("alone.exr"))

    def test_frames_need_their_place_in_the_name(self):
        message = self.run_program("render", self.fabric(), "-o", "a.png", "--turn", "camera:3", status=2)
        self.assertIn("####", message)
        self.assertIn("--turn", self.run_program("render", self.fabric(), "-o", "#.png", "--frames", "1..2", status=2))
        words = ("render", self.fabric(), "-o", "#.png", "--turn", "light", "--light", "dome")
        self.assertIn("direction", self.run_program(*words, status=2))

    def test_a_list_goes_on_after_errors(self):
        for name in ("one.json", "two.json"):
            self.fabric(name)
        (self.folder / "bad.json").write_text("{")
        (self.folder / "list.txt").write_text("# ours\none.json\nbad.json\nabsent.json\n\n")
        words = ("render", "two.json", "--list", "list.txt", "-o", "{}.png", "--stats", "{}.stats.json")
        done = self.run_both(*words, status=1)
        self.assertIn("2 of 4 pictures rendered", done.stdout)
        self.assertIn("failed: bad.png\nfailed: absent.png", done.stdout)
        for said in ("picture 1 of 4: two.png", "picture 4 of 4", "bad.json: ", "absent.json: "):
            self.assertIn(said, done.stderr)
        self.assertEqual(self.bytes_of("one.png"), self.bytes_of("two.png"))
        self.assertTrue((self.folder / "one.stats.json").exists())
        self.assertIn("2 of 2", self.run_program("render", "one.json", "two.json", "-o", "{}.png"))

    def test_a_list_goes_on_after_an_option_that_does_not_fit_a_fabric(self):
        """But not after one that fits none: nothing is rendered then."""
        sky = {"kind": "sky", "azimuth_deg": 100, "elevation_deg": 30}
        small = {**SMALL["render"], "width": 16, "samples_per_pixel": 2}
        self.fabric("first.json", light=sky)
        self.fabric("second.json", light={"kind": "dome"}, render=small)
        self.fabric("third.json", light=sky)
        fabrics = ("first.json", "second.json", "third.json")
        for options, said in (
            (("--turn", "light:2"), "second.json: --turn light: expected"),
            (("--crop", "10,10,8x8"), "second.json: --crop: expected"),
            (("--samples-from", 3), "second.json: --samples-from: expected"),
            (("--samples", 3), "second.json: --samples: expected"),
        ):
            with self.subTest(options=options):
                frames = 2 if "--turn" in options else 1
                pattern = "{}." + options[0] + (".#" if frames > 1 else "") + ".exr"
                done = self.run_both("render", *fabrics, "-o", pattern, *options, status=1)
                self.assertIn(f"{2 * frames} of {3 * frames} pictures rendered", done.stdout)
                self.assertIn("failed: second.", done.stdout)
                self.assertIn(said, done.stderr)
                pictures = sorted({file.name.split(".")[0] for file in self.folder.glob(f"*{options[0]}*.exr")})
                self.assertEqual(pictures, ["first", "third"])
        for options in (
            ("--turn", "light:2", "--light", "dome"),
            ("--size", "16x16", "--crop", "10,10,8x8"),
            ("--spp", 3, "--samples-from", 3),
            ("--spp", 3, "--samples", 4),
        ):
            with self.subTest(options=options):
                done = self.run_both("render", *fabrics, "-o", "{}.none.#.exr", *options, status=2)
                self.assertNotIn("picture 1 of", done.stderr)
                self.assertEqual(list(self.folder.glob("*.none.*")), [])
        alone = ("render", "second.json", "-o", "#.exr", "--turn", "light:2")
        self.assertIn("direction", self.run_program(*alone, status=2), "there is no other fabric that it could fit")

    def test_a_list_may_name_files_that_begin_like_its_remarks(self):
        self.fabric("#4 twill.json")
        (self.folder / "list.txt").write_text("#4 twill.json is a remark\n./#4 twill.json\n")
        self.run_program("render", "--list", "list.txt", "-o", "{}.png")
        self.assertEqual([file.name for file in self.folder.glob("*.png")], ["#4 twill.png"])

    def test_no_picture_is_written_over_another(self):
        os.mkdir(self.folder / "other")
        self.fabric("one.json")
        self.fabric("other/one.json")
        message = self.run_program("render", "one.json", "other/one.json", "-o", "{}.png", status=2)
        for said in ("one.json", "other/one.json", "one.png"):
            self.assertIn(said, message)

    def test_no_figures_are_written_over_others(self):
        one, other = self.fabric("one.json"), self.fabric("other.json")
        several = ("render", one, other, "-o", "{}.png", "--stats", "s.json")
        turned = ("render", one, "-o", "#.png", "--turn", "camera:2", "--stats", "{}.s.json")
        for words, said in ((several, "{}"), (turned, "####"),
                            (("render", one, "-o", "a.png", "--stats", "a.png"), "a.png")):
            with self.subTest(words=words):
                message = self.run_program(*words, status=2)
                self.assertIn("--stats: expected", message)
                self.assertIn(said, message)
                self.assertEqual(list(self.folder.glob("*.png")), [])

    def test_progress_is_json_a_line(self):
        done = self.run_both("render", self.fabric(), "-o", "a.png", "--progress", "json")
        lines = [json.loads(line) for line in done.stderr.splitlines() if line.startswith("{")]
        rendering = [line for line in lines if line["stage"] == "rendering"]
        fractions = [line["fraction"] for line in rendering]
        self.assertEqual(fractions, sorted(fractions))
        self.assertEqual(fractions[-1], 1)
        self.assertEqual(set(rendering[-1]), {"stage", "fraction", "elapsed_s", "left_s"})
        self.assertEqual(lines[-1]["stage"], "written")
        self.assertEqual((lines[-1]["output"], lines[-1]["complete"]), ("a.png", True))

    def test_a_picture_that_fails_is_an_event_too(self):
        self.fabric("first.json")
        (self.folder / "second.json").write_text("{")
        self.fabric("third.json")
        done = self.run_both("render", "first.json", "second.json", "third.json", "-o", "{}.png", "--progress", "json",
                             status=1)
        self.assertTrue(all(line.startswith("{") for line in done.stderr.splitlines()), done.stderr)
        events = [json.loads(line) for line in done.stderr.splitlines()]
        begun = [(event["number"], event["of"], event["output"]) for event in events if event["stage"] == "picture"]
        self.assertEqual(begun, [(1, 3, "first.png"), (2, 3, "second.png"), (3, 3, "third.png")])
        ended = [(event["stage"], event["output"]) for event in events if event["stage"] in ("written", "failed")]
        self.assertEqual(ended, [("written", "first.png"), ("failed", "second.png"), ("written", "third.png")])
        (failed,) = [event for event in events if event["stage"] == "failed"]
        self.assertIn("second.json", failed["error"])

    def test_ctrl_c_ends_the_whole_list(self):
        self.fabric("one.json")
        self.fabric("two.json")
        words = ("render", "one.json", "two.json", "-o", "{}.exr", "--spp", 1000000)
        program = self.start_at_work("rendering", *words)
        program.send_signal(signal.SIGINT)
        said, _ = program.communicate(timeout=HANGS_S)
        self.assertEqual(program.returncode, 130)
        self.assertIn("stopped in picture 1 of 2", said)
        self.assertTrue((self.folder / "one.exr").exists())
        self.assertFalse((self.folder / "two.exr").exists())


main()
