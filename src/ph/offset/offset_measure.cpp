// A piece r = X/W has r′ = p·H/W², and |H| is a polynomial for the offset of a PH curve, a straight
// line along a rational unit vector and an arc: for the first, H is a multiple of (x, y) with
// x² + y² = σ². So r′ has the length ±p·|H|/W², of which the integral is Δs + d·Δφ, and x dy − y dx
// is p·(X × H)/W³ dt.
#include "phrame/ph/offset/offset_measure.hpp"

#include "phrame/integrate/endpoint.hpp"
#include "phrame/integrate/integral_sum.hpp"
#include "phrame/integrate/integrate.hpp"
#include "phrame/ph/curve/special_points.hpp"

namespace phrame::inline v0 {
namespace {

/// ±|r′|, with the sign of p.
RationalFunction signed_speed(const RationalCurve& curve) {
  const auto& [x, y, z] = curve.direction();
  const Polynomial size = *square_root(x * x + y * y);
  return {curve.multiplier() * size, curve.weight() * curve.weight()};
}

RationalFunction area_rate(const RationalCurve& curve) {
  const auto& [x, y, z] = curve.numerator();
  const Vector<Polynomial>& h = curve.direction();
  const Polynomial& w = curve.weight();
  return {Rational(1, 2) * curve.multiplier() * (x * h[1] - y * h[0]), w * w * w};
}

/// factor·∫ f.
KnownIntegral known_integral(const RationalFunction& f, const Antiderivative& F,
                             const RealAlgebraic& from, const RealAlgebraic& to,
                             const Rational& factor) {
  const auto end = [](const RealAlgebraic& x) {
    const auto r = x.rational();
    return r ? Endpoint(*r) : Endpoint(x);
  };
  const DefiniteIntegral found = definite_integral(F, f, end(from), end(to), AtPoles::refuse);
  KnownIntegral known{{Real(factor) * found.value, std::nullopt}};
  if (found.exact) known.value.exact = factor * *found.exact;
  if (from.is_rational() && to.is_rational())
    known.parts = {{f, F, *from.rational(), *to.rational(), factor}};
  return known;
}

/// What is on the way.
class LengthSum {
 public:
  explicit LengthSum(const Offset& offset) : offset_(offset) {}

  OffsetLength make() {
    for (std::size_t k = 0; k < offset_.pieces.size(); ++k) {
      add_piece(k);
      const std::size_t next = k + 1;
      if (next == offset_.pieces.size() || !offset_.meets[k] || sign_ != first_sign(next))
        end(k, Rational(1));
    }
    length_.total = sum_of_integrals(all_);
    return std::move(length_);
  }

 private:
  int first_sign(std::size_t k) const {
    return sign_after_zero(offset_.pieces[k].curve.multiplier());
  }

  void add_piece(std::size_t k) {
    const RationalCurve& curve = offset_.pieces[k].curve;
    const RationalFunction speed = signed_speed(curve);
    const Antiderivative F = integrate(speed);
    sign_ = first_sign(k);
    RealAlgebraic from = Rational(0);
    const auto add = [&](const RealAlgebraic& to) {
      if (stretch_.empty()) {
        first_piece_ = k;
        from_ = from;
      }
      stretch_.push_back(known_integral(speed, F, from, to, sign_));
      from = to;
    };
    for (const RealRoot& root : odd(real_roots(curve.multiplier(), open_interval(0, 1)))) {
      add(root.at);
      end(k, root.at);
      sign_ = -sign_;
    }
    add(Rational(1));
  }

  void end(std::size_t k, const RealAlgebraic& to) {
    length_.stretches.push_back({first_piece_, from_, k, to, sum_of_integrals(stretch_)});
    all_.insert(all_.end(), stretch_.begin(), stretch_.end());
    stretch_.clear();
  }

  const Offset& offset_;
  int sign_ = 1;
  std::size_t first_piece_ = 0;
  RealAlgebraic from_ = Rational(0);
  std::vector<KnownIntegral> stretch_;
  std::vector<KnownIntegral> all_;
  OffsetLength length_{{}, {Rational(0), std::nullopt}};
};

}  // namespace

OffsetLength length(const Offset& offset) { return LengthSum(offset).make(); }

Real signed_area(const Path& path) {
  Rational exact;
  std::vector<KnownIntegral> others;
  for (const Segment& segment : path.segments()) {
    const RationalFunction rate = area_rate(*rational_curve(segment));
    if (rate.is_polynomial())
      exact += antiderivative(rate.numerator())(1);
    else
      others.push_back(known_integral(rate, integrate(rate), Rational(0), Rational(1), 1));
  }
  if (others.empty()) return exact;
  return Real(exact) + sum_of_integrals(others).value;
}

std::optional<DefiniteIntegral> signed_area(const Offset& offset) {
  for (const bool meets : offset.meets)
    if (!meets) return std::nullopt;
  std::vector<KnownIntegral> integrals;
  for (const OffsetPiece& piece : offset.pieces) {
    const RationalFunction rate = area_rate(piece.curve);
    integrals.push_back(known_integral(rate, integrate(rate), Rational(0), Rational(1), 1));
  }
  return sum_of_integrals(integrals);
}

}  // namespace phrame
