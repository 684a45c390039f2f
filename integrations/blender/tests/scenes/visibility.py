"""What the camera and shadow rays do not see."""

from stage import feature


@feature("hidden from the camera")
def _(s):
    s.ball.visible_camera = False


@feature("without a shadow", lit=False)
def _(s):
    s.ball.visible_shadow = False
    # Else Cycles loses a part of the light: the one that paths would have found, which the ball is not open to.
    s.light("AREA", 300, (2.5, -2.5, 4.5), (0, 0, 0.5), size=1.5).data.cycles.use_multiple_importance_sampling = False


@feature("world, hidden from the camera")
def _(s):
    s.scene.world.cycles_visibility.camera = False
    s.aim(s.camera, (0, 0, 2))


@feature("transparent film")
def _(s):
    s.scene.render.film_transparent = True
    s.aim(s.camera, (0, 0, 2))
