"""Who sees an object: the parameters of its shapes that say so, and what has no equal."""

RAYS = {
    "visible_diffuse": "diffuse rays",
    "visible_glossy": "glossy rays",
    "visible_transmission": "refracted rays",
}


def shape_visibility(object_, view_layer, report):
    """Parameters of the object's shapes, by its own settings and those of its collections in the view layer."""
    original = object_.original
    hidden = [what for name, what in RAYS.items() if not getattr(object_, name, True)]
    casts_shadows = getattr(object_, "visible_shadow", True)
    is_pane = hidden == ["diffuse rays"] and not casts_shadows
    if hidden and not is_pane:
        report.add(f"objects are seen by all rays; this one is hidden from {', '.join(hidden)}", object_.name)
    if getattr(object_, "is_holdout", False) or original.holdout_get(view_layer=view_layer):
        report.add("holdouts have no equal; the object is shown", object_.name)
    if getattr(object_, "is_shadow_catcher", False):
        report.add("shadow catchers have no equal; the object is shown", object_.name)
    params = {}
    if not getattr(object_, "visible_camera", True) or original.indirect_only_get(view_layer=view_layer):
        params["bool visibletocamera"] = False
    if is_pane:
        params["bool visibletodiffuse"] = False
    elif not casts_shadows:
        params["float shadowalpha"] = 0
    return params
