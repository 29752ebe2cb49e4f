#include "phrame/ph/construct/exact_end.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <random>

#include "phrame/algebra/big_float.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/gaussian_integer.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/construct/preimage_grid.hpp"
#include "phrame/ph/curve/scale.hpp"

// For the halves (A₀, L, M), (M, R, A₂), X = 3A₀ + 4L + 3M and Y = 3M + 4R + 3A₂ the condition is
//   X i X* + Y i Y* = c,
//   c = 240·integral − 15(S(A₀, A₀) + 2S(M, M) + S(A₂, A₂)) + 10(S(A₀, M) + S(M, A₂)).
// For X = α₁ + kβ₁, Y = α₂ + kβ₂ with given α₁, α₂ ∈ ℚ(i), N = |α₁|² + |α₂|², γ = (c_y + ic_z)/2,
// its y and z are ᾱ₁β₁ + ᾱ₂β₂ = γ̄. The solutions are, with any ζ ∈ ℚ(i),
//   β₁ = α₁γ̄/N − ᾱ₂ζ, β₂ = α₂γ̄/N + ᾱ₁ζ, and then |β₁|² + |β₂|² = |γ|²/N + |ζ|²N,
// and its x is N − (|β₁|² + |β₂|²) = c_x, that is |Nζ|² = R = (N − c_x/2)² − |c|²/4. So what is
// needed is that R is a sum of two rational squares; α₁ is moved until it is seen to be. It is so
// if it is at every prime. At 2 it is made sure: of the numerators of α₁, α₂ over a power of 2 one
// is odd, and that power is so high that N exceeds c 2-adically; then R is N² times a number that
// is 1 modulo 4. η = Nζ is free up to a factor of size 1 in ℚ(i), and is turned near to that of the
// curve: α₁β₂ − α₂β₁ = Nζ. All is done in a rotated space, because c along the x-axis would make R
// a product of two rational numbers, each of which had to be such a sum.

namespace phrame::inline v0 {
namespace {

GaussianRational alpha(const RationalQuaternion& a) { return {a.u, a.v}; }
GaussianRational beta(const RationalQuaternion& a) { return {a.q, a.p}; }
RationalQuaternion from_hopf(const GaussianRational& alpha, const GaussianRational& beta) {
  return {alpha.re, alpha.im, beta.im, beta.re};
}

/// The exponent of 2 in the denominator.
long binary_places(const Rational& x) {
  const Integer d = denominator(x);
  return bit_length(gcd(d, Integer(1) << static_cast<unsigned long>(bit_length(d)))) - 1;
}

/// The number 2k/2^places next to x, or (2k + 1)/2^places.
Rational even_near(const Rational& x, long places) { return rounded_to_places(x, places - 1); }
Rational odd_near(const Rational& x, long places) {
  const Rational unit = power_of_two(-places);
  return even_near(x - unit, places) + unit;
}

/// η with |η|² = r·d², an integer, over d; no value where that is not seen to exist. Throws
/// Undecided where that integer is so long that it would take minutes to find one that is prime.
std::optional<GaussianRational> of_norm(const Rational& r, const Integer& d) {
  constexpr long most_bits = 2500;
  const Integer n = numerator(Rational(r * Rational(d) * Rational(d)));
  if (bit_length(n) > most_bits)
    throw Undecided(fmt::format(
        "the exact end: the sum of two squares would have {} bits, and at most {} are tried",
        bit_length(n), most_bits));
  const auto root = easy_norm_root(n);
  if (!root) return std::nullopt;
  return GaussianRational{Rational(root->re, d), Rational(root->im, d)};
}

/// Near x and y, with X i X* + Y i Y* = c; no value where none are found.
std::optional<QuaternionPair> exact_sum(const RationalQuaternion& x, const RationalQuaternion& y,
                                        const Vector<Rational>& c, long bits) {
  constexpr long most_tries = 1500;
  const long places = std::max(
      bits, std::max({binary_places(c[0]), binary_places(c[1]), binary_places(c[2])}) / 2 + 3);
  const GaussianRational start{odd_near(x.u, places), even_near(x.v, places)};
  const GaussianRational a2{even_near(y.u, places), even_near(y.v, places)};
  const GaussianRational gamma_bar{c[1] / 2, -c[2] / 2};
  const GaussianRational wanted = alpha(x) * beta(y) - alpha(y) * beta(x);
  const Integer d_of_c =
      lcm(lcm(Integer(denominator(c[0])), Integer(denominator(c[1]))), Integer(denominator(c[2])));
  std::mt19937_64 engine(1);
  unsigned long range = 2;
  long negative = 0;
  for (long n = 0; n < most_tries; ++n) {
    const auto step = [&] {
      if (n == 0) return Rational(0);
      return 2 * (Rational(engine() % (2 * range + 1)) - Rational(range)) * power_of_two(-places);
    };
    const GaussianRational a1{start.re + step(), start.im + step()};
    if (n % 40 == 39) ++range;
    const Rational size = norm(a1) + norm(a2);
    const Rational r = (size - c[0] / 2) * (size - c[0] / 2) - dot(c, c) / 4;
    if (r < 0) {  // nearly straight: look farther away
      if (++negative % 12 == 0) range *= 2;
      continue;
    }
    const auto eta = of_norm(r, 2 * lcm(d_of_c, Integer(denominator(size))));
    if (!eta) continue;
    const GaussianRational zeta =
        1 / size * (*eta * unit_near(wanted * conjugate(*eta), std::max(bits, 20L)));
    const GaussianRational b1 = 1 / size * (a1 * gamma_bar) - conjugate(a2) * zeta;
    const GaussianRational b2 = 1 / size * (a2 * gamma_bar) + conjugate(a1) * zeta;
    return QuaternionPair{from_hopf(a1, b1), from_hopf(a2, b2)};
  }
  return std::nullopt;
}

/// The same, seen from other sides. From one of them a prime of the denominator of c, which comes
/// from the steps of the parameter, may divide all R, to an odd power or so that it hides the
/// others: where its y² + z² is divided by that prime.
std::optional<QuaternionPair> exact_turned_sum(const QuaternionPair& near,
                                               const Vector<Rational>& c, long bits) {
  const Rational fifth(1, 5);
  for (const RationalQuaternion& five : {RationalQuaternion{2, 1, 2, 4},
                                         {4, 2, 1, 2},
                                         {2, 4, 1, -2},
                                         {1, -2, 4, 2},
                                         {2, -2, -1, 4}}) {
    const RationalQuaternion u = fifth * five;  // of size 1
    const RationalQuaternion u_back = conjugate(u);
    const RationalQuaternion turned_c = u * RationalQuaternion{0, c[0], c[1], c[2]} * u_back;
    const auto found =
        exact_sum(u * near.x, u * near.y, {turned_c.v, turned_c.p, turned_c.q}, bits);
    if (found) return QuaternionPair{u_back * found->x, u_back * found->y};
  }
  return std::nullopt;
}

/// λ with c = λ·d, where there is one; d ≠ 0.
std::optional<Rational> ratio(const Vector<Rational>& c, const Vector<Rational>& d) {
  const Rational lambda = dot(c, d) / dot(d, d);
  if (c != lambda * d) return std::nullopt;
  return lambda;
}

/// a ≠ 0 over a factor of ℚ(i), so that it has short coefficients if its multiples have.
RationalQuaternion short_multiple(const RationalQuaternion& a) {
  Integer d = 1;
  for (const Rational& x : {a.u, a.v, a.p, a.q}) d = lcm(d, Integer(denominator(x)));
  const auto integral = [&](const GaussianRational& z) {
    return GaussianInteger{numerator(Rational(z.re * d)), numerator(Rational(z.im * d))};
  };
  const GaussianInteger factor = gcd(integral(alpha(a)), integral(beta(a)));
  const auto divided = [&](const GaussianRational& z) {
    const GaussianInteger q = *exact_quotient(integral(z), factor);
    return GaussianRational{q.re, q.im};
  };
  return from_hopf(divided(alpha(a)), divided(beta(a)));
}

/// The same where all are on one line: for X = wa, Y = wb with a, b ∈ ℚ(i) and c = λ·w i w* it is
/// |a|² + |b|² = λ. By Lagrange's theorem on four squares there is no obstruction. The odd part of
/// the denominator of λ is one of a, so that it is no factor of what has to be a norm; and a has as
/// many binary places as make λ an integer, or two more: with more than that |a|² alone would say
/// what λ − |a|² is modulo 4, and −|a|² is no norm.
QuaternionPair exact_line_sum(const RationalQuaternion& x, const RationalQuaternion& y,
                              const RationalQuaternion& w, const Rational& lambda, long bits) {
  constexpr long most_tries = 4000;
  const auto over_w = [&](const RationalQuaternion& a) {
    return alpha(1 / norm(w) * (conjugate(w) * a));
  };
  const auto times_w = [&](const GaussianRational& z) {
    return w * RationalQuaternion{z.re, z.im, 0, 0};
  };
  const GaussianRational a_near = over_w(x);
  const GaussianRational b_near = over_w(y);
  const long places = binary_places(lambda);
  const long least_twos = (places + 1) / 2;
  Integer fives = denominator(lambda) >> static_cast<unsigned long>(places);
  for (long k = 0; k < bits; k += 2) fives *= 5;
  std::mt19937_64 engine(1);
  for (long n = 0; n < most_tries; ++n) {
    const Integer grid = fives << static_cast<unsigned long>(least_twos + n % 3);
    const auto near = [&](const Rational& part) {
      return Rational(floor(part * grid) + Integer(engine() % 17) - 8, grid);
    };
    const GaussianRational a{near(a_near.re), near(a_near.im)};
    const auto eta = of_norm(lambda - norm(a), grid);
    if (!eta) continue;
    return {times_w(a), times_w(*eta * unit_near(b_near * conjugate(*eta), std::max(bits, 20L)))};
  }
  throw Undecided("the exact end: no four rational squares were found near the straight segment");
}

/// Is it u + qk? These make the curves in the plane z = 0.
bool is_plane(const RationalQuaternion& a) { return a.v == 0 && a.p == 0; }

/// The same in that plane: w = u + iq has the square x + iy, and w₁² + w₂² = c is
/// (w₁ + iw₂)(w₁ − iw₂) = c. The first factor is near to that of x and y; any is possible but 0.
QuaternionPair exact_plane_sum(const RationalQuaternion& x, const RationalQuaternion& y,
                               const Vector<Rational>& c, long bits) {
  const GaussianRational sum{x.u - y.q, x.q + y.u};
  const GaussianRational difference{x.u + y.q, x.q - y.u};
  const bool takes_sum = norm(sum) >= norm(difference);
  const GaussianRational& factor = takes_sum ? sum : difference;
  const GaussianRational s{rounded_to_places(factor.re, bits), rounded_to_places(factor.im, bits)};
  if (norm(s) == 0) throw Undecided("the exact end: the last segment is too short");
  const GaussianRational other = 1 / norm(s) * (GaussianRational{c[0], c[1]} * conjugate(s));
  const GaussianRational w1 = Rational(1, 2) * (s + other);
  const GaussianRational half = Rational(1, 2) * (s - other);  // ±iw₂
  const GaussianRational w2 = half * GaussianRational{0, takes_sum ? -1 : 1};
  return {{w1.re, 0, 0, w1.im}, {w2.re, 0, 0, w2.im}};
}

}  // namespace

GaussianRational unit_near(const GaussianRational& z, long bits) {
  if (z.re == 0 && z.im == 0) return {1, 0};
  const Rational scale = scale_for_doubles(std::max(abs(z.re), abs(z.im)));
  BigFloat re(scale * z.re, bits + 64);
  BigFloat im(scale * z.im, bits + 64);
  GaussianRational quarters{1, 0};
  while (re < im || re < -im) {  // times −i
    const BigFloat old = re;
    re = im;
    im = -old;
    quarters = quarters * GaussianRational{0, 1};
  }
  const Rational tau = rounded_to_places(im / (re + sqrt(re * re + im * im)), bits);
  const Rational norm = 1 + tau * tau;
  return quarters * GaussianRational{(1 - tau * tau) / norm, 2 * tau / norm};
}

QuaternionPair exact_pair(const QuaternionPair& near, const Vector<Rational>& c, long bits) {
  const auto& [x, y] = near;
  const RationalQuaternion w = norm(x) == 0 ? x : short_multiple(x);
  const auto lambda = norm(x) == 0 ? std::nullopt : ratio(c, rotated_i(w));
  const bool is_in_plane = is_plane(x) && is_plane(y) && c[2] == 0;
  if (lambda && ratio(rotated_i(y), rotated_i(w))) try {
      return exact_line_sum(x, y, w, *lambda, bits);
    } catch (const Undecided&) {
      if (!is_in_plane) throw;
    }
  if (is_in_plane) return exact_plane_sum(x, y, c, bits);
  if (auto found = exact_turned_sum(near, c, bits)) return *std::move(found);
  throw Undecided("the exact end: no sum of two rational squares was found near the curve");
}

std::array<QuadraticPreimage, 2> exact_halves(const QuadraticPreimage& a,
                                              const Vector<Rational>& integral, long bits) {
  const Rational half(1, 2);
  const RationalQuaternion left = half * (a[0] + a[1]);
  const RationalQuaternion right = half * (a[1] + a[2]);
  const RationalQuaternion middle = half * (left + right);
  const Vector<Rational> c =
      Rational(240) * integral - integral_of_ends(a[0], middle) - integral_of_ends(middle, a[2]);
  const RationalQuaternion first_ends = Rational(3) * (a[0] + middle);
  const RationalQuaternion second_ends = Rational(3) * (middle + a[2]);
  const RationalQuaternion x = first_ends + Rational(4) * left;
  const RationalQuaternion y = second_ends + Rational(4) * right;
  const QuaternionPair found = exact_pair({x, y}, c, bits);
  const Rational quarter(1, 4);
  return {QuadraticPreimage{a[0], quarter * (found.x - first_ends), middle},
          QuadraticPreimage{middle, quarter * (found.y - second_ends), a[2]}};
}

// With Z₁, …, Z₆ the middle coefficients of the sixths and Z₀, Z₇ those that A would have before
// and after, the values at the joints are (Z_{i−1} + Z_i)/2, and 60·∫ A i A* of a sixth is
//   3S(Z₋, Z₋) + 27S(Z, Z) + 3S(Z₊, Z₊) + S(Z₋, Z₊) + 13S(Z₋, Z) + 13S(Z, Z₊).
// The sum of these has no term with both Z₂ and Z₅, and 33S(Z₂, Z₂) + 66S(Z₂, L), likewise of Z₅;
// completing the squares leaves X i X* + Y i Y* = c.
std::array<QuadraticPreimage, 6> exact_sixths(const QuadraticPreimage& a,
                                              const Vector<Rational>& integral, long bits) {
  const auto blossom = [&](const Rational& s, const Rational& t) {
    return Rational((1 - s) * (1 - t)) * a[0] + Rational(s * (1 - t) + t * (1 - s)) * a[1] +
           Rational(s * t) * a[2];
  };
  std::array<RationalQuaternion, 8> z;
  for (long i = 0; i < 8; ++i)
    z[static_cast<std::size_t>(i)] = blossom(Rational(i - 1, 6), Rational(i, 6));
  const auto rest = [&](std::size_t k) {
    return Rational(1, 66) * (Rational(26) * (z[k - 1] + z[k + 1]) + z[k - 2] + z[k + 2]);
  };
  const RationalQuaternion rest2 = rest(2);
  const RationalQuaternion rest5 = rest(5);
  const QuaternionPair near{z[2] + rest2, z[5] + rest5};
  z[2] = z[5] = {};
  Vector<Rational> c = Rational(360) * integral;
  for (std::size_t i = 1; i <= 6; ++i)
    c = c - Rational(3) * (rotated_i(z[i - 1]) + rotated_i(z[i + 1])) -
        Rational(27) * rotated_i(z[i]) - symmetric_product(z[i - 1], z[i + 1]) -
        Rational(13) * symmetric_product(z[i], z[i - 1] + z[i + 1]);
  const QuaternionPair found =
      exact_pair(near, Rational(1, 33) * c + rotated_i(rest2) + rotated_i(rest5), bits);
  z[2] = found.x - rest2;
  z[5] = found.y - rest5;
  std::array<QuadraticPreimage, 6> pieces;
  const Rational half(1, 2);
  for (std::size_t i = 1; i <= 6; ++i)
    pieces[i - 1] = {half * (z[i - 1] + z[i]), z[i], half * (z[i] + z[i + 1])};
  return pieces;
}

// With w_ij = C(4, i)·C(4, j)/(9·C(8, i + j)), ∫ A i A* = Σ w_ij S(A_i, A_j); w₂₂ = 2/35.
QuarticSquare complete_square(const QuarticPreimage& a) {
  constexpr std::array<long, 5> row{1, 4, 6, 4, 1};
  constexpr std::array<long, 9> long_row{1, 8, 28, 56, 70, 56, 28, 8, 1};
  const auto weight = [&](std::size_t i, std::size_t j) {
    return Rational(row[i] * row[j], 9 * long_row[i + j]);
  };
  const Rational square = weight(2, 2);
  QuarticSquare result{};
  for (const std::size_t i : {0U, 1U, 3U, 4U}) {
    result.shift = result.shift + Rational(weight(2, i) / square) * a[i];
    for (const std::size_t j : {0U, 1U, 3U, 4U})
      result.rest = result.rest + weight(i, j) * symmetric_product(a[i], a[j]);
  }
  result.rest = result.rest - square * rotated_i(result.shift);
  return result;
}

Vector<Rational> integral(const QuarticPreimage& a) {
  const auto [shift, rest] = complete_square(a);
  return Rational(2, 35) * rotated_i(a[2] + shift) + rest;
}

std::array<QuarticPreimage, 2> exact_halves(const QuarticPreimage& a,
                                            const Vector<Rational>& integral, long bits) {
  QuarticPreimage left;
  QuarticPreimage right = a;
  const Rational half(1, 2);
  for (std::size_t k = 0; k < 5; ++k) {  // de Casteljau
    left[k] = right[0];
    for (std::size_t j = 0; j + k < 4; ++j) right[j] = half * (right[j] + right[j + 1]);
  }
  const auto [left_shift, left_rest] = complete_square(left);
  const auto [right_shift, right_rest] = complete_square(right);
  const Vector<Rational> c = Rational(35, 2) * (Rational(2) * integral - left_rest - right_rest);
  const QuaternionPair found = exact_pair({left[2] + left_shift, right[2] + right_shift}, c, bits);
  left[2] = found.x - left_shift;
  right[2] = found.y - right_shift;
  return {left, right};
}

}  // namespace phrame
