#include "descriptor.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

namespace quadmatch::io {
namespace {

std::string open_reason(int number) {
  if (number == ENOENT || number == ENOTDIR) return "there is no such file; check the name and the folder";
  if (number == EACCES) return "the file may not be read (permission denied); ask its owner for permission";
  return fmt::format("the file cannot be opened ({}); check the name", system_reason(number));
}

}  // namespace

Descriptor::~Descriptor() {
  if (number_ > STDERR_FILENO) ::close(number_);
}

bool Descriptor::close() { return ::close(std::exchange(number_, -1)) == 0; }

std::string system_reason(int number) { return std::generic_category().message(number); }

Unexpected<Error> cannot_read(const std::string& path, const std::string& why) {
  return Unexpected(Error{ErrorCode::CannotRead, why, path == "-" ? "standard input" : path});
}

Expected<OpenFile> open_for_reading(const std::string& path) {
  OpenFile file{Descriptor(path == "-" ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC))};
  if (!file.descriptor.valid()) return cannot_read(path, open_reason(errno));
  struct stat status {};
  if (::fstat(file.descriptor.number(), &status) != 0) return cannot_read(path, open_reason(errno));
  if (S_ISDIR(status.st_mode)) return cannot_read(path, "this is a folder; name a file in it");
  if (S_ISREG(status.st_mode)) file.size = static_cast<std::size_t>(status.st_size);
  return file;
}

Expected<std::size_t> read_some(const Descriptor& file, char* into, std::size_t size, const std::string& path) {
  ssize_t got = -1;
  do {
    got = ::read(file.number(), into, std::min(size, kMostPerCall));
  } while (got < 0 && errno == EINTR);
  if (got < 0) return cannot_read(path, fmt::format("the file cannot be read ({})", system_reason(errno)));
  return static_cast<std::size_t>(got);
}

}  // namespace quadmatch::io
