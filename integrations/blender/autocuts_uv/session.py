"""Sessions (.acproj), the format in which a model goes to autocuts-cli and back.

A session holds what no model file does: seams, pins, weights, and UVs at full precision. The format is one CBOR map of
blocks, each with its size, a checksum and its content.
"""

import hashlib
import struct
import zlib

import numpy as np

from . import figures

_VERSION = 2
_CUT = 1


def _head(major, value):
    for code, form, limit in ((24, "B", 1 << 8), (25, ">H", 1 << 16), (26, ">I", 1 << 32), (27, ">Q", 1 << 64)):
        if value < 24:
            return bytes([major << 5 | value])
        if value < limit:
            return bytes([major << 5 | code]) + struct.pack(form, value)
    raise OverflowError(value)


def encode(value):
    """The CBOR bytes of a bool, int, float, text, bytes, list or dict."""
    if isinstance(value, bool):
        return b"\xf5" if value else b"\xf4"
    if isinstance(value, int):
        return _head(0, value) if value >= 0 else _head(1, -1 - value)
    if isinstance(value, float):
        return b"\xfb" + struct.pack(">d", value)
    if isinstance(value, bytes):
        return _head(2, len(value)) + value
    if isinstance(value, str):
        text = value.encode()
        return _head(3, len(text)) + text
    if isinstance(value, list):
        return _head(4, len(value)) + b"".join(encode(item) for item in value)
    items = (encode(key) + encode(item) for key, item in value.items())
    return _head(5, len(value)) + b"".join(items)


class _Decoder:
    """Reads one CBOR value from bytes."""

    def __init__(self, data):
        self._data = data
        self._at = 0

    def _take(self, count):
        self._at += count
        if self._at > len(self._data):
            raise ValueError("the session is cut off")
        return self._data[self._at - count : self._at]

    def value(self):
        first = self._take(1)[0]
        major, info = first >> 5, first & 31
        if major == 7:
            return self._simple(info)
        number = info
        if info >= 24:
            number = int.from_bytes(self._take(1 << (info - 24)), "big")
        if major <= 1:
            return number if major == 0 else -1 - number
        if major <= 3:
            raw = bytes(self._take(number))
            return raw if major == 2 else raw.decode()
        if major == 4:
            return [self.value() for _ in range(number)]
        return {self.value(): self.value() for _ in range(number)}

    def _simple(self, info):
        if info in (20, 21):
            return info == 21
        if info in (25, 26, 27):
            form = {25: ">e", 26: ">f", 27: ">d"}[info]
            return struct.unpack(form, self._take(struct.calcsize(form)))[0]
        return None


def decode(data):
    """The value of CBOR bytes, see encode()."""
    return _Decoder(memoryview(data)).value()


def packed(values, kind):
    """Bytes of an array of kind "<i4" or "<f8": all lowest bytes first, then the next ones."""
    array = np.ascontiguousarray(values, dtype=kind)
    return array.view(np.uint8).reshape(-1, array.itemsize).T.tobytes()


def unpacked(data, kind):
    """The array that packed() made bytes of."""
    size = np.dtype(kind).itemsize
    planes = np.frombuffer(data, np.uint8).reshape(size, -1)
    return np.ascontiguousarray(planes.T).view(kind).ravel()


def _uv_block(model):
    """UVs with one entry for each run of equal UVs among the corners of a vertex."""
    order = np.argsort(model.corners, kind="stable")
    uvs = model.uvs[order]
    bits = np.ascontiguousarray(uvs).view(np.uint64)
    repeats = np.zeros(len(order), dtype=bool)
    repeats[1:] = (bits[1:] == bits[:-1]).all(axis=1)
    return {
        "name": "UVMap",
        "scale": figures.layout_scale(model),
        "repeats": np.packbits(repeats, bitorder="little").tobytes(),
        "u": packed(uvs[~repeats, 0], "<f8"),
        "v": packed(uvs[~repeats, 1], "<f8"),
    }


def _uvs_of(block, corners):
    """UVs of each corner, the inverse of _uv_block()."""
    order = np.argsort(corners, kind="stable")
    bits = np.frombuffer(block["repeats"], np.uint8)
    repeats = np.unpackbits(bits, count=len(order), bitorder="little").astype(bool)
    entry = np.cumsum(~repeats) - 1
    uvs = np.empty((len(order), 2))
    uvs[order, 0] = unpacked(block["u"], "<f8")[entry]
    uvs[order, 1] = unpacked(block["v"], "<f8")[entry]
    return uvs


def _seam_block(model):
    """Cut edges and their weights, each edge by the corners at which its two sides start."""
    pairs = model.side_pairs()
    cut = model.cuts[pairs].any(axis=1)
    weights = np.ones(pairs.shape) if model.seam_weights is None else model.seam_weights[pairs]
    told = cut | (weights != 1).any(axis=1)
    states = np.repeat(np.where(cut[told], _CUT, 0).astype(np.uint8), 2)
    return {
        "sides": packed(pairs[told].ravel(), "<i4"),
        "states": states.tobytes(),
        "weights": packed(weights[told].ravel(), "<f8"),
        "straight": bytes(len(states)),
    }


def _hard_sides(model):
    pairs = model.side_pairs()
    hard = np.zeros(len(model.corners), dtype=bool)
    hard[pairs[model.hard[pairs[:, 0]], 0]] = True
    return np.packbits(hard, bitorder="little").tobytes()


def _polygon_block(model):
    return {
        "positions": packed(model.positions.ravel(), "<f8"),
        "faceSizes": packed(model.face_sizes, "<i4"),
        "corners": packed(model.corners, "<i4"),
        "faceObjects": packed(model.face_objects, "<i4"),
        "hardSides": _hard_sides(model),
    }


def _scene_block(model, materials, face_materials):
    counts = [len(model.positions), len(model.face_sizes), len(model.corners)]
    return {
        "path": "",
        "format": "",
        "counts": packed(counts, "<i4"),
        "objects": list(model.names),
        "materials": list(materials),
        "faceMaterial": packed(face_materials, "<i4"),
        "notes": [],
    }


def _pin_list(model):
    return [
        {"corner": int(corner), "position": model.uvs[corner].tolist(), "hard": True, "weight": 1.0}
        for corner in np.flatnonzero(model.pins)
    ]


def _blocks(model, materials, face_materials):
    blocks = {
        "polygons": _polygon_block(model),
        "scene": _scene_block(model, materials, face_materials),
        "uvSets": {"count": 1, "active": 0},
        "uv.0": _uv_block(model),
        "seams": _seam_block(model),
        "constraints": {"pins": _pin_list(model), "rectangles": []},
        "marks": {"faces": b"", "flags": b"", "tags": []},
        "settings": {"solve": {}, "packing": {}},
        "selection": {"mode": 0, "faces": b"", "sides": b"", "corners": b""},
    }
    if model.texel_weights is not None:
        faces = np.flatnonzero(model.texel_weights != 1)
        blocks["texelWeights"] = {
            "faces": packed(faces, "<i4"),
            "weights": packed(model.texel_weights[faces], "<f8"),
        }
    contents = {name: encode(block) for name, block in blocks.items()}
    contents.update(view=b"", thumbnail=b"", sessionPath=b"")
    return contents


def write(path, model, materials, face_materials):
    """Writes a Model with materials: their names, and of each face its number or -1."""
    parts = {"format": "autocuts-project", "version": _VERSION}
    for name, content in _blocks(model, materials, face_materials).items():
        summed = hashlib.sha256(name.encode() + struct.pack("<q", len(content)) + content)
        parts[name] = [len(content), summed.digest(), content]
    with open(path, "wb") as file:
        file.write(encode(parts))


def read_uvs(path, corners):
    """The UVs of a session, (corners, 2), of a mesh with these vertices of corners."""
    with open(path, "rb") as file:
        parts = decode(file.read())
    size, _, content = parts["uv.0"]
    if size != len(content):
        content = zlib.decompress(content)
    return _uvs_of(decode(content), corners)
