// Pieces are halved until Taylor polynomials of some degree do on them. What they prove is computed
// as a checker does, exactly, and has to be within the piece's share of what the claims leave.
#include "phrame/ph/proof/certify_integral.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/grid_quotient.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/along/antisymmetric_rate.hpp"
#include "phrame/ph/along/path_length.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/proof/integral_laws.hpp"
#include "phrame/ph/proof/stated_number.hpp"

namespace phrame::inline v0 {
namespace {

/// Beyond the digits of a claim.
constexpr long spare_bits = 10;

/// Pieces of one segment.
class PieceMaker {
 public:
  /// The integral of f, or where there is a multiplier of |f|, which has its sign.
  PieceMaker(RootQuotient f, std::optional<Polynomial> multiplier)
      : f_(std::move(f)), multiplier_(std::move(multiplier)) {
    if (multiplier_ && !multiplier_->is_constant())
      zeros_ = isolate_real_roots(*multiplier_, open_interval(0, 1));
  }

  /// As far as to t or beyond it; each leaves the integral no more than `room`.
  std::vector<IntegralPiece> pieces(const Rational& t, const Rational& room) const {
    std::vector<IntegralPiece> list;
    Rational start = 0;
    for (const Interval& zero : zeros_) {
      if (start >= t) return list;
      // Next to a zero that is not rational the integral is small.
      Interval close = zero;
      std::optional<IntegralPiece> across;
      for (Rational width(1, 1 << 16); !across && close.lower != close.upper; width *= width) {
        close = narrowed(*multiplier_, zero, width);
        if (close.lower != close.upper) across = piece(*close.lower, *close.upper, room, true);
      }
      add_halves(list, start, *close.lower, t, room);
      if (across) list.push_back(*std::move(across));
      start = *close.upper;
    }
    add_halves(list, start, 1, t, room);
    return list;
  }

 private:
  void add_halves(std::vector<IntegralPiece>& list, const Rational& from, const Rational& to,
                  const Rational& t, const Rational& room) const {
    constexpr long greatest_level = 4096;
    struct Open {
      Rational from, to;
      long level;
    };
    std::vector<Open> open;
    if (from < to) open.push_back({from, to, 0});
    while (!open.empty()) {
      const Open part = std::move(open.back());
      open.pop_back();
      if (part.from >= t) return;
      if (auto found = piece(part.from, part.to, room, false)) {
        list.push_back(*std::move(found));
        continue;
      }
      if (part.level == greatest_level)
        throw Undecided(fmt::format("certify: a singularity is closer than 2^-{} to t = {:.9g}",
                                    greatest_level, static_cast<double>(part.from)));
      const Rational middle = (part.from + part.to) / 2;
      open.push_back({middle, part.to, part.level + 1});
      open.push_back({part.from, middle, part.level + 1});
    }
  }

  /// No value where it does not prove enough.
  std::optional<IntegralPiece> piece(const Rational& from, const Rational& to, const Rational& room,
                                     bool has_zero) const {
    const Polynomial D = on_piece(f_.denominator, from, to);
    if (2 * D.coefficient(0) <= sum_of_sizes(D)) return std::nullopt;
    auto about = grid_quotient(on_piece(f_.numerator, from, to), D, on_piece(f_.radicand, from, to),
                               binary_exponent((to - from) / room) + 2);
    if (!about) return std::nullopt;
    const IntegralPiece found{to, std::move(about->root), std::move(about->rate)};
    PieceProof proof(f_, found, from);
    if (multiplier_) proof.of_size(*multiplier_);
    if (!proof.objection().empty() || (!has_zero && proof.has_both_signs())) return std::nullopt;
    const IntegralBounds bounds = proof.bounds(to);
    if (bounds.upper - bounds.lower > room) return std::nullopt;
    return found;
  }

  RootQuotient f_;
  std::optional<Polynomial> multiplier_;
  std::vector<Interval> zeros_{};  ///< of the multiplier, on (0, 1)
};

/// What is to be certified, without its pieces.
IntegralCertificate without_pieces(const Path& path) {
  IntegralCertificate c;
  for (const Segment& segment : path.segments()) {
    if (const auto* by_formulas = std::get_if<ExpressionCurve>(&segment)) {
      c.segments.push_back(
          FormulaSegment{by_formulas->position(), by_formulas->from(), by_formulas->to(), {}});
      continue;
    }
    const RationalCurve* curve = rational_curve(segment);
    const Polynomial sigma = dot(curve->direction(), curve->direction());
    Polynomial root = square_root(sigma).value_or(Polynomial{1});
    if (root(0) < 0) root = -root;
    c.segments.push_back(IntegralSegment{curve->numerator(), curve->weight(), std::move(root), {}});
  }
  return c;
}

/// Gives segment k, which is by formulas, pieces of all of it, by halving, where the rate is off by
/// no more than `room`. Where that does not end it says why not, and where.
std::string objection_to_models(IntegralCertificate& c, std::size_t k, const Rational& room,
                                long order, long bits) {
  auto& segment = std::get<FormulaSegment>(c.segments[k]);
  std::vector<ModelPiece>& pieces = segment.pieces;
  pieces.clear();
  const DirectedCurve curve = directed_curve(c.segments[k]);
  Rational start = 0;
  std::string objection;
  for (std::vector<Rational> ends{1}; !ends.empty();) {
    const ModelPiece piece{ends.back(), order, bits};
    const PieceProof proof(c, segment, curve, piece, start);
    if (proof.is_too_short())
      return fmt::format("next to t = {:.9g}: {}",
                         static_cast<double>(Rational(static_cast<long>(k)) + start), objection);
    if (!proof.objection().empty() || proof.error() > room) {
      objection = proof.objection().empty() ? "the models are too inaccurate" : proof.objection();
      ends.push_back((start + piece.to) / 2);
      continue;
    }
    pieces.push_back(piece);
    start = piece.to;
    ends.pop_back();
  }
  return "";
}

/// Why the joints beside formulas leave the angle more than `room`, or are none; or "".
std::string objection_to_turns(const IntegralCertificate& c, const Rational& room) {
  std::optional<DirectedCurve> before;
  for (std::size_t k = 0; k < c.segments.size(); ++k) {
    DirectedCurve curve = directed_curve(c.segments[k]);
    const std::string objection = before ? objection_to_joint(c, k, *before, curve) : "";
    if (!objection.empty()) return fmt::format("joint {}: {}", k, objection);
    if (curve.turn_of_models.upper - curve.turn_of_models.lower > room)
      return fmt::format("joint {}: the models are too inaccurate", k);
    before = std::move(curve);
  }
  return "";
}

/// The pieces of all segments by formulas, of models that are as fine as it takes.
void find_model_pieces(IntegralCertificate& c, const Rational& slack) {
  const Rational room = slack / Rational(4 * static_cast<long>(c.segments.size()));
  const long needed = std::max(0L, -binary_exponent(room));
  const long order = needed * 2 / 3 + 8;  // of models that get smaller by 3/2 bits a term
  std::string objection;
  for (long more = 48; more <= 768; more *= 2) {
    objection.clear();
    for (std::size_t k = 0; k < c.segments.size() && objection.empty(); ++k)
      if (std::holds_alternative<FormulaSegment>(c.segments[k]))
        objection = objection_to_models(c, k, room, order, needed + more);
    if (objection.empty()) objection = objection_to_turns(c, room);
    if (objection.empty()) return;
  }
  throw Undecided("certify: " + objection);
}

/// The pieces up to t of the other segments, whose bounds are no further apart than the slack.
void find_pieces(IntegralCertificate& c, const PathParameter& end, const Rational& slack) {
  std::map<std::size_t, PieceMaker> makers;
  std::optional<DirectedCurve> before;
  for (std::size_t k = 0; k <= end.segment; ++k) {
    DirectedCurve curve = directed_curve(c.segments[k]);
    if (before) objection_to_joint(c, k, *before, curve);
    if (std::holds_alternative<IntegralSegment>(c.segments[k]))
      makers.try_emplace(k, std::get<RootQuotient>(integrand(c, k, curve)),
                         c.frame ? std::nullopt : std::optional(curve.multiplier));
    before = std::move(curve);
  }
  for (std::size_t most = 16 * makers.size(), count = most + 1; count > most; most = 2 * count) {
    count = 0;
    for (const auto& [k, maker] : makers) {
      const Rational room = slack / Rational(static_cast<long>(most));
      auto& pieces = std::get<IntegralSegment>(c.segments[k]).pieces;
      pieces = maker.pieces(k == end.segment ? end.t : Rational(1), room);
      count += pieces.size();
    }
    if (count <= most) return;
  }
}

/// The segment that t is in, the earlier one at a joint, up to which are those that are summed.
PathParameter last_part(std::size_t count, const Rational& t) {
  const PathParameter at = locate_inside(count, t);
  return at.t == 0 && at.segment > 0 ? PathParameter{at.segment - 1, 1} : at;
}

/// Why the angle is 0 at t ≠ 0, as far as it is seen.
std::optional<Antisymmetry> symmetry_up_to(const IntegralCertificate& c, const Rational& t,
                                           std::size_t claims) {
  if (t > 1) return std::nullopt;
  const DirectedCurve curve = directed_curve(c.segments.front());
  return find_antisymmetry(t, [&](const Antisymmetry& symmetry) {
    return objection_to_symmetry(c, curve, t, symmetry, claims).empty();
  });
}

/// add(t, stated, symmetry) makes the claims; `is_zero` says that all of them are 0.
template <class Value, class Add>
IntegralCertificate with_claims(IntegralCertificate c, const std::vector<Rational>& at, long digits,
                                bool is_zero, const Value& value, const Add& add) {
  std::optional<Rational> slack;
  PathParameter end{0, 0};
  const std::size_t count = c.segments.size();
  const bool has_models = has_formulas(c);
  const bool is_found_to_be_zero = is_zero && !has_models;
  for (const Rational& t : at) {
    const Real exact = value(Place(locate_inside(count, t)));
    std::optional<Antisymmetry> symmetry;
    StatedNumber stated{"0", "0", 0};
    if (t != 0 && !is_found_to_be_zero && exact.exact() == Rational(0)) {
      symmetry = symmetry_up_to(c, t, at.size());
      if (!symmetry) {
        stated.slack = power_of_ten(-digits);
        stated.radius = upper_bound_text(stated.slack, 1);
      }
    } else {
      stated = stated_number(exact, digits, is_found_to_be_zero || t == 0, spare_bits);
    }
    add(c, t, stated, symmetry);
    if (t == 0) continue;
    const PathParameter place = last_part(count, t);
    if (std::pair(place.segment, place.t) > std::pair(end.segment, end.t)) end = place;
    if (!symmetry && (!slack || stated.slack < *slack)) slack = stated.slack;
  }
  if (has_models) {
    const Rational half = slack.value_or(1) / 2;
    find_model_pieces(c, half);
    slack = half;
  }
  if (end.t != 0) find_pieces(c, end, slack && *slack > 0 ? *slack : Rational(1));
  return c;
}

}  // namespace

IntegralCertificate certify(const PathAngle& angle, const std::vector<Rational>& at, long digits) {
  const Path& path = angle.path();
  if (angle.reference() == Reference::euler_rodrigues)
    throw DomainError("certify: this angle is to the Euler-Rodrigues frame");
  IntegralCertificate c = without_pieces(path);
  c.frame = angle.reference();
  if (c.frame == Reference::up) c.up = angle.up();
  return with_claims(
      std::move(c), at, digits, angle.is_zero(),
      [&](const Place& place) { return angle.value(place); },
      [](IntegralCertificate& to, const Rational& t, const StatedNumber& stated,
         const std::optional<Antisymmetry>& symmetry) {
        to.angles.push_back({t, stated.value, stated.radius, {}, symmetry});
      });
}

IntegralCertificate certify_length(const Path& path, const std::vector<Rational>& at, long digits) {
  const PathLength length(path);
  return with_claims(
      without_pieces(path), at, digits, false,
      [&](const Place& place) { return length.value(place); },
      [](IntegralCertificate& to, const Rational& t, const StatedNumber& stated, const auto&) {
        to.lengths.push_back({t, stated.value, stated.radius});
      });
}

}  // namespace phrame
