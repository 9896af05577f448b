"""The set-up that app/run and tests/run share installs what is missing, no more, and says so where it cannot."""

import os
import re
import shutil
import signal
import subprocess
import time
import unittest
from pathlib import Path

from harness import HANGS_S, ROOT, CommandLineTest, main


class Setup(CommandLineTest):
    def setUp(self):
        super().setUp()
        (self.folder / "packages.txt").write_text("# a remark\nhere-dev\n\nabsent-dev  # another\n")
        self.tool("dpkg-query", '[[ ${!#} == here-dev ]] && printf installed || exit 1')
        self.tool("sudo", '[[ $1 == -n ]] && shift; exec "$@"')

    def tool(self, name, script):
        file = self.folder / name
        file.write_text("#!/bin/bash\n" + script + "\n")
        file.chmod(0o755)

    def install(self):
        return subprocess.run(
            ["bash", "-euc", f'source "{ROOT}/app/setup.sh"; install_packages packages.txt'],
            cwd=self.folder,
            env={**os.environ, "PATH": f"{self.folder}:{os.environ['PATH']}"},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            timeout=HANGS_S,
        )

    def test_only_what_is_missing_is_installed(self):
        self.tool("apt-get", 'echo "$@" >>apt.log')
        done = self.install()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout, "")
        update, install = (self.folder / "apt.log").read_text().splitlines()
        self.assertIn("update", update)
        self.assertIn("install -y --no-install-recommends absent-dev", install)
        self.assertNotIn("here-dev", install)

    def test_nothing_missing_asks_for_nothing(self):
        self.tool("dpkg-query", "printf 'installed installed '")
        self.tool("apt-get", "touch called")
        done = self.install()
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertFalse((self.folder / "called").exists())

    def test_where_it_cannot_one_line_says_what_to_do(self):
        self.tool("apt-get", "exit 100")
        done = self.install()
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("apt-get install --no-install-recommends absent-dev", done.stderr)

    def test_a_dead_source_is_the_reason_only_of_what_is_not_known(self):
        dead = "W: Failed to fetch http://dead.invalid/dists/x/InRelease  Could not resolve 'dead.invalid'"
        for updating, installing, reason in (
            (dead, "E: You don't have enough free space in /var/cache/apt/archives/.", "the disk is full"),
            (dead, "E: Unable to correct problems", "Unable to correct problems"),
            (dead, "E: Unable to locate package absent-dev", "no network, or none that reaches the packages"),
            (dead, "E: Package 'absent-dev' has no installation candidate", "no network, or none that reaches the packages"),
            ("", "E: Unable to locate package absent-dev", "not known here: absent-dev; Debian 12 and 13 have them"),
            ("", "E: Failed to fetch http://a.invalid/a.deb  Could not connect to a.invalid",
             "no network, or none that reaches the packages"),
        ):
            with self.subTest(updating=updating, installing=installing):
                self.tool("apt-get", f'[[ $* == *" update" ]] && said="{updating}" || said="{installing}"\necho "$said"; exit 100')
                done = self.install()
                self.assertEqual(done.returncode, 1)
                self.assertIn(f"could not be installed ({reason}); please run", done.stderr)

    def test_a_full_disk_is_told_from_other_reasons(self):
        for said, reason in (
            ("E: You don't have enough free space in /var/cache/apt/archives/.", "the disk is full"),
            ("E: Write error - write (28: No space left on device)", "the disk is full"),
            ("E: Unable to correct problems", "Unable to correct problems"),
        ):
            with self.subTest(said=said):
                self.tool("apt-get", f'echo "{said}" >&2; exit 100')
                done = self.install()
                self.assertEqual(done.returncode, 1)
                installing, refusal = done.stderr.splitlines()
                self.assertEqual(installing, "loomlight: installing absent-dev")
                self.assertIn(f"could not be installed ({reason}); please run, as root: apt-get update", refusal)


class SmallTree(CommandLineTest):
    """The scripts in a tree of their own, where the tools that they call are ours."""

    TOOLS = {"dpkg-query": "printf installed"}

    def setUp(self):
        super().setUp()
        (self.folder / "tools").mkdir()
        for name in ("CMakePresets.json", "app/run", "app/setup.sh", "app/packages.txt", "tests/run", "tests/packages.txt",
                     "tests/clang_packages.txt"):
            (self.folder / name).parent.mkdir(exist_ok=True)
            shutil.copy(ROOT / name, self.folder / name)
        for name, script in self.TOOLS.items():
            self.tool(name, script)

    def tool(self, name, script):
        file = self.folder / "tools" / name
        file.write_text("#!/bin/bash\n" + script + "\n")
        file.chmod(0o755)

    def df_says(self, *free_mb):
        """What its calls say, one after the other, and the last one from then on."""
        (self.folder / "free").write_text("".join(f"{mb}\n" for mb in free_mb))
        self.tool("df", 'mb=$(head -n 1 free); (($(wc -l <free) == 1)) || sed -i 1d free\n'
                        'if [[ $* == *--output=avail* ]]; then printf "Avail\\n%5sM\\n" $mb\n'
                        'else printf "Filesystem 1M-blocks Used Available\\nour disk 9999 0 $mb\\n"; fi')

    def run_script(self, *words, **environment):
        plain = {key: value for key, value in os.environ.items() if key not in ("DISPLAY", "WAYLAND_DISPLAY")}
        return subprocess.run(
            words,
            cwd=self.folder,
            env={**plain, "PATH": f"{self.folder}/tools:{os.environ['PATH']}", **environment},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            timeout=HANGS_S,
        )


class AppRun(SmallTree):
    """app/run where building makes a program that says how it was called."""

    TOOLS = {
        **SmallTree.TOOLS,
        "cmake": "touch .build/release/build.ninja; echo configured",
        "ninja": "mkdir -p .build/release/app; cp tools/program .build/release/app/loomlight; echo built",
        "program": 'echo "called with: $*"; exit 7',
    }

    def app_run(self, *words, **environment):
        return self.run_script("app/run", *words, **environment)

    def test_words_go_to_the_program_and_its_answer_comes_back(self):
        done = self.app_run("info", "a file.json", "--json")
        self.assertEqual((done.returncode, done.stdout), (7, "called with: info a file.json --json\n"))

    def test_a_display_gets_the_editor(self):
        done = self.app_run(DISPLAY=":5")
        self.assertRegex(done.stdout, r"^called with: edit .*/samples/cloths/denim_raw.json\n$")

    def test_without_a_display_a_picture_is_rendered(self):
        done = self.app_run()
        self.assertRegex(done.stdout, r"^called with: render .*/samples/cloths/denim_raw.json -o denim.png")
        self.assertIn("no display", done.stderr)

    def test_a_disk_that_is_too_small_is_known_before_building(self):
        self.df_says(100)
        done = self.app_run()
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertRegex(done.stderr, r"\Aloomlight: not enough space on the disk of .*about \d+ MB, 100 MB are free\n\Z")

    def test_a_disk_that_fills_up_while_building_is_named(self):
        self.tool("ninja", "echo 'fatal error: error writing to a.o: No space left on device'; exit 1")
        for left_mb, end in ((9, r"building failed: the disk of .*/\.build/release is full"), (5000, "building failed")):
            with self.subTest(left_mb=left_mb):
                shutil.rmtree(self.folder / ".build", ignore_errors=True)
                self.df_says(5000, left_mb)
                done = self.app_run()
                self.assertEqual((done.returncode, done.stdout), (1, ""))
                self.assertRegex(done.stderr.splitlines()[-1], f"^loomlight: {end}$")

    def test_a_disk_that_fills_up_while_configuring_is_named(self):
        self.configured_for(self.folder)
        self.tool("cmake", "echo 'CMake Error: No space left on device'; exit 1")
        self.df_says(9)
        self.assertRegex(self.run_script("tests/run").stderr, r"\nloomlight: configuring failed: the disk of .* is full\n\Z")

    def configured_for(self, tree):
        """As if it had been configured when the tree was there."""
        (self.folder / ".build/release").mkdir(parents=True)
        (self.folder / ".build/release/build.ninja").touch()
        (self.folder / ".build/release/CMakeCache.txt").write_text(f"CMAKE_HOME_DIRECTORY:INTERNAL={tree}\n")

    def test_what_was_built_elsewhere_is_to_be_removed(self):
        self.configured_for("/elsewhere")
        done = self.app_run()
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertRegex(done.stderr, r"\Aloomlight: [^\n]*/elsewhere[^\n]* try again: rm -r [^\n]*/\.build/release\n\Z")

    def test_a_build_that_a_changed_system_has_spoilt_is_to_be_removed(self):
        gone = "ninja: error: '/usr/lib/libgone.so.1', needed by 'app/loomlight', missing and no known rule to make it"
        for said, helps in ((gone, True), ("CMake Error at CMakeLists.txt:3", True), ("a.cpp:1: error: no such type", False)):
            with self.subTest(said=said):
                shutil.rmtree(self.folder / ".build", ignore_errors=True)
                self.configured_for(self.folder)
                self.tool("ninja", f'echo "{said}"; exit 1')
                done = self.app_run()
                self.assertEqual((done.returncode, done.stdout), (1, ""))
                *_, error, last = done.stderr.splitlines()
                self.assertEqual(error, said)
                self.assertTrue(last.startswith("loomlight: building failed"))
                self.assertEqual(last.endswith("/.build/release"), helps, last)

    def test_configuring_that_fails_where_it_has_succeeded_before(self):
        self.configured_for(self.folder)
        self.tool("cmake", "exit 1")
        self.assertRegex(self.run_script("tests/run").stderr, r"configuring failed; .*rm -r .*/\.build/release\n\Z")
        (self.folder / ".build/release/build.ninja").unlink()
        self.assertRegex(self.app_run().stderr, r"configuring failed\n\Z")


class TestsRun(SmallTree):
    """tests/run, whose words are looked at before anything else is done."""

    TOOLS = {"dpkg-query": "touch asked; printf installed"}

    def refusal(self, *words):
        done = self.run_script("tests/run", *words)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertFalse((self.folder / "asked").exists(), "packages were looked at first")
        (line,) = done.stderr.splitlines()
        return line

    def test_an_option_without_its_name(self):
        for option in ("--preset", "-L"):
            for words in ((option,), ("-R", "volume", option)):
                with self.subTest(words=words):
                    self.assertEqual(self.refusal(*words), f"loomlight: {option} takes a name")

    def test_a_word_that_is_no_option(self):
        for words in (("volume",), ("-R", "volume", "threads"), ("--schedule-random", "volume")):
            with self.subTest(words=words):
                self.assertIn(f'"{words[-1]}" is no option', self.refusal(*words))

    def test_an_unknown_preset(self):
        self.assertRegex(self.refusal("--preset", "fast"), '"fast"; there are: release .*clang')

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


class Night(SmallTree):
    """tests/nightly, which goes on after a failure and says of each part how it ended."""

    SCRIPTS = (".ci/run", "tests/run", "tests/gates", "tests/fuzz/run", "tests/clean_room", "tests/package_room",
               "tests/arm_room", "tests/farm", "tests/handover/run")

    def setUp(self):
        super().setUp()
        shutil.copy(ROOT / "tests/nightly", self.folder / "tests/nightly")
        for script in self.SCRIPTS:
            self.ends_with(script, 0)

    def ends_with(self, script, status):
        file = self.folder / script
        file.parent.mkdir(exist_ok=True)
        file.write_text(f'#!/bin/bash\necho "$0 $*" >>calls; exit {status}\n')
        file.chmod(0o755)

    def night(self, *parts, **environment):
        (self.folder / "calls").unlink(missing_ok=True)
        return self.run_script("tests/nightly", *parts, **environment)

    def calls(self):
        return [line.rstrip() for line in (self.folder / "calls").read_text().splitlines()]

    def test_parts_that_are_named_run_alone(self):
        done = self.night("tsan", "rooms")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.calls(), ["tests/run --preset tsan", "tests/clean_room --all"])
        self.assertRegex(done.stdout, r"\Apassed: tests/run --preset tsan \(\d+ s\)\npassed: tests/clean_room --all \(\d+ s\)\n\Z")

    def test_a_part_that_there_is_not_is_told_those_that_there_are(self):
        done = self.night("tsan", "thread")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        (line,) = done.stderr.splitlines()
        self.assertIn('"thread" is no part of the night; there are: ci ', line)
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
        self.assertEqual(self.calls(), ["tests/run --schedule-random"] * 2)
        self.ends_with("tests/run", 1)
        self.assertEqual(self.night("suites", **twice).returncode, 1)


class RoomScripts(SmallTree):
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

    def process_in(self, rooms):
        """Of the first room there, as soon as it has said it."""
        for _ in range(int(HANGS_S / 0.05)):
            said = "".join(file.read_text() for file in rooms.glob("*/process"))
            if said.endswith("\n"):
                return int(said)
            time.sleep(0.05)
        self.fail("no room was begun")

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
                    process = self.process_in(rooms)
                    script.send_signal(stop)
                    _, said = script.communicate(timeout=HANGS_S)
                    self.assertEqual((script.returncode, said), (status, ""))
                    self.assertFalse(Path(f"/proc/{process}").exists(), "what ran there goes on")
                    rooms.rmdir()  # fails where anything is left


main()
