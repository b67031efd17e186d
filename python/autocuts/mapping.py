"""The jobs: a mesh and options in, a map out."""

import numpy as np

from . import _autocuts
from .drawing import svg
from .mesh import Mesh, mesh_of
from .options import options_of

_WISHES = ("face_sizes", "uvs", "objects", "materials", "normals", "locked", "edges", "edge_weights", "texel_weights", "pins")


def _split(keywords):
    """What belongs to the mesh, and the options."""
    wishes = {name: keywords.pop(name) for name in _WISHES if name in keywords}
    return wishes, options_of(keywords)


def _going(progress):
    return None if progress is None else lambda share: progress(share) is not False


def _shown(map, mesh):
    map._sizes = mesh.sizes()
    return map


def _run(name, positions, faces, progress, keywords, better=None):
    wishes, options = _split(keywords)
    mesh = mesh_of(positions, faces, wishes)
    take = None if better is None else lambda map: better(_shown(map, mesh))
    return _shown(_autocuts.call(name, mesh.arrays(), options, _going(progress), take), mesh)


def unwrap(positions, faces=None, *, progress=None, better=None, **options):
    """Cuts, maps and packs a mesh.

    positions: (N, 3) numbers, or a Mesh and no faces. faces: (F, 3) or (F, k) vertices; or, with face_sizes of shape (F,),
    the flat list of the vertices of all corners. All other fields of Mesh can be given by name: uvs, objects, materials,
    normals, locked, edges, edge_weights, texel_weights, pins. progress: called at the start and some 20 times
    a second with a share from 0 to 1; when it returns False, or on Ctrl-C, the map is the best one so far. better: called with
    the best Map so far whenever there is a better one, packed with little effort.

    Options, with the names and defaults of autocuts-cli: quality ("draft", "standard", "best"), max_distortion (above 4),
    seams ("free", "keep", "only"), seams_from (of "cuts", "uv", "sharp", "hard", "materials"), sharp_angle (degrees),
    surface ("auto", "organic", "hard-surface"), flat ("rigid", "free"), alike ("off", "same-cuts", "stack"), creases,
    align and symmetry ("off", "auto", "on"), crease_strength, visibility, mirror, world_up ("-", "y", "z", "auto-y",
    "auto-z"), texture_size (texels, one number or two), margin, tile_border (texels), rotation ("none", "free", 15, 30, 45, 90, 180), keep_scale,
    pack_time (seconds), density (texels per unit, in as many UDIM tiles as that needs), threads.

    Raises ValueError for a mesh or an option that cannot be used, RuntimeError where the margins leave no room.
    """
    return _run("unwrap", positions, faces, progress, options, better)


def finish(positions, faces=None, uvs=None, *, progress=None, **options):
    """Makes a map that is there usable: within the bound, few seams, no overlaps. Arguments as for unwrap()."""
    return _run("finish", positions, faces, progress, {"uvs": uvs, **options})


def pack(positions, faces=None, uvs=None, *, progress=None, **options):
    """Packs the islands of a map anew; with alike="stack", copies are laid on each other. Arguments as for unwrap()."""
    return _run("pack", positions, faces, progress, {"uvs": uvs, **options})


def separate(positions, faces=None, uvs=None, *, progress=None, **options):
    """Cuts the islands of a map that overlap themselves, and packs. Arguments as for unwrap()."""
    return _run("separate", positions, faces, progress, {"uvs": uvs, **options})


def align(positions, faces=None, uvs=None, *, progress=None, **options):
    """Turns islands to the axes and makes straight what is straight on the mesh. Arguments as for unwrap()."""
    return _run("align", positions, faces, progress, {"uvs": uvs, **options})


def lightmap(positions, faces=None, uvs=None, *, progress=None, **options):
    """A map for light maps of a map: no overlaps, one texel density. Arguments as for unwrap()."""
    return _run("lightmap", positions, faces, progress, {"uvs": uvs, **options})


def take(positions, faces=None, uvs=None, **options):
    """A map that is there, to be measured or drawn. Arguments as for unwrap()."""
    return _run("take", positions, faces, None, {"uvs": uvs, **options})


def transfer(source, mesh, *, match="auto", progress=None, **options):
    """Gives a Mesh the UVs of another one, also of another resolution.

    match: "auto", "topology" (the polygons are the same) or "position" (the nearest points of the surface). Returns the map
    and how well it was matched: faces, copied, placed, mean_distance, scale. Faces that find no UVs keep those of `mesh`, or
    have NaN.
    """
    matches = {"auto": 0, "topology": 1, "position": 2}
    if match not in matches:
        raise ValueError(f"match is one of {', '.join(matches)}, not {match!r}")
    made, matched = _autocuts.transfer(
        source.arrays(), mesh.arrays(), matches[match], options_of(options), _going(progress)
    )
    return _shown(made, mesh), matched


def render_layout(map, size=1024, tile=1001):
    """A picture of a map, (height, width, 4) bytes: islands in colours, seams darker, overlaps red, the rest transparent.

    size: pixels, one number or two. tile: its UDIM number.
    """
    width, height = size if hasattr(size, "__len__") else (size, size)
    return map.draw(width, height, tile)


class Job:
    """A job in the background, on a thread that runs no Python: for programs that look after it from their own event loop.

    name: "unwrap", "finish", "pack", "separate", "align", "lightmap" or "take"; the other arguments are those of the function
    of this name.
    """

    _NAMES = ("unwrap", "finish", "pack", "separate", "align", "lightmap", "take")

    def __init__(self, name, positions, faces=None, **options):
        if name not in self._NAMES:
            raise ValueError(f"the name of a job is one of {', '.join(self._NAMES)}, not {name!r}")
        wishes, settings = _split(options)
        self._mesh = mesh_of(positions, faces, wishes)
        self._job = _autocuts.Job(name, self._mesh.arrays(), settings)

    @property
    def share(self):
        """Its progress, from 0 to 1."""
        return self._job.share

    @property
    def newest(self):
        """The best Map so far of an unwrap, packed with little effort; None before there is one."""
        made = self._job.newest
        return None if made is None else _shown(made, self._mesh)

    def stop(self):
        """Asks it to end soon, with the best map so far."""
        self._job.stop()

    def wait(self, seconds=0):
        """Waits for the end. True when it has ended."""
        return self._job.wait(seconds)

    def result(self):
        """Waits for the end, and returns the Map or raises what the function would raise."""
        return _shown(self._job.result(), self._mesh)

    def figures(self):
        """The figures of the result, as of Map.measure(); measured in the background as well."""
        return self._job.figures()


class LiveSolve:
    """A map that gets better all the time on a thread of its own, and follows its steering.

    In short::

        live = autocuts.LiveSolve(mesh)
        while (map := live.wait(1.0)) is not None:
            ...                      # show it; live.steer(pins=[[corner, u, v]]) moves a corner
    """

    def __init__(self, mesh, **options):
        self._mesh, self._keywords = mesh, options
        self._live = _autocuts.LiveSolve(mesh.arrays(), options_of(options))

    def steer(self, **changes):
        """Other wishes (fields of Mesh: pins, edges, edge_weights, locked, uvs ...) and options; the others stay."""
        wishes = {name: changes.pop(name) for name in ("positions", "faces", *_WISHES) if name in changes}
        self._keywords = {**self._keywords, **changes}
        self._mesh = Mesh(**{**vars(self._mesh), **wishes})
        self._live.steer(self._mesh.arrays(), options_of(self._keywords))

    def wait(self, seconds):
        """The next map; None when none came in time, or when nothing is left to gain."""
        made = self._live.wait(seconds)
        return None if made is None else _shown(made, self._mesh)

    @property
    def rests(self):
        """True when nothing is left to gain; steering sets it to work again."""
        return self._live.rests()


def unwrap_trimesh(mesh, **options):
    """A new trimesh.Trimesh with a UV map, its vertices split at the seams, from one without."""
    import trimesh

    made = unwrap(mesh.vertices, mesh.faces, **options)
    keys = np.column_stack([np.asarray(mesh.faces).ravel(), made.uvs])
    unique, inverse = np.unique(keys, axis=0, return_inverse=True)
    return trimesh.Trimesh(
        vertices=np.asarray(mesh.vertices)[unique[:, 0].astype(np.int64)],
        faces=inverse.reshape(-1, 3),
        visual=trimesh.visual.TextureVisuals(uv=unique[:, 1:]),
        process=False,
    )


_autocuts.Map._repr_svg_ = lambda map: svg(map.uvs, map._sizes, map.islands) if hasattr(map, "_sizes") else None
