"""Transfer on edited characters, with data made by formula from the numbers of vertices, corners, edges and faces."""
import bmesh
import bpy
import numpy as np

import scene
from case import Case

LEAST_EXACT = 0.99
EDITS = ["delete:30", "extrude:20", "loop:1", "renumber"]


def dressed(obj):
    """Give an object one of everything; no two vertices, corners or edges have the same."""
    mesh = obj.data
    vertices, corners, edges = len(mesh.vertices), len(mesh.loops), len(mesh.edges)
    uv = mesh.uv_layers.new(name="Layout", do_init=False)
    uv.data.foreach_set("uv", np.stack([np.arange(corners), np.arange(corners)[::-1]], axis=1).astype(np.float32).ravel())
    for name, step in (("Arm.L", 1), ("Arm.R", 2)):
        group = obj.vertex_groups.new(name=name)
        for vertex in range(0, vertices, step):
            group.add([vertex], (vertex + 1) / (vertices + 1), "REPLACE")
    obj.shape_key_add(name="Basis")
    smile = obj.shape_key_add(name="Smile")
    smile.data.foreach_set("co", smiling(scene.numbers(mesh.vertices, "co", 3), np.arange(vertices)).ravel())
    tint = mesh.color_attributes.new("Tint", "FLOAT_COLOR", "POINT")
    tint.data.foreach_set("color", np.arange(4 * vertices, dtype=np.float32))
    paint = mesh.color_attributes.new("Paint", "BYTE_COLOR", "CORNER")
    paint.data.foreach_set("color_srgb", (np.arange(4 * corners) % 251 / 255).astype(np.float32))
    for name in ("Skin", "Cloth"):
        mesh.materials.append(bpy.data.materials.new(name))
    mesh.polygons.foreach_set("material_index", np.arange(len(mesh.polygons), dtype=np.int32) % 2)
    mesh.edges.foreach_set("use_seam", np.arange(edges) % 3 == 0)
    mesh.edges.foreach_set("use_edge_sharp", np.arange(edges) % 5 == 0)
    mesh.edges.foreach_set("crease", (np.arange(edges) % 256 / 255).astype(np.float32))


def smiling(basis, number):
    """The shape key at the vertices of these numbers, where they are at `basis`: a power of two, so that sums are exact enough to compare."""
    return basis + np.float32(0.25) * (np.float32(1) + (number % 7).astype(np.float32))[:, None]


class Carried:
    """Shares of the survivors that have their own value, and those that have another one than they had or should have."""

    def __init__(self, before, source, target, pairs):
        there = pairs[:, 1]
        right = _equal(target[there], source[pairs[:, 0]])
        untouched = _equal(target[there], before[there]) if before is not None else ~right & False
        self.exact = right.mean()
        self.wrong = int((~right & ~untouched).sum())


def _equal(one, other):
    same = (one == other) | ((one != one) & (other != other))
    return same.all(axis=1) if same.ndim > 1 else same


class Transfer(Case):
    def check(self, path, edits, seed):
        source, target, truth = scene.edited(path, edits, seed)
        dressed(source)
        self.pick(source, target)
        bare, untouched = scene.all_of(target), scene.all_of(source)
        basis = scene.numbers(target.data.vertices, "co", 3)
        bpy.ops.ed.undo_push(message="before")
        self.call(bpy.ops.quadmatch.transfer)
        source, target = bpy.data.objects["Source"], bpy.data.objects["Target"]
        self.assertSame(scene.all_of(source), untouched)
        for name, carried in self.compared(source, target, basis, truth).items():
            print(f"{path.parent.name}/{path.name}, {name}: {carried.exact:.2%} exact, {carried.wrong} wrong")
            with self.subTest(data=name):
                self.assertGreaterEqual(carried.exact, LEAST_EXACT)
                self.assertEqual(carried.wrong, 0)
        self.assertEqual([slot.material.name for slot in target.material_slots], ["Skin", "Cloth"])
        dressed_now = scene.all_of(target)

        bpy.ops.ed.undo()
        self.assertSame(scene.all_of(bpy.data.objects["Target"]), bare)
        self.assertSame(scene.all_of(bpy.data.objects["Source"]), untouched)
        bpy.ops.ed.redo()
        self.assertSame(scene.all_of(bpy.data.objects["Target"]), dressed_now)

    def compared(self, source, target, basis, truth):
        """By kind of data. What the target had before is what Blender puts into new layers."""
        def at(name, get, pairs, empty=0.0):
            here, there = get(source), get(target)
            return name, Carried(np.full_like(there, empty), here, there, pairs)

        compared = dict([
            at("UV map", lambda o: scene.numbers(o.data.uv_layers["Layout"].data, "uv", 2), truth.corners),
            at("weights", lambda o: scene.weights(o, "Arm.L"), truth.vertices, np.nan),
            at("thin weights", lambda o: scene.weights(o, "Arm.R"), truth.vertices, np.nan),
            at("colours at vertices", lambda o: scene.numbers(o.data.color_attributes["Tint"].data, "color", 4), truth.vertices, 1),
            at("colours at corners", lambda o: scene.numbers(o.data.color_attributes["Paint"].data, "color_srgb", 4), truth.corners, 1),
            at("materials", lambda o: scene.numbers(o.data.polygons, "material_index", 1, np.int32), truth.faces),
            at("seams", lambda o: scene.numbers(o.data.edges, "use_seam", 1, bool), truth.edges),
            at("sharp edges", lambda o: scene.numbers(o.data.edges, "use_edge_sharp", 1, bool), truth.edges),
            at("creases", lambda o: scene.numbers(o.data.edges, "crease"), truth.edges)])
        # Shape keys are displacements: the truth is the target's own shape, moved as the source's vertex is.
        moved = np.round((scene.numbers(target.data.shape_keys.key_blocks["Smile"].data, "co", 3) - basis) * 64) / 64
        number = np.arange(len(source.data.vertices))
        compared["shape keys"] = Carried(np.zeros_like(moved), smiling(np.zeros((len(number), 3), np.float32), number), moved, truth.vertices)
        return compared

    def test_an_edited_bear_gets_everything_back_and_undo_takes_it_away(self):
        self.check(scene.ROOT / "examples" / "bear.obj", EDITS, 3)

    def test_an_edited_toy_dog_gets_everything_back_and_undo_takes_it_away(self):
        self.check(scene.ROOT / "examples" / "dog_toy.obj", ["extrude:12", "collapse:3", "refine:9", "renumber"], 2)

    def test_an_edited_body_gets_everything_back_and_undo_takes_it_away(self):
        self.check(self.shared("mh_male_generic_muscle"), EDITS, 5)

    def test_an_edited_running_woman_gets_everything_back_and_undo_takes_it_away(self):
        self.check(self.shared("qt_woman_running_sitting"), EDITS, 2)

    def shared(self, pair):
        path = scene.SHARED / "pairs" / pair / "a.obj"
        if not path.exists():
            self.skipTest(f"{path} is not there: it is no file of this project")
        return path


def copy_of(obj, name, positions=None, number=None, turned=False):
    """An object of the same connectivity: vertex v is vertex number[v] of it."""
    old = scene.numbers(obj.data.vertices, "co", 3)
    number = np.arange(len(old)) if number is None else number
    new = np.empty_like(old)
    new[number] = old if positions is None else positions
    faces = [[int(number[v]) for v in polygon.vertices] for polygon in obj.data.polygons]
    return scene.add(name, new, [face[::-1] for face in faces] if turned else faces)


class Kinds(Case):
    """What each kind of data does on copies of the bear."""

    def setUp(self):
        super().setUp()
        self.source = scene.load(scene.ROOT / "examples" / "bear.obj", "Source")
        self.basis = scene.numbers(self.source.data.vertices, "co", 3)

    def transfer(self, target, *kinds):
        self.pick(self.source, target)
        for kind in ("uv", "groups", "shapes", "colours", "materials", "edges", "order"):
            setattr(self.settings, kind, kind in kinds)
        return self.call(bpy.ops.quadmatch.transfer)

    def smiles(self):
        """A shape key with displacements along x."""
        self.source.shape_key_add(name="Basis")
        smile = self.source.shape_key_add(name="Smile")
        self.moves = np.zeros_like(self.basis)
        self.moves[:, 0] = 0.25
        smile.data.foreach_set("co", (self.basis + self.moves).ravel())
        smile.slider_max = 3
        smile.value = 2

    def displacements(self, obj, name="Smile"):
        keys = obj.data.shape_keys.key_blocks
        return scene.numbers(keys[name].data, "co", 3) - scene.numbers(keys[name].relative_key.data, "co", 3)

    def test_a_shape_key_keeps_the_pose_of_the_target(self):
        self.smiles()
        posed = scene.load(scene.ROOT / "examples" / "bear_posed.obj", "Target")
        before = scene.numbers(posed.data.vertices, "co", 3)
        self.transfer(posed, "shapes")
        np.testing.assert_allclose(self.displacements(posed), self.moves, atol=1e-6)
        np.testing.assert_array_equal(scene.numbers(posed.data.vertices, "co", 3), before)
        key = posed.data.shape_keys.key_blocks["Smile"]
        self.assertEqual((key.slider_max, key.value), (3, 2))

    def test_a_shape_key_grows_with_the_target(self):
        self.smiles()
        lines = self.transfer(copy_of(self.source, "Target", 100 * self.basis), "shapes")
        np.testing.assert_allclose(self.displacements(bpy.data.objects["Target"]), 100 * self.moves, atol=1e-3)
        self.assertIn("Shape keys are scaled by 100, as the target is", lines)

    def test_a_shape_key_is_mirrored_with_the_target(self):
        self.smiles()
        self.settings.orientation = "reversing"
        mirrored = copy_of(self.source, "Target", self.basis * np.float32([-1, 1, 1]), turned=True)
        lines = self.transfer(mirrored, "shapes")
        np.testing.assert_allclose(self.displacements(mirrored), -self.moves, atol=1e-5)
        self.assertIn("Shape keys are mirrored, as the target is", lines)

    def test_a_shape_key_is_left_out_where_the_target_is_mirrored_and_posed(self):
        self.smiles()
        self.settings.orientation = "reversing"
        posed = scene.numbers(scene.load(scene.ROOT / "examples" / "bear_posed.obj", "Posed").data.vertices, "co", 3)
        target = copy_of(self.source, "Target", posed * np.float32([-1, 1, 1]), turned=True)
        lines = self.transfer(target, "shapes")
        self.assertTrue(any("lie turned over and posed" in line for line in lines), lines)
        np.testing.assert_array_equal(self.displacements(target), 0 * self.moves)

    def test_a_shape_key_may_be_relative_to_another_one(self):
        self.smiles()
        wide = self.source.shape_key_add(name="Wide")
        wide.relative_key = self.source.data.shape_keys.key_blocks["Smile"]
        wide.data.foreach_set("co", (self.basis + 3 * self.moves).ravel())
        target = copy_of(self.source, "Target", self.basis + np.float32(1))
        self.transfer(target, "shapes")
        self.assertEqual(target.data.shape_keys.key_blocks["Wide"].relative_key.name, "Smile")
        np.testing.assert_allclose(self.displacements(target, "Wide"), 2 * self.moves, atol=1e-5)

    def test_weights_that_the_source_has_not_are_taken_away_and_other_groups_stay(self):
        self.source.vertex_groups.new(name="Arm").add([5], 0.5, "REPLACE")
        target = copy_of(self.source, "Target")
        target.vertex_groups.new(name="Mine").add([5, 6], 0.75, "REPLACE")
        target.vertex_groups.new(name="Arm").add([6], 1.0, "REPLACE")
        self.transfer(target, "groups")
        self.assertEqual([g.name for g in target.vertex_groups], ["Mine", "Arm"])
        self.assertEqual(np.flatnonzero(~np.isnan(scene.weights(target, "Arm"))).tolist(), [5])
        self.assertEqual(np.flatnonzero(~np.isnan(scene.weights(target, "Mine"))).tolist(), [5, 6])

    def test_the_order_of_the_source_comes_back_and_all_data_go_with_it(self):
        number = np.random.default_rng(1).permutation(len(self.basis))
        target = copy_of(self.source, "Target", number=number)
        target.vertex_groups.new(name="Mine").add([int(number[7])], 0.5, "REPLACE")
        target.shape_key_add(name="Basis")
        target.shape_key_add(name="Up").data[int(number[7])].co.z += 1
        target.modifiers.new("Hook", "HOOK").vertex_indices_set([int(number[7])])
        self.transfer(target, "order")
        np.testing.assert_array_equal(scene.numbers(target.data.vertices, "co", 3), self.basis)
        self.assertEqual([set(p.vertices) for p in target.data.polygons], [set(p.vertices) for p in self.source.data.polygons])
        self.assertEqual(np.flatnonzero(~np.isnan(scene.weights(target, "Mine"))).tolist(), [7])
        self.assertEqual(np.flatnonzero(self.displacements(target, "Up")[:, 2]).tolist(), [7])

    def test_ambiguous_parts_are_left_out_and_named_unless_they_are_asked_for(self):
        # A square fits in four ways. It is far off, so that positions do not choose.
        self.source, target = scene.grid("Source", 4, 4), scene.grid("Target", 4, 4)
        self.settings.positions = False
        self.source.data.uv_layers.new(name="Layout")
        self.pick(self.source, target)
        self.assertRefused(bpy.ops.quadmatch.transfer, "no part is the same beyond doubt", target)
        self.settings.allow_ambiguous = True
        self.assertIn("16 of Target's 16 faces", self.transfer(target, "uv")[0])

    def test_a_region_of_too_little_confidence_is_left_out(self):
        target = scene.load(scene.ROOT / "examples" / "bear_no_ears_posed.obj", "Target")
        self.source.vertex_groups.new(name="Arm").add(range(100), 1.0, "REPLACE")
        self.settings.min_confidence = 1.0
        self.pick(self.source, target)
        self.assertRefused(bpy.ops.quadmatch.transfer, "no part is the same beyond doubt", target)

    def test_a_target_that_was_edited_since_the_last_match_is_matched_anew(self):
        self.source.vertex_groups.new(name="Arm").add([5], 0.5, "REPLACE")
        target = copy_of(self.source, "Target")
        self.transfer(target, "groups")
        number = np.arange(len(self.basis))[::-1]
        other = copy_of(self.source, "Other", number=number)
        target.data = other.data
        bpy.data.objects.remove(other)
        self.transfer(target, "groups")
        self.assertEqual(np.flatnonzero(~np.isnan(scene.weights(target, "Arm"))).tolist(), [int(number[5])])

    def test_other_options_make_another_match(self):
        self.source.vertex_groups.new(name="Arm").add([5], 0.5, "REPLACE")
        target = copy_of(self.source, "Target")
        self.assertIn("2,944 of", self.transfer(target, "groups")[0])
        self.settings.orientation = "reversing"
        self.assertNotIn("2,944 of", self.transfer(target, "groups")[0])

    def test_a_mirrored_copy_takes_seams_and_corners_the_other_way_round(self):
        self.settings.orientation = "reversing"
        mesh = self.source.data
        mesh.edges.foreach_set("use_seam", np.arange(len(mesh.edges)) % 3 == 0)
        layer = mesh.uv_layers.new(name="Layout", do_init=False)
        vertex = scene.numbers(mesh.loops, "vertex_index", 1, np.int32)
        face = np.repeat(np.arange(len(mesh.polygons)), 4)
        layer.data.foreach_set("uv", np.stack([vertex, face], axis=1).astype(np.float32).ravel())
        target = copy_of(self.source, "Target", self.basis * np.float32([-1, 1, 1]), turned=True)
        self.transfer(target, "uv", "edges")
        there = scene.numbers(target.data.uv_layers["Layout"].data, "uv", 2)
        np.testing.assert_array_equal(there[:, 0], scene.numbers(target.data.loops, "vertex_index", 1, np.int32))
        np.testing.assert_array_equal(there[:, 1], face)
        self.assertEqual(self.seams(target), self.seams(self.source))

    @staticmethod
    def seams(obj):
        return {frozenset(edge.vertices) for edge in obj.data.edges if edge.use_seam}

    def test_faces_of_any_size_take_their_corners_along(self):
        self.source, target = scene.mixed_pair()
        layer = self.source.data.uv_layers.new(name="Layout", do_init=False)
        layer.data.foreach_set("uv", np.repeat(np.arange(12, dtype=np.float32), 2))
        self.transfer(target, "uv")
        there = scene.numbers(target.data.uv_layers["Layout"].data, "uv", 2)[:, 0]
        # Vertex v of the source is 6 - v of the target; faces are pentagon, triangle, square here.
        self.assertEqual(there.tolist(), [10, 11, 7, 8, 9, 0, 1, 2, 5, 6, 3, 4])

    def test_a_hidden_target_takes_data_and_stays_hidden(self):
        self.source.vertex_groups.new(name="Arm").add([5], 0.5, "REPLACE")
        target = copy_of(self.source, "Target")
        target.hide_set(True)
        self.transfer(target, "groups")
        self.assertTrue(target.hide_get())
        self.assertEqual(np.flatnonzero(~np.isnan(scene.weights(target, "Arm"))).tolist(), [5])

    def test_modifiers_stay_and_what_lies_beneath_them_is_matched(self):
        self.source.vertex_groups.new(name="Arm").add([5], 0.5, "REPLACE")
        target = copy_of(self.source, "Target")
        target.modifiers.new("Finer", "SUBSURF")
        lines = self.transfer(target, "groups")
        self.assertEqual([m.name for m in target.modifiers], ["Finer"])
        self.assertEqual(np.flatnonzero(~np.isnan(scene.weights(target, "Arm"))).tolist(), [5])
        self.assertIn("Target: what lies beneath the modifiers is matched and changed (Finer)", lines)

    def test_what_was_edited_in_edit_mode_counts_and_edit_mode_goes_on(self):
        self.source.vertex_groups.new(name="Arm").add(range(len(self.basis)), 0.5, "REPLACE")
        target = copy_of(self.source, "Target")
        bpy.context.view_layer.objects.active = target
        target.select_set(True)
        bpy.ops.object.mode_set(mode="EDIT")
        self.source.select_set(True)
        mesh = bmesh.from_edit_mesh(target.data)
        mesh.faces.ensure_lookup_table()
        bmesh.ops.delete(mesh, geom=[mesh.faces[100]], context="FACES_ONLY")
        lines = self.transfer(target, "groups")
        self.assertEqual((self.source.mode, target.mode), ("OBJECT", "EDIT"))
        self.assertTrue(self.source.select_get() and target.select_get())
        self.assertIn("2,943 faces", lines[0])
        bpy.ops.object.mode_set(mode="OBJECT")
        self.assertEqual(len(target.data.polygons), 2943)
        self.assertEqual(int((scene.weights(target, "Arm") == 0.5).sum()), len(self.basis))
