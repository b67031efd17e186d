"""Options by the names and words of autocuts-cli."""

from . import _autocuts

_SWITCH = {"off": 0, "auto": 1, "on": 2, False: 0, True: 2}
_WORDS = {
    "quality": {"draft": 0, "standard": 1, "best": 2},
    "seams": {"free": 0, "keep": 1, "only": 2},
    "surface": {"auto": 0, "organic": 1, "hard-surface": 2},
    "flat": {"rigid": 1, "free": 0},
    "alike": {"off": 0, "same-cuts": 1, "stack": 2},
    "creases": _SWITCH,
    "align": _SWITCH,
    "symmetry": {"off": 0, "auto": 2, "on": 1, False: 0, True: 1},
    "world_up": {"-": 0, "y": 1, "z": 2, "auto-y": 3, "auto-z": 4},
    "rotation": {"none": 0, "free": 1, 15: 15, 30: 30, 45: 45, 90: 90, 180: 180},
    "cage_direction": {"smooth": 0, "shading": 1, "corrected": 2},
}
_SOURCES = {"cuts": 1, "uv": 2, "sharp": 4, "hard": 8, "materials": 16}


def _number_of(name, value):
    words = _WORDS.get(name)
    if words is None:
        return value
    if value not in words:
        raise ValueError(f"{name} is one of {', '.join(map(str, words))}, not {value!r}")
    return words[value]


def _sources(names):
    total = 0
    for name in [names] if isinstance(names, str) else names:
        if name not in _SOURCES:
            raise ValueError(f"seams_from is made of {', '.join(_SOURCES)}, not {name!r}")
        total += _SOURCES[name]
    return total


def set_options(options, given):
    """Sets fields of options of the binding. Raises TypeError for a name that is none, ValueError for a word."""
    given = dict(given)
    if "texture_size" in given:
        size = given.pop("texture_size")
        columns, rows = size if hasattr(size, "__len__") else (size, size)
        side = "width" if hasattr(options, "width") else "texture_width"
        given.update({side: columns, side.replace("width", "height"): rows})
    for name, value in given.items():
        target = "flat_rigid" if name == "flat" else name
        if not hasattr(options, target):
            raise TypeError(f"there is no option {name!r}")
        setattr(options, target, _sources(value) if name == "seams_from" else _number_of(name, value))
    return options


def options_of(given):
    return set_options(_autocuts.Options(), given)
