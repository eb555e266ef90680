"""Selections of meshes in object mode, and edit mode on several objects."""
import bpy
import numpy as np

from .mesh_arrays import edge_vertices, edges_of, read


def select_faces(mesh, arrays, faces):
    """Select these faces (bool for each) and nothing else. Hidden ones stay unselected; returns how many those are."""
    faces = np.asarray(faces, bool)
    hidden = read(mesh.polygons, "hide", arrays.face_count, bool)
    seen = faces & ~hidden
    at_corner = np.repeat(seen, arrays.sizes)
    vertices = np.zeros(arrays.vertex_count, bool)
    vertices[arrays.corners[at_corner]] = True
    edges = np.zeros(len(mesh.edges), bool)
    edges[edges_of(mesh)[at_corner]] = True
    mesh.polygons.foreach_set("select", seen)
    mesh.vertices.foreach_set("select", vertices)
    mesh.edges.foreach_set("select", edges)
    mesh.update()
    return int((faces & hidden).sum())


def select_vertices(mesh, arrays, vertices):
    """Select these vertices and nothing else, and edges and faces all of whose vertices are."""
    vertices = np.asarray(vertices, bool) & ~read(mesh.vertices, "hide", arrays.vertex_count, bool)
    mesh.vertices.foreach_set("select", vertices)
    mesh.edges.foreach_set("select", vertices[edge_vertices(mesh)].all(axis=1))
    mesh.polygons.foreach_set("select", np.logical_and.reduceat(vertices[arrays.corners], arrays.starts))
    mesh.update()


def edit(context, objects, active, elements, step):
    """Enter edit mode on the objects that can be seen, in the mode of "FACE" or "VERT". Returns the names of the others.

    What was done before is a step of its own to undo, called `step`: Blender does not go back over the border of edit mode
    in one.
    """
    seen = [obj for obj in objects if obj.visible_get()]
    hidden = [obj.name for obj in objects if obj not in seen]
    if not seen:
        return hidden
    if context.view_layer.objects.active and context.view_layer.objects.active.mode != "OBJECT":
        bpy.ops.object.mode_set(mode="OBJECT")
    bpy.ops.ed.undo_push(message=step)
    for obj in context.view_layer.objects:
        obj.select_set(obj in seen)
    context.view_layer.objects.active = active if active in seen else seen[0]
    context.tool_settings.mesh_select_mode = (elements == "VERT", False, elements == "FACE")
    bpy.ops.object.mode_set(mode="EDIT")
    return hidden
