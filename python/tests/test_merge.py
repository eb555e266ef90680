import numpy as np
import pytest

import quadmatch
from conftest import grid, renumbered


@pytest.fixture(scope="module")
def base(bear):
    """A bear without a plane of symmetry, with data on it."""
    vertices = bear.vertices + np.sin(bear.vertices[:, [1, 2, 0]] * 3)
    return quadmatch.Mesh(vertices, bear.faces, vertex_data={"weight": np.arange(len(vertices)) / 8})


def around(mesh, face):
    """A face and those that touch it."""
    return np.flatnonzero(np.isin(mesh.faces, mesh.faces[face]).any(axis=1))


def edited(mesh, *, without=(), moved=(), by=0.05, weight=None):
    vertices, weights = np.array(mesh.vertices), np.array(mesh.vertex_data["weight"])
    vertices[list(moved)] += by
    if weight is not None:
        weights[list(moved)] = weight
    return quadmatch.Mesh(vertices, np.delete(mesh.faces, list(without), axis=0), vertex_data={"weight": weights})


def test_edits_apart_from_each_other_are_both_in_the_result(base):
    hole = around(base, 100)
    moved = base.faces[2000]
    done = quadmatch.merge(base, edited(base, without=hole), edited(base, moved=moved, weight=-1))
    assert done.clean and done.ours.removed_faces == len(hole) and done.theirs.moved_vertices == 4
    both = edited(base, without=hole, moved=moved, weight=-1)
    assert quadmatch.diff(done.mesh, both).same
    assert (done.mesh.vertex_data["weight"] == -1).sum() == 4
    assert {row.name: row.from_theirs for row in done.attributes} == {"positions": 4, "weight": 4}


def test_every_face_of_the_result_is_one_of_the_three(base):
    hole, other = around(base, 100), around(base, 2000)
    vertices, faces, _, _ = renumbered(base.vertices, np.delete(base.faces, other, axis=0), seed=4)
    ours, theirs = edited(base, without=hole), quadmatch.Mesh(vertices, faces)
    done = quadmatch.merge(base, ours, theirs)
    assert done.clean and done.mesh.face_count == base.face_count - len(hole) - len(other)
    assert done.face_origins.shape == (done.mesh.face_count, 3) and (done.face_origins >= 0).all()
    assert done.vertex_origins.shape == (done.mesh.vertex_count, 3)
    for column, mesh in enumerate((base, ours, theirs)):
        corners = np.sort(done.vertex_origins[done.mesh.faces, column], axis=1)
        assert (corners == np.sort(mesh.faces[done.face_origins[:, column]], axis=1)).all()


def test_a_side_that_changed_nothing_gives_the_other_back(base):
    ours = edited(base, without=around(base, 100))
    for done in (quadmatch.merge(base, ours, base), quadmatch.merge(base, base, ours)):
        assert done.clean and (done.mesh.faces == ours.faces).all() and (done.mesh.vertices == ours.vertices).all()


def test_edits_that_meet_are_conflicts_and_the_preferred_side_is_there(base):
    moved = base.faces[2000]
    ours, theirs = edited(base, moved=moved), edited(base, moved=moved, by=-0.05)
    for prefer, side in (("ours", ours), ("theirs", theirs)):
        done = quadmatch.merge(base, ours, theirs, prefer=prefer)
        assert not done.clean and [(row.name, row.domain, row.count) for row in done.values] == [("positions", "vertex", 4)]
        assert sorted(done.values[0].first) == sorted(moved.tolist())
        assert (done.mesh.vertices == side.vertices).all()
    meeting = quadmatch.merge(base, edited(base, without=around(base, 100)), edited(base, without=[100]))
    assert len(meeting.areas) == 1 and len(meeting.areas[0].base_faces) > 0
    assert np.linalg.norm(np.array(meeting.areas[0].centre) - base.vertices[base.faces[100]].mean(axis=0)) < 1


def test_matches_that_are_given_are_gone_by(base):
    ours, theirs = edited(base, without=around(base, 100)), edited(base, without=around(base, 2000))
    to_ours, to_theirs = quadmatch.match(base, ours), quadmatch.match(base, theirs)
    done = quadmatch.merge(base, ours, theirs, match_ours=to_ours, match_theirs=to_theirs)
    assert done.clean and (done.mesh.faces == quadmatch.merge(base, ours, theirs).mesh.faces).all()
    with pytest.raises(ValueError, match="faces"):
        quadmatch.merge(base, theirs, quadmatch.Mesh(*grid(2, 2)), match_theirs=to_ours)


def test_meshes_with_nothing_in_common_are_refused(base):
    cube = quadmatch.Mesh(None, [[0, 1, 2], [0, 2, 3], [0, 3, 1], [3, 2, 1]])
    with pytest.raises(ValueError, match="it has no part in common with mesh, so there is nothing to merge by"):
        quadmatch.merge(base, cube, edited(base, without=[7]))


def test_a_word_that_is_no_side_is_refused(base):
    with pytest.raises(ValueError) as refused:
        quadmatch.merge(base, base, base, prefer="mine")
    assert str(refused.value) == "prefer: there is no 'mine'; give ours or theirs"


def test_a_search_that_is_stopped_merges_nothing(base):
    ours = edited(base, without=around(base, 100))
    with pytest.raises(quadmatch.Cancelled, match="nothing is merged"):
        quadmatch.merge(base, ours, ours, progress=lambda *step: False)
    told = []
    quadmatch.merge(base, ours, ours, progress=lambda *step: told.append(step))
    assert told[-1] == (ours.face_count, ours.face_count)
