"""Jobs whose calls on files fail, one after the other, or at which the program is killed.

tests/fuzz/failingcalls.cpp makes the calls fail. What the jobs write must be all new or all old then.
"""
import base64
import errno
import json
import os
import shutil
import signal
from pathlib import Path

import bakes
import oddmeshes

ERRORS = [errno.EIO, errno.ENOSPC, errno.EACCES, errno.EDQUOT, errno.EROFS, errno.EMFILE, errno.ENOMEM, errno.EPERM,
          errno.EINTR, errno.EBUSY, errno.ENOENT]
KILL = "kill"
# name: the arguments, the outputs that belong together, then each output by itself.
JOBS = {
    **{"convert to " + suffix: (["convert", "in.obj", "-o", "out." + suffix], ["out." + suffix])
       for suffix in ("obj", "acproj", "glb", "ply", "dae", "fbx")},
    "convert to gltf": (["convert", "in.obj", "-o", "out.gltf"], ["out.gltf"]),
    "unwrap with report and layout": (["unwrap", "in.obj", "--quality", "draft", "--margin", "2",
                                       "--report", "report.json", "--layout", "layout.svg", "-o", "out.obj"],
                                      ["out.obj"], ["report.json"], ["layout.svg"]),
    "session in place": (["pack", "in.acproj", "-o", "in.acproj"], ["in.acproj"]),
    "bake": (["bake", "mapped.obj", "--maps", "position,ao,curvature", "--size", "16", "-o", "baked"],
             ["baked/mapped_position.png", "baked/mapped_ao.png", "baked/mapped_curvature.png"]),
    "bake into two folders": (["bake", "linked.obj", "--maps", "position,ao", "--size", "16", "-o", "baked"],
                              ["baked/linked_position.png", "baked/linked_ao.png"]),
    "light": (["lightbake", "mapped.obj", "--size", "16", "--samples", "1", "-o", "light.png"], ["light.png"]),
    "glTF pair in place": (["pack", "pair.gltf", "-o", "pair.gltf"], ["pair.gltf"]),
    "convert to obj with pictures": (["convert", "looks.glb", "-o", "out.obj"],
                                     ["out.obj", "out.mtl", "out_picture.png", "out_other.png"]),
    "bake of tiles": (["bake", "tiles.obj", "--maps", "position,ao", "--size", "16", "-o", "baked"],
                      [f"baked/tiles_{name}.{tile}.png" for name in ("position", "ao") for tile in (1001, 1002)]),
    "layout of tiles": (["pack", "tiles.obj", "--per", "object", "--texture-size", "64", "--pack-time", ".05",
                         "--layout", "layout.png", "-o", "out.obj"],
                        ["out.obj"], ["layout.1001.png", "layout.1002.png"]),
    "textures": (["transfer", "mapped.obj", "--from", "old.obj", "--textures", "picture.png,other.png",
                  "-o", "carried"], ["carried/picture.png", "carried/other.png"]),
}
# Files that lie elsewhere, and those that are not there before.
LINKS = {"baked/linked_ao.png": "elsewhere/ao.png"}
NEW = {"out.mtl", "out_picture.png", "out_other.png"}
JOBS = {name: (job[0], job[1:]) for name, job in JOBS.items()}
TWO_OBJECTS = [b"v 0 0 0", b"v 1 0 0", b"v 1 1 0", b"v 0 1 0", b"v 0 0 1", b"v 1 0 1", b"v 1 1 1", b"v 0 1 1",
               b"o one", b"f 1 2 3 4", b"o two", b"f 5 6 7 8"]


def prepare(program, rng, folder):
    """Writes the inputs of all jobs."""
    write = lambda name, lines: (folder / name).write_bytes(b"\n".join(lines) + b"\n")
    write("in.obj", oddmeshes.lines_of(rng, *oddmeshes.grid(rng, 6), False))
    for name in ("mapped.obj", "old.obj", "linked.obj"):
        program.run(["unwrap", "in.obj", "--quality", "draft", "-o", name])
    program.run(["convert", "mapped.obj", "-o", "in.acproj"])
    for name in ("picture.png", "other.png"):
        (folder / name).write_bytes(bakes.png(rng, 16, 16))
    program.run(["convert", "mapped.obj", "-o", "in.glb"])
    program.run(["convert", "in.glb", "-o", "in.gltf"])
    write_pair(folder)
    write("two.obj", TWO_OBJECTS)
    program.run(["unwrap", "two.obj", "--per", "object", "--quality", "draft", "-o", "tiles.obj"])
    write("looks.mtl", [b"newmtl a", b"map_Kd picture.png", b"newmtl b", b"map_Kd other.png"])
    lines, at = (folder / "mapped.obj").read_bytes().splitlines(), lambda k: lines.index(faces[k])
    faces = [line for line in lines if line.startswith(b"f ")]
    lines.insert(at(len(faces) // 2), b"usemtl b")
    lines.insert(at(0), b"usemtl a")
    write("looks.obj", [b"mtllib looks.mtl", *lines])
    program.run(["convert", "looks.obj", "-o", "looks.glb"])


def write_pair(folder):
    """A glTF file with its buffer beside it, made of one that holds it."""
    tree = json.loads((folder / "in.gltf").read_bytes())
    buffer = tree["buffers"][0]
    (folder / "pair.bin").write_bytes(base64.b64decode(buffer["uri"].partition(",")[2]))
    buffer["uri"] = "pair.bin"
    (folder / "pair.gltf").write_text(json.dumps(tree))


class Sweep:
    """One job in a folder of its own, again and again."""

    def __init__(self, program, library, rng, name, folder):
        self.program, self.library = program, str(library)
        self.arguments, self.sets = JOBS[name]
        self.folder, self.kept = Path(folder) / "work", Path(folder) / "kept"
        self.kept.mkdir()
        self.log = Path(folder) / "calls.log"
        program.folder = str(self.kept)
        prepare(program, rng, self.kept)
        self.output = {name for names in self.sets for name in names}
        for name in self.output:
            (self.kept / name).parent.mkdir(exist_ok=True)
            if name in LINKS:
                (self.kept / LINKS[name]).parent.mkdir()
                (self.kept / name).symlink_to(Path("..") / LINKS[name])
            if name in NEW or (self.kept / name).exists():
                continue
            # So that there is something to lose.
            shutil.copy(self.kept / ("in.gltf" if name.endswith(".gltf") else "mapped.obj"), self.kept / name)
        self.old = self.contents()
        self.others = self.other_contents(self.kept)
        self.reset()
        self.reference = self.run(0, KILL)
        self.calls = len(self.log.read_text().splitlines())
        self.new = self.contents()
        self.names = self.all_names()
        if self.reference.code != 0 or self.old == self.new:
            raise RuntimeError(f"{name}: the job changes nothing: {self.reference.err}")

    def all_names(self):
        return {str(path.relative_to(self.folder)) for path in self.folder.rglob("*")}

    def reset(self):
        shutil.rmtree(self.folder, ignore_errors=True)
        shutil.copytree(self.kept, self.folder, symlinks=True)
        self.program.folder = str(self.folder)

    def contents(self):
        folder = self.folder if self.folder.exists() else self.kept
        return {name: (folder / name).read_bytes() if (folder / name).exists() else None for name in self.output}

    def other_contents(self, folder):
        """What the job must leave alone."""
        paths = {str(path.relative_to(folder)): path for path in folder.rglob("*") if path.is_file()}
        ours = self.output | {LINKS.get(name) for name in self.output} | {"stdout", "stderr"}
        return {name: path.read_bytes() for name, path in paths.items() if name not in ours}

    def run(self, call, error):
        self.log.unlink(missing_ok=True)
        return self.program.run(self.arguments, more={
            "LD_PRELOAD": self.library, "FAILING_FOLDER": str(self.folder), "FAILING_LOG": str(self.log),
            "FAILING_CALL": str(call), "FAILING_WITH": str(error)})

    def same(self, name, content, expected):
        """Some formats hold the time, so that the bytes differ but not what they say."""
        if content == expected[name]:
            return True
        if content is None or expected is not self.new or not name.endswith((".fbx", ".dae", ".json")):
            return False
        return abs(len(content) - len(expected[name])) < 64

    def faults(self, call, error):
        """(what is wrong when that call fails, the run)"""
        self.reset()
        run = self.run(call, error)
        killed = error == KILL
        if killed:  # the next run that looks into the folder puts right what is mixed
            for name in dict.fromkeys((self.sets[0][0], self.sets[0][-1])):
                self.program.run(["check", name])
        now = self.contents()
        if killed and run.code == -signal.SIGKILL:
            faults = []
        else:
            faults = self.program.faults(run)
        for names in self.sets:
            old = all(self.same(n, now[n], self.old) for n in names)
            new = all(self.same(n, now[n], self.new) for n in names)
            each = all(self.same(n, now[n], self.old) or self.same(n, now[n], self.new) for n in names)
            if not each:
                faults.append("neither the old nor the new file")
            elif not old and not new:
                faults.append("some files of a set are new, others old")
            if run.code == 0 and not new:
                faults.append("no output in spite of success")
            if run.code in (1, 2) and len(self.sets) == 1 and not old and self.old != self.new:
                faults.append("a failed run changed the output")
        others = self.other_contents(self.folder)
        if any(others.get(name) != content for name, content in self.others.items()):
            faults.append("a file that is no output is changed")
        left = self.all_names() - self.names - {"stdout", "stderr"}
        if "no backup" in run.err:  # the next save makes the backup of this file
            left -= {name + ".new" for name in self.output}
        if killed:  # it may leave a single file that had no name before, and the lock of a session, which is void then
            single = tuple(names[0] + "." for names in self.sets if len(names) == 1)
            single += tuple(f".{name}.lock" for name in self.output if name.endswith(".acproj"))
            left = {name for name in left if not name.startswith(single)}
        if left:
            faults.append("other files are left")
        for name in now:
            if name.endswith(".gltf") and self.program.run(["check", name]).code != 0:
                faults.append("the glTF file cannot be read")
        return faults, run
