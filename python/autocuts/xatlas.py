"""The calls of xatlas-python, so that a pipeline changes one line: from autocuts import xatlas

Works: parametrize(), export(), Atlas with several meshes and, where texels_per_unit and resolution are given, several
atlases; padding, resolution, rotate_charts, bruteForce (more effort when packing), blockAlign, max_chart_size, create_image
and use_input_mesh_uvs (the charts of the given UVs are kept and packed). Taken and without effect: the costs and weights of
ChartOptions, max_chart_area and max_boundary_length, rotate_charts_to_axis, bilinear. Where there are several atlases,
get_mesh_atlases() says in which one each triangle lies; UVs are those in its atlas. Faces that cannot be mapped (without
area, with NaN) get UVs of 0.

quality is "draft"; set xatlas.quality = "standard" for shorter seams.
"""

from dataclasses import dataclass

import numpy as np

from .mapping import pack, render_layout, separate, take, unwrap

quality = "draft"
__all__ = ["Atlas", "ChartOptions", "PackOptions", "export", "parametrize", "quality"]

@dataclass
class ChartOptions:
    """Only use_input_mesh_uvs has an effect."""

    max_chart_area: float = 0.0
    max_boundary_length: float = 0.0
    normal_deviation_weight: float = 2.0
    roundness_weight: float = 0.01
    straightness_weight: float = 6.0
    normal_seam_weight: float = 4.0
    texture_seam_weight: float = 0.5
    max_cost: float = 2.0
    max_iterations: int = 1
    use_input_mesh_uvs: bool = False
    fix_winding: bool = False


@dataclass
class PackOptions:
    """padding in texels; resolution 0: 1024. See the module for what has no effect."""

    max_chart_size: int = 0
    padding: int = 0
    texels_per_unit: float = 0.0
    resolution: int = 0
    bilinear: bool = True
    blockAlign: bool = False
    bruteForce: bool = False
    create_image: bool = False
    rotate_charts_to_axis: bool = True
    rotate_charts: bool = True
    block_align: bool = False  # as the last versions write it
    brute_force: bool = False


def _array(values, columns, name):
    array = np.ascontiguousarray(values, dtype=np.float64)
    if array.ndim != 2 or array.shape[1] != columns:
        raise ValueError(f"{name} must be an Nx{columns} array, not {array.shape}")
    return array


def _triangles(indices, count):
    array = np.ascontiguousarray(indices)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"indices must be an Nx3 array, not {array.shape}")
    array = array.astype(np.int64)
    if array.size and (array.min() < 0 or array.max() >= count):
        raise RuntimeError(f"an index is out of range: there are {count} vertices")
    return array


def _mappable(positions, triangles):
    """Which triangles have numbers and an area."""
    with np.errstate(all="ignore"):
        corners = positions[triangles]
        normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        area = np.linalg.norm(normal, axis=1)
    return np.isfinite(corners).all(axis=(1, 2)) & (np.abs(corners) <= 1e150).all(axis=(1, 2)) & (area > 0)


_BLOCK = 4  # texels along the side of a block of compressed textures


def _areas(corners):
    """Areas of triangles in the plane or in space."""
    a, b = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    if corners.shape[2] == 2:
        return abs(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]) / 2
    return np.linalg.norm(np.cross(a, b), axis=1) / 2


def _scale(corners, uvs):
    """Length in the map per length on the surface."""
    area = _areas(corners).sum()
    return float(np.sqrt(_areas(uvs).sum() / area)) if area > 0 else 0.0


def _boxes(result):
    """Lower and upper corner of the box of each chart, and the chart of each corner of the mesh."""
    charts = np.repeat(result.islands, 3)
    low, high = np.full((result.island_count, 2), np.inf), np.full((result.island_count, 2), -np.inf)
    np.minimum.at(low, charts, result.uvs)
    np.maximum.at(high, charts, result.uvs)
    return low, high, charts


def _limit(result, positions, faces, objects, most, options):
    """Charts that are longer than `most` texels are scaled down, and all are packed as they are then."""
    low, high, charts = _boxes(result)
    factor = np.minimum(1, most / options["texture_size"] / np.maximum((high - low).max(axis=1), 1e-300))
    if (factor == 1).all():
        return result
    uvs = low[charts] + (result.uvs - low[charts]) * factor[charts, None]
    kept = {name: value for name, value in options.items() if name != "density"}
    return pack(positions, faces, uvs, objects=objects, keep_scale=True, **{**kept, "rotation": "none"})


def _to_blocks(result, side):
    """Charts moved so that their boxes begin at blocks."""
    low, _, charts = _boxes(result)
    step = _BLOCK / side
    return result.uvs + (np.floor(low / step + 1e-6) * step - low)[charts]


class Atlas:
    """Meshes that share one texture."""

    def __init__(self):
        self._meshes = []
        self._results = None
        self._figures = {}
        self._side = 0
        self._atlases = 0
        self._triangle_atlases = []
        self._images = []
        self._texels_per_unit = 0.0

    def add_mesh(self, positions, indices, normals=None, uvs=None):
        positions = _array(positions, 3, "positions")
        for values, columns, name in ((normals, 3, "normals"), (uvs, 2, "uvs")):
            if values is not None and len(_array(values, columns, name)) != len(positions):
                raise ValueError(f"the first dimension of {name} must be that of positions")
        uvs = None if uvs is None else _array(uvs, 2, "uvs")
        self._meshes.append((positions, _triangles(indices, len(positions)), uvs))

    def add_uv_mesh(self, uvs, indices, face_materials=None):
        uvs = _array(uvs, 2, "uvs")
        flat = np.column_stack([uvs, np.zeros(len(uvs))])
        self._meshes.append((flat, _triangles(indices, len(uvs)), uvs))

    def generate(self, chart_options=None, pack_options=None, verbose=False):
        chart, packing = chart_options or ChartOptions(), pack_options or PackOptions()
        options = {
            "texture_size": packing.resolution or 1024,
            "margin": max(packing.padding, 0),
            "rotation": "free" if packing.rotate_charts else "none",
        }
        if packing.bruteForce or packing.brute_force:
            options["pack_time"] = 10.0
        if packing.texels_per_unit > 0 and packing.resolution > 0:
            options["density"] = packing.texels_per_unit
        blocks = packing.blockAlign or packing.block_align
        if blocks:
            options["margin"] += 2 * _BLOCK - 2  # charts move by less than a block along each axis
            options["tile_border"] = max(options["margin"] / 2, _BLOCK)
        self._side = options["texture_size"]
        positions, corners, objects, kept, uvs = [np.empty((0, 3))], [], [], [], []
        first = 0
        for number, (points, triangles, own) in enumerate(self._meshes):
            good = _mappable(points, triangles)
            used = triangles[good]
            positions.append(np.where(np.isfinite(points), points, 0))
            corners.append(used + first)
            objects.append(np.full(len(used), number, dtype=np.int32))
            kept.append(good)
            uvs.append(None if own is None else own[used])
            first += len(points)
        faces = np.concatenate(corners) if corners else np.empty((0, 3), dtype=np.int64)
        made = np.empty((0, 3, 2))
        if len(faces):
            points, numbers = np.concatenate(positions), np.concatenate(objects)
            result = self._map(points, faces, numbers, uvs, chart, options)
            if packing.max_chart_size > 0:
                result = _limit(result, points, faces, numbers, packing.max_chart_size, options)
            if blocks:
                result = take(points, faces, _to_blocks(result, self._side), objects=numbers, **options)
            self._figures = result.measure()
            made = result.uvs.reshape(-1, 3, 2)
            self._texels_per_unit = self._side * _scale(points[faces], made)
        made = np.nan_to_num(made)
        # UDIM tiles are atlases, in their order.
        tile = np.floor(made.mean(axis=1)).astype(np.int64)
        numbers, atlas = np.unique(tile[:, 0] + 10 * tile[:, 1], return_inverse=True)
        made = made - tile[:, None, :]
        self._atlases = int(atlas.max()) + 1 if len(faces) else 0
        self._images = []
        if packing.create_image and len(faces):
            self._images = [render_layout(result, self._side, 1001 + int(number))[:, :, :3] for number in numbers]
        self._results, self._triangle_atlases, at = [], [], 0
        for (_, triangles, _), good in zip(self._meshes, kept):
            uv, places = np.zeros((len(triangles), 3, 2)), np.zeros(len(triangles), dtype=np.uint32)
            uv[good], places[good] = made[at : at + good.sum()], atlas[at : at + good.sum()]
            at += good.sum()
            self._triangle_atlases.append(places)
            self._results.append(self._split(triangles, uv, places))

    def _map(self, positions, faces, objects, uvs, chart, options):
        flat = np.ptp(positions[:, 2]) == 0 and all(own is not None for own in uvs)
        if all(own is not None for own in uvs) and (chart.use_input_mesh_uvs or flat):
            given = np.concatenate(uvs)
            result = pack(positions, faces, given, objects=objects, **options)
            if result.measure()["overlapping_pairs"] > 0 and "density" not in options:
                result = separate(positions, faces, given, objects=objects, **options)
        else:
            result = unwrap(positions, faces, objects=objects, quality=quality, **options)
        return result

    @staticmethod
    def _split(triangles, uv, atlas):
        """Vertices that are the same in the mesh and in the map become one again."""
        keys = np.column_stack([triangles.reshape(-1), np.repeat(atlas, 3), uv.reshape(-1, 2).astype(np.float32)])
        unique, inverse = np.unique(keys, axis=0, return_inverse=True)
        vmapping = unique[:, 0].astype(np.uint32)
        return vmapping, inverse.reshape(-1, 3).astype(np.uint32), unique[:, 2:].astype(np.float32)

    def get_mesh(self, index):
        """vmapping, indices, uvs of a mesh, see parametrize()."""
        if self._results is None or not 0 <= index < len(self._results):
            raise IndexError(f"Mesh index {index} out of bounds for atlas with {len(self)} meshes")
        return self._results[index]

    __getitem__ = get_mesh

    def get_mesh_atlases(self, index):
        """(F,): the atlas of each triangle of a mesh, from 0. Not in xatlas-python."""
        self.get_mesh(index)
        return self._triangle_atlases[index]

    def __len__(self):
        return len(self._meshes)

    def get_utilization(self, index):
        if not 0 <= index < self.atlas_count:
            raise IndexError(f"Atlas index {index} out of bounds")
        return self._figures["packing_efficiency"]

    def get_chart_image(self, index):
        """(height, width, 3) bytes: the charts in colours. Only with create_image."""
        if not 0 <= index < len(self._images):
            raise IndexError(f"Chart image index {index} out of bounds, or create_image was not set")
        return self._images[index]

    chart_image = property(lambda self: self.get_chart_image(0))
    texels_per_unit = property(lambda self: self._texels_per_unit)
    mesh_count = property(__len__)
    atlas_count = property(lambda self: self._atlases)
    chart_count = property(lambda self: self._figures.get("islands", 0))
    width = property(lambda self: self._side if self._figures else 0)
    height = width
    utilization = property(lambda self: self.get_utilization(0) if self._figures else 0.0)


def parametrize(positions, indices, normals=None, uvs=None):
    """Maps a mesh. positions (N, 3), indices (F, 3).

    Returns vmapping (n,), the old vertex of each new one; indices (F, 3) into the new ones; uvs (n, 2) in 0 to 1.
    """
    atlas = Atlas()
    atlas.add_mesh(positions, indices, normals, uvs)
    atlas.generate()
    return atlas[0]


def export(path, positions, indices=None, uvs=None, normals=None):
    """Writes an OBJ; the arrays are per vertex. ValueError when the path cannot be opened."""
    try:
        file = open(path, "w", encoding="ascii")
    except OSError as error:
        raise ValueError(f"{path} cannot be opened: {error.strerror}") from error
    with file:
        for name, values, columns in (("v", positions, 3), ("vt", uvs, 2), ("vn", normals, 3)):
            if values is not None:
                file.writelines(f"{name} {' '.join(map(repr, row))}\n" for row in _array(values, columns, name).tolist())
        if indices is None:
            return
        for triangle in _triangles(indices, len(positions)).tolist():
            words = []
            for vertex in triangle:
                n = vertex + 1
                if normals is not None:
                    words.append(f"{n}/{n if uvs is not None else ''}/{n}")
                else:
                    words.append(f"{n}/{n}" if uvs is not None else str(n))
            file.write(f"f {' '.join(words)}\n")
