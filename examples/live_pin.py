"""A live solve whose first corner is pulled along a circle, drawn to pictures: live_pin.py IN FOLDER [FRAMES]"""

import math
import pathlib
import sys
import zlib

import autocuts


def write_png(path, image):
    """An (height, width, 4) array of bytes as a PNG."""
    height, width = image.shape[:2]

    def chunk(kind, data):
        body = kind + data
        return len(data).to_bytes(4, "big") + body + zlib.crc32(body).to_bytes(4, "big")

    head = width.to_bytes(4, "big") + height.to_bytes(4, "big") + bytes([8, 6, 0, 0, 0])
    rows = b"".join(b"\0" + row.tobytes() for row in image)
    path.write_bytes(
        b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")
    )


def main(path, folder, frames=12):
    folder = pathlib.Path(folder)
    folder.mkdir(exist_ok=True)
    live = autocuts.LiveSolve(autocuts.Mesh.load(path))
    live.wait(30)
    for frame in range(int(frames)):
        angle = 2 * math.pi * frame / int(frames)
        live.steer(pins=[[0, 0.5 + 0.2 * math.cos(angle), 0.5 + 0.2 * math.sin(angle)]])
        made = live.wait(30)
        write_png(folder / f"frame{frame:03}.png", autocuts.render_layout(made, 512))
    print(f"{frames} pictures, islands {made.island_count}")


if __name__ == "__main__":
    main(*sys.argv[1:])
