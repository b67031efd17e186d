"""The kinds of cases: each makes files from a random generator, runs the program and returns a Finding or None."""
import json
import re
import shutil
import signal
import subprocess
from dataclasses import dataclass, field
from pathlib import Path

import bakes
import commandlines
import conversions
import filefaults
import mutations
import oddmeshes
import sessions
from bakes import pick

# The list that the program has.
SOURCE = Path(__file__).resolve().parents[2] / "src/model/io/formats/meshformats.cpp"
FORMATS = re.findall(r'\{u"(\w+)"_s, u"[^"]+/', SOURCE.read_text()) + ["acproj"]
# CPU seconds in which a job ends after an interrupt, besides those for the files.
INTERRUPT_SECONDS = 0.3
OUTPUTS = ["obj", "obj", "acproj", "glb", "ply", "dae", "fbx"]


@dataclass
class Finding:
    cause: str
    arguments: list
    run: object
    input: Path = None
    again: object = None  # called with other bytes of the input: whether the cause is the same; None: not repeatable
    notes: list = field(default_factory=list)


def job_options(rng):
    number = lambda *choices: str(rng.choice(choices))
    return ["--quality", rng.choice(["draft", "draft", "standard"]), "--time-limit", "5", "--threads", "1",
            "--pack-time", "0.05"] + pick(
        rng, (.1, "--lambda", number(0, .3, .99, 1)), (.1, "--init", rng.choice(["tutte", "random", "uv"])),
        (.1, "--energy", "amips"), (.1, "--solver", "exact"), (.1, "--weights", "count"), (.1, "--symmetry"),
        (.2, "--max-distortion", number(4, 4.0001, 5, 1e6)), (.1, "--creases", "on"), (.1, "--visibility", "1"),
        (.2, "--seams", rng.choice(["keep", "only"]), "--seams-from", rng.choice(["sharp", "hard,materials", "uv"])),
        (.2, "--align", "on"), (.1, "--mirror"), (.1, "--world-up", rng.choice("yz")),
        (.1, "--texture-size", number(16, 64, 16384, "64x512", "1024x16")), (.1, "--margin", number(0, 1, 64)),
        (.1, "--rotation", rng.choice(["free", "180", "90", "45", "15", "none"])), (.1, "--tile", number(1002, 1011)),
        (.05, "--per", rng.choice(["object", "material"])),
        (.05, "--only", "islands:1"), (.05, "--layout", "layout.svg"), (.05, "--layout", "layout.png"))


class Cases:
    def __init__(self, program, files, library):
        """\\param library of tests/fuzz/failingcalls.cpp"""
        self.program, self.files, self.folder, self.library = program, files, None, library
        self.delays, self.delays_cpu, self.skipped = [], [], set()

    def write(self, name, data):
        path = self.folder / name
        path.write_bytes(data)
        return path

    def check_run(self, arguments, source, sound=False):
        """Runs a command that reads `source` and may write to the last argument."""
        report = self.folder / "report.json"
        old = b"the file before\n"
        output = self.folder / arguments[-1] if "-o" in arguments else None

        def attempt():
            report.unlink(missing_ok=True)
            if output:
                output.write_bytes(old)
            run = self.program.run(arguments)
            faults = self.program.faults(run)
            if output and run.code in (1, 2) and output.read_bytes() != old and arguments[0] != "replay":
                faults.append("a failed run changed the output")
            if output and run.code in (0, 3) and output.read_bytes() == old:
                faults.append("no output in spite of success")
            elif arguments[0] == "unwrap" and run.code in (0, 3) and "--only" not in arguments:
                strict = sound and not {"--no-pack", "--allow-overlaps"} & set(arguments)
                status = json.loads(report.read_text())["status"] if report.exists() else "done"
                if status in ("done", "bound_missed"):
                    session = arguments[1] if arguments[1].endswith(".acproj") else None
                    faults += self.program.map_faults(str(output), strict, session)
            return faults, run

        faults, run = attempt()
        if not faults:
            return None

        def again(data):
            source.write_bytes(data)
            return faults[0] in attempt()[0]

        return Finding(faults[0], arguments, run, source, again, faults[1:])

    def reading(self, rng, name, data):
        source = self.write(name, data)
        command = rng.choice(["check", "check", "convert", "replay" if name.endswith("acproj") else "check"])
        if command == "convert":
            return self.check_run(["convert", name, "-o", "out." + rng.choice(OUTPUTS)], source)
        return self.check_run([command, name], source)

    def mapping(self, rng, name, data, sound):
        command = rng.choice(["unwrap", "unwrap", "unwrap", "pack", "finish", "separate", "lightmap"])
        options = job_options(rng)
        if command != "unwrap":
            options = pick(rng, (.3, "--texture-size", "64"), (.3, "--tile", "1002")) + options[2:6]
        options += ["--report", "report.json"]
        return self.check_run([command, name, *options, "-o", "out." + rng.choice(OUTPUTS[:3])],
                              self.write(name, data), sound)

    def pick_file(self, rng):
        suffix = rng.choice(sorted(self.files))
        return suffix, rng.choice(self.files[suffix])

    def run(self, kind, rng, folder):
        """Runs a case of a kind in an empty folder."""
        self.program.folder, self.folder = folder, Path(folder)
        return getattr(self, kind)(rng)

    # The kinds. Each is called with a random generator.

    def odd_mesh(self, rng):
        _, sound, lines = oddmeshes.any_mesh(rng)
        kind = self.reading if rng.random() < 0.2 else self.mapping
        more = (sound,) if kind == self.mapping else ()
        return kind(rng, rng.choice(["in.obj", "mödel 体.obj"]), b"\n".join(lines) + b"\n", *more)

    def foreign_file(self, rng):
        suffix, path = self.pick_file(rng)
        data = path.read_bytes()
        small = len(data) < 20_000 and rng.random() < 0.5
        kind, more = (self.mapping, (False,)) if small else (self.reading, ())
        return self.naming(path, kind(rng, "in." + suffix, data, *more))

    def damaged_file(self, rng):
        suffix, path = self.pick_file(rng)
        other = rng.choice(self.files[suffix]).read_bytes()
        return self.naming(path, self.reading(rng, "in." + suffix, mutations.mutated(rng, path.read_bytes(), other)))

    @staticmethod
    def naming(path, finding):
        """The finding with a note from which file it comes."""
        if finding:
            finding.notes.append("made of " + path.name)
        return finding

    def session(self, rng, points, faces, uv=False):
        """The bytes of a session of a mesh."""
        self.write("mesh.obj", b"\n".join(oddmeshes.lines_of(rng, points, faces, uv)) + b"\n")
        run = self.program.run(["convert", "mesh.obj", "-o", "made.acproj"])
        return (self.folder / "made.acproj").read_bytes() if run.code == 0 else None

    def damaged_session(self, rng):
        data = self.session(rng, *oddmeshes.grid(rng, 4), uv=True)
        if data is None:
            return None
        return self.reading(rng, "in.acproj", sessions.damage(rng, data))

    def steered_session(self, rng):
        points, faces = rng.choice([oddmeshes.grid, oddmeshes.box])(rng)
        data = self.session(rng, points, faces, uv=rng.random() < 0.5)
        if data is None:
            return None
        return self.mapping(rng, "in.acproj", sessions.steer(rng, data, faces), False)

    def interrupt(self, rng):
        """Ctrl-C: a valid map soon after. The time is counted in CPU seconds, as the machine may be busy."""
        self.write("in.obj", b"\n".join(oddmeshes.lines_of(rng, *oddmeshes.grid(rng, rng.randint(20, 60)))) + b"\n")
        output = self.folder / ("out." + rng.choice(OUTPUTS))
        output.unlink(missing_ok=True)
        arguments = ["unwrap", "in.obj", "--threads", "1", "--quality",
                     rng.choice(["standard", "best"]), "-o", output.name]
        run = self.program.run(arguments, send=signal.SIGINT, after=rng.choice([0.0, 0.1, 1, 3]) * rng.random())
        faults = self.program.faults(run)
        if run.code not in (0, 3, 130):
            faults.append("exit code %d after an interrupt" % run.code)
        elif not output.exists():
            faults.append("no output after an interrupt")
        else:
            faults += ["after an interrupt: " + f for f in self.program.map_faults(str(output), True)]
            # Not part of these seconds: reading, where the signal comes as early as that, measuring and writing.
            files = (self.program.run(["check", output.name]).cpu +
                     self.program.run(["convert", output.name, "-o", "again.obj"]).cpu)
            if run.late > 0:
                self.delays.append(run.late)
                self.delays_cpu.append(run.late_cpu)
            if run.late_cpu > INTERRUPT_SECONDS * self.program.slowness + 2 * files:
                faults.append("ends late after an interrupt")
        if faults:
            return Finding(faults[0], arguments, run, self.folder / "in.obj", None,
                           faults[1:] + ["%.2f s, %.2f CPU s after the signal" % (run.late, run.late_cpu)])
        return None

    def bake_arguments(self, rng):
        """Writes the files of a bake into its folder. Returns its arguments, the last of which is the output."""
        write = lambda name: self.write(name, b"\n".join(bakes.mesh(rng, True)) + b"\n").name
        write("in.obj")
        kind = rng.choice(["bake", "bake", "lightbake", "transfer"])
        suffix, data = bakes.picture(rng)
        picture = self.write("picture." + suffix, data).name
        if kind == "lightbake":
            options = [picture if word == "picture" else word for word in bakes.light_options(rng, rng.random() < 0.5)]
            return [kind, "in.obj", *options, "--threads", "1", "-o", "out." + rng.choice(sorted(bakes.BEGINNINGS))]
        if kind == "transfer":
            options = ["--from", write("old.obj"), "--textures", picture]
            return [kind, "in.obj", *options, *pick(rng, (.5, "--size", bakes.size(rng))), "--threads", "1", "-o", "out"]
        options = bakes.bake_options(rng) + pick(rng, (.5, "--high", write("high.obj")), (.2, "--cage-file", "in.obj"))
        if rng.random() < 0.3:
            self.write("in.mtl", b"newmtl m\nKd 1 .5 0\nmap_Kd " + picture.encode() + b"\n")
            source = self.folder / "in.obj"
            source.write_bytes(b"mtllib in.mtl\nusemtl m\n" + source.read_bytes())
        return [kind, "in.obj", *options, "--threads", "1", "-o", "out"]

    def bake(self, rng):
        """A bake of odd models and pictures, some interrupted: whole pictures or none, and no old one lost."""
        arguments = self.bake_arguments(rng)
        output = self.folder / arguments[-1]
        names = [path.name for path in self.folder.iterdir()]
        interrupt = {"send": signal.SIGINT, "after": 0.3 * rng.random()} if rng.random() < 0.2 else {}
        source = self.folder / "in.obj"

        def attempt():
            run = self.program.run(arguments, **interrupt)
            faults = self.program.faults(run)
            written = list(output.rglob("*")) if output.is_dir() else [output] if output.exists() else []
            faults += ["a broken picture is left: " + Path(n).suffix for n in bakes.broken_files(output)] if (
                output.is_dir()) else []
            if run.code == 0 and not written and not interrupt and "--time-limit" not in arguments:
                faults.append("no output in spite of success")
            if run.code in (1, 2) and written:
                faults.append("a failed bake left pictures")
            more = {p.name for p in self.folder.iterdir()} - {*names, output.name, "stdout", "stderr"}
            if more - {output.stem + ".1001" + output.suffix}:
                faults.append("other files are left")
            return faults, run

        faults, run = attempt()
        if not faults:
            return None

        def again(data):
            source.write_bytes(data)
            return faults[0] in attempt()[0]

        return Finding(faults[0], arguments, run, source, None if interrupt else again, faults[1:])

    def chain(self, rng, name, before, words):
        """Converts a file over some formats to OBJ. Returns faults and the last run."""
        names = ["step%d.%s" % (k, rng.choice(conversions.FORMATS)) for k in range(rng.randint(1, 3))] + ["end.obj"]
        for source, target in zip([name, *names], names):
            run = self.program.run(["convert", source, "-o", target])
            faults = self.program.faults(run)
            if faults or run.code != 0:
                return faults or ["exit code %d of a conversion" % run.code], run, names
        after = conversions.figures((self.folder / names[-1]).read_bytes())
        return ["%s changed by a conversion" % w for w in conversions.differences(before, after, words)], run, names

    def chained(self, rng, name, data, before, words):
        source, state = self.write(name, data), rng.getstate()
        faults, run, names = self.chain(rng, name, before(data), words)
        if not faults:
            return None

        def again(other):
            rng.setstate(state)
            source.write_bytes(other)
            try:
                expected = before(other)
            except (IndexError, ValueError):
                return False  # too much was left out for it to be a model
            return faults[0] in self.chain(rng, name, expected, words)[0]

        return Finding(faults[0], ["convert", name, "-o", names[0]], run, source, again,
                       faults[1:] + ["over " + ", ".join(names)])

    def conversion(self, rng):
        """Over several formats and back: places, sizes, UVs, names and materials stay."""
        self.write("in.mtl", conversions.library(rng))
        return self.chained(rng, "in.obj", conversions.obj(rng), conversions.figures,
                            ["box", "area", "triangles", "UVs", "area of UVs", "objects", "materials"])

    def units(self, rng):
        """Files in other units and with other axes have their true size and stand upright in other formats."""
        name, data, metres = conversions.in_units(rng)
        return self.chained(rng, name, data, lambda _: conversions.figures(metres), ["box", "area", "triangles"])

    def large_output(self, rng):
        """(arguments, output, its bytes before, its bytes after success)"""
        self.write("in.obj", b"\n".join(oddmeshes.lines_of(rng, *oddmeshes.grid(rng, rng.randint(40, 90)))) + b"\n")
        output = self.folder / ("out." + rng.choice(OUTPUTS))
        arguments = ["convert", "in.obj", "-o", output.name]
        output.unlink(missing_ok=True)
        self.program.run(["sample", "torus", "-o", output.name])
        old = output.read_bytes()
        self.program.run(arguments)
        return arguments, output, old, output.read_bytes()

    def kill(self, rng):
        """SIGKILL: the old or the new file."""
        arguments, output, old, new = self.large_output(rng)
        figures = self.program.run(["check", output.name]).out
        for _ in range(5):
            output.write_bytes(old)
            run = self.program.run(arguments, send=signal.SIGKILL, after=0.3 * rng.random())
            # Some formats hold the time, so that the bytes differ but not what they say.
            if output.read_bytes() not in (old, new) and self.program.run(["check", output.name]).out != figures:
                return Finding("torn file after a kill", arguments, run, self.folder / "in.obj")
        return None

    def failed_call(self, rng):
        """Calls on files that fail, or at which the program is killed: all of a set new, or all old."""
        if not self.library.is_file() or self.program.sanitized:
            self.skipped.add("failed_call: only in a release build with its tests")
            return None
        sweep = filefaults.Sweep(self.program, self.library, rng, rng.choice(sorted(filefaults.JOBS)), self.folder)
        for _ in range(5):
            call, error = rng.randint(1, sweep.calls), rng.choice([*filefaults.ERRORS, filefaults.KILL])
            faults, run = sweep.faults(call, error)
            if faults:
                return Finding(faults[0], sweep.arguments, run, sweep.kept / "in.obj", None,
                               [*faults[1:], f"call {call} of {sweep.calls} with {error}"])
        return None

    def command_line(self, rng):
        """Options and values at random: an exit code, one line that says what is wrong, and no file that is not named
        is changed."""
        before = self.folder / "before"
        before.mkdir()
        self.program.folder = str(before)
        options = commandlines.prepare(self.program, rng, before)
        kept = commandlines.contents(before)
        for number in range(20):
            self.program.folder = str(self.folder / str(number))
            shutil.copytree(before, self.program.folder)
            words = commandlines.command_line(rng, options)
            faults, run = commandlines.faults(self.program, words, kept, self.folder / str(number))
            if faults:
                return Finding(faults[0], words, run, before / "in.obj", None, faults[1:])
        return None

    def full_disk(self, rng):
        """Not enough room for the output: the old file, exit code 1 and what to do."""
        arguments, output, old, new = self.large_output(rng)
        if rng.random() < 0.2:
            run = self.program.run(["check", "in.obj"], out="/dev/full")
            arguments, output, old = ["check", "in.obj", ">/dev/full"], self.folder / "in.obj", None
        elif rng.random() < 0.5:
            output.write_bytes(old)
            run = self.program.run(arguments, file_size=rng.randrange(4096, len(new) - 1))
        else:
            disk = self.folder / "disk"
            disk.mkdir(exist_ok=True)
            size = len(old) + len(new) // 2
            mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=%d" % size, "none", disk],
                                     capture_output=True, check=False)
            if mounted.returncode != 0:
                self.skipped.add("full_disk on a small tmpfs: this user may not mount one")
                return None
            try:
                output = disk / output.name
                output.write_bytes(old)
                arguments = arguments[:-1] + ["disk/" + output.name]
                run = self.program.run(arguments)
                faults = self.full_disk_faults(run, output.read_bytes() == old)
            finally:
                subprocess.run(["umount", disk], check=False)
            return Finding(faults[0], arguments, run, self.folder / "in.obj") if faults else None
        faults = self.full_disk_faults(run, old is None or output.read_bytes() == old)
        return Finding(faults[0], arguments, run, self.folder / "in.obj") if faults else None

    def full_disk_faults(self, run, kept):
        faults = self.program.faults(run)
        if run.code != 1:
            faults.append("exit code %d with a full disk" % run.code)
        if not kept:
            faults.append("the file before is gone with a full disk")
        return faults
