#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>

#include <quadmatch/io/file.hpp>

#include "batch/result_store.hpp"

using namespace quadmatch;
using namespace quadmatch::cli;

namespace {

namespace fs = std::filesystem;

struct TemporaryFolder {
  TemporaryFolder() : path((fs::temp_directory_path() / "quadmatch-store-XXXXXX").string()) {
    REQUIRE(::mkdtemp(path.data()) != nullptr);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() { fs::remove_all(path); }
  std::string path;
};

PairRow full_row() {
  PairRow row{.job = 7, .line = 9, .name = "n", .source = std::string("a\nb\0c", 5), .target = "\xff.obj"};
  row.options = "--waves";
  row.status = status::kMatched;
  row.remarks = "dirty";
  row.source_faces = 0xffffffffU;
  row.confidence = 1.0 / 3.0;
  row.reading_ms = 0.25;
  return row;
}

}  // namespace

TEST_CASE("a row comes back as it was, with zero bytes, line breaks, bytes that are no UTF-8, and what there is not") {
  const TemporaryFolder folder;
  {
    const Expected<std::unique_ptr<ResultStore>> store = ResultStore::open(folder.path);
    REQUIRE(store.has_value());
    REQUIRE((*store)->record(full_row()).has_value());
  }
  const Expected<std::unique_ptr<ResultStore>> store = ResultStore::open_existing(folder.path);
  REQUIRE(store.has_value());
  const Expected<std::optional<PairRow>> found = (*store)->find(7);
  REQUIRE(found.has_value());
  REQUIRE(found->has_value());
  CHECK(same_results(**found, full_row()));
  CHECK((*found)->source.size() == 5);
  CHECK(!(*found)->error.has_value());
  CHECK((*found)->confidence == 1.0 / 3.0);
  CHECK((*found)->reading_ms == 0.25);
  CHECK(!(*(*store)->find(8)).has_value());
  CHECK(*(*store)->last_job() == 7);
}

TEST_CASE("one holder at a time has a folder, and others are told who") {
  const TemporaryFolder folder;
  const Expected<std::unique_ptr<ResultStore>> store = ResultStore::open(folder.path);
  REQUIRE(store.has_value());
  const Expected<std::unique_ptr<ResultStore>> other = ResultStore::open(folder.path);
  REQUIRE(!other.has_value());
  CHECK(other.error().message.starts_with("process "));
  CHECK(other.error().message.ends_with(" writes its results here; wait for it, or choose another folder"));
}

TEST_CASE("a line of JSON has what is the same on every run, and no times") {
  const std::string line = json_line(full_row());
  CHECK(line.starts_with(R"({"job":7,"line":9,"name":"n","source":"a\nb\u0000c","target":")"));
  CHECK(line.find("\"error\":null") != std::string::npos);
  CHECK(line.find("_ms") == std::string::npos);
  CHECK(line.ends_with("}\n"));
}

TEST_CASE("where there are no results, there is nothing to merge") {
  const TemporaryFolder folder;
  const Expected<std::unique_ptr<ResultStore>> store = ResultStore::open_existing(folder.path);
  REQUIRE(!store.has_value());
  CHECK(store.error().message.starts_with("there are no results here"));
  CHECK(fs::is_empty(folder.path));
}
