#include <doctest/doctest.h>

#include "batch/job_list.hpp"

using namespace quadmatch;
using namespace quadmatch::cli;

namespace {

JobList list_of(std::string_view text, const MatchingArguments& defaults = {}) {
  Expected<JobList> list = parse_job_list(text, "lists/jobs.csv", defaults);
  REQUIRE(list.has_value());
  return *std::move(list);
}

std::string refusal(std::string_view text) {
  const Expected<JobList> list = parse_job_list(text, "jobs.csv", {});
  REQUIRE(!list.has_value());
  return list.error().describe();
}

/// The fault of the only job with these cells.
std::string fault_of(std::string_view header, std::string_view row) {
  const JobList list = list_of(std::string(header) + "\n" + std::string(row) + "\n");
  REQUIRE(list.jobs.size() == 1);
  return list.jobs.front().fault;
}

}  // namespace

TEST_CASE("a job has its meshes, its file, its name and its options, in columns of any order") {
  const JobList list = list_of(
      "algorithm,target,name,source,output,min-region,no-positions,anchor\n"
      "exact,\"b, new.obj\",hand, a.obj,m.json,,yes,\n"
      ",b.obj,,a.obj,,7,no,1=2 3:0=4:1\n");
  REQUIRE(list.jobs.size() == 2);
  const Job& first = list.jobs[0];
  CHECK(first.number == 1);
  CHECK(first.line == 2);
  CHECK(first.name == "hand");
  CHECK(first.source == " a.obj");
  CHECK(first.target == "b, new.obj");
  CHECK(first.output == "m.json");
  CHECK(first.fault.empty());
  CHECK(options_text(first.matching) == "--algorithm=exact --no-positions");
  CHECK(options_text(list.jobs[1].matching) == "--anchor=1=2 --anchor=3:0=4:1 --min-region=7");
}

TEST_CASE("paths are relative to the folder of the list") {
  const JobList list = list_of("source,target\na.obj,/b.obj\n");
  CHECK(list.resolved("a.obj") == "lists/a.obj");
  CHECK(list.resolved("/b.obj") == "/b.obj");
  CHECK(parse_job_list("source,target\na,b\n", "-", {})->resolved("a") == "a");
}

TEST_CASE("an empty cell leaves an option as the command line has it, and a flag can be taken back") {
  MatchingArguments defaults;
  defaults.algorithm = "greedy";
  defaults.no_positions = true;
  const JobList list = list_of("source,target,algorithm,no-positions\na,b,,\na,b,regions,no\n", defaults);
  CHECK(options_text(list.jobs[0].matching) == "--algorithm=greedy --no-positions");
  CHECK(options_text(list.jobs[1].matching).empty());
}

TEST_CASE("a header without meshes, with unknown columns or one twice is refused, and says which there are") {
  CHECK(
      refusal("") ==
      "jobs.csv: there are no jobs; the first row names the columns, such as source,target, and each further row is a "
      "pair");
  CHECK(refusal("a.obj,b.obj\nc.obj,d.obj\n").starts_with("jobs.csv:1: \"a.obj\" is no column of a job list; "));
  CHECK(refusal("source,colour,target\na,b,c\n").find("algorithm, anchor, arc-lengths, at-least") != std::string::npos);
  CHECK(refusal("source,output\na,b\n") == "jobs.csv:1: there is no column target; name it in the first row");
  CHECK(refusal("source,target,source\na,b,c\n") == "jobs.csv:1: column source is named twice; leave one of them out");
}

TEST_CASE("a row that cannot be done has a fault and the rest goes on") {
  CHECK(fault_of("source,target", "a.obj") ==
        "the row has 1 field, but the header names 2; put fields with commas in quotes");
  CHECK(fault_of("source,target", "a.obj,") == "there is no target; name a mesh");
  CHECK(fault_of("source,target", "-,b.obj").starts_with("the source is -, but standard input"));
  CHECK(fault_of("source,target,output", "a,b,-").starts_with("the output is -"));
  CHECK(fault_of("source,target", std::string_view("a\0.obj,b", 8)) == "a path holds a zero byte; correct it");
  CHECK(fault_of("source,target,algorithm", "a,b,best") ==
        "--algorithm: best not in {exact,greedy,lazy-greedy,regions}");
  CHECK(fault_of("source,target,min-region", "a,b,-3") == "Could not convert: --min-region = -3");
  CHECK(fault_of("source,target,waves", "a,b,perhaps") == "waves: \"perhaps\" is neither yes nor no");
  CHECK(fault_of("source,target,time-limit", "a,b,3") ==
        "--time-limit needs --algorithm exact; regions ends by itself");
  const JobList list = list_of("source,target\na.obj\nb.obj,c.obj\n");
  CHECK(!list.jobs[0].fault.empty());
  CHECK(list.jobs[1].fault.empty());
  CHECK(list.jobs[1].number == 2);
}

TEST_CASE("jobs that say the same are duplicates, however they spell it, and with other options they are not") {
  const JobList list =
      list_of("source,target,no-positions,name\na,b,,one\n./a,x/../b,no,two\na,b,yes,three\nb,a,,four\na\na\n");
  CHECK(list.jobs[0].duplicate_of == 0);
  CHECK(list.jobs[1].duplicate_of == 1);
  CHECK(list.jobs[2].duplicate_of == 0);
  CHECK(list.jobs[3].duplicate_of == 0);
  CHECK(list.jobs[5].duplicate_of == 0);  // broken rows are nobody's duplicates
}

TEST_CASE("no job writes what another one reads or writes") {
  const JobList list = list_of("source,target,output\na,b,m\nc,d,./m\nc,d,b\nc,d,n\n");
  CHECK(list.jobs[0].fault.empty());
  CHECK(list.jobs[1].fault == "job 1 writes ./m already; choose another name");
  CHECK(list.jobs[2].fault == "the output b is a mesh of job 1 and would be overwritten; choose another name");
  CHECK(list.jobs[3].fault.empty());
}
