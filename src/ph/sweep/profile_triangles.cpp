#include "phrame/ph/sweep/profile_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"

namespace phrame::inline v0 {
namespace {

/// Twice the area of a triangle, > 0 where it is counterclockwise.
Rational triangle_area(const ProfilePoint& a, const ProfilePoint& b, const ProfilePoint& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

}  // namespace

bool is_between(const ProfilePoint& p, const ProfilePoint& a, const ProfilePoint& b) {
  for (std::size_t k = 0; k < 2; ++k)
    if (p[k] < std::min(a[k], b[k]) || p[k] > std::max(a[k], b[k])) return false;
  return true;
}

int profile_turn(const ProfilePoint& a, const ProfilePoint& b, const ProfilePoint& c) {
  return triangle_area(a, b, c).sign();
}

bool meet(const ProfilePoint& a, const ProfilePoint& b, const ProfilePoint& c,
          const ProfilePoint& d) {
  const int abc = profile_turn(a, b, c);
  const int abd = profile_turn(a, b, d);
  const int cda = profile_turn(c, d, a);
  const int cdb = profile_turn(c, d, b);
  if (abc * abd < 0 && cda * cdb < 0) return true;
  return (abc == 0 && is_between(c, a, b)) || (abd == 0 && is_between(d, a, b)) ||
         (cda == 0 && is_between(a, c, d)) || (cdb == 0 && is_between(b, c, d));
}

namespace {

/// Signs of triangles of a profile's corners: by doubles where these are enough, else exactly.
class CornerSigns {
 public:
  explicit CornerSigns(const std::vector<ProfilePoint>& corners) : exact_(corners) {
    for (const auto& [x, y] : corners) {
      rounded_.push_back({round_to_double(x), round_to_double(y)});
      for (const double c : rounded_.back()) size_ = std::max(size_, std::abs(c));
    }
  }

  // With M the greatest coordinate, differences d of rounded ones are within 2^−51·M; those of
  // products of two of them within 2^−50·M·Σ|d| + 2^−101·M², rounding included.
  int turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const auto& [ax, ay] = rounded_[a];
    const double bx = rounded_[b][0] - ax;
    const double by = rounded_[b][1] - ay;
    const double cx = rounded_[c][0] - ax;
    const double cy = rounded_[c][1] - ay;
    const double area = bx * cy - by * cx;
    const double sum = std::abs(bx) + std::abs(by) + std::abs(cx) + std::abs(cy);
    const double error = 0x1p-49 * size_ * (sum + 0x1p-40 * size_) + 0x1p-1000;
    if (std::abs(area) > error && sum * size_ < HUGE_VAL) return area > 0 ? 1 : -1;
    return profile_turn(exact_[a], exact_[b], exact_[c]);
  }

  double distance(std::uint32_t a, std::uint32_t b) const {
    return std::hypot(rounded_[a][0] - rounded_[b][0], rounded_[a][1] - rounded_[b][1]);
  }

 private:
  const std::vector<ProfilePoint>& exact_;
  std::vector<std::array<double, 2>> rounded_;
  double size_ = 0;
};

/// What is left of a polygon while its ears are clipped: a ring of nodes, each at a corner. The
/// ends of a side there and back to a hole are two nodes each.
class EarRing {
 public:
  explicit EarRing(const Profile& profile);

  std::size_t size() const { return size_; }
  std::size_t next(std::size_t node) const { return next_[node]; }
  std::array<std::uint32_t, 3> triangle_at(std::size_t node) const {
    return {corner_[before_[node]], corner_[node], corner_[next_[node]]};
  }
  /// Is the triangle at the node within the polygon, with no other corner in it or on its sides?
  bool is_ear(std::size_t node) const;
  void clip(std::size_t node);

 private:
  const ProfilePoint& at(std::size_t node) const { return profile_.corners()[corner_[node]]; }
  int turn_at(std::size_t node) const {
    return signs_.turn(corner_[before_[node]], corner_[node], corner_[next_[node]]);
  }
  std::size_t add_node(std::uint32_t corner);
  void link(std::size_t from, std::size_t to) {
    next_[from] = to;
    before_[to] = from;
  }
  void join_hole(std::size_t first);
  bool is_visible(std::size_t node, std::size_t from) const;
  bool is_within_corner(std::size_t node, std::uint32_t p) const;
  bool is_in_the_way(std::uint32_t a, std::uint32_t b, std::uint32_t p, std::uint32_t q) const;

  const Profile& profile_;
  CornerSigns signs_;
  std::vector<std::uint32_t> corner_;
  std::vector<std::size_t> next_;
  std::vector<std::size_t> before_;
  std::vector<std::size_t> reflex_;  ///< nodes that are not convex: others are in no triangle
  std::vector<std::array<std::uint32_t, 2>> bridges_;  ///< the sides there and back
  std::size_t size_ = 0;
};

std::size_t EarRing::add_node(std::uint32_t corner) {
  corner_.push_back(corner);
  next_.push_back(0);
  before_.push_back(0);
  return corner_.size() - 1;
}

/// The corner of a ring that is farthest to the right.
std::size_t rightmost(const Profile& profile, std::size_t first) {
  std::size_t found = first;
  for (std::size_t k = profile.next(first); k != first; k = profile.next(k))
    if (profile.corners()[k] > profile.corners()[found]) found = k;
  return found;
}

EarRing::EarRing(const Profile& profile) : profile_(profile), signs_(profile.corners()) {
  const std::size_t count = profile.corners().size();
  for (std::size_t k = 0; k < count; ++k) add_node(static_cast<std::uint32_t>(k));
  for (std::size_t k = 0; k < count; ++k) link(k, profile.next(k));
  std::vector<std::size_t> holes;
  for (std::size_t k = 1; k < profile.rings().size(); ++k)
    holes.push_back(rightmost(profile, profile.rings()[k]));
  size_ = holes.empty() ? count : profile.rings()[1];
  std::sort(holes.begin(), holes.end(), [&](std::size_t a, std::size_t b) {
    return profile.corners()[a] > profile.corners()[b];
  });
  for (const std::size_t hole : holes) join_hole(hole);
  std::size_t node = 0;
  for (std::size_t k = 0; k < size_; ++k, node = next_[node])
    if (turn_at(node) <= 0) reflex_.push_back(node);
}

/// Does the corner lie between the two sides at the node, on the left of them?
bool EarRing::is_within_corner(std::size_t node, std::uint32_t p) const {
  const bool left_of_first = signs_.turn(corner_[before_[node]], corner_[node], p) > 0;
  const bool left_of_second = signs_.turn(corner_[node], corner_[next_[node]], p) > 0;
  return turn_at(node) > 0 ? left_of_first && left_of_second : left_of_first || left_of_second;
}

/// Do the lines from a to b and from p to q meet elsewhere than at an end of both?
bool EarRing::is_in_the_way(std::uint32_t a, std::uint32_t b, std::uint32_t p,
                            std::uint32_t q) const {
  const auto& corners = profile_.corners();
  const bool begins_there = a == p || a == q;
  if (!begins_there && b != p && b != q) {
    const int side = signs_.turn(p, q, a) * signs_.turn(p, q, b);
    return side <= 0 && meet(corners[a], corners[b], corners[p], corners[q]);
  }
  const std::uint32_t other = begins_there ? b : a;
  return signs_.turn(p, q, other) == 0 && is_between(corners[other], corners[p], corners[q]);
}

/// Is nothing in the way of a line between the two, within the polygon?
bool EarRing::is_visible(std::size_t node, std::size_t from) const {
  const std::uint32_t p = corner_[node];
  const std::uint32_t q = corner_[from];
  if (!is_within_corner(node, q)) return false;
  for (std::uint32_t k = 0; k < profile_.corners().size(); ++k)
    if (is_in_the_way(k, static_cast<std::uint32_t>(profile_.next(k)), p, q)) return false;
  return std::none_of(bridges_.begin(), bridges_.end(), [&](const auto& bridge) {
    return is_in_the_way(bridge[0], bridge[1], p, q);
  });
}

// The corner of a hole that is farthest to the right sees one of the polygon around it, in which
// the holes farther to the right are already [Eberly]: the end of the side that a ray to the right
// meets first, or a reflex corner in the triangle between. The nearest one
// is taken.
void EarRing::join_hole(std::size_t first) {
  std::vector<std::pair<double, std::size_t>> nodes;  // the nearest, about, on top of a heap
  std::size_t node = 0;
  for (std::size_t k = 0; k < size_; ++k, node = next_[node])
    nodes.emplace_back(signs_.distance(corner_[node], corner_[first]), node);
  std::make_heap(nodes.begin(), nodes.end(), std::greater<>());
  while (!nodes.empty() && !is_visible(nodes.front().second, first)) {
    std::pop_heap(nodes.begin(), nodes.end(), std::greater<>());
    nodes.pop_back();
  }
  if (nodes.empty()) throw Error("profile: the check failed, a hole sees nothing around it");
  const std::size_t to = nodes.front().second;
  std::size_t count = 0;
  std::size_t at_hole = first;
  do {
    at_hole = next_[at_hole];
    ++count;
  } while (at_hole != first);
  const std::size_t again = add_node(corner_[to]);
  const std::size_t back = add_node(corner_[first]);
  link(again, next_[to]);
  link(before_[first], back);
  link(to, first);
  link(back, again);
  bridges_.push_back({corner_[to], corner_[first]});
  size_ += count + 2;
}

bool EarRing::is_ear(std::size_t node) const {
  if (turn_at(node) <= 0) return false;
  const std::array<std::uint32_t, 3> triangle = triangle_at(node);
  return std::none_of(reflex_.begin(), reflex_.end(), [&](std::size_t other) {
    const auto [i, j, k] = triangle;
    const std::uint32_t p = corner_[other];
    if (p == i || p == j || p == k) return false;
    return signs_.turn(i, j, p) >= 0 && signs_.turn(j, k, p) >= 0 && signs_.turn(k, i, p) >= 0;
  });
}

void EarRing::clip(std::size_t node) {
  link(before_[node], next_[node]);
  --size_;
  // Its neighbours may have become convex.
  std::erase_if(reflex_, [&](std::size_t k) {
    return k == node || ((k == before_[node] || k == next_[node]) && turn_at(k) > 0);
  });
}

/// Twice the area that the rings bound.
Rational bounded_area(const Profile& profile) {
  Rational sum;
  for (std::size_t k = 0; k < profile.corners().size(); ++k) {
    const auto& [x, y] = profile.corners()[k];
    const auto& [next_x, next_y] = profile.corners()[profile.next(k)];
    sum += x * next_y - y * next_x;
  }
  return sum;
}

void require_filled(const Profile& profile,
                    const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  Rational rest = bounded_area(profile);
  for (const auto& [i, j, k] : triangles) {
    const Rational area =
        triangle_area(profile.corners()[i], profile.corners()[j], profile.corners()[k]);
    if (area <= 0) throw Error("profile: the check failed, a triangle has no area");
    rest -= area;
  }
  if (rest != 0) throw Error("profile: the check failed, its triangles do not fill it");
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulated(const Profile& profile) {
  EarRing ring(profile);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::size_t at = 0;
  // A polygon of four corners or more has two ears, one of which is found in less than one round.
  while (ring.size() > 3) {
    std::size_t tried = 0;
    for (; !ring.is_ear(at); at = ring.next(at))
      if (++tried > ring.size()) throw Error("profile: the check failed, there is no ear");
    triangles.push_back(ring.triangle_at(at));
    const std::size_t clipped = at;
    at = ring.next(ring.next(at));  // not the same corner again: a fan would have long thin ears
    ring.clip(clipped);
  }
  triangles.push_back(ring.triangle_at(at));
  require_filled(profile, triangles);
  return triangles;
}

}  // namespace phrame
