#include <quadmatch/shapes/figures.hpp>

#include <algorithm>
#include <array>

#include <quadmatch/shapes/edit.hpp>

#include "soup_builder.hpp"
#include "soup_faces.hpp"

namespace quadmatch::shapes {
namespace {

// Figure 4.1 in numbers: below "start" 12 columns, 10 rows high; above it 15 columns, 3 rows high.
constexpr std::uint32_t kColumns = 12;
constexpr std::uint32_t kLowerRows = 10;
constexpr std::uint32_t kUpperRows = 3;
constexpr std::uint32_t kExtraColumns = 3;  // the fewest with which the hole is a triangle and the mesh simple
constexpr std::uint32_t kStartColumn = 6;
// The squeezed quads: in the row below the one that hangs from "start", left of its column. There the fire from
// "start" runs along the row before it gets round its end, and what greedy growth takes for granted is wrong.
constexpr std::uint32_t kSqueezedRow = 8;
constexpr std::array<std::uint32_t, 3> kSqueezedColumns = {3, 4, 5};

constexpr std::uint32_t lower_vertex(std::uint32_t i, std::uint32_t j) { return j * (kColumns + 1) + i; }

/// The points above "start", in rows of one more than 15; row 0 is the topmost lower row, with the hole's rim between.
std::uint32_t upper_vertex(std::uint32_t i, std::uint32_t j) {
  constexpr std::uint32_t kWidth = kColumns + kExtraColumns + 1;
  if (j > 0) return lower_vertex(0, kLowerRows + 1) + (kExtraColumns - 1) + (j - 1) * kWidth + i;
  if (i <= kStartColumn) return lower_vertex(i, kLowerRows);
  if (i >= kStartColumn + kExtraColumns) return lower_vertex(i - kExtraColumns, kLowerRows);
  return lower_vertex(0, kLowerRows + 1) + (i - kStartColumn - 1);
}

void add_lower_points(SoupBuilder& builder) {
  for (std::uint32_t j = 0; j <= kLowerRows; ++j) {
    for (std::uint32_t i = 0; i <= kColumns; ++i) builder.vertex(i, j, 0);
  }
}

/// The further up, the more room the extra columns have; the hole lies just above "start".
void add_upper_points(SoupBuilder& builder) {
  for (std::uint32_t i = 1; i < kExtraColumns; ++i) {
    builder.vertex(kStartColumn + 0.4 * (i - 0.5 * kExtraColumns), kLowerRows + 0.4, 0);
  }
  for (std::uint32_t j = 1; j <= kUpperRows; ++j) {
    const double room = 1.0 * kExtraColumns * (j + 1) / (kUpperRows + 1);
    for (std::uint32_t i = 0; i <= kColumns + kExtraColumns; ++i) {
      const double extra = std::clamp((1.0 * i - kStartColumn) / kExtraColumns, 0.0, 1.0);
      builder.vertex(i - extra * kExtraColumns + (extra - 0.5) * room, kLowerRows + j, 0);
    }
  }
}

HalfedgeId image(HalfedgeId h, const std::vector<FacePair>& truth) {
  const auto pair = std::find_if(truth.begin(), truth.end(),
                                 [&](const FacePair& candidate) { return candidate.source.value == h.value / 4; });
  return HalfedgeId(4 * pair->target.value + h.value % 4);
}

}  // namespace

Figure41 fig_4_1() {
  SoupBuilder builder;
  add_lower_points(builder);
  add_upper_points(builder);
  for (std::uint32_t j = 0; j < kLowerRows; ++j) {
    for (std::uint32_t i = 0; i < kColumns; ++i) {
      builder.face_of({lower_vertex(i, j), lower_vertex(i + 1, j), lower_vertex(i + 1, j + 1), lower_vertex(i, j + 1)});
    }
  }
  for (std::uint32_t j = 0; j < kUpperRows; ++j) {
    for (std::uint32_t i = 0; i < kColumns + kExtraColumns; ++i) {
      builder.face_of({upper_vertex(i, j), upper_vertex(i + 1, j), upper_vertex(i + 1, j + 1), upper_vertex(i, j + 1)});
    }
  }
  const std::uint32_t first_extra_face = kColumns * kLowerRows + kStartColumn;
  return {builder.take(), VertexId(lower_vertex(kStartColumn, kLowerRows)), HalfedgeId(4 * first_extra_face)};
}

Figure42 fig_4_2() {
  const Figure41 original = fig_4_1();
  Figure42 figure;
  figure.soup = original.soup;
  for (std::uint32_t f = 0; f < face_count(original.soup); ++f) figure.truth.push_back({FaceId(f), FaceId(f), 0});
  for (const std::uint32_t column : kSqueezedColumns) {
    const FaceId face(kSqueezedRow * kColumns + column);
    figure.squeezed.push_back(face);
    // The lower left corner onto the upper right one. It always fits: pinned by the tests.
    Expected<Edit> edit = collapse_quad(figure.soup, image(HalfedgeId(4 * face.value), figure.truth));
    figure.truth = chained(figure.truth, edit->truth, edit->soup);
    figure.soup = std::move(edit->soup);
  }
  figure.seed = image(original.seed, figure.truth);
  figure.start = figure.soup.corners[figure.seed.value];
  return figure;
}

}  // namespace quadmatch::shapes
