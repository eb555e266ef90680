"""UV maps: at corners, so that seams of the layout stay seams."""
import numpy as np

from .mesh_arrays import read
from .sentences import counted

MOST_UV_MAPS = 8  # Blender has no room for more


def carry(source, target, along):
    """Along the corner pairs of a Correspondence. Maps are found by name, or made; other corners keep what they have."""
    layers = source.data.uv_layers
    lines = []
    for layer in layers:
        values = read(layer.data, "uv", 2 * len(source.data.loops), np.float32).reshape(-1, 2)
        mine = target.data.uv_layers.get(layer.name)
        if mine is None:
            if len(target.data.uv_layers) == MOST_UV_MAPS:
                lines.append(f"UV map {layer.name} is left out: {target.name} has {MOST_UV_MAPS} already")
                continue
            mine = _new(target.data, layer.name)
        written = read(mine.data, "uv", 2 * len(target.data.loops), np.float32).reshape(-1, 2)
        written[along.corners[:, 1]] = values[along.corners[:, 0]]
        mine.data.foreach_set("uv", written.ravel())
    if layers:
        rest = len(target.data.loops) - len(along.corners)
        lines.insert(0, f"{counted(len(layers), 'UV map')}: {len(along.corners):,} corners, {rest:,} keep their own")
    return lines


def _new(mesh, name):
    """An empty map: a new one is a copy of the active one otherwise."""
    return mesh.uv_layers.new(name=name, do_init=False)
