"""Checks the exported fox and exits with 1 when something is not as promised.

    blender --background --factory-startup --python res/check_walker.py

Reads the .dae files itself (no Blender functions; any Python with numpy will
do), skins the mesh as a player would and measures the soles against a ground
that moves at walking speed.
"""
import os
import sys
import xml.etree.ElementTree as ElementTree

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
NS = {"c": "http://www.collada.org/2005/11/COLLADASchema"}
STEPS_PER_KEY = 4
CONTACT = 0.004       # a sole vertex lower than this share of the height touches the ground


def numbers(element):
    return np.array(element.text.split(), float)


class Document:
    def __init__(self, name):
        self.root = ElementTree.parse(os.path.join(HERE, name)).getroot()
        self.by_id = {"#" + e.get("id"): e for e in self.root.iter() if e.get("id")}

    def all(self, path):
        return self.root.findall(path, NS)

    def source(self, parent, semantic):
        """The numbers or names behind an <input> of parent."""
        wanted = next(i for i in parent.findall("c:input", NS) if i.get("semantic") == semantic)
        source = self.by_id[wanted.get("source")]
        names = source.find("c:Name_array", NS)
        return names.text.split() if names is not None else numbers(source.find("c:float_array", NS))


class Skin:
    """The mesh with its weights."""

    def __init__(self, document):
        skin = document.all(".//c:skin")[0]
        mesh = document.by_id[skin.get("source")].find("c:mesh", NS)
        positions = document.source(mesh.find("c:vertices", NS), "POSITION").reshape(-1, 3)
        shape = numbers(skin.find("c:bind_shape_matrix", NS)).reshape(4, 4)
        self.positions = np.c_[positions, np.ones(len(positions))] @ shape.T
        self.triangles = sum(int(t.get("count")) for t in mesh.findall("c:triangles", NS))
        self.joints = document.source(skin.find("c:joints", NS), "JOINT")
        self.inverse = document.source(skin.find("c:joints", NS), "INV_BIND_MATRIX").reshape(-1, 4, 4)
        entries = skin.find("c:vertex_weights", NS)
        values = document.source(entries, "WEIGHT")
        counts = numbers(entries.find("c:vcount", NS)).astype(int)
        pairs = numbers(entries.find("c:v", NS)).astype(int).reshape(-1, 2)
        self.weights = np.zeros((len(positions), len(self.joints)))
        np.add.at(self.weights, (np.repeat(np.arange(len(counts)), counts), pairs[:, 0]), values[pairs[:, 1]])
        self.influences = counts

    def deform(self, joint_world, chosen):
        matrices = np.stack([joint_world[j] @ b for j, b in zip(self.joints, self.inverse)])
        moved = np.einsum("jab,vb->vja", matrices, self.positions[chosen])
        return np.einsum("vj,vja->va", self.weights[chosen], moved)[:, :3]


class Clip:
    """Joint matrices over time."""

    def __init__(self, document):
        self.tracks = {}
        for channel in document.all(".//c:channel"):
            sampler = document.by_id[channel.get("source")]
            self.times = document.source(sampler, "INPUT")
            node = document.by_id["#" + channel.get("target").split("/")[0]]
            self.tracks[node.get("sid")] = document.source(sampler, "OUTPUT").reshape(-1, 4, 4)
        self.parents, self.rest = {}, {}
        for node in document.all(".//c:node[@type='JOINT']"):
            self.rest[node.get("sid")] = numbers(node.find("c:matrix", NS)).reshape(4, 4)
            for child in node.findall("c:node[@type='JOINT']", NS):
                self.parents[child.get("sid")] = node.get("sid")

    @property
    def length(self):
        return self.times[-1] - self.times[0]

    def seam(self):
        """Largest difference between the first and the last key."""
        return max(np.abs(t[0] - t[-1]).max() for t in self.tracks.values())

    def world(self, key):
        """All joints at a fractional key number."""
        i = min(int(key), len(self.times) - 2)
        result = {}
        for joint in self.rest:      # parents come first in the file
            track = self.tracks.get(joint)
            local = self.rest[joint] if track is None else track[i] + (key - i) * (track[i + 1] - track[i])
            parent = self.parents.get(joint)
            result[joint] = local if parent is None else result[parent] @ local
        return result


def sole_paths(skin, clip):
    """Vertices of the soles over two rounds: positions (time, vertex, 3), and the time step."""
    chosen = np.flatnonzero(skin.positions[:, 2] < .004)
    keys = np.arange(0, len(clip.times) - 1, 1 / STEPS_PER_KEY)
    once = np.stack([skin.deform(clip.world(k), chosen) for k in keys])
    return np.concatenate([once, once]), clip.length / len(keys)


def ground_speed(paths, step, touching):
    velocity = np.diff(paths[:, :, 1], axis=0) / step
    return float(np.median(velocity[touching[1:] & touching[:-1]]))


def worst_slide(paths, step, touching, speed):
    """The longest way a vertex moves over the ground while it touches it."""
    ground = paths[:, :, :2].copy()
    ground[:, :, 1] -= speed * step * np.arange(len(paths))[:, None]
    worst = 0.0
    for v in range(paths.shape[1]):
        edges = np.flatnonzero(np.diff(np.r_[0, touching[:, v].astype(int), 0]))
        for first, last in zip(edges[::2], edges[1::2]):
            worst = max(worst, float(np.linalg.norm(np.ptp(ground[first:last, v], axis=0))))
    return worst


def gait_figures(skin, clip):
    height = float(np.ptp(skin.positions[:, 2]))
    paths, step = sole_paths(skin, clip)
    touching = paths[:, :, 2] < CONTACT * height
    speed = ground_speed(paths, step, touching)
    return {"height": height, "speed": speed, "sink": -float(paths[:, :, 2].min()) / height,
            "slide": worst_slide(paths, step, touching, speed) / height,
            "flight": float((~touching.any(1)).mean())}


def main():
    walk = Document("walker.dae")
    skin, clip = Skin(walk), Clip(walk)
    run, idle = Clip(Document("walker-run.dae")), Clip(Document("walker-idle.dae"))
    figures, running = gait_figures(skin, clip), gait_figures(skin, run)
    sums = skin.weights.sum(1)
    print(f"{skin.triangles} triangles, {len(skin.joints)} joints, up to {skin.influences.max()} "
          f"influences ({(skin.influences >= 5).sum()} vertices with five or more)")
    for name, gait, figure in (("walk", clip, figures), ("run", run, running)):
        print(f"{name}: {gait.length:.3f} s, {figure['speed']:.3f} m/s, slide {figure['slide']:.2%}, "
              f"sinks {figure['sink']:.2%} of {figure['height']:.2f} m, flight {figure['flight']:.0%}")
    print(f"idle: {idle.length:.3f} s; seams {clip.seam():.1e} {run.seam():.1e} {idle.seam():.1e}")
    checks = {
        "3000 triangles": skin.triangles >= 3000, "25 joints": len(skin.joints) >= 25,
        "five influences": skin.influences.max() >= 5, "weights sum to 1": np.abs(sums - 1).max() < 1e-3,
        "loops": max(c.seam() for c in (clip, run, idle)) < 1e-5,
        "walk length": .8 <= clip.length <= 1.2, "run length": .6 <= run.length <= .8,
        "idle length": 2 <= idle.length <= 4, "no slide": figures["slide"] <= .02,
        "no sinking": max(figures["sink"], running["sink"]) <= .01, "run has flight": running["flight"] > .1,
        "same joints": set(clip.rest) == set(run.rest) == set(idle.rest) == set(skin.joints),
        "relative texture": walk.all(".//c:image/c:init_from")[0].text == "walker.png",
    }
    for name, good in checks.items():
        print("ok  " if good else "FAIL", name)
    if not all(checks.values()):
        sys.exit(1)


main()
