"""A cloth that a slow machine keeps up with: coarse fibres, a small flat piece amid the view, few voxels."""

from window_driver import write_json


def small_cloth(home, name, **other):
    """Writes it, with what is to be otherwise; returns the file."""
    fabric = {
        "loomlight_version": 1, "name": name, "weave": ["#.", ".#"], "fibres": [{"name": "coarse", "radius_um": 20}],
        "drape": {"kind": "flat", "width_mm": 4, "height_mm": 4},
        "light": {"kind": "dome"}, "camera": {"distance_mm": 64, "elevation_deg": 75}, "render": {"resolution": 1},
    }
    return write_json(home, name.lower() + ".json", {**fabric, **other})
