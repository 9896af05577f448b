"""Ctrl-C keeps what has been rendered, and it can be gone on with."""

import os
import signal
import subprocess

from harness import HANGS_S, LOOMLIGHT, ROOT, CommandLineTest, main, samples_said


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

    def test_a_part_of_a_farm_that_is_asked_to_end_is_gone_on_with(self):
        size, samples = "48x32", 1200
        words = [ROOT / "samples/farm/part", 0, 1, 1, self.fabric(), "out.exr", size, samples, "--threads", 1]
        part = subprocess.Popen(list(map(str, words)), cwd=self.folder, stdin=subprocess.DEVNULL,
                                stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                                env={**os.environ, "LOOMLIGHT": LOOMLIGHT}, start_new_session=True)
        self.addCleanup(part.stderr.close)
        # Said before the first sample. A line of progress comes after a second, when a quick machine is done.
        while f"rendering {size.replace('x', ' x ')}" not in (line := part.stderr.readline()):
            self.assertNotEqual(line, "", "it ended before it was stopped")
        os.killpg(part.pid, signal.SIGTERM)  # the script and the program alike, as Slurm does at a limit of time
        said = part.stderr.read()
        self.assertEqual(part.wait(timeout=HANGS_S), 130, said)
        parts = self.folder / "out.exr.parts"
        (kept,) = parts.iterdir()
        self.assertRegex(kept.name, r"^kept\.0\.[0-9a-f]{16}\.exr$", said)
        again = subprocess.run(list(map(str, words)), cwd=self.folder, stdin=subprocess.DEVNULL, capture_output=True,
                               env={**os.environ, "LOOMLIGHT": LOOMLIGHT}, timeout=HANGS_S, text=True)
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertEqual([file.name for file in parts.iterdir()], ["part.0.exr"])
        self.run_program("merge", "out.exr.parts/part.0.exr", "-o", "out.exr")
        self.run_program("render", self.fabric(), "-o", "whole.exr", "--size", size, "--spp", samples)
        self.assertEqual(self.bytes_of("out.exr"), self.bytes_of("whole.exr"))

    def test_a_part_of_a_farm_that_cannot_be_gone_on_with_is_begun_anew(self):
        """As it is on another kind of processor."""
        parts = self.folder / "out.exr.parts"
        parts.mkdir()
        (parts / "kept.0.another.exr").write_text("of another kind of processor")
        words = [ROOT / "samples/farm/part", 0, 1, 1, self.fabric(), "out.exr", "32x24", 2]
        ran = subprocess.run(list(map(str, words)), cwd=self.folder, stdin=subprocess.DEVNULL, capture_output=True,
                             env={**os.environ, "LOOMLIGHT": LOOMLIGHT}, timeout=HANGS_S, text=True)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertEqual([file.name for file in parts.iterdir()], ["part.0.exr"], ran.stderr)

    def test_jobs_of_slurm_take_names_of_every_kind(self):
        tools = self.folder / "tools"
        tools.mkdir()
        sbatch = tools / "sbatch"  # runs at once what Slurm would run later, by the same shell
        sbatch.write_text("""#!/bin/bash
            indices=0
            while (($#)); do
              case $1 in --array) indices=$2 ;; --wrap) job=$2 ;; esac
              shift
            done
            for index in ${indices//,/ }; do SLURM_ARRAY_TASK_ID=$index /bin/sh -c "$job" >&2; done
            echo 7
            """)
        sbatch.chmod(0o755)
        fabric = self.fabric("grün, d'or & $(false) `x`.json")
        words = [ROOT / "samples/farm/slurm_render", 1, 2, fabric, "ö's.exr", "32x24", 4, "--light", "sky"]
        plain = {key: value for key, value in os.environ.items() if not key.startswith(("LC_", "LANG"))}
        ran = subprocess.run(list(map(str, words)), cwd=self.folder, stdin=subprocess.DEVNULL, capture_output=True,
                             env={**plain, "LC_ALL": "C", "LOOMLIGHT": LOOMLIGHT, "PATH": f"{tools}:{os.environ['PATH']}"},
                             timeout=HANGS_S)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.run_program("render", fabric, "-o", "whole.exr", "--size", "32x24", "--spp", 4, "--light", "sky")
        self.assertEqual(self.bytes_of("ö's.exr"), self.bytes_of("whole.exr"))

    def test_a_farm_takes_up_no_parts_of_another_order(self):
        fabric = self.fabric("farmed.json")

        def check(*order):
            words = map(str, [ROOT / "samples/farm/part", "--check", *order])
            ran = subprocess.run(list(words), cwd=self.folder, stdin=subprocess.DEVNULL, capture_output=True, text=True)
            return ran.returncode, ran.stderr

        self.assertEqual(check(2, 2, fabric, "out.exr", "48x32", 8, "--seed", 3), (0, ""))
        self.assertEqual(check(2, 2, fabric, "out.exr", "48x32", 8, "--seed", 3), (0, ""), "the same once more")
        self.assertIn("parts of another order", check(2, 2, fabric, "out.exr", "48x32", 8, "--seed", 4)[1])
        edited = self.folder / fabric
        edited.write_text(edited.read_text().replace("ends_per_cm\": ", "ends_per_cm\": 1", 1))
        self.assertIn("parts of another order", check(2, 2, fabric, "out.exr", "48x32", 8, "--seed", 3)[1])
        self.assertIn("from 1 to 8 ranges", check(9, 2, fabric, "other.exr", "48x32", 8)[1])
        self.assertIn("from 1 to 32 strips", check(2, 33, fabric, "other.exr", "48x32", 8)[1])


main()
