// The roots are guessed in doubles and improved by Newton's steps, of which nothing is proved.
// Then, of n points zᵢ, the discs |z − zᵢ| ≤ n·|d(zᵢ)|/|a·Π(zᵢ − zⱼ)|, a the leading coefficient,
// contain all roots of d, and one that is apart from the others contains one [Smith 1970]. The
// points are those above the real axis and their conjugates, so that no disc that is apart meets
// the axis.
#include "phrame/algebra/near_poles.hpp"

#include <algorithm>

#include "phrame/algebra/near_arithmetic.hpp"
#include "phrame/algebra/near_elementary.hpp"
#include "phrame/algebra/root_guess.hpp"
#include "phrame/algebra/rounding.hpp"

namespace phrame::inline v0 {
namespace {

using Complex = std::complex<double>;
using NearPolynomial = std::vector<NearNumber>;  // ascending

constexpr long most_degree = 63;
constexpr double greatest = 0x1p200;  // of coefficients; products of many stay far from overflow

/// About the binary exponent of the greatest coefficient of d ≠ 0.
long size_exponent(const Polynomial& d) {
  return std::abs(_fmpz_vec_max_bits(d.raw()->coeffs, d.raw()->length)) -
         static_cast<long>(fmpz_bits(d.raw()->den));
}

/// No value where a coefficient is too large for doubles.
std::optional<NearPolynomial> near_polynomial(const Polynomial& p) {
  const auto coefficient = [&](long k) -> NearNumber {
    const fmpz c = p.raw()->coeffs[k];
    const bool is_double = !COEFF_IS_MPZ(c) && std::abs(c) <= (1L << 53);
    if (is_double && fmpz_is_one(p.raw()->den) != 0) return {{static_cast<double>(c)}};
    return near_number(p.coefficient(k));
  };
  NearPolynomial result;
  result.reserve(static_cast<std::size_t>(p.degree() + 1));
  for (long k = 0; k <= p.degree(); ++k) {
    result.push_back(coefficient(k));
    if (!(std::abs(result.back().value.high) < greatest)) return std::nullopt;
  }
  return result;
}

/// For coefficients of degree ≤ 63.
NearPolynomial derivative(const NearPolynomial& p) {
  NearPolynomial result;
  result.reserve(p.size());
  for (std::size_t k = 1; k < p.size(); ++k) {
    const auto factor = static_cast<double>(k);
    const NearNumber& c = p[k];
    const DoubleDouble value = pairs::product(c.value, {factor});
    result.push_back(
        {value,
         (factor * c.error + pairs::rounding * std::abs(value.high)) * pairs::up + pairs::least});
  }
  return result;
}

NearComplex as_complex(const NearNumber& x) { return {x.value, {}, x.error}; }

NearComplex evaluate(const NearPolynomial& p, const NearComplex& z) {
  if (p.empty()) return {};
  NearComplex value = as_complex(p.back());
  for (std::size_t k = p.size() - 1; k-- > 0;) value = value * z + as_complex(p[k]);
  return value;
}

Complex approximate(const NearComplex& z) { return {z.re.high, z.im.high}; }

/// p′(z), of p′, in doubles.
Complex slope(const NearPolynomial& derivative, Complex z) {
  Complex value = 0;
  for (std::size_t k = derivative.size(); k-- > 0;)
    value = {value.real() * z.real() - value.imag() * z.imag() + derivative[k].value.high,
             value.real() * z.imag() + value.imag() * z.real()};
  return value;
}

/// Approximations of the roots above the real axis; none where they are not half of all.
std::vector<NearComplex> points_above(const NearPolynomial& d, const NearPolynomial& slope_of_d) {
  std::vector<double> coefficients;
  for (const NearNumber& c : d) coefficients.push_back(c.value.high);
  std::vector<NearComplex> points;
  for (const Complex& z : guess_roots(coefficients))
    if (z.imag() > 0) points.push_back({{z.real()}, {z.imag()}});
  if (2 * points.size() + 1 != d.size()) return {};
  constexpr int most_steps = 3;
  constexpr double enough = 0x1p-42;  // its square is what remains
  for (NearComplex& z : points)
    for (int k = 0; k < most_steps; ++k) {
      const Complex at = approximate(z);
      const Complex step = approximate(evaluate(d, z)) / slope(slope_of_d, at);
      z = z - NearComplex{{step.real()}, {step.imag()}};
      z.error = 0;
      if (std::norm(step) < enough * enough * std::norm(at)) break;
    }
  return points;
}

/// Gives each point the radius of its disc; false where they are not apart.
bool enclose(std::vector<NearComplex>& points, const NearPolynomial& d) {
  const double leading = std::abs(d.back().value.high) * pairs::down - d.back().error * pairs::up;
  std::vector<double> radii;
  for (const NearComplex& z : points) {
    const NearComplex value = evaluate(d, z);
    double radius =
        static_cast<double>(d.size() - 1) * (pairs::size_above(value) + value.error) / leading;
    double nearest = INFINITY;
    const auto divide_by_distance = [&](const NearComplex& other) {
      const double distance = pairs::size_below(z - other);
      radius /= distance;
      nearest = std::min(nearest, distance);
      return distance > 0 && radius > 0x1p-900 && radius < 0x1p900;
    };
    for (const NearComplex& other : points)
      if ((&other != &z && !divide_by_distance(other)) || !divide_by_distance(conjugate(other)))
        return false;
    radius *= pairs::up;
    // So that a square around it is apart from the others, too.
    if (!(16 * radius < nearest)) return false;
    radii.push_back(radius);
  }
  for (std::size_t k = 0; k < points.size(); ++k) points[k].error = radii[k];
  return true;
}

std::optional<std::vector<NearPole>> found(const Polynomial& n, const Polynomial& d) {
  const auto below = near_polynomial(d);
  const auto above = near_polynomial(n);
  if (!below || !above) return std::nullopt;
  const NearPolynomial slope_of_d = derivative(*below);
  std::vector<NearComplex> points = points_above(*below, slope_of_d);
  if (points.empty() || !enclose(points, *below)) return std::nullopt;
  std::vector<NearPole> poles;
  for (const NearComplex& z : points) {
    const NearComplex residue = evaluate(*above, z) * inverse(evaluate(slope_of_d, z));
    const NearComplex over_z = inverse(z);
    if (!std::isfinite(residue.error) || !std::isfinite(over_z.error)) return std::nullopt;
    poles.push_back({z, over_z, residue});
  }
  return poles;
}

}  // namespace

std::optional<std::vector<NearPole>> near_poles(const Polynomial& n, const Polynomial& d) {
  if (d.degree() < 2 || d.degree() > most_degree) return std::nullopt;
  return rounding_to_nearest([&] {
    // n and d times one number have the same poles and residues.
    constexpr long usual = 150;
    const long size = size_exponent(d);
    if (std::abs(size) <= usual) return found(n, d);
    const Rational scale = power_of_two(-size);
    return found(scale * n, scale * d);
  });
}

namespace {

/// Doubles that a number is between.
struct DoubleBounds {
  double least;
  double most;

  DoubleBounds(double middle, double error) {
    const double radius = error * pairs::up + std::abs(middle) * 0x1p-51 + 0x1p-1070;
    least = middle - radius;
    most = middle + radius;
  }
  bool overlaps(const DoubleBounds& other) const {
    return !(most < other.least) && !(other.most < least);
  }
};

}  // namespace

// Two residues are distinct where their real parts are, or the sizes of their imaginary parts; and
// one is from its conjugate where that is not 0.
bool have_distinct_residues(const std::vector<NearPole>& poles) {
  std::vector<std::pair<DoubleBounds, DoubleBounds>> residues;
  for (const NearPole& pole : poles) {
    const NearComplex& residue = pole.residue;
    const DoubleBounds re(residue.re.high, residue.error);
    const DoubleBounds im(std::abs(residue.im.high), residue.error);
    if (!(im.least > 0)) return false;
    if (poles.size() == 1) return true;
    for (const auto& [other_re, other_im] : residues)
      if (re.overlaps(other_re) && im.overlaps(other_im)) return false;
    residues.emplace_back(re, im);
  }
  return true;
}

NearNumber change(const std::vector<NearPole>& poles, const NearNumber& t) {
  if (t.value.high == 0 && t.error == 0) return {};
  const NearComplex minus_t{pairs::negative(t.value), {}, t.error};
  NearNumber sum;
  for (const NearPole& pole : poles) {
    const NearComplex term = pole.residue * log(NearComplex{{1}, {}} + minus_t * pole.inverse);
    sum = sum + NearNumber{{2 * term.re.high, 2 * term.re.low}, 2 * term.error};
  }
  return sum;
}

}  // namespace phrame
