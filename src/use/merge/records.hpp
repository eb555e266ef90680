#pragma once
/// Objects, groups, materials, carried lines and elements that are not understood, merged three-way.

#include <array>
#include <vector>

#include "../data/face_states.hpp"
#include "layout.hpp"
#include "values.hpp"

namespace quadmatch::use {

/// The records of OBJ as states of faces, merged face by face. New faces of THEIRS go to the end of the object of OURS
/// that they belong to.
class MergedRecords {
 public:
  /// @param faces  of the layout, in its order.
  MergedRecords(const ThreeFiles& files, const std::vector<Origin>& faces, Side preferred, ValueTally& tally);

  /// For each place in the result the face of the layout that is there.
  [[nodiscard]] const std::vector<std::uint32_t>& order() const { return order_; }
  [[nodiscard]] const std::vector<FaceRecord>& records() const { return records_; }

 private:
  void put_in_order(const std::vector<Origin>& faces, const std::vector<Track>& tracks);

  std::vector<std::uint32_t> order_;
  std::vector<FaceRecord> records_;
};

/// Where the parts of the three files are in the result.
struct NewNumbers {
  const Layout& layout;
  /// The places of the faces of a side, with the end behind them; faces that are gone have that of the next.
  std::vector<std::uint32_t> of_ours_faces, of_theirs_faces;
  /// The places of entries of the pools of texture coordinates, by side.
  std::array<std::vector<std::uint32_t>, 3> texture;
};

/// Material libraries, carried lines and further elements: those of OURS, or of THEIRS where OURS left them as they
/// were. Lines and elements that name vertices name them by their new numbers; those that name one that is gone are
/// left out, with a note.
/// @param[in,out] result  has OURS' or nothing of these, and its face records.
void merge_carried(const ThreeFiles& files, const NewNumbers& numbers, MeshFile& result, ValueTally& tally);

}  // namespace quadmatch::use
