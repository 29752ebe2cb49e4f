#include "phrame/ph/construct/rrmf_spline.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/big_float.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/progress.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/construct/exact_fit.hpp"
#include "phrame/ph/construct/multiplier.hpp"
#include "phrame/ph/construct/rrmf_quintic.hpp"
#include "phrame/ph/construct/scale.hpp"
#include "phrame/ph/curve/end_point.hpp"

// A segment is r′ = F·(A₀B) i (A₀B)*, B = (1, b, q): turned back by A₀ and in units of its step it
// is φ·B i B*, φ = F·|A₀|², with numbers b, τ, φ of p bits. The next A₀ is A₀q, so that the
// tangent is the same, exactly.

namespace phrame {
namespace {

using RrmfEnd = RrmfEnds<Rational>;

/// A preimage of the direction of v, of size 1, to so many bits.
RationalQuaternion unit_preimage_of(const Vector<Rational>& v, long bits) {
  const Rational scale = scale_for_doubles(largest(v));
  Vector<BigFloat> w;
  for (std::size_t k = 0; k < 3; ++k) w[k] = BigFloat(scale * v[k], bits + 32);
  const Quaternion<BigFloat> a = preimage(BigFloat(1.0) / sqrt(dot(w, w)) * w);
  const auto part = [&](const BigFloat& x) {
    return Rational(x.scaled(bits)) * power_of_two(-bits);
  };
  return {part(a.u), part(a.v), part(a.p), part(a.q)};
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

struct RrmfState {
  RationalQuaternion a0;
  Vector<Rational> r;
};

/// A segment, and where the next one starts.
struct RrmfPiece {
  Curve curve;
  RrmfState next;
  Rational squared_points;
  Rational sines;
  long bits;
};

/// The same with a multiplier that leads to the point, exactly; no value where there is none.
std::optional<RrmfPiece> meeting(RrmfPiece piece, const Vector<Rational>& point) {
  const Curve& curve = piece.curve;
  const auto f = slight_multiplier(curve.preimage(), curve.multiplier().coefficients(),
                                   point - curve.start(), MultiplierFreedom::all);
  if (!f) return std::nullopt;
  piece.curve = Curve(curve.preimage(), from_bernstein(*f), curve.start());
  piece.next.r = point;
  piece.squared_points = 0;
  return piece;
}

class RrmfSegment {
 public:
  /// Towards that point and in that direction.
  RrmfSegment(const RrmfState& start, const Vector<Rational>& point, const Vector<Rational>& d1,
              const Deviation& tolerance, PointRule rule)
      : start_(start),
        point_(point),
        d1_(d1),
        tolerance_(tolerance),
        rule_(rule),
        size_(norm(start.a0)),
        scale_(scale_for_doubles(largest(point - start.r))),
        step_((scale_ / size_) * turned_back(point - start.r, start.a0)),
        end_direction_(turned_back(d1, start.a0)) {}

  /// No value where none is found.
  std::optional<RrmfPiece> found() const;

 private:
  RrmfEnd wanted(long bits) const {
    RrmfEnd ends{{}, unit_preimage_of(end_direction_, bits)};
    for (std::size_t k = 0; k < 3; ++k) ends.step[k] = rounded_to_places(step_[k], bits);
    return ends;
  }
  RrmfPiece piece(const RrmfQuintic<Rational>& x, long bits) const;
  std::optional<RrmfPiece> straight(long bits) const;
  bool is_within_tolerance(const RrmfPiece& piece) const {
    return piece.squared_points <= tolerance_.points * tolerance_.points &&
           4 * piece.sines <= tolerance_.derivatives * tolerance_.derivatives;
  }

  const RrmfState& start_;
  const Vector<Rational>& point_;
  const Vector<Rational>& d1_;
  const Deviation& tolerance_;
  PointRule rule_;
  Rational size_;
  Rational scale_;
  Vector<Rational> step_;
  Vector<Rational> end_direction_;
};

RrmfPiece RrmfSegment::piece(const RrmfQuintic<Rational>& x, long bits) const {
  const Rational multiplier = rounded_to_bits(x.f / (size_ * scale_), bits + 4);
  const RationalQuaternion a2 = start_.a0 * last_coefficient(x);
  const Curve curve(from_bernstein({start_.a0, start_.a0 * x.b, a2}), Polynomial{multiplier},
                    start_.r);
  const Vector<Rational> r = end_point(curve);
  const Vector<Rational> off = r - point_;
  return {curve, {a2, r}, dot(off, off), squared_sine(rotated_i(a2), d1_), bits};
}

/// The line, where that ends as wanted: b = q = 1. There all quintics that end so are it, and to
/// look for one is to look along them.
std::optional<RrmfPiece> RrmfSegment::straight(long bits) const {
  const Rational length = rounded_to_places(step_[0], bits);
  if (!(length > 0) || !(end_direction_[0] > 0)) return std::nullopt;
  RrmfPiece line = piece({{1, 0, 0, 0}, 0, length}, bits);
  if (!is_within_tolerance(line)) return std::nullopt;
  return rule_ == PointRule::near ? line : meeting(std::move(line), point_);
}

std::optional<RrmfPiece> RrmfSegment::found() const {
  constexpr long spare_bits = 24;
  constexpr int most_passes = 12;
  bool met_nearly = false;
  long bits = std::max(24L, 6 - binary_exponent(std::min(Rational(tolerance_.points * scale_),
                                                         tolerance_.derivatives)));
  if (auto line = straight(bits)) return line;
  const RrmfEnd first = wanted(bits + spare_bits);
  const RrmfEnds<double> guessed{scaled_to_doubles(1, first.step),
                                 quaternion_in_doubles(first.end)};
  const std::optional<RrmfQuintic<double>> guess = rrmf_quintic(guessed);
  if (!guess) return std::nullopt;
  const RrmfParameters parameters(*guess, freest_parameter(*guess, guessed));
  const JacobianRows rows = parameters.without_held(rrmf_jacobian(*guess, guessed));
  std::vector<Rational> x = parameters.free();
  for (int pass = 0; pass < most_passes; ++pass, bits += 8) {
    const RrmfEnd ends = wanted(bits + 2 * spare_bits);
    const auto defect = [&](const std::vector<Rational>& at) {
      const auto list = rrmf_defect(parameters.quintic(at), ends);
      return std::vector<Rational>(list.begin(), list.end());
    };
    x = refine(std::move(x), defect, rows, bits + spare_bits).parameters;
    std::vector<Rational> rounded;
    for (const Rational& value : x) rounded.push_back(rounded_to_places(value, bits));
    const RrmfQuintic<Rational> quintic = parameters.quintic(std::move(rounded));
    if (!(quintic.f > 0) || norm(last_coefficient(quintic)) == 0) continue;
    RrmfPiece result = piece(quintic, bits);
    if (!is_within_tolerance(result)) continue;
    if (rule_ == PointRule::near) return result;
    met_nearly = true;
    if (auto exact = meeting(std::move(result), point_)) return exact;
  }
  if (met_nearly) throw Undecided(std::string(no_slight_multiplier));
  return std::nullopt;
}

}  // namespace

Construction rrmf_spline(const HermiteSpline& data, const Deviation& tolerance, PointRule rule) {
  require_directions(data);
  const long first_bits = std::max(24L, 6 - binary_exponent(tolerance.derivatives));
  RrmfState state{unit_preimage_of(data.derivatives.front(), first_bits), data.points.front()};
  Rational squared_points;
  Rational sines = squared_sine(rotated_i(state.a0), data.derivatives.front());
  std::vector<Curve> curves;
  std::vector<Rational> parameters{0};
  long bits = first_bits;
  Stage stage("segments", data.segments());
  for (std::size_t k = 0; k < data.segments(); ++k, stage.advance()) {
    if (data.points[k] == data.points[k + 1])
      throw DomainError(fmt::format(
          "segment {}: its ends are equal, and directions alone do not say how great it is",
          k + 1));
    const std::optional<RrmfPiece> found = of_segment(k, [&] {
      return RrmfSegment(state, data.points[k + 1], data.derivatives[k + 1], tolerance, rule)
          .found();
    });
    if (!found)
      throw Undecided(fmt::format(
          "segment {}: no quintic with these ends and tangents and a rational rotation-minimizing "
          "frame was found",
          k + 1));
    curves.push_back(found->curve);
    squared_points = std::max(squared_points, found->squared_points);
    sines = std::max(sines, found->sines);
    bits = std::max(bits, found->bits);
    state = found->next;
    parameters.emplace_back(k + 1);
  }
  return {joined(curves),
          std::move(parameters),
          {},
          bits,
          {square_root_above(squared_points), 2 * square_root_above(sines)}};
}

bool is_rrmf_of_class_one(const Path& path) {
  return std::ranges::all_of(path.segments(), [](const Curve& curve) {
    if (preimage_degree(curve) > 2) return false;
    const std::vector<RationalQuaternion> a = to_bernstein(curve.preimage(), 2);
    return symmetric_product(a[0], a[2]) == rotated_i(a[1]);
  });
}

}  // namespace phrame
