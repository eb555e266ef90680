"""Numbering and direction must not matter: a renumbered target, swapped meshes, moved positions that nobody looks at."""
import collections
import pathlib
import tempfile

from parts.common import Bar, bar_table, command_line, keep, kept, table
from parts.subjects import edited_copy, edits_named, in_parallel, match, name_of, pair_folders, posed, quality_meshes, renumbered, tool

EDITS = ["renumber", "delete", "light", "loops", "heavy"]
SEEDS = [1, 2, 3]
POSES = ["bend:60", "turn", "scramble"]
WAYS = [(), ("--no-positions",)]
LEAST_SAME = 0.999


def pairs_by_source(found):
    """Source face: (target face, rotation, orientation), and the source faces in regions that are ambiguous."""
    pairs = {f: (g, r, region["orientation"]) for region in found["regions"] for f, g, r in region["faces"]}
    return pairs, {f for region in found["regions"] if region.get("ambiguous") for f, _, _ in region["faces"]}


def swapped_back(found, sizes):
    """A match of B with A as one of A with B. `sizes`: corners of the faces of A."""
    regions = []
    for region in found["regions"]:
        turned = region["orientation"] == "reversing"
        faces = [[f, g, r if turned else -r % sizes[f]] for g, f, r in region["faces"]]
        regions.append({**region, "faces": faces})
    return {"regions": regions}


def numbered_back(found, places, sizes):
    """A match with a renumbered B as one with B itself. `sizes`: corners of the faces of A."""
    regions = []
    for region in found["regions"]:
        faces = [[f, places[g][0], (r + places[g][1]) % sizes[f]] for f, g, r in region["faces"]]
        regions.append({**region, "faces": faces})
    return {"regions": regions}


def compared(found, other):
    """Of the faces matched in either and ambiguous in neither: how many are there, how many have the same partner, how
    many have one in both and not the same?"""
    (pairs, vague), (others, as_vague) = pairs_by_source(found), pairs_by_source(other)
    asked = (pairs.keys() | others.keys()) - vague - as_vague
    return {"asked": len(asked), "same": sum(pairs.get(f) == others.get(f) for f in asked),
            "elsewhere": sum(f in pairs and f in others and pairs[f] != others[f] for f in asked),
            "ambiguous": len(vague | as_vague)}


def measure_pair(options, source, target, more):
    obj = tool("objmesh")
    sizes = [len(face) for face in obj.read_obj(source)[1]]
    positions, faces, places = renumbered(*obj.read_obj(target), seed=2026)
    found = match(options, source, target, *more)
    with tempfile.TemporaryDirectory() as folder:
        shuffled = pathlib.Path(folder, "b.obj")
        obj.write_obj(shuffled, positions, faces)
        again = match(options, source, shuffled, *more)
    back = match(options, target, source, *more)
    return {"faces": len(sizes), "renumbered": compared(found, numbered_back(again, places, sizes)),
            "swapped": compared(found, swapped_back(back, sizes))}


def same_when_posed(options, source, target):
    """With --no-positions: are the regions the same, to the last pair, wherever the vertices of the target went?"""
    obj = tool("objmesh")
    positions, faces = obj.read_obj(target)
    plain = match(options, source, target, "--no-positions")["regions"]
    same = {}
    with tempfile.TemporaryDirectory() as folder:
        moved = pathlib.Path(folder, "b.obj")
        for pose in POSES:
            obj.write_obj(moved, posed(positions, faces, pose), faces)
            same[pose] = match(options, source, moved, "--no-positions")["regions"] == plain
    return same


def measure_copy(job):
    options, mesh, edit, seed = job
    row = {"mesh": name_of(mesh), "edit": edit, "seed": seed}
    try:
        with edited_copy(mesh, edits_named(edit), seed) as (source, target, _):
            rows = [row | {"options": " ".join(more)} | measure_pair(options, source, target, more) for more in WAYS]
            return {"rows": rows, "posed": [row | same_when_posed(options, source, target)]}
    except LookupError as error:
        return {"rows": [], "posed": [row | {"skipped": str(error)}]}


def measure_real(job):
    options, folder = job
    row = {"mesh": folder.name, "edit": "real pair"}
    return {"rows": [row | {"options": " ".join(more)} | measure_pair(options, folder / "a.obj", folder / "b.obj", more)
                     for more in WAYS], "posed": []}


def measure(options):
    seeds = SEEDS[:1] if options.quick else SEEDS
    found = in_parallel(options, measure_copy, [(options, mesh, edit, seed) for edit in EDITS
                                                for mesh in quality_meshes(options) for seed in seeds])
    found += in_parallel(options, measure_real, [(options, folder) for folder in pair_folders(options)])
    keep(options, "invariance.json", {key: sum((one[key] for one in found), []) for key in ("rows", "posed")})


def share(rows, key):
    return sum(row[key]["same"] for row in rows) / max(1, sum(row[key]["asked"] for row in rows))


def groups(rows):
    found = collections.OrderedDict()
    for row in rows:
        found.setdefault((row["options"], row["edit"]), []).append(row)
    return found


def bars(options):
    figures = kept(options, "invariance.json")
    if not figures:
        return []
    rows = figures["rows"]
    same = [row[pose] for row in figures["posed"] for pose in POSES if pose in row]
    return [Bar("invariance: same pairs, B renumbered", share(rows, "renumbered"), LEAST_SAME),
            Bar("invariance: same pairs, A and B swapped", share(rows, "swapped"), LEAST_SAME),
            Bar("invariance: same regions without positions, B posed", sum(same) / max(1, len(same)), 1)]


def page(options):
    figures = kept(options, "invariance.json")
    if not figures:
        return []
    lines = []
    for (more, edit), rows in sorted(groups(figures["rows"]).items(), key=lambda group: group[0][0]):
        worst = min(rows, key=lambda row: min(share([row], "renumbered"), share([row], "swapped")))
        lowest = min(share([worst], "renumbered"), share([worst], "swapped"))
        elsewhere = sum(row[key]["elsewhere"] for row in rows for key in ("renumbered", "swapped"))
        vague = sum(row["renumbered"]["ambiguous"] for row in rows) / sum(row["faces"] for row in rows)
        lines.append([f"{edit} `{more}`" if more else edit, len(rows), f"{share(rows, 'renumbered'):.5f}",
                      f"{share(rows, 'swapped'):.5f}", f"{lowest:.4f}" + (f" {worst['mesh']}" if lowest < 1 else ""),
                      elsewhere, f"{vague:.3f}"])
    copies = [row for row in figures["posed"] if POSES[0] in row]
    same = [[pose, len(copies), sum(row[pose] for row in copies)] for pose in POSES]
    return ["\n## Invariance\n",
            f"{command_line('invariance')}. A matched with B, with B in another order, and B with A: the share of faces "
            "with the same partner by the same rotation, of those matched by either and reported ambiguous by neither. "
            "*Worst* is the lowest of a pair; *elsewhere* are faces with another partner, the others that differ are matched "
            "once and left free once; *ambiguous* is the share of faces left out.\n",
            table(["edit", "pairs", "renumbered", "swapped", "worst", "elsewhere", "ambiguous"], lines),
            "\nWith `--no-positions` the copy may be bent, turned, or have its positions shuffled; the regions must be the "
            "same to the last pair.\n",
            table(["pose", "pairs", "same regions"], same), "\n" + bar_table(bars(options))]
