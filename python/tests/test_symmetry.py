import numpy as np
import pytest

import quadmatch
from conftest import grid


@pytest.fixture(scope="module")
def figure(examples):
    """Wholly symmetric, and at rest: its sides lie to +x and -x of x = 6."""
    return quadmatch.read(examples / "fig_4_1.obj")


@pytest.fixture(scope="module")
def mirror(figure):
    return quadmatch.symmetry(figure)


def posed(mesh):
    """Where nothing is opposite any more."""
    return mesh.vertices + np.sin(mesh.vertices[:, [1, 2, 0]] * 3) + mesh.vertices[:, [1, 0, 2]] / 4


def test_every_vertex_has_the_partner_that_its_position_says(figure, mirror):
    assert mirror.whole and mirror.complete and mirror.mirrors == 1 and not mirror.maybe_more
    assert np.allclose(figure.vertices[mirror.vertex_map], [12, 0, 0] + figure.vertices * [-1, 1, 1])
    assert mirror.plane.fits and mirror.plane.error < 1e-9
    assert np.allclose(mirror.plane.normal, (1, 0, 0)) and mirror.plane.offset == pytest.approx(6)


def test_the_map_is_its_own_inverse_and_a_sound_match(figure, mirror):
    assert (mirror.vertex_map[mirror.vertex_map] == np.arange(figure.vertex_count)).all()
    assert (mirror.face_map[mirror.face_map] == np.arange(figure.face_count)).all()
    assert quadmatch.verify(figure, figure, mirror.match)
    assert {region.orientation for region in mirror.match.regions} == {"reversing"}


def test_the_centre_line_is_what_lies_on_itself(figure, mirror):
    line = mirror.line
    assert line.vertices.tolist() == np.flatnonzero(mirror.vertex_map == np.arange(figure.vertex_count)).tolist()
    assert line.faces.tolist() == np.flatnonzero(mirror.face_map == np.arange(figure.face_count)).tolist()
    assert (figure.vertices[line.vertices, 0] == 6).all() and np.isin(line.edges, line.vertices).all()
    one, other = line.crossed_edges.T
    assert len(one) > 0 and (mirror.vertex_map[one] == other).all()
    assert 2 * mirror.vertex_pairs + len(line.vertices) == figure.vertex_count
    assert 2 * mirror.face_pairs + len(line.faces) == figure.face_count


def test_a_posed_model_has_the_same_mirror_but_no_plane(figure, mirror):
    found = quadmatch.symmetry(quadmatch.Mesh(posed(figure), figure.faces))
    assert (found.vertex_map == mirror.vertex_map).all() and not found.plane.fits
    blind = quadmatch.symmetry(quadmatch.Mesh(None, figure.faces), positions=False)
    assert blind.plane is None and blind.whole and blind.match.settings["positions"] == "false"


def test_what_has_no_partner_is_named(bear):
    found = quadmatch.symmetry(bear)
    assert not found.whole and 0 < len(found.unpaired_faces) < 100
    assert found.unpaired_faces.tolist() == np.flatnonzero(found.face_map < 0).tolist()
    assert found.unpaired_vertices.tolist() == np.flatnonzero(found.vertex_map < 0).tolist()
    paired = np.flatnonzero(found.vertex_map >= 0)
    off = bear.vertices[found.vertex_map[paired]] - bear.vertices[paired] * [-1, 1, 1]
    assert (np.linalg.norm(off, axis=1) < 1e-4).mean() > 0.9  # some lie a row off beside what has no partner


def test_arrays_of_a_symmetry_are_views_and_outlive_it(figure):
    mirror = quadmatch.symmetry(figure)
    kept, expected = mirror.line.vertices, mirror.line.vertices.tolist()
    with pytest.raises(ValueError, match="read-only"):
        kept[0] = 0
    del mirror
    assert kept.tolist() == expected


def test_symmetrize_brings_the_other_side_to_where_this_one_is(figure):
    pushed = np.array(figure.vertices)
    pushed[pushed[:, 0] > 6, 1] += 0.01 * pushed[pushed[:, 0] > 6, 0]
    mesh = quadmatch.Mesh(pushed, figure.faces)
    even = quadmatch.symmetrize(mesh, side="-x")
    left = figure.vertices[:, 0] < 6
    assert (even.mesh.vertices[left] == figure.vertices[left]).all()
    assert quadmatch.symmetry(even.mesh).plane.error < 1e-9  # though in another plane than the figure's
    assert even.moved > 0 and even.farthest > 0.05 and even.attributes == ()
    assert (even.mesh.faces == figure.faces).all()
    given = quadmatch.symmetrize(mesh, quadmatch.symmetry(figure), side="-x")
    assert np.allclose(given.mesh.vertices, figure.vertices)


def test_symmetrize_copies_data_of_posed_models_too(figure, mirror):
    weight = np.random.default_rng(1).random(figure.vertex_count)
    mesh = quadmatch.Mesh(posed(figure), figure.faces, vertex_data={"weight": weight})
    done = quadmatch.symmetrize(mesh, side="+x", only=["properties"])
    found = done.mesh.vertex_data["weight"]
    assert (found == found[mirror.vertex_map]).all() and (done.mesh.vertices == mesh.vertices).all()
    assert [row.name for row in done.attributes] == ["weight"] and done.moved == 0
    with pytest.raises(ValueError, match="the model is posed"):
        quadmatch.symmetrize(mesh, side="+x")


@pytest.mark.parametrize("options, sentence", [
    ({"side": "left"}, "side: there is no 'left'; give +x, -x, +y, -y, +z or -z"),
    ({"side": "+y"}, "mesh: its sides lie to +x and -x, none to y; choose the axis across the mirror"),
    ({"side": "+x", "only": "none"}, "only: there is no 'none'; give uv, colours, properties, groups, materials, "
                                     "smoothing, normals or positions"),
])
def test_wishes_that_mean_nothing_are_refused_in_a_sentence(figure, mirror, options, sentence):
    with pytest.raises(ValueError) as refused:
        quadmatch.symmetrize(quadmatch.Mesh(figure.vertices, figure.faces), mirror, **options)
    assert str(refused.value) == sentence


def test_a_symmetry_of_another_mesh_is_refused(mirror):
    with pytest.raises(ValueError, match="the match was made for a source of 165 faces, but mesh has 4"):
        quadmatch.symmetrize(quadmatch.Mesh(*grid(2, 2)), mirror, side="+x")
    with pytest.raises(ValueError, match="it has no positions"):
        quadmatch.symmetrize(quadmatch.Mesh(None, grid(2, 2)[1]), side="+x")


def test_progress_of_the_search_is_told_and_may_stop_it(figure, bear):
    told = []
    assert quadmatch.symmetry(figure, progress=lambda *step: told.append(step)).whole
    assert told[-1] == (figure.face_count, figure.face_count)
    assert not quadmatch.symmetry(bear, progress=lambda *step: False).complete
    with pytest.raises(ValueError, match="cannot be called"):
        quadmatch.symmetry(figure, progress=3)
