#include "console.hpp"

#include <cstdio>

#include <unistd.h>

#include <fmt/format.h>

#include "text.hpp"

namespace quadmatch::cli {
namespace {

/// Is a line of progress on the terminal now? There is one terminal, so there is one answer.
bool progress_shown = false;

void clear_progress() {
  if (!progress_shown) return;
  progress_shown = false;
  fmt::print(stderr, "\r\x1b[K");
  std::fflush(stderr);
}

}  // namespace

void complain(std::string_view what) {
  clear_progress();
  fmt::print(stderr, "quadmatch: {}\n", what);
}

int complain(const Error& error) {
  complain(error.describe());
  return kTrouble;
}

void warn(std::string_view what) { complain(fmt::format("warning: {}", what)); }

bool print(std::string_view text) {
  clear_progress();
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0) return true;
  complain("standard output cannot be written; make room or choose another place");
  return false;
}

Progress::Progress(bool wanted) : visible_(wanted && ::isatty(STDERR_FILENO) == 1) {}

void Progress::stage(const std::string& what) {
  stage_ = what;
  last_shown_ = {};
  show(what);
}

void Progress::update(std::size_t done, std::size_t most) {
  show(fmt::format("{}: {} of at most {} faces", stage_, grouped(done), grouped(most)));
}

void Progress::show(const std::string& line) {
  const Clock::time_point now = Clock::now();
  const bool too_early = now - began_ < std::chrono::seconds(1);
  const bool too_often = now - last_shown_ < std::chrono::milliseconds(100);
  if (!visible_ || too_early || too_often) return;
  last_shown_ = now;
  progress_shown = true;
  fmt::print(stderr, "\r\x1b[K{}", line);
  std::fflush(stderr);
}

void Progress::clear() { clear_progress(); }

double Stopwatch::lap() {
  const Clock::time_point now = Clock::now();
  const std::chrono::duration<double, std::milli> passed = now - began_;
  began_ = now;
  return passed.count();
}

}  // namespace quadmatch::cli
