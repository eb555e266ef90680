"""The paper's figures, drawn from our own models; what the greedy cascade costs, in numbers."""
import json
import pathlib
import sys
import tempfile

import numpy

from parts.common import ROOT, table

sys.path.insert(0, str(ROOT / "docs"))
import picture as draw  # after the path is set
from paper.compatibility_graph import CompatibilityGraph

TITLE = "Figures"
INTRODUCTION = "The paper's figures once more, from models that this project makes. What is red has no partner, as in the paper."

FRONT = draw.view(0, 0)
TILTED = draw.view(-25, 12)
WRONG = draw.UNMATCHED
MATCHED = (0.62, 0.77, 0.9)
CANDIDATE = (0.99, 0.86, 0.55)
LARGEST = (0.96, 0.62, 0.2)
BLANK = (0.96, 0.96, 0.95)


class Studio:
    """Where models come from and pictures go."""

    def __init__(self, options, folder):
        self.programs = draw.Programs(options.build.resolve(), folder)
        self.folder = folder
        self.images = options.docs / "images"

    def shape(self, name, *more):
        path = self.folder / f"{name.replace(':', '_').replace(',', '_')}.obj"
        self.programs.run("make_shape", name, path, *more)
        return path

    def truth_of_figure_4_2(self):
        path = self.folder / "truth.json"
        self.shape("fig_4_2", "--truth", path)
        return {(f, g): r for f, g, r in json.loads(path.read_text(encoding="utf-8"))["exact"]}

    def save(self, figure, name):
        draw.save(figure, self.images / name)


def painted(panel, path, colour_of, title="", rotation=FRONT, decorate=None, both_sides=True):
    picture = draw.Picture(draw.Mesh(path), rotation)
    picture.add_faces(colour_of, both_sides)
    if decorate:
        decorate(picture)
    picture.paint(panel, title)
    return picture


def extraordinary_vertices(mesh):
    """Valence other than 4 inside, other than 3 on the boundary (§2.1)."""
    directed = {edge for face in mesh.faces for edge in zip(face, face[1:] + face[:1])}
    boundary = {vertex for a, b in directed if (b, a) not in directed for vertex in (a, b)}
    return [vertex for vertex, valence in enumerate(draw.valences(mesh)) if valence != (3 if vertex in boundary else 4)]


def figure_2_1(studio):
    figure, (panel,) = draw.panels(1, 4.2, 4.4)
    painted(panel, draw.EXAMPLES / "dog_toy.obj", lambda _: draw.PLAIN, rotation=draw.view(20, 25), both_sides=False)
    studio.save(figure, "fig_2_1.png")


def figure_3_1(studio):
    """The gadgets: M1 of a cycle, M2 of the graph of a cube, and the 7n quads that a Hamiltonian cycle matches."""
    studio.programs.run("make_instances", "gadgets", studio.folder, "--graph", "cube")
    match = json.loads((studio.folder / "cube-match.json").read_text(encoding="utf-8"))
    figure, panels = draw.panels(2, 9, 4.8)
    for side, (panel, name) in enumerate(zip(panels, ("source", "target"))):
        partnered = {pair[side] for region in match["regions"] for pair in region["faces"]}
        painted(panel, studio.folder / f"cube-{name}.obj", lambda face, partnered=partnered:
                MATCHED if face in partnered else WRONG if side == 0 else BLANK, ("M1, of a cycle", "M2, of a cube's graph")[side])
    studio.save(figure, "fig_3_1.png")


def figure_4_1(studio):
    """The five extraordinary vertices, and the particles' ways in bold."""
    path = studio.shape("fig_4_1")
    graph = studio.programs.skeleton(path, "--separatrices")
    mesh = draw.Mesh(path)
    start = max(range(len(mesh.positions)), key=lambda vertex: draw.valences(mesh)[vertex])
    extraordinary = extraordinary_vertices(mesh)
    figure, (panel,) = draw.panels(1, 4.6, 4.8)

    def decorate(picture):
        picture.add_lines(graph.lines, graph.positions, draw.INK, 2.2)
        picture.add_dots(mesh.positions[extraordinary], draw.NODE, 0.014)
        picture.add_dots(mesh.positions[[start]], draw.ANCHOR, 0.02)

    painted(panel, path, lambda _: BLANK, decorate=decorate)
    panel.set(**window(mesh.positions[:, :2], margin=0.03))
    studio.save(figure, "fig_4_1.png")


def figure_4_2(studio):
    """M1 with its three squeezed quads, and M2."""
    source, target = studio.shape("fig_4_1"), studio.shape("fig_4_2")
    survive = {f for f, _ in studio.truth_of_figure_4_2()}
    figure, (left, right) = draw.panels(2, 8, 4.4)
    painted(left, source, lambda face: BLANK if face in survive else WRONG, "M1: three quads that will be squeezed")
    painted(right, target, lambda _: BLANK, "M2")
    studio.save(figure, "fig_4_2.png")


def cascade(studio, algorithm):
    """A match of Figs. 4.1 and 4.2 grown from the anchor it finds, and which of its pairs are true."""
    match = studio.programs.match(studio.shape("fig_4_1"), studio.shape("fig_4_2"), "--algorithm", algorithm, "--waves")
    truth = studio.truth_of_figure_4_2()
    pairs = match["regions"][0]["faces"]
    right = {g for f, g, r in pairs if truth.get((f, g)) == r}
    return {"matched": len(pairs), "right": len(right), "of": len(truth), "match": match, "right_faces": right}


def draw_cascade(studio, algorithm, name):
    """M2: a wave is the paler the earlier it burned; red where a wrong quad lies on it."""
    outcome = cascade(studio, algorithm)
    region = outcome["match"]["regions"][0]
    shades = draw.matplotlib.colormaps["Blues"]
    wave_of, begin = {}, 0
    for wave, end in enumerate(region["waves"]):
        wave_of.update({pair[1]: wave for pair in region["faces"][begin:end]})
        begin = end
    last = max(1, len(region["waves"]) - 1)

    def colour(face):
        if face not in wave_of:
            return BLANK
        return shades(0.15 + 0.6 * wave_of[face] / last)[:3] if face in outcome["right_faces"] else WRONG

    figure, (panel,) = draw.panels(1, 4.6, 4.8)
    painted(panel, studio.shape("fig_4_2"), colour)
    studio.save(figure, name)
    return {key: outcome[key] for key in ("matched", "right", "of")}


def telling_wave(graph_at, waves):
    """A wave before which L has the most components of different sizes: the picture that tells most."""
    return max(range(1, len(waves)), key=lambda wave: (len({len(c) for c in graph_at(wave).components()}), -wave))


def window(points, margin=0.35):
    """Limits of a panel that shows some points and their surroundings, as a square."""
    low, high = numpy.min(points, axis=0), numpy.max(points, axis=0)
    middle, half = (low + high) / 2, (0.5 + margin) * (high - low).max()
    return {"xlim": (middle[0] - half, middle[0] + half), "ylim": (middle[1] - half, middle[1] + half)}


def figure_4_4(studio):
    """S' in blue, candidates numbered on both meshes, and L itself."""
    source, target = studio.shape("fig_4_1"), studio.shape("fig_4_2")
    region = studio.programs.match(source, target, "--algorithm", "lazy-greedy", "--waves")["regions"][0]
    meshes = draw.Mesh(source), draw.Mesh(target)

    def graph_at(wave):
        return CompatibilityGraph(meshes[0].faces, meshes[1].faces, region["faces"][:region["waves"][wave - 1]])

    wave = telling_wave(graph_at, region["waves"])
    graph = graph_at(wave)
    largest = max(graph.components(), key=len)
    taken = [{pair[side] for pair in region["faces"][:region["waves"][wave - 1]]} for side in (0, 1)]
    figure, panels = draw.panels(2, 9, 4.8)
    for side, (panel, path, title) in enumerate(zip(panels, (source, target), ("M1 and L", "M2"))):
        members = {graph.faces(node)[side] for node in largest}
        others = {graph.faces(node)[side] for node in graph.nodes} - members

        def colour(face, side=side, members=members, others=others):
            return (MATCHED if face in taken[side] else LARGEST if face in members
                    else CANDIDATE if face in others else BLANK)

        painted(panel, path, colour, title)
        centre = {node: meshes[side].positions[meshes[side].faces[graph.faces(node)[side]]].mean(axis=0)[:2]
                  for node in graph.nodes}
        for node, number in graph.numbers().items():
            panel.text(*centre[node], str(number), fontsize=9, ha="center", va="center", zorder=5)
        panel.set(**window(list(centre.values())))
        if side == 0:
            for one, other in graph.links:
                panel.plot(*numpy.array([centre[one], centre[other]]).T, color=draw.LINE, linewidth=4, alpha=0.6, zorder=4)
    studio.save(figure, "fig_4_4.png")
    return {"wave": wave, "candidates": len(graph.nodes), "components": sorted(map(len, graph.components()), reverse=True),
            "most_neighbours": graph.most_neighbours()}


def figure_5_1(studio):
    bear = draw.EXAMPLES / "bear.obj"
    graph = studio.programs.skeleton(bear)
    figure, (panel,) = draw.panels(1, 4.2, 4.6)
    painted(panel, bear, lambda _: draw.PLAIN, rotation=TILTED, both_sides=False,
            decorate=lambda picture: picture.add_lines(graph.lines, graph.positions, draw.UNMATCHED, 1.4))
    studio.save(figure, "fig_5_1.png")


def draw_mismatch(studio, source, target, name, titles, both_sides=False):
    """Lazy-greedy, as in the paper: what has no partner is red."""
    match = studio.programs.match(source, target, "--algorithm", "lazy-greedy")
    figure, panels = draw.panels(2, 8, 4.6)
    for side, (panel, path, title) in enumerate(zip(panels, (source, target), titles)):
        partnered = {pair[side] for region in match["regions"] for pair in region["faces"]}
        painted(panel, path, lambda face, partnered=partnered: draw.PLAIN if face in partnered else WRONG, title, TILTED,
                both_sides=both_sides)
    studio.save(figure, name)
    return {"matched": sum(len(region["faces"]) for region in match["regions"]),
            "source": len(draw.Mesh(source).faces), "target": len(draw.Mesh(target).faces)}


def figure_5_2(studio):
    names = "bear.obj", "bear_no_ears_posed.obj"
    return draw_mismatch(studio, *(draw.EXAMPLES / name for name in names), "fig_5_2.png", names)


def figure_5_3(studio):
    """Modest and massive mismatches in one model: the crown gone, a patch pulled out, a slit, a few quads collapsed."""
    source = draw.EXAMPLES / "bear_posed.obj"
    target = studio.programs.edited(source, 32, "delete:200", "extrude:40", "rip:8", "collapse:3", "renumber")
    return draw_mismatch(studio, source, target, "fig_5_3.png", ("bear_posed.obj", "an edited copy"))


def measure(options):
    with tempfile.TemporaryDirectory() as folder:
        studio = Studio(options, pathlib.Path(folder))
        for figure in (figure_2_1, figure_3_1, figure_4_1, figure_4_2, figure_5_1):
            figure(studio)
        return {"greedy": draw_cascade(studio, "greedy", "fig_4_3.png"), "graph": figure_4_4(studio),
                "lazy-greedy": draw_cascade(studio, "lazy-greedy", "fig_4_5.png"),
                "bears": figure_5_2(studio), "edited": figure_5_3(studio)}


def shown(number, name, text):
    return [f"\n## Fig. {number}\n", f"![Fig. {number}](images/{name})\n", text + "\n"]


def matched_of(raw):
    return f"{raw['matched']:,} of {raw['source']:,} quads and {raw['target']:,}"


def page(raw):
    greedy, lazy, graph = raw["greedy"], raw["lazy-greedy"], raw["graph"]
    lines = shown("2.1", "fig_2_1.png", "The dog toy, of genus 16: `examples/dog_toy.obj`.")
    lines += shown("3.1", "fig_3_1.png", "The gadgets of Theorem 3.1, and what a Hamiltonian cycle of the cube's graph matches: "
                   "7n quads, in blue; in red the one quad of each vertex of M1 that is lost. [How they are "
                   "built](../design/013-hardness.md), [what exact search says of them](hardness.md).")
    lines += shown("4.1", "fig_4_1.png", "M1: five extraordinary vertices; \"start\" in red, the ways of the particles bold. "
                   "[Why it has a hole](../reading-the-paper.md#fig-41-cannot-be-a-disk).")
    lines += shown("4.2", "fig_4_2.png", "M2: three quads of M1 are compressed into edges.")
    lines += shown("4.3", "fig_4_3.png", "Greedy on M2, from the anchor of its own finding: the paler, the earlier a quad "
                   "burned; red quads lie on a wrong quad of M1.")
    lines += shown("4.4", "fig_4_4.png", f"Lazy-greedy before wave {graph['wave']}. Blue quads are matched; a number stands "
                   "on both quads of a candidate; lines are the edges of the compatibility graph L. The component that is "
                   f"taken next is orange. The sizes of all components: {', '.join(map(str, graph['components']))}; no "
                   f"candidate has more than {graph['most_neighbours']} neighbours in L.")
    lines += shown("4.5", "fig_4_5.png", "Lazy-greedy on M2. Both [wave by wave](../how-it-works.md).")
    lines += ["\nThe cascade in numbers:\n",
              table(["algorithm", "quads matched", "of them right", "true pairs there are"],
                    [[name, row["matched"], row["right"], row["of"]] for name, row in (("greedy", greedy), ("lazy-greedy", lazy))]),
              "\nTests hold both: \"Figs 4.3 and 4.5: from an anchor of its own finding, lazy-greedy is as right, and greedy "
              "derails too\" and its neighbours.\n"]
    lines += shown("5.1", "fig_5_1.png", "The skeleton graph of the bear in red.")
    lines += shown("5.2", "fig_5_2.png", f"Two bears by lazy-greedy: {matched_of(raw['bears'])} matched; the rest is the ears "
                   "and the places where they grow.")
    lines += shown("5.3", "fig_5_3.png", f"Modest and massive mismatches by lazy-greedy: {matched_of(raw['edited'])} matched. A "
                   "patch deleted, one extruded, a slit and three collapsed quads.")
    return lines
