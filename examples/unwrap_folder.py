"""Unwraps all models of a folder: unwrap_folder.py IN OUT [draft|standard|best]"""

import pathlib
import sys

import autocuts


def main(source, target, quality="standard"):
    target = pathlib.Path(target)
    target.mkdir(exist_ok=True)
    for path in sorted(pathlib.Path(source).iterdir()):
        if path.suffix.lower() not in (".obj", ".fbx", ".glb", ".gltf", ".dae"):
            continue
        try:
            mesh = autocuts.Mesh.load(path)
            made = autocuts.unwrap(mesh, uvs=None, quality=quality)
            mesh.save(target / path.name, made)
        except (ValueError, RuntimeError) as error:
            print(f"{path.name}: {error}")
            continue
        figures = made.measure()
        print(f"{path.name}: islands {figures['islands']}, distortion {figures['distortion']:.3f}")


if __name__ == "__main__":
    main(*sys.argv[1:])
