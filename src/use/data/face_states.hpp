#pragma once
/// Records of OBJ that hold from a face on, as states of faces and back.

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <quadmatch/io/mesh_file.hpp>

namespace quadmatch::use {

/// A record of the one or the other of two files, or none.
struct RecordId {
  bool own = false;  ///< of the second
  std::uint32_t index = std::numeric_limits<std::uint32_t>::max();

  [[nodiscard]] bool valid() const { return index != std::numeric_limits<std::uint32_t>::max(); }
  bool operator==(const RecordId& other) const { return index == other.index && (own == other.own || !other.valid()); }
};

/// One kind of record, by faces.
struct Track {
  std::string keyword;
  std::vector<RecordId> states;
};

/// What holds at each face of a file: the index of a record, or 0xffffffff before the first.
[[nodiscard]] std::vector<std::uint32_t> states_of(const MeshFile& file, std::string_view keyword);

/// The kinds of records that the files have, in the order in which they come.
[[nodiscard]] std::vector<std::string> keywords_of(const std::vector<const MeshFile*>& files);

/// The records of a file whose faces have these states, in its order. One is written where the record behind a state
/// changes. A face without a state after one with a state is preceded by `g default`, `s off`, or `o` or `usemtl`
/// without a name.
[[nodiscard]] std::vector<FaceRecord> records_of(const MeshFile& first, const MeshFile& second,
                                                 const std::vector<Track>& tracks);

}  // namespace quadmatch::use
