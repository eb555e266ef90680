"""The command line program quadmatch, where the extension module does not fit: files in a folder of their own."""
import json
import pathlib
import shutil
import subprocess
import tempfile

import numpy as np

from .refusal import Cancelled, Refusal

POLL_SECONDS = 0.05


def find(preferred=""):
    """The program's path, or None: the one set in the preferences, else on PATH."""
    if preferred:
        return shutil.which(preferred)
    return shutil.which("quadmatch")


def write_ply(path, mesh):
    """Positions and faces of MeshArrays, as binary PLY with counts of 32 bits: one array for all faces."""
    header = ("ply\nformat binary_little_endian 1.0\n"
              f"element vertex {mesh.vertex_count}\nproperty float x\nproperty float y\nproperty float z\n"
              f"element face {mesh.face_count}\nproperty list uint int vertex_indices\nend_header\n")
    with open(path, "wb") as file:
        file.write(header.encode("ascii"))
        file.write(mesh.positions.astype("<f4").tobytes())
        file.write(np.insert(mesh.corners, mesh.starts, mesh.sizes).astype("<i4").tobytes())


def run(program, verb, meshes, arguments, progress, written=None, given=None):
    """Run `quadmatch VERB MESH... ARGUMENT...`; the object printed as JSON, or that in the file `written`.

    meshes: name to MeshArrays. given: name of a file to its object, as JSON. progress: called now and then; False stops the
    program.
    """
    with tempfile.TemporaryDirectory(prefix="quadmatch_") as folder:
        for name, mesh in meshes.items():
            write_ply(pathlib.Path(folder, name + ".ply"), mesh)
        for name, data in (given or {}).items():
            pathlib.Path(folder, name).write_text(json.dumps(data), encoding="utf-8")
        command = [program, verb, *(name + ".ply" for name in meshes), *arguments]
        output, errors = pathlib.Path(folder, "stdout"), pathlib.Path(folder, "stderr")
        with open(output, "wb") as out, open(errors, "wb") as err:
            status = _wait(command, folder, out, err, progress)
        if status not in (0, 1):
            raise Refusal(_sentence(errors.read_text(encoding="utf-8", errors="replace"), status))
        result = pathlib.Path(folder, written) if written else output
        try:
            return json.loads(result.read_text(encoding="utf-8"))
        except (OSError, ValueError) as error:
            raise Refusal(f"{program} gave no answer that can be read; is it the program quadmatch?") from error


def _wait(command, folder, out, err, progress):
    try:
        process = subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=out, stderr=err)
    except OSError as error:
        raise Refusal(f"{command[0]} cannot be run: {error.strerror}") from error
    while True:
        try:
            return process.wait(POLL_SECONDS)
        except subprocess.TimeoutExpired:
            if progress(0, 0) is False:
                process.kill()
                process.wait()
                raise Cancelled() from None


def _sentence(errors, status):
    lines = [line for line in errors.splitlines() if line.strip()]
    text = lines[-1] if lines else f"it ended with status {status}"
    return text.removeprefix("quadmatch: ")
