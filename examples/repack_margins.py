"""Packs the map of a model for several sizes of texture: repack_margins.py IN"""

import sys

import autocuts


def main(path):
    mesh = autocuts.Mesh.load(path)
    if mesh.uvs is None:
        mesh.uvs = autocuts.unwrap(mesh, quality="draft").uvs
    for size in (256, 512, 1024, 2048):
        packed = autocuts.pack(mesh, texture_size=size, margin=4)
        figures = packed.measure()
        print(f"{size}: {100 * figures['packing_efficiency']:.1f} % used, gutter {figures['gutter_texels']:.1f} texels")


if __name__ == "__main__":
    main(*sys.argv[1:])
