"""Renders a clip as files for a contact sheet, reading the exported COLLADA back.

    xvfb-run -a blender --background --factory-startup --python res/render_walker.py -- \
        CLIP.dae OUT_DIR ANGLE_DEGREES COUNT SIZE [CENTRE_Z WIDTH]

An armature-only clip is shown on the mesh of walker.dae.  Angle 0 is the
front, 90 the fox's left side.
"""
import math
import os
import sys

import bpy
from mathutils import Vector

HERE = os.path.dirname(os.path.abspath(__file__))


def load(clip):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.context.scene.render.fps = 30
    bpy.ops.wm.collada_import(filepath=clip)
    rig = next(o for o in bpy.data.objects if o.type == "ARMATURE")
    if not any(o.type == "MESH" for o in bpy.data.objects):
        action = rig.animation_data.action
        bpy.ops.wm.collada_import(filepath=os.path.join(HERE, "walker.dae"))
        mesh = next(o for o in bpy.data.objects if o.type == "MESH")
        rig = mesh.find_armature()
        rig.animation_data.action = action
    return rig.animation_data.action


def set_up(angle, size, centre_z, width):
    scene = bpy.context.scene
    scene.render.engine = "BLENDER_WORKBENCH"
    shading = scene.display.shading
    shading.light, shading.color_type = "STUDIO", "TEXTURE"
    shading.show_backface_culling = False
    scene.view_settings.view_transform = "Standard"
    scene.render.resolution_x = scene.render.resolution_y = size
    scene.world = bpy.data.worlds.new("grey")
    scene.world.color = (.55, .6, .62)
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    scene.collection.objects.link(camera)
    scene.camera = camera
    camera.data.type, camera.data.ortho_scale = "ORTHO", width
    angle = math.radians(angle)
    towards = Vector((math.sin(angle), -math.cos(angle), 0.12))
    camera.location = Vector((0, .12 * abs(math.sin(angle)), centre_z)) + towards * 5
    camera.rotation_euler = (-towards).to_track_quat("-Z", "Y").to_euler()
    bpy.ops.mesh.primitive_plane_add(size=0.9, location=(0, 0, -0.002))


def main():
    clip, out, angle, count, size, *rest = sys.argv[sys.argv.index("--") + 1:]
    action = load(clip)
    centre_z, width = [float(v) for v in rest] or (0.69, 1.5)
    set_up(float(angle), int(size), centre_z, width)
    first, last = action.frame_range
    scene = bpy.context.scene
    for i in range(int(count)):
        frame = first + (last - first) * i / int(count)
        scene.frame_set(int(frame), subframe=frame % 1)
        scene.render.filepath = os.path.join(out, f"{os.path.basename(clip)}-{angle}-{i:02}.png")
        bpy.ops.render.render(write_still=True)


main()
