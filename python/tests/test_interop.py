import types

import numpy as np
import pytest

import quadmatch
from conftest import grid

meshio = pytest.importorskip("meshio")
VERTICES, FACES = grid(2, 3)


def test_a_mesh_goes_to_meshio_and_back():
    mesh = quadmatch.Mesh(VERTICES, [[0, 1, 4], [1, 5, 4], [1, 2, 6, 5], [4, 5, 9, 8], [5, 6, 10, 9]],
                          vertex_data={"weight": np.arange(12) / 3}, face_data={"part": np.array([1, 2, 3, 4, 5])})
    out = mesh.to_meshio()
    assert isinstance(out, meshio.Mesh) and [block.type for block in out.cells] == ["triangle", "quad"]
    again = quadmatch.check(out)
    assert (again.triangles, again.quads) == (2, 3)
    done = quadmatch.transfer(out, mesh, only="properties", allow_ambiguous=True)
    assert (done.mesh.vertex_data["weight"] == mesh.vertex_data["weight"]).all()
    assert (done.mesh.face_data["part"] == mesh.face_data["part"]).all()


def test_meshes_of_meshio_are_matched_as_they_are(bear, examples):
    one = meshio.Mesh(bear.vertices, [("quad", bear.faces)])
    assert quadmatch.match(one, examples / "bear_no_ears_posed.obj").matched_faces == 2644


def test_points_in_the_plane_and_lines_are_fine_solids_are_not():
    flat = meshio.Mesh(VERTICES[:, :2], [("line", [[0, 1]]), ("quad", FACES)])
    assert quadmatch.check(flat).quads == 6
    with pytest.raises(ValueError, match="cells of type tetra are no faces; extract the surface first"):
        quadmatch.check(meshio.Mesh(VERTICES, [("tetra", [[0, 1, 4, 5]])]))
    with pytest.raises(ValueError, match="more nodes than corners"):
        quadmatch.check(meshio.Mesh(VERTICES, [("quad8", [[0, 1, 2, 3, 4, 5, 6, 7]])]))


def test_a_mesh_without_positions_does_not_go_to_meshio():
    with pytest.raises(ValueError, match="no positions"):
        quadmatch.Mesh(None, FACES).to_meshio()


def test_whatever_has_vertices_and_faces_is_a_mesh():
    # As trimesh.Trimesh has them; trimesh itself is not in Debian.
    like_trimesh = types.SimpleNamespace(vertices=VERTICES, faces=np.array([[0, 1, 5], [0, 5, 4]]))
    assert quadmatch.check(like_trimesh).triangles == 2
    assert quadmatch.match(like_trimesh, like_trimesh).matched_faces == 2
