#!/usr/bin/python3
"""Compares Walkcycle's posed vertices with Blender's own evaluation of the scenes that Blender exported.

usage: blender_oracle.py WALKCYCLE [FOLDER_TO_KEEP]

Exits with 77 (skipped, says ctest) where Blender is not installed. A vertex may be off by 1e-3 of the mesh's size.
"""
import json
import os
import shutil
import subprocess
import sys
import tempfile

import numpy as np

TOLERANCE = 1e-3


def pose(walkcycle, document, times):
    text = subprocess.run([walkcycle, "pose", document, "--time", ",".join(repr(t) for t in times), "--json"],
                          check=True, capture_output=True, text=True).stdout
    return json.loads(text)


def compare(walkcycle, folder, name):
    """The largest distance, as a share of the mesh's size; and what it was about."""
    reference = json.load(open(os.path.join(folder, name + ".json")))
    posed = pose(walkcycle, os.path.join(folder, name + ".dae"), reference["times"])
    worst, about = 0.0, ""
    for mesh in reference["meshes"][0]:
        instances = [i for i in posed["instances"] if mesh in (i["node"], i["geometry"].removesuffix("-mesh"))]
        if not instances:
            return float("inf"), f"no instance of {mesh} among {[i['node'] for i in posed['instances']]}"
        for k, moment in enumerate(reference["meshes"]):
            want = np.array(moment[mesh]).reshape(-1, 3)
            if reference["up"] == "Y":
                want = want[:, [0, 2, 1]] * [1, 1, -1]
            got = np.array(instances[0]["positions"][k]).reshape(-1, 3)
            if got.shape != want.shape:
                return float("inf"), f"{mesh}: {len(got)} vertices, Blender has {len(want)}"
            error = np.abs(got - want).max() / np.linalg.norm(want.max(0) - want.min(0))
            if error > worst:
                worst, about = error, f"{mesh} at {reference['times'][k]:.3f} s"
    return worst, about


def main():
    if not shutil.which("blender"):
        print("Blender is not installed: skipped")
        return 77
    walkcycle = os.path.abspath(sys.argv[1])
    folder = sys.argv[2] if len(sys.argv) > 2 else tempfile.mkdtemp(prefix="blender-oracle-")
    os.makedirs(folder, exist_ok=True)
    script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "blender_scenes.py")
    made = subprocess.run(["blender", "--background", "--factory-startup", "--python-exit-code", "1", "--python", script, "--", folder],
                          capture_output=True, text=True)
    if made.returncode != 0:
        print("Blender could not make the scenes:\n" + made.stdout[-2000:] + made.stderr[-2000:])
        return 1
    failed = 0
    for name in sorted(f[:-5] for f in os.listdir(folder) if f.endswith(".json")):
        worst, about = compare(walkcycle, folder, name)
        failed += worst > TOLERANCE
        print(f"{'ok  ' if worst <= TOLERANCE else 'FAIL'} {name}: off by {worst:.1e} of the size {about}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
