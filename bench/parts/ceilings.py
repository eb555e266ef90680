"""What no method can know of rows that were removed or inserted: the other edits that leave the very same mesh, and how
often anybody can be right who sees nothing else.

Our matcher plays no part here. Wherever an edit removes a row of quads, or cuts one in two, the same is done to every
other row in the same run of parallel rows. Where that leaves the same mesh (the same faces at the same vertices, and with
positions these at the same places) the truth could as well be the other one: the edit draws both alike often, since
parallel rows have equally many faces. So a pair of faces is true with the share of those truths in which it is, whatever
the method.
"""
import collections
import dataclasses
import random
import statistics

from parts import regions
from parts.common import command_line, keep, kept, table
from parts.subjects import edits_named, in_parallel, name_of, quality_meshes, tool

PLACED, UNPLACED = "plain", "connectivity"  # the runs of the part `regions` that these are ceilings for
SURE = 1 - 1e-9  # shares are summed
EDITS = {PLACED: ["unloop"], UNPLACED: ["loop", "loops", "unloop", "heavy"]}


def beyond(mesh, row, side):
    """The row of quads beside a row, face by face and entered from the same end; None where there is no whole one.
    Rows are lists of (face, corner at which it is entered); `side` is 1 (towards their second corner) or 3."""
    beside = []
    for index, entry in row:
        other = mesh.across.get((index, (entry + side) % 4))
        if other is None or len(mesh.faces[other[0]]) != 4:
            return None
        beside.append((other[0], (other[1] + side) % 4))
    found = mesh.chord(*beside[0])
    return beside if found and len(found[0]) == len(beside) and set(found[0]) == set(beside) else None


def parallel_rows(mesh, row):
    """All rows beside each other about this one, and its number among them."""
    rows, seen = [row], {index for index, _ in row}
    for side in (1, 3):
        while following := beyond(mesh, rows[0] if side == 3 else rows[-1], side):
            if not seen.isdisjoint(index for index, _ in following):
                break
            seen.update(index for index, _ in following)
            rows.insert(0 if side == 3 else len(rows), following)
    return rows, rows.index(row)


@dataclasses.dataclass
class Result:
    """What an edit leaves of some faces, in an order in which those of two edits correspond, corner by corner."""
    faces: list    # vertices of each
    origins: list  # (face of the mesh before, the corner that was its first vertex), or None: a part of one
    gone: set      # faces of the mesh before that do not survive


def corners(mesh, place):
    index, entry = place
    face = mesh.faces[index]
    return tuple(face[(entry + step) % len(face)] for step in range(len(face)))


def removal(mesh, rows, number, side, around):
    """Remove a row; its vertices on one side go to those opposite. None where these are the same."""
    images = {}
    for a, b, c, d in (corners(mesh, place) for place in rows[number]):
        images.update({b: a, c: d} if side == 1 else {a: b, d: c})
    if set(images) & set(images.values()):
        return None
    left = [place for row in rows[:number] + rows[number + 1:] for place in row] + around
    return Result([tuple(images.get(vertex, vertex) for vertex in corners(mesh, place)) for place in left], left,
                  {index for index, _ in rows[number]})


def insertion(mesh, rows, number, around):
    """Cut a row in two. A new vertex is named by the edge in whose middle it is."""
    near, far = [], []
    for a, b, c, d in (corners(mesh, place) for place in rows[number]):
        first, second = frozenset((a, b)), frozenset((c, d))
        near.append((a, first, second, d))
        far.append((first, b, c, second))
    before = [place for row in rows[:number] for place in row]
    after = [place for row in rows[number + 1:] for place in row] + around
    return Result([corners(mesh, place) for place in before] + near + far + [corners(mesh, place) for place in after],
                  before + 2 * len(near) * [None] + after, {index for index, _ in rows[number]})


def same_mesh(one, other, positions):
    """Are these the same faces at the same vertices, for some one-to-one map of the vertices? `positions`: that map must
    leave every vertex where it is; None: they do not matter."""
    partner, back = {}, {}
    for face, image in zip(one.faces, other.faces):
        for v, w in zip(face, image):
            if partner.setdefault(v, w) != w or back.setdefault(w, v) != v:
                return False
            if positions and v != w and positions[v] != positions[w]:
                return False
    return True


def other_truths(mesh, row, edit, with_positions):
    """All edits that leave the same mesh as that which was made, which is among them: what was made, and all."""
    rows, made = parallel_rows(mesh, row)
    members = {index for one in rows for index, _ in one}
    touched = {face for index in members for vertex in mesh.faces[index] for face in mesh.faces_at[vertex]}
    around = [(index, 0) for index in sorted(touched - members)]
    if edit == "loop":
        given = insertion(mesh, rows, made, around)
        results = [insertion(mesh, rows, number, around) for number in range(len(rows))]
    else:
        given = removal(mesh, rows, made, 1, around)
        results = [removal(mesh, rows, number, side, around) for number in range(len(rows))
                   for side in ((1, 3) if with_positions else (1,))]
    return given, [result for result in results
                   if result and same_mesh(given, result, mesh.positions if with_positions else None)]


def edit_once(mesh, name, size, with_positions):
    """Edit the mesh. @return for each truth that it may have, the faces of the mesh before on which those of the mesh
    after lie, with the turn of their corners, or None; and the faces that do not survive."""
    editor, drawn = tool("edit_mesh"), []
    before = editor.EditableMesh(mesh.positions, mesh.faces, None)
    draw, mesh.origins = mesh.random_chord, [(index, 0) for index in range(len(mesh.faces))]
    mesh.random_chord = lambda: drawn.append(draw()) or drawn[-1]
    editor.EDITS[name](mesh, size)
    del mesh.random_chord
    names = [origin if isinstance(origin, tuple) else None for origin in mesh.origins]
    gone = set(range(len(before.faces))) - {origin[0] for origin in names if origin}
    if name not in ("loop", "unloop"):
        return [(names, gone)]
    row = drawn[-1][0]
    given, results = other_truths(before, row, name, with_positions)
    number_of = {origin[0]: number for number, origin in enumerate(names) if origin}
    halves = [number for number, origin in enumerate(names) if origin is None and isinstance(mesh.origins[number], list)
              and mesh.origins[number][0] in given.gone]
    # The edit adds the halves row face by row face; a result has all that are near and then all that are far.
    ordered = iter(halves[0::2] + halves[1::2])
    after = [number_of[origin[0]] if origin else next(ordered) for origin in given.origins]
    truths = []
    for result in results:
        truth = list(names)
        for number, ours, theirs in zip(after, given.origins, result.origins):
            turn = (theirs[1] - ours[1]) % 4 if ours and theirs else 0
            if ours is None and theirs:  # half of a cut face starts with the corner at which the row is entered
                turn = theirs[1]
            truth[number] = theirs and (theirs[0], turn)
        truths.append((truth, (gone - given.gone) | result.gone))
    return truths


def chances_of_pairs(steps):
    """For each face of the edited mesh the share of all truths in which its most frequent partner is its partner."""
    chances = []
    for face in range(len(steps[-1][0][0])):
        votes = {(face, 0): 1.0}
        for truths in reversed(steps):
            before = collections.Counter()
            for (name, turn), share in votes.items():
                for names, _ in truths:
                    if names[name]:
                        before[names[name][0], turn + names[name][1]] += share / len(truths)
            votes = before
        whole = collections.Counter()
        for (name, turn), share in votes.items():
            whole[name, turn % 4] += share
        chances.append(max(whole.values(), default=0.0))
    return chances


def chances_to_survive(steps, faces):
    """For each face of the mesh itself the share of all truths in which it survives."""
    left = None
    for truths in reversed(steps):
        chances = collections.Counter()
        for names, _ in truths:
            for number, name in enumerate(names):
                if name:
                    chances[name[0]] += (1.0 if left is None else left[number]) / len(truths)
        left = chances
    return [left[face] for face in range(faces)]


def best_sum(chances):
    """The most that recall and precision can be together on the average, whatever is left out: the surest pairs are
    matched first."""
    right, best = 0.0, 0.0
    for matched, chance in enumerate(sorted(chances, reverse=True), 1):
        right += chance
        best = max(best, right / len(chances) + right / matched)
    return best


def measure_copy(job):
    path, edit, seed, run = job
    editor, quality = tool("edit_mesh"), tool("quality")
    mesh = editor.EditableMesh(*tool("objmesh").read_obj(path), random.Random(seed))
    row = {"mesh": name_of(path), "edit": edit, "seed": seed, "run": run}
    faces, steps = len(mesh.faces), []
    try:
        for word in quality.sized(edits_named(edit), faces):
            name, _, size = word.partition(":")
            rows = int(size) if name in ("loop", "unloop") else 1
            for _ in range(rows):
                steps.append(edit_once(mesh, name, 1 if name in ("loop", "unloop") else int(size), run == PLACED))
    except editor.CannotEdit as error:
        return row | {"skipped": str(error)}
    survive = chances_to_survive(steps, faces)
    surviving = round(sum(survive))
    chances = sorted(chances_of_pairs(steps), reverse=True)[:surviving]
    return row | {"surviving": surviving, "undecided": sum(chance < SURE for chance in chances) / surviving,
                  "recall": sum(chances) / surviving, "recall and precision": best_sum(chances),
                  "near": sum(sorted(survive, reverse=True)[:len(steps[-1][0][0])]) / surviving}


def measure(options):
    jobs = []
    for run, edits in EDITS.items():
        seeds = [int(seed) for seed in regions.RUNS[run][0].split(",")]
        jobs += [(mesh, edit, seed, run) for edit in edits for mesh in quality_meshes(options)
                 for seed in (seeds[:1] if options.quick else seeds)]
    keep(options, "ceilings.json", in_parallel(options, measure_copy, jobs))


def bars(_):
    return []


def line(options, rows, run, edit, *keys):
    """The most that can be expected of a sum of figures, what is asked, and what our matcher has; None if not measured."""
    group = [row for row in rows if row["run"] == run and row["edit"] == edit]
    if not group:
        return None
    ours = [regions.mean(regions.runs_kept(options).get(run, []), edit, key) for key in keys]
    asked = [regions.BARS[run].get(key, {}).get(edit) for key in keys]
    return [f"{run}: {' + '.join(keys)} of {edit}", len(group),
            f"{100 * statistics.mean(row['undecided'] for row in group):.1f} %",
            f"{statistics.mean(row[' and '.join(keys)] for row in group):.4f}",
            f"{sum(asked):g}" if None not in asked else "", f"{sum(ours):.4f}" if None not in ours else ""]


def page(options):
    rows = [row for row in kept(options, "ceilings.json") or [] if "recall" in row]
    lines = [line(options, rows, PLACED, "unloop", "recall", "precision"), line(options, rows, PLACED, "unloop", "recall"),
             *(line(options, rows, UNPLACED, edit, "recall") for edit in EDITS[UNPLACED]),
             line(options, rows, UNPLACED, "unloop", "near")]
    if not rows:
        return []
    return ["\n## What nobody can know\n",
            f"{command_line('ceilings')}. A row of quads is removed by merging its two sides. Where the row beside it is as "
            "regular, removing that one, from the other side, leaves the very same mesh: the same faces at the same vertices "
            "at the same places. Both are drawn alike often, so which one was removed is the toss of a coin for any method. "
            "Without positions every row of a run of parallel rows may have been removed, or cut in two by an inserted loop. "
            "This part does the same to the other rows and compares the meshes it gets, corner by corner; our matcher plays "
            "no part. *Undecided* are faces of the edited mesh whose partner is not the same by all these truths; *at most* is "
            "the mean of the best that can be expected of any method. It can be beaten by luck, not by skill.\n",
            table(["", "pairs", "undecided", "at most", "asked", "measured"], [one for one in lines if one])]
