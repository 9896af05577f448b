"""A picture of a hundred million pixels is read and woven while the window goes on. In the real window."""

import os
import struct
import time
import zlib

from small_cloth import small_cloth
from window_driver import expect, run, window

PROGRAM = os.environ["LOOMLIGHT"]
WIDTH, HEIGHT = 800, 520
SIDE = 10_000


def processor_ms(act):
    """What of the processor it takes, ms, whatever else the machine does."""
    before = time.process_time()
    act()
    return 1e3 * (time.process_time() - before)


def huge_picture(home):
    """Grey bars; a row of them many times over. Returns the file, and what of the processor unpacking it takes, ms."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    row = b"\0" + b"".join(bytes([(x * 12 // SIDE) * 20] * 3) for x in range(SIDE))
    squeeze = zlib.compressobj(1)
    pixels = b"".join(squeeze.compress(row * 100) for _ in range(SIDE // 100)) + squeeze.flush()
    unpacking_ms = processor_ms(lambda: zlib.decompress(pixels))
    file = os.path.join(home, "huge.png")
    with open(file, "wb") as png:
        png.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", SIDE, SIDE, 8, 2, 0, 0, 0)) +
                  chunk(b"IDAT", pixels) + chunk(b"IEND", b""))
    return file, unpacking_ms


def test():
    with window(WIDTH, HEIGHT, samples=1) as editor:  # the picture is not judged
        picture, unpacking_ms = huge_picture(editor.home)
        editor.start(PROGRAM, [small_cloth(editor.home, "Plain")])
        editor.wait_for_picture()
        editor.key("ctrl+o")
        editor.name_file(picture)
        editor.wait_until("the picture is read", lambda: editor.fact("picture.state") == "ready")
        expect(editor.fact("picture.colours") == "4", f"colours: {editor.fact('picture.colours')}")
        revision = editor.number("revision")
        editor.click("picture.weave")
        editor.wait_until("the picture is woven", lambda: editor.number("revision") > revision)
        editor.wait_until("the dialog closes", lambda: editor.fact("dialog") == "none")
        # Frames are small beside what it takes to unpack the picture, let alone to read and to weave it: had any of
        # that been done between two frames, one would be as long.
        longest_ms = editor.number("longest_frame_ms")
        expect(longest_ms < unpacking_ms, f"the window's thread was busy for {longest_ms} ms of the processor in a "
                                          f"frame; unpacking the picture takes {unpacking_ms:.0f} ms")


run(test)
