// With c + si = conj(A₀)·A₁, A₀ at the start and A₁ at the end without their zeros, the
// Euler–Rodrigues frame at the end is that at the start, turned by 2·arg(c + si): the holonomy is
// θ(end) + 2·arg(c + si). The frame of v is that frame turned by arg γ, γ = v·e₂ + i v·e₃, up to a
// constant, and closes: so −2π·Tw = θ(end) − Δ arg γ, and the writhe is Lk − Tw.
#include "phrame/ph/proof/closed_certificate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "phrame/algebra/argument.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/along/path_angle.hpp"
#include "phrame/ph/curve/crossings.hpp"
#include "phrame/ph/curve/end_point.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/frame/closed_curve.hpp"
#include "phrame/ph/proof/check_decisions.hpp"
#include "phrame/ph/proof/check_weight.hpp"
#include "phrame/ph/proof/stated_crossings.hpp"
#include "phrame/ph/proof/stated_number.hpp"

namespace phrame::inline v0 {
namespace {

/// A rational number and Σ k·arctan(slope), each slope > 0 once.
class ArctanSum {
 public:
  explicit ArctanSum(Rational rest) : rest_(std::move(rest)) {}

  void add(const Rational& k, const Rational& slope) {
    if (slope == 0 || k == 0) return;
    Rational& factor = factors_[abs(slope)];
    factor += slope > 0 ? k : Rational(-k);
    if (factor == 0) factors_.erase(abs(slope));
  }
  /// k·π.
  void add_half_turns(const Rational& k) { add(4 * k, 1); }

  RealBall enclose(long bits) const {
    RealBall sum(rest_, bits);
    for (const auto& [slope, k] : factors_)
      sum = phrame::add(sum, multiply(RealBall(k, bits), argument(1, slope, bits), bits), bits);
    return sum;
  }

  /// Why sign·x + more ≤ 0 is not proved.
  std::string objection(int sign, const Rational& more, const Rational& radius) const {
    if (factors_.empty()) return unless(Rational(sign) * rest_ + more <= 0, wrong);
    long ask = std::max(0L, radius == 0 ? 0 : -binary_exponent(radius)) + 64;
    for (const auto& [slope, k] : factors_) ask += bits_of(k);
    for (const long bits : {ask, ask + 256}) {
      const long precision = bits + bits_of(rest_) + 64;
      const RealBall x = phrame::add(multiply(RealBall(sign, 2), enclose(precision), precision),
                                     RealBall(more, precision), precision);
      if (x.upper() <= 0) return "";
      if (x.lower() > 0) return wrong;
    }
    return "it is too close to the end of the interval";
  }

 private:
  static constexpr auto wrong = "it is another one";

  Rational rest_;
  std::map<Rational, Rational> factors_;  ///< k of each slope
};

/// conj(A₀)·A₁, of which two parts are 0 where the tangents are the same.
RationalQuaternion back_to_start(const std::vector<Curve>& segments) {
  return conjugate(evaluate(without_real_content(segments.front().preimage()), 0)) *
         evaluate(without_real_content(segments.back().preimage()), 1);
}

std::string objection_to_closing(const std::vector<Curve>& segments) {
  for (const Curve& curve : segments)
    if (!objection_to_weight(curve).empty()) return "rests on the weight";
  if (sign_after_zero(segments.front().multiplier()) < 0)
    return "the multiplier is negative at the start";
  if (end_point(segments.back()) != segments.front().start())
    return "the path does not end where it begins";
  const RationalQuaternion back = back_to_start(segments);
  return unless(back.p == 0 && back.q == 0, "the tangent at the end is not that at the start");
}

/// θ(end) + 2·arctan(s/c), or θ(end) + π.
ArctanSum holonomy_of(const Rational& theta, const std::vector<Curve>& segments) {
  const RationalQuaternion back = back_to_start(segments);
  ArctanSum sum(theta);
  if (back.u == 0)
    sum.add_half_turns(1);
  else
    sum.add(2, back.v / back.u);
  return sum;
}

std::string objection_to_holonomy(const HolonomyClaim& claim, const std::vector<Curve>& segments,
                                  const ClaimedSum& theta) {
  const Rational radius = parse_rational(claim.radius);
  ArctanSum off = holonomy_of(theta.value - parse_rational(claim.value), segments);
  off.add_half_turns(2 * claim.turns);
  for (const int sign : {1, -1})
    if (std::string objection = off.objection(sign, theta.radius - radius, radius);
        !objection.empty())
      return objection;
  return "";
}

/// The change of arg γ along the path, which is subtracted.
void subtract_turn_of(ArctanSum& sum, const std::vector<Curve>& segments,
                      const Vector<Rational>& v) {
  for (const Curve& curve : segments) {
    const QuaternionPolynomial a = without_real_content(curve.preimage());
    GaussianPolynomial gamma{dot(as_polynomials(v), rotated_j(a)),
                             dot(as_polynomials(v), rotated_k(a))};
    const Polynomial common = gcd(gamma.re, gamma.im);
    const ContinuousArgument argument(
        {exact_quotient(gamma.re, common), exact_quotient(gamma.im, common)});
    const auto [x, y] = argument.coordinates(1);
    sum.add(-1, y(1) / x(1));
    sum.add(1, y(0) / x(0));
    sum.add_half_turns(argument.turn(1).index);
  }
}

long sum_of_signs(const std::vector<StatedCrossing>& crossings) {
  long sum = 0;
  for (const StatedCrossing& crossing : crossings) sum += crossing.sign;
  return sum;
}

std::string objection_to_writhe(const WritheClaim& claim, const std::vector<Curve>& segments,
                                const ClaimedSum& theta) {
  const Rational radius = parse_rational(claim.radius);
  const Rational rest = Rational(sum_of_signs(claim.crossings)) - parse_rational(claim.value);
  ArctanSum turn(theta.value);
  subtract_turn_of(turn, segments, claim.projection);
  for (const int sign : {1, -1}) {
    ArctanSum off = turn;
    off.add_half_turns(2 * (rest - Rational(sign) * radius));
    if (std::string objection = off.objection(sign, theta.radius, radius); !objection.empty())
      return objection;
  }
  return "";
}

/// The k for which 2πk is next to the number.
long whole_turns(const RealBall& angle) {
  return std::lround(approximate(divide(angle, times_power_of_two(pi(64), 1), 64)));
}

/// Does another way find it, too? The number is that up to whole turns where it is an angle.
std::string objection_by(const Real& found, const std::string& value, const std::string& radius,
                         bool is_up_to_turns) {
  const Rational allowed = parse_rational(radius);
  const long bits = std::max(0L, allowed == 0 ? 0 : -binary_exponent(allowed)) + 128;
  RealBall off = subtract(found.enclose(bits), RealBall(parse_rational(value), bits), bits);
  if (is_up_to_turns)
    off = subtract(off, multiply(RealBall(2 * whole_turns(off), 64), pi(bits), bits), bits);
  return unless(absolute(off).lower() <= allowed, "another way finds another one");
}

Path path_of(const std::vector<Curve>& segments) {
  std::vector<Segment> list;
  for (const Curve& curve : segments) list.emplace_back(PhSegment(curve));
  return Path::of_continuous(std::move(list));
}

/// The crossings that Newton's method finds along the same v, where it decides.
std::string objection_by_newton(const WritheClaim& claim, const Path& path) {
  const auto found = self_crossings(series_of(path), claim.projection);
  if (!found) return "";
  return unless(found->size() == claim.crossings.size() &&
                    phrame::sum_of_signs(*found) == sum_of_signs(claim.crossings),
                "Newton's method finds other crossings");
}

std::pair<std::string, std::string> rounded(const Real& x, long digits) {
  const std::string value = round_to_decimal(x, digits).value;
  return {value, upper_bound_text(rounding_radius(x, parse_rational(value), digits), 1)};
}

WritheClaim writhe_claim(const Path& path, const std::vector<Curve>& segments, long digits) {
  for (const Vector<Rational>& v : writhe_projections()) {
    const auto frame = closed_frame(path, v);
    const auto found = frame ? self_crossings(series_of(path), v) : std::nullopt;
    if (!found) continue;
    WritheClaim claim{v, {}, "", ""};
    const auto boxed = [&](const Crossing& c) {
      const auto box =
          box_around(segments, v, {static_cast<long>(c.first_segment), c.first_t.midpoint()},
                     {static_cast<long>(c.second_segment), c.second_t.midpoint()});
      if (box) claim.crossings.push_back(*box);
      return box.has_value();
    };
    if (!std::ranges::all_of(*found, boxed) ||
        !objection_to_crossings(segments, v, claim.crossings).empty())
      continue;
    std::tie(claim.value, claim.radius) = rounded(writhe(*frame), digits);
    return claim;
  }
  throw Undecided(
      "certify: of 9 projections none tells the crossings of the path so that others can check it");
}

}  // namespace

ClosedClaims closed_claims(const PhPath& path, const ClosedQuery& query, long digits) {
  ClosedClaims claims;
  if (!query.holonomy && !query.writhe) return claims;
  const Path whole(path);
  const std::vector<Curve>& segments = path.segments();
  if (const std::string objection = objection_to_closing(segments); !objection.empty())
    throw DomainError("certify: " + objection);
  if (query.holonomy) {
    const auto [value, radius] = rounded(*PathAngle(whole).holonomy(), digits);
    claims.holonomy = {0, value, radius};
  }
  if (query.writhe) claims.writhe = writhe_claim(whole, segments, digits);
  return claims;
}

bool complete(ClosedClaims& claims, const std::vector<Curve>& segments, const ClaimedSum& theta) {
  if (auto& claim = claims.holonomy) {
    claim->turns = whole_turns(subtract(RealBall(parse_rational(claim->value), 64),
                                        holonomy_of(theta.value, segments).enclose(64), 64));
    if (!objection_to_holonomy(*claim, segments, theta).empty()) return false;
  }
  return !claims.writhe || objection_to_writhe(*claims.writhe, segments, theta).empty();
}

std::vector<Statement> verify(const ClosedClaims& claims, const std::vector<Curve>& segments,
                              bool is_joined, bool is_smooth,
                              const std::variant<ClaimedSum, std::string>& theta) {
  const auto* sum = std::get_if<ClaimedSum>(&theta);
  const std::string closing = is_joined ? objection_to_closing(segments) : "rests on the joints";
  std::vector<Statement> list{{"closed", closing}};
  std::optional<Path> path;
  if (closing.empty()) path = path_of(segments);
  const auto about = [](const char* what, const auto& claim) {
    return fmt::format("|{} - {}| <= {}", what, claim.value, claim.radius);
  };
  if (const auto& claim = claims.holonomy) {
    std::string objection = !path ? "rests on the closed"
                            : sum ? objection_to_holonomy(*claim, segments, *sum)
                                  : std::get<std::string>(theta);
    if (objection.empty())
      objection = objection_by(*PathAngle(*path).holonomy(), claim->value, claim->radius, true);
    list.push_back({about("holonomy", *claim), objection});
  }
  if (const auto& claim = claims.writhe) {
    std::string crossings =
        !path        ? "rests on the closed"
        : !is_smooth ? "the path has corners"
                     : objection_to_crossings(segments, claim->projection, claim->crossings);
    if (crossings.empty()) crossings = objection_by_newton(*claim, *path);
    std::string objection = !crossings.empty() ? "rests on the crossings"
                            : sum              ? objection_to_writhe(*claim, segments, *sum)
                                               : std::get<std::string>(theta);
    if (objection.empty())
      if (const auto frame = closed_frame(*path, claim->projection))
        objection = objection_by(phrame::writhe(*frame), claim->value, claim->radius, false);
    list.push_back({"crossings", crossings});
    list.push_back({about("writhe", *claim), objection});
  }
  return list;
}

}  // namespace phrame
