"""Gives a model a map by way of trimesh, which has to be installed: with_trimesh.py IN OUT"""

import sys

import autocuts
import trimesh


def main(source, target):
    mapped = autocuts.unwrap_trimesh(trimesh.load(source, force="mesh", process=False), quality="draft")
    mapped.export(target)
    print(f"vertices {len(mapped.vertices)}, triangles {len(mapped.faces)}")


if __name__ == "__main__":
    main(*sys.argv[1:])
