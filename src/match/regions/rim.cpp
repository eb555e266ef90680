#include "rim.hpp"

#include <algorithm>
#include <utility>

namespace quadmatch::regions {

Rim::Rim(const Sides& sides, const Patchwork& patchwork)
    : source_(sides.source.mesh), target_(sides.target.mesh), patchwork_(patchwork) {}

std::vector<HalfedgeId> Rim::entries() {
  update();
  return tidied(all_, [&](FaceId face) { return region_[face] == Patchwork::kNoRegion; });
}

std::vector<HalfedgeId> Rim::entries(std::uint32_t region) {
  update();
  if (region >= of_region_.size()) return {};
  return tidied(of_region_[region], [&](FaceId face) { return region_[face] != region; });
}

void Rim::update() {
  if (region_.size() == 0) {
    place_ = PerFace<std::uint32_t>(source_.face_count(), kNone);
    region_ = PerFace<std::uint32_t>(source_.face_count(), Patchwork::kNoRegion);
  }
  note_places();
  const std::vector<FaceId>& changed = patchwork_.changed();
  const std::vector<HalfedgeId>& history = patchwork_.history();
  if (8 * (changed.size() - seen_) > history.size()) {
    // In the order of the file, in which what is beside a face mostly lies beside it in memory too.
    for (std::uint32_t f = 0; f < source_.face_count(); ++f) {
      if (place_[FaceId(f)] != kNone) look_at(FaceId(f));
    }
  } else {
    for (std::size_t k = seen_; k < changed.size(); ++k) look_about(changed[k]);
  }
  seen_ = changed.size();
}

void Rim::note_places() {
  const std::vector<HalfedgeId>& history = patchwork_.history();
  for (; noted_ < history.size(); ++noted_) {
    std::uint32_t& place = place_[source_.face(history[noted_])];
    if (place == kNone) place = static_cast<std::uint32_t>(noted_);
  }
}

bool Rim::is_deep(FaceId face) const {
  const std::uint32_t region = patchwork_.region(face);
  HalfedgeId image = patchwork_.image(source_.first(face));
  for (const HalfedgeId h : source_.halfedges(face)) {
    const HalfedgeId beside = source_.twin(h);
    if (!beside.valid() || patchwork_.region(source_.face(beside)) != region) return false;
    if (patchwork_.image(beside) != target_.twin(image)) return false;
    image = target_.next(image);
  }
  return true;
}

void Rim::look_at(FaceId face) {
  const bool is_rim = patchwork_.is_matched(face) && !is_deep(face);
  const std::uint32_t region = is_rim ? patchwork_.region(face) : Patchwork::kNoRegion;
  const std::uint32_t before = std::exchange(region_[face], region);
  if (region == before) return;
  if (before != Patchwork::kNoRegion) of_region_[before].has_stale = all_.has_stale = true;
  if (region == Patchwork::kNoRegion) return;
  if (region >= of_region_.size()) of_region_.resize(region + std::size_t{1});
  of_region_[region].places.push_back(place_[face]);
  if (before == Patchwork::kNoRegion) all_.places.push_back(place_[face]);
}

void Rim::look_about(FaceId face) {
  look_at(face);
  for (const HalfedgeId h : source_.halfedges(face)) {
    if (const HalfedgeId beside = source_.twin(h); beside.valid()) look_at(source_.face(beside));
  }
}

/// Bring a list in order, and say which half-edges it stands for.
template <class IsStale>
std::vector<HalfedgeId> Rim::tidied(List& list, IsStale is_stale) const {
  const std::vector<HalfedgeId>& history = patchwork_.history();
  std::vector<std::uint32_t>& places = list.places;
  if (list.has_stale || list.sorted < places.size()) {
    const auto added = places.begin() + static_cast<std::ptrdiff_t>(list.sorted);
    std::sort(added, places.end());
    std::inplace_merge(places.begin(), added, places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());  // what left and came back is there twice
    std::erase_if(places, [&](std::uint32_t place) { return is_stale(source_.face(history[place])); });
    list.sorted = places.size();
    list.has_stale = false;
  }
  std::vector<HalfedgeId> entries;
  entries.reserve(places.size());
  for (const std::uint32_t place : places) entries.push_back(history[place]);
  return entries;
}

}  // namespace quadmatch::regions
