"""Walk, run and idle as functions of the phase (0..1) that return a Pose."""
import math
from dataclasses import dataclass

from mathutils import Quaternion, Vector

import fox_skeleton as sk
from fox_pose import X, Y, Z, Pose, arm, sides, turn

FPS = 30
HEEL = Vector((0, 0.078, 0.0))      # where the sole first touches the ground
TIP = Vector((0, -0.178, 0.0))      # and where it leaves it


@dataclass
class Gait:
    frames: int
    speed: float              # metres a second
    toe_off: float            # phases within one foot's cycle, 0 = heel strike
    flat: float
    heel_off: float
    tip_roll: float
    strike_pitch: float       # degrees, negative = toes up
    off_pitch: float
    tip_pitch: float
    middle: float             # phase at which the ankle is below the hip
    lift: float               # extra height of the ankle in the swing
    kick: float               # extra pitch in the swing
    bob: float
    bob_top: float            # phase of the body's highest point
    stretch: float            # greatest share of the leg's length in use
    lean: float
    pelvis_yaw: float
    pelvis_roll: float
    sway: float
    chest_yaw: float
    arm_swing: float
    elbow: float
    elbow_swing: float
    curl: float
    arm_out: float            # degrees the arms hang off the body
    flutter: float            # how much ears, tail, scarf and pack follow


WALK = Gait(frames=30, speed=0.72, toe_off=.62, flat=.12, heel_off=.33, tip_roll=.54,
            strike_pitch=-22, off_pitch=58, tip_pitch=30, middle=.30, lift=.030, kick=6,
            bob=.014, bob_top=.36, stretch=.985, lean=4, pelvis_yaw=9, pelvis_roll=4, sway=.016,
            chest_yaw=10, arm_swing=27, elbow=20, elbow_swing=14, curl=20, arm_out=17, flutter=1.0)
RUN = Gait(frames=20, speed=1.95, toe_off=.37, flat=.05, heel_off=.13, tip_roll=.29,
           strike_pitch=-10, off_pitch=62, tip_pitch=34, middle=.16, lift=.115, kick=38,
           bob=.034, bob_top=.44, stretch=.985, lean=13, pelvis_yaw=11, pelvis_roll=5, sway=.008,
           chest_yaw=15, arm_swing=40, elbow=82, elbow_swing=16, curl=42, arm_out=21, flutter=1.8)


def _smooth(t):
    t = max(0.0, min(1.0, t))
    return t * t * (3 - 2 * t)


def _wave(phase, turns=1, lag=0.0):
    return math.sin(2 * math.pi * (turns * phase - lag))


def _stance(gait, u):
    """Ankle (relative to its rest place), foot pitch and toe pitch while on the ground."""
    travel = Vector((0, gait.speed * gait.frames / FPS * (u - gait.middle), 0))
    side_free = Vector((0, sk.ANKLE.y, sk.ANKLE.z))
    if u < gait.flat:
        t = u / gait.flat
        pitch = gait.strike_pitch * (1 - t) ** 2
        ankle = HEEL + turn(X, pitch) @ (side_free - HEEL)
        return ankle - side_free + travel, pitch, pitch
    pitch = gait.off_pitch * max(0, (u - gait.heel_off) / (gait.toe_off - gait.heel_off)) ** 1.7
    toe = gait.tip_pitch * max(0, (u - gait.tip_roll) / (gait.toe_off - gait.tip_roll)) ** 2
    ball_rest = Vector((0, sk.BALL.y, sk.BALL.z))
    ball = TIP + turn(X, toe) @ (ball_rest - TIP)
    ankle = ball + turn(X, pitch) @ (side_free - ball_rest)
    return ankle - side_free + travel, pitch, toe


def _hermite(a, va, b, vb, t):
    return (a * (2 * t ** 3 - 3 * t * t + 1) + va * (t ** 3 - 2 * t * t + t)
            + b * (3 * t * t - 2 * t ** 3) + vb * (t ** 3 - t * t))


def _foot(gait, u):
    """Ankle offset, foot pitch and toe pitch at phase u of this foot."""
    u %= 1.0
    if u <= gait.toe_off:
        return _stance(gait, u)
    step = 1e-4
    span = 1 - gait.toe_off
    t = (u - gait.toe_off) / span
    start, start_early = _stance(gait, gait.toe_off), _stance(gait, gait.toe_off - step)
    end, end_late = _stance(gait, 0), _stance(gait, step)
    ankle, pitch, _ = (
        _hermite(a, (a - early) * (span / step), b, (late - b) * (span / step), t)
        for a, early, b, late in zip(start, start_early, end, end_late))
    bump = math.sin(math.pi * t) ** 2
    ankle = ankle + Vector((0, 0, gait.lift * bump))
    pitch += gait.kick * math.sin(math.pi * min(1, t * 1.4)) ** 2
    toe = pitch + (start[2] - start[1]) * (1 - _smooth(t * 2.2))
    return ankle, pitch, toe


def _trunk(gait, u, drop):
    pose = Pose()
    height = gait.bob * math.cos(4 * math.pi * (u - gait.bob_top)) - drop
    pose.shift = Vector((gait.sway * _wave(u, 1, .05), .008 * _wave(u, 2, .1), height))
    swing = math.cos(2 * math.pi * u)
    pose.turns["pelvis"] = (turn(Z, -gait.pelvis_yaw * swing) @ turn(X, gait.lean * .6)
                            @ turn(Y, -gait.pelvis_roll * _wave(u, 1, -.08)))
    chest = (turn(Z, gait.chest_yaw * swing) @ turn(X, gait.lean + 1.2 * _wave(u, 2, .2))
             @ turn(Y, gait.pelvis_roll * .5 * _wave(u, 1, -.08)))
    pose.spread(("spine1", "spine2", "chest"), chest)
    pose.spread(("neck", "head"), turn(X, gait.lean * .15 + 1.5 * _wave(u, 2, .3)) @ turn(Z, 1.5 * swing))
    return pose


def _legs(gait, pose, u):
    """Puts both feet; returns how far the more stretched leg reaches (share of its length)."""
    reach = 0
    for side, sign, shift in sides():
        ankle, pitch, toe = _foot(gait, u + shift)
        rest = Vector((sign * sk.ANKLE.x, sk.ANKLE.y, sk.ANKLE.z))
        narrow = Vector((-sign * .012, 0, 0))        # feet step nearer the middle line
        reach = max(reach, pose.reach(side, rest + ankle + narrow, turn(X, pitch), turn(X, toe)))
    return reach


def _followers(pose, u, amount, beat=2):
    """Ears, tail, scarf and backpack move a little later than the body."""
    for side, sign, _ in sides():
        for i in (1, 2):
            pose.turns[f"ear{i}_{side}"] = turn(X, -4 * amount * _wave(u, beat, .18 + .1 * i))
    for i in range(1, 5):
        pose.turns[f"tail{i}"] = (turn(Z, 7 * amount ** .5 * _wave(u, 1, .12 * i))
                                  @ turn(X, 3.5 * amount * _wave(u, beat, .15 + .12 * i)))
    for i in range(1, 4):
        pose.turns[f"scarf{i}"] = (turn(X, 6 * amount * _wave(u, beat, .1 + .17 * i) + 3 * (amount - 1))
                                   @ turn(Z, 6 * amount * _wave(u, 1, .1 + .15 * i)))
    pose.turns["backpack"] = turn(X, 1.6 * amount * _wave(u, beat, .22))


def _gait_pose(gait, u, drop):
    pose = _trunk(gait, u, drop)
    for side, sign, shift in sides():
        swing = math.cos(2 * math.pi * (u + shift - .02))
        elbow = gait.elbow - gait.elbow_swing * math.cos(2 * math.pi * (u + shift - .08))
        arm(pose, side, sign, gait.arm_swing * swing, elbow, gait.arm_out, gait.curl,
            raise_by=1.5 * _wave(u, 2, .25))
    _followers(pose, u, gait.flutter)
    return pose, _legs(gait, pose, u)


def gait_clip(gait):
    """All frames of a gait, the body as high as the legs' length allows."""
    low, high = 0.0, 0.2
    for _ in range(24):
        drop = (low + high) / 2
        worst = max(_gait_pose(gait, i / gait.frames, drop)[1] for i in range(gait.frames))
        low, high = (drop, high) if worst > gait.stretch else (low, drop)
    return [_gait_pose(gait, i % gait.frames / gait.frames, high)[0] for i in range(gait.frames + 1)]


IDLE_FRAMES = 90


def _idle_pose(u):
    pose = Pose()
    breath = _wave(u, 1)
    pose.shift = Vector((.010 * _wave(u, 1, .1), 0, -.012 + .004 * breath))
    pose.turns["pelvis"] = turn(Y, 1.2 * _wave(u, 1, .1))
    pose.spread(("spine1", "spine2", "chest"), turn(X, 2 - 2.2 * breath) @ turn(Z, 3 * _wave(u, 1, .2)))
    look = 17 * _wave(u, 1, .12) + 6 * _wave(u, 2, .05)
    pose.spread(("neck", "head"), turn(Z, look) @ turn(X, 2 * _wave(u, 2, .1)) @ turn(Y, 3 * _wave(u, 1, .3)))
    for side, sign, shift in sides():
        arm(pose, side, sign, 2 * _wave(u, 1, .2), 20 + 2 * breath, out=15, curl=22 + 3 * breath,
            raise_by=2 * breath)
        ankle = Vector((sign * sk.ANKLE.x, sk.ANKLE.y, sk.ANKLE.z))
        pose.reach(side, ankle, Quaternion(), Quaternion())
    _followers(pose, u, .5, beat=2)
    for i in range(1, 5):       # a slow wag
        pose.turns[f"tail{i}"] = turn(Z, 9 * _wave(u, 1, .1 * i)) @ turn(X, 2 * _wave(u, 2, .1 * i))
    return pose


def idle_clip():
    return [_idle_pose(i % IDLE_FRAMES / IDLE_FRAMES) for i in range(IDLE_FRAMES + 1)]
