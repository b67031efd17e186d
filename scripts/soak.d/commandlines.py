"""Random command lines: options of the program's own help with values that fit, nearly fit or do not."""
import re

import filefaults

COMMANDS = ["unwrap", "pack", "separate", "lightmap", "finish", "transfer", "bake", "lightbake", "check", "convert",
            "replay", "sample"]
INPUTS = ["in.obj", *4 * ["mapped.obj"], *4 * ["in.acproj"], "in.glb", "pair.gltf", "tiles.obj", "none.obj", "folder",
          "empty.obj", "folder/../mapped.obj", "mapped", "in.acproj/x", ""]
# {what the help calls a value: some that fit}
FITTING = {"X": ["0", "1", "4.1", ".5", "1e-3"], "N": ["0", "1", "2", "64", "1002"], "SECONDS": ["0", ".01", "1"],
           "N|WxH": ["16", "64", "64x32"], "PART": ["islands:1", "objects:object", "materials:x", "islands:1,2"],
           "FILE": ["mapped.obj", "in.obj", "in.acproj"], "FILES|all": ["all", "picture.png", "picture.png,other.png"],
           "NAME|N": ["1", "2", "UVMap"], "NAMES": ["object", "a,b#2"], "TEXELS": ["0", "4"],
           "RECTANGLE": ["0,0,.5,.5", "R0"], "LIST": ["uv", "sharp,hard", "position", "position,ao,normal"],
           "AZIMUTH,ELEVATION": ["0,90", "150,35"],
           "R,G,B": ["1,1,1", ".5"], "COLOR|FILE": [".5", "picture.png"], "DEGREES": ["0", "10"], "SET": ["1"],
           "X,Y,Z:X,Y,Z:WxH:R,G,B": ["0,3,0:0,0,0:1x1:5,5,5"], "MATERIAL:R,G,B": ["x:1,1,1"], "NAME": ["new", "UVMap"]}
ODD = ["", "-1", "nan", "inf", "1e308", "-0", "99999999999999999999", "x", "é体", "\n", "a" * 5000, "--", "-", "0x10",
       "1,2,3", "islands:0", "islands:999999999", "../..", "/dev/null", "/", "folder", "none/x.obj", ",", ":", "%s%n",
       "\u202e", "0 "]
OUTPUTS = ["out.obj", "out.acproj", "out.glb", "out.gltf", "out.ply", "out.dae", "out.fbx", "out.png", "out.exr",
           "out.xyz", "out", "", "none/out.obj", "folder", "mapped.obj", "in.acproj", "in.obj", "/dev/null", "/proc/x.obj",
           "out.stl"]
JOURNAL = "autocuts-batch.jsonl"
CHOSEN_APART = {"--output", "--report", "--layout", "--size", "--samples"}


def options_of(help_text):
    """{command: [(name, what the help calls its value or "")]}"""
    options = {command: [] for command in COMMANDS}
    for commands, rows in re.findall(r"^([a-z, ]+):\n((?:  .*\n)+)", help_text, re.MULTILINE):
        found = re.findall(r"^  (?:-\w, |--[\w-]+, )?(--[\w-]+)(?: ([^\s]+))?(?:  .*)?$", rows, re.MULTILINE)
        for command in COMMANDS if commands == "all commands" else re.split(r",\s*", commands):
            if command in options:
                options[command] += [row for row in found if row[0] not in CHOSEN_APART]
    return options


def value_of(rng, kind):
    if rng.random() < 0.1:
        return rng.choice(ODD)
    if "|" in kind and kind not in FITTING:
        return rng.choice([word for word in kind.split("|") if not word.isupper()] or ["1"])
    return rng.choice(FITTING.get(kind, ["1"]))


def command_line(rng, options):
    command = rng.choice(COMMANDS) if rng.random() < 0.97 else rng.choice(
        ["", "Unwrap", "-x", "--help", "--version", "é"])
    words = [command]
    if command in ("bake", "lightbake"):  # small jobs, so that many fit into the time
        words += ["--size", "16", "--samples", "1"]
    for _ in range(rng.choice([1] * 20 + [0, 2])):
        words.append(rng.choice(["torus", "bumpycube", *INPUTS] if command == "sample" else INPUTS))
    for _ in range(rng.choice([0, 1, 1, 2, 3, 6])):
        name, kind = rng.choice(options.get(command if rng.random() < 0.95 else "pack", options["check"]))
        value = [value_of(rng, kind)] if kind or rng.random() < 0.05 else []
        if value and rng.random() < 0.3:
            words.append(name + "=" + value[0])
        else:
            words += [name, *value] if rng.random() < 0.99 else [name]
    if command != "check" and rng.random() < 0.95:
        words += [rng.choice(["-o", "--output"]), rng.choice(OUTPUTS) if rng.random() < 0.4 else
                  {"bake": "out", "lightbake": "out.png"}.get(command, "out.obj")]
    for name, values in (("--report", ["report.json", "mapped.obj", "none/r.json", "folder", "out.obj"]),
                         ("--layout", ["layout.svg", "layout.png", "layout", "mapped.obj", "report.json"])):
        if command not in ("check", "convert", "replay", "sample") and rng.random() < 0.2:
            words += [name, rng.choice(values)]
    if rng.random() < 0.05:
        words.insert(rng.randrange(1, len(words) + 1), rng.choice(ODD))
    if rng.random() < 0.03:
        words.insert(rng.randrange(len(words) + 1), "--")
    return words


def prepare(program, rng, folder):
    """Writes what the command lines name. Returns the options of the program."""
    filefaults.prepare(program, rng, folder)
    (folder / "folder").mkdir()
    (folder / "empty.obj").touch()
    return options_of(program.run(["--help"]).out)


def contents(folder):
    """{name: bytes} of all files but what the program has said."""
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*")
            if path.is_file() and path.name not in ("stdout", "stderr")}


def faults(program, words, before, folder):
    """(what is wrong with a run, the run). \\param before contents of the folder"""
    run = program.run(words)
    found, after = program.faults(run), contents(folder)
    changed = [name for name in before if after.get(name) != before[name]]
    # Several inputs go into a folder, with a journal: what succeeds before one fails stays, and the report tells of all.
    stays = [name.removesuffix(JOURNAL) for name in after if name.endswith("/" + JOURNAL) and name not in before]
    beyond = [value for option, value in zip(words, words[1:])
              if option in ("-o", "--output") and value.startswith("..") and (folder / value / JOURNAL).is_file()]
    if stays or beyond:
        stays += [value for option, value in zip(words, words[1:]) if option == "--report"]
        stays += [word.removeprefix("--report=") for word in words if word.startswith("--report=")]
    was, now = ({name: data for name, data in files.items() if not name.startswith(tuple(stays))}
                for files in (before, after))
    if run.code in (1, 2) and was != now:
        found.append("a failed run wrote files")
    if run.code in (1, 2) and not run.err.strip():
        found.append("fails without a message")
    if any(name not in words and "--output=" + name not in words for name in changed):
        found.append("a file is changed that is not named")
    return found, run
