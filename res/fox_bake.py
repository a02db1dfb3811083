"""Lays the mesh out flat (UV) and bakes a colour function of space into a picture.

Colour depends on the place on the body only, never on the UV layout, so the
islands' borders show no seams.
"""
import math
import struct
import zlib

import bpy
import numpy as np

SIZE = 1024
HEAD_SCALE = 2.0       # the face is what one looks at: give it more texels
HEAD_FROM = 0.925


def unwrap(fox):
    """Head and body are projected apart, so that the head can be made larger."""
    mesh = fox.data
    mesh.uv_layers.new(name="UVMap")
    centre_z = np.array([polygon.center.z for polygon in mesh.polygons])
    is_head = centre_z > HEAD_FROM
    for chosen in (is_head, ~is_head):
        _select_faces(mesh, chosen)
        bpy.ops.object.mode_set(mode="EDIT")
        bpy.ops.uv.smart_project(angle_limit=math.radians(74), island_margin=0.004,
                                 area_weight=0.3, correct_aspect=False, scale_to_bounds=False)
        bpy.ops.object.mode_set(mode="OBJECT")
    _even_scale(mesh, is_head)
    _select_faces(mesh, np.ones(len(is_head), bool))
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.uv.select_all(action="SELECT")
    bpy.ops.uv.pack_islands(rotate=True, margin=0.006)
    bpy.ops.object.mode_set(mode="OBJECT")


def _select_faces(mesh, chosen):
    mesh.polygons.foreach_set("select", np.asarray(chosen, bool))
    for edge in mesh.edges:
        edge.select = False
    for vertex in mesh.vertices:
        vertex.select = False
    for polygon, wanted in zip(mesh.polygons, chosen):
        polygon.select = bool(wanted)
        if wanted:
            for v in polygon.vertices:
                mesh.vertices[v].select = True
            for loop in polygon.loop_indices:
                mesh.edges[mesh.loops[loop].edge_index].select = True


def loop_uvs(mesh):
    flat = np.empty(len(mesh.loops) * 2, np.float32)
    mesh.uv_layers[0].data.foreach_get("uv", flat)
    return flat.reshape(-1, 2)


def _even_scale(mesh, is_head):
    """Brings both projections to one scale of texels per metre, the head larger."""
    uv = loop_uvs(mesh)
    corners = uv.reshape(-1, 3, 2)
    a, b = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    flat_area = np.abs(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]) / 2
    area = np.array([polygon.area for polygon in mesh.polygons])
    for chosen, wanted in ((is_head, HEAD_SCALE), (~is_head, 1.0)):
        scale = wanted * math.sqrt(area[chosen].sum() / flat_area[chosen].sum())
        corners[chosen] *= scale
    mesh.uv_layers[0].data.foreach_set("uv", corners.ravel())


def _texels(mesh, positions, normals):
    """For each texel inside a triangle: its pixel, place on the body and normal."""
    corners = loop_uvs(mesh).reshape(-1, 3, 2) * SIZE - 0.5
    vertex = np.empty(len(mesh.loops), np.int64)
    mesh.loops.foreach_get("vertex_index", vertex)
    vertex = vertex.reshape(-1, 3)
    pixels, places, directions = [], [], []
    for uv, ids in zip(corners, vertex):
        low = np.maximum(np.floor(uv.min(0)).astype(int), 0)
        high = np.minimum(np.ceil(uv.max(0)).astype(int), SIZE - 1)
        x, y = np.meshgrid(np.arange(low[0], high[0] + 1), np.arange(low[1], high[1] + 1))
        basis = np.array([uv[1] - uv[0], uv[2] - uv[0]]).T
        if x.size == 0 or abs(np.linalg.det(basis)) < 1e-9:
            continue
        st = np.linalg.solve(basis, np.stack([x.ravel() - uv[0, 0], y.ravel() - uv[0, 1]]))
        weights = np.stack([1 - st[0] - st[1], st[0], st[1]], 1)
        hit = weights.min(1) >= -0.02
        pixels.append(np.stack([x.ravel(), y.ravel()], 1)[hit])
        places.append(weights[hit] @ positions[ids])
        directions.append(weights[hit] @ normals[ids])
    return np.concatenate(pixels), np.concatenate(places), np.concatenate(directions)


def bake(fox, positions, colour):
    """The texture as (SIZE, SIZE, 3) bytes, first row at the bottom."""
    normals = np.array([v.normal for v in fox.data.vertices], np.float32)
    pixels, places, directions = _texels(fox.data, positions, normals)
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    picture = np.zeros((SIZE, SIZE, 3), np.float32)
    painted = np.zeros((SIZE, SIZE), bool)
    picture[pixels[:, 1], pixels[:, 0]] = colour(places.astype(np.float32), directions.astype(np.float32))
    painted[pixels[:, 1], pixels[:, 0]] = True
    print(f"texels used: {painted.mean():.0%}")
    _grow(picture, painted, 12)
    picture[~painted] = picture[painted].mean(0)
    return (np.clip(picture, 0, 1) * 255 + 0.5).astype(np.uint8)


def _grow(picture, painted, steps):
    """Repeats the border colours outwards, so that filtering finds no foreign colour."""
    for _ in range(steps):
        total = np.zeros_like(picture)
        count = np.zeros(painted.shape, np.float32)
        for dy, dx in ((0, 1), (0, -1), (1, 0), (-1, 0)):
            near = np.roll(painted, (dy, dx), (0, 1))
            total += np.roll(picture, (dy, dx), (0, 1)) * near[..., None]
            count += near
        fresh = ~painted & (count > 0)
        picture[fresh] = total[fresh] / count[fresh][:, None]
        painted |= fresh


def write_png(path, picture):
    """A plain RGB PNG; rows are stored as differences to the left pixel."""
    rows = picture[::-1].astype(np.int16)
    rows[:, 1:] = (rows[:, 1:] - rows[:, :-1]) % 256
    data = b"".join(b"\1" + row.astype(np.uint8).tobytes() for row in rows)

    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    head = struct.pack(">IIBBBBB", SIZE, SIZE, 8, 2, 0, 0, 0)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head)
                   + chunk(b"IDAT", zlib.compress(data, 9)) + chunk(b"IEND", b""))
