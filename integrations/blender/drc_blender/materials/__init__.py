"""From Blender's shader nodes to DRC's materials and textures."""
