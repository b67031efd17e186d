"""Figures of each triangle of a map, to be drawn. What is written about a map comes from the engine."""

import numpy as np

_CELLS_PER_TRIANGLE = 1.0


def fan_triangles(face_sizes):
    """(T, 3) corners of the triangles of faces, as fans, and (T,) the face of each."""
    starts = np.cumsum(face_sizes) - face_sizes
    face = np.repeat(np.arange(len(face_sizes)), face_sizes - 2)
    first = np.repeat(np.cumsum(face_sizes - 2) - (face_sizes - 2), face_sizes - 2)
    step = np.arange(len(face)) - first
    base = starts[face]
    return np.stack([base, base + step + 1, base + step + 2], axis=1), face


def map_lines(face_sizes, uvs):
    """(C, 2, 2) UVs of both ends of each side, which runs from its corner to the next one of its face."""
    following = np.arange(1, len(uvs) + 1)
    ends = np.cumsum(face_sizes)
    following[ends - 1] = ends - face_sizes
    return np.stack([uvs, uvs[following]], axis=1)


def any_flipped(model):
    """Whether triangles of a map are turned over."""
    triangles, _ = fan_triangles(model.face_sizes)
    return bool((_areas(_sides(model.uvs[triangles])) < 0).any())


def layout_scale(model):
    """Length in the map of one unit of the solver, for which the whole mesh has the area pi; 1 without a map. Pins are at
    that scale."""
    triangles, _ = fan_triangles(model.face_sizes)
    area = np.abs(_areas(_plane(model.positions[model.corners[triangles]])))
    flat = np.abs(_areas(_sides(model.uvs[triangles])))
    mapped = np.isfinite(flat)
    of_map, of_mesh = flat[mapped].sum(), area[mapped].sum() * np.pi / max(area.sum(), 1e-300)
    return float(np.sqrt(of_map / of_mesh)) if of_map > 0 and of_mesh > 0 else 1.0


def _plane(points):
    """(T, 2, 2) sides of triangles in their planes. points: (T, 3, 3)."""
    a, b = points[:, 1] - points[:, 0], points[:, 2] - points[:, 0]
    length = np.linalg.norm(a, axis=1)
    along = a / np.maximum(length, 1e-300)[:, None]
    x = (b * along).sum(axis=1)
    y = np.linalg.norm(b - x[:, None] * along, axis=1)
    return np.stack([np.stack([length, np.zeros_like(x)], 1), np.stack([x, y], 1)], axis=1)


def _areas(sides):
    return 0.5 * (sides[:, 0, 0] * sides[:, 1, 1] - sides[:, 0, 1] * sides[:, 1, 0])


def _sides(uvs):
    return np.stack([uvs[:, 1] - uvs[:, 0], uvs[:, 2] - uvs[:, 0]], axis=1)


def stretch(points, uvs):
    """(T,) symmetric Dirichlet energy of each triangle at the scale of the whole map; 4: none, inf: flipped or without
    area. points: (T, 3, 3), uvs: (T, 3, 2)."""
    model, flat = _plane(points), _sides(uvs)
    area, area_uv = _areas(model), _areas(flat)
    energy = np.full(len(points), np.inf)
    fine = (area > 0) & (area_uv > 0)
    if not fine.any():
        return energy
    scale = np.sqrt(area_uv[fine].sum() / area[fine].sum())
    jacobian = np.linalg.inv(model[fine]) @ flat[fine] / scale
    squares = (jacobian**2).sum(axis=(1, 2))
    determinant = np.linalg.det(jacobian)
    energy[fine] = squares * (1 + 1 / determinant**2)
    return energy


def density(points, uvs, size):
    """(T,) texels per unit of the scene. size: width and height of the texture."""
    area = _areas(_plane(points))
    texels = np.abs(_areas(_sides(uvs * np.array(size))))
    return np.sqrt(texels / np.maximum(area, 1e-300))


def _candidate_pairs(low, high):
    """(N, 2) triangles whose boxes share a cell of a grid, each pair once."""
    size = max((high - low).mean(), 1e-9) / _CELLS_PER_TRIANGLE
    first = np.floor(low / size).astype(np.int64)
    spans = np.floor(high / size).astype(np.int64) - first + 1
    counts = spans[:, 0] * spans[:, 1]
    owner = np.repeat(np.arange(len(low)), counts)
    step = np.arange(len(owner)) - np.repeat(np.cumsum(counts) - counts, counts)
    cell_x = first[owner, 0] + step % spans[owner, 0]
    cell_y = first[owner, 1] + step // spans[owner, 0]
    cell = cell_x * (1 << 31) + cell_y
    order = np.lexsort((owner, cell))
    owner, cell = owner[order], cell[order]
    pairs, distance = [], 1
    while True:
        same = cell[distance:] == cell[:-distance]
        if not same.any():
            break
        pairs.append(np.stack([owner[:-distance][same], owner[distance:][same]], axis=1))
        distance += 1
    if not pairs:
        return np.empty((0, 2), dtype=np.int64)
    return np.unique(np.concatenate(pairs), axis=0)


def _apart(a, b, slack):
    """(N,) True where a side of a separates the triangles a and b, (N, 3, 2), wound to the left, but for a slack."""
    apart = np.zeros(len(a), dtype=bool)
    for i in range(3):
        along = a[:, (i + 1) % 3] - a[:, i]
        normal = np.stack([along[:, 1], -along[:, 0]], axis=1)
        normal /= np.maximum(np.linalg.norm(normal, axis=1), 1e-300)[:, None]
        distance = ((b - a[:, i : i + 1]) * normal[:, None]).sum(axis=2)
        apart |= distance.min(axis=1) >= -slack
    return apart


def overlapping(uvs, slack=1e-6):
    """(T,) True for triangles that overlap another one by more than the slack, in UV units. uvs: (T, 3, 2)."""
    area = _areas(_sides(uvs))
    wound = np.where((area < 0)[:, None, None], uvs[:, ::-1], uvs)
    usable = np.flatnonzero(np.abs(area) > slack**2)
    wound = wound[usable]
    marked = np.zeros(len(uvs), dtype=bool)
    if not len(usable):
        return marked
    pairs = _candidate_pairs(wound.min(axis=1), wound.max(axis=1))
    a, b = wound[pairs[:, 0]], wound[pairs[:, 1]]
    hit = pairs[~(_apart(a, b, slack) | _apart(b, a, slack))]
    marked[usable[hit.ravel()]] = True
    return marked
