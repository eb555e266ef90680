"""What holds for every input, tried on many by hypothesis."""
import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

import quadmatch
from conftest import grid, renumbered

# The same examples on every run; time is not the matter.
steady = settings(derandomize=True, deadline=None, max_examples=60)
polygons = st.lists(st.lists(st.integers(0, 11), min_size=3, max_size=6), min_size=1, max_size=12)


@st.composite
def patches(draw):
    """A piece of a grid: positions and faces."""
    vertices, faces = grid(draw(st.integers(1, 6)), draw(st.integers(1, 6)))
    kept = draw(st.lists(st.booleans(), min_size=len(faces), max_size=len(faces)))
    chosen = faces[kept] if any(kept) else faces
    return vertices, chosen


@steady
@given(polygons)
def test_any_polygons_come_back_as_they_were_given(faces):
    mesh = quadmatch.Mesh(None, faces)
    offsets = mesh.offsets
    assert [mesh.corners[a:b].tolist() for a, b in zip(offsets, offsets[1:])] == faces


@steady
@given(polygons, polygons, st.sampled_from(["regions", "lazy-greedy", "greedy"]))
def test_any_two_meshes_however_dirty_have_a_sound_match(one, other, algorithm):
    match = quadmatch.match(None, one, None, other, algorithm=algorithm)
    assert quadmatch.verify(quadmatch.Mesh(None, one), quadmatch.Mesh(None, other), match)


@steady
@given(patches(), st.integers(0, 2**32 - 1))
def test_a_renumbered_copy_is_matched_whole_and_keeps_its_hash(patch, seed):
    vertices, faces = patch
    new_vertices, new_faces, _, _ = renumbered(vertices, faces, seed)
    match = quadmatch.match(vertices, faces, new_vertices, new_faces)
    assert match.matched_faces == len(faces)
    assert quadmatch.connectivity_hash(quadmatch.Mesh(vertices, faces)) == quadmatch.connectivity_hash(
        quadmatch.Mesh(new_vertices, new_faces))


@steady
@given(patches(), st.sampled_from(["obj", "ply", "off", "usda"]))
def test_every_format_gives_the_same_mesh_back(tmp_path_factory, patch, ending):
    vertices, faces = patch
    path = tmp_path_factory.mktemp("mesh") / f"mesh.{ending}"
    quadmatch.write(path, quadmatch.Mesh(vertices, faces))
    again = quadmatch.read(path)
    assert (again.faces == faces).all() and (again.vertices == vertices).all()


anything = st.one_of(
    st.none(), st.integers(), st.text(max_size=4), st.lists(st.lists(st.integers(-3, 2**40) | st.floats() | st.text(max_size=2),
                                                                     max_size=5), max_size=4),
    arrays.arrays(arrays.integer_dtypes() | arrays.floating_dtypes() | arrays.boolean_dtypes() | arrays.complex_number_dtypes(),
                  arrays.array_shapes(min_dims=0, max_dims=3, max_side=5)),
    st.tuples(st.lists(st.integers(-2, 9), max_size=4), st.lists(st.integers(-2, 9), max_size=9)))


@settings(steady, max_examples=400)
@given(anything, anything)
def test_whatever_is_given_is_a_mesh_or_a_value_error_of_one_line(vertices, faces):
    try:
        mesh = quadmatch.Mesh(vertices, faces)
    except ValueError as error:
        assert str(error).startswith("mesh: ") and "\n" not in str(error)
    else:
        assert mesh.face_count > 0 and (mesh.corners >= 0).all() and (mesh.corners < mesh.vertex_count).all()
        assert mesh.vertices is None or np.isfinite(mesh.vertices).all()
