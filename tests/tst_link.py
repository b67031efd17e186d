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

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "python", "autocuts"))
import link

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
        began = time.monotonic()
        with self.assertRaisesRegex(link.LinkError, "ended"):
            while True:
                studio.wait_for("maps", LONG)
        self.assertLess(time.monotonic() - began, LONG)
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
