"""Signed distance primitives on numpy arrays of points (N, 3)."""
import numpy as np


def vec(*xyz):
    return np.array(xyz, np.float32)


def ellipsoid(p, centre, radii):
    """Bound on the distance to an axis-aligned ellipsoid (exact at the surface)."""
    q = p - vec(*centre)
    r = vec(*radii)
    k0 = np.linalg.norm(q / r, axis=1)
    k1 = np.linalg.norm(q / (r * r), axis=1)
    return k0 * (k0 - 1.0) / np.maximum(k1, 1e-6)


def round_cone(p, a, b, ra, rb):
    """A capsule whose radius goes linearly from ra at a to rb at b."""
    a, b = vec(*a), vec(*b)
    ab = b - a
    t = np.clip((p - a) @ ab / max(float(ab @ ab), 1e-9), 0, 1)
    return np.linalg.norm(p - a - t[:, None] * ab, axis=1) - (ra + (rb - ra) * t)


def tube(p, points, radii):
    """Round cones through a list of points, softly joined."""
    d = None
    for a, b, ra, rb in zip(points, points[1:], radii, radii[1:]):
        piece = round_cone(p, a, b, ra, rb)
        d = piece if d is None else smooth_union(d, piece, 0.012)
    return d


def box(p, centre, half, rounding):
    q = np.abs(p - vec(*centre)) - (vec(*half) - rounding)
    outside = np.linalg.norm(np.maximum(q, 0), axis=1)
    return outside + np.minimum(q.max(axis=1), 0) - rounding


def squash(p, centre, axis, factor, distance):
    """`distance` of space stretched by 1/factor along a unit axis: a flatter body."""
    axis = vec(*axis)
    along = (p - vec(*centre)) @ axis
    stretched = p + (along * (1.0 / factor - 1.0))[:, None] * axis
    return distance(stretched) * factor


def turn_z(p, centre, angle):
    """Points turned about a vertical axis through centre."""
    q = p - vec(*centre)
    c, s = np.cos(angle), np.sin(angle)
    turned = np.stack([c * q[:, 0] - s * q[:, 1], s * q[:, 0] + c * q[:, 1], q[:, 2]], 1)
    return turned.astype(np.float32) + vec(*centre)


def smooth_union(a, b, k):
    h = np.maximum(k - np.abs(a - b), 0) / k
    return np.minimum(a, b) - h * h * (k * 0.25)


def smooth_cut(a, b, k):
    """a without b."""
    return -smooth_union(-a, b, k)


def mirrored(p):
    """Points folded onto the left half, for bodies that are the same on both sides."""
    q = p.copy()
    q[:, 0] = np.abs(q[:, 0])
    return q
