"""Makes odd meshes as the lines of OBJ files: valid by the letter, and what no artist would make on purpose."""
import math


def grid(rng, size=None, triangles=False):
    """A wavy sheet of quads or triangles, with UVs in half of the cases."""
    n = size or rng.randint(1, 12)
    points = [(x, y, 0.4 * math.sin(x) * math.cos(1.3 * y)) for y in range(n + 1) for x in range(n + 1)]
    faces = []
    for y in range(n):
        for x in range(n):
            a = y * (n + 1) + x + 1
            quad = [a, a + 1, a + n + 2, a + n + 1]
            faces += [quad[:3], [quad[0], quad[2], quad[3]]] if triangles else [quad]
    return points, faces


def box(rng):
    s = [rng.uniform(0.1, 4) for _ in range(3)]
    points = [(x * s[0], y * s[1], z * s[2]) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
    return points, [[1, 3, 4, 2], [5, 6, 8, 7], [1, 2, 6, 5], [3, 7, 8, 4], [1, 5, 7, 3], [2, 4, 8, 6]]


def tetrahedra(rng):
    """Random triangles between few points: edges of many faces, pinched vertices, doubled and folded faces."""
    n = rng.randint(4, 12)
    points = [tuple(rng.gauss(0, 1) for _ in range(3)) for _ in range(n)]
    return points, [rng.sample(range(1, n + 1), 3) for _ in range(rng.randint(1, 40))]


def ring(rng, n, wobble):
    return [((1 - wobble * rng.random()) * math.cos(2 * math.pi * i / n),
             (1 - wobble * rng.random()) * math.sin(2 * math.pi * i / n), wobble * rng.gauss(0, 0.1))
            for i in range(n)]


def many_gon(rng):
    n = rng.choice([5, 8, 30, 300, 3000])
    return ring(rng, n, rng.choice([0, 0.1, 0.9])), [list(range(1, n + 1))]


def odd_polygon(rng):
    """A cube or sheet with a polygon that visits corners twice, crosses or touches itself."""
    points, faces = box(rng) if rng.random() < 0.5 else grid(rng, 3)
    face = list(rng.choice(faces))
    kind = rng.randrange(6)
    if kind == 0:  # spur: there and back
        i = rng.randrange(len(face))
        points.append(tuple(rng.gauss(0, 1) for _ in range(3)))
        face[i + 1:i + 1] = [len(points), face[i]]
    elif kind == 1:  # spur along a side
        i = rng.randrange(len(face))
        face[i + 1:i + 1] = [face[(i + 1) % len(face)], face[i]]
    elif kind == 2:  # two corners in one place
        i, k = rng.sample(range(len(face)), 2)
        points.append(points[face[i] - 1])
        face[k] = len(points)
    elif kind == 3:  # bow-tie
        face[0], face[1] = face[1], face[0]
    elif kind == 4:  # touches itself in a corner
        face += [len(points) + 1, len(points) + 2, face[0], len(points) + 3]
        points += [tuple(rng.gauss(0, 1) for _ in range(3)) for _ in range(3)]
    else:  # any walk over the corners
        face = [rng.randint(1, len(points)) for _ in range(rng.randint(3, 9))]
    faces[rng.randrange(len(faces))] = face
    return points, faces


def scaled(rng):
    points, faces = box(rng)
    scale = 10.0 ** rng.choice([-40, -12, -6, -3, 3, 6, 12, 40, 60, 149])
    count = len(points)
    offset = rng.choice([0, 1, 1e6])
    points += [tuple(scale * c + offset for c in p) for p in points]
    faces += [[c + count for c in f] for f in faces]
    return points, faces


def flat_parts(rng):
    """Faces without area: corners in one place or on one line."""
    points, faces = grid(rng, 4, rng.random() < 0.5)
    for _ in range(rng.randint(1, len(points))):
        i, k = rng.randrange(len(points)), rng.randrange(len(points))
        points[i] = rng.choice([points[k], tuple((a + b) / 2 for a, b in zip(points[i], points[k]))])
    return points, faces


def bad_numbers(rng):
    points, faces = box(rng)
    i = rng.randrange(len(points))
    point = list(points[i])
    point[rng.randrange(3)] = rng.choice(["nan", "inf", "-inf", "1e999", "1e151", "-0", "1e-320", "0x10", "1,5"])
    points[i] = point
    return points, faces


def parts(rng):
    points, faces = [], []
    for k in range(rng.randint(2, 30)):
        p, f = rng.choice([box, grid])(rng)
        faces += [[c + len(points) for c in face] for face in f]
        points += [(x + 10 * k, y, z) for x, y, z in p]
    return points, faces


def lines_of(rng, points, faces, uv=False):
    """OBJ lines; with odd names, long lines, comments and continued lines now and then."""
    lines = [b"v " + b" ".join(str(c).encode() for c in p) for p in points]
    if uv:
        lines += [b"vt %.6f %.6f" % (rng.random(), rng.random()) for _ in points]
    name = rng.choice(["part", "Körper 体", "a" * 5000, "", "..", "%s%n", "name # no comment", "\u202e"])
    for i, face in enumerate(faces):
        if i % 7 == 0 and rng.random() < 0.2:
            lines.append(rng.choice(["o ", "g ", "usemtl ", "# "]).encode() + name.encode())
        words = [b"%d/%d" % (c, c) if uv else b"%d" % c for c in face]
        joint = b" \\\n " if rng.random() < 0.02 else b" "
        lines.append(b"f " + joint.join(words))
    return lines


MAKERS = [grid, box, tetrahedra, many_gon, odd_polygon, scaled, flat_parts, bad_numbers, parts]
# Of these a new map has no overlaps; the polygons of the others may overlap themselves, and are never cut.
SOUND = [grid, box, tetrahedra, parts]


def any_mesh(rng):
    """(name of the maker, whether its maps must be without overlaps, lines)"""
    maker = rng.choice(MAKERS)
    return maker.__name__, maker in SOUND, lines_of(rng, *maker(rng), uv=rng.random() < 0.4)
