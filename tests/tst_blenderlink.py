"""Blender and a studio, by the live link: maps, seams, pins and the selection both ways, edits, and a studio that is killed.

Blender runs this without a window, so the test calls what the timer would call. A second program, linked to the same model,
shows what is in the studio."""

import os
import shutil
import signal
import stat
import sys
import tempfile
import time
import unittest

import bmesh
import bpy
import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "support"))
import blenderaddon

PREFERENCES = blenderaddon.install()

from autocuts_uv import api, link, livelink, meshdata

STUDIO = os.environ["AUTOCUTS_STUDIO"]
LONG = 120  # seconds; much longer than anything takes


def add_grid(side):
    bpy.ops.mesh.primitive_grid_add(x_subdivisions=side, y_subdivisions=side)
    item = bpy.context.object
    for vertex in item.data.vertices:
        vertex.co.z = 0.4 * vertex.co.x * vertex.co.y
    return item


def uvs_of(item):
    return api.uvs_of(item.data.uv_layers.active) if item.data.uv_layers else None


def inner_edge(mesh, number):
    """The number of an edge between two faces."""
    counts = np.bincount(meshdata.values(mesh.loops, "edge_index", np.int32))
    return int(np.flatnonzero(counts == 2)[number])


class BlenderLink(unittest.TestCase):
    def setUp(self):
        if bpy.context.mode != "OBJECT":
            bpy.ops.object.mode_set(mode="OBJECT")
        bpy.data.batch_remove(list(bpy.data.objects))
        self.folder = tempfile.mkdtemp(prefix="link")
        self.addCleanup(shutil.rmtree, self.folder, True)
        for name in ("XDG_RUNTIME_DIR", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"):
            os.environ[name] = os.path.join(self.folder, name)
            os.mkdir(os.environ[name], 0o700)
        self.addCleanup(self.kill_studios)
        bpy.context.scene.autocuts.link_mode = "live"

    def kill_studios(self):
        session = livelink.current
        livelink.end()
        if session is not None and session.process is not None:
            session.process.kill()
            session.process.wait()

    def studio(self, *arguments):
        """Lets the add-on start the studio with arguments."""
        path = os.path.join(self.folder, "studio")
        with open(path, "w", encoding="utf-8") as file:
            file.write(f'#!/bin/sh\nexec "{STUDIO}" {" ".join(arguments)}\n')
        os.chmod(path, stat.S_IRWXU)
        PREFERENCES.studio = path

    def until(self, holds, what):
        """Does what the timer does until something holds."""
        end = time.monotonic() + LONG
        while not holds():
            self.assertLess(time.monotonic(), end, what)
            livelink.current.dirty = True
            livelink.current.tick()
            time.sleep(0.02)

    def open(self, *items):
        for item in bpy.data.objects:
            item.select_set(item in items)
        bpy.context.view_layer.objects.active = items[0]
        self.assertEqual(bpy.ops.autocuts.open_studio(), {"FINISHED"})
        session = livelink.current
        self.until(lambda: session.serial > 0 and not session.waiting, "no studio")
        self.assertEqual(session.notes, [])
        return session

    def second(self, *items):
        """Another program with the same model. What is in the studio comes to it."""
        program = link.connect(livelink.model_name(), "Second")
        self.addCleanup(program.close)
        program.want("live")
        model = meshdata.model_of(bpy.context, list(items), meshdata.Taking())
        program.send_mesh(
            livelink.model_name(), model.names, model.positions, model.face_sizes, model.corners, model.face_objects, up="z"
        )
        self.assertEqual(program.wait_for("taken", LONG).fields["how"], "unchanged")
        return program

    def hears(self, program, kind, fits):
        """The first message of a type that fits."""
        found = []

        def heard():
            found.extend(one for one in program.poll() if one.type == kind and fits(one))
            return found

        self.until(heard, f"no {kind}")
        return found[0]

    def test_maps_come_while_solving(self):
        self.studio("--solve")
        items = add_grid(8), add_grid(5)
        self.open(*items)
        before = [uvs_of(item).copy() for item in items]
        self.until(lambda: all(not np.array_equal(uvs_of(i), b) for i, b in zip(items, before)), "no map")
        for item in items:
            self.assertTrue(((uvs_of(item) > -0.01) & (uvs_of(item) < 1.01)).all())

    def test_seams_pins_and_uvs_go_both_ways(self):
        self.studio()
        item = add_grid(6)
        self.open(item)
        program = self.second(item)
        first, other = inner_edge(item.data, 3), inner_edge(item.data, 20)
        ends = [sorted(item.data.edges[number].vertices) for number in (first, other)]
        item.data.edges[first].use_seam = True
        marks = self.hears(program, "marks", lambda one: "cuts" in one.arrays)
        self.assertEqual(marks.arrays["cuts"].tolist(), [ends[0]])
        program.send_marks(cuts=[ends[1]], pins=[5], pin_uvs=[uvs_of(item)[5]])
        self.until(lambda: item.data.edges[other].use_seam, "no seam")
        self.until(lambda: api.pins_of(item.data.uv_layers.active)[5], "no pin")
        self.assertTrue(item.data.edges[first].use_seam)
        item.data.edges[first].use_seam = False
        marks = self.hears(program, "marks", lambda one: "uncuts" in one.arrays)
        self.assertEqual(marks.arrays["uncuts"].tolist(), [ends[0]])
        moved = uvs_of(item) * 0.5
        api.set_uvs(item.data.uv_layers.active, moved)
        maps = self.hears(program, "maps", lambda one: np.allclose(one.arrays["uvs"], moved, atol=1e-6))
        self.assertEqual(len(maps.arrays["uvs"]), len(moved))
        self.assertTrue(np.array_equal(uvs_of(item), moved.astype(np.float32)))

    def test_textures_go_both_ways(self):
        self.studio()
        item = add_grid(4)
        paths = []
        for name in ("one", "two", "bumps"):
            image = bpy.data.images.new(name, 4, 4)
            image.filepath_raw = os.path.join(self.folder, name + ".png")
            image.file_format = "PNG"
            image.save()
            paths.append(image.filepath_raw)
        material = bpy.data.materials.new("Wood")
        material.use_nodes = True
        item.data.materials.append(material)
        livelink._set_texture(material, "baseColor", paths[0])
        self.open(item)
        program = self.second(item)
        told = program.wait_for("textures", LONG).fields["materials"]
        self.assertEqual(told, [{"name": "Wood", "textures": {"baseColor": paths[0]}}])
        livelink._set_texture(material, "baseColor", paths[1])
        told = self.hears(program, "textures", lambda one: True).fields["materials"]
        self.assertEqual(told, [{"name": "Wood", "textures": {"baseColor": paths[1]}}])
        program.send_textures([{"name": "Wood", "textures": {"baseColor": paths[0], "normal": paths[2]}}])
        expected = {"baseColor": paths[0], "normal": paths[2]}
        self.until(lambda: livelink._textures(material) == expected, "no textures")

    def test_selection_in_edit_mode(self):
        self.studio()
        item = add_grid(4)
        bpy.ops.object.mode_set(mode="EDIT")
        bpy.ops.mesh.select_all(action="DESELECT")
        self.open(item)
        program = self.second(item)
        edited = bmesh.from_edit_mesh(item.data)
        edited.faces.ensure_lookup_table()
        edited.faces[3].select_set(True)
        bmesh.update_edit_mesh(item.data)
        self.assertEqual(self.hears(program, "marks", lambda one: True).arrays["selection"].tolist(), [3])
        program.send_marks(selection=[1, 2], cuts=[sorted(item.data.edges[inner_edge(item.data, 0)].vertices)])

        def selected():
            return [face.index for face in bmesh.from_edit_mesh(item.data).faces if face.select]

        self.until(lambda: selected() == [1, 2], "no selection")
        self.assertTrue(any(edge.seam for edge in bmesh.from_edit_mesh(item.data).edges))

    def test_edits_of_the_mesh_are_relinked(self):
        self.studio("--solve")
        item = add_grid(6)
        session = self.open(item)
        seam = inner_edge(item.data, 3)
        item.data.edges[seam].use_seam = True
        for number in range(5):
            serial = session.serial
            item.data.vertices[number].co.z += 0.1
            item.data.update()
            self.until(lambda: session.serial > serial and not session.waiting, "not handed over")
        self.assertEqual(session.notes, [])
        edited = bmesh.new()
        edited.from_mesh(item.data)
        edited.faces.ensure_lookup_table()
        edited.faces.remove(edited.faces[0])
        edited.to_mesh(item.data)
        edited.free()
        serial = session.serial
        self.until(lambda: session.serial > serial and not session.waiting, "not handed over")
        self.assertIn("1 of 36 faces", session.notes[0])
        self.second(item)  # finds that the studio has the same
        self.assertTrue(session.is_open)

    def test_on_request(self):
        self.studio()
        bpy.context.scene.autocuts.link_mode = "request"
        item = add_grid(4)
        self.open(item)
        program = self.second(item)
        before = uvs_of(item).copy()
        model = meshdata.model_of(bpy.context, [item], meshdata.Taking())
        program.send_mesh(
            livelink.model_name(),
            model.names,
            model.positions,
            model.face_sizes,
            model.corners,
            model.face_objects,
            uv_sets=[("UVMap", model.uvs * 0.25)],
            up="z",
        )
        program.wait_for("taken", LONG)
        program.request()
        program.wait_for("maps", LONG)
        livelink.current.tick()
        self.assertTrue(np.array_equal(uvs_of(item), before))
        self.assertEqual(bpy.ops.autocuts.get_map(), {"FINISHED"})
        self.until(lambda: np.allclose(uvs_of(item), 0.25 * before, atol=1e-6), "no map")

    def test_a_killed_studio(self):
        self.studio()
        item = add_grid(4)
        session = self.open(item)
        os.kill(session.process.pid, signal.SIGKILL)
        session.process.wait()
        self.until(lambda: not session.is_open, "the link is open")
        self.assertIn("ended", session.notes[-1])
        item.data.edges[inner_edge(item.data, 3)].use_seam = True
        again = self.open(item)
        self.assertTrue(again.is_open)

    def test_a_program_that_is_no_studio(self):
        self.studio("--help > /dev/null; exit 1;")
        item = add_grid(4)
        item.select_set(True)
        bpy.ops.autocuts.open_studio()
        self.until(lambda: not livelink.current.is_open, "the link is open")
        self.assertIn("did not start", livelink.current.notes[-1])
        PREFERENCES.studio = os.path.join(self.folder, "missing")
        with self.assertRaisesRegex(RuntimeError, "not found"):
            bpy.ops.autocuts.open_studio()


blenderaddon.run_unittest(__name__)
