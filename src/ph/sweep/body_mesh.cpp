#include "phrame/ph/sweep/body_mesh.hpp"

#include <cmath>
#include <limits>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/sweep/profile_triangles.hpp"

namespace phrame::inline v0 {
namespace {

bool is_same(const SweepSection& a, const SweepSection& b, std::size_t k) {
  const Vector<double> way = b.points[k] - a.points[k];
  return std::hypot(way[0], way[1], way[2]) <= 8 * (a.rounding + b.rounding);
}

}  // namespace

BodyMesh::BodyMesh(const Profile& profile, bool is_closed, bool is_against, MeshSink& out)
    : profile_(profile), is_closed_(is_closed), is_against_(is_against), out_(out) {}

void BodyMesh::add(const SweepSection& section) {
  if (!is_closed_) return add_ring(section, false);
  waiting_.push_back(section);
  if (waiting_.size() < 3) return;
  add_ring(std::move(waiting_.front()), false);
  waiting_.erase(waiting_.begin());
}

void BodyMesh::finish() {
  if (is_closed_) {
    add_ring(std::move(waiting_.front()), waiting_.back().is_joint);
    return add_strip(last_, first_);
  }
  for (const auto& [i, j, k] : triangulated(profile_)) {
    add_triangle(first_, i, first_, k, first_, j);  // seen from behind
    add_triangle(last_, i, last_, j, last_, k);
  }
}

/// At a corner the rings share the points that lie on the axis of the turn; a ring at the joint of
/// a closed path shares those of the first.
void BodyMesh::add_ring(SweepSection section, bool is_at_joint) {
  Ring ring{std::move(section)};
  for (std::size_t k = 0; k < ring.section.points.size(); ++k) {
    const bool has_last =
        sections_ > 0 && ring.section.is_joint && is_same(last_.section, ring.section, k);
    const bool has_first = sections_ > 0 && is_at_joint && is_same(ring.section, first_.section, k);
    if (has_last || has_first) {
      const Ring& other = has_last ? last_ : first_;
      ring.numbers.push_back(other.numbers[k]);
      ring.points.push_back(other.points[k]);
    } else {
      if (points_ == std::numeric_limits<std::uint32_t>::max())
        throw Undecided("sweep: more than 4294967295 points are needed");
      ring.numbers.push_back(points_++);
      ring.points.push_back(ring.section.points[k]);
      out_.add_point(ring.points.back());
    }
  }
  folds_ += ring.section.folds;
  if (sections_++ == 0)
    first_ = ring;
  else
    add_strip(last_, ring);
  last_ = std::move(ring);
  out_.keep_points(first_.numbers, last_.numbers);
}

void BodyMesh::add_strip(const Ring& here, const Ring& there) {
  for (std::size_t k = 0; k < here.numbers.size(); ++k) {
    const std::size_t next = profile_.next(k);
    add_triangle(here, k, here, next, there, next);
    add_triangle(here, k, there, next, there, k);
  }
}

/// Nothing where two of its points are one.
void BodyMesh::add_triangle(const Ring& a, std::size_t i, const Ring& b, std::size_t j,
                            const Ring& c, std::size_t k) {
  MeshSink::Triangle numbers{a.numbers[i], b.numbers[j], c.numbers[k]};
  MeshSink::Corners corners{&a.points[i], &b.points[j], &c.points[k]};
  if (numbers[0] == numbers[1] || numbers[1] == numbers[2] || numbers[2] == numbers[0]) return;
  if (is_against_) {
    std::swap(numbers[1], numbers[2]);
    std::swap(corners[1], corners[2]);
  }
  out_.add_triangle(numbers, corners);
}

}  // namespace phrame
