#include "sheets.hpp"

#include <algorithm>
#include <bit>

namespace quadmatch::exact {
namespace {

/// Pairs walked at most, for each face of the larger mesh.
constexpr std::size_t kPairsPerFace = 10;

}  // namespace

Sheets::Sheets(const Partial& partial)
    : most_pairs_(kPairsPerFace * std::max(partial.mesh(kSource).face_count(), partial.mesh(kTarget).face_count())),
      slots_(std::bit_ceil(4 * most_pairs_ + 2)),
      reached_{PerFace<std::uint32_t>(partial.mesh(kSource).face_count(), 0),
               PerFace<std::uint32_t>(partial.mesh(kTarget).face_count(), 0)} {}

/// True if the pair had not been seen. Equal pairs are named by the first half-edge of the source face.
bool Sheets::note(const Pair& pair) {
  const std::uint64_t key = (std::uint64_t{pair.source.value} << 32U) | pair.target.value;
  const std::size_t mask = slots_.size() - 1;
  std::size_t place = static_cast<std::size_t>((key * 0x9e3779b97f4a7c15U) >> 20U) & mask;
  for (; slots_[place].stamp == stamp_; place = (place + 1) & mask) {
    if (slots_[place].pair == pair) return false;
  }
  slots_[place] = {stamp_, pair};
  ++noted_;
  return true;
}

/// False where the pairs are too many.
bool Sheets::visit(const Partial& partial, const Pair& pair) {
  if (!pair.source.valid() || !pair.target.valid()) return true;
  const Mesh& source = partial.mesh(kSource);
  const FaceId f = source.face(pair.source), g = partial.mesh(kTarget).face(pair.target);
  if (!partial.is_open(kSource, f) || !partial.is_open(kTarget, g)) return true;
  const std::uint32_t size = source.size(f);
  if (partial.mesh(kTarget).size(g) != size) return true;
  const std::uint32_t back = (size - source.corner(pair.source)) % size;
  const Pair named{source.first(f), partial.turned(kTarget, pair.target, back)};
  if (2 * noted_ >= slots_.size()) return false;  // pairs that do not fit take slots as well
  if (!note(named) || !partial.fits(named)) return true;
  reached_[kSource][f] = reached_[kTarget][g] = stamp_;
  queue_.push_back(named);
  return queue_.size() <= most_pairs_;
}

bool Sheets::walk(const Partial& partial, const Rim& rim) {
  ++stamp_;
  noted_ = 0;
  queue_.clear();
  for (const Pair& inside : rim) {
    if (!visit(partial, beyond(partial, inside))) return false;
  }
  for (std::size_t next = 0; next < queue_.size(); ++next) {
    Pair inside = queue_[next];
    for (std::uint32_t corner = partial.mesh(kSource).size(partial.mesh(kSource).face(inside.source)); corner > 0;
         --corner) {
      if (!visit(partial, beyond(partial, inside))) return false;
      inside = {partial.mesh(kSource).next(inside.source), partial.mesh(kTarget).next(inside.target)};
    }
  }
  return true;
}

bool Sheets::exclude(Partial& partial, Side side) {
  bool excluded = false;
  for (std::uint32_t f = 0; f < partial.mesh(side).face_count(); ++f) {
    if (!partial.is_open(side, FaceId(f)) || reached_[side][FaceId(f)] == stamp_) continue;
    partial.exclude(side, FaceId(f));
    excluded = true;
  }
  return excluded;
}

bool Sheets::exclude_unreached(Partial& partial, const Rim& rim) {
  const std::uint32_t open = std::min(partial.open_faces(kSource), partial.open_faces(kTarget));
  if (given_up_at_ != 0xffffffff) {
    const std::uint32_t size = partial.size();
    const std::uint32_t changed = size > given_up_at_ ? size - given_up_at_ : given_up_at_ - size;
    if (8 * changed < open) return false;
  }
  if (!walk(partial, rim)) {
    given_up_at_ = partial.size();
    return false;
  }
  given_up_at_ = 0xffffffff;
  const bool excluded = exclude(partial, kSource);
  return exclude(partial, kTarget) || excluded;
}

}  // namespace quadmatch::exact
