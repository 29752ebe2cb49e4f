// The Euler–Rodrigues frame goes on at a joint, or is carried by the least rotation through a
// corner, where conj(A₀)·A₁ = c + yj + zk with c ≠ 0 for the preimages there, without their zeros:
// the rotation from the one frame to the other, A₁·conj(A₀), has an axis that is normal to e₁ then.
// So θ(t) is the sum of the θ(1) of the segments before t and of θ of that one, and its error at
// most the sum of theirs.
#include "phrame/ph/proof/path_certificate.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/along/path_angle.hpp"
#include "phrame/ph/curve/end_point.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/proof/certify.hpp"
#include "phrame/ph/proof/check_decisions.hpp"
#include "phrame/ph/proof/closed_certificate.hpp"
#include "phrame/ph/proof/stated_number.hpp"
#include "phrame/ph/proof/verify.hpp"

namespace phrame::inline v0 {
namespace {

void add(ClaimedSum& sum, const AngleClaim& claim) {
  sum.value += parse_rational(claim.theta);
  sum.radius += parse_rational(claim.radius);
}

/// The first claim about t; null where there is none.
const AngleClaim* claim_at(const Certificate& c, const Rational& t) {
  const auto found = std::ranges::find(c.claims, t, &AngleClaim::t);
  return found == c.claims.end() ? nullptr : &*found;
}

/// conj(A₀)·A₁ at the joint.
RationalQuaternion step_between(const Curve& before, const Curve& after) {
  return conjugate(evaluate(without_real_content(before.preimage()), 1)) *
         evaluate(without_real_content(after.preimage()), 0);
}

/// One segment behind another one.
struct SegmentJoint {
  std::string objection;   ///< why it does not go on from that; empty where it does
  bool is_corner = false;  ///< where both have values there
};

SegmentJoint joint_of(const Curve& before, const Curve& after) {
  if (before.weight()(1) == 0) return {"the weight of the segment before is 0 at its end"};
  const RationalQuaternion step = step_between(before, after);
  const bool is_corner = step.p != 0 || step.q != 0;
  if (end_point(before) != after.start())
    return {"the segment does not begin where the one before ends", is_corner};
  if (step.v != 0 || step.u == 0) return {"the Euler-Rodrigues frame does not go on", is_corner};
  const bool is_turned_over =
      is_corner && sign_before_one(before.multiplier()) != sign_after_zero(after.multiplier());
  return {is_turned_over ? "the tangent changes its side at the corner" : "", is_corner};
}

/// Sums of what the segments claim, from the start to each joint, and what they lack.
class SegmentSums {
 public:
  explicit SegmentSums(const std::vector<Certificate>& segments)
      : segments_(segments), to_joint_(segments.size()) {
    for (std::size_t k = 0; k + 1 < segments.size(); ++k) {
      const AngleClaim* whole = claim_at(segments[k], 1);
      if (whole == nullptr) return;
      to_joint_[k + 1] = to_joint_[k];
      add(to_joint_[k + 1], *whole);
      ++known_;
    }
  }

  /// No value where a segment claims nothing of that.
  std::optional<ClaimedSum> at(const PathParameter& t) const {
    if (t.segment > known_) return std::nullopt;
    ClaimedSum sum = to_joint_[t.segment];
    if (t.t == 0) return sum;
    const AngleClaim* part = claim_at(segments_[t.segment], t.t);
    if (part == nullptr) return std::nullopt;
    add(sum, *part);
    return sum;
  }

 private:
  const std::vector<Certificate>& segments_;
  std::vector<ClaimedSum> to_joint_;
  std::size_t known_ = 0;  ///< the last joint up to which all segments claim their end
};

std::vector<Curve> curves_of(const PathCertificate& c) {
  std::vector<Curve> curves;
  for (const Certificate& segment : c.segments) curves.push_back(segment.curve);
  return curves;
}

bool follows(const AngleClaim& claim, const ClaimedSum& sum) {
  return abs(sum.value - parse_rational(claim.theta)) + sum.radius <= parse_rational(claim.radius);
}

/// θ(t) correctly rounded. A decimal half way between two gets a whole unit, one that is exact
/// none.
AngleClaim rounded_claim(const Real& theta, const Rational& t, long digits) {
  AngleClaim claim{t, round_to_decimal(theta, digits).value, "0", {}};
  const Rational value = parse_rational(claim.theta);
  const std::optional<Rational>& exact = theta.exact();
  if (t == 0 || (exact && *exact == value && value != 0)) return claim;
  claim.radius = upper_bound_text(rounding_radius(theta, value, digits), 1);
  return claim;
}

}  // namespace

PathCertificate certify(const PhPath& path, const std::vector<Rational>& at, long digits,
                        const ClosedQuery& query) {
  const auto& curves = path.segments();
  if (query.writhe && !path.corners().empty())
    throw DomainError(
        fmt::format("certify: the path has a corner at t = {}, and no certificate tells of its "
                    "writhe",
                    path.corners().front()));
  const PathAngle angle(Path(path), Reference::euler_rodrigues);
  PathCertificate certificate;
  std::vector<std::vector<Rational>> places(curves.size());
  const auto ask = [&](const PathParameter& place) {
    const auto ask_of = [&](std::size_t k, const Rational& s) {
      if (std::ranges::find(places[k], s) == places[k].end()) places[k].push_back(s);
    };
    for (std::size_t k = 0; k < place.segment; ++k) ask_of(k, 1);
    if (place.t != 0) ask_of(place.segment, place.t);
  };
  for (const Rational& t : at) {
    ask(locate_inside(path, t));
    certificate.claims.push_back(rounded_claim(angle.value(t), t, digits));
  }
  const bool is_about_closed = query.holonomy || query.writhe;
  if (is_about_closed) {
    ask({curves.size() - 1, 1});
    certificate.closed = closed_claims(path, query, digits);
  }
  for (const long more : {4L, 16L, 64L, 256L}) {
    const long of_count = static_cast<long>(std::to_string(curves.size()).size());
    certificate.segments.clear();
    for (std::size_t k = 0; k < curves.size(); ++k)
      certificate.segments.push_back(
          certify(curves[k], Reference::euler_rodrigues, places[k], digits + of_count + more));
    const SegmentSums sums(certificate.segments);
    const auto is_told = [&](const AngleClaim& claim) {
      return follows(claim, sums.at(locate_inside(path, claim.t)).value());
    };
    if (std::ranges::all_of(certificate.claims, is_told) &&
        (!is_about_closed ||
         complete(*certificate.closed, curves, sums.at({curves.size() - 1, 1}).value())))
      return certificate;
  }
  throw Undecided(
      "certify: angles of the segments with 256 more digits do not tell that of the path");
}

std::vector<Statement> verify(const PathCertificate& c) {
  std::vector<Statement> list;
  std::size_t proved = c.segments.size();  // the first segment with an angle that is not
  for (std::size_t k = 0; k < c.segments.size(); ++k)
    for (Statement& statement : verify(c.segments[k])) {
      if (!statement.is_proved() && std::holds_alternative<AngleClaim>(statement.what))
        proved = std::min(proved, k);
      statement.segment = k;
      list.push_back(std::move(statement));
    }
  std::size_t joined = 0;  // the last joint up to which all are proved
  bool is_smooth = true;
  for (std::size_t k = 1; k < c.segments.size(); ++k) {
    SegmentJoint joint = joint_of(c.segments[k - 1].curve, c.segments[k].curve);
    if (joint.objection.empty() && joined + 1 == k) joined = k;
    if (joint.is_corner) is_smooth = false;
    list.push_back({fmt::format("joint {}", k), std::move(joint.objection)});
  }
  const SegmentSums sums(c.segments);
  const auto sum_at = [&](const PathParameter& at) -> std::variant<ClaimedSum, std::string> {
    if (at.segment > joined) return "rests on the joints";
    if (proved < at.segment + (at.t == 0 ? 0 : 1))
      return fmt::format("rests on the angles of segment {}", proved);
    const auto sum = sums.at(at);
    if (!sum) return "the segments do not claim the angles that it is the sum of";
    return *sum;
  };
  for (const AngleClaim& claim : c.claims) {
    const auto objection = [&]() -> std::string {
      if (claim.t < 0 || claim.t > Rational(static_cast<long>(c.segments.size())))
        return "t is not on the path";
      const auto sum = sum_at(locate_inside(c.segments.size(), claim.t));
      if (const auto* why = std::get_if<std::string>(&sum)) return *why;
      return follows(claim, std::get<ClaimedSum>(sum))
                 ? ""
                 : "it does not follow from the angles of the segments";
    };
    list.push_back({claim, objection()});
  }
  const std::size_t last = c.segments.size() - 1;
  if (c.closed)
    std::ranges::move(verify(*c.closed, curves_of(c), joined == last, is_smooth, sum_at({last, 1})),
                      std::back_inserter(list));
  return list;
}

std::variant<Path, std::string> path_of(const PathCertificate& c) {
  std::vector<Segment> segments{PhSegment(c.segments.front().curve)};
  std::vector<std::size_t> corners;
  for (std::size_t k = 1; k < c.segments.size(); ++k) {
    const Curve& curve = c.segments[k].curve;
    const SegmentJoint joint = joint_of(c.segments[k - 1].curve, curve);
    if (!joint.objection.empty()) return "rests on the joints";
    if (joint.is_corner) corners.push_back(k);
    segments.emplace_back(PhSegment(curve));
  }
  return Path::of_continuous(std::move(segments), std::move(corners));
}

}  // namespace phrame
