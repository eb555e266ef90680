"""Who matches: the library inside the add-on, or else the command line program."""
import dataclasses

import numpy as np

from . import found, library, program
from .refusal import Cancelled, Refusal


@dataclasses.dataclass(frozen=True)
class Options:
    orientation: str = "auto"  #: "auto", "preserving" or "reversing", of the meshes as they are stored
    positions: bool = True
    anchors: tuple = ()  #: rows: source face, corner, target face, corner

    def arguments(self):
        """For the program."""
        words = ["--orientation", self.orientation] + ([] if self.positions else ["--no-positions"])
        for a, b, c, d in self.anchors:
            words += ["--anchor", f"{a}:{b}={c}:{d}"]
        return words


def program_path():
    from .preferences import preferred_program
    return program.find(preferred_program())


def state():
    """Who works, and what keeps the library from it: two sentences, the second may be empty."""
    if library.load():
        return f"quadmatch {library.load().__version__}", ""
    path = program_path()
    if path:
        return f"the program {path} is used", library.reason()
    return ("neither is the program quadmatch on PATH; install it, or say in the add-on's preferences where it is",
            library.reason())


def _required_program():
    path = program_path()
    if not path:
        raise Refusal(f"{library.reason()}; the program quadmatch would do as well, but it is not on PATH nor set in "
                      "the add-on's preferences")
    return path


def _mesh(quadmatch, name, arrays):
    corners = arrays.corners
    faces = corners.reshape(-1, 4) if arrays.all_quads else (np.append(arrays.starts, len(corners)), corners)
    try:
        return quadmatch.Mesh(arrays.positions, faces, name=name)
    except ValueError as error:
        raise Refusal(str(error)) from error


def _match_by_program(source, target, options, progress):
    """The object in a match file."""
    return program.run(_required_program(), "match", {"source": source, "target": target},
                       [*options.arguments(), "--quiet", "-o", "match.json"], progress, written="match.json")


def match(source, target, names, options, progress):
    """Found. progress(matched, most): False cancels."""
    if library.load() is None:
        return found.from_match_file(_match_by_program(source, target, options, progress))
    return found.from_library(_match_by_library(_meshes(names, source, target), options, progress))


def _meshes(names, *arrays):
    return [_mesh(library.load(), name, mesh) for name, mesh in zip(names, arrays)]


def _match_by_library(meshes, options, progress):
    """quadmatch.Match."""
    try:
        made = library.load().match(*meshes, orientation=options.orientation, positions=options.positions,
                                    anchors=options.anchors, progress=progress)
    except ValueError as error:
        raise Refusal(str(error)) from error
    if not made.complete:
        raise Cancelled()
    return made


@dataclasses.dataclass(frozen=True)
class Mirror:
    """The mirror of a mesh."""
    found: found.Found  #: the mesh on itself
    mirrors: int  #: how many fit as well, this one included; 0: none was found
    line_vertices: np.ndarray
    line_faces: np.ndarray
    unpaired_faces: np.ndarray
    plane: object  #: (normal, offset, error as a share of the size, does it fit), or None

    def vertex_map(self, count):
        partner = np.full(count, -1, np.int32)
        partner[self.found.vertices[:, 0]] = self.found.vertices[:, 1]
        return partner

    def face_map(self, count):
        partner = np.full(count, -1, np.int32)
        for region in self.found.regions:
            partner[region.faces[:, 0]] = region.faces[:, 1]
        return partner


def symmetry(arrays, name, positions, progress):
    """The Mirror of a mesh."""
    quadmatch = library.load()
    if quadmatch is None:
        return _mirror_by_program(arrays, positions, progress)
    made = quadmatch.symmetry(_mesh(quadmatch, name, arrays), positions=positions, progress=progress)
    if not made.complete:
        raise Cancelled()
    plane = made.plane and (np.array(made.plane.normal), made.plane.offset, made.plane.error, made.plane.fits)
    return Mirror(found.from_library(made.match), made.mirrors, np.array(made.line.vertices), np.array(made.line.faces),
                  np.array(made.unpaired_faces), plane)


def _mirror_by_program(arrays, positions, progress):
    data = program.run(_required_program(), "symmetry", {"mesh": arrays},
                       ["-o", "map.json", "--quiet", *([] if positions else ["--no-positions"])], progress, written="map.json")
    said = data["symmetry"]
    plane, line = said["plane"], said["centre_line"]
    plane = plane and (np.array(plane["normal"]), plane["offset"], plane["error"], plane["fits"])
    return Mirror(found.from_match_file(data), said["mirrors"], np.array(line["vertices"], np.int32),
                  np.array(line["faces"], np.int32), np.array(said["unpaired"]["faces"], np.int32), plane)


@dataclasses.dataclass(frozen=True)
class Change:
    """One area that is different: what it is called, and the faces that came, went, or have other neighbours."""
    kind: str
    source_faces: np.ndarray
    target_faces: np.ndarray
    rejoined: np.ndarray  #: of the source


@dataclasses.dataclass(frozen=True)
class Differences:
    changes: tuple
    moved: np.ndarray  #: (K, 2): vertices of the source and the target that are elsewhere
    match: found.Found


def diff(source, target, names, options, tolerance, progress):
    """What was changed from source to target, the largest change first."""
    quadmatch = library.load()
    if quadmatch is None:
        return _diff_by_program(source, target, options, tolerance, progress)
    meshes = _meshes(names, source, target)
    made = _match_by_library(meshes, options, progress)
    said = quadmatch.diff(*meshes, made, tolerance=tolerance)
    changes = tuple(Change(change.kind, change.source_faces, change.target_faces, change.rejoined)
                    for change in said.changes)
    return Differences(changes, said.moved, found.from_library(made))


def _diff_by_program(source, target, options, tolerance, progress):
    made = _match_by_program(source, target, options, progress)
    data = program.run(_required_program(), "diff", {"source": source, "target": target},
                       ["--json", "--match", "match.json", "--tolerance", repr(tolerance)], progress,
                       given={"match.json": made})
    keys = "source_faces", "target_faces", "rejoined_source_faces"
    changes = tuple(Change(row["kind"], *(np.array(row[key], np.int32) for key in keys)) for row in data["changes"])
    return Differences(changes, np.array(data["moved"], np.int32).reshape(-1, 2), found.from_match_file(made))
