#include "face_states.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace quadmatch::use {
namespace {

/// A record that says that there is none from here on.
FaceRecord ending(const std::string& keyword, std::uint32_t face) {
  return {face, keyword, keyword == "s" ? "off" : keyword == "g" ? "default" : ""};
}

/// Those that begin before one face, in the order in which they are written: endings first; then the records of the
/// file that the object comes from, as importers let an object end its groups; each file's in its own order.
void write_changes(const MeshFile& first, const MeshFile& second, std::uint32_t place,
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
    const FaceRecord& record = (id.own ? second : first).face_records[id.index];
    records.push_back({place, record.keyword, record.value});
  }
}

}  // namespace

std::vector<std::uint32_t> states_of(const MeshFile& file, std::string_view keyword) {
  std::vector<std::uint32_t> states(file.mesh.face_count(), RecordId().index);
  std::uint32_t from = 0, holds = RecordId().index;
  for (std::uint32_t r = 0; r < file.face_records.size(); ++r) {
    if (file.face_records[r].keyword != keyword) continue;
    const std::uint32_t first = file.face_records[r].first_face;
    for (; from < first; ++from) states[from] = holds;
    holds = r;
  }
  for (; from < states.size(); ++from) states[from] = holds;
  return states;
}

std::vector<std::string> keywords_of(const std::vector<const MeshFile*>& files) {
  std::vector<std::string> keywords;
  for (const MeshFile* const file : files) {
    for (const FaceRecord& record : file->face_records) {
      if (std::find(keywords.begin(), keywords.end(), record.keyword) == keywords.end()) {
        keywords.push_back(record.keyword);
      }
    }
  }
  return keywords;
}

std::vector<FaceRecord> records_of(const MeshFile& first, const MeshFile& second, const std::vector<Track>& tracks) {
  std::vector<FaceRecord> records;
  std::vector<RecordId> holds(tracks.size());
  const std::size_t faces = tracks.empty() ? 0 : tracks.front().states.size();
  for (std::uint32_t place = 0; place < faces; ++place) {
    std::vector<std::pair<const Track*, RecordId>> changes;
    for (std::size_t t = 0; t < tracks.size(); ++t) {
      const RecordId& state = tracks[t].states[place];
      if (state == holds[t]) continue;
      holds[t] = state;
      changes.emplace_back(&tracks[t], state);
    }
    if (!changes.empty()) write_changes(first, second, place, std::move(changes), records);
  }
  return records;
}

}  // namespace quadmatch::use
