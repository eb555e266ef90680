#pragma once
/// Lets so many pairs work at a time that their memory stays within a limit.

#include <condition_variable>
#include <cstdint>
#include <mutex>

namespace quadmatch::cli {

/// Those who come are let in one after the other, so that a large pair waits for small ones before it and not for
/// those behind it.
class MemoryGate {
 public:
  explicit MemoryGate(std::uint64_t limit) : limit_(limit) {}

  /// What is held until it is destroyed.
  class Share {
   public:
    Share(Share&& other) noexcept : gate_(other.gate_), bytes_(other.bytes_) { other.gate_ = nullptr; }
    Share& operator=(Share&& other) = delete;
    ~Share() {
      if (gate_ != nullptr) gate_->leave(bytes_);
    }

   private:
    friend class MemoryGate;
    Share(MemoryGate* gate, std::uint64_t bytes) : gate_(gate), bytes_(bytes) {}
    MemoryGate* gate_;
    std::uint64_t bytes_;
  };

  /// Wait until there is room. @pre bytes <= limit()
  [[nodiscard]] Share enter(std::uint64_t bytes);
  /// Wait until nobody else is in, and keep others out.
  [[nodiscard]] Share enter_alone() { return enter(limit_); }
  [[nodiscard]] std::uint64_t limit() const { return limit_; }

 private:
  void leave(std::uint64_t bytes);

  std::uint64_t limit_;
  std::uint64_t held_ = 0;
  std::uint64_t next_ticket_ = 0, now_served_ = 0;
  std::mutex mutex_;
  std::condition_variable changed_;
};

}  // namespace quadmatch::cli
