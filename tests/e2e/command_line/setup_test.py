"""The set-up that app/run and tests/run share installs what is missing, no more, and says so where it cannot."""

import os
import shutil
import subprocess

from harness import HANGS_S, ROOT, CommandLineTest, main
from small_tree import SmallTree


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


main()
