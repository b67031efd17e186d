"""Small models for conversions, in several formats, units and axes, and what has to stay the same."""
import itertools

FORMATS = ["fbx", "glb", "gltf", "dae"]
NAMES = ["Body", "Left arm", "Käse", "Cube", "Cube.001", "a_b", "x" * 60, "0"]
MATERIALS = ["red", "wood 2", "Öl", "metal.001"]
# Formats have numbers of single precision, and some are converted several times.
TOLERANCE = 2e-5


def triangles(rng):
    """Triangles of an object: ((points), (UVs))."""
    size, place = 10 ** rng.uniform(-3, 3), [rng.uniform(-5, 5) for _ in range(3)]
    point = lambda: tuple(size * (p + rng.uniform(0, 1)) for p in place)
    uv = lambda: (rng.uniform(0, 1), rng.uniform(0, 1))
    return [((point(), point(), point()), (uv(), uv(), uv())) for _ in range(rng.randint(1, 12))]


def obj(rng):
    """The bytes of an OBJ file of several objects with materials."""
    lines, count = ["mtllib in.mtl"], 0
    for name in rng.sample(NAMES, rng.randint(1, 4)):
        lines += ["o " + name, "usemtl " + rng.choice(MATERIALS)]
        for points, uvs in triangles(rng):
            lines += ["v %r %r %r" % p for p in points] + ["vt %r %r" % uv for uv in uvs]
            lines.append("f " + " ".join("%d/%d" % (count + k, count + k) for k in (1, 2, 3)))
            count += 3
    return "\n".join(lines).encode() + b"\n"


def library(rng):
    """The bytes of the materials of obj()."""
    color = lambda: " ".join(rng.choice(["0", "1", "0.5", "0.25"]) for _ in range(3))
    return "".join("newmtl %s\nKd %s\n" % (name, color()) for name in MATERIALS).encode()


def figures(data):
    """What is compared of an OBJ file: {word: a number, or a set of names}."""
    points, uvs, names, materials = [], [], set(), set()
    box, uv_box = [[1e300] * 3, [-1e300] * 3], [[1e300] * 2, [-1e300] * 2]
    area = uv_area = faces = 0.0
    name = material = None
    for line in data.decode("utf-8", "replace").splitlines():
        word, _, rest = line.partition(" ")
        if word in ("v", "vt"):
            (points if word == "v" else uvs).append([float(x) for x in rest.split()[:3 if word == "v" else 2]])
        elif word == "o":
            name = rest
        elif word == "usemtl":
            material = rest
        elif word == "f":
            names.add(name)
            materials.add(material)
            corners = [c.split("/") for c in rest.split()]
            p = [points[int(c[0]) - 1] for c in corners]
            uv = [uvs[int(c[1]) - 1] for c in corners if len(c) > 1 and c[1]]
            for values, low_high in ((p, box), (uv, uv_box)):
                for value in values:
                    low_high[0] = [min(a, b) for a, b in zip(low_high[0], value)]
                    low_high[1] = [max(a, b) for a, b in zip(low_high[1], value)]
            for k in range(1, len(p) - 1):
                a, b = ([y - x for x, y in zip(p[0], p[j])] for j in (k, k + 1))
                area += sum((a[i] * b[j] - a[j] * b[i]) ** 2 for i, j in ((0, 1), (1, 2), (2, 0))) ** .5 / 2
                faces += 1
                if len(uv) == len(p):
                    (ax, ay), (bx, by) = ([y - x for x, y in zip(uv[0], uv[j])] for j in (k, k + 1))
                    uv_area += abs(ax * by - ay * bx) / 2
    return {"box": box, "area": area, "triangles": faces, "UVs": uv_box, "area of UVs": uv_area, "objects": names,
            "materials": materials}


def differences(before, after, words):
    """The words whose figures differ."""
    size = max([1e-30] + [abs(x) for side in before["box"] for x in side])
    scales = {"box": size, "area": max(before["area"], size * size * 1e-3), "UVs": 1, "area of UVs": 1, "triangles": 1}
    flat = lambda value: [x for side in value for x in side] if isinstance(value, list) else [value]
    differ = lambda word: before[word] != after[word] if isinstance(before[word], set) else any(
        not abs(a - b) <= TOLERANCE * scales[word] for a, b in zip(flat(before[word]), flat(after[word])))
    return [word for word in words if differ(word)]


def turns():
    """The 24 axes of right-handed coordinates: rows to the right, up, and to the front."""
    for order in itertools.permutations(range(3)):
        for signs in itertools.product((1, -1), repeat=3):
            odd = sum(order[i] > order[j] for i in range(3) for j in range(i + 1, 3)) % 2
            if signs[0] * signs[1] * signs[2] * (-1 if odd else 1) > 0:
                yield tuple(zip(order, signs))


def text_fbx(points, axes, factor):
    """\\param axes one of turns() \\param factor centimetres of a unit"""
    setting = lambda name, value: '\t\tP: "%s", "int", "Integer", "",%d\n' % (name, value)
    names = ["CoordAxis", "UpAxis", "FrontAxis"]
    settings = "".join(setting(n, a) + setting(n + "Sign", s) for n, (a, s) in zip(names, axes))
    numbers = ",".join("%r" % x for p in points for x in p)
    indices = ",".join(str(i if i % 3 < 2 else -i - 1) for i in range(len(points)))
    return ('; FBX 7.4.0 project file\nFBXHeaderExtension:  {\n\tFBXHeaderVersion: 1003\n\tFBXVersion: 7400\n}\n'
            'GlobalSettings:  {\n\tVersion: 1000\n\tProperties70:  {\n' + settings +
            '\t\tP: "UnitScaleFactor", "double", "Number", "",%r\n\t}\n}\nObjects:  {\n' % factor +
            '\tGeometry: 1, "Geometry::", "Mesh" {\n\t\tVertices: *%d {\n\t\t\ta: %s\n\t\t}\n' % (3 * len(points), numbers) +
            '\t\tPolygonVertexIndex: *%d {\n\t\t\ta: %s\n\t\t}\n\t\tGeometryVersion: 124\n\t}\n' % (len(points), indices) +
            '\tModel: 2, "Model::Mesh", "Mesh" {\n\t\tVersion: 232\n\t}\n}\n'
            'Connections:  {\n\tC: "OO",2,0\n\tC: "OO",1,2\n}\n').encode()


def collada(points, up, metres):
    """\\param up "X", "Y" or "Z" """
    numbers = " ".join("%r" % x for p in points for x in p)
    return ('<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset>'
            '<unit meter="%r"/><up_axis>%s_UP</up_axis></asset><library_geometries><geometry id="g"><mesh>' % (metres, up) +
            '<source id="p"><float_array id="pa" count="%d">%s</float_array><technique_common>' % (3 * len(points), numbers) +
            '<accessor source="#pa" count="%d" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>' %
            len(points) + '<param name="Z" type="float"/></accessor></technique_common></source><vertices id="v">'
            '<input semantic="POSITION" source="#p"/></vertices><triangles count="%d">' % (len(points) // 3) +
            '<input semantic="VERTEX" source="#v" offset="0"/><p>%s</p></triangles>' % " ".join(
                str(i) for i in range(len(points))) + '</mesh></geometry></library_geometries><library_visual_scenes>'
            '<visual_scene id="s"><node id="n" name="Mesh"><instance_geometry url="#g"/></node></visual_scene>'
            '</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>').encode()


def in_units(rng):
    """(name of a file in random units and axes, its bytes, the same as an OBJ file in metres with y up)"""
    points = [p for corners, _ in triangles(rng) for p in corners]
    if rng.random() < 0.6:
        axes, factor = rng.choice(list(turns())), rng.choice([1, 100, 2.54, 0.1, 30.48, 10 ** rng.uniform(-2, 3)])
        name, data = "in.fbx", text_fbx(points, axes, factor)
        world = [[factor / 100 * s * p[a] for a, s in axes] for p in points]
    else:
        up, metres = rng.choice("XYZ"), rng.choice([1, 0.01, 0.0254, 0.001, 10 ** rng.uniform(-3, 2)])
        name, data = "in.dae", collada(points, up, metres)
        turn = {"X": lambda x, y, z: (-y, x, z), "Y": lambda x, y, z: (x, y, z), "Z": lambda x, y, z: (x, z, -y)}[up]
        world = [[metres * x for x in turn(*p)] for p in points]
    lines = ["o Mesh"] + ["v %r %r %r" % tuple(p) for p in world]
    lines += ["f %d %d %d" % (i + 1, i + 2, i + 3) for i in range(0, len(world), 3)]
    return name, data, "\n".join(lines).encode()
