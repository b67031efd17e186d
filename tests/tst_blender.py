"""The add-on for Blender without a window: what it takes over, what it keeps, and its jobs. Blender runs this."""

import os
import re
import subprocess
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

from autocuts_uv import api, engine, figures, jobs, meshdata, operators, options

PROGRAM = os.environ["AUTOCUTS_CLI"]


def read(collection, name, kind, width=1):
    return meshdata.values(collection, name, kind, width).tolist()


def uvs_of(item, name=None):
    """(C, 2) UVs of an object in object mode."""
    layers = item.data.uv_layers
    return api.uvs_of(layers[name] if name else layers.active)


def everything_but_uvs(item):
    """All that must be kept of an object, as plain values."""
    mesh = item.data
    mesh.calc_normals_split()
    active = mesh.uv_layers.active
    return {
        "positions": read(mesh.vertices, "co", np.float32, 3),
        "corners": read(mesh.loops, "vertex_index", np.int32),
        "sizes": read(mesh.polygons, "loop_total", np.int32),
        "normals": read(mesh.loops, "normal", np.float32, 3),
        "custom normals": mesh.has_custom_normals,
        "smooth": read(mesh.polygons, "use_smooth", bool),
        "sharp": read(mesh.edges, "use_edge_sharp", bool),
        "seams": read(mesh.edges, "use_seam", bool),
        "hidden": [read(part, "hide", bool) for part in (mesh.vertices, mesh.edges, mesh.polygons)],
        "selected": [read(part, "select", bool) for part in (mesh.vertices, mesh.edges, mesh.polygons)],
        "materials": [slot.name for slot in mesh.materials],
        "material of faces": read(mesh.polygons, "material_index", np.int32),
        "shape keys": [
            (key.name, key.value, read(key.data, "co", np.float32, 3))
            for key in (mesh.shape_keys.key_blocks if mesh.shape_keys else ())
        ],
        "groups": [group.name for group in item.vertex_groups],
        "weights": [[(member.group, member.weight) for member in vertex.groups] for vertex in mesh.vertices],
        "colours": [(color.name, read(color.data, "color", np.float32, 4)) for color in mesh.color_attributes],
        "UV maps": [layer.name for layer in mesh.uv_layers],
        "active UV map": active.name if active else "",
        "other UV maps": [api.uvs_of(layer).tolist() for layer in mesh.uv_layers if layer != active],
        "selected UVs": [read(layer.data, "select", bool) for layer in mesh.uv_layers],
        "pins": [read(layer.data, "pin_uv", bool) for layer in mesh.uv_layers],
        "modifiers": [(modifier.name, modifier.type) for modifier in item.modifiers],
        "matrix": [list(row) for row in item.matrix_world],
        "parent": item.parent.name if item.parent else "",
    }


def select(*items):
    bpy.ops.object.select_all(action="DESELECT")
    for item in items:
        item.select_set(True)
    bpy.context.view_layer.objects.active = items[0]


def in_edit_mode(call, **arguments):
    bpy.ops.object.mode_set(mode="EDIT")
    result = call(**arguments)
    bpy.ops.object.mode_set(mode="OBJECT")
    return result


def select_faces(mesh, chosen):
    """Selects these faces, their edges and vertices, and no others. chosen: (F,) bool."""
    for part in (mesh.vertices, mesh.edges):
        part.foreach_set("select", np.zeros(len(part), dtype=bool))
    mesh.polygons.foreach_set("select", chosen)
    bpy.context.tool_settings.mesh_select_mode = (False, False, True)


def part_of_face(mesh):
    """(F,) the number of the connected part of each face, from 0, the part with the fewest faces first."""
    least = np.arange(len(mesh.vertices))
    before = None
    while not np.array_equal(before, least):
        before = least.copy()
        for polygon in mesh.polygons:
            least[list(polygon.vertices)] = least[list(polygon.vertices)].min()
    labels = least[[polygon.vertices[0] for polygon in mesh.polygons]]
    names, counts = np.unique(labels, return_counts=True)
    return np.argsort(np.argsort(counts, kind="stable"))[np.searchsorted(names, labels)]


def add_suzanne():
    """Suzanne with all that an artist may have given her."""
    bpy.ops.mesh.primitive_monkey_add()
    item = bpy.context.object
    mesh = item.data
    item.modifiers.new("Subdivision", "SUBSURF")
    item.modifiers.new("Mirror", "MIRROR").use_axis = (False, True, False)
    item.shape_key_add(name="Basis")
    smile = item.shape_key_add(name="Smile")
    smile.data[3].co.z += 0.2
    smile.value = 0.5
    mesh.use_auto_smooth = True
    rng = np.random.default_rng(5)
    normals = rng.normal(size=(len(mesh.loops), 3))
    mesh.normals_split_custom_set((normals / np.linalg.norm(normals, axis=1)[:, None]).tolist())
    group = item.vertex_groups.new(name="Ears")
    group.add(list(range(0, 90)), 0.7, "REPLACE")
    colors = mesh.color_attributes.new("Paint", "FLOAT_COLOR", "CORNER")
    colors.data.foreach_set("color", rng.random(4 * len(mesh.loops)).astype(np.float32))
    for name in ("Skin", "Eyes"):
        mesh.materials.append(bpy.data.materials.new(name))
    mesh.polygons.foreach_set("material_index", rng.integers(0, 2, len(mesh.polygons)).astype(np.int32))
    mesh.uv_layers.new(name="Second")
    mesh.uv_layers.active = mesh.uv_layers["UVMap"]
    select_faces(mesh, part_of_face(mesh) == 0)
    in_edit_mode(bpy.ops.mesh.hide, unselected=False)
    select_faces(mesh, rng.random(len(mesh.polygons)) < 0.3)
    in_edit_mode(lambda: None)  # selects the edges and vertices of the faces, and nothing hidden
    return item


def add_cube(size=2.0, location=(0, 0, 0)):
    bpy.ops.mesh.primitive_cube_add(size=size, location=location)
    return bpy.context.object


def add_grid(side, size=2.0):
    bpy.ops.mesh.primitive_grid_add(x_subdivisions=side, y_subdivisions=side, size=size)
    return bpy.context.object


def triangle_uvs(item):
    triangles, face = figures.fan_triangles(meshdata.values(item.data.polygons, "loop_total", np.int32))
    return uvs_of(item)[triangles].astype(float), face


def uv_area(item):
    """(F,) area of each face in the map, negative where it is turned over."""
    uvs, face = triangle_uvs(item)
    a, b = uvs[:, 1] - uvs[:, 0], uvs[:, 2] - uvs[:, 0]
    return np.bincount(face, 0.5 * (a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]))


def seams_in_map(item):
    """(E,) edges between two faces whose UVs differ between these."""
    mesh = item.data
    edges, corners = (read(mesh.loops, name, np.int32) for name in ("edge_index", "vertex_index"))
    uvs = uvs_of(item)
    following = np.arange(len(corners)) + 1
    for polygon in mesh.polygons:
        following[polygon.loop_start + polygon.loop_total - 1] = polygon.loop_start
    seams, sides = np.zeros(len(mesh.edges), dtype=bool), {}
    for corner, edge in enumerate(edges):
        if edge in sides:
            other = sides[edge]
            seams[edge] = not (
                np.array_equal(uvs[corner], uvs[following[other]]) and np.array_equal(uvs[following[corner]], uvs[other])
            )
        sides[edge] = corner
    return seams


class BlenderTest(unittest.TestCase):
    def setUp(self):
        if bpy.context.mode != "OBJECT":
            bpy.ops.object.mode_set(mode="OBJECT")
        bpy.data.batch_remove(list(bpy.data.objects))
        PREFERENCES.engine = "AUTO"

    def measured(self, *items):
        """The figures of the map of objects."""
        select(*items)
        model = meshdata.model_of(bpy.context, list(items), meshdata.Taking())
        return jobs.Job(engine.CommandEngine(PROGRAM).run(engine.Request("check", model))).wait().figures

    def assertKept(self, before, item):
        after = everything_but_uvs(item)
        for what, value in before.items():
            self.assertEqual(value, after[what], what)


class Keeping(BlenderTest):
    def test_unwrap_keeps_all_else_with_both_engines(self):
        maps = []
        for kind in ("MODULE", "PROGRAM"):
            PREFERENCES.engine = kind
            item = add_suzanne()
            before, uvs = everything_but_uvs(item), uvs_of(item).copy()
            self.assertEqual(bpy.ops.autocuts.unwrap(quality="draft"), {"FINISHED"})
            self.assertKept(before, item)
            maps.append(uvs_of(item))
            self.assertFalse(np.array_equal(maps[-1], uvs))
            found = self.measured(item)
            self.assertEqual((found["overlapping_pairs"], found["flipped_triangles"]), (0, 0))
            self.assertLess(found["distortion"], 4.1001)
        self.assertTrue(np.array_equal(*maps))

    def test_every_operator_keeps_all_else(self):
        item = add_suzanne()
        bpy.ops.autocuts.unwrap(quality="draft")
        for name in ("unwrap_selected", "pack", "separate", "straighten", "stack", "measure"):
            for edit in (False, True):
                before = everything_but_uvs(item)
                call = getattr(bpy.ops.autocuts, name)
                draft = {"quality": "draft"} if name == "unwrap_selected" else {}
                self.assertEqual(in_edit_mode(call, **draft) if edit else call(**draft), {"FINISHED"}, name)
                self.assertKept(before, item)

    def test_edit_mode_gives_the_map_of_object_mode(self):
        bpy.ops.mesh.primitive_monkey_add()
        bpy.ops.autocuts.unwrap(quality="draft")
        expected = uvs_of(bpy.context.object)
        bpy.ops.mesh.primitive_monkey_add()
        other = bpy.context.object
        in_edit_mode(bpy.ops.autocuts.unwrap, quality="draft")
        self.assertTrue(np.array_equal(uvs_of(other), expected))

    def test_hidden_and_unselected_faces_keep_their_uvs(self):
        item = add_suzanne()
        bpy.ops.autocuts.unwrap(quality="draft")
        before = uvs_of(item).copy()
        mesh = item.data
        faces = np.repeat(np.arange(len(mesh.polygons)), read(mesh.polygons, "loop_total", np.int32))
        hidden = part_of_face(mesh) < 2
        mesh.polygons.foreach_set("hide", hidden)
        in_edit_mode(bpy.ops.autocuts.unwrap, quality="draft", seed=2)
        after = uvs_of(item)
        self.assertTrue(np.array_equal(before[hidden[faces]], after[hidden[faces]]))
        self.assertFalse(np.array_equal(before[~hidden[faces]], after[~hidden[faces]]))
        mesh.polygons.foreach_set("hide", np.zeros(len(hidden), dtype=bool))
        chosen = part_of_face(mesh) == 1
        select_faces(mesh, chosen)
        in_edit_mode(bpy.ops.autocuts.unwrap_selected, quality="draft")
        last = uvs_of(item)
        self.assertTrue(np.array_equal(after[~chosen[faces]], last[~chosen[faces]]))
        self.assertFalse(np.array_equal(after[chosen[faces]], last[chosen[faces]]))

    def test_a_rigged_character_from_fbx(self):
        bpy.ops.object.armature_add()
        rig = bpy.context.object
        bpy.ops.object.mode_set(mode="EDIT")
        spine = rig.data.edit_bones[0]
        arm = rig.data.edit_bones.new("Arm")
        arm.head, arm.tail, arm.parent = spine.tail, (1, 0, 1.5), spine
        bpy.ops.object.mode_set(mode="OBJECT")
        bpy.ops.mesh.primitive_uv_sphere_add(segments=16, ring_count=8)
        body = bpy.context.object
        select(rig, body)
        bpy.ops.object.parent_set(type="ARMATURE_NAME")
        for name, upper in (("Arm", True), ("Bone", False)):
            members = [vertex.index for vertex in body.data.vertices if (vertex.co.z > 0) == upper]
            body.vertex_groups[name].add(members, 0.8, "REPLACE")
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "character.fbx")
            bpy.ops.export_scene.fbx(filepath=path, use_selection=True, bake_anim=False)
            bpy.data.batch_remove(list(bpy.data.objects))
            bpy.ops.import_scene.fbx(filepath=path)
        item = next(one for one in bpy.data.objects if one.type == "MESH")
        rig = next(one for one in bpy.data.objects if one.type == "ARMATURE")
        rig.pose.bones["Arm"].rotation_mode = "XYZ"
        rig.pose.bones["Arm"].rotation_euler = (0.7, 0, 0)
        bpy.context.view_layer.update()
        select(item)
        before = everything_but_uvs(item)
        self.assertEqual(before["groups"], ["Bone", "Arm"])
        self.assertEqual(bpy.ops.autocuts.unwrap(quality="draft"), {"FINISHED"})
        self.assertKept(before, item)
        posed = meshdata.model_of(bpy.context, [item], meshdata.Taking())
        evaluated = item.evaluated_get(bpy.context.evaluated_depsgraph_get())
        expected = [evaluated.matrix_world @ vertex.co for vertex in evaluated.data.vertices]
        self.assertTrue(np.allclose(posed.positions, expected, atol=1e-6))
        rest = meshdata.model_of(bpy.context, [item], meshdata.Taking(modifiers=False))
        self.assertFalse(np.allclose(posed.positions, rest.positions, atol=1e-3))

    def test_modifiers_that_change_topology_do_not_count(self):
        item = add_suzanne()
        model = meshdata.model_of(bpy.context, [item], meshdata.Taking())
        self.assertEqual(len(model.positions), len(item.data.vertices))

    def test_saved_and_loaded(self):
        item = add_suzanne()
        bpy.ops.autocuts.unwrap(quality="draft")
        bpy.context.scene.autocuts.margin = 13
        before, uvs = everything_but_uvs(item), uvs_of(item).copy()
        name = item.name
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "saved.blend")
            bpy.ops.wm.save_as_mainfile(filepath=path)
            bpy.ops.wm.read_factory_settings(use_empty=True)
            globals()["PREFERENCES"] = blenderaddon.install()
            bpy.ops.wm.open_mainfile(filepath=path)
        self.assertKept(before, bpy.data.objects[name])
        self.assertTrue(np.array_equal(uvs_of(bpy.data.objects[name]), uvs))
        self.assertEqual(bpy.context.scene.autocuts.margin, 13)


class TakingOver(BlenderTest):
    def test_sixty_objects_into_one_square_and_a_tile_each(self):
        items = [add_cube(location=(3 * number, 0, 0)) for number in range(60)]
        for number, item in enumerate(items):
            item.scale = (1 + number % 3,) * 3
        bpy.context.view_layer.update()
        select(*items)
        self.assertEqual(bpy.ops.autocuts.unwrap(quality="draft", texture_size=(4096, 4096), margin=4), {"FINISHED"})
        together = np.concatenate([uvs_of(item) for item in items])
        self.assertTrue(((together >= 0) & (together <= 1)).all())
        self.assertEqual(self.measured(*items)["overlapping_pairs"], 0)
        areas = np.array([uv_area(item).sum() for item in items])
        scales = np.array([1 + number % 3 for number in range(60)])
        self.assertTrue(np.allclose(areas / scales**2, areas[0], rtol=1e-3))
        self.assertEqual(bpy.ops.autocuts.pack(per="object"), {"FINISHED"})
        tiles = [np.floor(uvs_of(item).mean(axis=0)).astype(int).tolist() for item in items]
        self.assertEqual(tiles, [[number % 10, number // 10] for number in range(60)])

    def test_linked_duplicates_once(self):
        item = add_suzanne()
        linked = item.copy()
        bpy.context.collection.objects.link(linked)
        select(item, linked)
        self.assertEqual(len(meshdata.objects_to_map(bpy.context)), 1)
        bpy.ops.autocuts.unwrap(quality="draft")
        alone = add_suzanne()
        bpy.ops.autocuts.unwrap(quality="draft")
        self.assertTrue(np.array_equal(uvs_of(linked), uvs_of(alone)))

    def test_marked_seams_sharp_edges_and_materials(self):
        item = add_grid(8)
        mesh = item.data
        middle = [
            edge.index
            for edge in mesh.edges
            if all(abs(mesh.vertices[vertex].co.x) < 1e-6 for vertex in edge.vertices)
        ]
        self.assertEqual(len(middle), 8)
        is_middle = np.isin(np.arange(len(mesh.edges)), middle)
        mesh.polygons.foreach_set("material_index", [int(polygon.center.x > 0) for polygon in mesh.polygons])
        mesh.materials.append(bpy.data.materials.new("Left"))
        mesh.materials.append(bpy.data.materials.new("Right"))
        everything = np.ones(len(mesh.polygons), dtype=bool)
        for flag, arguments in (
            ("use_seam", {}),
            ("use_seam", {"seams": "only", "seams_from": {"cuts"}}),
            ("use_edge_sharp", {"seams": "keep", "seams_from": {"hard"}}),
            ("", {"seams": "only", "seams_from": {"materials"}}),
        ):
            for name in ("use_seam", "use_edge_sharp"):
                mesh.edges.foreach_set(name, is_middle & (name == flag))
            self.assertEqual(bpy.ops.autocuts.unwrap(quality="draft", **arguments), {"FINISHED"})
            self.assertEqual(seams_in_map(item).tolist(), is_middle.tolist(), arguments)
            select_faces(mesh, everything)
            mesh.polygons[0].select = False
            in_edit_mode(bpy.ops.autocuts.unwrap_selected, quality="draft", **arguments)
            self.assertEqual(seams_in_map(item)[is_middle].tolist(), [True] * 8, arguments)
        mesh.edges.foreach_set("use_seam", is_middle)
        bpy.ops.autocuts.unwrap(quality="draft", use_seams=False)
        self.assertFalse(seams_in_map(item).any())

    def test_pins_stay(self):
        item = add_grid(6)
        bpy.ops.autocuts.unwrap(quality="draft")
        layer = item.data.uv_layers.active
        uvs = uvs_of(item) * 0.5 + 0.25
        chosen = [corner for corner, loop in enumerate(item.data.loops) if loop.vertex_index in (0, 48)]
        for corner in chosen:
            layer.data[corner].pin_uv = True
        for call in (bpy.ops.autocuts.unwrap, bpy.ops.autocuts.pack):
            maps = []
            for kind in ("MODULE", "PROGRAM"):
                PREFERENCES.engine = kind
                api.set_uvs(layer, uvs)
                self.assertEqual(call(), {"FINISHED"})
                maps.append(uvs_of(item).copy())
                self.assertTrue(np.allclose(maps[-1][chosen], uvs[chosen], atol=2e-6), kind)
            self.assertTrue(np.allclose(*maps, atol=1e-6))
        PREFERENCES.engine = "AUTO"
        bpy.ops.autocuts.pack(use_pins=False)
        self.assertGreater(np.abs(uvs_of(item)[chosen] - uvs[chosen]).max(), 0.1)

    def test_vertex_groups_as_weights(self):
        item = add_grid(8)
        right = [vertex.index for vertex in item.data.vertices if vertex.co.x > 0.1]
        item.vertex_groups.new(name="Detail").add(right, 1.0, "REPLACE")
        maps = []
        for kind in ("PROGRAM", "MODULE"):
            PREFERENCES.engine = kind
            bpy.ops.autocuts.unwrap(quality="draft", texel_group="Detail", texel_factor=3, max_distortion=4.5)
            maps.append(uvs_of(item).copy())
        self.assertTrue(np.array_equal(*maps))
        bpy.ops.autocuts.unwrap(quality="draft", texel_group="Detail", texel_factor=3, max_distortion=4.5)
        area = uv_area(item)
        centers = np.array([polygon.center.x for polygon in item.data.polygons])
        ratio = area[centers > 0.3].mean() / area[centers < -0.3].mean()
        self.assertGreater(ratio, 4)
        # A cylinder has to be cut somewhere: not where that is dear.
        bpy.ops.mesh.primitive_cylinder_add(vertices=24, end_fill_type="NOTHING")
        tube = bpy.context.object
        left = [vertex.index for vertex in tube.data.vertices if vertex.co.x < 0]
        group = tube.vertex_groups.new(name="Seams")
        for members, side in ((left, -1), ([v.index for v in tube.data.vertices if v.co.x > 0], 1)):
            group.remove(list(range(48)))
            group.add(members, 1.0, "REPLACE")
            for kind in ("PROGRAM", "MODULE"):
                PREFERENCES.engine = kind
                bpy.ops.autocuts.unwrap(quality="draft", seam_group="Seams", seam_factor=100)
                cut = np.flatnonzero(seams_in_map(tube))
                self.assertEqual(len(cut), 1)
                where = tube.data.vertices[tube.data.edges[cut[0]].vertices[0]].co.x
                self.assertLess(where * side, 1e-6, kind)

    def test_scale_of_objects_counts(self):
        small, large = add_cube(), add_cube(location=(9, 0, 0))
        large.scale = (2, 2, 2)
        bpy.context.view_layer.update()
        select(small, large)
        bpy.ops.autocuts.unwrap(quality="draft")
        self.assertAlmostEqual(uv_area(large).sum() / uv_area(small).sum(), 4, places=3)
        bpy.ops.autocuts.pack(density=100.0, texture_size=(1024, 1024))
        self.assertAlmostEqual(np.sqrt(uv_area(small).sum() * 1024**2 / 24), 100, places=2)

    def test_the_size_of_the_active_image(self):
        item = add_cube()
        material = bpy.data.materials.new("Painted")
        material.use_nodes = True
        node = material.node_tree.nodes.new("ShaderNodeTexImage")
        node.image = bpy.data.images.new("Wide", 512, 128)
        material.node_tree.nodes.active = node
        item.data.materials.append(material)
        self.assertEqual(operators.image_size(bpy.context), (512, 128))
        bpy.ops.autocuts.unwrap(quality="draft")
        wide = uvs_of(item).copy()
        bpy.ops.autocuts.unwrap(quality="draft", use_image_size=False, texture_size=(512, 128))
        self.assertTrue(np.array_equal(uvs_of(item), wide))
        bpy.ops.autocuts.unwrap(quality="draft", use_image_size=False)
        self.assertFalse(np.array_equal(uvs_of(item), wide))

    def test_a_mesh_without_a_uv_map_gets_one(self):
        item = add_cube()
        item.data.uv_layers.remove(item.data.uv_layers[0])
        with self.assertRaisesRegex(RuntimeError, "no UV map yet"):
            bpy.ops.autocuts.pack()
        for edit in (False, True):
            while item.data.uv_layers:
                item.data.uv_layers.remove(item.data.uv_layers[0])
            call = bpy.ops.autocuts.unwrap
            self.assertEqual(in_edit_mode(call, quality="draft") if edit else call(quality="draft"), {"FINISHED"})
            self.assertEqual([layer.name for layer in item.data.uv_layers], ["UVMap"])
            self.assertGreater(uv_area(item).sum(), 0.1)


class Operators(BlenderTest):
    def test_stack_lays_copies_on_each_other(self):
        items = [add_suzanne() for _ in range(2)]
        items[1].location.x = 4
        bpy.context.view_layer.update()
        select(*items)
        bpy.ops.autocuts.unwrap(quality="draft")
        self.assertFalse(np.allclose(uvs_of(items[0]), uvs_of(items[1]), atol=1e-3))
        self.assertEqual(bpy.ops.autocuts.stack(), {"FINISHED"})
        self.assertTrue(np.allclose(uvs_of(items[0]), uvs_of(items[1]), atol=1e-5))

    def test_straighten_makes_a_grid_upright(self):
        item = add_grid(6)
        bpy.ops.autocuts.unwrap(quality="draft")
        turn = np.array([[0.8, 0.6], [-0.6, 0.8]])
        rng = np.random.default_rng(3)
        wavy = np.array([item.data.vertices[loop.vertex_index].co[:2] for loop in item.data.loops])
        wavy += 0.03 * rng.normal(size=(len(item.data.vertices), 2))[[loop.vertex_index for loop in item.data.loops]]
        for kind in ("MODULE", "PROGRAM"):
            PREFERENCES.engine = kind
            api.set_uvs(item.data.uv_layers.active, wavy @ turn * 0.2 + 0.5)
            self.assertEqual(bpy.ops.autocuts.straighten(), {"FINISHED"})
            uvs = uvs_of(item)
            for polygon in item.data.polygons:
                corners = uvs[polygon.loop_start : polygon.loop_start + 4]
                sides = np.abs(np.roll(corners, -1, axis=0) - corners)
                self.assertLess(sides.min(axis=1).max(), 1e-4, kind)

    def test_straighten_leaves_flipped_maps_to_the_program(self):
        item = add_grid(4)
        bpy.ops.autocuts.unwrap(quality="draft")
        uvs = uvs_of(item) * [-1, 1] + [1, 0]
        api.set_uvs(item.data.uv_layers.active, uvs)
        PREFERENCES.engine = "MODULE"
        with self.assertRaisesRegex(RuntimeError, "flipped triangles"):
            bpy.ops.autocuts.straighten()
        PREFERENCES.engine = "AUTO"
        self.assertEqual(bpy.ops.autocuts.straighten(), {"FINISHED"})
        self.assertTrue((uv_area(item) > 0).all())

    def test_separate_and_pack_take_overlaps_away(self):
        item = add_cube()
        square = np.tile([[0, 0], [1, 0], [1, 1], [0, 1]], (6, 1))
        for call in (bpy.ops.autocuts.pack, bpy.ops.autocuts.separate):
            api.set_uvs(item.data.uv_layers.active, square)
            self.assertGreater(self.measured(item)["overlapping_pairs"], 0)
            self.assertEqual(call(margin=4), {"FINISHED"})
            self.assertEqual(self.measured(item)["overlapping_pairs"], 0)

    def test_only_selected_faces_are_packed(self):
        item = add_cube()
        bpy.ops.autocuts.unwrap(quality="draft", seams="only", seams_from={"sharp"})
        before = uvs_of(item).copy()
        select_faces(item.data, np.arange(6) < 2)
        for arguments in ({"margin": 64}, {"fill_tiles": True}):
            bpy.ops.autocuts.pack(selected=True, **arguments)
            after = uvs_of(item)
            self.assertTrue(np.array_equal(before[8:], after[8:]))
            self.assertFalse(np.array_equal(before[:8], after[:8]))
        self.assertEqual(self.measured(item)["overlapping_pairs"], 0)

    def test_the_border_of_the_selected_faces(self):
        item = add_grid(6)
        bpy.ops.autocuts.unwrap(quality="draft")
        chosen = np.array([polygon.center.x > 0 for polygon in item.data.polygons])
        select_faces(item.data, chosen)
        with self.assertRaisesRegex(RuntimeError, "no island lies as a whole"):
            bpy.ops.autocuts.pack(selected=True)
        bpy.ops.autocuts.pack(selected=True, border="free")
        self.assertEqual(seams_in_map(item).sum(), 6)

    def test_bake_a_detailed_model_onto_another(self):
        low = add_cube()
        high = add_cube()
        high.modifiers.new("Round", "SUBSURF").levels = 3
        select(low)
        bpy.ops.autocuts.unwrap(quality="draft")
        select(low, high)
        with tempfile.TemporaryDirectory() as folder:
            done = bpy.ops.autocuts.bake(
                directory=folder, maps={"normal", "position"}, texture_size=(64, 64), cage=0.5, samples="1"
            )
            self.assertEqual(done, {"FINISHED"})
            names = sorted(os.listdir(folder))
            self.assertEqual([name.rsplit("_", 1)[1] for name in names], ["normal.png", "position.png"])
            image = bpy.data.images[names[0]]
            self.assertEqual((tuple(image.size), image.colorspace_settings.name), ((64, 64), "Non-Color"))
            pixels = np.array(image.pixels).reshape(-1, 4)
            baked = pixels[pixels[:, 3] > 0.5][:, :3]
            # Flat faces of the cube see a round one: its normals lean to all sides.
            self.assertGreater(np.ptp(baked[:, 0]), 0.3)
        self.assertEqual({item.name for item in bpy.context.selected_objects}, {low.name, high.name})
        self.assertEqual(bpy.context.view_layer.objects.active, low)

    def test_measure_says_figures(self):
        item = add_suzanne()
        bpy.ops.autocuts.unwrap(quality="draft")
        bpy.ops.autocuts.measure()
        found = self.measured(item)
        self.assertEqual(
            bpy.context.scene.autocuts.figures,
            f"{found['islands']} islands, distortion {found['distortion']:.3f}, seams {found['seam_norm']:.2f}",
        )

    def test_what_cannot_be_done_is_said(self):
        item = add_cube()
        select_faces(item.data, np.zeros(6, dtype=bool))
        with self.assertRaisesRegex(RuntimeError, "No faces are selected"):
            bpy.ops.autocuts.unwrap_selected()
        PREFERENCES.engine = "MODULE"
        with self.assertRaisesRegex(RuntimeError, "does not know init tutte"):
            bpy.ops.autocuts.unwrap(init="tutte")
        PREFERENCES.engine = "PROGRAM"
        with self.assertRaisesRegex(RuntimeError, "as wide as the whole texture"):
            bpy.ops.autocuts.unwrap(quality="draft", texture_size=(16, 16), margin=64)
        PREFERENCES.program = "/nowhere"
        with self.assertRaisesRegex(RuntimeError, "was not found"):
            bpy.ops.autocuts.unwrap()
        PREFERENCES.program = PROGRAM
        bpy.ops.object.select_all(action="DESELECT")
        with self.assertRaisesRegex(RuntimeError, "Select mesh objects"):
            bpy.ops.autocuts.pack()

    def test_options_are_those_of_the_command_line(self):
        told = subprocess.run([PROGRAM, "--help"], check=True, capture_output=True, text=True).stdout
        told = re.sub(r"\n {10,}", " ", told)
        shown = {}
        for line in told.splitlines():
            match = re.match(r"  (--[a-z-]+)(?:, --[a-z-]+)? (\S+)? *(.*)", line)
            if match:
                default = re.search(r"\[([^\[\]]*)\]$", line)
                shown.setdefault(match[1], (match[2], default[1] if default else ""))
        own = {"sharp_angle", *options.TAKING}
        for name in options.ALL:
            if name in own:
                continue
            flag = "--" + options.word_of(name).replace("_", "-")
            self.assertIn(flag, shown)
            words, default = shown[flag]
            prop = options.ALL[name].keywords
            value = options.default_of(name)
            if isinstance(value, bool):
                self.assertFalse(value, flag)
            elif isinstance(value, set):
                self.assertEqual(value, set(default.split(",")), flag)
            elif isinstance(value, tuple):
                self.assertEqual(value, (int(default),) * 2, flag)
            elif isinstance(value, str):
                items = [item[0] for item in prop["items"]]
                if default and name not in options.OWN_DEFAULTS:
                    self.assertEqual(value, default, flag)
                self.assertLessEqual(set(words.split("|")) if "|" in words else set(), set(items), flag)
            elif default:
                self.assertAlmostEqual(value, float(default), msg=flag)


class Jobs(BlenderTest):
    def job(self, *items, **options_given):
        """A job of Unwrap on objects, and the parts that it is for."""
        model = meshdata.model_of(bpy.context, list(items), meshdata.Taking())
        request = engine.Request("unwrap", model, options_given)
        chosen = engine.engine_for(request, operators.available_engines(bpy.context))
        return jobs.Job(chosen.run(request)), model.parts

    def test_progress_and_the_best_map_so_far(self):
        for kind in ("MODULE", "PROGRAM"):
            PREFERENCES.engine = kind
            bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=5)
            item = bpy.context.object
            job, parts = self.job(item, quality="best")
            while job.step() and job.progress.share < 0.3:
                time.sleep(0.01)
            self.assertTrue(job.running, kind)
            job.stop()
            outcome = job.wait()
            self.assertTrue(outcome.stopped, kind)
            self.assertEqual(meshdata.write_uvs(parts, outcome.uvs), [])
            found = self.measured(item)
            self.assertEqual((found["overlapping_pairs"], found["flipped_triangles"]), (0, 0))

    def test_a_closed_job_ends_at_once(self):
        for kind in ("MODULE", "PROGRAM"):
            PREFERENCES.engine = kind
            bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=5)
            handles, folders = os.listdir("/proc/self/fd"), set(os.listdir(tempfile.gettempdir()))
            job, _ = self.job(bpy.context.object, quality="best")
            while job.step() and job.progress.share < 0.1:
                time.sleep(0.01)
            self.assertTrue(job.running, kind)
            begin = time.monotonic()
            job.close()
            self.assertLess(time.monotonic() - begin, 20, kind)  # the whole job takes longer
            self.assertFalse(job.step())
            self.assertIsNone(job.wait())
            if kind == "PROGRAM":
                self.assertEqual(len(os.listdir("/proc/self/fd")), len(handles))
                left = set(os.listdir(tempfile.gettempdir())) - folders
                self.assertEqual([name for name in left if name.startswith("autocuts_")], [])

    def test_stopped_before_there_is_a_map(self):
        for kind in ("MODULE", "PROGRAM"):
            PREFERENCES.engine = kind
            bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=5)
            before = uvs_of(bpy.context.object).copy()
            job, parts = self.job(bpy.context.object)
            job.stop()
            outcome = job.wait()
            self.assertTrue(outcome.stopped, kind)
            if outcome.uvs is None:
                self.assertTrue(np.array_equal(uvs_of(bpy.context.object), before))
            else:
                self.assertEqual(meshdata.write_uvs(parts, outcome.uvs), [])

    def test_the_best_map_so_far_is_given_out(self):
        bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=5)
        item = bpy.context.object
        before = uvs_of(item).copy()
        job, parts = self.job(item, quality="best")
        while job.step() and job.progress.newest is None:
            time.sleep(0.01)
        self.assertTrue(job.running)
        # A valid map: each side once, at a seam or not.
        newest = job.progress.newest
        drawn = np.concatenate([newest.seams, newest.inner])
        self.assertEqual(len(drawn), len(item.data.loops))
        self.assertTrue(np.isfinite(drawn).all() and drawn.min() >= 0 and drawn.max() <= 1)
        self.assertGreater(len(newest.inner), len(newest.seams))
        self.assertTrue(np.array_equal(uvs_of(item), before))
        job.stop()
        outcome = job.wait()
        self.assertTrue(outcome.stopped)
        self.assertEqual(meshdata.write_uvs(parts, outcome.uvs), [])
        found = self.measured(item)
        self.assertEqual((found["overlapping_pairs"], found["flipped_triangles"]), (0, 0))

    def test_a_mesh_that_changed_is_not_written(self):
        changed, removed, kept, edited = (add_cube(location=(3 * i, 0, 0)) for i in range(4))
        before = uvs_of(changed).copy()
        job, parts = self.job(changed, removed, kept, edited, quality="draft")
        work = bmesh.new()
        work.from_mesh(changed.data)
        bmesh.ops.reverse_faces(work, faces=work.faces[:1])
        work.to_mesh(changed.data)
        work.free()
        name = removed.name
        bpy.data.objects.remove(removed)
        select(edited)
        bpy.ops.object.mode_set(mode="EDIT")
        bpy.ops.mesh.select_all(action="SELECT")
        bpy.ops.mesh.subdivide()
        outcome = job.wait()
        problems = meshdata.write_uvs(parts, outcome.uvs)
        bpy.ops.object.mode_set(mode="OBJECT")
        self.assertEqual(
            problems,
            [
                f"{changed.name} has changed meanwhile and keeps its UVs",
                f"{name} is gone",
                f"{edited.name} has changed meanwhile and keeps its UVs",
            ],
        )
        self.assertTrue(np.array_equal(np.sort(uvs_of(changed), axis=0), np.sort(before, axis=0)))
        self.assertTrue(np.array_equal(uvs_of(kept), outcome.uvs[48:72].astype(np.float32)))

    def test_a_crash_of_the_program_is_said(self):
        item = add_cube()
        model = meshdata.model_of(bpy.context, [item], meshdata.Taking())
        with self.assertRaisesRegex(engine.EngineError, "ended with 1"):
            jobs.Job(engine.CommandEngine("false").run(engine.Request("pack", model))).wait()

    def test_stopped_before_the_program_listens(self):
        model = meshdata.model_of(bpy.context, [add_cube()], meshdata.Taking())
        with tempfile.TemporaryDirectory() as folder:
            program = os.path.join(folder, "interrupted")
            with open(program, "w", encoding="utf-8") as file:
                file.write("#!/bin/sh\nkill -INT $$\n")
            os.chmod(program, 0o700)
            outcome = jobs.Job(engine.CommandEngine(program).run(engine.Request("pack", model))).wait()
        self.assertTrue(outcome.stopped)
        self.assertIsNone(outcome.uvs)

    def test_time_of_handing_over(self):
        item = add_grid(224)
        self.assertEqual(len(item.data.polygons), 50176)
        for mode in ("OBJECT", "EDIT"):
            bpy.ops.object.mode_set(mode=mode)
            start = time.process_time()
            model = meshdata.model_of(bpy.context, [item], meshdata.Taking())
            taken = time.process_time()
            with tempfile.TemporaryDirectory() as folder:
                path = os.path.join(folder, "a.acproj")
                engine.session.write(path, model, [], model.face_materials)
                written = time.process_time()
                uvs = engine.session.read_uvs(path, model.corners)
            got = time.process_time()
            self.assertTrue(np.array_equal(uvs, model.uvs))
            moved = uvs + 0.25
            self.assertEqual(meshdata.write_uvs(model.parts, moved), [])
            end = time.process_time()
            bpy.ops.object.mode_set(mode="OBJECT")
            self.assertTrue(np.array_equal(uvs_of(item), moved.astype(np.float32)))
            print(
                f"100,352 triangles, {mode.lower()} mode, CPU s: from Blender {taken - start:.3f}, "
                f"to a session {written - taken:.3f}, from it {got - written:.3f}, to Blender {end - got:.3f}"
            )


class Figures(BlenderTest):
    def test_lines_run_around_each_face(self):
        uvs = np.arange(14.0).reshape(7, 2)
        lines = figures.map_lines(np.array([3, 4]), uvs)
        self.assertEqual(lines[:, 0].tolist(), uvs.tolist())
        self.assertEqual(lines[:, 1].tolist(), uvs[[1, 2, 0, 4, 5, 6, 3]].tolist())

    def test_stretch_is_that_of_the_engine(self):
        item = add_suzanne()
        item.modifiers.clear()
        item.shape_key_clear()
        # Triangles, so that both split faces alike.
        bpy.ops.object.mode_set(mode="EDIT")
        bpy.ops.mesh.select_all(action="SELECT")
        bpy.ops.mesh.quads_convert_to_tris()
        bpy.ops.object.mode_set(mode="OBJECT")
        bpy.ops.autocuts.unwrap(quality="draft")
        model = meshdata.model_of(bpy.context, [item], meshdata.Taking())
        triangles, _ = figures.fan_triangles(model.face_sizes)
        points = model.positions[model.corners[triangles]]
        area = 0.5 * np.linalg.norm(np.cross(points[:, 1] - points[:, 0], points[:, 2] - points[:, 0]), axis=1)
        energy = figures.stretch(points, model.uvs[triangles])
        mean = (energy * area).sum() / area.sum()
        self.assertAlmostEqual(mean, self.measured(item)["distortion"], places=2)
        density = figures.density(points, model.uvs[triangles], (1000, 1000))
        self.assertAlmostEqual((density**2 * area).sum() / 1e6, uv_area(item).sum(), places=6)

    def test_overlapping_triangles_are_found(self):
        rng = np.random.default_rng(1)
        uvs = rng.random((100, 1, 2)) + 0.04 * rng.normal(size=(100, 3, 2))
        expected = np.zeros(100, dtype=bool)
        for i in range(100):
            for j in range(i):
                a, b = uvs[[i]], uvs[[j]]
                both = np.concatenate([a, b])
                if figures.overlapping(both).all():
                    expected[[i, j]] = True
        self.assertTrue(10 < expected.sum() < 90)  # some overlap, some do not
        self.assertEqual(figures.overlapping(uvs).tolist(), expected.tolist())
        side = np.array([[[0, 0], [1, 0], [0, 1]], [[1, 0], [1, 1], [0, 1]]], dtype=float)
        self.assertEqual(figures.overlapping(side).tolist(), [False, False])
        self.assertEqual(figures.overlapping(side * [1, -1]).tolist(), [False, False])
        side[1, :, 0] -= 0.1
        self.assertEqual(figures.overlapping(side).tolist(), [True, True])
        self.assertEqual(figures.overlapping(np.stack([side[0], side[0] * 0.2 + 0.1])).tolist(), [True, True])


blenderaddon.run_unittest(__name__)
