import os
import subprocess

import numpy as np
import pytest

import quadmatch
from conftest import ROOT, grid

VERTICES, FACES = grid(2, 2)
PROGRAM = ROOT / "build" / "release" / "quadmatch"


def with_value(array, place, value):
    changed = np.array(array, dtype=float)
    changed[place] = value
    return changed


@pytest.mark.parametrize("vertices, faces, sentence", [
    (VERTICES, FACES.astype(float), "mesh: faces must be integers, but the array is float64 of shape (4, 4); convert it with .astype(int)"),
    (VERTICES, FACES > 3, "mesh: faces must be integers, but the array is bool of shape (4, 4); convert it with .astype(int)"),
    (VERTICES, FACES.ravel(), "mesh: faces must be an array of shape (M, 4), a list of lists, or a tuple (offsets, indices), but it is int64 of shape (16,)"),
    (VERTICES, FACES[:, :2], "mesh: faces must be an array of shape (M, 4), a list of lists, or a tuple (offsets, indices), but it is int64 of shape (4, 2)"),
    (VERTICES, FACES.astype(str), "mesh: faces must be integers, but the array is <U21 of shape (4, 4); convert it with .astype(int)"),
    (VERTICES, [], "mesh: there are no faces; give the mesh with its faces"),
    (VERTICES, FACES[:0], "mesh: there are no faces; give the mesh with its faces"),
    (VERTICES, ([0], []), "mesh: there are no faces; give the mesh with its faces"),
    (VERTICES, {"a": 1}, "mesh: faces must be an array of shape (M, 4), a list of lists, or a tuple (offsets, indices), but it is object of shape ()"),
    (VERTICES, 7, "mesh: faces must be an array of shape (M, 4), a list of lists, or a tuple (offsets, indices), but it is int64 of shape ()"),
    (VERTICES, [[0, 1, 2], 5], "mesh: face f1 is 5; give the numbers of its vertices as a list"),
    (VERTICES, [[0, 1, 2], "123"], "mesh: face f1 is '123'; give the numbers of its vertices as a list"),
    (VERTICES, [[0, 1, 2], [0, 1, 2, [3]]], "mesh: faces must be lists of vertex numbers"),
    (VERTICES, [[0, 1, 2], [0, 1, 2, 3.5]], "mesh: faces must be integers, but the array is float64 of shape (7,); convert it with .astype(int)"),
    (VERTICES, [[0, 1, 2, 3], [0, 1]], "mesh: face f1 has fewer than three corners"),
    (VERTICES, [[0, 1, 2, 9]], "mesh: face f0 names vertex 9, but there are only 9 vertices, counted from 0"),
    (VERTICES, [[0, 1, 2], [0, -1, 2, 3]], "mesh: face f1 names vertex -1, but vertices count from 0"),
    (None, [[0, 1, 2, -7]], "mesh: face f0 names vertex -7, but vertices count from 0"),
    (VERTICES, np.array([[0, 1, 2, 2**63]], np.uint64), "mesh: faces hold 9223372036854775808, which is out of range"),
    (VERTICES, ([0, 4], FACES.ravel()), "mesh: the face starts do not divide the corners into faces"),
    (VERTICES, ([], FACES.ravel()), "mesh: offsets are empty; give M + 1 of them for M faces, from 0 to the number of indices"),
    (VERTICES, ([0, 9, 4, 16], FACES.ravel()), "mesh: face f1 has fewer than three corners"),
    (VERTICES, ([0, -4, 16], FACES.ravel()), "mesh: offset -4 is outside the 16 indices; offsets run from 0 to their number"),
    (VERTICES, ([0, 4.5, 16], FACES.ravel()), "mesh: offsets must be integers, but the array is float64 of shape (3,); convert it with .astype(int)"),
    (VERTICES, ([0, 4, 16], FACES), "mesh: indices must be an array of one axis, but it is int64 of shape (4, 4)"),
    (VERTICES, ([0, 1, 2], [1, 2, 3], [2, 3, 4]), "mesh: a tuple of faces must be (offsets, indices), but it has 3 parts; give single faces as a list"),
    (VERTICES[:, :2], FACES, "mesh: positions must be an array of shape (N, 3), but it is float64 of shape (9, 2)"),
    (VERTICES.ravel(), FACES, "mesh: positions must be an array of shape (N, 3), but it is float64 of shape (27,)"),
    (VERTICES.astype(complex), FACES, "mesh: positions must be real numbers, but the array is complex128 of shape (9, 3); convert it with .astype(float)"),
    (VERTICES.astype(object), FACES, "mesh: positions must be real numbers, but the array is object of shape (9, 3); convert it with .astype(float)"),
    ([[0, 0, 0], [1]], FACES, "mesh: positions do not all have the same length; give rows of equal length"),
    (with_value(VERTICES, (5, 1), np.nan), FACES, "mesh: a coordinate of vertex v5 is not a finite number; correct it, or give None for the positions"),
    (with_value(VERTICES, (0, 0), np.inf), FACES, "mesh: a coordinate of vertex v0 is not a finite number; correct it, or give None for the positions"),
])
def test_what_makes_no_mesh_is_refused_in_a_sentence(vertices, faces, sentence):
    with pytest.raises(ValueError) as refused:
        quadmatch.Mesh(vertices, faces)
    assert str(refused.value) == sentence


@pytest.mark.parametrize("more, sentence", [
    ({"vertex_count": 12}, "mesh: there are 9 positions, but vertex_count is 12; leave it out"),
    ({"vertex_data": {"w": [1, 2]}}, "mesh: vertex data 'w' must have shape (9,), one number for each vertex, but it is int64 of shape (2,)"),
    ({"face_data": {"w": ["a"] * 4}}, "mesh: face data 'w' must be numbers, but the array is <U1 of shape (4,)"),
    ({"face_data": {"w": [2**40] * 4}}, "mesh: face data 'w' hold integers beyond 32 bits, which no mesh file keeps; give float64"),
    ({"texture_coordinates": np.zeros((16, 4))}, "mesh: texture coordinates must be an array of shape (K, 2), or a tuple of it and the index of each corner, but it is float64 of shape (16, 4)"),
    ({"texture_coordinates": np.zeros((9, 2))}, "mesh: texture coordinates are indexed outside their 9 rows; -1 means none"),
    ({"texture_coordinates": (np.zeros((9, 2)), [0])}, "mesh: texture coordinates need an index for each of the 16 corners, but there are 1"),
    ({"texture_coordinates": np.full((16, 2), np.nan)}, "mesh: texture coordinates hold a number that is not finite; correct it"),
])
def test_data_that_do_not_fit_the_mesh_are_refused_in_a_sentence(more, sentence):
    with pytest.raises(ValueError) as refused:
        quadmatch.Mesh(VERTICES, FACES, **more)
    assert str(refused.value) == sentence


@pytest.mark.parametrize("options, sentence", [
    ({"algorithm": "best"}, "algorithm: there is no 'best'; give regions, lazy-greedy, greedy or exact"),
    ({"orientation": "up"}, "orientation: there is no 'up'; give auto, preserving or reversing"),
    ({"without": "seems"}, "without: there is no 'seems'; give equal-parts, seams, ties, slides, turns, ventures, slivers, islands, restarts, rows, acceptance or doubts"),
    ({"min_confidence": 2}, "min_confidence: 2 is no share; give a number from 0 to 1"),
    ({"min_confidence": float("nan")}, "min_confidence: nan is no share; give a number from 0 to 1"),
    ({"min_region": -1}, "min_region: -1 is no count; give a whole number from 0 on"),
    ({"at_least": 3}, "at_least needs algorithm='exact'; regions ends by itself"),
    ({"time_limit": 3}, "time_limit needs algorithm='exact'; regions ends by itself"),
    ({"time_limit": -3}, "time_limit: -3 is no time; give seconds, 0.001 or more"),
    ({"algorithm": "exact", "anchors": [[0, 0, 0, 0]]}, "algorithm='exact' looks at all places and takes no anchors; leave them out, or use regions"),
    ({"anchors": [[9, 0, 0, 0]]}, "anchors: the source has no face 9; its faces are 0 to 3"),
    ({"anchors": [[0, 0, 0, 4]]}, "anchors: face 0 of the target has no corner 4; its corners are 0 to 3"),
    ({"anchors": [0, 0, 0, 0]}, "anchors: rows must be source face, corner, target face, corner, so of shape (K, 4), but it is int64 of shape (4,)"),
    ({"progress": 3}, "progress: 3 cannot be called; give a function of two numbers"),
])
def test_options_that_mean_nothing_are_refused_in_a_sentence(options, sentence):
    with pytest.raises(ValueError) as refused:
        quadmatch.match(VERTICES, FACES, VERTICES, FACES, **options)
    assert str(refused.value) == sentence


def test_the_side_at_fault_is_named():
    with pytest.raises(ValueError, match=r"^target: face f0 names vertex 99"):
        quadmatch.match(VERTICES, FACES, VERTICES, [[0, 1, 2, 99]])
    with pytest.raises(ValueError, match=r"^source: this is no mesh but an object of type int; give "):
        quadmatch.match(3, quadmatch.Mesh(VERTICES, FACES))
    with pytest.raises(TypeError, match="takes two meshes, or V1, F1, V2, F2; 3 were given"):
        quadmatch.match(VERTICES, FACES, VERTICES)


def test_a_match_of_other_meshes_is_refused(bear, earless, bears):
    other = quadmatch.match(VERTICES, FACES, VERTICES, FACES)
    for use in (lambda: quadmatch.verify(bear, earless, other), lambda: quadmatch.transfer(bear, earless, other)):
        with pytest.raises(ValueError, match="4 faces"):
            use()


def bad_files(folder):
    (folder / "index.obj").write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 9\n")
    (folder / "number.obj").write_text("v 0 0 nan\n")
    (folder / "empty.obj").write_text("")
    (folder / "what.dat").write_text("what?\n")
    (folder / "cut.ply").write_text("ply\nformat ascii 1.0\nelement vertex 3\n")
    (folder / "folder").mkdir()
    return ["index.obj", "number.obj", "empty.obj", "what.dat", "cut.ply", "folder", "missing.obj"]


@pytest.mark.skipif(not PROGRAM.exists(), reason="the command line is not built (cmake --build --preset release)")
def test_files_are_refused_with_the_sentence_of_the_command_line(tmp_path, monkeypatch):
    names = bad_files(tmp_path)
    monkeypatch.chdir(tmp_path)
    for name in names:
        ended = subprocess.run([PROGRAM, "check", name], capture_output=True, text=True, check=False)
        with pytest.raises((ValueError, OSError)) as refused:
            quadmatch.read(name)
        assert f"quadmatch: {refused.value}\n" == ended.stderr


def test_files_that_cannot_be_read_or_written_are_errors_of_the_system(tmp_path):
    bad_files(tmp_path)
    with pytest.raises(FileNotFoundError):
        quadmatch.read(tmp_path / "missing.obj")
    with pytest.raises(FileNotFoundError):
        quadmatch.read_match(tmp_path / "missing.json")
    with pytest.raises(OSError):
        quadmatch.read(tmp_path / "folder")
    with pytest.raises(OSError):
        quadmatch.write(tmp_path / "nowhere" / "a.obj", quadmatch.Mesh(VERTICES, FACES))
    with pytest.raises(ValueError, match=r"index\.obj:4: vertex 9 is named"):
        quadmatch.read(tmp_path / "index.obj")
    with pytest.raises(ValueError, match="null character"):
        quadmatch.read("a\0.obj")


def test_a_failed_write_leaves_the_old_file(tmp_path):
    path = tmp_path / "a.obj"
    quadmatch.write(path, quadmatch.Mesh(VERTICES, FACES))
    before = path.read_bytes()
    path.chmod(0o444)
    if not os.access(path, os.W_OK):  # root may write all the same
        with pytest.raises(OSError):
            quadmatch.write(path, quadmatch.Mesh(VERTICES, FACES[:1]))
    with pytest.raises(ValueError):
        quadmatch.write(tmp_path / "a.xyz", quadmatch.Mesh(VERTICES, FACES))
    assert path.read_bytes() == before and os.listdir(tmp_path) == ["a.obj"]
