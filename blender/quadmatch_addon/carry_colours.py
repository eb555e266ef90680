"""Colour attributes, at corners and at vertices."""
import numpy as np

from .colours import NAME
from .mesh_arrays import read
from .sentences import counted


def carry(source, target, along):
    """Attributes are found by name, or made; others of that name and of another kind are in the way, and stay."""
    lines, carried = [], 0
    for layer in source.data.color_attributes:
        if layer.name == NAME:
            continue  # our own picture of the match
        mine = target.data.attributes.get(layer.name)
        if mine is None:
            mine = target.data.color_attributes.new(layer.name, layer.data_type, layer.domain)
        elif (mine.domain, mine.data_type) != (layer.domain, layer.data_type):
            lines.append(f"Colours {layer.name} are left out: {target.name} has another attribute of that name")
            continue
        pairs = along.corners if layer.domain == "CORNER" else along.vertices
        # As they are stored: bytes are sRGB, and a turn through linear numbers could round them.
        name = "color_srgb" if layer.data_type == "BYTE_COLOR" else "color"
        written = read(mine.data, name, 4 * len(mine.data), np.float32).reshape(-1, 4)
        written[pairs[:, 1]] = read(layer.data, name, 4 * len(layer.data), np.float32).reshape(-1, 4)[pairs[:, 0]]
        mine.data.foreach_set(name, written.ravel())
        carried += 1
    if carried:
        lines.insert(0, f"{counted(carried, 'colour attribute')}")
    return lines
