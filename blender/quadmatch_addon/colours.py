"""The colour attribute "quadmatch" that shows a match: a colour for each face, at its corners: borders are crisp."""
import numpy as np

NAME = "quadmatch"
KIND = "FLOAT_COLOR"  # Blender copies whole arrays of them; bytes it converts one by one, far more slowly
MATCHED, AMBIGUOUS, UNMATCHED = (0.10, 0.35, 0.80, 1), (0.95, 0.75, 0.10, 1), (0.85, 0.10, 0.08, 1)
CENTRE = (0.9, 0.9, 0.9, 1)


def by_state(found, arrays):
    """Colours of the faces of source and target, (F, 4) each."""
    both = [np.tile(np.float32(UNMATCHED), (mesh.face_count, 1)) for mesh in arrays]
    for region in found.regions:
        for side, colours in enumerate(both):
            colours[region.faces[:, side]] = AMBIGUOUS if region.ambiguous else MATCHED
    return both


def by_place(found, arrays):
    """The source's colours are its places in its bounding box, the target's those of the partners; grey: unmatched."""
    both = [np.tile(np.float32((0.2, 0.2, 0.2, 1)), (mesh.face_count, 1)) for mesh in arrays]
    centres = arrays[0].centres
    low, high = centres.min(axis=0), centres.max(axis=0)
    places = 0.1 + 0.9 * (centres - low) / np.where(high > low, high - low, 1)
    for region in found.regions:
        source, target = region.faces[:, 0], region.faces[:, 1]
        both[0][source, :3] = both[1][target, :3] = places[source]
    return both


WAYS = {"state": by_state, "place": by_place}


def room_for(mesh):
    """Can the attribute be made? Another attribute of that name may be in the way."""
    there = mesh.attributes.get(NAME)
    return there is None or (there.domain, there.data_type) == ("CORNER", KIND)


def paint(mesh, arrays, colours):
    """Write the attribute and make it the one that is shown."""
    layer = mesh.color_attributes.get(NAME) or mesh.color_attributes.new(NAME, KIND, "CORNER")
    layer.data.foreach_set("color", np.repeat(colours, arrays.sizes, axis=0).ravel())
    mesh.color_attributes.active_color = mesh.color_attributes[NAME]
    mesh.update()
