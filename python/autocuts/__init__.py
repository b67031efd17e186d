"""UV maps of polygon meshes: cuts and distortion optimised together.

    import autocuts
    map = autocuts.unwrap(positions, faces, quality="draft")
    map.uvs          # (corners, 2): u, v of each corner of each face; the texture is 0 to 1
    map.islands      # (faces,): the island of each face
    map.measure()    # distortion (4: no stretch), seam length, packing, flips, overlaps

The same mesh and options give the same map on any number of threads, and the one of autocuts-cli. The licence is
GPL-3.0-or-later.
"""

from . import _autocuts
from ._autocuts import Map

__version__ = _autocuts.version
__all__ = ["Map", "pack", "separate", "take", "unwrap"]

_WORDS = {
    "quality": {"draft": 0, "standard": 1, "best": 2},
    "surface": {"auto": 0, "organic": 1, "hard": 2},
    "rotation": {"none": 0, "quarter": 1, "any": 2},
}


def _options(given):
    options = _autocuts.Options()
    if "texture_size" in given:
        size = given.pop("texture_size")
        width, height = size if hasattr(size, "__len__") else (size, size)
        given.update(texture_width=width, texture_height=height)
    for name, value in given.items():
        if not hasattr(options, name):
            raise TypeError(f"there is no option {name!r}")
        words = _WORDS.get(name)
        if words and value not in words:
            raise ValueError(f"{name} is one of {', '.join(words)}, not {value!r}")
        setattr(options, name, words[value] if words else value)
    return options


def _run(call, positions, faces, face_sizes, uvs, objects, locked, edges, progress, options):
    def going(fraction):
        return progress(fraction) is not False

    watch = going if progress else None
    return call(positions, faces, face_sizes, uvs, objects, locked, edges, _options(options), watch)


def unwrap(
    positions, faces, *, face_sizes=None, uvs=None, objects=None, locked=None, edges=None, progress=None, **options
):
    """Cuts, maps and packs a mesh.

    positions: (N, 3) numbers. faces: (F, 3) or (F, k) vertices; or, with face_sizes of shape (F,), the flat list of
    the vertices of all corners. uvs: (corners, 2), the map before, NaN where there is none. objects: (F,) numbers from
    0, seams run between objects. locked: (F,), islands that stay as they are in uvs. edges: (corners,), for the edge from
    each corner to the next of its face: 0 free, 1 a seam, 2 never one. progress: called with a share from
    0 to 1; when it returns False, or on Ctrl-C, the map is the best one so far.

    Options, with the names and defaults of autocuts-cli: quality ("draft", "standard", "best"), max_distortion (above 4),
    surface ("auto", "organic", "hard"), symmetry, align, texture_size (texels, one number or two), margin, border
    (texels), rotation ("none", "quarter", "any"), keep_scale, pack_effort (seconds), density (texels
    per unit, in as many UDIM tiles as that needs), threads.

    Raises ValueError for a mesh or an option that cannot be used, RuntimeError where the margins leave no room.
    """
    return _run(_autocuts.unwrap, positions, faces, face_sizes, uvs, objects, locked, edges, progress, options)


def pack(positions, faces, uvs, *, face_sizes=None, objects=None, locked=None, progress=None, **options):
    """Packs the islands of a map anew. Arguments as for unwrap()."""
    return _run(_autocuts.pack, positions, faces, face_sizes, uvs, objects, locked, None, progress, options)


def separate(positions, faces, uvs, *, face_sizes=None, objects=None, locked=None, progress=None, **options):
    """Cuts the islands of a map that overlap themselves, and packs. Arguments as for unwrap()."""
    return _run(_autocuts.separate, positions, faces, face_sizes, uvs, objects, locked, None, progress, options)


def take(positions, faces, uvs, *, face_sizes=None, objects=None, **options):
    """A map that is there, to be measured. Arguments as for unwrap()."""
    return _run(_autocuts.take, positions, faces, face_sizes, uvs, objects, None, None, None, options)
