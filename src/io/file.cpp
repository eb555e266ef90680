// Whole files in and out, on POSIX calls: they tell why they fail, and rename is all or nothing.

#include <quadmatch/io/file.hpp>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include <quadmatch/mesh/large_pages.hpp>

#include "descriptor.hpp"

namespace quadmatch {
namespace {

using io::Descriptor;
using io::kMostPerCall;
using io::system_reason;

Unexpected<Error> cannot_write(const std::string& path, const std::string& why) {
  return Unexpected(Error{ErrorCode::CannotWrite, why, path == "-" ? "standard output" : path});
}

std::string write_reason(int number) {
  return fmt::format("the file cannot be written ({}); make room or choose another place", system_reason(number));
}

bool write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), std::min(bytes.size(), kMostPerCall));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// The folder of a path with the slash behind it, empty for the current one.
std::string folder_of(const std::string& path) { return path.substr(0, path.rfind('/') + 1); }

/// Where a path leads to after all symbolic links, even if nothing is there yet.
std::string follow_links(std::string path) {
  constexpr int kMostLinks = 40;
  for (int i = 0; i < kMostLinks; ++i) {
    char next[4096];
    const ssize_t length = ::readlink(path.c_str(), next, sizeof next);
    if (length <= 0 || length == sizeof next) break;
    const std::string leads_to(next, static_cast<std::size_t>(length));
    path = leads_to.front() == '/' ? std::string() : folder_of(path);
    path += leads_to;
  }
  return path;
}

/// A file of a fresh name in a folder, removed unless it is kept.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& folder) {
    constexpr int kMostNames = 1000;
    for (int i = 0; i < kMostNames && descriptor_ < 0; ++i) {
      path_ = fmt::format("{}.quadmatch-{}.tmp", folder, i);
      descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (descriptor_ < 0 && errno != EEXIST) break;
    }
    exists_ = descriptor_ >= 0;
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (exists_) ::unlink(path_.c_str());
  }

  [[nodiscard]] int descriptor() const { return descriptor_; }
  [[nodiscard]] bool rename_to(const std::string& target) {
    if (std::rename(path_.c_str(), target.c_str()) != 0) return false;
    exists_ = false;
    return true;
  }

 private:
  std::string path_;
  int descriptor_ = -1;
  bool exists_ = false;
};

/// Give a file the mode of the one it is to replace.
bool copy_mode([[maybe_unused]] int descriptor, [[maybe_unused]] const struct stat& from) {
#ifdef __wasi__
  return true;  // has no modes
#else
  return ::fchmod(descriptor, from.st_mode & 07777U) == 0;
#endif
}

/// Some file systems cannot synchronise, which is no reason to refuse.
bool synchronise(int descriptor) { return ::fsync(descriptor) == 0 || errno == EINVAL || errno == ENOTSUP; }

/// Write aside and rename. @return 0, or the error number of the step that failed.
int write_aside(const std::string& target, std::string_view bytes, const struct stat* existing) {
  TemporaryFile aside(folder_of(target));
  Descriptor file(aside.descriptor());
  if (!file.valid()) return errno;
  if (!write_all(file.number(), bytes)) return errno;
  if (existing != nullptr && !copy_mode(file.number(), *existing)) return errno;
  if (!synchronise(file.number())) return errno;
  if (!file.close()) return errno;
  return aside.rename_to(target) ? 0 : errno;
}

}  // namespace

FileBytes::FileBytes(std::string_view bytes) {
  if (!resize(bytes.size())) std::abort();  // as any allocation below the front ends
  if (!bytes.empty()) std::memcpy(data(), bytes.data(), bytes.size());
}

bool FileBytes::resize(std::size_t size) {
  void* const room = std::realloc(data_.get(), size + kPadding);
  if (room == nullptr) return false;
  static_cast<void>(data_.release());
  data_.reset(static_cast<char*>(room));
  if (size > size_) prefer_large_pages(data_.get(), size);
  size_ = size;
  std::memset(data_.get() + size, '\n', kPadding);
  return true;
}

Expected<FileBytes> read_file(const std::string& path) {
  constexpr const char* kTooLarge = "the file does not fit into memory; split it";
  const Expected<io::OpenFile> file = io::open_for_reading(path);
  if (!file) return Unexpected(file.error());
  // One byte more than the file holds, so that its end is seen without growing.
  constexpr std::size_t kLeast = std::size_t{64} << 10;
  FileBytes bytes;
  if (!bytes.resize(std::max(file->size + 1, kLeast))) return io::cannot_read(path, kTooLarge);
  std::size_t filled = 0;
  while (true) {
    if (filled == bytes.size() && !bytes.resize(2 * filled)) return io::cannot_read(path, kTooLarge);
    const Expected<std::size_t> got =
        io::read_some(file->descriptor, bytes.data() + filled, bytes.size() - filled, path);
    if (!got) return Unexpected(got.error());
    if (*got == 0) break;
    filled += *got;
  }
  if (!bytes.resize(filled)) return io::cannot_read(path, kTooLarge);
  return bytes;
}

Expected<void> replace_file(const std::string& path, std::string_view bytes) {
  if (path == "-") {
    if (!write_all(STDOUT_FILENO, bytes)) return cannot_write(path, write_reason(errno));
    return {};
  }
  const std::string target = follow_links(path);
  struct stat existing {};
  const bool exists = ::stat(target.c_str(), &existing) == 0;
  if (exists && S_ISDIR(existing.st_mode)) return cannot_write(path, "this is a folder; name a file in it");
  if (exists && ::access(target.c_str(), W_OK) != 0) {
    return cannot_write(path,
                        fmt::format("the file is write-protected ({}); choose another name", system_reason(errno)));
  }
  if (exists && !S_ISREG(existing.st_mode)) {
    Descriptor device(::open(target.c_str(), O_WRONLY | O_CLOEXEC));
    if (!device.valid() || !write_all(device.number(), bytes) || !device.close()) {
      return cannot_write(path, write_reason(errno));
    }
    return {};
  }
  const int failed = write_aside(target, bytes, exists ? &existing : nullptr);
  if (failed == ENOENT || failed == ENOTDIR) {
    return cannot_write(path, "there is no such folder; create it or choose another place");
  }
  if (failed != 0) return cannot_write(path, write_reason(failed));
  return {};
}

}  // namespace quadmatch
