from typing import Callable, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

version: str

Progress = Optional[Callable[[float], bool]]

class Options:
    """autocuts_options of the C header."""

    quality: int
    max_distortion: float
    seams: int
    seams_from: int
    sharp_angle: float
    surface: int
    flat_rigid: int
    alike: int
    creases: int
    crease_strength: float
    visibility: float
    symmetry: int
    mirror: int
    align: int
    world_up: int
    texture_width: int
    texture_height: int
    margin: float
    tile_border: float
    rotation: int
    keep_scale: int
    pack_time: float
    density: float
    threads: int

class BakeOptions:
    """autocuts_bake_options of the C header."""

    width: int
    height: int
    tile: int
    samples: int
    rays: int
    cage: float
    cage_direction: int
    ray_reach: float
    curvature_radius: float
    thickness_limit: float
    dilation: int
    directx: int
    floats: int
    threads: int

class Arrays:
    """The arrays of a mesh, checked."""

    def __init__(
        self,
        positions: ArrayLike,
        faces: ArrayLike,
        face_sizes: Optional[ArrayLike],
        uvs: Optional[ArrayLike],
        objects: Optional[ArrayLike],
        materials: Optional[ArrayLike],
        normals: Optional[ArrayLike],
        colors: Optional[ArrayLike],
        locked: Optional[ArrayLike],
        edges: Optional[ArrayLike],
        edge_weights: Optional[ArrayLike],
        texel_weights: Optional[ArrayLike],
        pins: Optional[ArrayLike],
    ) -> None: ...

class Map:
    """A map of a mesh. Its arrays cannot be written and keep the map alive."""

    @property
    def uvs(self) -> NDArray[np.float64]:
        """(corners, 2): u, v of each corner of each face; NaN where there is none."""
    @property
    def islands(self) -> NDArray[np.int32]:
        """(faces,): the island of each face, from 0; -1 without UVs."""
    @property
    def seams(self) -> NDArray[np.uint8]:
        """(corners,): 1 when the edge from a corner to the next one of its face is a seam or a border."""
    @property
    def island_count(self) -> int: ...
    @property
    def stopped(self) -> bool: ...
    @property
    def outcome(self) -> dict[str, float]:
        """stopped, within_bound, hard_share, unmet_pins, unmet_joins, missing_seams."""
    def measure(self) -> dict[str, float]:
        """distortion, seam_norm, packing_efficiency, gutter_texels, islands, flipped_triangles, overlapping_pairs."""
    def draw(self, width: int, height: int, tile: int) -> NDArray[np.uint8]:
        """(height, width, 4): see render_layout()."""

class LiveSolve:
    def __init__(self, mesh: Arrays, options: Options) -> None: ...
    def steer(self, mesh: Arrays, options: Options) -> None: ...
    def wait(self, seconds: float) -> Optional[Map]: ...
    def rests(self) -> bool: ...

def call(
    name: str, mesh: Arrays, options: Options, progress: Progress, better: Optional[Callable[[Map], None]]
) -> Map:
    """Runs "unwrap", "finish", "pack", "separate", "align", "lightmap" or "take"."""

class Job:
    """One of these calls on a thread of its own; see autocuts.Job."""

    def __init__(self, name: str, mesh: Arrays, options: Options) -> None: ...
    @property
    def share(self) -> float: ...
    @property
    def newest(self) -> Optional[Map]: ...
    def stop(self) -> None: ...
    def wait(self, seconds: float) -> bool: ...
    def result(self) -> Map: ...
    def figures(self) -> dict[str, float]: ...

def transfer(
    source: Arrays, mesh: Arrays, match: int, options: Options, progress: Progress
) -> tuple[Map, dict[str, float]]: ...
def bake(
    mesh: Arrays,
    high: Optional[Arrays],
    maps: list[int],
    options: BakeOptions,
    cage: Optional[ArrayLike],
    progress: Progress,
) -> tuple[list[NDArray[np.float32]], int, int]: ...
