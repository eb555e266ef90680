#pragma once
/// The match of a report, and the places its changes name, as blocks of bytes.

#include <vector>

#include <quadmatch/mesh/match.hpp>
#include <quadmatch/mesh/mesh.hpp>
#include <quadmatch/report/report.hpp>

#include "packer.hpp"

namespace quadmatch::report {

/// Append pairs and waves, region by region, and for both meshes the half-edges where regions meet:
/// pairs, waves, source.borders, target.borders.
void add_match(Blocks& blocks, const Mesh& source, const Mesh& target, const Match& match);

/// Append the faces of all changes, those of the source before those of the target: changes.
void add_changes(Blocks& blocks, const std::vector<ReportChange>& changes);

}  // namespace quadmatch::report
