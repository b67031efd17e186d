"""Meshes: as arguments of all functions, and as files."""

import os
import shutil
import subprocess
import tempfile
from dataclasses import dataclass, field

import numpy as np

from . import _autocuts


@dataclass(eq=False)
class Mesh:
    """A polygon mesh, and what is wished of its map.

    Arrays "per corner" have a row for each entry of `faces`; an edge belongs to the corner at which it begins and ends at
    the next corner of its face. None: not given.
    """

    positions: np.ndarray  # (N, 3)
    faces: np.ndarray  # (F, 3) or (F, k) vertices; with face_sizes the flat list of the vertices of all corners
    face_sizes: np.ndarray = None  # (F,)
    uvs: np.ndarray = None  # (corners, 2), NaN where there is none
    objects: np.ndarray = None  # (F,) numbers from 0: seams run between objects
    materials: np.ndarray = None  # (F,) numbers from 0, -1 for none
    normals: np.ndarray = None  # (corners, 3): edges at which they differ are hard
    colors: np.ndarray = None  # (corners, 3), linear, 0 to 1; for bakes
    locked: np.ndarray = None  # (F,), not 0: the island of the face stays as it is in uvs
    edges: np.ndarray = None  # (corners,): 0 free, 1 always a seam, 2 never one
    edge_weights: np.ndarray = None  # (corners,): factors from 0 on what a seam along the edge costs
    texel_weights: np.ndarray = None  # (F,), .125 to 8: how much more texels per length the face gets
    pins: np.ndarray = None  # rows of corner, u, v: held there; or of corner, u, v, weight: pulled there by a spring
    object_names: list = field(default_factory=list)
    material_names: list = field(default_factory=list)
    path: str = None  # the file that it was read from

    @property
    def corner_count(self):
        return np.size(self.faces)

    def sizes(self):
        """(F,): the corners of each face."""
        if self.face_sizes is not None:
            return np.asarray(self.face_sizes)
        return np.full(len(self.faces), np.shape(self.faces)[1])

    def arrays(self):
        """What the binding takes. Raises ValueError for shapes that do not fit."""
        return _autocuts.Arrays(
            self.positions,
            self.faces,
            self.face_sizes,
            self.uvs,
            self.objects,
            self.materials,
            self.normals,
            self.colors,
            self.locked,
            self.edges,
            self.edge_weights,
            self.texel_weights,
            self.pins,
        )

    @staticmethod
    def load(path, uv_set=None):
        """Reads a file of any format that autocuts-cli reads, sessions too. uv_set: its name, or its number from 1.

        Raises ValueError with what the program says. The program is the one of the environment variable AUTOCUTS_CLI, or
        autocuts-cli where programs are looked for.
        """
        with tempfile.TemporaryDirectory() as folder:
            plain = os.path.join(folder, "model.obj")
            chosen = [] if uv_set is None else ["--uv-set", str(uv_set)]
            _run_program("convert", os.fspath(path), "-o", plain, *chosen)
            mesh = _read_obj(plain)
        mesh.path = os.fspath(path)
        return mesh

    def save(self, path, map=None):
        """Writes the mesh, with the UVs of a map or else its own. A file that was loaded is written with all that is in it,
        in the format that the name of the new one says.
        """
        uvs = self.uvs if map is None else np.asarray(getattr(map, "uvs", map))
        with tempfile.TemporaryDirectory() as folder:
            plain = os.path.join(folder, "model.obj")
            _write_obj(plain, self, uvs)
            if self.path is None:
                _run_program("convert", plain, "-o", os.fspath(path))
            elif uvs is None:
                _run_program("convert", self.path, "-o", os.fspath(path))
            else:
                _run_program("transfer", self.path, "--from", plain, "--match", "topology", "-o", os.fspath(path))

    def _repr_svg_(self):
        from .drawing import svg

        return None if self.uvs is None else svg(np.asarray(self.uvs), self.sizes())


def mesh_of(positions, faces, wishes):
    """The mesh that a function was given: one, or its arrays."""
    if isinstance(positions, Mesh):
        if faces is not None:
            raise TypeError("a Mesh has its faces")
        given = {name: value for name, value in wishes.items() if value is not None}
        return Mesh(**{**vars(positions), **given}) if given else positions
    if faces is None:
        raise TypeError("faces are missing")
    return Mesh(positions, faces, **wishes)


def _run_program(*arguments):
    program = os.environ.get("AUTOCUTS_CLI") or shutil.which("autocuts-cli")
    if program is None:
        raise ValueError("autocuts-cli was not found. Install it, or set AUTOCUTS_CLI to its path")
    ran = subprocess.run([program, *arguments], capture_output=True, text=True, check=False)
    if ran.returncode != 0:
        raise ValueError(ran.stderr.strip() or f"autocuts-cli ended with {ran.returncode}")


def _read_obj(path):
    """An OBJ as autocuts-cli writes it."""
    numbers = {"v": [], "vt": [], "vn": []}
    corners, sizes, texture, normal, objects, materials = [], [], [], [], [], []
    names, looks, current, look = [], [], -1, -1
    with open(path, encoding="utf-8") as file:
        for line in file:
            words = line.split()
            if not words or words[0].startswith("#"):
                continue
            kind = words[0]
            if kind in numbers:
                numbers[kind].append([float(word) for word in words[1:]])
            elif kind in ("o", "g"):
                name = line.split(maxsplit=1)[1].strip() if len(words) > 1 else ""
                if name not in names:
                    names.append(name)
                current = names.index(name)
            elif kind == "usemtl":
                name = line.split(maxsplit=1)[1].strip()
                if name not in looks:
                    looks.append(name)
                look = looks.index(name)
            elif kind == "f":
                sizes.append(len(words) - 1)
                objects.append(max(current, 0))
                materials.append(look)
                for word in words[1:]:
                    parts = [int(part) - 1 if part else -1 for part in word.split("/")] + [-1, -1]
                    corners.append(parts[0])
                    texture.append(parts[1])
                    normal.append(parts[2])
    points = np.array(numbers["v"], dtype=float).reshape(len(numbers["v"]), -1)
    mesh = Mesh(points[:, :3], np.array(corners), np.array(sizes), object_names=names, material_names=looks)
    mesh.uvs = _per_corner(numbers["vt"], texture, 2)
    mesh.normals = _per_corner(numbers["vn"], normal, 3)
    mesh.objects = np.array(objects) if len(names) > 1 else None
    mesh.materials = np.array(materials) if looks else None
    return mesh


def _per_corner(rows, indices, columns):
    """The rows that corners name, NaN where they name none; None where no corner does."""
    if not rows or max(indices, default=-1) < 0:
        return None
    values = np.vstack([np.array(rows, dtype=float)[:, :columns], np.full((1, columns), np.nan)])
    return values[indices]


def _write_obj(path, mesh, uvs):
    """Numbers are written so that they are read back as the same ones."""
    corners = np.asarray(mesh.faces).ravel().tolist()
    rows = [None] * len(corners)
    if uvs is not None:
        rows = [tuple(row) if row[0] == row[0] else None for row in np.asarray(uvs, dtype=float).reshape(-1, 2).tolist()]
    places = {row: i + 1 for i, row in enumerate(dict.fromkeys(row for row in rows if row is not None))}
    with open(path, "w", encoding="utf-8") as file:
        file.writelines(f"v {x!r} {y!r} {z!r}\n" for x, y, z in np.asarray(mesh.positions, dtype=float).tolist())
        file.writelines(f"vt {u!r} {v!r}\n" for u, v in places)
        objects = mesh.objects if mesh.objects is None else np.asarray(mesh.objects).tolist()
        current, at = None, 0
        for face, size in enumerate(mesh.sizes().tolist()):
            if objects is not None and objects[face] != current:
                current = objects[face]
                name = mesh.object_names[current] if current < len(mesh.object_names) else f"object{current}"
                file.write(f"o {name}\n")
            words = (
                f"{corners[c] + 1}/{places[rows[c]]}" if rows[c] is not None else f"{corners[c] + 1}"
                for c in range(at, at + size)
            )
            file.write(f"f {' '.join(words)}\n")
            at += size
