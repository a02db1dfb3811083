"""Armature and skin weights of the fox."""
import bpy
import numpy as np

import fox_shape as fs
import fox_skeleton
from fox_mesh import neighbour_mean, vertex_positions

SMOOTHING = 5
HEAD_BONES = ("head", "ear")
HAND_BONES = ("forearm", "hand", "thumb", "index", "middle", "little")
LEG_BONES = ("thigh", "shin", "foot", "toe")
# Which joints may move a part; a part not named here follows body, arms and legs.
ALLOWED = {
    fs.EAR: HEAD_BONES, fs.NOSE: ("head",), fs.EYE: ("head",), fs.FUR: ("head", "ear", "neck"),
    fs.PAW: HAND_BONES, fs.CUFF: ("forearm", "hand"),
    fs.TAIL: ("tail", "pelvis"), fs.PACK: ("backpack",), fs.ROLL: ("backpack",),
    fs.SCARF: ("scarf", "neck", "chest", "clavicle"),
    fs.BOOT: ("shin", "foot", "toe"), fs.SOLE: ("foot", "toe"),
    fs.TROUSERS: ("pelvis", "spine1", "thigh", "shin"),
    fs.JACKET: ("pelvis", "spine", "chest", "neck", "clavicle", "upperarm", "forearm"),
    fs.STRAP: ("pelvis", "spine", "chest", "clavicle", "upperarm"),
    fs.BUCKLE: ("spine1",),
}


def build_armature():
    """The skeleton as a Blender armature object."""
    data = bpy.data.armatures.new("Skeleton")
    rig = bpy.data.objects.new("Skeleton", data)
    bpy.context.collection.objects.link(rig)
    bpy.context.view_layer.objects.active = rig
    bpy.ops.object.mode_set(mode="EDIT")
    for name, parent, head, tail in fox_skeleton.joints():
        bone = data.edit_bones.new(name)
        bone.head, bone.tail = head, tail
        bone.parent = data.edit_bones.get(parent) if parent else None
    bpy.ops.object.mode_set(mode="OBJECT")
    return rig


def bind(fox, rig):
    """Heat weights, kept to the parts they belong to, smoothed and normalised."""
    bpy.ops.object.select_all(action="DESELECT")
    fox.select_set(True)
    rig.select_set(True)
    bpy.context.view_layer.objects.active = rig
    bpy.ops.object.parent_set(type="ARMATURE_AUTO")
    names = [name for name, *_ in fox_skeleton.joints()]
    weights = _read(fox, names)
    print("vertices without heat:", int((weights.sum(1) == 0).sum()))
    positions = vertex_positions(fox.data)
    mask = _mask(positions, names)
    weights = _fill(weights * mask, positions, mask)
    _write(fox, names, _smooth(weights, fox.data, mask))


def _read(fox, names):
    weights = np.zeros((len(fox.data.vertices), len(names)))
    column = {fox.vertex_groups[n].index: i for i, n in enumerate(names) if n in fox.vertex_groups}
    for vertex in fox.data.vertices:
        for entry in vertex.groups:
            weights[vertex.index, column[entry.group]] = entry.weight
    return weights


def _mask(positions, names):
    """1 where a joint may move a vertex, from its part and its side of the body."""
    normal_in = fs.gradient(positions) * .003
    kind = fs.material(positions - normal_in)
    mask = np.zeros((len(positions), len(names)))
    for part, allowed in ALLOWED.items():
        column = np.array([name.startswith(allowed) for name in names], float)
        mask[kind == part] = column
    for i, name in enumerate(names):
        if name.endswith("_L"):
            mask[positions[:, 0] < -.02, i] = 0
        if name.endswith("_R"):
            mask[positions[:, 0] > .02, i] = 0
        if name.startswith("foot"):      # the tip of the sole rolls with the toe alone
            mask[positions[:, 1] < fox_skeleton.BALL.y - .03, i] = 0
    return mask


def _fill(weights, positions, mask):
    """Vertices left without weight take the nearest allowed joints'."""
    joints = fox_skeleton.joints()
    for v in np.flatnonzero(weights.sum(1) < 1e-4):
        for i, (_, _, head, tail) in enumerate(joints):
            if mask[v, i]:
                a, b = np.array(head), np.array(tail)
                t = np.clip((positions[v] - a) @ (b - a) / ((b - a) @ (b - a)), 0, 1)
                weights[v, i] = 1 / (np.linalg.norm(positions[v] - a - t * (b - a)) + .01) ** 4
    return weights / weights.sum(1, keepdims=True)


def _smooth(weights, mesh, mask):
    edges = np.array([e.vertices[:] for e in mesh.edges])
    for _ in range(SMOOTHING):
        weights = .5 * weights + .5 * neighbour_mean(weights, edges)
    weights[weights < .004] = 0
    return weights / weights.sum(1, keepdims=True)


def _write(fox, names, weights):
    fox.vertex_groups.clear()
    for i, name in enumerate(names):
        group = fox.vertex_groups.new(name=name)
        for v in np.flatnonzero(weights[:, i]):
            group.add([int(v)], float(weights[v, i]), "REPLACE")
    influences = (weights > 0).sum(1)
    print("joints:", len(names), "most influences:", influences.max(),
          "vertices with five or more:", int((influences >= 5).sum()))
