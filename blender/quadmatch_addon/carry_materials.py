"""Materials of faces: slots that the target lacks are added."""
import numpy as np

from .mesh_arrays import read
from .sentences import counted


def carry(source, target, along):
    if not source.material_slots or not len(along.faces):
        return []
    theirs = read(source.data.polygons, "material_index", len(source.data.polygons), np.int32)[along.faces[:, 0]]
    theirs = np.clip(theirs, 0, len(source.material_slots) - 1)  # as Blender draws what lies outside
    slot = np.zeros(len(source.material_slots), np.int32)
    used = np.unique(theirs)
    for index in used:
        slot[index] = _slot(target, source.material_slots[index].material)
    indices = read(target.data.polygons, "material_index", len(target.data.polygons), np.int32)
    indices[along.faces[:, 1]] = slot[theirs]
    target.data.polygons.foreach_set("material_index", indices)
    target.data.update()
    return [f"{counted(len(used), 'material')}: {len(along.faces):,} faces"]


def _slot(target, material):
    """The first slot with it, or a new one."""
    for index, slot in enumerate(target.material_slots):
        if slot.material == material:
            return index
    target.data.materials.append(material)
    return len(target.data.materials) - 1
