"""Models of many parts, some of them equal, renumbered: every part must find its own."""
from parts.common import Bar, bar_table, command_line, keep, kept, table
from parts.subjects import edited_copy, in_parallel, match, tool

MESHES = ["mh_hm08_base", "tbm_vintage_rotary_phone", "mh2_bot"]
WAYS = [(), ("--no-positions",)]
LEAST_RECALL = 0.99
LEAST_COVERED = 0.99


def measure_mesh(job):
    options, name = job
    rows = []
    with edited_copy(options.meshes / f"{name}.obj", [], seed=0) as (source, target, truth):
        partner = {face: image for face, image, _ in truth["exact"]}
        for more in WAYS:
            found = match(options, source, target, *more)
            matched = [(f, g, region) for region in found["regions"] for f, g, _ in region["faces"]]
            astray = [region for f, g, region in matched if partner[f] != g]
            rows.append({"mesh": name, "options": " ".join(more), "faces": len(partner), "regions": len(found["regions"]),
                         "recall": tool("score_match").score(truth, found)["recall"],
                         "covered": len(matched) / len(partner),
                         "ambiguous": sum(bool(region.get("ambiguous")) for _, _, region in matched),
                         "on another part": len(astray),
                         "of these not ambiguous": sum(not region.get("ambiguous") for region in astray)})
    return rows


def measure(options):
    names = MESHES[-1:] if options.quick else MESHES
    keep(options, "multi.json", sum(in_parallel(options, measure_mesh, [(options, name) for name in names]), []))


def bars(options):
    rows = kept(options, "multi.json") or []
    placed, bare = ([row for row in rows if bool(row["options"]) == want] for want in (False, True))
    if not rows:
        return []
    return [Bar("many parts: recall, the worst mesh", min(row["recall"] for row in placed), LEAST_RECALL),
            Bar("many parts, without positions: covered", min(row["covered"] for row in bare), LEAST_COVERED),
            Bar("many parts, without positions: on another part and not reported ambiguous, faces",
                sum(row["of these not ambiguous"] for row in bare), 0, at_most=True)]


def page(options):
    rows = kept(options, "multi.json")
    if not rows:
        return []
    lines = [[row["mesh"] + (f" `{row['options']}`" if row["options"] else ""), f"{row['faces']:,}", row["regions"],
              f"{row['recall']:.4f}", f"{row['covered']:.4f}", f"{row['ambiguous']:,}", f"{row['on another part']:,}",
              row["of these not ambiguous"]] for row in rows]
    return ["\n## Many parts\n",
            f"{command_line('multi')}. Models of up to 154 components, renumbered. Without positions, equal parts cannot be "
            "told apart: they must be covered all the same, and be reported ambiguous.\n",
            table(["mesh", "faces", "regions", "recall", "covered", "ambiguous faces", "on another part", "and not ambiguous"],
                  lines), "\n" + bar_table(bars(options))]
