"""The set-up that app/run and tests/run share installs what is missing, no more, and says so where it cannot."""

import os
import shutil
import subprocess

from harness import ROOT, CommandLineTest, main


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
            timeout=60,
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
        self.tool("dpkg-query", "printf installed")
        self.tool("apt-get", "touch called")
        done = self.install()
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertFalse((self.folder / "called").exists())

    def test_where_it_cannot_one_line_says_what_to_do(self):
        self.tool("apt-get", "exit 100")
        done = self.install()
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("apt-get install --no-install-recommends absent-dev", done.stderr)


class AppRun(CommandLineTest):
    """app/run in a tree where building makes a program that says how it was called."""

    def setUp(self):
        super().setUp()
        tools = self.folder / "tools"
        tools.mkdir()
        (self.folder / "app").mkdir()
        for name in ("run", "setup.sh", "packages.txt"):
            shutil.copy(ROOT / "app" / name, self.folder / "app" / name)
        for name, script in (
            ("dpkg-query", "printf installed"),
            ("cmake", "touch .build/release/build.ninja; echo configured"),
            ("ninja", "mkdir -p .build/release/app; cp tools/program .build/release/app/loomlight; echo built"),
            ("program", 'echo "called with: $*"; exit 7'),
        ):
            (tools / name).write_text("#!/bin/bash\n" + script + "\n")
            (tools / name).chmod(0o755)

    def app_run(self, *words, **environment):
        plain = {key: value for key, value in os.environ.items() if key not in ("DISPLAY", "WAYLAND_DISPLAY")}
        return subprocess.run(
            ["app/run", *words],
            cwd=self.folder,
            env={**plain, "PATH": f"{self.folder}/tools:{os.environ['PATH']}", **environment},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            timeout=60,
        )

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


main()
