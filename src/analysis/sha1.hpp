#pragma once
/// The digest of a stream of numbers.

#include <cstdint>
#include <memory>
#include <string_view>

#include <quadmatch/analysis/connectivity_hash.hpp>

namespace quadmatch {

/// SHA-1, by a library that stays out of sight.
class Sha1 {
 public:
  Sha1();
  ~Sha1();
  Sha1(const Sha1&) = delete;
  Sha1& operator=(const Sha1&) = delete;

  void add(std::string_view text);
  /// Four bytes, the lowest first.
  void add(std::uint32_t number);
  /// Of all that was added. Call once.
  [[nodiscard]] Digest finish();

 private:
  struct Library;
  std::unique_ptr<Library> library_;
};

}  // namespace quadmatch
