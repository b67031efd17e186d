"""The live link with the studio: hands the selected objects over, and writes what comes back into them.

One Session lives at a time. Its tick() is called by a timer of Blender. Only the first answer of a studio is waited for.
"""

import os
import subprocess
import time
from dataclasses import dataclass, field

import bmesh
import bpy
import numpy as np

from . import api, link, meshdata

_EVERY = 0.1  # seconds between two looks at the link
_ANSWER = 2  # seconds that Blender waits for the first answer of a studio
_START = 60  # seconds that a studio may take to start
#: Channels of pictures, and the inputs of the surface that they are at.
_INPUTS = {
    "baseColor": "Base Color",
    "roughness": "Roughness",
    "metalness": "Metallic",
    "normal": "Normal",
    "emission": "Emission",
}
_RESTING = 0.3  # seconds between two looks at a mesh that is being edited


@dataclass
class Known:
    """What the studio knows of the mesh that was sent last."""

    mesh: bytes = b""  # what decides whether it must be sent again
    uvs: np.ndarray = field(default_factory=lambda: np.empty((0, 2), np.float32))
    cuts: np.ndarray = field(default_factory=lambda: np.empty(0, np.int64))  # keys of edges, ascending
    pins: np.ndarray = field(default_factory=lambda: np.empty(0, np.int64))  # corners, ascending
    faces: np.ndarray | None = None  # selected ones; None: not said
    materials: list = field(default_factory=list)  # with their pictures


def _keys(pairs):
    """(N,) a number for each pair of vertices, whatever their order."""
    low, high = np.sort(pairs.reshape(-1, 2), axis=1).astype(np.int64).T
    return low << 32 | high


def _pairs(keys):
    """The inverse of _keys()."""
    return np.stack([keys >> 32, keys & 0xFFFFFFFF], axis=1).astype(np.int32)


def _sides(model):
    """(C, 2) the two vertices of the side that starts at each corner."""
    following = np.arange(1, len(model.corners) + 1)
    ends = np.cumsum(model.face_sizes)
    following[ends - 1] = ends - model.face_sizes
    return np.stack([model.corners, model.corners[following]], axis=1)


def _textures(material):
    """Paths of the images in the inputs of a material's surface, by channel."""
    if material is None or not material.node_tree:
        return {}
    found = {}
    surface = next((node for node in material.node_tree.nodes if node.type == "BSDF_PRINCIPLED"), None)
    for channel, name in _INPUTS.items():
        socket = surface.inputs.get(name) if surface else None
        node = socket.links[0].from_node if socket and socket.links else None
        if node and node.type == "NORMAL_MAP" and node.inputs["Color"].links:
            node = node.inputs["Color"].links[0].from_node
        if node and node.type == "TEX_IMAGE" and node.image and node.image.filepath:
            found[channel] = os.path.abspath(bpy.path.abspath(node.image.filepath))
    return found


def _image_node(material, channel):
    """The node of the picture at an input of a material's surface, made where there is none; None without a surface."""
    tree = material.node_tree if material else None
    surface = next((node for node in tree.nodes if node.type == "BSDF_PRINCIPLED"), None) if tree else None
    socket = surface.inputs.get(_INPUTS[channel]) if surface and channel in _INPUTS else None
    if socket is None:
        return None
    node = socket.links[0].from_node if socket.links else None
    if channel == "normal":
        if node is None or node.type != "NORMAL_MAP":
            node = tree.nodes.new("ShaderNodeNormalMap")
            tree.links.new(node.outputs["Normal"], socket)
        socket = node.inputs["Color"]
        node = socket.links[0].from_node if socket.links else None
    if node is None or node.type != "TEX_IMAGE":
        node = tree.nodes.new("ShaderNodeTexImage")
        tree.links.new(node.outputs["Color"], socket)
    return node


def _set_texture(material, channel, path):
    """Puts a picture at an input of a material's surface, where the file is there."""
    node = _image_node(material, channel) if os.path.isfile(path) else None
    if node is None:
        return
    node.image = bpy.data.images.load(path, check_existing=True)
    if channel not in ("baseColor", "emission"):
        node.image.colorspace_settings.name = "Non-Color"


def model_name():
    """The name by which the studio knows this file."""
    return bpy.data.filepath or f"untitled-{os.getpid()}.blend"


class Session:
    """A link, and the objects that it is for."""

    def __init__(self, objects, mode, studio):
        self.names = [item.name for item in objects]
        self.mode = mode
        self.notes = []  # for the user, the newest last
        self.waiting = False  # for the answer to a mesh
        self.dirty = False
        self.parts = []
        self._studio = studio  # the program
        self._known = Known()
        self._link = None
        self.process = None
        self._until = time.monotonic() + _START
        self._looked = 0.0
        self._went_back = False  # Blender's undo or redo has put other UVs here
        self._is_restoring = False  # the next map comes after it, and is no step
        self._lacks_step = False  # maps were written since the last step of Blender's undo
        self._uv_set = ""  # of the studio, that the link is for; empty: that of its next map
        self._left_out = set()  # other UV sets that the user was told of
        self._first_vertices, self._first_faces = [], []
        self._connect()

    @property
    def is_open(self):
        """False when the link has ended."""
        return self._until > 0

    @property
    def text(self):
        """The state in a few words."""
        if not self.is_open:
            return "Not linked"
        if self._link is None:
            return "Autocuts is starting"
        return "Linked to Autocuts"

    @property
    def serial(self):
        """Number of the mesh that was sent last; 0 before there is one."""
        return self._link.serial if self._link else 0

    def _connect(self):
        """Links to the studio that has this file, or has nothing; else starts one."""
        try:
            self._link = link.connect(model_name(), "Blender", timeout=_ANSWER, any_model=False)
        except link.LinkError:
            self.process = subprocess.Popen([self._studio], stdin=subprocess.DEVNULL)
            return
        self._begin()

    def _await_studio(self):
        """Links to the studio that was started, when it answers."""
        self._link = link.started_studio(self.process, "Blender", timeout=_ANSWER)
        if self._link is not None:
            self._begin()
        elif self.process.poll() is not None or time.monotonic() > self._until:
            self.close("Autocuts did not start: say in the preferences of this add-on where it is")

    def _begin(self):
        self._link.want(self.mode)
        self._send_mesh(self._model(), True, True)

    def set_mode(self, mode):
        """When maps come: "live", "pause" or "request"."""
        self.mode = mode
        if self._link is not None and self.is_open:
            self._link.want(mode)

    def request(self):
        """Asks for the newest map, and sends what has changed here."""
        if self._link is not None:
            self.dirty = True
            self._looked = 0.0
            self._link.request()

    def go_back(self):
        """Blender has undone or redone something: other UVs are an older map then, and no edit."""
        self.dirty = self._went_back = True

    def close(self, note=""):
        """Ends the link."""
        if note:
            self.notes.append(note)
        self._until = 0
        if self._link is not None:
            self._link.close()

    def tick(self):
        """Takes what has come and sends what has changed."""
        try:
            if self._link is None:
                self._await_studio()
                return
            for message in self._link.poll():
                getattr(self, "_take_" + message.type, lambda _message: None)(message)
            if self.dirty and not self.waiting and time.monotonic() > self._looked + _RESTING:
                self._look()
            if not self._link.is_open:
                self.close("Autocuts has ended the link")
        except (link.LinkError, OSError) as error:
            self.close(str(error))

    # What comes

    def _take_taken(self, message):
        self.waiting = False
        self.notes += message.fields["lost"]
        if message.fields["how"] == "opened":
            self._uv_set = self._uv_name(self.parts)

    def _take_refused(self, message):
        self.waiting = False
        self.notes.append(f"{message.fields['reason']}. {message.fields['remedy']}.")

    def _take_left(self, message):
        self.notes.append(f"Autocuts has another model now: {message.fields['model'] or 'none'}")

    def _take_bye(self, _message):
        self.close("Autocuts was closed")

    def _take_maps(self, message):
        uvs = message.arrays["uvs"]
        if np.isnan(uvs).all():
            return
        if not self._is_ours(message.fields["uvSet"]):
            return
        if any(self._is_there(part) and not self._is_same(part) for part in self.parts):
            self.dirty = True  # the mesh as it is now goes to the studio, and its map comes back
            return
        self.notes += meshdata.write_uvs(self.parts, uvs)
        known = self._single(uvs, self._known.uvs)
        self._lacks_step |= not self._is_restoring and not np.array_equal(known, self._known.uvs)
        self._is_restoring = False
        self._known.uvs = known
        for part in self.parts:
            layer = bpy.data.objects[part.object_name].data.uv_layers.active if self._is_there(part) else None
            part.uv_name = layer.name if layer else part.uv_name
        if self._lacks_step and not message.fields["solving"]:
            self._lacks_step = False
            _push_undo()

    def _is_ours(self, uv_set):
        """True for the UV set that the link is for. In a model that the studio had, that is the one of the first map."""
        self._uv_set = self._uv_set or uv_set
        if uv_set != self._uv_set and uv_set not in self._left_out:
            self._left_out.add(uv_set)
            self.notes.append(f"Maps of {uv_set} stay in Autocuts: this link is for {self._uv_set}")
        return uv_set == self._uv_set

    @staticmethod
    def _uv_name(parts):
        """The name of the UV set that the studio gets."""
        return parts[0].uv_name or "UVMap"

    @staticmethod
    def _single(uvs, before):
        """UVs as Blender stores them; where there are none it keeps what it has."""
        made = uvs.astype(np.float32)
        missing = np.isnan(made)
        return np.where(missing, np.nan_to_num(before) if before.shape == made.shape else 0, made)

    def _is_there(self, part):
        item = bpy.data.objects.get(part.object_name)
        return item is not None and item.type == "MESH"

    @staticmethod
    def _is_same(part):
        return meshdata.topology_of(meshdata.flushed_mesh(bpy.data.objects[part.object_name])) == part.topology

    def _take_marks(self, message):
        given = message.arrays
        nothing = np.empty((0, 2), np.int32)
        cuts, uncuts = (_keys(np.asarray(given.get(name, nothing))) for name in ("cuts", "uncuts"))
        pins, unpins = (np.asarray(given.get(name, ()), dtype=np.int64) for name in ("pins", "unpins"))
        faces = given.get("selection")
        for part, first_vertex, first_face in zip(self.parts, self._first_vertices, self._first_faces):
            if not self._is_there(part) or not self._is_same(part):
                continue
            item = bpy.data.objects[part.object_name]
            self._mark_edges(item, first_vertex, cuts, uncuts)
            own = [
                corners[(corners >= part.first_corner) & (corners < part.first_corner + part.corner_count)]
                - part.first_corner
                for corners in (pins, unpins)
            ]
            if len(own[0]) or len(own[1]):
                self._change_pins(part, item, *own)
            if faces is not None and item.mode == "EDIT":
                _select_faces(item, np.asarray(faces) - first_face)
        known = self._known
        known.cuts = np.union1d(np.setdiff1d(known.cuts, uncuts), cuts)
        if faces is not None:
            known.faces = np.asarray(faces)

    def _change_pins(self, part, item, pins, unpins):
        """Only pins that are in Blender are known: others would be taken for removed here."""
        if api.change_pins(item, part.uv_name, pins, unpins):
            kept = np.setdiff1d(self._known.pins, unpins + part.first_corner)
            self._known.pins = np.union1d(kept, pins + part.first_corner)

    def _take_textures(self, message):
        for told in message.fields["materials"]:
            material = bpy.data.materials.get(told["name"])
            present = _textures(material)
            for channel, path in told["textures"].items():
                if present.get(channel) != path:
                    _set_texture(material, channel, path)
        self._known.materials = self._materials(told["name"] for told in message.fields["materials"])

    @staticmethod
    def _materials(names):
        return [{"name": name, "textures": _textures(bpy.data.materials.get(name))} for name in names]

    @staticmethod
    def _mark_edges(item, first_vertex, cuts, uncuts):
        if not len(cuts) and not len(uncuts):
            return
        mesh = item.data
        keys = _keys(meshdata.values(mesh.edges, "vertices", np.int32, 2) + first_vertex)
        on, off = np.isin(keys, cuts), np.isin(keys, uncuts)
        if item.mode == "EDIT":
            edited = bmesh.from_edit_mesh(mesh)
            edited.edges.ensure_lookup_table()
            for edge in np.flatnonzero(on | off).tolist():
                edited.edges[edge].seam = bool(on[edge])
            bmesh.update_edit_mesh(mesh, loop_triangles=False, destructive=False)
        else:
            mesh.edges.foreach_set("use_seam", (api.seams_of(mesh) | on) & ~off)
            mesh.update()

    # What goes

    def _objects(self):
        return [item for name in self.names if (item := bpy.data.objects.get(name)) and item.type == "MESH"]

    def _model(self):
        return meshdata.model_of(bpy.context, self._objects(), meshdata.Taking())

    def _selected(self, model):
        """The selected faces; None where no object is in edit mode."""
        if not any(item.mode == "EDIT" for item in self._objects()):
            return None
        chosen = [meshdata.values(item.data.polygons, "select", bool) for item in self._objects()]
        return np.flatnonzero(np.concatenate(chosen)).astype(np.int32)

    @staticmethod
    def _described(model):
        """What decides whether a mesh must be sent again."""
        arrays = (model.positions, model.corners, model.face_sizes, model.face_objects, model.face_materials)
        return b"".join(array.tobytes() for array in arrays) + repr((model.names, model.materials)).encode()

    def _look(self):
        """Sends what has changed in Blender."""
        self.dirty = False
        self._looked = time.monotonic()
        if not self._objects():
            self.close("The linked objects are gone")
            return
        model = self._model()
        uvs = model.uvs.astype(np.float32)
        same_corners = uvs.shape == self._known.uvs.shape and b"".join(
            part.topology for part in model.parts
        ) == b"".join(part.topology for part in self.parts)
        went_back, self._went_back = self._went_back, False
        if went_back and same_corners:
            self._known.uvs = uvs
        own_uvs = same_corners and not np.array_equal(uvs, self._known.uvs, equal_nan=True)
        # Changes of marks are said with the numbers that the studio knows.
        if same_corners:
            self._send_marks(model)
            materials = self._materials(model.materials)
            if materials != self._known.materials:
                self._known.materials = materials
                self._link.send_textures(materials)
        if own_uvs or self._described(model) != self._known.mesh:
            self._send_mesh(model, own_uvs, False)
        if went_back:
            self._is_restoring = True
            self._link.request()

    def _marks_of(self, model):
        cuts = np.unique(_keys(_sides(model)[model.cuts]))
        pins = np.flatnonzero(model.pins & np.isfinite(model.uvs).all(axis=1))
        return cuts, pins, self._selected(model)

    def _send_marks(self, model):
        cuts, pins, faces = self._marks_of(model)
        known = self._known
        uvs = model.uvs.astype(np.float32)
        moved = pins[np.isin(pins, known.pins) & (uvs[pins] != known.uvs[pins]).any(axis=1)]
        set_pins = np.union1d(np.setdiff1d(pins, known.pins), moved).astype(np.int64)
        changes = {
            "cuts": _pairs(np.setdiff1d(cuts, known.cuts)),
            "uncuts": _pairs(np.setdiff1d(known.cuts, cuts)),
            "pins": set_pins,
            "pin_uvs": model.uvs[set_pins],
            "unpins": np.setdiff1d(known.pins, pins),
        }
        if faces is not None and not np.array_equal(faces, known.faces):
            changes["selection"] = faces
        if any(len(value) for value in changes.values()) or "selection" in changes:
            self._link.send_marks(**changes)
        known.cuts, known.pins = cuts, pins
        known.faces = faces if faces is not None else known.faces

    def _send_mesh(self, model, own_uvs, opens):
        cuts, pins, faces = self._marks_of(model)
        has_uvs = own_uvs and np.isfinite(model.uvs).any()
        materials = self._materials(model.materials)
        self._link.send_mesh(
            model_name(),
            model.names,
            model.positions,
            model.face_sizes,
            model.corners,
            model.face_objects,
            materials,
            model.face_materials,
            uv_sets=[(self._uv_name(model.parts), model.uvs)] if has_uvs else (),
            cuts=_pairs(cuts),
            pins=pins,
            pin_uvs=model.uvs[pins],
            selection=faces,
            up="z",
            open=opens,
        )
        self.waiting = True
        self.parts = model.parts
        meshes = [item.data for item in self._objects()]
        self._first_vertices = np.cumsum([0] + [len(mesh.vertices) for mesh in meshes])[:-1].tolist()
        self._first_faces = np.cumsum([0] + [len(mesh.polygons) for mesh in meshes])[:-1].tolist()
        self._known = Known(self._described(model), model.uvs.astype(np.float32), cuts, pins, faces, materials)


def _select_faces(item, faces):
    """Selects these faces of a mesh in edit mode, and no others."""
    edited = bmesh.from_edit_mesh(item.data)
    edited.faces.ensure_lookup_table()
    for face in edited.faces:
        face.select_set(False)
    for number in faces[(faces >= 0) & (faces < len(edited.faces))].tolist():
        edited.faces[number].select_set(True)
    edited.select_flush_mode()
    bmesh.update_edit_mesh(item.data, loop_triangles=False, destructive=False)


def _push_undo():
    """Makes what was written a step of Blender's undo, where Blender has a window. Strokes of a brush have their own steps."""
    for window in () if bpy.app.background else bpy.context.window_manager.windows[:1]:
        with bpy.context.temp_override(window=window):
            if bpy.context.mode in {"OBJECT", "EDIT_MESH"} and bpy.ops.ed.undo_push.poll():
                bpy.ops.ed.undo_push(message="Map of Autocuts")


current = None  # the Session


def open_studio(objects, mode, studio):
    """Hands objects over. Ends the link that there was."""
    global current
    end()
    current = Session(objects, mode, studio)
    if not bpy.app.background and not bpy.app.timers.is_registered(_tick):
        bpy.app.timers.register(_tick, first_interval=_EVERY)


def end():
    """Ends the link."""
    if current is not None:
        current.close()


def set_mode(mode):
    """When maps come to the linked objects."""
    if current is not None:
        current.set_mode(mode)


def _tick():
    """For Blender's timer: the time until the next call, or None for never again."""
    if current is None or not current.is_open:
        _redraw()
        return None
    notes = len(current.notes)
    try:
        current.tick()
    except Exception:
        current.close("An error has ended the link: see the console")
        _redraw()
        raise
    if len(current.notes) != notes:
        _redraw()
    return _EVERY


def _redraw():
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            if area.type in {"VIEW_3D", "IMAGE_EDITOR"}:
                area.tag_redraw()


@bpy.app.handlers.persistent
def _changed(*_arguments):
    if current is not None:
        current.dirty = True


@bpy.app.handlers.persistent
def _went_back(*_arguments):
    if current is not None:
        current.go_back()


@bpy.app.handlers.persistent
def _loaded(*_arguments):
    end()


def register():
    bpy.app.handlers.depsgraph_update_post.append(_changed)
    for handlers in (bpy.app.handlers.undo_post, bpy.app.handlers.redo_post):
        handlers.append(_went_back)
    bpy.app.handlers.load_pre.append(_loaded)


def unregister():
    end()
    if bpy.app.timers.is_registered(_tick):
        bpy.app.timers.unregister(_tick)
    bpy.app.handlers.depsgraph_update_post.remove(_changed)
    for handlers in (bpy.app.handlers.undo_post, bpy.app.handlers.redo_post):
        handlers.remove(_went_back)
    bpy.app.handlers.load_pre.remove(_loaded)
