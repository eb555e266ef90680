"""The two sides of a mirrored mesh, in any pose: areas between the centre lines, judged as a whole."""
import numpy as np


def sides_of_faces(arrays, mirror, side):
    """1 on the side, -1 opposite, 0 on the centre line or without partner. side: "+x", "-z", …

    An area lies on the side towards which its faces lie farther than their partners, taken together: a hand that reaches
    across the middle stays on its side.
    """
    partner = mirror.face_map(arrays.face_count)
    paired = (partner >= 0) & (partner != np.arange(arrays.face_count))
    axis, sign = "xyz".index(side[1]), 1 if side[0] == "+" else -1
    place = sign * arrays.centres[:, axis]
    farther = np.where(paired, place - place[partner], 0.0)
    area = _areas(arrays, paired, mirror)
    sums = np.bincount(area[paired], weights=farther[paired], minlength=area.max() + 1 if len(area) else 0)
    found = np.zeros(arrays.face_count, np.int8)
    found[paired] = np.sign(sums[area[paired]])
    return found


def _areas(arrays, paired, mirror):
    """A number for each face: the same where paired faces hang together across edges that are not on the line."""
    on_line = np.zeros(arrays.vertex_count, bool)
    on_line[mirror.line_vertices] = True
    following = np.arange(len(arrays.corners)) + 1
    following[arrays.starts + arrays.sizes - 1] = arrays.starts
    open_edge = ~(on_line[arrays.corners] & on_line[arrays.corners[following]]) & paired[arrays.face_of_corner]
    corners = np.flatnonzero(open_edge)
    corners = corners[np.argsort(arrays.edges[corners], kind="stable")]
    same = np.flatnonzero(arrays.edges[corners][1:] == arrays.edges[corners][:-1])
    one, other = arrays.face_of_corner[corners[same]], arrays.face_of_corner[corners[same + 1]]
    return _components(arrays.face_count, one, other)


def _components(count, one, other):
    """The smallest number that each element is connected with: hooking and jumping, until nothing changes."""
    label = np.arange(count)
    while True:
        lowest = np.minimum(label[one], label[other])
        before = label.copy()
        np.minimum.at(label, label[one], lowest)
        np.minimum.at(label, label[other], lowest)
        label = label[label]
        if np.array_equal(label, before):
            return label
