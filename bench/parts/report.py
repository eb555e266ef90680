"""Reports: how large they are, and when the first picture of one stands in a browser."""
import json
import pathlib
import statistics
import subprocess
import tempfile

from parts.common import ROOT, Bar, bar_table, command_line, keep, kept, run, table

# Round cubes of so many quads a side, both in random order: the largest a report of them can be.
SIDES = {"20 k": 58, "200 k": 183}
MOST_BYTES = {"20 k": 2_000_000, "200 k": 12_000_000}
MOST_MILLISECONDS = 2000
REPEATED = 5


def first_frames(page, times):
    """When each of so many browsers has drawn a report, in milliseconds after it began to load; by software."""
    command = ["node", ROOT / "web" / "browser" / "first_frame.mjs", page, times]
    ended = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    if ended.returncode != 0:
        raise SystemExit(f"first_frame.mjs: {ended.stderr.strip()[-400:]}; it needs scripts/install.sh web and npm ci in web/")
    return json.loads(ended.stdout)


def report_of(options, folder, side):
    run([options.build / "make_shape", f"sphere:{side}", folder / "sphere.obj"])
    for seed in (1, 2):
        run([options.build / "edit_mesh", folder / "sphere.obj", folder / f"{seed}.obj", "renumber", "--seed", seed])
    figures = json.loads(run([options.program, "match", folder / "1.obj", folder / "2.obj", "--json", "--report", folder / "page.html"]))
    return figures["source"]["faces"], folder / "page.html"


def measure(options):
    rows = []
    for name, side in SIDES.items():
        if options.quick and name != "20 k":
            continue
        with tempfile.TemporaryDirectory() as folder:
            faces, page = report_of(options, pathlib.Path(folder), side)
            frames = first_frames(page, 1 if options.quick else REPEATED)
            rows.append({"size": name, "faces": faces, "bytes": page.stat().st_size,
                         "first frame": statistics.median(frames), "slowest": max(frames)})
    keep(options, "report.json", rows)


def bars(options):
    found = []
    for row in kept(options, "report.json") or []:
        found.append(Bar(f"report of {row['size']} quads a side, bytes", row["bytes"], MOST_BYTES[row["size"]], at_most=True))
        if row["size"] == "20 k":
            found.append(Bar("report of 20 k quads a side, first frame, ms", row["first frame"], MOST_MILLISECONDS, at_most=True))
    return found


def page(options):
    rows = kept(options, "report.json")
    if not rows:
        return []
    lines = [[row["size"], f"{row['faces']:,}", f"{row['bytes'] / 1e6:.2f}", f"{row['first frame']:.0f}", f"{row['slowest']:.0f}"]
             for row in rows]
    return ["\n## Reports\n",
            f"{command_line('report')}. Reports of round cubes whose faces and vertices stand in random order, opened from disk "
            "in Chromium, which draws without a graphics card. *First frame* is the time from the start of loading until both "
            f"meshes are drawn, the median of {REPEATED}.\n",
            table(["quads a side", "faces", "MB", "first frame, ms", "slowest, ms"], lines),
            "\n" + bar_table(bars(options))]
