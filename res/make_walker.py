"""Makes the fox: mesh, texture, skeleton, skin and clips, exported as COLLADA.

    blender -t 1 --background --factory-startup --python res/make_walker.py

One thread, because decimation on several gives a slightly other mesh each time.
"""
import os
import re
import sys

import bpy

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)

import fox_bake  # noqa: E402
import fox_mesh  # noqa: E402
import fox_motion  # noqa: E402
import fox_paint  # noqa: E402
import fox_weights  # noqa: E402

FIXED_DATE = "2024-01-01T00:00:00"
TEXTURE = os.path.join(HERE, "walker.png")


def start_scene():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.context.scene.render.fps = fox_motion.FPS
    bpy.context.preferences.filepaths.save_version = 0


def paint(fox):
    """Bakes the texture and gives the mesh the one material that shows it."""
    fox_bake.unwrap(fox)
    positions = fox_mesh.vertex_positions(fox.data)
    fox_bake.write_png(TEXTURE, fox_bake.bake(fox, positions, fox_paint.colour))
    material = bpy.data.materials.new("Fox")
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    image = nodes.new("ShaderNodeTexImage")
    image.image = bpy.data.images.load(TEXTURE)
    surface = nodes["Principled BSDF"]
    surface.inputs["Roughness"].default_value = 0.9
    surface.inputs["Specular"].default_value = 0.1
    links.new(image.outputs["Color"], surface.inputs["Base Color"])
    fox.data.materials.append(material)


def set_action(rig, name, poses):
    """Keys every joint's turn, and the pelvis' place, on every frame."""
    action = bpy.data.actions.new(name)
    rig.animation_data_create().action = action
    for bone in rig.data.bones:
        rest = bone.matrix_local.to_quaternion()
        turns = [rest.inverted() @ pose.turns[bone.name] @ rest for pose in poses]
        for before, after in zip(turns, turns[1:]):
            after.make_compatible(before)
        path = f'pose.bones["{bone.name}"].'
        _key(action, path + "rotation_quaternion", turns, bone.name)
        if bone.parent is None:
            shifts = [rest.inverted() @ pose.shift for pose in poses]
            _key(action, path + "location", shifts, bone.name)
    scene = bpy.context.scene
    scene.frame_start, scene.frame_end = 0, len(poses) - 1
    scene.frame_set(0)


def _key(action, path, values, group):
    for index in range(len(values[0])):
        curve = action.fcurves.new(path, index=index, action_group=group)
        curve.keyframe_points.add(len(values))
        for frame, (point, value) in enumerate(zip(curve.keyframe_points, values)):
            point.co = frame, value[index]
            point.interpolation = "LINEAR"


def export(name, objects, sampling=1):
    path = os.path.join(HERE, name)
    bpy.ops.object.select_all(action="DESELECT")
    for item in objects:
        item.select_set(True)
    bpy.context.view_layer.objects.active = objects[0]
    bpy.ops.wm.collada_export(
        filepath=path, selected=True, include_children=False, include_armatures=True,
        deform_bones_only=False, include_animations=True, include_all_actions=False,
        export_animation_type_selection="sample", sampling_rate=sampling, keep_flat_curves=True,
        use_texture_copies=False, triangulate=True, limit_precision=True)
    tidy(path)


def tidy(path):
    """Fixed dates and a relative texture path, so that each run gives the same bytes."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    text = re.sub(r"<(created|modified)>[^<]*<", rf"<\1>{FIXED_DATE}<", text)
    text = re.sub(r"<init_from>[^<]*walker\.png<", "<init_from>walker.png<", text)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def main():
    start_scene()
    fox = fox_mesh.build_object()
    paint(fox)
    rig = fox_weights.build_armature()
    fox_weights.bind(fox, rig)
    set_action(rig, "walk", fox_motion.gait_clip(fox_motion.WALK))
    export("walker.dae", [rig, fox])
    set_action(rig, "run", fox_motion.gait_clip(fox_motion.RUN))
    export("walker-run.dae", [rig])
    set_action(rig, "idle", fox_motion.idle_clip())
    export("walker-idle.dae", [rig], sampling=2)


main()
