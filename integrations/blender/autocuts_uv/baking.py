"""Bakes: Blender writes the models, autocuts-cli bakes them."""

import os
import tempfile

import bpy

from . import engine


def _export(context, objects, path):
    """Writes objects with their modifiers, normals and materials as an OBJ."""
    layer = context.view_layer
    active, selected = layer.objects.active, context.selected_objects
    for item in selected:
        item.select_set(False)
    for item in objects:
        item.select_set(True)
    try:
        bpy.ops.wm.obj_export(filepath=path, export_selected_objects=True, path_mode="ABSOLUTE")
    finally:
        for item in objects:
            item.select_set(False)
        for item in selected:
            item.select_set(True)
        layer.objects.active = active


def job(context, program, folder, options):
    """A job that bakes the selected objects onto the active one and returns the paths of the pictures. The models are
    written now."""
    low = context.active_object
    high = [item for item in context.selected_objects if item != low and item.type == "MESH"]
    models = tempfile.TemporaryDirectory(prefix="autocuts_")
    # The pictures have the name of the model.
    low_path = os.path.join(models.name, bpy.path.clean_name(low.name) + ".obj")
    _export(context, [low], low_path)
    words = ["bake", low_path, "-o", folder, *engine.command_words(options)]
    if high:
        high_path = os.path.join(models.name, "high.obj")
        _export(context, high, high_path)
        words += ["--high", high_path]

    def steps():
        with models:
            report = os.path.join(models.name, "report.json")
            code, messages = yield from program.call([*words, "--report", report])
            if code != 0:
                raise engine.EngineError(messages[-1] if messages else "the bake was stopped")
            return engine.pictures_of(report)

    return steps()
