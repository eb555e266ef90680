"""cluster/dask_pairs.py: pairs of a list on the workers of a dask cluster."""
import json
import subprocess
import sys

import pytest

import quadmatch
from conftest import ROOT

pytest.importorskip("distributed", reason="Debian's python3-distributed is not installed")


def test_the_pairs_of_a_list_are_matched_on_workers_and_a_pair_that_fails_is_an_answer(tmp_path, examples):
    names = ["bear.obj", "bear_no_ears_posed.obj", "bear_posed.obj", "missing.obj", "fig_4_1.obj", "fig_4_2.obj"]
    pairs = [(names[k], names[(k * 2 + 1) % len(names)]) for k in range(len(names))]
    for name in names:
        if (examples / name).exists():
            (tmp_path / name).write_bytes((examples / name).read_bytes())
    listed = tmp_path / "pairs.csv"
    listed.write_text("source,target\n" + "".join(f"{source},{target}\n" for source, target in pairs), encoding="utf-8")
    output = tmp_path / "out.jsonl"
    ended = subprocess.run([sys.executable, ROOT / "cluster" / "dask_pairs.py", listed, output, "--workers", "2", "--chunk",
                            "2"], capture_output=True, text=True, check=False, timeout=300)
    assert ended.returncode == 0, ended.stderr
    rows = [json.loads(line) for line in output.read_text(encoding="utf-8").splitlines()]
    assert [(row["source"], row["target"]) for row in rows] == [(str(tmp_path / s), str(tmp_path / t)) for s, t in pairs]
    for (source, target), row in zip(pairs, rows):
        if "missing.obj" in (source, target):
            assert "missing.obj" in row["error"]
            continue
        match = quadmatch.match(examples / source, examples / target)
        assert row["error"] is None
        assert row["matched_faces"] == match.matched_faces
        assert row["regions"] == len(match.regions)
