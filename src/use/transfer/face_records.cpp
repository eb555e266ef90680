#include "face_records.hpp"

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

#include "../data/face_states.hpp"

namespace quadmatch::use {
namespace {

constexpr std::uint32_t kNone = ElementMap::kNone;

bool has(const MeshFile& file, std::string_view keyword) {
  return std::any_of(file.face_records.begin(), file.face_records.end(),
                     [&](const FaceRecord& record) { return record.keyword == keyword; });
}

bool is_wanted(std::string_view keyword, const Carry& carry) {
  if (keyword == "usemtl") return carry.materials;
  if (keyword == "s") return carry.smoothing;
  return (keyword == "o" || keyword == "g") && carry.groups;
}

/// What most of the matched faces of each of the target's objects are in: its other faces shall be there too, or an
/// object would fall apart in two for being new in places. By own record + 1.
std::vector<std::uint32_t> objects_taken(const std::vector<std::uint32_t>& theirs,
                                         const std::vector<std::uint32_t>& own, const ElementMap& map,
                                         std::size_t own_records) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> votes;
  for (std::size_t f = 0; f < own.size(); ++f) {
    if (map.from[f] != kNone && theirs[map.from[f]] != kNone) ++votes[{own[f] + 1, theirs[map.from[f]]}];
  }
  std::vector<std::uint32_t> taken(own_records + 1, kNone), most(own_records + 1, 0);
  for (const auto& [pair, count] : votes) {
    if (count <= most[pair.first]) continue;
    most[pair.first] = count;
    taken[pair.first] = pair.second;
  }
  return taken;
}

Track carried_track(const MeshFile& source, const MeshFile& target, const std::string& keyword, const ElementMap& map,
                    Fill fill, TransferredAttribute& report) {
  const std::vector<std::uint32_t> theirs = states_of(source, keyword);
  const std::vector<std::uint32_t> own = states_of(target, keyword);
  Track track{keyword, std::vector<RecordId>(own.size())};
  const bool whole = keyword == "o" && fill == Fill::Keep;
  std::vector<std::uint32_t> taken;
  if (whole) taken = objects_taken(theirs, own, map, target.face_records.size());
  for (std::size_t f = 0; f < own.size(); ++f) {
    if (map.from[f] != kNone) {
      track.states[f] = {false, theirs[map.from[f]]};
      ++(track.states[f].valid() ? report.carried : report.without);
    } else if (fill == Fill::Smooth && map.nearest[f] != kNone) {
      track.states[f] = {false, theirs[map.nearest[f]]};
      ++(track.states[f].valid() ? report.filled : report.without);
    } else if (whole && taken[own[f] + 1] != kNone) {
      track.states[f] = {false, taken[own[f] + 1]};
      ++report.filled;
    } else if (fill != Fill::None && own[f] != kNone) {
      track.states[f] = {true, own[f]};
      ++report.kept;
    } else {
      ++report.without;
    }
  }
  return track;
}

Track own_track(const MeshFile& target, const std::string& keyword) {
  Track track{keyword, {}};
  for (const std::uint32_t record : states_of(target, keyword)) track.states.push_back({true, record});
  return track;
}

}  // namespace

std::vector<FaceRecord> carry_face_records(const MeshFile& source, const MeshFile& target, const ElementMap& map,
                                           const std::vector<FaceId>& faces, const TransferOptions& options,
                                           std::vector<TransferredAttribute>& report) {
  std::vector<Track> tracks;
  bool any_carried = false;
  for (const std::string& keyword : keywords_of({&source, &target})) {
    if (is_wanted(keyword, options.carry) && has(source, keyword)) {
      TransferredAttribute& entry = report.emplace_back(TransferredAttribute{keyword, Domain::Face});
      tracks.push_back(carried_track(source, target, keyword, map, options.fill, entry));
      any_carried = true;
    } else if (has(target, keyword)) {
      tracks.push_back(own_track(target, keyword));
    }
  }
  if (!any_carried && !options.order) return target.face_records;

  for (Track& track : tracks) {
    std::vector<RecordId> in_order;
    in_order.reserve(faces.size());
    for (const FaceId f : faces) in_order.push_back(track.states[f.value]);
    track.states = std::move(in_order);
  }
  return records_of(source, target, tracks);
}

}  // namespace quadmatch::use
