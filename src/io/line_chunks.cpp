#include "line_chunks.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include <unistd.h>

namespace quadmatch::io {
namespace {

constexpr std::size_t kChunk = std::size_t{256} << 10;
constexpr const char* kTooLong = "the file does not fit into memory; split it";

}  // namespace

Expected<LineChunks> LineChunks::open(const std::string& path) {
  Expected<OpenFile> file = open_for_reading(path);
  if (!file) return Unexpected(std::move(file).error());
  LineChunks chunks;
  chunks.path_ = path;
  chunks.file_ = std::move(file->descriptor);
  chunks.size_ = file->size;
  if (!chunks.buffer_.resize(kChunk)) return cannot_read(path, kTooLong);
  return chunks;
}

std::string LineChunks::sample(std::size_t offset, std::size_t count) const {
  if (memory_ != nullptr) return std::string(memory_->view().substr(std::min(offset, size_), count));
  std::string bytes(count, '\0');
  const ssize_t got = ::pread(file_.number(), bytes.data(), count, static_cast<off_t>(offset));
  bytes.resize(got < 0 ? 0 : static_cast<std::size_t>(got));
  return bytes;
}

Expected<void> LineChunks::fill() {
  while (filled_ < buffer_.size() && !ended_) {
    const Expected<std::size_t> got = read_some(file_, buffer_.data() + filled_, buffer_.size() - filled_, path_);
    if (!got) return Unexpected(got.error());
    ended_ = *got == 0;
    filled_ += *got;
  }
  return {};
}

std::size_t LineChunks::end_of_lines() const {
  const std::string_view text = buffer_.view().substr(0, filled_);
  for (std::size_t end = text.size();;) {
    const std::size_t feed = text.substr(0, end).rfind('\n');
    if (feed == text.npos) return 0;
    const std::size_t last = feed > 0 && text[feed - 1] == '\r' ? feed - 1 : feed;
    if (last == 0 || text[last - 1] != '\\') return feed + 1;
    end = feed;
  }
}

Expected<std::string_view> LineChunks::next() {
  if (memory_ != nullptr) return std::exchange(given_, size_) == 0 ? memory_->view() : std::string_view();

  std::memmove(buffer_.data(), buffer_.data() + given_, filled_ - given_);
  filled_ -= std::exchange(given_, 0);
  while (true) {
    if (const Expected<void> fine = fill(); !fine) return Unexpected(fine.error());
    given_ = ended_ ? filled_ : end_of_lines();
    if (given_ > 0 || ended_) break;
    if (!buffer_.resize(2 * buffer_.size())) return cannot_read(path_, kTooLong);  // one very long line
  }
  if (ended_ && !buffer_.resize(filled_)) return cannot_read(path_, kTooLong);  // puts line feeds behind it
  return buffer_.view().substr(0, given_);
}

}  // namespace quadmatch::io
