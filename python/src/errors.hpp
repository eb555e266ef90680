#pragma once
/// Errors of the library as exceptions of Python, with the same sentence as on the command line.

#include <utility>

#include <quadmatch/mesh/expected.hpp>

namespace quadmatch::python {

/// Throw an Error: FileNotFoundError or OSError for a file that cannot be read or written, ValueError for all else.
/// @pre the caller holds the GIL.
[[noreturn]] void raise(const Error& error);

/// What an Expected holds, or its error as an exception.
template <class T>
T taken(Expected<T> value) {
  if (!value) raise(value.error());
  return *std::move(value);
}

}  // namespace quadmatch::python
