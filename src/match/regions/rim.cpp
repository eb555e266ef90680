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
    const PerFace<char> deep = deep_faces();
    for (std::uint32_t place = 0; place < history.size(); ++place) {
      if (const FaceId face = source_.face(history[place]); place_[face] == place) list(face, !deep[face]);
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

/// Are faces on both sides of an edge, in one region and beside each other's images? @pre that of h is matched
bool Rim::goes_on(HalfedgeId h, HalfedgeId image, HalfedgeId beside) const {
  if (!beside.valid()) return false;
  const FaceId other = source_.face(beside);
  return patchwork_.region(other) == patchwork_.region(source_.face(h)) &&
         patchwork_.image(beside) == target_.twin(image);
}

bool Rim::is_deep(FaceId face) const {
  HalfedgeId image = patchwork_.image(source_.first(face));
  for (const HalfedgeId h : source_.halfedges(face)) {
    if (!goes_on(h, image, source_.twin(h))) return false;
    image = target_.next(image);
  }
  return true;
}

/// Which faces are deep, of those that are matched; every edge is looked at once.
PerFace<char> Rim::deep_faces() const {
  PerFace<char> deep(source_.face_count(), true);
  for (std::uint32_t f = 0; f < source_.face_count(); ++f) {
    const bool is_matched = patchwork_.is_matched(FaceId(f));
    HalfedgeId image = is_matched ? patchwork_.image(source_.first(FaceId(f))) : HalfedgeId();
    for (const HalfedgeId h : source_.halfedges(FaceId(f))) {
      const HalfedgeId beside = source_.twin(h);
      if (!(beside < h) && !(is_matched && goes_on(h, image, beside))) {
        deep[FaceId(f)] = false;
        if (beside.valid()) deep[source_.face(beside)] = false;
      }
      if (is_matched) image = target_.next(image);
    }
  }
  return deep;
}

void Rim::list(FaceId face, bool ends) {
  const bool is_rim = ends && patchwork_.is_matched(face);
  const std::uint32_t region = is_rim ? patchwork_.region(face) : Patchwork::kNoRegion;
  const std::uint32_t before = std::exchange(region_[face], region);
  if (region == before) return;
  if (before != Patchwork::kNoRegion) of_region_[before].has_stale = all_.has_stale = true;
  if (region == Patchwork::kNoRegion) return;
  if (region >= of_region_.size()) of_region_.resize(region + std::size_t{1});
  of_region_[region].places.push_back(place_[face]);
  if (before == Patchwork::kNoRegion) all_.places.push_back(place_[face]);
}

void Rim::look_at(FaceId face) { list(face, patchwork_.is_matched(face) && !is_deep(face)); }

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
