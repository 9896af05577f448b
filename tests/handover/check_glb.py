"""What Blender makes of a .glb; for `blender -b --python check_glb.py -- GLB SIDECAR OUT`, which fails by its status.

The swatch has its true size, and its picture under a white dome is that of its base colour at this size, neither
mirrored nor turned, as bright as a surface of these colours can be."""

import json
import os
import sys

import bpy
import numpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import render_glb

LEAST_LIGHT = 0.75  # of the sky, that a normal sees which is tilted by 60 degrees
MOST_GLOSS = 0.1  # that a surface of index 1.5 adds to its base colour under a dome, whatever its roughness


def expect(condition, message):
    if not condition:
        print(f"FAILED: {message}")
        sys.stdout.flush()
        os._exit(1)


def pixels_of(image):
    """Rows from the bottom, red green blue as they are encoded."""
    values = numpy.empty(len(image.pixels), dtype=numpy.float32)
    image.pixels.foreach_get(values)
    return values.reshape(image.size[1], image.size[0], image.channels)[:, :, :3]


def linear(encoded):
    return numpy.where(encoded <= 0.04045, encoded / 12.92, ((encoded + 0.055) / 1.055) ** 2.4)


def base_colour(swatch):
    """The picture that leads into the surface's base colour."""
    tree = swatch.data.materials[0].node_tree
    surface = next(node for node in tree.nodes if node.type == "BSDF_PRINCIPLED")
    to_visit = [link.from_node for link in surface.inputs["Base Color"].links]
    while to_visit:
        node = to_visit.pop()
        if node.type == "TEX_IMAGE":
            return node.image
        to_visit += [link.from_node for entry in node.inputs for link in entry.links]
    return None


def laid_out(tile, tile_mm, middle_mm, size=1.0):
    """What a camera over `middle_mm` sees of tiles that lie side by side from the lower left corner."""
    sub = 4
    step = 1000 * render_glb.SEEN_M / (render_glb.PIXELS * sub)
    at = (numpy.arange(render_glb.PIXELS * sub) + 0.5) * step - 500 * render_glb.SEEN_M
    height, width, _ = tile.shape
    columns = ((middle_mm[0] + at) / (size * tile_mm[0]) % 1 * width).astype(int)
    rows = ((middle_mm[1] + at) / (size * tile_mm[1]) % 1 * height).astype(int)
    fine = tile[rows][:, columns]
    return fine.reshape(render_glb.PIXELS, sub, render_glb.PIXELS, sub, 3).mean(axis=(1, 3))


def likeness(a, b):
    """Correlation of brightness."""
    return float(numpy.corrcoef(a.mean(axis=2).ravel(), b.mean(axis=2).ravel())[0, 1])


def check(glb, sidecar, out):
    with open(sidecar, encoding="utf-8") as file:
        told = json.load(file)
    tile_mm = told["width_mm"], told["height_mm"]
    swatch = render_glb.load(glb)
    left, right, low, high = (1000 * edge for edge in render_glb.corners(swatch))
    for side, tile in ((right - left, tile_mm[0]), (high - low, tile_mm[1])):
        count = max(1, round(side / tile))
        expect(abs(side - count * tile) < 1e-3, f"a side of {side} mm is not tiles of {tile} mm")
        expect(count == 1 or abs(side - 100) <= tile / 2 + 1e-3, f"a side has {side} mm, and might be nearer to 100")
    base = base_colour(swatch)
    expect(base is not None, "no picture leads into the base colour")
    expect(tuple(base.size) == (told["width_px"], told["height_px"]), f"the base colour has {tuple(base.size)} pixels")
    tile = pixels_of(base)

    render_glb.look_at(swatch)
    render_glb.lay_black_below(swatch)
    render_glb.light_by("dome")
    render_glb.render(out)
    shown = pixels_of(bpy.data.images.load(out))
    middle = (right - left) / 2, (high - low) / 2
    seen = likeness(shown, laid_out(tile, tile_mm, middle))
    others = {
        "mirrored": likeness(shown, laid_out(tile[:, ::-1], tile_mm, middle)),
        "upside down": likeness(shown, laid_out(tile[::-1], tile_mm, middle)),
        "a tenth larger": likeness(shown, laid_out(tile, tile_mm, middle, 1.1)),
    }
    bright, own = linear(shown).mean(axis=(0, 1)), linear(tile).mean(axis=(0, 1))
    print(f"likeness {seen:.2f}; " + ", ".join(f"{how} {value:.2f}" for how, value in others.items()))
    print("mean colour " + ", ".join(f"{value:.4f}" for value in bright) + "; of the map " +
          ", ".join(f"{value:.4f}" for value in own))
    expect(seen > 0.7, f"the picture is not that of its base colour: {seen:.2f}")
    for how, value in others.items():
        expect(seen > value + 0.2, f"{how} it would be as like: {value:.2f} and {seen:.2f}")
    expect((bright > LEAST_LIGHT * own).all() and (bright < own + MOST_GLOSS).all(), "its mean colour is another")


if __name__ == "__main__":
    try:
        check(*sys.argv[sys.argv.index("--") + 1 :])
    except Exception as failure:  # Blender itself ends with 0 whatever its script did
        expect(False, repr(failure))
