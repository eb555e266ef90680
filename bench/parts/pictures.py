"""Pictures and films: processor time beside that of the match alone, memory, and bytes."""
import pathlib
import statistics
import tempfile

from parts.common import Bar, bar_table, command_line, conditions, keep, kept, measured_run, run, table

# Round cubes of so many quads a side, matched with themselves in another order.
SIDES = {"20 k": 58, "200 k": 183, "1 M": 409}
OUTPUTS = {"match": None, "image": "picture.png", "animation": "film.webp"}
REPEATED = 3
# Beside a match, which takes longer the larger the mesh is, a picture costs what its pixels cost.
MOST_IMAGE_SECONDS = 5
MOST_RATIO_AT_1_M = 3
MOST_BYTES = {"image": 1_000_000, "animation": 3_000_000}


def drawn(options, folder, output):
    """What a whole command takes."""
    command = [options.program, "match", "1.obj", "2.obj", "--quiet"]
    command += ["-o", "m.json"] if OUTPUTS[output] is None else [f"--{output}", OUTPUTS[output]]
    print("  $", *command, flush=True)
    return measured_run(command, statuses=(0,), folder=folder)


def row_of(options, folder, name, side):
    run([options.build / "make_shape", f"sphere:{side}", folder / "1.obj"])
    run([options.build / "edit_mesh", folder / "1.obj", folder / "2.obj", "renumber", "--seed", 1])
    row = {"size": name, "faces": 6 * side * side, "seconds": {}, "memory": {}, "bytes": {}}
    for output, file in OUTPUTS.items():
        figures = [drawn(options, folder, output) for _ in range(1 if options.quick else REPEATED)]
        row["seconds"][output] = statistics.median(figure.processor_seconds for figure in figures)
        row["memory"][output] = max(figure.peak for figure in figures)
        if file:
            row["bytes"][output] = (folder / file).stat().st_size
    return row


def measure(options):
    rows = []
    for name, side in SIDES.items():
        if options.quick and name != "20 k":
            continue
        with tempfile.TemporaryDirectory() as folder:
            rows.append(row_of(options, pathlib.Path(folder), name, side))
    keep(options, "pictures.json", {"conditions": conditions(options), "rows": rows})


def bars(options):
    found = []
    for row in (kept(options, "pictures.json") or {"rows": []})["rows"]:
        size, seconds = row["size"], row["seconds"]
        if size == "20 k":
            found.append(Bar("picture of 20 k quads a side, s beside the match", seconds["image"] - seconds["match"],
                             MOST_IMAGE_SECONDS, at_most=True))
        if size == "1 M":
            found.append(Bar("picture of 1 M quads a side, times the match", seconds["image"] / seconds["match"],
                             MOST_RATIO_AT_1_M, at_most=True))
        for output, most in MOST_BYTES.items():
            found.append(Bar(f"{output} of {size} quads a side, bytes", row["bytes"][output], most, at_most=True))
    return found


def page(options):
    raw = kept(options, "pictures.json")
    if not raw:
        return []
    lines = []
    for row in raw["rows"]:
        for output in OUTPUTS:
            seconds = row["seconds"][output]
            lines.append([row["size"] if output == "match" else "", output, f"{seconds:.2f}",
                          f"{seconds / row['seconds']['match']:.1f}", f"{row['memory'][output] / 1e6:.0f}",
                          f"{row['bytes'][output] / 1e6:.2f}" if output in row["bytes"] else ""])
    return ["\n## Pictures\n",
            f"{command_line('pictures')}. Round cubes matched with themselves in random order, and the same with `--image` and "
            "with `--animation` (WebP), both of 1280x640 pixels. Processor time of the whole command, one thread drawing, the "
            f"median of {REPEATED}.\n",
            table(["quads a side", "written", "seconds", "times the match", "memory, MB", "MB"], lines),
            "\n" + bar_table(bars(options))]
