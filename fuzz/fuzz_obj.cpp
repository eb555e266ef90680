#include "round_trip.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  quadmatch::fuzz::round_trip(data, size, quadmatch::Format::Obj);
  return 0;
}
