"""What pictures of models are drawn with: shaded faces, lines and dots, painted from back to front by matplotlib.

The same bytes every time. Needs Debian's python3-matplotlib, which brings numpy and PIL along.
"""
import io
import json
import pathlib
import subprocess

import matplotlib
import matplotlib.collections
import numpy
import PIL.Image

matplotlib.use("agg")
import matplotlib.pyplot  # after the choice of a renderer

ROOT = pathlib.Path(__file__).resolve().parent.parent
EXAMPLES = ROOT / "examples"

PLAIN = (0.86, 0.86, 0.84)
UNMATCHED = (0.84, 0.15, 0.16)
REGIONS = ["#7fb3d5", "#f5c26b", "#9fd39a", "#c9a6dd", "#8fd6cf", "#f2a7c3", "#c8b08a", "#b9c86e"]
LINE = (0.13, 0.35, 0.6)
NODE = (0.95, 0.6, 0.1)
AGREES = (0.35, 0.7, 0.3)
ANCHOR = (0.84, 0.15, 0.16)
ON_LINE = (0.55, 0.8, 0.6)
ADDED_BY_OURS = (0.3, 0.55, 0.85)
ADDED_BY_THEIRS = (0.95, 0.6, 0.2)
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

    def run(self, program, *words, statuses=(0,)):
        command = [str(self.build / program), *(str(word) for word in words)]
        ended = subprocess.run(command, check=False, cwd=ROOT, capture_output=True, text=True)
        if ended.returncode not in statuses:
            raise SystemExit(f"{' '.join(command)}: status {ended.returncode}: {ended.stderr.strip()}")

    def match(self, source, target, *more):
        path = self.folder / "match.json"
        self.run("quadmatch", "match", source, target, "-o", path, "--quiet", *more)
        return json.loads(path.read_text(encoding="utf-8"))

    def symmetry(self, mesh, *more):
        path = self.folder / "map.json"
        self.run("quadmatch", "symmetry", mesh, "-o", path, "--quiet", *more, statuses=(0, 1))
        return json.loads(path.read_text(encoding="utf-8"))

    def transferred(self, source, target, *more):
        path = self.folder / "transferred.obj"
        self.run("quadmatch", "transfer", source, target, "-o", path, "--quiet", *more, statuses=(0, 1))
        return path

    def merge(self, base, ours, theirs, output):
        """Writes the merge; the figures, with where each of its faces comes from."""
        command = [self.build / "quadmatch", "merge", base, ours, theirs, "-o", output, "--json", "--origins", "--quiet"]
        return json.loads(subprocess.run(command, check=True, cwd=ROOT, capture_output=True).stdout)

    def diff(self, source, target):
        command = [str(self.build / "quadmatch"), "diff", str(source), str(target), "--json"]
        return json.loads(subprocess.run(command, check=False, cwd=ROOT, capture_output=True).stdout)

    def truth(self, name):
        """Of a figure that is another one edited: the true pairs of faces, and how each is turned."""
        path = self.folder / "truth.json"
        self.run("make_shape", name, self.folder / "truth.obj", "--truth", path)
        return {(f, g): r for f, g, r in json.loads(path.read_text(encoding="utf-8"))["exact"]}

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


def drawn(figure, dpi=110):
    """A figure as a picture of 256 colours, the rare ones too."""
    bytes_of = io.BytesIO()
    figure.savefig(bytes_of, dpi=dpi, format="png")
    matplotlib.pyplot.close(figure)
    picture = PIL.Image.open(bytes_of).convert("RGB")
    return picture.quantize(256, PIL.Image.Quantize.MAXCOVERAGE, dither=PIL.Image.Dither.NONE)


def save(figure, path):
    """As PNG; 256 colours make it half the size."""
    path.parent.mkdir(parents=True, exist_ok=True)
    drawn(figure).save(path, optimize=True)


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


def chequered(path, squares=16):
    """A colour for each face by where its middle is on the texture, nothing for faces that are not on it."""
    pool, shades = [], []
    for line in path.read_text(encoding="utf-8").splitlines():
        words = line.split()
        if words[:1] == ["vt"]:
            pool.append([float(word) for word in words[1:3]])
        elif words[:1] == ["f"]:
            indices = [int((word.split("/") + [""])[1] or 0) for word in words[1:]]
            if 0 in indices:
                shades.append(None)
                continue
            u, v = numpy.mean([pool[index - 1] for index in indices], axis=0)
            shades.append(REGIONS[(int(u * squares) + 3 * int(v * squares)) % len(REGIONS)])
    return shades


def region_colours(match, side):
    """Face of one side (0: source, 1: target): colour of its region."""
    return {pair[side]: REGIONS[index % len(REGIONS)] for index, region in enumerate(match["regions"])
            for pair in region["faces"]}
