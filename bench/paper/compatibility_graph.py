"""The compatibility graph L of §4.5.2 between two quad meshes, straight from its definition: for the picture of Fig. 4.4."""


def halfedges(faces):
    """Directed edge of two vertices: the face it goes along and the corner it begins at."""
    return {(face[k], face[(k + 1) % 4]): (f, k) for f, face in enumerate(faces) for k in range(4)}


class CompatibilityGraph:
    """`nodes` are candidates (h, h'): half-edges (face, corner) of unmatched quads, along the rim of what is matched."""

    def __init__(self, source, target, pairs):
        self.meshes = source, target
        self.edges = halfedges(source), halfedges(target)
        self.matched = {f for f, _, _ in pairs}, {g for _, g, _ in pairs}
        beyond = [(self.twin(0, (f, k)), self.twin(1, (g, (r + k) % 4))) for f, g, r in pairs for k in range(4)]
        self.nodes = sorted((h, i) for h, i in beyond if h and i and h[0] not in self.matched[0] and i[0] not in self.matched[1])
        self.links = [(node, self.next(node)) for node in self.nodes if self.next(node)]

    def twin(self, side, halfedge):
        face, corner = halfedge
        quad = self.meshes[side][face]
        return self.edges[side].get((quad[(corner + 1) % 4], quad[corner]))

    def end_of_gap(self, side, halfedge):
        """Round the origin of a half-edge on the rim, through unmatched quads: the next rim half-edge, and the quads passed."""
        for passed in range(1, len(self.meshes[side])):
            before = (halfedge[0], (halfedge[1] - 1) % 4)
            halfedge = self.twin(side, before)
            if halfedge is None:
                return None, passed
            if halfedge[0] in self.matched[side]:
                return before, passed
        return None, 0

    def next(self, node):
        """The candidate about the origin of this one, where the stars of the two origins agree."""
        (end, passed), (partner_end, partner_passed) = (self.end_of_gap(side, node[side]) for side in (0, 1))
        other = (end, partner_end)
        return other if passed == partner_passed and other in set(self.nodes) and other != node else None

    @staticmethod
    def faces(node):
        return node[0][0], node[1][0]

    def neighbours(self, node):
        return [b if a == node else a for a, b in self.links if node in (a, b)]

    def most_neighbours(self):
        return max(len(self.neighbours(node)) for node in self.nodes)

    def components(self):
        """Nodes of each component of L."""
        left, found = set(self.nodes), []
        while left:
            component, fresh = [], [min(left)]
            left.remove(fresh[0])
            while fresh:
                node = fresh.pop()
                component.append(node)
                reached = [other for other in self.neighbours(node) if other in left]
                left.difference_update(reached)
                fresh += reached
            found.append(component)
        return found

    def numbers(self):
        """A number for each node, consecutive along components."""
        return {node: number for number, node in enumerate((n for c in self.components() for n in c), start=1)}
