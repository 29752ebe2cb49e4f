#include "phrame/ph/construct/near.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/progress.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/construct/exact_fit.hpp"
#include "phrame/ph/construct/preimage.hpp"
#include "phrame/ph/construct/rmf_difference.hpp"
#include "phrame/ph/curve/end_point.hpp"
#include "phrame/ph/curve/scale.hpp"

namespace phrame::inline v0 {
namespace {

void require_near_degree(std::size_t points) {
  const long n = static_cast<long>(points) - 1;
  if (n > max_near_degree)
    throw DomainError(fmt::format("PH curve nearby: the degree of the curve is {}, the limit is {}",
                                  n, max_near_degree));
}

void require_positive(const Rational& epsilon) {
  if (epsilon <= 0)
    throw DomainError(
        fmt::format("PH curve nearby: the distance {} is not positive", as_written(epsilon)));
}

PreimageFit fit_of_points(const BezierPoints& points, long scale) {
  std::vector<Vector<Rational>> from_first;
  for (std::size_t k = 1; k < points.size(); ++k) from_first.push_back(points[k] - points[0]);
  return best_fit(scaled_down(bezier_derivatives(points), scale), scaled_down(from_first, scale));
}

bool is_within(const Rational& squared_distance, const Rational& epsilon) {
  return squared_distance <= epsilon * epsilon;
}

/// What is known of a curve before it is rounded.
struct FineFit {
  BezierPoints points;
  long scale;
  MeasuredFit fit;
};

/// A fit in doubles is not the best one: that may be so many times nearer.
const Rational most_refined(4);

/// No value where the best fit is farther than that.
std::optional<FineFit> fine_fit(const Vector<Polynomial>& hodograph, const Vector<Rational>& start,
                                const std::optional<Rational>& most = std::nullopt) {
  if (hodograph == Vector<Polynomial>{})
    throw DomainError("PH curve nearby: the hodograph is zero, so the curve is a point");
  FineFit result{bezier_points(hodograph, start), 0, {}};
  require_near_degree(result.points.size());
  result.scale = scale_of(result.points);
  const PreimageFit guess = fit_of_points(result.points, result.scale);
  const ExactFit fit = exact_fit(guess, result.scale);
  if (most && !is_within(squared_distance(fit, start, result.points), most_refined * *most))
    return std::nullopt;
  result.fit = refined(fit, FitStep(guess, FreePart::all), FreePart::all, result.scale, start,
                       result.points);
  return result;
}

/// How far the farthest control point is from the start, in one coordinate.
Rational size_of(const BezierPoints& points) {
  Rational size = 0;
  for (const auto& p : points) size = std::max(size, largest(p - points.front()));
  return size;
}

/// What make(bits) has a value of, with the fewest bits, by halving from those of the best so far;
/// `bits` becomes theirs.
template <class T, class Make>
T with_fewest_bits(T best, long& bits, const Make& make) {
  for (long low = -1; bits - low > 1;) {
    const long middle = low + (bits - low) / 2;
    if (std::optional<T> next = make(middle)) {
      best = *std::move(next);
      bits = middle;
    } else {
      low = middle;
    }
  }
  return best;
}

/// With the fewest bits that keep it within ε, as it is given.
MeasuredFit shortest(const FineFit& fine, const Rational& epsilon) {
  long bits = fine.fit.bits;
  return with_fewest_bits(fine.fit, bits, [&](long fewer) -> std::optional<MeasuredFit> {
    MeasuredFit next{rounded(fine.fit.fit, fine.scale, fewer, FreePart::all), 0, fewer};
    if (is_point(next.fit)) return std::nullopt;
    next.squared_distance = squared_distance(next.fit, fine.points.front(), fine.points);
    if (!is_within(next.squared_distance, epsilon)) return std::nullopt;
    return next;
  });
}

/// The hodographs of a curve given and of the one in its place.
HodographPair hodograph_pair(const BezierPoints& given, const Curve& curve) {
  return {bezier_derivatives(given),
          bezier_derivatives(control_points_in_degree(curve, given.size() - 1))};
}

/// √x as a bound to print, and not above ε where x is not above ε².
Rational distance_of(const Rational& squared, const Rational& epsilon) {
  return std::min(square_root_above(squared), epsilon);
}

/// |r′(t)|, from the Bernstein coefficients of r′.
double speed_at(std::vector<Vector<double>> hodograph, double t) {
  for (std::size_t left = hodograph.size() - 1; left > 0; --left)
    for (std::size_t k = 0; k < left; ++k)
      hodograph[k] = (1 - t) * hodograph[k] + t * hodograph[k + 1];
  return std::sqrt(dot(hodograph[0], hodograph[0]));
}

/// Is |r′| > least all along? Told by steps as far as its greatest slope allows.
bool is_faster(const std::vector<Vector<double>>& hodograph, double least) {
  double square = 0;
  for (std::size_t k = 0; k + 1 < hodograph.size(); ++k) {
    const auto slope = hodograph[k + 1] - hodograph[k];
    square = std::max(square, dot(slope, slope));
  }
  const double slope = std::sqrt(square) * static_cast<double>(hodograph.size() - 1);
  constexpr double least_step = 0x1p-8;
  for (double t = 0; t < 1;) {
    const double room = speed_at(hodograph, t) - least;
    if (!(room > least_step * slope)) return false;
    t += room / slope;
  }
  return true;
}

/// Are all PH curves of degree n from the same start seen to be farther than that from the curve
/// with these n Bernstein coefficients of r′? If one has control points no farther, its |f|σ is
/// within ε = 2n·most of |r′|. If |r′| > ε, f has no zero, so that |f|σ is a polynomial of degree
/// n − 1, and with alternating signs its values at the n + 1 extrema of Chebyshev's polynomial, of
/// which the first and the last are halved, add up to 0: those of |r′| to nε at most. The other
/// percent is for rounding.
bool is_far_from_ph(const std::vector<Vector<double>>& hodograph, double most) {
  const auto n = static_cast<double>(hodograph.size());
  const double epsilon = 1.01 * 2 * n * most;
  double sum = 0;
  for (std::size_t k = 0; k <= hodograph.size(); ++k) {
    const double t = (1 - std::cos(std::numbers::pi * static_cast<double>(k) / n)) / 2;
    const double weight = k == 0 || k == hodograph.size() ? 0.5 : 1;
    sum += (k % 2 == 0 ? weight : -weight) * speed_at(hodograph, t);
  }
  return std::abs(sum) > n * epsilon && is_faster(hodograph, epsilon);
}

/// A spline in doubles, each A divided by 2ᵉ, and what its joints are to be: the ends of A on both
/// sides in one direction, the later one `ratio` times the former.
struct SplineFit {
  long scale = 0;
  std::vector<PreimageFit> segments;
  std::vector<Quaternion<double>>
      joints;                  ///< the ends of A before joint k and, last, of the spline
  std::vector<double> ratios;  ///< at joint k
};

/// Both are constants, and the speeds are as equal as points known to within ε can tell.
bool is_differentiable(const PreimageFit& before, const PreimageFit& after, std::size_t points,
                       double epsilon) {
  if (before.multiplier.size() > 1 || after.multiplier.size() > 1) return false;
  const double difference = norm(before.preimage.back()) - norm(after.preimage.front());
  return std::abs(difference) <= 8 * epsilon * static_cast<double>(points);
}

/// |H|/(|A||B|) of the ends of A and B is the cosine of half the angle between their tangents.
constexpr double most_turn = 0.1;

/// Throws DomainError where the curves that are given have no one tangent between segments k and
/// k + 1, up to that angle.
void require_one_tangent(const std::vector<BezierPoints>& curves, std::size_t k) {
  const Vector<Rational> last = bezier_derivatives(curves[k]).back();
  const Vector<Rational> first = bezier_derivatives(curves[k + 1]).front();
  const auto fail = [k](const char* what) {
    throw DomainError(fmt::format("PH curve nearby: {} where segment {} begins", what, k + 2));
  };
  const Rational squares = dot(last, last) * dot(first, first);
  if (squares == 0) fail("there is a cusp");
  const Rational product = dot(last, first);
  if (product <= 0 ||
      static_cast<double>(Rational(product * product / squares)) < std::pow(std::cos(most_turn), 2))
    fail("the tangent breaks");
}

/// Turns the segment behind joint k to the one before it, and says what the joint is: true, or
/// false where they do not join though the curves that are given do.
bool join(SplineFit& spline, std::size_t k, const std::vector<BezierPoints>& curves,
          double epsilon) {
  const PreimageFit& before = spline.segments[k];
  PreimageFit& after = spline.segments[k + 1];
  if (before.multiplier.back() < 0) {  // A j i (A j)* = −A i A*
    for (auto& a : after.preimage) a = a * Quaternion<double>{0, 0, 1, 0};
    for (double& f : after.multiplier) f = -f;
  }
  const auto& end = before.preimage.back();
  const auto product = hermitian_product(end, after.preimage.front());
  const double size = std::hypot(product.re, product.im);
  const double sizes = std::sqrt(norm(end) * norm(after.preimage.front()));
  constexpr double tiny = 1e-8;
  if (!(sizes > tiny) || size < std::cos(most_turn / 2) * sizes) {
    require_one_tangent(curves, k);
    return false;
  }
  for (auto& a : after.preimage)
    a = turned(a, ComplexOf<double>{product.re / size, -product.im / size});
  const double ratio = is_differentiable(before, after, curves[k].size(), epsilon)
                           ? 1
                           : std::sqrt(norm(after.preimage.front()) / norm(end));
  spline.ratios.push_back(ratio);
  const auto behind = (1 / ratio) * after.preimage.front();
  if (after.preimage.size() == 1 && before.preimage.size() > 1)
    spline.joints.push_back(behind);  // a line has one direction
  else if (before.preimage.size() == 1)
    spline.joints.push_back(end);
  else
    spline.joints.push_back(0.5 * (end + behind));
  return true;
}

/// What is not near where a segment by itself is too far from any, or those near them do not join.
std::variant<SplineFit, NotNear> spline_fit(const std::vector<BezierPoints>& curves,
                                            const Rational& epsilon) {
  SplineFit spline;
  spline.scale = scale_of(curves.front());
  for (const BezierPoints& points : curves) spline.scale = std::max(spline.scale, scale_of(points));
  Rational farthest = 0;  // squared
  for (const BezierPoints& points : curves) {
    spline.segments.push_back(fit_of_points(points, spline.scale));
    const ExactFit fit = exact_fit(spline.segments.back(), spline.scale);
    farthest = std::max(farthest, squared_distance(fit, points.front(), points));
  }
  const Rational within = most_refined * epsilon;
  if (!is_within(farthest, within)) return NotNear{square_root_above(farthest)};
  const auto scaled_epsilon =
      static_cast<double>(Rational(epsilon * power_of_two(-2 * spline.scale)));
  for (std::size_t k = 0; k + 1 < curves.size(); ++k)
    if (!join(spline, k, curves, scaled_epsilon)) return NotNear{};
  spline.joints.push_back(spline.segments.back().preimage.back());
  return spline;
}

/// A spline with exact joints.
struct MeasuredSpline {
  std::vector<ExactFit> segments;
  std::vector<Vector<Rational>> starts;
  Rational squared_distance;
};

/// With so many bits, as far as it is within ε: no value where it is not.
std::optional<MeasuredSpline> measured_spline(const SplineFit& spline,
                                              const std::vector<FitStep>& steps,
                                              const std::vector<BezierPoints>& curves, long bits,
                                              const std::optional<Rational>& epsilon) {
  const auto to_bits = [&](const Quaternion<double>& a) {
    return rounded_to_places(power_of_two(spline.scale) * exact_quaternion(a), bits - spline.scale);
  };
  MeasuredSpline result;
  Vector<Rational> start = curves.front().front();
  RationalQuaternion first = to_bits(spline.segments.front().preimage.front());
  Stage stage("segments", curves.size());
  for (std::size_t k = 0; k < curves.size(); ++k, stage.advance()) {
    ExactFit fit = exact_fit(spline.segments[k], spline.scale);
    // The ends are the joints', all else is refined and rounded.
    fit.preimage.front() = first;
    if (fit.preimage.size() > 1) fit.preimage.back() = to_bits(spline.joints[k]);
    if (is_point(fit)) return std::nullopt;
    fit = refined(fit, steps[k], FreePart::inner, spline.scale, start, curves[k]).fit;
    fit = rounded(std::move(fit), spline.scale, bits, FreePart::inner);
    if (is_point(fit)) return std::nullopt;
    const Rational distance = squared_distance(fit, start, curves[k]);
    if (epsilon && !is_within(distance, *epsilon)) return std::nullopt;
    result.squared_distance = std::max(result.squared_distance, distance);
    result.starts.push_back(start);
    start = end_point(curve_of(fit, start));
    if (k < spline.ratios.size())
      first = rounded_to_places(exact_rational(spline.ratios[k]), bits) * fit.preimage.back();
    result.segments.push_back(std::move(fit));
  }
  return result;
}

}  // namespace

std::variant<NearCurve, NotNear> near_curve(const Vector<Polynomial>& hodograph,
                                            const Vector<Rational>& start,
                                            const Rational& epsilon) {
  require_positive(epsilon);
  const FineFit fine = fine_fit(hodograph, start).value();
  if (!is_within(fine.fit.squared_distance, epsilon))
    return NotNear{square_root_above(fine.fit.squared_distance)};
  const MeasuredFit found = shortest(fine, epsilon);
  Curve curve = curve_of(found.fit, start);
  const auto bound = rmf_difference_bound({hodograph_pair(fine.points, curve)});
  return NearCurve{
      std::move(curve),
      {distance_of(found.squared_distance, epsilon),
       distance_of(fine.fit.squared_distance, epsilon), found.bits - fine.scale, bound, epsilon}};
}

std::optional<NearSuggestion> near_suggestion(const Vector<Polynomial>& hodograph,
                                              const Vector<Rational>& start) {
  constexpr long most_degree = 45;
  const Rational least_share(1, 1000);
  for (const Polynomial& p : hodograph)
    if (p.degree() >= most_degree) return std::nullopt;
  const BezierPoints points = bezier_points(hodograph, start);
  const Rational size = size_of(points);
  const Rational most = least_share * size;
  const long scale = scale_of(points);
  if (is_far_from_ph(scaled_down(bezier_derivatives(points), scale),
                     static_cast<double>(Rational(most * power_of_two(-2 * scale)))))
    return std::nullopt;
  const auto fine = fine_fit(hodograph, start, most);
  if (!fine) return std::nullopt;
  const Rational distance = square_root_above(fine->fit.squared_distance);
  if (distance == 0 || distance > most) return std::nullopt;
  // A curve that is PH over ℝ has PH curves over ℚ as near as one likes.
  const Rational enough = power_of_ten(decimal_exponent(size) - 30);
  if (10 * distance < enough) return NearSuggestion{enough, enough / 10};
  // The power of ten above it, or the next where little room is left to take bits off.
  Rational epsilon = power_of_ten(decimal_exponent(distance) + 1);
  if (distance > Rational(9, 10) * epsilon) epsilon *= 10;
  return NearSuggestion{epsilon, distance};
}

std::variant<NearPath, NotNear> near_path(const std::vector<BezierPoints>& curves,
                                          const Rational& epsilon) {
  require_positive(epsilon);
  for (const BezierPoints& points : curves) require_near_degree(points.size());
  const auto guess = spline_fit(curves, epsilon);
  if (const auto* none = std::get_if<NotNear>(&guess)) return *none;
  const auto& spline = std::get<SplineFit>(guess);
  std::vector<FitStep> steps;
  for (const PreimageFit& fit : spline.segments) steps.emplace_back(fit, FreePart::inner);
  const auto with_bits = [&](long bits, const std::optional<Rational>& within) {
    return measured_spline(spline, steps, curves, bits, within);
  };
  const long most_bits = std::max(64L, 2 * spline.scale - binary_exponent(epsilon) + 16);
  const auto fine = with_bits(most_bits, std::nullopt);
  if (!fine) throw DomainError("PH curve nearby: a segment shrinks to a point");
  if (!is_within(fine->squared_distance, epsilon))
    return NotNear{square_root_above(fine->squared_distance)};
  long bits = most_bits;
  const MeasuredSpline best =
      with_fewest_bits(*fine, bits, [&](long fewer) { return with_bits(fewer, epsilon); });
  std::vector<HodographPair> pairs;
  std::vector<Curve> exact;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    exact.push_back(curve_of(best.segments[k], best.starts[k]));
    pairs.push_back(hodograph_pair(curves[k], exact.back()));
  }
  return NearPath{
      joined(exact),
      {distance_of(best.squared_distance, epsilon), distance_of(fine->squared_distance, epsilon),
       bits - spline.scale, rmf_difference_bound(pairs), epsilon}};
}

std::variant<NearPath, NotNear> near_path(const Path& path, const Rational& epsilon) {
  std::vector<BezierPoints> curves;
  for (const Segment& segment : path.segments()) {
    const RationalCurve* curve = rational_curve(segment);
    if (curve == nullptr || !curve->weight().is_constant())
      throw DomainError(
          fmt::format("PH curve nearby: segment {} is no polynomial curve", curves.size() + 1));
    curves.push_back(bezier_points(hodograph(*curve), point(*curve, 0)));
  }
  return near_path(curves, epsilon);
}

std::variant<NamedPhPath, NotNear> near_path(const NamedPath& named, const Rational& epsilon) {
  if (auto ph = with_preimages(named)) return *std::move(ph);
  auto found = near_path(named.path, epsilon);
  if (const auto* none = std::get_if<NotNear>(&found)) return *none;
  auto& [path, nearness] = std::get<NearPath>(found);
  return NamedPhPath(named.name, std::move(path), std::move(nearness));
}

}  // namespace phrame
