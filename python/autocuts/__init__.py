"""UV maps of polygon meshes: cuts and distortion optimised together.

In short::

    import autocuts
    map = autocuts.unwrap(positions, faces, quality="draft")
    map.uvs          # (corners, 2): u, v of each corner of each face; the texture is 0 to 1
    map.islands      # (faces,): the island of each face
    map.measure()    # distortion (4: no stretch), seam length, packing, flips, overlaps

    mesh = autocuts.Mesh.load("model.fbx")
    mesh.save("mapped.fbx", autocuts.unwrap(mesh))

The same mesh and options give the same map on any number of threads, and the one of autocuts-cli. The licence is
GPL-3.0-or-later.
"""

from ._autocuts import Map
from ._autocuts import version as __version__
from .baking import bake
from .mapping import (
    Job,
    LiveSolve,
    align,
    finish,
    lightmap,
    pack,
    render_layout,
    separate,
    take,
    transfer,
    unwrap,
    unwrap_trimesh,
)
from .mesh import Mesh

__all__ = [
    "Job",
    "LiveSolve",
    "Map",
    "Mesh",
    "align",
    "bake",
    "finish",
    "lightmap",
    "pack",
    "render_layout",
    "separate",
    "take",
    "transfer",
    "unwrap",
    "unwrap_trimesh",
]
