// What the program says about itself, and to those who hold it wrong.

#include <doctest/doctest.h>

#include <algorithm>
#include <sstream>

#include "program.hpp"

using namespace quadmatch::test;

namespace {

const std::vector<std::string> kVerbs{"match", "transfer", "symmetry", "merge",       "verify", "check",
                                      "diff",  "skeleton", "batch",    "batch-merge", "index",  "find"};

std::size_t longest_line(const std::string& text) {
  std::size_t longest = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) longest = std::max(longest, line.size());
  return longest;
}

}  // namespace

TEST_CASE("--help names every verb, an example and the exit statuses, on standard output") {
  const Folder folder;
  const Outcome help = folder.run({"--help"});
  CHECK(help.status == 0);
  CHECK(help.err.empty());
  for (const std::string& verb : kVerbs) CHECK(contains(help.out, "\n  " + verb + " "));
  CHECK(contains(help.out, "Examples:\n  quadmatch match "));
  CHECK(contains(help.out, "Exit status: 0 same, 1 different, 2 trouble"));
  CHECK(folder.run({"-h"}).out == help.out);
}

TEST_CASE("the help of every verb has a usage line, options, examples and exit statuses, and fits a terminal") {
  const Folder folder;
  for (const std::string& verb : kVerbs) {
    CAPTURE(verb);
    const Outcome help = folder.run({verb, "--help"});
    CHECK(help.status == 0);
    CHECK(help.err.empty());
    const std::string takes = verb == "merge"         ? "BASE OURS THEIRS"
                              : verb == "batch"       ? "JOBS"
                              : verb == "batch-merge" ? "FOLDER"
                              : verb == "index"       ? "FOLDER"
                              : verb == "find"        ? "MESH LIBRARY"
                                                      : "A";
    CHECK(contains(help.out, "Usage: quadmatch " + verb + " [OPTIONS] " + takes));
    CHECK(contains(help.out, "\n  --json "));
    CHECK(contains(help.out, "\n  --quiet "));
    CHECK(contains(help.out, "\nExamples:\n  quadmatch " + verb + " "));
    CHECK(contains(help.out, "\nExit status: 0"));
    CHECK(longest_line(help.out) <= 100);
  }
}

TEST_CASE("the help of match states defaults and shows every form of an anchor") {
  const Outcome help = Folder().run({"match", "--help"});
  for (const char* part : {"(default: regions)", "(default: auto)", "(default: 10)", "--anchor 12:0=90:1",
                           "--anchor 5-6=31-30", "--anchor 5=31", "1 nothing matched"}) {
    CAPTURE(part);
    CHECK(contains(help.out, part));
  }
}

TEST_CASE("--version prints one line") {
  const Outcome version = Folder().run({"--version"});
  CHECK(version.status == 0);
  CHECK(version.out.rfind("quadmatch ", 0) == 0);
  CHECK(line_count(version.out) == 1);
  CHECK(version.err.empty());
}

TEST_CASE("wrong usage is one line on standard error with a hint, and exit status 2") {
  struct Case {
    std::vector<std::string> arguments;
    std::string message;
  };
  const std::vector<Case> cases{
      {{}, "what is to be done? Name a verb, such as match; see quadmatch --help"},
      {{"mtach", "a", "b"}, "there is no verb or option mtach; see quadmatch --help"},
      {{"--colour"}, "there is no verb or option --colour; see quadmatch --help"},
      {{"match"}, "A is required; see quadmatch match --help"},
      {{"match", "a.obj"}, "B is required; see quadmatch match --help"},
      {{"verify", "a.obj", "b.obj"}, "M is required; see quadmatch verify --help"},
      {{"check"}, "A is required; see quadmatch check --help"},
      {{"diff", "a.obj"}, "B is required; see quadmatch diff --help"},
      {{"diff", "a.obj", "b.obj", "-o", "m.json"},
       "-o writes the map of --isomorphic; for a match of parts see quadmatch match"},
      {{"diff", "a", "b", "--isomorphic", "-o", "-"},
       "-o - would mix figures and map on standard output; write the map to a file, or say --quiet"},
      {{"skeleton"}, "A is required; see quadmatch skeleton --help"},
      {{"match", "a", "b", "--fast"}, "The following argument was not expected: --fast; see quadmatch match --help"},
      {{"match", "a", "b", "--rounds", "many"}, "Could not convert: --rounds = many; see quadmatch match --help"},
      {{"match", "a", "b", "--algorithm", "x"},
       "--algorithm: x not in {exact,greedy,lazy-greedy,regions}; see quadmatch match --help"},
      {{"match", "a", "b", "--orientation", "x"},
       "--orientation: x not in {auto,preserving,reversing}; see quadmatch match --help"},
  };
  const Folder folder;
  for (const Case& wrong : cases) {
    CAPTURE(wrong.message);
    const Outcome outcome = folder.run(wrong.arguments);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err == "quadmatch: " + wrong.message + "\n");
  }
  CHECK(folder.names().empty());
}
