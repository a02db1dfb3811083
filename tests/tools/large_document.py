"""Writes honest COLLADA documents of any size, to measure what loading them costs. By hand, not by ctest:

    python3 tests/tools/large_document.py vertices 150 /tmp/large.dae
    /usr/bin/time -v build/walkcycle check /tmp/large.dae

KIND is what there is much of: vertices (one smooth mesh with normals and texture coordinates), quads (the same mesh
without normals), keys (a hundred joints with matrix keys), curves (a hundred joints with keys per number), nodes,
meshes (small ones), skin (one skin with four influences a vertex) or instances.
"""
import math
import sys

HEAD = """<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="meter" meter="1"/><up_axis>Y_UP</up_axis></asset>
"""


def source(name, numbers, params, matrix=False):
    width = 16 if matrix else len(params)
    kind = "float4x4" if matrix else "float"
    text = " ".join(numbers)
    described = "".join(f'<param name="{p}" type="{kind}"/>' for p in (["TRANSFORM"] if matrix else params))
    return (f'<source id="{name}"><float_array id="{name}-array" count="{len(numbers)}">{text}</float_array>'
            f'<technique_common><accessor source="#{name}-array" count="{len(numbers) // width}" stride="{width}">'
            f'{described}</accessor></technique_common></source>\n')


def names(name, words, param):
    return (f'<source id="{name}"><Name_array id="{name}-array" count="{len(words)}">{" ".join(words)}</Name_array>'
            f'<technique_common><accessor source="#{name}-array" count="{len(words)}" stride="1"><param name="{param}" '
            f'type="name"/></accessor></technique_common></source>\n')


def scene(nodes):
    return ('<library_visual_scenes><visual_scene id="scene">\n' + nodes + '</visual_scene></library_visual_scenes>\n'
            '<scene><instance_visual_scene url="#scene"/></scene>\n</COLLADA>\n')


def grid(side, name="grid", attributes=True):
    """A wavy sheet of side x side corners as quads."""
    at, normals, uvs, quads = [], [], [], []
    for y in range(side):
        for x in range(side):
            height = math.sin(x * 0.1) * math.cos(y * 0.1)
            at += [f"{x * 0.01:.6f}", f"{height:.6f}", f"{y * 0.01:.6f}"]
            if attributes:
                normals += [f"{math.sin(x):.6f}", f"{math.cos(x):.6f}", "0.000000"]
                uvs += [f"{x / side:.6f}", f"{y / side:.6f}"]
    for y in range(side - 1):
        for x in range(side - 1):
            corner = y * side + x
            for index in (corner, corner + side, corner + side + 1, corner + 1):
                quads.append(" ".join([str(index)] * (3 if attributes else 1)))
    count = (side - 1) * (side - 1)
    text = f'<library_geometries><geometry id="{name}"><mesh>\n' + source(name + "-at", at, "XYZ")
    inputs = f'<input semantic="VERTEX" source="#{name}-v" offset="0"/>'
    if attributes:
        text += source(name + "-n", normals, "XYZ") + source(name + "-uv", uvs, "ST")
        inputs += (f'<input semantic="NORMAL" source="#{name}-n" offset="1"/>'
                   f'<input semantic="TEXCOORD" source="#{name}-uv" offset="2" set="0"/>')
    return (text + f'<vertices id="{name}-v"><input semantic="POSITION" source="#{name}-at"/></vertices>\n'
            f'<polylist count="{count}">{inputs}<vcount>{"4 " * count}</vcount><p>{" ".join(quads)}</p></polylist>\n'
            '</mesh></geometry></library_geometries>\n')


def vertices(size, attributes=True):
    side = int(math.sqrt(size / (135 if attributes else 64)))
    return HEAD + grid(side, attributes=attributes) + scene('<node><instance_geometry url="#grid"/></node>\n')


def skin(size):
    side = int(math.sqrt(size / 165))
    points = side * side
    joints = [f"joint{i}" for i in range(64)]
    identity = "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1".split()
    groups = " ".join(f"{i % 64} 0 {(i + 1) % 64} 1 {(i + 2) % 64} 2 {(i + 3) % 64} 3" for i in range(points))
    controller = ('<library_controllers><controller id="skin"><skin source="#grid">\n' + names("names", joints, "JOINT") +
                  source("binds", identity * 64, "", True) + source("weights", ["0.4", "0.3", "0.2", "0.1"], "W") +
                  '<joints><input semantic="JOINT" source="#names"/><input semantic="INV_BIND_MATRIX" '
                  f'source="#binds"/></joints><vertex_weights count="{points}"><input semantic="JOINT" source="#names" '
                  'offset="0"/><input semantic="WEIGHT" source="#weights" offset="1"/>'
                  f'<vcount>{"4 " * points}</vcount><v>{groups}</v></vertex_weights></skin></controller>'
                  '</library_controllers>\n')
    nodes = "".join(f'<node sid="{j}" type="JOINT">' for j in joints[:1]) + "".join(
        f'<node sid="{j}" type="JOINT"/>' for j in joints[1:]) + "</node>"
    return HEAD + grid(side) + controller + scene(nodes + '<node><instance_controller url="#skin"/></node>\n')


def animation(number, count, matrix):
    name = f"a{number}"
    times = [f"{k / 30:.6f}" for k in range(count)]
    text = f'<animation id="{name}">\n' + source(name + "-in", times, ["TIME"])
    if matrix:
        values = []
        for k in range(count):
            angle = math.sin(k * 0.7 + number) * 0.5
            c, s = f"{math.cos(angle):.6f}", f"{math.sin(angle):.6f}"
            minus = s[1:] if s[0] == "-" else "-" + s
            values += [c, minus, "0.000000", f"{angle:.6f}", s, c, "0.000000", "1.000000",
                       "0.000000", "0.000000", "1.000000", "0.000000", "0", "0", "0", "1"]
        text += source(name + "-out", values, "", True)
    else:
        text += source(name + "-out", [f"{math.sin(k * 0.7 + number):.6f}" for k in range(count)], ["ANGLE"])
    target = "transform" if matrix else "turn.ANGLE"
    return (text + names(name + "-how", ["LINEAR"] * count, "INTERPOLATION") + f'<sampler id="{name}-s"><input '
            f'semantic="INPUT" source="#{name}-in"/><input semantic="OUTPUT" source="#{name}-out"/><input '
            f'semantic="INTERPOLATION" source="#{name}-how"/></sampler><channel source="#{name}-s" '
            f'target="j{number}/{target}"/></animation>\n')


def keys(size, matrix=True):
    count = max(2, int(size / 100 / (145 if matrix else 26)))
    moved = ('<matrix sid="transform">1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</matrix>' if matrix
             else '<rotate sid="turn">0 0 1 0</rotate>')
    nodes = "".join(f'<node id="j{i}" type="JOINT">{moved}</node>\n' for i in range(100))
    return (HEAD + "<library_animations>\n" + "".join(animation(i, count, matrix) for i in range(100)) +
            "</library_animations>\n" + scene(nodes))


def nodes(size):
    line = '<node id="node%d" name="node%d" type="NODE"><translate sid="t">%d 1.500000 2.500000</translate></node>\n'
    return HEAD + scene("".join(line % (i, i, i) for i in range(size // 104)))


def meshes(size):
    count = size // 760
    parts = "".join(
        f'<geometry id="g{i}"><mesh>' + source(f"p{i}", "0 0 0 1 0 0 1 1 0 0 1 0".split(), "XYZ") +
        f'<vertices id="v{i}"><input semantic="POSITION" source="#p{i}"/></vertices><polylist count="1"><input '
        f'semantic="VERTEX" source="#v{i}" offset="0"/><vcount>4</vcount><p>0 1 2 3</p></polylist></mesh></geometry>\n'
        for i in range(count))
    shown = "".join(f'<node id="n{i}"><translate>{i} 0 0</translate><instance_geometry url="#g{i}"/></node>\n'
                    for i in range(count))
    return HEAD + "<library_geometries>\n" + parts + "</library_geometries>\n" + scene(shown)


def instances(size):
    line = '<node id="n%d"><translate>%d 0 0</translate><instance_geometry url="#grid"/></node>\n'
    return HEAD + grid(4) + scene("".join(line % (i, i) for i in range(size // 88)))


KINDS = {"vertices": vertices, "quads": lambda size: vertices(size, False), "keys": keys,
         "curves": lambda size: keys(size, False), "nodes": nodes, "meshes": meshes, "skin": skin,
         "instances": instances}

if __name__ == "__main__":
    if len(sys.argv) != 4 or sys.argv[1] not in KINDS:
        sys.exit(__doc__)
    with open(sys.argv[3], "w", encoding="ascii") as out:
        out.write(KINDS[sys.argv[1]](int(float(sys.argv[2]) * 1e6)))
