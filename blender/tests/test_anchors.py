"""Anchors: what the user says is the same, by two vertices selected one after the other."""
import bmesh
import bpy
import numpy as np

import scene
from case import Case


class Anchors(Case):
    """A square of 4 by 4 quads fits on another in four ways; an anchor says in which."""

    def setUp(self):
        super().setUp()
        self.source, self.target = scene.grid("Source", 4, 4), scene.grid("Target", 4, 4)
        self.pick(self.source, self.target)
        self.settings.positions = False
        self.settings.allow_ambiguous = True
        for obj in (self.source, self.target):
            obj.select_set(True)
        bpy.context.view_layer.objects.active = self.target

    def select(self, obj, *vertices):
        if obj.mode != "EDIT":
            bpy.ops.object.mode_set(mode="EDIT")
        mesh = bmesh.from_edit_mesh(obj.data)
        mesh.verts.ensure_lookup_table()
        mesh.select_history.clear()
        for vertex in mesh.verts:
            vertex.select = False
        for index in vertices:
            mesh.verts[index].select = True
            mesh.select_history.add(mesh.verts[index])

    def image_of(self, vertex):
        """Where a vertex of the source goes."""
        group = self.source.vertex_groups.new(name=f"Mark {vertex}")
        bpy.ops.object.mode_set(mode="OBJECT")
        group.add([vertex], 1.0, "REPLACE")
        self.call(bpy.ops.quadmatch.transfer)
        return np.flatnonzero(scene.weights(self.target, group.name) == 1).tolist()

    def anchored(self, first, second):
        self.select(self.source, *first)
        self.select(self.target, *second)
        self.call(bpy.ops.quadmatch.add_anchor)

    def test_the_edge_that_was_said_to_be_the_same_is(self):
        # Numbers run along x: 0 to 4 is the lower rim, 24 down to 20 the upper one.
        self.anchored((0, 1), (24, 23))
        self.assertEqual(self.image_of(0), [24])

    def test_another_anchor_another_match(self):
        self.anchored((0, 1), (4, 9))
        self.assertEqual(self.image_of(0), [4])
        self.assertEqual(self.image_of(20), [0])

    def test_turned_over_the_edge_runs_the_other_way_round(self):
        self.settings.orientation = "reversing"
        self.anchored((0, 1), (4, 3))
        self.assertEqual(self.image_of(0), [4])

    def test_an_anchor_can_be_removed(self):
        self.anchored((0, 1), (24, 23))
        self.assertEqual(len(self.settings.anchors), 1)
        self.call(bpy.ops.quadmatch.remove_anchor, index=0)
        self.assertEqual(len(self.settings.anchors), 0)

    def test_three_vertices_or_one_are_refused(self):
        for vertices in ((0,), (0, 1, 2)):
            self.select(self.source, *vertices)
            self.select(self.target, 0, 1)
            self.assertRefused(bpy.ops.quadmatch.add_anchor, f"Source: select two vertices of an edge one after the other, in the same order on both objects; {len(vertices)}")

    def test_vertices_that_no_edge_joins_are_refused(self):
        self.select(self.source, 0, 6)
        self.select(self.target, 0, 1)
        self.assertRefused(bpy.ops.quadmatch.add_anchor, "Source: no edge joins the two selected vertices")

    def test_outside_edit_mode_it_is_refused(self):
        self.assertRefused(bpy.ops.quadmatch.add_anchor, "Source is not in edit mode")

    def test_an_edge_that_has_no_face_on_that_side_is_refused(self):
        self.anchored((1, 0), (1, 0))
        self.assertRefused(bpy.ops.quadmatch.match, "anchor: Source has no face on that side of the edge from vertex 1 to 0")
