"""What will not do is refused with a plain sentence, and nothing is changed."""
import bpy
import numpy as np

import scene
from case import Case


class BadInput(Case):
    def setUp(self):
        super().setUp()
        self.source, self.target = scene.grid("Source", 3, 2), scene.grid("Target", 3, 2)
        self.pick(self.source, self.target)
        self.source.vertex_groups.new(name="Arm").add([1], 0.5, "REPLACE")

    def both_refuse(self, sentence):
        for operator in (bpy.ops.quadmatch.match, bpy.ops.quadmatch.transfer, bpy.ops.quadmatch.diff):
            self.assertRefused(operator, sentence, self.source, self.target)

    def test_nothing_picked(self):
        self.pick(None, None)
        self.both_refuse("select two objects")

    def test_only_a_source_picked(self):
        self.pick(self.source, None)
        self.both_refuse("pick a target in the panel as well")

    def test_the_same_object_twice(self):
        self.pick(self.source, self.source)
        self.both_refuse("Source is source and target")

    def test_a_mesh_without_faces(self):
        self.pick(self.source, scene.add("Wire", [(0, 0, 0), (1, 0, 0)], []))
        self.both_refuse("Wire has no faces")

    def test_an_object_that_is_no_mesh(self):
        light = scene.add_object("Lamp", bpy.data.lights.new("Lamp", "POINT"))
        self.pick(None, None)
        for obj in (self.source, light):
            obj.select_set(True)
        bpy.context.view_layer.objects.active = light
        self.assertRefused(bpy.ops.quadmatch.match, "Lamp is no mesh but of type light", self.source)

    def test_two_objects_of_one_mesh(self):
        self.pick(self.source, scene.add_object("Twin", self.source.data))
        self.both_refuse("two objects of one mesh")

    def test_a_mesh_of_several_users(self):
        scene.add_object("Twin", self.target.data)
        self.both_refuse("the mesh Target of Target has 2 users, and all would change; make it single-user")

    def test_a_source_of_several_users_is_read_all_the_same(self):
        scene.add_object("Twin", self.source.data)
        self.call(bpy.ops.quadmatch.transfer)

    def test_a_fake_user_does_not_count(self):
        self.target.data.use_fake_user = True
        self.call(bpy.ops.quadmatch.transfer)

    def test_linked_data(self):
        scene.FOLDER.mkdir(parents=True, exist_ok=True)
        path = str(scene.FOLDER / "library.blend")
        bpy.data.libraries.write(path, {self.target})
        bpy.data.objects.remove(self.target)
        with bpy.data.libraries.load(path, link=True) as (_, wanted):
            wanted.objects = ["Target"]
        self.target = wanted.objects[0]
        bpy.context.scene.collection.objects.link(self.target)
        self.pick(self.source, self.target)
        self.both_refuse("Target is linked from library.blend and cannot be changed here; make it local")

    def test_a_position_that_is_no_number(self):
        self.target.data.vertices[3].co.x = float("nan")
        self.both_refuse("Target has a vertex whose position is not a finite number")

    def test_an_attribute_in_the_way(self):
        self.target.data.attributes.new("quadmatch", "FLOAT", "POINT")
        self.assertRefused(bpy.ops.quadmatch.match, "Target has another attribute called quadmatch; rename it", self.source, self.target)

    def test_nothing_to_transfer(self):
        for kind in ("uv", "groups", "shapes", "colours", "materials", "edges", "order"):
            setattr(self.settings, kind, False)
        self.assertRefused(bpy.ops.quadmatch.transfer, "nothing is to be transferred; tick what is", self.source, self.target)

    def test_nothing_in_common(self):
        self.pick(self.source, scene.add("Triangle", [(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)]))
        self.assertRefused(bpy.ops.quadmatch.transfer, "no faces are the same", self.source)

    def test_faces_in_another_order_than_their_corners(self):
        polygons = self.target.data.polygons
        polygons[0].loop_start, polygons[1].loop_start = 4, 0
        self.both_refuse("the mesh Target keeps its faces in another order than their corners; enter edit mode and leave it once")

    def test_a_mesh_of_several_users_is_matched_if_nothing_is_written(self):
        scene.add_object("Twin", self.target.data)
        self.settings.colour, self.settings.select = "none", False
        self.call(bpy.ops.quadmatch.match)

    def test_an_object_outside_the_view_layer(self):
        bpy.context.scene.collection.objects.unlink(self.target)
        self.both_refuse("Target is not in this view layer")


class Scales(Case):
    """Scales of objects are no obstacle, but are spoken of."""

    def setUp(self):
        super().setUp()
        self.source = scene.load(scene.ROOT / "examples" / "bear.obj", "Source")
        self.target = scene.load(scene.ROOT / "examples" / "bear.obj", "Target")
        self.source.vertex_groups.new(name="Arm").add([5], 0.5, "REPLACE")
        self.pick(self.source, self.target)
        self.settings.select = False

    def test_different_scales_do_not_matter_and_are_named(self):
        self.target.scale = (100, 100, 100)
        bpy.context.view_layer.update()
        lines = self.call(bpy.ops.quadmatch.transfer)
        self.assertIn("scales are different (1 and 100); meshes are compared without the objects' scales", lines)
        self.assertEqual(np.flatnonzero(~np.isnan(scene.weights(self.target, "Arm"))).tolist(), [5])

    def test_a_negative_scale_is_named_and_data_go_by_the_meshes(self):
        self.target.scale = (-1, 1, 1)
        bpy.context.view_layer.update()
        lines = self.call(bpy.ops.quadmatch.transfer)
        self.assertTrue(any(line.startswith("Target has a negative scale, so it is seen mirrored") for line in lines), lines)
        self.assertEqual(np.flatnonzero(~np.isnan(scene.weights(self.target, "Arm"))).tolist(), [5])

    def test_the_orientation_is_that_of_what_is_seen(self):
        self.target.scale = (-1, 1, 1)
        bpy.context.view_layer.update()
        self.settings.orientation = "reversing"  # seen as a mirror image, so stored alike
        self.assertFalse(any("turned over" in line for line in self.call(bpy.ops.quadmatch.match)))
        self.settings.orientation = "preserving"
        self.assertTrue(any("faces lie turned over" in line for line in self.call(bpy.ops.quadmatch.match)))
