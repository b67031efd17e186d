"""Installs the add-on of the build; for tests that Blender runs with a folder of its own for add-ons."""

import os
import sys

import bpy


def install():
    """Installs the zip as a user would, and gives the preferences of the add-on."""
    bpy.ops.preferences.addon_install(filepath=os.environ["AUTOCUTS_ADDON"], target="DEFAULT")
    bpy.ops.preferences.addon_enable(module="autocuts_uv")
    preferences = bpy.context.preferences.addons["autocuts_uv"].preferences
    preferences.program = os.environ["AUTOCUTS_CLI"]
    preferences.module_folder = os.environ["AUTOCUTS_MODULE"]
    return preferences


def run_unittest(module):
    """Runs the tests of a module and ends Blender with an exit code."""
    import unittest

    names = sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else None
    suite = unittest.defaultTestLoader.loadTestsFromName(module)
    if names:
        suite = unittest.defaultTestLoader.loadTestsFromNames(names, sys.modules[module])
    result = unittest.TextTestRunner(verbosity=2).run(suite)
    sys.stdout.flush()
    os._exit(not result.wasSuccessful())
