#include "writer.hpp"

#include <utility>

namespace quadmatch::canonical {

Writer::Writer(const Mesh& mesh)
    : mesh_(mesh), reached_(mesh.face_count(), 0), numbered_(mesh.vertex_count()), images_(mesh) {}

LeastWriting Writer::write(std::span<const HalfedgeId> starts, const GivenNumbers& given, std::uint32_t next_number) {
  least_ = {};
  DisjointSets joined(static_cast<std::uint32_t>(starts.size()));
  std::uint32_t least_start = 0;
  for (std::uint32_t start = 0; start < starts.size(); ++start) {
    if (joined.find(start) < start) continue;  // as good as one that was tried
    switch (try_start(starts[start], given, next_number)) {
      case Trial::Less:
        std::swap(least_.numbers, numbers_);
        std::swap(least_.faces, faces_);
        least_start = start;
        break;
      case Trial::Equal:
        if (start > 0) images_.join(least_.faces, faces_, starts, joined);
        break;
      case Trial::Greater:
        break;
    }
  }
  LeastWriting result{std::move(least_), 0};
  for (std::uint32_t start = 0; start < starts.size(); ++start) {
    result.symmetries += joined.find(start) == joined.find(least_start) ? 1 : 0;
  }
  return result;
}

/// Write until a number is larger than the least writing's.
Writer::Trial Writer::try_start(HalfedgeId start, const GivenNumbers& given, std::uint32_t next_number) {
  ++run_;
  faces_.clear();
  numbers_.clear();
  put_ = 0;
  trial_ = least_.faces.empty() ? Trial::Less : Trial::Equal;
  reach(start);
  for (std::size_t here = 0; here < faces_.size(); ++here) {
    if (!put_face(faces_[here], given, next_number)) return Trial::Greater;
  }
  return trial_;
}

bool Writer::put_face(HalfedgeId start, const GivenNumbers& given, std::uint32_t& next_number) {
  if (!put(mesh_.size(mesh_.face(start)))) return false;
  HalfedgeId h = start;
  do {
    if (!put(number_of(mesh_.origin(h), given, next_number))) return false;
    const HalfedgeId beyond = mesh_.twin(h);
    if (beyond.valid() && reached_[mesh_.face(beyond)] != run_) reach(beyond);
    h = mesh_.next(h);
  } while (h != start);
  return true;
}

/// Note the next number of the trial. @return false where that makes it greater than the least.
bool Writer::put(std::uint32_t number) {
  if (trial_ == Trial::Equal) {
    // All writings of a component are equally long.
    const std::uint32_t least = least_.numbers[put_];
    if (number > least) return false;
    if (number == least) {
      ++put_;
      return true;
    }
    trial_ = Trial::Less;
    numbers_.assign(least_.numbers.begin(), least_.numbers.begin() + static_cast<std::ptrdiff_t>(put_));
  }
  numbers_.push_back(number);
  return true;
}

void Writer::reach(HalfedgeId h) {
  // It is read when its turn comes, a whole wave later.
  mesh_.prefetch(h);
  reached_[mesh_.face(h)] = run_;
  faces_.push_back(h);
}

std::uint32_t Writer::number_of(VertexId v, const GivenNumbers& given, std::uint32_t& next_number) {
  if (given.size() > 0 && given[v] != kNoNumber) return given[v];
  Numbered& numbered = numbered_[v];
  if (numbered.run != run_) numbered = {run_, next_number++};
  return numbered.number;
}

std::vector<std::uint32_t> Writer::numbers_of(std::span<const HalfedgeId> faces) {
  ++run_;
  least_ = {};
  numbers_.clear();
  trial_ = Trial::Less;
  std::uint32_t next_number = 0;
  for (const HalfedgeId start : faces) {
    put(mesh_.size(mesh_.face(start)));
    HalfedgeId h = start;
    do {
      put(number_of(mesh_.origin(h), {}, next_number));
      h = mesh_.next(h);
    } while (h != start);
  }
  return std::move(numbers_);
}

}  // namespace quadmatch::canonical
