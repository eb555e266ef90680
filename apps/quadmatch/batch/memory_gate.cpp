#include "memory_gate.hpp"

namespace quadmatch::cli {

MemoryGate::Share MemoryGate::enter(std::uint64_t bytes) {
  std::unique_lock lock(mutex_);
  const std::uint64_t ticket = next_ticket_++;
  changed_.wait(lock, [&] { return ticket == now_served_ && held_ + bytes <= limit_; });
  held_ += bytes;
  ++now_served_;
  lock.unlock();
  changed_.notify_all();
  return {this, bytes};
}

void MemoryGate::leave(std::uint64_t bytes) {
  {
    const std::lock_guard lock(mutex_);
    held_ -= bytes;
  }
  changed_.notify_all();
}

}  // namespace quadmatch::cli
