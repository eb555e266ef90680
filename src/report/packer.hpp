#pragma once
/// Numbers as few bytes: what the viewer reads back in web/src/unpacker.ts, in the same order.

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace quadmatch::report {

class Packer {
 public:
  /// Seven bits a byte, the lowest first; the top bit says that more follow (LEB128).
  void add(std::uint64_t number);
  /// The difference from the number before, small ones of either sign in one byte (zigzag).
  void add_step(std::uint32_t before, std::uint32_t number);
  /// Two bytes, the lower first.
  void add_uint16(std::uint16_t number);
  /// Four bytes, the lowest first (IEEE 754).
  void add_float32(float number);
  /// Eight a byte, the first lowest, filled up with zeros.
  void add_bits(const std::vector<bool>& bits);
  /// Each in `width` bits, the lowest first, without gaps, filled up with zeros. @pre width is 1 ... 32
  void add_packed(const std::vector<std::uint32_t>& numbers, std::uint32_t width);
  /// How many, then each as the step from the one before; the first from 0.
  void add_list(const std::vector<std::uint32_t>& numbers);

  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  void add_byte(std::uint64_t byte) { bytes_.push_back(static_cast<char>(byte & 0xffU)); }

  std::string bytes_;
};

/// Named runs of bytes, one after the other.
class Blocks {
 public:
  struct Block {
    std::string name;
    std::size_t size = 0;
  };

  void add(std::string name, const Packer& packer);
  [[nodiscard]] const std::vector<Block>& list() const { return list_; }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }
  [[nodiscard]] std::string take_bytes() && { return std::move(bytes_); }

 private:
  std::vector<Block> list_;
  std::string bytes_;
};

/// Append bytes as base64 (RFC 4648, with padding).
void append_base64(std::string& text, std::string_view bytes);

}  // namespace quadmatch::report
