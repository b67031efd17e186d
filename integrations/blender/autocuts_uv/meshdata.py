"""Blender's meshes as arrays for the engine, and UVs back into them.

A Model joins the meshes of several objects; each of them is a Part, which knows where its corners are and what the mesh
looked like, so that nothing is written to a mesh that has changed.
"""

import hashlib
from dataclasses import dataclass, field

import bmesh
import bpy
import numpy as np

from . import api


@dataclass
class Part:
    """One mesh of a Model. Blender's data is found by name: undo replaces the objects of Python."""

    object_name: str
    uv_name: str
    first_corner: int
    corner_count: int
    topology: bytes


@dataclass
class Model:
    """Meshes for the engine, in world space. V vertices, C corners, F faces; a side runs from its corner to the next
    one of its face."""

    positions: np.ndarray  # (V, 3), units of the scene
    corners: np.ndarray  # (C,) vertex of each corner
    face_sizes: np.ndarray  # (F,) corners of each face
    face_objects: np.ndarray  # (F,) index into names
    face_materials: np.ndarray  # (F,) index into materials, -1: none
    uvs: np.ndarray  # (C, 2), NaN: none yet
    scope: np.ndarray  # (F,) bool: faces that may change
    pins: np.ndarray  # (C,) bool: stays at its UV
    edges: np.ndarray  # (C,) edge of the side that starts at each corner
    cuts: np.ndarray  # (C,) bool: the side is always a seam
    hard: np.ndarray  # (C,) bool: the side is a sharp edge
    seam_weights: np.ndarray | None  # (C,) factor on the cost of a seam there
    texel_weights: np.ndarray | None  # (F,) factor on the texels per length
    names: list = field(default_factory=list)
    materials: list = field(default_factory=list)
    parts: list = field(default_factory=list)

    def side_pairs(self):
        """(N, 2) corners at which both sides of an edge between two faces start, the first face first."""
        order = np.argsort(self.edges, kind="stable")
        edges = self.edges[order]
        firsts = np.flatnonzero(np.concatenate([[True], edges[1:] != edges[:-1]]))
        sizes = np.diff(np.append(firsts, len(edges)))
        firsts = firsts[sizes == 2]
        pairs = np.stack([order[firsts], order[firsts + 1]], axis=1)
        return pairs[self.corners[pairs[:, 0]] != self.corners[pairs[:, 1]]]

    def face_of_corner(self):
        """(C,) the face of each corner."""
        return np.repeat(np.arange(len(self.face_sizes)), self.face_sizes)

    def cut_between_materials(self):
        """Makes edges between faces of different materials seams."""
        pairs = self.side_pairs()
        materials = self.face_materials[self.face_of_corner()[pairs]]
        self.cuts[pairs[materials[:, 0] != materials[:, 1]]] = True


@dataclass
class Taking:
    """What is taken over from Blender."""

    selected_only: bool = False
    seams: bool = True
    pins: bool = True
    modifiers: bool = True
    seam_group: str = ""
    seam_factor: float = 1
    texel_group: str = ""
    texel_factor: float = 1


def values(collection, name, kind, width=1):
    """An array of a property of everything in a collection of Blender."""
    array = np.empty(len(collection) * width, dtype=kind)
    collection.foreach_get(name, array)
    return array if width == 1 else array.reshape(-1, width)


def topology_of(mesh):
    """A hash that changes with counts and order of vertices, faces and corners. Edit mode must have been flushed."""
    digest = hashlib.sha256(str((len(mesh.vertices), len(mesh.polygons))).encode())
    digest.update(values(mesh.polygons, "loop_total", np.int32).tobytes())
    digest.update(values(mesh.loops, "vertex_index", np.int32).tobytes())
    return digest.digest()


def flushed_mesh(item):
    """The mesh of an object as it is now, in edit mode, too."""
    if item.mode == "EDIT":
        item.update_from_editmode()
    return item.data


def objects_to_map(context):
    """Mesh objects that are selected or in edit mode, of linked duplicates the first only."""
    chosen = context.objects_in_mode if context.mode == "EDIT_MESH" else context.selected_objects
    unique = {}
    for item in chosen:
        if item.type == "MESH" and item.data.polygons and item.data.library is None:
            unique.setdefault(item.data.name, item)
    return list(unique.values())


def _positions(context, item, mesh, modifiers):
    """(V, 3) in world space, with modifiers when these leave the corners as they are."""
    points = values(mesh.vertices, "co", np.float32, 3)
    if modifiers and (item.modifiers or mesh.shape_keys):
        evaluated = item.evaluated_get(context.evaluated_depsgraph_get())
        made = evaluated.to_mesh()
        if topology_of(made) == topology_of(mesh):
            points = values(made.vertices, "co", np.float32, 3)
        evaluated.to_mesh_clear()
    matrix = np.array(item.matrix_world)
    return points.astype(np.float64) @ matrix[:3, :3].T + matrix[:3, 3]


def _group_weights(item, mesh, name):
    """(V,) weights in a vertex group, None where the object has no such group."""
    group = item.vertex_groups.get(name) if name else None
    if group is None:
        return None
    weights = np.zeros(len(mesh.vertices))
    for vertex in mesh.vertices:
        for membership in vertex.groups:
            if membership.group == group.index:
                weights[vertex.index] = membership.weight
    return weights


def _scope(item, mesh, selected_only):
    """(F,) faces that may change: in edit mode no hidden ones."""
    scope = np.ones(len(mesh.polygons), dtype=bool)
    if selected_only:
        scope &= values(mesh.polygons, "select", bool)
    if item.mode == "EDIT":
        scope &= ~values(mesh.polygons, "hide", bool)
    return scope


def _face_means(per_vertex, corners, sizes):
    starts = np.cumsum(sizes) - sizes
    return np.add.reduceat(per_vertex[corners], starts) / sizes


def _uvs_and_pins(item, corner_count):
    """(C, 2) UVs, NaN without a UV map, and (C,) pins of the active UV map. Edit mode must have been flushed."""
    if not item.data.uv_layers:
        return np.full((corner_count, 2), np.nan), np.zeros(corner_count, dtype=bool)
    layer = item.to_mesh().uv_layers.active  # a copy: those of a mesh in edit mode cannot be read
    found = api.uvs_of(layer).astype(np.float64), api.pins_of(layer)
    item.to_mesh_clear()
    return found


def _arrays(context, item, taking):
    """The arrays of one object, as the fields of a Model, with vertices, edges and materials counted from 0."""
    mesh = flushed_mesh(item)
    corners = values(mesh.loops, "vertex_index", np.int32)
    sizes = values(mesh.polygons, "loop_total", np.int32)
    edges = values(mesh.loops, "edge_index", np.int32)
    uvs, pins = _uvs_and_pins(item, len(corners))
    arrays = {
        "positions": _positions(context, item, mesh, taking.modifiers),
        "corners": corners,
        "face_sizes": sizes,
        "face_materials": values(mesh.polygons, "material_index", np.int32),
        "uvs": uvs,
        "scope": _scope(item, mesh, taking.selected_only),
        "pins": pins & taking.pins,
        "edges": edges,
        "cuts": api.seams_of(mesh)[edges] & taking.seams,
        "hard": api.sharp_edges_of(mesh)[edges],
    }
    if not mesh.materials:
        arrays["face_materials"][:] = -1
    seam, texel = (_group_weights(item, mesh, name) for name in (taking.seam_group, taking.texel_group))
    along = None if seam is None else seam[values(mesh.edges, "vertices", np.int32, 2)].mean(axis=1)
    arrays["seam_weights"] = np.ones(len(corners)) if seam is None else taking.seam_factor ** along[edges]
    arrays["texel_weights"] = (
        np.ones(len(sizes)) if texel is None else taking.texel_factor ** _face_means(texel, corners, sizes)
    )
    return arrays


def model_of(context, objects, taking):
    """The objects as one Model. Faces of different objects share nothing."""
    parts, pieces, names, materials = [], [], [], []
    counts = {"corners": 0, "edges": 0, "vertices": 0}
    for number, item in enumerate(objects):
        arrays = _arrays(context, item, taking)
        mesh = item.data
        layer = mesh.uv_layers.active
        parts.append(
            Part(item.name, layer.name if layer else "", counts["corners"], len(mesh.loops), topology_of(mesh))
        )
        arrays["corners"] = arrays["corners"] + counts["vertices"]
        arrays["edges"] = arrays["edges"] + counts["edges"]
        arrays["face_objects"] = np.full(len(mesh.polygons), number, dtype=np.int32)
        own = [slot.name if slot else "-" for slot in mesh.materials]
        for name in own:
            if name not in materials:
                materials.append(name)
        if own:
            numbers = np.array([materials.index(name) for name in own], dtype=np.int32)
            arrays["face_materials"] = numbers[np.minimum(arrays["face_materials"], len(own) - 1)]
        counts["corners"] += len(mesh.loops)
        counts["edges"] += len(mesh.edges)
        counts["vertices"] += len(mesh.vertices)
        pieces.append(arrays)
        names.append(item.name)
    joined = {key: np.concatenate([piece[key] for piece in pieces]) for key in pieces[0]}
    for key in ("seam_weights", "texel_weights"):
        if (joined[key] == 1).all():
            joined[key] = None
    return Model(**joined, names=names, materials=materials, parts=parts)


def _write_edit_mesh(mesh, uv_name, uvs):
    """Writes to a mesh in edit mode; its corners are in the order of the flushed mesh."""
    edited = bmesh.from_edit_mesh(mesh)
    layer = edited.loops.layers.uv.get(uv_name) or edited.loops.layers.uv.new(uv_name or "UVMap")
    rows = iter(uvs.tolist())
    for face in edited.faces:
        for loop in face.loops:
            loop[layer].uv = next(rows)
    bmesh.update_edit_mesh(mesh, loop_triangles=False, destructive=False)


def _write_mesh(mesh, uv_name, uvs):
    layer = mesh.uv_layers.get(uv_name) or mesh.uv_layers.new(name="UVMap", do_init=False)
    api.set_uvs(layer, uvs)
    mesh.update()


def _problem(part):
    """Why nothing can be written to a mesh; empty when it can."""
    item = bpy.data.objects.get(part.object_name)
    if item is None or item.type != "MESH":
        return f"{part.object_name} is gone"
    mesh = flushed_mesh(item)
    if topology_of(mesh) != part.topology:
        return f"{part.object_name} has changed meanwhile and keeps its UVs"
    if part.uv_name and part.uv_name not in mesh.uv_layers:
        return f"the UV map {part.uv_name} of {part.object_name} is gone"
    return ""


def write_uvs(parts, uvs):
    """Writes (C, 2) UVs to the meshes they were made for, but NaN. Returns what kept others from it, in words."""
    problems = []
    for part in parts:
        problem = _problem(part)
        if problem:
            problems.append(problem)
            continue
        item = bpy.data.objects[part.object_name]
        own = uvs[part.first_corner : part.first_corner + part.corner_count]
        if np.isnan(own).any():
            own = np.where(np.isnan(own), np.nan_to_num(_uvs_and_pins(item, len(own))[0]), own)
        write = _write_edit_mesh if item.mode == "EDIT" else _write_mesh
        write(item.data, part.uv_name, own)
    return problems
