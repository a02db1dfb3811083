"""Makes rigged, animated scenes in Blender, exports each with one set of its COLLADA exporter's options, and writes where
Blender itself has every vertex at the times that the export can know. Run by blender_oracle.py:

    blender --background --factory-startup --python blender_scenes.py -- OUTPUT_FOLDER
"""
import json
import math
import os
import sys

import bpy
from mathutils import Vector

FPS = 24
KEY_FRAMES = (1, 9, 17, 25)
BETWEEN = (5, 13, 21)

# name: (scene, exporter options, whether the motion between the keys is in the file)
#
# Not here, because Blender 3.4 writes what no reader can put right (docs/collada-notes.md): bones with decomposed or
# keyed animation (their rest is left out, quaternions are lost, and the node's elements come in reversed order),
# skins under an armature away from the origin (the bind shape matrix is the mesh's local one), children of bones (they
# start at the bone's tail, the file says its head), "deform bones only" with a control bone in mid-chain (it is taken
# out of the hierarchy with its transform), shape keys (the morph is written, but not instanced), a Y-up root that is
# not applied (the turn is in the bind shape matrix as well, twice), and curves between keys (written as LINEAR).
KEYED_OBJECTS = dict(export_animation_type_selection="keys", export_animation_transformation_type_selection="decomposed",
                     export_object_transformation_type_selection="decomposed")
CASES = {
    "sampled": ("limb", dict(export_animation_type_selection="sample"), True),
    "sampled_matrix": ("limb", dict(export_animation_type_selection="sample", export_animation_transformation_type_selection="matrix"), True),
    "sampled_every_fourth": ("limb", dict(export_animation_type_selection="sample", sampling_rate=4), False),
    "y_up_applied": ("limb", dict(apply_global_orientation=True, export_global_forward_selection="-Z", export_global_up_selection="Y"), True),
    "deform_bones_only": ("controls", dict(deform_bones_only=True), True),
    "with_control_bones": ("controls", dict(deform_bones_only=False), True),
    "bind_info_kept": ("limb", dict(keep_bind_info=True), True),
    "triangulated": ("limb", dict(triangulate=True), True),
    "two_armatures": ("two", {}, True),
    "shape_keys": ("shapes", dict(include_shapekeys=True), True),
    "objects_keyed": ("movers", KEYED_OBJECTS, False),
    "objects_sampled": ("movers", dict(export_animation_type_selection="sample"), True),
}
Y_UP = ("y_up_applied",)


def clear():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.fps = FPS
    scene.frame_start, scene.frame_end = KEY_FRAMES[0], KEY_FRAMES[-1]


def tube(name, height=3.0, rings=13, sides=8, x=0.0):
    """A closed tube along Z from 0 to `height`."""
    points, faces = [], []
    for r in range(rings):
        z = height * r / (rings - 1)
        radius = 0.3 + 0.1 * math.sin(3.0 * z)
        points += [(x + radius * math.cos(2 * math.pi * s / sides), radius * math.sin(2 * math.pi * s / sides), z) for s in range(sides)]
    for r in range(rings - 1):
        for s in range(sides):
            a, b = r * sides + s, r * sides + (s + 1) % sides
            faces.append((a, b, b + sides, a + sides))
    faces += [tuple(reversed(range(sides))), tuple(range((rings - 1) * sides, rings * sides))]
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(points, [], faces)
    mesh.update()
    thing = bpy.data.objects.new(name, mesh)
    bpy.context.collection.objects.link(thing)
    return thing


def armature(name, controls=False, x=0.0):
    """Three bones in a chain with bends and rolls, as no exporter likes them."""
    data = bpy.data.armatures.new(name)
    thing = bpy.data.objects.new(name, data)
    bpy.context.collection.objects.link(thing)
    bpy.context.view_layer.objects.active = thing
    bpy.ops.object.mode_set(mode="EDIT")
    parent = None
    joints = [(x, 0, 0), (x + 0.1, 0.05, 1), (x - 0.05, 0.1, 2), (x, 0, 3)]
    for i in range(3):
        bone = data.edit_bones.new(f"{name}.bone {i}" if i == 1 else f"{name}_bone{i}")
        bone.head, bone.tail, bone.roll = joints[i], joints[i + 1], 0.4 * i
        bone.parent, bone.use_connect = parent, i > 0
        parent = bone
    if controls:  # a bone that deforms nothing, as handles of rigs do
        bone = data.edit_bones.new("handle")
        bone.head, bone.tail, bone.parent = joints[3], (x, 1, 3), parent
        bone.use_deform = False
    bpy.ops.object.mode_set(mode="OBJECT")
    return thing


def animate(arm, phase=0.0):
    for i, bone in enumerate(arm.pose.bones[:3]):
        bone.rotation_mode = "QUATERNION" if i % 2 else "XYZ"
        for k, frame in enumerate(KEY_FRAMES):
            angle = (0.5 + 0.2 * i) * math.sin(phase + 1.3 * k + i)
            if i % 2:
                bone.rotation_quaternion = (math.cos(angle / 2), math.sin(angle / 2) * 0.6, 0.0, math.sin(angle / 2) * 0.8)
                bone.keyframe_insert("rotation_quaternion", frame=frame)
            else:
                bone.rotation_euler = (angle, 0.5 * angle, -0.3 * angle)
                bone.keyframe_insert("rotation_euler", frame=frame)
            if i == 0:
                bone.location = (0.1 * k, -0.2 * math.sin(k), 0.05 * k)
                bone.keyframe_insert("location", frame=frame)
            if i == 2:
                bone.scale = (1.0 + 0.1 * k, 1.0 + 0.1 * k, 1.0 + 0.1 * k)
                bone.keyframe_insert("scale", frame=frame)


def skin(mesh, arm):
    modifier = mesh.modifiers.new("Armature", "ARMATURE")
    modifier.object = arm
    mesh.parent = arm
    for i, bone in enumerate(arm.data.bones[:3]):
        group = mesh.vertex_groups.new(name=bone.name)
        for vertex in mesh.data.vertices:
            weight = max(0.0, 1.0 - abs(vertex.co.z - (i + 0.5)))
            if i == 0 and vertex.co.z < 0.5 or i == 2 and vertex.co.z > 2.5:
                weight = 1.0
            if weight > 0.0:
                group.add([vertex.index], weight, "ADD")
    for vertex in mesh.data.vertices:  # the exporter writes what it finds, Blender normalises: agree beforehand
        total = sum(g.weight for g in vertex.groups)
        for g in vertex.groups:
            g.weight /= total


def keyed(thing, path, values):
    for frame, value in zip(KEY_FRAMES, values):
        setattr(thing, path, value)
        thing.keyframe_insert(path, frame=frame)


def build(scene):
    clear()
    if scene in ("limb", "controls"):
        mesh, arm = tube("Tube"), armature("Rig", scene == "controls")
        skin(mesh, arm)
        animate(arm)
    elif scene == "two":
        for i in range(2):
            mesh, arm = tube(f"Tube{i}", x=4.0 * i), armature(f"Rig{i}", x=4.0 * i)
            skin(mesh, arm)
            animate(arm, 0.7 * i)
    elif scene == "shapes":  # what is exported is the mesh at rest
        mesh = tube("Shape")
        for k in range(3):
            for point in mesh.shape_key_add(name=f"Key{k}").data:
                point.co += Vector((0.2 * k, 0.1 * k, 0.3 * k)) * point.co.z
    elif scene == "movers":  # smooth curves with Blender's own handles; one kind of motion each
        keyed(tube("Slider"), "location", [(0, 0, 0), (1, -2, 0.5), (3, 0.2, -1), (2, 2, 2)])
        keyed(tube("Turner"), "rotation_euler", [(0, 0, 0), (0.5, 1.1, -0.4), (2.5, -0.3, 0.9), (7.0, 0.5, 0.2)])
        keyed(tube("Grower"), "scale", [(1, 1, 1), (2, 1, 0.5), (0.7, 1.5, 1.2), (1, 1, 3)])


def evaluated(frame):
    """World positions of every mesh at a frame, as Blender draws them."""
    bpy.context.scene.frame_set(frame)
    graph = bpy.context.evaluated_depsgraph_get()
    result = {}
    for thing in bpy.context.scene.objects:
        if thing.type != "MESH":
            continue
        shown = thing.evaluated_get(graph)
        mesh = shown.to_mesh()
        result[thing.name] = [c for v in mesh.vertices for c in shown.matrix_world @ v.co]
        shown.to_mesh_clear()
    return result


def main(folder):
    for name, (scene, options, between) in CASES.items():
        build(scene)
        frames = sorted(KEY_FRAMES + (BETWEEN if between else ()))
        reference = {"times": [f / FPS for f in frames], "meshes": [evaluated(f) for f in frames],
                     "up": "Y" if name in Y_UP else "Z"}
        bpy.context.scene.frame_set(KEY_FRAMES[0])
        bpy.ops.wm.collada_export(filepath=os.path.join(folder, name + ".dae"), **options)
        with open(os.path.join(folder, name + ".json"), "w") as out:
            json.dump(reference, out)


main(sys.argv[sys.argv.index("--") + 1])
