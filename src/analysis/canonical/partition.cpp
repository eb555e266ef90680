// Nothing here may depend on the numbers of elements: cells are split by counts, and both the order of the fragments
// and the order in which cells take their turn follow from the order of the cells.

#include "partition.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace quadmatch::canonical {

Partition::Partition(const std::vector<std::uint64_t>& labels, bool is_refined)
    : elements_(labels.size()),
      place_(labels.size()),
      cell_of_(labels.size()),
      size_(labels.size(), 0),
      is_queued_(labels.size(), false),
      touches_(labels.size(), 0) {
  std::iota(elements_.begin(), elements_.end(), std::uint32_t{0});
  std::sort(elements_.begin(), elements_.end(),
            [&labels](std::uint32_t a, std::uint32_t b) { return std::pair(labels[a], a) < std::pair(labels[b], b); });
  std::uint32_t cell = 0;
  for (std::uint32_t place = 0; place < elements_.size(); ++place) {
    const std::uint32_t element = elements_[place];
    if (labels[element] != labels[elements_[cell]]) cell = place;
    if (cell == place && !is_refined) enqueue(cell);
    place_[element] = place;
    cell_of_[element] = cell;
    ++size_[cell];
  }
}

void Partition::enqueue(std::uint32_t cell) {
  if (is_queued_[cell]) return;
  is_queued_[cell] = true;
  queue_.push_back(cell);
}

void Partition::single_out(std::uint32_t element) {
  const std::uint32_t cell = cell_of_[element];
  if (size_[cell] == 1) return;
  const std::uint32_t other = elements_[cell];
  std::swap(elements_[cell], elements_[place_[element]]);
  std::swap(place_[element], place_[other]);
  for (const std::uint32_t member : members(cell)) {
    if (member != element) cell_of_[member] = cell + 1;
  }
  size_[cell + 1] = size_[cell] - 1;
  size_[cell] = 1;
  enqueue(cell);
}

void Partition::refine(const Tangle& tangle) {
  std::vector<std::uint32_t> splitter;
  for (std::size_t turn = 0; turn < queue_.size(); ++turn) {
    const std::uint32_t cell = queue_[turn];
    is_queued_[cell] = false;
    // All of it, also where it is split by itself.
    splitter.assign(elements_.begin() + cell, elements_.begin() + cell + size_[cell]);
    if (tangle.is_vertex(splitter.front())) {
      for (const std::uint32_t v : splitter) {
        for (const std::uint32_t h : tangle.leaving_of(v)) touch(h);
      }
      split_touched();
      continue;
    }
    for (const std::vector<std::uint32_t>* links : {&tangle.prev, &tangle.twin, &tangle.origin}) {
      for (const std::uint32_t h : splitter) {
        if ((*links)[h] != Tangle::kNone) touch((*links)[h]);
      }
      split_touched();
    }
  }
  queue_.clear();
}

void Partition::touch(std::uint32_t element) {
  if (size_[cell_of_[element]] == 1) return;
  if (touches_[element]++ == 0) touched_.push_back(element);
}

/// Split every cell of which some elements were touched oftener than others.
void Partition::split_touched() {
  std::sort(touched_.begin(), touched_.end(), [this](std::uint32_t a, std::uint32_t b) {
    return std::pair(cell_of_[a], touches_[a]) < std::pair(cell_of_[b], touches_[b]);
  });
  for (std::size_t first = 0, last = 0; first < touched_.size(); first = last) {
    const std::uint32_t cell = cell_of_[touched_[first]];
    while (last < touched_.size() && cell_of_[touched_[last]] == cell) ++last;
    split(std::span(touched_).subspan(first, last - first));
  }
  for (const std::uint32_t element : touched_) touches_[element] = 0;
  touched_.clear();
}

/// @param touched  of one cell, ascending by how often; they go to its end, behind those that were not touched.
void Partition::split(std::span<const std::uint32_t> touched) {
  const std::uint32_t cell = cell_of_[touched.front()];
  const std::uint32_t size = size_[cell];
  if (touched.size() == size && touches_[touched.front()] == touches_[touched.back()]) return;

  std::uint32_t place = cell + size;
  fragments_.clear();
  for (std::size_t last = touched.size(); last-- > 0;) {
    const std::uint32_t element = touched[last];
    const std::uint32_t other = elements_[--place];
    std::swap(elements_[place], elements_[place_[element]]);
    std::swap(place_[element], place_[other]);
    const bool is_first_of_its_kind = last == 0 || touches_[touched[last - 1]] != touches_[element];
    if (is_first_of_its_kind) fragments_.push_back(place);
  }
  if (place > cell) fragments_.push_back(cell);
  std::reverse(fragments_.begin(), fragments_.end());
  for (std::size_t k = 0; k < fragments_.size(); ++k) {
    const std::uint32_t start = fragments_[k];
    const std::uint32_t end = k + 1 < fragments_.size() ? fragments_[k + 1] : cell + size;
    size_[start] = end - start;
    if (start == cell) continue;
    for (std::uint32_t at = start; at < end; ++at) cell_of_[elements_[at]] = start;
  }

  // What the whole cell said is known; what all parts but one say tells what that one says.
  std::uint32_t left_out = fragments_.front();
  for (const std::uint32_t fragment : fragments_) {
    if (size_[fragment] > size_[left_out]) left_out = fragment;
  }
  const bool was_queued = is_queued_[cell];
  for (const std::uint32_t fragment : fragments_) {
    if (was_queued || fragment != left_out) enqueue(fragment);
  }
}

}  // namespace quadmatch::canonical
