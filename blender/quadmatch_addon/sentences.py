"""What is said of a match, one short line each: the sidebar is narrow."""


PLURALS = {"vertex": "vertices"}


def counted(number, noun):
    """"1 vertex", "2,000 vertices"."""
    return f"{number:,} {noun if number == 1 else PLURALS.get(noun, noun + 's')}"


def percent(part, whole):
    """Rounded down: 100 % is all of it."""
    return f"{int(1000 * part / whole) / 10:.1f} %"


def match_lines(found, source, target, arrays):
    """The first line stands for all in the status bar."""
    lines = [f"{found.matched:,} faces are the same"]
    for obj, mesh in zip((source, target), arrays):
        missing = mesh.face_count - found.matched
        lines.append(f"{obj.name}: {percent(found.matched, mesh.face_count)} of {mesh.face_count:,}, {missing:,} unmatched")
    if found.regions:
        largest = found.regions[0]
        lines.append(f"{counted(len(found.regions), 'region')}, the largest {len(largest.faces):,}, "
                     f"confidence {100 * largest.confidence:.0f} %")
    turned = sum(len(region.faces) for region in found.regions if region.reversing)
    if turned:
        lines.append(f"{turned:,} faces lie turned over")
    return lines + doubts(region for region in found.regions if region.ambiguous)


def doubts(regions, shown=3):
    regions = list(regions)
    lines = [f"Ambiguous: {region.doubt}" for region in regions[:shown]]
    if len(regions) > shown:
        lines.append("Ambiguous: " + _more(regions[shown:]))
    return lines


def _more(regions):
    return f"{counted(len(regions), 'region')} more, {counted(sum(len(region.faces) for region in regions), 'face')}"


def left_out(regions, shown=3):
    """Of regions that are not written."""
    lines = []
    for region in list(regions)[:shown]:
        why = (f"fit in {region.ways} ways" if region.ambiguous else
               f"have a confidence of {100 * region.confidence:.0f} % only")
        lines.append(f"Left out: {counted(len(region.faces), 'face')} from face {region.faces[0, 1]} on, they {why}")
    if len(regions) > shown:
        lines.append("Left out: " + _more(regions[shown:]))
    return lines
