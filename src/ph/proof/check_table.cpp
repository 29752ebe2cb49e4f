// The law of the page wants f₂ = cos(θ + φ)e₂ + sin(θ + φ)e₃ for all θ within the radius of a
// claim. There |f₂ − exact| is at most √2·√2·(radius + rounding) in each component, as it is
// computed there, which is less than 3 radius + 10⁻⁹⁰⁰.
#include "phrame/ph/proof/check_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/place.hpp"
#include "phrame/ph/frame/path_frame.hpp"
#include "phrame/ph/proof/check_weight.hpp"
#include "phrame/ph/proof/integral_laws.hpp"
#include "phrame/ph/proof/path_certificate.hpp"
#include "phrame/ph/proof/verify_integral.hpp"

namespace phrame::inline v0 {
namespace {

bool is_next_double(const Rational& entry, const Real& exact, const Rational& slack) {
  const double given = round_to_double(Real(entry));
  if (slack == 0) return given == round_to_double(exact);
  const RealBall around(slack, 64);
  for (long bits = 128; bits <= 4096; bits *= 2) {
    const RealBall ball = widened(exact.enclose(bits), around);
    if (const auto found = common_double(ball)) return given == *found;
  }
  return false;
}

}  // namespace

const std::vector<std::string>& certified_columns() {
  static const std::vector<std::string> names{"t",   "x",   "y",   "z",   "e1x", "e1y", "e1z",
                                              "f2x", "f2y", "f2z", "f3x", "f3y", "f3z"};
  return names;
}

namespace {

/// Rows at the t of the claims about a path; where the angle is 0 they follow without it.
std::string objection_to_rows(const PathAngle& angle, const std::vector<AngleClaim>& claims,
                              const std::function<bool(const Rational& t)>& is_zero,
                              const std::vector<std::vector<Rational>>& rows) {
  if (rows.size() != claims.size())
    return fmt::format("it has {} rows, and there are {} angles", rows.size(), claims.size());
  const Path& path = angle.path();
  const Vector<Real> first = tangent(path, {0, Rational(0)});
  if (first[0].exact() == Rational(-1)) return "the tangent at the start is -x";
  const StartAngle start = start_angle(LeastRotation(), angle);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const AngleClaim& claim = claims[k];
    if (!goes_on(path) && (claim.t < 0 || claim.t > path.end())) return "a t is not on the path";
    const PathParameter place = locate(path, claim.t);
    const Place at{place.segment, place.t};
    const bool is_exact =
        is_zero(claim.t) || (parse_rational(claim.theta) == 0 && parse_rational(claim.radius) == 0);
    if (!is_exact && parse_rational(claim.radius) >= 1)
      return fmt::format("the angle is known to {} only", claim.radius);
    const Rational slack =
        is_exact ? Rational(0) : 3 * parse_rational(claim.radius) + power_of_ten(-900);
    const Frame<Real> frame = rotation_minimizing_frame(angle, at, start);
    const Frame<Real> reference = reference_frame(angle, at);
    const Vector<Real> r = position(path, at);
    const Vector<Real>* vectors[]{&r, &frame.e1, &frame.e2, &frame.e3};
    for (std::size_t i = 0; i < certified_columns().size(); ++i) {
      const std::size_t axis = (i + 2) % 3;
      const Real exact = i == 0 ? Real(claim.t) : (*vectors[(i - 1) / 3])[axis];
      const bool needs_angle = i >= 7 && !(reference.e2[axis].exact() == Rational(0) &&
                                           reference.e3[axis].exact() == Rational(0));
      // To another frame a number that is not known exactly may be 0.
      const bool may_be_0 = angle.reference() == Reference::up && !exact.exact();
      const Rational least = may_be_0 && i >= 4 ? power_of_ten(-900) : Rational(0);
      if (!is_next_double(rows[k][i], exact, needs_angle ? std::max(slack, least) : least))
        return fmt::format("row {}, {} is not proved to be the double next to the exact number",
                           k + 1, certified_columns()[i]);
    }
  }
  return "";
}

std::string objection_to_rows_by_erf(const Path& path, const std::vector<AngleClaim>& claims,
                                     const std::function<bool(const Rational& t)>& is_zero,
                                     const std::vector<std::vector<Rational>>& rows) {
  if (sign_after_zero(ph_curve(path.segments().front())->multiplier()) < 0)
    return "the multiplier is negative at the start";
  return objection_to_rows(PathAngle(path, Reference::euler_rodrigues), claims, is_zero, rows);
}

/// Is the angle 0 at t, since nothing has turned?
bool is_still_at(const IntegralCertificate& c, const Rational& t) {
  std::optional<DirectedCurve> before;
  for (std::size_t k = 0; k < c.segments.size() && Rational(static_cast<long>(k)) <= t; ++k) {
    DirectedCurve curve = directed_curve(c.segments[k]);
    if (before) objection_to_joint(c, k, *before, curve);
    if (curve.turn.exact() != Rational(0)) return false;
    if (t == Rational(static_cast<long>(k))) return true;
    const auto f = integrand(c, k, curve);
    const auto* rate = std::get_if<RootQuotient>(&f);
    if (rate == nullptr || !rate->numerator.is_zero()) return false;
    before = std::move(curve);
  }
  return true;
}

}  // namespace

std::string objection_to_table(const Certificate& c,
                               const std::vector<std::vector<Rational>>& rows) {
  if (c.reference != Reference::euler_rodrigues) return "the angles are those to the Frenet frame";
  if (!objection_to_weight(c.curve).empty()) return "rests on the weight";
  const auto is_zero = [&](const Rational& t) { return t == 0 || c.rate.numerator.is_zero(); };
  return objection_to_rows_by_erf(Path(c.curve), c.claims, is_zero, rows);
}

std::string objection_to_table(const IntegralCertificate& c,
                               const std::vector<std::vector<Rational>>& rows) {
  if (has_formulas(c)) return "there are none of curves by formulas";
  if (c.frame != Reference::up) return "the angles are not those to the frame of a vector";
  const auto path = path_of(c);
  if (const auto* objection = std::get_if<std::string>(&path)) return *objection;
  const auto is_zero = [&](const Rational& t) { return is_still_at(c, t); };
  try {
    return objection_to_rows(PathAngle(std::get<Path>(path), c.up), c.angles, is_zero, rows);
  } catch (const DomainError& error) {
    return error.what();
  }
}

std::string objection_to_table(const PathCertificate& c,
                               const std::vector<std::vector<Rational>>& rows) {
  for (const Certificate& segment : c.segments)
    if (!objection_to_weight(segment.curve).empty()) return "rests on the weight";
  const auto path = path_of(c);
  if (const auto* objection = std::get_if<std::string>(&path)) return *objection;
  const auto turning = std::ranges::find_if(
      c.segments, [](const Certificate& segment) { return !segment.rate.numerator.is_zero(); });
  const auto is_zero = [zero_to = Rational(static_cast<long>(turning - c.segments.begin()))](
                           const Rational& t) { return t <= zero_to; };
  return objection_to_rows_by_erf(std::get<Path>(path), c.claims, is_zero, rows);
}

}  // namespace phrame
