"""While the mouse is down the picture moves: a stroke across the weave, the twist slider, a colour wheel. Each step of a
drag is another picture of the cloth, before the button comes up."""

import os

from window_driver import difference, run, window, write_json

PROGRAM = os.environ["LOOMLIGHT"]
WIDTH, HEIGHT = 1000, 900
STEPS = 6
LEAST_CHANGE = 1e-4  # of the whole picture: a stroke turns a few crossings of it


def striped_fabric(home):
    rows = [["#" if (pick + end) % 4 < 2 else "." for end in range(16)] for pick in range(16)]
    fabric = {
        "loomlight_version": 1, "name": "Drags", "weave": ["".join(row) for row in rows],
        "ends_per_cm": 24, "picks_per_cm": 22, "warp_sequence": [0], "weft_sequence": [1],
        "yarns": [{"name": "blue", "count_tex": 30, "plies": 2, "fibre": 0},
                  {"name": "ecru", "count_tex": 30, "plies": 2, "fibre": 1}],
        "fibres": [{"name": "blue", "radius_um": 9, "absorption_per_mm": [50, 20, 4]},
                   {"name": "ecru", "radius_um": 9, "absorption_per_mm": [1, 2, 4]}],
        "drape": {"kind": "flat", "width_mm": 8, "height_mm": 8}, "light": {"kind": "dome"},
        "camera": {"distance_mm": 20, "elevation_deg": 70}, "render": {"resolution": 2},
    }
    return write_json(home, "drags.json", fabric)


def pictures_of_drag(editor, name, start, step):
    """One of the viewport after each step, all with the button down and each other than the one before."""
    editor.wait_for_picture()
    editor.wait_until("the picture has samples", lambda: editor.number("shown_samples") > 0)
    pictures = [editor.screenshot(f"{name}_0", "viewport")]
    editor.move(*start)
    editor.press()
    for i in range(1, STEPS + 1):
        shown = editor.number("shown_generation")
        editor.move(start[0] + i * step[0], start[1] + i * step[1])
        editor.wait_until(f"step {i} of the {name} is traced", lambda: editor.number("shown_generation") > shown)

        def moved():
            picture = editor.screenshot(f"{name}_{i}", "viewport")
            return difference(pictures[-1], picture) > LEAST_CHANGE
        editor.wait_until(f"step {i} of the {name} is seen", moved)
        pictures.append(os.path.join(editor.home, f"{name}_{i}.png"))
    editor.release()
    return pictures


def stroke(editor):
    x0, y0, x1, y1 = editor.widgets()["draft.cell_0_0"]
    size = x1 - x0
    return pictures_of_drag(editor, "stroke", ((x0 + x1) / 2, (y0 + y1) / 2), (2 * size, -2 * size))


def twist(editor):
    return pictures_of_drag(editor, "twist", editor.centre("yarn.ply_twist_per_m"), (12, 0))


def colour(editor):
    editor.click("tab.fibre")
    editor.click("fibre.colour")
    editor.centre("fibre.colour/picker")
    x0, y0, x1, y1 = editor.widgets()["fibre.colour/picker"]
    side = min(x1 - x0, y1 - y0)
    return pictures_of_drag(editor, "colour", (x0 + 0.6 * side, y0 + 0.6 * side), (-0.06 * side, -0.06 * side))


def test():
    with window(WIDTH, HEIGHT) as editor:
        editor.start(PROGRAM, [striped_fabric(editor.home)])
        for drag in (stroke, twist, colour):
            drag(editor)


if __name__ == "__main__":
    run(test)
