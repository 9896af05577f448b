"""The shader of the display against the C++ that pictures are written with: the program that compares them, on a display
of its own."""

import os
import subprocess

from window_driver import Display, expect, run


def test():
    display = Display(1024, 640)
    try:
        environment = {**os.environ, "DISPLAY": display.name, "LIBGL_ALWAYS_SOFTWARE": "1"}
        done = subprocess.run([os.environ["LOOMLIGHT_DISPLAY_SHADER"]], env=environment, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True)
        expect(done.returncode == 0, done.stdout)
    finally:
        display.close()


run(test)
