from typing import Callable, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

version: str

class Options:
    quality: int
    max_distortion: float
    surface: int
    symmetry: int
    align: int
    texture_width: int
    texture_height: int
    margin: float
    border: float
    rotation: int
    keep_scale: int
    pack_effort: float
    density: float
    threads: int

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
    def measure(self) -> dict[str, float]:
        """distortion, seam_norm, packing_efficiency, gutter_texels, islands, flipped_triangles, overlapping_pairs."""

def _call(
    positions: ArrayLike,
    faces: ArrayLike,
    face_sizes: Optional[ArrayLike],
    uvs: Optional[ArrayLike],
    objects: Optional[ArrayLike],
    locked: Optional[ArrayLike],
    edges: Optional[ArrayLike],
    options: Options,
    progress: Optional[Callable[[float], bool]],
) -> Map: ...

unwrap = pack = separate = take = _call
