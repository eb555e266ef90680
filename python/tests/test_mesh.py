import gc

import numpy as np
import pytest

import quadmatch
from conftest import grid

MIXED = [[0, 1, 4, 3], [1, 2, 4], [0, 3, 4, 2, 1]]


def test_faces_come_as_array_as_lists_and_as_offsets_and_indices():
    vertices, faces = grid(2, 3)
    offsets, indices = np.arange(0, 25, 4), faces.ravel()
    for given in (faces, faces.tolist(), [tuple(face) for face in faces], (offsets, indices), (list(offsets), list(indices))):
        mesh = quadmatch.Mesh(vertices, given)
        assert mesh.all_quads and mesh.faces.shape == (6, 4)
        assert (mesh.faces == faces).all() and (mesh.vertices == vertices).all()
        assert (mesh.offsets == offsets).all()


def test_polygons_of_any_size_keep_their_corners_and_go_round():
    mesh = quadmatch.Mesh(None, MIXED)
    assert not mesh.all_quads and mesh.vertices is None and mesh.vertex_count == 5
    offsets, indices = mesh.faces
    assert offsets.tolist() == [0, 4, 7, 12] and indices.tolist() == sum(MIXED, [])
    again = quadmatch.Mesh(None, mesh.faces)
    assert (again.corners == mesh.corners).all() and (again.offsets == mesh.offsets).all()


def test_triangles_may_be_an_array_of_three_columns():
    mesh = quadmatch.Mesh(None, np.array([[0, 1, 2], [2, 1, 3]]))
    assert mesh.face_count == 2 and mesh.faces[0].tolist() == [0, 3, 6]


@pytest.mark.parametrize("dtype", ["int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64", ">i4"])
def test_faces_may_be_integers_of_any_type(dtype):
    vertices, faces = grid(3, 3)
    assert (quadmatch.Mesh(vertices, faces.astype(dtype)).faces == faces).all()


@pytest.mark.parametrize("reorder", [np.asfortranarray, lambda a: np.repeat(a, 2, axis=0)[::2], lambda a: a[::-1][::-1],
                                     lambda a: a.astype(a.dtype.newbyteorder())])
def test_arrays_may_have_any_memory_order(reorder):
    vertices, faces = grid(3, 4)
    mesh = quadmatch.Mesh(reorder(vertices), reorder(faces))
    assert (mesh.faces == faces).all() and (mesh.vertices == vertices).all()


def test_arrays_of_a_mesh_are_views_read_only_and_outlive_it():
    vertices, faces = grid(2, 2)
    mesh = quadmatch.Mesh(vertices, faces)
    assert np.shares_memory(mesh.vertices, mesh.vertices) and np.shares_memory(mesh.faces, mesh.corners)
    for array in (mesh.vertices, mesh.faces, mesh.corners):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0
    kept = mesh.vertices
    vertices[:] = 7
    del mesh
    gc.collect()
    assert (kept == grid(2, 2)[0]).all()


def test_positions_may_be_any_finite_numbers():
    extreme = np.array([np.finfo(float).max, -np.finfo(float).max, 5e-324, -0.0, 1.0, -1.0]).reshape(2, 3)
    assert (quadmatch.Mesh(extreme, [[0, 1, 0]]).vertices == extreme).all()
    for wrong in (np.nan, np.inf, -np.inf, -np.nan):
        with pytest.raises(ValueError, match="vertex v1 is not a finite number"):
            quadmatch.Mesh([[0, 0, 0], [0, wrong, 0]], [[0, 1, 0]])


def test_data_of_vertices_faces_and_corners_survive_a_file(tmp_path):
    vertices, faces = grid(2, 2)
    weight, part = np.linspace(0, 1, 9), np.array([3, 1, 4, 1])
    mesh = quadmatch.Mesh(vertices, faces, vertex_data={"weight": weight}, face_data={"part": part},
                          texture_coordinates=vertices[:, :2][faces.ravel()])
    assert (mesh.vertex_data["weight"] == weight).all() and (mesh.face_data["part"] == part).all()
    for ply in ("binary", "ascii", "big-endian"):
        quadmatch.write(tmp_path / "a.ply", mesh, ply=ply)
        again = quadmatch.read(tmp_path / "a.ply")
        assert (again.vertex_data["weight"] == weight).all() and (again.face_data["part"] == part).all()
    quadmatch.write(tmp_path / "a.obj", mesh)
    again = quadmatch.read(tmp_path / "a.obj")
    values, index = again.texture_coordinates
    assert (values[index] == vertices[:, :2][faces.ravel()]).all()
    assert again.path == str(tmp_path / "a.obj") and (again.faces == faces).all()


def test_corners_without_texture_coordinates_have_the_index_minus_one(tmp_path):
    vertices, faces = grid(1, 1)
    mesh = quadmatch.Mesh(vertices, faces, texture_coordinates=([[0.5, 0.25]], [0, -1, 0, -1]))
    values, index = mesh.texture_coordinates
    assert values.tolist() == [[0.5, 0.25]] and index.tolist() == [0, -1, 0, -1]


def test_a_file_name_may_hold_any_character(tmp_path):
    path = tmp_path / b"b\xe4r.obj".decode(errors="surrogateescape")
    quadmatch.write(path, quadmatch.Mesh(*grid(1, 1)))
    assert quadmatch.read(path).path == str(path)
