// With φ = φ(t) r_d′ = r′ + d·φ′·U′(φ) is along r′. The arc of U from φ₀ to φ₁, which turns by less
// than π, is by the forms of U in (1 − s)·(p₀, q₀) + s·(p₁, q₁), with one of the two signs of (p₁,
// q₁).
#include "phrame/ph/offset/gauge_offset.hpp"
#include "phrame/ph/curve/special_points.hpp"

#include <fmt/format.h>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/offset/gauge_kind.hpp"
#include "phrame/ph/offset/gauge_normal.hpp"
#include "phrame/ph/offset/joined_offset.hpp"

namespace phrame::inline v0 {
namespace {

/// r + d·v, as X/W.
std::optional<RationalCurve> moved(const Vector<Polynomial>& r, const Polynomial& weight,
                                   const GaugeVector& v, const Rational& d) {
  const Polynomial w = weight * v.weight;
  const Vector<Polynomial> sum{r[0] * v.weight + d * v.x * weight,
                               r[1] * v.weight + d * v.y * weight, r[2] * v.weight};
  const auto is_constant = [&](const Polynomial& x) { return w(0) * x == x(0) * w; };
  if (is_constant(sum[0]) && is_constant(sum[1])) return std::nullopt;
  return RationalCurve(sum, w);
}

GaugeParameter parameter_at(const GaugeParameter& phi, const Rational& t) {
  return {{phi.p(t)}, {phi.q(t)}};
}

/// U there.
PlaneDirection value(const Gauge& gauge, const GaugeParameter& constant) {
  const GaugeVector u = vector_at(gauge, constant);
  const Rational w = u.weight(0);
  return {u.x(0) / w, u.y(0) / w};
}

/// The part of φ from one to the other by which U turns by less than π.
GaugeParameter between(const Gauge& gauge, const GaugeParameter& from, const GaugeParameter& to) {
  const auto way = [&](const Rational& sign) -> GaugeParameter {
    const auto line = [&](const Rational& a, const Rational& b) { return Polynomial{a, b - a}; };
    return {line(from.p(0), sign * to.p(0)), line(from.q(0), sign * to.q(0))};
  };
  const PlaneDirection a = value(gauge, from);
  const PlaneDirection b = value(gauge, to);
  const PlaneDirection middle = value(gauge, parameter_at(way(1), Rational(1, 2)));
  const int side = cross(a, b).sign();
  return way(cross(a, middle).sign() == side && cross(middle, b).sign() == side ? 1 : -1);
}

/// The φ with U(φ) = −U(constant).
GaugeParameter opposite(const Gauge& gauge, const GaugeParameter& constant) {
  const PlaneDirection u = value(gauge, constant);
  const Polynomial at = gcd(gauge.x() + u.x * gauge.weight(), gauge.y() + u.y * gauge.weight());
  if (at.degree() < 1) return {{1}, {}};
  return {{-at.coefficient(0)}, {at.coefficient(1)}};
}

/// Lines along the tangents.
std::vector<RationalCurve> mitre(const PlaneCorner& corner, const PlaneDirection& a,
                                 const PlaneDirection& b, const Rational& d) {
  const PlaneDirection gap{b.x - a.x, b.y - a.y};
  const Rational along = cross(gap, corner.after) / cross(corner.before, corner.after);
  const auto point = [&](const Rational& x, const Rational& y) -> Vector<Rational> {
    return {corner.at[0] + d * x, corner.at[1] + d * y, corner.at[2]};
  };
  const auto tip = point(a.x + along * corner.before.x, a.y + along * corner.before.y);
  return {bezier_curve({point(a.x, a.y), tip}), bezier_curve({tip, point(b.x, b.y)})};
}

/// Half of d·U about a point, from one φ to the opposite one: with the sign 1 to the left of
/// U(from) for d > 0, else to its right, which is ahead of a path that has U(from) to its right.
std::vector<RationalCurve> half_around(const Gauge& gauge, const Vector<Rational>& center,
                                       const GaugeParameter& from, const GaugeParameter& to,
                                       const Rational& d, int sign) {
  // Of the two φ half way on the line through both, one is ahead.
  const auto half = [&](const Rational& share) -> GaugeParameter {
    return {from.p + share * to.p, from.q + share * to.q};
  };
  const auto is_ahead = [&](const GaugeParameter& at) {
    return cross(value(gauge, from), value(gauge, at)).sign() == sign * d.sign();
  };
  const GaugeParameter ahead = is_ahead(half(1)) ? half(1) : half(-1);
  const auto& [x, y, z] = center;
  std::vector<RationalCurve> arcs;
  for (const auto& [a, b] : {std::pair(from, ahead), std::pair(ahead, to)})
    arcs.push_back(*moved(Vector<Polynomial>{Polynomial{x}, {y}, {z}}, {1},
                          vector_at(gauge, between(gauge, a, b)), d));
  return arcs;
}

}  // namespace

struct GaugeOffsets::State {
  Path path;
  bool is_closed;
  Gauge gauge;
  std::vector<std::optional<GaugeParameter>> parameters;  ///< of the segments
};

GaugeOffsets::GaugeOffsets(const Path& path, Gauge gauge) {
  State state{path, path.is_closed(), std::move(gauge), {}};
  const auto& segments = path.segments();
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const RationalCurve* curve = rational_curve(segments[k]);
    const auto fail = [&](const char* reason) {
      throw DomainError(fmt::format(
          "offset: {} {}", segments.size() == 1 ? "the path" : fmt::format("segment {}", k + 1),
          reason));
    };
    if (curve == nullptr) fail("is given by formulas, and no rational curve");
    if (!curve->direction()[2].is_zero()) fail("is in no plane z = const");
    auto found = right_parameter(state.gauge, *curve);
    if (auto* parameter = std::get_if<GaugeParameter>(&found)) {
      state.parameters.emplace_back(std::move(*parameter));
      continue;
    }
    state.parameters.emplace_back();
    none_.push_back(
        {k, std::get<NoGaugeParameter>(found).degrees, offset_kind(*curve, state.gauge)});
  }
  state_ = std::make_shared<const State>(std::move(state));
}

Offset GaugeOffsets::at(const Rational& d, OffsetJoin join) const {
  if (d == 0) throw DomainError("offset: the distance is 0");
  const auto& [path, is_closed, gauge, parameters] = *state_;
  std::vector<OffsetSegment> segments;
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const RationalCurve& curve = *rational_curve(path.segments()[k]);
    const auto e1 = [&](const Rational& t) -> PlaneDirection {
      return {curve.direction()[0](t), curve.direction()[1](t)};
    };
    segments.push_back({std::nullopt, point(curve, 0), e1(0), e1(1),
                        sign_after_zero(curve.multiplier()), sign_changes(curve.multiplier())});
    if (!parameters[k]) continue;
    segments[k].curve =
        moved(curve.numerator(), curve.weight(), vector_at(gauge, *parameters[k]), d);
    if (segments[k].curve) segments[k].curve = with_direction(*segments[k].curve, e1(0));
  }
  const auto at_corner = [&, &parameters = parameters, &gauge = gauge](
                             const PlaneCorner& corner, std::size_t before, std::size_t after) {
    std::vector<RationalCurve> pieces;
    if (join == OffsetJoin::open || !parameters[before] || !parameters[after]) return pieces;
    const GaugeParameter from = parameter_at(*parameters[before], 1);
    const GaugeParameter to = parameter_at(*parameters[after], 0);
    if (join == OffsetJoin::round) {
      const auto& [x, y, z] = corner.at;
      const GaugeVector arc = vector_at(gauge, between(gauge, from, to));
      pieces.push_back(*moved(Vector<Polynomial>{Polynomial{x}, {y}, {z}}, {1}, arc, d));
    } else {
      pieces = mitre(corner, value(gauge, from), value(gauge, to), d);
    }
    for (RationalCurve& piece : pieces)
      if (corner.sign < 0) piece = piece.turned_over();
    return pieces;
  };
  return joined_offset(d, std::move(segments), is_closed, at_corner);
}

std::vector<RationalCurve> GaugeOffsets::end_cap(const Rational& d) const {
  const RationalCurve& curve = *rational_curve(state_->path.segments().back());
  const GaugeParameter from = parameter_at(*state_->parameters.back(), 1);
  return half_around(state_->gauge, point(curve, 1), from, opposite(state_->gauge, from), d,
                     sign_before_one(curve.multiplier()));
}

std::vector<RationalCurve> GaugeOffsets::start_cap(const Rational& d) const {
  const RationalCurve& curve = *rational_curve(state_->path.segments().front());
  const GaugeParameter to = parameter_at(*state_->parameters.front(), 0);
  return half_around(state_->gauge, point(curve, 0), opposite(state_->gauge, to), to, d,
                     sign_after_zero(curve.multiplier()));
}

}  // namespace phrame
