#include "phrame/ph/construct/rmf_family.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/construct/preimage_grid.hpp"

// With A = A₀·(1, b, b′, c) and n of c as in rmf_septic.cpp, V is A₀ times the b without i that are
// ⟂ n, and b × b′ = n/3. For E₁ = A₀e₁, E₂ = A₀e₂ that is det m·(e₁ × e₂) = n/3. The integers in
// the plane of A₀ and A₃, which are those in V's complement by ω, have a basis whose ω is ±ω(E₁,
// E₂), because ω is unimodular: so, where that is not 0, n/(e₁ × e₂) is ± the index of A₀, A₃ in
// them, up to powers of 2. A matrix of determinant δ whose entry m₂₁ is not 0 is
//   m = (δ(1 + ab), δ(a + c + abc); b, 1 + bc),
// with any numbers a, b ≠ 0, c: nothing is divided. Rows and columns are exchanged such that b is
// the greatest entry.

namespace phrame::inline v0 {
namespace {

using IntegerVector4 = std::array<Integer, 4>;

/// An integer multiple of it.
IntegerVector4 integer_multiple(const RationalQuaternion& a) {
  Integer d = 1;
  for (const Rational* x : {&a.u, &a.v, &a.p, &a.q}) d = lcm(d, denominator(*x));
  return {numerator(a.u * d), numerator(a.v * d), numerator(a.p * d), numerator(a.q * d)};
}

Integer scalar_product(const IntegerVector4& a, const IntegerVector4& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

/// a − c·b.
void subtract(IntegerVector4& a, const Integer& c, const IntegerVector4& b) {
  for (std::size_t k = 0; k < 4; ++k) a[k] -= c * b[k];
}

/// x/y to the nearest integer.
Integer nearest_quotient(const Integer& x, const Integer& y) {
  return floor_quotient(2 * x + y, 2 * y);
}

/// Of the lattice with this basis the sublattice of ω(A, X) = 0: by Euclid's algorithm.
std::vector<IntegerVector4> sublattice(std::vector<IntegerVector4> basis, const IntegerVector4& a) {
  const IntegerVector4 row{-a[1], a[0], a[3], -a[2]};
  std::vector<std::pair<Integer, IntegerVector4>> list;
  for (IntegerVector4& e : basis) list.emplace_back(scalar_product(row, e), std::move(e));
  for (;;) {
    // The least one that is not 0 to the end; the others become remainders by it.
    std::ranges::sort(list, [](const auto& x, const auto& y) {
      return x.first != 0 && (y.first == 0 || abs(x.first) > abs(y.first));
    });
    const auto zero = std::ranges::find_if(list, [](const auto& x) { return x.first == 0; });
    const auto count = zero - list.begin();
    if (count <= 1) break;
    const auto& least = list[static_cast<std::size_t>(count - 1)];
    for (auto x = list.begin(); x != zero - 1; ++x) {
      const Integer q = nearest_quotient(x->first, least.first);
      x->first -= q * least.first;
      subtract(x->second, q, least.second);
    }
  }
  std::vector<IntegerVector4> result;
  for (auto& [value, e] : list)
    if (value == 0) result.push_back(std::move(e));
  return result;
}

/// A basis of two shortest vectors, by Lagrange's and Gauss's algorithm.
void shorten(IntegerVector4& a, IntegerVector4& b) {
  Integer aa = scalar_product(a, a);
  Integer bb = scalar_product(b, b);
  for (;;) {
    if (bb < aa) {
      std::swap(a, b);
      std::swap(aa, bb);
    }
    const Integer q = nearest_quotient(scalar_product(a, b), aa);
    if (q == 0) return;
    subtract(b, q, a);
    bb = scalar_product(b, b);
  }
}

/// The vector ⟂ all b of a c, in the basis 1, j, k.
Vector<Rational> normal_of(const RationalQuaternion& c) { return {c.v, -c.q, c.p}; }

/// Of 1, j and k.
Vector<Rational> without_i_part(const RationalQuaternion& b) { return {b.u, b.p, b.q}; }

constexpr long guard_bits = 64;

/// A power of 2 brings e to about the size of a.
RationalQuaternion of_size(const IntegerVector4& e, const Rational& squared_size) {
  const RationalQuaternion x{e[0], e[1], e[2], e[3]};
  const long k = binary_exponent(squared_size) - binary_exponent(norm(x));
  return power_of_two(k >> 1) * x;
}

}  // namespace

RmfFamily::RmfFamily(const RationalQuaternion& a0, const RationalQuaternion& a3)
    : a0_(a0), a3_(a3) {
  const RationalQuaternion from_a0 = conjugate(a0);  // times |A₀|²
  const Vector<Rational> n = normal_of(from_a0 * a3);
  const auto p = static_cast<std::size_t>(
      std::ranges::max_element(n, {}, [](const Rational& x) { return abs(x); }) - n.begin());
  if (n[p] == 0) throw DomainError("the tangents at the ends are the same");
  std::vector<IntegerVector4> all{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
  std::vector<IntegerVector4> e =
      sublattice(sublattice(std::move(all), integer_multiple(a0)), integer_multiple(a3));
  shorten(e[0], e[1]);
  const Rational size = std::max(norm(a0), norm(a3));
  basis_ = {of_size(e[0], size), of_size(e[1], size)};
  const Vector<Rational> area =
      cross(without_i_part(from_a0 * basis_[0]), without_i_part(from_a0 * basis_[1]));
  determinant_ = norm(a0) * n[p] / (3 * area[p]);
}

// The nearest A₁, A₂ in V first, and one of them moved at right angles to the other such that the
// determinant is δ. This does not depend on the basis, so what is next to each other has members
// next to each other, also in different families. Then the numbers are rounded.
namespace {

template <class T>
using Matrix2 = std::array<std::array<T, 2>, 2>;

/// m of the inner coefficients projected to the plane of e1, e2, with a row changed such that
/// det m is the determinant: the row of the smaller coefficient, at a right angle to the other.
Matrix2<BigFloat> projected(const std::array<FloatQuaternion, 2>& inner, const FloatQuaternion& e1,
                            const FloatQuaternion& e2, const BigFloat& determinant) {
  const BigFloat e11 = norm(e1);
  const BigFloat e12 = hermitian_product(e1, e2).re;
  const BigFloat e22 = norm(e2);
  const BigFloat gram = e11 * e22 - e12 * e12;
  Matrix2<BigFloat> m;
  for (std::size_t k = 0; k < 2; ++k) {
    const BigFloat x = hermitian_product(e1, inner[k]).re;
    const BigFloat y = hermitian_product(e2, inner[k]).re;
    m[k] = {(e22 * x - e12 * y) / gram, (e11 * y - e12 * x) / gram};
  }
  const std::size_t kept = BigFloat(16.0) * norm(inner[0]) < norm(inner[1]) ? 1 : 0;
  const std::array<BigFloat, 2> across{-(e12 * m[kept][0] + e22 * m[kept][1]),
                                       e11 * m[kept][0] + e12 * m[kept][1]};
  const BigFloat size = m[kept][0] * across[1] - m[kept][1] * across[0];
  if (size == BigFloat(0.0))
    throw DomainError("the inner coefficients have no part in the plane of the family");
  const BigFloat lacking = determinant - (m[0][0] * m[1][1] - m[0][1] * m[1][0]);
  const BigFloat part = (kept == 0 ? lacking : -lacking) / size;
  for (std::size_t k = 0; k < 2; ++k) m[1 - kept][k] = m[1 - kept][k] + part * across[k];
  return m;
}

/// The place of the greatest entry: its row and its column.
std::pair<std::size_t, std::size_t> greatest_entry(const Matrix2<BigFloat>& m) {
  std::pair<std::size_t, std::size_t> place{1, 0};
  const auto square = [&](std::size_t i, std::size_t j) { return m[i][j] * m[i][j]; };
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j)
      if (square(place.first, place.second) < square(i, j)) place = {i, j};
  return place;
}

/// A matrix next to m with exactly that determinant; a, b and c are multiples of 2^−bits.
Matrix2<Rational> with_determinant(const Rational& determinant, const Matrix2<BigFloat>& m,
                                   long bits, long precision) {
  const auto [r, s] = greatest_entry(m);
  const Rational delta = (r == 1) == (s == 0) ? determinant : Rational(-determinant);
  const auto rounded = [&](const BigFloat& x) { return rounded_to_places(x, bits); };
  const BigFloat one(1.0);
  const Rational b = rounded(m[r][s]);
  if (b == 0) throw DomainError("the inner coefficients are below the rounding");
  const BigFloat divisor(b, precision);
  const Rational c = rounded((m[r][1 - s] - one) / divisor);
  const Rational a = rounded((m[1 - r][s] / BigFloat(delta, precision) - one) / divisor);
  Matrix2<Rational> exact;
  exact[r][s] = b;
  exact[r][1 - s] = 1 + b * c;
  exact[1 - r][s] = delta * (1 + a * b);
  exact[1 - r][1 - s] = delta * (a + c + a * b * c);
  return exact;
}

}  // namespace

CubicPreimage<Rational> RmfFamily::member(const RationalQuaternion& a1,
                                          const RationalQuaternion& a2, long bits) const {
  const long precision = std::max(bits, 0L) + guard_bits;
  const Matrix2<BigFloat> near = projected(
      {big_floats(a1, precision), big_floats(a2, precision)}, big_floats(basis_[0], precision),
      big_floats(basis_[1], precision), BigFloat(determinant_, precision));
  const Matrix2<Rational> m = with_determinant(determinant_, near, bits, precision);
  const auto combination = [&](const std::array<Rational, 2>& row) {
    return row[0] * basis_[0] + row[1] * basis_[1];
  };
  return {a0_, combination(m[0]), combination(m[1]), a3_};
}

}  // namespace phrame
