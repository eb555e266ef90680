#include "match_options.hpp"

#include <array>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "words.hpp"

namespace quadmatch::python {
namespace {

/// Do the options of the exact search go together with the rest?
Expected<void> exact_options_fit(const MatchWords& words) {
  const bool exact = words.algorithm == "exact";
  if (!exact && (words.time_limit != 0 || words.at_least != 0)) {
    return refuse(fmt::format("{} needs algorithm='exact'; {} ends by itself",
                              words.at_least != 0 ? "at_least" : "time_limit", words.algorithm));
  }
  if (exact && !words.anchors.empty()) {
    return refuse("algorithm='exact' looks at all places and takes no anchors; leave them out, or use regions");
  }
  return {};
}

Expected<HalfedgeId> corner_at(const Mesh& mesh, const char* name, std::int64_t face, std::int64_t corner) {
  if (face < 0 || face >= mesh.face_count()) {
    return refuse(
        fmt::format("anchors: the {} has no face {}; its faces are 0 to {}", name, face, mesh.face_count() - 1));
  }
  const FaceId f(static_cast<std::uint32_t>(face));
  if (corner < 0 || corner >= mesh.size(f)) {
    return refuse(fmt::format("anchors: face {} of the {} has no corner {}; its corners are 0 to {}", face, name,
                              corner, mesh.size(f) - 1));
  }
  return HalfedgeId(mesh.first(f).value + static_cast<std::uint32_t>(corner));
}

Expected<UserAnchor> anchor_of(const std::array<std::int64_t, 4>& row, const Mesh& source, const Mesh& target) {
  const Expected<HalfedgeId> from = corner_at(source, "source", row[0], row[1]);
  if (!from) return Unexpected(from.error());
  const Expected<HalfedgeId> to = corner_at(target, "target", row[2], row[3]);
  if (!to) return Unexpected(to.error());
  const UserAnchor anchor{*from, *to};
  if (Expected<void> fine = check_anchor(source, target, anchor); !fine) return Unexpected(fine.error());
  return anchor;
}

Expected<void> add_anchors(const MatchWords& words, const Mesh& source, const Mesh& target, MatchOptions& options) {
  for (const std::array<std::int64_t, 4>& row : words.anchors) {
    const Expected<UserAnchor> anchor = anchor_of(row, source, target);
    if (!anchor) return Unexpected(anchor.error());
    options.anchors.push_back(*anchor);
  }
  return {};
}

Expected<void> leave_out(const MatchWords& words, Stages& stages) {
  for (const std::string& word : words.without) {
    const Expected<bool Stages::*> stage = meaning(kStageWords, "without", word);
    if (!stage) return Unexpected(stage.error());
    stages.** stage = false;
  }
  return {};
}

}  // namespace

Expected<OrientationChoice> orientation_of(const std::string& word) {
  return meaning(kOrientationWords, "orientation", word);
}

Expected<MatchOptions> options_of(const MatchWords& words, const Mesh& source, const Mesh& target) {
  const Expected<Algorithm> algorithm = meaning(kAlgorithmWords, "algorithm", words.algorithm);
  if (!algorithm) return Unexpected(algorithm.error());
  const Expected<OrientationChoice> orientation = orientation_of(words.orientation);
  if (!orientation) return Unexpected(orientation.error());
  if (Expected<void> fine = exact_options_fit(words); !fine) return Unexpected(fine.error());
  if (Expected<void> fine = check_share("min_confidence", words.least_confidence); !fine) {
    return Unexpected(fine.error());
  }
  MatchOptions options{.algorithm = *algorithm,
                       .orientation = *orientation,
                       .positions = words.positions,
                       .least_confidence = words.least_confidence,
                       .least_region = words.least_region,
                       .at_least = words.at_least,
                       .waves = words.waves};
  options.anchor_search.rounds = words.rounds;
  options.anchor_search.colouring.arc_lengths = words.arc_lengths;
  if (Expected<void> fine = leave_out(words, options.stages); !fine) return Unexpected(fine.error());
  if (Expected<void> fine = add_anchors(words, source, target, options); !fine) return Unexpected(fine.error());
  return options;
}

std::vector<std::pair<std::string, std::string>> settings_of(const MatchWords& words) {
  std::vector<std::pair<std::string, std::string>> settings{{"program", "quadmatch " QUADMATCH_VERSION " (Python)"},
                                                            {"algorithm", words.algorithm},
                                                            {"orientation", words.orientation},
                                                            {"rounds", std::to_string(words.rounds)},
                                                            {"arc_lengths", words.arc_lengths ? "true" : "false"},
                                                            {"positions", words.positions ? "true" : "false"}};
  if (words.time_limit != 0) settings.emplace_back("time_limit", fmt::format("{}", words.time_limit));
  if (words.at_least != 0) settings.emplace_back("at_least", fmt::format("{}", words.at_least));
  if (!words.without.empty()) settings.emplace_back("without", fmt::format("{}", fmt::join(words.without, " ")));
  std::string anchors;
  for (const auto& [f, i, g, k] : words.anchors) {
    anchors += fmt::format("{}{}:{}={}:{}", anchors.empty() ? "" : " ", f, i, g, k);
  }
  if (!anchors.empty()) settings.emplace_back("anchors", std::move(anchors));
  return settings;
}

}  // namespace quadmatch::python
