#include "phrame/algebra/piecewise_polynomial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "phrame/algebra/error.hpp"

namespace phrame::inline v0 {
namespace {

/// Is no coefficient known worse than to 2^−bits times the greatest?
bool is_accurate(const BallPolynomial& p, long bits) {
  RealBall greatest;
  RealBall radius;
  for (long k = 0; k <= p.degree_bound(); ++k) {
    const RealBall c = p.coefficient(k);
    mag_t lower;
    mag_init(lower);
    arb_get_mag_lower(lower, c.raw());
    mag_max(arb_radref(greatest.raw()), arb_radref(greatest.raw()), lower);
    mag_max(arb_radref(radius.raw()), arb_radref(radius.raw()), arb_radref(c.raw()));
    mag_clear(lower);
  }
  mag_mul_2exp_si(arb_radref(radius.raw()), arb_radref(radius.raw()), bits);
  return mag_cmp(arb_radref(radius.raw()), arb_radref(greatest.raw())) <= 0;
}

}  // namespace

std::optional<PolynomialPiece> empty_piece(double from, double to, double origin) {
  PolynomialPiece piece;
  piece.origin = origin;
  const bool begins_at_zero = from == 0 || to == 0;
  piece.center = begins_at_zero ? 0 : from + (to - from) / 2;
  // Then t − center is exact [Sterbenz, Floating-Point Computation, 1974].
  const double least = std::min(std::abs(from), std::abs(to));
  const double greatest = std::max(std::abs(from), std::abs(to));
  if (!begins_at_zero &&
      !(std::abs(piece.center) <= 2 * least && greatest <= 2 * std::abs(piece.center)))
    return std::nullopt;
  int exponent = 0;
  if (std::frexp(std::max(to - piece.center, piece.center - from), &exponent) == 0.5) --exponent;
  constexpr int greatest_exponent = 900;
  if (std::abs(exponent) > greatest_exponent)
    throw Undecided(fmt::format(
        "piecewise polynomial: [{}, {}] is too small or too large for doubles", from, to));
  piece.scale = std::ldexp(1.0, -exponent);
  return piece;
}

BallPolynomial on_piece(const Polynomial& p, const PolynomialPiece& piece, long bits,
                        bool is_definite) {
  const RealBall center = exact_sum(piece.center, -piece.origin);
  const long exponent = -std::ilogb(piece.scale);
  constexpr long most_bits = 1 << 20;
  for (long precision = bits + 32; precision <= most_bits; precision *= 2) {
    const BallPolynomial q =
        stretched(shifted(BallPolynomial(p, precision), center, precision), exponent);
    if (is_accurate(q, bits) && (!is_definite || q.coefficient(0).accuracy_bits() >= bits))
      return q;
  }
  throw Undecided(fmt::format(
      "piecewise polynomial: {} bits of precision do not tell a polynomial near {} from 0",
      most_bits, piece.center));
}

BallPolynomial per_y(const Polynomial& p, const PolynomialPiece& piece, long bits) {
  BallPolynomial q = on_piece(p, piece, bits);
  arb_poly_scalar_mul_2exp_si(q.raw(), q.raw(), -std::ilogb(piece.scale));
  return q;
}

RealBall variation(const BallPolynomial& p, long bits) {
  RealBall sum;
  for (long k = 1; k <= p.degree_bound(); ++k) sum = add(sum, absolute(p.coefficient(k)), bits);
  return sum;
}

RealBall least(const BallPolynomial& p, long bits) {
  return subtract(absolute(p.coefficient(0)), variation(p, bits), bits);
}

RealBall integral_bound(const BallPolynomial& p, long bits) {
  RealBall bound;
  for (long k = 0; k <= p.degree_bound(); ++k)
    bound = add(bound, divide(absolute(p.coefficient(k)), RealBall(k + 1, bits), bits), bits);
  return bound;
}

PiecewisePolynomial::PiecewisePolynomial(const std::vector<double>& ends, const DoubleShape& shape,
                                         const Make& make)
    : shape_(shape), ends_{ends.front()} {
  const RoundingToNearest mode;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k)
    if (!(std::isfinite(ends[k]) && ends[k] < ends[k + 1] &&
          std::isfinite(ends[k + 1] - ends.front())))
      throw DomainError(
          fmt::format("piecewise polynomial: [{}, {}] is not an interval whose length is a double",
                      ends[k], ends[k + 1]));
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const std::size_t before = pieces_.size();
    std::vector<double> right_ends{ends[k + 1]};
    while (!right_ends.empty()) {
      const double low = ends_.back();
      const double high = right_ends.back();
      const bool has_zero_inside = low < 0 && 0 < high;
      auto piece = has_zero_inside ? std::nullopt : make(low, high);
      if (piece) {
        const auto is_finite = [](double x) { return std::isfinite(x); };
        if (!is_finite(piece->error) || !is_finite(piece->error_per_y) ||
            !std::all_of(piece->coefficients.begin(), piece->coefficients.end(), is_finite))
          throw Undecided(
              fmt::format("piecewise polynomial: next to t = {} it is too large for doubles", low));
        piece->steepness = steepness(piece->coefficients, shape);
        pieces_.push_back(std::move(*piece));
        ends_.push_back(high);
        right_ends.pop_back();
        continue;
      }
      const double middle = has_zero_inside ? 0 : low + (high - low) / 2;
      if (!(low < middle && middle < high))
        throw Undecided(fmt::format(
            "piecewise polynomial: next to t = {} it needs pieces that have no double inside",
            low));
      if (pieces_.size() - before + right_ends.size() >= max_pieces)
        throw Undecided(fmt::format(
            "piecewise polynomial: from t = {} on it needs more than {} pieces", low, max_pieces));
      right_ends.push_back(middle);
    }
  }
  make_cells();
}

// With y + z for the t and z = (low + rest)·scale, of which low·scale is known and |rest·scale| ≤
// r: p(y + z) is p(y) + p′(y)·low·scale, off by at most steepness·(|z|² + r) and what p′ is. The
// pieces are proved on all of |y| ≤ 1. Next to |y| = 1 y + z might be beyond that, and at a joint
// the function another.
template <std::size_t width>
std::optional<NearValues<width>> near_values(const PiecewisePolynomial& polynomials,
                                             const NearNumber& t) {
  const double high = t.value.high;
  if (!(polynomials.from() <= high && high <= polynomials.to())) return std::nullopt;
  const PolynomialPiece& piece = polynomials.at(high);
  const double y = piece.y(high);
  const double z = t.value.low * piece.scale;
  const double r = t.error * piece.scale;
  const double most_z = std::abs(z) + r;
  const bool is_double = t.value.low == 0 && t.error == 0;
  if (!is_double && !(std::abs(y) <= 1 - 0x1p-30 && most_z <= 0x1p-31)) return std::nullopt;
  const double* coefficients = piece.coefficients.data();
  NearValues<width> near{evaluate_compensated<width>(coefficients, polynomials.shape(), y),
                         piece.error + piece.error_per_y * (std::abs(y) + most_z)};
  if (is_double || piece.steepness == 0) return near;
  const auto slopes = evaluate_slope<width>(coefficients, polynomials.shape(), y);
  double size = 0;
  for (std::size_t k = 0; k < width; ++k) {
    size += std::abs(near.values[k].high);
    near.values[k] = two_sum(near.values[k].high, near.values[k].low + slopes[k] * z);
  }
  // The sums of the low parts round, too: by 2^−53 of what is not much above 2^−53·size +
  // |z|·slope.
  near.error += piece.steepness * (most_z * (2 * slope_error + most_z) + r) + size * 0x1p-104 +
                underflow_error * (1 + piece.steepness);
  near.error *= 1 + 0x1p-40;
  return near;
}
template std::optional<NearValues<1>> near_values<1>(const PiecewisePolynomial&, const NearNumber&);
template std::optional<NearValues<4>> near_values<4>(const PiecewisePolynomial&, const NearNumber&);

PiecewisePolynomial PiecewisePolynomial::on_units(std::size_t n, const DoubleShape& shape,
                                                  const Make& make) {
  std::vector<double> ends(n + 1);
  std::iota(ends.begin(), ends.end(), 0.0);
  return {ends, shape, make};
}

void PiecewisePolynomial::fail_outside(double t, const char* what) const {
  throw DomainError(fmt::format("{}: t = {} is outside [{}, {}]", what, t, from(), to()));
}

void PiecewisePolynomial::require_inside(std::span<const double> t, std::size_t results,
                                         const char* what) const {
  if (results != t.size())
    throw DomainError(
        fmt::format("{}: there are {} results for {} values of t", what, results, t.size()));
  // All first, which is done for several at once.
  const double least = from();
  const double greatest = to();
  bool are_inside = true;
  for (const double x : t) are_inside = are_inside & (least <= x) & (x <= greatest);
  if (are_inside) return;
  for (const double x : t) require_inside(x, what);
}

// Every t in cell k lies at or after an end e where the double before e is in a cell before k; and
// before or at the greatest such end of cell k + 1, because t ≥ e implies that the cell of e is k
// at most, and so is that of the double before e. (cell_of does not decrease.)
void PiecewisePolynomial::make_cells() {
  std::size_t cells = 1;
  while (cells < 2 * pieces_.size()) cells *= 2;
  cells_per_unit_ = static_cast<double>(cells) / (to() - from());
  if (!std::isfinite(cells_per_unit_)) cells_per_unit_ = 0;  // one cell, of the shortest interval
  // Enough of them in every rounding mode.
  first_.assign(std::max(cell_of(to()), cells) + 2, 0);
  std::size_t cell = 0;
  for (std::size_t piece = 1; piece < pieces_.size(); ++piece) {
    const double before = std::nextafter(ends_[piece], -std::numeric_limits<double>::infinity());
    for (const std::size_t last = cell_of(before); cell <= last; ++cell)
      first_[cell] = static_cast<std::uint32_t>(piece - 1);
  }
  for (; cell < first_.size(); ++cell)
    first_[cell] = static_cast<std::uint32_t>(pieces_.size() - 1);
}

}  // namespace phrame
