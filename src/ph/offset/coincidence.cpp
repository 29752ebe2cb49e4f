// Curves that coincide in a part are one algebraic curve, so that any point of one is on the other,
// if not always for a t in [0, 1]; and an end of one is on the other one. Modulo a prime
// polynomials with a common divisor have one of the same degree, where it does not divide a leading
// coefficient.
#include "phrame/ph/offset/coincidence.hpp"

#include <algorithm>
#include <limits>

#include "phrame/algebra/algebraic_image.hpp"
#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/bivariate_factor.hpp"
#include "phrame/algebra/eliminant.hpp"
#include "phrame/algebra/modular.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

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

/// Does H point the same way at both places, where the curves have one tangent?
bool are_alike(const RationalCurve& a, const Rational& s, const RationalCurve& b,
               const Rational& t) {
  return dot(evaluate(a.direction(), s), evaluate(b.direction(), t)) > 0;
}

/// Where s and t both are in [0, 1].
std::vector<CoincidentParts> parts_along(const Bivariate& factor, std::size_t first,
                                         std::size_t second,
                                         const std::vector<RationalCurve>& curves) {
  std::vector<Rational> cuts{0, 1};
  for (const Rational& t : {Rational(0), Rational(1)})
    if (const auto s = partner(swapped(factor), t); s && *s > 0 && *s < 1) cuts.push_back(*s);
  std::ranges::sort(cuts);
  std::vector<CoincidentParts> parts;
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    const Rational at = (cuts[k] + cuts[k + 1]) / 2;
    const auto middle = partner(factor, at);
    if (cuts[k] == cuts[k + 1] || !middle || *middle <= 0 || *middle >= 1) continue;
    const Rational from = *partner(factor, cuts[k]);
    const Rational to = *partner(factor, cuts[k + 1]);
    // Of one curve the earlier part first, or all of what is gone along there and back.
    const bool is_twin = first == second && cuts[k] + cuts[k + 1] > from + to;
    if (!is_twin)
      parts.push_back({first, cuts[k], cuts[k + 1], second, from, to,
                       are_alike(curves[first], at, curves[second], *middle)});
  }
  return parts;
}

PlaneBox opposite(const PlaneBox& box) {
  return {DoubleInterval{-box[0].upper, -box[0].lower},
          DoubleInterval{-box[1].upper, -box[1].lower}};
}

/// The coordinate by which the points of a straight curve are told apart.
std::size_t axis_of(const RationalCurve& line) { return line.direction()[0](0) == 0 ? 1 : 0; }

/// The t of a leg at which x, or y, is that number between those at its ends.
RealAlgebraic place(const RationalCurve& line, const LineLeg& leg, const RealAlgebraic& x) {
  if (x == leg.start) return leg.from;
  if (x == leg.end) return leg.to;
  // The polynomial of x at X/W, times a power of W.
  const Polynomial numerator = line.numerator()[axis_of(line)];
  const Polynomial& p = x.polynomial();
  Polynomial sum;
  Polynomial power{1};
  for (long k = p.degree(); k >= 0; --k) {
    sum = sum * numerator + p.coefficient(k) * power;
    power *= line.weight();
  }
  const RationalFunction along(numerator, line.weight());
  const std::vector<RealRoot> roots = real_roots(sum, closed_interval(0, 1));
  return std::ranges::find_if(roots,
                              [&](const RealRoot& root) {
                                return root.at > leg.from && root.at < leg.to &&
                                       (x.is_rational() || image(along, root.at) == x);
                              })
      ->at;
}

Interval parameters(const CurveNode& arc) {
  return closed_interval(exact_sum(arc.lower, 0).midpoint(), exact_sum(arc.upper, 0).midpoint());
}

}  // namespace

Bivariate meeting_gap(const RationalCurve& a, const RationalCurve& b, std::size_t k) {
  const Polynomial p = a.numerator()[k];
  const Polynomial q = b.numerator()[k];
  const Polynomial& w = b.weight();
  std::vector<Polynomial> rows;
  for (long j = 0; j <= std::max(q.degree(), w.degree()); ++j)
    rows.push_back(w.coefficient(j) * p - q.coefficient(j) * a.weight());
  return Bivariate(rows);
}

MeetingEquations meeting_equations(const RationalCurve& a, const RationalCurve& b,
                                   bool is_one_curve) {
  MeetingEquations made{meeting_gap(a, b, 0), meeting_gap(a, b, 1), {}};
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

bool is_straight(const RationalCurve& curve) { return binormal(curve)[2].is_zero(); }

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
    if (is_straight(k) ? !turning_[k].reversals.empty() : images[k].may_visit(images[k], 1))
      add(k, k, curves);
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
      if (is_straight(first) && is_straight(second)
              ? !are_apart(all[first], all[second])
              : (may_end_on(first, second) || may_end_on(second, first)) &&
                    images[second].may_visit(images[first], 0))
        add(first, second, curves);
    }
  std::ranges::sort(parts_, {}, [](const CoincidentParts& x) {
    return std::tuple(x.first_segment, x.first_from, x.second_segment, x.second_from);
  });
}

const std::vector<LineLeg>& Coincidences::legs_of(std::size_t line, const RationalCurve& curve) {
  std::vector<LineLeg>& legs = legs_[line];
  if (!legs.empty()) return legs;
  const RationalFunction x(curve.numerator()[axis_of(curve)], curve.weight());
  RealAlgebraic from;
  RealAlgebraic start = image(x, from);
  std::vector<RealAlgebraic> ends = turning_[line].reversals;
  ends.emplace_back(1);
  for (const RealAlgebraic& to : ends) {
    RealAlgebraic end = image(x, to);
    legs.push_back({std::exchange(from, to), to, std::exchange(start, end), end});
  }
  return legs;
}

// Between two legs on one line all points of both ranges of x are common ones.
void Coincidences::add_legs(std::size_t first, const LineLeg& a, std::size_t second,
                            const LineLeg& b, const std::vector<RationalCurve>& curves) {
  const RealAlgebraic lower = std::max(std::min(a.start, a.end), std::min(b.start, b.end));
  const RealAlgebraic upper = std::min(std::max(a.start, a.end), std::max(b.start, b.end));
  if (lower > upper) return;
  RealAlgebraic s = place(curves[first], a, lower);
  RealAlgebraic t = place(curves[second], b, lower);
  if (lower == upper) {
    points_.push_back({first, s, second, t});
    return;
  }
  RealAlgebraic s_to = place(curves[first], a, upper);
  RealAlgebraic t_to = place(curves[second], b, upper);
  if (s > s_to) {
    std::swap(s, s_to);
    std::swap(t, t_to);
  }
  parts_.push_back(
      {first, s, s_to, second, t, t_to, are_alike(curves[first], 0, curves[second], 0)});
}

void Coincidences::add_lines(std::size_t first, std::size_t second,
                             const std::vector<RationalCurve>& curves) {
  const Vector<Rational> h = evaluate(curves[first].direction(), 0);
  const auto is_along = [&](const Vector<Rational>& v) { return h[0] * v[1] == h[1] * v[0]; };
  if (!is_along(evaluate(curves[second].direction(), 0))) return;
  lines_.insert({first, second});
  if (!is_along(point(curves[second], 0) - point(curves[first], 0))) return;
  const std::vector<LineLeg>& a = legs_of(first, curves[first]);
  const std::vector<LineLeg>& b = legs_of(second, curves[second]);
  for (std::size_t j = 0; j < a.size(); ++j)
    for (std::size_t k = first == second ? j + 1 : 0; k < b.size(); ++k)
      add_legs(first, a[j], second, b[k], curves);
}

void Coincidences::add(std::size_t first, std::size_t second,
                       const std::vector<RationalCurve>& curves) {
  if (is_straight(first) && is_straight(second)) return add_lines(first, second, curves);
  for (Bivariate& factor :
       meeting_equations(curves[first], curves[second], first == second).shared) {
    if (!is_bilinear(factor)) continue;
    for (CoincidentParts& x : parts_along(factor, first, second, curves))
      parts_.push_back(std::move(x));
    factors_[{first, second}].push_back(std::move(factor));
  }
}

bool Coincidences::is_straight(std::size_t k) const { return turning_[k].first_turn == 0; }

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
