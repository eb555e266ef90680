"""Carry-over: texture coordinates stripped from an edited copy come back, and a renumbered copy gets its order back."""
import json
import pathlib
import statistics
import subprocess
import tempfile

from parts.common import Bar, bar_table, command_line, keep, kept, table
from parts.readings import known_corners
from parts.subjects import QUALITY_MESHES, edited_copy, edits_named, in_parallel, name_of, quality_meshes, tool

SEED = 1
QUICK_EDITS = ["renumber", "delete", "loop", "mirror"]
# The mirror image of a symmetric model lies on it either way round: which is meant must be said.
MORE = {"mirror": ("--orientation", "reversing")}
LEAST_EXACT = 0.99
LEAST_EXACT_HEAVY = 0.90
MOST_WRONG = 0.005


def texture_of(path):
    """The texture coordinates of each corner of each face of an OBJ file, or None."""
    pool, faces = [], []
    with open(path, encoding="utf-8", errors="replace") as file:
        for line in file:
            words = line.split()
            if words and words[0] == "vt":
                pool.append(tuple(float(word) for word in words[1:]))
            elif words and words[0] == "f":
                indices = [(word.split("/") + [""])[1] for word in words[1:]]
                faces.append([pool[int(index) - (int(index) > 0)] if index else None for index in indices])
    return faces


def transfer(options, source, target, output, *more):
    """The figures of a transfer, or None where nothing could be carried."""
    command = [options.program, "transfer", source, target, "-o", output, "--json", "--quiet", *more]
    ended = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    if ended.returncode in (0, 1):
        return json.loads(ended.stdout)
    if "nothing is carried" in ended.stderr:
        return None
    raise RuntimeError(f"{' '.join(map(str, command))}: {ended.stderr.strip()[-200:]}")


def compared(source, target, truth, known=None):
    """Of the surviving corners that had a texture coordinate, or of those among them that are known: all, those that have
    it again, those with another one."""
    turned = -1 if truth["orientation"] == "reversing" else 1
    all_corners = exact = wrong = 0
    for face, image, rotation in truth["exact"]:
        for corner, expected in enumerate(source[face]):
            if expected is None or (known is not None and (face, corner) not in known):
                continue
            found = target[image][(rotation + turned * corner) % len(source[face])]
            all_corners += 1
            exact += found == expected
            wrong += found is not None and found != expected
    return all_corners, exact, wrong


def carry_over(options, mesh, edit):
    row = {"mesh": name_of(mesh), "edit": edit}
    try:
        with edited_copy(mesh, edits_named(edit), SEED) as (_, target, truth), tempfile.TemporaryDirectory() as folder:
            output = pathlib.Path(folder, "out.obj")
            figures = transfer(options, mesh, target, output, "--only", "uv", *MORE.get(edit, ()))
            carried = texture_of(output if figures else target)
            corners, exact, wrong = compared(texture_of(mesh), carried, truth)
            known, exact_known = corners, exact
            if edit == "unloop":
                some = known_corners(*tool("objmesh").read_obj(mesh), texture_of(mesh), edits_named(edit), SEED)
                known, exact_known, _ = compared(texture_of(mesh), carried, truth, some)
            left_out = sum(part["faces"] for part in figures["left_out"]) if figures else len(truth["exact"])
            row |= {"corners": corners, "exact": exact / corners, "wrong": wrong / corners, "left out": left_out,
                    "known": known / corners, "exact of known": exact_known / known}
            bold = transfer(options, mesh, target, output, "--only", "uv", "--allow-ambiguous", *MORE.get(edit, ()))
            _, exact, wrong = compared(texture_of(mesh), texture_of(output if bold else target), truth)
            return row | {"exact, allowed": exact / corners, "wrong, allowed": wrong / corners}
    except LookupError as error:
        return row | {"skipped": str(error)}


def order_again(options, mesh):
    """Does --order give a renumbered copy the vertices, faces and corners of the mesh's own file?"""
    with edited_copy(mesh, [], SEED) as (source, target, _), tempfile.TemporaryDirectory() as folder:
        output = pathlib.Path(folder, "out.obj")
        figures = transfer(options, source, target, output, "--only", "none", "--order")
        read = tool("objmesh").read_obj
        return {"mesh": name_of(mesh), "same order": figures is not None and read(output) == read(source),
                "left out": sum(part["faces"] for part in figures["left_out"]) if figures else None}


def measure_job(job):
    options, mesh, edit = job
    return carry_over(options, mesh, edit) if edit else order_again(options, mesh)


def has_texture(mesh):
    return any(corner is not None for face in texture_of(mesh) for corner in face)


def meshes_of(options):
    if not options.quick:
        return quality_meshes(options)
    return [options.meshes / f"{name}.obj" for name in QUALITY_MESHES if name in ("mh_proxy741", "tbm_duck_sculpture")]


def measure(options):
    meshes = meshes_of(options)
    edits = QUICK_EDITS if options.quick else list(tool("quality").EDITS)
    textured = [mesh for mesh in meshes if has_texture(mesh)]
    jobs = [(options, mesh, edit) for edit in edits for mesh in textured] + [(options, mesh, "") for mesh in meshes]
    rows = in_parallel(options, measure_job, jobs)
    keep(options, "transfer.json", {"uv": [row for row in rows if "edit" in row],
                                    "order": [row for row in rows if "edit" not in row]})


def measured(figures, heavy=None):
    return [row for row in figures["uv"] if "exact" in row and (heavy is None or (row["edit"] == "heavy") == heavy)]


def exact_of_known(row):
    return row.get("exact of known", row["exact"])


def bars(options):
    figures = kept(options, "transfer.json")
    if not figures:
        return []
    found = []
    for heavy, least in ((False, LEAST_EXACT), (True, LEAST_EXACT_HEAVY)):
        rows, edits = measured(figures, heavy), "heavy edits" if heavy else "single edits"
        for what, share in (("exact", lambda row: row["exact"]), ("exact where the edited mesh tells", exact_of_known)):
            worst = min(rows, key=share, default=None)
            if worst and not (heavy and what != "exact"):
                found.append(Bar(f"carried UVs: {what}, {edits}, the worst ({worst['mesh']}, {worst['edit']})", share(worst), least))
    worst = max(measured(figures), key=lambda row: row["wrong"])
    found.append(Bar(f"carried UVs: wrong, the worst ({worst['mesh']}, {worst['edit']})", worst["wrong"], MOST_WRONG, at_most=True))
    same = [row["same order"] for row in figures["order"]]
    found.append(Bar("renumbered copies with the source's order again, share", sum(same) / len(same), 1))
    return found


def page(options):
    figures = kept(options, "transfer.json")
    if not figures:
        return []
    lines = []
    for edit in dict.fromkeys(row["edit"] for row in measured(figures)):
        rows = [row for row in measured(figures) if row["edit"] == edit]
        worst = min(rows, key=lambda row: row["exact"])
        lines.append([edit, len(rows), f"{statistics.mean(row['exact'] for row in rows):.4f}",
                      f"{worst['exact']:.4f} ({worst['mesh']})", f"{min(map(exact_of_known, rows)):.4f}",
                      f"{max(row['wrong'] for row in rows):.4f}",
                      f"{sum(row['left out'] for row in rows):,}",
                      f"{min(row['exact, allowed'] for row in rows):.4f}", f"{max(row['wrong, allowed'] for row in rows):.4f}"])
    failed = [row["mesh"] for row in figures["order"] if not row["same order"]]
    order = f"not on {', '.join(failed)}" if failed else f"on all {len(figures['order'])} meshes"
    return ["\n## Carry-over\n",
            f"{command_line('transfer')}. An edited copy without texture coordinates takes those of the mesh as it was "
            "delivered, by `quadmatch transfer --only uv`. *exact* is the share of the corners of surviving faces that have "
            "theirs again, *wrong* the share that has another one; the rest has none. What is ambiguous is *left out*, unless it is *allowed* by "
            "`--allow-ambiguous`. *Where told*: of rows that were removed, often any of two or more could have been, and leaves the "
            "very same mesh; what texture coordinates its neighbours then have is a toss of a coin. All such removals are tried, and "
            f"counted are the corners on which they agree, in the worst case {min(row.get('known', 1) for row in measured(figures)):.4f} "
            "of all. A mirror image is said "
            "to be one by `--orientation reversing`.\n",
            table(["edit", "meshes", "exact, mean", "worst", "where told, worst", "wrong, worst", "faces left out", "allowed: exact, worst",
                   "wrong, worst"], lines),
            f"\n`--order` gives a renumbered copy the order of the source's file, vertex by vertex and corner by corner, {order}.\n",
            "\n" + bar_table(bars(options))]
