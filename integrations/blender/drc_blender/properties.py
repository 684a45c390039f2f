"""The settings of a render, and the preferences of the add-on."""

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty, PointerProperty, StringProperty


class DrcSettings(bpy.types.PropertyGroup):
    stop: EnumProperty(
        name="Stop",
        default="TIME",
        items=(
            ("TIME", "Time", "Render for so many seconds, with reading and denoising"),
            ("NOISE", "Noise", "Render until the denoised picture's relative error is estimated to be this"),
            ("SAMPLES", "Samples", "Render so many samples a pixel"),
        ),
    )
    time: FloatProperty(name="Seconds", default=30, min=1, soft_max=3600, description="Seconds for the whole render")
    noise: FloatProperty(
        name="Noise",
        default=0.03,
        min=0.001,
        max=1,
        precision=3,
        description="Relative error of the denoised picture at which the render ends",
    )
    samples: IntProperty(name="Samples", default=128, min=1, soft_max=4096, description="Samples a pixel, on average")
    most_time: FloatProperty(
        name="At Most", default=0, min=0, description="Seconds after which a render by noise ends anyway; 0: no limit"
    )
    denoise: BoolProperty(
        name="Denoise", default=True, description="Remove the remaining noise by Open Image Denoise, if it is installed"
    )
    cells: BoolProperty(
        name="Radiance Cells",
        default=True,
        description="Learn the indirect light while rendering; without, DRC is a path tracer",
    )
    max_bounces: IntProperty(
        name="Bounces", default=12, min=0, max=1000, description="Most bounces of a path that are not specular"
    )
    seed: IntProperty(name="Seed", default=0, min=0, description="Seed of the random numbers")
    filter_kind: EnumProperty(
        name="Filter",
        default="GAUSSIAN",
        items=(
            ("GAUSSIAN", "Gaussian", "As wide as the Blackman-Harris filter of Cycles"),
            ("BOX", "Box", "Pixels by themselves"),
        ),
    )
    filter_width: FloatProperty(
        name="Width", default=1.5, min=0.1, max=10, description="Of the pixel filter, in pixels"
    )
    texture_side: IntProperty(
        name="Baked Textures",
        default=1024,
        min=16,
        max=8192,
        description="Pixels of the side of textures that are baked, since their nodes have no equal",
    )
    world_side: IntProperty(
        name="Baked World", default=1024, min=16, max=4096, description="Pixels of the side of the picture of the world"
    )
    keep_files: StringProperty(
        name="Files",
        default="",
        subtype="DIR_PATH",
        description="Folder for the exported scene; without, it is in Blender's temporary folder",
    )


class DrcPreferences(bpy.types.AddonPreferences):
    bl_idname = __package__

    program: StringProperty(
        name="Program", default="", subtype="FILE_PATH", description="The program drc; without, the one in PATH"
    )
    threads: IntProperty(name="Threads", default=0, min=0, description="0: one for each core")

    def draw(self, _context):
        from .program import UserError, find_program

        self.layout.prop(self, "program")
        self.layout.prop(self, "threads")
        try:
            self.layout.label(text=find_program(bpy.path.abspath(self.program)), icon="CHECKMARK")
        except UserError as error:
            self.layout.label(text=str(error), icon="ERROR")


class Defaults:
    """The preferences where the add-on runs without having been enabled, as in tests."""

    program, threads = "", 0


def preferences():
    addon = bpy.context.preferences.addons.get(__package__)
    return addon.preferences if addon is not None and addon.preferences is not None else Defaults


def program():
    from .program import find_program

    chosen = preferences().program
    return find_program(bpy.path.abspath(chosen) if chosen else "")


CLASSES = (DrcSettings, DrcPreferences)


def register():
    for made in CLASSES:
        bpy.utils.register_class(made)
    bpy.types.Scene.drc = PointerProperty(type=DrcSettings)


def unregister():
    del bpy.types.Scene.drc
    for made in reversed(CLASSES):
        bpy.utils.unregister_class(made)
