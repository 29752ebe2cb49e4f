#include "phrame/ph/offset/exact_meetings.hpp"

#include <algorithm>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/eliminant.hpp"
#include "phrame/ph/curve/close_crossings.hpp"
#include "phrame/ph/curve/plane_ball.hpp"
#include "phrame/ph/offset/coincidence.hpp"

namespace phrame::inline v0 {

/// A resultant, and what tells its multiple roots.
struct PairEliminant {
  Polynomial whole;
  Polynomial squarefree;
  Polynomial repeated;  ///< gcd of the whole and its derivative

  explicit PairEliminant(Polynomial p)
      : whole(std::move(p)),
        squarefree(squarefree_part(whole)),
        repeated(gcd(whole, differentiate(whole))) {}

  bool is_multiple(const Interval& root) const { return count_real_roots(repeated, root) > 0; }
};

namespace {

constexpr long most_bits_of_one = 20'000'000;
constexpr long first_cell_bits = 128;
constexpr long most_cell_bits = 4096;

/// a = quotient·b + rest over ℚ[s]/(p), b ≠ 0.
struct Division {
  Bivariate quotient;
  Bivariate rest;
};
Division divide(const QuotientRing& field, const Bivariate& a, const Bivariate& b) {
  const Polynomial unit = field.divide(Polynomial{1}, b.coefficients().back());
  const std::size_t size = b.coefficients().size();
  std::vector<Polynomial> rest = a.coefficients();
  std::vector<Polynomial> quotient(rest.size() < size ? 0 : rest.size() - size + 1);
  for (std::size_t k = quotient.size(); k-- > 0;) {
    quotient[k] = field.multiply(rest[k + size - 1], unit);
    for (std::size_t j = 0; j < size; ++j)
      rest[k + j] -= field.multiply(quotient[k], b.coefficients()[j]);
  }
  return {Bivariate(quotient), Bivariate(rest)};
}

Bivariate common_of(const QuotientRing& field, Bivariate a, Bivariate b) {
  while (!b.is_zero()) a = std::exchange(b, divide(field, a, b).rest);
  return a;
}

/// All t that solve f = g = 0 with one s, a root of p, as simple roots of a polynomial in t over
/// ℚ[s]/(p); no value where t = ∞ may be one.
std::optional<Bivariate> common_roots(const QuotientRing& field, const Bivariate& f,
                                      const Bivariate& g) {
  const Bivariate a = field.reduce(f);
  const Bivariate b = field.reduce(g);
  if (a.degree() < f.degree() && b.degree() < g.degree()) return std::nullopt;
  const Bivariate all = common_of(field, a, b);
  std::vector<Polynomial> slope;
  for (long k = 1; k <= all.degree(); ++k) slope.push_back(Rational(k) * all.coefficient(k));
  return divide(field, all, common_of(field, all, Bivariate(slope))).quotient;
}

/// Has v(s, t) a root t in the interval? Precondition: one at most, a simple one.
bool has_root(const Bivariate& v, const RealAlgebraic& s, const Interval& t) {
  const auto sign_of = [&](const Rational& end) { return sign_at(evaluate_at(v, end), s); };
  return sign_of(*t.lower) != sign_of(*t.upper);
}

}  // namespace

bool passes_through(const RationalCurve& curve, const Interval& t, const RationalCurve& other,
                    const RealAlgebraic& s) {
  if (s.is_rational()) return !through(curve, point(other, *s.rational()), t).empty();
  const QuotientRing field(s.polynomial());
  const auto roots =
      common_roots(field, meeting_gap(other, curve, 0), meeting_gap(other, curve, 1));
  return roots && has_root(*roots, s, t);
}

std::optional<RealAlgebraic> exact_place(const RationalCurve& curve, const RationalCurve& other,
                                         const RealBall& t) {
  const MeetingEquations equations = meeting_equations(curve, other, &curve == &other);
  if (equations.f.is_zero() || equations.g.is_zero() ||
      eliminant_size(equations.f, equations.g) > most_bits_of_one)
    return std::nullopt;
  const Polynomial roots = eliminant(equations.f, equations.g);
  const Interval where = closed_interval(t.lower(), t.upper());
  if (roots.is_zero() || count_real_roots(squarefree_part(roots), where) != 1) return std::nullopt;
  return real_roots(roots, where).front().at;
}

/// Two curves, or one with itself.
class ExactMeetings::Pair {
 public:
  Pair(const RationalCurve& a, const RationalCurve& b)
      : first(a), second(b), equations(meeting_equations(a, b, &a == &b)) {}

  /// Is it one curve with itself? Then s = t is no common point.
  bool is_one_curve() const { return &first == &second; }

  const RationalCurve& first;
  const RationalCurve& second;
  const MeetingEquations equations;

  /// @{ That in s, and that in t; nothing where it is 0 or too long. What it takes is taken of
  /// `bits`.
  const PairEliminant* of_first(long& bits) {
    return made(of_first_, equations.f, equations.g, bits);
  }
  const PairEliminant* of_second(long& bits) {
    return made(of_second_, swapped(equations.f), swapped(equations.g), bits);
  }
  /// @}

 private:
  using Kept = std::optional<std::optional<PairEliminant>>;

  static const PairEliminant* made(Kept& kept, const Bivariate& f, const Bivariate& g, long& bits) {
    if (!kept) {
      kept.emplace();
      if (f.is_zero() || g.is_zero()) return nullptr;
      const long size = eliminant_size(f, g);
      if (size > std::min(most_bits_of_one, bits)) return nullptr;
      bits -= size;
      if (Polynomial found = eliminant(f, g); !found.is_zero()) kept->emplace(std::move(found));
    }
    return *kept ? &**kept : nullptr;
  }

  Kept of_first_;
  Kept of_second_;
};

namespace {

/// A root of both resultants each, in open intervals without a second one: a common point or none.
struct Cell {
  Interval s;
  Interval t;
};

/// The roots in a part, each in an open interval without another one.
std::vector<Interval> roots_in(const Polynomial& squarefree, const CurvePart& part) {
  std::vector<Interval> roots = isolate_real_roots(squarefree, interval_of(part));
  for (Interval& root : roots) {
    if (*root.lower != *root.upper) continue;
    const Rational at = *root.lower;
    Rational width(1, 1024);
    do {
      width = width * width;
      root = open_interval(at - width, at + width);
    } while (count_real_roots(squarefree, root) > 1);
  }
  return roots;
}

/// A transversal crossing, or nothing.
struct InCell {
  bool is_decided = false;
  std::optional<Crossing> crossing = {};
};

InCell simple_in(const Cell& cell, const UndecidedCrossing& place, const CurveSeries& series,
                 const PairEliminant& of_s, const PairEliminant& of_t, long most_bits) {
  const PlanePosition position = plane_position(series);
  const std::size_t first = place.first.segment;
  const std::size_t second = place.second.segment;
  Cell narrow = cell;
  for (long bits = first_cell_bits; bits <= most_bits; bits *= 2) {
    const Rational width = power_of_two(-bits);
    narrow.s = narrowed(of_s.squarefree, narrow.s, width);
    narrow.t = narrowed(of_t.squarefree, narrow.t, width);
    const long working = 4 * bits;
    // Wider, so that Newton's step may be inside of it.
    const auto around = [&](const Interval& x) {
      return hull(*x.lower - width, *x.upper + width, working);
    };
    const RealBall s = around(narrow.s);
    const RealBall t = around(narrow.t);
    const auto p = position(first, s, 2, working);
    const auto q = position(second, t, 2, working);
    for (std::size_t k = 0; k < 2; ++k)
      if (!subtract(p[k].coefficient(0), q[k].coefficient(0), working).contains_zero())
        return {true};
    const PlaneBall v{p[0].coefficient(1), p[1].coefficient(1)};
    const PlaneBall w{q[0].coefficient(1), q[1].coefficient(1)};
    const int sign = phrame::sign(cross(v, w, working));
    if (sign == 0) continue;
    const NewtonStep step = newton(position, first, s, position, second, t, working);
    if (!step.first.is_finite() || !step.second.is_finite()) continue;
    const auto is_outside = [](const RealBall& x, const Interval& y) {
      return x.upper() < *y.lower || x.lower() > *y.upper;
    };
    if (is_outside(step.first, narrow.s) || is_outside(step.second, narrow.t)) return {true};
    const auto is_inside = [](const RealBall& x, const RealBall& ball, const Interval& y) {
      return x.lower() > ball.lower() && x.upper() < ball.upper() && x.lower() > *y.lower &&
             x.upper() < *y.upper;
    };
    if (is_inside(step.first, s, cell.s) && is_inside(step.second, t, cell.t))
      return {true, Crossing{first, step.first, second, step.second, sign}};
  }
  return {};
}

/// The directions' product H(s) × H(t), a polynomial in t over ℚ[s].
Bivariate cross_of_directions(const RationalCurve& a, const RationalCurve& b) {
  const auto& h = a.direction();
  const auto& k = b.direction();
  std::vector<Polynomial> rows;
  for (long j = 0; j <= std::max(k[0].degree(), k[1].degree()); ++j)
    rows.push_back(k[1].coefficient(j) * h[0] - k[0].coefficient(j) * h[1]);
  return Bivariate(rows);
}

/// The same root, in a part of the open interval.
Interval shorter(const Polynomial& p, const Interval& root) {
  const Rational width = (*root.upper - *root.lower) / 4;
  const Interval found = narrowed(p, root, width);
  if (*found.lower < *found.upper) return found;
  return open_interval(*found.lower - width / 2, *found.lower + width / 2);
}

/// A curve through a common point.
struct BranchAt {
  const RationalCurve& curve;
  const Polynomial& roots;  ///< of which the parameter is one
  Interval t;               ///< open, without another one
  RealAlgebraic at;
};

/// One half of a branch, from the common point on.
struct HalfBranch {
  const BranchAt* branch;
  bool is_upper;  ///< at greater parameters?
  int way;        ///< 1 where v·P grows on it, −1 where it falls
  Rational end;   ///< v·P at its end
};

using PlaneVector = std::array<Rational, 2>;

/// A v with v·H ≠ 0 on both branches, up to their common point.
PlaneVector way_along(const BranchAt& p, const BranchAt& q) {
  const auto rate = [](const PlaneVector& v, const RationalCurve& curve) {
    return v[0] * curve.direction()[0] + v[1] * curve.direction()[1];
  };
  for (long bits = 64;; bits *= 2) {
    const auto unit = [&](const BranchAt& branch) {
      const RealBall t = enclose(branch.at, bits);
      const auto& h = branch.curve.direction();
      const PlaneVector v{evaluate(h[0], t, bits).midpoint(), evaluate(h[1], t, bits).midpoint()};
      const Rational size = abs(v[0]) + abs(v[1]);
      return size == 0 ? v : PlaneVector{v[0] / size, v[1] / size};
    };
    const PlaneVector a = unit(p);
    const PlaneVector b = unit(q);
    const Rational sign = a[0] * b[0] + a[1] * b[1] < 0 ? -1 : 1;
    const PlaneVector v{a[0] + sign * b[0], a[1] + sign * b[1]};
    if (sign_at(rate(v, p.curve), p.at) != 0 && sign_at(rate(v, q.curve), q.at) != 0) return v;
  }
}

/// Where v·P is that level on a half.
struct LevelPoint {
  const RationalCurve* curve;
  RealAlgebraic t;
  bool is_first;  ///< of both branches

  RealBall across(const PlaneVector& v, long bits) const {
    const RealBall at = enclose(t, bits);
    const auto x = curve->numerator();
    return divide(evaluate(v[0] * x[1] - v[1] * x[0], at, bits),
                  evaluate(curve->weight(), at, bits), bits);
  }
};

LevelPoint at_level(const HalfBranch& half, bool is_first, const PlaneVector& v,
                    const Rational& level) {
  const RationalCurve& curve = half.branch->curve;
  const auto x = curve.numerator();
  const auto places = real_roots(v[0] * x[0] + v[1] * x[1] - level * curve.weight(),
                                 closed_interval(*half.branch->t.lower, *half.branch->t.upper));
  return {&curve, (half.is_upper ? places.back() : places.front()).at, is_first};
}

/// Is v × P less at the first one? Precondition: they are two points.
bool is_right_of(const LevelPoint& a, const LevelPoint& b, const PlaneVector& v) {
  for (long bits = 128;; bits *= 2) {
    const int sign = phrame::sign(subtract(b.across(v, bits), a.across(v, bits), bits));
    if (sign != 0) return sign > 0;
  }
}

/// Does each of two branches cross the other one in a common point? The four halves from there on
/// go up or down along v, without turning. Those that go one way are compared at one level, where
/// no two meet, as parameters in both intervals have no other point in common. The branches cross
/// if their halves follow each other in turns around the point. Both halves of one that goes
/// back there along itself are one.
bool cross_each_other(BranchAt p, BranchAt q) {
  const PlaneVector v = way_along(p, q);
  std::array<std::vector<HalfBranch>, 2> halves;  // up, down
  for (BranchAt* branch : {&p, &q}) {
    const RationalCurve& curve = branch->curve;
    Interval& t = branch->t;
    const Polynomial rate = v[0] * curve.direction()[0] + v[1] * curve.direction()[1];
    const long cusps = is_root(curve.multiplier(), branch->at) ? 1 : 0;
    const auto goes_on = [&] {
      const Interval all = closed_interval(*t.lower, *t.upper);
      return count_real_roots(rate * curve.weight(), all) == 0 &&
             count_real_roots(curve.multiplier(), all) == cusps;
    };
    while (!goes_on()) t = shorter(branch->roots, t);
    const auto sign_at_end = [&](const Rational& end) { return curve.multiplier()(end).sign(); };
    if (sign_at_end(*t.lower) != sign_at_end(*t.upper) && goes_back_at(curve, branch->at))
      return false;
    for (const bool is_upper : {false, true}) {
      const Rational& end = is_upper ? *t.upper : *t.lower;
      const Vector<Rational> at = point(curve, end);
      const int sign = rate(end).sign() * sign_at_end(end);
      const int way = is_upper ? sign : -sign;
      halves[way > 0 ? 0 : 1].push_back({branch, is_upper, way, v[0] * at[0] + v[1] * at[1]});
    }
  }
  std::vector<bool> around;  // of the first one?
  for (const std::vector<HalfBranch>& side : halves) {
    if (side.empty()) continue;
    const int way = side.front().way;
    const Rational level =
        std::ranges::min_element(side, {}, [&](const HalfBranch& x) { return way * x.end; })->end;
    std::vector<LevelPoint> points;
    for (const HalfBranch& half : side)
      points.push_back(at_level(half, half.branch == &p, v, level));
    std::ranges::sort(points, [&](const LevelPoint& a, const LevelPoint& b) {
      return is_right_of(a, b, v) == (way > 0);
    });
    for (const LevelPoint& x : points) around.push_back(x.is_first);
  }
  return around[0] != around[1] && around[1] != around[2] && around[2] != around[3];
}

/// Of one curve with itself, the earlier place first.
Crossing in_order(Crossing x) {
  if (x.first_segment == x.second_segment && x.second_t.midpoint() < x.first_t.midpoint()) {
    std::swap(x.first_t, x.second_t);
    x.sign = -x.sign;
  }
  return x;
}

/// Is this root in an open interval that number?
bool is_at(const Interval& root, const Polynomial& p, const Rational& t) {
  return *root.lower < t && t < *root.upper && p(t) == 0;
}

}  // namespace

ExactMeetings::ExactMeetings(const OffsetBranches& curves, const CurveSeries& series)
    : curves_(curves), series_(series) {}
ExactMeetings::~ExactMeetings() = default;

ExactMeetings::Pair& ExactMeetings::pair_of(std::size_t first, std::size_t second) {
  auto& pair = pairs_[{first, second}];
  if (!pair) pair = std::make_unique<Pair>(curves_.curves[first], curves_.curves[second]);
  return *pair;
}

bool ExactMeetings::is_quick(const UndecidedCrossing& place) const {
  constexpr long most = 25;  // half the degree of a resultant, at most
  const auto degree = [&](const CurvePart& part) {
    return phrame::degree(curves_.curves[part.segment]);
  };
  return degree(place.first) * degree(place.second) <= most;
}

std::optional<PartMeetings> ExactMeetings::between(const UndecidedCrossing& place) {
  const std::size_t first = place.first.segment;
  const std::size_t second = place.second.segment;
  Pair& pair = pair_of(first, second);
  std::vector<Bivariate> shared;  // that is 0 where the parts coincide
  for (const Bivariate& factor : pair.equations.shared)
    if (may_vanish(factor, interval_of(place.first), interval_of(place.second)))
      shared.push_back(factor);
  if (!std::ranges::all_of(shared, is_bilinear)) return std::nullopt;
  const auto is_never_zero = [](const Bivariate& v) { return v.is_constant() && !v.is_zero(); };
  if (is_never_zero(pair.equations.f) || is_never_zero(pair.equations.g)) return PartMeetings{};
  const PairEliminant* of_s = pair.of_first(bits_left_);
  if (of_s == nullptr) return std::nullopt;
  const std::vector<Interval> in_s = roots_in(of_s->squarefree, place.first);
  if (in_s.empty()) return PartMeetings{};
  const PairEliminant* of_t = pair.of_second(bits_left_);
  if (of_t == nullptr) return std::nullopt;
  const std::vector<Interval> in_t = roots_in(of_t->squarefree, place.second);
  const auto are_ends = [&](std::size_t before, const Interval& end, const PairEliminant& of_end,
                            std::size_t behind, const Interval& start,
                            const PairEliminant& of_start) {
    return goes_on_into(series_, before, behind) && is_at(end, of_end.squarefree, 1) &&
           is_at(start, of_start.squarefree, 0);
  };
  const auto are_one_place = [&](const Interval& s, const Interval& t) {
    if (are_ends(first, s, *of_s, second, t, *of_t) || are_ends(second, t, *of_t, first, s, *of_s))
      return true;
    const Rational lower = std::max(*s.lower, *t.lower);
    const Rational upper = std::min(*s.upper, *t.upper);
    return pair.is_one_curve() && lower < upper &&
           count_real_roots(of_s->squarefree, open_interval(lower, upper)) > 0;
  };
  const auto coincide = [&](const Interval& s, const Interval& t) {
    return std::ranges::any_of(shared, [&](const Bivariate& factor) {
      return has_root(factor, real_root(of_s->squarefree, s), t);
    });
  };
  PartMeetings found;
  for (const Interval& s : in_s)
    for (const Interval& t : in_t) {
      if (are_one_place(s, t) || coincide(s, t)) continue;
      const bool is_multiple = of_s->is_multiple(s) && of_t->is_multiple(t);
      const long most_bits = is_multiple ? 2 * first_cell_bits : most_cell_bits;
      const InCell simple = simple_in({s, t}, place, series_, *of_s, *of_t, most_bits);
      if (simple.crossing) found.crossings.push_back(in_order(*simple.crossing));
      if (simple.is_decided) continue;
      if (!is_multiple) return std::nullopt;
      const RealAlgebraic at = real_root(of_s->repeated, s);
      const QuotientRing field(at.polynomial());
      const auto roots = common_roots(field, pair.equations.f, pair.equations.g);
      if (!roots) return std::nullopt;
      if (!has_root(*roots, at, t)) continue;
      const RealAlgebraic other = real_root(of_t->repeated, t);
      const Bivariate turn = field.reduce(cross_of_directions(pair.first, pair.second));
      if (!is_root(pair.first.multiplier(), at) && !is_root(pair.second.multiplier(), other) &&
          !has_root(common_of(field, *roots, turn), at, t))
        return std::nullopt;
      const bool crosses = cross_each_other({pair.first, of_s->squarefree, s, at},
                                            {pair.second, of_t->squarefree, t, other});
      found.touching.push_back({first, at, second, other, crosses});
    }
  return found;
}

}  // namespace phrame
