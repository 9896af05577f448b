"""The quick form of `bench ui`: it draws frames while all is rebuilt, and says what they took. Times are not judged."""

import json
import os
import subprocess
import tempfile

from window_driver import HANGS_S, Display, environment_of, expect

PROGRAM = os.environ["LOOMLIGHT"]


def main():
    display = Display(1600, 1000)
    try:
        with tempfile.TemporaryDirectory(prefix="loomlight-ui-") as home:
            done = subprocess.run([PROGRAM, "bench", "ui", "--quick", "--json"], env=environment_of(display, home),
                                  timeout=HANGS_S, stdout=subprocess.PIPE, text=True, check=True)
        told = json.loads(done.stdout)
        expect(told["frames"] >= 3 * 8, f"eight frames at least of each of three cloths, not {told['frames']}")
        for what in ("besides_drawing_ms", "panels_ms", "pixels_ms"):
            times = told[what]
            expect(0 < times["median"] <= times["p99"] <= times["longest"], f"{what} is in order: {times}")
    finally:
        display.close()
    print("ok")


main()
