"""Ctrl-C keeps what has been rendered, and it can be gone on with."""

import signal

from harness import HANGS_S, CommandLineTest, main, samples_said


class Interrupt(CommandLineTest):
    def start(self, output):
        """A picture in the making, of which there is some already, and which nobody lives to see finished."""
        words = ("render", self.fabric(), "-o", output, "--size", "64x48", "--spp", 1000000)
        return self.start_at_work("rendering", *words)

    def test_the_picture_so_far_can_be_finished(self):
        process = self.start("part.exr")
        process.send_signal(signal.SIGINT)
        said, _ = process.communicate(timeout=HANGS_S)
        self.assertEqual(process.returncode, 130)
        self.assertIn("stopped", said)
        # A stopped pass has given some pixels more samples than others, but at most about twice as many.
        samples = 3 * samples_said(said) + 8
        self.run_program("render", "--resume", "part.exr", "-o", "finished.exr", "--spp", samples)
        self.run_program("render", self.fabric(), "-o", "whole.exr", "--size", "64x48", "--spp", samples)
        self.assertEqual(self.bytes_of("finished.exr"), self.bytes_of("whole.exr"))

    def test_a_request_to_terminate_is_heeded_too(self):
        process = self.start("part.png")
        process.terminate()
        process.communicate(timeout=HANGS_S)
        self.assertEqual(process.returncode, 130)
        self.assertTrue((self.folder / "part.png").exists())


main()
