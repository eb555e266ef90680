#!/usr/bin/env python3
"""Draw the pictures of README.md and docs/how-it-works.md into docs/images/: the same bytes every time.

usage: docs/draw.py [--build FOLDER]

Everything shown is the program's own output on the shipped examples. Needs a release build, and
Debian's python3-matplotlib, which brings numpy and PIL along.
"""
import argparse
import io
import json
import pathlib
import subprocess
import tempfile

import matplotlib
import matplotlib.collections
import numpy
import PIL.Image

matplotlib.use("agg")
import matplotlib.pyplot  # after the choice of a renderer

ROOT = pathlib.Path(__file__).resolve().parent.parent
IMAGES = ROOT / "docs" / "images"
EXAMPLES = ROOT / "examples"

PLAIN = (0.86, 0.86, 0.84)
UNMATCHED = (0.84, 0.15, 0.16)
REGIONS = ["#7fb3d5", "#f5c26b", "#9fd39a", "#c9a6dd", "#8fd6cf", "#f2a7c3", "#c8b08a", "#b9c86e"]
LINE = (0.13, 0.35, 0.6)
NODE = (0.95, 0.6, 0.1)
AGREES = (0.35, 0.7, 0.3)
ANCHOR = (0.84, 0.15, 0.16)
INK = (0.1, 0.1, 0.12)
EDGE = (0.35, 0.35, 0.35, 0.45)
LIGHT = numpy.array([0.35, 0.5, 0.8])


class Mesh:
    """Positions and faces of an OBJ file, and its polylines."""

    def __init__(self, path):
        positions, self.faces, self.lines = [], [], []
        for line in path.read_text(encoding="utf-8").splitlines():
            words = line.split()
            if words[:1] == ["v"]:
                positions.append([float(word) for word in words[1:4]])
            elif words[:1] == ["f"]:
                self.faces.append([int(word.split("/")[0]) - 1 for word in words[1:]])
            elif words[:1] == ["l"]:
                self.lines.append([int(word) - 1 for word in words[1:]])
        self.positions = numpy.array(positions)


def view(turn, tilt):
    """A rotation: `turn` degrees about the upright axis, then tilted towards us. We look along -z."""
    a, b = numpy.radians([turn, tilt])
    about = numpy.array([[numpy.cos(a), 0, numpy.sin(a)], [0, 1, 0], [-numpy.sin(a), 0, numpy.cos(a)]])
    over = numpy.array([[1, 0, 0], [0, numpy.cos(b), -numpy.sin(b)], [0, numpy.sin(b), numpy.cos(b)]])
    return over @ about


class Picture:
    """Faces and lines of one model, painted from back to front."""

    def __init__(self, mesh, rotation):
        self.mesh, self.rotation = mesh, rotation
        self.points = mesh.positions @ rotation.T
        self.size = numpy.ptp(self.points, axis=0).max()
        self.items = []  # depth, points, colour, edge colour, width

    def add_faces(self, colour_of, both_sides=False):
        for index, face in enumerate(self.mesh.faces):
            points = self.points[face]
            normal = sum(numpy.cross(points[k], points[(k + 1) % len(face)]) for k in range(len(face)))
            length = numpy.linalg.norm(normal)
            if length == 0 or (normal[2] < 0 and not both_sides):
                continue
            lit = 0.62 + 0.38 * abs(normal @ LIGHT) / length / numpy.linalg.norm(LIGHT)
            colour = numpy.array(matplotlib.colors.to_rgb(colour_of(index))) * lit
            self.items.append((points[:, 2].mean(), points[:, :2], colour, EDGE, 0.3))

    def add_lines(self, lines, positions, colour=LINE, width=1.3):
        """Polylines on the surface, drawn in front of the faces they border."""
        points = positions @ self.rotation.T
        for line in lines:
            for a, b in zip(line, line[1:]):
                depth = (points[a][2] + points[b][2]) / 2 + 0.02 * self.size
                self.items.append((depth, points[[a, b]][:, :2], (0, 0, 0, 0), colour, width))

    def add_dots(self, positions, colour, radius=0.011):
        angles = numpy.linspace(0, 2 * numpy.pi, 17)
        circle = radius * self.size * numpy.stack([numpy.cos(angles), numpy.sin(angles)], axis=1)
        for point in positions @ self.rotation.T:
            self.items.append((point[2] + 0.03 * self.size, point[:2] + circle, colour, INK, 0.5))

    def paint(self, panel, title="", box=None):
        self.items.sort(key=lambda item: item[0])
        _, points, colours, edges, widths = zip(*self.items)
        panel.add_collection(matplotlib.collections.PolyCollection(points, facecolors=colours, edgecolors=edges,
                                                                   linewidths=widths, joinstyle="round"))
        low, high = box or (self.points[:, :2].min(axis=0), self.points[:, :2].max(axis=0))
        panel.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), aspect="equal")
        panel.axis("off")
        panel.set_title(title, fontsize=10)


class Programs:
    """The project's programs, and a folder for what they write."""

    def __init__(self, build, folder):
        self.build, self.folder = build, folder

    def run(self, program, *words):
        command = [str(self.build / program), *(str(word) for word in words)]
        subprocess.run(command, check=True, cwd=ROOT, capture_output=True)

    def match(self, source, target, *more):
        path = self.folder / "match.json"
        self.run("quadmatch", "match", source, target, "-o", path, "--quiet", *more)
        return json.loads(path.read_text(encoding="utf-8"))

    def skeleton(self, mesh, *more):
        path = self.folder / "lines.obj"
        self.run("quadmatch", "skeleton", mesh, "-o", path, "--quiet", *more)
        return Mesh(path)

    def edited(self, mesh, seed, *edits):
        path = self.folder / "edited.obj"
        self.run("edit_mesh", mesh, path, *edits, "--seed", seed)
        return path


def panels(count, width, height):
    figure, found = matplotlib.pyplot.subplots(1, count, figsize=(width, height), squeeze=False)
    figure.subplots_adjust(left=0.005, right=0.995, bottom=0.01, top=0.92, wspace=0.02)
    return figure, found[0]


def save(figure, name):
    """As PNG of 256 colours, the rare ones too: half the size."""
    IMAGES.mkdir(parents=True, exist_ok=True)
    drawn = io.BytesIO()
    figure.savefig(drawn, dpi=110, format="png")
    matplotlib.pyplot.close(figure)
    picture = PIL.Image.open(drawn).convert("RGB")
    picture = picture.quantize(256, PIL.Image.Quantize.MAXCOVERAGE, dither=PIL.Image.Dither.NONE)
    picture.save(IMAGES / name, optimize=True)


def ends_of(lines):
    """Vertices at the ends of polylines, and how many ends each has."""
    count = {}
    for line in lines:
        for end in (line[0], line[-1]):
            count[end] = count.get(end, 0) + 1
    return count


def valences(mesh):
    """The number of edges at each vertex."""
    edges = {frozenset(edge) for face in mesh.faces for edge in zip(face, face[1:] + face[:1])}
    return numpy.bincount([vertex for edge in edges for vertex in edge], minlength=len(mesh.positions))


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
    save(figure, "separatrices.png")


def region_colours(match, side):
    """Face of one side (0: source, 1: target): colour of its region."""
    return {pair[side]: REGIONS[index % len(REGIONS)] for index, region in enumerate(match["regions"])
            for pair in region["faces"]}


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
    save(figure, "waves.png")


def draw_pair(programs, name, source, target, titles, box=None, both_sides=False):
    """Two meshes beside each other, regions in colours, what has no partner in red."""
    match = programs.match(source, target)
    figure, both = panels(2, 8, 4.6 if box is None else 3.6)
    for side, (panel, path, title) in enumerate(zip(both, (source, target), titles)):
        colours = region_colours(match, side)
        picture = Picture(Mesh(path), view(-25, 12))
        picture.add_faces(lambda face, colours=colours: colours.get(face, UNMATCHED), both_sides)
        picture.paint(panel, title, box)
    save(figure, name)


def draw_bears(programs):
    """What demo.sh matches."""
    names = "bear.obj", "bear_no_ears_posed.obj"
    draw_pair(programs, "bears.png", *(EXAMPLES / name for name in names), names)


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


PICTURES = [draw_bears, draw_skeletons, draw_waves, draw_regions, draw_seam]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        for draw in PICTURES:
            draw(Programs(options.build.resolve(), pathlib.Path(folder)))


if __name__ == "__main__":
    main()
