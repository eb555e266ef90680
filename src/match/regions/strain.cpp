#include "strain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>

#include "nth_smallest.hpp"

namespace quadmatch::regions {
namespace {

using Vector6 = Eigen::Matrix<float, 6, 1>;
using Matrix6 = Eigen::Matrix<float, 6, 6>;

/// What pulls the stretch of a face towards that of the whole: little beside matched faces, which count 6 each.
constexpr float kPull = 0.02F;
/// One length says no more than this: a wrong pair's may be anything.
constexpr double kMostStretch = 1.0;
/// No more does one face's error say of what is usual.
constexpr float kMostError = 0.2F;

/// Normal equations of the tensor's least squares fit: lower triangle, then right side; last, the share of faces heard
/// that are matched.
using Evidence = std::array<float, 28>;

void add_length(Evidence& evidence, const Vector6& row, float value, float weight) {
  std::size_t k = 0;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j <= i; ++j) evidence[k++] += weight * row[i] * row[j];
  }
  for (int i = 0; i < 6; ++i) evidence[k++] += weight * row[i] * value;
}

Vector6 tensor_of(const Evidence& evidence) {
  Matrix6 normal;
  Vector6 right;
  std::size_t k = 0;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j <= i; ++j) normal(i, j) = normal(j, i) = evidence[k++];
  }
  for (int i = 0; i < 6; ++i) right[i] = evidence[k++];
  for (int i = 0; i < 6; ++i) normal(i, i) += i < 3 ? kPull : 2 * kPull;
  return normal.ldlt().solve(right);
}

/// By how much a length in this direction grows, as a linear function of the tensor.
Vector6 growth_along(const Point& from, const Point& to) {
  const double x = to[0] - from[0], y = to[1] - from[1], z = to[2] - from[2];
  const double squared = x * x + y * y + z * z;
  if (!(squared > 0)) return Vector6::Zero();
  Vector6 row;
  row << static_cast<float>(x * x / squared), static_cast<float>(y * y / squared), static_cast<float>(z * z / squared),
      static_cast<float>(2 * x * y / squared), static_cast<float>(2 * x * z / squared),
      static_cast<float>(2 * y * z / squared);
  return row;
}

class Strain {
 public:
  Strain(const Sides& sides, const Patchwork& patchwork, const Lengths& source, const Lengths& target, double scale)
      : source_(sides.source.mesh),
        patchwork_(patchwork),
        source_lengths_(source),
        target_lengths_(target),
        scale_(scale),
        tensor_(source_.face_count(), Vector6::Zero()),
        heard_(source_.face_count(), 0) {}

  /// From far around to near; what fits badly far around is heard less nearby.
  void fit() {
    for (const int rings : {32, 16}) {
      PerFace<Evidence> evidence = gather();
      spread(evidence, rings);
      for (std::uint32_t f = 0; f < source_.face_count(); ++f) {
        tensor_[FaceId(f)] = tensor_of(evidence[FaceId(f)]);
        heard_[FaceId(f)] = evidence[FaceId(f)].back();
      }
    }
  }
  [[nodiscard]] Stretched result() const {
    constexpr float kEnough = 0.4F;  // of the faces around: at a straight rim it is half
    const auto stretch = [&](HalfedgeId h) {
      const Vector6& tensor = tensor_[source_.face(h)];
      return Lengths::Pair{along_edge(h).dot(tensor), along_diagonal(h).dot(tensor)};
    };
    Stretched result{source_lengths_.stretched(stretch), heard_, usual_errors()};
    for (std::uint32_t f = 0; f < source_.face_count(); ++f) {
      result.known[FaceId(f)] = std::min(1.0F, heard_[FaceId(f)] / kEnough);
    }
    return result;
  }

 private:
  [[nodiscard]] const Point& place(VertexId v) const { return source_.positions()[v.value]; }
  [[nodiscard]] Vector6 along_edge(HalfedgeId h) const {
    return growth_along(place(source_.origin(h)), place(source_.tip(h)));
  }
  [[nodiscard]] Vector6 along_diagonal(HalfedgeId h) const {
    return growth_along(place(source_.origin(h)), place(source_.tip(source_.next(h))));
  }
  [[nodiscard]] float edge_growth(HalfedgeId h, HalfedgeId t) const {
    return bounded(target_lengths_.edge(t) - source_lengths_.edge(h) - scale_);
  }
  [[nodiscard]] float diagonal_growth(HalfedgeId h, HalfedgeId t) const {
    return bounded(target_lengths_.diagonal(t) - source_lengths_.diagonal(h) - scale_);
  }
  [[nodiscard]] static float bounded(double growth) {
    return static_cast<float>(std::clamp(growth, -kMostStretch, kMostStretch));
  }

  /// How badly each matched face fits now; the usual error decides what is bad.
  [[nodiscard]] PerFace<float> weights() const {
    PerFace<float> errors(source_.face_count(), 0);
    std::vector<float> sorted;
    for_each_matched([&](FaceId face) {
      errors[face] = error(face);
      sorted.push_back(errors[face]);
    });
    if (sorted.empty()) return errors;
    const float usual = std::max(1e-4F, nth_smallest(sorted, sorted.size() / 2));
    for_each_matched([&](FaceId face) {
      const float ratio = errors[face] / usual;
      errors[face] = 1 / (1 + ratio * ratio);
    });
    return errors;
  }
  [[nodiscard]] float error(FaceId face) const {
    const Vector6& tensor = tensor_[face];
    float sum = 0;
    for (const HalfedgeId h : source_.halfedges(face)) {
      const HalfedgeId t = patchwork_.image(h);
      const float edge = edge_growth(h, t) - along_edge(h).dot(tensor);
      const float diagonal = diagonal_growth(h, t) - along_diagonal(h).dot(tensor);
      sum += edge * edge + 0.5F * diagonal * diagonal;
    }
    return std::sqrt(sum / (1.5F * static_cast<float>(source_.size(face))));
  }
  template <class Visit>
  void for_each_matched(Visit visit) const {
    for (std::uint32_t f = 0; f < source_.face_count(); ++f) {
      if (patchwork_.is_matched(FaceId(f))) visit(FaceId(f));
    }
  }

  /// What errors are usual about each face, matched or not.
  [[nodiscard]] PerFace<float> usual_errors() const {
    constexpr int kRings = 16;
    PerFace<std::array<float, 2>> sums(source_.face_count(), {0, 0});
    for_each_matched([&](FaceId face) { sums[face] = {std::min(error(face), kMostError), 1}; });
    spread(sums, kRings);
    PerFace<float> errors(source_.face_count(), 0);
    for (std::uint32_t f = 0; f < source_.face_count(); ++f) {
      const auto [sum, weight] = sums[FaceId(f)];
      errors[FaceId(f)] = weight > 0 ? sum / weight : 0;
    }
    return errors;
  }

  [[nodiscard]] PerFace<Evidence> gather() const {
    const PerFace<float> weight = weights();
    PerFace<Evidence> evidence(source_.face_count(), Evidence{});
    for_each_matched([&](FaceId face) {
      for (const HalfedgeId h : source_.halfedges(face)) {
        const HalfedgeId t = patchwork_.image(h);
        add_length(evidence[face], along_edge(h), edge_growth(h, t), weight[face]);
        add_length(evidence[face], along_diagonal(h), diagonal_growth(h, t), 0.5F * weight[face]);
      }
      evidence[face].back() = 1;
    });
    return evidence;
  }
  /// Let every face hear its neighbours, and they theirs.
  template <std::size_t kCount>
  void spread(PerFace<std::array<float, kCount>>& numbers, int rings) const {
    PerFace<std::array<float, kCount>> next(source_.face_count());
    for (int ring = 0; ring < rings; ++ring) {
      for (std::uint32_t f = 0; f < source_.face_count(); ++f) {
        std::array<float, kCount> sums = numbers[FaceId(f)];
        float heard = 1;
        for (const HalfedgeId h : source_.halfedges(FaceId(f))) {
          const HalfedgeId beside = source_.twin(h);
          if (!beside.valid()) continue;
          const std::array<float, kCount>& other = numbers[source_.face(beside)];
          for (std::size_t k = 0; k < kCount; ++k) sums[k] += other[k];
          heard += 1;
        }
        for (std::size_t k = 0; k < kCount; ++k) next[FaceId(f)][k] = sums[k] / heard;
      }
      std::swap(numbers, next);
    }
  }

  const Mesh& source_;
  const Patchwork& patchwork_;
  const Lengths& source_lengths_;
  const Lengths& target_lengths_;
  double scale_;
  PerFace<Vector6> tensor_;
  PerFace<float> heard_;  // the share of matched faces around
};

}  // namespace

Stretched stretched(const Sides& sides, const Patchwork& patchwork, const Lengths& source, const Lengths& target,
                    double scale) {
  Strain strain(sides, patchwork, source, target, scale);
  strain.fit();
  return strain.result();
}

}  // namespace quadmatch::regions
