#include "growth.hpp"

namespace quadmatch {

Evidence weigh(const std::vector<VertexPair>& vertices, const PerFan<VertexCode>& source_codes,
               const PerFan<VertexCode>& target_codes) {
  Evidence evidence;
  for (const VertexPair& pair : vertices) {
    // A vertex of several fans is judged by its first, which bears its number.
    const VertexCode left = source_codes[FanId(pair.source.value)];
    const VertexCode right = target_codes[FanId(pair.target.value)];
    evidence.source_extraordinary += left.extraordinary();
    evidence.target_extraordinary += right.extraordinary();
    evidence.agreeing += left.extraordinary() && left == right;
  }
  return evidence;
}

}  // namespace quadmatch
