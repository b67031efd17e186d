"""The live link: hand a mesh to a running studio, and get its map back while it is being made.

    with link.connect(model="chair.blend") as studio:
        studio.send_mesh("chair.blend", ["Chair"], positions, sizes, corners, open=True)
        studio.want("live")
        maps = studio.wait_for("maps")
        uvs = maps.arrays["uvs"]

`python3 -m autocuts.link MODEL -o OUT` does that for a file; it needs NumPy and the rest of the package. Without them this
file needs nothing but Python 3.8: bridges for other programs may carry a copy of it. With NumPy, arrays are NumPy's;
without it, rows of several numbers are tuples in a list. docs/link.md describes the protocol.
"""

import argparse
import array
import json
import os
import select
import socket
import struct
import subprocess
import sys
import tempfile
import time

try:
    import numpy
except ImportError:
    numpy = None

VERSION = 1
_HEAD = struct.Struct("<II")  # bytes of the fields, bytes of the arrays
_MOST_FIELDS, _MOST_ARRAYS = 4 << 20, 1 << 30  # bytes; docs/link.md
_AT_ONCE = 1 << 20  # bytes
_DYING, _DYING_LOOKS = 0.02, 50  # seconds between two looks at a studio that is being killed, and how many
_CODES = {"i4": "i", "f4": "f", "f8": "d"}
#: Per array that is sent: kind and columns.
_SENT = {
    "positions": ("f8", 3),
    "pinUvs": ("f8", 2),
    "cuts": ("i4", 2),
    "uncuts": ("i4", 2),
}


class LinkError(Exception):
    """The studio is not there, refuses, or sends what cannot be read. The text is for the user."""


class NoAnswer(LinkError):
    """The studio is there, and has said nothing in time."""


class Ended(LinkError):
    """The studio has ended, or closed the link."""

    def __init__(self):
        super().__init__("The link to the studio has ended. Open the model in Autocuts again.")


class Message:
    """What came over the link: its type, its fields and its arrays by name."""

    def __init__(self, kind, fields, arrays):
        self.type = kind
        self.fields = fields
        self.arrays = arrays

    def __repr__(self):
        return f"Message({self.type!r}, {self.fields!r}, arrays={sorted(self.arrays)})"


def _bytes_of(values, kind, columns):
    """Rows and bytes of an array."""
    if numpy is not None:
        made = numpy.ascontiguousarray(values, dtype="<" + kind)
        return made.size // columns, made.tobytes()
    rows = list(values)
    flat = rows if columns == 1 or not hasattr(rows[0] if rows else 0, "__len__") else [x for row in rows for x in row]
    made = array.array(_CODES[kind], flat)
    if sys.byteorder == "big":
        made.byteswap()
    return len(made) // columns, made.tobytes()


def _values_of(data, kind, columns):
    """The inverse of _bytes_of()."""
    if numpy is not None:
        made = numpy.frombuffer(data, "<" + kind)
        return made.reshape(-1, columns) if columns > 1 else made
    made = array.array(_CODES[kind])
    made.frombytes(data)
    if sys.byteorder == "big":
        made.byteswap()
    return made if columns == 1 else list(zip(*[iter(made)] * columns))


def encode(kind, fields, arrays):
    """The bytes of a message. arrays: by name, each (values, kind of number, columns)."""
    described, content = [], []
    for name, (values, number, columns) in arrays.items():
        rows, data = _bytes_of(values, number, columns)
        described.append({"name": name, "kind": number, "shape": [rows, columns]})
        content.append(data)
    text = json.dumps({**fields, "type": kind, "arrays": described}).encode()
    content = b"".join(content)
    return _HEAD.pack(len(text), len(content)) + text + content


def decode(text, content):
    """The message of a frame."""
    fields = json.loads(text)
    arrays, offset = {}, 0
    for one in fields.pop("arrays", ()):
        rows, columns = (one["shape"] + [1])[:2]
        end = offset + rows * columns * int(one["kind"][1])
        arrays[one["name"]] = _values_of(content[offset:end], one["kind"], columns)
        offset = end
    return Message(fields.pop("type"), fields, arrays)


def user_folder():
    """The folder of the places of all studios of the user."""
    runtime = os.environ.get("XDG_RUNTIME_DIR")
    if not runtime:
        user = os.environ.get("USER") or os.environ.get("LOGNAME") or str(os.getuid())
        runtime = os.path.join(tempfile.gettempdir(), "runtime-" + user)
    return os.path.join(runtime, "autocuts")


class Place:
    """Where a studio listens, as its file says."""

    def __init__(self, path):
        self.path = path
        with open(path, encoding="utf-8") as file:
            told = json.load(file)
        self.version, self.socket, self.token = told["version"], told["socket"], told["token"]
        self.process, self.model = told["process"], told["model"]

    def forget(self):
        """Removes what a studio that was killed has left behind, by its own name: the file may say anything."""
        for path in (self.path, self.path[:-5] + ".socket"):
            try:
                os.remove(path)
            except OSError:
                pass


def _is_own(folder):
    """True when only this user can write to a folder and read it, as the studio makes it."""
    try:
        found = os.stat(folder)
    except OSError:
        return False
    return found.st_uid == os.getuid() and not found.st_mode & 0o077


def places(folder=None):
    """The places of all studios, also of those that were killed, the newest first. None in a folder of others."""
    folder = folder or user_folder()
    found = []
    for name in os.listdir(folder) if _is_own(folder) else ():
        if name.startswith("studio-") and name.endswith(".json"):
            try:
                path = os.path.join(folder, name)
                found.append((os.path.getmtime(path), Place(path)))
            except (OSError, ValueError, KeyError):
                continue  # it ends just now, or is no place
    return [place for _, place in sorted(found, key=lambda one: one[0], reverse=True)]


class Link:
    """A link to one studio. Nothing here waits, but for what says so and has a timeout."""

    def __init__(self, place, program="Python", timeout=10):
        """Connects. Raises LinkError when the studio refuses, OSError when there is none."""
        self.place = place
        self.serial = 0  # of the mesh that was sent last
        self.process = None  # of a studio that was started for it
        self._in, self._out = bytearray(), bytearray()
        self._kept = []  # messages that came behind the one that was waited for
        self._socket = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        try:
            self._socket.settimeout(timeout)
            self._socket.connect(place.socket)
            self._socket.setblocking(False)
            hello = {"version": VERSION, "token": place.token, "program": program, "process": os.getpid()}
            self._send(encode("hello", hello, {}))
            self.welcome = self.wait_for("welcome", timeout=timeout)
        except BaseException:
            self.close()
            raise

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    @property
    def is_open(self):
        """False when the link has ended."""
        return self._socket is not None

    def close(self):
        """Ends the link."""
        if self._socket is not None:
            try:
                self._send(encode("bye", {}, {}))
            except (LinkError, OSError):
                pass
            self._drop()

    def _drop(self):
        if self._socket is not None:
            self._socket.close()
            self._socket = None

    def send(self, kind, fields=None, arrays=None):
        """Sends a message. arrays: as encode() takes them."""
        self._send(encode(kind, fields or {}, arrays or {}))

    def _send(self, data):
        if self._socket is None:
            raise Ended()
        self._out += data
        self._write()

    def _write(self):
        """Writes as much as the studio takes now; poll() goes on with the rest."""
        while self._out:
            try:
                sent = self._socket.send(memoryview(self._out)[:_AT_ONCE])
            except BlockingIOError:
                return
            except OSError:
                self._out.clear()  # what the studio said last can still be read
                return
            del self._out[:sent]

    def send_mesh(
        self,
        model,
        objects,
        positions,
        sizes,
        corners,
        face_objects=None,
        materials=(),
        face_materials=None,
        uv_sets=(),
        cuts=(),
        pins=(),
        pin_uvs=(),
        selection=None,
        up="y",
        open=False,
    ):
        """Hands a mesh over; "taken" or "refused" comes back. Returns its serial number.

        model: a name that stays the same when the model changes, such as the path of its file. objects: names.
        positions: (V, 3). sizes: corners per face. corners: the vertices of the faces, one after the other.
        materials: names, or dicts with "name" and "textures" (channel: path). uv_sets: pairs of a name and (C, 2)
        UVs, the active set first; leave them out when they are those that the studio sent. cuts: (N, 2) vertices of
        edges that are always seams. pins: corners, held at pin_uvs. up: "y" or "z". open: the user wants this model
        in the studio, in place of another one.
        """
        self.serial += 1
        fields = {
            "serial": self.serial,
            "model": model,
            "objects": list(objects),
            "materials": [{"name": one} if isinstance(one, str) else one for one in materials],
            "uvSets": [name for name, _ in uv_sets],
            "up": up,
            "open": open,
        }
        arrays = {
            "positions": (positions, "f8", 3),
            "sizes": (sizes, "i4", 1),
            "corners": (corners, "i4", 1),
        }
        for name, values in (("faceObjects", face_objects), ("faceMaterials", face_materials)):
            if values is not None:
                arrays[name] = (values, "i4", 1)
        for number, (_, uvs) in enumerate(uv_sets):
            arrays[f"uvs{number}"] = (uvs, "f8", 2)
        self.send("mesh", fields, {**arrays, **self._marks(cuts, (), pins, pin_uvs, (), selection)})
        return self.serial

    def send_marks(self, cuts=(), uncuts=(), pins=(), pin_uvs=(), unpins=(), selection=None):
        """Says what has changed on the mesh that was sent last; see send_mesh(). uncuts: edges that are no longer
        always seams. unpins: corners."""
        self.send("marks", {"serial": self.serial}, self._marks(cuts, uncuts, pins, pin_uvs, unpins, selection))

    def send_textures(self, materials):
        """Says which pictures materials have now; see send_mesh()."""
        self.send("textures", {"serial": self.serial, "materials": list(materials)})

    @staticmethod
    def _marks(cuts, uncuts, pins, pin_uvs, unpins, selection):
        given = {"cuts": cuts, "uncuts": uncuts, "pins": pins, "pinUvs": pin_uvs, "unpins": unpins}
        arrays = {name: (values, *_SENT.get(name, ("i4", 1))) for name, values in given.items() if len(values)}
        if selection is not None:
            arrays["selection"] = (selection, "i4", 1)
        return arrays

    def want(self, mode):
        """When maps come: "live", on "pause", or on "request" only."""
        self.send("want", {"mode": mode})

    def request(self):
        """Asks for the newest map now."""
        self.send("send")

    def poll(self):
        """The messages that have come. Those about a mesh before the last one are left out."""
        messages, self._kept = self._kept, []
        if self._socket is None:
            return messages
        self._write()
        messages += self._taken()
        while self._socket is not None:
            try:
                data = self._socket.recv(_AT_ONCE)
            except BlockingIOError:
                break
            except OSError:
                data = b""
            if not data:
                self._drop()
            self._in += data
        return messages + self._taken()

    def _taken(self):
        """The whole messages among the bytes that have come."""
        messages, at = [], 0
        while len(self._in) - at >= _HEAD.size:
            fields, arrays = _HEAD.unpack_from(self._in, at)
            if fields > _MOST_FIELDS or arrays > _MOST_ARRAYS:
                self._drop()
                raise LinkError("The studio sent what cannot be read. Use programs of the same version.")
            start = at + _HEAD.size
            if len(self._in) < start + fields + arrays:
                break
            at = start + fields + arrays
            message = decode(bytes(self._in[start : start + fields]), bytes(self._in[start + fields : at]))
            if message.type not in ("maps", "marks", "textures") or message.fields.get("serial") == self.serial:
                messages.append(message)
        del self._in[:at]
        return messages

    def receive(self, timeout):
        """Waits at most `timeout` seconds. Returns the messages that have come, none when nothing came."""
        until = time.monotonic() + timeout
        messages = self.poll()
        while not messages and self._socket is not None:
            left = until - time.monotonic()
            if left <= 0:
                break
            select.select([self._socket], [self._socket] if self._out else [], [], left)
            messages = self.poll()
        return messages

    def wait_for(self, kind, timeout=60, heard=None):
        """Waits for a message of a type; what comes behind it is left for later. Raises LinkError when the studio
        refuses, when the link ends, and after `timeout` seconds. heard: a list that gets the messages before it;
        None: they are forgotten."""
        until = time.monotonic() + timeout
        while True:
            messages = self.receive(max(0, until - time.monotonic()))
            for number, message in enumerate(messages):
                if message.type in ("refused", kind):
                    self._kept = messages[number + 1 :]
                if message.type == "refused":
                    raise LinkError(f"{message.fields['reason']}. {message.fields['remedy']}.")
                if message.type == kind:
                    return message
                if heard is not None:
                    heard.append(message)
            if self._socket is None:
                raise Ended()
            if time.monotonic() >= until:
                raise NoAnswer(f"The studio did not answer within {timeout} s.")


def _gone(error):
    return isinstance(error, (ConnectionRefusedError, FileNotFoundError))


def _linked(place, program, timeout):
    """The link to this studio. One that is just being killed takes the connection and closes it: it is asked again,
    until it is gone."""
    for _ in range(_DYING_LOOKS):
        try:
            return Link(place, program, timeout)
        except Ended:
            time.sleep(_DYING)
    return Link(place, program, timeout)


def connect(model=None, program="Python", folder=None, timeout=10, any_model=True):
    """Links to the studio that has this model open; else to one without a model; else to the newest one, or to none
    without any_model. Places of studios that were killed are removed. `timeout` is for each studio; one that refuses is
    passed over. Raises LinkError when there is none."""
    found = [place for place in places(folder) if any_model or place.model in ("", model)]
    found.sort(key=lambda place: 0 if model and place.model == model else 1 if not place.model else 2)
    refusal = None
    for place in found:
        try:
            return _linked(place, program, timeout)
        except LinkError as error:
            refusal = refusal or error
        except OSError as error:
            if _gone(error):
                place.forget()
    raise refusal or LinkError("No studio of Autocuts runs. Start it, and let other programs in (Preferences).")


def started_studio(process, program="Python", folder=None, timeout=10):
    """Links to the studio that was started as this process. None while it does not listen, or is too busy to answer."""
    for place in places(folder):
        if place.process == process.pid:
            try:
                studio = Link(place, program, timeout)
            except NoAnswer:
                return None
            studio.process = process
            return studio
    return None


def start_studio(command=("autocuts",), folder=None, timeout=60, program="Python"):
    """Starts a studio and links to it."""
    process = subprocess.Popen(list(command), stdin=subprocess.DEVNULL)
    until = time.monotonic() + timeout
    while time.monotonic() < until and process.poll() is None:
        studio = started_studio(process, program, folder, timeout)
        if studio is not None:
            return studio
        time.sleep(0.05)
    raise LinkError("The studio has not started. Start it yourself and try again.")


def _hand_file(studio, mesh, path):
    """Hands a Mesh of the package over, as what the user wants to see. A studio that has this file keeps its map."""
    model = os.path.abspath(path)
    is_there = studio.welcome.fields["model"] == model
    numbers = [] if mesh.objects is None else sorted(set(mesh.objects.tolist()))
    names = list(mesh.object_names) or [os.path.basename(path)]
    names += [f"object {number}" for number in range(len(names), max(numbers, default=0) + 1)]
    materials = mesh.materials if mesh.material_names else None
    own = [] if mesh.uvs is None else [("UVMap", mesh.uvs)]
    for uv_sets in ([], own) if is_there and own else (own,):
        studio.send_mesh(
            model,
            names,
            mesh.positions,
            mesh.sizes(),
            numpy.ravel(mesh.faces),
            mesh.objects,
            mesh.material_names,
            materials,
            uv_sets=uv_sets,
            open=True,
        )
        taken = studio.wait_for("taken").fields
        for line in taken["lost"]:
            print(line, file=sys.stderr)
        if taken["how"] != "opened":
            return  # else its objects have other names there: it has been opened anew, without a map


def _run(choice):
    from autocuts import Mesh

    mesh = Mesh.load(choice.model)
    if choice.start:
        studio = start_studio((choice.studio,), program="autocuts.link")
    else:
        studio = connect(os.path.abspath(choice.model), "autocuts.link")
    with studio:
        studio.want("live" if choice.watch == "live" else "pause")
        _hand_file(studio, mesh, choice.model)
        while True:
            maps = studio.wait_for("maps", timeout=choice.timeout)
            mesh.uvs = maps.arrays["uvs"]
            mesh.save(choice.output)
            print(f"{choice.output}: {len(maps.arrays['seams'])} edges are seams")
            if not choice.watch:
                return


def main(arguments):
    """The command line: hands a file to the studio and writes the map that comes back. Returns an exit code."""
    options = argparse.ArgumentParser(prog="python3 -m autocuts.link", description=main.__doc__.split(". Returns")[0])
    options.add_argument("model", help="a mesh in any format that autocuts-cli reads")
    options.add_argument("-o", "--output", required=True, help="the mesh with the map")
    options.add_argument("--watch", choices=("pause", "live"), help="write each map, until the studio ends the link")
    options.add_argument("--start", action="store_true", help="start a studio, in place of one that runs")
    options.add_argument("--studio", default="autocuts", help="the program for --start (autocuts)")
    options.add_argument("--timeout", type=float, default=86400, metavar="SECONDS", help="how long to wait for a map (a day)")
    try:
        _run(options.parse_args(arguments))
    except (LinkError, OSError, ValueError) as error:
        print(f"autocuts.link: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return 130
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
