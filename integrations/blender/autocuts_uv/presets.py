"""Presets of the options in the panels, by Blender's own preset system."""

import bpy
from bl_operators.presets import AddPresetBase
from bl_ui.utils import PresetPanel

from . import options

_FOLDER = "autocuts"


class AUTOCUTS_PT_presets(PresetPanel, bpy.types.Panel):
    """The list of presets in the header of a panel."""

    bl_label = "Autocuts Presets"
    preset_subdir = _FOLDER
    preset_operator = "script.execute_preset"
    preset_add_operator = "autocuts.preset_add"


class AUTOCUTS_OT_preset_add(AddPresetBase, bpy.types.Operator):
    """Add or remove a preset of the options"""

    bl_idname = "autocuts.preset_add"
    bl_label = "Add Autocuts Preset"
    preset_menu = "AUTOCUTS_PT_presets"
    preset_subdir = _FOLDER
    preset_defines = ["settings = bpy.context.scene.autocuts"]
    preset_values = [f"settings.{name}" for name in options.ALL]


CLASSES = (AUTOCUTS_PT_presets, AUTOCUTS_OT_preset_add)
