#pragma once
/// What a reader met and did not keep, counted by name for its notes.

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "line_scanner.hpp"

namespace quadmatch::io {

/// A hostile file may invent many names: beyond a few they are counted as one.
class PassedOver {
 public:
  void add(std::string_view name) {
    const auto known =
        std::find_if(counts_.begin(), counts_.end(), [name](const auto& count) { return count.first == name; });
    if (known != counts_.end()) {
      ++known->second;
    } else if (counts_.size() < kMostNames) {
      counts_.emplace_back(name, 1);
    } else {
      ++others_;
    }
  }

  /// "3 'vp' records were passed over", where `noun` is "record".
  void append_notes(std::string_view noun, std::vector<std::string>& notes) const {
    for (const auto& [name, count] : counts_) {
      notes.push_back(count == 1 ? fmt::format("1 {} {} was passed over", in_quotes(name), noun)
                                 : fmt::format("{} {} {}s were passed over", count, in_quotes(name), noun));
    }
    if (others_ > 0) notes.push_back(fmt::format("{} {}s of other names were passed over", others_, noun));
  }

 private:
  static constexpr std::size_t kMostNames = 8;
  std::vector<std::pair<std::string, std::size_t>> counts_;
  std::size_t others_ = 0;
};

}  // namespace quadmatch::io
