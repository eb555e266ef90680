"""What each idea is good for: the same pairs matched with it and without it."""
import statistics

from parts.common import command_line, keep, kept, table
from parts import unrelated
from parts.multi import MESHES as MESHES_OF_PARTS
from parts.subjects import edited_copy, edits_named, in_parallel, match, name_of, quality_meshes, tool

STAGES = ["equal-parts", "seams", "ties", "slides", "turns", "slivers", "islands", "restarts", "rows", "acceptance", "doubts"]
VARIANTS = {"all": [], **{stage: ["--without", stage] for stage in STAGES}, "positions": ["--no-positions"]}
SEEDS = [1, 2]
TOLD = ["loop", "loops", "unloop", "twist", "rip", "collapse", "extrude", "light", "heavy"]
# Told apart from the means: renumbered models with equal parts, and pairs that have nothing in common.
PARTS, UNRELATED = "many parts", "unrelated"


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


def measure_unrelated(job):
    """Faces matched of two meshes that have nothing in common, by each variant, as a share of the smaller one."""
    options, source, target = job
    paths = [options.meshes / f"{name}.obj" for name in (source, target)]
    row = {"mesh": source, "edit": UNRELATED}
    for name, more in VARIANTS.items():
        found = match(options, *paths, *more)
        matched = sum(len(region["faces"]) for region in found["regions"])
        row[name] = {"matched": matched / min(found["source"]["faces"], found["target"]["faces"])}
    return row


def measure(options):
    seeds = SEEDS[:1] if options.quick else SEEDS
    jobs = [(options, mesh, edit, seed) for edit in edits() for mesh in quality_meshes(options) for seed in seeds]
    jobs += [(options, options.meshes / f"{name}.obj", PARTS, seed) for name in MESHES_OF_PARTS[-1 if options.quick else 0:]
             for seed in seeds]
    pairs = [(options, *pair) for pair in unrelated.PAIRS]
    keep(options, "ablation.json", in_parallel(options, measure_copy, jobs) + in_parallel(options, measure_unrelated, pairs))


def bars(_):
    return []


def page(options):
    rows = [row for row in kept(options, "ablation.json") or [] if "all" in row]
    if not rows:
        return []
    def mean(variant, key, edit=None):
        chosen = [row for row in rows if (row["edit"] == edit if edit else row["edit"] not in (PARTS, UNRELATED))]
        return statistics.mean(row[variant][key] for row in chosen)
    lines = []
    for variant in (name for name in VARIANTS if name in rows[0]):  # a stage may be newer than the figures
        name = "everything on" if variant == "all" else f"without {variant}"
        lines.append([name, f"{mean(variant, 'recall'):.4f}", f"{mean(variant, 'precision'):.4f}"] +
                     [f"{mean(variant, 'recall', edit):.3f}" for edit in [*TOLD, PARTS]] +
                     [f"{100 * mean(variant, 'matched', UNRELATED):.1f} %"])
    return ["\n## What each idea is good for\n",
            f"{command_line('ablation')}. Edited copies of the eight meshes, matched with one stage of the engine "
            "left out (`--without`), or without positions: mean recall and precision over all edits, and recall for some; *many "
            "parts* are renumbered models with equal parts, *unrelated* the share of faces matched of pairs that have nothing "
            "in common; both are not in the means. Equal parts are laid first for speed.\n",
            table(["", "recall", "precision", *TOLD, PARTS, UNRELATED], lines)]
