#include "phrame/ph/twist/rotation_family.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"

namespace phrame::inline v0 {
namespace {

/// Σ of a term for each parameter; the first is the constant.
using Coefficients = std::vector<ComplexBall>;

/// What a family is made of, at one precision.
struct Ends {
  RealBall cosine;  ///< of Δθ/2
  RealBall sine;    ///< exactly 0 where Δθ ∈ 2πℤ is known
  RealBall first_rate;
  RealBall last_rate;
};

Ends ends_of(const TwistPiece& piece, long bits) {
  const RealBall first = piece.first_rate().enclose(bits);
  const RealBall last = piece.last_rate().enclose(bits);
  if (piece.whole_turns)
    return {RealBall(*piece.whole_turns % 2 == 0 ? 1 : -1, bits), RealBall(), first, last};
  const RealBall half = multiply(piece.turn.enclose(bits), RealBall(Rational(1, 2), bits), bits);
  const auto [cosine, sine] = cos_sin(half, bits);
  return {cosine, sine, first, last};
}

RealBall scaled(const RealBall& x, const Rational& c, long bits) {
  return multiply(RealBall(c, bits), x, bits);
}

Rotation from_bernstein(const Coefficients& w, long bits) {
  std::vector<RealBall> a;
  std::vector<RealBall> b;
  for (const ComplexBall& c : w) {
    a.push_back(c.re());
    b.push_back(c.im());
  }
  return {phrame::from_bernstein(a, bits), phrame::from_bernstein(b, bits)};
}

/// Everything is free but w(0) = 1 and the direction of w(1).
RotationFamily free_family(const Ends& ends, std::size_t degree, long bits) {
  RotationFamily family;
  const RealBall one(1, bits);
  const ComplexBall real(one, {});
  const ComplexBall imaginary({}, one);
  const auto add_term = [&](std::size_t k, const ComplexBall& value, const RealBall& gamma) {
    Coefficients w(degree + 1);
    w[k] = value;
    family.basis.push_back(from_bernstein(w, bits));
    family.end_factor.push_back(gamma);
  };
  add_term(0, real, {});
  for (std::size_t k = 1; k < degree; ++k) {
    add_term(k, real, {});
    add_term(k, imaginary, {});
  }
  add_term(degree, {ends.cosine, ends.sine}, one);
  return family;
}

/// The line 4sx − ρ₁γ = ρ₀c in the plane of x and γ: its point next to the origin, and a unit of
/// length along it.
RotationFamily matched_quadratics(const TwistPiece& piece, const Ends& ends, long bits) {
  const auto& [c, s, first, last] = ends;
  const RealBall one(1, bits);
  const RealBall four_s = scaled(s, 4, bits);
  const RealBall square = add(multiply(four_s, four_s, bits), multiply(last, last, bits), bits);
  RotationFamily family;
  const auto add_term = [&](const RealBall& w0, const ComplexBall& w1, const RealBall& gamma) {
    const ComplexBall w2(multiply(gamma, ends.cosine, bits), multiply(gamma, ends.sine, bits));
    family.basis.push_back(from_bernstein({ComplexBall(w0, {}), w1, w2}, bits));
    family.end_factor.push_back(gamma);
  };
  if (square.contains_zero()) {
    if (!piece.whole_turns || piece.last_rate().exact() != Rational(0))
      throw Undecided(
          "a turn close to whole turns, with a rate close to 0 at the end: no quadratic rotation "
          "can be told to exist");
    if (piece.first_rate().exact() != Rational(0) || *piece.whole_turns != 0)
      throw DomainError("no quadratic rotation has the rates that are wanted at the ends");
    add_term(one, ComplexBall(one, {}), one);  // θ ≡ 0
    return family;
  }
  const RealBall foot = divide(multiply(first, c, bits), square, bits);
  const RealBall length = sqrt(square, bits);
  add_term(one, {multiply(foot, four_s, bits), scaled(first, Rational(1, 4), bits)},
           scaled(multiply(foot, last, bits), -1, bits));
  add_term({}, {divide(last, length, bits), {}}, divide(four_s, length, bits));
  return family;
}

/// w₁ = x + iρ₀/(2n), wₙ₋₁ = e^{iΔθ/2}(y − iγρ₁/(2n)), n ≥ 3; parameters x, the parts of w₂ … wₙ₋₂,
/// y and γ.
RotationFamily matched_family(const Ends& ends, std::size_t degree, long bits) {
  RotationFamily family = free_family(ends, degree, bits);
  const auto& [c, s, first, last] = ends;
  const Rational share(1, static_cast<long>(2 * degree));
  const auto with = [&](std::size_t k, const ComplexBall& value) {
    Coefficients w(degree + 1);
    w[k] = value;
    return from_bernstein(w, bits);
  };
  const auto sum = [bits](const Rotation& v, const Rotation& w) {
    return Rotation{add(v.a, w.a, bits), add(v.b, w.b, bits)};
  };
  const std::size_t n = degree;
  const std::size_t im_of_first = 2;
  const std::size_t re_of_last = 2 * n - 3;
  family.basis.front() =
      sum(family.basis.front(), with(1, ComplexBall({}, scaled(first, share, bits))));
  family.basis[re_of_last] = with(n - 1, {c, s});
  const ComplexBall turned(s, scaled(c, -1, bits));  // −i·e^{iΔθ/2}
  family.basis.back() =
      sum(family.basis.back(), with(n - 1, multiply(scaled(last, share, bits), turned, bits)));
  // The imaginary parts are no parameters any more: that of wₙ₋₁ comes after its real part.
  for (const std::size_t k : {re_of_last + 1, im_of_first}) {
    family.basis.erase(family.basis.begin() + static_cast<std::ptrdiff_t>(k));
    family.end_factor.erase(family.end_factor.begin() + static_cast<std::ptrdiff_t>(k));
  }
  return family;
}

}  // namespace

RotationFamily rotation_family(const TwistPiece& piece, long degree, EndRates rates, long bits) {
  if (degree < 1 || (rates == EndRates::matched && degree < 2))
    throw DomainError(fmt::format("rotation_family: the degree is {}, at least {} is needed",
                                  degree, rates == EndRates::matched ? 2 : 1));
  const Ends ends = ends_of(piece, bits);
  const auto n = static_cast<std::size_t>(degree);
  if (rates == EndRates::free) return free_family(ends, n, bits);
  return n == 2 ? matched_quadratics(piece, ends, bits) : matched_family(ends, n, bits);
}

Rotation member(const RotationFamily& family, const std::vector<RealBall>& parameters, long bits) {
  Rotation w = family.basis.front();
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    w.a = add(w.a, multiply(parameters[k], family.basis[k + 1].a, bits), bits);
    w.b = add(w.b, multiply(parameters[k], family.basis[k + 1].b, bits), bits);
  }
  return w;
}

Rotation member(const RotationFamily& family, const std::vector<Rational>& parameters, long bits) {
  std::vector<RealBall> balls;
  for (const Rational& p : parameters) balls.emplace_back(p, bits);
  return member(family, balls, bits);
}

RealBall end_factor(const RotationFamily& family, const std::vector<Rational>& parameters,
                    long bits) {
  RealBall gamma = family.end_factor.front();
  for (std::size_t k = 0; k < parameters.size(); ++k)
    gamma = add(gamma, scaled(family.end_factor[k + 1], parameters[k], bits), bits);
  return gamma;
}

std::vector<ComplexBall> to_bernstein(const Rotation& w, long n, long bits) {
  const auto a = to_bernstein(w.a, n, bits);
  const auto b = to_bernstein(w.b, n, bits);
  std::vector<ComplexBall> coefficients;
  for (std::size_t k = 0; k < a.size(); ++k) coefficients.emplace_back(a[k], b[k]);
  return coefficients;
}

BallPolynomial norm(const Rotation& w, long bits) {
  return add(multiply(w.a, w.a, bits), multiply(w.b, w.b, bits), bits);
}

BallPolynomial wronskian(const Rotation& w, long bits) {
  return subtract(multiply(w.a, differentiate(w.b, bits), bits),
                  multiply(differentiate(w.a, bits), w.b, bits), bits);
}

std::optional<RealBall> turn(const Rotation& w, const Rational& from, const Rational& to,
                             long bits) {
  const long n = std::max({w.a.degree_bound(), w.b.degree_bound(), 0L});
  const auto between = [&](const BallPolynomial& p) {
    auto c = to_bernstein(p, n, bits);
    if (to != 1) c = split(c, to, bits).first;
    if (from != 0) c = split(c, from / to, bits).second;
    return c;
  };
  // On a part where all Bernstein coefficients are in one open half plane, w is, too, and turns by
  // a principal argument.
  struct Part {
    std::vector<RealBall> a;
    std::vector<RealBall> b;
    int depth;
  };
  std::vector<Part> parts{{between(w.a), between(w.b), 0}};
  RealBall half_turn;
  while (!parts.empty()) {
    const Part part = std::move(parts.back());
    parts.pop_back();
    const auto at = [&part](std::size_t k) { return ComplexBall(part.a[k], part.b[k]); };
    const ComplexBall first = at(0);
    const ComplexBall last = at(part.a.size() - 1);
    const ComplexBall axis = conjugate(add(first, last, bits));
    bool is_in_half_plane = true;
    for (std::size_t k = 0; k < part.a.size() && is_in_half_plane; ++k)
      is_in_half_plane = sign(multiply(at(k), axis, bits).re()) > 0;
    if (is_in_half_plane) {
      half_turn = add(half_turn, argument(multiply(last, conjugate(first), bits), bits), bits);
      continue;
    }
    if (part.depth > 60) return std::nullopt;
    auto [a_left, a_right] = split(part.a, Rational(1, 2), bits);
    auto [b_left, b_right] = split(part.b, Rational(1, 2), bits);
    parts.push_back({std::move(a_right), std::move(b_right), part.depth + 1});
    parts.push_back({std::move(a_left), std::move(b_left), part.depth + 1});
  }
  return scaled(half_turn, 2, bits);
}

}  // namespace phrame
