#pragma once
/// An ordered partition of the elements of a tangle, refined until it tells apart whatever it can.

#include <cstdint>
#include <span>
#include <vector>

#include "tangle.hpp"

namespace quadmatch::canonical {

/// Cells of elements that look alike, in an order that does not depend on numbers: the same for the same tangle,
/// however its elements are numbered. A cell is named by where it begins, so the order of cells is that of their names.
class Partition {
 public:
  /// Cells by label, ascending.
  /// @param labels      one per element.
  /// @param is_refined  these cells need no refinement: they are part of a partition that was refined.
  explicit Partition(const std::vector<std::uint64_t>& labels, bool is_refined = false);

  /// Split cells until all elements of a cell have prev, twin, origin and leaving half-edges in the same cells, equally
  /// many: the coarsest such partition, as Hopcroft's algorithm makes it. Only what was split since the last call, or
  /// is new, is looked at.
  /// @par Cost  O(n log^2 n) for n elements, and less where little is split.
  void refine(const Tangle& tangle);

  /// Give an element a cell of its own, in front of the rest of its cell.
  void single_out(std::uint32_t element);

  [[nodiscard]] std::uint32_t cell_of(std::uint32_t element) const { return cell_of_[element]; }
  [[nodiscard]] std::uint32_t size_of(std::uint32_t cell) const { return size_[cell]; }
  [[nodiscard]] bool is_single(std::uint32_t element) const { return size_[cell_of_[element]] == 1; }
  [[nodiscard]] std::span<const std::uint32_t> members(std::uint32_t cell) const {
    return std::span(elements_).subspan(cell, size_[cell]);
  }
  /// All elements, cell by cell.
  [[nodiscard]] std::span<const std::uint32_t> elements() const { return elements_; }
  /// The cell after this one, or the number of elements.
  [[nodiscard]] std::uint32_t after(std::uint32_t cell) const { return cell + size_[cell]; }

 private:
  void touch(std::uint32_t element);
  void split_touched();
  void split(std::span<const std::uint32_t> touched);
  void enqueue(std::uint32_t cell);

  std::vector<std::uint32_t> elements_;  // cell by cell
  std::vector<std::uint32_t> place_;     // of each element in elements_
  std::vector<std::uint32_t> cell_of_;   // of each element
  std::vector<std::uint32_t> size_;      // of each cell, at its name

  std::vector<std::uint32_t> queue_;  // cells that others have not been split by yet
  std::vector<bool> is_queued_;
  std::vector<std::uint32_t> touched_;  // elements the present cell says something about, and how often
  std::vector<std::uint32_t> touches_;
  std::vector<std::uint32_t> fragments_;
};

}  // namespace quadmatch::canonical
