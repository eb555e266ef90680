#pragma once
/// The sentence for a word that stands for no choice.

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include <quadmatch/match/words.hpp>
#include <quadmatch/mesh/expected.hpp>

namespace quadmatch::python {

[[nodiscard]] inline Unexpected<Error> refuse(std::string message) {
  return Unexpected(Error{ErrorCode::BadArgument, std::move(message)});
}

/// @par Errors  BadArgument, naming the argument and all the words there are.
template <class Meaning, std::size_t kCount>
[[nodiscard]] Expected<Meaning> meaning(const Words<Meaning, kCount>& words, const char* argument,
                                        std::string_view word) {
  std::string all;
  for (std::size_t k = 0; k < kCount; ++k) {
    if (words[k].first == word) return words[k].second;
    all += fmt::format("{}{}", k == 0 ? "" : k + 1 == kCount ? " or " : ", ", words[k].first);
  }
  return refuse(fmt::format("{}: there is no '{}'; give {}", argument, word, all));
}

[[nodiscard]] inline Expected<void> check_share(const char* argument, double share) {
  if (share >= 0 && share <= 1) return {};
  return refuse(fmt::format("{}: {} is no share; give a number from 0 to 1", argument, share));
}

}  // namespace quadmatch::python
