#pragma once
/// Two meshes that were read, compared part by part.

#include <optional>

#include "diff_arguments.hpp"
#include "diff_report.hpp"

namespace quadmatch::cli {

/// @param reading  how long it took to read them, in milliseconds.
/// @return         nothing, after a complaint, where the match does not fit.
[[nodiscard]] std::optional<DiffSummary> compare(const DiffArguments& arguments, const MeshFile& source,
                                                 const MeshFile& target, double reading, Progress& progress);

/// As text, JSON or a line, whichever is asked for; false where it cannot be written.
[[nodiscard]] bool tell(const DiffArguments& arguments, const DiffSummary& summary);

}  // namespace quadmatch::cli
