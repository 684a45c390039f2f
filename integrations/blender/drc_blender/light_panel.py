"""The settings of lamps that DRC renders: Blender's own panel for them is Eevee's, with factors that change nothing here."""

import bpy

from .engine import DrcRenderEngine

SHAPE = {
    "POINT": ("shadow_soft_size",),
    "SPOT": ("shadow_soft_size", "spot_size", "spot_blend", "show_cone"),
    "SUN": ("angle",),
}
OF_AREA = ("size", "spread")
OF_LONG_AREA = ("size", "size_y", "spread")


class DRC_PT_light(bpy.types.Panel):
    bl_space_type, bl_region_type, bl_context = "PROPERTIES", "WINDOW", "data"
    bl_label = "Light"

    @classmethod
    def poll(cls, context):
        return context.light and context.engine == DrcRenderEngine.bl_idname

    def draw(self, context):
        light, layout = context.light, self.layout
        layout.row().prop(light, "type", expand=True)
        layout.use_property_split, layout.use_property_decorate = True, True
        if hasattr(light, "use_temperature"):
            layout.prop(light, "use_temperature")
            if light.use_temperature:
                layout.prop(light, "temperature")
        layout.prop(light, "color")
        layout.prop(light, "energy", text="Strength" if light.type == "SUN" else "Power")
        for name in ("exposure", "normalize"):
            if hasattr(light, name):
                layout.prop(light, name)
        layout.separator()
        if light.type == "AREA":
            layout.prop(light, "shape")
            names = OF_LONG_AREA if light.shape in ("RECTANGLE", "ELLIPSE") else OF_AREA
        else:
            names = SHAPE[light.type]
        for name in names:
            layout.prop(light, name, text="Radius" if name == "shadow_soft_size" else None)


CLASSES = (DRC_PT_light,)


def register():
    for made in CLASSES:
        bpy.utils.register_class(made)


def unregister():
    for made in reversed(CLASSES):
        bpy.utils.unregister_class(made)
