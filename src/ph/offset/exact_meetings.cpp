#include "phrame/ph/offset/exact_meetings.hpp"

#include <algorithm>

#include "phrame/algebra/algebraic_image.hpp"
#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/bivariate_factor.hpp"
#include "phrame/algebra/eliminant.hpp"
#include "phrame/ph/curve/close_crossings.hpp"
#include "phrame/ph/curve/plane_ball.hpp"

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

/// The t of all common roots of polynomials in t over ℚ[s]/(p), where it is one, as a polynomial in
/// s; by Euclid's algorithm.
std::optional<Polynomial> common_root(const Bivariate& f, const Bivariate& g, const Polynomial& p) {
  const QuotientRing field(p);
  Bivariate a = field.reduce(f);
  Bivariate b = field.reduce(g);
  // Else t = ∞ may be one.
  if (a.degree() < f.degree() && b.degree() < g.degree()) return std::nullopt;
  if (a.degree() < b.degree()) std::swap(a, b);
  while (!b.is_zero()) {
    const Polynomial unit = field.divide(Polynomial{1}, b.coefficients().back());
    std::vector<Polynomial> monic;
    for (const Polynomial& c : b.coefficients()) monic.push_back(field.multiply(c, unit));
    std::vector<Polynomial> rest = a.coefficients();
    for (std::size_t k = rest.size(); k >= monic.size(); --k) {
      const Polynomial lead = rest[k - 1];
      for (std::size_t j = 0; j < monic.size(); ++j)
        rest[k - monic.size() + j] -= field.multiply(lead, monic[j]);
    }
    a = Bivariate(monic);
    b = Bivariate(rest);
  }
  if (a.degree() != 1) return std::nullopt;
  return field.divide(Rational(-1) * a.coefficient(0), a.coefficient(1));
}

}  // namespace

/// Two curves, or one with itself.
class ExactMeetings::Pair {
 public:
  Pair(const RationalCurve& a, const RationalCurve& b) : f_(gap(a, b, 0)), g_(gap(a, b, 1)) {
    common_ = gcd(f_, g_);
    if (common_.is_zero()) return;
    f_ = exact_quotient(f_, common_);
    g_ = exact_quotient(g_, common_);
  }

  /// Do the curves not coincide in these parts? As curves they do where both polynomials have a
  /// common factor: one with itself where s = t. It is bilinear where each goes through its points
  /// once, and then greatest and least at corners.
  bool are_apart(const Interval& s, const Interval& t) const {
    if (common_.degree() > 1 || swapped(common_).degree() > 1) return false;
    int sign = 0;
    for (const Rational& y : {*t.lower, *t.upper})
      for (const Rational& x : {*s.lower, *s.upper}) {
        const int here = evaluate_at(common_, y)(x).sign();
        if (here == 0 || here == -sign) return false;
        sign = here;
      }
    return true;
  }

  const Bivariate& f() const { return f_; }
  const Bivariate& g() const { return g_; }

  /// @{ That in s, and that in t; nothing where it is 0 or too long. What it takes is taken of
  /// `bits`.
  const PairEliminant* of_first(long& bits) { return made(first_, f_, g_, bits); }
  const PairEliminant* of_second(long& bits) {
    return made(second_, swapped(f_), swapped(g_), bits);
  }
  /// @}

 private:
  using Kept = std::optional<std::optional<PairEliminant>>;

  /// One coordinate of P − Q, times both weights: a polynomial in t over ℚ[s].
  static Bivariate gap(const RationalCurve& a, const RationalCurve& b, std::size_t k) {
    const Polynomial p = a.numerator()[k];
    const Polynomial q = b.numerator()[k];
    const Polynomial& w = b.weight();
    std::vector<Polynomial> rows;
    for (long j = 0; j <= std::max(q.degree(), w.degree()); ++j)
      rows.push_back(w.coefficient(j) * p - q.coefficient(j) * a.weight());
    return Bivariate(rows);
  }

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

  Bivariate f_;
  Bivariate g_;
  Bivariate common_;  ///< a factor that both had
  Kept first_;
  Kept second_;
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

long order_of(const Polynomial& p, const RealAlgebraic& root) {
  long order = 0;
  for (Polynomial rest = p; is_root(rest, root); ++order)
    rest = exact_quotient(rest, root.polynomial());
  return order;
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

std::optional<PartMeetings> ExactMeetings::between(const UndecidedCrossing& place) {
  if (are_joined(series_, place.first, place.second)) return std::nullopt;
  Pair& pair = pair_of(place.first.segment, place.second.segment);
  if (!pair.are_apart(interval_of(place.first), interval_of(place.second))) return std::nullopt;
  const PairEliminant* of_s = pair.of_first(bits_left_);
  if (of_s == nullptr) return std::nullopt;
  const std::vector<Interval> in_s = roots_in(of_s->squarefree, place.first);
  if (in_s.empty()) return PartMeetings{};
  const PairEliminant* of_t = pair.of_second(bits_left_);
  if (of_t == nullptr) return std::nullopt;
  const std::vector<Interval> in_t = roots_in(of_t->squarefree, place.second);
  PartMeetings found;
  for (const Interval& s : in_s)
    for (const Interval& t : in_t) {
      const bool is_multiple = of_s->is_multiple(s) && of_t->is_multiple(t);
      const long most_bits = is_multiple ? 2 * first_cell_bits : most_cell_bits;
      const InCell simple = simple_in({s, t}, place, series_, *of_s, *of_t, most_bits);
      if (simple.crossing) found.crossings.push_back(*simple.crossing);
      if (simple.is_decided) continue;
      if (!is_multiple) return std::nullopt;
      const RealAlgebraic at = real_root(of_s->repeated, s);
      const auto other = common_root(pair.f(), pair.g(), at.polynomial());
      if (!other) return std::nullopt;
      const RealAlgebraic second = image(*other, at);
      if (compare(second, *t.lower) <= 0 || compare(second, *t.upper) >= 0) continue;
      // As there is no other t, its order is the multiplicity of the common point.
      const bool crosses = order_of(of_s->whole, at) % 2 != 0;
      found.touching.push_back({place.first.segment, at, place.second.segment, second, crosses});
    }
  return found;
}

}  // namespace phrame
