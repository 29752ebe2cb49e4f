#pragma once
#include <algorithm>
#include <cmath>
#include <string>

#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/end_point.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/offset/offset_trim.hpp"

namespace phrame::test {

/// A polynomial in s and t: the coefficients of s⁰, s¹, …, polynomials in t.
using PlanePolynomial = std::vector<Polynomial>;

/// F(s, t) = |r(s) − P(t)|² − d², times both squared weights.
inline PlanePolynomial distance_gap(const Curve& base, const RationalCurve& offset,
                                    const Rational& d) {
  const Vector<Polynomial> r = numerator(base);
  const Polynomial& w = base.weight();
  const Vector<Polynomial>& X = offset.numerator();
  const Polynomial& W = offset.weight();
  // Products of a polynomial in s by one in t.
  const std::vector<std::pair<Polynomial, Polynomial>> terms{
      {r[0] * r[0] + r[1] * r[1], W * W},
      {r[0] * w, Rational(-2) * X[0] * W},
      {r[1] * w, Rational(-2) * X[1] * W},
      {w * w, X[0] * X[0] + X[1] * X[1] - d * d * W * W}};
  PlanePolynomial sum;
  for (const auto& [in_s, in_t] : terms)
    for (long k = 0; k <= in_s.degree(); ++k) {
      if (static_cast<std::size_t>(k) == sum.size()) sum.emplace_back();
      sum[static_cast<std::size_t>(k)] += in_s.coefficient(k) * in_t;
    }
  return sum;
}

/// F/(s − a(t)), by Horner's scheme; no value where that is no polynomial.
inline std::optional<PlanePolynomial> divided(const PlanePolynomial& F, const Polynomial& a) {
  PlanePolynomial quotient(F.size() - 1);
  Polynomial rest;
  for (std::size_t k = F.size(); k > 0; --k) {
    if (k < F.size()) quotient[k - 1] = rest;
    rest = F[k - 1] + a * rest;
  }
  if (!rest.is_zero()) return std::nullopt;
  return quotient;
}

/// What is found out about the sign of a polynomial on a rectangle.
enum class SignThere { positive, negative_somewhere, undecided };

namespace trim_proof {

inline double half_sum(double a, double b) { return (a + b) / 2; }
inline Integer half_sum(const Integer& a, const Integer& b) { return floor_quotient(a + b, 2); }
/// What a half-sum of numbers of at most that size is off by.
inline double rounding_error(double size) { return size * 0x1p-52 + 0x1p-1000; }
inline Integer rounding_error(const Integer& /*size*/) { return 1; }

/// Bernstein coefficients c[i·columns + j] of a polynomial in s and t, each off by at most `error`.
template <class T>
struct Tensor {
  std::size_t rows;
  std::size_t columns;
  std::vector<T> c;
  T error;

  T size() const {
    T most = 0;
    for (const T& x : c) most = std::max<T>(most, x < 0 ? T(-x) : x);
    return most;
  }
  /// The greatest difference of neighbours so many coefficients apart.
  T variation(std::size_t step) const {
    T most = 0;
    for (std::size_t k = 0; k + step < c.size(); ++k) {
      if (step == 1 && (k + 1) % columns == 0) continue;
      const T rise = c[k + step] - c[k];
      most = std::max<T>(most, rise < 0 ? T(-rise) : rise);
    }
    return most;
  }
  /// Its halves, in s or in t, by de Casteljau's algorithm.
  std::pair<Tensor, Tensor> halves(bool in_s) const {
    Tensor first = *this;
    Tensor second = *this;
    const std::size_t step = in_s ? columns : 1;
    const std::size_t count = in_s ? rows : columns;
    for (std::size_t line = 0; line < (in_s ? columns : rows); ++line) {
      const std::size_t start = in_s ? line : line * columns;
      for (std::size_t left = count - 1; left > 0; --left) {
        first.c[start + (count - 1 - left) * step] = second.c[start];
        for (std::size_t k = 0; k < left; ++k)
          second.c[start + k * step] =
              half_sum(second.c[start + k * step], second.c[start + (k + 1) * step]);
      }
      first.c[start + (count - 1) * step] = second.c[start];
    }
    first.error += rounding_error(size()) * T(static_cast<long>(count));
    second.error = first.error;
    return {std::move(first), std::move(second)};
  }
};

template <class T>
SignThere sign_of(Tensor<T> whole, long most_boxes) {
  std::vector<Tensor<T>> left{std::move(whole)};
  while (!left.empty()) {
    if (most_boxes-- == 0) return SignThere::undecided;
    const Tensor<T> box = std::move(left.back());
    left.pop_back();
    const std::size_t last = box.c.size() - 1;
    for (const std::size_t corner : {std::size_t(0), box.columns - 1, last + 1 - box.columns, last})
      if (box.c[corner] < -box.error) return SignThere::negative_somewhere;
    if (std::ranges::all_of(box.c, [&](const T& x) { return x > box.error; })) continue;
    if (box.size() <= box.error) return SignThere::undecided;
    auto [a, b] = box.halves(box.variation(box.columns) > box.variation(1));
    left.push_back(std::move(a));
    left.push_back(std::move(b));
  }
  return SignThere::positive;
}

}  // namespace trim_proof

/// Of the polynomial for s from 0 to 1 and t from `from` to `to`: by doubles with their errors, and
/// where these do not tell by integers of 120 digits.
inline SignThere sign_on(const PlanePolynomial& F, const Rational& from, const Rational& to) {
  long degree = 0;
  const Polynomial along{from, to - from};
  PlanePolynomial G;
  for (const Polynomial& c : F)
    degree = std::max(degree, G.emplace_back(compose(c, along)).degree());
  const std::size_t columns = static_cast<std::size_t>(degree) + 1;
  std::vector<std::vector<Rational>> rows;
  for (const Polynomial& c : G) rows.push_back(to_bernstein(c, degree));
  std::vector<Rational> exact(F.size() * columns);
  for (std::size_t j = 0; j < columns; ++j) {
    std::vector<Rational> in_s;
    for (const auto& row : rows) in_s.push_back(row[j]);
    const std::vector<Rational> column =
        to_bernstein(Polynomial(in_s), static_cast<long>(F.size()) - 1);
    for (std::size_t i = 0; i < F.size(); ++i) exact[i * columns + j] = column[i];
  }
  Rational size;
  for (const Rational& x : exact) size = std::max(size, abs(x));
  if (size == 0) return SignThere::undecided;
  trim_proof::Tensor<double> fast{F.size(), columns, {}, 0x1p-52};
  trim_proof::Tensor<Integer> slow{F.size(), columns, {}, 1};
  const Rational unit = power_of_ten(120);
  for (const Rational& x : exact) {
    fast.c.push_back(static_cast<double>(x / size));
    slow.c.push_back(floor(x / size * unit));
  }
  const SignThere sign = trim_proof::sign_of(std::move(fast), 20'000);
  return sign != SignThere::undecided ? sign : trim_proof::sign_of(std::move(slow), 20'000);
}

/// What is proved of a trimmed offset.
struct TrimProof {
  long parts = 0;                 ///< that were looked at
  long pairs = 0;                 ///< of a part and a segment
  std::vector<std::string> open;  ///< pairs of which nothing is proved
  std::vector<std::string> wrong;
};
/// Proves of each part, but for a millionth at each of its ends, where it may touch other discs,
/// that all of its points are at the distance |d| from their feet, by an identity of polynomials,
/// and that no point of the path is nearer: F > 0 for all s and t, where F is without its factors
/// at the foot, (s − t)², or s or 1 − s at a corner.
inline TrimProof prove_distance(const PhPath& path, const TrimmedOffset& found) {
  TrimProof proof;
  for (const TrimmedBranch& branch : found.branches)
    for (const OffsetPart& part : branch.parts) {
      const OffsetPiece& piece = found.offset.pieces[part.piece];
      const Vector<Rational> corner = path.segments()[piece.segment].start();
      constexpr long bits = 400;
      const Rational lower = part.from.enclose(bits).midpoint();
      const Rational margin = (part.to.enclose(bits).midpoint() - lower) / (1L << 20);
      const Rational from = simplest_between(lower + margin / 2, lower + margin);
      const Rational upper = part.to.enclose(bits).midpoint();
      const Rational to = simplest_between(upper - margin, upper - margin / 2);
      ++proof.parts;
      for (std::size_t k = 0; k < path.segments().size(); ++k) {
        const Curve& base = path.segments()[k];
        const std::string name = "part " + std::to_string(proof.parts) + " of piece " +
                                 std::to_string(part.piece) + " from t = " + to_string(from) +
                                 " to " + to_string(to) + ", segment " + std::to_string(k);
        PlanePolynomial F = distance_gap(base, piece.curve, found.offset.distance);
        const auto divide_by = [&](const Polynomial& a) {
          std::optional<PlanePolynomial> quotient = divided(F, a);
          if (quotient)
            F = std::move(*quotient);
          else
            proof.wrong.push_back(name + ": not at the distance d from its foot");
        };
        if (!piece.is_join && k == piece.segment) {
          divide_by({0, 1});
          divide_by({0, 1});
        }
        if (piece.is_join && base.start() == corner) divide_by({});
        if (piece.is_join && end_point(base) == corner) {
          divide_by({1});
          for (Polynomial& c : F) c *= Rational(-1);
        }
        ++proof.pairs;
        const SignThere sign = sign_on(F, from, to);
        if (sign == SignThere::undecided) proof.open.push_back(name);
        if (sign == SignThere::negative_somewhere)
          proof.wrong.push_back(name + ": nearer than |d|");
      }
    }
  return proof;
}

}  // namespace phrame::test
