"""DRC, a renderer for interiors, as a render engine of Blender."""


def register():
    from . import registration

    registration.register()


def unregister():
    from . import registration

    registration.unregister()
