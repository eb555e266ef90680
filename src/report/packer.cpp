#include "packer.hpp"

#include <bit>
#include <utility>

namespace quadmatch::report {

void Packer::add(std::uint64_t number) {
  for (; number >= 0x80; number >>= 7U) add_byte(number | 0x80U);
  add_byte(number);
}

void Packer::add_step(std::uint32_t before, std::uint32_t number) {
  const std::int64_t step = std::int64_t{number} - std::int64_t{before};
  add(step < 0 ? static_cast<std::uint64_t>(-step) * 2 - 1 : static_cast<std::uint64_t>(step) * 2);
}

void Packer::add_uint16(std::uint16_t number) {
  add_byte(number);
  add_byte(number >> 8U);
}

void Packer::add_float32(float number) {
  const auto bits = std::bit_cast<std::uint32_t>(number);
  for (std::uint32_t shift = 0; shift < 32; shift += 8) add_byte(bits >> shift);
}

void Packer::add_bits(const std::vector<bool>& bits) {
  for (std::size_t i = 0; i < bits.size(); i += 8) {
    std::uint32_t byte = 0;
    for (std::size_t k = i; k < bits.size() && k < i + 8; ++k) byte |= (bits[k] ? 1U : 0U) << (k - i);
    add_byte(byte);
  }
}

void Packer::add_packed(const std::vector<std::uint32_t>& numbers, std::uint32_t width) {
  std::uint64_t held = 0;
  std::uint32_t bits = 0;
  for (const std::uint32_t number : numbers) {
    held |= std::uint64_t{number} << bits;
    for (bits += width; bits >= 8; bits -= 8, held >>= 8U) add_byte(held);
  }
  if (bits > 0) add_byte(held);
}

void Packer::add_list(const std::vector<std::uint32_t>& numbers) {
  add(numbers.size());
  std::uint32_t before = 0;
  for (const std::uint32_t number : numbers) {
    add_step(before, number);
    before = number;
  }
}

void Blocks::add(std::string name, const Packer& packer) {
  list_.push_back({std::move(name), packer.bytes().size()});
  bytes_ += packer.bytes();
}

void append_base64(std::string& text, std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto byte = [&](std::size_t i) {
    return i < bytes.size() ? std::uint32_t{static_cast<unsigned char>(bytes[i])} : 0U;
  };
  text.reserve(text.size() + (bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::uint32_t three = byte(i) << 16U | byte(i + 1) << 8U | byte(i + 2);
    text += kDigits[three >> 18U];
    text += kDigits[three >> 12U & 63U];
    text += i + 1 < bytes.size() ? kDigits[three >> 6U & 63U] : '=';
    text += i + 2 < bytes.size() ? kDigits[three & 63U] : '=';
  }
}

}  // namespace quadmatch::report
