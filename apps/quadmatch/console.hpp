#pragma once
/// What the program says and where: data on standard output, messages on standard error.

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

#include <quadmatch/mesh/error.hpp>

namespace quadmatch::cli {

/// Exit statuses, as of `diff`.
constexpr int kSame = 0;
constexpr int kDifferent = 1;
constexpr int kTrouble = 2;
/// Neither: the search for an answer was stopped.
constexpr int kUnknown = 3;

/// `quadmatch: what`, one line on standard error.
void complain(std::string_view what);
/// The same for an Error of the library. @return kTrouble
int complain(const Error& error);
/// `quadmatch: warning: what`.
void warn(std::string_view what);

/// Write data to standard output. @return false, after a complaint, where it cannot be written (a full disk).
bool print(std::string_view text);

/// One line on a terminal that says how far the work is, rewritten in place and cleared at the end. It appears when
/// work has lasted a second, never where standard error is not a terminal, and makes way for messages.
class Progress {
 public:
  explicit Progress(bool wanted);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress() { clear(); }

  /// Is there anybody to look at it?
  [[nodiscard]] bool visible() const { return visible_; }
  /// What is being done now: "reading a.obj".
  void stage(const std::string& what);
  /// A line as it is, not more often than one can read.
  void line(const std::string& text) { show(text); }
  /// And how far.
  void update(std::size_t done, std::size_t most);
  void clear();

 private:
  void show(const std::string& line);

  using Clock = std::chrono::steady_clock;
  bool visible_;
  std::string stage_;
  Clock::time_point began_ = Clock::now();
  Clock::time_point last_shown_ = {};
};

/// Milliseconds since it was made or last asked.
class Stopwatch {
 public:
  double lap();

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point began_ = Clock::now();
};

}  // namespace quadmatch::cli
