"""How displacements go from one mesh to another: turned, scaled or mirrored with it where the whole of it was."""
import numpy as np

RIGID = 1e-3  # root mean square, as a share of the size
SAME_SIZE = (0.8, 1.25)  # edges of a posed model are about as long as they were


def displacement_matrix(source, target, edges, turned):
    """A (3, 3) matrix for the displacements of these vertices, or None where there is none.

    source, target: (N, 3) positions of partners; edges: (E, 2) rows of these; turned: the part lies turned over.
    Where the target is the source moved, scaled or mirrored as a whole, its displacements are too. Where it is posed they
    are only scaled; if it is turned over as well nobody knows which way they point.
    """
    if np.array_equal(source, target):
        return np.eye(3)
    whole = _similarity(source.astype(np.float64), target.astype(np.float64), turned)
    if whole is not None:
        return np.eye(3) if np.allclose(whole, np.eye(3), atol=1e-4) else whole
    if turned:
        return None
    ratio = _edge_ratio(source, target, edges)
    return np.eye(3) * (1.0 if SAME_SIZE[0] <= ratio <= SAME_SIZE[1] else ratio)


def _similarity(source, target, turned):
    """The orthogonal matrix, times a scale, that lays source on target best (Kabsch), if it does."""
    source, target = source - source.mean(axis=0), target - target.mean(axis=0)
    left, scales, right = np.linalg.svd(target.T @ source)
    spread = (source**2).sum()
    size = np.sqrt((target**2).sum())
    if spread == 0 or size == 0:
        return None
    flat = scales[2] <= 1e-9 * scales[0]
    signs = np.ones(3)
    if flat and np.linalg.det(left @ right) * (-1 if turned else 1) < 0:
        signs[2] = -1  # a flat part fits either way: the side that its faces show
    matrix = (left * signs) @ right * (scales * signs).sum() / spread
    return matrix if np.sqrt(((source @ matrix.T - target)**2).sum()) <= RIGID * size else None


def _edge_ratio(source, target, edges):
    lengths = [np.linalg.norm(points[edges[:, 0]] - points[edges[:, 1]], axis=1) for points in (source, target)]
    good = lengths[0] > 0
    return float(np.median(lengths[1][good] / lengths[0][good])) if good.any() else 1.0
