"""The panels in the sidebars of the UV editor and of the 3D view, and the entries in the UV menu."""

import bpy

from . import livelink, operators, options, overlay, presets


class AUTOCUTS_PG_settings(bpy.types.PropertyGroup):
    """The options as they are in the panels; they are saved with the file."""

    __annotations__ = {
        **options.ALL,
        "selected": bpy.props.BoolProperty(name="Only selected", description="All other faces keep their UVs"),
        "directory": bpy.props.StringProperty(
            name="Folder", subtype="DIR_PATH", default="//", description="Where baked pictures go"
        ),
        "link_mode": bpy.props.EnumProperty(
            name="Maps come",
            items=[
                ("live", "Live", "Each better map, while the studio solves"),
                ("pause", "On pause", "Whenever the studio has stopped solving"),
                ("request", "On request", "Only when you press Get Map"),
            ],
            default="live",
            description="When maps of the studio are written to the objects",
            update=lambda settings, _context: livelink.set_mode(settings.link_mode),
        ),
        "figures": bpy.props.StringProperty(description="Figures of the map that was measured last"),
        "overlay": bpy.props.EnumProperty(
            name="Show",
            items=[
                ("NONE", "Nothing", ""),
                ("OVERLAPS", "Overlaps", "Red where the map lies on itself"),
                ("STRETCH", "Stretch", "Green: none, red: much, or turned over"),
                ("DENSITY", "Texel density", "Green: as most, red: more texels, blue: fewer"),
            ],
            description="What is drawn over the map in the UV editor",
            update=overlay.update_from_property,
        ),
    }


def _button(layout, settings, operator, text=""):
    """A button of an operator with the options of the panels."""
    kind = getattr(bpy.types, "AUTOCUTS_OT_" + operator)
    props = layout.operator(kind.bl_idname, text=text or kind.bl_label)
    for name in kind.__annotations__:
        setattr(props, name, getattr(settings, name))


def _fields(layout, settings, names):
    """The fields of options below each other."""
    column = layout.column()
    column.use_property_split = True
    column.use_property_decorate = False
    for name in names:
        column.prop(settings, name)


class _Sidebar:
    bl_region_type = "UI"
    bl_category = "Autocuts"


class _Main(_Sidebar):
    """Buttons, the progress of a job, and figures."""

    bl_label = "Autocuts"

    def draw_header_preset(self, _context):
        presets.AUTOCUTS_PT_presets.draw_panel_header(self.layout)

    def draw(self, context):
        layout, settings = self.layout, context.scene.autocuts
        job = operators.BackgroundMixin.current
        if job is not None:
            layout.label(text=job.status_text().split(",")[0])
            layout.operator("autocuts.stop", text="Stop (Escape)", icon="CANCEL")
            return
        column = layout.column(align=True)
        column.scale_y = 1.4
        _button(column, settings, "unwrap")
        column = layout.column(align=True)
        _button(column, settings, "unwrap_selected")
        for pair in (("pack", "separate"), ("straighten", "stack"), ("measure", "bake")):
            row = layout.row(align=True)
            for operator in pair:
                _button(row, settings, operator)
        _fields(layout, settings, ("selected", "overlay"))
        if settings.figures:
            box = layout.box().column(align=True)
            for part in settings.figures.split(", "):
                box.label(text=part)


class _Studio(_Sidebar):
    """The live link with the studio."""

    bl_label = "Studio"

    def draw(self, context):
        layout, session = self.layout, livelink.current
        layout.operator("autocuts.open_studio")
        _fields(layout, context.scene.autocuts, ("link_mode",))
        if session is None:
            return
        row = layout.row(align=True)
        row.operator("autocuts.get_map")
        row.operator("autocuts.end_link")
        box = layout.box().column(align=True)
        for text in (session.text, *session.notes[-3:]):
            box.label(text=text)


class _Unwrapping(_Sidebar):
    bl_label = "Unwrap"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        settings = context.scene.autocuts
        _fields(self.layout, settings, (*options.BOUND, "seams"))
        if settings.seams != "free":
            self.layout.column().prop(settings, "seams_from")
            if "sharp" in settings.seams_from:
                _fields(self.layout, settings, ("sharp_angle",))
        _fields(self.layout, settings, options.SOLVING)


class _Solver(_Sidebar):
    bl_label = "Solver"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        _fields(self.layout, context.scene.autocuts, options.EXPERT)


class _Packing(_Sidebar):
    bl_label = "Texture and Packing"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        settings = context.scene.autocuts
        _fields(self.layout, settings, ("use_image_size",))
        size = operators.image_size(context) if settings.use_image_size else None
        if size:
            self.layout.label(text=f"{size[0]} x {size[1]} texels, of the image")
        else:
            _fields(self.layout, settings, options.TEXTURE)
        _fields(self.layout, settings, (*options.PACKING, *options.PLACING, *options.SEPARATING, *options.SCOPE, *options.ROOM))


class _Taking(_Sidebar):
    bl_label = "From the Mesh"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        settings = context.scene.autocuts
        _fields(self.layout, settings, ("use_seams", "use_pins", "use_modifiers"))
        column = self.layout.column()
        column.use_property_split = True
        column.use_property_decorate = False
        for kind in ("seam", "texel"):
            if context.active_object:
                column.prop_search(settings, f"{kind}_group", context.active_object, "vertex_groups")
            column.prop(settings, f"{kind}_factor")


class _Baking(_Sidebar):
    bl_label = "Bake"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        settings = context.scene.autocuts
        self.layout.column().prop(settings, "maps")
        _fields(self.layout, settings, [name for name in options.BAKING if name != "maps"] + ["directory"])


def _panel(base, editor, space, parent):
    """The class of a panel in one of the editors."""
    name = f"AUTOCUTS_PT_{editor}{base.__name__.lower()}"
    members = {"bl_space_type": space, "bl_idname": name, "__doc__": base.__doc__}
    if parent:
        members["bl_parent_id"] = parent
    return type(name, (base, bpy.types.Panel), members)


def _panels():
    made = []
    for editor, space in (("uv", "IMAGE_EDITOR"), ("view", "VIEW_3D")):
        main = _panel(_Main, editor, space, "")
        made.append(main)
        made += [
            _panel(base, editor, space, main.bl_idname)
            for base in (_Studio, _Unwrapping, _Packing, _Taking, _Baking, _Solver)
        ]
    return tuple(made)


CLASSES = (AUTOCUTS_PG_settings, *_panels())


def draw_menu(self, context):
    """The entries in the UV menu."""
    self.layout.separator()
    for kind in operators.CLASSES[:-5]:
        name = kind.__name__.removeprefix("AUTOCUTS_OT_")
        self.layout.operator_context = "INVOKE_DEFAULT"
        _button(self.layout, context.scene.autocuts, name, f"Autocuts: {kind.bl_label}")
    self.layout.operator_context = "EXEC_REGION_WIN"


MENUS = ("IMAGE_MT_uvs", "VIEW3D_MT_uv_map")


def register():
    bpy.types.Scene.autocuts = bpy.props.PointerProperty(type=AUTOCUTS_PG_settings)
    for menu in MENUS:
        getattr(bpy.types, menu).append(draw_menu)


def unregister():
    for menu in MENUS:
        getattr(bpy.types, menu).remove(draw_menu)
    del bpy.types.Scene.autocuts
