#pragma once
/// How numbers of two files are stored in one.

#include <quadmatch/io/mesh_file.hpp>

namespace quadmatch::use {

[[nodiscard]] bool is_whole(ScalarType type);
[[nodiscard]] const char* name_of(ScalarType type);
/// The smallest type that holds every value of both exactly.
[[nodiscard]] ScalarType holding_both(ScalarType one, ScalarType other);

}  // namespace quadmatch::use
