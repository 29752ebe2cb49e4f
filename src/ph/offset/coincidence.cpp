// Curves that coincide in a part are one algebraic curve, so that any point of one is on the other,
// if not always for a t in [0, 1]; and an end of one is on the other one. Modulo a prime
// polynomials with a common divisor have one of the same degree, where it does not divide a leading
// coefficient.
//
// Let C₀ go through its points once, but for finitely many, and let the curves be C₀(h(s)) and
// C₀(k(t)), as by Lüroth's theorem they are, over ℚ, too. For nearly each s the common points are
// those with h(s) = k(t): so the greatest common divisor of both equations is the numerator of
// h(s) − k(t), and tells h and k but for one fractional linear map of both.
#include "phrame/ph/offset/coincidence.hpp"

#include <algorithm>
#include <numeric>

#include "phrame/algebra/algebraic_image.hpp"
#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/bivariate_factor.hpp"
#include "phrame/algebra/eliminant.hpp"
#include "phrame/algebra/linear_system.hpp"
#include "phrame/algebra/modular.hpp"
#include "phrame/ph/curve/special_points.hpp"
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
    const auto sum = [&](Word a, Word b, Word c) {
      ModularPolynomial p(prime);
      for (const auto& [x, factor] : {std::pair(&x_[0], a), {&x_[1], b}, {&x_[2], c}}) {
        ModularPolynomial term = *x;
        p += term *= factor;
      }
      return p;
    };
    const ModularPolynomial line = sum(31, 57, 1009);
    if (line.degree() == degree()) mark_ = product_of_values(line, sum(1, 0, 777), x_[2]);
  }

  /// Is it seen that both are not along one algebraic curve? Let that be of degree n. A curve of
  /// degree kn along it goes through each of its points k times, t = ∞ and complex t counted: so
  /// ∏ (x + 777) over all t at which it is on a certain line is the k-th power of one number.
  bool is_apart_from(const ModularCurve& other) const {
    if (!mark_ || !other.mark_) return false;
    const long common = std::gcd(degree(), other.degree());
    const Word prime = x_[0].prime();
    return power(*mark_, other.degree() / common, prime) !=
           power(*other.mark_, degree() / common, prime);
  }

  /// For how many t, complex ones, too, a point of the other curve, that at a certain t, is one of
  /// this curve, at most; no value where that is not seen.
  std::optional<long> most_visits(const ModularCurve& other) const {
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
    if (!is_whole(a, 0) && !is_whole(b, 1)) return std::nullopt;
    return common_degree(a, b);
  }

 private:
  long degree() const { return std::ranges::max(degrees_); }

  std::array<ModularPolynomial, 3> x_;
  std::array<long, 3> degrees_{};
  std::optional<Word> mark_;  ///< ∏ (x + 777) over all points on a line
};

/// The first two of these coordinates.
PlaneBox plane_box(const Vector<RealBall>& x) {
  return {doubles_around(x[0]), doubles_around(x[1])};
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
bool are_alike(const RationalCurve& a, const RealAlgebraic& s, const RationalCurve& b,
               const RealAlgebraic& t) {
  for (long bits = 64;; bits *= 2) {
    const auto product = [&](std::size_t k) {
      return multiply(evaluate(a.direction()[k], enclose(s, bits), bits),
                      evaluate(b.direction()[k], enclose(t, bits), bits), bits);
    };
    if (const int found = sign(add(product(0), product(1), bits)); found != 0) return found > 0;
  }
}

/// t − s.
Bivariate diagonal() { return Bivariate({Polynomial{0, -1}, Polynomial{1}}); }

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

/// x of a straight curve, or y, by which its points are told apart.
RationalFunction along_line(const RationalCurve& line) {
  const std::size_t axis = line.direction()[0](0) == 0 ? 1 : 0;
  return {line.numerator()[axis], line.weight()};
}

/// h and k without poles on [0, 1] for which the polynomial is 0 where h(s) = k(t): it is
/// a(s)·d(t) − b(s)·c(t) with h = a/b and k = c/d, as polynomials whose coefficients of t⁰, t¹, …
/// are combinations of two are. No value where it is none, or none of some a/(b + ma) has no poles.
std::optional<std::array<RationalFunction, 2>> common_parameter(const Bivariate& v) {
  const auto& rows = v.coefficients();
  const auto one = std::ranges::find_if(rows, [](const Polynomial& p) { return !p.is_zero(); });
  const auto other = std::find_if(one + 1, rows.end(), [&](const Polynomial& p) {
    return !p.is_zero() && linear_relations({*one, p}).empty();
  });
  if (other == rows.end()) return std::nullopt;
  const auto& [b, a] = std::minmax(*one, *other, [](const Polynomial& p, const Polynomial& q) {
    return p.degree() < q.degree();
  });
  std::vector<Rational> c;
  std::vector<Rational> d;
  for (const Polynomial& row : rows) {  // da − cb
    const auto relations = linear_relations({a, b, row});
    if (relations.size() != 1) return std::nullopt;
    const std::vector<Rational>& x = relations.front();
    d.push_back(-x[0] / x[2]);
    c.push_back(x[1] / x[2]);
  }
  for (const long m : {0, 1, -1, 2, -2, 3, -3, 5, -5, 8, -8}) {
    const auto part = [&](const Polynomial& n, const Polynomial& rest) {
      return RationalFunction(n, rest + Rational(m) * n);
    };
    const auto has_pole = [](const RationalFunction& f) {
      return count_real_roots(f.denominator(), closed_interval(0, 1)) > 0;
    };
    if ((b + Rational(m) * a).is_zero()) continue;
    const std::array<RationalFunction, 2> found{part(a, b), part(Polynomial(c), Polynomial(d))};
    if (std::ranges::none_of(found, has_pole)) return found;
  }
  return std::nullopt;
}

/// The t of a leg at which f is that number between those at its ends.
RealAlgebraic place(const RationalFunction& f, const CurveLeg& leg, const RealAlgebraic& x) {
  if (x == leg.start) return leg.from;
  if (x == leg.end) return leg.to;
  // The polynomial of x at f, times a power of its denominator.
  const Polynomial& p = x.polynomial();
  Polynomial sum;
  Polynomial power{1};
  for (long k = p.degree(); k >= 0; --k) {
    sum = sum * f.numerator() + p.coefficient(k) * power;
    power *= f.denominator();
  }
  const std::vector<RealRoot> roots = real_roots(sum, closed_interval(0, 1));
  return std::ranges::find_if(roots,
                              [&](const RealRoot& root) {
                                return root.at > leg.from && root.at < leg.to &&
                                       (x.is_rational() || image(f, root.at) == x);
                              })
      ->at;
}

CurveCourse course_along(const RationalFunction& f, std::vector<RealAlgebraic> turns) {
  CurveCourse course{f, {}, {}};
  turns.emplace_back(1);
  RealAlgebraic from;
  RealAlgebraic start = image(f, from);
  for (const RealAlgebraic& to : turns) {
    RealAlgebraic end = image(f, to);
    course.legs.push_back({std::exchange(from, to), to, std::exchange(start, end), end});
  }
  return course;
}

/// Where the algebraic curve turns back on a part, its ends included: at cusps, by its parameter.
std::vector<RealAlgebraic> tips_on(const CurveCourse& course, const Interval& part) {
  std::vector<RealAlgebraic> tips;
  for (const CurveTip& tip : course.tips)
    if (tip.t >= *part.lower && tip.t <= *part.upper) tips.push_back(tip.at);
  return tips;
}

/// The least and the greatest value of its parameter on a part.
std::array<RealAlgebraic, 2> range(const CurveCourse& course, const Interval& part) {
  std::vector<RealAlgebraic> values{course.along(*part.lower), course.along(*part.upper)};
  for (const CurveLeg& leg : course.legs)
    if (leg.from > *part.lower && leg.from < *part.upper) values.push_back(leg.start);
  const auto [least, greatest] = std::ranges::minmax_element(values);
  return {*least, *greatest};
}

/// The t at which a curve goes through a point, where there is one, complex ones counted.
std::optional<Rational> only_place(const RationalCurve& curve, const Vector<Rational>& at) {
  const Polynomial common = visits_of(curve, at);
  if (common.degree() != 1) return std::nullopt;
  return -common.coefficient(0) / common.coefficient(1);
}

/// The bilinear factor of P(s) − Q(t), told by three points of P and proved by Q(t(s)) = P(s).
std::optional<Bivariate> bilinear_factor(const RationalCurve& p, const RationalCurve& q) {
  std::array<std::vector<Rational>, 4> values;  // of 1, s, t and st
  for (const Rational& s : {Rational(0), Rational(1), Rational(1, 3)}) {
    const auto t = only_place(q, point(p, s));
    if (!t) return std::nullopt;
    values[0].emplace_back(1);
    values[1].push_back(s);
    values[2].push_back(*t);
    values[3].push_back(s * *t);
  }
  const auto relations = linear_relations(
      {Polynomial(values[0]), Polynomial(values[1]), Polynomial(values[2]), Polynomial(values[3])});
  if (relations.size() != 1) return std::nullopt;
  const std::vector<Rational>& x = relations.front();
  const Polynomial numerator{-x[0], -x[1]};
  const Polynomial denominator{x[2], x[3]};
  if (denominator.is_zero()) return std::nullopt;
  const RationalFunction t(numerator, denominator);
  for (std::size_t k = 0; k < 2; ++k)
    if (compose(RationalFunction(q.numerator()[k], q.weight()), t) !=
        RationalFunction(p.numerator()[k], p.weight()))
      return std::nullopt;
  return Bivariate({-numerator, denominator});
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
    made.f = exact_quotient(made.f, diagonal());
    made.g = exact_quotient(made.g, diagonal());
  }
  const Bivariate common = gcd(made.f, made.g);
  if (common.is_constant()) return made;
  made.f = exact_quotient(made.f, common);
  made.g = exact_quotient(made.g, common);
  for (BivariateFactor& x : factor(common)) made.shared.push_back(std::move(x.base));
  return made;
}

bool is_straight(const RationalCurve& curve) { return binormal(curve)[2].is_zero(); }

// C₀(h(t)) does where h′ = 0, and (h(t) − h(s))/(t − s) is h′ for s = t.
bool goes_back_at(const RationalCurve& curve, const RealAlgebraic& t) {
  if (is_straight(curve)) return true;
  const auto vanishes = [&](const Bivariate& factor) {
    Polynomial along;
    for (long k = factor.degree(); k >= 0; --k)
      along = Polynomial{0, 1} * along + factor.coefficient(k);
    return is_root(along, t);
  };
  return std::ranges::any_of(meeting_equations(curve, curve, true).shared, vanishes);
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
    if (is_straight(k) ? !turning_[k].reversals.empty() : images[k].most_visits(images[k]) != 1)
      add(k, k, curves, false);
  }
  const auto lower = [&](std::size_t k) { return all[k][0].lower; };
  std::ranges::sort(order, {}, lower);
  // What coincides does not both start and end at one joint of two curves. Where both turn back,
  // it may start and end there.
  const auto may_end_on = [&](std::size_t a, std::size_t b) {
    const bool is_before = branches.behind[a] == b;
    const bool is_behind = branches.behind[b] == a;
    return ((is_before || !is_behind) && !are_apart(ends[a][0], all[b])) ||
           ((is_behind || !is_before) && !are_apart(ends[a][1], all[b]));
  };
  const auto may_turn_on = [&](std::size_t a, std::size_t b) {
    return !turning_[a].reversals.empty() && !turning_[b].reversals.empty() &&
           !are_apart(all[a], all[b]);
  };
  for (auto a = order.begin(); a != order.end(); ++a)
    for (auto b = a + 1; b != order.end() && lower(*b) <= all[*a][0].upper; ++b) {
      const auto [first, second] = std::minmax(*a, *b);
      if (is_straight(first) && is_straight(second)) {
        if (!are_apart(all[first], all[second])) add_lines(first, second, curves);
        continue;
      }
      if (!may_turn_on(first, second) && !may_end_on(first, second) && !may_end_on(second, first))
        continue;
      if (images[first].is_apart_from(images[second])) continue;
      const auto visits = images[second].most_visits(images[first]);
      if (visits != 0) add(first, second, curves, visits == 1);
    }
  std::ranges::sort(parts_, {}, [](const CoincidentParts& x) {
    return std::tuple(x.first_segment, x.first_from, x.second_segment, x.second_from);
  });
}

const CurveCourse& Coincidences::course_of_line(std::size_t line, const RationalCurve& curve) {
  const auto found = courses_of_lines_.find(line);
  if (found != courses_of_lines_.end()) return found->second;
  return courses_of_lines_.emplace(line, course_along(along_line(curve), turning_[line].reversals))
      .first->second;
}

// Between two legs on one curve all points of both ranges of its parameter are common ones.
void Coincidences::add_legs(std::size_t first, const CurveCourse& a, std::size_t second,
                            const CurveCourse& b, const std::vector<RationalCurve>& curves) {
  for (std::size_t j = 0; j < a.legs.size(); ++j)
    for (std::size_t k = first == second ? j + 1 : 0; k < b.legs.size(); ++k) {
      const CurveLeg& p = a.legs[j];
      const CurveLeg& q = b.legs[k];
      const RealAlgebraic lower = std::max(std::min(p.start, p.end), std::min(q.start, q.end));
      const RealAlgebraic upper = std::min(std::max(p.start, p.end), std::max(q.start, q.end));
      if (lower > upper) continue;
      RealAlgebraic s = place(a.along, p, lower);
      RealAlgebraic t = place(b.along, q, lower);
      if (lower == upper) {
        points_.push_back({first, s, second, t});
        continue;
      }
      const bool alike = are_alike(curves[first], s, curves[second], t);
      RealAlgebraic s_to = place(a.along, p, upper);
      RealAlgebraic t_to = place(b.along, q, upper);
      if (s > s_to) {
        std::swap(s, s_to);
        std::swap(t, t_to);
      }
      parts_.push_back({first, s, s_to, second, t, t_to, alike});
    }
}

void Coincidences::add_lines(std::size_t first, std::size_t second,
                             const std::vector<RationalCurve>& curves) {
  const Vector<Rational> h = evaluate(curves[first].direction(), 0);
  const auto is_along = [&](const Vector<Rational>& v) { return h[0] * v[1] == h[1] * v[0]; };
  if (!is_along(evaluate(curves[second].direction(), 0))) return;
  lines_.insert({first, second});
  if (!is_along(point(curves[second], 0) - point(curves[first], 0))) return;
  const CurveCourse& a = course_of_line(first, curves[first]);
  add_legs(first, a, second, course_of_line(second, curves[second]), curves);
}

void Coincidences::add(std::size_t first, std::size_t second,
                       const std::vector<RationalCurve>& curves, bool is_visited_once) {
  if (is_straight(first) && is_straight(second)) return add_lines(first, second, curves);
  const auto factor_of_parts =
      is_visited_once ? bilinear_factor(curves[first], curves[second]) : std::nullopt;
  std::vector<Bivariate> shared =
      factor_of_parts ? std::vector{*factor_of_parts}
                      : meeting_equations(curves[first], curves[second], first == second).shared;
  if (!std::ranges::all_of(shared, is_bilinear) && add_courses(first, second, shared, curves))
    return;
  for (Bivariate& factor : shared) {
    if (!is_bilinear(factor)) continue;
    for (CoincidentParts& x : parts_along(factor, first, second, curves))
      parts_.push_back(std::move(x));
    factors_[{first, second}].push_back(std::move(factor));
  }
}

bool Coincidences::add_courses(std::size_t first, std::size_t second,
                               const std::vector<Bivariate>& shared,
                               const std::vector<RationalCurve>& curves) {
  Bivariate all = first == second ? diagonal() : Bivariate({Polynomial{1}});
  for (const Bivariate& factor : shared) all = all * factor;
  const auto parameter = common_parameter(all);
  if (!parameter) return false;
  // Where the algebraic curve turns back and the curve does along it, too, it goes on.
  const auto course = [&](const RationalFunction& f, std::size_t curve) {
    const std::vector<RealAlgebraic> turns = sign_changes(differentiate(f).numerator());
    CurveCourse made = course_along(f, turns);
    std::vector<RealAlgebraic> tips;
    std::ranges::set_symmetric_difference(turns, turning_[curve].reversals,
                                          std::back_inserter(tips));
    for (const RealAlgebraic& t : tips) made.tips.push_back({t, image(f, t)});
    return made;
  };
  const std::array both{course(parameter->front(), first), course(parameter->back(), second)};
  add_legs(first, both[0], second, both[1], curves);
  courses_.emplace(std::pair(first, second), both);
  return true;
}

bool Coincidences::is_straight(std::size_t k) const { return turning_[k].first_turn == 0; }

bool Coincidences::cover(const CurveNode& a, const CurveNode& b) const {
  if (!a.is_arc() || !b.is_arc()) return false;
  if (a.first_segment > b.first_segment) return cover(b, a);
  const std::pair pair(a.first_segment, b.first_segment);
  if (lines_.contains(pair)) return true;
  const auto found = factors_.find(pair);
  const auto courses = courses_.find(pair);
  if (found == factors_.end() && courses == courses_.end()) return false;
  if (!is_one_way(hull_of(a.direction, b.direction)) &&
      !is_one_way(hull_of(a.direction, opposite(b.direction))))
    return false;
  if (courses != courses_.end()) {
    const auto& [p, q] = courses->second;
    const Interval of_a = parameters(a);
    const Interval of_b = parameters(b);
    const auto [from, to] = range(p, of_a);
    const auto [start, end] = range(q, of_b);
    std::vector<RealAlgebraic> tips = tips_on(p, of_a);
    std::ranges::copy(tips_on(q, of_b), std::back_inserter(tips));
    const bool turns_once = std::ranges::all_of(tips, [&](const auto& x) { return x == tips[0]; });
    return from <= end && start <= to &&
           (tips.empty() || (turns_once && a.turn != 0 && b.turn != 0));
  }
  if (a.reversals > 1 || b.reversals > 1) return false;
  if ((has_cusp(a) || has_cusp(b)) && (a.turn == 0 || b.turn == 0)) return false;
  return std::ranges::any_of(found->second, [&](const Bivariate& factor) {
    return may_vanish(factor, parameters(a), parameters(b)) &&
           (a.reversals + b.reversals < 2 || turn_back_at_once(a, b, factor));
  });
}

/// Does an arc turn back, or the curve at an end of it?
bool Coincidences::has_cusp(const CurveNode& arc) const {
  const Interval part = parameters(arc);
  return std::ranges::any_of(turning_[arc.first_segment].reversals, [&](const RealAlgebraic& t) {
    return t >= *part.lower && t <= *part.upper;
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
