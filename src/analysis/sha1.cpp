// The one source file that includes Boost.Uuid, for its SHA-1.

#include "sha1.hpp"

#include <array>

// Without exceptions Boost asks its user what to do instead; 2^64 bits are never reached.
#include <boost/config.hpp>
#ifdef BOOST_NO_EXCEPTIONS
#include <cstdlib>
#include <exception>
namespace boost {
struct source_location;
[[noreturn]] inline void throw_exception(const std::exception& /*unused*/) { std::abort(); }
[[noreturn]] inline void throw_exception(const std::exception& /*unused*/, const source_location& /*unused*/) {
  std::abort();
}
}  // namespace boost
#endif
#include <boost/uuid/detail/sha1.hpp>

namespace quadmatch {

struct Sha1::Library {
  boost::uuids::detail::sha1 sha1;
};

Sha1::Sha1() : library_(std::make_unique<Library>()) {}
Sha1::~Sha1() = default;

void Sha1::add(std::string_view text) { library_->sha1.process_bytes(text.data(), text.size()); }

void Sha1::add(std::uint32_t number) {
  std::array<std::uint8_t, 4> bytes;
  for (std::uint8_t& byte : bytes) {
    byte = static_cast<std::uint8_t>(number);
    number >>= 8;
  }
  library_->sha1.process_bytes(bytes.data(), bytes.size());
}

Digest Sha1::finish() {
  unsigned int words[5];
  library_->sha1.get_digest(words);
  Digest digest;
  for (std::size_t k = 0; k < digest.bytes.size(); ++k) {
    digest.bytes[k] = static_cast<std::uint8_t>(words[k / 4] >> (24 - 8 * (k % 4)));
  }
  return digest;
}

}  // namespace quadmatch
