"""The live link between processes: a studio that another program starts, kills and is killed by, with noise and two programs
at once. The environment names the studio (AUTOCUTS_STUDIO)."""

import contextlib
import json
import os
import random
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "support"))
from linkmodules import autocuts_maya, link, mayastandin

STUDIO = os.environ["AUTOCUTS_STUDIO"]
LONG = 120  # seconds; much longer than anything takes


def grid(side, bend=0.0):
    """Positions, sizes and corners of side x side squares."""
    positions = [(x, y, bend * x * y / side) for y in range(side + 1) for x in range(side + 1)]
    corners = []
    for y in range(side):
        for x in range(side):
            first = y * (side + 1) + x
            corners += [first, first + 1, first + side + 2, first + side + 1]
    return positions, [4] * (side * side), corners


def rows(array):
    """An array of a message as tuples, with NumPy and without."""
    return [tuple(int(x) for x in row) for row in array]


class Frames(unittest.TestCase):
    def test_with_and_without_numpy(self):
        """Both give the same bytes and the same values."""
        arrays = {"a": ([(1.5, 2.5), (-1.0, 1e300)], "f8", 2), "b": ([7, -8], "i4", 1), "c": ([], "i4", 2)}
        before = link.numpy
        made = []
        for numpy in {before, None}:
            link.numpy = numpy
            try:
                frame = link.encode("maps", {"name": "Größe"}, arrays)
                size = int.from_bytes(frame[:4], "little")
                message = link.decode(frame[8 : 8 + size], frame[8 + size :])
            finally:
                link.numpy = before
            made.append(frame)
            self.assertEqual((message.type, message.fields), ("maps", {"name": "Größe"}))
            self.assertEqual([tuple(row) for row in message.arrays["a"]], arrays["a"][0])
            self.assertEqual(list(message.arrays["b"]), [7, -8])
            self.assertEqual(len(message.arrays["c"]), 0)
        self.assertEqual(len(set(made)), 1)


class Studios(unittest.TestCase):
    def setUp(self):
        self.runtime = tempfile.mkdtemp(prefix="link")
        os.chmod(self.runtime, 0o700)
        self.addCleanup(shutil.rmtree, self.runtime, True)
        self.addCleanup(lambda before: os.environ.update(before), dict(os.environ))
        for name in ("XDG_RUNTIME_DIR", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"):
            os.environ[name] = os.path.join(self.runtime, name)
            os.mkdir(os.environ[name], 0o700)
        self.processes = []
        self.addCleanup(self.end_studios)

    def end_studios(self):
        for process in self.processes:
            process.kill()
            process.wait()

    def start(self, *arguments):
        studio = link.start_studio((STUDIO, *arguments), timeout=LONG)
        self.processes.append(studio.process)
        self.addCleanup(studio.close)
        return studio

    def hand(self, studio, name, mesh, **more):
        studio.send_mesh(name, ["Grid"], *mesh, **more)
        return studio.wait_for("taken", LONG)

    def test_a_map_comes_back(self):
        studio = self.start("--solve")
        studio.want("live")
        self.assertEqual(self.hand(studio, "a", grid(12, 0.4), open=True).fields["how"], "opened")
        maps = studio.wait_for("maps", LONG)
        while maps.fields["solving"]:
            maps = studio.wait_for("maps", LONG)
        self.assertEqual(len(maps.arrays["uvs"]), 4 * 144)
        flat = [x for row in maps.arrays["uvs"] for x in row]
        self.assertTrue(all(-0.01 <= x <= 1.01 for x in flat))

    def test_fifty_rounds_of_two_programs(self):
        """One bends the mesh, both cut and select; in the end both have all cuts, and the solve goes on."""
        side = 10
        first = self.start("--solve")
        first.want("live")
        self.hand(first, "a", grid(side), open=True)
        second = link.Link(first.place, "Second", LONG)
        self.addCleanup(second.close)
        second.want("live")
        self.hand(second, "a", grid(side))
        expected, known = set(), {first: set(), second: set()}

        def take(program, message):
            self.assertNotEqual(message.type, "refused")
            if message.type == "marks":
                known[program] |= set(rows(message.arrays.get("cuts", ())))
                known[program] -= set(rows(message.arrays.get("uncuts", ())))

        def hear(program):
            for message in program.poll():
                take(program, message)

        def cut(program, edge):
            expected.add(edge)
            known[program].add(edge)
            program.send_marks(cuts=[edge])

        for number in range(50):
            # Edges within the grid, each one once.
            row, column = divmod(number, side)
            a = (row + 1) * (side + 1) + column
            cut(first, (a, a + 1))
            first.request()
            first.wait_for("maps", LONG, heard := [])  # the cut is there
            for message in heard:
                take(first, message)
            # The second one has an older state of the mesh until it takes over the newer one.
            mesh = grid(side, 0.01 * (number // 5))
            hear(second)
            self.hand(second, "a", mesh, cuts=sorted(known[second]))
            across = column * (side + 1) + row + 1
            cut(second, (across, across + side + 1))
            hear(first)
            self.hand(first, "a", mesh, cuts=sorted(known[first]))
        until = time.monotonic() + LONG
        while time.monotonic() < until and not known[first] == known[second] == expected:
            hear(first)
            hear(second)
        self.assertEqual(known[first], expected)
        self.assertEqual(known[second], expected)
        first.request()
        self.assertEqual(len(first.wait_for("maps", LONG).arrays["uvs"]), 4 * side * side)

    def test_a_wrong_token(self):
        studio = self.start()
        place = link.places()[0]
        place.token = "0" * 64
        with self.assertRaisesRegex(link.LinkError, "token"):
            link.Link(place)
        self.hand(studio, "a", grid(3), open=True)

    def test_a_killed_studio(self):
        studio = self.start("--solve")
        self.hand(studio, "a", grid(12, 0.4), open=True)
        studio.want("live")
        os.kill(studio.place.process, signal.SIGKILL)
        with self.assertRaisesRegex(link.LinkError, "ended"):
            while True:
                studio.wait_for("maps", LONG)
        self.assertFalse(studio.is_open)
        # What it left behind is removed, and another studio is found.
        self.assertEqual(len(link.places()), 1)
        with self.assertRaisesRegex(link.LinkError, "No studio"):
            link.connect()
        self.assertEqual(link.places(), [])
        self.assertEqual(os.listdir(link.user_folder()), [])
        other = self.start()
        with link.connect() as again:
            self.hand(again, "a", grid(3), open=True)
        self.assertTrue(other.is_open)

    def test_killed_programs(self):
        studio = self.start("--solve")
        self.hand(studio, "a", grid(12, 0.4), open=True)
        program = (
            "import sys; sys.path.insert(0, sys.argv[1]); import link, os, signal\n"
            "studio = link.connect()\n"
            "studio.want('live')\n"
            "data = link.encode('mesh', {'serial': 1}, {'positions': ([0.0] * 3000000, 'f8', 3)})\n"
            "studio._send(data[: len(data) // 2])\n"
            "os.kill(os.getpid(), signal.SIGKILL)\n"
        )
        for _ in range(5):
            ended = subprocess.run([sys.executable, "-c", program, os.path.dirname(link.__file__)], check=False)
            self.assertEqual(ended.returncode, -signal.SIGKILL)
        self.assertEqual(self.hand(studio, "a", grid(12, 0.5)).fields["how"], "relinked")

    def test_noise(self):
        studio = self.start()
        self.hand(studio, "a", grid(4), open=True)
        dice = random.Random(3)
        told = studio.place
        hello = link.encode("hello", {"version": 1, "token": told.token, "program": "Noise"}, {})
        for number in range(150):
            with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as noise:
                noise.settimeout(LONG)
                noise.connect(told.socket)
                data = bytearray(link.encode("mesh", {"serial": number}, {"sizes": ([4] * 50, "i4", 1)}))
                for _ in range(dice.randrange(30)):
                    data[dice.randrange(len(data))] = dice.randrange(256)
                with contextlib.suppress(BrokenPipeError, ConnectionResetError):
                    noise.sendall((hello if number % 3 else b"") + data[: dice.randrange(len(data))])
                    if number % 2:
                        noise.shutdown(socket.SHUT_WR)
                        while noise.recv(1 << 16):
                            pass
        self.assertEqual(self.hand(studio, "a", grid(4, 0.1)).fields["how"], "relinked")

    def maya_until(self, holds):
        until = time.monotonic() + LONG
        while not holds():
            self.assertLess(time.monotonic(), until, mayastandin.scene.said)
            mayastandin.scene.run_timers()
            time.sleep(0.01)

    def test_maya_by_a_stand_in(self):
        """Two meshes get one map; an edit is re-linked; faces are selected on both sides; the studio is killed."""
        scene = mayastandin.scene
        self.addCleanup(autocuts_maya.end_link)
        first, second = "|one|oneShape", "|two|twoShape"
        for path in (first, second):
            scene.meshes[path] = mayastandin.Mesh(*grid(5, 0.4))
        scene.selection = []
        autocuts_maya.open_in_autocuts()
        self.assertIn("select meshes", scene.said[-1])
        solving = os.path.join(self.runtime, "solving")
        with open(solving, "w", encoding="utf-8") as file:
            file.write(f'#!/bin/sh\nexec "{STUDIO}" --solve\n')
        os.chmod(solving, 0o700)
        scene.selection = ["|one", "|two"]
        autocuts_maya.open_in_autocuts(studio=solving)
        process = autocuts_maya._session.process
        self.processes.append(process)
        mesh = scene.meshes[second]
        self.maya_until(lambda: mesh.us)
        self.assertEqual(mesh.counts, mesh.sizes)
        self.assertEqual(len(set(zip(mesh.us, mesh.vs))), len(mesh.us))
        self.assertTrue(all(-0.01 < value < 1.01 for value in mesh.us + mesh.vs))
        # Corners of a vertex that lie together in the map are one.
        self.assertLess(len(mesh.us), len(mesh.corners))
        serial = autocuts_maya._session.link.serial
        mesh.points[3] = (3, 0, 0.5)
        self.maya_until(lambda: autocuts_maya._session.link.serial > serial and not autocuts_maya._session.waiting)
        with link.connect() as other:
            model = ["|one|oneShape", "|two|twoShape"]
            points = [p for one in scene.meshes.values() for p in one.points]
            sizes = [s for one in scene.meshes.values() for s in one.sizes]
            corners = mesh.corners + [corner + len(mesh.points) for corner in mesh.corners]
            other.send_mesh(other.place.model, model, points, sizes, corners, [0] * 25 + [1] * 25)
            self.assertEqual(other.wait_for("taken", LONG).fields["how"], "unchanged")
            other.send_marks(selection=[1, 27])
            self.maya_until(lambda: scene.selection == [f"{first}.f[1]", f"{second}.f[2]"])
            scene.selection = [f"{second}.f[4]"]
            heard = []
            self.maya_until(
                lambda: heard.extend(other.poll())
                or any(29 in one.arrays.get("selection", ()) for one in heard if one.type == "marks")
            )
        process.kill()
        process.wait()
        self.maya_until(lambda: autocuts_maya._session is None)
        self.assertEqual(scene.timers, {})

    @unittest.skipUnless(os.environ.get("AUTOCUTS_MODULE"), "no Python module")
    def test_the_command_line(self):
        """A file goes to the studio, and comes back with the map that another program has put there."""
        model, output = (os.path.join(self.runtime, name) for name in ("grid.obj", "mapped.obj"))
        positions, _, corners = grid(3)
        with open(model, "w", encoding="utf-8") as file:
            file.writelines(f"v {x} {y} {z}\n" for x, y, z in positions)
            quads = zip(*[iter(corners)] * 4)
            file.writelines("f " + " ".join(str(vertex + 1) for vertex in quad) + "\n" for quad in quads)
        self.start()
        environment = {**os.environ, "PYTHONPATH": os.environ["AUTOCUTS_MODULE"]}
        with subprocess.Popen(
            [sys.executable, "-m", "autocuts.link", model, "-o", output], env=environment, stdout=subprocess.PIPE, text=True
        ) as tool:
            until = time.monotonic() + LONG
            while link.places()[0].model != model:
                self.assertLess(time.monotonic(), until)
                time.sleep(0.05)
            with link.connect() as other:
                uvs = [(positions[vertex][0] / 8, positions[vertex][1] / 8) for vertex in corners]
                other.send_mesh(model, ["Other"], *grid(3))
                # Another object: it is no state of this model.
                with self.assertRaisesRegex(link.LinkError, "another model"):
                    other.wait_for("taken", LONG)
                other.send_mesh(model, ["grid.obj"], *grid(3), uv_sets=[("UVMap", uvs)])
                other.wait_for("taken", LONG)
                self.assertIn("0 edges are seams", tool.communicate(timeout=LONG)[0])
        self.assertEqual(tool.returncode, 0)
        with open(output, encoding="utf-8") as file:
            written = {tuple(map(float, line.split()[1:])) for line in file if line.startswith("vt ")}
        self.assertEqual(written, set(uvs))
        failed = subprocess.run(
            [sys.executable, "-m", "autocuts.link", model + "x", "-o", output],
            env=environment, capture_output=True, text=True, check=False,
        )
        self.assertEqual(failed.returncode, 1)
        self.assertTrue(failed.stderr.startswith("autocuts.link: "), failed.stderr)

    def test_nothing_is_readable_by_others(self):
        studio = self.start()
        folder = link.user_folder()
        self.assertEqual(os.stat(folder).st_mode & 0o777, 0o700)
        for name in os.listdir(folder):
            self.assertEqual(os.stat(os.path.join(folder, name)).st_mode & 0o077, 0, name)
        with open(studio.place.path, encoding="utf-8") as file:
            self.assertEqual(json.load(file)["process"], studio.place.process)


if __name__ == "__main__":
    unittest.main(verbosity=2)
