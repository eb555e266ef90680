"""The optimality gap: how much of the proved optimum each algorithm reaches, and how often the optimum is not the truth."""
import itertools
import json
import pathlib
import statistics
import subprocess
import tempfile

from paper.edited_copies import edited_copy, run_tool, true_pairs
from paper.exact import patch
from parts.common import Bar, bar_table, table
from parts.subjects import in_parallel, tool

TITLE = "The optimality gap"
INTRODUCTION = ("Small edited patches in the plane, on spheres and on tori, and patches cut from real meshes: the largest region "
                "there is, proved by exact search, beside what each algorithm finds.")

# Sizes in quads from 20 to what exact proves in seconds.
SURFACES = {
    "plane": ["grid:5,4", "grid:8,5", "grid:10,6", "star:5,4", "grid:12,10", "star:5,6", "grid:16,12"],
    "sphere": ["sphere:2", "sphere:3", "sphere:4", "sphere:5", "sphere:6"],
    "torus": ["torus:6,4", "torus:8,5", "torus:10,6", "torus:12,8", "torus:16,12"],
}
EDITS = {"delete": ["delete:3%"], "extrude": ["extrude:3%"], "collapse": ["collapse:2"], "rip": ["rip:4"],
         "refine": ["refine:2%"], "loop": ["loop:1"], "mix": ["collapse:1", "delete:2%", "extrude:2%"]}
SEEDS = (1, 2, 3)
# Discs of so many faces around a random one of real meshes, where the collection is there.
CUT_FROM = ("mh_male_casualsuit01", "tbm_duck_sculpture", "pairs/mh_male_generic_muscle/a", "fe_plate_holes")
CUT_SIZES, CUT_SEEDS = (40, 80, 120), (1,)
REAL = "cut from real meshes"
SECONDS = 4
ALGORITHMS = ("greedy", "lazy-greedy", "regions")
LEAST_SHARE = 0.99


def sized(edits, faces):
    """Shares of the faces as numbers."""
    words = []
    for edit in edits:
        name, size = edit.split(":")
        words.append(f"{name}:{max(1, round(faces * int(size[:-1]) / 100))}" if size.endswith("%") else edit)
    return words


def faces_of(path):
    return [[int(word.split("/")[0]) - 1 for word in line.split()[1:]]
            for line in path.read_text(encoding="utf-8").splitlines() if line.startswith("f ")]


def sides(faces):
    """Directed edge: face and corner."""
    return {(face[k], face[(k + 1) % len(face)]): (f, k) for f, face in enumerate(faces) for k in range(len(face))}


def largest_true_piece(source, target, truth):
    """True pairs connected by edges that both meshes have: no true region has more faces."""
    ours, theirs = sides(source), sides(target)
    partner = {f: (g, r) for (f, g), r in truth.items()}
    left, most = set(partner), 0
    while left:
        fresh, size = [left.pop()], 0
        while fresh:
            f = fresh.pop()
            size += 1
            for beside in true_neighbours(f, source, target, partner, ours, theirs):
                if beside in left:
                    left.remove(beside)
                    fresh.append(beside)
        most = max(most, size)
    return most


def true_neighbours(f, source, target, partner, ours, theirs):
    g, r = partner[f]
    corners = len(source[f])
    for k in range(corners):
        here = ours.get((source[f][(k + 1) % corners], source[f][k]))
        there = theirs.get((target[g][(r + k + 1) % corners], target[g][(r + k) % corners]))
        if here and there and partner.get(here[0], (None,))[0] == there[0]:
            yield here[0]


def match(options, source, target, folder, algorithm, *more):
    """The match file, and what the program says of it."""
    output = pathlib.Path(folder, "m.json")
    output.unlink(missing_ok=True)
    command = [options.program, "match", source, target, "-o", output, "--json", "--algorithm", algorithm,
               "--orientation", "preserving", *more]
    ended = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    if ended.returncode not in (0, 1):
        raise RuntimeError(f"{' '.join(map(str, command))}: {ended.stderr.strip()[-200:]}")
    return json.loads(output.read_text(encoding="utf-8")), json.loads(ended.stdout)


def cut_patch(options, shape, seed, path):
    """A disc of a real mesh, `name:faces`."""
    name, count = shape.rsplit(":", 1)
    obj = tool("objmesh")
    obj.write_obj(path, *patch(*obj.read_obj(options.meshes / f"{name}.obj"), int(count), seed))


def measure_one(job):
    options, surface, shape, edit, seed = job
    row = {"surface": surface, "shape": shape, "edit": edit, "seed": seed}
    with tempfile.TemporaryDirectory() as folder:
        source = pathlib.Path(folder, "a.obj")
        if surface == REAL:
            cut_patch(options, shape, seed, source)
        else:
            run_tool(options, "make_shape", shape, source)
        faces = faces_of(source)
        try:
            with edited_copy(options, source, sized(EDITS[edit], len(faces)) + ["renumber"], seed) as (target, truth):
                return row | compare(options, source, target, truth, folder)
        except LookupError as reason:
            return row | {"skipped": str(reason)}


def compare(options, source, target, truth, folder):
    """Exact first, then what the others reach."""
    best, told = match(options, source, target, folder, "exact", "--time-limit", SECONDS)
    row = {"faces": len(faces_of(source)), "optimum": best_region(best), **told["optimality"],
           "true in optimum": true_pairs(best, truth),
           "largest true piece": largest_true_piece(faces_of(source), faces_of(target), truth)}
    for algorithm in ALGORITHMS:
        found, _ = match(options, source, target, folder, algorithm)
        row[algorithm] = {"largest": best_region(found), "all": sum(len(region["faces"]) for region in found["regions"]),
                          "true": true_pairs(found, truth)}
    return row


def best_region(match_file):
    return max((len(region["faces"]) for region in match_file["regions"]), default=0)


def measure(options):
    jobs = [(options, surface, shape, edit, seed)
            for surface, shapes in SURFACES.items() for shape, edit, seed in itertools.product(shapes, EDITS, SEEDS)]
    if options.collection:
        jobs += [(options, REAL, f"{name}:{size}", edit, seed)
                 for name, size, edit, seed in itertools.product(CUT_FROM, CUT_SIZES, EDITS, CUT_SEEDS)]
    return in_parallel(options, measure_one, jobs[::20] if options.quick else jobs)


def share(row, algorithm, which):
    return min(1.0, row[algorithm][which] / row["optimum"]) if row["optimum"] else 1.0


def mean_share(rows, algorithm, which):
    return statistics.mean(share(row, algorithm, which) for row in rows) if rows else 1.0


def bars(raw):
    proved = [row for row in raw if row.get("proved")]
    return [Bar("regions: mean share of the proved optimum", mean_share(proved, "regions", "all"), LEAST_SHARE)]


def row_of(name, rows):
    proved = [row for row in rows if row["proved"]]
    larger = sum(row["optimum"] > row["largest true piece"] for row in proved)
    other = sum(row["true in optimum"] < row["optimum"] for row in proved)
    shares = [f"{mean_share(proved, algorithm, which):.3f}" for algorithm, which in
              (("greedy", "largest"), ("lazy-greedy", "largest"), ("regions", "largest"), ("regions", "all"))]
    return [name, len(rows), len(proved)] + shares + [larger, other]


def page(raw):
    done = [row for row in raw if "skipped" not in row]
    header = ["", "patches", "proved", "greedy", "lazy-greedy", "regions, largest", "regions, all", "larger than the truth",
              "other than the truth"]
    groups = [("surface", [*SURFACES, REAL]), ("edit", list(EDITS)), ("faces", sorted({row["faces"] for row in done}))]
    page = [bar_table(bars(raw)),
            "\nMean shares of the proved optimum, each at most 1. *Regions, largest* is its largest region, *all* the faces of all "
            "its regions: it looks for what is true, in several pieces if need be, and not for the largest single piece. *Larger "
            "than the truth*: the optimum has more faces than any connected piece of the true correspondence, so that it cannot "
            "be true. *Other than the truth*: the optimum that was found contains pairs that are not true; on regular patches "
            "many maps are as large.\n"]
    for key, names in groups:
        rows = [row_of(str(name), rows) for name in names if (rows := [row for row in done if row[key] == name])]
        page += [f"\n## By {key}\n", table([key] + header[1:], rows + ([row_of("**all**", done)] if key == "surface" else []))]
    page.append(f"\n{len(raw) - len(done)} more patches were left out: the edit does not fit them.\n")
    return page
