import os
import signal
import threading

import numpy as np
import pytest

import quadmatch
from conftest import grid, renumbered


def test_the_earless_bear_is_found_in_the_bear_and_the_match_is_sound(bear, earless, bears):
    assert bears.matched_faces == 2644 and len(bears.vertices) == 2666 and bears.complete
    assert [len(region) for region in bears.regions] == [2644]
    verdict = quadmatch.verify(bear, earless, bears)
    assert verdict and verdict.faults == () and verdict.largest_region == 2644


def test_four_arrays_match_as_two_meshes_do(bear, earless, bears):
    by_arrays = quadmatch.match(bear.vertices, bear.faces, earless.vertices, earless.faces.tolist())
    assert (by_arrays.faces == bears.faces).all() and (by_arrays.vertices == bears.vertices).all()


def test_a_renumbered_copy_is_matched_vertex_by_vertex(bear):
    # Posed without a symmetry plane, so that there is one way only.
    vertices = bear.vertices + np.sin(bear.vertices[:, [1, 2, 0]] * 3)
    new_vertices, new_faces, vertex_to, face_to = renumbered(vertices, bear.faces, seed=3)
    match = quadmatch.match(vertices, bear.faces, new_vertices, new_faces)
    assert (match.vertex_map == vertex_to).all() and (match.face_map == face_to).all()


def test_maps_say_the_same_as_pairs(bear, bears):
    for column, pairs in ((bears.face_map, bears.faces[:, :2]), (bears.vertex_map, bears.vertices)):
        assert (column[pairs[:, 0]] == pairs[:, 1]).all()
        assert (column >= 0).sum() == len(pairs)
    assert len(bears.face_map) == bear.face_count and len(bears.vertex_map) == bear.vertex_count


def test_corners_follow_the_rotation(bear, earless, bears):
    region = bears.regions[0]
    assert region.orientation == "preserving" and not region.ambiguous
    f, g, r = region.faces.T
    for corner in range(4):
        image = earless.faces[g, (r + corner) % 4]
        assert (bears.vertex_map[bear.faces[f, corner]] == image).all()


def test_a_mirror_image_lies_the_other_way_round(bear):
    vertices = bear.vertices + np.sin(bear.vertices[:, [1, 2, 0]] * 3)
    match = quadmatch.match(vertices, bear.faces, vertices * [-1, 1, 1], bear.faces[:, ::-1], orientation="reversing")
    assert match.regions[0].orientation == "reversing"
    assert (match.vertex_map == np.arange(len(vertices))).all()


def test_arrays_of_a_match_are_views_read_only_and_outlive_it():
    match = quadmatch.match(*grid(3, 3), *grid(3, 3))
    faces, vertices = match.regions[0].faces, match.vertices
    expected = faces.tolist()
    assert np.shares_memory(faces, match.faces)
    for array in (faces, vertices):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0
    del match
    assert faces.tolist() == expected


def test_anchors_are_never_overruled():
    vertices, faces = grid(4, 4)
    match = quadmatch.match(None, faces, None, faces, anchors=[(0, 0, 15, 2)], orientation="preserving")
    assert match.face_map.tolist() == list(range(15, -1, -1))
    assert match.settings["anchors"] == "0:0=15:2"


def test_the_exact_search_proves_the_largest_region():
    vertices, faces = grid(3, 3)
    match = quadmatch.match(None, faces, None, np.delete(faces, 4, axis=0), algorithm="exact")
    assert match.optimality["proved"] and match.optimality["bound"] == match.matched_faces == 8
    asked = quadmatch.match(None, faces, None, faces, algorithm="exact", at_least=9)
    assert asked.optimality["decision"] == "yes"


@pytest.mark.parametrize("algorithm", ["regions", "lazy-greedy", "greedy"])
def test_every_algorithm_gives_a_sound_match_and_the_same_on_every_run(bear, earless, algorithm):
    one, other = (quadmatch.match(bear, earless, algorithm=algorithm, waves=True) for _ in range(2))
    assert quadmatch.verify(bear, earless, one) and one.faces.tolist() == other.faces.tolist()
    if algorithm != "regions":
        assert one.regions[0].waves[-1] == one.matched_faces


def test_options_reach_the_matcher(bear, earless, bears):
    assert quadmatch.match(bear, earless, min_region=2645).matched_faces == 0
    assert quadmatch.match(bear, earless, positions=False).settings["positions"] == "false"
    assert quadmatch.match(bear, earless, without=["seams", "ties"]).settings["without"] == "seams ties"
    region = bears.regions[0]
    assert region.agreeing == 68 and (region.source_extraordinary, region.target_extraordinary) == (76, 70)
    assert region.confidence == 68 / 70


def test_progress_is_told_up_to_the_end(bear, earless, bears):
    told = []
    match = quadmatch.match(bear, earless, progress=lambda matched, most: told.append((matched, most)))
    assert told[-1] == (match.matched_faces, 2688) and len(told) > 1
    assert (match.faces == bears.faces).all()


def test_progress_stops_the_work_and_the_match_so_far_is_sound(bear, earless):
    match = quadmatch.match(bear, earless, progress=lambda matched, most: False)
    assert not match.complete and quadmatch.verify(bear, earless, match)


def test_what_progress_raises_is_passed_on(bear, earless):
    def refuse(matched, most):
        raise LookupError("enough")
    with pytest.raises(LookupError, match="enough"):
        quadmatch.match(bear, earless, progress=refuse)


@pytest.fixture
def interruptible():
    """Programs that a script starts in the background ignore the signal, and so would Python."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


def test_other_threads_run_meanwhile_and_the_user_may_interrupt(bear, earless, interruptible):
    began = threading.Event()

    def interrupt():  # runs only if the GIL is free while the search goes on
        began.wait(60)
        os.kill(os.getpid(), signal.SIGINT)

    thread = threading.Thread(target=interrupt)
    thread.start()
    with pytest.raises(KeyboardInterrupt):
        quadmatch.match(bear, earless, algorithm="exact", time_limit=60, progress=lambda *_: began.set())
        thread.join()
    thread.join()


def test_threads_match_at_the_same_time_and_agree(bear, earless, bears):
    found = [None] * 4

    def work(place):
        found[place] = quadmatch.match(bear, earless).faces.tolist()

    threads = [threading.Thread(target=work, args=(place,)) for place in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == [bears.faces.tolist()] * 4


def test_a_match_file_goes_round(tmp_path, bear, earless, bears):
    quadmatch.write_match(tmp_path / "m.json", bears)
    again = quadmatch.read_match(tmp_path / "m.json")
    assert (again.faces == bears.faces).all() and (again.vertices == bears.vertices).all()
    assert again.settings == bears.settings and quadmatch.verify(bear, earless, again)


def test_a_match_that_is_not_sound_is_told(tmp_path, bear, earless, bears):
    path = tmp_path / "m.json"
    quadmatch.write_match(path, bears)
    source, target, rotation = bears.faces[0]
    text = path.read_text()
    assert f"[{source}, {target}, {rotation}]" in text or f"[{source},{target},{rotation}]" in text
    for before, after in ((f"[{source}, {target}, {rotation}]", f"[{source}, {target}, {(rotation + 1) % 4}]"),
                          (f"[{source},{target},{rotation}]", f"[{source},{target},{(rotation + 1) % 4}]")):
        text = text.replace(before, after, 1)
    path.write_text(text)
    verdict = quadmatch.verify(bear, earless, quadmatch.read_match(path), faults=2)
    assert not verdict and verdict.fault_count > 0 and 1 <= len(verdict.faults) <= 2
