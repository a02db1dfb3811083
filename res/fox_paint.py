"""What colour the fox has at each place: fur, eyes, cloth, leather and soft shadow."""
import numpy as np

import fox_shape as fs
from fox_field import mirrored, turn_z


def rgb(text):
    return np.array([int(text[i:i + 2], 16) for i in (0, 2, 4)], np.float32) / 255


ORANGE, CREAM, DARK = rgb("f0822f"), rgb("f7e9d0"), rgb("3a2420")
BASE = {
    fs.FUR: ORANGE, fs.NOSE: rgb("2a1b1c"), fs.EYE: ORANGE, fs.EAR: ORANGE, fs.PAW: rgb("5f3a2b"),
    fs.JACKET: rgb("2f918a"), fs.STRAP: rgb("7a4a2a"), fs.BUCKLE: rgb("e6b84a"),
    fs.TROUSERS: rgb("5c6484"), fs.BOOT: rgb("96603a"), fs.SOLE: rgb("3b2c27"), fs.TAIL: ORANGE,
    fs.SCARF: rgb("e8b23c"), fs.PACK: rgb("a07a48"), fs.ROLL: rgb("b8493a"), fs.CUFF: rgb("f0e2c4"),
}


def noise(p, scale):
    """Smooth random values in -1..1, one bump per 1/scale metres (scale per axis or one)."""
    q = p * np.asarray(scale, np.float32) + 100.0
    cell = np.floor(q).astype(np.int64)
    f = q - cell
    f = f * f * (3 - 2 * f)
    total = np.zeros(len(p), np.float32)
    for corner in range(8):
        d = np.array([corner & 1, corner >> 1 & 1, corner >> 2])
        key = ((cell + d) * np.array([73856093, 19349663, 83492791])).sum(1)
        key = (key ^ (key >> 13)) * 1274126177 & 0x7fffffff
        key = (key ^ (key >> 15)) & 0xffff
        total += (key / 32767.5 - 1) * np.where(d == 1, f, 1 - f).prod(1)
    return total


def step(low, high, x):
    t = np.clip((x - low) / (high - low), 0, 1)
    return t * t * (3 - 2 * t)


def mix(colour, other, amount):
    return colour + (other - colour) * np.asarray(amount)[..., None]


def stroke(distance, width, soft=0.002):
    """1 within `width` of a line, 0 away from it."""
    return 1 - step(width - soft, width + soft, np.abs(distance))


def _face(c, p, m, n):
    """Cream muzzle, cheeks and brow spots; mouth."""
    x, y, z = m.T
    edge = 0.985 + 0.30 * np.maximum(x - .045, 0) - 0.9 * np.maximum(.03 - x, 0) * (y < -.14)
    wobble = noise(p, (60, 60, 25)) * .006
    front = step(.035, -.01, y)
    c = mix(c, CREAM, step(edge + .012, edge - .012, z + wobble) * front)
    brow = np.hypot((x - .062) / .028, (z - 1.148) / .014)
    c = mix(c, CREAM, step(1.2, .8, brow + wobble * 20) * (y < 0) * .9)
    blush = np.hypot((x - .125) / .035, (z - .985) / .024)
    c = mix(c, rgb("f08a6a"), step(1.3, .2, blush) * (y < 0) * .55)
    smile = z - (.953 + 2.2 * np.maximum(x - .012, 0) ** 1.5 + .004 * (x < .006))
    c = mix(c, DARK, stroke(smile, .0028, .0015) * (x < .052) * (y < -.12))
    return mix(c, DARK, stroke(x, .0024, .0015) * (y < -.2) * (z > .952) * (z < .985))


def _ear_colour(c, m, n):
    along = (m[:, 2] - 1.15) / .19
    c = mix(c, DARK, step(.48, .66, along + noise(m, (60, 60, 20)) * .10))
    width = .062 * np.clip(1 - along, .02, 1)
    off = np.abs(m[:, 0] - .104 - .080 * along) / width
    inner = step(1.1, .75, off + noise(m, (90, 90, 30)) * .12) * step(.0, -.25, n[:, 1]) * (along > -.15)
    return mix(c, mix(np.broadcast_to(rgb("f6dcc0"), c.shape), rgb("d98a72"), step(.8, .1, off) * .7), inner)


def _eyes(c, m):
    q = turn_z(m, fs.EYE_CENTRE, -fs.EYE_TURN) - np.array(fs.EYE_CENTRE, np.float32)
    x, z = q[:, 0], q[:, 2]
    front = (m[:, 1] < -.05).astype(np.float32)
    rx, rz = .040, .050
    outline = np.hypot(x / (rx + .006), (z - .002) / (rz + .007))
    lash = np.hypot((x - .012) / (rx + .004), (z - .008) / (rz + .006))
    c = mix(c, DARK, step(1.04, .98, np.minimum(outline, lash)) * front)
    white = np.hypot(x / rx, (z + .002) / rz)
    c = mix(c, rgb("fffaf0"), step(1.03, .97, white) * front)
    inside = front * step(1.02, .98, white)
    iris = np.hypot((x + .006) / .031, (z + .003) / .041)
    ring = mix(np.broadcast_to(rgb("3f8f4d"), c.shape), rgb("b7d957"), step(.03, -.035, z))
    ring = mix(ring, rgb("1f3b2a"), step(.85, 1.0, iris))
    c = mix(c, ring, inside * step(1.04, .96, iris))
    c = mix(c, rgb("17100f"), inside * step(1.06, .96, np.hypot((x + .006) / .019, (z + .001) / .028)))
    c = mix(c, np.ones(3), inside * step(1.1, .9, np.hypot(x + .018, z - .018) / .0105))
    c = mix(c, np.ones(3), inside * step(1.1, .9, np.hypot(x - .008, z + .022) / .0052) * .9)
    return mix(c, rgb("e9dcd0"), inside * step(.020, .050, z) * .35)


def _fur_strokes(c, p, n):
    flow = noise(p, (110, 110, 28)) * .6 + noise(p, (210, 210, 60)) * .4
    return c * (1 + .085 * flow[:, None])


def _weave(c, p, fine):
    """Cloth: faint threads and broad, uneven fading."""
    threads = np.sin(p[:, 2] * fine) * np.sin((p[:, 0] + p[:, 1]) * fine)
    return c * (1 + .025 * threads + .05 * noise(p, 22) + .03 * noise(p, 70))[:, None]


def _folds(c, p, where, lines):
    """Shaded wrinkles: bright ridge above dark valley along bent level lines."""
    wave = np.sin(lines * 6.283)
    return c * (1 + where * (.16 * wave - .05))[:, None]


def _jacket(c, p, m, n):
    shoulder, elbow, wrist = [np.array(v, np.float32) for v in fs.arm_points()]
    c = _weave(c, p, 900)
    along = (m - shoulder) @ ((wrist - shoulder) / np.linalg.norm(wrist - shoulder))
    bend = np.exp(-((along - .16) / .05) ** 2) * (m[:, 0] > .17) + .7 * np.exp(-((along - .005) / .03) ** 2)
    c = _folds(c, p, bend * (along > -.02), along * 38 + noise(p, 26) * .9)
    sides = step(.04, .12, m[:, 0]) * (along < -.02)
    c = _folds(c, p, sides * .6, p[:, 2] * 26 + m[:, 0] * 18 + noise(p, 18))
    front = (p[:, 1] < 0) * (along < .0)
    c = mix(c, rgb("1f5753"), stroke(p[:, 0], .0035) * front)
    for z in (.675, .715, .755, .795):
        c = mix(c, rgb("e6b84a"), step(.0095, .0065, np.hypot(p[:, 0] - .016, p[:, 2] - z)) * front)
    hem = stroke(p[:, 2] - .533, .011, .003)
    c = mix(c, rgb("e6b84a"), hem)
    dots = np.arctan2(p[:, 0], -p[:, 1]) * 18
    c = mix(c, rgb("8c2f2a"), hem * step(.2, .5, np.sin(dots)) * stroke(p[:, 2] - .533, .005))
    patch = np.hypot(along - .165, (m[:, 1] - .045) * .8) + (m[:, 0] < .19)      # on the arm only
    c = mix(c, rgb("7a4a2a"), step(.036, .033, patch) * (m[:, 1] > .02))
    return mix(c, rgb("e0b070"), stroke(patch - .029, .0016, .001) * (m[:, 1] > .02) * .8)


def _trousers(c, p, m, n):
    c = _weave(c, p, 1100)
    knee = np.exp(-((p[:, 2] - .31) / .05) ** 2) + np.exp(-((p[:, 2] - .24) / .025) ** 2)
    c = _folds(c, p, knee * .8, p[:, 2] * 34 + np.abs(m[:, 0] - .09) * 16 + noise(p, 24) * .9)
    groin = np.exp(-(np.hypot(m[:, 0] - .03, p[:, 2] - .49) / .05) ** 2)
    c = _folds(c, p, groin, (p[:, 2] - m[:, 0]) * 30 + noise(p, 20) * .5)
    side = stroke(m[:, 1] - .006, .0022) * (m[:, 0] > .1)
    c = mix(c, rgb("363a4c"), side)
    knee_patch = np.maximum(np.abs(p[:, 0] + .095) / .034, np.abs(p[:, 2] - .325) / .038) * (1 + 9 * (p[:, 1] > 0))
    c = mix(c, rgb("8a6a4a"), step(1.0, .94, knee_patch))
    stitches = stroke(knee_patch - .84, .04, .02) * step(-.2, .2, np.sin((p[:, 0] + p[:, 2]) * 620))
    return mix(c, rgb("e6cf9a"), stitches)


def _boots(c, p, m, n):
    c = c * (1 + .10 * noise(p, 30) + .05 * noise(p, 120))[:, None]
    worn = step(-.12, -.17, p[:, 1]) * .5 + np.exp(-((p[:, 2] - .21) / .012) ** 2) * .4
    c = mix(c, rgb("c08a58"), worn * (.6 + .4 * noise(p, 60)))
    crease = np.exp(-((p[:, 1] + .055) / .03) ** 2) * step(.06, .10, p[:, 2])
    c = _folds(c, p, crease, p[:, 1] * 55 + noise(p, 20) * .4)
    strap = stroke((p[:, 2] - .135) + p[:, 1] * .15, .014, .002)
    c = mix(c, rgb("4e2d1c"), strap)
    buckle = np.maximum(np.abs(p[:, 2] - .135 + p[:, 1] * .15) / .018, np.abs(m[:, 1] - .0) / .015) * (1 + 9 * (m[:, 0] < .12))
    return mix(c, rgb("e6b84a"), step(1.0, .9, buckle) - step(.62, .52, buckle))


def _scarf(c, p):
    c = _weave(c, p, 700)
    angle = np.arctan2(p[:, 0], -p[:, 1])
    ring = np.hypot(p[:, 0], p[:, 1] - .01) < .15
    along = np.where(ring, angle * .11, (p - np.array(fs.sk.SCARF[0])) @ np.array((.58, .70, -.40)))
    stripe = step(.25, .45, np.sin(along * 100 + .6))
    c = mix(c, rgb("b8402f"), stripe * .95)
    c = mix(c, rgb("fbe6b0"), stroke(np.sin(along * 100 + .6) - .1, .10, .05) * .8)
    return _folds(c, p, .8 + 0 * along, p[:, 2] * 30 + angle * 1.1 + noise(p, 22) * .8)


def _pack(c, p, m, n):
    c = _weave(c, p, 800)
    flap = p[:, 2] > .722
    c = mix(c, rgb("8a6236"), flap * .8)
    c = mix(c, rgb("5a3a20"), stroke(p[:, 2] - .722, .003))
    c = mix(c, rgb("e8cf98"), stroke(p[:, 2] - .732, .0016, .001) * step(-.2, .2, np.sin(p[:, 0] * 500)))
    band = stroke(m[:, 0] - .062, .011, .0015) * (p[:, 1] > .19)
    c = mix(c, rgb("5e3820"), band)
    lock = np.maximum(np.abs(m[:, 0] - .062) / .015, np.abs(p[:, 2] - .728) / .012)
    return mix(c, rgb("e6b84a"), (step(1, .9, lock) - step(.5, .4, lock)) * (p[:, 1] > .19))


def _roll(c, p):
    c = _weave(c, p, 600)
    radius = np.hypot(p[:, 1] - .205, p[:, 2] - .846)
    end = np.abs(p[:, 0]) > .118
    spiral = np.sin(radius * 420 + np.arctan2(p[:, 1] - .205, p[:, 2] - .846))
    c = mix(c, rgb("f3d9a8"), end * step(0, .5, spiral) * .9)
    band = stroke(np.abs(p[:, 0]) - .068, .012, .002)
    return mix(mix(c, rgb("f3d9a8"), stroke(np.abs(p[:, 0]) - .100, .004) * ~end), rgb("5e3820"), band)


def _buckle(c, p, m, n):
    frame = np.maximum(m[:, 0] / .022, np.abs(p[:, 2] - fs.BELT_HEIGHT) / .018)
    c = mix(c, rgb("6b431f"), step(1.0, .9, frame))
    return mix(c, rgb("f6d98a"), stroke(p[:, 0], .004) * step(.2, .4, frame) * (m[:, 0] < .02) * (p[:, 1] < -.1))


def _paw(c, p, m, n):
    """Rosy pads on palm and finger tips, on the side the palm looks to."""
    normal = np.array(fs.sk.PALM_NORMAL, np.float32)
    facing = step(.45, .75, np.where(p[:, 0] < 0, -n[:, 0], n[:, 0]) * normal[0] + n[:, 2] * normal[2])
    pads = [fs.sk.hand_point(.048, 0.004)] + [points[2] for points in fs.sk.FINGERS.values()]
    for i, pad in enumerate(pads):
        radius = .028 if i == 0 else .013
        c = mix(c, rgb("d98f80"), facing * step(1.1, .8, np.linalg.norm(m - np.array(pad), axis=1) / radius / 1.25))
    return c


def occlusion(p, n):
    """Soft shadow: 1 in the open, lower in creases, from the field along the normal."""
    shade = np.zeros(len(p), np.float32)
    for reach, weight in ((.012, .35), (.03, .30), (.06, .20), (.11, .15)):
        free = np.clip(fs.distance(p + n * reach) / reach, -.2, 1)
        shade += weight * free
    return np.clip(shade, 0, 1)


def colour(p, n):
    """sRGB colours for places p with normals n, both (N, 3)."""
    p = p - fs.gradient(p) * fs.distance(p)[:, None]     # from the flat triangle to the round body
    kind = fs.material(p - n * .003)
    c = np.stack([BASE[k] for k in range(16)])[kind]
    painters = {
        fs.FUR: _face, fs.EYE: _face,
        fs.EAR: lambda c, p, m, n: _ear_colour(c, m, n), fs.JACKET: _jacket, fs.TROUSERS: _trousers,
        fs.BOOT: _boots, fs.SCARF: lambda c, p, m, n: _scarf(c, p), fs.PACK: _pack,
        fs.ROLL: lambda c, p, m, n: _roll(c, p),
        fs.TAIL: lambda c, p, m, n: mix(c, CREAM, step(.43, .47, p[:, 1] + noise(p, (60, 25, 25)) * .025)),
        fs.STRAP: lambda c, p, m, n: c * (1 + .12 * noise(p, 40) + .06 * noise(p, 160))[:, None],
        fs.BUCKLE: _buckle, fs.PAW: _paw,
        fs.CUFF: lambda c, p, m, n: _weave(c, p, 500),
        fs.SOLE: lambda c, p, m, n: c * (1 + .15 * np.sign(np.sin(p[:, 1] * 260)))[:, None],
    }
    for k, painter in painters.items():
        at = kind == k
        if at.any():
            on_head = k in (fs.FUR, fs.EYE, fs.EAR)
            place = fs.to_head(p[at]) if on_head else p[at]
            c[at] = painter(c[at], place, mirrored(place), n[at])
    furry = np.isin(kind, (fs.FUR, fs.EYE, fs.EAR, fs.TAIL, fs.PAW))
    c[furry] = _fur_strokes(c[furry], p[furry], n[furry])
    head = np.isin(kind, (fs.FUR, fs.EYE))
    c[head] = _eyes(c[head], mirrored(fs.to_head(p[head])))
    open_air = occlusion(p, n)
    tint = mix(np.ones_like(c), rgb("6a5670"), (1 - open_air) * .8)     # shadows lean to violet
    return c * tint * (.98 + .06 * n[:, 2:3])
