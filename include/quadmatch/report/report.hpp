#pragma once
/// A match to look at: one HTML file with both meshes, the match, its figures and what differs. It opens from disk and
/// needs no network (docs/design/019-report.md).

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <quadmatch/io/mesh_file.hpp>
#include <quadmatch/mesh/expected.hpp>
#include <quadmatch/mesh/match.hpp>

namespace quadmatch {

/// One line of figures, as a summary on a terminal has it: {"matched", "2,644 faces, 2,666 vertices"}.
struct ReportFigure {
  std::string name;
  std::string text;
};

/// A place worth a look, named: whoever reads the report can fly to it.
struct ReportChange {
  /// What it is, in a word or two: "added", "edge loop", "conflict". Changes of one kind are counted together.
  std::string kind;
  /// Where it is; either side may be empty, and need not be unmatched.
  std::vector<FaceId> source_faces;
  std::vector<FaceId> target_faces;
  /// One sentence without a full stop.
  std::string sentence;
};

/// What is said beside the pictures.
struct ReportText {
  std::string title;
  /// The program that made it, with its version.
  std::string program;
  std::vector<ReportFigure> figures = {};
  /// In the order in which they are listed.
  std::vector<ReportChange> changes = {};
  /// Source and target are one mesh, and the match its mirror: faces and partners light up on both sides.
  bool mirror = false;
};

/// Some faces of a mesh as connected areas, each ascending; from the largest, ties by lowest face.
/// @par Cost   O(#F + corners of these faces).
[[nodiscard]] std::vector<std::vector<FaceId>> connected_areas(const Mesh& mesh, std::span<const FaceId> faces);

/// The connected areas of faces that have no partner, each as a change: "only in source" first, then "only in target",
/// from the largest, ties by lowest face.
/// @pre        the match is sound for these meshes (see verify).
/// @par Cost   O(#corners).
[[nodiscard]] std::vector<ReportChange> unmatched_areas(const Mesh& source, const Mesh& target, const Match& match);

/// A report for a viewer that is there already: what stands in front of the bytes, as JSON, and the bytes.
struct PackedReport {
  std::string header;
  std::string bytes;
};

/// What `format_report` puts into its page, and nothing of the page.
/// @pre, @par Cost  as there.
[[nodiscard]] PackedReport pack_report(const MeshFile& source, const MeshFile& target, const Match& match,
                                       const ReportText& text);

/// The report as the bytes of an HTML file; the same input gives the same bytes.
///
/// @param source, target  any polygon meshes; without positions the figures and lists are shown, and no picture.
///                        Paths and the names of objects, groups and materials are shown as text whatever they hold.
/// @param match           shown region by region; with waves where its regions have them.
/// @pre        the match is sound for these meshes, and changes name faces that exist.
/// @par Cost   O(#corners) time; about 20 bytes of output a face of either mesh, and 0.6 MB for the viewer.
[[nodiscard]] std::string format_report(const MeshFile& source, const MeshFile& target, const Match& match,
                                        const ReportText& text);

/// The same into a file, all or nothing; `-` writes standard output.
/// @par Errors  CannotWrite, with the system's reason, or where the library was built without the viewer.
[[nodiscard]] Expected<void> write_report(const std::string& path, const MeshFile& source, const MeshFile& target,
                                          const Match& match, const ReportText& text);

}  // namespace quadmatch
