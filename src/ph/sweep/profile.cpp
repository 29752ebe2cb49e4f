#include "phrame/ph/sweep/profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"

namespace phrame {
namespace {

/// The sign of the area of a triangle: 1 where it is counterclockwise.
int turn(const ProfilePoint& a, const ProfilePoint& b, const ProfilePoint& c) {
  return ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).sign();
}

/// Is p, which is on the line through a and b, between them, the ends included?
bool is_between(const ProfilePoint& p, const ProfilePoint& a, const ProfilePoint& b) {
  for (std::size_t k = 0; k < 2; ++k)
    if (p[k] < std::min(a[k], b[k]) || p[k] > std::max(a[k], b[k])) return false;
  return true;
}

bool meet(const ProfilePoint& a, const ProfilePoint& b, const ProfilePoint& c,
          const ProfilePoint& d) {
  const int abc = turn(a, b, c);
  const int abd = turn(a, b, d);
  const int cda = turn(c, d, a);
  const int cdb = turn(c, d, b);
  if (abc * abd < 0 && cda * cdb < 0) return true;
  return (abc == 0 && is_between(c, a, b)) || (abd == 0 && is_between(d, a, b)) ||
         (cda == 0 && is_between(a, c, d)) || (cdb == 0 && is_between(b, c, d));
}

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
    if (turn(corner(i), corner(i + 1), corner(i + 2)) == 0 &&
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
  if (x <= 0)
    throw DomainError(fmt::format("profile: {} is not > 0: {}", what, abbreviated(to_string(x))));
}

}  // namespace

Profile::Profile(std::vector<ProfilePoint> corners, Rational error, Rational angle)
    : corners_(std::move(corners)), error_(std::move(error)), angle_(std::move(angle)) {
  if (corners_.size() > 1 && corners_.front() == corners_.back()) corners_.pop_back();
  if (corners_.size() < 3)
    throw DomainError(
        fmt::format("profile: it has {} corners, at least 3 are needed", corners_.size()));
  require_simple(corners_);
  if (doubled_area(corners_) < 0) std::reverse(corners_.begin(), corners_.end());
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
  std::vector<ProfilePoint> points;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto& [x, y] = corners[k];
    const auto& [next_x, next_y] = corners[profile.next(k)];
    for (long n = 0; n < pieces[k]; ++n) {
      const Rational u(n, pieces[k]);
      points.push_back({x + u * (next_x - x), y + u * (next_y - y)});
    }
  }
  return Profile(std::move(points), profile.error(), profile.angle());
}

namespace {

/// What is left of a polygon while its ears are clipped: a ring of corners.
class Ring {
 public:
  explicit Ring(const std::vector<ProfilePoint>& corners)
      : corners_(corners), next_(corners.size()), before_(corners.size()) {
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i) {
      next_[i] = (i + 1) % n;
      before_[i] = (i + n - 1) % n;
    }
    for (std::size_t i = 0; i < n; ++i)
      if (turn_at(i) <= 0) reflex_.push_back(i);
  }

  std::size_t next(std::size_t i) const { return next_[i]; }
  std::array<std::uint32_t, 3> triangle_at(std::size_t i) const {
    return {static_cast<std::uint32_t>(before_[i]), static_cast<std::uint32_t>(i),
            static_cast<std::uint32_t>(next_[i])};
  }
  /// Is the triangle at the corner within the polygon, with no other corner in it or on its sides?
  bool is_ear(std::size_t i) const;
  void clip(std::size_t i);

 private:
  int turn_at(std::size_t i) const {
    return turn(corners_[before_[i]], corners_[i], corners_[next_[i]]);
  }

  const std::vector<ProfilePoint>& corners_;
  std::vector<std::size_t> next_;
  std::vector<std::size_t> before_;
  std::vector<std::size_t> reflex_;  ///< corners that are not convex: others are in no triangle
};

bool Ring::is_ear(std::size_t i) const {
  if (turn_at(i) <= 0) return false;
  const ProfilePoint& a = corners_[before_[i]];
  const ProfilePoint& b = corners_[i];
  const ProfilePoint& c = corners_[next_[i]];
  return std::none_of(reflex_.begin(), reflex_.end(), [&](std::size_t k) {
    if (k == before_[i] || k == i || k == next_[i]) return false;
    const ProfilePoint& p = corners_[k];
    return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
  });
}

void Ring::clip(std::size_t i) {
  next_[before_[i]] = next_[i];
  before_[next_[i]] = before_[i];
  // Its neighbours may have become convex.
  std::erase_if(reflex_, [&](std::size_t k) {
    return k == i || ((k == before_[i] || k == next_[i]) && turn_at(k) > 0);
  });
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulated(const Profile& profile) {
  Ring ring(profile.corners());
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::size_t at = 0;
  // A polygon of four corners or more has two ears, one of which is found in less than one round.
  for (std::size_t left = profile.corners().size(); left > 3; --left) {
    while (!ring.is_ear(at)) at = ring.next(at);
    triangles.push_back(ring.triangle_at(at));
    const std::size_t clipped = at;
    at = ring.next(ring.next(at));  // not the same corner again: a fan would have long thin ears
    ring.clip(clipped);
  }
  triangles.push_back(ring.triangle_at(at));
  return triangles;
}

}  // namespace phrame
