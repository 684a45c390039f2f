"""The renderer's command lines, of the settings that the panels show."""


def scene_file_name(frame):
    """The renderer takes the frame's number, on which its noise depends, from the end of this name."""
    return f"frame_{frame:04d}.pbrt"


def render_command(program, scene_file, output, settings, viewer=None, threads=0):
    command = [
        program,
        "render",
        scene_file,
        "-o",
        output,
        "--aovs",
        "--integrator",
        "drc",
        "--cells",
        "on" if settings.cells else "off",
        "--max-depth",
        str(max(1, settings.max_bounces)),
        "--seed",
        str(settings.seed),
    ]
    if settings.stop == "TIME":
        command += ["--time", f"{settings.time:g}"]
    elif settings.stop == "SAMPLES":
        command += ["--spp", str(settings.samples)]
    else:
        command += ["--noise-threshold", f"{settings.noise:g}"]
        if settings.most_time > 0:
            command += ["--time", f"{settings.most_time:g}"]
    command += ["--denoise", "auto" if settings.denoise else "off"]
    if threads:
        command += ["--nthreads", str(threads)]
    if viewer is not None:
        command += ["--display-server", viewer]
    return command + ["--quiet"]


def view_command(program, scene_file, width, height, settings, threads=0, open_page=False):
    command = [
        program,
        "view",
        scene_file,
        "--resolution",
        f"{width}x{height}",
        "--integrator",
        "drc" if settings.cells else "path",
    ]
    if threads:
        command += ["--nthreads", str(threads)]
    return command + (["--open"] if open_page else [])
