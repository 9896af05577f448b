"""While the mouse is down the picture moves: a stroke across the weave, the twist slider, a colour wheel. Each step of a
drag is another picture of the cloth, before the button comes up.

That it is of another cloth, and not only of more samples, is told by the light in it: noise leaves the mean of all pixels
where it is, while each of these steps changes it by at least twice what noise could.
"""

import os
import subprocess

from window_driver import expect, run, window, write_json

PROGRAM = os.environ["LOOMLIGHT"]
WIDTH, HEIGHT = 720, 760  # narrow: few pixels beside the cloth
STEPS = 2
SAMPLES = 16  # for each pixel; of fewer, an older picture of the same view shows through
LEAST_CHANGE = 0.02  # of the light, by a step: a crossing of 16, 800 turns a metre, or a colour


def square_fabric(home, seed):
    """Sixteen crossings of dark and light, none of which the diagonal has dark."""
    rows = [["#" if pick == (end + 1) % 4 else "." for end in range(4)] for pick in range(4)]
    fabric = {
        "loomlight_version": 1, "name": "Drags", "weave": ["".join(row) for row in reversed(rows)],
        "ends_per_cm": 10, "picks_per_cm": 10, "warp_sequence": [0], "weft_sequence": [1],
        "yarns": [{"name": "blue", "count_tex": 150, "ply_twist_per_m": 2000, "fibre": 0},
                  {"name": "ecru", "count_tex": 150, "fibre": 1}],
        "fibres": [{"name": "blue", "radius_um": 20, "absorption_per_mm": [50, 20, 4]},
                   {"name": "ecru", "radius_um": 20, "absorption_per_mm": [1, 2, 4]}],
        "drape": {"kind": "flat", "width_mm": 4, "height_mm": 4}, "light": {"kind": "dome"},
        "camera": {"distance_mm": 51, "elevation_deg": 60},
        "render": {"resolution": 1, "estimator": "none", "seed": seed},
    }
    return write_json(home, f"drags {seed}.json", fabric)


def light(editor):
    """Of the newest picture, once it has all its samples: red, green and blue, the mean of all pixels."""
    editor.wait_for_picture()
    editor.wait_until("the picture has samples", lambda: editor.number("shown_samples") >= SAMPLES
                      and editor.fact("shown_generation") == editor.fact("generation"))
    return [float(channel) for channel in editor.fact("shown_light").split()]


def on_the_screen(editor, name):
    """Mean red, green and blue as they are drawn there, as light: of the middle, where nothing but cloth is."""
    mean = subprocess.run(["convert", editor.screenshot(name, "viewport"), "-gravity", "center", "-crop", "120x120+0+0",
                           "-colorspace", "RGB", "-format", "%[fx:mean.r] %[fx:mean.g] %[fx:mean.b]", "info:"],
                          check=True, capture_output=True, text=True)
    return [float(channel) for channel in mean.stdout.split()]


def change(before, after):
    """The largest of the three, in parts of what there was."""
    return max(abs(b - a) / a for a, b in zip(before, after))


def edits(editor, what, act):
    """Does it, and waits until the cloth is another."""
    generation = editor.number("generation")
    act()
    editor.wait_until(f"{what} edits the cloth", lambda: editor.number("generation") > generation)


def drag(editor, name, start, step, press_edits=True):
    """Each step is another cloth to see, with the button down; held still, the cloth stays as it is."""
    lights = [light(editor)]
    screens = [on_the_screen(editor, f"{name}_0")]
    editor.move(*start)
    if press_edits:
        edits(editor, f"the press of the {name}", editor.press)
    else:
        editor.press()
    for i in range(1, STEPS + 1):
        edits(editor, f"step {i} of the {name}", lambda: editor.move(start[0] + i * step[0], start[1] + i * step[1]))
        generation = editor.number("generation")
        lights.append(light(editor))
        expect(editor.number("generation") == generation, f"step {i} of the {name}, held still, goes on editing")
        changed = change(*lights[-2:])
        expect(changed > LEAST_CHANGE, f"step {i} of the {name} is not seen: the light changes by {100 * changed:.2f} %")
        screens.append(on_the_screen(editor, f"{name}_{i}"))
        expect(change(*screens[-2:]) > LEAST_CHANGE, f"step {i} of the {name} is not on the screen")
    editor.release()


def stroke(editor):
    x0, y0, x1, y1 = editor.widgets()["draft.cell_0_0"]
    size = x1 - x0
    # The button turns over the first crossing of the diagonal, and each step another.
    drag(editor, "stroke", ((x0 + x1) / 2, (y0 + y1) / 2), (size, -size))


def twist(editor):
    drag(editor, "twist", editor.centre("yarn.ply_twist_per_m"), (-200, 0), press_edits=False)


def colour(editor):
    editor.click("tab.fibre")
    editor.click("fibre.colour")
    editor.centre("fibre.colour/picker")
    x0, y0, x1, y1 = editor.widgets()["fibre.colour/picker"]
    side = min(x1 - x0, y1 - y0)
    drag(editor, "colour", (x0 + 0.6 * side, y0 + 0.6 * side), (-0.06 * side, -0.06 * side))


def test():
    with window(WIDTH, HEIGHT, SAMPLES) as editor:
        lights = []
        for seed in (1, 2):
            editor.start(PROGRAM, [square_fabric(editor.home, seed)])
            lights.append(light(editor))
            if seed == 1:
                editor.key("ctrl+q")
                expect(editor.wait_for_end() == 0, editor.log())
        noise = change(*lights)
        expect(noise < LEAST_CHANGE / 2, f"other samples of one cloth change its light by {100 * noise:.2f} %")
        for moves in (stroke, twist, colour):
            moves(editor)


run(test)
