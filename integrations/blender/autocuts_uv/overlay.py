"""Overlaps, stretch and texel density, drawn over the UV editor."""

import bpy
import gpu
import numpy as np
from gpu_extras.batch import batch_for_shader

from . import api, figures, meshdata

_ALPHA = 0.75
_RED = np.array([0.95, 0.1, 0.1, _ALPHA])
_CLEAR = np.array([0.2, 0.6, 0.9, 0.12])
_STRETCH_SPAN = np.log(2.0)  # of the energy over 4: that much is full red
_DENSITY_SPAN = np.log(2.0)  # of the density over the median

_handle = None
_batch = None


def _blend(share):
    """Colours from green by yellow to red. share: (N,), 0 to 1."""
    share = np.clip(share, 0, 1)
    red, green = np.minimum(1, 2 * share), np.minimum(1, 2 - 2 * share)
    return np.stack([red, green, np.full_like(share, 0.1), np.full_like(share, _ALPHA)], axis=1)


def colors_of(kind, points, uvs, size):
    """(T, 4) colours of triangles. kind: "OVERLAPS", "STRETCH" or "DENSITY"; points (T, 3, 3), uvs (T, 3, 2)."""
    if kind == "OVERLAPS":
        return np.where(figures.overlapping(uvs)[:, None], _RED, _CLEAR)
    if kind == "STRETCH":
        return _blend(np.log(figures.stretch(points, uvs) / 4) / _STRETCH_SPAN)
    density = np.maximum(figures.density(points, uvs, size), 1e-300)
    share = np.log(density / np.median(density)) / _DENSITY_SPAN
    colors = _blend(np.abs(share))
    colors[share < 0, 2], colors[share < 0, 0] = colors[share < 0, 0], 0.1  # too few texels: blue
    return colors


def _make_batch(context):
    settings = context.scene.autocuts
    objects = [item for item in meshdata.objects_to_map(context) if item.data.uv_layers]
    if settings.overlay == "NONE" or not objects:
        return None
    model = meshdata.model_of(context, objects, meshdata.Taking(seams=False, pins=False))
    triangles, _ = figures.fan_triangles(model.face_sizes)
    uvs, points = model.uvs[triangles], model.positions[model.corners[triangles]]
    colors = colors_of(settings.overlay, points, uvs, tuple(settings.texture_size))
    return batch_for_shader(
        api.flat_color_shader(),
        "TRIS",
        {
            "pos": uvs.reshape(-1, 2).astype(np.float32),
            "color": np.repeat(colors, 3, axis=0).astype(np.float32),
        },
    )


def update():
    """Measures what is selected anew, and draws it."""
    global _batch
    if bpy.app.background:
        return
    _batch = _make_batch(bpy.context)
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == "IMAGE_EDITOR":
                area.tag_redraw()


def update_from_property(_settings, _context):
    """For properties that the overlay depends on."""
    update()


def _draw():
    if _batch is None or bpy.context.area.ui_type != "UV":
        return
    view = bpy.context.region.view2d
    origin = view.view_to_region(0, 0, clip=False)
    far = view.view_to_region(1000, 1000, clip=False)
    shader = api.flat_color_shader()
    gpu.state.blend_set("ALPHA")
    with gpu.matrix.push_pop():
        gpu.matrix.translate(origin)
        gpu.matrix.scale(((far[0] - origin[0]) / 1000, (far[1] - origin[1]) / 1000))
        _batch.draw(shader)
    gpu.state.blend_set("NONE")


def register():
    global _handle
    if not bpy.app.background:
        _handle = bpy.types.SpaceImageEditor.draw_handler_add(_draw, (), "WINDOW", "POST_PIXEL")


def unregister():
    global _handle, _batch
    _batch = None
    if _handle:
        bpy.types.SpaceImageEditor.draw_handler_remove(_handle, "WINDOW")
        _handle = None
