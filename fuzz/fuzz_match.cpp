#include <quadmatch/io/match_file.hpp>

#include "round_trip.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace quadmatch;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const Expected<MatchFile> file = parse_match(bytes, "fuzz");
  if (!file) {
    fuzz::require_one_line(file.error());
    return 0;
  }
  const std::string written = format_match(*file);
  const Expected<MatchFile> again = parse_match(written, "again");
  fuzz::require(again.has_value() && format_match(*again) == written);
  return 0;
}
