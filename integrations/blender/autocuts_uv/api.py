"""The one file that knows what differs between Blender 3.4, 4.x and 5.x.

3.4   UVs, pins and UV selection are members of uv_layer.data.
3.5   UVs are attributes: uv_layer.uv, and uv_layer.pin, which is empty where nothing is pinned.
4.1   Smooth shading by angle has become a modifier; sharp edges are an attribute, still read by edge.use_edge_sharp.
4.2   Add-ons may be extensions, whose names begin with bl_ext; __package__ is the key of their preferences.
5.0   UV selection belongs to the mesh and uv_layer.data has none. Nothing here reads or writes UV selection, so it
      stays as it is.
"""

import bmesh
import bpy
import gpu
import numpy as np


def uvs_of(layer):
    """(C, 2) UVs of a UV map, single precision."""
    uvs = np.empty(2 * len(layer.data), dtype=np.float32)
    if hasattr(layer, "uv"):
        layer.uv.foreach_get("vector", uvs)
    else:
        layer.data.foreach_get("uv", uvs)
    return uvs.reshape(-1, 2)


def set_uvs(layer, uvs):
    """Writes (C, 2) UVs to a UV map."""
    flat = np.ascontiguousarray(uvs, dtype=np.float32).ravel()
    if hasattr(layer, "uv"):
        layer.uv.foreach_set("vector", flat)
    else:
        layer.data.foreach_set("uv", flat)


def pins_of(layer):
    """(C,) whether UVs are pinned."""
    pins = np.zeros(len(layer.data), dtype=bool)
    if not hasattr(layer, "pin"):
        layer.data.foreach_get("pin_uv", pins)
    elif len(layer.pin) == len(pins):
        layer.pin.foreach_get("value", pins)
    return pins


def change_pins(item, uv_name, pins, unpins):
    """Pins and frees corners of an object's UV map, also in edit mode. False when there is no such map."""
    if item.mode == "EDIT":
        edited = bmesh.from_edit_mesh(item.data)
        layer = edited.loops.layers.uv.get(uv_name)
        chosen = {**dict.fromkeys(unpins.tolist(), False), **dict.fromkeys(pins.tolist(), True)}
        loops = (loop for face in edited.faces for loop in face.loops) if layer else ()
        for corner, loop in enumerate(loops):
            if corner in chosen:
                loop[layer].pin_uv = chosen[corner]
        bmesh.update_edit_mesh(item.data, loop_triangles=False, destructive=False)
        return layer is not None
    layer = item.data.uv_layers.get(uv_name)
    if layer is None:
        return False
    flags = pins_of(layer)
    flags[unpins], flags[pins] = False, True
    if hasattr(layer, "pin"):
        if hasattr(layer, "pin_ensure"):
            layer.pin_ensure()
        layer.pin.foreach_set("value", flags)
    else:
        layer.data.foreach_set("pin_uv", flags)
    return True


def _edge_flags(mesh, name):
    flags = np.empty(len(mesh.edges), dtype=bool)
    mesh.edges.foreach_get(name, flags)
    return flags


def seams_of(mesh):
    """(E,) edges that are marked as seams."""
    return _edge_flags(mesh, "use_seam")


def sharp_edges_of(mesh):
    """(E,) edges that are marked as sharp."""
    return _edge_flags(mesh, "use_edge_sharp")


def preferences(context):
    """The preferences of this add-on, installed as an add-on or as an extension."""
    return context.preferences.addons[__package__].preferences


def uniform_color_shader():
    """The shader for lines of one colour."""
    return gpu.shader.from_builtin("2D_UNIFORM_COLOR" if bpy.app.version < (4, 0) else "UNIFORM_COLOR")


def flat_color_shader():
    """The shader for coloured triangles; 3.x has its own names for the 2D ones."""
    return gpu.shader.from_builtin("2D_SMOOTH_COLOR" if bpy.app.version < (4, 0) else "SMOOTH_COLOR")
