"""The Python module: maps of the command line, arrays of all kinds, errors, threads, and the calls of xatlas."""

import importlib.util
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import zipfile

import numpy as np

import autocuts
from autocuts import xatlas

CUBE = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [0, 0, 1], [1, 0, 1], [0, 1, 1], [1, 1, 1]], dtype=float)
QUADS = np.array([[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]])
TRIANGLES = np.concatenate([QUADS[:, [0, 1, 2]], QUADS[:, [0, 2, 3]]])


def torus(count):
    """Positions and quads of a torus with waves."""
    around, across = (axis.ravel() for axis in np.meshgrid(*[np.arange(count)] * 2, indexing="ij"))
    step = 2 * np.pi / count
    radius = 2 + (0.7 + 0.1 * np.sin(step * (5 * around + 3 * across))) * np.cos(step * across)
    points = np.column_stack([radius * np.cos(step * around), radius * np.sin(step * around), np.sin(step * across)])
    below, right = (around + 1) % count, (across + 1) % count
    quads = [around * count + across, below * count + across, below * count + right, around * count + right]
    return points, np.column_stack(quads)


def read_obj(path):
    """Positions, flat corners, sizes and UVs per corner."""
    points, vt, corners, sizes, uvs = [], [], [], [], []
    with open(path, encoding="utf-8") as file:
        for line in file:
            words = line.split()
            if not words:
                continue
            if words[0] == "v":
                points.append([float(word) for word in words[1:4]])
            elif words[0] == "vt":
                vt.append([float(word) for word in words[1:3]])
            elif words[0] == "f":
                sizes.append(len(words) - 1)
                for word in words[1:]:
                    parts = word.split("/")
                    corners.append(int(parts[0]) - 1)
                    if len(parts) > 1 and parts[1]:
                        uvs.append(vt[int(parts[1]) - 1])
    return np.array(points), np.array(corners), np.array(sizes), np.array(uvs)


class Unwrapping(unittest.TestCase):
    def test_the_map_of_the_command_line(self):
        cli = os.environ["AUTOCUTS_CLI"]
        with tempfile.TemporaryDirectory() as folder:
            model, mapped = os.path.join(folder, "m.obj"), os.path.join(folder, "u.obj")
            subprocess.run([cli, "sample", "bumpycube", "-o", model], check=True, capture_output=True)
            subprocess.run([cli, "unwrap", model, "-o", mapped, "--quality", "draft"], check=True, capture_output=True)
            points, corners, sizes, _ = read_obj(model)
            expected = read_obj(mapped)[3]
        made = autocuts.unwrap(points, corners, face_sizes=sizes, quality="draft", threads=2)
        self.assertTrue(np.array_equal(made.uvs, expected))

    def test_arrays_of_all_kinds(self):
        expected = autocuts.unwrap(CUBE, QUADS, quality="draft").uvs
        for points in (CUBE.astype(np.float32), np.asfortranarray(CUBE), np.repeat(CUBE, 2, axis=0)[::2], CUBE.tolist()):
            for faces in (QUADS.astype(np.int32), QUADS.astype(np.uint32), np.asfortranarray(QUADS), QUADS.tolist()):
                made = autocuts.unwrap(points, faces, quality="draft")
                self.assertTrue(np.array_equal(made.uvs, expected))

    def test_what_a_map_has(self):
        made = autocuts.unwrap(CUBE, QUADS)
        self.assertEqual((made.uvs.shape, made.islands.tolist(), made.seams.sum()), ((24, 2), [0] * 6, 14))
        figures = made.measure()
        self.assertEqual((figures["islands"], figures["flipped_triangles"], figures["overlapping_pairs"]), (1, 0, 0))
        self.assertAlmostEqual(figures["distortion"], 4)
        with self.assertRaises(ValueError):
            made.uvs[0] = 0
        uvs = made.uvs
        del made
        self.assertTrue(np.isfinite(uvs).all())  # they keep the map

    def test_packs_separates_and_keeps_locks(self):
        square = np.tile([[0, 0], [1, 0], [1, 1], [0, 1]], (6, 1)).astype(float)
        self.assertGreater(autocuts.take(CUBE, QUADS, square).measure()["overlapping_pairs"], 0)
        packed = autocuts.pack(CUBE, QUADS, square, margin=4, texture_size=(512, 256))
        self.assertEqual(packed.measure()["overlapping_pairs"], 0)
        again = autocuts.pack(CUBE, QUADS, packed.uvs, locked=[1, 0, 0, 0, 0, 0], margin=9, texture_size=(512, 256))
        self.assertTrue(np.array_equal(again.uvs[:4], packed.uvs[:4]))
        self.assertEqual(autocuts.separate(CUBE, QUADS, packed.uvs).measure()["overlapping_pairs"], 0)

    def test_edges_are_obeyed(self):
        made = autocuts.unwrap(CUBE, QUADS, edges=np.ones(24, dtype=int), quality="draft")
        self.assertEqual((made.island_count, made.seams.sum()), (6, 24))

    def test_bad_input_is_a_value_error(self):
        nan = CUBE.copy()
        nan[3, 1] = np.nan
        for words, call in (
            ("Nx3", lambda: autocuts.unwrap(CUBE[:, :2], QUADS)),
            ("Fx3", lambda: autocuts.unwrap(CUBE, QUADS.ravel())),
            ("vertex 3", lambda: autocuts.unwrap(nan, QUADS)),
            ("out of range", lambda: autocuts.unwrap(CUBE, QUADS + 5)),
            ("out of range", lambda: autocuts.unwrap(CUBE, QUADS - 1)),
            ("2 numbers per corner", lambda: autocuts.pack(CUBE, QUADS, CUBE[:, :2])),
            ("draft, standard, best", lambda: autocuts.unwrap(CUBE, QUADS, quality="fast")),
            ("above 4", lambda: autocuts.unwrap(CUBE, QUADS, max_distortion=3)),
            ("one object per face", lambda: autocuts.unwrap(CUBE, QUADS, objects=[0])),
            ("one lock per face", lambda: autocuts.unwrap(CUBE, QUADS, locked=[0])),
            ("one material per face", lambda: autocuts.unwrap(CUBE, QUADS, materials=[0])),
            ("3 numbers per corner", lambda: autocuts.unwrap(CUBE, QUADS, normals=CUBE)),
            ("edge weight of corner 2", lambda: autocuts.unwrap(CUBE, QUADS, edge_weights=[1, 1, -1] + [1] * 21)),
            ("texel weight", lambda: autocuts.unwrap(CUBE, QUADS, texel_weights=[9] * 6)),
            ("pin 0 is at a corner", lambda: autocuts.unwrap(CUBE, QUADS, pins=[[24, 0, 0]])),
            ("none, free, 15", lambda: autocuts.unwrap(CUBE, QUADS, rotation=20)),
            ("seams_from is made of", lambda: autocuts.unwrap(CUBE, QUADS, seams="keep", seams_from=["borders"])),
        ):
            with self.assertRaisesRegex(ValueError, words):
                call()
        with self.assertRaisesRegex(RuntimeError, "no room"):
            autocuts.unwrap(CUBE, QUADS, quality="draft", margin=5000)
        with self.assertRaisesRegex(TypeError, "no option"):
            autocuts.unwrap(CUBE, QUADS, speed=1)

    def test_progress_stops_and_its_errors_come_through(self):
        seen = []
        stopped = autocuts.unwrap(CUBE, QUADS, progress=lambda share: seen.append(share) or False)
        self.assertTrue(stopped.stopped and len(seen) >= 1 and 0 <= min(seen) and max(seen) <= 1)
        with self.assertRaises(ZeroDivisionError):
            autocuts.unwrap(CUBE, QUADS, progress=lambda share: 1 / 0)

    def test_better_maps_come_meanwhile(self):
        positions, faces = torus(40)
        maps = []
        made = autocuts.unwrap(positions, faces, better=maps.append)
        self.assertTrue(maps)
        for map in maps:
            figures = map.measure()
            self.assertEqual((figures["flipped_triangles"], figures["overlapping_pairs"]), (0, 0))
        self.assertIn("<svg", maps[0]._repr_svg_())
        self.assertTrue(np.array_equal(made.uvs, autocuts.unwrap(positions, faces).uvs))
        with self.assertRaises(ZeroDivisionError):
            autocuts.unwrap(positions, faces, better=lambda map: 1 / 0)

    def test_a_job_in_the_background(self):
        positions, faces = torus(40)
        job = autocuts.Job("unwrap", positions, faces)
        while not job.wait(0.01):
            self.assertTrue(0 <= job.share <= 1)
        expected = autocuts.unwrap(positions, faces)
        self.assertTrue(np.array_equal(job.result().uvs, expected.uvs))
        np.testing.assert_equal(job.figures(), expected.measure())  # a NaN is equal to a NaN
        self.assertIn("<svg", job.newest._repr_svg_())
        packed = autocuts.Job("pack", positions, faces, uvs=expected.uvs, margin=16)
        self.assertTrue(np.array_equal(packed.result().uvs, autocuts.pack(positions, faces, expected.uvs, margin=16).uvs))
        stopped = autocuts.Job("unwrap", positions, faces, quality="best")
        stopped.stop()
        self.assertTrue(stopped.result().stopped)
        del stopped
        begin = time.monotonic()
        autocuts.Job("unwrap", *torus(100), quality="best")  # nobody has it
        self.assertLess(time.monotonic() - begin, 10)  # the whole job takes longer
        for name, words in (("tear", "the name of a job"), ("pack", "no UVs")):
            with self.assertRaisesRegex(ValueError, words):
                autocuts.Job(name, positions, faces).result()

    def test_threads_of_python(self):
        expected, made = autocuts.unwrap(CUBE, QUADS).uvs, []
        threads = [threading.Thread(target=lambda: made.append(autocuts.unwrap(CUBE, QUADS).uvs)) for _ in range(8)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual([np.array_equal(uvs, expected) for uvs in made], [True] * 8)

    def test_ctrl_c_gives_the_best_map(self):
        program = (
            "import numpy as np, autocuts, os, signal\n"
            "a = np.linspace(0, 6, 120); x, y = np.meshgrid(a, a)\n"
            "points = np.column_stack([x.ravel(), y.ravel(), (np.sin(x) * np.cos(2 * y) * 2).ravel()])\n"
            "i = np.arange(119 * 120).reshape(119, 120)[:, :-1].ravel()\n"
            "faces = np.column_stack([i, i + 1, i + 121, i + 120])\n"
            "done = autocuts.unwrap(points, faces, quality='best',\n"
            "    progress=lambda share: os.kill(os.getpid(), signal.SIGINT))\n"
            "print(done.stopped, np.isfinite(done.uvs).all())\n"
        )
        ran = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=120, check=False)
        self.assertEqual(ran.stdout.split(), ["True", "True"], ran.stderr)


def grid(side=12):
    """A wavy sheet of quads, as a Mesh."""
    x, y = np.meshgrid(np.linspace(0, 3, side), np.linspace(0, 3, side))
    i = np.arange((side - 1) * side).reshape(side - 1, side)[:, :-1].ravel()
    points = np.column_stack([x.ravel(), y.ravel(), (np.sin(2 * x) * np.cos(2 * y) / 2).ravel()])
    return autocuts.Mesh(points, np.column_stack([i, i + 1, i + side + 1, i + side]))


class Steering(unittest.TestCase):
    def test_given_seams(self):
        made = autocuts.unwrap(CUBE, QUADS, seams="only", seams_from="sharp", quality="draft")
        self.assertEqual(made.island_count, 6)
        made = autocuts.unwrap(CUBE, QUADS, seams="only", seams_from=["materials"], materials=[0, 0, 1, 1, 1, 1], quality="draft")
        self.assertGreaterEqual(made.island_count, 3)
        up = np.tile([0.0, 0, 1], (24, 1))
        up[:4] = [0, 0, -1]  # the edges of the first face are hard
        made = autocuts.unwrap(CUBE, QUADS, seams="keep", seams_from="hard", normals=up, quality="draft")
        self.assertEqual(made.seams[:4].tolist(), [1, 1, 1, 1])

    def test_weights(self):
        mesh = autocuts.Mesh(CUBE, QUADS)
        free = autocuts.unwrap(mesh, quality="draft")
        dear = autocuts.unwrap(mesh, edge_weights=np.where(free.seams, 10, 0.01), quality="draft")
        self.assertFalse(np.array_equal(free.seams, dear.seams))
        apart = {"edges": np.ones(24, dtype=np.uint8), "quality": "draft"}
        uvs = autocuts.unwrap(mesh, texel_weights=[2, 1, 1, 1, 1, 1], **apart).uvs.reshape(6, 4, 2)
        sides = np.linalg.norm(uvs[:, 0] - uvs[:, 1], axis=1)
        self.assertTrue(np.allclose(sides[0] / sides[1:], 2, rtol=1e-3))

    def test_pins(self):
        mesh = grid()
        free = autocuts.unwrap(mesh, quality="draft")
        pins = [[0, *free.uvs[0]], [20, *(free.uvs[20] + [0.05, 0])]]
        made = autocuts.unwrap(mesh, uvs=free.uvs, pins=pins, quality="draft")
        self.assertTrue(np.allclose(made.uvs[[0, 20]], np.array(pins)[:, 1:], atol=1e-9))
        self.assertEqual(made.outcome["unmet_pins"], 0)
        torn = autocuts.unwrap(mesh, uvs=free.uvs, pins=[[0, 0.1, 0.1], [1, 0.9, 0.9], [2, 0.1, 0.9]], quality="draft")
        self.assertEqual(torn.measure()["overlapping_pairs"], 0)

    def test_other_jobs(self):
        mesh = grid()
        mesh.uvs = autocuts.unwrap(mesh, quality="draft").uvs
        for job in (autocuts.finish, autocuts.align, autocuts.lightmap):
            made = job(mesh)
            figures = made.measure()
            self.assertEqual((figures["flipped_triangles"], figures["overlapping_pairs"]), (0, 0), job.__name__)
        two = autocuts.Mesh(np.vstack([CUBE, CUBE + [3, 0, 0]]), np.vstack([QUADS, QUADS + 8]), objects=np.repeat([0, 1], 6))
        apart = autocuts.unwrap(two, quality="draft")
        self.assertEqual(apart.measure()["overlapping_pairs"], 0)
        stacked = autocuts.pack(two, uvs=apart.uvs, alike="stack").uvs.reshape(2, -1, 2)
        self.assertTrue(np.allclose(np.sort(stacked[0], axis=0), np.sort(stacked[1], axis=0), atol=1e-6))

    def test_transfer(self):
        coarse, fine = grid(12), grid(23)
        coarse.uvs = autocuts.unwrap(coarse, quality="draft").uvs
        same, matched = autocuts.transfer(coarse, autocuts.Mesh(coarse.positions, coarse.faces))
        self.assertTrue(np.array_equal(same.uvs, coarse.uvs) and matched["copied"] == len(coarse.faces))
        near, matched = autocuts.transfer(coarse, fine)
        self.assertEqual((matched["copied"], matched["placed"], np.isnan(near.uvs).any()), (0, len(fine.faces), False))
        with self.assertRaisesRegex(ValueError, "not the same"):
            autocuts.transfer(coarse, fine, match="topology")

    def test_live(self):
        mesh = grid()
        live = autocuts.LiveSolve(mesh, threads=2)
        first = None
        while first is None and not live.rests:
            first = live.wait(10)
        self.assertEqual(first.measure()["flipped_triangles"], 0)
        target = [0.25, 0.75]
        live.steer(pins=[[0, *target]])
        pinned = live.wait(30)
        self.assertTrue(np.allclose(pinned.uvs[0], target, atol=1e-9))
        live.steer(pins=None, edges=np.ones(mesh.corner_count, dtype=np.uint8))
        cut = live.wait(30)
        self.assertEqual(cut.island_count, len(mesh.faces))
        while live.wait(30) is not None:
            pass
        self.assertTrue(live.rests)
        with self.assertRaisesRegex(ValueError, "other faces"):
            live.steer(positions=CUBE, faces=QUADS, edges=None)


class Pictures(unittest.TestCase):
    def test_render_layout(self):
        made = autocuts.unwrap(CUBE, QUADS, edges=np.ones(24, dtype=np.uint8), quality="draft")
        image = autocuts.render_layout(made, (64, 64))
        self.assertEqual((image.shape, image.dtype), ((64, 64, 4), np.uint8))
        shown = image[..., 3] > 0
        self.assertAlmostEqual(shown.mean(), made.measure()["packing_efficiency"], delta=0.1)
        inner = autocuts.render_layout(made, 512)
        colors = {tuple(color) for color in inner[inner[..., 3] > 0][:, :3].tolist()}
        self.assertEqual(len(colors), 12)  # each island, and its border
        square = np.tile([[0, 0], [1, 0], [1, 1], [0, 1]], (6, 1)).astype(float)
        over = autocuts.render_layout(autocuts.take(CUBE, QUADS, square), 8)
        self.assertEqual(over[4, 4].tolist(), [220, 40, 40, 255])
        self.assertEqual(int(autocuts.render_layout(made, 8, tile=1002).sum()), 0)

    def test_notebooks(self):
        made = autocuts.unwrap(CUBE, QUADS, quality="draft")
        text = made._repr_svg_()
        self.assertEqual(text.count("Z"), 6)
        self.assertIn("<svg", autocuts.Mesh(CUBE, QUADS, uvs=made.uvs)._repr_svg_())
        self.assertIsNone(autocuts.Mesh(CUBE, QUADS)._repr_svg_())

    def test_bake(self):
        mesh = autocuts.Mesh(CUBE, QUADS)
        mesh.uvs = autocuts.unwrap(mesh, quality="draft").uvs
        mesh.colors = np.tile([1.0, 0, 0], (24, 1))
        high = autocuts.Mesh(CUBE * 1.02 - 0.01, QUADS, colors=np.tile([0.0, 0, 1], (24, 1)))
        made = autocuts.bake(mesh, ["object-normal", "ao", "color"], texture_size=64, rays=16)
        self.assertEqual([made[name].shape for name in ("object-normal", "ao", "color")], [(64, 64, 3), (64, 64, 1), (64, 64, 3)])
        self.assertGreater(made["texels"], 1000)
        self.assertTrue((made["color"][..., 0] > 0.9).any() and (made["color"][..., 2] < 0.1).all())
        self.assertTrue((made["ao"] > 0.99).all())  # nothing is hidden on a box
        made = autocuts.bake(mesh, "color", high=high, cage="auto", texture_size=64)
        self.assertTrue(made["missed"] == 0 and (made["color"][..., 2] > 0.9).any())
        for words, call in (("maps are made of", lambda: autocuts.bake(mesh, "light")),
                            ("no UVs", lambda: autocuts.bake(high)),
                            ("shape of positions", lambda: autocuts.bake(mesh, high=high, cage_positions=CUBE[:3])),
                            ("UDIM tile", lambda: autocuts.bake(mesh, tile=7))):
            with self.assertRaisesRegex(ValueError, words):
                call()


class Files(unittest.TestCase):
    def test_load_and_save(self):
        with tempfile.TemporaryDirectory() as folder:
            model = os.path.join(folder, "m.obj")
            with open(model, "w", encoding="utf-8") as file:
                file.write("o first\n" + "".join(f"v {x} {y} {z}\n" for x, y, z in CUBE))
                file.write("".join(f"f {' '.join(str(v + 1) for v in face)}\n" for face in QUADS[:3]))
                file.write("o second\n" + "".join(f"f {' '.join(str(v + 1) for v in face)}\n" for face in QUADS[3:]))
            mesh = autocuts.Mesh.load(model)
            self.assertEqual((mesh.object_names, mesh.objects.tolist()), (["first", "second"], [0] * 3 + [1] * 3))
            self.assertEqual(mesh.sizes().tolist(), [4] * 6)
            made = autocuts.unwrap(mesh, quality="draft")
            for name in ("u.obj", "u.glb", "u.fbx", "u.acproj"):
                path = os.path.join(folder, name)
                mesh.save(path, made)
                back = autocuts.Mesh.load(path)
                figures = autocuts.take(back).measure()
                self.assertAlmostEqual(figures["seam_norm"], made.measure()["seam_norm"], 4, name)
                self.assertEqual((figures["overlapping_pairs"], len(back.object_names)), (0, 2), name)
            fresh = autocuts.Mesh(CUBE, QUADS, uvs=autocuts.unwrap(CUBE, QUADS, quality="draft").uvs)
            fresh.save(os.path.join(folder, "fresh.obj"))
            self.assertTrue(np.array_equal(autocuts.Mesh.load(os.path.join(folder, "fresh.obj")).uvs, fresh.uvs))
            with self.assertRaisesRegex(ValueError, "nothing.obj"):
                autocuts.Mesh.load(os.path.join(folder, "nothing.obj"))

    @unittest.skipUnless(importlib.util.find_spec("trimesh"), "trimesh is missing")
    def test_trimesh(self):
        import trimesh

        made = autocuts.unwrap_trimesh(trimesh.creation.box(), quality="draft")
        self.assertEqual((len(made.faces), made.visual.uv.shape[1]), (12, 2))


class Examples(unittest.TestCase):
    """The examples of the documentation, run as users run them, with an installed package."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        source = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
        cls.examples = os.path.join(source, "examples")
        sys.path.insert(0, os.path.join(source, "python", "build_backend"))
        import autocuts_build

        wheel = autocuts_build.build_wheel(cls.folder.name, {"build-dir": os.environ["AUTOCUTS_BUILD"]})
        cls.site = os.path.join(cls.folder.name, "site")
        with zipfile.ZipFile(os.path.join(cls.folder.name, wheel)) as packed:
            packed.extractall(cls.site)
        cls.models = os.path.join(cls.folder.name, "models")
        os.mkdir(cls.models)
        autocuts.Mesh(CUBE, QUADS).save(os.path.join(cls.models, "cube.obj"))

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def run_example(self, name, *arguments):
        ran = subprocess.run(
            [sys.executable, os.path.join(self.examples, name), *arguments],
            capture_output=True, text=True, check=False, env={**os.environ, "PYTHONPATH": self.site},
        )
        self.assertEqual(ran.returncode, 0, ran.stderr)
        return ran.stdout

    def test_unwrap_folder(self):
        target = os.path.join(self.folder.name, "mapped")
        self.assertIn("cube.obj: islands 1, distortion 4.000", self.run_example("unwrap_folder.py", self.models, target, "draft"))
        self.assertIsNotNone(autocuts.Mesh.load(os.path.join(target, "cube.obj")).uvs)

    def test_repack_margins(self):
        self.assertEqual(self.run_example("repack_margins.py", os.path.join(self.models, "cube.obj")).count("% used"), 4)

    def test_live_pin(self):
        frames = os.path.join(self.folder.name, "frames")
        self.assertIn("3 pictures", self.run_example("live_pin.py", os.path.join(self.models, "cube.obj"), frames, "3"))
        self.assertEqual(len(os.listdir(frames)), 3)

    def test_snippets_of_the_documentation(self):
        path = os.path.join(os.path.dirname(self.examples), "docs", "library.md")
        with open(path, encoding="utf-8") as page:
            snippets = page.read().split("```python\n")[1:]
        before = os.getcwd()
        os.chdir(self.folder.name)
        try:
            autocuts.Mesh(CUBE, QUADS).save("model.fbx")
            for snippet in snippets:
                names = {"positions": CUBE, "faces": QUADS}
                exec(snippet.split("```")[0], names)  # pylint: disable=exec-used
                self.assertEqual(names["made"].island_count, 1)
            self.assertIsNotNone(autocuts.Mesh.load("mapped.fbx").uvs)
        finally:
            os.chdir(before)

    @unittest.skipUnless(importlib.util.find_spec("trimesh"), "trimesh is missing")
    def test_with_trimesh(self):
        mapped = os.path.join(self.folder.name, "mapped.obj")
        self.assertIn("triangles 12", self.run_example("with_trimesh.py", os.path.join(self.models, "cube.obj"), mapped))


class Xatlas(unittest.TestCase):
    def test_parametrize(self):
        vmapping, indices, uvs = xatlas.parametrize(CUBE, TRIANGLES)
        self.assertEqual((vmapping.dtype, indices.dtype, uvs.dtype), (np.uint32, np.uint32, np.float32))
        self.assertEqual(indices.shape, TRIANGLES.shape)
        self.assertTrue(np.array_equal(vmapping[indices], TRIANGLES))
        self.assertEqual(len(uvs), len(vmapping))
        self.assertTrue(len(vmapping) < 24 and uvs.min() >= 0 and uvs.max() <= 1)

    def test_several_meshes_in_one_atlas(self):
        atlas = xatlas.Atlas()
        atlas.add_mesh(CUBE, TRIANGLES)
        atlas.add_mesh(2 * CUBE, TRIANGLES)
        atlas.generate(pack_options=xatlas.PackOptions(padding=4, resolution=512))
        self.assertEqual((len(atlas), atlas.mesh_count, atlas.atlas_count, atlas.chart_count), (2, 2, 1, 2))
        self.assertEqual((atlas.width, atlas.height), (512, 512))
        self.assertTrue(0 < atlas.utilization <= 1 and atlas.get_utilization(0) == atlas.utilization)
        boxes = [(atlas[i][2].min(axis=0), atlas[i][2].max(axis=0)) for i in range(2)]
        areas = [np.prod(high - low) for low, high in boxes]
        self.assertAlmostEqual(areas[1] / areas[0], 4, delta=2)  # one texel density
        with self.assertRaisesRegex(IndexError, "out of bounds"):
            atlas.get_mesh(2)

    def test_several_atlases(self):
        atlas = xatlas.Atlas()
        for _ in range(4):
            atlas.add_mesh(CUBE, TRIANGLES)
        atlas.generate(pack_options=xatlas.PackOptions(padding=2, resolution=512, texels_per_unit=110))
        self.assertGreater(atlas.atlas_count, 1)
        used = set()
        for i in range(4):
            _, indices, uvs = atlas[i]
            self.assertTrue(uvs.min() >= 0 and uvs.max() <= 1)
            sides = np.linalg.norm(uvs[indices[:, 0]] - uvs[indices[:, 1]], axis=1)
            self.assertAlmostEqual(sides.min() * 512, 110, delta=0.5)
            used.update(atlas.get_mesh_atlases(i).tolist())
        self.assertEqual(used, set(range(atlas.atlas_count)))

    def test_what_cannot_be_mapped_gets_zero(self):
        points = np.vstack([CUBE, [[np.nan, 0, 0]]])
        triangles = np.vstack([TRIANGLES, [[0, 0, 1], [0, 1, 8]]])
        vmapping, indices, uvs = xatlas.parametrize(points, triangles)
        self.assertTrue(np.array_equal(vmapping[indices], triangles))
        self.assertTrue((uvs[indices[-2:]] == 0).all())
        self.assertTrue(np.ptp(uvs[indices[:-2]].reshape(-1, 2), axis=0).min() > 0.1)

    def test_maps_that_are_there_are_kept(self):
        uvs = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], dtype=float)
        atlas = xatlas.Atlas()
        atlas.add_uv_mesh(uvs, [[0, 1, 2], [0, 2, 3]])
        atlas.generate()
        vmapping, _, made = atlas[0]
        sides = np.linalg.norm(made[np.argsort(vmapping)] - np.roll(made[np.argsort(vmapping)], 1, axis=0), axis=1)
        self.assertTrue(np.ptp(sides) < 1e-5)

    def test_limits_blocks_and_images(self):
        atlas = xatlas.Atlas()
        atlas.add_mesh(CUBE, TRIANGLES)
        atlas.add_mesh(CUBE * [1, 1, 9], TRIANGLES)
        options = xatlas.PackOptions(padding=2, resolution=256, blockAlign=True, max_chart_size=100, create_image=True)
        atlas.generate(pack_options=options)
        for i in range(2):
            _, indices, uvs = atlas[i]
            self.assertLessEqual(np.ptp(uvs, axis=0).max() * 256, 100.01)
            low = uvs.min(axis=0) * 256
            self.assertTrue(np.allclose(low / 4, np.round(low / 4), atol=1e-3))
        self.assertEqual((atlas.chart_image.shape, atlas.chart_image.dtype), ((256, 256, 3), np.uint8))
        self.assertGreater(atlas.texels_per_unit, 1)
        with self.assertRaisesRegex(IndexError, "out of bounds"):
            atlas.get_chart_image(1)

    def test_errors(self):
        for words, kind, call in (
            ("Nx3", ValueError, lambda: xatlas.parametrize(CUBE[:, :2], TRIANGLES)),
            ("Nx3", ValueError, lambda: xatlas.parametrize(CUBE, QUADS)),
            ("first dimension", ValueError, lambda: xatlas.parametrize(CUBE, TRIANGLES, uvs=CUBE[:3, :2])),
            ("out of range", RuntimeError, lambda: xatlas.parametrize(CUBE, TRIANGLES + 1)),
            ("opened", ValueError, lambda: xatlas.export("/nowhere/at/all.obj", CUBE)),
        ):
            with self.assertRaisesRegex(kind, words):
                call()

    def test_export(self):
        vmapping, indices, uvs = xatlas.parametrize(CUBE, TRIANGLES)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "cube.obj")
            xatlas.export(path, CUBE[vmapping], indices, uvs)
            points, corners, sizes, read = read_obj(path)
        self.assertTrue(np.array_equal(points, CUBE[vmapping]) and np.array_equal(corners, indices.ravel()))
        self.assertTrue(np.allclose(read, uvs[indices.ravel()]) and (sizes == 3).all())


if __name__ == "__main__":
    signal.signal(signal.SIGINT, signal.default_int_handler)
    unittest.main(verbosity=2)
