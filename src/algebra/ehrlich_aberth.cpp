#include "phrame/algebra/ehrlich_aberth.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>

namespace phrame::inline v0 {
namespace {

using Complex = std::complex<double>;
using Points = std::vector<ComplexBall>;  ///< of radius 0
using Indices = std::vector<std::size_t>;

constexpr slong first_precision = 128;

void make_exact(ComplexBall& z) { acb_get_mid(z.raw(), z.raw()); }

/// |z| is about 2^exponent; 0 for z = 0.
slong exponent_of(const ComplexBall& z) {
  flint::Mag size;
  acb_get_mag(size.get(), z.raw());
  return mag_is_zero(size.get()) != 0 ? 0 : fmpz_get_si(MAG_EXPREF(size.get()));
}

/// z·2^−exponent; of parts that are larger than 2⁴⁰⁰ only that they are large.
Complex scaled(const ComplexBall& z, slong exponent) {
  const auto part = [exponent](arb_srcptr x) {
    flint::Arf y;
    arf_mul_2exp_si(y.get(), arb_midref(x), -exponent);
    if (arf_cmpabs_2exp_si(y.get(), 400) > 0) return arf_sgn(y.get()) * 0x1p400;
    return arf_get_d(y.get(), ARF_RND_NEAR);
  };
  return {part(acb_realref(z.raw())), part(acb_imagref(z.raw()))};
}

/// Moves zᵢ by −N/(1 − N·Σ 1/(zᵢ − zⱼ)), N = f(zᵢ)/f′(zᵢ): cubic convergence to a simple root,
/// linear convergence of m points to a cluster of m roots. The sum and the factor need no more
/// digits than doubles have. True where nothing remains to be done at this precision: the next
/// error would be far below the distance to the other points, or f(zᵢ) is 0 up to rounding.
bool step(Points& points, std::size_t i, const flint::FmpzPoly& f,
          const flint::FmpzPoly& derivative, slong bits, slong precision) {
  ComplexBall& z = points[i];
  ComplexBall move;
  ComplexBall slope;
  arb_fmpz_poly_evaluate_acb(move.raw(), f.get(), z.raw(), precision);
  if (acb_contains_zero(move.raw()) != 0) return true;
  arb_fmpz_poly_evaluate_acb(slope.raw(), derivative.get(), z.raw(), precision);
  make_exact(move);
  make_exact(slope);
  if (acb_is_zero(slope.raw()) != 0) return true;
  acb_div(move.raw(), move.raw(), slope.raw(), precision);

  const slong unit = exponent_of(move);
  const Complex newton = scaled(move, unit);
  Complex repulsion = 0;
  double nearest = 0x1p800;
  ComplexBall difference;
  for (const ComplexBall& other : points) {
    acb_sub(difference.raw(), z.raw(), other.raw(), 53);
    const Complex d = scaled(difference, unit);
    const double square = std::norm(d);
    if (square == 0) continue;  // itself, or one that it has met: this step parts them
    repulsion += std::conj(d) / square;
    nearest = std::min(nearest, square);
  }
  const Complex factor = 1.0 / (1.0 - newton * repulsion);
  if (!std::isfinite(factor.real()) || !std::isfinite(factor.imag())) return true;
  ComplexBall ball;
  acb_set_d_d(ball.raw(), factor.real(), factor.imag());
  acb_mul(move.raw(), move.raw(), ball.raw(), precision);
  acb_sub(z.raw(), z.raw(), move.raw(), precision);
  make_exact(z);
  return std::norm(newton * factor) < 0x1p-60 * nearest && unit - exponent_of(z) < -bits / 2;
}

/// Moves z by a quarter of this distance, or a little where that is 0: two points on the real axis
/// do not leave it by themselves where the roots are a conjugate pair, and two points on the same
/// root do not leave that. `k` tells the direction.
void shake(ComplexBall& z, flint::Mag distance, std::size_t k) {
  if (mag_is_zero(distance.get()) != 0) {
    acb_get_mag(distance.get(), z.raw());
    mag_mul_2exp_si(distance.get(), distance.get(), -16);
  }
  if (mag_is_zero(distance.get()) != 0) mag_one(distance.get());
  const double angle = static_cast<double>(k) + 0.5;
  ComplexBall move;
  ComplexBall size;
  acb_set_d_d(move.raw(), std::cos(angle) / 4, std::sin(angle) / 4);
  arf_set_mag(arb_midref(acb_realref(size.raw())), distance.get());
  acb_mul(move.raw(), move.raw(), size.raw(), 53);
  acb_add(z.raw(), z.raw(), move.raw(), ARF_PREC_EXACT);
  make_exact(z);
}

struct Disc {
  flint::Mag radius;
  flint::Mag distance;  ///< from its centre to the nearest other, or a little less

  /// So much smaller than its distance to the others, if they are, that a square around it, too,
  /// has one root only, and that its mirror image meets no other disc.
  bool is_isolated() const {
    flint::Mag wide;
    mag_mul_2exp_si(wide.get(), radius.get(), 4);
    return mag_cmp(wide.get(), distance.get()) < 0;
  }
};

/// The discs |z − zᵢ| ≤ n·|f(zᵢ)| / |a·Π(zᵢ − zⱼ)|, a the leading coefficient, contain all roots,
/// and m of them that are apart from the others contain m roots [Smith 1970].
std::vector<Disc> smith_discs(const Points& points, const flint::FmpzPoly& f, slong precision) {
  flint::Mag leading;
  mag_set_fmpz_lower(leading.get(), fmpz_poly_lead(f.get()));
  std::vector<flint::Mag> products(points.size(), leading);
  std::vector<Disc> discs(points.size());
  for (Disc& disc : discs) mag_inf(disc.distance.get());
  ComplexBall difference;
  flint::Mag distance;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      acb_sub(difference.raw(), points[i].raw(), points[j].raw(), MAG_BITS);
      acb_get_mag_lower(distance.get(), difference.raw());
      for (const std::size_t k : {i, j}) {
        mag_mul_lower(products[k].get(), products[k].get(), distance.get());
        mag_min(discs[k].distance.get(), discs[k].distance.get(), distance.get());
      }
    }
  ComplexBall value;
  for (std::size_t i = 0; i < points.size(); ++i) {
    arb_fmpz_poly_evaluate_acb(value.raw(), f.get(), points[i].raw(), precision);
    mag_ptr radius = discs[i].radius.get();
    acb_get_mag(radius, value.raw());
    mag_mul_ui(radius, radius, points.size());
    mag_div(radius, radius, products[i].get());
  }
  return discs;
}

/// A square around an isolated disc. Where it meets the real axis its root is real: the conjugate
/// of the root is in the mirror image of the disc, and so in no other disc.
ComplexBall enclosure(const ComplexBall& centre, const Disc& disc) {
  ComplexBall z = centre;
  acb_add_error_mag(z.raw(), disc.radius.get());
  if (arb_contains_zero(acb_imagref(z.raw())) != 0) arb_zero(acb_imagref(z.raw()));
  return z;
}

/// Where the roots are apart: twice the bits of the separation that Mahler (1964) proves, and
/// rounds enough to get there from a bad start.
slong greatest_precision(const flint::FmpzPoly& f) {
  const slong n = fmpz_poly_degree(f.get());
  const auto log_n = static_cast<slong>(std::log2(static_cast<double>(n))) + 1;
  return 8 * first_precision + 2 * n * (std::abs(fmpz_poly_max_bits(f.get())) + 2 * log_n);
}

}  // namespace

std::vector<ComplexBall> enclose_roots(const flint::FmpzPoly& f, std::vector<ComplexBall> start,
                                       long bits) {
  Points points = std::move(start);
  flint::FmpzPoly derivative;
  fmpz_poly_derivative(derivative.get(), f.get());
  Indices unsettled(points.size());
  std::iota(unsettled.begin(), unsettled.end(), 0);
  const slong last = greatest_precision(f) + 4 * bits;
  for (slong precision = std::max(first_precision, bits); precision <= last; precision *= 2) {
    // A cluster of m roots comes nearer by a factor of about (m − 1)/(m + 1) in a round, and
    // precision/2m bits are to be gained.
    const slong most_rounds = 20 + precision / 4;
    Indices moving = unsettled;
    for (slong round = 0; round < most_rounds && !moving.empty(); ++round)
      std::erase_if(moving,
                    [&](std::size_t i) { return step(points, i, f, derivative, bits, precision); });

    const std::vector<Disc> discs = smith_discs(points, f, precision);
    Points found;
    unsettled.clear();
    for (std::size_t i = 0; i < points.size(); ++i) {
      found.push_back(enclosure(points[i], discs[i]));
      const bool is_isolated = discs[i].is_isolated();
      if (!is_isolated) shake(points[i], discs[i].distance, i);
      if (!is_isolated || acb_rel_accuracy_bits(found.back().raw()) < bits) unsettled.push_back(i);
    }
    if (unsettled.empty()) return found;
  }
  return {};
}

}  // namespace phrame
