"""The Python side of the live link by itself: what stands for a studio here is a few lines, so nothing has to be built."""

import contextlib
import importlib
import json
import os
import shutil
import socket
import struct
import sys
import tempfile
import threading
import types
import unittest
import unittest.mock

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "support"))
from linkmodules import autocuts_maya, link, mayastandin

LONG = 120  # seconds; much longer than anything takes


class StandIn:
    """A studio that welcomes each program, refuses it, says nothing or dies, and keeps what it is sent."""

    def __init__(self, folder, process, model="", refuses=False, silent=False, dies=False):
        self.heard, self.model = [], model
        self.refuses, self.silent, self.dies = refuses, silent, dies
        self.how = "relinked"
        self.path = os.path.join(folder, f"studio-{process}.json")
        told = {"version": 1, "socket": self.path[:-5] + ".socket", "token": "0" * 64, "process": process, "model": model}
        self._server = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        self._server.bind(told["socket"])
        self._server.listen()
        with open(self.path, "w", encoding="utf-8") as file:
            json.dump(told, file)
        threading.Thread(target=self._serve, daemon=True).start()

    def _serve(self):
        while True:
            try:
                program, _ = self._server.accept()
            except OSError:
                return
            with program, contextlib.suppress(OSError):  # it may have gone
                if not self.dies:
                    self._answer(program)
            if self.dies:
                self.end()

    def _answer(self, program):
        while len(head := program.recv(8, socket.MSG_WAITALL)) == 8:
            fields, arrays = struct.unpack("<II", head)
            data = program.recv(fields + arrays, socket.MSG_WAITALL)
            message = link.decode(data[:fields], data[fields:])
            self.heard.append(message)
            if self.silent:
                continue
            if message.type == "hello" and self.refuses:
                program.sendall(link.encode("refused", {"serial": 0, "reason": "No", "remedy": "Ask another"}, {}))
            elif message.type == "hello":
                program.sendall(link.encode("welcome", {"version": 1, "program": "Stand-in", "model": self.model}, {}))
            elif message.type == "mesh":
                taken = {"serial": message.fields["serial"], "how": self.how, "lost": []}
                program.sendall(link.encode("taken", taken, {}))

    def end(self):
        with contextlib.suppress(OSError):  # it may have died
            self._server.shutdown(socket.SHUT_RDWR)
        self._server.close()


class WithPlaces(unittest.TestCase):
    """A folder of places of its own."""

    def setUp(self):
        runtime = tempfile.mkdtemp(prefix="link")
        self.addCleanup(shutil.rmtree, runtime, True)
        self.addCleanup(os.environ.update, {"XDG_RUNTIME_DIR": os.environ.get("XDG_RUNTIME_DIR", "")})
        os.environ["XDG_RUNTIME_DIR"] = runtime
        self.folder = link.user_folder()
        os.mkdir(self.folder, 0o700)

    def studio(self, *arguments, **more):
        made = StandIn(self.folder, *arguments, **more)
        self.addCleanup(made.end)
        return made


class Frames(unittest.TestCase):
    def test_fields_have_at_most_4_mib(self):
        """As in the studio."""
        one, other = socket.socketpair()
        self.addCleanup(one.close)
        studio = link.Link.__new__(link.Link)
        studio._socket, studio._in, studio._out, studio._kept, studio.serial = other, bytearray(), bytearray(), [], 0
        other.setblocking(False)
        one.sendall(struct.pack("<II", (4 << 20) + 1, 0))
        with self.assertRaisesRegex(link.LinkError, "cannot be read"):
            studio.poll()
        self.assertFalse(studio.is_open)


class Places(WithPlaces):
    def killed(self, told_socket):
        """The place of a studio that does not run."""
        path = os.path.join(self.folder, "studio-7.json")
        told = {"version": 1, "socket": told_socket, "token": "", "process": 7, "model": ""}
        with open(path, "w", encoding="utf-8") as file:
            json.dump(told, file)
        return path

    def test_a_folder_of_others(self):
        """What others can write to is not believed."""
        self.killed("nowhere")
        self.assertEqual(len(link.places()), 1)
        for mode in (0o770, 0o707, 0o750, 0o701):
            os.chmod(self.folder, mode)
            self.assertEqual(link.places(), [], oct(mode))
        os.chmod(self.folder, 0o700)
        self.assertEqual(len(link.places()), 1)

    def test_only_the_place_is_removed(self):
        """A file that a place names is the user's."""
        kept = os.path.join(self.folder, "kept.blend")
        for path in (kept, os.path.join(self.folder, "studio-7.socket")):
            with open(path, "w", encoding="utf-8") as file:
                file.write("something")
        self.killed(kept)
        with self.assertRaisesRegex(link.LinkError, "No studio"):
            link.connect()
        self.assertEqual(os.listdir(self.folder), ["kept.blend"])

    def test_a_studio_that_refuses_is_passed_over(self):
        newest = self.studio(2, refuses=True)
        studio = self.studio(1)
        os.utime(studio.path, (1, 1))
        with link.connect() as linked:
            self.assertEqual(linked.place.process, 1)
        self.assertTrue(newest.heard)

    def test_all_studios_refuse(self):
        self.studio(2, refuses=True)
        with self.assertRaisesRegex(link.LinkError, "No. Ask another."):
            link.connect()

    def test_a_studio_that_is_being_killed(self):
        """The system still takes connections for it, and closes them."""
        dying = self.studio(2, dies=True)
        with self.assertRaisesRegex(link.LinkError, "No studio"):
            link.connect()
        self.assertFalse(os.path.exists(dying.path))

    def test_a_studio_that_starts(self):
        """It may listen before it answers."""
        process = types.SimpleNamespace(pid=3)
        self.assertIsNone(link.started_studio(process))
        silent = self.studio(3, silent=True)
        self.assertIsNone(link.started_studio(process, timeout=0.01))
        silent.silent = False
        with link.started_studio(process) as linked:
            self.assertIs(linked.process, process)


@unittest.skipIf(link.numpy is None, "no NumPy")
class CommandLine(WithPlaces):
    def handed(self, model, open_model, how="relinked"):
        """The UV sets of the meshes that reach a studio that has open_model."""
        mesh = types.SimpleNamespace(
            positions=[(0, 0, 0), (1, 0, 0), (0, 1, 0)],
            faces=[(0, 1, 2)],
            uvs=[(0, 0), (1, 0), (0, 1)],
            sizes=lambda: [3],
            objects=None,
            object_names=(),
            materials=None,
            material_names=(),
        )
        studio = self.studio(1, model=open_model)
        studio.how = how
        with link.connect() as linked:
            link._hand_file(linked, mesh, model)
        return [one.fields["uvSets"] for one in studio.heard if one.type == "mesh"]

    def test_a_studio_that_has_the_file_keeps_its_map(self):
        self.assertEqual(self.handed("chair.obj", os.path.abspath("chair.obj")), [[]])

    def test_a_file_that_is_opened_anew_has_its_map(self):
        """Its objects have other names in the studio, so that this is no state of the open model."""
        self.assertEqual(self.handed("chair.obj", os.path.abspath("chair.obj"), "opened"), [[], ["UVMap"]])

    def test_the_map_of_a_file_goes_to_another_studio(self):
        self.assertEqual(self.handed("chair.obj", "", "opened"), [["UVMap"]])

    def test_the_studio_that_has_the_file_gets_it(self):
        """Also where another one is newer."""
        model = os.path.abspath("chair.obj")
        chosen = self.studio(1, model=model)
        other = self.studio(2, model="/table.obj")
        os.utime(chosen.path, (1, 1))
        os.utime(other.path, (2, 2))
        package = types.ModuleType("autocuts")
        package.Mesh = types.SimpleNamespace(load=lambda path: None)
        self.addCleanup(sys.modules.pop, "autocuts")
        sys.modules["autocuts"] = package
        choice = types.SimpleNamespace(model="chair.obj", start=False, watch=None)
        with self.assertRaises(AttributeError):  # there is no mesh
            link._run(choice)
        self.assertTrue(chosen.heard)
        self.assertEqual(other.heard, [])


class StandInLink:
    """A link on which messages come by hand."""

    def __init__(self):
        self.coming, self.meshes, self.marks, self.requests = [], [], [], 0
        self.serial, self.is_open = 0, True

    def come(self, kind, fields=None, arrays=None):
        self.coming.append(link.Message(kind, fields or {}, arrays or {}))

    def poll(self):
        coming, self.coming = self.coming, []
        return coming

    def want(self, mode):
        self.mode = mode

    def request(self):
        self.requests += 1

    def send_mesh(self, *arguments, **more):
        self.serial += 1
        self.meshes.append((arguments, more))

    def send_marks(self, **changes):
        self.marks.append(changes)

    def send_textures(self, materials):
        pass

    def close(self):
        self.is_open = False


class Maya(WithPlaces):
    def setUp(self):
        super().setUp()
        self.scene = mayastandin.scene
        self.scene.__init__()
        self.path = "|one|oneShape"
        self.mesh = mayastandin.Mesh([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [4], [0, 1, 2, 3])
        self.scene.meshes[self.path] = self.mesh
        self.scene.selection = ["|one"]
        self.link = StandInLink()
        self.addCleanup(autocuts_maya.end_link)

    def open(self):
        self.addCleanup(setattr, link, "connect", link.connect)
        link.connect = lambda *_arguments, **_more: self.link
        autocuts_maya.open_in_autocuts()
        self.link.come("taken", {"lost": []})
        self.scene.run_timers()

    def test_a_map_of_other_polygons_is_not_written(self):
        """The same number of corners, in another order."""
        self.open()
        self.mesh.corners = [1, 2, 3, 0]
        self.mesh.us, self.mesh.vs, self.mesh.counts, self.mesh.ids = [0.5], [0.25], [4], [0] * 4
        self.link.come("maps", {}, {"uvs": [(0, 0), (1, 0), (1, 1), (0, 1)]})
        self.scene.run_timers()
        self.assertEqual((self.mesh.us, self.mesh.ids), ([0.5], [0] * 4))
        self.assertEqual(len(self.link.meshes), 2)  # it is handed over as it is now

    def test_a_mesh_that_is_gone_ends_the_link(self):
        self.open()
        del self.scene.meshes[self.path]
        self.link.come("maps", {}, {"uvs": [(0, 0), (1, 0), (1, 1), (0, 1)]})
        self.scene.run_timers()
        self.assertIn("Error: Autocuts: the link has ended", self.scene.said[-1])
        self.assertEqual((self.scene.timers, self.link.is_open), ({}, False))

    def test_a_studio_is_not_waited_for(self):
        """Another program stands for a studio that takes long to start."""
        slow = os.path.join(self.folder, "slow")
        with open(slow, "w", encoding="utf-8") as file:
            file.write("#!/bin/sh\nexec sleep 1000\n")
        os.chmod(slow, 0o700)
        with unittest.mock.patch.object(autocuts_maya, "_ANSWER", LONG):
            self.start_slowly(slow)

    def start_slowly(self, slow):
        autocuts_maya.open_in_autocuts(mode="pause", studio=slow)
        process = autocuts_maya._session.process
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        self.scene.run_timers()
        autocuts_maya.set_mode("live")
        studio = self.studio(process.pid)
        self.scene.run_timers()
        autocuts_maya._session.link.wait_for("taken", LONG)
        self.assertEqual([one.fields["mode"] for one in studio.heard if one.type == "want"], ["live"])

    def test_a_studio_that_does_not_start(self):
        autocuts_maya.open_in_autocuts(studio="true")
        autocuts_maya._session.process.wait(LONG)
        self.scene.run_timers()
        self.assertIn("did not start", self.scene.said[-1])
        self.assertEqual(self.scene.timers, {})
        autocuts_maya.open_in_autocuts(studio=os.path.join(self.folder, "missing"))
        self.assertIn("missing", self.scene.said[-1])


def blender_module():
    """The link of the add-on, with a Blender that has nothing; None without NumPy."""
    if link.numpy is None:
        return None
    for name in ("bmesh", "bpy", "gpu"):
        sys.modules[name] = unittest.mock.MagicMock()
    sys.modules["bpy"].app.handlers.persistent = lambda function: function
    package = types.ModuleType("autocuts_uv")
    package.__path__ = [os.path.join(HERE, "..", "integrations", "blender", "autocuts_uv")]
    sys.modules.update({"autocuts_uv": package, "autocuts_uv.link": link})
    return importlib.import_module("autocuts_uv.livelink")


livelink = blender_module()


@unittest.skipIf(livelink is None, "no NumPy")
class Blender(unittest.TestCase):
    """What the link decides; tst_blenderlink.py shows it in Blender."""

    def setUp(self):
        """A mesh of one triangle that was handed over, with a map."""
        self.link = StandInLink()
        self.uvs = link.numpy.array([(0, 0), (1, 0), (0, 1)], dtype=float)
        self.written = []
        self.part = livelink.meshdata.Part("One", "UVMap", 0, 3, b"")
        self.model = types.SimpleNamespace(
            parts=[self.part], uvs=self.uvs, names=["One"], materials=[], face_materials=None, face_objects=None
        )
        for place, name, made in (
            (livelink.Session, "_objects", lambda _session: [unittest.mock.MagicMock()]),
            (livelink.Session, "_model", lambda _session: self.model),
            (livelink.Session, "_described", staticmethod(lambda model: b"")),
            (livelink.Session, "_is_same", staticmethod(lambda part: True)),
            (livelink.Session, "_is_there", lambda _session, part: True),
            (livelink.Session, "_marks_of", lambda _session, model: (link.numpy.zeros(0, int),) * 2 + (None,)),
            (livelink.meshdata, "write_uvs", self.write),
            (livelink.link, "connect", lambda *_arguments, **_more: self.link),
        ):
            patch = unittest.mock.patch.object(place, name, made)
            patch.start()
            self.addCleanup(patch.stop)
        for name in ("positions", "corners", "face_sizes"):
            setattr(self.model, name, None)
        livelink.current = self.session = livelink.Session([unittest.mock.MagicMock()], "live", "studio")
        self.addCleanup(livelink.end)
        self.session._looked = -LONG

    def write(self, parts, uvs):
        self.written.append(uvs)
        self.model.uvs = uvs
        return []

    def taken(self, how="opened"):
        self.link.come("taken", {"lost": [], "how": how})
        self.session.tick()

    def map_comes(self, uvs, name="UVMap", solving=False):
        self.link.come("maps", {"uvSet": name, "solving": solving}, {"uvs": uvs})
        self.session.tick()

    def test_pins_that_cannot_be_written_are_not_known(self):
        """Else they would be removed in the studio."""
        for written, known in ((False, []), (True, [1])):
            with unittest.mock.patch.object(livelink.api, "change_pins", return_value=written):
                self.link.come("marks", {}, {"pins": [1], "pinUvs": [(0, 0)]})
                self.session.tick()
            self.assertEqual(self.session._known.pins.tolist(), known)

    def test_an_error_ends_the_link(self):
        """The timer ends with it."""
        self.link.come("maps")  # without UVs
        with self.assertRaises(KeyError):
            livelink._tick()
        self.assertEqual((self.session.is_open, self.session.text), (False, "Not linked"))
        self.assertIn("console", self.session.notes[-1])
        self.assertIsNone(livelink._tick())

    def test_a_studio_that_starts_gets_the_objects(self):
        """When it answers."""
        refused = unittest.mock.Mock(side_effect=link.LinkError)
        process = types.SimpleNamespace(pid=1, poll=lambda: None)
        answers = iter((None, self.link))
        with unittest.mock.patch.multiple(
            livelink.link, connect=refused, started_studio=lambda *_, **__: next(answers)
        ), unittest.mock.patch.object(livelink.subprocess, "Popen", lambda *_, **__: process):
            session = livelink.Session([], "pause", "studio")
            handed = len(self.link.meshes)
            session.tick()
            self.assertEqual((session.text, len(self.link.meshes)), ("Autocuts is starting", handed))
            session.tick()
            self.assertEqual((session.text, len(self.link.meshes)), ("Linked to Autocuts", handed + 1))

    def test_a_studio_is_waited_for_at_most_2_s(self):
        """In the thread that draws Blender."""
        asked = []
        with unittest.mock.patch.object(livelink.link, "connect", lambda *_, **more: asked.append(more) or self.link):
            livelink.Session([], "live", "studio")
        self.assertEqual(asked, [{"timeout": 2, "any_model": False}])

    def test_maps_of_other_uv_sets_are_passed_over(self):
        """The user is told once."""
        self.taken("opened")
        for _ in range(2):
            self.map_comes(0.5 * self.uvs, "Lightmap")
        self.assertEqual(self.written, [])
        self.assertEqual(self.session.notes, ["Maps of Lightmap stay in Autocuts: this link is for UVMap"])
        self.map_comes(0.25 * self.uvs, "UVMap")
        self.assertEqual(len(self.written), 1)
        self.assertEqual(len(self.session.notes), 1)

    def test_the_first_map_says_which_uv_set_it_is(self):
        """The studio had the model, and its names are its own."""
        self.taken("relinked")
        for name in ("Main", "Lightmap", "Main"):
            self.map_comes(0.5 * self.uvs, name)
        self.assertEqual(len(self.written), 2)

    def test_final_maps_are_steps_of_undo(self):
        """Those of a running solve are not, nor are maps that are there."""
        self.taken()
        with unittest.mock.patch.object(livelink, "_push_undo") as push:
            for factor, solving, steps in ((0.5, True, 0), (0.4, True, 0), (0.4, False, 1), (0.4, False, 1), (0.3, False, 2)):
                self.map_comes(factor * self.uvs, solving=solving)
                self.assertEqual(push.call_count, steps, (factor, solving))

    def test_undo_sends_no_old_map(self):
        """The newest one is asked for, and is no other step of undo."""
        self.taken()
        self.map_comes(0.5 * self.uvs)
        self.model.uvs = self.uvs
        livelink._went_back()
        self.session.tick()
        self.assertEqual((len(self.link.meshes), self.link.requests), (1, 1))
        with unittest.mock.patch.object(livelink, "_push_undo") as push:
            self.map_comes(0.5 * self.uvs)
        self.assertEqual((len(self.written), push.call_count), (2, 0))
        # What is edited afterwards goes to the studio.
        self.session._looked = -LONG
        self.model.uvs = 0.25 * self.uvs
        livelink._changed()
        self.session.tick()
        self.assertEqual((len(self.link.meshes), self.link.requests), (2, 1))


if __name__ == "__main__":
    unittest.main(verbosity=2)
