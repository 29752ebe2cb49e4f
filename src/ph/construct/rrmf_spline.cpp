#include "phrame/ph/construct/rrmf_spline.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/progress.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/construct/of_segment.hpp"
#include "phrame/ph/construct/preimage_grid.hpp"
#include "phrame/ph/construct/refine.hpp"
#include "phrame/ph/construct/rrmf_joint.hpp"
#include "phrame/ph/construct/rrmf_quintic.hpp"
#include "phrame/ph/construct/spline_builder.hpp"
#include "phrame/ph/curve/end_point.hpp"

// A segment is r′ = F·(A₀B) i (A₀B)*, B = (1, b, q): turned back by A₀ and in units of its step it
// is φ·B i B*, φ = F·|A₀|². With numbers b, τ, φ of p bits it is within the tolerance, and so is
// one near it whose numbers are short for its ends, too. The next A₀ is A₀q over a rational number,
// so that the tangent is the same, exactly.

namespace phrame::inline v0 {
namespace {

using RrmfEnd = RrmfEnds<Rational>;

RationalQuaternion rounded_unit_preimage(const Vector<Rational>& v, long bits) {
  return rounded_to_places(unit_preimage(v, bits + 32), bits);
}

/// The six parameters, one of them held as it is.
class RrmfParameters {
 public:
  RrmfParameters(const RrmfQuintic<double>& x, std::size_t held)
      : all_{x.b.u, x.b.v, x.b.p, x.b.q, x.tau, x.f}, held_(held) {
    constexpr long held_bits = 20;
    held_value_ = rounded_to_places(exact_rational(all_[held]), held_bits);
  }

  std::vector<Rational> free() const {
    std::vector<Rational> list;
    for (const double x : all_) list.push_back(exact_rational(x));
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(held_));
    return list;
  }
  RrmfQuintic<Rational> quintic(std::vector<Rational> x) const {
    x.insert(x.begin() + static_cast<std::ptrdiff_t>(held_), held_value_);
    return {{x[0], x[1], x[2], x[3]}, x[4], x[5]};
  }
  JacobianRows without_held(JacobianRows rows) const {
    for (auto& row : rows) row.erase(row.begin() + static_cast<std::ptrdiff_t>(held_));
    return rows;
  }

 private:
  std::array<double, 6> all_;
  std::size_t held_;
  Rational held_value_;
};

/// A segment from A₀ in the direction of d₁, to the next point.
class RrmfSegment {
 public:
  RrmfSegment(const RrmfJoint& start, const Vector<Rational>& d1, const Deviation& tolerance,
              SplineBuilder& builder)
      : start_(start),
        a0_(exact(start.a, 1)),
        d1_(d1),
        tolerance_(tolerance),
        builder_(builder),
        size_(norm(a0_)),
        scale_(scale_for_doubles(largest(builder.wanted()))),
        step_((scale_ / size_) * turned_back(builder.wanted(), a0_)),
        end_direction_(turned_back(d1, a0_)) {}

  /// Adds it; false where none is found.
  bool add();

  const RrmfJoint& end() const { return end_; }
  long bits() const { return bits_; }

 private:
  RrmfEnd wanted(long bits) const {
    return {each(step_, [bits](const Rational& x) { return rounded_to_places(x, bits); }),
            rounded_unit_preimage(end_direction_, bits)};
  }
  bool add(const JoinedRrmf& joined, const Rational& f, long bits);
  bool add_straight(long bits);
  bool add_general(long bits);

  const RrmfJoint& start_;
  RationalQuaternion a0_;
  const Vector<Rational>& d1_;
  const Deviation& tolerance_;
  SplineBuilder& builder_;
  Rational size_;
  Rational scale_;
  Vector<Rational> step_;
  Vector<Rational> end_direction_;
  RrmfJoint end_;
  long bits_ = 0;
  bool is_near_ = false;  ///< was there one within the tolerance?
};

/// This one, if it is within the tolerance, and meets its point.
bool RrmfSegment::add(const JoinedRrmf& joined, const Rational& f, long bits) {
  const Rational& size = joined.size;
  const Rational multiplier = rounded_to_bits(f / (size * size * size_ * scale_), bits + 4);
  const BernsteinPreimage a{size * a0_, joined.a1, joined.a2};
  const Vector<Rational> off =
      end_point(Curve(from_bernstein(a), Polynomial{multiplier})) - builder_.wanted();
  const Vector<Rational> direction = rotated_i(a[2]);
  is_near_ = dot(off, off) <= tolerance_.points * tolerance_.points &&
             4 * squared_sine(direction, d1_) <= tolerance_.derivatives * tolerance_.derivatives;
  if (!is_near_ || !builder_.add(a, {multiplier}, MultiplierFreedom::all)) return false;
  builder_.meter().direction(direction, d1_);
  end_ = joined.end;
  bits_ = bits;
  return true;
}

/// The line, where that ends as wanted: b = q = 1. There all quintics that end so are it, and to
/// look for one is to look along them.
bool RrmfSegment::add_straight(long bits) {
  const Rational length = rounded_to_places(step_[0], bits);
  return length > 0 && end_direction_[0] > 0 && add({1, a0_, a0_, start_}, length, bits);
}

bool RrmfSegment::add_general(long bits) {
  constexpr long spare_bits = 24;
  constexpr double nothing = 1e-10;
  const RrmfEnd first = wanted(bits + spare_bits);
  const RrmfEnds<double> guessed{scaled_to_doubles(1, first.step),
                                 quaternion_in_doubles(first.end)};
  const std::optional<RrmfQuintic<double>> guess = rrmf_quintic(guessed);
  if (!guess) return false;
  const RrmfParameters parameters(*guess, freest_parameter(*guess, guessed));
  const JacobianRows rows = parameters.without_held(rrmf_jacobian(*guess, guessed));
  const auto defect_for = [&](long now) -> ExactDefect {
    return [&, ends = wanted(now + 2 * spare_bits)](const std::vector<Rational>& at) {
      const auto list = rrmf_defect(parameters.quintic(at), ends);
      return std::vector<Rational>(list.begin(), list.end());
    };
  };
  bool was_near = false;
  const auto accept = [&](const std::vector<Rational>& rounded, long now) {
    const RrmfQuintic<Rational> quintic = parameters.quintic(rounded);
    if (!(quintic.f > 0) || norm(last_coefficient(quintic)) == 0) return std::optional<bool>();
    const bool is_added = add(joined_rrmf(start_, quintic, now), quintic.f, now);
    was_near = was_near || is_near_;
    return is_added ? std::optional(true) : std::nullopt;
  };
  if (rounded_solution(parameters.free(), defect_for, least_change(rows, nothing), bits, 8, accept))
    return true;
  if (was_near) throw Undecided(std::string(no_slight_multiplier));
  return false;
}

bool RrmfSegment::add() {
  const long bits = std::max(
      24L, 6 - binary_exponent(std::min(tolerance_.points * scale_, tolerance_.derivatives)));
  return add_straight(bits) || add_general(bits);
}

}  // namespace

Construction rrmf_spline(const HermiteSpline& data, const Deviation& tolerance, PointRule rule) {
  require_directions(data);
  long bits = std::max(24L, 6 - binary_exponent(tolerance.derivatives));
  RrmfJoint joint = first_joint(data.derivatives.front(), bits);
  SplineBuilder builder(data, rule);
  builder.meter().direction(rotated_i(exact(joint.a, 1)), data.derivatives.front());
  Stage stage("segments", data.segments());
  for (std::size_t k = 0; k < data.segments(); ++k, stage.advance()) {
    if (data.points[k] == data.points[k + 1])
      throw DomainError(fmt::format(
          "segment {}: its ends are equal, and directions alone do not say how great it is",
          k + 1));
    RrmfSegment segment(joint, data.derivatives[k + 1], tolerance, builder);
    if (!of_segment(k, [&] { return segment.add(); }))
      throw Undecided(fmt::format(
          "segment {}: no quintic with these ends and tangents and a rational rotation-minimizing "
          "frame was found",
          k + 1));
    joint = segment.end();
    bits = std::max(bits, segment.bits());
  }
  return builder.finished(whole_parameters(data), bits);
}

bool is_rrmf_of_class_one(const PhPath& path) {
  return std::ranges::all_of(path.segments(), [](const Curve& curve) {
    if (preimage_degree(curve) > 2) return false;
    const std::vector<RationalQuaternion> a = to_bernstein(curve.preimage(), 2);
    return symmetric_product(a[0], a[2]) == rotated_i(a[1]);
  });
}

}  // namespace phrame
