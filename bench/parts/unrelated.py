"""Meshes that have nothing in common: what is matched is a mistake."""
import json

from parts.common import Bar, bar_table, command_line, keep, kept, run, table

PAIRS = [("tbm_duck_sculpture", "pmp_suzanne"), ("osd_rook", "mh_proxy741"), ("tbm_skull", "tbm_car_tire_01"),
         ("mh_male_casualsuit01", "tbm_gasket_04")]
MOST_MATCHED = 0.005


def measure(options):
    rows = []
    for source, target in PAIRS:
        for more in ([], ["--no-positions"]):
            told = json.loads(run([options.program, "match", options.meshes / f"{source}.obj",
                                   options.meshes / f"{target}.obj", "--json", "--quiet", *more], statuses=(0, 1)))
            rows.append({"source": source, "target": target, "options": " ".join(more), "matched": told["matched_faces"],
                         "source_faces": told["source"]["faces"], "target_faces": told["target"]["faces"]})
    keep(options, "unrelated.json", rows)


def share(row):
    return row["matched"] / min(row["source_faces"], row["target_faces"])


def bars(options):
    rows = kept(options, "unrelated.json")
    return [Bar("unrelated meshes: faces matched, the worst pair", max(map(share, rows)), MOST_MATCHED, at_most=True)] \
        if rows else []


def page(options):
    rows = kept(options, "unrelated.json")
    if not rows:
        return []
    lines = [[f"{row['source']}, {row['target']}" + (f" `{row['options']}`" if row["options"] else ""),
              f"{row['source_faces']:,}", f"{row['target_faces']:,}", row["matched"], f"{100 * share(row):.2f} %"] for row in rows]
    return ["\n## Unrelated meshes\n",
            f"{command_line('unrelated')}. Models that have nothing in common; the share is of the smaller mesh.\n",
            table(["pair", "faces", "faces", "matched", "share"], lines), "\n" + bar_table(bars(options))]
