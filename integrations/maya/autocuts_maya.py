"""Autocuts in Maya: opens the selected meshes in the studio, and writes the maps that come back into them.

Needs link.py of Autocuts beside it, and nothing else. The licence is GPL-3.0-or-later.
"""

import os
import subprocess
import time

import maya.api.OpenMaya as om
import maya.cmds as cmds

try:
    import link
except ImportError:
    from autocuts import link

_EVERY = 0.1  # seconds between two looks at the link
_LOOK = 5  # looks at the link between two looks at the meshes
_ANSWER = 2  # seconds that Maya waits for a studio to answer
_START = 60  # seconds that a studio may take to start


class _Part:
    """A mesh of the scene, and where it is among the others."""

    def __init__(self, path, first_vertex, first_corner, first_face):
        self.path = path
        self.first_vertex, self.first_corner, self.first_face = first_vertex, first_corner, first_face
        mesh = _mesh(path)
        self.points = [(p.x, p.y, p.z) for p in mesh.getPoints(om.MSpace.kWorld)]
        sizes, corners = mesh.getVertices()
        self.sizes, self.corners = list(sizes), list(corners)

    def uvs(self):
        """(C, 2) UVs of the current UV set, NaN where there is none; None without any."""
        mesh = _mesh(self.path)
        us, vs = mesh.getUVs(mesh.currentUVSetName())
        counts, ids = mesh.getAssignedUVs(mesh.currentUVSetName())
        if not len(us):
            return None
        found, at = [], 0
        for face, size in enumerate(self.sizes):
            count = counts[face]
            own = ids[at : at + count] if count == size else [-1] * size
            found += [(us[i], vs[i]) if i >= 0 else (float("nan"),) * 2 for i in own]
            at += count
        return found

    def is_same(self):
        """True when the mesh has the polygons that it had."""
        sizes, corners = _mesh(self.path).getVertices()
        return list(sizes) == self.sizes and list(corners) == self.corners

    def write(self, uvs):
        """Writes UVs of the corners: those of a vertex that are equal become one."""
        mesh = _mesh(self.path)
        ids, us, vs, known = [], [], [], {}
        for vertex, (u, v) in zip(self.corners, uvs):
            key = (vertex, float(u), float(v))
            if key not in known:
                known[key] = len(us)
                us.append(key[1])
                vs.append(key[2])
            ids.append(known[key])
        name = mesh.currentUVSetName()
        mesh.clearUVs(name)
        mesh.setUVs(us, vs, name)
        mesh.assignUVs(self.sizes, ids, name)
        mesh.updateSurface()


def _mesh(path):
    chosen = om.MSelectionList()
    chosen.add(path)
    return om.MFnMesh(chosen.getDagPath(0))


def _model_name():
    """The name by which the studio knows this scene."""
    return cmds.file(query=True, sceneName=True) or "untitled-%d.ma" % os.getpid()


def _selected_meshes():
    """Full paths of the meshes that are selected, or of which something is."""
    shapes = cmds.ls(cmds.ls(selection=True, objectsOnly=True, long=True) or [], dag=True, type="mesh", long=True,
                     noIntermediate=True)
    return list(dict.fromkeys(shapes or []))


class _Session:
    """A link, and the meshes that it is for."""

    def __init__(self, paths, studio, mode):
        """studio: the program, for when none runs that has this scene or nothing."""
        self.paths, self.mode = paths, mode
        self.parts = []
        self.notes = []
        self.waiting = False  # for the answer to a mesh
        self.link = None  # until a studio answers
        self.process = None  # of a studio that was started for it
        self._until = time.monotonic() + _START
        self._looks = 0
        self._selected = None
        try:
            found = link.connect(_model_name(), "Maya", timeout=_ANSWER, any_model=False)
        except link.LinkError:
            self.process = subprocess.Popen([studio], stdin=subprocess.DEVNULL)
            return
        self._begin(found)

    def _begin(self, studio):
        self.link = studio
        studio.want(self.mode)
        self.send_mesh(True)

    def _await_studio(self):
        """Links to the studio that was started, when it answers."""
        studio = link.started_studio(self.process, "Maya", timeout=_ANSWER)
        if studio is not None:
            self._begin(studio)
        elif self.process.poll() is not None or time.monotonic() > self._until:
            raise link.LinkError("the studio did not start: say where it is, open_in_autocuts(studio=PATH)")

    @property
    def is_open(self):
        """False when the link has ended."""
        return self.link is None or self.link.is_open

    def set_mode(self, mode):
        self.mode = mode
        if self.link is not None:
            self.link.want(mode)

    def request(self):
        if self.link is not None:
            self.link.request()

    def close(self):
        if self.link is not None:
            self.link.close()

    def _read(self):
        parts, counts = [], (0, 0, 0)
        for path in self.paths:
            part = _Part(path, *counts)
            counts = (
                counts[0] + len(part.points),
                counts[1] + len(part.corners),
                counts[2] + len(part.sizes),
            )
            parts.append(part)
        return parts

    def send_mesh(self, opens):
        parts = self._read() if opens or not self.parts else self.parts
        uvs = [part.uvs() for part in parts] if opens else [None]
        self.parts = parts
        self._selected = self._faces()
        self.link.send_mesh(
            _model_name(),
            self.paths,
            [point for part in parts for point in part.points],
            [size for part in parts for size in part.sizes],
            [corner + part.first_vertex for part in parts for corner in part.corners],
            [number for number, part in enumerate(parts) for _ in part.sizes],
            uv_sets=[] if None in uvs else [("map1", [uv for own in uvs for uv in own])],
            selection=self._selected,
            up=cmds.upAxis(query=True, axis=True),
            open=opens,
        )
        self.waiting = True

    def _faces(self):
        """The selected faces, by their numbers in the joined mesh."""
        faces = []
        for part in self.parts:
            name = part.path.split("|")[-2] if "|" in part.path else part.path
            for item in cmds.ls(selection=True, flatten=True, long=True) or []:
                owner, _, rest = item.partition(".f[")
                if rest and (owner == part.path or owner.split("|")[-1] == name):
                    faces.append(int(rest.rstrip("]")) + part.first_face)
        return sorted(faces)

    def tick(self):
        """Takes what has come and sends what has changed."""
        if self.link is None:
            self._await_studio()
            return
        for message in self.link.poll():
            take = getattr(self, "_take_" + message.type, None)
            if take:
                take(message)
        self._looks += 1
        if self._looks % _LOOK == 0 and not self.waiting and self.link.is_open:
            self._look()

    def _look(self):
        if not all(cmds.objExists(path) for path in self.paths):
            self._say("The linked meshes are gone")
            self.link.close()
            return
        now = self._read()
        if [(p.points, p.sizes, p.corners) for p in now] != [(p.points, p.sizes, p.corners) for p in self.parts]:
            self.parts = now
            self.send_mesh(False)
        elif self._faces() != self._selected:
            self._selected = self._faces()
            self.link.send_marks(selection=self._selected)

    def _say(self, text):
        self.notes.append(text)
        om.MGlobal.displayInfo("Autocuts: " + text)

    def _take_taken(self, message):
        self.waiting = False
        for line in message.fields["lost"]:
            self._say(line)

    def _take_refused(self, message):
        self.waiting = False
        self._say("%s. %s." % (message.fields["reason"], message.fields["remedy"]))

    def _take_left(self, message):
        self._say("the studio has another model now: " + (message.fields["model"] or "none"))

    def _take_maps(self, message):
        uvs = [(float(u), float(v)) for u, v in message.arrays["uvs"]]
        if any(u != u for u, _ in uvs):
            return  # a part has no map yet
        if not all(part.is_same() for part in self.parts):
            self._looks = _LOOK - 1  # the meshes go to the studio as they are now, and their map comes back
            return
        for part in self.parts:
            part.write(uvs[part.first_corner : part.first_corner + len(part.corners)])

    def _take_marks(self, message):
        if "selection" not in message.arrays:
            return
        self._selected = sorted(int(face) for face in message.arrays["selection"])
        names = [
            "%s.f[%d]" % (part.path, face - part.first_face)
            for face in self._selected
            for part in self.parts
            if part.first_face <= face < part.first_face + len(part.sizes)
        ]
        cmds.select(names, replace=True) if names else cmds.select(clear=True)


_session = None
_timer = None


def open_in_autocuts(mode="live", studio="autocuts"):
    """Opens the selected meshes in the studio. studio: the program, for when none runs that has them or nothing."""
    global _session, _timer
    paths = _selected_meshes()
    if not paths:
        om.MGlobal.displayError("Autocuts: select meshes first")
        return
    end_link()
    try:
        _session = _Session(paths, studio, mode)
    except (link.LinkError, OSError) as error:
        om.MGlobal.displayError("Autocuts: %s" % error)
        return
    _timer = om.MTimerMessage.addTimerCallback(_EVERY, _tick)


def _tick(*_arguments):
    try:
        _session.tick()
    except (link.LinkError, OSError, RuntimeError) as error:  # Maya's errors are RuntimeErrors
        om.MGlobal.displayError("Autocuts: the link has ended: %s" % error)
        end_link()
        return
    if not _session.is_open:
        end_link()


def set_mode(mode):
    """When maps come: "live", on "pause", or on "request" only."""
    if _session:
        _session.set_mode(mode)


def get_map():
    """Asks for the newest map."""
    if _session:
        _session.request()


def end_link():
    """Ends the link; the studio keeps the model."""
    global _session, _timer
    if _timer is not None:
        om.MMessage.removeCallback(_timer)
        _timer = None
    if _session is not None:
        _session.close()
        _session = None
