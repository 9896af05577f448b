"""What people call beside app/run: words that nobody knows, what cannot be tried here, and how a night is judged."""

import os
import re
import shutil
import signal
import subprocess
import time
import unittest
from pathlib import Path

from harness import HANGS_S, ROOT, main
from small_tree import SmallTree


class TestsRun(SmallTree):
    """tests/run, whose words are looked at before anything else is done."""

    TOOLS = {"dpkg-query": "touch asked; printf installed"}

    def refusal(self, *words):
        done = self.run_script("tests/run", *words)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertFalse((self.folder / "asked").exists(), "packages were looked at first")
        (line,) = done.stderr.splitlines()
        return line

    def test_an_option_without_its_value(self):
        for option in ("--preset", "-L", "-R", "--repeat"):
            for words in ((option,), ("-E", "volume", option)):
                with self.subTest(words=words):
                    self.assertEqual(self.refusal(*words), f"loomlight: {option} takes a value")

    def test_a_word_that_is_no_option(self):
        for words, wrong in ((("volume",), "volume"), (("-R", "volume", "threads"), "threads"),
                             (("--schedule-random", "volume"), "volume"), (("--labl", "quick"), "--labl"),
                             (("-R=volume",), "-R=volume"), (("-R", "volume", "--schedule-randm"), "--schedule-randm")):
            with self.subTest(words=words):
                self.assertIn(f'"{wrong}" is no option', self.refusal(*words))

    def test_options_are_handed_on_with_their_values(self):
        self.tool("cmake", "touch .build/checked/build.ninja")
        self.tool("ninja", "exit 0")
        self.tool("ctest", 'echo "$@" >>calls; echo "Total Tests: 3"')
        done = self.run_script("tests/run", "--preset=checked", "-R", "-volume", "--schedule-random", "-j4", "--label-regex",
                               "quick", "--repeat", "until-fail:2")
        self.assertEqual(done.returncode, 0, done.stderr)
        last = (self.folder / "calls").read_text().splitlines()[-1]
        self.assertRegex(last, r"^--preset checked -j \d+ -R -volume --schedule-random -j4 -L quick --repeat until-fail:2$")

    def test_words_that_choose_no_test(self):
        self.tool("cmake", "touch .build/release/build.ninja")
        self.tool("ninja", "exit 0")
        self.tool("ctest", 'echo "$@" >>calls; echo "Total Tests: 0"')
        done = self.run_script("tests/run", "-R", "nothing")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("no test of preset release is chosen by: -R nothing; tests/run -N lists all", done.stderr.splitlines()[-1])
        self.assertEqual((self.folder / "calls").read_text().count("\n"), 1, "none is to run")

    def test_an_unknown_preset(self):
        for words in (("--preset", "fast"), ("--preset=fast",)):
            self.assertRegex(self.refusal(*words), '"fast"; there are: release .*clang')

    def test_an_unknown_label_is_told_those_that_there_are(self):
        line = self.refusal("-L", "quik")
        self.assertIn('"quik"', line)
        said = subprocess.run(["ctest", "--test-dir", os.environ["LOOMLIGHT_BUILD"], "--print-labels"], check=True,
                              stdout=subprocess.PIPE, text=True).stdout
        given = {label for labels in re.findall(r"^  ([a-z-]+)$", said, re.MULTILINE) for label in labels.split("-")}
        self.assertLessEqual(given, set(line.split("the labels are: ")[1].split()))

    def test_a_list_of_tests_is_made_once_and_judges_nothing(self):
        self.tool("cmake", "touch .build/release/build.ninja")
        self.tool("ninja", "exit 0")
        self.tool("ctest", 'echo "$@" >>calls; echo "Total Tests: 3"')
        for words in (("-N",), ("-R", "volume", "-N"), ("--show-only=json-v1",), ("--print-labels",)):
            with self.subTest(words=words):
                (self.folder / "calls").unlink(missing_ok=True)
                done = self.run_script("tests/run", *words)
                self.assertEqual((done.returncode, done.stdout), (0, "Total Tests: 3\n"), done.stderr)
                self.assertEqual((self.folder / "calls").read_text(), f"--preset release {' '.join(words)}\n")
                self.assertNotIn("passed", done.stderr)


class OtherScripts(SmallTree):
    """What the gates and the fuzzers are not called with is said in a line, before anything else is done."""

    TOOLS = {"dpkg-query": "touch asked; printf installed"}

    def test_a_word_that_they_do_not_know(self):
        (self.folder / "tests/fuzz/corpus/drafts").mkdir(parents=True)
        for name in ("tests/gates", "tests/fuzz/run", "tests/handover/run", "app/package/make", ".ci/run", "tests/room.sh",
                     "tests/jobs.sh"):
            (self.folder / name).parent.mkdir(exist_ok=True)
            shutil.copy(ROOT / name, self.folder / name)
        subprocess.run(["git", "init", "--quiet"], cwd=self.folder, check=True)
        for words, said in (
            (("tests/gates", "speling"), 'no gate is called "speling"; there are: format arrows names'),
            (("tests/gates", "--since", "yesterday"), 'no commit is called "yesterday"'),
            (("tests/gates", "--since"), 'no commit is called ""'),
            (("tests/gates", "--most", "few"), "--most takes a number of files"),
            (("tests/fuzz/run", "draughts"), 'no fuzzer is called "draughts"; there are: tests/fuzz/corpus/drafts'),
            (("tests/fuzz/run", ""), 'no fuzzer is called ""'),
            (("tests/fuzz/run", "../corpus/drafts"), 'no fuzzer is called "../corpus/drafts"'),
            (("tests/handover/run", "--keep", "x", "--blender"),
             "usage: tests/handover/run [--loomlight PROGRAM] [--u3m-schema FILE] [--python PROGRAM] [--keep FOLDER]; "
             '"--blender" is none of these'),
            (("tests/handover/run", "--keep"), "--keep: expected a name"),
            (("app/package/make", "trixie"), 'app/package/make takes no words, got "trixie"'),
            ((".ci/run", "quick"), '.ci/run takes no words, got "quick"'),
            (("tests/fuzz/run", "--runs", "0"), '--runs: expected a number, got "0"'),
            (("tests/fuzz/run", "--seed"), '--seed: expected a number, got ""'),
        ):
            with self.subTest(words=words):
                done = self.run_script(*words)
                self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
                (line,) = done.stderr.splitlines()
                self.assertTrue(line.startswith(f"loomlight: {said}"), line)
                self.assertFalse((self.folder / "asked").exists(), "packages were looked at first")


class WaitsForProcesses(SmallTree):
    def soon(self, what, condition):
        """A process that is told to end does so when the machine has time for it."""
        for _ in range(int(HANGS_S / 0.05)):
            if condition():
                return
            time.sleep(0.05)
        self.fail(f"waited in vain until {what}")

    def process_said(self, folder, name):
        """The first process that a file of that name tells, as soon as it is told."""
        said = lambda: "".join(file.read_text() for file in folder.glob(name))
        self.soon("a process is begun", lambda: said().endswith("\n"))
        return int(said())


class ScriptOfScripts(WaitsForProcesses):
    """One that calls others: each writes down that it was called, and ends as it is told to."""

    def setUp(self):
        super().setUp()
        for name in (self.SCRIPT, "tests/jobs.sh"):
            (self.folder / name).parent.mkdir(exist_ok=True)
            shutil.copy(ROOT / name, self.folder / name)
        for script in self.CALLED:
            self.ends_with(script, 0)

    def ends_with(self, script, status, words=""):
        """Where it is called with these words; without any, with whatever words."""
        file = self.folder / script
        file.parent.mkdir(exist_ok=True)
        file.write_text(f'#!/bin/bash\necho "$0 $*" >>calls\n[[ "{words}" && "$*" != "{words}" ]] || exit {status}\n')
        file.chmod(0o755)

    def expect_end_with_it(self, called, stop, status, *words):
        """What it has called, and what that has called in its turn, ends when the script is told to."""
        (self.folder / called).write_text("#!/bin/bash\nsleep 1000 & echo $! >process; wait\n")
        (self.folder / "process").unlink(missing_ok=True)
        script = subprocess.Popen([self.SCRIPT, *words], cwd=self.folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                  stderr=subprocess.PIPE, text=True,
                                  env={**os.environ, "PATH": f"{self.folder}/tools:{os.environ['PATH']}"})
        self.process_said(self.folder, "process")
        script.send_signal(stop)
        script.communicate(timeout=HANGS_S)
        self.assertEqual(script.returncode, status)
        self.soon("all that was begun has ended", lambda: not self.processes_there())
        self.assertFalse((self.folder / "calls").exists(), "it has gone on to what comes next")

    def processes_there(self):
        """The words of those that run in the folder."""
        there = []
        for process in Path("/proc").glob("[0-9]*"):
            try:
                if os.readlink(process / "cwd") == str(self.folder.resolve()):
                    there.append((process / "cmdline").read_bytes())
            except OSError:
                pass  # it has ended, or is nobody's business
        return there

    def calls(self):
        return [line.rstrip() for line in (self.folder / "calls").read_text().splitlines()]


@unittest.skipIf(os.geteuid() != 0, "it takes root, and says so")
class EveryChange(ScriptOfScripts):
    """.ci/run, which fails where any of what it calls does."""

    SCRIPT = ".ci/run"
    CALLED = ("tests/gates", "tests/run", "tests/fuzz/run", "tests/clean_room")
    CALLS = ("tests/gates scripts arrows names words sizes format", "tests/run --preset checked", "tests/fuzz/run --light",
             "tests/gates --most 80 tidy", "tests/clean_room")

    def setUp(self):
        super().setUp()
        for name in ("ci_packages.txt", "room_packages.txt", "room.sh"):
            shutil.copy(ROOT / "tests" / name, self.folder / "tests")
        self.tool("unshare", "exit 0")

    def test_it_calls_all(self):
        done = self.run_script(".ci/run")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.calls(), list(self.CALLS))

    def test_where_rooms_cannot_be_made_it_says_so_at_once(self):
        self.tool("unshare", "exit 1")
        done = self.run_script(".ci/run")
        self.assertEqual((done.returncode, done.stdout), (77, ""), done.stderr)
        self.assertRegex(done.stderr, "^loomlight: a clean room takes [^\n]*\n$")
        self.assertFalse((self.folder / "calls").exists())

    def test_what_it_calls_ends_with_it(self):
        for stop, status in ((signal.SIGTERM, 143), (signal.SIGINT, 130)):
            with self.subTest(stop=stop.name):
                self.expect_end_with_it("tests/gates", stop, status)

    def test_a_failure_of_any_is_its_own(self):
        for call in self.CALLS:
            with self.subTest(call=call):
                script, _, words = call.partition(" ")
                self.ends_with(script, 3, words)
                self.assertEqual(self.run_script(".ci/run").returncode, 3)
                self.ends_with(script, 0)


class Night(ScriptOfScripts):
    """tests/nightly, which goes on after a failure and says of each part how it ended."""

    SCRIPT = "tests/nightly"
    CALLED = (".ci/run", "tests/run", "tests/gates", "tests/fuzz/run", "tests/clean_room", "tests/package_room",
              "tests/arm_room", "tests/farm", "tests/handover/run")

    def night(self, *parts, **environment):
        (self.folder / "calls").unlink(missing_ok=True)
        return self.run_script("tests/nightly", *parts, **environment)

    def test_parts_that_are_named_run_alone(self):
        done = self.night("tsan", "rooms")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.calls(), ["tests/run --preset tsan", "tests/clean_room --all"])
        self.assertRegex(done.stdout, r"\Apassed: tests/run --preset tsan \(\d+ s\)\npassed: tests/clean_room --all \(\d+ s\)\n\Z")

    def test_what_it_calls_ends_with_it(self):
        for stop, status in ((signal.SIGTERM, 143), (signal.SIGINT, 130)):
            with self.subTest(stop=stop.name):
                self.expect_end_with_it(".ci/run", stop, status, "ci", "tsan")

    def test_busy_loops_end_with_it(self):
        self.expect_end_with_it("tests/run", signal.SIGTERM, 143, "suites")

    def test_a_part_that_there_is_not_is_told_those_that_there_are(self):
        done = self.night("tsan", "thread")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        (line,) = done.stderr.splitlines()
        self.assertIn('"thread" is no part of the night; there are: ci ', line)
        self.assertFalse((self.folder / "calls").exists())

    def test_numbers_that_are_none_are_told_before_anything_is_done(self):
        for name, number in (("REPEATS", "0"), ("REPEATS", "2x"), ("REPEATS", "many"), ("BUSY", "some"), ("BUSY", "08")):
            with self.subTest(name=name, number=number):
                done = self.night("tsan", "suites", **{f"LOOMLIGHT_{name}": number})
                self.assertEqual((done.returncode, done.stdout), (2, ""))
                (line,) = done.stderr.splitlines()
                self.assertIn(f'got "{number}"' if name == "REPEATS" else f'and "{number}"', line)
                self.assertFalse((self.folder / "calls").exists())

    def test_it_goes_on_after_a_failure_and_fails(self):
        self.ends_with("tests/gates", 1)
        self.ends_with("tests/farm", 77)
        done = self.night("tidy", "packages", "farm")
        self.assertEqual(done.returncode, 1)
        self.assertEqual(self.calls(), ["tests/gates --all tidy", "tests/package_room", "tests/farm"])
        self.assertEqual([line.split(":")[0] for line in done.stdout.splitlines()], ["FAILED", "passed", "SKIPPED"])

    def test_what_cannot_be_tried_here_is_no_success(self):
        self.ends_with("tests/farm", 77)
        self.assertEqual(self.night("packages", "farm").returncode, 77)

    def test_the_suite_over_and_over_is_in_another_order_each_time(self):
        twice = {"LOOMLIGHT_REPEATS": "2", "LOOMLIGHT_BUSY": "1"}
        self.assertEqual(self.night("suites", **twice).returncode, 0)
        self.assertEqual(self.calls(), ["tests/run --preset checked --schedule-random"] * 2)
        self.ends_with("tests/run", 1)
        self.assertEqual(self.night("suites", **twice).returncode, 1)


class RoomScripts(WaitsForProcesses):
    ROOMS = ("clean_room", "package_room", "arm_room")
    SCRIPTS = (*ROOMS, "farm")

    def setUp(self):
        super().setUp()
        for name in ("room.sh", *self.SCRIPTS):
            shutil.copy(ROOT / "tests" / name, self.folder / "tests" / name)
        for name in ("room", "package_room", "farm"):
            (self.folder / f"tests/{name}_packages.txt").write_text("absent\n")
        self.folder.chmod(0o755)


class Rooms(RoomScripts):
    """The scripts that take root: what cannot be tried here ends with 77, and what fails with something else."""

    def test_a_word_that_none_of_them_knows_is_named(self):
        for name in self.SCRIPTS:
            for words in (("sid",), ("--fast",)):
                with self.subTest(script=name, words=words):
                    done = self.run_script(f"tests/{name}", *words)
                    self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
                    (line,) = done.stderr.splitlines()
                    self.assertRegex(line, f'^loomlight: usage: tests/{name} .*"{words[0]}" is none of these$')

    def test_without_root_a_line_says_that_it_takes_root(self):
        nobody = {"user": 65534, "group": 65534, "extra_groups": []} if os.geteuid() == 0 else {}
        for name in self.SCRIPTS:
            with self.subTest(script=name):
                done = subprocess.run([self.folder / "tests" / name], cwd=self.folder, stdin=subprocess.DEVNULL,
                                      capture_output=True, text=True, timeout=HANGS_S, **nobody)
                self.assertEqual((done.returncode, done.stdout), (77, ""), done.stderr)
                (line,) = done.stderr.splitlines()
                self.assertRegex(line, "takes? root.*: run this as root, or with sudo$")


@unittest.skipIf(os.geteuid() != 0, "without root they do not come so far")
class RoomsOfRoot(RoomScripts):
    """As far as root comes where packages, namespaces or the disk stand in the way, and where it stops them."""

    def test_a_system_without_namespaces_cannot_have_rooms(self):
        self.tool("unshare", "exit 1")
        for name in self.ROOMS:
            with self.subTest(script=name):
                done = self.run_script(f"tests/{name}")
                self.assertEqual((done.returncode, done.stdout), (77, ""), done.stderr)
                (line,) = done.stderr.splitlines()
                self.assertRegex(line, "^loomlight: a clean room takes namespaces of its own, and this system .* not let")

    def test_packages_that_cannot_be_installed_are_a_failure(self):
        for name, script in (("unshare", "exit 0"), ("dpkg-query", "exit 1"), ("apt-get", "exit 100")):
            self.tool(name, script)
        for name in self.SCRIPTS:
            with self.subTest(script=name):
                done = self.run_script(f"tests/{name}")
                self.assertEqual((done.returncode, done.stdout), (1, ""), done.stderr)
                self.assertIn("the packages could not be installed", done.stderr)

    def test_a_disk_without_space_for_a_room_is_named(self):
        self.tool("unshare", "exit 0")
        self.df_says(100)
        for name in self.ROOMS:
            with self.subTest(script=name):
                done = self.run_script(f"tests/{name}", TMPDIR=str(self.folder))
                self.assertEqual((done.returncode, done.stdout), (1, ""), done.stderr)
                (line,) = done.stderr.splitlines()
                self.assertRegex(line, "^loomlight: not enough space on the disk of .* a clean room takes about .* 100 MB are free$")

    def test_a_room_stays_where_that_is_asked_for_and_one_of_a_killed_run_goes(self):
        # The room is there when making it fails.
        self.tool("unshare", 'for room; do :; done\n[[ $room != true ]] || exit 0\nmkdir "$room"; exit 1')
        self.df_says(100000)
        rooms = self.folder / "rooms"
        for name in self.ROOMS:
            with self.subTest(script=name):
                rooms.mkdir()
                done = self.run_script(f"tests/{name}", "--keep", TMPDIR=str(rooms))
                (kept,) = rooms.iterdir()
                self.assertEqual(done.returncode, 1)
                self.assertEqual(done.stderr.splitlines()[-1], f"loomlight: kept for a look: chroot {kept}")
                no_process = int(Path("/proc/sys/kernel/pid_max").read_text())
                (rooms / f"loomlight-room.trixie.1.{no_process}").mkdir()
                self.assertEqual(self.run_script(f"tests/{name}", TMPDIR=str(rooms)).returncode, 1)
                self.assertEqual(list(rooms.iterdir()), [kept])
                shutil.rmtree(rooms)

    def test_a_room_is_gone_when_it_is_stopped(self):
        rooms = self.folder / "rooms"
        # The room's folder is its last word. It has begun when it says its process.
        self.tool("unshare", 'for room; do :; done\n[[ $room != true ]] || exit 0\n'
                             'mkdir "$room"; echo $$ >"$room/process"; exec sleep 1000')
        self.df_says(100000)
        for stop, status in ((signal.SIGTERM, 143), (signal.SIGINT, 130), (signal.SIGHUP, 143)):
            for name in self.ROOMS:
                with self.subTest(script=name, stop=stop.name):
                    rooms.mkdir()
                    script = subprocess.Popen(
                        [f"tests/{name}"], cwd=self.folder, stdin=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                        env={**os.environ, "PATH": f"{self.folder}/tools:{os.environ['PATH']}", "TMPDIR": str(rooms)})
                    process = self.process_said(rooms, "*/process")
                    script.send_signal(stop)
                    _, said = script.communicate(timeout=HANGS_S)
                    self.assertEqual((script.returncode, said), (status, ""))
                    self.assertFalse(Path(f"/proc/{process}").exists(), "what ran there goes on")
                    rooms.rmdir()  # fails where anything is left


main()
