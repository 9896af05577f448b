"""What the tests of the command line share: running the program, small fabrics, reading its pictures."""

import contextlib
import json
import os
import pathlib
import pty
import re
import struct
import subprocess
import tempfile
import threading
import unittest
import zlib

LOOMLIGHT = os.environ["LOOMLIGHT"]
ROOT = pathlib.Path(os.environ["LOOMLIGHT_ROOT"])
SAMPLES = ROOT / "samples"
HANGS_S = 900  # only what hangs takes so long, however busy the machine

# Small enough that the whole program runs in a fraction of a second.
SMALL = {
    "loomlight_version": 1,
    "name": "small twill",
    "weave": ["#..#", "##..", ".##.", "..##"],
    "ends_per_cm": 20,
    "picks_per_cm": 18,
    "warp_sequence": [0],
    "weft_sequence": [1],
    "yarns": [
        {"name": "warp", "fibre": 0, "fibres_per_ply": 20, "plies": 2, "yarn_twist_per_m": 400},
        {"name": "weft", "fibre": 1, "fibres_per_ply": 40},
    ],
    "fibres": [
        {"name": "blue", "radius_um": 9, "absorption_per_mm": [20, 8, 1]},
        {"name": "white", "radius_um": 9},
    ],
    "drape": {"kind": "flat", "width_mm": 4, "height_mm": 4, "radius_mm": 3},
    "camera": {"distance_mm": 14},
    "render": {"width": 32, "height": 24, "samples_per_pixel": 4, "resolution": 2},
}

# Closed cloth of one yarn: whatever is seen from above is its fibre.
_YARN = {"name": "yarn", "fibre": 0, "fibres_per_ply": 30}
CLOSED = {
    "weave": ["#.", ".#"],
    "ends_per_cm": 60,
    "picks_per_cm": 60,
    "weft_sequence": [0],
    "yarns": [_YARN],
    "fibres": [{"name": "a=b", "radius_um": 18}],
    "drape": {"kind": "flat", "width_mm": 12, "height_mm": 12},
    "camera": {"elevation_deg": 90, "fov_deg": 0, "distance_mm": 6},
}


class CommandLineTest(unittest.TestCase):
    """A test with a folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="loomlight-test-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_program(self, *words, status=0, messages=False, cwd=None, before=(), **options):
        """Runs the program in the test's folder or another, by the command `before` it; returns stdout, or stderr where it
        is to fail or for messages."""
        done = self.run_both(*words, status=status, cwd=cwd, before=before, **options)
        return done.stdout if status == 0 and not messages else done.stderr

    def run_both(self, *words, status=0, cwd=None, before=(), **options):
        """Likewise, with what it said on both."""
        done = subprocess.run(
            [*before, LOOMLIGHT, *map(str, words)],
            cwd=cwd or self.folder,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            timeout=HANGS_S,
            text=True,
            errors="replace",
            **options,
        )
        self.assertEqual(done.returncode, status, f"{words}\n{done.stdout}{done.stderr}")
        return done

    def start_at_work(self, label, *words, **options):
        """Starts the program on a terminal, and returns it when its bar `label` shows that some of the work is done."""
        terminal, end = pty.openpty()
        program = subprocess.Popen(
            [LOOMLIGHT, *map(str, words)],
            cwd=self.folder,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=end,
            text=True,
            **options,
        )
        self.addCleanup(program.stdout.close)
        self.addCleanup(program.wait)
        self.addCleanup(program.kill)
        os.close(end)
        screen = os.fdopen(terminal, "rb", buffering=0)
        said = b""
        while f"{label} [".encode() not in said:
            said += screen.read(4096)  # fails when the program ends before that

        def read_on():  # a full terminal would hold the program up
            with screen, contextlib.suppress(OSError):
                while screen.read(4096):
                    pass

        reader = threading.Thread(target=read_on)
        reader.start()
        self.addCleanup(reader.join)
        return program

    def fabric(self, file_name="fabric.json", **changes):
        """Writes the small fabric, with some of its top-level keys changed, and returns the file."""
        file = self.folder / file_name
        file.write_text(json.dumps({**SMALL, **changes}))
        return file

    def bytes_of(self, name):
        return (self.folder / name).read_bytes()


def read_png(file):
    """Width, height and rows of pixels of a PNG of 8 or 16 bits without interlace."""
    data = pathlib.Path(file).read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", "no PNG"
    position, compressed = 8, b""
    while position < len(data):
        length, kind = struct.unpack(">I4s", data[position : position + 8])
        body = data[position + 8 : position + 8 + length]
        if kind == b"IHDR":
            width, height, depth, colour, _, _, interlace = struct.unpack(">IIBBBBB", body)
            assert depth in (8, 16) and interlace == 0
        elif kind == b"IDAT":
            compressed += body
        position += 12 + length
    channels = {0: 1, 2: 3, 4: 2, 6: 4}[colour]
    step = channels * depth // 8  # bytes of a pixel
    raw, stride, rows = zlib.decompress(compressed), width * step, []
    above = bytearray(stride)
    for y in range(height):
        start = y * (stride + 1)
        kind, line = raw[start], bytearray(raw[start + 1 : start + 1 + stride])
        for i in range(stride):
            left = line[i - step] if i >= step else 0
            corner = above[i - step] if i >= step else 0
            line[i] = (line[i] + _predicted(kind, left, above[i], corner)) & 255
        values = struct.unpack(f">{width * channels}{'B' if depth == 8 else 'H'}", line)
        rows.append([values[i : i + channels] for i in range(0, width * channels, channels)])
        above = line
    return width, height, rows


def _predicted(kind, left, above, corner):
    if kind == 4:
        nearest = left + above - corner
        return min((left, above, corner), key=lambda value: abs(nearest - value))
    return (0, left, above, (left + above) // 2)[kind]


def write_png(file, rows):
    """Rows of pixels, red, green and blue, from the top."""
    def piece(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    head = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 2, 0, 0, 0)
    lines = b"".join(b"\0" + bytes(channel for pixel in row for channel in pixel) for row in rows)
    pathlib.Path(file).write_bytes(b"\x89PNG\r\n\x1a\n" + piece(b"IHDR", head) +
                                   piece(b"IDAT", zlib.compress(lines)) + piece(b"IEND", b""))


def samples_said(text):
    """The number of samples per pixel that `render` says it has reached."""
    return int(re.search(r"(\d+) samples per pixel", text).group(1))


def main():
    unittest.main(verbosity=2)
