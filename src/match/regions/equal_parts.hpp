#pragma once
/// Components that are the same in both meshes, down to the last corner: laid on each other whole, before anything
/// burns. Eyes, teeth, bolts: where several are equal, positions say which is which, or nobody can.

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <quadmatch/mesh/components.hpp>

#include "ignition.hpp"
#include "mending.hpp"
#include "placement.hpp"
#include "split.hpp"
#include "whole_map.hpp"

namespace quadmatch::regions {

/// A part that could be laid in more ways than one.
struct Tie {
  FaceId face;                ///< of the source, in the part
  std::uint32_t ways = 1;     ///< how many maps are as good; at least so many where counting them all would take long
  bool by_positions = false;  ///< positions chose among them
};

class EqualParts {
 public:
  /// @param bench    nothing need be matched yet.
  /// @param colours  of the spokes of both meshes, with arc lengths.
  /// @par Cost       O(#corners).
  EqualParts(Workbench& bench, const ColouredSpokes& colours);

  /// Lay every component that has exactly one equal in each mesh. @return faces matched.
  std::size_t lay_single();
  /// Lay equal components of which there are several: the nearest first where positions say where they lie, else in
  /// the order in which they come. @return faces matched.
  std::size_t lay_repeated();

  [[nodiscard]] const std::vector<Tie>& ties() const { return ties_; }
  /// The parts that were laid, each as it was grown, in order. The patchwork may have changed since.
  [[nodiscard]] std::vector<Piece> take_pieces() { return std::move(pieces_); }

 private:
  /// A component of one mesh and all that an equal one shares with it.
  struct Part {
    std::uint64_t signature = 0;
    std::uint32_t faces = 0;
    FaceId first_face;
    std::vector<std::uint32_t> spokes;
  };
  /// Parts of both meshes that look equal.
  struct Class {
    std::vector<std::uint32_t> source, target;
  };
  /// A map of a whole part.
  struct Laying {
    Candidate seed;
    std::uint32_t ways = 0;
    bool by_positions = false;
    bool is_latest = false;  ///< it was the last that was grown
  };

  [[nodiscard]] static std::vector<Part> parts_of(const Side& side, const SpokeColours& colours,
                                                  const Components& components);
  [[nodiscard]] static bool any_may_have_equal(const std::vector<Part>& parts, const ColouredSpokes& colours);
  [[nodiscard]] static Point middle_of(const Mesh& mesh, const Part& part);
  [[nodiscard]] std::vector<Candidate> seeds(const Part& part, const Part& other) const;
  [[nodiscard]] bool fills(Candidate seed, const Part& part);
  [[nodiscard]] Laying best_laying(const Part& part, const Part& other);
  [[nodiscard]] double worth_of_map() const;
  [[nodiscard]] double drift_of_map(const Point& middle) const;
  std::size_t lay(const Part& part, const Part& other, std::uint32_t equals, bool chosen_by_positions);
  /// Pairs of a class's members, the nearest first.
  struct Order {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    bool by_positions = false;  ///< else as they come
  };
  [[nodiscard]] Order nearest_pairs(const Class& equal);
  [[nodiscard]] std::optional<LocalPlacement> placement_of(const Part& part);
  void look_at_positions();
  void nearest_first(std::vector<Candidate>& places) const;

  Workbench& bench_;
  const ColouredSpokes& colours_;
  std::vector<Part> source_parts_, target_parts_;
  std::vector<Class> classes_;
  WholeMap map_;
  std::vector<Piece> pieces_;
  std::vector<Tie> ties_;
  bool looked_ = false;
  std::optional<LocalPlacement> here_;  // of the part that is laid
  std::size_t looked_at_ = 0;           // matched faces, to place parts
  std::size_t spent_ = 0;               // faces grown in trials of one part
};

}  // namespace quadmatch::regions
