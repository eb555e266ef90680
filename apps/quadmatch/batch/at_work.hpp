#pragma once
/// Which jobs are being done, in a file that outlives the process: so a run knows at what the one before it ended.

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <quadmatch/mesh/expected.hpp>

namespace quadmatch::cli {

class AtWork {
 public:
  /// The most jobs that are done at a time.
  static constexpr std::size_t kMost = 4096;

  /// Read what `at_work` in a folder says of the run before, and make it ours. @pre the folder is locked.
  /// @par Errors  CannotWrite.
  [[nodiscard]] static Expected<std::unique_ptr<AtWork>> open(const std::string& folder);
  AtWork(const AtWork&) = delete;
  AtWork& operator=(const AtWork&) = delete;
  ~AtWork();

  /// How many runs in succession ended while this job was at work: 0 for most.
  [[nodiscard]] std::uint32_t ends(std::uint32_t job) const;
  /// Note that a job begins, or is over. Neither needs a call of the system.
  void begin(std::uint32_t job);
  void end(std::uint32_t job);

 private:
  struct Slot {
    std::uint32_t job = 0;   ///< 0: free
    std::uint32_t ends = 0;  ///< if the process ends now
  };
  using Slots = std::array<Slot, kMost>;

  AtWork(Slots* slots, std::map<std::uint32_t, std::uint32_t> ends) : slots_(slots), ends_(std::move(ends)) {}

  Slots* slots_;  ///< the file in memory
  std::map<std::uint32_t, std::uint32_t> ends_;
  std::mutex mutex_;
};

}  // namespace quadmatch::cli
