// Pipes of lines and arcs, as they are bent: three legs took 25 s, and then it was not told that θ
// comes back to 0; a closed one with the holonomy π had no answer at all.
#include <set>

#include "phrame/algebra/rounding.hpp"
#include "phrame/answer/angle.hpp"
#include "phrame/answer/totals.hpp"
#include "phrame/ph/curve/real_vector.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/frame/compiled_angle.hpp"
#include "phrame/ph/frame/compiled_frame.hpp"
#include "phrame/ph/frame/path_frame.hpp"
#include "phrame/ph/twist/minimal_twist.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

struct Leg {
  Vector<Rational> direction;  ///< of length 1
  Rational length;
};

Vector<Rational> direction(Random& random) {
  const std::vector<Vector<Rational>> all{
      {1, 0, 0},
      {0, 1, 0},
      {0, 0, 1},
      {Rational(3, 5), Rational(4, 5), 0},
      {0, Rational(8, 17), Rational(15, 17)},
      {Rational(1, 3), Rational(2, 3), Rational(2, 3)},
      {Rational(-4, 9), Rational(1, 9), Rational(8, 9)},
  };
  const long last = random.chance(2) ? 2 : 6;
  return Rational(random.chance(2) ? 1 : -1) *
         all[static_cast<std::size_t>(random.integer(0, last))];
}

bool are_parallel(const Leg& a, const Leg& b) {
  return cross(a.direction, b.direction) == Vector<Rational>{};
}

/// A closed one goes each leg back later, in any order.
std::vector<Leg> legs(Random& random, bool is_closed) {
  for (;;) {
    std::vector<Leg> all;
    for (long k = random.integer(2, 4); k > 0; --k)
      all.push_back({direction(random), Rational(random.integer(4, 12), 2)});
    const std::size_t half = all.size();
    for (std::size_t k = 0; is_closed && k < half; ++k)
      all.push_back({Rational(-1) * all[k].direction, all[k].length});
    if (is_closed && random.chance(2))
      std::swap(all[half], all[static_cast<std::size_t>(random.integer(1, 2)) + half - 1]);
    bool bends = !is_closed || !are_parallel(all.back(), all.front());
    for (std::size_t k = 1; k < all.size(); ++k) bends = bends && !are_parallel(all[k - 1], all[k]);
    if (bends) return all;
  }
}

/// Arcs between the legs, which take a part of each.
Path pipe(Random& random, const std::vector<Leg>& legs, bool is_closed) {
  const std::size_t n = legs.size();
  std::vector<Rational> cut(n);  // at the end of each leg
  for (std::size_t k = 0; k + (is_closed ? 0 : 1) < n; ++k)
    cut[k] = std::min(legs[k].length, legs[(k + 1) % n].length) / Rational(random.integer(2, 4));
  std::vector<Segment> segments;
  Vector<Rational> at;
  for (std::size_t k = 0; k < n; ++k) {
    const Rational rest = legs[k].length - cut[k] - cut[(k + n - 1) % n];
    const Vector<Rational> end = at + rest * legs[k].direction;
    if (rest > 0) segments.emplace_back(bezier_curve({at, end}));
    at = end;
    if (cut[k] == 0) continue;
    const Leg& next = legs[(k + 1) % n];
    const Vector<Rational> corner = end + cut[k] * legs[k].direction;
    at = corner + cut[k] * next.direction;
    segments.emplace_back(
        bezier_curve({end, corner, at}, {1, 1, 2 / (1 + dot(legs[k].direction, next.direction))}));
  }
  return joined(std::move(segments));
}

/// The legs with their corners.
Path polygon(const std::vector<Leg>& legs) {
  std::vector<Segment> segments;
  Vector<Rational> at;
  for (const Leg& leg : legs) {
    const Vector<Rational> end = at + leg.length * leg.direction;
    segments.emplace_back(bezier_curve({at, end}));
    at = end;
  }
  return joined(std::move(segments));
}

/// What the turn of the direction a to b, about their normal, makes of a vector.
Vector<Rational> bent(const Vector<Rational>& v, const Vector<Rational>& a,
                      const Vector<Rational>& b) {
  return v - Rational(dot(a + b, v) / (1 + dot(a, b))) * (a + b) + Rational(2 * dot(a, v)) * b;
}

}  // namespace

TEST_CASE("pipes: law: all is answered, and the frame is bent with the legs") {
  for_samples(12, [](Random& random) {
    const bool is_closed = random.chance(2);
    const std::vector<Leg> all = legs(random, is_closed);
    const NamedPath named{"", pipe(random, all, is_closed)};
    const PathAngle angle(named.path);
    const Place end{named.path.segments().size() - 1, Rational(1)};

    // In an arc the frame turns with the tangent about the normal of its plane.
    const auto carried = [&](Vector<Real> v) {
      for (std::size_t k = 0; k + (is_closed ? 0 : 1) < all.size(); ++k) {
        const Vector<Rational>& a = all[k].direction;
        const Vector<Rational>& b = all[(k + 1) % all.size()].direction;
        Vector<Real> next{Rational(0), Rational(0), Rational(0)};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          Vector<Rational> unit;
          unit[axis] = 1;
          const Vector<Rational> image = bent(unit, a, b);
          for (std::size_t j = 0; j < 3; ++j) next[j] = next[j] + image[j] * v[axis];
        }
        v = next;
      }
      return v;
    };
    const auto check_frame = [&](const PathAngle& along, const Place& to) {
      const Frame<Real> start = rotation_minimizing_frame(along, {0, Rational(0)}, Rational(0));
      const Frame<Real> found = rotation_minimizing_frame(along, to, Rational(0));
      const Vector<Real> expected = carried(start.e2);
      for (std::size_t k = 0; k < 3; ++k)
        CHECK(found.e2[k].enclose(120).overlaps(expected[k].enclose(120)));
    };
    check_frame(angle, end);
    // However small the arcs are: the polygon of their corners has the same, the discrete
    // rotation-minimizing frame [Bergou et al. 2008].
    if (!is_closed) check_frame(PathAngle(polygon(all)), {all.size() - 1, Rational(1)});

    const AngleAnswer answered = answer(named, AngleQuery{.at = {Rational(1, 3)}});
    CHECK(answered.holonomy.has_value() == is_closed);
    CHECK(answered.no_holonomy.empty());
    for (const TotalsAnswer::Row& row : answer(named, TotalsQuery{}).rows)
      CHECK_MESSAGE(row.reason.find("undecided") == std::string::npos, row.reason);
    const MinimalTwist twist =
        minimal_twist(angle, Angle(), is_closed ? FrameStart(Angle()) : FrameStart(Angle(1)));
    round_to_decimal(twist.twist(), 17);
    CompiledFrames(angle, Rational(0));
  });
}
