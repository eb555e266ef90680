#include "truth_file.hpp"

#include <fstream>

#include <fmt/format.h>

namespace quadmatch {

bool write_truth(const std::string& path, const std::vector<FacePair>& truth) {
  std::ofstream file(path, std::ios::binary);
  file << "{\"orientation\": \"preserving\",\n \"partial\": {},\n \"exact\": [";
  const char* separator = "";
  for (const FacePair& pair : truth) {
    file << fmt::format("{}[{}, {}, {}]", separator, pair.source.value, pair.target.value, pair.rotation);
    separator = ", ";
  }
  file << "]}\n";
  return file.flush().good();
}

}  // namespace quadmatch
