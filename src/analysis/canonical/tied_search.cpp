#include "tied_search.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace quadmatch::canonical {
namespace {

/// A list within a list of numbers, so that no two lists of lists look the same.
void append(std::vector<std::uint32_t>& key, std::span<const std::uint32_t> numbers) {
  key.push_back(static_cast<std::uint32_t>(numbers.size()));
  key.insert(key.end(), numbers.begin(), numbers.end());
}

/// The sizes of all cells.
std::vector<std::uint32_t> shape_of(const Partition& partition) {
  std::vector<std::uint32_t> sizes;
  const auto count = static_cast<std::uint32_t>(partition.elements().size());
  for (std::uint32_t cell = 0; cell < count; cell = partition.after(cell)) sizes.push_back(partition.size_of(cell));
  return sizes;
}

/// The smallest cell of at least `least` members that is wanted; of several the first.
template <class Wanted>
std::uint32_t smallest_cell(const Partition& partition, std::uint32_t least, Wanted wanted) {
  std::uint32_t smallest = Tangle::kNone;
  const auto count = static_cast<std::uint32_t>(partition.elements().size());
  for (std::uint32_t cell = 0; cell < count; cell = partition.after(cell)) {
    const std::uint32_t size = partition.size_of(cell);
    if (size < least || !wanted(partition.members(cell).front())) continue;
    if (smallest == Tangle::kNone || size < partition.size_of(smallest)) smallest = cell;
  }
  return smallest;
}

/// Half-edges in pieces that are not written yet, by the parts into which they fall at vertices that are numbered.
std::vector<std::vector<std::uint32_t>> open_parts(const Tangle& tangle, const Partition& partition) {
  DisjointSets joined(tangle.pieces);
  for (std::uint32_t v = tangle.halfedge_count(); v < tangle.size(); ++v) {
    if (partition.is_single(v)) continue;
    for (const std::uint32_t h : tangle.leaving_of(v)) {
      joined.join(tangle.piece[tangle.leaving_of(v).front()], tangle.piece[h]);
    }
  }
  std::vector<std::vector<std::uint32_t>> parts;
  std::vector<std::uint32_t> part_of_piece(tangle.pieces, Tangle::kNone);
  for (std::uint32_t h = 0; h < tangle.halfedge_count(); ++h) {
    if (partition.is_single(h)) continue;
    std::uint32_t& part = part_of_piece[joined.find(tangle.piece[h])];
    if (part == Tangle::kNone) {
      part = static_cast<std::uint32_t>(parts.size());
      parts.emplace_back();
    }
    parts[part].push_back(h);
  }
  return parts;
}

}  // namespace

TiedSearch::TiedSearch(const Mesh& mesh, Writer& writer)
    : mesh_(mesh), writer_(writer), images_(mesh), given_(mesh.vertex_count(), kNoNumber) {}

TiedOrder TiedSearch::order(std::span<const FaceId> faces) {
  const Tangle tangle = tangle_of(mesh_, faces);
  std::vector<std::uint64_t> labels(tangle.size(), ~std::uint64_t{0});
  for (std::uint32_t h = 0; h < tangle.halfedge_count(); ++h) {
    const std::uint64_t corners = mesh_.size(mesh_.face(tangle.halfedges[h]));
    labels[h] = 2 * corners + (tangle.twin[h] == Tangle::kNone ? 0 : 1);
  }
  Partition partition(labels);
  partition.refine(tangle);
  Solution solution = settle(tangle, partition, 0, Depth::Full);
  return {std::move(solution.faces), std::move(solution.symmetries)};
}

/// Steps 1 and 2, after refinement.
TiedSearch::Solution TiedSearch::settle(const Tangle& tangle, const Partition& partition, std::uint32_t next_number,
                                        Depth depth) {
  Solution solution;
  append(solution.key, shape_of(partition));
  std::vector<VertexId> numbered;
  for (const std::uint32_t element : partition.elements()) {
    if (!tangle.is_vertex(element) || !partition.is_single(element)) continue;
    const VertexId v = tangle.vertices[element - tangle.halfedge_count()];
    given_[v] = next_number++;
    numbered.push_back(v);
  }
  write_settled(tangle, partition, next_number, solution);
  std::vector<Solution> parts;
  for (const std::vector<std::uint32_t>& part : open_parts(tangle, partition)) {
    parts.push_back(solve_part(tangle, partition, part, next_number, depth));
  }
  append_parts(parts, solution);
  for (const VertexId v : numbered) given_[v] = kNoNumber;
  return solution;
}

/// Where one half-edge of a piece has a cell of its own all have: each leads to all others.
void TiedSearch::write_settled(const Tangle& tangle, const Partition& partition, std::uint32_t next_number,
                               Solution& solution) {
  std::vector<bool> is_written(tangle.pieces, false);
  for (const std::uint32_t element : partition.elements()) {
    if (tangle.is_vertex(element) || !partition.is_single(element) || is_written[tangle.piece[element]]) continue;
    is_written[tangle.piece[element]] = true;
    const LeastWriting least = writer_.write(std::span(&tangle.halfedges[element], 1), given_, next_number);
    append(solution.key, least.writing.numbers);
    solution.faces.insert(solution.faces.end(), least.writing.faces.begin(), least.writing.faces.end());
  }
}

/// Parts in the order of their keys; those with the same key change places.
void TiedSearch::append_parts(std::vector<Solution>& parts, Solution& solution) {
  std::sort(parts.begin(), parts.end(), [](const Solution& a, const Solution& b) { return a.key < b.key; });
  for (std::size_t first = 0, last = 0; first < parts.size(); first = last) {
    while (last < parts.size() && parts[last].key == parts[first].key) ++last;
    solution.symmetries.multiply_by_factorial(last - first);
    solution.symmetries.multiply(parts[first].symmetries, last - first);
  }
  for (const Solution& part : parts) {
    append(solution.key, part.key);
    solution.faces.insert(solution.faces.end(), part.faces.begin(), part.faces.end());
    solution.is_canonical = solution.is_canonical && part.is_canonical;
  }
}

/// Step 3 or 4, with the cells of the whole in front of the key: parts that do not lie in the same ones are different.
TiedSearch::Solution TiedSearch::solve_part(const Tangle& tangle, const Partition& partition,
                                            std::span<const std::uint32_t> halfedges, std::uint32_t next_number,
                                            Depth depth) {
  std::vector<bool> keeps_vertex(tangle.size(), false);
  for (const std::uint32_t h : halfedges) {
    const std::uint32_t v = tangle.origin[h];
    if (v != Tangle::kNone) keeps_vertex[v] = !partition.is_single(v);
  }
  std::vector<std::uint32_t> elements;
  const Tangle part = part_of(tangle, halfedges, keeps_vertex, elements);
  std::vector<std::uint64_t> labels;
  labels.reserve(elements.size());
  for (const std::uint32_t element : elements) labels.push_back(partition.cell_of(element));
  const Partition cells(labels, true);

  // Of a cell that the part shares with its likes it may have a single member.
  const bool is_told_more = cells.size_of(smallest_cell(cells, 1, [](std::uint32_t) { return true; })) == 1;
  Solution solution = part.pieces == 1 ? write_piece(part, cells, next_number)
                      : is_told_more   ? settle(part, cells, next_number, depth)
                                       : branch(part, cells, next_number, depth);
  std::vector<std::uint32_t> key;
  for (std::uint32_t cell = 0; cell < part.size(); cell = cells.after(cell)) {
    key.push_back(static_cast<std::uint32_t>(labels[cells.members(cell).front()]));
    key.push_back(cells.size_of(cell));
  }
  std::vector<std::uint32_t> whole;
  append(whole, key);
  append(whole, solution.key);
  solution.key = std::move(whole);
  return solution;
}

TiedSearch::Solution TiedSearch::write_piece(const Tangle& tangle, const Partition& partition,
                                             std::uint32_t next_number) {
  const std::uint32_t cell =
      smallest_cell(partition, 1, [&tangle](std::uint32_t element) { return !tangle.is_vertex(element); });
  std::vector<HalfedgeId> starts;
  for (const std::uint32_t h : partition.members(cell)) starts.push_back(tangle.halfedges[h]);
  std::sort(starts.begin(), starts.end());
  LeastWriting least = writer_.write(starts, given_, next_number);
  Solution solution{std::move(least.writing.numbers), std::move(least.writing.faces), {}};
  solution.symmetries.multiply(least.symmetries);
  return solution;
}

/// Step 4. @pre the tangle has several pieces, none of which is written.
TiedSearch::Solution TiedSearch::branch(const Tangle& tangle, const Partition& partition, std::uint32_t next_number,
                                        Depth depth) {
  const std::uint32_t cell = smallest_cell(partition, 2, [](std::uint32_t) { return true; });
  std::vector<std::uint32_t> members(partition.members(cell).begin(), partition.members(cell).end());
  std::sort(members.begin(), members.end());

  DisjointSets joined(static_cast<std::uint32_t>(members.size()));
  std::optional<Solution> least;
  std::uint32_t least_member = 0;
  std::vector<Solution> ways_down;  // the first from each member that was tried
  for (std::uint32_t member = 0; member < members.size(); ++member) {
    if (joined.find(member) < member) continue;
    Partition singled_out = partition;
    singled_out.single_out(members[member]);
    singled_out.refine(tangle);
    if (least) {
      std::vector<std::uint32_t> beginning;
      append(beginning, shape_of(singled_out));
      if (std::lexicographical_compare(least->key.begin(), least->key.end(), beginning.begin(), beginning.end()) &&
          !std::equal(beginning.begin(), beginning.end(), least->key.begin())) {
        continue;
      }
    }
    Solution way_down = settle(tangle, singled_out, next_number, Depth::FirstWayDown);
    if (depth == Depth::FirstWayDown) {
      way_down.is_canonical = false;
      return way_down;
    }
    const auto same = std::find_if(ways_down.begin(), ways_down.end(),
                                   [&way_down](const Solution& other) { return other.key == way_down.key; });
    if (same != ways_down.end()) {
      join_images(tangle, members, *same, way_down, joined);
      continue;
    }
    ways_down.push_back(way_down);
    Solution solution =
        way_down.is_canonical ? std::move(way_down) : settle(tangle, singled_out, next_number, Depth::Full);
    if (!least || solution.key < least->key) {
      least = std::move(solution);
      least_member = member;
    } else if (solution.key == least->key) {
      join_images(tangle, members, *least, solution, joined);
    }
  }
  std::uint64_t orbit = 0;
  for (std::uint32_t member = 0; member < members.size(); ++member) {
    orbit += joined.find(member) == joined.find(least_member) ? 1 : 0;
  }
  least->symmetries.multiply(orbit);
  return *std::move(least);
}

void TiedSearch::join_images(const Tangle& tangle, std::span<const std::uint32_t> members, const Solution& one,
                             const Solution& other, DisjointSets& joined) {
  if (tangle.is_vertex(members.front())) {
    std::vector<VertexId> vertices;
    for (const std::uint32_t v : members) vertices.push_back(tangle.vertices[v - tangle.halfedge_count()]);
    images_.join(one.faces, other.faces, vertices, joined);
  } else {
    std::vector<HalfedgeId> halfedges;
    for (const std::uint32_t h : members) halfedges.push_back(tangle.halfedges[h]);
    images_.join(one.faces, other.faces, halfedges, joined);
  }
}

}  // namespace quadmatch::canonical
