# cmake -DINPUT=page.html -DVIEWER=true|false -DOUTPUT=page.cpp -P embed.cmake: a text file as the constant that
# src/report/page.hpp names.
file(READ "${INPUT}" text)
string(FIND "${text}" ")page\"" end)
if(NOT end EQUAL -1)
  message(FATAL_ERROR "${INPUT} holds what would end the literal it is put into; choose another delimiter")
endif()
file(WRITE "${OUTPUT}" "// Made from ${INPUT} by cmake/embed.cmake.
#include \"page.hpp\"

namespace quadmatch::report {

std::string_view page() {
  return R\"page(${text})page\";
}

bool has_viewer() { return ${VIEWER}; }

}  // namespace quadmatch::report
")
