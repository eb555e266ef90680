#include <quadmatch/mesh/error.hpp>

#include <fmt/format.h>

namespace quadmatch {

std::string Error::describe() const {
  if (path.empty()) return line == 0 ? message : fmt::format("line {}: {}", line, message);
  return line == 0 ? fmt::format("{}: {}", path, message) : fmt::format("{}:{}: {}", path, line, message);
}

}  // namespace quadmatch
