// Whole files in and out, on POSIX calls: they tell why they fail, and rename is all or nothing.

#include <quadmatch/io/file.hpp>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>
#include <system_error>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

namespace quadmatch {
namespace {

constexpr std::size_t kChunk = std::size_t{1} << 20;
/// The system may refuse single calls above 2 GB.
constexpr std::size_t kMostPerCall = std::size_t{1} << 30;

std::string reason(int number) { return std::generic_category().message(number); }

/// Ask for large pages: to touch a small page first costs the system as much time as scanning it costs us.
void prefer_large_pages([[maybe_unused]] char* begin, [[maybe_unused]] std::size_t size) {
#ifdef MADV_HUGEPAGE
  constexpr std::uintptr_t kPage = 4096;
  const std::uintptr_t first = (reinterpret_cast<std::uintptr_t>(begin) + kPage - 1) / kPage * kPage;
  const std::uintptr_t end = (reinterpret_cast<std::uintptr_t>(begin) + size) / kPage * kPage;
  if (first < end) static_cast<void>(::madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE));
#endif
}

/// A file descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int number, bool owned = true) : number_(number), owned_(owned) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (owned_ && number_ >= 0) ::close(number_);
  }

  [[nodiscard]] bool valid() const { return number_ >= 0; }
  [[nodiscard]] int number() const { return number_; }
  /// Close now, to learn whether it succeeded.
  [[nodiscard]] bool close() {
    const int closed = ::close(number_);
    number_ = -1;
    return closed == 0;
  }

 private:
  int number_;
  bool owned_;
};

Unexpected<Error> cannot_read(const std::string& path, const std::string& why) {
  return Unexpected(Error{ErrorCode::CannotRead, why, path == "-" ? "standard input" : path});
}

Unexpected<Error> cannot_write(const std::string& path, const std::string& why) {
  return Unexpected(Error{ErrorCode::CannotWrite, why, path == "-" ? "standard output" : path});
}

std::string open_reason(int number) {
  if (number == ENOENT || number == ENOTDIR) return "there is no such file; check the name and the folder";
  if (number == EACCES) return "the file may not be read (permission denied); ask its owner for permission";
  return fmt::format("the file cannot be opened ({}); check the name", reason(number));
}

std::string write_reason(int number) {
  return fmt::format("the file cannot be written ({}); make room or choose another place", reason(number));
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

/// Where a path leads to after all symbolic links, even if nothing is there yet.
std::string follow_links(const std::string& path) {
  constexpr int kMostLinks = 40;
  std::filesystem::path here(path);
  for (int i = 0; i < kMostLinks; ++i) {
    std::error_code no_link;
    const std::filesystem::path next = std::filesystem::read_symlink(here, no_link);
    if (no_link) break;
    here = here.parent_path() / next;  // an absolute link replaces the folder
  }
  return here.string();
}

/// A file of a fresh name in a folder, removed unless it is kept.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::filesystem::path& folder) {
    constexpr int kMostNames = 1000;
    for (int i = 0; i < kMostNames && descriptor_ < 0; ++i) {
      path_ = (folder / fmt::format(".quadmatch-{}.tmp", i)).string();
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
  const std::filesystem::path parent = std::filesystem::path(target).parent_path();
  TemporaryFile aside(parent.empty() ? std::filesystem::path(".") : parent);
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
  const bool standard = path == "-";
  const Descriptor file(standard ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC), !standard);
  if (!file.valid()) return cannot_read(path, open_reason(errno));
  struct stat status {};
  if (::fstat(file.number(), &status) != 0) return cannot_read(path, open_reason(errno));
  if (S_ISDIR(status.st_mode)) return cannot_read(path, "this is a folder; name a file in it");

  // One byte more than a regular file holds, so that its end is seen without growing.
  FileBytes bytes;
  const std::size_t expected = S_ISREG(status.st_mode) ? static_cast<std::size_t>(status.st_size) + 1 : kChunk;
  const auto grow = [&bytes](std::size_t size) { return bytes.resize(size); };
  if (!grow(expected)) return cannot_read(path, "the file does not fit into memory; split it");
  std::size_t filled = 0;
  while (true) {
    if (filled == bytes.size() && !grow(2 * filled)) {
      return cannot_read(path, "the file does not fit into memory; split it");
    }
    const ssize_t got = ::read(file.number(), bytes.data() + filled, std::min(bytes.size() - filled, kMostPerCall));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return cannot_read(path, fmt::format("the file cannot be read ({})", reason(errno)));
    if (got == 0) break;
    filled += static_cast<std::size_t>(got);
  }
  if (!bytes.resize(filled)) return cannot_read(path, "the file does not fit into memory; split it");
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
    return cannot_write(path, fmt::format("the file is write-protected ({}); choose another name", reason(errno)));
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
