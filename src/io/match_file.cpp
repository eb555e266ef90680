// The match file, quadmatch.match/1: checked when read, and written as compact JSON that is the same for the same
// match.

#include <quadmatch/io/match_file.hpp>

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include <quadmatch/io/file.hpp>

#include "match_parser.hpp"
#include "text_buffer.hpp"

namespace quadmatch {
namespace {

using io::json_text;
using io::kRematch;

Unexpected<Error> bad_index(const std::string& where, const char* what, std::uint32_t index, const char* side,
                            std::uint32_t count) {
  return Unexpected(Error{ErrorCode::BadIndex, fmt::format("{}: there is no {} {} in the {}, which has {}; {}", where,
                                                           what, index, side, count, kRematch)});
}

Expected<void> check_region(const MatchFile& file, std::size_t number) {
  const Region& region = file.match.regions[number];
  for (std::size_t i = 0; i < region.faces.size(); ++i) {
    const FacePair& pair = region.faces[i];
    const auto where = [&] { return fmt::format("region {}, pair {}", number, i); };
    if (pair.source.value >= file.source.faces) {
      return bad_index(where(), "face", pair.source.value, "source", file.source.faces);
    }
    if (pair.target.value >= file.target.faces) {
      return bad_index(where(), "face", pair.target.value, "target", file.target.faces);
    }
  }
  const std::vector<std::uint32_t>& waves = region.waves;
  if (!waves.empty() && (!std::is_sorted(waves.begin(), waves.end()) || waves.back() != region.faces.size())) {
    return Unexpected(Error{ErrorCode::BadIndex, fmt::format("region {}: its waves do not rise to its {} faces; {}",
                                                             number, region.faces.size(), kRematch)});
  }
  return {};
}

/// Does every pair name elements that the file's own counts allow?
Expected<void> check_indices(const MatchFile& file) {
  for (std::size_t r = 0; r < file.match.regions.size(); ++r) {
    if (Expected<void> fine = check_region(file, r); !fine) return fine;
  }
  for (std::size_t i = 0; i < file.match.vertices.size(); ++i) {
    const VertexPair& pair = file.match.vertices[i];
    const auto where = [i] { return fmt::format("vertices, pair {}", i); };
    if (pair.source.value >= file.source.vertices) {
      return bad_index(where(), "vertex", pair.source.value, "source", file.source.vertices);
    }
    if (pair.target.value >= file.target.vertices) {
      return bad_index(where(), "vertex", pair.target.value, "target", file.target.vertices);
    }
  }
  return {};
}

/// Divides the pairs of an array by commas, with a line break after every eighth.
void write_separator(io::TextBuffer& text, std::size_t index, std::string_view indent) {
  if (index % 8 == 0) {
    text << (index == 0 ? "\n" : ",\n") << indent;
  } else {
    text << ", ";
  }
}

void write_side(io::TextBuffer& text, std::string_view name, const MatchSide& side) {
  text << " \"" << name << "\": {\"path\": " << json_text(side.path) << ", \"vertices\": " << side.vertices
       << ", \"faces\": " << side.faces << "},\n";
}

void write_region(io::TextBuffer& text, const Region& region) {
  const Evidence& evidence = region.evidence;
  text << "  {\"orientation\": " << (region.orientation == Orientation::Reversing ? "\"reversing\"" : "\"preserving\"")
       << ",\n   \"evidence\": {\"agreeing\": " << evidence.agreeing
       << ", \"source_extraordinary\": " << evidence.source_extraordinary
       << ", \"target_extraordinary\": " << evidence.target_extraordinary << "},\n";
  if (region.ways > 1) {
    text << "   \"ways\": " << region.ways << ", \"ambiguous\": " << (region.ambiguous ? "true" : "false") << ",\n";
  }
  if (!region.waves.empty()) {
    text << "   \"waves\": [";
    for (std::size_t i = 0; i < region.waves.size(); ++i) text << (i == 0 ? "" : ", ") << region.waves[i];
    text << "],\n";
  }
  text << "   \"faces\": [";
  for (std::size_t i = 0; i < region.faces.size(); ++i) {
    const FacePair& pair = region.faces[i];
    write_separator(text, i, "    ");
    text << '[' << pair.source.value << ", " << pair.target.value << ", " << pair.rotation << ']';
  }
  text << "]}";
}

const char* answer_text(Decision decision) {
  switch (decision) {
    case Decision::Yes:
      return "yes";
    case Decision::No:
      return "no";
    default:
      return "unknown";
  }
}

void write_statistics(io::TextBuffer& text, const Optimality& optimality) {
  text << " \"statistics\": {\"proved\": " << (optimality.proved ? "true" : "false")
       << ", \"bound\": " << optimality.bound << ", \"nodes\": " << optimality.nodes;
  if (optimality.decision != Decision::NotAsked) {
    text << ", \"at_least\": " << optimality.at_least << ", \"answer\": \"" << answer_text(optimality.decision) << '"';
  }
  text << "},\n";
}

std::string counted(std::uint32_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

Expected<void> side_fits(const char* role, const MatchSide& stated, const MatchSide& given) {
  const auto misfit = [&](const std::string& expected, std::uint32_t has) {
    return Unexpected(
        Error{ErrorCode::MatchDoesNotFit, fmt::format("the match was made for a {} of {}, but {} has {}; {}", role,
                                                      expected, given.path, has, kRematch)});
  };
  if (stated.faces != given.faces) return misfit(counted(stated.faces, "face", "faces"), given.faces);
  if (stated.vertices != given.vertices) return misfit(counted(stated.vertices, "vertex", "vertices"), given.vertices);
  return {};
}

}  // namespace

Expected<MatchFile> parse_match(std::string_view bytes, const std::string& name) {
  Expected<MatchFile> file = io::parse_match_json(bytes);
  if (file) {
    if (Expected<void> fine = check_indices(*file); !fine) file = Unexpected(std::move(fine).error());
  }
  if (!file) file.error().path = name;
  return file;
}

Expected<MatchFile> read_match(const std::string& path) {
  const Expected<FileBytes> bytes = read_file(path);
  if (!bytes) return Unexpected(bytes.error());
  return parse_match(bytes->view(), path == "-" ? "standard input" : path);
}

Expected<void> fits(const MatchFile& file, const MatchSide& source, const MatchSide& target) {
  if (Expected<void> fine = side_fits("source", file.source, source); !fine) return fine;
  return side_fits("target", file.target, target);
}

std::string format_match(const MatchFile& file) {
  io::TextBuffer text;
  text.reserve(file.match.matched_faces() * 24 + file.match.vertices.size() * 20 + 1024);
  text << "{\"format\": \"" << io::kMatchFormat << "\",\n";
  write_side(text, "source", file.source);
  write_side(text, "target", file.target);
  if (!file.match.complete) text << " \"complete\": false,\n";
  if (!file.settings.empty()) {
    text << " \"settings\": {";
    for (std::size_t i = 0; i < file.settings.size(); ++i) {
      text << (i == 0 ? "" : ", ") << json_text(file.settings[i].first) << ": " << json_text(file.settings[i].second);
    }
    text << "},\n";
  }
  if (file.optimality) write_statistics(text, *file.optimality);
  text << " \"regions\": [";
  for (std::size_t i = 0; i < file.match.regions.size(); ++i) {
    text << (i == 0 ? "\n" : ",\n");
    write_region(text, file.match.regions[i]);
  }
  text << "],\n \"vertices\": [";
  for (std::size_t i = 0; i < file.match.vertices.size(); ++i) {
    write_separator(text, i, "  ");
    text << '[' << file.match.vertices[i].source.value << ", " << file.match.vertices[i].target.value << ']';
  }
  text << ']';
  for (const auto& [name, json] : file.further) text << ",\n " << json_text(name) << ": " << json;
  text << "}\n";
  return std::move(text).take();
}

Expected<void> write_match(const std::string& path, const MatchFile& file) {
  return replace_file(path, format_match(file));
}

}  // namespace quadmatch
