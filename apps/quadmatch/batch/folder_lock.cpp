#include "folder_lock.hpp"

#include <array>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <fmt/format.h>

namespace quadmatch::cli {
namespace {

/// What the holder wrote of itself: "process 12 on host".
std::string holder_of(int file) {
  std::array<char, 200> text = {};
  const ::ssize_t size = ::pread(file, text.data(), text.size(), 0);
  return size <= 0 ? "another process" : std::string(text.data(), static_cast<std::size_t>(size));
}

void sign(int file) {
  std::array<char, 100> host = {};
  ::gethostname(host.data(), host.size() - 1);
  const std::string text = fmt::format("process {} on {}", ::getpid(), host.data());
  // Only for the message to others: where it cannot be written, that says less.
  if (::ftruncate(file, 0) != 0 || ::pwrite(file, text.data(), text.size(), 0) < 0) return;
}

}  // namespace

Expected<FolderLock> FolderLock::take(const std::string& folder) {
  const std::string path = (std::filesystem::path(folder) / "lock").string();
  const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  const auto refuse = [](const std::string& where, std::string message) {
    return Unexpected(Error{ErrorCode::CannotWrite, std::move(message), where});
  };
  if (file < 0) {
    return refuse(path,
                  fmt::format("cannot be written: {}; choose another folder", std::generic_category().message(errno)));
  }
  FolderLock lock(file);
  if (::flock(file, LOCK_EX | LOCK_NB) == 0) {
    sign(file);
    return lock;
  }
  if (errno != EWOULDBLOCK) {
    return refuse(path, fmt::format("cannot be locked: {}; choose a folder on another file system",
                                    std::generic_category().message(errno)));
  }
  return refuse(folder,
                fmt::format("{} writes its results here; wait for it, or choose another folder", holder_of(file)));
}

FolderLock::~FolderLock() {
  if (file_ >= 0) ::close(file_);  // and with it the lock
}

}  // namespace quadmatch::cli
