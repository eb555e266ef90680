#include "watch.hpp"

#include <utility>

namespace quadmatch::python {

Watch::Watch(py::object progress, double time_limit) : progress_(std::move(progress)), time_limit_(time_limit) {}

std::function<bool(std::size_t, std::size_t)> Watch::progress_function() {
  return [this](std::size_t matched, std::size_t most) { return goes_on(matched, most); };
}

bool Watch::goes_on(std::size_t matched, std::size_t most) {
  if (stopped_) return false;
  const Clock::time_point now = Clock::now();
  stopped_ = time_limit_ > 0 && std::chrono::duration<double>(now - began_).count() >= time_limit_;
  if (stopped_ || now - last_told_ < std::chrono::milliseconds(50)) return !stopped_;
  last_told_ = now;
  const py::gil_scoped_acquire held;
  try {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    stopped_ = !tell(matched, most);
  } catch (...) {
    met_ = std::current_exception();
    stopped_ = true;
  }
  return !stopped_;
}

bool Watch::tell(std::size_t matched, std::size_t most) {
  if (progress_.is_none()) return true;
  const py::object answer = progress_(matched, most);
  return answer.is_none() || bool(py::bool_(answer));
}

void Watch::finish(std::size_t matched, std::size_t most) {
  if (met_) std::rethrow_exception(std::exchange(met_, nullptr));
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  if (!stopped_) static_cast<void>(tell(matched, most));
}

}  // namespace quadmatch::python
