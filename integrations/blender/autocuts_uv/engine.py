"""The engine behind one interface: the Python module autocuts, or the program autocuts-cli.

Both give the same maps, except for "align". The module knows fewer options; what it lacks goes to the program, which gives no
map before it ends. Nothing here touches Blender's data. Jobs are generators, see jobs.
"""

import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
from dataclasses import dataclass, field

import numpy as np

from . import figures, jobs, session

try:
    import pty
except ImportError:  # Windows: no progress from the program
    pty = None


class EngineError(Exception):
    """A job failed; the text is for the user."""


@dataclass
class Request:
    """A job: a command of autocuts-cli, the Model it works on, and the options that differ from their defaults, named
    as on the command line with _ in place of -. "align" is no command of autocuts-cli: it turns islands to the axes and
    straightens them."""

    command: str
    model: object
    options: dict = field(default_factory=dict)


@dataclass
class Outcome:
    """What came of a job."""

    uvs: np.ndarray | None = None  # (C, 2); None when it was stopped before there was a map
    figures: dict = field(default_factory=dict)  # see FIGURES
    notes: list = field(default_factory=list)  # warnings, in words
    stopped: bool = False


@dataclass
class LiveMap:
    """The best map so far of a job that runs, as lines to be drawn: the UVs of both ends of edges."""

    seams: np.ndarray  # (N, 2, 2) at seams and borders
    inner: np.ndarray  # (M, 2, 2) all others


# The figures of the module, and their names in the reports of the program.
FIGURES = {
    "islands": "charts",
    "distortion": "sym_dirichlet",
    "seam_norm": "seam_norm",
    "packing_efficiency": "packing_efficiency",
    "gutter_texels": "min_gutter_texels",
    "flipped_triangles": "flipped",
    "overlapping_pairs": "overlap_pairs",
}

_MODULE_NAMES = {"for": "surface"}
_MODULE_PLAIN = {
    *("quality", "max_distortion", "seams", "flat", "alike", "creases", "crease_strength", "visibility", "symmetry"),
    *("mirror", "align", "world_up", "texture_size", "margin", "tile_border", "keep_scale", "pack_time", "density"),
    "threads",
}
_MODULE_WORDS = {
    "rotation": {"none": "none", "free": "free", "15": 15, "30": 30, "45": 45, "90": 90, "180": 180},
}
_FAREWELL = 1  # seconds that a program has to end


def cpu_count():
    """Threads for a job when the user has not said how many."""
    return os.cpu_count() or 1


class ModuleEngine:
    """Jobs by the Python module, which works on this process's memory."""

    name = "Python module"
    _calls = {
        **{command: command for command in ("unwrap", "finish", "pack", "separate", "align")},
        "check": "take",
    }

    def __init__(self, module):
        self._module = module

    def lacks(self, request):
        """Why the module cannot do a job; empty when it can."""
        model = request.model
        if request.command not in self._calls:
            return f"the command {request.command}"
        if not model.scope.all():
            return "jobs on a part of a model"
        if request.command == "align" and ("density" in request.options or figures.any_flipped(model)):
            return "how to straighten at another density, or flipped triangles"
        for name, value in request.options.items():
            if not (name in _MODULE_PLAIN or name in _MODULE_NAMES or value in _MODULE_WORDS.get(name, {})):
                return f"{name} {value}"
        return ""

    def _options(self, given):
        options = {"threads": cpu_count()}
        for name, value in given.items():
            options[_MODULE_NAMES.get(name, name)] = _MODULE_WORDS.get(name, {}).get(value, value)
        return options

    def run(self, request):
        try:
            job = self._begun(request)
            shown = lines = None
            while not job.wait():
                newest = job.newest
                if newest is not shown:
                    shown, lines = newest, self._drawn(request.model, newest)
                if (yield jobs.Progress(job.share, lines)):
                    job.stop()
            made, found = job.result(), job.figures()
        except (ValueError, RuntimeError, MemoryError) as error:
            raise EngineError(str(error)) from error
        return Outcome(np.array(made.uvs), found, self._notes(made.outcome), made.stopped)

    @staticmethod
    def _wishes(request):
        model = request.model
        wishes = {"face_sizes": model.face_sizes, "objects": model.face_objects, "texel_weights": model.texel_weights}
        if request.command == "unwrap":
            wishes.update(edges=model.cuts.astype(np.uint8), edge_weights=model.seam_weights)
        pinned = np.flatnonzero(model.pins)
        if len(pinned) and request.command != "check":
            wishes["pins"] = np.column_stack([pinned, model.uvs[pinned]])
        return wishes

    def _begun(self, request):
        model = request.model
        given = {**self._wishes(request), **self._options(request.options)}
        return self._module.Job(self._calls[request.command], model.positions, model.corners, uvs=model.uvs, **given)

    @staticmethod
    def _drawn(model, made):
        lines = figures.map_lines(model.face_sizes, made.uvs)
        is_seam = made.seams.astype(bool)
        return LiveMap(lines[is_seam], lines[~is_seam])

    @staticmethod
    def _notes(outcome):
        notes = []
        if not outcome["within_bound"]:
            notes.append("the distortion is above the bound")
        if outcome["unmet_pins"]:
            notes.append(f"{outcome['unmet_pins']:.0f} pins could not be reached")
        return notes


def command_words(options):
    """Options as words for autocuts-cli: {"margin": 4, "symmetry": True} becomes --margin 4 --symmetry."""
    words = []
    for name, value in options.items():
        words.append("--" + name.replace("_", "-"))
        if isinstance(value, tuple):
            words.append("x".join(str(part) for part in value))
        elif value is not True:
            words.append(str(value))
    return words


# What the program does for "align": it keeps the seams and solves the islands anew.
_ALIGNING = {"seams": "only", "seams_from": "uv", "align": "on", "quality": "draft"}


class _Said:
    """What autocuts-cli says on a terminal: a line that it overwrites, and messages."""

    _share = re.compile(rb"(\d+) %")
    _origin = re.compile(r"autocuts-cli: (warning: |note: )?")

    def __init__(self):
        self.messages = []
        self.share = 0.0
        self._rest = b""

    def take(self, data):
        """Takes bytes as they come."""
        *lines, self._rest = re.split(rb"[\r\n]+", self._rest + data)
        for line in lines:
            share = self._share.search(line)
            text = line.decode(errors="replace").strip()
            if self._origin.match(text):
                self.messages.append(self._origin.sub("", text))
            elif share:
                self.share = int(share[1]) / 100


class _Terminal:
    """Where autocuts-cli says what it has to say: a terminal, or without any a file."""

    def __init__(self):
        if pty:
            self._own, self.end = pty.openpty()
            os.set_blocking(self._own, False)
        else:
            self._file = tempfile.TemporaryFile()
            self.end = self._file.fileno()

    def started(self):
        """The program has its end; this one is not needed any more."""
        if pty and self.end is not None:
            os.close(self.end)
            self.end = None

    def read(self):
        """What was said since the last call; without a terminal nothing before the end."""
        if not pty:
            return b""
        try:
            return os.read(self._own, 1 << 16)
        except OSError:  # nothing now, or the other end is closed
            return b""

    def close(self):
        """What is left, at the end of the program."""
        self.started()
        if pty:
            rest = b"".join(iter(self.read, b""))
            os.close(self._own)
            return rest
        self._file.seek(0)
        with self._file as file:
            return file.read()


class CommandEngine:
    """Jobs by autocuts-cli, in a process of their own; models go there and back as sessions."""

    name = "autocuts-cli"

    def __init__(self, program):
        self._program = program

    def lacks(self, _request):
        """Why the program cannot do a job; empty when it can."""
        return ""

    def call(self, words, out=subprocess.DEVNULL):
        """Runs the program, as a job. Returns its exit code and its messages. out: a file for what it prints."""
        terminal, said = _Terminal(), _Said()
        try:
            with subprocess.Popen(
                [self._program, *words], stdin=subprocess.DEVNULL, stdout=out, stderr=terminal.end
            ) as process:
                terminal.started()
                try:
                    yield from self._follow(process, terminal, said)
                except GeneratorExit:
                    self._end(process)
                    raise
        finally:
            said.take(terminal.close() + b"\n")
        # Stopped before the program listens to it.
        return 130 if process.returncode == -signal.SIGINT else process.returncode, said.messages

    @staticmethod
    def _follow(process, terminal, said):
        asked = os.name == "nt"  # it cannot be asked there
        while process.poll() is None:
            said.take(terminal.read())
            if (yield jobs.Progress(said.share)) and not asked:
                process.send_signal(signal.SIGINT)
                asked = True

    @staticmethod
    def _end(process):
        """Nobody wants its result: it may remove its own files, but not for long."""
        process.terminate()
        try:
            process.wait(_FAREWELL)
        except subprocess.TimeoutExpired:
            process.kill()

    def run(self, request):
        with tempfile.TemporaryDirectory(prefix="autocuts_") as folder:
            model, made, report = (os.path.join(folder, name) for name in ("in.acproj", "out.acproj", "report.json"))
            command, options = request.command, request.options
            if command == "align":
                command, options = "unwrap", {**options, **_ALIGNING}
            words = [command, model, *self._scope_words(request, model), *command_words(options)]
            if request.command == "check":
                with open(report, "wb") as out:
                    code, messages = yield from self.call([*words, "--json"], out)
            else:
                code, messages = yield from self.call([*words, "-o", made, "--report", report])
            messages = [message.removeprefix(f"{model}: ") for message in messages]
            if code not in (0, 3, 130):
                raise EngineError(messages[-1] if messages else f"autocuts-cli ended with {code}")
            return self._outcome(request, code, messages, made, report)

    @staticmethod
    def _scope_words(request, path):
        """Writes the session. A part of a model is told by materials: "s0" may change, "k0" stays."""
        model = request.model
        if model.scope.all():
            session.write(path, model, model.materials, model.face_materials)
            return []
        kinds = model.face_materials + 1
        count = int(kinds.max()) + 1
        names = [f"k{i}" for i in range(count)] + [f"s{i}" for i in range(count)]
        session.write(path, model, names, kinds + count * model.scope)
        chosen = sorted({f"s{kind}" for kind in kinds[model.scope]})
        return ["--only", "materials:" + ",".join(chosen)]

    @staticmethod
    def _outcome(request, code, messages, made, report):
        outcome = Outcome(notes=messages, stopped=code == 130)
        if os.path.exists(made):
            outcome.uvs = session.read_uvs(made, request.model.corners)
        if os.path.exists(report):
            with open(report, encoding="utf-8") as file:
                figures = json.load(file)
            outcome.figures = {name: figures.get(key) for name, key in FIGURES.items()}
        return outcome


def pictures_of(report):
    """Paths of the pictures in the report of a bake."""
    with open(report, encoding="utf-8") as file:
        return json.load(file)["files"]


def find_module(folder):
    """The Python module, or None. folder: where to look first; may be empty."""
    if folder and folder not in sys.path:
        sys.path.insert(0, folder)
    try:
        import autocuts
    except ImportError:
        return None
    return autocuts


def find_program(path):
    """The path of autocuts-cli, or None. path: of the program, or empty to look in PATH."""
    return shutil.which(path or "autocuts-cli")


def find_studio(path, program_path):
    """The path of the studio, or None. path: of it, or empty to look beside autocuts-cli, then in PATH."""
    if path:
        return shutil.which(path)
    program = find_program(program_path)
    beside = shutil.which("autocuts", path=os.path.dirname(os.path.realpath(program))) if program else None
    return beside or shutil.which("autocuts")


def engines(kind, module_folder, program_path):
    """The engines that are there, the preferred one first. kind: "AUTO", "MODULE" or "PROGRAM"."""
    found = []
    if kind != "PROGRAM" and (module := find_module(module_folder)):
        found.append(ModuleEngine(module))
    if kind != "MODULE" and (program := find_program(program_path)):
        found.append(CommandEngine(program))
    return found


def engine_for(request, available):
    """The first engine that can do a job."""
    if not available:
        raise EngineError("Autocuts was not found: say in the preferences of this add-on where it is")
    reasons = []
    for candidate in available:
        reason = candidate.lacks(request)
        if not reason:
            return candidate
        reasons.append(f"the {candidate.name} does not know {reason}")
    raise EngineError("; ".join(reasons))
