// Curves that coincide in a part are one algebraic curve, so that any point of one is on the other,
// if not always for a t in [0, 1]; and an end of one is on the other one. Modulo a prime
// polynomials with a common divisor have one of the same degree, where it does not divide a leading
// coefficient.
#include "phrame/ph/offset/coincidence.hpp"

#include <algorithm>
#include <limits>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/bivariate_factor.hpp"
#include "phrame/algebra/eliminant.hpp"
#include "phrame/algebra/modular.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

/// One coordinate of P − Q, times both weights.
Bivariate gap(const RationalCurve& a, const RationalCurve& b, std::size_t k) {
  const Polynomial p = a.numerator()[k];
  const Polynomial q = b.numerator()[k];
  const Polynomial& w = b.weight();
  std::vector<Polynomial> rows;
  for (long j = 0; j <= std::max(q.degree(), w.degree()); ++j)
    rows.push_back(w.coefficient(j) * p - q.coefficient(j) * a.weight());
  return Bivariate(rows);
}

/// X, Y and W modulo a prime, but for a common factor.
class ModularCurve {
 public:
  ModularCurve(const RationalCurve& curve, Word prime)
      : x_{ModularPolynomial(prime), ModularPolynomial(prime), ModularPolynomial(prime)} {
    const auto numerator = curve.numerator();
    const Rational unit(lcm(denominator(numerator[0]), denominator(numerator[1])));
    const std::array<Polynomial, 3> all{unit * numerator[0], unit * numerator[1],
                                        unit * curve.weight()};
    for (std::size_t k = 0; k < 3; ++k) {
      x_[k] = ModularPolynomial(prime, integer_numerator(all[k]));
      degrees_[k] = all[k].degree();
    }
  }

  /// May a point of the other curve, that at a certain t, be one of this curve for more than
  /// `least` t, complex ones, too?
  bool may_visit(const ModularCurve& other, long least) const {
    constexpr Word sample = 12345;
    const Word w = evaluate(other.x_[2], sample);
    const auto gap = [&](std::size_t k) {
      ModularPolynomial one = x_[k];
      ModularPolynomial rest = x_[2];
      one *= w;
      rest *= evaluate(other.x_[k], sample);
      one -= rest;
      return one;
    };
    const ModularPolynomial a = gap(0);
    const ModularPolynomial b = gap(1);
    // Is a leading coefficient known to be none that the prime divides?
    const auto is_whole = [&](const ModularPolynomial& p, std::size_t k) {
      return p.degree() == std::max(degrees_[k], degrees_[2]);
    };
    if (!is_whole(a, 0) && !is_whole(b, 1)) return true;
    return common_degree(a, b) > least;
  }

 private:
  std::array<ModularPolynomial, 3> x_;
  std::array<long, 3> degrees_{};
};

/// The first two of these coordinates.
PlaneBox plane_box(const Vector<RealBall>& x) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto interval = [&](std::size_t k) {
    if (!x[k].is_finite()) return DoubleInterval{-infinity, infinity};
    return DoubleInterval{-upper_double(subtract({}, x[k], 64)), upper_double(x[k])};
  };
  return {interval(0), interval(1)};
}

PlaneBox box_at(const RationalCurve& curve, const Rational& t) {
  const Vector<Rational> at = point(curve, t);
  return plane_box({RealBall(at[0], 64), RealBall(at[1], 64), {}});
}

/// The t with factor(s, t) = 0; no value where there is none.
std::optional<Rational> partner(const Bivariate& factor, const Rational& s) {
  const Rational slope = factor.coefficient(1)(s);
  if (slope == 0) return std::nullopt;
  return -factor.coefficient(0)(s) / slope;
}

/// Where s and t both are in [0, 1].
std::vector<CoincidentParts> parts_along(const Bivariate& factor, std::size_t first,
                                         std::size_t second) {
  std::vector<Rational> cuts{0, 1};
  for (const Rational& t : {Rational(0), Rational(1)})
    if (const auto s = partner(swapped(factor), t); s && *s > 0 && *s < 1) cuts.push_back(*s);
  std::ranges::sort(cuts);
  std::vector<CoincidentParts> parts;
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    const auto middle = partner(factor, (cuts[k] + cuts[k + 1]) / 2);
    if (cuts[k] == cuts[k + 1] || !middle || *middle <= 0 || *middle >= 1) continue;
    const Rational from = *partner(factor, cuts[k]);
    const Rational to = *partner(factor, cuts[k + 1]);
    // Of one curve the earlier part first, or all of what is gone along there and back.
    const bool is_twin = first == second && cuts[k] + cuts[k + 1] > from + to;
    if (!is_twin) parts.push_back({first, cuts[k], cuts[k + 1], second, from, to});
  }
  return parts;
}

PlaneBox opposite(const PlaneBox& box) {
  return {DoubleInterval{-box[0].upper, -box[0].lower},
          DoubleInterval{-box[1].upper, -box[1].lower}};
}

Interval parameters(const CurveNode& arc) {
  return closed_interval(exact_sum(arc.lower, 0).midpoint(), exact_sum(arc.upper, 0).midpoint());
}

}  // namespace

MeetingEquations meeting_equations(const RationalCurve& a, const RationalCurve& b,
                                   bool is_one_curve) {
  MeetingEquations made{gap(a, b, 0), gap(a, b, 1), {}};
  if (is_one_curve) {
    const Bivariate diagonal({Polynomial{0, -1}, Polynomial{1}});
    made.f = exact_quotient(made.f, diagonal);
    made.g = exact_quotient(made.g, diagonal);
  }
  const Bivariate common = gcd(made.f, made.g);
  if (common.is_constant()) return made;
  made.f = exact_quotient(made.f, common);
  made.g = exact_quotient(made.g, common);
  for (BivariateFactor& x : factor(common)) made.shared.push_back(std::move(x.base));
  return made;
}

bool is_bilinear(const Bivariate& factor) {
  return factor.degree() == 1 && swapped(factor).degree() == 1;
}

bool may_vanish(const Bivariate& factor, const Interval& s, const Interval& t) {
  if (!is_bilinear(factor)) return true;
  int sign = 0;
  for (const Rational& y : {*t.lower, *t.upper})
    for (const Rational& x : {*s.lower, *s.upper}) {
      const int here = evaluate_at(factor, y)(x).sign();
      if (here == 0 || here == -sign) return true;
      sign = here;
    }
  return false;
}

Coincidences::Coincidences(const OffsetBranches& branches, const CurveSeries& series)
    : turning_(series.turning) {
  const auto& curves = branches.curves;
  const Word prime = Primes().next();
  std::vector<ModularCurve> images;
  std::vector<PlaneBox> all;
  std::vector<std::array<PlaneBox, 2>> ends;
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    images.emplace_back(curves[k], prime);
    all.push_back(plane_box(series.boxes[k]));
    ends.push_back({box_at(curves[k], 0), box_at(curves[k], 1)});
    order.push_back(k);
    if (images[k].may_visit(images[k], 1)) add(k, k, curves);
  }
  const auto lower = [&](std::size_t k) { return all[k][0].lower; };
  std::ranges::sort(order, {}, lower);
  // What coincides does not both start and end at one joint of two curves.
  const auto may_end_on = [&](std::size_t a, std::size_t b) {
    const bool is_before = branches.behind[a] == b;
    const bool is_behind = branches.behind[b] == a;
    return ((is_before || !is_behind) && !are_apart(ends[a][0], all[b])) ||
           ((is_behind || !is_before) && !are_apart(ends[a][1], all[b]));
  };
  for (auto a = order.begin(); a != order.end(); ++a)
    for (auto b = a + 1; b != order.end() && lower(*b) <= all[*a][0].upper; ++b) {
      const auto [first, second] = std::minmax(*a, *b);
      if ((may_end_on(first, second) || may_end_on(second, first)) &&
          images[second].may_visit(images[first], 0))
        add(first, second, curves);
    }
  std::ranges::sort(parts_, {}, [](const CoincidentParts& x) {
    return std::tuple(x.first_segment, x.first_from, x.second_segment);
  });
}

// On one line, both without turning back, they have in common what lies between the ends.
bool Coincidences::add_lines(std::size_t first, std::size_t second,
                             const std::vector<RationalCurve>& curves) {
  for (const std::size_t k : {first, second})
    if (turning_[k].first_turn != 0 || !turning_[k].reversals.empty()) return false;
  const Vector<Rational> h = evaluate(curves[first].direction(), 0);
  const Vector<Rational> gap = point(curves[second], 0) - point(curves[first], 0);
  const auto is_along = [&](const Vector<Rational>& v) { return h[0] * v[1] == h[1] * v[0]; };
  if (!is_along(gap) || !is_along(evaluate(curves[second].direction(), 0))) return false;
  const std::size_t along = h[0] == 0 ? 1 : 0;
  std::vector<Rational> lower;
  std::vector<Rational> upper;
  for (const std::size_t k : {first, second}) {
    const auto [from, to] = std::minmax({point(curves[k], 0)[along], point(curves[k], 1)[along]});
    lower.push_back(from);
    upper.push_back(to);
  }
  const Rational from = std::max(lower[0], lower[1]);
  const Rational to = std::min(upper[0], upper[1]);
  if (from >= to) return false;
  const auto place = [&](std::size_t k, const Rational& x) -> RealAlgebraic {
    for (const long end : {0L, 1L})
      if (x == point(curves[k], end)[along]) return Rational(end);
    return real_roots(curves[k].numerator()[along] - x * curves[k].weight(), closed_interval(0, 1))
        .front()
        .at;
  };
  std::array<RealAlgebraic, 2> s{place(first, from), place(first, to)};
  std::array<RealAlgebraic, 2> t{place(second, from), place(second, to)};
  if (compare(s[0], s[1]) > 0) {
    std::swap(s[0], s[1]);
    std::swap(t[0], t[1]);
  }
  lines_.insert({first, second});
  parts_.push_back({first, s[0], s[1], second, t[0], t[1]});
  return true;
}

void Coincidences::add(std::size_t first, std::size_t second,
                       const std::vector<RationalCurve>& curves) {
  if (first != second && add_lines(first, second, curves)) return;
  for (Bivariate& factor :
       meeting_equations(curves[first], curves[second], first == second).shared) {
    if (!is_bilinear(factor)) continue;
    for (CoincidentParts& x : parts_along(factor, first, second)) parts_.push_back(std::move(x));
    factors_[{first, second}].push_back(std::move(factor));
  }
}

bool Coincidences::cover(const CurveNode& a, const CurveNode& b) const {
  if ((factors_.empty() && lines_.empty()) || !a.is_arc() || !b.is_arc()) return false;
  if (a.first_segment > b.first_segment) return cover(b, a);
  if (lines_.contains({a.first_segment, b.first_segment})) return true;
  const auto found = factors_.find({a.first_segment, b.first_segment});
  if (found == factors_.end() || a.reversals > 1 || b.reversals > 1) return false;
  if (!is_one_way(hull_of(a.direction, b.direction)) &&
      !is_one_way(hull_of(a.direction, opposite(b.direction))))
    return false;
  if (a.reversals + b.reversals > 0 && (a.turn == 0 || b.turn == 0)) return false;
  return std::ranges::any_of(found->second, [&](const Bivariate& factor) {
    return may_vanish(factor, parameters(a), parameters(b)) &&
           (a.reversals + b.reversals < 2 || turn_back_at_once(a, b, factor));
  });
}

/// Of two arcs that hang together and turn back once each: is that in one point?
bool Coincidences::turn_back_at_once(const CurveNode& a, const CurveNode& b,
                                     const Bivariate& factor) const {
  const Interval s = parameters(a);
  const Interval t = parameters(b);
  const auto one = partner(swapped(factor), *t.lower);
  const auto other = partner(swapped(factor), *t.upper);
  if (!one || !other) return false;
  const Rational lower = std::min(*one, *other);
  const Rational upper = std::max(*one, *other);
  const auto is_in = [](const RealAlgebraic& x, const Rational& from, const Rational& to) {
    return compare(x, from) >= 0 && compare(x, to) <= 0;
  };
  return std::ranges::any_of(turning_[a.first_segment].reversals, [&](const RealAlgebraic& x) {
    return is_in(x, *s.lower, *s.upper) && is_in(x, lower, upper);
  });
}

}  // namespace phrame
