"""From an evaluated Blender scene to a folder with a pbrt-v4 file, PLY meshes and images."""
