// A with the coefficients Z is C¹ whatever they are (c2_equations.hpp), so they may be rounded. But
// values at joints, (h⁺Z + hZ⁺)/(h + h⁺), would then have denominators of their own at each joint,
// and the points of the curve, which are sums, ever longer ones. With the steps h_k = n_k·u, n_k
// integers, it is the differences that are rounded instead:
//   Z⁺ = Z + (n + n⁺)E,  J = Z + nE,  A′ = 2E/u at the joint,
// where E is a multiple of 2^−p. Then all coefficients of A are, and r_k is r_0 and a multiple of
// u/(120·4^p). E is what takes Z next to where it is wanted, so that Z is off by (n + n⁺)/2^{p+1}
// at most. The differences of a closed spline have a sum given by Z₀, so the last one is a fraction
// over n + n⁺, and so are the values at the start.
#include "phrame/ph/construct/c2_spline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/construct/c2_equations.hpp"
#include "phrame/ph/construct/exact_end.hpp"
#include "phrame/ph/construct/preimage_grid.hpp"
#include "phrame/ph/construct/refine.hpp"
#include "phrame/ph/construct/spline_builder.hpp"

namespace phrame::inline v0 {
namespace {

/// The Bernstein coefficients of A, over one denominator.
struct LatticeSpline {
  std::vector<IntegerQuaternion> joints;   ///< N + 1
  std::vector<IntegerQuaternion> middles;  ///< N
  Rational step;                           ///< times this
};

/// 2^p·z, rounded.
IntegerQuaternion on_lattice(const RationalQuaternion& z, long p) {
  return each(z, [scale = power_of_two(p)](const Rational& x) {
    return floor(scale * x + Rational(1, 2));
  });
}

IntegerQuaternion rounded_quotient(const IntegerQuaternion& a, const Integer& n) {
  return each(a, [&](const Integer& x) { return floor(Rational(2 * x + n, 2 * n)); });
}

/// The points wanted, and all that is computed of them once.
class C2Problem {
 public:
  explicit C2Problem(const HermiteSpline& data)
      : data_(data),
        n_(data.segments()),
        units_(scaled(data)),
        common_(parameter_steps(units_.data)) {}

  std::optional<Construction> run(const Deviation& tolerance, PointRule rule, bool is_plane) const;

 private:
  C2Data in_doubles(bool is_plane) const;
  LatticeSpline lattice_spline(const std::vector<RationalQuaternion>& z, const Integer& sign,
                               long p) const;
  /// 120/(u·step²) times the chords of the spline.
  std::vector<Vector<Integer>> chords(const LatticeSpline& spline) const;
  /// What the chords lack and, times steps, the derivatives at the ends of an open spline.
  std::vector<Rational> defect(const LatticeSpline& spline, std::size_t dimension) const;
  /// The segment that turns most: a closed spline goes wrong there, and is made to end where the
  /// next one begins.
  std::size_t adjusted_segment(const LatticeSpline& spline) const;
  /// From the start on up to that segment, and from the end back to it.
  std::vector<Vector<Rational>> joints_of(const LatticeSpline& spline, std::size_t adjusted) const;
  std::optional<Construction> within(const Deviation& tolerance, const LatticeSpline& spline,
                                     PointRule rule, long p) const;
  long first_places(const Deviation& tolerance) const;

  const HermiteSpline& data_;
  std::size_t n_;
  ScaledSpline units_;     ///< in which the spline is found
  ParameterSteps common_;  ///< in these
};

C2Data C2Problem::in_doubles(bool is_plane) const {
  C2Data result;
  const HermiteSpline& data = units_.data;
  for (std::size_t k = 0; k < n_; ++k) {
    result.steps.push_back(static_cast<double>(data.step(k)));
    result.chords.push_back(scaled_to_doubles(1, data.points[k + 1] - data.points[k]));
  }
  for (const Vector<Rational>& d : data.derivatives)
    result.derivatives.push_back(scaled_to_doubles(1, d));
  result.is_closed = data.is_closed;
  result.is_plane = is_plane;
  return result;
}

LatticeSpline C2Problem::lattice_spline(const std::vector<RationalQuaternion>& z,
                                        const Integer& sign, long p) const {
  const std::vector<Integer>& n = common_.counts;
  LatticeSpline result;
  result.step = power_of_two(-p);
  IntegerQuaternion at = on_lattice(z[0], p);
  const auto go_on = [&](const Integer& before, const Integer& after,
                         const RationalQuaternion& wanted) {
    const Integer sum = before + after;
    const IntegerQuaternion e = rounded_quotient(on_lattice(wanted, p) - at, sum);
    result.joints.push_back(at + before * e);
    at = at + sum * e;
  };
  if (!data_.is_closed) {
    for (std::size_t k = 0; k <= n_; ++k) {
      go_on(n[k > 0 ? k - 1 : 0], n[k < n_ ? k : n_ - 1], z[k + 1]);
      if (k < n_) result.middles.push_back(at);
    }
    return result;
  }
  result.middles.push_back(at);
  for (std::size_t k = 1; k < n_; ++k) {
    go_on(n[k - 1], n[k], z[k]);
    result.middles.push_back(at);
  }
  // Over the denominator of what closes it.
  const Integer sum = n.back() + n.front();
  const IntegerQuaternion last = sum * at + n.back() * (sign * result.middles.front() - at);
  for (auto* list : {&result.joints, &result.middles})
    for (IntegerQuaternion& a : *list) a = sum * a;
  result.joints.insert(result.joints.begin(), sign * last);
  result.joints.push_back(last);
  result.step /= sum;
  return result;
}

std::vector<Vector<Integer>> C2Problem::chords(const LatticeSpline& spline) const {
  std::vector<Vector<Integer>> result;
  for (std::size_t k = 0; k < n_; ++k) {
    const IntegerQuaternion& a = spline.joints[k];
    const IntegerQuaternion& c = spline.joints[k + 1];
    result.push_back(common_.counts[k] * integral_times_120(a, spline.middles[k], c));
  }
  return result;
}

std::vector<RationalQuaternion> to_quaternions(const std::vector<Rational>& parts, bool is_plane) {
  std::vector<RationalQuaternion> z;
  for (std::size_t k = 0; k < parts.size(); k += is_plane ? 2 : 4)
    z.push_back(is_plane ? RationalQuaternion{parts[k], 0, 0, parts[k + 1]}
                         : RationalQuaternion{parts[k], parts[k + 1], parts[k + 2], parts[k + 3]});
  return z;
}

/// Without the last digits, which are those of the doubles' rounding.
std::vector<Rational> to_parts(const std::vector<Quaternion<double>>& z, bool is_plane) {
  constexpr long places = 40;
  std::vector<Rational> parts;
  const auto put = [&](double x) { parts.push_back(rounded_to_places(exact_rational(x), places)); };
  for (const auto& [u, v, p, q] : z) {
    put(u);
    if (!is_plane) {
      put(v);
      put(p);
    }
    put(q);
  }
  return parts;
}

std::vector<Rational> C2Problem::defect(const LatticeSpline& spline, std::size_t dimension) const {
  const HermiteSpline& data = units_.data;
  const Rational square = spline.step * spline.step;
  std::vector<Rational> result;
  const auto put = [&](const Vector<Rational>& v) {
    result.insert(result.end(), v.begin(), v.begin() + static_cast<long>(dimension));
  };
  const auto put_end = [&](const Rational& h, std::size_t k) {
    if (!data.is_closed)
      put(h * (exact(rotated_i(spline.joints[k]), square) - data.derivatives[k]));
  };
  put_end(data.step(0), 0);
  const std::vector<Vector<Integer>> found = chords(spline);
  for (std::size_t k = 0; k < n_; ++k)
    put(exact(found[k], common_.unit * square / 120) - (data.points[k + 1] - data.points[k]));
  put_end(data.step(n_ - 1), n_);
  return result;
}

long C2Problem::first_places(const Deviation& tolerance) const {
  constexpr long least = 40;
  if (tolerance.points == 0) return least;
  long longest = 0;
  for (const Integer& count : common_.counts) longest = std::max(longest, bit_length(count));
  return std::max(least, longest + bit_length(Integer(n_)) + 2 -
                             binary_exponent(units_.scales[0] * tolerance.points));
}

std::optional<Construction> C2Problem::run(const Deviation& tolerance, PointRule rule,
                                           bool is_plane) const {
  constexpr int most_passes = 20;
  const C2Data data = in_doubles(is_plane);
  const auto guess = c2_coefficients(data);
  if (!guess) return std::nullopt;
  const ParameterStep step = c2_step(data, *guess);
  const Integer sign = guess->closing_sign < 0 ? -1 : 1;
  std::vector<Rational> parts = to_parts(guess->z, is_plane);
  return first_within(tolerance, first_places(tolerance), most_passes, [&](long p) {
    const auto spline_with = [&](const std::vector<Rational>& parameters) {
      return lattice_spline(to_quaternions(parameters, is_plane), sign, p);
    };
    const ExactDefect lacking = [&](const std::vector<Rational>& parameters) {
      return defect(spline_with(parameters), is_plane ? 2 : 3);
    };
    parts = refine(std::move(parts), lacking, step, p).parameters;
    return within(tolerance, spline_with(parts), rule, p);
  });
}

/// Of the angle between the tangents.
double cosine_between(const IntegerQuaternion& a, const IntegerQuaternion& c) {
  const Vector<Integer> t0 = rotated_i(a);
  const Vector<Integer> t1 = rotated_i(c);
  const Integer sizes = norm(a) * norm(c);
  return sizes == 0 ? -1 : static_cast<double>(Rational(dot(t0, t1), sizes));
}

std::size_t C2Problem::adjusted_segment(const LatticeSpline& spline) const {
  const auto cosine = [&](std::size_t k) {
    return cosine_between(spline.joints[k], spline.joints[k + 1]);
  };
  std::size_t result = 0;
  for (std::size_t k = 1; k < n_; ++k)
    if (cosine(k) < cosine(result)) result = k;
  return result;
}

std::vector<Vector<Rational>> C2Problem::joints_of(const LatticeSpline& spline,
                                                   std::size_t adjusted) const {
  const std::vector<Vector<Integer>> moves = chords(spline);
  const Rational scale = common_.unit * spline.step * spline.step / (120 * units_.scales[0]);
  std::vector<Vector<Rational>> result(n_ + 1, data_.points.front());
  Vector<Integer> sum{};
  for (std::size_t k = 0; k < std::min(adjusted, n_); ++k) {
    sum = sum + moves[k];
    result[k + 1] = result[0] + exact(sum, scale);
  }
  sum = {};
  for (std::size_t k = n_; k > adjusted + 1; --k) {
    sum = sum - moves[k - 1];
    result[k - 1] = result[n_] + exact(sum, scale);
  }
  return result;
}

std::optional<Construction> C2Problem::within(const Deviation& tolerance,
                                              const LatticeSpline& spline, PointRule rule,
                                              long p) const {
  const Rational& root = units_.root;
  const Rational step = spline.step * root;
  const std::size_t adjusted = data_.is_closed ? adjusted_segment(spline) : n_;
  const std::vector<Vector<Rational>> joints = joints_of(spline, adjusted);
  DeviationMeter meter(tolerance);
  for (std::size_t k = 0; k <= n_; ++k) meter.point(joints[k] - data_.points[k]);
  if (!data_.is_closed)
    for (const std::size_t k : {std::size_t{0}, n_})
      meter.derivative(exact(rotated_i(spline.joints[k]), step * step) - data_.derivatives[k]);
  PreimageSpline found{{}, root, p - binary_exponent(root), meter.deviation()};
  if (!is_within(found.deviation, tolerance)) return std::nullopt;
  const auto in_fractions = [&](const IntegerQuaternion& a) { return exact(a, spline.step); };
  for (std::size_t k = 0; k < n_; ++k)
    found.segments.push_back({{in_fractions(spline.joints[k]), in_fractions(spline.middles[k]),
                               in_fractions(spline.joints[k + 1])},
                              data_.step(k),
                              joints[k]});
  const auto sixths = [p](const BernsteinPreimage& a, const Vector<Rational>& integral) {
    return listed(exact_sixths({a[0], a[1], a[2]}, integral, p));
  };
  return construction_of(found, {sixths, adjusted}, data_, rule);
}

bool is_plane(const Vector<Rational>& v) { return v[2] == 0; }

/// What may be the reason that none was found.
std::string trouble(const HermiteSpline& data) {
  std::vector<Rational> chords;
  std::vector<Rational> speeds;
  for (std::size_t k = 0; k < data.segments(); ++k) {
    const Rational chord = largest(data.points[k + 1] - data.points[k]);
    if (chord == 0) continue;
    chords.push_back(chord);
    speeds.push_back(chord / data.step(k));
  }
  const auto differ = [](const std::vector<Rational>& list, const Rational& factor) {
    const auto [least, greatest] = std::ranges::minmax_element(list);
    return least != list.end() && *greatest > factor * *least;
  };
  if (differ(speeds, 1'000)) return "; the parameters are far from the lengths of the chords";
  if (differ(chords, 1'000'000)) return "; the lengths of the chords are very different";
  return "";
}

/// A and its derivative by the parameter.
struct MovingPreimage {
  RationalQuaternion a;
  RationalQuaternion rate;
};

/// At t, 0 or 1, of a segment whose multiplier is the step of the parameter.
MovingPreimage in_parameter_at(const Curve& curve, const Rational& t) {
  const auto& [u, v, p, q] = curve.preimage();
  const QuaternionPolynomial slope{differentiate(u), differentiate(v), differentiate(p),
                                   differentiate(q)};
  const Rational h = curve.multiplier().coefficient(0);
  return {evaluate(curve.preimage(), t), Rational(1 / h) * evaluate(slope, t)};
}

/// Are A i A* and its derivative, 2S(A, A′), the same? They are where A and A′ are, as in splines
/// through points; that is cheaper to see.
bool meet_c2(const MovingPreimage& before, const MovingPreimage& after) {
  if (before.a == after.a && before.rate == after.rate) return true;
  return rotated_i(before.a) == rotated_i(after.a) &&
         symmetric_product(before.a, before.rate) == symmetric_product(after.a, after.rate);
}

}  // namespace

Construction c2_spline(const HermiteSpline& data, const Deviation& tolerance, PointRule rule) {
  const std::size_t n = data.segments();
  if (data.is_closed && n < 3)
    throw DomainError("a closed C2 spline wants three different points at least");
  if (!data.is_closed)
    for (const std::size_t k : {std::size_t{0}, n})
      if (largest(data.derivatives[k]) == 0)
        throw DomainError(fmt::format(
            "the derivative at point {} is 0: the C2 spline has no tangent there", k + 1));
  const C2Problem problem(data);
  if (std::ranges::all_of(data.points, is_plane) && std::ranges::all_of(data.derivatives, is_plane))
    if (auto found = problem.run(tolerance, rule, true)) return *std::move(found);
  if (auto found = problem.run(tolerance, rule, false)) return *std::move(found);
  throw Undecided("the C2 spline: Newton's method finds none" + trouble(data));
}

bool is_c2(const PhPath& path, bool is_closed) {
  const std::vector<Curve>& segments = path.segments();
  if (std::ranges::any_of(segments, [](const Curve& c) { return c.multiplier().degree() != 0; }))
    return false;
  for (std::size_t k = 1; k < segments.size(); ++k)
    if (!meet_c2(in_parameter_at(segments[k - 1], 1), in_parameter_at(segments[k], 0)))
      return false;
  return !is_closed ||
         meet_c2(in_parameter_at(segments.back(), 1), in_parameter_at(segments.front(), 0));
}

}  // namespace phrame
