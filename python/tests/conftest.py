import pathlib

import numpy as np
import pytest

import quadmatch

ROOT = pathlib.Path(__file__).resolve().parents[2]


def grid(rows, columns):
    """A patch of quads in the plane: positions and an (M, 4) array."""
    number = np.arange((rows + 1) * (columns + 1)).reshape(rows + 1, columns + 1)
    faces = np.stack([number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1]], axis=-1).reshape(-1, 4)
    y, x = np.divmod(np.arange(number.size), columns + 1)
    return np.column_stack([x, y, 0 * x]).astype(float), faces


def renumbered(vertices, faces, seed):
    """The same mesh in another order: positions, faces, and the new number of each vertex and face."""
    rng = np.random.default_rng(seed)
    vertex_to, face_to = rng.permutation(len(vertices)), rng.permutation(len(faces))
    new_vertices, new_faces = np.empty_like(vertices), np.empty_like(faces)
    new_vertices[vertex_to] = vertices
    new_faces[face_to] = vertex_to[faces]
    return new_vertices, new_faces, vertex_to, face_to


@pytest.fixture(scope="session")
def examples():
    return ROOT / "examples"


@pytest.fixture(scope="session")
def bear(examples):
    return quadmatch.read(examples / "bear.obj")


@pytest.fixture(scope="session")
def earless(examples):
    return quadmatch.read(examples / "bear_no_ears_posed.obj")


@pytest.fixture(scope="session")
def bears(bear, earless):
    return quadmatch.match(bear, earless)
