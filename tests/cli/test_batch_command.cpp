#include <doctest/doctest.h>

#include <csignal>
#include <memory>
#include <sstream>

#include <fcntl.h>
#include <sqlite3.h>
#include <sys/file.h>
#include <unistd.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <quadmatch/shapes/edit.hpp>
#include <quadmatch/shapes/renumber.hpp>
#include <quadmatch/shapes/zoo.hpp>

#include "program.hpp"

using namespace quadmatch;
using namespace quadmatch::test;
using Json = nlohmann::json;

namespace {

/// a.obj and b.obj: a star and the same renumbered; c.obj: another shape; jobs.csv: three pairs, one with a match file.
void write_pairs(const Folder& folder) {
  const PolygonSoup star = shapes::star(5, 4);
  folder.write("a.obj", star);
  folder.write("b.obj", shapes::renumbered(star, 3).soup);
  folder.write("c.obj", shapes::grating(2, 2));
  folder.write("jobs.csv",
               "source,target,output,algorithm\na.obj,b.obj,ab.json,\nb.obj,a.obj,,lazy-greedy\na.obj,c.obj,,\n");
}

std::vector<Json> lines_of(const Folder& folder, const std::string& results = "R") {
  std::vector<Json> lines;
  std::istringstream text(folder.read(results + "/results.jsonl"));
  for (std::string line; std::getline(text, line);) lines.push_back(Json::parse(line));
  return lines;
}

/// The database of another program that looks at ours.
class Sql {
 public:
  Sql(const Folder& folder, const std::string& name) {
    sqlite3* raw = nullptr;
    REQUIRE(sqlite3_open(folder.path(name).c_str(), &raw) == SQLITE_OK);
    database_.reset(raw);
  }
  void run(const std::string& sql) const {
    REQUIRE(sqlite3_exec(database_.get(), sql.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK);
  }
  [[nodiscard]] std::string text(const std::string& sql) const {
    std::string all;
    const auto add = [](void* into, int count, char** cells, char**) {
      std::string& text_of_all = *static_cast<std::string*>(into);
      for (int k = 0; k < count; ++k) text_of_all.append(cells[k] != nullptr ? cells[k] : "null").append(1, ' ');
      return 0;
    };
    REQUIRE(sqlite3_exec(database_.get(), sql.c_str(), add, &all, nullptr) == SQLITE_OK);
    return all;
  }

 private:
  struct Close {
    void operator()(sqlite3* database) const { sqlite3_close(database); }
  };
  std::unique_ptr<sqlite3, Close> database_;
};

}  // namespace

TEST_CASE("every pair of the list has a row in the database and a line of JSON, in the order of the list") {
  const Folder folder;
  write_pairs(folder);
  const Outcome outcome = folder.run({"batch", "jobs.csv", "-o", "R"});
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  CHECK(contains(outcome.out, "jobs     jobs.csv: 3 pairs\n"));
  CHECK(contains(outcome.out, "written  R/results.sqlite\n         R/results.jsonl\n"));
  const std::vector<Json> lines = lines_of(folder);
  REQUIRE(lines.size() == 3);
  CHECK(lines[0]["job"] == 1);
  CHECK(lines[0]["status"] == "matched");
  CHECK(lines[0]["source"] == "a.obj");
  CHECK(lines[0]["matched_faces"] == 80);
  CHECK(lines[0]["confidence"] == 1.0);
  CHECK(lines[0]["error"].is_null());
  CHECK(lines[1]["options"] == "--algorithm=lazy-greedy");
  const Sql sql(folder, "R/results.sqlite");
  CHECK(sql.text("SELECT job, line, source_faces, matched_faces, regions FROM pairs WHERE job = 1") == "1 2 80 80 1 ");
  CHECK(sql.text("SELECT count(*) FROM pairs WHERE matching_ms >= 0 AND reading_ms > 0") == "3 ");
  CHECK(sql.text("PRAGMA user_version") == "1 ");
}

TEST_CASE("a match file of batch is that of match, byte by byte") {
  const Folder folder;
  write_pairs(folder);
  CHECK(folder.run({"batch", "jobs.csv", "-o", "R", "--quiet"}).status == 0);
  CHECK(folder.run({"match", "a.obj", "b.obj", "-o", "m.json", "--quiet"}).status == 0);
  CHECK((folder.read("ab.json") == folder.read("m.json")));
}

TEST_CASE("one thread or many, in one go or by shards that are merged: the lines are the same bytes") {
  const Folder folder;
  write_pairs(folder);
  folder.run({"batch", "jobs.csv", "-o", "R", "--threads", "1"});
  folder.run({"batch", "jobs.csv", "-o", "R8", "--threads", "8"});
  CHECK(folder.run({"batch", "jobs.csv", "-o", "S1", "--shard", "1/2"}).status == 0);
  CHECK(folder.run({"batch", "jobs.csv", "-o", "S2", "--shard", "2/2"}).status == 0);
  CHECK(lines_of(folder, "S1").size() == 2);
  const Outcome merged = folder.run({"batch-merge", "S2", "S1", "-o", "M"});
  CHECK(merged.status == 0);
  CHECK(contains(merged.out, "merged   3 pairs of 2 folders\n"));
  CHECK((folder.read("R/results.jsonl") == folder.read("R8/results.jsonl")));
  CHECK((folder.read("R/results.jsonl") == folder.read("M/results.jsonl")));
}

TEST_CASE("a merge names what is missing, may be done again, and never replaces what batch made") {
  const Folder folder;
  write_pairs(folder);
  folder.run({"batch", "jobs.csv", "-o", "S1", "--shard", "1/2"});
  const Outcome partial = folder.run({"batch-merge", "S1", "-o", "M"});
  CHECK(partial.status == 1);
  CHECK(contains(partial.out, "missing  1 pair (job 2); run their shards, then merge again\n"));
  folder.run({"batch", "jobs.csv", "-o", "S2", "--shard", "2/2"});
  CHECK(folder.run({"batch-merge", "S1", "S2", "-o", "M"}).status == 0);
  CHECK(lines_of(folder, "M").size() == 3);
  const Outcome refused = folder.run({"batch-merge", "S1", "S2", "-o", "S1"});
  CHECK(refused.status == 2);
  CHECK(refused.err == "quadmatch: S1: these are results of batch and would be lost; choose another folder\n");
  CHECK(folder.run({"batch-merge", "S1", "nowhere", "-o", "N"}).status == 2);
}

TEST_CASE("results of different lists are not merged") {
  const Folder folder;
  write_pairs(folder);
  folder.write("other.csv", "source,target\na.obj,b.obj\n");
  folder.run({"batch", "jobs.csv", "-o", "S1"});
  folder.run({"batch", "other.csv", "-o", "S2"});
  const Outcome outcome = folder.run({"batch-merge", "S1", "S2", "-o", "M"});
  CHECK(outcome.status == 2);
  CHECK(outcome.err ==
        "quadmatch: S2: these results are of another job list (other.csv) than those in S1 (jobs.csv); merge what "
        "belongs to one list\n");
}

TEST_CASE("what is done is not done again, and rows may be added at the end of the list") {
  const Folder folder;
  write_pairs(folder);
  folder.run({"batch", "jobs.csv", "-o", "R"});
  Sql(folder, "R/results.sqlite").run("UPDATE pairs SET matching_ms = 12345");
  folder.write("jobs.csv", folder.read("jobs.csv") + "c.obj,b.obj,,\n");
  const Outcome outcome = folder.run({"batch", "jobs.csv", "-o", "R"});
  CHECK(outcome.status == 0);
  CHECK(contains(outcome.out, "before   3 were done already\n"));
  CHECK(lines_of(folder).size() == 4);
  CHECK(Sql(folder, "R/results.sqlite").text("SELECT count(*) FROM pairs WHERE matching_ms = 12345") == "3 ");
}

TEST_CASE("results of a list that was changed are not mixed with it") {
  const Folder folder;
  write_pairs(folder);
  folder.run({"batch", "jobs.csv", "-o", "R"});
  const std::string before = folder.read("R/results.jsonl");
  folder.write("jobs.csv", "source,target\nc.obj,b.obj\n");
  const Outcome fewer = folder.run({"batch", "jobs.csv", "-o", "R"});
  CHECK(fewer.status == 2);
  CHECK(fewer.err ==
        "quadmatch: jobs.csv: there are 1 job, but job 3 was done before; take another folder for a changed list (rows "
        "may be added at its end)\n");
  folder.write("jobs.csv", "source,target\nc.obj,b.obj\nb.obj,a.obj\na.obj,c.obj\n");
  const Outcome other = folder.run({"batch", "jobs.csv", "-o", "R"});
  CHECK(other.status == 2);
  CHECK(contains(other.err, "job 1 is c.obj with b.obj here, but a.obj with b.obj was done under this number; "));
  CHECK((folder.read("R/results.jsonl") == before));
}

TEST_CASE("a pair that fails is recorded and the rest goes on") {
  const Folder folder;
  write_pairs(folder);
  folder.write("bad.obj", "v 0 0 0\nf 1 2 9\n");
  folder.write("jobs.csv",
               "source,target,output\nnone.obj,b.obj,\nbad.obj,b.obj,\na.obj\n\"a\"x,b.obj,\na.obj,b.obj,no/m.json\n"
               "a.obj,.,\na.obj,b.obj,\na.obj,b.obj,\n");
  const Outcome outcome = folder.run({"batch", "jobs.csv", "-o", "R"});
  CHECK(outcome.status == 1);
  CHECK(contains(outcome.out, "done     1 matched, 6 failed, 1 duplicate\n"));
  CHECK(contains(outcome.out,
                 "trouble  job 1: none.obj: there is no such file; check the name and the folder\n"
                 "         the rest stands in the results under status and error\n"));
  const std::vector<Json> lines = lines_of(folder);
  REQUIRE(lines.size() == 8);
  CHECK(contains(lines[1]["error"].get<std::string>(), "bad.obj:2: vertex 2 is named"));
  CHECK(contains(lines[2]["error"].get<std::string>(), "line 4: the row has 1 field"));
  CHECK(contains(lines[3]["error"].get<std::string>(), "line 5: a quote stands inside"));
  CHECK(contains(lines[4]["error"].get<std::string>(), "no/m.json: "));
  CHECK(lines[5]["status"] == "failed");
  CHECK(lines[6]["status"] == "matched");
  CHECK(lines[7]["status"] == "duplicate");
  CHECK(lines[7]["error"] == "the same as job 7, which is done instead");
}

TEST_CASE("what failed stays so until --retry, or until its row is another") {
  const Folder folder;
  write_pairs(folder);
  folder.write("jobs.csv", "source,target\nlate.obj,b.obj\ntypo.obj,b.obj\n");
  CHECK(folder.run({"batch", "jobs.csv", "-o", "R"}).status == 1);
  folder.write("late.obj", folder.read("a.obj"));
  CHECK(folder.run({"batch", "jobs.csv", "-o", "R"}).status == 1);
  CHECK(lines_of(folder)[0]["status"] == "failed");
  CHECK(folder.run({"batch", "jobs.csv", "-o", "R", "--retry"}).status == 1);
  CHECK(lines_of(folder)[0]["status"] == "matched");
  folder.write("jobs.csv", "source,target\nlate.obj,b.obj\na.obj,b.obj\n");
  CHECK(folder.run({"batch", "jobs.csv", "-o", "R"}).status == 0);
}

TEST_CASE("a pair that may need more memory than allowed is refused, and done when more is allowed") {
  const Folder folder;
  write_pairs(folder);
  folder.write("big.obj", shapes::sphere(60));
  folder.write("jobs.csv", "source,target\nbig.obj,big.obj\na.obj,b.obj\n");
  const Outcome outcome = folder.run({"batch", "jobs.csv", "-o", "R", "--memory", "4M"});
  CHECK(outcome.status == 1);
  CHECK(contains(outcome.out, "done     1 matched, 1 refused\n"));
  CHECK(lines_of(folder)[0]["status"] == "refused");
  CHECK(contains(lines_of(folder)[0]["error"].get<std::string>(), " are allowed; give more by --memory"));
  CHECK(lines_of(folder)[1]["status"] == "matched");
  CHECK(folder.run({"batch", "jobs.csv", "-o", "R", "--memory", "1G"}).status == 0);
  CHECK(lines_of(folder)[0]["matched_faces"] == 6 * 60 * 60);
}

TEST_CASE("paths may have blanks, commas, quotes, line breaks, and bytes that are no UTF-8") {
  const Folder folder;
  write_pairs(folder);
  const std::vector<std::string> names{" a b .obj",  "a,b.obj",   "a\"b.obj", "a\nb.obj",
                                       "a\r\nb.obj", "a\xff.obj", "-a.obj"};
  std::string list = "source,target\n";
  for (const std::string& name : names) {
    folder.write(name, folder.read("a.obj"));
    std::string quoted;
    for (const char c : name) quoted.append(c == '"' ? 2 : 1, c);
    list += fmt::format("\"{}\",b.obj\n", quoted);
  }
  folder.write("jobs.csv", list);
  CHECK(folder.run({"batch", "jobs.csv", "-o", "a \n folder"}).status == 0);
  const Sql sql(folder, "a \n folder/results.sqlite");
  CHECK(sql.text("SELECT count(*) FROM pairs WHERE status = 'matched'") == "7 ");
  CHECK(sql.text("SELECT source FROM pairs WHERE job = 4") == "a\nb.obj ");
  CHECK(sql.text("SELECT source FROM pairs WHERE job = 6") == "a\xff.obj ");
}

TEST_CASE("paths are relative to the folder of the list, and to the current one for a list on standard input") {
  const Folder folder;
  write_pairs(folder);
  std::filesystem::create_directory(folder.path("lists"));
  folder.write("lists/jobs.csv", "source,target,output\n../a.obj,../b.obj,m.json\n");
  CHECK(folder.run({"batch", "lists/jobs.csv", "-o", "R"}).status == 0);
  CHECK(folder.has("lists/m.json"));
  CHECK(folder.run({"batch", "-", "-o", "R2"}, "source,target\na.obj,b.obj\n").status == 0);
}

TEST_CASE("a second process is told who writes into the folder") {
  const Folder folder;
  write_pairs(folder);
  std::filesystem::create_directory(folder.path("R"));
  folder.write("R/lock", "process 17 on elsewhere");
  const int held = ::open(folder.path("R/lock").c_str(), O_RDWR | O_CLOEXEC);
  REQUIRE(::flock(held, LOCK_EX) == 0);
  const Outcome outcome = folder.run({"batch", "jobs.csv", "-o", "R"});
  CHECK(outcome.status == 2);
  CHECK(outcome.err ==
        "quadmatch: R: process 17 on elsewhere writes its results here; wait for it, or choose another folder\n");
  ::close(held);
  CHECK(folder.run({"batch", "jobs.csv", "-o", "R"}).status == 0);
}

TEST_CASE("a database that another program holds ends the run with a hint, and the next run goes on") {
  const Folder folder;
  write_pairs(folder);
  folder.run({"batch", "jobs.csv", "-o", "R", "--shard", "1/2"});
  {
    const Sql other(folder, "R/results.sqlite");
    other.run("BEGIN EXCLUSIVE");
    const Outcome outcome = folder.run({"batch", "jobs.csv", "-o", "R"});
    CHECK(outcome.status == 2);
    CHECK(contains(outcome.err, "R/results.sqlite: another program holds this database; end it, then run the same"));
  }
  CHECK(folder.run({"batch", "jobs.csv", "-o", "R"}).status == 0);
  CHECK(lines_of(folder).size() == 3);
}

TEST_CASE("who reads the database keeps nobody from writing it") {
  const Folder folder;
  write_pairs(folder);
  folder.run({"batch", "jobs.csv", "-o", "R", "--shard", "1/2"});
  const Sql reader(folder, "R/results.sqlite");
  reader.run("PRAGMA journal_mode = WAL; BEGIN");
  CHECK(reader.text("SELECT count(*) FROM pairs") == "2 ");
  CHECK(folder.run({"batch", "jobs.csv", "-o", "R"}).status == 0);
  reader.run("COMMIT");
  CHECK(reader.text("SELECT count(*) FROM pairs") == "3 ");
}

TEST_CASE("where there is no room for the database, the run ends with a hint, and the next run goes on") {
  const Folder folder;
  write_pairs(folder);
  std::string list = "source,target,name\n";
  for (int k = 0; k < 60; ++k) list += fmt::format("a.obj,b{}.obj,{:x>3000}\n", k, "");
  folder.write("jobs.csv", list);
  for (int k = 0; k < 60; ++k) folder.write(fmt::format("b{}.obj", k), folder.read("b.obj"));
  const Outcome full = folder.shell("trap '' XFSZ; ulimit -f 100; exec \"$QUADMATCH\" batch jobs.csv -o R");
  CHECK(full.status == 2);
  CHECK(full.err.starts_with("quadmatch: R/results.sqlite: "));
  CHECK(contains(full.err, "run the same command again, which goes on from here"));
  CHECK(folder.run({"batch", "jobs.csv", "-o", "R"}).status == 0);
  CHECK(lines_of(folder).size() == 60);
}

TEST_CASE("a pair that brings the whole program down ends two runs, and is recorded as failed by the third") {
  const Folder folder;
  write_pairs(folder);
  folder.write("big.obj", shapes::sphere(60));
  folder.write("jobs.csv", "source,target,output\na.obj,b.obj,\nbig.obj,big.obj,big.json\nb.obj,c.obj,\n");
  // The match file is larger than a file may be, and the system ends who writes it.
  const std::string script = "ulimit -f 400; exec \"$QUADMATCH\" batch jobs.csv -o R --threads 1";
  CHECK(folder.shell(script).status == 128 + SIGXFSZ);
  CHECK(folder.shell(script).status == 128 + SIGXFSZ);
  const Outcome third = folder.shell(script);
  CHECK(third.status == 1);
  CHECK(contains(third.out, "done     1 matched, 1 with nothing in common, 1 failed\n"));
  CHECK(contains(lines_of(folder).at(1)["error"].get<std::string>(), "the program is ended by signal 25 ("));
  CHECK(folder.run({"batch", "jobs.csv", "-o", "R", "--retry"}).status == 0);
  CHECK(lines_of(folder).at(1)["status"] == "matched");
}

TEST_CASE("a database of another version, of something else, or none at all is left as it is") {
  const Folder folder;
  write_pairs(folder);
  folder.run({"batch", "jobs.csv", "-o", "R"});
  Sql(folder, "R/results.sqlite").run("PRAGMA user_version = 2");
  const Outcome newer = folder.run({"batch", "jobs.csv", "-o", "R"});
  CHECK(newer.status == 2);
  CHECK(contains(newer.err, "these results are of version 2 and this program writes version 1; "));

  std::filesystem::create_directory(folder.path("S"));
  Sql(folder, "S/results.sqlite").run("CREATE TABLE recipes (name)");
  const std::string recipes = folder.read("S/results.sqlite");
  const Outcome other = folder.run({"batch", "jobs.csv", "-o", "S"});
  CHECK(other.status == 2);
  CHECK(other.err == "quadmatch: S/results.sqlite: this database is not one of batch; choose another folder\n");
  CHECK((folder.read("S/results.sqlite") == recipes));

  std::filesystem::create_directory(folder.path("T"));
  folder.write("T/results.sqlite", "Dear diary, this is no database, whatever it is called.\n");
  const Outcome text = folder.run({"batch", "jobs.csv", "-o", "T"});
  CHECK(text.status == 2);
  CHECK(contains(text.err, "T/results.sqlite: this is no database, or a damaged one; "));

  const Outcome file = folder.run({"batch", "jobs.csv", "-o", "a.obj"});
  CHECK(file.status == 2);
  CHECK(contains(file.err, "a.obj: cannot be a folder of results: "));
}

TEST_CASE("a dirty mesh is remarked on, and an exact search leaves what it proved") {
  const Folder folder;
  folder.write("a.obj", shapes::grid(3, 3));
  folder.write("dirty.obj", obj_of(shapes::grid(3, 3)) + "v 9 9 9\n");
  folder.write("jobs.csv", "source,target,algorithm,at-least\na.obj,dirty.obj,exact,9\n");
  CHECK(folder.run({"batch", "jobs.csv", "-o", "R"}).status == 0);
  const Json line = lines_of(folder).at(0);
  CHECK(contains(line["remarks"].get<std::string>(), "dirty.obj: "));
  CHECK(line["answer"] == "yes");
  CHECK(line["bound"] == 9);
}

TEST_CASE("--json gives the counts, --quiet nothing") {
  const Folder folder;
  write_pairs(folder);
  const Outcome figures = folder.run({"batch", "jobs.csv", "-o", "R", "--json"});
  const Json json = Json::parse(figures.out);
  CHECK(json["jobs"] == 3);
  CHECK(json["done_before"] == 0);
  CHECK(json["failed"] == 0);
  const Outcome quiet = folder.run({"batch", "jobs.csv", "-o", "R", "--quiet"});
  CHECK(quiet.out.empty());
  CHECK(quiet.err.empty());
}

TEST_CASE("wrong options of batch are one line and exit status 2") {
  const Folder folder;
  write_pairs(folder);
  const auto said = [&folder](const std::vector<std::string>& more) {
    std::vector<std::string> words{"batch", "jobs.csv", "-o", "R"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = folder.run(words);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    return outcome.err;
  };
  CHECK(contains(said({"--shard", "3/2"}), "--shard 3/2: this is no shard; write i/n"));
  CHECK(contains(said({"--memory", "lots"}), "see quadmatch batch --help\n"));
  CHECK(contains(said({"--time-limit", "3"}), "--time-limit needs --algorithm exact"));
  CHECK(folder.run({"batch", "nowhere.csv", "-o", "R"}).err ==
        "quadmatch: nowhere.csv: there is no such file; check the name and the folder\n");
  CHECK(!folder.has("R"));
}
