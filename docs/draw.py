#!/usr/bin/python3
"""Draw the pictures of README.md and of the pages in docs/ into docs/images/: the same bytes every time.

usage: docs/draw.py [--build FOLDER] [--only NAME...]

Everything shown is the program's own output on the shipped examples. Needs a release build, and
Debian's python3-matplotlib, which brings numpy and PIL along.
"""
import argparse
import pathlib
import tempfile

import matplotlib
import numpy

from picture import (ADDED_BY_OURS, ADDED_BY_THEIRS, AGREES, ANCHOR, EXAMPLES, NODE, ON_LINE, PLAIN, REGIONS,
                     ROOT, UNMATCHED, Mesh, Picture, Programs, chequered, drawn, ends_of, panels, region_colours,
                     save, valences, view)

IMAGES = ROOT / "docs" / "images"


def draw_skeletons(programs):
    """The bear's two graphs; the paper's anchor on the first, and what agrees with the bear without ears on the second."""
    source, target = EXAMPLES / "bear.obj", EXAMPLES / "bear_no_ears_posed.obj"
    bear, other = Mesh(source), Mesh(target)
    seed = programs.match(source, target, "--algorithm", "lazy-greedy")["regions"][0]["faces"][0]
    partner = dict(programs.match(source, target)["vertices"])
    before, after = valences(bear), valences(other)
    extraordinary = numpy.flatnonzero(before != 4)
    agree = [v for v in extraordinary if v in partner and after[partner[v]] == before[v]]

    figure, (left, right) = panels(2, 8, 4.6)
    graph = programs.skeleton(source)
    ends = ends_of(graph.lines)
    picture = Picture(bear, view(-25, 12))
    picture.add_faces(lambda face: ANCHOR if face == seed[0] else PLAIN)
    picture.add_lines(graph.lines, graph.positions)
    picture.add_dots(graph.positions[[v for v, count in ends.items() if count == 4]], (1, 1, 1))
    picture.add_dots(bear.positions[extraordinary], NODE)
    picture.paint(left, "skeleton graph, with crossings")

    graph = programs.skeleton(source, "--separatrices")
    picture = Picture(bear, view(-25, 12))
    picture.add_faces(lambda _: PLAIN)
    picture.add_lines(graph.lines, graph.positions)
    picture.add_dots(bear.positions[extraordinary], NODE)
    picture.add_dots(bear.positions[agree], AGREES, radius=0.0115)
    picture.paint(right, "separatrix graph")
    save(figure, IMAGES / "separatrices.png")


def draw_waves(programs):
    source, target = EXAMPLES / "bear.obj", EXAMPLES / "bear_no_ears_posed.obj"
    match = programs.match(source, target, "--waves", "--algorithm", "lazy-greedy")
    colours = matplotlib.colormaps["viridis_r"]
    figure, both = panels(2, 8, 4.6)
    for side, (panel, path) in enumerate(zip(both, (source, target))):
        shade = {}
        for region in match["regions"]:
            start = 0
            for wave, end in enumerate(region["waves"]):
                for pair in region["faces"][start:end]:
                    shade[pair[side]] = colours(wave / max(1, len(region["waves"]) - 1))[:3]
                start = end
        picture = Picture(Mesh(path), view(-25, 12))
        picture.add_faces(lambda face, shade=shade: shade.get(face, UNMATCHED))
        picture.paint(panel, path.name)
    save(figure, IMAGES / "waves.png")


def draw_pair(programs, name, source, target, titles, box=None, both_sides=False):
    """Two meshes beside each other, regions in colours, what has no partner in red."""
    match = programs.match(source, target)
    figure, both = panels(2, 8, 4.6 if box is None else 3.6)
    for side, (panel, path, title) in enumerate(zip(both, (source, target), titles)):
        colours = region_colours(match, side)
        picture = Picture(Mesh(path), view(-25, 12))
        picture.add_faces(lambda face, colours=colours: colours.get(face, UNMATCHED), both_sides)
        picture.paint(panel, title, box)
    save(figure, IMAGES / name)


def draw_bears(programs):
    """What demo.sh matches: the picture and the film are the program's own."""
    pair = EXAMPLES / "bear.obj", EXAMPLES / "bear_no_ears_posed.obj"
    programs.run("quadmatch", "match", *pair, "--image", IMAGES / "bears.png", "--image-size", "880x440", "--quiet")
    programs.run("quadmatch", "match", *pair, "--algorithm", "lazy-greedy", "--animation", IMAGES / "bears.webp",
                 "--image-size", "640x320", "--quiet")


FIRE = {"waiting": "#dcdcd6", "front": "#ffd23c", "right": "#7fb3d5", "wrong": UNMATCHED}
FIRE_MILLISECONDS, LAST_MILLISECONDS = 320, 3000


def burned(programs, source, target, truth, algorithm):
    """M2 after each wave: what state each face is in."""
    region = programs.match(source, target, "--algorithm", algorithm, "--waves")["regions"][0]
    states, state, begin = [], {}, 0
    for end in region["waves"]:
        front = region["faces"][begin:end]
        states.append(state | {g: "front" for _, g, _ in front})
        state = state | {g: "right" if truth.get((f, g)) == r else "wrong" for f, g, r in front}
        begin = end
    return [*states, state]


def draw_fire(programs):
    """Figs. 4.3 and 4.5, wave by wave: greedy's cascade beside lazy-greedy's containment."""
    source, target = EXAMPLES / "fig_4_1.obj", EXAMPLES / "fig_4_2.obj"
    truth = programs.truth("fig_4_2")
    growth = {name: burned(programs, source, target, truth, name) for name in ("greedy", "lazy-greedy")}
    pictures = []
    for wave in range(max(len(states) for states in growth.values())):
        figure, both = panels(2, 8, 4)
        for panel, (name, states) in zip(both, growth.items()):
            state = states[min(wave, len(states) - 1)]
            picture = Picture(Mesh(target), view(0, 0))
            picture.add_faces(lambda face, state=state: FIRE[state.get(face, "waiting")], both_sides=True)
            wrong = sum(word == "wrong" for word in state.values())
            picture.paint(panel, f"{name}: {len(state)} quads" + (f", {wrong} of them wrong" if wrong else ""))
        pictures.append(drawn(figure, dpi=80))
    durations = [FIRE_MILLISECONDS] * (len(pictures) - 1) + [LAST_MILLISECONDS]
    pictures[0].save(IMAGES / "fire.webp", save_all=True, append_images=pictures[1:], duration=durations, loop=0,
                     lossless=True, method=4)


def draw_regions(programs):
    source = EXAMPLES / "bear.obj"
    target = programs.edited(source, 9, "delete:40", "extrude:40", "loop:1", "twist:1", "loop:1", "renumber")
    draw_pair(programs, "regions.png", source, target,
              ("bear.obj", "an edited copy"))


def draw_seam(programs):
    source = EXAMPLES / "shirt_long.obj"
    target = programs.edited(source, 11, "loop:1", "renumber")
    draw_pair(programs, "seam.png", source, target, ("shirt_long.obj, a sleeve", "with one edge loop more"),
              box=((-1.3, 0.35), (-0.3, 1.05)), both_sides=True)


def draw_symmetry(programs):
    """A posed bear: each side in a colour of its own, the centre line, and what has no mirror image."""
    path = EXAMPLES / "bear_posed.obj"
    found = programs.symmetry(path)
    partner = {pair[0]: pair[1] for region in found["regions"] for pair in region["faces"]}
    line = found["symmetry"]["centre_line"]
    mesh = Mesh(path)
    # By connectivity alone: what can be reached without crossing the line is one side.
    beside = {}
    for face, corners in enumerate(mesh.faces):
        for edge in zip(corners, corners[1:] + corners[:1]):
            beside.setdefault(frozenset(edge), []).append(face)
    along = {frozenset(edge) for edge in line["edges"]}
    left, to_visit = set(), [next(face for face in partner if partner[face] != face)]
    while to_visit:
        face = to_visit.pop()
        if face in left:
            continue
        left.add(face)
        corners = mesh.faces[face]
        for edge in map(frozenset, zip(corners, corners[1:] + corners[:1])):
            if edge not in along:
                to_visit += [other for other in beside[edge] if partner.get(other, other) not in (other, *left)]
    figure, both = panels(2, 8, 4.6)
    for panel, turn, title in zip(both, (-25, 155), ("bear_posed.obj", "from behind")):
        picture = Picture(mesh, view(turn, 12))
        picture.add_faces(lambda face: UNMATCHED if face not in partner else ON_LINE if partner[face] == face
                          else REGIONS[0] if face in left else REGIONS[1])
        picture.add_lines(line["edges"], mesh.positions, width=1.8)
        picture.paint(panel, title)
    save(figure, IMAGES / "symmetry.png")


def draw_transfer(programs):
    """What transfer carries: materials of a bear, on one that waves and has no ears."""
    source, target = EXAMPLES / "bear.obj", EXAMPLES / "bear_no_ears_posed.obj"
    result = programs.transferred(source, target, "--only", "uv")
    figure, both = panels(2, 8, 4.6)
    for panel, path, title in zip(both, (source, result), ("bear.obj: its texture", "carried over to bear_no_ears_posed.obj")):
        mesh, shades = Mesh(path), chequered(path)
        picture = Picture(mesh, view(-25, 12))
        picture.add_faces(lambda face, shades=shades: shades[face] or UNMATCHED)
        picture.paint(panel, title)
    save(figure, IMAGES / "transfer.png")


def draw_merge(programs):
    """Two edits of the bear and their merge: what OURS added in blue, what THEIRS added in orange."""
    base = EXAMPLES / "bear.obj"
    ours = programs.edited(base, 24, "extrude:24").rename(programs.folder / "mine.obj")
    theirs = programs.edited(base, 4, "loop:1", "renumber").rename(programs.folder / "yours.obj")
    merged = programs.folder / "merged.obj"
    origins = programs.merge(base, ours, theirs, merged)["origins"]
    figure, all_three = panels(3, 9, 3.6)
    for side, (panel, path) in enumerate(zip(all_three, (ours, theirs, merged)), start=1):
        added = {}
        for face, (before, mine, yours) in enumerate(origins):
            if before is None:
                added[face if side == 3 else (None, mine, yours)[side]] = ADDED_BY_OURS if yours is None else ADDED_BY_THEIRS
        picture = Picture(Mesh(path), view(-25, 12))
        picture.add_faces(lambda face, added=added: added.get(face, PLAIN))
        picture.paint(panel, path.name)
    save(figure, IMAGES / "merge.png")


CHANGES = {"inserted loop": "#e8a33d", "deletion": "#cf4a3f", "extrusion": "#9a7fc7", "refinement": "#6fb36b"}


def draw_diff(programs):
    """What docs/diff.md shows: the same edits, areas coloured by kind."""
    source = EXAMPLES / "bear.obj"
    target = programs.edited(source, 14, "delete:30", "extrude:20", "loop:1", "refine:12", "renumber")
    changes = programs.diff(source, target)["changes"]
    figure, both = panels(2, 8, 4.6)
    for side, panel, path, title in zip(("source_faces", "target_faces"), both, (source, target), ("bear.obj", "an edited copy")):
        colours = {face: CHANGES[change["kind"]] for change in changes for face in change[side]}
        picture = Picture(Mesh(path), view(-25, 12))
        picture.add_faces(lambda face, colours=colours: colours.get(face, PLAIN))
        picture.paint(panel, title)
    save(figure, IMAGES / "diff.png")


PICTURES = [draw_symmetry, draw_transfer, draw_bears, draw_fire, draw_skeletons, draw_waves, draw_regions, draw_seam, draw_merge, draw_diff]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", nargs="*", metavar="NAME", help="of these pictures, such as bears and fire")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        for draw in PICTURES:
            if options.only and draw.__name__.removeprefix("draw_") not in options.only:
                continue
            draw(Programs(options.build.resolve(), pathlib.Path(folder)))


if __name__ == "__main__":
    main()
