// Values are looked up one by one; the meshes that have the rarest of them are then compared value by value.

#include "relatives.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <tuple>
#include <unordered_map>

namespace quadmatch::cli {
namespace {

/// A value that more meshes have than this tells little, and is only asked for where nothing rarer is known.
constexpr std::uint32_t kCommon = 400;
constexpr std::uint32_t kVeryCommon = 20000;
/// Common values that are asked for then.
constexpr std::size_t kFewValues = 32;
/// Meshes that are compared value by value.
constexpr std::size_t kCompared = 64;

/// What a value of the mesh weighs, by how many meshes of the library have it.
using Weights = std::unordered_map<std::uint32_t, double>;

/// How much of the mesh each of its relatives has. No order of it reaches a result.
using Shares = std::unordered_map<std::int64_t, double>;

struct Question {
  LibraryStore* store;
  const Signature* asked;
  double meshes;  ///< in the library

  [[nodiscard]] double weight(std::size_t having) const {
    return std::log1p(meshes / std::max(1.0, static_cast<double>(having)));
  }
};

/// How much of the mesh each of its relatives has, by the values that are not common; and what each value weighs.
/// @param most  meshes of one value; what more have is common.
Expected<Shares> look_up(const Question& question, std::size_t values, std::uint32_t most, Weights& weights) {
  Shares shared;
  std::vector<std::int64_t> having;
  for (std::size_t k = 0; k < values; ++k) {
    const std::uint32_t value = question.asked->values[k];
    if (Expected<void> found = question.store->meshes_with(value, most + 1, having); !found) {
      return Unexpected(found.error());
    }
    weights[value] = question.weight(having.size());
    if (having.size() > most) continue;
    for (const std::int64_t mesh : having) shared[mesh] += weights[value];
  }
  return shared;
}

/// The numbers of the meshes with most in common, by the values looked up, in order of their numbers.
std::vector<std::int64_t> most_promising(const Shares& shared, std::size_t most) {
  std::vector<std::pair<double, std::int64_t>> order;
  for (const auto& [mesh, weight] : shared) order.emplace_back(-weight, mesh);
  const auto kept = static_cast<std::ptrdiff_t>(std::min(most, order.size()));
  std::partial_sort(order.begin(), order.begin() + kept, order.end());
  std::vector<std::int64_t> found;
  for (std::ptrdiff_t k = 0; k < kept; ++k) found.push_back(order[static_cast<std::size_t>(k)].second);
  return found;
}

double part(double some, std::uint32_t whole) { return whole == 0 ? 0 : std::min(1.0, some / whole); }

/// Compare the sample of a mesh with all values that are asked for.
Relative compared(LibraryMesh mesh, const Signature& asked, const Weights& weights) {
  double hits = 0;
  double weight = 0;
  for (const std::uint32_t value : mesh.signature.values) {
    const auto place = weights.find(value);
    if (place == weights.end()) continue;
    ++hits;
    weight += place->second;
  }
  const std::uint32_t elements = mesh.signature.elements;
  const auto sample = static_cast<std::uint32_t>(mesh.signature.values.size());
  Relative relative{.mesh = std::move(mesh)};
  if (hits == 0) return relative;
  // Each value of the sample stands for this many elements.
  const double scale = static_cast<double>(elements) / sample;
  const double common = std::min<double>(hits * scale, std::min(elements, asked.elements));
  relative.common = common / (static_cast<double>(elements) + asked.elements - common);
  relative.of_this = part(common, asked.elements);
  relative.of_other = part(common, elements);
  relative.weight = weight * scale / std::sqrt(static_cast<double>(elements) * asked.elements);
  return relative;
}

/// Add those nearest in size that are not there yet.
Expected<void> add_by_size(LibraryStore& store, std::uint32_t faces, std::uint32_t most,
                           std::vector<std::int64_t>& numbers) {
  const Expected<std::vector<std::int64_t>> near = store.meshes_of_size(faces, most);
  if (!near) return Unexpected(near.error());
  for (const std::int64_t number : *near) {
    if (std::find(numbers.begin(), numbers.end(), number) == numbers.end()) numbers.push_back(number);
  }
  return {};
}

std::int64_t difference(std::uint32_t one, std::uint32_t other) {
  return std::abs(static_cast<std::int64_t>(one) - static_cast<std::int64_t>(other));
}

}  // namespace

Expected<std::vector<Relative>> find_relatives(LibraryStore& store, const Signature& asked, std::uint32_t faces,
                                               std::uint32_t most) {
  // One lock for all that is looked up, not one for each.
  if (Expected<void> begun = store.begin_reading(); !begun) return Unexpected(begun.error());
  const Expected<std::int64_t> meshes = store.mesh_count();
  if (!meshes) return Unexpected(meshes.error());
  const Question question{&store, &asked, static_cast<double>(*meshes)};
  Weights weights;
  Expected<Shares> shared = look_up(question, asked.values.size(), kCommon, weights);
  if (shared && shared->empty()) {
    shared = look_up(question, std::min(kFewValues, asked.values.size()), kVeryCommon, weights);
  }
  if (!shared) return Unexpected(shared.error());
  std::vector<std::int64_t> numbers = most_promising(*shared, std::max<std::size_t>(kCompared, most));
  if (numbers.size() < most) {
    if (Expected<void> added = add_by_size(store, faces, most, numbers); !added) return Unexpected(added.error());
  }
  std::vector<Relative> relatives;
  for (const std::int64_t number : numbers) {
    Expected<LibraryMesh> mesh = store.mesh(number);
    if (!mesh) return Unexpected(mesh.error());
    relatives.push_back(compared(*std::move(mesh), asked, weights));
  }
  if (Expected<void> ended = store.commit(); !ended) return Unexpected(ended.error());
  std::sort(relatives.begin(), relatives.end(), [faces](const Relative& one, const Relative& other) {
    return std::tuple(-one.weight, difference(one.mesh.faces, faces), one.mesh.file.path) <
           std::tuple(-other.weight, difference(other.mesh.faces, faces), other.mesh.file.path);
  });
  if (relatives.size() > most) relatives.resize(most);
  return relatives;
}

}  // namespace quadmatch::cli
