#pragma once
/// Work that takes long without the GIL, and still lets Python interrupt it and hears what it says of progress.

#include <chrono>
#include <cstddef>
#include <exception>
#include <functional>

#include <pybind11/pybind11.h>

namespace quadmatch::python {

namespace py = pybind11;

/// Made and finished with the GIL held; the progress function in between is called without it.
class Watch {
 public:
  /// @param progress    called with (matched, most) every twentieth of a second at most; None: nobody. Returning False
  ///                    stops the work.
  /// @param time_limit  seconds until the work is stopped; 0: none.
  Watch(py::object progress, double time_limit);

  /// For MatchOptions::progress. Exceptions of Python do not pass through the library: they stop it, and wait.
  [[nodiscard]] std::function<bool(std::size_t, std::size_t)> progress_function();

  /// Throw what was met meanwhile, KeyboardInterrupt included; else tell the last of the progress.
  void finish(std::size_t matched, std::size_t most);

 private:
  using Clock = std::chrono::steady_clock;

  [[nodiscard]] bool goes_on(std::size_t matched, std::size_t most);
  /// @pre the GIL is held. @return false where the callback said stop.
  [[nodiscard]] bool tell(std::size_t matched, std::size_t most);

  py::object progress_;
  Clock::time_point began_ = Clock::now();
  Clock::time_point last_told_ = {};
  double time_limit_;
  bool stopped_ = false;
  std::exception_ptr met_;
};

}  // namespace quadmatch::python
