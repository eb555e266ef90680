#include "at_work.hpp"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>
#include <type_traits>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <fmt/format.h>

namespace quadmatch::cli {

Expected<std::unique_ptr<AtWork>> AtWork::open(const std::string& folder) {
  static_assert(std::is_trivially_copyable_v<Slots>);
  const std::string path = (std::filesystem::path(folder) / "at_work").string();
  const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  void* bytes = MAP_FAILED;
  // Blocks are reserved first: a page that has no room when it is written would end the process.
  if (file >= 0) errno = ::posix_fallocate(file, 0, sizeof(Slots));
  if (file >= 0 && errno == 0) bytes = ::mmap(nullptr, sizeof(Slots), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  const int failure = errno;
  if (file >= 0) ::close(file);
  if (bytes == MAP_FAILED) {
    return Unexpected(Error{ErrorCode::CannotWrite,
                            fmt::format("cannot be written: {}; make room, or choose another folder",
                                        std::generic_category().message(failure)),
                            path});
  }
  auto* const slots = static_cast<Slots*>(bytes);
  std::map<std::uint32_t, std::uint32_t> ends;
  for (Slot& slot : *slots) {
    if (slot.job != 0) ends[slot.job] = slot.ends;
    slot = {};
  }
  return std::unique_ptr<AtWork>(new AtWork(slots, std::move(ends)));
}

AtWork::~AtWork() { ::munmap(slots_, sizeof(Slots)); }

std::uint32_t AtWork::ends(std::uint32_t job) const {
  const auto found = ends_.find(job);
  return found == ends_.end() ? 0 : found->second;
}

void AtWork::begin(std::uint32_t job) {
  const std::lock_guard lock(mutex_);
  const auto free = std::find_if(slots_->begin(), slots_->end(), [](const Slot& slot) { return slot.job == 0; });
  if (free == slots_->end()) return;
  free->ends = ends(job) + 1;
  free->job = job;
}

void AtWork::end(std::uint32_t job) {
  const std::lock_guard lock(mutex_);
  const auto held = std::find_if(slots_->begin(), slots_->end(), [job](const Slot& slot) { return slot.job == job; });
  if (held != slots_->end()) *held = {};
}

}  // namespace quadmatch::cli
