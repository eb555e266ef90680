#include <doctest/doctest.h>

#include "batch_run.hpp"

using namespace quadmatch::cli;

TEST_CASE("progress says how many, how fast, and how long still, by the rate of this run alone") {
  CHECK(progress_text(0, 0, 10000, 0, 0.0) == "0 of 10,000 pairs");
  CHECK(progress_text(500, 0, 10000, 0, 2.0) == "500 of 10,000 pairs; 250 pairs/s, 38 s left");
  CHECK(progress_text(500, 8000, 10000, 3, 2.0) == "8,500 of 10,000 pairs, 3 failed; 250 pairs/s, 6 s left");
  CHECK(progress_text(3, 0, 1000, 0, 2.0) == "3 of 1,000 pairs; 1.5 pairs/s, 11 min 04 s left");
  CHECK(progress_text(1, 0, 10000, 0, 2.0) == "1 of 10,000 pairs; 0.5 pairs/s, 5 h 33 min left");
  CHECK(progress_text(1, 0, 1, 0, 1.0) == "1 of 1 pair; 1.0 pairs/s, 0 s left");
}

TEST_CASE("the shards of a list have every job once") {
  for (std::uint32_t of = 1; of <= 5; ++of) {
    for (std::uint32_t job = 1; job <= 23; ++job) {
      int holders = 0;
      for (std::uint32_t number = 1; number <= of; ++number) holders += Shard{number, of}.has(job);
      CHECK(holders == 1);
    }
  }
}

TEST_CASE("a shard is i/n with i from 1 to n") {
  CHECK(parse_shard("2/5")->number == 2);
  CHECK(parse_shard("2/5")->of == 5);
  for (const char* wrong : {"", "2", "2/", "/5", "0/5", "6/5", "1/0", "a/b", "1/2x", "-1/2", "1/99999999999"}) {
    CAPTURE(wrong);
    REQUIRE(!parse_shard(wrong).has_value());
    CHECK(parse_shard(wrong).error().message.ends_with("write i/n with i from 1 to n, such as 2/5"));
  }
}
