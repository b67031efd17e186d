"""The operators. Those that may take long run in the background when they are called from the window; in scripts they
wait for the result."""

import os

import bpy

from . import api, baking, engine, jobs, livelink, meshdata, options, overlay

_OF_PARTS = {*options.SCOPE, *options.ROOM}  # they mean nothing where all faces may change
_TICK = 0.1  # seconds between two looks at a job


class Failure(Exception):
    """A job cannot begin; the text is for the user."""


def image_size(context):
    """Width and height of the image in the UV editor, or of the active texture of the material; None without one."""
    image = getattr(context.space_data, "image", None)
    item = context.active_object
    material = item.active_material if item else None
    if image is None and material and material.node_tree:
        node = material.node_tree.nodes.active
        image = node.image if node and node.type == "TEX_IMAGE" else None
    return tuple(image.size) if image and min(image.size) > 0 else None


def available_engines(context):
    """The engines that the preferences of the add-on lead to."""
    chosen = api.preferences(context)
    return engine.engines(chosen.engine, chosen.module_folder, chosen.program)


def _counted(count, thing):
    return f"{count} {thing}" + ("" if count == 1 else "s")


def _outcome_text(outcome):
    """What came of a job, in a line."""
    figures = outcome.figures
    words = []
    if figures.get("islands") is not None:
        words.append(_counted(figures["islands"], "island"))
    if figures.get("distortion"):
        words.append(f"distortion {figures['distortion']:.3f}")
    if figures.get("seam_norm") is not None:
        words.append(f"seams {figures['seam_norm']:.2f}")
    if figures.get("overlapping_pairs"):
        words.append(_counted(figures["overlapping_pairs"], "overlap"))
    if figures.get("flipped_triangles"):
        words.append(_counted(figures["flipped_triangles"], "flipped triangle"))
    return ", ".join(words)


class MapOperator:
    """What the operators that change UVs have in common."""

    command = "unwrap"
    names = ()  # of the options of its command
    fixed = {}  # options that are always given
    selected_only = False
    progress_text = "Unwrapping"

    @classmethod
    def poll(cls, context):
        if BackgroundMixin.current is not None:
            cls.poll_message_set("A job is running: Escape stops it")
            return False
        if context.mode not in {"OBJECT", "EDIT_MESH"} or not meshdata.objects_to_map(context):
            cls.poll_message_set("Select mesh objects with faces, in object mode or edit mode")
            return False
        return True

    def taking(self):
        """What is taken over from Blender, by the properties of this operator."""
        return meshdata.Taking(
            selected_only=self.selected_only or getattr(self, "selected", False),
            seams=self.use_seams,
            pins=self.use_pins,
            modifiers=self.use_modifiers,
            seam_group=self.seam_group,
            seam_factor=self.seam_factor,
            texel_group=self.texel_group,
            texel_factor=self.texel_factor,
        )

    def request(self, context):
        """The job for what is selected."""
        model = meshdata.model_of(context, meshdata.objects_to_map(context), self.taking())
        if not model.scope.any():
            raise Failure("No faces are selected" if self.taking().selected_only else "All faces are hidden")
        names = [name for name in self.names if name not in _OF_PARTS or not model.scope.all()]
        given = options.given(self, names)
        size = image_size(context) if self.use_image_size else None
        if size:
            given["texture_size"] = size
        given.update(self.fixed)
        if given.get("seams", "free") != "free" and "materials" in getattr(self, "seams_from", ()):
            model.cut_between_materials()
        return engine.Request(self.command, model, given)

    def job(self, context):
        """The job, begun, and the parts that its UVs are for."""
        request = self.request(context)
        chosen = engine.engine_for(request, available_engines(context))
        return jobs.Job(chosen.run(request)), request.model.parts

    def finish(self, parts, outcome):
        """Writes what came of a job, and says what there is to say."""
        for note in outcome.notes:
            self.report({"WARNING"}, note)
        if outcome.uvs is None:
            self.report({"INFO"}, "Stopped before there was a map")
            return {"CANCELLED"}
        problems = meshdata.write_uvs(parts, outcome.uvs)
        for problem in problems:
            self.report({"WARNING"}, problem)
        if len(problems) == len(parts):
            return {"CANCELLED"}
        overlay.update()
        state = "Stopped, the best map so far: " if outcome.stopped else ""
        self.report({"INFO"}, state + _outcome_text(outcome))
        return {"FINISHED"}

    def execute(self, context):
        try:
            job, parts = self.job(context)
            return self.finish(parts, job.wait())
        except (Failure, engine.EngineError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}


class BackgroundMixin:
    """Looks after an operator's job from a timer, while Blender stays usable. Escape stops it with the best map so far."""

    current = None  # the operator whose job runs

    def invoke(self, context, _event):
        try:
            self._job, self._parts = self.job(context)
        except (Failure, engine.EngineError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        self._drawn = None
        self._timer = context.window_manager.event_timer_add(_TICK, window=context.window)
        self._workspace = context.workspace.name
        BackgroundMixin.current = self
        context.window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        if event.type == "ESC" and event.value == "PRESS":
            self._job.stop()
        if event.type != "TIMER":
            return {"PASS_THROUGH"}
        runs = self._job.step()
        self._show(context, self.status_text())
        if self._job.progress.newest is not self._drawn:
            self._drawn = self._job.progress.newest
            overlay.show_live(self._drawn)
        if runs:
            return {"PASS_THROUGH"}
        self._end(context)
        if self._job.closed:
            return {"CANCELLED"}
        try:
            return self.finish(self._parts, self._job.wait())
        except (Failure, engine.EngineError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}

    def cancel(self, context):
        """Blender ends the operator, for instance when another file is opened."""
        try:
            self._job.close()
        finally:
            self._end(context)

    def end_now(self):
        """Ends the job without its map."""
        self._job.close()

    def status_text(self):
        if self._job.stopping:
            return f"{self.progress_text}: stopping"
        return f"{self.progress_text}: {self._job.progress.share:.0%}, Escape stops with the best map so far"

    @property
    def share(self):
        """Progress of the job, 0 to 1."""
        return self._job.progress.share

    def stop(self):
        """Asks the job to end with the best that it has."""
        self._job.stop()

    def _show(self, context, text):
        workspace = bpy.data.workspaces.get(self._workspace)
        if workspace:
            workspace.status_text_set(text)
        for window in context.window_manager.windows:
            for area in window.screen.areas:
                if area.type in {"VIEW_3D", "IMAGE_EDITOR"}:
                    for region in area.regions:
                        if region.type == "UI":
                            region.tag_redraw()

    def _end(self, context):
        context.window_manager.event_timer_remove(self._timer)
        BackgroundMixin.current = None
        overlay.show_live(None)
        self._show(context, None)


def _annotated(*groups, **own):
    """Annotations of a class with these properties."""
    return {name: prop for group in (*groups, own, options.TAKING) for name, prop in group.items()}


class AUTOCUTS_OT_unwrap(BackgroundMixin, MapOperator, bpy.types.Operator):
    """Make a UV map: cuts and distortion are optimised together"""

    bl_idname = "autocuts.unwrap"
    bl_label = "Unwrap"
    bl_options = {"REGISTER", "UNDO", "PRESET"}
    names = tuple(options.UNWRAP)
    __annotations__ = _annotated(options.UNWRAP)


class AUTOCUTS_OT_unwrap_selected(BackgroundMixin, MapOperator, bpy.types.Operator):
    """Unwrap the selected faces; all others keep their UVs"""

    bl_idname = "autocuts.unwrap_selected"
    bl_label = "Unwrap Selected Faces"
    bl_options = {"REGISTER", "UNDO", "PRESET"}
    names = tuple(options.UNWRAP)
    selected_only = True
    __annotations__ = _annotated(options.UNWRAP)


class AUTOCUTS_OT_separate(BackgroundMixin, MapOperator, bpy.types.Operator):
    """Cut islands that overlap themselves, then pack"""

    bl_idname = "autocuts.separate"
    bl_label = "Separate"
    bl_options = {"REGISTER", "UNDO", "PRESET"}
    command = "separate"
    names = tuple(options.SEPARATE)
    progress_text = "Separating"
    __annotations__ = _annotated(options.SEPARATE)


def _selected():
    return bpy.props.BoolProperty(name="Only selected", description="All other faces keep their UVs")


class MappedOperator(MapOperator):
    """An operator for meshes that have a map."""

    def request(self, context):
        request = super().request(context)
        if any(not part.uv_name for part in request.model.parts):
            raise Failure("There is no UV map yet: unwrap first")
        return request


class AUTOCUTS_OT_pack(MappedOperator, bpy.types.Operator):
    """Arrange the islands of the map anew, by their real shapes"""

    bl_idname = "autocuts.pack"
    bl_label = "Pack"
    bl_options = {"REGISTER", "UNDO", "PRESET"}
    command = "pack"
    names = tuple(options.PACK)
    __annotations__ = _annotated(options.PACK, selected=_selected())


class AUTOCUTS_OT_straighten(MappedOperator, bpy.types.Operator):
    """Turn islands to the axes, and make straight in the map what is straight on the model; seams stay"""

    bl_idname = "autocuts.straighten"
    bl_label = "Straighten"
    bl_options = {"REGISTER", "UNDO", "PRESET"}
    command = "align"
    names = tuple(options.RESHAPE)
    __annotations__ = _annotated(options.RESHAPE, selected=_selected())


class AUTOCUTS_OT_stack(MappedOperator, bpy.types.Operator):
    """Lay the islands of parts that are copies of each other on each other; seams stay"""

    bl_idname = "autocuts.stack"
    bl_label = "Stack"
    bl_options = {"REGISTER", "UNDO", "PRESET"}
    names = tuple(options.RESHAPE)
    fixed = {"seams": "only", "seams_from": "uv", "alike": "stack", "quality": "draft"}
    __annotations__ = _annotated(options.RESHAPE, selected=_selected())


class AUTOCUTS_OT_measure(BackgroundMixin, MappedOperator, bpy.types.Operator):
    """Measure the map, and show overlaps, stretch or texel density over the UV editor"""

    bl_idname = "autocuts.measure"
    bl_label = "Measure"
    bl_options = {"REGISTER"}
    command = "check"
    names = tuple(options.TEXTURE)
    progress_text = "Measuring"
    __annotations__ = _annotated(options.TEXTURE)

    def finish(self, _parts, outcome):
        settings = bpy.context.scene.autocuts
        settings.figures = _outcome_text(outcome)
        if settings.overlay == "NONE":
            settings.overlay = "STRETCH"
        self.report({"INFO"}, settings.figures)
        return {"FINISHED"}


class AUTOCUTS_OT_bake(BackgroundMixin, bpy.types.Operator):
    """Bake the selected objects onto the active one, or the active one itself when it is selected alone"""

    bl_idname = "autocuts.bake"
    bl_label = "Bake"
    bl_options = {"REGISTER", "UNDO", "PRESET"}
    progress_text = "Baking"
    __annotations__ = {
        **options.BAKE,
        "use_image_size": options.TAKING["use_image_size"],
        "directory": bpy.props.StringProperty(
            name="Folder", subtype="DIR_PATH", default="//", description="Where the pictures go"
        ),
    }

    @classmethod
    def poll(cls, context):
        if BackgroundMixin.current is not None:
            cls.poll_message_set("A job is running: Escape stops it")
            return False
        item = context.active_object
        if context.mode != "OBJECT" or item is None or item.type != "MESH" or not item.data.uv_layers:
            cls.poll_message_set("In object mode, make a mesh object with a UV map the active one")
            return False
        return True

    def job(self, context):
        """The job, begun; it gives the pictures."""
        given = options.given(self, options.BAKE)
        size = image_size(context) if self.use_image_size else None
        if size:
            given["texture_size"] = size
        programs = [one for one in available_engines(context) if isinstance(one, engine.CommandEngine)]
        if not programs:
            raise engine.EngineError("Bakes need autocuts-cli: say in the preferences of this add-on where it is")
        folder = bpy.path.abspath(self.directory) or bpy.app.tempdir
        os.makedirs(folder, exist_ok=True)
        return jobs.Job(baking.job(context, programs[0], folder, given)), None

    def finish(self, _parts, pictures):
        for path in pictures:
            image = bpy.data.images.load(path, check_existing=True)
            image.reload()
            if "color" not in os.path.basename(path):
                image.colorspace_settings.name = "Non-Color"
        self.report({"INFO"}, "Baked " + ", ".join(os.path.basename(path) for path in pictures))
        return {"FINISHED"}

    def execute(self, context):
        try:
            job, _ = self.job(context)
            return self.finish(None, job.wait())
        except engine.EngineError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}


class AUTOCUTS_OT_open_studio(bpy.types.Operator):
    """Open the selected objects in the studio, which gives maps, seams and pins back while you work there"""

    bl_idname = "autocuts.open_studio"
    bl_label = "Open in Autocuts"

    @classmethod
    def poll(cls, context):
        return MapOperator.poll.__func__(cls, context)

    def execute(self, context):
        studio = engine.find_studio(api.preferences(context).studio, api.preferences(context).program)
        if studio is None:
            self.report({"ERROR"}, "Autocuts was not found: say in the preferences of this add-on where it is")
            return {"CANCELLED"}
        try:
            livelink.open_studio(meshdata.objects_to_map(context), context.scene.autocuts.link_mode, studio)
        except (livelink.link.LinkError, OSError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}


class _LinkedOperator:
    @classmethod
    def poll(cls, _context):
        return livelink.current is not None and livelink.current.is_open


class AUTOCUTS_OT_get_map(_LinkedOperator, bpy.types.Operator):
    """Get the newest map of the studio now"""

    bl_idname = "autocuts.get_map"
    bl_label = "Get Map"

    def execute(self, _context):
        livelink.current.request()
        return {"FINISHED"}


class AUTOCUTS_OT_end_link(_LinkedOperator, bpy.types.Operator):
    """End the link; the studio keeps the model"""

    bl_idname = "autocuts.end_link"
    bl_label = "End Link"

    def execute(self, _context):
        livelink.end()
        return {"FINISHED"}


class AUTOCUTS_OT_stop(bpy.types.Operator):
    """Stop the job with the best map so far"""

    bl_idname = "autocuts.stop"
    bl_label = "Stop"
    bl_options = {"INTERNAL"}

    @classmethod
    def poll(cls, _context):
        return BackgroundMixin.current is not None

    def execute(self, _context):
        BackgroundMixin.current.stop()
        return {"FINISHED"}


def unregister():
    """Ends the job that runs, also when Blender is closed."""
    if BackgroundMixin.current is not None:
        BackgroundMixin.current.end_now()


CLASSES = (
    AUTOCUTS_OT_unwrap,
    AUTOCUTS_OT_unwrap_selected,
    AUTOCUTS_OT_separate,
    AUTOCUTS_OT_pack,
    AUTOCUTS_OT_straighten,
    AUTOCUTS_OT_stack,
    AUTOCUTS_OT_measure,
    AUTOCUTS_OT_bake,
    AUTOCUTS_OT_open_studio,
    AUTOCUTS_OT_get_map,
    AUTOCUTS_OT_end_link,
    AUTOCUTS_OT_stop,
)
