import numpy as np
import pytest

import quadmatch
from conftest import grid, renumbered


def test_check_counts_and_names_what_departs(examples):
    toy = quadmatch.check(examples / "dog_toy.obj")
    assert toy.well_formed and [part.genus for part in toy.components] == [16]
    fan = quadmatch.check(quadmatch.Mesh(None, [[0, 1, 2, 3], [0, 1, 4, 5], [0, 1, 6, 7]]), kept=1)
    assert not fan.well_formed and fan.departure_counts["non-manifold-edge"] == 1
    assert ("non-manifold-edge" in dict(fan.departures)) and fan.components[0].genus is None


def test_the_skeleton_of_a_patch_with_one_irregular_vertex_runs_to_the_boundary():
    # Three quads around a vertex, each refined into two by two: the corners and the centre are extraordinary.
    mesh = quadmatch.Mesh(None, [[0, 1, 2, 3], [0, 3, 4, 5], [0, 5, 6, 1]])
    skeleton = quadmatch.skeleton(mesh)
    check = quadmatch.check(mesh)
    assert (len(skeleton.nodes), len(skeleton.arcs)) == (check.vertices, check.edges) == (7, 9)
    assert skeleton.reduction == 0


def test_paths_of_the_skeleton_run_along_edges_from_node_to_node(bear):
    edges = {frozenset(pair) for face in bear.faces.tolist() for pair in zip(face, face[1:] + face[:1])}
    for separatrices in (False, True):
        skeleton = quadmatch.skeleton(bear, separatrices=separatrices)
        assert len(skeleton.paths) == len(skeleton.arcs) > 0
        for (first, last), path in zip(skeleton.arcs, skeleton.paths):
            assert path[0] == skeleton.nodes[first] and path[-1] == skeleton.nodes[last]
            assert all(frozenset(pair) in edges for pair in zip(path.tolist(), path[1:].tolist()))


def test_a_patch_of_which_only_the_corners_are_extraordinary_has_arcs_along_its_sides():
    skeleton = quadmatch.skeleton(quadmatch.Mesh(*grid(3, 4)))
    assert len(skeleton.nodes) == 4 and sorted(len(path) for path in skeleton.paths) == [4, 4, 5, 5]
    assert skeleton.reduction == pytest.approx(0.8)


def test_the_hash_is_the_same_for_a_renumbered_copy_and_unoriented_for_a_mirror_image(bear):
    _, faces, _, _ = renumbered(bear.vertices, bear.faces, seed=1)
    assert quadmatch.connectivity_hash(quadmatch.Mesh(None, faces)) == quadmatch.connectivity_hash(bear)
    mirrored = quadmatch.connectivity_hash(quadmatch.Mesh(None, np.ascontiguousarray(bear.faces[:, ::-1])))
    assert mirrored[1] == quadmatch.connectivity_hash(bear)[1]
