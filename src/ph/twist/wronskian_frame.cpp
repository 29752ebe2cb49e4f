#include "phrame/ph/twist/wronskian_frame.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/scale.hpp"

namespace phrame::inline v0 {
namespace {

constexpr long most_pair_bits = 1L << 12;
/// What is lost between the coefficients of a plane and its best pair, often.
constexpr long pair_guard = 128;

Polynomial wronskian_of(const Polynomial& a, const Polynomial& b) {
  return a * differentiate(b) - differentiate(a) * b;
}

WronskianPlanes planes_of(const Curve& curve, const Polynomial& n) {
  const long degree = preimage_degree(curve);
  if (n.is_zero())
    throw DomainError(
        "there is nothing to turn: h = 0, the Euler-Rodrigues frame is rotation-minimizing");
  if (degree > 2)
    throw DomainError(
        fmt::format("the preimage has degree {}: ab′ − a′b = 2hσ is solved for degrees 1 and 2, "
                    "with 1 and 5 planes (degree 3 has 42)",
                    degree));
  return wronskian_planes(n, 2 * degree);
}

Polynomial value_at(const std::vector<RationalFunction>& coefficients, const Rational& x) {
  std::vector<Rational> list;
  for (const RationalFunction& c : coefficients) list.push_back(c(x));
  return Polynomial(list);
}

Rational largest_coefficient(const Polynomial& p) {
  Rational most;
  for (const Rational& c : p.coefficients()) most = std::max(most, abs(c));
  return most;
}

/// Are the coefficients of p, beside the greatest of them, next to these numbers?
bool is_close(const Polynomial& p, const std::vector<Real>& coefficients, long bits) {
  const Rational allowed = largest_coefficient(p) * power_of_two(-bits);
  for (std::size_t k = 0; k < coefficients.size(); ++k) {
    const long size = allowed == 0 ? 0 : std::max(0L, -binary_exponent(allowed));
    const RealBall off =
        subtract(coefficients[k].enclose(size + bits),
                 RealBall(p.coefficient(static_cast<long>(k)), size + 2 * bits), size + 2 * bits);
    if (!is_at_most(absolute(off), RealBall(allowed, bits))) return false;
  }
  return true;
}

bool has_pole(const WronskianPlane& plane, const Rational& x) {
  const auto is_pole = [&x](const RationalFunction& f) { return f.denominator()(x) == 0; };
  return std::any_of(plane.a.begin(), plane.a.end(), is_pole) ||
         std::any_of(plane.b.begin(), plane.b.end(), is_pole);
}

Polynomial reversed(const Polynomial& p) { return compose(p, Polynomial{1, -1}); }

bool is_even_or_odd(const Polynomial& p) { return reversed(p) == p || reversed(p) == -p; }

/// Has t ↦ 1 − t the same planes and the same J?
bool is_symmetric(const Curve& curve, const Polynomial& n, FrameWeight weight) {
  const QuaternionPolynomial& preimage = curve.preimage();
  if (!is_even_or_odd(n) || !is_even_or_odd(sigma(preimage))) return false;
  if (weight == FrameWeight::one) return true;
  if (!is_even_or_odd(curve.multiplier())) return false;
  return weight == FrameWeight::speed ||
         (is_even_or_odd(rho(preimage)) && is_even_or_odd(triple_product(curve)));
}

/// a₂ of the plane with t ↦ 1 − t: (a″b′ − a′b″)/(2(ab′ − a′b)) at the origin, of any basis.
RealBall reversed_second(const WronskianPlane& plane, const Rational& origin, long bits) {
  const PlaneBasis basis = enclose(plane, origin, bits);
  const RealBall there(1 - origin, bits);
  const auto derivatives = [&](const BallPolynomial& p) {
    const BallPolynomial taylor = shifted(p, there, bits);  // odd ones change their sign
    return std::array{taylor.coefficient(0),
                      multiply(RealBall(-1, bits), taylor.coefficient(1), bits),
                      taylor.coefficient(2)};
  };
  const auto a = derivatives(basis.a);
  const auto b = derivatives(basis.b);
  const auto minor = [&](std::size_t i, std::size_t j) {
    return subtract(multiply(a[i], b[j], bits), multiply(a[j], b[i], bits), bits);
  };
  return divide(minor(2, 1), minor(0, 1), bits);
}

}  // namespace

WronskianFrame::WronskianFrame(const Curve& curve, FrameWeight weight)
    : curve_(with_primitive_preimage(curve)),
      weight_(weight),
      n_(Rational(2) * twist_numerator(curve_.preimage()) * sigma(curve_.preimage())),
      planes_(planes_of(curve_, n_)),
      tied_(planes_.real.size(), false) {
  compare();
}

std::shared_ptr<const std::vector<PlanePairs>> WronskianFrame::pairs(long bits) const {
  return pairs_.get(bits, [&](const auto*) {
    const Polynomial s = sigma(curve_.preimage());
    const Polynomial wanted = Rational(2) * s * s;
    for (long precision = bits + pair_guard; precision <= std::max(4 * bits, most_pair_bits);
         precision *= 2) {
      const auto moments = weight_moments(curve_, weight_, 4 * planes_.degree + 1, precision);
      std::vector<PlanePairs> found;
      for (const WronskianPlane& plane : planes_.real) {
        const auto pair =
            best_in_plane(enclose(plane, planes_.origin, precision), wanted, moments, precision);
        if (!pair) break;
        found.push_back(*pair);
      }
      if (found.size() == planes_.real.size()) return found;
    }
    throw Undecided("the best pair of polynomials in a plane cannot be told from another one");
  });
}

void WronskianFrame::compare() {
  const std::size_t count = planes_.real.size();
  std::vector<std::size_t> least;
  for (long bits = 64; bits <= 1024; bits *= 2) {
    const auto found = pairs(bits);
    const auto value = [&](std::size_t k) { return (*found)[k].best.value; };
    least.clear();
    for (std::size_t k = 0; k < count; ++k) {
      bool is_beaten = false;
      for (std::size_t j = 0; j < count; ++j) is_beaten |= is_less(value(j), value(k));
      if (!is_beaten) least.push_back(k);
    }
    best_ = least.front();
    if (least.size() == 1) return;
  }
  // Is the one the other from its end? Then there is no difference.
  const auto fail = [] {
    throw Undecided("the best pairs of two planes have the same J, or nearly the same");
  };
  if (least.size() != 2 || !is_symmetric(curve_, n_, weight_)) fail();
  constexpr long bits = 512;
  const RealBall reversed = reversed_second(planes_.real[least[0]], planes_.origin, bits);
  for (std::size_t k = 0; k < count; ++k) {
    const RealBall a2 =
        evaluate(planes_.real[k].a[2], enclose(planes_.real[k].parameter, bits), bits);
    if ((k == least[1]) != a2.overlaps(reversed)) fail();
  }
  tied_[least[1]] = true;
}

std::optional<long> WronskianFrame::critical_points(std::size_t plane) const {
  const auto& all = (*pairs(64))[plane].all;
  if (!all) return std::nullopt;
  return static_cast<long>(all->size());
}

Real WronskianFrame::number(std::size_t plane, RealBall (*part)(const PlanePairs&)) const {
  return Real(
      [frame = *this, plane, part](long bits) { return part((*frame.pairs(bits))[plane]); });
}

Real WronskianFrame::value(std::size_t plane) const {
  return number(plane, [](const PlanePairs& p) { return p.best.value; });
}

Real WronskianFrame::multiplier(std::size_t plane) const {
  return number(plane, [](const PlanePairs& p) { return p.best.multiplier; });
}

std::array<Real, 3> WronskianFrame::form(std::size_t plane) const {
  return {number(plane, [](const PlanePairs& p) { return p.best.form[0]; }),
          number(plane, [](const PlanePairs& p) { return p.best.form[1]; }),
          number(plane, [](const PlanePairs& p) { return p.best.form[2]; })};
}

std::vector<Real> WronskianFrame::coefficients(bool of_a) const {
  std::vector<Real> list;
  for (long k = 0; k <= planes_.degree; ++k) {
    if (k == 0 && common_zero() == Rational(0)) {  // the balls do not know
      list.emplace_back(Rational(0));
      continue;
    }
    list.emplace_back([frame = *this, of_a, k](long bits) {
      const long precision = bits + pair_guard;
      const auto& [x1, x2, x3] = (*frame.pairs(bits))[frame.best_].best.form;
      const auto [a, b] = enclose(frame.planes_.real[frame.best_], frame.planes_.origin, precision);
      const RealBall g = sqrt(x1, precision);
      const RealBall b_part = divide(b.coefficient(k), g, precision);
      if (of_a) return subtract(RealBall(), b_part, precision);
      // g·a₀ + (x₂/g)·b₀
      return add(multiply(g, a.coefficient(k), precision), multiply(x2, b_part, precision),
                 precision);
    });
  }
  return list;
}

std::vector<Real> WronskianFrame::a() const { return coefficients(true); }

std::vector<Real> WronskianFrame::b() const { return coefficients(false); }

RationalPair WronskianFrame::rounded(long bits) const {
  const std::vector<Real> best_a = a();
  const std::vector<Real> best_b = b();
  for (long more = bits;; more *= 2) {
    const RationalPair pair = rounded_by(more);
    const bool is_near = is_close(pair.a, best_a, bits / 2) && is_close(pair.b, best_b, bits / 2) &&
                         abs(pair.defect) <= largest_coefficient(n_) * power_of_two(-bits / 2);
    if (is_near || more > 16 * bits) return pair;  // more, where a₀ and b₀ nearly cancel
  }
}

RationalPair WronskianFrame::rounded_by(long bits) const {
  const WronskianPlane& plane = planes_.real[best_];
  RationalPair pair;
  if (const auto exact = plane.parameter.rational()) {
    pair.parameter = *exact;
  } else {
    long places = bits;
    do {
      pair.parameter = rounded_to_places(enclose(plane.parameter, 2 * places).midpoint(), places);
      places += bits;
    } while (has_pole(plane, pair.parameter));
  }
  const long half = bits / 2 + 16;
  const auto& [x1, x2, x3] = (*pairs(bits))[best_].best.form;
  const auto few = [half](const RealBall& x) {
    const Rational middle = x.midpoint();
    if (middle == 0) return Rational(0);
    return rounded_to_bits(abs(middle), half) * Rational(middle.sign());
  };
  const RealBall root = sqrt(x1, bits + pair_guard);
  pair.g = few(root);
  pair.q = few(divide(x2, root, bits + pair_guard));
  const Polynomial tau{-planes_.origin, 1};
  const Polynomial a0 = compose(value_at(plane.a, pair.parameter), tau);
  const Polynomial b0 = compose(value_at(plane.b, pair.parameter), tau);
  pair.a = Rational(-1 / pair.g) * b0;
  pair.b = pair.g * a0 + pair.q * b0;
  pair.defect = (wronskian_of(pair.a, pair.b) - n_).coefficient(2 * planes_.degree - 2);
  return pair;
}

}  // namespace phrame
