"""The denoised preview: a key brings it and a button takes it away, and the window says that it is there."""

from drags_test import PROGRAM, striped_fabric
from window_driver import expect, run, window


def test():
    with window(1280, 720) as editor:
        editor.start(PROGRAM, [striped_fabric(editor.home)])
        editor.wait_until("the picture has samples", lambda: editor.number("shown_samples") > 0, 120)
        expect(editor.fact("denoised") == "no", "noise is taken before anybody asked for it")
        editor.key("n")
        editor.wait_until("the picture is denoised", lambda: editor.fact("denoised") == "yes")
        editor.click("view.denoise")
        editor.wait_until("the picture is as it was traced", lambda: editor.fact("denoised") == "no")


if __name__ == "__main__":
    run(test)
