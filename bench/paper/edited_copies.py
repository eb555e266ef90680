"""Edited copies by the project's own generator, and how much of their truth a match found."""
import contextlib
import json
import pathlib
import subprocess
import tempfile


def run_tool(options, name, *words):
    """Raises LookupError with what the program said where it refused."""
    ended = subprocess.run([str(options.build / name), *map(str, words)], capture_output=True, text=True, check=False)
    if ended.returncode != 0:
        raise LookupError(ended.stderr.strip())


@contextlib.contextmanager
def edited_copy(options, mesh, edits, seed):
    """The file of an edited copy, and its true pairs (face, face): rotation. Raises LookupError where an edit does not fit."""
    with tempfile.TemporaryDirectory() as folder:
        target, truth = pathlib.Path(folder, "b.obj"), pathlib.Path(folder, "truth.json")
        run_tool(options, "edit_mesh", mesh, target, *edits, "--seed", seed, "--truth", truth)
        pairs = json.loads(truth.read_text(encoding="utf-8"))["exact"]
        yield target, {(f, g): r for f, g, r in pairs}


def true_pairs(match, truth):
    """How many pairs of a match are true, rotation included."""
    return sum(truth.get((f, g)) == r and region["orientation"] == "preserving"
               for region in match["regions"] for f, g, r in region["faces"])


def recall(match, truth):
    return true_pairs(match, truth) / max(1, len(truth))
