#include "records.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "../data/carried_lines.hpp"
#include "../data/numbering.hpp"

namespace quadmatch::use {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// The states of one kind of record on the faces of the result: OURS' records, where THEIRS say the same.
Track merged_track(const ThreeFiles& files, const std::string& keyword, const std::vector<Origin>& faces,
                   Side preferred, ValueTally& tally) {
  std::array<std::vector<std::uint32_t>, 3> states;
  for (const Side side : kSides) states[static_cast<std::size_t>(side)] = states_of(file_of(files, side), keyword);
  const auto record = [&](Side side, std::uint32_t face) { return states[static_cast<std::size_t>(side)][face]; };
  const auto text = [&](Side side, std::uint32_t face) -> std::optional<std::string_view> {
    const std::uint32_t r = record(side, face);
    if (r == kNone) return std::nullopt;
    return file_of(files, side).face_records[r].value;
  };
  const auto same = [&](Side a, std::uint32_t i, Side b, std::uint32_t j) { return text(a, i) == text(b, j); };
  const Picks picks = pick(keyword, Domain::Face, faces, preferred, same);
  tally.enter(picks);

  std::vector<std::uint32_t> as_ours(file_of(files, Side::Theirs).face_records.size(), kNone);
  for (const Origin& face : faces) {
    if (!face.has(Side::Ours) || !face.has(Side::Theirs)) continue;
    const std::uint32_t theirs = record(Side::Theirs, face[Side::Theirs]);
    if (theirs == kNone || as_ours[theirs] != kNone) continue;
    if (same(Side::Ours, face[Side::Ours], Side::Theirs, face[Side::Theirs])) {
      as_ours[theirs] = record(Side::Ours, face[Side::Ours]);
    }
  }
  Track track{keyword, {}};
  for (std::size_t k = 0; k < faces.size(); ++k) {
    RecordId state{picks.sides[k] == Side::Ours, record(picks.sides[k], faces[k][picks.sides[k]])};
    if (!state.own && state.valid() && as_ours[state.index] != kNone) state = {true, as_ours[state.index]};
    track.states.push_back(state);
  }
  return track;
}

bool same_texts(const std::vector<CarriedRecord>& a, const std::vector<CarriedRecord>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const CarriedRecord& one, const CarriedRecord& another) { return one.text == another.text; });
}

bool same_elements(const std::vector<FurtherElement>& a, const std::vector<FurtherElement>& b) {
  const auto same_property = [](const Property& one, const Property& another) {
    return one.name == another.name && one.values == another.values && one.list_starts == another.list_starts;
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](const FurtherElement& one, const FurtherElement& other) {
                      return one.name == other.name && one.count == other.count &&
                             std::equal(one.properties.begin(), one.properties.end(), other.properties.begin(),
                                        other.properties.end(), same_property);
                    });
}

/// Whose block of data is taken where it is not looked into: of the side that changed it, of OURS where both did.
template <class Block, class Same>
Side side_of(const ThreeFiles& files, Block MeshFile::*block, const Same& same, const char* name, MeshFile& result,
             ValueTally& tally) {
  const auto of = [&](Side side) -> const Block& { return file_of(files, side).*block; };
  const bool ours = !same(of(Side::Base), of(Side::Ours)), theirs = !same(of(Side::Base), of(Side::Theirs));
  tally.ours_changed = tally.ours_changed || ours;
  tally.theirs_changed = tally.theirs_changed || theirs;
  if (ours && theirs && !same(of(Side::Ours), of(Side::Theirs))) {
    result.notes.push_back(fmt::format("{} differ in all three meshes; those of OURS were taken", name));
  }
  return theirs && !ours ? Side::Theirs : Side::Ours;
}

/// The new numbers of a side's vertices.
std::vector<std::uint32_t> new_vertices(const NewNumbers& numbers, Side side) {
  std::vector<std::uint32_t> places;
  for (const VertexId v : side == Side::Ours ? numbers.layout.of_ours : numbers.layout.of_theirs) {
    places.push_back(v.value);
  }
  // A vertex that the other side joined anew has a successor, if not a place of its own.
  for (std::uint32_t k = 0; k < numbers.layout.vertices.size(); ++k) {
    const VertexId v = numbers.layout.vertices[k].in[side];
    if (v.valid() && places[v.value] == kNone) places[v.value] = k;
  }
  return places;
}

void merge_lines(const ThreeFiles& files, const NewNumbers& numbers, MeshFile& result, ValueTally& tally) {
  const Side side = side_of(files, &MeshFile::carried, same_texts, "lines that are carried along", result, tally);
  const std::vector<std::uint32_t> vertices = new_vertices(numbers, side);
  const std::vector<std::uint32_t>& faces = side == Side::Ours ? numbers.of_ours_faces : numbers.of_theirs_faces;
  const std::vector<std::uint32_t>& texture = numbers.texture[static_cast<std::size_t>(side)];
  std::size_t lost = 0;
  result.carried.clear();
  for (CarriedRecord line : file_of(files, side).carried) {
    bool complete = true;
    const auto vertex = [&](std::uint32_t v) {
      complete = complete && v < vertices.size() && vertices[v] != kNone;
      return complete ? vertices[v] : 0;
    };
    const auto entry = [&](std::uint32_t i) { return i < texture.size() ? texture[i] : kNone; };
    line.text = renumbered_line(line.text, vertex, entry);
    if (!complete) {
      ++lost;
      continue;
    }
    line.before_face = faces[std::min<std::size_t>(line.before_face, faces.size() - 1)];
    result.carried.push_back(std::move(line));
  }
  std::stable_sort(result.carried.begin(), result.carried.end(),
                   [](const CarriedRecord& a, const CarriedRecord& b) { return a.before_face < b.before_face; });
  // Lines stand before the records of the face below them: they belong to the object that ends there.
  for (CarriedRecord& line : result.carried) {
    const auto below =
        std::lower_bound(result.face_records.begin(), result.face_records.end(), line.before_face,
                         [](const FaceRecord& record, std::uint32_t face) { return record.first_face < face; });
    line.before_record = static_cast<std::uint32_t>(below - result.face_records.begin());
  }
  if (lost > 0)
    result.notes.push_back(fmt::format("{} l or p lines name vertices that are gone and were left out", lost));
}

void merge_further(const ThreeFiles& files, const NewNumbers& numbers, MeshFile& result, ValueTally& tally) {
  const Side side =
      side_of(files, &MeshFile::further_elements, same_elements, "elements that are carried along", result, tally);
  const std::vector<std::uint32_t> vertices = new_vertices(numbers, side);
  result.further_elements = file_of(files, side).further_elements;
  bool moved = false, gone = false;
  for (std::uint32_t v = 0; v < vertices.size(); ++v) {
    moved = moved || vertices[v] != v;
    gone = gone || vertices[v] == kNone;
  }
  if (gone) {
    for (const FurtherElement& element : result.further_elements) {
      result.notes.push_back(
          fmt::format("the elements {} may name vertices that are gone and were left out", element.name));
    }
    result.further_elements.clear();
  }
  for (FurtherElement& element : result.further_elements) {
    if (moved) renumber_further(element, vertices, result.notes);
  }
}

void merge_libraries(const ThreeFiles& files, MeshFile& result, ValueTally& tally) {
  const auto libraries = [&](Side side) -> const std::vector<std::string>& {
    return file_of(files, side).material_libraries;
  };
  const auto lists = [&](Side side, const std::string& name) {
    return std::find(libraries(side).begin(), libraries(side).end(), name) != libraries(side).end();
  };
  tally.ours_changed = tally.ours_changed || libraries(Side::Base) != libraries(Side::Ours);
  tally.theirs_changed = tally.theirs_changed || libraries(Side::Base) != libraries(Side::Theirs);
  result.material_libraries.clear();
  for (const std::string& name : libraries(Side::Ours)) {
    if (!lists(Side::Base, name) || lists(Side::Theirs, name)) result.material_libraries.push_back(name);
  }
  for (const std::string& name : libraries(Side::Theirs)) {
    if (!lists(Side::Base, name) && !lists(Side::Ours, name)) result.material_libraries.push_back(name);
  }
}

}  // namespace

MergedRecords::MergedRecords(const ThreeFiles& files, const std::vector<Origin>& faces, Side preferred,
                             ValueTally& tally) {
  const std::size_t conflicts_before = tally.conflicts.size();
  std::vector<Track> tracks;
  for (const std::string& keyword : keywords_of({files[1], files[2], files[0]})) {
    tracks.push_back(merged_track(files, keyword, faces, preferred, tally));
  }
  put_in_order(faces, tracks);
  std::vector<std::uint32_t> places(order_.size());
  for (std::uint32_t place = 0; place < order_.size(); ++place) places[order_[place]] = place;
  for (std::size_t k = conflicts_before; k < tally.conflicts.size(); ++k) {
    for (std::uint32_t& face : tally.conflicts[k].first) face = places[face];
  }
  for (Track& track : tracks) {
    std::vector<RecordId> in_order;
    for (const std::uint32_t face : order_) in_order.push_back(track.states[face]);
    track.states = std::move(in_order);
  }
  records_ = records_of(file_of(files, Side::Theirs), file_of(files, Side::Ours), tracks);
}

void MergedRecords::put_in_order(const std::vector<Origin>& faces, const std::vector<Track>& tracks) {
  for (std::uint32_t face = 0; face < faces.size(); ++face) order_.push_back(face);
  const auto objects =
      std::find_if(tracks.begin(), tracks.end(), [](const Track& track) { return track.keyword == "o"; });
  if (objects == tracks.end()) return;
  std::vector<std::uint32_t> behind(faces.size());
  std::vector<std::uint32_t> last_of;  // the last face of OURS in the object of each of its records
  for (std::uint32_t face = 0; face < faces.size(); ++face) {
    const RecordId& state = objects->states[face];
    const bool known = state.own && state.valid();
    if (known && state.index >= last_of.size()) last_of.resize(state.index + std::size_t{1}, kNone);
    if (faces[face].has(Side::Ours)) {
      behind[face] = face;
      if (known) last_of[state.index] = face;
    } else {
      behind[face] = known ? last_of[state.index] : kNone;
    }
  }
  std::stable_sort(order_.begin(), order_.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return behind[a] < behind[b]; });
}

void merge_carried(const ThreeFiles& files, const NewNumbers& numbers, MeshFile& result, ValueTally& tally) {
  merge_libraries(files, result, tally);
  merge_lines(files, numbers, result, tally);
  merge_further(files, numbers, result, tally);
}

}  // namespace quadmatch::use
