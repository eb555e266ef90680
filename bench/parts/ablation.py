"""What each idea is good for: the same pairs matched with it and without it."""
import statistics

from parts.common import command_line, keep, kept, table
from parts.multi import MESHES as MESHES_OF_PARTS
from parts.subjects import edited_copy, edits_named, in_parallel, match, name_of, quality_meshes, tool

STAGES = ["equal-parts", "seams", "ties", "slides", "slivers", "islands", "restarts", "acceptance"]
VARIANTS = {"all": [], **{stage: ["--without", stage] for stage in STAGES}, "positions": ["--no-positions"]}
SEEDS = [1, 2]
TOLD = ["loop", "loops", "unloop", "twist", "rip", "collapse", "extrude", "light", "heavy"]
PARTS = "many parts"  # renumbered models with equal parts, told apart from the mean


def edits():
    return [name for name in tool("quality").EDITS if name != "mirror"]


def measure_copy(job):
    options, mesh, edit, seed = job
    row = {"mesh": name_of(mesh), "edit": edit, "seed": seed}
    try:
        with edited_copy(mesh, [] if edit == PARTS else edits_named(edit), seed) as (source, target, truth):
            for name, more in VARIANTS.items():
                figures = tool("score_match").score(truth, match(options, source, target, *more))
                row[name] = {"recall": figures["recall"], "precision": figures["precision"]}
    except LookupError as error:
        row["skipped"] = str(error)
    return row


def measure(options):
    seeds = SEEDS[:1] if options.quick else SEEDS
    jobs = [(options, mesh, edit, seed) for edit in edits() for mesh in quality_meshes(options) for seed in seeds]
    jobs += [(options, options.meshes / f"{name}.obj", PARTS, seed) for name in MESHES_OF_PARTS[-1 if options.quick else 0:]
             for seed in seeds]
    keep(options, "ablation.json", in_parallel(options, measure_copy, jobs))


def bars(_):
    return []


def page(options):
    rows = [row for row in kept(options, "ablation.json") or [] if "all" in row]
    if not rows:
        return []
    def mean(variant, key, edit=None):
        return statistics.mean(row[variant][key] for row in rows if (row["edit"] == edit if edit else row["edit"] != PARTS))
    lines = []
    for variant in VARIANTS:
        name = "everything on" if variant == "all" else f"without {variant}"
        lines.append([name, f"{mean(variant, 'recall'):.4f}", f"{mean(variant, 'precision'):.4f}"] +
                     [f"{mean(variant, 'recall', edit):.3f}" for edit in [*TOLD, PARTS]])
    return ["\n## What each idea is good for\n",
            f"{command_line('ablation')}. Edited copies of the eight meshes, matched with one stage of the engine "
            "left out (`--without`), or without positions: mean recall and precision over all edits, and recall for some; *many "
            "parts* are renumbered models with equal parts, and not in the means.\n",
            table(["", "recall", "precision", *TOLD, PARTS], lines)]
