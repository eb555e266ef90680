"""The panels draw in every state, with properties, operators and icons that there are."""
import types

import bpy

import scene
from case import Case
from quadmatch_addon import engine, panel

ICONS = bpy.types.UILayout.bl_rna.functions["label"].parameters["icon"].enum_items.keys()


class Layout:
    """Stands for Blender's: keeps what it is given, and complains of what Blender would complain of."""

    def __init__(self, kept):
        self._kept = kept

    def row(self, **_):
        return self

    column = box = row

    def label(self, text="", icon="NONE"):
        self._icon(icon)
        self._kept.append(text)

    def prop(self, data, name, **_):
        assert name in data.bl_rna.properties, name
        self._kept.append(name)

    def prop_enum(self, data, name, value, **_):
        assert value in data.bl_rna.properties[name].enum_items, value

    def operator(self, name, icon="NONE", **_):
        self._icon(icon)
        group, _, verb = name.partition(".")
        getattr(getattr(bpy.ops, group), verb).get_rna_type()
        self._kept.append(name)
        return types.SimpleNamespace()

    def template_list(self, kind, _, data, name, active, active_name, **__):
        assert hasattr(bpy.types, kind) and name in data.bl_rna.properties and active_name in active.bl_rna.properties
        self._kept.append(name)

    @staticmethod
    def _icon(name):
        assert name in ICONS, name


class Panel(Case):
    def drawn(self):
        """All that the panels show, from the top."""
        kept = []
        shading = next(area.spaces.active.shading for area in bpy.context.window.screen.areas if area.type == "VIEW_3D")
        # Without a window Blender has neither a sidebar nor a scale.
        scale = types.SimpleNamespace(system=types.SimpleNamespace(ui_scale=1.0))
        context = types.SimpleNamespace(scene=bpy.context.scene, preferences=scale,
                                        region=types.SimpleNamespace(width=220),
                                        space_data=types.SimpleNamespace(shading=shading))
        for kind in panel.CLASSES:
            if not hasattr(kind, "poll") or kind.poll(context):
                kind.draw(types.SimpleNamespace(layout=Layout(kept)), context)
        return kept

    def test_at_first_it_shows_what_can_be_done(self):
        kept = self.drawn()
        for operator in ("match", "transfer", "mirror_map", "symmetrize", "diff", "add_anchor"):
            self.assertIn(f"quadmatch.{operator}", kept)
        self.assertNotIn("quadmatch.select_change", kept)

    def test_afterwards_it_shows_the_report_the_changes_and_the_anchors(self):
        self.pick(*scene.mixed_pair())
        self.settings.target.data.vertices[2].co.z += 1
        self.call(bpy.ops.quadmatch.diff)
        anchor = self.settings.anchors.add()
        anchor.source, anchor.target, anchor.source_edge, anchor.target_edge = "Mixed", "Turned", (0, 1), (6, 5)
        kept = self.drawn()
        self.assertIn("quadmatch.select_change", kept)
        self.assertIn("quadmatch.remove_anchor", kept)
        self.assertIn("Mixed 0-1 = Turned 6-5", kept)
        self.assertIn("0 changes, 1 vertex moved", kept)

    def test_long_sentences_are_broken_into_lines(self):
        self.settings.report = "a sentence that is much longer than the sidebar is wide " * 3
        self.assertTrue(all(len(line) < 40 for line in self.drawn()))

    def test_it_says_why_the_module_does_not_work(self):
        why = "the module was built for another Python"
        state, engine.state = engine.state, lambda: ("the program /opt/quadmatch is used", why)
        try:
            words = " ".join(self.drawn())
        finally:
            engine.state = state
        self.assertIn("The module was built for another Python. The program /opt/quadmatch is used.", words)
