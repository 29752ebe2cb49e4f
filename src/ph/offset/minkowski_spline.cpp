// With the null factors (x′ + r′, σ + y′; σ − y′, x′ − r′) = h·w·vᵀ, w = (a, b) and v = (c, d),
// which is a vector V(w, v) and half of σ, and for quadratic w and v with Bernstein coefficients
// wᵢ, vⱼ
//   120 ∫ V(w, v) = V(B, C) + 15·(V(w₀, v₀) + V(w₂, v₂)) − 5·(V(w₀, v₂) + V(w₂, v₀)),
//   B = 3w₀ + 4w₁ + 3w₂, C = 3v₀ + 4v₁ + 3v₂.
// The ends are known up to w₂ ↦ λw₂, v₂ ↦ v₂/λ, and then V(B, C) = c is: that has a solution where
// c is not timelike, with s = √(c_x² + c_y² − c_r²), up to B ↦ μB, C ↦ C/μ. As for PH quintics w
// and v are rounded to multiples of 2^−p, those at a joint once for both neighbours, and each
// segment aims at its end from where it does start; p grows until all is within the tolerance.
#include "phrame/ph/offset/minkowski_spline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <tuple>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/real.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/construct/spline_builder.hpp"
#include "phrame/ph/curve/scale.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

using Pair = std::array<Rational, 2>;

Pair operator+(const Pair& a, const Pair& b) { return {a[0] + b[0], a[1] + b[1]}; }
Pair operator-(const Pair& a, const Pair& b) { return {a[0] - b[0], a[1] - b[1]}; }
Pair operator*(const Rational& c, const Pair& a) { return {c * a[0], c * a[1]}; }

/// A column w and a row v, of which w·vᵀ counts.
struct NullPair {
  Pair w;
  Pair v;
};
NullPair operator+(const NullPair& a, const NullPair& b) { return {a.w + b.w, a.v + b.v}; }
/// With the same product.
NullPair boosted(const Rational& factor, const NullPair& a) {
  return {factor * a.w, 1 / factor * a.v};
}

/// (x, y, r).
Vector<Rational> vector_of(const Pair& w, const Pair& v) {
  const Rational ac = w[0] * v[0];
  const Rational bd = w[1] * v[1];
  return {(ac + bd) / 2, (w[0] * v[1] - w[1] * v[0]) / 2, (ac - bd) / 2};
}
Rational sigma_of(const Pair& w, const Pair& v) { return (w[0] * v[1] + w[1] * v[0]) / 2; }

/// x² + y² − r².
Rational minkowski_square(const Vector<Rational>& d) {
  return d[0] * d[0] + d[1] * d[1] - d[2] * d[2];
}

/// √x ≥ 0, exact or to 20 bits; 1 for 0.
Rational short_root(const Rational& x) {
  if (x == 0) return 1;
  if (const auto root = square_root(x)) return *root;
  const long bits = 64 + std::abs(binary_exponent(x));
  return rounded_to_bits(square_root_of(x).enclose(bits).midpoint(), 20);
}

/// b with the factor for which σ of both orders is the same.
NullPair beside(const NullPair& a, NullPair b) {
  Rational first = sigma_of(a.w, b.v);
  Rational second = sigma_of(b.w, a.v);
  if (first + second < 0) {
    b = {Rational(-1) * b.w, Rational(-1) * b.v};
    first = -first;
    second = -second;
  }
  if (first == 0 || second == 0) return b;
  return boosted(short_root(abs(first / second)), b);
}

/// The same curve with a, b about as large as c, d, so that u, v, p, q are short numbers.
MinkowskiCurve balanced(MinkowskiCurve curve) {
  std::vector<Polynomial> n = null_factors(curve);
  const auto size = [](const Polynomial& p, const Polynomial& q) {
    Rational most;
    for (const Polynomial& x : {p, q})
      for (const Rational& c : x.coefficients()) most = std::max(most, abs(c));
    return most;
  };
  const Rational factor = power_of_two(binary_exponent(size(n[2], n[3]) / size(n[0], n[1])) / 2);
  const auto& [a, b, c, d] =
      std::tuple(Rational(factor / 4) * n[0], Rational(factor / 4) * n[1],
                 Rational(1 / (4 * factor)) * n[2], Rational(1 / (4 * factor)) * n[3]);
  curve.preimage = {a + b + c + d, a - b + c - d, a - b - c + d, a + b - c - d};
  return curve;
}

class MinkowskiChain {
 public:
  /// With multiples of 2^−places, or exactly.
  MinkowskiChain(const HermiteSpline& data, std::optional<long> places, const Deviation& tolerance)
      : data_(data), places_(places), meter_(tolerance), end_(data.points.front()) {}

  /// No value where it is not exact and should be.
  std::optional<MinkowskiSpline> run() {
    ends_ = pair_of(data_.derivatives.front());
    meter_.derivative(vector_of(ends_.w, ends_.v) - data_.derivatives.front());
    for (std::size_t k = 0; k < data_.segments() && !is_inexact_; ++k) add(k);
    if (is_inexact_) return std::nullopt;
    return MinkowskiSpline{std::move(axis_), meter_.deviation()};
  }

 private:
  /// √x of x ≥ 0.
  Rational root(const Rational& x) {
    if (const auto exact = square_root(x)) return *exact;
    if (!places_) {
      is_inexact_ = true;
      return 1;
    }
    return square_root_of(x)
        .enclose(std::max(*places_, 0L) + 96 + std::abs(binary_exponent(x)))
        .midpoint();
  }

  Rational rounded(const Rational& x) const { return places_ ? rounded_to_places(x, *places_) : x; }
  Pair rounded(const Pair& a) const { return {rounded(a[0]), rounded(a[1])}; }

  /// With V(w, v) = d and σ ≥ 0, both as large: where r′ = 0 v is ±(b, a).
  NullPair pair_of(const Vector<Rational>& d) {
    const Rational s = root(minkowski_square(d));
    const std::array<Pair, 2> rows{Pair{d[0] + d[2], s + d[1]}, Pair{s - d[1], d[0] - d[2]}};
    std::size_t i = 0;
    std::size_t j = 0;
    for (const std::size_t m : {0U, 1U})
      for (const std::size_t n : {0U, 1U})
        if (abs(rows[m][n]) > abs(rows[i][j])) {
          i = m;
          j = n;
        }
    const Rational& pivot = rows[i][j];
    if (pivot == 0) return {};
    NullPair found{{rows[0][j] / pivot, rows[1][j] / pivot}, rows[i]};
    const auto size = [](const Pair& a) -> Rational { return a[0] * a[0] + a[1] * a[1]; };
    const Rational ratio = size(found.v) / size(found.w);
    // Where it is to be exact any factor is right.
    found = boosted(places_ ? root(root(ratio)) : short_root(short_root(ratio)), found);
    return {rounded(found.w), rounded(found.v)};
  }

  /// What V(B, C) is to be.
  Vector<Rational> wanted(std::size_t k, const NullPair& next) const {
    const auto& [w0, v0] = ends_;
    const auto& [w2, v2] = next;
    return (120 / data_.step(k)) * (data_.points[k + 1] - end_) -
           Rational(15) * (vector_of(w0, v0) + vector_of(w2, v2)) +
           Rational(5) * (vector_of(w0, v2) + vector_of(w2, v0));
  }

  void add(std::size_t k) {
    const NullPair next = pair_of(data_.derivatives[k + 1]);
    if (is_inexact_) return;
    const NullPair last = beside(ends_, next);
    const Vector<Rational> c = wanted(k, last);
    if (minkowski_square(c) < 0 || c == Vector<Rational>{})
      throw DomainError(fmt::format(
          "segment {} has no such Minkowski PH quintic: the radius changes by too much", k + 1));
    const NullPair both = beside(ends_ + last, pair_of(c));
    if (is_inexact_) return;
    const NullPair ends = ends_ + last;
    const NullPair middle{rounded(Rational(1, 4) * (both.w - Rational(3) * ends.w)),
                          rounded(Rational(1, 4) * (both.v - Rational(3) * ends.v))};
    push(k, {ends_, middle, last});
    meter_.point(end_ - data_.points[k + 1]);
    meter_.derivative(vector_of(next.w, next.v) - data_.derivatives[k + 1]);
    ends_ = next;
  }

  void push(std::size_t k, const std::array<NullPair, 3>& coefficients) {
    const auto part = [&](Pair NullPair::*pair, std::size_t n) {
      std::vector<Rational> list;
      for (const NullPair& a : coefficients) list.push_back((a.*pair)[n]);
      return from_bernstein(list);
    };
    const Polynomial a = part(&NullPair::w, 0);
    const Polynomial b = part(&NullPair::w, 1);
    const Polynomial c = part(&NullPair::v, 0);
    const Polynomial d = part(&NullPair::v, 1);
    const Rational half_step = data_.step(k) / 2;
    auto found = identify_minkowski(
        {half_step * (a * c + b * d), half_step * (a * d - b * c), half_step * (a * c - b * d)},
        end_);
    if (const auto* reason = std::get_if<NotMinkowski>(&found))
      throw DomainError(fmt::format("segment {}: {}", k + 1, to_string(*reason)));
    axis_.push_back(balanced(std::get<MinkowskiCurve>(std::move(found))));
    end_ = evaluate(position(axis_.back()), 1);
  }

  const HermiteSpline& data_;
  std::optional<long> places_;
  DeviationMeter meter_;
  Vector<Rational> end_;
  NullPair ends_{};  ///< at the last joint
  bool is_inexact_ = false;
  MedialAxis axis_;
};

void require_spacelike(const HermiteSpline& data) {
  if (data.is_closed) throw DomainError("a spline of Minkowski PH quintics is open");
  require_directions(data);
  for (std::size_t k = 0; k < data.derivatives.size(); ++k)
    if (minkowski_square(data.derivatives[k]) < 0)
      throw DomainError(fmt::format(
          "the derivative at point {} has x'^2 + y'^2 < r'^2, so that there is no envelope",
          k + 1));
}

/// About what the rounding of w and v asks for; those of small derivatives, too, have some bits.
long first_places(const HermiteSpline& data, const Deviation& tolerance) {
  Rational size = size_of_derivatives(data);
  for (std::size_t k = 0; k < data.segments(); ++k)
    size = std::max(size, Rational(largest(data.points[k + 1] - data.points[k]) / data.step(k)));
  constexpr long least_bits = 24;
  long places = std::numeric_limits<long>::min();
  for (const Vector<Rational>& d : data.derivatives)
    places = std::max(places, least_bits - binary_exponent(largest(d)) / 2);
  const Rational reach = data.parameters.back() - data.parameters.front();
  return std::max(places, binary_exponent(size) / 2 + 4 -
                              std::min(binary_exponent(tolerance.derivatives),
                                       binary_exponent(tolerance.points / reach)));
}

}  // namespace

MinkowskiSpline minkowski_spline(const HermiteSpline& data, const Deviation& tolerance) {
  require_spacelike(data);
  if (auto exact = MinkowskiChain(data, std::nullopt, tolerance).run()) return *std::move(exact);
  constexpr int most_passes = 40;
  long places = first_places(data, tolerance);
  for (int pass = 0; pass < most_passes; ++pass, places += 8) {
    auto found = MinkowskiChain(data, places, tolerance).run();
    if (found && is_within(found->deviation, tolerance)) return *std::move(found);
  }
  throw Undecided("construct: the tolerance is not reached by numbers with " +
                  std::to_string(places) + " binary places");
}

}  // namespace phrame
