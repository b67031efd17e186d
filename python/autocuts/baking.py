"""Bakes of a surface into pictures."""

from . import _autocuts
from .options import set_options

_MAPS = {
    "normal": 0,
    "object-normal": 1,
    "ao": 2,
    "bent-normal": 3,
    "curvature": 4,
    "thickness": 5,
    "position": 6,
    "color": 7,
    "material-id": 8,
    "height": 9,
}


def bake(mesh, maps=("normal", "ao"), *, high=None, cage=0.02, cage_positions=None, progress=None, **options):
    """Bakes into the map of a Mesh, uvs.

    maps: names as in autocuts-cli. high: the detailed Mesh at the same place; None: the mesh itself. cage: how far it is
    looked for, as a share of the diagonal of the mesh's bounding box, or "auto". cage_positions: (N, 3), the vertices moved
    outwards, in its place. Options: texture_size, tile, samples (along each side of a texel), rays, cage_direction
    ("smooth", "shading", "corrected"), ray_reach, curvature_radius, thickness_limit, dilation, directx, floats, threads.

    Returns a dict of pictures (height, width, channels) of float32, rows from the top, with "texels" and "missed": how many
    lie in islands, and for how many of them no ray met the detailed mesh. Raises RuntimeError when progress stops it.
    """
    names = [maps] if isinstance(maps, str) else list(maps)
    for name in names:
        if name not in _MAPS:
            raise ValueError(f"maps are made of {', '.join(_MAPS)}, not {name!r}")
    if mesh.uvs is None:
        raise ValueError("the mesh has no UVs to bake into")
    given = set_options(_autocuts.BakeOptions(), {"cage": -1 if cage == "auto" else cage, **options})
    going = None if progress is None else lambda share: progress(share) is not False
    pictures, texels, missed = _autocuts.bake(
        mesh.arrays(), None if high is None else high.arrays(), [_MAPS[name] for name in names], given, cage_positions, going
    )
    return {**dict(zip(names, pictures)), "texels": texels, "missed": missed}
