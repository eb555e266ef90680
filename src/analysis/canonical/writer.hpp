#pragma once
/// Writes a component as numbers, from a half-edge on: whoever reads them can build it anew, so two components with the
/// same writing are the same.

#include <cstdint>
#include <span>
#include <vector>

#include <quadmatch/mesh/mesh.hpp>
#include <quadmatch/mesh/per_element.hpp>

#include "images.hpp"

namespace quadmatch::canonical {

/// A writing of faces: for each the number of its corners, then the numbers of their vertices.
struct Writing {
  std::vector<std::uint32_t> numbers;
  /// The faces in this order, each by the half-edge it is read from.
  std::vector<HalfedgeId> faces;
};

/// The least writing of a component and how many half-edges it can be written from.
struct LeastWriting {
  Writing writing;
  std::uint32_t symmetries = 1;
};

/// Vertices that bear a number already; invalid ones (kNone) are numbered as they come. No entries: all of them.
using GivenNumbers = PerVertex<std::uint32_t>;
constexpr std::uint32_t kNoNumber = VertexId::kNone;

class Writer {
 public:
  /// Memory for the whole mesh; make one and use it again and again.
  explicit Writer(const Mesh& mesh);

  /// Write the component of a half-edge from each of `starts`, and keep the lexicographically least writing.
  ///
  /// Faces come breadth first: a face is read from the half-edge through which it was reached, which the starting
  /// half-edge decides for all. A writing is given up at its first number that is larger than the least one's. Two that
  /// are equal are a symmetry of the component; starts that a known symmetry lays on a start that was tried need not be
  /// tried, so those that succeed are at most log2 of the symmetries.
  ///
  /// @param starts  of one component, ascending, not empty; with every half-edge all those that a symmetry lays it on.
  /// @param given   numbers of vertices that keep them.
  /// @param next_number  for the first vertex without; larger than all that are given.
  /// @par Cost      O(corners) for each start that is written to its end.
  [[nodiscard]] LeastWriting write(std::span<const HalfedgeId> starts, const GivenNumbers& given = {},
                                   std::uint32_t next_number = 0);

  /// The writing that takes the faces in a given order, vertices numbered from 0 as they come.
  [[nodiscard]] std::vector<std::uint32_t> numbers_of(std::span<const HalfedgeId> faces);

 private:
  enum class Trial { Less, Equal, Greater };

  Trial try_start(HalfedgeId start, const GivenNumbers& given, std::uint32_t next_number);
  bool put(std::uint32_t number);
  bool put_face(HalfedgeId start, const GivenNumbers& given, std::uint32_t& next_number);
  void reach(HalfedgeId h);
  std::uint32_t number_of(VertexId v, const GivenNumbers& given, std::uint32_t& next_number);

  const Mesh& mesh_;
  Writing least_;
  std::vector<std::uint32_t> numbers_;  // of a trial that is less, from its beginning
  std::vector<HalfedgeId> faces_;       // of the trial
  std::size_t put_ = 0;                 // numbers of the trial
  Trial trial_ = Trial::Less;

  // What holds for one run only bears its number.
  std::uint32_t run_ = 0;
  PerFace<std::uint32_t> reached_;
  struct Numbered {
    std::uint32_t run = 0, number = 0;
  };
  PerVertex<Numbered> numbered_;
  Images images_;
};

}  // namespace quadmatch::canonical
