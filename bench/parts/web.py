"""The page: matching in WebAssembly beside the program on the same pairs, and how a browser bears a large pair."""
import json
import pathlib
import statistics
import subprocess
import tempfile

from parts.common import ROOT, Bar, bar_table, command_line, keep, kept, run, table

# Small pairs more often: it takes some runs until the machine code of WebAssembly is as good as it gets.
REPEATED, REPEATED_SMALL = 5, 40
SMALL_BYTES = 1_000_000
MOST_TIMES_NATIVE = 4
# A round cube of so many quads a side of a face, and what is done to the other of the pair.
LARGE = {"200 k": 183, "1 M": 409}
EDITS = ["delete:40", "extrude:40", "loop:1", "renumber", "--seed", "5"]
MOST_MILLISECONDS_DEAF = 1000


def node(script, *words):
    command = ["node", ROOT / "web" / "browser" / script, *words]
    ended = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    if ended.returncode != 0:
        raise SystemExit(f"{script}: {ended.stderr.strip()[-400:]}; it needs scripts/install.sh browser web and scripts/build_page.sh")
    return json.loads(ended.stdout)


def pairs(options, folder):
    """Our own, two of the collection where that is there, and large ones made here."""
    found = {"bears": [ROOT / "examples" / name for name in ("bear.obj", "bear_no_ears_posed.obj")],
             "shirts": [ROOT / "examples" / name for name in ("shirt_long.obj", "shirt_short.obj")]}
    for name in ("mh_male_generic_muscle", "mh_female1605_male1591"):
        if (options.meshes / "pairs" / name).is_dir():
            found[name] = [options.meshes / "pairs" / name / file for file in ("a.obj", "b.obj")]
    for name, side in LARGE.items():
        if options.quick:
            continue
        found[name] = [folder / f"{side}.obj", folder / f"{side}_edited.obj"]
        run([options.build / "make_shape", f"sphere:{side}", found[name][0]])
        run([options.build / "edit_mesh", *found[name], *EDITS])
    return found


def times_of(path):
    return REPEATED_SMALL if path.stat().st_size < SMALL_BYTES else REPEATED


def compared(options, folder, source, target):
    """Both ways on one pair; the match files, which know the files by their names, have to be the same."""
    repeated = 1 if options.quick else times_of(source)
    native, match = {"reading": [], "matching": []}, folder / "match.json"
    for _ in range(repeated):
        figures = json.loads(run([options.program, "match", source, target, "--json", "--threads", "1", "-o", match], (0, 1)))
        for stage, times in native.items():
            times.append(figures["milliseconds"][stage])
    web = node("engine_times.mjs", source, target, repeated)
    if json.loads(web["match"])["regions"] != json.loads(match.read_text(encoding="utf-8"))["regions"]:
        raise SystemExit(f"{source} and {target} are matched in another way by WebAssembly")
    return {"faces": figures["source"]["faces"], "native": native, "web": {stage: web[stage] for stage in native},
            "memory": web["memory"]}


def measure(options):
    rows, deaf = {}, {}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for pair, (source, target) in pairs(options, folder).items():
            rows[pair] = compared(options, folder, source, target)
            if pair in LARGE:
                deaf[pair] = node("page_times.mjs", source, target)
    keep(options, "web.json", {"pairs": rows, "page": deaf})


def ratio(row, stage):
    return statistics.median(row["web"][stage]) / statistics.median(row["native"][stage])


def bars(options):
    figures = kept(options, "web.json")
    if not figures:
        return []
    found = [Bar(f"WebAssembly, matching {pair}, times native", ratio(row, "matching"), MOST_TIMES_NATIVE, at_most=True)
             for pair, row in figures["pairs"].items()]
    found += [Bar(f"the page with {pair} quads a side, longest not listening, ms", row["longest"], MOST_MILLISECONDS_DEAF,
                  at_most=True) for pair, row in figures["page"].items()]
    return found


def page(options):
    figures = kept(options, "web.json")
    if not figures:
        return []
    lines = [[pair, f"{row['faces']:,}", f"{statistics.median(row['native']['matching']):.1f}",
              f"{statistics.median(row['web']['matching']):.1f}", f"{row['web']['matching'][0]:.1f}",
              f"{ratio(row, 'matching'):.2f}", f"{ratio(row, 'reading'):.2f}", f"{row['memory'] / 1e6:,.0f}"]
             for pair, row in figures["pairs"].items()]
    found = ["\n## The page\n",
             f"{command_line('web')}. The engine of the page, WebAssembly in node, beside the program with one thread, both the median "
             f"of {REPEATED} runs, of {REPEATED_SMALL} for small pairs; the match files are the same. *First* is the first run, while the machine code is still being made. "
             "*Memory* is what the engine takes of the 4 GB it can have.\n",
             table(["pair", "faces", "native, ms", "WebAssembly, ms", "first, ms", "matching, times native",
                    "reading, times native", "memory, MB"], lines)]
    if figures["page"]:
        lines = [[pair, f"{row['report'] / 1000:.1f}", row["longest"], f"{row['drawn'][0]:,}", f"{row['drawn'][1]:,}"]
                 for pair, row in figures["page"].items()]
        found += ["\nTwo large files dropped on the page in Chromium, which draws without a graphics card: from the drop to the report, "
                  "the longest the page did not listen to its user, and how many faces of either side are drawn.\n",
                  table(["quads a side", "report, s", "not listening, ms", "drawn, source", "drawn, target"], lines)]
    return [*found, "\n" + bar_table(bars(options))]
