#pragma once
/// Words for data that are carried from mesh to mesh, and what became of them as plain values.

#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include <quadmatch/use/transfer.hpp>

#include "words.hpp"

namespace quadmatch::python {

namespace py = pybind11;

/// What `only` may name.
inline constexpr Words<bool Carry::*, 8> kCarried{{{"uv", &Carry::texture_coordinates},
                                                   {"colours", &Carry::colours},
                                                   {"properties", &Carry::properties},
                                                   {"groups", &Carry::groups},
                                                   {"materials", &Carry::materials},
                                                   {"smoothing", &Carry::smoothing},
                                                   {"normals", &Carry::normals},
                                                   {"positions", &Carry::positions}}};

/// What `only` names.
/// @param words     those there are; a null pointer stands for nothing.
/// @param otherwise what is carried where it names nothing.
/// @par Errors      BadArgument for another word.
template <std::size_t kCount>
[[nodiscard]] Expected<Carry> carry_of(const Words<bool Carry::*, kCount>& words, const std::vector<std::string>& only,
                                       const Carry& otherwise) {
  if (only.empty()) return otherwise;
  Carry carry = Carry::nothing();
  for (const std::string& word : only) {
    const Expected<bool Carry::*> wanted = meaning(words, "only", word);
    if (!wanted) return Unexpected(wanted.error());
    if (*wanted != nullptr) carry.** wanted = true;
  }
  return carry;
}

[[nodiscard]] const char* name_of(Domain domain);

/// A list of dicts, as quadmatch.TransferredAttribute takes them.
[[nodiscard]] py::list as_list(const std::vector<TransferredAttribute>& attributes);

}  // namespace quadmatch::python
