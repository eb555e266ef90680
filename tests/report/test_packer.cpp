#include "packer.hpp"

#include <doctest/doctest.h>

using namespace quadmatch::report;

namespace {

std::vector<int> bytes_of(const Packer& packer) {
  std::vector<int> bytes;
  for (const char c : packer.bytes()) bytes.push_back(static_cast<unsigned char>(c));
  return bytes;
}

std::string base64(std::string_view bytes) {
  std::string text;
  append_base64(text, bytes);
  return text;
}

}  // namespace

TEST_CASE("numbers take seven bits a byte, the lowest first") {
  Packer packer;
  packer.add(0);
  packer.add(127);
  packer.add(128);
  packer.add(0xffffffffU);
  CHECK(bytes_of(packer) == std::vector<int>{0, 127, 0x80, 1, 0xff, 0xff, 0xff, 0xff, 0x0f});
}

TEST_CASE("steps either way are small numbers, and the longest fit") {
  Packer packer;
  for (const std::uint32_t next : {10U, 9U, 11U, 8U}) packer.add_step(10, next);
  packer.add_step(0, 0xffffffffU);
  packer.add_step(0xffffffffU, 0);
  CHECK(bytes_of(packer) == std::vector<int>{0, 1, 2, 3, 0xfe, 0xff, 0xff, 0xff, 0x1f, 0xfd, 0xff, 0xff, 0xff, 0x1f});
}

TEST_CASE("lists, bits and floats stand as the viewer reads them") {
  Packer packer;
  packer.add_list({5, 7, 6});
  packer.add_bits({true, false, true, false, false, false, false, false, true});
  packer.add_uint16(0x1234);
  packer.add_float32(1.0F);
  CHECK(bytes_of(packer) == std::vector<int>{3, 10, 4, 1, 0b101, 1, 0x34, 0x12, 0, 0, 0x80, 0x3f});
}

TEST_CASE("numbers of any width stand without gaps") {
  Packer packer;
  packer.add_packed({1, 2, 7}, 3);
  CHECK(bytes_of(packer) == std::vector<int>{0b11010001, 0b1});
  Packer wide;
  wide.add_packed({0xfffffff1U, 0x1f}, 32);
  CHECK(bytes_of(wide) == std::vector<int>{0xf1, 0xff, 0xff, 0xff, 0x1f, 0, 0, 0});
}

TEST_CASE("base64 is that of RFC 4648, its examples included") {
  CHECK(base64("").empty());
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foo") == "Zm9v");
  CHECK(base64("foob") == "Zm9vYg==");
  CHECK(base64(std::string("\xff\xfe\x00", 3)) == "//4A");
}
