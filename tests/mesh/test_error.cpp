#include <doctest/doctest.h>
#include <quadmatch/mesh/error.hpp>

using quadmatch::Error;
using quadmatch::ErrorCode;

TEST_CASE("an error says path, line and message, and leaves out what is not known") {
  const std::string message = "there is no number here; write one";
  CHECK(Error{ErrorCode::BadNumber, message, "a.obj", 7}.describe() == "a.obj:7: " + message);
  CHECK(Error{ErrorCode::BadNumber, message, "a.obj"}.describe() == "a.obj: " + message);
  CHECK(Error{ErrorCode::BadNumber, message, "", 7}.describe() == "line 7: " + message);
  CHECK(Error{ErrorCode::BadNumber, message}.describe() == message);
}
