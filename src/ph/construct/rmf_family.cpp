#include "phrame/ph/construct/rmf_family.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/in_place.hpp"
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

Integer scalar_product(const IntegerQuaternion& a, const IntegerQuaternion& b) {
  Integer sum = a.u * b.u;
  add_product(sum, a.v, b.v);
  add_product(sum, a.p, b.p);
  add_product(sum, a.q, b.q);
  return sum;
}

/// a − c·b.
void subtract_product(IntegerQuaternion& a, const Integer& c, const IntegerQuaternion& b) {
  subtract_product(a.u, c, b.u);
  subtract_product(a.v, c, b.v);
  subtract_product(a.p, c, b.p);
  subtract_product(a.q, c, b.q);
}

/// Of the lattice with this basis the sublattice of ω(A, X) = 0: by Euclid's algorithm.
std::vector<IntegerQuaternion> sublattice(std::vector<IntegerQuaternion> basis,
                                          const IntegerQuaternion& a) {
  const IntegerQuaternion row{-a.v, a.u, a.q, -a.p};
  std::vector<std::pair<Integer, IntegerQuaternion>> list;
  list.reserve(basis.size());
  for (IntegerQuaternion& e : basis) list.emplace_back(scalar_product(row, e), std::move(e));
  for (;;) {
    // The least one that is not 0 to the end; the others become remainders by it.
    std::ranges::sort(list,
                      [](const auto& x, const auto& y) { return is_longer(x.first, y.first); });
    const auto zero = std::ranges::find_if(list, [](const auto& x) { return x.first.sign() == 0; });
    const auto count = zero - list.begin();
    if (count <= 1) break;
    const auto& least = list[static_cast<std::size_t>(count - 1)];
    for (auto x = list.begin(); x != zero - 1; ++x) {
      const Integer q = nearest_quotient(x->first, least.first);
      subtract_product(x->first, q, least.first);
      subtract_product(x->second, q, least.second);
    }
  }
  std::vector<IntegerQuaternion> result;
  for (auto& [value, e] : list)
    if (value.sign() == 0) result.push_back(std::move(e));
  return result;
}

/// A basis of two shortest vectors, by Lagrange's and Gauss's algorithm.
void shorten(IntegerQuaternion& a, IntegerQuaternion& b) {
  Integer aa = scalar_product(a, a);
  Integer bb = scalar_product(b, b);
  Integer ab = scalar_product(a, b);
  for (;;) {
    if (bb < aa) {
      std::swap(a, b);
      std::swap(aa, bb);
    }
    const Integer q = nearest_quotient(ab, aa);
    if (q.sign() == 0) return;
    subtract_product(b, q, a);
    subtract_product(bb, q, ab);  // (b − qa)² = b² − q(ab) − q(ab − qa²)
    subtract_product(ab, q, aa);
    subtract_product(bb, q, ab);
  }
}

/// The vector ⟂ all b of a c, in the basis 1, j, k.
Vector<Integer> normal_of(const IntegerQuaternion& c) { return {c.v, -c.q, c.p}; }

/// Of 1, j and k.
Vector<Integer> without_i_part(const IntegerQuaternion& b) { return {b.u, b.p, b.q}; }

constexpr long guard_bits = 64;

/// 2ᵏ that brings e to about this size.
long exponent_to_size(const IntegerQuaternion& e, const Rational& squared_size) {
  return (binary_exponent(squared_size) - bit_length(norm(e)) + 1) >> 1;
}

}  // namespace

RmfStart::RmfStart(const RationalQuaternion& start) : a0(start) {
  include_denominators(denominator, a0);
  whole = whole_multiple(a0, denominator);
  lattice = sublattice({{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}, whole);
}

RmfFamily::RmfFamily(const RmfStart& start, const RationalQuaternion& a3) : a0_(start.a0), a3_(a3) {
  Integer d = 1;
  include_denominators(d, a3);
  const IntegerQuaternion end = whole_multiple(a3, d);
  const IntegerQuaternion from_start = conjugate(start.whole);
  const Vector<Integer> n = normal_of(from_start * end);
  const auto p = static_cast<std::size_t>(
      std::ranges::max_element(n, {}, [](const Integer& x) { return abs(x); }) - n.begin());
  if (n[p] == 0) throw DomainError("the tangents at the ends are the same");
  std::vector<IntegerQuaternion> e = sublattice(start.lattice, end);
  shorten(e[0], e[1]);
  const Integer squared_start = norm(start.whole);
  const Rational size = std::max(Rational(squared_start, start.denominator * start.denominator),
                                 Rational(norm(end), d * d));
  const std::array<long, 2> k{exponent_to_size(e[0], size), exponent_to_size(e[1], size)};
  basis_ = {exact(e[0], power_of_two(k[0])), exact(e[1], power_of_two(k[1]))};
  // Of n, |A₀|² and the area the factors are those of A₀ twice, of A₃, and of both E.
  const Integer area =
      cross(without_i_part(from_start * e[0]), without_i_part(from_start * e[1]))[p];
  determinant_ =
      Rational(squared_start * n[p], 3 * start.denominator * d * area) * power_of_two(-k[0] - k[1]);
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
