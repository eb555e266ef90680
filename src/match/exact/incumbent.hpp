#pragma once
/// The largest region found so far, and what a better one must beat.

#include <algorithm>
#include <cstdint>
#include <functional>
#include <vector>

#include <quadmatch/mesh/match.hpp>

#include "partial.hpp"

namespace quadmatch::exact {

/// Called now and then; false stops everything.
using KeepGoing = std::function<bool()>;

/// Shared by the searches of both ways round, which bound each other.
struct Incumbent {
  std::vector<Pair> pairs;
  Orientation orientation = Orientation::Preserving;
  /// A region is of interest if it has more faces than this: as many as `pairs`, or one fewer than were asked for.
  std::uint32_t to_beat = 0;
  /// As many as were asked for have been found, so nothing more is to be done.
  bool enough = false;
  std::uint32_t at_least = 0;

  /// Keep pairs that are a region, if they are more.
  /// @return true if they were.
  bool offer(const std::vector<Pair>& region, const std::vector<Pair>& and_these, Orientation laid) {
    const std::size_t size = region.size() + and_these.size();
    if (size <= pairs.size()) return false;
    pairs = region;
    pairs.insert(pairs.end(), and_these.begin(), and_these.end());
    orientation = laid;
    to_beat = std::max(to_beat, static_cast<std::uint32_t>(size));
    enough = at_least > 0 && size >= at_least;
    return true;
  }
};

/// Counts steps of work and asks every so often whether to go on.
class Budget {
 public:
  Budget(std::uint64_t node_limit, KeepGoing keep_going)
      : node_limit_(node_limit), keep_going_(std::move(keep_going)) {}

  /// One node of the search tree. False: stop.
  bool node() {
    ++nodes_;
    if (node_limit_ != 0 && nodes_ >= node_limit_) stopped_ = true;
    return work(kNode);
  }
  /// Some work besides. False: stop.
  bool work(std::uint64_t steps) {
    work_ += steps;
    if (!stopped_ && work_ >= next_question_) {
      next_question_ = work_ + kBetweenQuestions;
      if (keep_going_ && !keep_going_()) stopped_ = true;
    }
    return !stopped_;
  }
  [[nodiscard]] bool stopped() const { return stopped_; }
  [[nodiscard]] std::uint64_t nodes() const { return nodes_; }

 private:
  static constexpr std::uint64_t kNode = 1024, kBetweenQuestions = 256 * kNode;

  std::uint64_t node_limit_;
  KeepGoing keep_going_;
  std::uint64_t nodes_ = 0, work_ = 0, next_question_ = kBetweenQuestions;
  bool stopped_ = false;
};

}  // namespace quadmatch::exact
