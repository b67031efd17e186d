"""What is drawn over the UV editor: overlaps, stretch and texel density, and the map of a job that runs."""

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

_SEAM_COLOR = (1.0, 0.45, 0.1, 1.0)
_INNER_COLOR = (1.0, 1.0, 1.0, 0.2)
_SEAM_WIDTH = 2  # pixels

_handle = None
_batch = None
_live = []  # batches of lines, their colours and widths


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
    _redraw()


def show_live(live_map):
    """Draws the newest map of a job that runs; None when it has ended. The meshes are not touched."""
    _live.clear()
    if bpy.app.background:
        return
    shader = api.uniform_color_shader()
    drawn = [] if live_map is None else [(live_map.inner, _INNER_COLOR, 1), (live_map.seams, _SEAM_COLOR, _SEAM_WIDTH)]
    for lines, color, width in drawn:
        points = lines.reshape(-1, 2).astype(np.float32)
        _live.append((batch_for_shader(shader, "LINES", {"pos": points}), color, width))
    _redraw()


def _redraw():
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == "IMAGE_EDITOR":
                area.tag_redraw()


def update_from_property(_settings, _context):
    """For properties that the overlay depends on."""
    update()


def _draw():
    if (_batch is None and not _live) or bpy.context.area.ui_type != "UV":
        return
    view = bpy.context.region.view2d
    origin = view.view_to_region(0, 0, clip=False)
    far = view.view_to_region(1000, 1000, clip=False)
    gpu.state.blend_set("ALPHA")
    with gpu.matrix.push_pop():
        gpu.matrix.translate(origin)
        gpu.matrix.scale(((far[0] - origin[0]) / 1000, (far[1] - origin[1]) / 1000))
        if _batch is not None and not _live:
            _batch.draw(api.flat_color_shader())
        for batch, color, width in _live:
            gpu.state.line_width_set(width)
            shader = api.uniform_color_shader()
            shader.bind()
            shader.uniform_float("color", color)
            batch.draw(shader)
    gpu.state.line_width_set(1)
    gpu.state.blend_set("NONE")


def register():
    global _handle
    if not bpy.app.background:
        _handle = bpy.types.SpaceImageEditor.draw_handler_add(_draw, (), "WINDOW", "POST_PIXEL")


def unregister():
    global _handle, _batch
    _batch = None
    _live.clear()
    if _handle:
        bpy.types.SpaceImageEditor.draw_handler_remove(_handle, "WINDOW")
        _handle = None
