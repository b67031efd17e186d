"""Writes random steering into sessions (.acproj): a CBOR map of blocks, each [size, SHA-256, zlib data]."""
import hashlib
import struct
import zlib


def decode(data, at=0):
    """(value, place after it) of a CBOR item of definite length."""
    major, low = data[at] >> 5, data[at] & 31
    at += 1
    if major == 7:
        if low in (20, 21, 22):
            return {20: False, 21: True, 22: None}[low], at
        size, form = {25: (2, ">e"), 26: (4, ">f"), 27: (8, ">d")}[low]
        return struct.unpack(form, data[at:at + size])[0], at + size
    value = low
    if low >= 24:
        size = 1 << (low - 24)
        value = int.from_bytes(data[at:at + size], "big")
        at += size
    if major == 0:
        return value, at
    if major == 1:
        return -1 - value, at
    if major in (2, 3):
        chunk = data[at:at + value]
        return (bytes(chunk) if major == 2 else chunk.decode()), at + value
    items = []
    for _ in range(value * (major - 3)):
        item, at = decode(data, at)
        items.append(item)
    return (items if major == 4 else dict(zip(items[::2], items[1::2]))), at


def head(major, value):
    if value < 24:
        return bytes([major << 5 | value])
    size = next(s for s in (1, 2, 4, 8) if value < 1 << (8 * s))
    return bytes([major << 5 | 24 + size.bit_length() - 1]) + value.to_bytes(size, "big")


def encode(value):
    if isinstance(value, bool):
        return b"\xf5" if value else b"\xf4"
    if value is None:
        return b"\xf6"
    if isinstance(value, int):
        return head(0, value) if value >= 0 else head(1, -1 - value)
    if isinstance(value, float):
        return b"\xfb" + struct.pack(">d", value)
    if isinstance(value, bytes):
        return head(2, len(value)) + value
    if isinstance(value, str):
        return head(3, len(value.encode())) + value.encode()
    if isinstance(value, list):
        return head(4, len(value)) + b"".join(map(encode, value))
    return head(5, len(value)) + b"".join(encode(k) + encode(v) for k, v in value.items())


def blocks_of(session):
    """{name: content} of a session; format and version come first, as they are."""
    blocks = decode(session)[0]
    for name, block in blocks.items():
        if isinstance(block, list):
            size, _, data = block
            blocks[name] = data if len(data) == size else zlib.decompress(data)
    return blocks


def session_of(blocks):
    result = {}
    for name, content in blocks.items():
        if isinstance(content, bytes):
            size, data = len(content), zlib.compress(content)
            if len(data) >= size:
                data = content
            checksum = hashlib.sha256(name.encode() + struct.pack("<q", size) + data).digest()
            content = [size, checksum, data]
        result[name] = content
    return encode(result)


def packed(form, values):
    """Little-endian numbers, all first bytes before all second bytes and so on."""
    raw = [struct.pack(form, v) for v in values]
    return bytes(r[k] for k in range(struct.calcsize(form)) for r in raw)


def inner_edges(faces):
    """The pairs of corners at which the two sides of an edge start, corners counted over all faces."""
    starts, edges, corner = {}, [], 0
    for face in faces:
        for i, a in enumerate(face):
            b = face[(i + 1) % len(face)]
            if (b, a) in starts:
                edges.append((starts[b, a], corner + i))
            starts[a, b] = corner + i
        corner += len(face)
    return edges


def steer(rng, session, faces):
    """The session with random cuts, joins, weights, pins and rectangles. \\param faces as in its OBJ file"""
    odd_share = rng.choice([0, 0, 0, 0, 0.1])

    def odd(usual):
        """The usual number, or in some sessions one that a file should not hold."""
        return usual if rng.random() >= odd_share else rng.choice([0.0, -1.0, 1e300, 1e-300, float("nan"), float("inf")])

    blocks = blocks_of(session)
    edges = [e for e in inner_edges(faces) if rng.random() < rng.choice([0.05, 0.3])]
    states, weights = [], []
    for _ in edges:
        state = rng.choice([0, 0, 1, 2])
        both = rng.random() < 0.9
        states += [state, state if both else rng.randrange(3)]
        weights += 2 * [odd(rng.choice([1.0, 0.0, 0.2, 5.0]))]
    blocks["seams"] = encode({"sides": packed("<i", [c for e in edges for c in e]), "states": bytes(states),
                              "weights": packed("<d", weights)})
    corners = sorted(rng.sample(range(sum(map(len, faces))), rng.choice([0, 0, 1, 2, 5, 10])
                                if len(faces) > 2 else 0))
    pins = [{"corner": c, "position": [odd(rng.random()), odd(rng.random())],
             "hard": rng.random() < 0.7, "weight": odd(1.0)} for c in corners]
    rectangles = []
    for number in range(rng.choice([0, 0, 1, 3])):
        x, y = rng.random() * 0.7, rng.random() * 0.7
        chosen = [f for f in range(len(faces)) if rng.random() < 0.2]
        rectangles.append({"id": number + 1, "name": "R%d" % number, "color": 4282417407,
                           "lower": [x, y], "upper": [x + odd(0.3), y + 0.3], "hard": rng.random() < 0.5,
                           "weight": odd(1.0), "faces": struct.pack("<%di" % len(chosen), *chosen)})
    blocks["constraints"] = encode({"pins": pins, "rectangles": rectangles})
    return session_of(blocks)


def mutated(rng, value):
    """A tree with one of its values exchanged, left out, doubled or put deeper."""
    inside = isinstance(value, (list, dict)) and value and rng.random() < 0.85
    if inside and isinstance(value, list):
        i = rng.randrange(len(value))
        return value[:i] + rng.choice([[], [value[i]] * 2, [mutated(rng, value[i])], [mutated(rng, value[i])]]) + value[i + 1:]
    if inside:
        key = rng.choice(sorted(value, key=str))
        changed = {**value, key: mutated(rng, value[key])}
        if rng.random() < 0.15:
            del changed[key]
        return changed
    return rng.choice([None, True, 0, -1, 1 << 31, (1 << 63) - 1, -(1 << 63), float("nan"), float("inf"), 1e300, "", "\0",
                       "x" * 10_000, b"", b"\xff" * 7, [], {}, [[[value]]], {"": value}])


def damage(rng, session):
    """Changes the tree or the bytes inside a block and makes its checksum right again, so that the readers behind it
    are reached."""
    blocks = blocks_of(session)
    names = [n for n, c in blocks.items() if isinstance(c, bytes) and c]
    name = rng.choice(names)
    try:
        tree, end = decode(blocks[name])
    except (KeyError, ValueError, IndexError, struct.error, RecursionError, TypeError):
        tree, end = None, -1
    if end == len(blocks[name]) and rng.random() < 0.7:
        for _ in range(rng.choice([1, 1, 3])):
            tree = mutated(rng, tree)
        blocks[name] = encode(tree)
        return session_of(blocks)
    content = bytearray(blocks[name])
    for _ in range(rng.choice([1, 1, 3, 10])):
        i = rng.randrange(len(content))
        content[i] = rng.choice([0, 255, rng.randrange(256), content[i] ^ 1 << rng.randrange(8)])
    blocks[name] = bytes(content)
    return session_of(blocks)
