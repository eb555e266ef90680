"""Removed rows of quads: all removals that leave the very same mesh, and what of the truth they agree on."""
import random

from parts.subjects import tool


def faces_of(mesh):
    """The faces, whatever order they are in and whichever corner they start at."""
    return {min(face[k:] + face[:k] for k in range(len(face))) for face in mesh.faces}


def copy_of(mesh):
    copy = tool("edit_mesh").EditableMesh(mesh.positions, mesh.faces, None)
    copy.origins = list(mesh.origins)
    return copy


def rows_ending(mesh, gone):
    """Every way to remove a row of quads so that only vertices of `gone` go: which vertex each becomes, and the faces."""
    found = {}
    for start, face in enumerate(mesh.faces):
        if len(face) != 4 or gone.isdisjoint(face):
            continue
        for corner in range(4):
            chord = mesh.chord(start, corner)
            if not chord:
                continue
            images = {}
            for index, entry in chord[0]:
                a, b, c, d = (mesh.faces[index][(entry + step) % 4] for step in range(4))
                images[b], images[c] = a, d
            if gone.issuperset(images) and not set(images) & set(images.values()):
                found[tuple(sorted(images.items()))] = (images, {index for index, _ in chord[0]})
    return list(found.values())


def removals(mesh, edited, gone):
    """All meshes with the faces of `edited` that are made by removing rows, with their own origins of faces."""
    if len(mesh.faces) <= len(edited):
        return [mesh] if faces_of(mesh) == edited else []
    made = []
    for images, removed in rows_ending(mesh, gone):
        copy = copy_of(mesh)
        copy.substitute(images)
        copy.replace(removed, [])
        made += removals(copy, edited, gone - set(images))
    return made


def values_at(mesh, texture):
    """What a face and one of its vertices get where each face keeps what it had."""
    values = {}
    for face, (source, first) in zip(mesh.faces, mesh.origins):
        key = min(face[k:] + face[:k] for k in range(len(face)))
        for corner, vertex in enumerate(face):
            values[key, vertex] = texture[source][(first + corner) % len(face)]
    return values


def known_corners(positions, faces, texture, edits, seed):
    """Corners of surviving faces, as (face, corner), that have the same texture coordinate whichever of the removals that
    make this very mesh was meant; of edits that remove rows and do nothing else."""
    editor = tool("edit_mesh")
    meant = editor.EditableMesh(positions, faces, random.Random(seed))
    for edit in edits:
        name, _, size = edit.partition(":")
        editor.EDITS[name](meant, int(size))
    gone = {vertex for face in faces for vertex in face} - {vertex for face in meant.faces for vertex in face}
    base = editor.EditableMesh(positions, faces, None)
    readings = [values_at(mesh, texture) for mesh in removals(base, faces_of(meant), gone)]
    known = set()
    for face, (source, first) in zip(meant.faces, meant.origins):
        key = min(face[k:] + face[:k] for k in range(len(face)))
        for corner, vertex in enumerate(face):
            if len({reading[key, vertex] for reading in readings}) == 1:
                known.add((source, (first + corner) % len(face)))
    return known
