"""From the distance field to a Blender mesh: surface nets, relaxing, decimation."""
import bmesh
import bpy
import numpy as np

import fox_shape

CELL = 0.0075
LOW = np.array((-0.50, -0.31, -0.03), np.float32)
HIGH = np.array((0.50, 0.66, 1.50), np.float32)
TRIANGLES = 7600


def sample_grid():
    """The field on a regular grid, one x slab at a time to spare memory."""
    axes = [np.arange(LOW[i], HIGH[i], CELL, dtype=np.float32) for i in range(3)]
    y, z = np.meshgrid(axes[1], axes[2], indexing="ij")
    grid = np.empty([len(a) for a in axes], np.float32)
    for i, x in enumerate(axes[0]):
        slab = np.stack([np.full(y.size, x, np.float32), y.ravel(), z.ravel()], 1)
        grid[i] = fox_shape.distance(slab).reshape(y.shape)
    return grid


def _corner(grid, dx, dy, dz):
    nx, ny, nz = grid.shape
    return grid[dx:nx - 1 + dx, dy:ny - 1 + dy, dz:nz - 1 + dz]


def _cell_vertices(grid):
    """One vertex in each cell the surface crosses: the mean of its edge crossings."""
    corners = [(a, b, c) for a in (0, 1) for b in (0, 1) for c in (0, 1)]
    inside = np.stack([_corner(grid, *c) < 0 for c in corners])
    crossed = inside.any(0) & ~inside.all(0)
    cells = np.argwhere(crossed)
    total = np.zeros((len(cells), 3))
    count = np.zeros(len(cells))
    for a in corners:
        for axis in range(3):
            if a[axis]:
                continue
            b = tuple(v + (i == axis) for i, v in enumerate(a))
            fa, fb = _corner(grid, *a)[crossed], _corner(grid, *b)[crossed]
            hit = (fa < 0) != (fb < 0)
            t = fa[hit] / (fa[hit] - fb[hit])
            total[hit] += np.array(a) + t[:, None] * (np.array(b) - np.array(a))
            count[hit] += 1
    number = np.full(crossed.shape, -1)
    number[crossed] = np.arange(len(cells))
    return LOW + CELL * (cells + total / count[:, None]), number


def _quads(grid, number):
    """A quad around every grid edge with a change of sign, facing outwards."""
    faces = []
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        near = np.take(grid, range(grid.shape[axis] - 1), axis) < 0
        far = np.take(grid, range(1, grid.shape[axis]), axis) < 0
        at = np.argwhere(near != far)
        at = at[(at[:, u] > 0) & (at[:, v] > 0)]
        ring = []
        for du, dv in ((1, 1), (0, 1), (0, 0), (1, 0)):
            cell = at.copy()
            cell[:, u] -= du
            cell[:, v] -= dv
            ring.append(number[tuple(np.minimum(cell, np.array(number.shape) - 1).T)])
        ring = np.stack(ring, 1)
        outwards = near[tuple(at.T)]
        ring[~outwards] = ring[~outwards, ::-1]
        faces.append(ring)
    return np.concatenate(faces)


def project(vertices, steps=3):
    """Moves vertices onto the surface."""
    v = vertices.astype(np.float32)
    for _ in range(steps):
        v = v - fox_shape.gradient(v) * np.clip(fox_shape.distance(v), -.01, .01)[:, None]
    return v


def neighbour_mean(values, edges):
    """Mean of each vertex's neighbours, for values (N, k)."""
    total = np.zeros_like(values)
    count = np.zeros((len(values), 1), values.dtype)
    for a, b in ((0, 1), (1, 0)):
        np.add.at(total, edges[:, a], values[edges[:, b]])
        np.add.at(count, edges[:, a], 1)
    return total / np.maximum(count, 1)


def build_object():
    """The fox's mesh as a Blender object, closed and in one piece."""
    grid = sample_grid()
    vertices, number = _cell_vertices(grid)
    quads = _quads(grid, number)
    edges = np.unique(np.sort(np.concatenate([quads[:, [i, (i + 1) % 4]] for i in range(4)]), 1), axis=0)
    for _ in range(2):       # even out the grid's steps, staying on the surface
        vertices = project(.4 * vertices + .6 * neighbour_mean(vertices, edges), 1)
    mesh = bpy.data.meshes.new("Walker")
    mesh.from_pydata(project(vertices, 2).tolist(), [], quads.tolist())
    fox = bpy.data.objects.new("Walker", mesh)
    bpy.context.collection.objects.link(fox)
    bpy.context.view_layer.objects.active = fox
    fox.select_set(True)
    _keep_largest_piece(fox)
    _mend(fox)
    _decimate(fox)
    return fox


def _keep_largest_piece(fox):
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.separate(type="LOOSE")
    bpy.ops.object.mode_set(mode="OBJECT")
    pieces = sorted((o for o in bpy.data.objects if o.type == "MESH"), key=lambda o: -len(o.data.vertices))
    fox.data = pieces[0].data
    for piece in pieces:
        if piece is not fox:
            bpy.data.objects.remove(piece)


def _mend(fox):
    """Opens the few places where sheets touch in one edge or point, and caps them."""
    shape = bmesh.new()
    shape.from_mesh(fox.data)
    for _ in range(6):
        bad = {v for v in shape.verts if not v.is_manifold}
        bad |= {v for e in shape.edges if not e.is_manifold for v in e.verts}
        if not bad:
            break
        bmesh.ops.delete(shape, geom=list(bad), context="VERTS")
        bmesh.ops.holes_fill(shape, edges=[e for e in shape.edges if e.is_boundary], sides=0)
        bmesh.ops.triangulate(shape, faces=[f for f in shape.faces if len(f.verts) > 4])
    print("edges left open or shared:", sum(not e.is_manifold for e in shape.edges))
    shape.to_mesh(fox.data)
    shape.free()


def _decimate(fox):
    # In small steps: one big step can hang in Blender 3.4 on flat areas.
    for left in (28000, 17000, 11000, TRIANGLES):
        modifier = fox.modifiers.new("fewer", "DECIMATE")
        modifier.use_collapse_triangulate = True
        modifier.ratio = left / sum(len(f.vertices) - 2 for f in fox.data.polygons)
        bpy.ops.object.modifier_apply(modifier="fewer")
    mesh = fox.data
    mesh.vertices.foreach_set("co", project(vertex_positions(mesh), 1).ravel())
    mesh.polygons.foreach_set("use_smooth", np.ones(len(mesh.polygons), bool))
    mesh.update()
    print("triangles:", len(mesh.polygons), "vertices:", len(mesh.vertices))


def vertex_positions(mesh):
    flat = np.empty(len(mesh.vertices) * 3, np.float32)
    mesh.vertices.foreach_get("co", flat)
    return flat.reshape(-1, 3)
