"""The joints of the fox, as one table of rest positions in metres.

The fox stands on z = 0 and faces -Y; its left side is +X.  The shape, the
weights and the motion all read their positions from here.
"""
from mathutils import Vector

# The arm hangs out and down in the rest pose, so that sleeve and jacket are
# apart and automatic weights do not leak from one into the other.
_SHOULDER = Vector((0.128, 0.012, 0.790))
ARM_DIRECTION = Vector((0.74, 0.0, -0.67)).normalized()
PALM_NORMAL = Vector((-0.67, 0.0, -0.74)).normalized()
_ELBOW = _SHOULDER + 0.160 * ARM_DIRECTION + Vector((0, 0.008, 0))
_WRIST = _ELBOW + 0.150 * ARM_DIRECTION + Vector((0, -0.014, 0))

HIP = Vector((0.085, 0.010, 0.555))
KNEE = Vector((0.092, -0.006, 0.320))
ANKLE = Vector((0.092, 0.014, 0.095))
BALL = Vector((0.096, -0.105, 0.030))
TOE_TIP = Vector((0.098, -0.180, 0.030))


def hand_point(along, across, out=0.0):
    """A point of the left hand: along the arm, across (+ = backwards), palmwards."""
    return _WRIST + along * ARM_DIRECTION + Vector((0, across, 0)) + out * PALM_NORMAL


# finger name -> its three joints (knuckle, middle, tip)
FINGERS = {
    "index": (hand_point(0.078, -0.038), hand_point(0.110, -0.047, .004), hand_point(0.140, -0.053, .012)),
    "middle": (hand_point(0.084, 0.000), hand_point(0.120, 0.000, .004), hand_point(0.152, 0.000, .012)),
    "little": (hand_point(0.078, 0.037), hand_point(0.107, 0.046, .004), hand_point(0.133, 0.052, .012)),
    "thumb": (hand_point(0.026, -0.034, .012), hand_point(0.052, -0.066, .020), hand_point(0.080, -0.082, .026)),
}

TAIL = [Vector(p) for p in ((0, 0.115, 0.560), (0, 0.215, 0.500), (0, 0.325, 0.470),
                            (0, 0.435, 0.505), (0, 0.520, 0.600))]
SCARF = [Vector(p) for p in ((0.075, 0.075, 0.885), (0.160, 0.150, 0.905),
                             (0.222, 0.230, 0.870), (0.268, 0.300, 0.795))]
# The head was drawn smaller and then grown about its base: a big head is friendlier.
HEAD_BASE = Vector((0, 0, 0.945))
HEAD_GROWTH = 1.13
EAR_DRAWN = [Vector(p) for p in ((0.108, 0.020, 1.150), (0.146, 0.026, 1.235),
                                 (0.186, 0.036, 1.330))]
EAR = [HEAD_BASE + HEAD_GROWTH * (p - HEAD_BASE) for p in EAR_DRAWN]


def _centre_joints():
    return [
        ("pelvis", None, (0, .012, .560), (0, .012, .625)),
        ("spine1", "pelvis", (0, .012, .625), (0, .012, .685)),
        ("spine2", "spine1", (0, .012, .685), (0, .012, .745)),
        ("chest", "spine2", (0, .012, .745), (0, .012, .835)),
        ("neck", "chest", (0, .012, .835), (0, .000, .910)),
        ("head", "neck", (0, .000, .910), (0, .000, 1.180)),
        ("backpack", "chest", (0, .195, .630), (0, .195, .800)),
    ]


def _chain(names, parent, points):
    joints = []
    for name, head, tail in zip(names, points, points[1:]):
        joints.append((name, parent, head, tail))
        parent = name
    return joints


def _left_joints():
    joints = [
        ("clavicle", "chest", Vector((.030, .012, .800)), _SHOULDER),
        ("upperarm", "clavicle", _SHOULDER, _ELBOW),
        ("forearm", "upperarm", _ELBOW, _WRIST),
        ("hand", "forearm", _WRIST, hand_point(0.078, 0)),
        ("thigh", "pelvis", HIP, KNEE),
        ("shin", "thigh", KNEE, ANKLE),
        ("foot", "shin", ANKLE, BALL),
        ("toe", "foot", BALL, TOE_TIP),
    ]
    joints += _chain(["ear1", "ear2"], "head", EAR)
    for finger, points in FINGERS.items():
        joints += _chain([finger + "1", finger + "2"], "hand", points)
    return joints


def _sided(joints, side):
    """Left joints as they are, or mirrored to the right; names get _L or _R."""
    sign = 1 if side == "L" else -1
    left_names = {name for name, *_ in joints}
    out = []
    for name, parent, head, tail in joints:
        if parent in left_names:
            parent = f"{parent}_{side}"
        flip = [Vector((sign * p[0], p[1], p[2])) for p in (head, tail)]
        out.append((f"{name}_{side}", parent, *flip))
    return out


def joints():
    """All joints, parents first, as (name, parent or None, head, tail)."""
    table = _centre_joints()
    table += _chain([f"tail{i}" for i in range(1, 5)], "pelvis", TAIL)
    table += _chain([f"scarf{i}" for i in range(1, 4)], "neck", SCARF)
    for side in "LR":
        table += _sided(_left_joints(), side)
    return [(name, parent, Vector(head), Vector(tail)) for name, parent, head, tail in table]
