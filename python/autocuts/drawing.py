"""Maps as SVG, for notebooks."""

import colorsys

import numpy as np

_SIDE = 400  # pixels of the first tile
_MOST = 20_000  # faces that are drawn: browsers get slow beyond


def _color(island):
    red, green, blue = colorsys.hsv_to_rgb(0.618 * island % 1, 0.35, 0.95)
    return f"#{int(255 * red):02x}{int(255 * green):02x}{int(255 * blue):02x}"


def svg(uvs, sizes, islands=None):
    """A picture of a map. uvs: (corners, 2); sizes: corners of each face; islands: of each face, for colours."""
    starts = np.concatenate([[0], np.cumsum(sizes)])
    known = np.isfinite(uvs).all(axis=1)
    if not known.any():
        return f'<svg xmlns="http://www.w3.org/2000/svg" width="{_SIDE}" height="{_SIDE}"/>'
    low = np.floor(np.minimum(uvs[known].min(axis=0) + 1e-9, 0))
    high = np.ceil(np.maximum(uvs[known].max(axis=0) - 1e-9, 1))
    width, height = (_SIDE * (high - low)).tolist()
    points = np.column_stack([_SIDE * (uvs[:, 0] - low[0]), _SIDE * (high[1] - uvs[:, 1])])
    paths = {}
    for face in range(min(len(sizes), _MOST)):
        corners = slice(starts[face], starts[face + 1])
        if known[corners].all():
            path = "L".join(f"{x:.1f},{y:.1f}" for x, y in points[corners].tolist())
            paths.setdefault(0 if islands is None else int(islands[face]), []).append(f"M{path}Z")
    drawn = "".join(
        f'<path d="{"".join(faces)}" fill="{_color(island)}" stroke="#333" stroke-width=".4"/>'
        for island, faces in sorted(paths.items())
    )
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:.0f}" height="{height:.0f}">'
        f'<rect width="100%" height="100%" fill="#fff" stroke="#999"/>{drawn}</svg>'
    )
