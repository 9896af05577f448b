"""Ctrl-C keeps what has been rendered, and it can be gone on with."""

import signal
import subprocess
import time

from harness import LOOMLIGHT, CommandLineTest, main, samples_said


class Interrupt(CommandLineTest):
    def start(self, *words):
        process = subprocess.Popen(
            [LOOMLIGHT, "render", *map(str, words)],
            cwd=self.folder,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        self.assertIn("rendering", process.stderr.readline())
        return process

    def test_the_picture_so_far_can_be_finished(self):
        fabric = self.fabric()
        process = self.start(fabric, "-o", "part.exr", "--size", "64x48", "--spp", 1000000)
        time.sleep(1)
        process.send_signal(signal.SIGINT)
        said, _ = process.communicate(timeout=30)
        self.assertEqual(process.returncode, 130)
        self.assertIn("stopped", said)
        # A stopped pass has given some pixels more samples than others, but at most about twice as many.
        samples = 3 * samples_said(said) + 8
        self.run_program("render", "--resume", "part.exr", "-o", "finished.exr", "--spp", samples)
        self.run_program("render", fabric, "-o", "whole.exr", "--size", "64x48", "--spp", samples)
        self.assertEqual(self.bytes_of("finished.exr"), self.bytes_of("whole.exr"))

    def test_a_request_to_terminate_is_heeded_too(self):
        process = self.start(self.fabric(), "-o", "part.png", "--size", "64x48", "--spp", 1000000)
        process.terminate()
        process.communicate(timeout=30)
        self.assertEqual(process.returncode, 130)
        self.assertTrue((self.folder / "part.png").exists())


main()
