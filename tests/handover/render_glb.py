"""Loads a .glb of a hand-over into Blender and renders it; for `blender -b --python render_glb.py -- GLB OUT LIGHT`.

LIGHT is dome (white from above) or lamp (parallel light, 45 degrees above the right edge). The swatch is seen from
straight above, a tenth of it across, without perspective."""

import math
import sys

import bpy
import numpy

numpy.bool = bool  # Debian 12 has an importer that is older than its NumPy

glb, out, light = sys.argv[sys.argv.index("--") + 1 :]
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.import_scene.gltf(filepath=glb)
scene = bpy.context.scene
swatches = [thing for thing in scene.objects if thing.type == "MESH"]
assert len(swatches) == 1, f"expected one swatch, got {len(swatches)}"
across, up, depth = (1000 * side for side in swatches[0].dimensions)
print(f"swatch {across:.3f} x {max(up, depth):.3f} mm, {len(bpy.data.images)} pictures")
middle = sum((swatches[0].matrix_world @ corner.co for corner in swatches[0].data.vertices), start=0 * swatches[0].location)
middle /= len(swatches[0].data.vertices)
# glTF's z is up; Blender turns it to lie in its xz-plane, the face towards -y.
camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
camera.data.type = "ORTHO"
camera.data.ortho_scale = 0.01
camera.data.clip_start = 0.001
camera.location = (middle.x, middle.y - 0.2, middle.z)
camera.rotation_euler = (math.pi / 2, 0, 0)
scene.collection.objects.link(camera)
scene.camera = camera
scene.world = bpy.data.worlds.new("world")
scene.world.use_nodes = True
background = scene.world.node_tree.nodes["Background"]
background.inputs["Color"].default_value = (1, 1, 1, 1)
background.inputs["Strength"].default_value = 1 if light == "dome" else 0
if light == "lamp":
    lamp = bpy.data.objects.new("lamp", bpy.data.lights.new("lamp", "SUN"))
    lamp.data.energy = math.pi / math.cos(math.pi / 4)  # white paper shows radiance 1
    lamp.data.angle = 0
    lamp.rotation_euler = (math.pi / 2, 0, math.pi / 4)
    scene.collection.objects.link(lamp)
scene.render.engine = "CYCLES"
scene.cycles.samples = 16
scene.cycles.use_denoising = False
scene.view_settings.view_transform = "Standard"
scene.render.resolution_x = scene.render.resolution_y = 256
scene.render.image_settings.file_format = "PNG"
scene.render.filepath = out
bpy.ops.render.render(write_still=True)
