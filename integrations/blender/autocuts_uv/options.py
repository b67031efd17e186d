"""The options of the command line as properties of Blender: the same names, defaults and ranges.

A name that is a word of Python has _ behind it. given() makes the options of a Request of them.
"""

from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty, IntVectorProperty, StringProperty


def _choice(words, default, description, name):
    items = [(word, word.replace("-", " ").capitalize(), "") for word in words.split()]
    return EnumProperty(name=name, items=items, default=default, description=description)


def _flag(description, name, default=False):
    return BoolProperty(name=name, default=default, description=description)


def _number(default, low, high, description, name, **more):
    return FloatProperty(name=name, default=default, min=low, max=high, description=description, **more)


BOUND = {
    "max_distortion": _number(
        4.1,
        4.0001,
        1e6,
        "Find the shortest seams with which the mean symmetric Dirichlet energy stays below this; 4 is no distortion",
        "Max distortion",
        soft_max=6,
        step=1,
        precision=3,
    ),
    "quality": _choice("draft standard best", "standard", "How long to search for shorter seams", "Quality"),
}

SEAMING = {
    "seams": _choice(
        "free keep only",
        "free",
        "Whose seams: those of the search; the given ones and what the bound needs besides; exactly the given ones",
        "Seams",
    ),
    "seams_from": EnumProperty(
        name="Given seams",
        options={"ENUM_FLAG"},
        items=[
            ("cuts", "Marked", "Edges marked as seams", 1),
            ("uv", "UV map", "The seams of the map that is there", 2),
            ("sharp", "Bent", "Edges bent by more than an angle", 4),
            ("hard", "Sharp", "Edges marked as sharp", 8),
            ("materials", "Materials", "Edges between materials", 16),
        ],
        default={"cuts", "uv"},
        description="What the given seams of Keep and Only are",
    ),
    "sharp_angle": _number(30, 0, 180, "Edges bent by more degrees than that are given seams", "Angle"),
}

SOLVING = {
    "for_": _choice(
        "auto organic hard-surface",
        "auto",
        "What the model is like: curved, or flat faces with sharp edges; auto recognises each connected part",
        "For",
    ),
    "flat": _choice("rigid free", "rigid", "Flat faces and what unrolls without stretch keep their shape", "Flat"),
    "alike": _choice(
        "off same-cuts stack",
        "same-cuts",
        "Parts that are copies of each other get the same seams; stack also lays their islands on each other",
        "Alike",
    ),
    "creases": _choice("off auto on", "auto", "Put seams along sharp edges", "Creases"),
    "crease_strength": _number(0.8, 0, 1, "Part of its cost that a seam on a sharp edge saves", "Crease strength"),
    "visibility": _number(0, 0, 1, "How much seams prefer hidden places", "Visibility"),
    "symmetry": _flag("Make symmetric cuts on every symmetric mesh", "Symmetry"),
    "no_symmetry": _flag("Do not make symmetric cuts where they hardly cost more", "No symmetry"),
    "align": _choice(
        "off auto on",
        "off",
        "Turn islands to the axes, and make straight in the map what is straight on the model",
        "Align",
    ),
    "mirror": _flag("Make the maps of symmetric islands symmetric", "Mirror"),
    "world_up": _choice(
        "- y z auto-y auto-z",
        "auto-z",
        "Turn islands so that this direction of the model is up in the map; auto: where that hardly costs texel density",
        "World up",
    ),
    "allow_overlaps": _flag("Do not cut islands that overlap themselves", "Allow overlaps"),
    "no_pack": _flag("Leave the islands where the solver put them", "Do not pack"),
}

EXPERT = {
    "init": _choice("rigid tutte random uv", "rigid", "Where the solver starts from", "Start"),
    "weights": _choice("length count", "length", "What a seam costs: its length, or 1 per edge", "Seam cost"),
    "energy": _choice("symmetric-dirichlet amips", "symmetric-dirichlet", "How distortion is measured", "Energy"),
    "solver": _choice("fast exact", "fast", "Conjugate gradients, or a full factorisation in every step", "Solver"),
    "seed": IntProperty(name="Seed", default=1, min=0, max=2000000000, description="Seed of everything random"),
    "time_limit": _number(0, 0, 1e9, "Stop after so many seconds with the best map so far; 0: no limit", "Time limit"),
}

TEXTURE = {
    "texture_size": IntVectorProperty(
        name="Texture size",
        size=2,
        default=(2048, 2048),
        min=1,
        max=65536,
        description="Width and height of the texture in texels",
    ),
}

PACKING = {
    "margin": _number(8, 0, 4096, "Texels between islands, and half of it to the border", "Margin"),
    "tile_border": _number(
        -1, -1, 4096, "Texels between the islands and the border of the tile; below 0: half the margin", "Border"
    ),
    "rotation": _choice("free 180 90 45 30 15 none", "free", "How islands may be turned, in degrees", "Rotation"),
    "tile": IntProperty(name="Tile", default=1001, min=1001, max=2000, description="UDIM tile to pack into"),
    "pack_time": _number(
        0.5, 0, 3600, "Effort that goes into packing, in CPU seconds of a usual machine", "Pack time", soft_max=30
    ),
    "per": _choice("- object material", "-", "Give every object or material a UDIM tile of its own", "Tile per"),
    "density": _number(
        0, 0, 1e12, "Texels per unit of the scene, in as many UDIM tiles as that needs; 0: fill the tile", "Density"
    ),
}

PLACING = {
    "keep_scale": _flag("Keep the size of the islands; otherwise all get the same texel density", "Keep scale"),
    "tiles": _choice("keep one", "keep", "Islands stay in their UDIM tiles, or all go into one", "Tiles"),
}

# Of jobs on a part of the faces.
SCOPE = {
    "border": _choice(
        "attached free",
        "attached",
        "Where the border of the chosen faces runs through an island, the map stays whole, or is cut there",
        "Border of the faces",
    ),
}
ROOM = {
    "fill_tiles": _flag("Pack the chosen faces into the free room beside the others, at their texel density", "Fill"),
}

SEPARATING = {
    "separate_by": _choice(
        "short-seams growing",
        "short-seams",
        "Cut between overlapping layers along the shortest seam, or into regions that grow",
        "Separate by",
    ),
}

BAKING = {
    "maps": EnumProperty(
        name="Maps",
        options={"ENUM_FLAG"},
        items=[
            (word, word.replace("-", " ").capitalize(), "", 1 << number)
            for number, word in enumerate(
                (
                    "normal",
                    "object-normal",
                    "ao",
                    "bent-normal",
                    "curvature",
                    "thickness",
                    "position",
                    "color",
                    "material-id",
                    "height",
                )
            )
        ],
        default={"normal", "ao"},
        description="What to bake",
    ),
    "samples": _choice("1 4 9 16 36 64", "4", "Places in each texel that are baked and averaged", "Samples"),
    "rays": IntProperty(name="Rays", default=64, min=1, max=65536, description="Rays per texel"),
    "cage": _number(
        0.02,
        1e-6,
        1,
        "How far the detailed model is looked for, as a share of the diagonal of the bounding box",
        "Cage",
        precision=4,
    ),
    "cage_direction": _choice(
        "smooth shading corrected", "smooth", "Which normals the rays follow from the surface", "Cage direction"
    ),
    "by_name": _flag("Objects see those of the same name only", "By name"),
    "dilation": IntProperty(
        name="Dilation", default=16, min=0, max=1024, description="Texels around islands that are filled"
    ),
    "format": _choice("png tif tga exr", "png", "Format of the pictures", "Format"),
    "directx": _flag("Tangent space normals with green down", "DirectX normals"),
    "color_from": _choice("auto textures vertices materials", "auto", "What color shows", "Color from"),
}

# Of the add-on alone: what is taken over from Blender.
TAKING = {
    "use_image_size": _flag("Use the size of the active image as the texture size", "Size of the image", True),
    "use_seams": _flag("Edges marked as seams are always seams", "Marked seams", True),
    "use_pins": _flag("Pinned UVs stay where they are", "Pins", True),
    "use_modifiers": _flag("Measure the shape with modifiers that change no topology", "Modifiers", True),
    "seam_group": StringProperty(name="Seam weights", description="Vertex group that makes seams cheaper or dearer"),
    "seam_factor": _number(
        10, 1e-3, 1e3, "Cost of a seam where the vertex group is 1; below 1 it attracts seams", "Seam factor"
    ),
    "texel_group": StringProperty(name="Texel weights", description="Vertex group that gets more texels"),
    "texel_factor": _number(2, 0.125, 8, "Texels per length where the vertex group is 1", "Texel factor"),
}

UNWRAP = {**BOUND, **SEAMING, **SOLVING, **EXPERT, **TEXTURE, **PACKING, **SCOPE}
PACK = {**TEXTURE, **PACKING, **PLACING, **SCOPE, **ROOM}
SEPARATE = {**SEPARATING, **TEXTURE, **PACKING, **SCOPE, "tiles": PLACING["tiles"]}
# Options that keep the seams and solve the islands anew.
RESHAPE = {"max_distortion": BOUND["max_distortion"], **TEXTURE, **PACKING, **SCOPE}
BAKE = {**BAKING, **TEXTURE}
ALL = {**UNWRAP, **PACK, **SEPARATE, **BAKE, **TAKING}


# Their defaults are not those of the command line: in Blender z is up.
OWN_DEFAULTS = {"world_up"}


def word_of(name):
    """The name of an option on the command line, with _ in place of -."""
    return name.rstrip("_")


def default_of(name):
    """The default of a property."""
    default = ALL[name].keywords["default"]
    return tuple(default) if isinstance(default, (tuple, list)) else default


def value_of(owner, name):
    """The value of a property; several numbers as a tuple."""
    value = getattr(owner, name)
    if isinstance(ALL[name].keywords["default"], tuple):
        return tuple(value)
    if ALL[name].function is FloatProperty:
        return float(f"{value:.7g}")  # as it was typed, not as single precision has it
    return value


def _listed(owner, name):
    """The words of a property that may be several, in the order of their items."""
    chosen = getattr(owner, name)
    return ",".join(item[0] for item in ALL[name].keywords["items"] if item[0] in chosen)


def given(owner, names):
    """The options that differ from the defaults of the command line, as for a Request."""
    options = {}
    for name in names:
        value = value_of(owner, name)
        is_default = value == default_of(name) and name not in OWN_DEFAULTS
        if is_default or name in ("seams_from", "sharp_angle"):
            continue
        options[word_of(name)] = _listed(owner, name) if isinstance(value, set) else value
    if "seams_from" in names and owner.seams != "free":
        sources = _listed(owner, "seams_from").replace("sharp", f"sharp:{value_of(owner, 'sharp_angle'):g}")
        # Edges between materials are cut by the add-on: a part of a model is told by materials.
        words = [word for word in sources.split(",") if word and word != "materials"]
        options["seams_from"] = ",".join(words) if words else "cuts"
    return options
