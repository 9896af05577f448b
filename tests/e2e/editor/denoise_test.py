"""The denoised preview: a key brings it and takes it away, the window says that it is there, and it is shown at once."""

from drags_test import PROGRAM, striped_fabric
from window_driver import difference, expect, run, window


def test():
    with window(1280, 720) as editor:
        editor.start(PROGRAM, [striped_fabric(editor.home)])
        editor.wait_until("the picture has samples", lambda: editor.number("shown_samples") > 0, 120)
        expect(editor.fact("denoised") == "no", "noise is taken before anybody asked for it")
        before = editor.screenshot("before", "viewport")
        editor.key("n")
        editor.wait_until("the picture is denoised", lambda: editor.fact("denoised") == "yes")
        change = difference(before, editor.screenshot("denoised", "viewport"))
        expect(change > 0.003, f"the picture is as it was: {change}")
        editor.click("view.denoise")
        editor.wait_until("the picture is as it was traced", lambda: editor.fact("denoised") == "no")


if __name__ == "__main__":
    run(test)
