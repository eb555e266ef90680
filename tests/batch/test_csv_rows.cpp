#include <doctest/doctest.h>

#include <string>

#include "batch/csv_rows.hpp"

using namespace quadmatch::cli;

namespace {

using Fields = std::vector<std::string>;

}  // namespace

TEST_CASE("RFC 4180: quoted fields hold commas, quotes and line breaks") {
  const std::vector<CsvRow> rows = csv_rows("a,b\r\n\"x, y\",\"he said \"\"quad\"\"\"\r\n\"two\nlines\",z\r\n");
  REQUIRE(rows.size() == 3);
  CHECK(rows[0].fields == Fields{"a", "b"});
  CHECK(rows[1].fields == Fields{"x, y", "he said \"quad\""});
  CHECK(rows[2].fields == Fields{"two\nlines", "z"});
  CHECK(rows[2].line == 3);
}

TEST_CASE("rows end with any line end, the last with none, and lines count from 1 past empty ones and line breaks") {
  const std::vector<CsvRow> rows = csv_rows(
      "\xEF\xBB\xBF"
      "a\n\n\"b\n\nc\"\rd\r\n\r\ne");
  REQUIRE(rows.size() == 4);
  CHECK(rows[0].fields == Fields{"a"});
  CHECK(rows[1].fields == Fields{"b\n\nc"});
  CHECK(rows[2].fields == Fields{"d"});
  CHECK(rows[3].fields == Fields{"e"});
  CHECK(rows[0].line == 1);
  CHECK(rows[1].line == 3);
  CHECK(rows[2].line == 6);
  CHECK(rows[3].line == 8);
}

TEST_CASE("blanks belong to the fields, and empty fields are fields") {
  const std::vector<CsvRow> rows = csv_rows(" a , b\t,,\"\"\n,\n");
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].fields == Fields{" a ", " b\t", "", ""});
  CHECK(rows[1].fields == Fields{"", ""});
}

TEST_CASE("a row that cannot be read costs one line") {
  const std::vector<CsvRow> rows = csv_rows("a,b\n\"x\"y,1\nc,d\n");
  REQUIRE(rows.size() == 3);
  CHECK(rows[1].fields.empty());
  CHECK(rows[1].line == 2);
  CHECK(rows[1].fault.starts_with("a quote stands inside a field"));
  CHECK(rows[2].fields == Fields{"c", "d"});
}

TEST_CASE("a quote that is never closed does not swallow the rest of the list") {
  const std::vector<CsvRow> rows = csv_rows("a\n\"open\nb\nc");
  REQUIRE(rows.size() == 4);
  CHECK(rows[1].fault.starts_with("a quote is opened and never closed"));
  CHECK(rows[2].fields == Fields{"b"});
  CHECK(rows[3].fields == Fields{"c"});
  CHECK(rows[3].line == 4);
}

TEST_CASE("every beginning of a list can be read, and nothing of it twice") {
  const std::string list = "s,t\n\"a, 1\",\"b\"\"\n\"\r\nc,d\n";
  for (std::size_t size = 0; size <= list.size(); ++size) {
    CAPTURE(size);
    std::uint64_t last = 0;
    for (const CsvRow& row : csv_rows(std::string_view(list).substr(0, size))) {
      CHECK(row.line > last);
      CHECK(row.fields.empty() == !row.fault.empty());
      last = row.line;
    }
  }
}
