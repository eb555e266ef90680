import numpy as np
import pytest

import quadmatch
from conftest import renumbered


@pytest.fixture(scope="module")
def bent(bear):
    """A bear without a plane of symmetry."""
    return quadmatch.Mesh(bear.vertices + np.sin(bear.vertices[:, [1, 2, 0]] * 3), bear.faces)


def without_a_patch(mesh, seed_face=100):
    """The mesh without a face and those around it, and their numbers."""
    gone = np.flatnonzero(np.isin(mesh.faces, mesh.faces[seed_face]).any(axis=1))
    return quadmatch.Mesh(mesh.vertices, np.delete(mesh.faces, gone, axis=0)), gone


def test_a_renumbered_copy_has_no_differences(bent):
    vertices, faces, _, _ = renumbered(bent.vertices, bent.faces, seed=2)
    found = quadmatch.diff(bent, quadmatch.Mesh(vertices, faces))
    assert not found and found.same and found.changes == () and found.moved.shape == (0, 2)
    assert found.totals.matched_faces == found.totals.source_faces == bent.face_count


def test_a_hole_is_a_deletion_with_its_faces_and_the_other_way_round_an_addition(bent):
    holed, gone = without_a_patch(bent)
    found = quadmatch.diff(bent, holed)
    assert found and [change.kind for change in found.changes] == ["deletion"]
    change = found.changes[0]
    assert change.source_faces.tolist() == gone.tolist() and change.size == len(gone) and len(change.target_faces) == 0
    back = quadmatch.diff(holed, bent)
    assert [change.kind for change in back.changes] == ["addition"]
    assert back.changes[0].target_faces.tolist() == gone.tolist()


def test_moved_vertices_are_named_and_may_be_ignored(bent):
    vertices = np.array(bent.vertices)
    vertices[[5, 70]] += 0.1
    sculpted = quadmatch.Mesh(vertices, bent.faces)
    found = quadmatch.diff(bent, sculpted)
    assert found.moved.tolist() == [[5, 5], [70, 70]] and found.changes == () and found.whole_motion is None
    assert quadmatch.diff(bent, sculpted, ignore_positions=True).same
    assert quadmatch.diff(bent, sculpted, tolerance=0.5).same


def test_a_whole_that_moved_as_one_body_is_told_so(bent):
    motion = quadmatch.diff(bent, quadmatch.Mesh(2 * bent.vertices[:, [1, 2, 0]], bent.faces)).whole_motion
    assert motion.degrees == pytest.approx(120) and motion.scale == pytest.approx(2) and not motion.mirrored


def test_a_match_that_is_given_is_gone_by(bent):
    holed, gone = without_a_patch(bent)
    match = quadmatch.match(bent, holed)
    found = quadmatch.diff(bent, holed, match)
    assert found.match is match and found.changes[0].source_faces.tolist() == gone.tolist()
    with pytest.raises(ValueError, match="faces"):
        quadmatch.diff(holed, bent, match)


def test_the_kinds_are_those_of_the_command_line(bear, earless):
    found = quadmatch.diff(bear, earless)
    assert {change.kind for change in found.changes} <= {"coarsening", "re-connection", "deletion", "collapse"}
    assert sum(len(change.source_faces) for change in found.changes) == bear.face_count - found.totals.matched_faces


@pytest.mark.parametrize("options, sentence", [
    ({"tolerance": -1}, "tolerance: -1 is no share; give a number from 0 to 1"),
    ({"min_confidence": 7}, "min_confidence: 7 is no share; give a number from 0 to 1"),
    ({"orientation": "up"}, "orientation: there is no 'up'; give auto, preserving or reversing"),
])
def test_options_that_mean_nothing_are_refused_in_a_sentence(bent, options, sentence):
    with pytest.raises(ValueError) as refused:
        quadmatch.diff(bent, bent, **options)
    assert str(refused.value) == sentence


def test_a_search_that_is_stopped_is_no_difference(bent):
    holed, _ = without_a_patch(bent)
    with pytest.raises(quadmatch.Cancelled):
        quadmatch.diff(bent, holed, progress=lambda *step: False)
    told = []
    quadmatch.diff(bent, holed, progress=lambda *step: told.append(step))
    assert told
