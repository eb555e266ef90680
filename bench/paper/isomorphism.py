"""Exact isomorphism (§1.1.3): what a map of the whole, the count of symmetries and the hash cost, beside bliss in the same run.

`measure(options)` runs the benchmark program on whole meshes and gives the raw figures; `page(raw)` is the section about them.
bliss is told of vertices and edges, coloured by vertex code: that is less than a mesh, since it does not see which way round
faces run, so it has the lighter question. It compares two meshes by the canonical forms of both.
"""
import json
import statistics
import tempfile

from parts.common import ROOT, Bar, bar_table, conditions, run, table

TITLE = "Exact isomorphism"
INTRODUCTION = ("§1.1.3 has \"a simple O(m²) algorithm for finding an exact topological match\". Near linear in practice, with "
                "the number of symmetries and a hash that is equal exactly for meshes that are the same.")

REPETITIONS = 3
# Our time for the map, at most so many times bliss' for comparing canonical forms.
MOST_OF_BLISS = 1
QUESTIONS = {"isomorphism": "bliss", "automorphisms": "bliss-automorphisms", "hash": "bliss"}
# Without pinched vertices: bliss colours a vertex by one of its fans, which another order may change.
REAL_MESHES = ("pairs/mh_male_generic_muscle/a.obj", "mh_hm08_base.obj", "tbm_skull.obj", "tbm_vintage_rotary_phone.obj",
               "tbm_metal_grating_01.obj", "quadriflow_skull.obj")


def subjects(options):
    found = {"bear": ROOT / "examples" / "bear.obj", "dog toy": ROOT / "examples" / "dog_toy.obj"}
    real = REAL_MESHES[:2] if options.quick else REAL_MESHES
    if options.meshes.is_dir():
        found.update({name.removesuffix(".obj").removesuffix("/a").split("/")[-1]: options.meshes / name for name in real})
    return found


def measure(options):
    figures = {"conditions": conditions(options), "repetitions": REPETITIONS, "subjects": {}}
    wanted = "|".join((*QUESTIONS, *QUESTIONS.values()))
    for name, path in subjects(options).items():
        with tempfile.TemporaryDirectory() as folder:
            output = run([options.build / "bench" / "quadmatch_bench", path, 0, folder, "--benchmark_format=json",
                          f"--benchmark_filter=^({wanted})/", f"--benchmark_repetitions={REPETITIONS}",
                          "--benchmark_enable_random_interleaving=true", "--benchmark_min_time=0.1"])
        times = {}
        for row in json.loads(output)["benchmarks"]:
            if row["run_type"] == "iteration":
                times.setdefault(row["run_name"].split("/")[0], []).append(round(row["cpu_time"], 4))
                quads = int(row["quads"])
        ways = json.loads(run([options.program, "diff", path, path, "--isomorphic", "--orientation", "preserving",
                               "--json"]))["ways"]["product"]
        figures["subjects"][name] = {"faces": quads, "automorphisms": ways, "ms": times}
    return figures


def medians(subject):
    return {what: statistics.median(times) for what, times in subject["ms"].items()}


def bars(raw):
    return [Bar(f"{name}: map of {subject['faces']:,} faces on their renumbered selves / bliss",
                medians(subject)["isomorphism"] / medians(subject)["bliss"], MOST_OF_BLISS, at_most=True)
            for name, subject in raw["subjects"].items()] if raw else []


def short(product):
    """The first factors of a long product."""
    factors = product.split(" * ")
    return product if len(factors) <= 3 else " * ".join(factors[:3]) + " * ..."


def page(raw):
    if not raw:
        return []
    where = raw["conditions"]
    rows = []
    for name, subject in raw["subjects"].items():
        ms = medians(subject)
        rows.append([name, f"{subject['faces']:,}", short(subject["automorphisms"])] +
                    [cell for what, peer in QUESTIONS.items() for cell in (f"{ms[what]:.2f}", f"{ms[what] / ms[peer]:.2f}")] +
                    [f"{ms['bliss']:.1f}", f"{ms['bliss-automorphisms']:.1f}"])
    return ["One thread, processor time in milliseconds, medians of %d runs, interleaved at random; %s, %s, %s at %s.\n" % (
                raw["repetitions"], where["cpu"], where["compiler"], where["version"], where["commit"]),
            "*Map*: the whole mesh on its renumbered self. *Automorphisms* and *hash* look at the mesh and at its mirror "
            "image. *Of bliss*: the ratio to bliss' time in the same run, for comparing the canonical forms of both graphs "
            "(map, hash) or for finding the automorphisms of one. bliss is told of vertices and edges only.\n",
            table(["mesh", "faces", "automorphisms", "map", "of bliss", "automorphisms", "of bliss", "hash", "of bliss",
                   "bliss, forms", "bliss, automorphisms"], rows),
            "\n" + bar_table(bars(raw))]
