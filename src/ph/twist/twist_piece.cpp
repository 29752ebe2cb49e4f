#include "phrame/ph/twist/twist_piece.hpp"

#include <algorithm>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/ph/along/arc_length.hpp"
#include "phrame/ph/curve/real_vector.hpp"
#include "phrame/ph/curve/special_points.hpp"
#include "phrame/ph/curve/transform.hpp"

namespace phrame::inline v0 {
namespace {

/// T·speed − erf_rate at τ.
Real wanted_rate(const TwistPiece& piece, const Rational& tau) {
  return piece.twist * Real(piece.speed(tau)) + Real(Rational(-piece.erf_rate(tau)));
}

TwistPiece piece_between(const MinimalTwist& mtf, std::size_t index, const Rational& a,
                         const Rational& b) {
  const Curve& whole = *ph_curve(mtf.path().segments()[index]);
  const bool is_segment = a == 0 && b == 1;
  const Curve part = is_segment ? whole : segment(whole, a, b);
  const Polynomial arc_length =
      is_segment ? mtf.arc_length().closed_form(index)->polynomial() : ArcLength(part).polynomial();
  const Rational length = arc_length(1);
  const Rational from = Rational(static_cast<long>(index)) + a;
  const Rational to = Rational(static_cast<long>(index)) + b;
  const Real start = cached(mtf.rmf().value(Place(index, a)));
  const Real twist = mtf.twist() * quotient_of(length, mtf.length());
  const bool is_whole = mtf.path().segments().size() == 1 && is_segment;
  const Real whole_twist =
      is_whole ? mtf.own_twist() : cached(start + -mtf.rmf().value(Place(index, b)));
  const auto erf_twist = [rmf = mtf.rmf(), start, whole_twist, index, a, b](const Rational& tau) {
    if (tau == 1) return whole_twist;
    return start + -rmf.value(Place(index, a + (b - a) * tau));
  };
  const Real turn = cached(twist + -whole_twist);
  std::optional<Integer> whole_turns;
  if (turn.exact() == Rational(0)) whole_turns = 0;
  return {from,
          to,
          -rate_to_erf(part.preimage()),
          Rational(1 / length) * differentiate(arc_length),
          length,
          twist,
          turn,
          whole_turns,
          mtf.reduced_value({index, a}),
          erf_twist};
}

/// `where` names the segment of a spline.
void require_no_cusp(const Curve& curve, const std::string& where) {
  const auto found = cusps(curve);
  if (!found.empty())
    throw DomainError("the curve has a cusp" + where + " at " + place_text("t", found.front().at) +
                      ", where a frame that turns with the parameter turns at an infinite rate");
}

/// Those between neighbours of the points.
std::vector<TwistPiece> pieces_between(const MinimalTwist& mtf, std::vector<Rational> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<TwistPiece> pieces;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const auto [index, t] = locate_inside(mtf.path().segments().size(), points[k]);
    pieces.push_back(piece_between(mtf, index, t, t + points[k + 1] - points[k]));
  }
  return pieces;
}

}  // namespace

Real TwistPiece::first_rate() const { return wanted_rate(*this, 0); }

Real TwistPiece::last_rate() const { return wanted_rate(*this, 1); }

void require_to_erf(const MinimalTwist& mtf) {
  if (mtf.rmf().reference() != Reference::euler_rodrigues)
    throw DomainError(
        "a rational frame is there of PH curves only, by their Euler-Rodrigues frame");
}

std::vector<TwistPiece> twist_pieces(const MinimalTwist& mtf, std::vector<Rational> points) {
  require_to_erf(mtf);
  const Path& path = mtf.path();
  const std::size_t count = path.segments().size();
  for (std::size_t k = 0; k < count; ++k) {
    require_no_cusp(*ph_curve(path.segments()[k]),
                    count == 1 ? std::string() : " in segment " + std::to_string(k + 1));
    points.emplace_back(static_cast<long>(k));
  }
  points.push_back(path.end());
  const auto [least, greatest] = std::minmax_element(points.begin(), points.end());
  if (*least < 0 || *greatest > path.end())
    throw DomainError("the parameter " + as_written(*least < 0 ? *least : *greatest) +
                      " is outside [0, " + to_string(path.end()) + "]");
  std::vector<TwistPiece> pieces = pieces_between(mtf, std::move(points));
  if (pieces.size() == 1 && !pieces.front().whole_turns)
    pieces.front().whole_turns = mtf.whole_turns_of_theta();
  return pieces;
}

TwistPiece untwisted_piece(const Curve& curve) {
  require_no_cusp(curve, "");
  const Polynomial arc_length = ArcLength(curve).polynomial();
  const Rational length = arc_length(1);
  const RmfAngle rmf(curve);
  const Real turn = cached(rmf.value(1));
  std::optional<Integer> whole_turns;
  if (turn.exact() == Rational(0)) whole_turns = 0;
  const auto erf_twist = [rmf, turn](const Rational& tau) {
    return tau == 1 ? -turn : -rmf.value(tau);
  };
  return {0,
          1,
          -rate_to_erf(curve.preimage()),
          Rational(1 / length) * differentiate(arc_length),
          length,
          Real(Rational(0)),
          turn,
          whole_turns,
          Real(Rational(0)),
          erf_twist};
}

std::vector<TwistPiece> divided(const MinimalTwist& mtf, const TwistPiece& piece,
                                std::vector<Rational> points) {
  points.insert(points.end(), {piece.from, piece.to});
  return pieces_between(mtf, std::move(points));
}

}  // namespace phrame
