import numpy as np
import pytest

import quadmatch
from conftest import renumbered


@pytest.fixture(scope="module")
def bent(bear):
    """A bear without a plane of symmetry, with data on it."""
    vertices = bear.vertices + np.sin(bear.vertices[:, [1, 2, 0]] * 3)
    return quadmatch.Mesh(vertices, bear.faces, vertex_data={"weight": np.arange(len(vertices)) / 7},
                          face_data={"part": np.arange(bear.face_count) % 5},
                          texture_coordinates=vertices[:, :2][bear.corners])


def test_data_follow_the_vertices_faces_and_corners_of_a_renumbered_copy(bent):
    vertices, faces, vertex_to, face_to = renumbered(bent.vertices, bent.faces, seed=5)
    done = quadmatch.transfer(bent, quadmatch.Mesh(vertices, faces))
    assert done.complete and done.left_out == () and done.matched_faces == len(faces)
    assert (done.mesh.vertex_data["weight"][vertex_to] == bent.vertex_data["weight"]).all()
    assert (done.mesh.face_data["part"][face_to] == bent.face_data["part"]).all()
    values, index = done.mesh.texture_coordinates
    assert (values[index] == done.mesh.vertices[:, :2][done.mesh.corners]).all()
    carried = {row.name: (row.domain, row.carried) for row in done.attributes}
    assert carried["weight"] == ("vertex", len(vertices)) and carried["part"] == ("face", len(faces))
    assert carried["texture coordinates"] == ("corner", 4 * len(faces))


def test_only_carries_only_that(bent):
    done = quadmatch.transfer(bent, quadmatch.Mesh(bent.vertices, bent.faces), only="uv")
    assert done.mesh.texture_coordinates is not None and done.mesh.vertex_data == {}


def test_order_gives_the_numbers_of_the_source_back(bent):
    vertices, faces, _, _ = renumbered(bent.vertices, bent.faces, seed=6)
    match = quadmatch.match(bent.vertices, bent.faces, vertices, faces)
    target = quadmatch.Mesh(vertices, faces)
    done = quadmatch.transfer(bent, target, match, only=["none"], order=True)
    assert (done.mesh.faces == bent.faces).all() and (done.mesh.vertices == bent.vertices).all()


def test_what_is_new_keeps_gets_nothing_or_goes_on_smoothly(bear, earless):
    source = quadmatch.Mesh(bear.vertices, bear.faces, vertex_data={"weight": np.ones(bear.vertex_count)})
    none = quadmatch.transfer(source, earless, fill="none", allow_ambiguous=True)
    smooth = quadmatch.transfer(source, earless, fill="smooth", allow_ambiguous=True)
    assert not none.complete and (none.mesh.vertex_data["weight"] == 0).sum() == none.attributes[0].without > 0
    assert np.allclose(smooth.mesh.vertex_data["weight"], 1) and smooth.attributes[0].filled == none.attributes[0].without


def test_doubtful_parts_are_left_out_and_named():
    faces = np.array([[0, 1, 4, 3], [1, 2, 5, 4]])
    source = quadmatch.Mesh(None, faces, vertex_data={"weight": np.arange(6)})
    done = quadmatch.transfer(source, quadmatch.Mesh(None, faces))
    assert done.matched_faces == 0 and [part.reason for part in done.left_out] == ["ambiguous"]
    assert done.left_out[0].ways >= 2 and done.left_out[0].faces == 2
    assert quadmatch.transfer(source, quadmatch.Mesh(None, faces), allow_ambiguous=True).complete


@pytest.mark.parametrize("options, sentence", [
    ({"only": "uvs"}, "only: there is no 'uvs'; give uv, colours, properties, groups, materials, smoothing, normals, "
                      "positions or none"),
    ({"fill": "full"}, "fill: there is no 'full'; give keep, none or smooth"),
    ({"min_confidence": -1}, "min_confidence: -1 is no share; give a number from 0 to 1"),
])
def test_options_that_mean_nothing_are_refused_in_a_sentence(bent, options, sentence):
    with pytest.raises(ValueError) as refused:
        quadmatch.transfer(bent, bent, **options)
    assert str(refused.value) == sentence


def test_a_source_without_data_is_refused(bear, earless):
    with pytest.raises(ValueError, match="it has none of the data that are to be carried"):
        quadmatch.transfer(quadmatch.Mesh(None, bear.faces), earless, only="uv")
