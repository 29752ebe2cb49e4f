#include "phrame/ph/construct/rmf_spline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/in_place.hpp"
#include "phrame/algebra/progress.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/construct/exact_end.hpp"
#include "phrame/ph/construct/preimage_grid.hpp"
#include "phrame/ph/construct/rmf_family.hpp"
#include "phrame/ph/construct/rmf_plan.hpp"
#include "phrame/ph/construct/rmf_plane.hpp"
#include "phrame/ph/construct/spline_builder.hpp"
#include "phrame/ph/curve/end_point.hpp"

// At every joint there is one quaternion Q_k, rounded, where the segment before ends and the next
// one begins, up to a real factor. The shape of a septic is chosen for the data, in doubles; then
// its free numbers are refined, exactly, such that it ends where it is to from where the one before
// does end. Along tangents that are parallel Q_k is a multiple of the first such Q, and so the
// directions are the same.
//
// A closed spline ends with Q₀u, u of size 1 in ℚ(i), so with the derivative that it starts with,
// and what is missing of the way back is put into the multiplier of one segment. Where points are
// to be met exactly, each segment starts in its point, and has a multiplier that leads to the next.

namespace phrame::inline v0 {
namespace {

/// 2^e above √x.
long exponent_above_root(const Rational& x) { return (binary_exponent(x) >> 1) + 1; }

/// ∫ A i A* of a cubic A. With the denominators apart: they are common ones.
Vector<Rational> integral_of(const CubicPreimage<Rational>& a) {
  constexpr std::array<std::array<unsigned long, 4>, 4> weights{
      {{60, 30, 12, 3}, {30, 36, 27, 12}, {12, 27, 36, 30}, {3, 12, 30, 60}}};
  Integer d = 1;
  for (const RationalQuaternion& x : a) include_denominators(d, x);
  CubicPreimage<Integer> b;
  for (std::size_t k = 0; k < 4; ++k) b[k] = whole_multiple(a[k], d);
  Vector<Integer> sum;
  for (std::size_t i = 0; i < 4; ++i) {
    IntegerQuaternion weighted{};
    for (std::size_t j = 0; j < 4; ++j)
      for (const auto part : {&IntegerQuaternion::u, &IntegerQuaternion::v, &IntegerQuaternion::p,
                              &IntegerQuaternion::q})
        add_product(weighted.*part, b[j].*part, weights[i][j]);
    sum = sum + symmetric_product(b[i], weighted);
  }
  return each(sum, [divisor = 420 * d * d](const Integer& x) { return Rational(x, divisor); });
}

/// So many more of what is rounded again.
constexpr long guard_places = 16;

/// So many more of the phase at the end, and of what is between, where points are met exactly. In a
/// plane that is not rational the curve is out of it by what A i A* at the ends is; the multiplier
/// can mend no more than a small part of that.
constexpr long places_between = 48;

/// Of a factor of an A with this |A|², for multiples of 2^−places.
long bits_for(const Rational& squared_size, long places) {
  constexpr long least_bits = 40;
  return std::max(places + exponent_above_root(squared_size), least_bits);
}

/// How many bits must be known of the numbers that are rounded to multiples of 2^−places.
class WorkingPrecision {
 public:
  explicit WorkingPrecision(const HermiteSpline& data)
      : size_(exponent_above_root(size_of_derivatives(data) + 1)) {}
  long operator()(long places) const { return std::max(0L, places + size_) + 96; }

 private:
  long size_;  ///< of the roots of all derivatives, in bits
};

/// A spline with one rounding.
class RmfChain {
 public:
  RmfChain(const HermiteSpline& data, const RmfPlan& plan, const WorkingPrecision& precision,
           long places, PointRule rule, SplineBuilder& builder)
      : data_(data),
        plan_(plan),
        working_precision_(precision),
        places_(places),
        rule_(rule),
        builder_(builder) {}

  /// No value where it could not be closed, or not meet its points exactly.
  std::optional<Construction> run();

 private:
  /// A = size·base there.
  struct Joint {
    RationalQuaternion base;
    Rational size;
  };

  void start();
  /// Segment k, towards this end of it.
  ExactFit piece(std::size_t k, const Vector<Rational>& target);
  bool add(const ExactFit& piece);
  class Septics;
  Joint end_of(const FloatQuaternion& as_is, std::size_t k, long places) const;
  ExactFit between_parallels(std::size_t k, const Vector<Rational>& target);
  bool close();

  bool is_closing(std::size_t k) const { return data_.is_closed && k == plan_.closing; }
  /// Of Q_k; nearly parallel tangents have digits in which they do not differ.
  long places_at(std::size_t k) const;
  /// The size of A at joint k where it is a multiple of this; 1 at the end of a closed spline,
  /// where that is Q₀u.
  Rational size_at(std::size_t k, const RationalQuaternion& base) const;

  const HermiteSpline& data_;
  const RmfPlan& plan_;
  const WorkingPrecision& working_precision_;
  long places_;
  PointRule rule_;
  SplineBuilder& builder_;
  std::vector<ExactFit> pieces_;  ///< without the factor h of f
  RationalQuaternion first_;      ///< Q₀
  Joint joint_;                   ///< the last one
};

long RmfChain::places_at(std::size_t k) const {
  double unit = 1;
  if (k > 0) unit = std::min(unit, plan_.segments[k - 1].unit);
  if (k < plan_.segments.size()) unit = std::min(unit, plan_.segments[k].unit);
  return places_ - std::ilogb(unit);
}

Rational RmfChain::size_at(std::size_t k, const RationalQuaternion& base) const {
  if (data_.is_closed && k == data_.segments()) return 1;
  const Vector<Rational>& d = data_.derivatives[k];
  if (largest(d) == 0) return 0;
  const long places = bits_for(norm(base), places_);
  const long precision = working_precision_(places);
  const Vector<BigFloat> v = big_floats(d, precision);
  return rounded_to_places(sqrt(sqrt(dot(v, v)) / BigFloat(norm(base), precision)), places);
}

void RmfChain::start() {
  const auto is_zero_at = [&](std::size_t k) { return largest(data_.derivatives[k]) == 0; };
  const std::size_t k = is_zero_at(0) ? 1 : 0;
  const Vector<Rational> along = is_zero_at(k) ? mean_derivative(data_, 0) : data_.derivatives[k];
  const long places = places_at(k);
  first_ = rounded_to_places(preimage(big_floats(along, working_precision_(places))), places);
  joint_ = {first_, is_zero_at(0) ? 0 : 1};
}

ExactFit RmfChain::between_parallels(std::size_t k, const Vector<Rational>& target) {
  const RationalQuaternion& q = joint_.base;
  const bool is_base = plan_.base[k + 1] == k + 1 && largest(data_.derivatives[k + 1]) != 0;
  const ParallelEnds ends{q, joint_.size, is_base ? Rational(1) : size_at(k + 1, q)};
  const long places = bits_for(norm(q), places_);
  joint_.size = ends.at_end;
  const bool may_be_straight =
      rule_ == PointRule::near || cross(rotated_i(q), target) == Vector<Rational>{};
  if (plan_.segments[k].form == SegmentForm::line && may_be_straight)
    if (auto line = line_between(ends, target, places)) return *std::move(line);
  ExactFit plane = plane_between(ends, target, places, rule_);
  if (hermitian_product(q, plane.preimage.back()).re < 0) joint_.size = -joint_.size;
  return plane;
}

/// The end of a septic for a phase of its own.
RmfChain::Joint RmfChain::end_of(const FloatQuaternion& as_is, std::size_t k, long places) const {
  if (!is_closing(k)) return {rounded_to_places(as_is, places), 1};
  const long precision = working_precision_(places);
  const auto [re, im] =
      direction_of(hermitian_product(big_floats(first_, precision), as_is), BigFloat(0.0));
  const GaussianRational u =
      unit_near({rounded_to_places(re, precision), rounded_to_places(im, precision)},
                bits_for(norm(first_), places));
  const RationalQuaternion base = turned(first_, u);
  return {base, size_at(k + 1, base)};
}

/// The septics with a start that is given, and the phase, b and b′ as parameters.
class RmfChain::Septics {
 public:
  Septics(const RmfChain& chain, std::size_t k, const Vector<Rational>& target);

  /// The one that ends at the target, next to that of the plan.
  CubicPreimage<Rational> solution();
  /// The end of what was the solution.
  const Joint& end() const { return end_; }

 private:
  CubicPreimage<Rational> member(const std::vector<Rational>& x);
  std::vector<double> step(const std::vector<double>& off) const;

  const RmfChain& chain_;
  const SegmentPlan& plan_;
  std::size_t k_;
  Vector<Rational> target_;
  long places_;
  long precision_;
  RationalQuaternion q_;  ///< A at the start
  long bits_;             ///< of the parameters
  FloatQuaternion a0_;
  FloatQuaternion a3_;
  Phase turn_;      ///< A = a₀·turn at the start …
  Phase end_turn_;  ///< … and a₃·this at the end, for the minimal rotation
  RmfStart start_;  ///< of q_
  std::optional<Rational> t_;
  std::optional<RmfFamily> family_;  ///< of the t above
  Joint end_;
};

// What closes a spline is not rounded, so that its end can come as near as one likes.
RmfChain::Septics::Septics(const RmfChain& chain, std::size_t k, const Vector<Rational>& target)
    : chain_(chain),
      plan_(chain.plan_.segments[k]),
      k_(k),
      target_(target),
      places_(chain.places_at(k + 1)),
      q_(chain.joint_.size * chain.joint_.base),
      start_(q_) {
  const bool is_exact = chain.rule_ == PointRule::exact;
  const long places_of_end = places_;
  if (is_exact)
    places_ += places_between;
  else if (chain.is_closing(k))
    places_ += bits_for(norm(q_), places_);
  precision_ = chain.working_precision_(places_);
  const Vector<Rational>& d3 = chain.data_.derivatives[k + 1];
  bits_ = bits_for(std::max(norm(q_), 2 * largest(d3)), places_);
  a0_ = preimage(big_floats(chain.data_.derivatives[k], precision_));
  a3_ = preimage(big_floats(d3, precision_));
  if (is_exact) a3_ = big_floats(rounded_to_places(a3_, places_of_end), precision_);
  turn_ = direction_of(hermitian_product(a0_, big_floats(q_, precision_)), BigFloat(0.0));
  end_turn_ = turn_to(a0_, a3_) * turn_;
}

CubicPreimage<Rational> RmfChain::Septics::member(const std::vector<Rational>& x) {
  if (t_ != x[0]) {
    t_ = x[0];
    const Rational half_turns = exact_rational(plan_.unit) * x[0];
    end_ = chain_.end_of(turned(a3_, end_turn_ * phase_of(Angle(half_turns, 0), precision_)), k_,
                         places_);
    family_.emplace(start_, end_.size * end_.base);
  }
  const auto inner = [&](std::size_t at) {
    const FloatQuaternion b =
        big_floats(RationalQuaternion{x[at], 0, x[at + 1], x[at + 2]}, precision_);
    return rounded_to_places(turned(a0_ * b, turn_), places_ + guard_places);
  };
  return family_->member(inner(1), inner(4), bits_);
}

/// Seen from the start, and over the |A|² there.
std::vector<double> RmfChain::Septics::step(const std::vector<double>& off) const {
  const BigFloat inverse_size = BigFloat(1.0) / sqrt(norm(a0_));
  const Quaternion<double> a = in_doubles(inverse_size * a0_);
  const Quaternion<double> v = conjugate(a) * Quaternion<double>{0, off[0], off[1], off[2]} * a;
  return plan_.section->change({v.v, v.p, v.q});
}

CubicPreimage<Rational> RmfChain::Septics::solution() {
  const Rational squared_size = norm(q_);
  struct Tried {
    std::vector<Rational> x;
    CubicPreimage<Rational> member;
    Joint end;
  };
  std::vector<Tried> tried;
  const ExactDefect defect = [&](const std::vector<Rational>& x) {
    tried.push_back({x, member(x), end_});
    const Vector<Rational> off = integral_of(tried.back().member) - target_;
    return std::vector<Rational>{off[0] / squared_size, off[1] / squared_size,
                                 off[2] / squared_size};
  };
  const SepticShape& shape = plan_.section->solution();
  std::vector<Rational> start{exact_rational(shape.turn)};
  for (const Vector<double>& b : {shape.b, shape.b_prime})
    for (const double x : b) start.push_back(exact_rational(x));
  const ParameterStep newton_step = [&](const std::vector<double>& off) { return step(off); };
  const auto found = refine(std::move(start), defect, newton_step, bits_).parameters;
  const auto best = std::ranges::find(tried, found, &Tried::x);
  end_ = best->end;
  return best->member;
}

ExactFit RmfChain::piece(std::size_t k, const Vector<Rational>& target) {
  if (plan_.segments[k].form != SegmentForm::space) return between_parallels(k, target);
  try {
    Septics septics(*this, k, target);
    const CubicPreimage<Rational> a = septics.solution();
    joint_ = septics.end();
    return {{a.begin(), a.end()}, {1}};
  } catch (const DomainError& error) {
    throw Undecided(fmt::format("segment {}: {}", k + 1, error.what()));
  }
}

bool RmfChain::add(const ExactFit& piece) {
  std::vector<Rational> f = piece.multiplier;
  for (Rational& x : f) x *= data_.step(builder_.next());
  return builder_.add(piece.preimage, std::move(f), MultiplierFreedom::inner_only);
}

bool RmfChain::close() {
  const std::size_t m = plan_.closing;
  ExactFit& piece = pieces_[m];
  const Vector<Rational> lacking = (1 / data_.step(m)) * (data_.points.front() - builder_.end());
  auto f = multiplier_with(from_bernstein(piece.preimage), piece.multiplier,
                           end_point(curve_of(piece, {})) + lacking, MultiplierFreedom::inner_only);
  if (!f || std::ranges::any_of(*f, [](const Rational& x) { return x <= 0; })) return false;
  piece.multiplier = *std::move(f);
  builder_.restart();
  return std::ranges::all_of(pieces_, [&](const ExactFit& again) { return add(again); });
}

std::optional<Construction> RmfChain::run() {
  start();
  Stage stage("segments", data_.segments());
  for (std::size_t k = 0; k < data_.segments(); ++k, stage.advance()) {
    pieces_.push_back(piece(k, 1 / data_.step(k) * builder_.wanted()));
    if (!add(pieces_.back())) return std::nullopt;
  }
  if (data_.is_closed && builder_.end() != data_.points.front() && !close()) return std::nullopt;
  const auto compare = [&](const Rational& f, const RationalQuaternion& a, std::size_t k) {
    builder_.meter().derivative(f * rotated_i(a) - data_.derivatives[k]);
  };
  for (std::size_t k = 0; k < pieces_.size(); ++k)
    compare(pieces_[k].multiplier.front(), pieces_[k].preimage.front(), k);
  compare(pieces_.back().multiplier.back(), pieces_.back().preimage.back(), pieces_.size());
  return builder_.finished(data_.parameters, places_);
}

/// A first number of places: such that derivatives and points can be met, and such that small
/// derivatives have some bits, for they say where the curve goes.
long first_places(const HermiteSpline& data, const Deviation& tolerance) {
  constexpr long least_bits = 40;
  constexpr long margin = 6;
  const Rational fastest = size_of_derivatives(data);
  long places = std::numeric_limits<long>::min();
  const auto want = [&](long e) { places = std::max(places, e); };
  for (const Vector<Rational>& d : data.derivatives)
    if (const Rational size = largest(d); size != 0) want(least_bits - exponent_above_root(size));
  if (fastest != 0)
    want(exponent_above_root(fastest) + margin - binary_exponent(tolerance.derivatives));
  for (std::size_t k = 0; k < data.segments(); ++k) {
    const Rational h = data.step(k);
    const Rational size =
        std::max({Rational(largest(mean_derivative(data, k))), largest(data.derivatives[k]),
                  largest(data.derivatives[k + 1])});
    want(exponent_above_root(size) + binary_exponent(h) + margin -
         binary_exponent(tolerance.points));
  }
  return places;
}

}  // namespace

Construction rmf_spline(const HermiteSpline& data, const Deviation& tolerance, PointRule rule) {
  constexpr int most_passes = 12;
  require_regular(data);
  const long places = first_places(data, tolerance);
  const WorkingPrecision precision(data);
  const RmfPlan plan = rmf_plan(data, tolerance, 2 * precision(places));
  return first_built(
      data, rule, tolerance, places, most_passes,
      [&](SplineBuilder& builder, long now) {
        return RmfChain(data, plan, precision, now, rule, builder).run();
      },
      data.is_closed
          ? "the septics with h = 0: the spline could not be closed"
          : "the septics with h = 0: the points are too sensitive to their coefficients");
}

}  // namespace phrame
