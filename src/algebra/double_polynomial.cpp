#include "phrame/algebra/double_polynomial.hpp"

#include <algorithm>
#include <cmath>

// The bounds. Let u = 2^−53, and S_k = Σ_{j≥k} |a_j|, which bounds every |s_k| of Horner's rule up
// to a factor (1 + u)^{2n}. These factors, at most 2^−40 above 1 for n < 64, and the rounding of
// the sums below, which have no negative term, are covered by the factor 1 + 2^−30 at the end.
//
// In doubles, s_k = fl(fl(s_{k+1}·y) + a_k): an error of u·S_{k+1} and one of u·S_k, so that the
// sum of 2u·S_k bounds them all, since |y| ≤ 1.
//
// With compensation, s_{k+1}·y + a_k = s_k + π_k + ρ_k exactly, |π_k| ≤ u·S_{k+1}, |ρ_k| ≤ u·S_k.
// What is summed in doubles is c_k = c_{k+1}·y + (π_k + ρ_k + l_k), l_k the second coefficient.
// With m_k = u·S_{k+1} + u·S_k + |l_k|, M_k = Σ_{j≥k} m_j bounds |c_k|, and each of the four
// operations has an error of at most u·m_k, u·m_k, u·M_k, u·M_k.
//
// Where p(0) = 0 the last step adds nothing to s_1·y, and every error above has a factor y.

namespace phrame::inline v0 {
namespace {

constexpr double u = 0x1p-53;
constexpr double covers_rounding = 1 + 0x1p-30;

/// The sum of two doubles next to the middle of x.
DoubleDouble nearest(const arb_struct* x) {
  flint::Arb rest;
  const double high = arf_get_d(arb_midref(x), ARF_RND_NEAR);
  arf_set_d(arb_midref(rest.get()), high);
  arf_sub(arb_midref(rest.get()), arb_midref(x), arb_midref(rest.get()), ARF_PREC_EXACT,
          ARF_RND_DOWN);
  return {high, arf_get_d(arb_midref(rest.get()), ARF_RND_NEAR)};
}

/// |coefficient of yᵏ|, of the first or the second doubles.
class Sizes {
 public:
  Sizes(const std::vector<double>& coefficients, const DoubleShape& shape, long which)
      : coefficients_(coefficients), shape_(shape), which_(which) {}
  double first(long k) const { return at(shape_.position(k)); }
  double second(long k) const { return at(shape_.position(k) + shape_.width); }

 private:
  double at(long position) const {
    return std::abs(coefficients_[static_cast<std::size_t>(position + which_)]);
  }
  const std::vector<double>& coefficients_;
  const DoubleShape& shape_;
  long which_;
};

}  // namespace

long DoubleShape::position(long k) const {
  const long pairs_before = std::max(0L, paired - 1 - k);
  return width * (degree - k + pairs_before);
}

std::vector<double> round_coefficients(const std::vector<BallPolynomial>& polynomials,
                                       const DoubleShape& shape) {
  std::vector<double> rounded(static_cast<std::size_t>(shape.size()));
  for (long which = 0; which < shape.width; ++which)
    for (long k = 0; k <= shape.degree; ++k) {
      const RealBall c = polynomials[static_cast<std::size_t>(which)].coefficient(k);
      const DoubleDouble pair = nearest(c.raw());
      const long at = shape.position(k) + which;
      rounded[static_cast<std::size_t>(at)] = pair.high;
      if (k < shape.paired) rounded[static_cast<std::size_t>(at + shape.width)] = pair.low;
    }
  return rounded;
}

BallPolynomial exact_polynomial(const std::vector<double>& coefficients, const DoubleShape& shape,
                                long which) {
  std::vector<RealBall> exact(static_cast<std::size_t>(shape.degree + 1));
  for (long k = 0; k <= shape.degree; ++k) {
    arb_struct* c = exact[static_cast<std::size_t>(k)].raw();
    const long at = shape.position(k) + which;
    arb_set_d(c, coefficients[static_cast<std::size_t>(at)]);
    if (k >= shape.paired) continue;
    flint::Arb second;
    arb_set_d(second.get(), coefficients[static_cast<std::size_t>(at + shape.width)]);
    arb_add(c, c, second.get(), ARF_PREC_EXACT);
  }
  return BallPolynomial(exact);
}

template <std::size_t width>
std::array<DoubleDouble, width> evaluate_compensated(const double* coefficients,
                                                     const DoubleShape& shape, double y) {
  return compensated_values<width>(coefficients, shape, std::array{y});
}
template std::array<DoubleDouble, 1> evaluate_compensated<1>(const double*, const DoubleShape&,
                                                             double);
template std::array<DoubleDouble, 4> evaluate_compensated<4>(const double*, const DoubleShape&,
                                                             double);

// Horner's rule for n ≤ 63 coefficients k·a_k, each rounded once: an error of at most (2n + 1)u/(1
// − (2n + 1)u)·Σ k|a_k|, and the second doubles are at most u·|a_k|; together less than 2^−45 of
// that sum.
template <std::size_t width>
std::array<double, width> evaluate_slope(const double* coefficients, const DoubleShape& shape,
                                         double y) {
  return slope_values<width>(coefficients, shape, std::array{y});
}
template std::array<double, 1> evaluate_slope<1>(const double*, const DoubleShape&, double);
template std::array<double, 4> evaluate_slope<4>(const double*, const DoubleShape&, double);

double steepness(const std::vector<double>& coefficients, const DoubleShape& shape) {
  double sum = 0;
  for (long which = 0; which < shape.width; ++which) {
    const Sizes sizes(coefficients, shape, which);
    for (long k = 1; k <= shape.degree; ++k)
      sum +=
          static_cast<double>(k * k) * (sizes.first(k) + (k < shape.paired ? sizes.second(k) : 0));
  }
  return sum * covers_rounding;
}

double rounding_error(const std::vector<double>& coefficients, const DoubleShape& shape,
                      long which) {
  const Sizes sizes(coefficients, shape, which);
  const bool is_plain = shape.paired == 1;
  double error = 0;
  double s = sizes.first(shape.degree);
  for (long k = shape.degree - 1; k >= shape.paired; --k) {
    s += sizes.first(k);
    error += 2 * u * s;
  }
  if (is_plain) {
    const double tail = s + sizes.second(0);
    error += u * s + u * tail;             // y·(…), and second + that
    error += u * (tail + sizes.first(0));  // first + that
  } else {
    double sum = 0;
    for (long k = shape.paired - 1; k >= 0; --k) {
      const double before = s;
      s += sizes.first(k);
      const double m = u * before + u * s + sizes.second(k);
      sum += m;
      error += 2 * u * (m + sum);
    }
  }
  return error * covers_rounding;
}

}  // namespace phrame
