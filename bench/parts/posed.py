"""Real pairs with one side posed: bent, and turned by 90 degrees."""
import json
import pathlib
import tempfile

from parts.common import Bar, command_line, keep, kept, table
from parts.subjects import in_parallel, match, pair_folders, posed, tool

POSES = ["turn", "bend:60"]
LEAST_RECALL = 0.99


def measure_pair(job):
    options, folder, pose = job
    obj = tool("objmesh")
    positions, faces = obj.read_obj(folder / "b.obj")
    with tempfile.TemporaryDirectory() as scratch:
        target = pathlib.Path(scratch, "b.obj")
        obj.write_obj(target, posed(positions, faces, pose), faces)
        found = match(options, folder / "a.obj", target)
    truth = json.loads((folder / "truth.json").read_text(encoding="utf-8"))
    return {"pair": folder.name, "pose": pose, **tool("score_match").score(truth, found, faces)}


def measure(options):
    jobs = [(options, folder, pose) for folder in pair_folders(options, known_only=True) for pose in POSES]
    keep(options, "posed.json", in_parallel(options, measure_pair, jobs))


def bars(options):
    rows = kept(options, "posed.json") or []
    return [Bar(f"real pairs posed: recall of {row['pair']}, {row['pose']}", row["recall"], LEAST_RECALL) for row in rows]


def page(options):
    rows = kept(options, "posed.json")
    if not rows:
        return []
    lines = [[row["pair"], f"`{row['pose']}`", row["surviving"], f"{row['recall']:.4f}", f"{row['near']:.4f}",
              f"{max(0, LEAST_RECALL - row['recall']):.4f}"] for row in rows]
    return ["\n## Real pairs, one side posed\n",
            f"{command_line('posed')}. The second mesh bent by 60 degrees about its longest axis, or turned by 90 degrees. "
            f"The bar is a recall of {LEAST_RECALL} on the faces known to be the same.\n",
            table(["pair", "pose", "known", "recall", "near", "missed by"], lines)]
