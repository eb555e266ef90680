"""Libraries: is the mesh that a query was edited from among the first three, how fast, and how large is the index?"""
import json
import math
import pathlib
import random
import statistics
import subprocess
import tempfile

from parts.common import ROOT, Bar, bar_table, command_line, conditions, keep, kept, run, table

MESHES = 1000
LEAST_FOUND = 0.98
MOST_MILLISECONDS = 50
MOST_BYTES = 5000
FIRST = 3
# Matching takes longer than ranking, so only some queries are asked with it.
MATCHED_EVERY = 10
# Light edits, each with the size it has unless told otherwise; every query is one of them, renumbered and posed.
KINDS = ["delete", "extrude", "collapse", "rip", "refine", "loop", "unloop", "twist", "handle"]
# What a made mesh differs by from others of its shape: several of these, at random places.
CHANGES = ["loop:{}", "unloop:{}", "refine:{}", "extrude:{}", "delete:{}", "handle:{}", "collapse:{}", "rip:{}"]
LARGEST = {"loop": 3, "unloop": 2, "refine": 40, "extrude": 60, "delete": 60, "handle": 3, "collapse": 6, "rip": 12}
EXAMPLES = ["bear", "shirt_short", "shirt_long", "dog_toy"]


def base_shape(chance):
    """A shape that make_shape makes, of random sizes, or one of the examples; and how often it is subdivided first."""
    pick = chance.randrange(10)
    if pick < 4:
        return f"example:{EXAMPLES[pick]}", 0
    low = chance.randrange
    return [(f"grid:{low(15, 40)},{low(15, 40)}", 0), (f"cylinder:{low(12, 40)},{low(15, 50)}", 0),
            (f"star:{low(3, 12)},{low(8, 14)}", 0), (f"sphere:{low(9, 22)}", 0),
            (f"grating:{low(2, 7)},{low(2, 7)}", 1), (f"dog_toy:{low(2, 9)},{low(12, 40)}", 0)][pick - 4]


def edit(options, source, target, edits, seed):
    """Make a copy with these edits; those that fit nowhere are left out. @return those made."""
    made = list(edits)
    while made:
        command = [options.build / "edit_mesh", source, target, *made, "--seed", seed]
        ended = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
        if ended.returncode == 0:
            return made
        made = [one for one in made if f"{one} does not fit" not in ended.stderr] if "does not fit" in ended.stderr else made[:-1]
    return made


def make_mesh(options, folder, number):
    """One of the library: a shape, and four to eight edits of random sizes."""
    chance = random.Random(number)
    shape, steps = base_shape(chance)
    plain = folder / "plain.obj"
    if shape.startswith("example:"):
        plain = ROOT / "examples" / f"{shape[8:]}.obj"
    else:
        subprocess.run([options.build / "make_shape", shape, plain], check=True, capture_output=True)
    changes = []
    for template in chance.choices(CHANGES, k=chance.randrange(4, 9)):
        name = template.split(":", 1)[0]
        changes.append(template.format(chance.randrange(1, LARGEST[name] + 1) + int(name == "rip")))
    path = folder / "meshes" / f"{number % 10}" / f"{number:04}_{shape.split(':')[-1 if steps else 0].replace(',', 'x')}.obj"
    path.parent.mkdir(parents=True, exist_ok=True)
    if not edit(options, plain, path, [f"subdivide:{steps}"] * bool(steps) + changes + ["renumber"], number):
        raise RuntimeError(f"{path}: no edit fits {shape}")
    return path


def pose(path):
    """Bend and turn a mesh: every vertex moves."""
    lines = []
    for line in path.read_text(encoding="utf-8").splitlines():
        if line.startswith("v "):
            x, y, z = (float(word) for word in line.split()[1:4])
            turn = 0.3 * y + 1
            x, z = x * math.cos(turn) - z * math.sin(turn), x * math.sin(turn) + z * math.cos(turn) + 0.1 * x * x
            line = f"v {y:.6g} {x:.6g} {z:.6g}"
        lines.append(line)
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def ask(options, query, library, *more):
    command = [options.program, "find", query, library, "--json", "--quiet", *more]
    ended = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    if ended.returncode not in (0, 1):
        raise RuntimeError(ended.stderr.strip()[-300:])
    return json.loads(ended.stdout)


def rank_of(answer, path):
    return next((found["rank"] for found in answer["found"] if found["path"] == str(path.resolve())), None)


def query(options, folder, library, mesh, number):
    """An edited, renumbered and posed copy of a mesh of the library, and where that mesh stands in the answer."""
    copy, kind = folder / "query.obj", KINDS[number % len(KINDS)]
    made = edit(options, mesh, copy, [kind, "renumber"], 10_000 + number)
    if kind not in made:
        return {"mesh": mesh.stem, "edit": kind, "skipped": True}
    pose(copy)
    signed = ask(options, copy, library, "--no-match", "--top", "10")
    times = signed["milliseconds"]
    row = {"mesh": mesh.stem, "edit": kind, "faces": signed["faces"], "by signature": rank_of(signed, mesh),
           "milliseconds": times["reading"] + times["ranking"], "reading": times["reading"]}
    if number % MATCHED_EVERY:
        return row
    matched = ask(options, copy, library)
    return row | {"rank": rank_of(matched, mesh), "matching": matched["milliseconds"]["matching"]}


def measure(options):
    count = 60 if options.quick else MESHES
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        meshes = [make_mesh(options, folder, number) for number in range(count)]
        library = folder / "library.sqlite"
        filled = json.loads(run([options.program, "index", folder / "meshes", "-o", library, "--json", "--quiet"]))
        again = json.loads(run([options.program, "index", folder / "meshes", "-o", library, "--json", "--quiet"]))
        rows = [query(options, folder, library, mesh, number) for number, mesh in enumerate(meshes)]
    keep(options, "find.json", {"conditions": conditions(options), "meshes": count, "index": filled, "again": again, "rows": rows})


def asked(figures):
    return [row for row in figures["rows"] if "skipped" not in row]


def found_share(rows, ranking="by signature"):
    rows = [row for row in rows if ranking in row]
    return sum(row[ranking] is not None and row[ranking] <= FIRST for row in rows) / len(rows)


def bars(options):
    figures = kept(options, "find.json")
    if not figures:
        return []
    rows = asked(figures)
    slow = statistics.quantiles([row["milliseconds"] for row in rows], n=100)[98]
    return [Bar(f"find: the relative is among the first {FIRST}, share of {len(rows)} queries", found_share(rows), LEAST_FOUND),
            Bar("find: likewise after matching, of every tenth query", found_share(rows, "rank"), LEAST_FOUND),
            Bar("find: milliseconds a query by signatures, reading included, 99 of 100", slow, MOST_MILLISECONDS, at_most=True),
            Bar("find: bytes of the library a mesh", figures["index"]["bytes"] / figures["index"]["meshes"], MOST_BYTES,
                at_most=True)]


def page(options):
    figures = kept(options, "find.json")
    if not figures:
        return []
    lines = []
    for kind in KINDS:
        rows = [row for row in asked(figures) if row["edit"] == kind]
        if rows:
            matched = [row["matching"] for row in rows if "matching" in row]
            lines.append([kind, len(rows), f"{found_share(rows):.3f}", f"{found_share(rows, 'rank'):.3f}" if matched else "-",
                          f"{statistics.median(row['milliseconds'] for row in rows):.1f}",
                          f"{max(row['milliseconds'] for row in rows):.1f}",
                          f"{statistics.median(matched):.0f}" if matched else "-"])
    left_out = len(figures["rows"]) - len(asked(figures))
    index = figures["index"]
    return ["\n## A library of meshes\n",
            f"{command_line('find')}. {figures['meshes']:,} meshes are made of ten shapes of random sizes by four to eight random "
            "edits each. Every one of them is asked for once, by a copy with one light edit more, renumbered and posed "
            f"({left_out} are left out, where the edit fits nowhere). *found*: it is among the first {FIRST} that `quadmatch find` "
            "names by signatures alone (`--no-match`); milliseconds are those of reading the query and ranking. Every tenth query "
            "is asked for with matching too; *matching* is what the first five take on top.\n",
            table(["edit", "queries", "found", "after matching", "ms, median", "worst", "matching, ms"], lines),
            f"\nThe index: {index['bytes'] / index['meshes']:,.0f} bytes a mesh, made in {index['milliseconds'] / 1000:.1f} s; brought "
            f"up to date, with nothing changed, in {figures['again']['milliseconds']:.0f} ms.\n",
            "\n" + bar_table(bars(options))]
