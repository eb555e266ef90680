#pragma once
/// The parts of the module, each in a file of its own.

#include <memory>

#include <pybind11/pybind11.h>

#include <quadmatch/io/match_file.hpp>
#include <quadmatch/io/mesh_file.hpp>

namespace quadmatch::python {

namespace py = pybind11;

/// Meshes and matches never change once Python sees them, so threads share them without locks.
using MeshHandle = std::shared_ptr<MeshFile>;
using MatchHandle = std::shared_ptr<MatchFile>;

void bind_mesh(py::module_& module);      ///< Mesh, read, write
void bind_match(py::module_& module);     ///< Match, Region, match, verify, read_match, write_match
void bind_transfer(py::module_& module);  ///< transfer
void bind_symmetry(py::module_& module);  ///< Symmetry, symmetry, symmetrize
void bind_diff(py::module_& module);      ///< diff
void bind_merge(py::module_& module);     ///< match_side, merge
void bind_analysis(py::module_& module);  ///< check, skeleton, connectivity_hash

}  // namespace quadmatch::python
