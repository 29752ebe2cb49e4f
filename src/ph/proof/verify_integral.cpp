#include "phrame/ph/proof/verify_integral.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/integrate/absolute_integral.hpp"
#include "phrame/ph/along/rational_rates.hpp"
#include "phrame/ph/along/segment_integral.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/proof/check_decisions.hpp"
#include "phrame/ph/proof/integral_laws.hpp"

namespace phrame::inline v0 {
namespace {

ExpressionCurve curve_of(const FormulaSegment& formulas) {
  return {formulas.position, formulas.from, formulas.to};
}

/// f(t) dt for t = c·s, c > 0.
RootQuotient scaled(const RootQuotient& f, const Rational& c) {
  const Polynomial by{0, c};
  return {c * compose(f.numerator, by), compose(f.denominator, by), compose(f.radicand, by)};
}

/// What one segment proves.
class SegmentProof {
 public:
  SegmentProof(const IntegralCertificate& c, std::size_t k, const SegmentProof* before)
      : c_(c), k_(k), curve_(directed_curve(c.segments[k])) {
    const auto* segment = std::get_if<IntegralSegment>(&c.segments[k]);
    if (segment != nullptr && !segment->weight.is_constant())
      state("weight", unless(count_real_roots(segment->weight, closed_interval(0, 1)) == 0,
                             "w has a zero on [0, 1]"));
    if (before != nullptr) {
      const std::string objection = objection_to_joint(c, k, before->curve_, curve_);
      is_joined_ = objection.empty();
      add({name_of_joint(c, k), objection});
    }
    if (segment == nullptr) {
      const auto& formulas = std::get<FormulaSegment>(c.segments[k]);
      std::string objection = objection_to_pieces(formulas.pieces, [&](const ModelPiece& piece) {
        return PieceProof(c, formulas, curve_, piece, end_);
      });
      if (objection.empty() && end_ != 1) objection = "the pieces end before 1";
      state("pieces", objection);
      return;
    }
    const auto f = integrand(c, k, curve_);
    if (const auto* objection = std::get_if<std::string>(&f)) {
      state("rate", *objection);
      state("pieces", "rests on the rate");
      return;
    }
    state("rate", "");
    state("pieces", objection_to_pieces(segment->pieces, [&](const IntegralPiece& piece) {
            PieceProof proof(std::get<RootQuotient>(f), piece, end_);
            if (proof.objection().empty() && !c_.frame) proof.of_size(curve_.multiplier);
            return proof;
          }));
  }

  const std::vector<Statement>& statements() const { return statements_; }
  bool is_proved() const { return is_proved_; }
  /// Does it go on from the segment before?
  bool is_joined() const { return is_joined_; }
  /// By how much the angle grows at the joint.
  IntegralBounds turn(long bits) const {
    const RealBall of_corner = curve_.turn.enclose(bits);
    IntegralBounds turn{of_corner.lower(), of_corner.upper()};
    return turn += curve_.turn_of_models;
  }
  /// The pieces end here.
  const Rational& end() const { return end_; }

  /// Precondition: t is in the pieces.
  IntegralBounds bounds(const Rational& t) const {
    const auto after = std::ranges::upper_bound(pieces_, t, {}, &Part::start);
    if (after == pieces_.begin()) return {};
    const Part& part = *std::prev(after);
    IntegralBounds all = part.before;
    if (part.start < t) all += part.proof.bounds(t);
    return all;
  }

  std::string objection_to_symmetry(const Rational& t, const Antisymmetry& symmetry) const {
    return phrame::objection_to_symmetry(c_, curve_, t, symmetry, c_.angles.size());
  }

  /// The same by Taylor series in balls of 1/√S and 1/D.
  RealBall by_series(const Rational& t, long bits) {
    if (!series_) series_ = series();
    const Rational s = t / end_;
    return std::visit([&](const auto& f) { return enclosed(f, s, bits); }, *series_);
  }

 private:
  struct Part {
    Rational start;
    IntegralBounds before;
    PieceProof proof;
  };
  using Series = std::variant<TaylorIntegral, AbsoluteIntegral, SegmentIntegral>;

  static RealBall enclosed(const TaylorIntegral& f, const Rational& s, long bits) {
    return f.enclose(s, bits);
  }
  template <class F>
  static RealBall enclosed(const F& f, const Rational& s, long bits) {
    return f.enclose(Real(s), bits);
  }

  void add(Statement statement) {
    is_proved_ = is_proved_ && statement.is_proved();
    statements_.push_back(std::move(statement));
  }
  void state(const char* what, const std::string& objection) {
    add({fmt::format("{} of segment {}", what, k_), objection});
  }

  template <class Piece, class Proof>
  std::string objection_to_pieces(const std::vector<Piece>& pieces, const Proof& proof_of) {
    IntegralBounds sum;
    for (std::size_t j = 0; j < pieces.size(); ++j) {
      const Rational& to = pieces[j].to;
      if (to <= end_ || to > 1) return fmt::format("piece {} is empty, or ends beyond 1", j);
      const PieceProof proof = proof_of(pieces[j]);
      if (!proof.objection().empty()) return fmt::format("piece {}: {}", j, proof.objection());
      pieces_.push_back({end_, sum, proof});
      sum += proof.bounds(to);
      end_ = to;
    }
    return "";
  }

  /// Where the pieces are D and S have no zero.
  Series series() const {
    if (const auto* formulas = std::get_if<FormulaSegment>(&c_.segments[k_])) {
      const ExpressionCurve given = curve_of(*formulas);
      const Segment curve = curve_.multiplier(0) < 0 ? given.turned_over() : given;
      if (!c_.frame) return arc_length(curve);
      return c_.frame == Reference::up ? up_frame_angle(curve, c_.up) : frenet_angle(curve);
    }
    const auto& segment = std::get<IntegralSegment>(c_.segments[k_]);
    RationalCurve curve(segment.position, segment.weight);
    if (dot(evaluate(curve.direction(), 0), evaluate(curve_.direction, 0)) < 0)
      curve = curve.turned_over();
    if (!c_.frame) return AbsoluteIntegral(scaled(length_rate(curve), end_));
    return TaylorIntegral(scaled(
        c_.frame == Reference::up ? up_frame_turning(curve, c_.up) : frenet_turning(curve), end_));
  }

  const IntegralCertificate& c_;
  std::size_t k_ = 0;
  DirectedCurve curve_;
  std::vector<Statement> statements_;
  bool is_proved_ = true;
  bool is_joined_ = true;
  std::vector<Part> pieces_;
  Rational end_ = 0;
  std::optional<Series> series_;
};

/// |the integral from 0 to t, and the turns of the corners up to there − value| ≤ radius. With a
/// symmetry the integral is 0.
std::string objection_to_claim(std::vector<SegmentProof>& segments, const Rational& t,
                               const Rational& value, const Rational& radius,
                               const std::optional<Antisymmetry>& symmetry = {}) {
  if (t < 0 || t > Rational(static_cast<long>(segments.size()))) return "t is not on the path";
  if (symmetry && (t == 0 || t > 1)) return "a symmetry is one of the first segment";
  IntegralBounds sum;
  const auto each = [&](const auto& does) -> std::string {
    for (std::size_t k = 0; Rational(static_cast<long>(k)) < t; ++k) {
      const Rational to = std::min(Rational(1), Rational(t - Rational(static_cast<long>(k))));
      if (!segments[k].is_proved()) return fmt::format("rests on what is of segment {}", k);
      if (to > segments[k].end()) return fmt::format("the pieces of segment {} end before t", k);
      does(segments[k], to);
    }
    return "";
  };
  std::string objection =
      each([&](SegmentProof& segment, const Rational& to) { sum += segment.bounds(to); });
  if (objection.empty() && symmetry) {
    objection = segments.front().objection_to_symmetry(t, *symmetry);
    sum = {};
  }
  if (!objection.empty()) return objection;
  const long bits = 128 + (radius == 0 ? 0 : std::max(0L, -binary_exponent(radius))) +
                    std::max(0L, binary_exponent(abs(value) + 1));
  IntegralBounds turns;
  for (std::size_t k = 1; k < segments.size() && Rational(static_cast<long>(k)) <= t; ++k) {
    if (!segments[k].is_joined()) return fmt::format("rests on joint {}", k);
    turns += segments[k].turn(bits);
  }
  sum += turns;
  if (sum.lower < value - radius || value + radius < sum.upper)
    return "it does not follow from the pieces";
  try {
    RealBall total = widened(RealBall((turns.lower + turns.upper) / 2, bits),
                             RealBall((turns.upper - turns.lower) / 2, bits));
    each([&](SegmentProof& segment, const Rational& to) {
      total = add(total, segment.by_series(to, bits), bits);
    });
    const RealBall claimed = widened(RealBall(value, bits + 64), RealBall(radius, bits + 64));
    return unless(total.overlaps(claimed), "the series say something else");
  } catch (const Undecided& error) {
    return error.what();
  } catch (const DomainError& error) {
    return error.what();
  }
}

}  // namespace

std::vector<Statement> verify(const IntegralCertificate& c) {
  std::vector<Statement> list;
  std::vector<SegmentProof> segments;
  segments.reserve(c.segments.size());
  for (std::size_t k = 0; k < c.segments.size(); ++k) {
    segments.emplace_back(c, k, k == 0 ? nullptr : &segments.back());
    const auto& statements = segments.back().statements();
    list.insert(list.end(), statements.begin(), statements.end());
  }
  for (const AngleClaim& claim : c.angles)
    list.push_back({claim, objection_to_claim(segments, claim.t, parse_rational(claim.theta),
                                              parse_rational(claim.radius), claim.symmetry)});
  for (const LengthClaim& claim : c.lengths)
    list.push_back({claim, objection_to_claim(segments, claim.t, parse_rational(claim.length),
                                              parse_rational(claim.radius))});
  return list;
}

std::variant<Path, std::string> path_of(const IntegralCertificate& c) {
  try {
    std::vector<Segment> segments;
    for (const CertifiedSegment& segment : c.segments) {
      if (const auto* formulas = std::get_if<FormulaSegment>(&segment)) {
        segments.emplace_back(curve_of(*formulas));
        continue;
      }
      const auto& [position, weight, square, pieces] = std::get<IntegralSegment>(segment);
      segments.emplace_back(RationalCurve(position, weight));
    }
    return joined(std::move(segments));
  } catch (const DomainError& error) {
    return std::string(error.what());
  }
}

}  // namespace phrame
