"""Mirror Map and Symmetrize, on the bear at rest and posed."""
import dataclasses

import bpy
import numpy as np

import scene
from case import Case
from quadmatch_addon import engine
from quadmatch_addon.mesh_arrays import arrays_of
from quadmatch_addon.sides import sides_of_faces


class Mirror(Case):
    def open(self, name):
        self.bear = scene.load(scene.ROOT / "examples" / name, "Bear")
        bpy.context.view_layer.objects.active = self.bear
        self.bear.select_set(True)
        self.rest = scene.numbers(scene.load(scene.ROOT / "examples" / "bear.obj", "Rest").data.vertices, "co", 3)

    def partner(self):
        return scene.numbers(self.bear.data.attributes["quadmatch_mirror"].data, "value", 1, np.int32)

    def mirror_map(self):
        self.settings.select = False
        return self.call(bpy.ops.quadmatch.mirror_map)

    def test_of_a_posed_model_every_vertex_knows_the_one_opposite(self):
        self.open("bear_posed.obj")
        lines = self.mirror_map()
        partner = self.partner()
        paired = np.flatnonzero(partner >= 0)
        self.assertGreater(len(paired), 2800)
        np.testing.assert_array_equal(partner[partner[paired]], paired)
        # Both bears have the same numbers. At rest partners are mirror images but for the rows that a patch interrupts.
        apart = np.abs(self.rest[partner[paired]] - self.rest[paired] * [-1, 1, 1]).max(axis=1)
        self.assertGreater((apart < 1e-4).mean(), 0.93)
        self.assertTrue(any(line.startswith("Posed: no plane") for line in lines), lines)

    def test_faces_without_a_partner_are_selected_in_edit_mode(self):
        self.open("bear.obj")
        lines = self.call(bpy.ops.quadmatch.mirror_map)
        self.assertEqual(self.bear.mode, "EDIT")
        bpy.ops.object.mode_set(mode="OBJECT")
        selected = np.flatnonzero(scene.numbers(self.bear.data.polygons, "select", 1, bool))
        mirror = engine.symmetry(arrays_of(self.bear.data), "Bear", True, lambda matched, most: True)
        self.assertGreater(len(selected), 0)
        np.testing.assert_array_equal(selected, mirror.unpaired_faces)
        self.assertTrue(lines[0].endswith(f"{len(selected)} have none"), lines[0])

    def test_positions_of_one_side_are_mirrored_onto_the_other_and_undo_takes_it_back(self):
        self.open("bear.obj")
        sculpted = self.rest.copy()
        sculpted[np.flatnonzero(self.rest[:, 0] > 0.01)[::7], 1] += np.float32(0.03)
        self.bear.data.vertices.foreach_set("co", sculpted.ravel())
        self.mirror_map()
        partner = self.partner()
        right = np.flatnonzero((partner >= 0) & (self.rest[:, 0] > 0.01) & (self.rest[partner, 0] < -0.01))
        self.assertGreater(len(right), 1300)
        before = scene.all_of(self.bear)
        self.settings.symmetrize_groups = False
        bpy.ops.ed.undo_push(message="before")
        self.call(bpy.ops.quadmatch.symmetrize)
        now = scene.numbers(bpy.data.objects["Bear"].data.vertices, "co", 3)
        np.testing.assert_array_equal(now[partner[right]], now[right] * np.float32([-1, 1, 1]))
        np.testing.assert_array_equal(now[right], sculpted[right])
        np.testing.assert_array_equal(now[partner < 0], sculpted[partner < 0])
        bpy.ops.ed.undo()
        self.assertSame(scene.all_of(bpy.data.objects["Bear"]), before)

    def test_shape_keys_keep_their_displacements_when_the_basis_is_made_even(self):
        self.open("bear.obj")
        self.bear.shape_key_add(name="Basis")
        up = self.bear.shape_key_add(name="Up")
        up.data.foreach_set("co", (self.rest + np.float32([0, 0.5, 0])).ravel())
        self.settings.symmetrize_groups = False
        self.call(bpy.ops.quadmatch.symmetrize)
        keys = self.bear.data.shape_keys.key_blocks
        np.testing.assert_allclose(scene.numbers(keys["Up"].data, "co", 3) - scene.numbers(keys["Basis"].data, "co", 3),
                                   np.tile([0, 0.5, 0], (2946, 1)), atol=1e-5)

    def test_weights_go_to_the_other_side_of_a_posed_model_and_change_their_names(self):
        self.open("bear_posed.obj")
        self.mirror_map()
        partner = self.partner()
        right = np.flatnonzero((partner >= 0) & (partner != np.arange(2946)) & (self.rest[:, 0] > 0))
        group = self.bear.vertex_groups.new(name="Arm.R")
        for vertex in right[::3].tolist():
            group.add([vertex], (vertex + 1) / 4096, "REPLACE")
        self.settings.symmetrize_positions = False
        self.call(bpy.ops.quadmatch.symmetrize)
        here, there = scene.weights(self.bear, "Arm.R"), scene.weights(self.bear, "Arm.L")
        np.testing.assert_array_equal(there[partner[right]], here[right])
        self.assertTrue(np.isnan(there[right]).all())

    def test_a_selection_goes_to_the_other_side(self):
        self.open("bear_posed.obj")
        self.mirror_map()
        partner = self.partner()
        vertex = int(np.flatnonzero((partner >= 0) & (self.rest[:, 0] > 0.3))[0])
        chosen = np.zeros(2946, bool)
        chosen[vertex] = True
        for elements in (self.bear.data.polygons, self.bear.data.edges):
            elements.foreach_set("select", np.zeros(len(elements), bool))
        self.bear.data.vertices.foreach_set("select", chosen)
        self.settings.symmetrize_positions, self.settings.symmetrize_groups, self.settings.symmetrize_selection = False, False, True
        self.call(bpy.ops.quadmatch.symmetrize)
        self.assertEqual(set(np.flatnonzero(scene.numbers(self.bear.data.vertices, "select", 1, bool))), {vertex, int(partner[vertex])})

    def test_a_hand_that_reaches_across_the_middle_stays_on_its_side(self):
        self.open("bear.obj")
        arrays = arrays_of(self.bear.data, edges=True)
        mirror = engine.symmetry(arrays, "Bear", True, lambda matched, most: True)
        at_rest = sides_of_faces(arrays, mirror, "+x")
        self.assertGreater((at_rest == np.sign(arrays.centres[:, 0])).mean(), 0.9)
        across = arrays.positions.copy()
        hand = across[:, 0] > 0.9 * across[:, 0].max()
        across[hand, 0] -= np.float32(2.5) * across[:, 0].max()  # farther than the other hand
        posed = dataclasses.replace(arrays, positions=across)
        self.assertGreater((posed.centres[at_rest > 0, 0] < -0.1).sum(), 20)
        np.testing.assert_array_equal(sides_of_faces(posed, mirror, "+x"), at_rest)
        np.testing.assert_array_equal(sides_of_faces(posed, mirror, "-x"), -at_rest)

    def test_positions_of_a_posed_model_are_refused(self):
        self.open("bear_posed.obj")
        self.assertRefused(bpy.ops.quadmatch.symmetrize, "Bear is posed, the best plane misses by ", self.bear)

    def test_without_an_active_object_it_is_refused(self):
        bpy.context.view_layer.objects.active = None
        self.assertRefused(bpy.ops.quadmatch.mirror_map, "no object is active; select one")

    def test_a_mesh_of_several_users_is_refused(self):
        self.open("bear.obj")
        scene.add_object("Twin", self.bear.data)
        for operator in (bpy.ops.quadmatch.mirror_map, bpy.ops.quadmatch.symmetrize):
            self.assertRefused(operator, "2 users", self.bear)
