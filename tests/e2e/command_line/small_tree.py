"""For tests of the scripts: a tree of their own."""

import os
import shutil
import subprocess

from harness import HANGS_S, ROOT, CommandLineTest


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
