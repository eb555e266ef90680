#include "face_records.hpp"

#include <algorithm>
#include <map>
#include <string_view>
#include <tuple>

namespace quadmatch::use {
namespace {

constexpr std::uint32_t kNone = ElementMap::kNone;

/// A record of the source or of the target, or none.
struct RecordId {
  bool own = false;  ///< of the target
  std::uint32_t index = kNone;

  [[nodiscard]] bool valid() const { return index != kNone; }
  bool operator==(const RecordId& other) const { return index == other.index && (own == other.own || index == kNone); }
};

/// What holds at each face of a file: the index of a record, or kNone before the first.
std::vector<std::uint32_t> states_of(const MeshFile& file, std::string_view keyword) {
  std::vector<std::uint32_t> states(file.mesh.face_count(), kNone);
  std::uint32_t from = 0, holds = kNone;
  for (std::uint32_t r = 0; r < file.face_records.size(); ++r) {
    if (file.face_records[r].keyword != keyword) continue;
    const std::uint32_t first = file.face_records[r].first_face;
    for (; from < first; ++from) states[from] = holds;
    holds = r;
  }
  for (; from < states.size(); ++from) states[from] = holds;
  return states;
}

bool has(const MeshFile& file, std::string_view keyword) {
  return std::any_of(file.face_records.begin(), file.face_records.end(),
                     [&](const FaceRecord& record) { return record.keyword == keyword; });
}

bool is_wanted(std::string_view keyword, const Carry& carry) {
  if (keyword == "usemtl") return carry.materials;
  if (keyword == "s") return carry.smoothing;
  return (keyword == "o" || keyword == "g") && carry.groups;
}

/// One kind of record, by faces of the target.
struct Track {
  std::string keyword;
  std::vector<RecordId> states;
};

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

/// A record that says that there is none from here on.
FaceRecord ending(const std::string& keyword, std::uint32_t face) {
  return {face, keyword, keyword == "s" ? "off" : keyword == "g" ? "default" : ""};
}

/// Those that begin before one face, in the order in which they are written: endings first; then the records of the
/// file that the object comes from, as importers let an object end its groups; each file's in its own order.
void write_changes(const MeshFile& source, const MeshFile& target, std::uint32_t place,
                   std::vector<std::pair<const Track*, RecordId>> changes, std::vector<FaceRecord>& records) {
  const auto object =
      std::find_if(changes.begin(), changes.end(), [](const auto& change) { return change.first->keyword == "o"; });
  const bool own_first = object != changes.end() && object->second.valid() && object->second.own;
  const auto rank = [own_first](const auto& change) {
    const RecordId& id = change.second;
    return std::tuple(id.valid(), id.valid() && id.own != own_first, id.valid() ? id.index : 0);
  };
  std::stable_sort(changes.begin(), changes.end(), [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  for (const auto& [track, id] : changes) {
    if (!id.valid()) {
      records.push_back(ending(track->keyword, place));
      continue;
    }
    const FaceRecord& record = (id.own ? target : source).face_records[id.index];
    records.push_back({place, record.keyword, record.value});
  }
}

std::vector<std::string> keywords_of(const MeshFile& source, const MeshFile& target) {
  std::vector<std::string> keywords;
  for (const MeshFile* const file : {&source, &target}) {
    for (const FaceRecord& record : file->face_records) {
      if (std::find(keywords.begin(), keywords.end(), record.keyword) == keywords.end()) {
        keywords.push_back(record.keyword);
      }
    }
  }
  return keywords;
}

}  // namespace

std::vector<FaceRecord> carry_face_records(const MeshFile& source, const MeshFile& target, const ElementMap& map,
                                           const std::vector<FaceId>& faces, const TransferOptions& options,
                                           std::vector<TransferredAttribute>& report) {
  std::vector<Track> tracks;
  bool any_carried = false;
  for (const std::string& keyword : keywords_of(source, target)) {
    if (is_wanted(keyword, options.carry) && has(source, keyword)) {
      TransferredAttribute& entry = report.emplace_back(TransferredAttribute{keyword, Domain::Face});
      tracks.push_back(carried_track(source, target, keyword, map, options.fill, entry));
      any_carried = true;
    } else if (has(target, keyword)) {
      tracks.push_back(own_track(target, keyword));
    }
  }
  if (!any_carried && !options.order) return target.face_records;

  std::vector<FaceRecord> records;
  std::vector<RecordId> holds(tracks.size());
  for (std::uint32_t place = 0; place < faces.size(); ++place) {
    std::vector<std::pair<const Track*, RecordId>> changes;
    for (std::size_t t = 0; t < tracks.size(); ++t) {
      const RecordId& state = tracks[t].states[faces[place].value];
      if (state == holds[t]) continue;
      holds[t] = state;
      changes.emplace_back(&tracks[t], state);
    }
    if (!changes.empty()) write_changes(source, target, place, std::move(changes), records);
  }
  return records;
}

}  // namespace quadmatch::use
