"""Loads a .glb of a hand-over into Blender and renders it; for `blender -b --python render_glb.py -- GLB OUT LIGHT
[STOPS]`.

LIGHT is dome (white from above), lamp (parallel light, 45 degrees above the right edge) or grazing (75 degrees). The
swatch is seen from straight above, a tenth of it across, without perspective."""

import math
import sys

import bpy
import numpy

numpy.bool = bool  # Debian 12 has an importer that is older than its NumPy

SEEN_M = 0.01
PIXELS = 256
LAMPS_DEG = {"lamp": 45, "grazing": 75}  # from the normal


def load(glb):
    """The one object of the file."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=glb)
    swatches = [thing for thing in bpy.context.scene.objects if thing.type == "MESH"]
    assert len(swatches) == 1, f"expected one swatch, got {len(swatches)}"
    return swatches[0]


def corners(swatch):
    """Left, right, lower and upper edge in m: Blender turns the swatch to lie in its xz-plane, the face to -y."""
    places = [swatch.matrix_world @ corner.co for corner in swatch.data.vertices]
    across, up = [place.x for place in places], [place.z for place in places]
    return min(across), max(across), min(up), max(up)


def look_at(swatch):
    left, right, low, high = corners(swatch)
    scene = bpy.context.scene
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.data.type = "ORTHO"
    camera.data.ortho_scale = SEEN_M
    camera.data.clip_start = 0.001
    camera.location = ((left + right) / 2, -0.2, (low + high) / 2)
    camera.rotation_euler = (math.pi / 2, 0, 0)
    scene.collection.objects.link(camera)
    scene.camera = camera


def light_by(kind):
    """White paper shows radiance 1 in every one of them."""
    scene = bpy.context.scene
    scene.world = bpy.data.worlds.new("world")
    scene.world.use_nodes = True
    background = scene.world.node_tree.nodes["Background"]
    background.inputs["Color"].default_value = (1, 1, 1, 1)
    background.inputs["Strength"].default_value = 1 if kind == "dome" else 0
    if kind in LAMPS_DEG:
        angle = math.radians(LAMPS_DEG[kind])
        lamp = bpy.data.objects.new("lamp", bpy.data.lights.new("lamp", "SUN"))
        lamp.data.energy = math.pi / math.cos(angle)
        lamp.data.angle = 0
        lamp.rotation_euler = (math.pi / 2, 0, angle)
        scene.collection.objects.link(lamp)


def lay_black_below(swatch):
    """So that holes show what they show of our cloth: nothing."""
    left, right, low, high = corners(swatch)
    bpy.ops.mesh.primitive_plane_add(size=1, location=((left + right) / 2, 0.005, (low + high) / 2),
                                     rotation=(math.pi / 2, 0, 0))
    card = bpy.context.object
    card.scale = (right - left, high - low, 1)
    black = bpy.data.materials.new("black")
    black.use_nodes = True
    tree = black.node_tree
    tree.nodes.clear()
    tree.links.new(tree.nodes.new("ShaderNodeEmission").outputs[0], tree.nodes.new("ShaderNodeOutputMaterial").inputs[0])
    tree.nodes["Emission"].inputs["Strength"].default_value = 0
    card.data.materials.append(black)


def render(out, samples=16, stops=0.0):
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.samples = samples
    scene.cycles.use_denoising = False
    scene.view_settings.view_transform = "Standard"
    scene.view_settings.exposure = stops
    scene.render.resolution_x = scene.render.resolution_y = PIXELS
    scene.render.image_settings.file_format = "PNG"
    scene.render.filepath = out
    bpy.ops.render.render(write_still=True)


if __name__ == "__main__":
    glb, out, light, *stops = sys.argv[sys.argv.index("--") + 1 :]
    swatch = load(glb)
    left, right, low, high = corners(swatch)
    print(f"swatch {1000 * (right - left):.3f} x {1000 * (high - low):.3f} mm, {len(bpy.data.images)} pictures")
    look_at(swatch)
    lay_black_below(swatch)
    light_by(light)
    render(out, samples=64, stops=float(stops[0]) if stops else 0.0)
