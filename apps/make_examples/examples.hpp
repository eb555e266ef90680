#pragma once
/// The files in examples/: which model goes where, and what it carries.

#include <string>
#include <vector>

#include <quadmatch/io/mesh_file.hpp>

namespace quadmatch {

struct Example {
  /// Within the folder.
  std::string name;
  MeshFile file;
};

/// All of them, the same bytes on every machine: coordinates are rounded to five decimals.
[[nodiscard]] std::vector<Example> make_examples();

}  // namespace quadmatch
