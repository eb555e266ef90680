#include "errors.hpp"

#include <filesystem>
#include <string>
#include <system_error>

#include <pybind11/pybind11.h>

namespace py = pybind11;

namespace quadmatch::python {
namespace {

PyObject* kind_of(const Error& error) {
  if (error.code == ErrorCode::CannotWrite) return PyExc_OSError;
  if (error.code != ErrorCode::CannotRead) return PyExc_ValueError;
  std::error_code unknown;
  const bool missing = !std::filesystem::exists(error.path, unknown) && !unknown;
  return missing ? PyExc_FileNotFoundError : PyExc_OSError;
}

}  // namespace

void raise(const Error& error) {
  const std::string sentence = error.describe();
  // A path may hold bytes that are no UTF-8.
  const py::object text = py::reinterpret_steal<py::object>(
      PyUnicode_DecodeUTF8(sentence.data(), static_cast<Py_ssize_t>(sentence.size()), "backslashreplace"));
  PyErr_SetObject(kind_of(error), text.ptr());
  throw py::error_already_set();
}

}  // namespace quadmatch::python
