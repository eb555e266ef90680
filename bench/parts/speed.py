"""What a quad costs from thousands of quads to millions, in file order and renumbered, beside peers in the same run."""
import json
import statistics
import tempfile

from parts.common import ROOT, Bar, bar_table, command_line, conditions, keep, kept, run, table

REPETITIONS = 3
COLUMNS = ["build", "anchors", "regions", "regions-in-file-order", "lazy-greedy", "lazy-greedy-in-file-order", "greedy"]
MOST_GROWTH = 2
MOST_OF_TINYOBJ = 0.3
MOST_OF_BLISS = 1 / 8
# Growth is told from the first size of so many quads on, against tinyobjloader at the size nearest to a million.
FIRST_SIZE = 10_000
PEER_SIZE = 1_000_000


def subjects(options):
    """A mesh and how often it is refined."""
    found = {"bear": (ROOT / "examples" / "bear.obj", 5)}
    if options.meshes.is_dir():
        found["male_generic body"] = (options.meshes / "pairs/mh_male_generic_muscle/a.obj", 4)
    return {name: (mesh, 2 if options.quick else steps) for name, (mesh, steps) in found.items()}


def measure(options):
    figures = {"conditions": conditions(options), "repetitions": REPETITIONS, "subjects": {}}
    for name, (path, steps) in subjects(options).items():
        with tempfile.TemporaryDirectory() as folder:
            output = run([options.build / "bench" / "quadmatch_bench", path, steps, folder, "--benchmark_format=json",
                          f"--benchmark_repetitions={REPETITIONS}", "--benchmark_enable_random_interleaving=true",
                          "--benchmark_min_time=0.1"])
        times = {}
        for row in json.loads(output)["benchmarks"]:
            if row["run_type"] == "iteration":
                entry = times.setdefault(row["run_name"], {"ms": [], "matched": row.get("matched", 0)})
                entry["ms"].append(round(row["cpu_time"], 4))
        figures["subjects"][name] = times
    keep(options, "speed.json", figures)


class Subject:
    """The medians of one mesh, refined step by step."""

    def __init__(self, times):
        self.times = times
        self.median = {key: statistics.median(entry["ms"]) for key, entry in times.items()}
        self.sizes = sorted({int(key.split("/")[1]) for key in times})
        self.peer_sizes = [size for size in self.sizes if f"read-tinyobjloader/{size}" in times]
        self.peer_size = min(self.peer_sizes, key=lambda size: abs(size - PEER_SIZE))
        self.base = next((size for size in self.sizes if size >= FIRST_SIZE), self.sizes[0])

    def ms(self, what, size):
        return self.median[f"{what}/{size}"]

    def per_quad(self, what, size):
        """Nanoseconds, or None where it was not measured."""
        return self.median[f"{what}/{size}"] * 1e6 / size if f"{what}/{size}" in self.median else None

    def growth(self, what):
        return self.per_quad(what, self.sizes[-1]) / self.per_quad(what, self.base)

    def measured(self):
        return [what for what in COLUMNS if self.per_quad(what, self.sizes[-1])]


def subjects_kept(options):
    figures = kept(options, "speed.json")
    return {name: Subject(times) for name, times in figures["subjects"].items()} if figures else {}


def bars(options):
    found = []
    for name, subject in subjects_kept(options).items():
        for what in ("regions", "regions-in-file-order"):
            if what in subject.measured():
                found.append(Bar(f"{name}, {what}: growth of the cost of a quad, {subject.base:,} to {subject.sizes[-1]:,}",
                                 subject.growth(what), MOST_GROWTH, at_most=True))
        ratio = subject.ms("regions", subject.peer_size) / subject.ms("read-tinyobjloader", subject.peer_size)
        found.append(Bar(f"{name}: match of {subject.peer_size:,} renumbered quads / tinyobjloader reading one file",
                         ratio, MOST_OF_TINYOBJ, at_most=True))
        first = subject.sizes[0]
        if first >= FIRST_SIZE:
            found.append(Bar(f"{name}: match of {first:,} quads / bliss",
                             subject.ms("regions", first) / subject.ms("bliss", first), MOST_OF_BLISS, at_most=True))
    return found


def sentences(subject):
    size, first = subject.peer_size, subject.sizes[0]
    tiny, ours = subject.ms("read-tinyobjloader", size), subject.ms("read-quadmatch", size)
    parsing = ours - subject.ms("build-in-file-order", size)
    matched = {what: subject.ms(what, size) for what in ("regions", "lazy-greedy")}
    bliss, regions = subject.ms("bliss", first), subject.ms("regions", first)
    return (f"\n{size:,} quads as a file: tinyobjloader reads it in {tiny:,.0f} ms, quadmatch in {parsing:,.0f} ms: "
            f"**{tiny / parsing:.1f} times as fast**; with the connectivity, which tinyobjloader does not make, in "
            f"{ours:,.0f} ms: {tiny / ours:.1f} times as fast. Matching takes regions "
            f"{matched['regions']:,.0f} ms and lazy-greedy {matched['lazy-greedy']:,.0f} ms: "
            f"**{matched['regions'] / tiny:.2f} and {matched['lazy-greedy'] / tiny:.2f} of tinyobjloader's time for "
            f"one of the two files**. From {subject.base:,} to {subject.sizes[-1]:,} quads the cost of a quad grows "
            f"{subject.growth('regions'):.2f} and {subject.growth('lazy-greedy'):.2f} times. At {first:,} quads bliss needs "
            f"{bliss:,.1f} ms to say that the two graphs are the same, and regions "
            f"{regions:,.1f} ms to match them: **1/{bliss / regions:.0f}**.\n")


def page(options):
    figures = kept(options, "speed.json")
    if not figures:
        return []
    where = figures["conditions"]
    page = ["## Speed\n", "%s. One thread, processor time. Medians of %d runs, interleaved at random; %s, %s, %s at %s.\n" % (
        command_line("speed"), figures["repetitions"], where["cpu"], where["compiler"], where["version"], where["commit"]),
        "Every mesh is refined by Catmull-Clark step by step and matched with a copy whose vertices, faces and first "
        "corners are in random order, or with one in the order of the file. *Anchors* are vertex codes, both skeletons and "
        "the colouring; *regions*, *lazy-greedy* and *greedy* are the whole match from two meshes in memory. Nanoseconds per "
        "quad.\n"]
    if (options.docs / "results" / "speed.svg").exists():
        page.append("![What a quad costs, by size of the mesh](results/speed.svg)\n")
    for name, subject in subjects_kept(options).items():
        names = subject.measured()
        rows = [[f"{size:,}", f"{subject.times[f'regions/{size}']['matched']:,.0f}"] +
                [f"{subject.per_quad(what, size):.0f}" if subject.per_quad(what, size) else "" for what in names]
                for size in subject.sizes]
        page += [f"\n### {name}\n", table(["quads", "matched by regions", *(what.replace("-in-file-order", ", file order")
                                                                         for what in names)], rows), sentences(subject)]
    return page + ["\n" + bar_table(bars(options))]
