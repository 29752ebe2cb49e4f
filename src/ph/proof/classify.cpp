#include "phrame/ph/proof/classify.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/along/rmf_angle.hpp"
#include "phrame/ph/curve/direction_span.hpp"
#include "phrame/ph/curve/hodograph_fraction.hpp"
#include "phrame/ph/curve/special_points.hpp"

namespace phrame::inline v0 {
namespace {

const Interval unit_interval = closed_interval(0, 1);

void check(bool holds, std::string_view what) {
  if (!holds) throw Error(fmt::format("classify: the check failed, {}", what));
}

bool are_all_roots(const std::vector<RealRoot>& roots, const Polynomial& p) {
  for (const RealRoot& root : roots)
    if (!is_root(p, root.at)) return false;
  return static_cast<long>(roots.size()) == count_real_roots(p, unit_interval);
}

void check(const RationalFrame& frame, const QuaternionPolynomial& a) {
  const QuaternionPolynomial& b = frame.preimage;
  check(twist_numerator(b).is_zero(), "the rational frame is not rotation-minimizing");
  const Vector<Polynomial> x = rotated_i(a);
  const Vector<Polynomial> y = rotated_i(b);
  for (std::size_t k = 0; k < 3; ++k)
    check(sigma(b) * x[k] == sigma(a) * y[k], "the rational frame has another tangent");
}

/// Line, plane and helix, of a curve or of the path that it is part of.
template <class AnyClassification>
void check_shape(const AnyClassification& c, const QuaternionPolynomial& a) {
  const Vector<Polynomial> r = rotated_i(a);
  if (c.line)
    for (std::size_t k = 0; k < 3; ++k)
      check((*c.line)[k] * r[(k + 1) % 3] == (*c.line)[(k + 1) % 3] * r[k], "line");
  if (c.normal) check(dot(*c.normal, r).is_zero(), "normal");
  if (c.helix) check(dot(c.helix->axis, r) == c.helix->constant * sigma(a), "helix");
}

/// The first and the last leg have one angle to the middle one, and that between them by the law of
/// cosines on the sphere.
void check(const ControlCone& cone, const Curve& curve) {
  const std::vector<Vector<Rational>> points = control_points(curve);
  const auto product = [&](std::size_t j, std::size_t k) {
    return dot(points[j + 1] - points[j], points[k + 1] - points[k]);
  };
  const Rational cosine_squared = cone.cosine_squared;
  for (const std::size_t k : {0, 2}) {
    const Rational along = product(k, 1);
    check(along * along == cosine_squared * product(k, k) * product(1, 1) &&
              (along < 0) == cone.is_obtuse,
          "control cone");
  }
  const Rational cosine = cosine_squared + (1 - cosine_squared) * cone.azimuth_cosine;
  const Rational between = product(0, 2);
  check(between * between == cosine * cosine * product(0, 0) * product(2, 2) &&
            (between < 0) == (cosine < 0),
        "azimuth on the control cone");
}

void check(const Classification& c, const Curve& curve) {
  const QuaternionPolynomial& a = curve.preimage();
  check(are_all_roots(c.cusps, curve.multiplier() * sigma(a)), "cusps");
  check_shape(c, a);
  if (c.control_cone) check(*c.control_cone, curve);
  if (c.double_ph) check(rho(a) == c.double_ph->constant * pow(c.double_ph->omega, 2), "double PH");
  Polynomial common;
  for (const Polynomial& component : hodograph_fraction(curve).numerator)
    common = gcd(common, exact_quotient(component, c.content));
  check(common.is_constant(), "content");
  if (const auto* frame = std::get_if<RationalFrame>(&c.rational_frame)) check(*frame, a);
  const Polynomial twist = rate_to_erf(a).numerator();
  if (!twist.is_zero()) check(are_all_roots(c.erf_turning.zeros, twist), "zeros of h");
}

}  // namespace

Classification classify(const Curve& curve) {
  const QuaternionPolynomial& a = curve.preimage();
  const Classification result{cusps(curve),
                              inflections(a),
                              line_direction(a),
                              plane_normal(a),
                              helix(a),
                              control_cone(curve),
                              double_ph(a),
                              hodograph_content(curve),
                              twist_numerator(a).is_zero(),
                              rational_frame(a),
                              erf_turning(curve)};
  check(result, curve);
  return result;
}

namespace {

/// What PH curves have as a whole.
void add_shape(PathClassification& result, const PhPath& path) {
  if (path.is_curve()) {
    const Classification& curve = *result.segments.front();
    result.line = curve.line;
    result.normal = curve.normal;
    result.helix = curve.helix;
    return;
  }
  result.line = line_direction(path);
  result.normal = plane_normal(path);
  result.helix = helix(path);
  for (const Curve& curve : path.segments()) check_shape(result, curve.preimage());
}

void add_shape(PathClassification& result, const Path& path) {
  result.erf_is_rotation_minimizing = false;
  const auto span = direction_span(path);
  if (are_on_a_line(span))
    result.line = span.front();
  else
    result.normal = common_normal(span);
}

}  // namespace

PathClassification classify(const Path& path) {
  PathClassification result;
  for (const Segment& segment : path.segments()) {
    const Curve* curve = ph_curve(segment);
    const auto& kinds =
        result.segments.emplace_back(curve ? std::optional(classify(*curve)) : std::nullopt);
    if (!(kinds ? kinds->cusps : cusps(segment)).empty()) result.is_regular = false;
    if (kinds && !kinds->erf_is_rotation_minimizing) result.erf_is_rotation_minimizing = false;
  }
  if (const auto ph = path.ph())
    add_shape(result, *ph);
  else
    add_shape(result, path);
  return result;
}

}  // namespace phrame
