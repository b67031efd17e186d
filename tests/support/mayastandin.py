"""A stand-in for the parts of Maya that integrations/maya uses, for tests without Maya. Written from the manuals of maya.cmds
and maya.api.OpenMaya 2022; install() makes it importable as maya.

One scene: meshes by the full path of their shape. Timers run when run_timers() is called.
"""

import sys
import types
from dataclasses import dataclass, field


@dataclass
class Mesh:
    points: list  # (x, y, z)
    sizes: list
    corners: list
    us: list = field(default_factory=list)
    vs: list = field(default_factory=list)
    counts: list = None  # UVs of each face, 0 for none
    ids: list = field(default_factory=list)


@dataclass
class Point:
    x: float
    y: float
    z: float


class Scene:
    """All that the stand-in knows."""

    def __init__(self):
        self.meshes, self.selection, self.timers, self.said = {}, [], {}, []
        self.name, self.axis = "", "y"

    def run_timers(self):
        for function in list(self.timers.values()):
            function(0.1, 0.1, None)


scene = Scene()


class MSelectionList:
    def __init__(self):
        self._paths = []

    def add(self, path):
        if path not in scene.meshes:
            raise RuntimeError("(kInvalidParameter): No object matches name")
        self._paths.append(path)

    def getDagPath(self, number):
        return self._paths[number]


class MFnMesh:
    def __init__(self, path):
        self._mesh = scene.meshes[path]

    def getPoints(self, _space):
        return [Point(*point) for point in self._mesh.points]

    def getVertices(self):
        return self._mesh.sizes, self._mesh.corners

    def currentUVSetName(self):
        return "map1"

    def getUVs(self, _name):
        return self._mesh.us, self._mesh.vs

    def getAssignedUVs(self, _name):
        return self._mesh.counts or [0] * len(self._mesh.sizes), self._mesh.ids

    def clearUVs(self, _name):
        self._mesh.us, self._mesh.vs, self._mesh.counts, self._mesh.ids = [], [], None, []

    def setUVs(self, us, vs, _name):
        if len(us) != len(vs):
            raise RuntimeError("(kInvalidParameter): U and V differ")
        self._mesh.us, self._mesh.vs = list(us), list(vs)

    def assignUVs(self, counts, ids, _name):
        if sum(counts) != len(ids) or max(ids) >= len(self._mesh.us):
            raise RuntimeError("(kInvalidParameter): ids do not fit")
        self._mesh.counts, self._mesh.ids = list(counts), list(ids)

    def updateSurface(self):
        pass


class MTimerMessage:
    @staticmethod
    def addTimerCallback(_seconds, function):
        number = max(scene.timers, default=0) + 1
        scene.timers[number] = function
        return number


class MMessage:
    @staticmethod
    def removeCallback(number):
        del scene.timers[number]


class MGlobal:
    @staticmethod
    def displayInfo(text):
        scene.said.append(text)

    @staticmethod
    def displayError(text):
        scene.said.append("Error: " + text)


def ls(*names, selection=False, objectsOnly=False, dag=False, type=None, long=False, noIntermediate=False, flatten=False):
    if selection:
        found = [name.partition(".")[0] if objectsOnly else name for name in scene.selection]
        return list(dict.fromkeys(found))
    wanted = names[0] if names else list(scene.meshes)
    return [path for path in scene.meshes for name in wanted if path == name or path.startswith(name + "|")]


def select(*names, replace=False, clear=False):
    scene.selection = [] if clear else list(names[0])


def file(query=False, sceneName=False):
    return scene.name


def upAxis(query=False, axis=False):
    return scene.axis


def objExists(path):
    return path in scene.meshes


def install():
    """Makes `import maya.cmds` and `import maya.api.OpenMaya` give this."""
    here = sys.modules[__name__]
    maya, cmds, api, om = (types.ModuleType(name) for name in ("maya", "maya.cmds", "maya.api", "maya.api.OpenMaya"))
    for name in ("ls", "select", "file", "upAxis", "objExists"):
        setattr(cmds, name, getattr(here, name))
    for name in ("MSelectionList", "MFnMesh", "MTimerMessage", "MMessage", "MGlobal"):
        setattr(om, name, getattr(here, name))
    om.MSpace = types.SimpleNamespace(kWorld=4)
    maya.cmds, maya.api, api.OpenMaya = cmds, api, om
    for module in (maya, cmds, api, om):
        sys.modules[module.__name__] = module
