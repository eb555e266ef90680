"""Shape keys: as displacements from the key they are relative to, so that a target of another shape keeps its own."""
import numpy as np

from .mesh_arrays import edge_vertices, read
from .motion import displacement_matrix
from .sentences import counted


def points_of(key):
    return read(key.data, "co", 3 * len(key.data), np.float32).reshape(-1, 3)


def carry(source, target, along):
    """Keys are found by name, or made. Vertices without partner stay where the key had them; in a new one, at its base."""
    keys = source.data.shape_keys
    if keys is None or len(keys.key_blocks) < 2:
        return []
    if target.data.shape_keys is None:
        target.shape_key_add(name=keys.reference_key.name, from_mix=False)
        target.data.shape_keys.use_relative = keys.use_relative
    here, there, matrices, lines = _partners(source, target, along)
    mine = {keys.reference_key.name: target.data.shape_keys.reference_key}
    fresh = set()
    for key in keys.key_blocks:
        if key != keys.reference_key:
            mine[key.name] = _key(target, key, fresh)
    for key in _relative_first(keys):
        mine[key.name].relative_key = mine[key.relative_key.name]
        _write(key, mine[key.name], here, there, matrices, key.name in fresh)
    target.data.update()
    return [f"{counted(len(keys.key_blocks) - 1, 'shape key')}: {len(here):,} vertices", *lines]


def _partners(source, target, along):
    """Vertices here and there, the matrix of each for displacements (None: as they are), and what is to be said."""
    pairs, turned, lines = along.vertices, along.turned_vertices, []
    bases = [points_of(obj.data.shape_keys.reference_key) for obj in (source, target)]
    matrices = np.tile(np.eye(3), (len(pairs), 1, 1))
    kept = np.ones(len(pairs), bool)
    for side in (False, True):
        chosen = turned == side
        if not chosen.any():
            continue
        matrix = displacement_matrix(bases[0][pairs[chosen, 0]], bases[1][pairs[chosen, 1]],
                                     _edges_among(source.data, pairs[chosen, 0]), side)
        if matrix is None:
            kept[chosen] = False
            lines.append(f"Shape keys are left out on {chosen.sum():,} vertices: they lie turned over and posed, "
                         "so nobody knows which way they move")
        else:
            matrices[chosen] = matrix
            lines += _said(matrix)
    plain = np.allclose(matrices, np.eye(3), atol=0)
    return pairs[kept, 0], pairs[kept, 1], None if plain else matrices[kept], lines


def _said(matrix):
    scale = abs(np.linalg.det(matrix)) ** (1 / 3)
    lines = [] if np.isclose(scale, 1, rtol=1e-3) else [f"Shape keys are scaled by {scale:.3g}, as the target is"]
    if np.linalg.det(matrix) < 0:
        lines.append("Shape keys are mirrored, as the target is")
    return lines


def _edges_among(mesh, vertices):
    """Edges with both ends among these vertices, as rows of their places in it."""
    place = np.full(len(mesh.vertices), -1)
    place[vertices] = np.arange(len(vertices))
    ends = place[edge_vertices(mesh)]
    return ends[(ends >= 0).all(axis=1)]


def _key(target, theirs, fresh):
    key = target.data.shape_keys.key_blocks.get(theirs.name)
    if key is None:
        key = target.shape_key_add(name=theirs.name, from_mix=False)
        key.slider_min, key.slider_max, key.value = theirs.slider_min, theirs.slider_max, theirs.value
        key.mute, key.interpolation, key.vertex_group = theirs.mute, theirs.interpolation, theirs.vertex_group
        fresh.add(theirs.name)
    return key


def _relative_first(keys):
    """All keys but the reference, each after the key it is relative to; a key in a circle comes last."""
    waiting = [key for key in keys.key_blocks if key != keys.reference_key]
    done = {keys.reference_key.name}
    while waiting:
        ready = [key for key in waiting if key.relative_key.name in done] or waiting
        done.update(key.name for key in ready)
        waiting = [key for key in waiting if key not in ready]
        yield from ready


def _write(source_key, key, here, there, matrices, fresh):
    """The displacements of the source's key, from what it is relative to, onto the target's."""
    theirs, their_basis = points_of(source_key), points_of(source_key.relative_key)
    basis = points_of(key.relative_key)
    points = basis.copy() if fresh else points_of(key)
    moves = theirs[here] - their_basis[here]
    if matrices is not None:
        moves = np.einsum("nij,nj->ni", matrices, moves).astype(np.float32)
    # Where both stand in the same place the key is copied, to the last bit.
    same = (their_basis[here] == basis[there]).all(axis=1) if matrices is None else np.zeros(len(here), bool)
    points[there] = np.where(same[:, None], theirs[here], basis[there] + moves)
    key.data.foreach_set("co", points.ravel())
