"""The body of the fox as a distance field made of named parts.

Every part has a material.  The same field gives the surface (where the soft
union of all parts is zero), the material of a texel (the nearest part) and
the soft shadow in creases (how fast the field grows along the normal).
"""
import numpy as np

import fox_skeleton as sk
from fox_field import (box, ellipsoid, mirrored, round_cone, smooth_cut, smooth_union, squash,
                       tube, turn_z)

(FUR, NOSE, EYE, EAR, PAW, JACKET, STRAP, BUCKLE, TROUSERS, BOOT, SOLE, TAIL, SCARF, PACK, ROLL,
 CUFF) = range(16)

EYE_CENTRE = (0.080, -0.118, 1.062)
EYE_RADII = (0.049, 0.036, 0.060)
EYE_TURN = 0.42      # eyes look a little outwards, around the head
BELT_HEIGHT = 0.618
STRAP_X = 0.082


def to_head(p):
    """Places on the grown head as places on the head as drawn."""
    base = np.array(sk.HEAD_BASE, np.float32)
    return ((p - base) / sk.HEAD_GROWTH + base).astype(np.float32)


def grown(part):
    """A part of the head, drawn small, at its full size."""
    return lambda p: sk.HEAD_GROWTH * part(to_head(p))


def _skull(p):
    m = mirrored(p)
    d = ellipsoid(p, (0, 0.005, 1.040), (0.188, 0.168, 0.158))
    d = smooth_union(d, ellipsoid(m, (0.105, -0.040, 0.968), (0.088, 0.080, 0.066)), 0.05)
    d = smooth_union(d, round_cone(m, (0.15, -0.02, 0.968), (0.252, 0.0, 0.938), .046, .007), .03)
    d = smooth_union(d, round_cone(m, (0.15, -0.01, 0.995), (0.232, .015, 1.000), .038, .006), .02)
    d = smooth_union(d, round_cone(p, (0, -0.10, 0.988), (0, -0.232, 0.972), .078, .032), .05)
    for root, tip in (((0, -.06, 1.175), (.012, -.128, 1.256)), ((.03, -.035, 1.180), (.066, -.075, 1.244)),
                      ((-.028, -.035, 1.180), (-.052, -.080, 1.250))):
        d = smooth_union(d, round_cone(p, root, tip, .034, .007), .018)
    return d


def _ear(p):
    m = mirrored(p)
    base, _, tip = [tuple(v) for v in sk.EAR_DRAWN]
    outer = squash(m, base, (-.2, .98, 0), 0.48, lambda q: round_cone(q, base, tip, .084, .017))
    end = [b + .86 * (t - b) for b, t in zip(base, tip)]     # stays off the thin tip
    cup = [(b[0] - .006, b[1] - .040, b[2]) for b in (base, end)]
    inner = squash(m, cup[0], (-.2, .98, 0), 0.5, lambda q: round_cone(q, cup[0], cup[1], .062, .012))
    return smooth_cut(outer, inner, 0.012)


def _eye(p):
    return ellipsoid(turn_z(mirrored(p), EYE_CENTRE, -EYE_TURN), EYE_CENTRE, EYE_RADII)


def _torso(p):
    def body(q):
        d = round_cone(q, (0, .01, .655), (0, .01, .765), .128, .108)
        skirt = round_cone(q, (0, .01, .630), (0, .01, .568), .128, .184)
        return smooth_union(d, skirt, .03)
    return np.maximum(squash(p, (0, .01, 0), (0, 1, 0), 0.90, body), .520 - p[:, 2])


def arm_points():
    table = {name: (head, tail) for name, _, head, tail in sk.joints()}
    return table["upperarm_L"][0], table["forearm_L"][0], table["forearm_L"][1]


def _sleeve(p):
    shoulder, elbow, wrist = arm_points()
    cuff = wrist - 0.012 * sk.ARM_DIRECTION
    inside = shoulder - 0.05 * sk.ARM_DIRECTION
    m = mirrored(p)
    along = (m - np.array(cuff, np.float32)) @ np.array(sk.ARM_DIRECTION, np.float32)
    return np.maximum(tube(m, (inside, shoulder, elbow, cuff), (.055, .060, .052, .060)), along - .004)


def _cuff(p):
    _, _, wrist = arm_points()
    m = mirrored(p)
    ring = round_cone(m, wrist - .022 * sk.ARM_DIRECTION, wrist - .006 * sk.ARM_DIRECTION, .064, .064)
    along = (m - np.array(wrist, np.float32)) @ np.array(sk.ARM_DIRECTION, np.float32)
    return np.maximum(ring, np.abs(along + .014) - .021)


def _hand(p):
    _, _, wrist = arm_points()
    m = mirrored(p)
    normal = tuple(sk.PALM_NORMAL)
    middle = wrist + .050 * sk.ARM_DIRECTION
    d = squash(m, tuple(middle), normal, 0.62, lambda q: round_cone(
        q, wrist + .010 * sk.ARM_DIRECTION, wrist + .066 * sk.ARM_DIRECTION, .040, .050))
    for name, points in sk.FINGERS.items():
        radii = (.021, .020, .015) if name != "thumb" else (.025, .021, .015)
        d = smooth_union(d, tube(m, points, radii), .010)
    return d


def _belt(p):
    return np.maximum(_torso(p) - .008, np.abs(p[:, 2] - BELT_HEIGHT) - .022)


def _straps(p):
    """A shell around jacket and shoulder, cut to two vertical bands."""
    m = mirrored(p)
    shell = smooth_union(_torso(p), _sleeve(p), .04) - .005
    band = np.maximum(np.abs(m[:, 0] - STRAP_X) - .020, BELT_HEIGHT + .02 - p[:, 2])
    return np.maximum(shell, band)


def _buckle(p):
    return box(p, (0, -.138, BELT_HEIGHT), (.032, .016, .028), .010)


def _trousers(p):
    m = mirrored(p)
    d = ellipsoid(p, (0, .012, .540), (.138, .118, .078))
    leg = tube(m, (sk.HIP, sk.KNEE, (.092, .004, .245)), (.081, .076, .079))
    d = np.maximum(smooth_union(d, leg, .03), .208 - p[:, 2])      # tucked into the boots
    return np.maximum(d, p[:, 2] - .570)                            # and under the jacket


def _boot(p):
    m = mirrored(p)
    d = round_cone(m, (.092, .010, .205), (.092, .014, .095), .062, .054)
    d = smooth_union(d, ellipsoid(m, (.092, .008, .205), (.083, .083, .030)), .006)
    d = smooth_union(d, round_cone(m, (.092, .026, .062), (.095, -.075, .058), .052, .054), .03)
    d = smooth_union(d, ellipsoid(m, (.096, -.118, .050), (.066, .074, .056)), .03)
    return np.maximum(d, .012 - p[:, 2])


def _sole(p):
    m = mirrored(p)
    flat = m.copy()
    flat[:, 2] = 0
    outline = tube(flat, ((.092, .030, 0), (.094, -.040, 0), (.097, -.122, 0)), (.052, .050, .067))
    edge = np.stack([outline + .008, np.abs(p[:, 2] - .015) - .015 + .008], 1)
    return np.linalg.norm(np.maximum(edge, 0), axis=1) + np.minimum(edge.max(1), 0) - .008


def _tail(p):
    return tube(p, sk.TAIL + [sk.TAIL[-1] + (sk.TAIL[-1] - sk.TAIL[-2]) * .25],
                (.034, .064, .090, .080, .034, .006))


def _scarf_ring(p):
    q = p - np.array((0, .010, .868), np.float32)
    q[:, 2] += q[:, 1] * 0.22      # lower in front
    ring = np.sqrt(q[:, 0] ** 2 + (q[:, 1] * 1.05) ** 2) - .088
    return np.sqrt(ring ** 2 + (q[:, 2] * .95) ** 2) - .044


def _scarf_end(p):
    flat = (.76, -.64, .10)        # thin across, wide up and down
    return squash(p, sk.SCARF[1], flat, 0.36, lambda q: tube(q, sk.SCARF, (.036, .046, .054, .060)))


def _pack(p):
    d = box(p, (0, .190, .700), (.108, .066, .105), .040)
    d = smooth_union(d, box(p, (0, .196, .765), (.116, .076, .044), .030), .006)
    d = smooth_union(d, box(p, (0, .258, .672), (.064, .026, .046), .018), .006)
    side = ellipsoid(mirrored(p), (.110, .190, .665), (.034, .046, .052))
    return smooth_union(d, side, .006)


def _roll(p):
    across = np.sqrt((p[:, 1] - .205) ** 2 + (p[:, 2] - .846) ** 2) - .046
    ends = np.abs(p[:, 0]) - .124
    edge = np.stack([across + .014, ends + .014], 1)
    return np.linalg.norm(np.maximum(edge, 0), axis=1) + np.minimum(edge.max(1), 0) - .014


# (material, softness of the join with what came before, distance)
PARTS = [
    (TROUSERS, .010, _trousers),
    (BOOT, .008, _boot),
    (SOLE, .004, _sole),
    (JACKET, .006, _torso),
    (JACKET, .035, _sleeve),
    (CUFF, .006, _cuff),
    (PAW, .008, _hand),
    (STRAP, .008, _belt),
    (STRAP, .010, _straps),
    (BUCKLE, .004, _buckle),
    (TAIL, .012, _tail),
    (PACK, .008, _pack),
    (ROLL, .006, _roll),
    (FUR, .010, lambda p: round_cone(p, (0, .012, .82), (0, 0, .95), .06, .06)),
    (FUR, .030, grown(_skull)),
    (EAR, .025, grown(_ear)),
    (NOSE, .006, grown(lambda p: ellipsoid(p, (0, -.258, .990), (.027, .021, .020)))),
    (EYE, .006, grown(_eye)),
    (SCARF, .008, _scarf_ring),
    (SCARF, .012, _scarf_end),
]


def distance(points):
    """Signed distance of the whole fox."""
    points = np.asarray(points, np.float32)
    total = None
    for _, k, part in PARTS:
        d = part(points)
        total = d if total is None else smooth_union(total, d, k)
    return total


def material(points):
    """Material of the part nearest to (or deepest around) each point."""
    points = np.asarray(points, np.float32)
    each = np.stack([part(points) for _, _, part in PARTS], 1)
    return np.array([m for m, _, _ in PARTS])[each.argmin(1)]


def gradient(points, step=1e-3):
    """Outward direction of the field."""
    g = np.empty_like(points)
    for axis in range(3):
        offset = np.zeros(3, np.float32)
        offset[axis] = step
        g[:, axis] = distance(points + offset) - distance(points - offset)
    return g / np.maximum(np.linalg.norm(g, axis=1, keepdims=True), 1e-9)
