"""A picture of a hundred million pixels is read and woven while the window goes on. In the real window."""

import os
import struct
import zlib

from small_cloth import small_cloth
from window_driver import expect, run, window

PROGRAM = os.environ["LOOMLIGHT"]
WIDTH, HEIGHT = 1280, 720
SIDE = 10_000


def huge_picture(home):
    """Grey bars; a row of them many times over."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    row = b"\0" + bytes((x * 12 // SIDE) * 20 for x in range(SIDE))
    squeeze = zlib.compressobj(1)
    pixels = b"".join(squeeze.compress(row * 100) for _ in range(SIDE // 100)) + squeeze.flush()
    file = os.path.join(home, "huge.png")
    with open(file, "wb") as png:
        png.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", SIDE, SIDE, 8, 0, 0, 0, 0)) +
                  chunk(b"IDAT", pixels) + chunk(b"IEND", b""))
    return file


def frames_while(editor, state):
    """How many frames are drawn while the mouse moves and the dialog is in that state."""
    first, step = editor.number("frame"), 0
    while editor.fact("picture.state") == state and step < 400:
        step += 1
        editor.move(500 + 5 * (step % 20), 300)
    return editor.number("frame") - first


def test():
    with window(WIDTH, HEIGHT) as editor:
        picture = huge_picture(editor.home)
        editor.start(PROGRAM, [small_cloth(editor.home, "Plain")])
        editor.wait_for_picture()
        editor.key("ctrl+o")
        editor.click("browser.name")
        editor.key("ctrl+a")
        editor.type(picture)
        editor.key("Return")
        editor.wait_until("the dialog is there", lambda: editor.fact("picture.state") in ("reading", "ready"))
        frames = frames_while(editor, "reading")
        editor.wait_until("the picture is read", lambda: editor.fact("picture.state") == "ready", 60)
        expect(frames >= 5, f"the window stood still while the picture was read: {frames} frames")
        expect(editor.fact("picture.colours") == "4", f"colours: {editor.fact('picture.colours')}")
        revision = editor.number("revision")
        editor.click("picture.weave")
        editor.wait_until("the picture is woven", lambda: editor.number("revision") > revision, 60)
        editor.wait_until("the dialog closes", lambda: editor.fact("dialog") == "none")


run(test)
