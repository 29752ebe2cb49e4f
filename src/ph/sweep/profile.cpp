#include "phrame/ph/sweep/profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/sweep/profile_triangles.hpp"

namespace phrame::inline v0 {
namespace {

/// Around a side, in doubles: rounding keeps the order of numbers, so that sides whose boxes are
/// apart are, too.
struct SideBox {
  std::array<double, 2> low;
  std::array<double, 2> high;

  bool is_apart_from(const SideBox& other) const {
    for (std::size_t k = 0; k < 2; ++k)
      if (high[k] < other.low[k] || other.high[k] < low[k]) return true;
    return false;
  }
};

std::vector<SideBox> side_boxes(const std::vector<ProfilePoint>& corners) {
  std::vector<SideBox> boxes;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    SideBox box{};
    for (std::size_t k = 0; k < 2; ++k) {
      const double a = round_to_double(corners[i][k]);
      const double b = round_to_double(corners[(i + 1) % corners.size()][k]);
      box.low[k] = std::min(a, b);
      box.high[k] = std::max(a, b);
    }
    boxes.push_back(box);
  }
  return boxes;
}

void require_simple(const std::vector<ProfilePoint>& corners) {
  const std::size_t n = corners.size();
  const auto corner = [&](std::size_t i) -> const ProfilePoint& { return corners[i % n]; };
  for (std::size_t i = 0; i < n; ++i)
    if (corner(i) == corner(i + 1))
      throw DomainError(
          fmt::format("profile: the corners {} and {} are the same point", i + 1, (i + 1) % n + 1));
  const auto boxes = side_boxes(corners);
  for (std::size_t i = 0; i < n; ++i) {
    // Sides with a common corner go back on each other only if they are on one line.
    if (profile_turn(corner(i), corner(i + 1), corner(i + 2)) == 0 &&
        !is_between(corner(i + 1), corner(i), corner(i + 2)))
      throw DomainError(fmt::format("profile: it turns back at the corner {}", (i + 1) % n + 1));
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      if (boxes[i].is_apart_from(boxes[j])) continue;
      if (meet(corner(i), corner(i + 1), corner(j), corner(j + 1)))
        throw DomainError(
            fmt::format("profile: the sides after the corners {} and {} meet", i + 1, j + 1));
    }
  }
}

/// A simple ring with what it lies in.
struct BoxedRing {
  const std::vector<ProfilePoint>& corners;
  std::vector<SideBox> sides;
  SideBox all;

  explicit BoxedRing(const std::vector<ProfilePoint>& ring)
      : corners(ring), sides(side_boxes(ring)), all(sides.front()) {
    for (const SideBox& side : sides)
      for (std::size_t k = 0; k < 2; ++k) {
        all.low[k] = std::min(all.low[k], side.low[k]);
        all.high[k] = std::max(all.high[k], side.high[k]);
      }
  }
};

bool rings_meet(const BoxedRing& a, const BoxedRing& b) {
  if (a.all.is_apart_from(b.all)) return false;
  const auto& p = a.corners;
  const auto& q = b.corners;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (a.sides[i].is_apart_from(b.all)) continue;
    for (std::size_t j = 0; j < q.size(); ++j)
      if (!a.sides[i].is_apart_from(b.sides[j]) &&
          meet(p[i], p[(i + 1) % p.size()], q[j], q[(j + 1) % q.size()]))
        return true;
  }
  return false;
}

/// Does the ring go around the other, which it does not meet? A ray to the right is counted that
/// meets sides which begin on or below it and end above it, or the other way round.
bool goes_around(const BoxedRing& around, const BoxedRing& other) {
  if (around.all.is_apart_from(other.all)) return false;
  const auto& ring = around.corners;
  const ProfilePoint& p = other.corners.front();
  bool is_inside = false;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const ProfilePoint& a = ring[k];
    const ProfilePoint& b = ring[(k + 1) % ring.size()];
    if ((a[1] > p[1]) == (b[1] > p[1])) continue;
    if (profile_turn(a, b, p) == (b[1] > a[1] ? 1 : -1)) is_inside = !is_inside;
  }
  return is_inside;
}

/// The number of the ring around all others, which have none around them but this.
std::size_t outer_ring(const std::vector<std::vector<ProfilePoint>>& all) {
  const std::vector<BoxedRing> rings(all.begin(), all.end());
  std::size_t outer = 0;
  for (std::size_t k = 0; k < rings.size(); ++k) {
    for (std::size_t n = 0; n < k; ++n)
      if (rings_meet(rings[n], rings[k]))
        throw DomainError(fmt::format("profile: the rings {} and {} meet", n + 1, k + 1));
    if (goes_around(rings[k], rings[outer])) outer = k;
  }
  for (std::size_t k = 0; k < rings.size(); ++k)
    for (std::size_t n = 0; n < rings.size(); ++n) {
      if (n == k || k == outer) continue;
      const bool is_within = goes_around(rings[n], rings[k]);
      if (n == outer && !is_within)
        throw DomainError(
            fmt::format("profile: the ring {} is not within the ring {}: they would be two bodies",
                        k + 1, n + 1));
      if (n != outer && is_within)
        throw DomainError(fmt::format("profile: the ring {} is within the ring {}, which is a hole",
                                      k + 1, n + 1));
    }
  return outer;
}

Rational doubled_area(const std::vector<ProfilePoint>& corners) {
  Rational sum;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const ProfilePoint& a = corners[i];
    const ProfilePoint& b = corners[(i + 1) % corners.size()];
    sum += a[0] * b[1] - a[1] * b[0];
  }
  return sum;
}

void require_positive(const Rational& x, const char* what) {
  if (x <= 0) throw DomainError(fmt::format("profile: {} is not > 0: {}", what, as_written(x)));
}

}  // namespace

namespace {

/// Counterclockwise, each corner once. Throws DomainError.
std::vector<ProfilePoint> simple_ring(std::vector<ProfilePoint> corners) {
  if (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
  if (corners.size() < 3)
    throw DomainError(
        fmt::format("profile: it has {} corners, at least 3 are needed", corners.size()));
  require_simple(corners);
  if (doubled_area(corners) < 0) std::reverse(corners.begin(), corners.end());
  return corners;
}

}  // namespace

void Profile::append_ring(std::vector<ProfilePoint> corners) {
  const std::size_t first = corners_.size();
  rings_.push_back(first);
  for (std::size_t k = 0; k < corners.size(); ++k)
    next_.push_back(first + (k + 1) % corners.size());
  corners_.insert(corners_.end(), std::make_move_iterator(corners.begin()),
                  std::make_move_iterator(corners.end()));
}

Profile::Profile(std::vector<ProfilePoint> corners, Rational error, Rational angle)
    : Profile(std::move(error), std::move(angle)) {
  append_ring(simple_ring(std::move(corners)));
}

Profile Profile::of_rings(std::vector<std::vector<ProfilePoint>> rings, const Rational& error,
                          const Rational& angle) {
  if (rings.size() == 1) return Profile(std::move(rings.front()), error, angle);
  if (rings.empty()) throw DomainError("profile: it has no ring");
  for (std::size_t k = 0; k < rings.size(); ++k) try {
      rings[k] = simple_ring(std::move(rings[k]));
    } catch (const DomainError& complaint) {
      throw DomainError(fmt::format("{} (of the ring {})", complaint.what(), k + 1));
    }
  const std::size_t outer = outer_ring(rings);
  Profile profile(error, angle);
  profile.append_ring(rings[outer]);
  for (std::size_t k = 0; k < rings.size(); ++k) {
    if (k == outer) continue;
    std::reverse(rings[k].begin(), rings[k].end());
    profile.append_ring(std::move(rings[k]));
  }
  return profile;
}

double Profile::reach() const {
  double greatest = 0;
  for (const auto& [x, y] : corners_)
    greatest = std::max(greatest, std::hypot(round_to_double(x), round_to_double(y)));
  return greatest * (1 + 0x1p-50);
}

Profile regular_polygon(long corners, const Rational& radius) {
  require_positive(radius, "the radius");
  if (corners < 3)
    throw DomainError(fmt::format("profile: it has {} corners, at least 3 are needed", corners));
  std::vector<ProfilePoint> points{{radius, 0}};
  for (long k = 1; k < corners; ++k) {
    const double angle = 2 * M_PI * static_cast<double>(k) / static_cast<double>(corners);
    points.push_back(
        {radius * exact_rational(std::cos(angle)), radius * exact_rational(std::sin(angle))});
  }
  // An angle in doubles is off by at most 2^−50, cosine and sine by less than that; a side is at
  // least 4R/n long.
  return Profile(std::move(points), radius * power_of_two(-48),
                 Rational(corners) * power_of_two(-48));
}

Profile circle_profile(const Rational& radius, const Rational& tolerance,
                       const std::optional<Rational>& angle) {
  require_positive(radius, "the radius");
  require_positive(tolerance, "the tolerance");
  if (angle) require_positive(*angle, "the tolerance of normals");
  // A chord of the angle 2π/n is R(1 − cos π/n) ≤ R(π/n)²/2 < 5R/n² away, at the angle π/n < 22/7n
  // to the ends of its arc.
  const double n = std::max(std::ceil(std::sqrt(5 * round_to_double(Rational(radius / tolerance)))),
                            angle ? std::ceil(22 / (7 * round_to_double(*angle)) + 0x1p-30) : 0);
  if (!(n <= 10'000))
    throw DomainError(
        "profile: the tolerance is too small for the circle: more than 10000 corners are needed");
  const long corners = std::max(6L, static_cast<long>(n));
  const Profile polygon = regular_polygon(corners, radius);
  return Profile(polygon.corners(), polygon.error() + 5 * radius / Rational(corners * corners),
                 Rational(22, 7 * corners));
}

Profile rectangle_profile(const Rational& width, const Rational& height) {
  require_positive(width, "the width");
  require_positive(height, "the height");
  const Rational x = width / 2;
  const Rational y = height / 2;
  return Profile({{x, y}, {-x, y}, {-x, -y}, {x, -y}});
}

Profile subdivided(const Profile& profile, const std::vector<long>& pieces) {
  const auto& corners = profile.corners();
  Profile divided(profile.error(), profile.angle());
  for (const std::size_t first : profile.rings()) {
    std::vector<ProfilePoint> points;
    std::size_t k = first;
    do {
      const auto& [x, y] = corners[k];
      const auto& [next_x, next_y] = corners[profile.next(k)];
      for (long n = 0; n < pieces[k]; ++n) {
        const Rational u(n, pieces[k]);
        points.push_back({x + u * (next_x - x), y + u * (next_y - y)});
      }
      k = profile.next(k);
    } while (k != first);
    divided.append_ring(std::move(points));
  }
  return divided;
}

}  // namespace phrame
