"""Random bakes: options, small pictures and models with colours, for the cases."""
import struct
import zlib

import mutations
import oddmeshes

MAPS = ["normal", "object-normal", "ao", "bent-normal", "curvature", "thickness", "position", "color", "material-id",
        "height"]
# How the files that a bake writes begin.
BEGINNINGS = {"png": b"\x89PNG\r\n\x1a\n", "exr": b"\x76\x2f\x31\x01", "tif": (b"II*\0", b"MM\0*"),
              "tga": (b"\0\0\x02", b"\0\0\x03")}


def pick(rng, *pairs):
    """Some of the options: each (probability, option, ...) on its own."""
    return [word for chance, *words in pairs if rng.random() < chance for word in words]


def mesh(rng, uv):
    """The lines of an OBJ file, with vertex colours now and then, some of them odd."""
    if rng.random() < 0.3:
        lines = oddmeshes.any_mesh(rng)[2]
    else:
        points, faces = rng.choice([oddmeshes.box(rng), oddmeshes.grid(rng, rng.randint(2, 12))])
        lines = oddmeshes.lines_of(rng, points, faces, uv)
    if rng.random() < 0.4:
        odd = rng.random() < 0.3
        number = lambda: b"%g" % (rng.choice([-1, 1e308, float("nan"), 255]) if odd and rng.random() < 0.2 else rng.random())
        lines = [b" ".join([line] + [number() for _ in range(rng.choice([3, 3, 3, 2, 4]) if odd else 3)])
                 if line.startswith(b"v ") else line for line in lines]
    return lines


def png(rng, width, height):
    deep, color = rng.choice([8, 16]), rng.choice([0, 2, 6])
    row = width * {0: 1, 2: 3, 6: 4}[color] * deep // 8
    chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    pixels = b"".join(b"\0" + rng.randbytes(row) for _ in range(height))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, deep, color, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(pixels)) + chunk(b"IEND", b""))


def tga(rng, width, height):
    return struct.pack("<BBBHHBHHHHBB", 0, 0, 2, 0, 0, 0, 0, 0, width, height, 24, 0x20) + rng.randbytes(3 * width * height)


def hdr(rng, width, height):
    return b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n" % (height, width) + rng.randbytes(4 * width * height)


def picture(rng):
    """(suffix, bytes) of a small picture, damaged now and then."""
    suffix, maker = rng.choice([("png", png), ("tga", tga), ("hdr", hdr)])
    data = maker(rng, rng.choice([1, 2, 7, 16, 33]), rng.choice([1, 2, 7, 16, 33]))
    if rng.random() < 0.6:
        data = mutations.mutated(rng, data, maker(rng, 5, 4))
    return suffix, data or b"\0"


def size(rng):
    return rng.choice(["16", "32", "64", "64x512", "300x20", "100"])


def bake_options(rng):
    number = lambda *choices: str(rng.choice(choices))
    return ["--size", size(rng), "--maps", ",".join(rng.sample(MAPS, rng.choice([1, 1, 2, 10]))),
            "--rays", number(1, 3, 16)] + pick(
        rng, (.5, "--samples", number(1, 4, 9)), (.5, "--cage", number(1e-6, .001, .1, 1)),
        (.3, "--cage-direction", rng.choice(["shading", "corrected"])), (.2, "--by-name"),
        (.2, "--ray-reach", number(1e-6, .1, 1e6)), (.2, "--curvature-radius", number(1e-6, .01, 1)),
        (.2, "--thickness-limit", number(1e-6, 10)), (.3, "--dilation", number(0, 1, 1024)),
        (.5, "--format", rng.choice(["png", "tif", "tga", "exr"])), (.2, "--bits", number(8, 16, 32)),
        (.2, "--directx"), (.3, "--color-from", rng.choice(["textures", "vertices", "materials"])),
        (.1, "--time-limit", number(.001, .1)))


def light_options(rng, has_picture):
    number = lambda *choices: str(rng.choice(choices))
    albedo = [(.5, "--albedo", "picture")] if has_picture else [(.3, "--albedo", number("0", "1", ".5,.2,0"))]
    return ["--size", size(rng), "--samples", number(1, 4, 16)] + pick(
        rng, (.5, "--sun", number("0,90", "150,35", "-400,0", "10,-10")), (.3, "--sun-angle", number(0, 10, 90)),
        (.5, "--sky", rng.choice(["day", "none", "1", "1,.5,.2/0/1"])), (.2, "--turbidity", number(2, 10)),
        (.3, "--area-light", "0,3,0:0,0,0:1x1:5,5,5"), (.3, "--bounces", number(0, 1, 20)), (.2, "--no-denoise"),
        (.2, "--no-direct"), (.2, "--no-indirect"), (.3, "--values", rng.choice(["irradiance", "lit"])),
        (.3, "--dilation", number(0, 100)), (.2, "--bits", number(8, 16, 32)), (.2, "--up", "z"),
        (.1, "--time-limit", number(.001, .1)), *albedo)


def broken_files(folder):
    """The names of files in a folder that do not begin as their formats do."""
    return [path.name for path in sorted(folder.rglob("*")) if path.is_file() and not
            path.read_bytes().startswith(BEGINNINGS.get(path.suffix[1:], b""))]
