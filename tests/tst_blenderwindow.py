"""The add-on in a window of Blender: jobs in the background, Escape, undo, edits meanwhile, presets, what is drawn.

Blender runs this, with --enable-event-simulate. Where AUTOCUTS_PICTURES names a folder, screenshots are left there."""

import os
import sys
import tempfile
import traceback
import unittest

import bpy
import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "support"))
import blenderaddon

bpy.context.preferences.view.show_splash = False
PREFERENCES = blenderaddon.install()

from autocuts_uv import engine, jobs, meshdata, operators, overlay

CHECK = unittest.TestCase()
_TICK = 0.02
_SETTLING = 10  # ticks before a screenshot


def window():
    return bpy.context.window_manager.windows[0]


def area(kind):
    return next(one for one in window().screen.areas if one.type == kind)


def within(kind, call, *arguments, **options):
    """Calls an operator in the window's area of a kind."""
    place = area(kind)
    region = next(one for one in place.regions if one.type == "WINDOW")
    with bpy.context.temp_override(window=window(), area=place, region=region):
        return call(*arguments, **options)


def press(key, place=None):
    """A key or a button in the middle of a region, or of the UV editor."""
    place = place or next(one for one in area("IMAGE_EDITOR").regions if one.type == "WINDOW")
    x, y = place.x + place.width // 2, place.y + place.height // 2
    for value in ("PRESS", "RELEASE"):
        window().event_simulate(type=key, value=value, x=x, y=y)


def screenshot(path):
    with bpy.context.temp_override(window=window(), screen=window().screen):
        bpy.ops.wm.redraw_timer(type="DRAW_WIN_SWAP", iterations=1)
        bpy.ops.screen.screenshot(filepath=path)


def color_in_uv_editor(uv):
    """What is seen at a place of the UV editor: red, green, blue from 0 to 1."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "screen.png")
        screenshot(path)
        image = bpy.data.images.load(path)
        pixels = np.array(image.pixels).reshape(image.size[1], image.size[0], 4)
        bpy.data.images.remove(image)
    region = next(one for one in area("IMAGE_EDITOR").regions if one.type == "WINDOW")
    x, y = region.view2d.view_to_region(*uv, clip=False)
    return pixels[region.y + y, region.x + x, :3]


def picture(name):
    """Leaves a screenshot, once panels that open have moved to their places."""
    if "AUTOCUTS_PICTURES" in os.environ:
        for _ in range(_SETTLING):
            yield lambda: True
        screenshot(os.path.join(os.environ["AUTOCUTS_PICTURES"], name + ".png"))


def uvs():
    """(C, 2) UVs of the active object, in every mode."""
    item = bpy.context.view_layer.objects.active
    mesh = meshdata.flushed_mesh(item)
    return meshdata._uvs_and_pins(item, len(mesh.loops))[0]


def job_ended():
    return operators.BackgroundMixin.current is None


def begin(name, **options):
    """Begins an operator as a button of the UV editor does."""
    result = within("IMAGE_EDITOR", getattr(bpy.ops.autocuts, name), "INVOKE_DEFAULT", **options)
    CHECK.assertEqual(result, {"RUNNING_MODAL"})
    CHECK.assertFalse(job_ended())


def add(kind, **options):
    """Begins with an empty scene and one mesh, in edit mode with all faces selected."""
    if bpy.context.view_layer.objects.active and bpy.context.view_layer.objects.active.mode == "EDIT":
        within("VIEW_3D", bpy.ops.object.mode_set, mode="OBJECT")
    bpy.data.batch_remove(list(bpy.data.objects))
    within("VIEW_3D", getattr(bpy.ops.mesh, f"primitive_{kind}_add"), **options)
    within("VIEW_3D", bpy.ops.object.mode_set, mode="EDIT")
    within("VIEW_3D", bpy.ops.mesh.select_all, action="SELECT")
    within("VIEW_3D", bpy.ops.ed.undo_push, message="Begin")


def undo():
    within("IMAGE_EDITOR", bpy.ops.ed.undo)


def redo():
    within("IMAGE_EDITOR", bpy.ops.ed.redo)


def overlaps():
    item = bpy.context.view_layer.objects.active
    model = meshdata.model_of(bpy.context, [item], meshdata.Taking())
    program = engine.CommandEngine(os.environ["AUTOCUTS_CLI"])
    figures = jobs.Job(program.run(engine.Request("check", model))).wait().figures
    return figures["overlapping_pairs"] + figures["flipped_triangles"]


def unwrap_in_both_modes():
    """A run is one undo step."""
    for mode in ("EDIT", "OBJECT"):
        add("monkey")
        within("VIEW_3D", bpy.ops.object.mode_set, mode=mode)
        within("VIEW_3D", bpy.ops.ed.undo_push, message="Mode")
        before = uvs()
        begin("unwrap", quality="draft")
        CHECK.assertFalse(operators.AUTOCUTS_OT_pack.poll(bpy.context))
        yield job_ended
        after = uvs()
        CHECK.assertFalse(np.array_equal(before, after))
        CHECK.assertEqual(overlaps(), 0)
        undo()
        CHECK.assertTrue(np.array_equal(uvs(), before), mode)
        redo()
        CHECK.assertTrue(np.array_equal(uvs(), after), mode)


def escape_keeps_the_best_map():
    for kind in ("MODULE", "PROGRAM"):
        PREFERENCES.engine = kind
        add("ico_sphere", subdivisions=4)
        before = uvs()
        begin("unwrap", quality="best")
        yield lambda: operators.BackgroundMixin.current.share > 0.3
        if kind == "PROGRAM":
            yield from picture("run")
        press("ESC")
        yield job_ended
        CHECK.assertFalse(np.array_equal(uvs(), before))
        CHECK.assertEqual(overlaps(), 0)
        undo()
        CHECK.assertTrue(np.array_equal(uvs(), before))
    PREFERENCES.engine = "AUTO"


def the_live_map():
    """The best map so far is drawn, in both modes; the mesh is untouched until the end."""
    for mode in ("OBJECT", "EDIT"):
        add("ico_sphere", subdivisions=5)
        within("VIEW_3D", bpy.ops.object.mode_set, mode=mode)
        within("VIEW_3D", bpy.ops.ed.undo_push, message="Mode")
        within("IMAGE_EDITOR", bpy.ops.image.view_all)
        before = uvs()
        begin("unwrap", quality="best")
        running = operators.BackgroundMixin.current
        yield lambda: overlay._live
        CHECK.assertRegex(running.status_text(), "[0-9]+%, Escape stops")
        CHECK.assertTrue(np.array_equal(uvs(), before))
        yield from picture(f"live_{mode.lower()}")
        # The middle of the longest seam, of those drawn last.
        seams = running._drawn.seams
        longest = seams[np.argmax(np.linalg.norm(seams[:, 1] - seams[:, 0], axis=1))]
        color = color_in_uv_editor(longest.mean(axis=0))
        CHECK.assertGreater(color[0] - color[2], 0.3, (mode, color))
        press("ESC")
        yield job_ended
        CHECK.assertEqual(overlay._live, [])
        CHECK.assertFalse(np.array_equal(uvs(), before))
        CHECK.assertEqual(overlaps(), 0)
        undo()
        CHECK.assertTrue(np.array_equal(uvs(), before))


def the_button_stops_too():
    add("ico_sphere", subdivisions=4)
    before = uvs()
    begin("unwrap", quality="best")
    yield lambda: operators.BackgroundMixin.current.share > 0.3
    within("VIEW_3D", bpy.ops.autocuts.stop)
    yield job_ended
    CHECK.assertFalse(np.array_equal(uvs(), before))


def edits_meanwhile():
    """Other edits and their undo do not disturb a run; an edit of the topology does, and the mesh keeps its UVs."""
    add("ico_sphere", subdivisions=3)
    before = uvs()
    begin("unwrap")
    within("VIEW_3D", bpy.ops.transform.translate, value=(1, 0, 0))
    within("VIEW_3D", bpy.ops.transform.translate, value=(1, 0, 0))
    undo()
    yield job_ended
    CHECK.assertFalse(np.array_equal(uvs(), before))
    CHECK.assertEqual(overlaps(), 0)
    add("ico_sphere", subdivisions=3)
    begin("unwrap")
    within("VIEW_3D", bpy.ops.mesh.subdivide)
    before = uvs()
    yield job_ended
    CHECK.assertTrue(np.array_equal(uvs(), before))


def another_file_ends_a_run():
    add("ico_sphere", subdivisions=4)
    begin("unwrap", quality="best")
    yield lambda: operators.BackgroundMixin.current.share > 0.1
    job = operators.BackgroundMixin.current._job
    bpy.ops.wm.read_homefile(app_template="")
    yield lambda: job_ended() and not job.running
    CHECK.assertTrue(job.closed)
    yield show_uv_editor()


def the_end_of_the_add_on_ends_a_run():
    """Closing Blender does the same."""
    add("ico_sphere", subdivisions=4)
    begin("unwrap", quality="best")
    yield lambda: operators.BackgroundMixin.current.share > 0.1
    job = operators.BackgroundMixin.current._job
    operators.unregister()
    CHECK.assertFalse(job.running)
    yield job_ended


def adjust_last_operation():
    add("monkey")
    begin("unwrap", quality="draft")
    yield job_ended
    within("IMAGE_EDITOR", bpy.ops.ed.undo_push, message="Map")
    within("IMAGE_EDITOR", bpy.ops.autocuts.pack, "EXEC_DEFAULT", True, margin=40)
    expected = uvs()
    undo()
    within("IMAGE_EDITOR", bpy.ops.autocuts.pack, "EXEC_DEFAULT", True, margin=8)
    CHECK.assertFalse(np.array_equal(uvs(), expected))
    bpy.context.window_manager.operators[-1].margin = 40
    within("IMAGE_EDITOR", bpy.ops.ed.undo_redo)
    CHECK.assertTrue(np.array_equal(uvs(), expected))


def presets_are_kept():
    settings = bpy.context.scene.autocuts
    settings.margin, settings.seams_from, settings.texture_size = 21, {"hard", "uv"}, (512, 256)
    within("IMAGE_EDITOR", bpy.ops.autocuts.preset_add, name="Props")
    settings.margin, settings.seams_from, settings.texture_size = 8, {"cuts", "uv"}, (2048, 2048)
    path = bpy.utils.preset_find("Props", os.path.join("autocuts"))
    within("IMAGE_EDITOR", bpy.ops.script.execute_preset, filepath=path, menu_idname="AUTOCUTS_PT_presets")
    found = (settings.margin, settings.seams_from, tuple(settings.texture_size))
    CHECK.assertEqual(found, (21, {"hard", "uv"}, (512, 256)))
    settings.margin, settings.seams_from, settings.texture_size = 8, {"cuts", "uv"}, (2048, 2048)
    yield job_ended


def overlays():
    """What is drawn lies on the map and has the colours of the figures."""
    add("monkey")
    for kind in ("STRETCH", "DENSITY", "OVERLAPS"):
        bpy.context.scene.autocuts.overlay = kind
        begin("measure")
        yield job_ended
        yield from picture(kind.lower())
    CHECK.assertIn("1 overlap", bpy.context.scene.autocuts.figures)
    begin("unwrap", quality="draft")
    yield job_ended
    bpy.context.scene.autocuts.overlay = "STRETCH"
    begin("measure")
    yield job_ended
    yield from picture("unwrapped")
    CHECK.assertNotIn("overlap", bpy.context.scene.autocuts.figures)
    # A map of two squares, one of them on top of another: the corners of the faces are far away from their middles.
    add("cube")
    item = bpy.context.view_layer.objects.active
    square = np.array([[0, 0], [1, 0], [1, 1], [0, 1]])
    places = [(0, 0), (0, 0), (2, 0), (2, 2), (0, 2), (4, 0)]
    model = meshdata.model_of(bpy.context, [item], meshdata.Taking())
    meshdata.write_uvs(model.parts, np.concatenate([square + place for place in places]) / 5)
    for kind, low, high in (("OVERLAPS", "red", "blue"), ("STRETCH", "green", "green"), ("NONE", "", "")):
        bpy.context.scene.autocuts.overlay = kind
        for uv, wanted in (((0.1, 0.1), low), ((0.5, 0.1), high)):
            color = color_in_uv_editor(uv)
            strongest = ("red", "green", "blue")[int(np.argmax(color))] if np.ptp(color) > 0.05 else ""
            CHECK.assertEqual(strongest, wanted, (kind, uv, color))


def show_uv_editor():
    """Opens the workspace for UVs, with both sidebars. Gives what to wait for."""
    bpy.context.window_manager.windows[0].workspace = bpy.data.workspaces["UV Editing"]

    def shown():
        kinds = [one.type for one in window().screen.areas]
        if "IMAGE_EDITOR" not in kinds or "VIEW_3D" not in kinds:
            return False
        for kind in ("IMAGE_EDITOR", "VIEW_3D"):
            area(kind).spaces.active.show_region_ui = True
        return True

    return shown


def open_tabs():
    """Clicks on the tab of the add-on in both sidebars, whose places are those of a new window of 1920 x 1080."""
    for x, y in ((789, 819), (1572, 828)):
        for kind, value in (("MOUSEMOVE", "NOTHING"), ("LEFTMOUSE", "PRESS"), ("LEFTMOUSE", "RELEASE")):
            window().event_simulate(type=kind, value=value, x=x, y=y)
            yield lambda: True
    within("IMAGE_EDITOR", bpy.ops.image.view_all)


def everything():
    """All cases one after the other; each yields what it waits for."""
    yield show_uv_editor()
    if "AUTOCUTS_PICTURES" in os.environ:
        yield from open_tabs()
    wanted = sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else ()
    for case in (
        unwrap_in_both_modes,
        escape_keeps_the_best_map,
        the_live_map,
        the_button_stops_too,
        edits_meanwhile,
        the_end_of_the_add_on_ends_a_run,
        adjust_last_operation,
        presets_are_kept,
        overlays,
        another_file_ends_a_run,
    ):
        if not wanted or case.__name__ in wanted:
            print("case", case.__name__, flush=True)
            yield from case()


class Runner:
    """Goes on with the cases from a timer, so that Blender's windows live in between."""

    def __init__(self):
        self._cases = everything()
        self._ready = next(self._cases)

    def __call__(self):
        try:
            if self._ready():
                self._ready = next(self._cases)
            return _TICK
        except StopIteration:
            print("all cases passed", flush=True)
            os._exit(0)
        except BaseException:
            traceback.print_exc()
            sys.stderr.flush()
            if "AUTOCUTS_PICTURES" in os.environ:
                screenshot(os.path.join(os.environ["AUTOCUTS_PICTURES"], "failed.png"))
            os._exit(1)


bpy.app.timers.register(Runner(), first_interval=_TICK, persistent=True)
