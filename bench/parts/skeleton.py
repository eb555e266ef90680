"""Sizes of skeleton graphs beside the paper's Table 5.1, and whether renumbering changes them."""
import json

from parts.common import ROOT, Bar, keep, kept, run, table
from parts.subjects import edited_copy

# Table 5.1 of the paper: vertices and edges of the mesh, then of its skeleton graph, then the reduction.
PAPER = [("bear", 1070, 2110, 202, 393, 81), ("chick", 932, 1827, 32, 56, 97), ("shirt", 3099, 6134, 518, 1015, 83),
         ("director", 9958, 19889, 2510, 5001, 75), ("tommy", 10281, 20530, 2496, 4973, 76),
         ("body", 13238, 26457, 3176, 6339, 76), ("girl", 6976, 13903, 2340, 4647, 66)]
KEYS = ["vertices", "edges", "graph_vertices", "graph_edges", "reduction_percent"]
HEADER = ["model", "vertices", "edges", "skeleton vertices", "skeleton edges", "reduction"]


def sizes_of(options, mesh):
    figures = json.loads(run([options.program, "skeleton", mesh, "--json", "--quiet"]))
    return {key: figures[0][key] for key in KEYS}


def measure(options):
    rows = []
    for mesh in sorted((ROOT / "examples").glob("*.obj")) + sorted(options.meshes.glob("*.obj")):
        sizes = sizes_of(options, mesh)
        row = {"model": mesh.stem, **sizes}
        if options.collection:  # no edit: only renumbered
            with edited_copy(mesh, [], seed=0) as (_, shuffled, _):
                row["same when renumbered"] = sizes == sizes_of(options, shuffled)
        rows.append(row)
    keep(options, "skeleton.json", rows)


def bars(options):
    checked = [row["same when renumbered"] for row in kept(options, "skeleton.json") or [] if "same when renumbered" in row]
    return [Bar("skeleton graphs: same sizes when renumbered", sum(checked) / len(checked), 1)] if checked else []


def page(options):
    rows = kept(options, "skeleton.json")
    if not rows:
        return []
    page = ["\n## Skeleton graphs\n", "The paper's Table 5.1:\n",
            table(HEADER, [[name, f"{v:,}", f"{e:,}", f"{sv:,}", f"{se:,}", f"{r} %"] for name, v, e, sv, se, r in PAPER]),
            "\nOurs, by `quadmatch skeleton`: the shipped examples and the real meshes.\n"]
    ours = [[row["model"]] + [f"{row[key]:,}" for key in KEYS[:-1]] + [f"{row[KEYS[-1]]:.0f} %"] for row in rows]
    page.append(table(HEADER, ours))
    checked = [row for row in rows if "same when renumbered" in row]
    same = sum(row["same when renumbered"] for row in checked)
    if checked:
        page.append(f"\nRenumbered copies of {len(checked)} meshes gave the same sizes for {same} of them.\n")
    return page
