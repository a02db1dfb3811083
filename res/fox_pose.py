"""A pose of the fox: one rotation per joint, in the axes of the rest pose.

`turns[name]` turns a joint and all below it against its parent; because all
rest joints share the armature's axes, a global turn is the plain product of
the turns from the pelvis down.
"""
import math

from mathutils import Matrix, Quaternion, Vector

import fox_skeleton

JOINTS = {name: (parent, head, tail) for name, parent, head, tail in fox_skeleton.joints()}
X, Y, Z = Vector((1, 0, 0)), Vector((0, 1, 0)), Vector((0, 0, 1))
FORWARD = Vector((0, -1, 0))


def turn(axis, degrees):
    return Quaternion(axis, math.radians(degrees))


def sides():
    """(suffix, +1 or -1, phase shift) of the left and the right half."""
    return (("L", 1, 0.0), ("R", -1, 0.5))


class Pose:
    def __init__(self):
        self.turns = {name: Quaternion() for name in JOINTS}
        self.shift = Vector()          # of the pelvis

    def world(self, name):
        """Global turn of a joint."""
        parent = JOINTS[name][0]
        return (self.world(parent) if parent else Quaternion()) @ self.turns[name]

    def place(self, name):
        """Where the joint's head is."""
        parent, head, _ = JOINTS[name]
        if parent is None:
            return head + self.shift
        return self.place(parent) + self.world(parent) @ (head - JOINTS[parent][1])

    def set_world(self, name, rotation):
        self.turns[name] = self.world(JOINTS[name][0]).inverted() @ rotation

    def spread(self, names, rotation):
        """Shares out a global turn of the last joint evenly over a chain."""
        start = self.world(JOINTS[names[0]][0])
        part = Quaternion().slerp(start.inverted() @ rotation, 1 / len(names))
        for name in names:
            self.turns[name] = part

    def reach(self, side, ankle, foot, toe):
        """Two-bone leg: puts the ankle at a point; foot and toe get global turns."""
        thigh, shin = f"thigh_{side}", f"shin_{side}"
        hip = self.place(thigh)
        upper, lower = [(JOINTS[b][2] - JOINTS[b][1]) for b in (thigh, shin)]
        a, b = upper.length, lower.length
        line = ankle - hip
        span = min(line.length, (a + b) * 0.9995)
        bend = math.acos(max(-1, min(1, (a * a + span * span - b * b) / (2 * a * span))))
        hinge = self.world("pelvis").slerp(foot, 0.5) @ X
        hinge = (hinge - hinge.project(line)).normalized()
        knee = hip + a * (Quaternion(hinge, -bend) @ line.normalized())
        self.set_world(thigh, _aim(upper, knee - hip, hinge))
        self.set_world(shin, _aim(lower, ankle - knee, hinge))
        self.set_world(f"foot_{side}", foot)
        self.set_world(f"toe_{side}", toe)
        return line.length / (a + b)


def _frame(direction, hinge):
    y = direction.normalized()
    x = (hinge - hinge.project(y)).normalized()
    return Matrix((x, y, x.cross(y))).transposed()


def _aim(rest, target, hinge):
    """The turn that takes a bone's rest direction to target, its X axis to hinge."""
    return (_frame(target, hinge) @ _frame(rest, X).transposed()).to_quaternion()


def arm(pose, side, sign, swing, elbow, out=13.0, curl=20.0, raise_by=0.0):
    """Arm hanging `out` degrees off the body, swung back by `swing`, elbow bent forwards."""
    rest_out = math.degrees(math.atan2(fox_skeleton.ARM_DIRECTION.x, -fox_skeleton.ARM_DIRECTION.z))
    direction = Vector((sign * fox_skeleton.ARM_DIRECTION.x, 0, fox_skeleton.ARM_DIRECTION.z))
    palm = Vector((sign * fox_skeleton.PALM_NORMAL.x, 0, fox_skeleton.PALM_NORMAL.z))
    pose.turns[f"clavicle_{side}"] = turn(Y, sign * (5 - raise_by)) @ turn(Z, sign * swing * .12)
    pose.turns[f"upperarm_{side}"] = turn(X, swing) @ turn(Y, sign * (rest_out - out - 5))
    pose.turns[f"forearm_{side}"] = turn(direction.cross(FORWARD), elbow)
    pose.turns[f"hand_{side}"] = turn(direction.cross(FORWARD), -swing * .25) @ turn(direction.cross(palm), 6)
    for finger, share in (("index", .8), ("middle", 1.0), ("little", 1.2)):
        for joint in "12":
            pose.turns[f"{finger}{joint}_{side}"] = turn(direction.cross(palm), curl * share)
    pose.turns[f"thumb1_{side}"] = turn(direction.cross(palm), curl * .4)
