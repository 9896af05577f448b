"""The cloth itself above what Blender makes of its maps, under three lights: side_by_side.py FABRIC FOLDER OUT STOPS.

FOLDER is one that the fabric has been handed over into. Both see 10 mm from straight above, without perspective, where
white paper shows radiance 1, and are brightened by as many stops. LOOMLIGHT is the program where it is not in the path."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
PROGRAM = os.environ.get("LOOMLIGHT", "loomlight")
DISTANCE_MM = 28.356  # from which a camera without perspective sees 10 mm
LIGHTS = {
    "dome": {"kind": "dome"},
    "lamp": {"kind": "directional", "azimuth_deg": 0, "elevation_deg": 45, "intensity": 1.41421},
    "grazing": {"kind": "directional", "azimuth_deg": 0, "elevation_deg": 15, "intensity": 3.86370},
}


def ours(fabric, light, out, stops, scratch):
    """Of even yarns in an even sett, as the tile is."""
    even = {"evenness_cv_percent": 0, "slubs_per_m": 0, "shade_variation_percent": 0}
    yarns = [{**yarn, **even} for yarn in fabric["yarns"]]
    scene = {**fabric, "sett_cv_percent": 0, "yarns": yarns, "light": light,
             "drape": {"kind": "flat", "width_mm": 20, "height_mm": 20},
             "camera": {"azimuth_deg": -90, "elevation_deg": 90, "distance_mm": DISTANCE_MM, "fov_deg": 0}}
    file = os.path.join(scratch, "scene.json")
    with open(file, "w", encoding="utf-8") as text:
        json.dump(scene, text)
    subprocess.run([PROGRAM, "render", file, "-o", out, "--size", "256x256", "--spp", "64", "--tone", "plain",
                    "--exposure", stops], check=True)


def main(fabric_file, folder, out, stops):
    with open(fabric_file, encoding="utf-8") as text:
        fabric = json.load(text)
    glb = next(file for file in pathlib.Path(folder).glob("*.glb") if not file.stem.endswith("_back"))
    with tempfile.TemporaryDirectory() as scratch:
        rows = [[], []]
        for light, told in LIGHTS.items():
            for row, name in zip(rows, ("ours", "blender")):
                row.append(os.path.join(scratch, f"{name}.{light}.png"))
            ours(fabric, told, rows[0][-1], stops, scratch)
            subprocess.run(["blender", "-b", "--factory-startup", "--python-exit-code", "1", "--python", HERE / "render_glb.py", "--", glb,
                            rows[1][-1], light, stops], check=True, stdout=subprocess.DEVNULL)
        subprocess.run(["montage", *rows[0], *rows[1], "-tile", "3x2", "-geometry", "256x256+4+4", "-background",
                        "white", "-strip", out], check=True)


main(*sys.argv[1:])
