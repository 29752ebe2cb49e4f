// Let T and T̃ be the unit tangents of the two curves, η(t) < π the angle between them, κ and κ̃ the
// rates |T′| and |T̃′|. A rotation-minimizing frame is carried along the curve of tangents on the
// unit sphere by parallel transport. To go along T from 0 to t and then by the shortest arc to
// T̃(t), or by the shortest arc to T̃(0) and then along T̃, differs by the rotation around the loop
// that the two ways make, whose angle is the area, with its sign, that the arcs from T(τ) to T̃(τ),
// τ ∈ [0, t], sweep over (Gauss and Bonnet). This is the angle between the two frames, and
// continuous in t, so that it is that of the frames without multiples of 2π.
//
// Of the arcs S(τ, x), x ∈ [0, 1], the part of ∂S/∂τ at right angles to the arc is a Jacobi field,
//   (sin((1 − x)η)·a + sin(xη)·b)/sin η  with  |a| ≤ κ, |b| ≤ κ̃,
// and |∂S/∂x| = η. So the area swept over in dτ is at most
//   η ∫₀¹ |…| dx ≤ ((1 − cos η)/sin η)·(κ + κ̃) = tan(η/2)·(κ + κ̃),
// and the angle is at most Σ tan(η_i/2)(K_i + K̃_i) over parts with η ≤ η_i on them, K_i and K̃_i
// being their total curvatures, the lengths of T and T̃. The same holds where T jumps, along an arc
// of the length that is: the points next to T̃ by η_i are a convex cap.
//
// η: sin η ≤ |r′ − r̃′|/|r̃′|, and η < π/2 where |r′ − r̃′| < |r̃′|. With Bernstein coefficients d_k of
// r′ − r̃′ and c_k of r̃′, and any unit vector e: |r′ − r̃′| ≤ max |d_k|, |r̃′| ≥ min e·c_k.
//
// K: by Crofton's formula the length of T is π times the mean, over all great circles, of the
// number of points where T crosses one. T crosses that of the normal x where x·r′ changes its sign,
// at most as often as the sequence of the numbers x·c_k does (Bernstein polynomials diminish
// variation), which is as often as the polygon of arcs from each direction c_k/|c_k| to the next
// crosses it. So K is at most the length of that polygon, the sum of the angles between successive
// c_k. For parts made by subdivision it tends to K.
#include "phrame/ph/construct/rmf_difference.hpp"

#include <tuple>

#include "phrame/algebra/ball.hpp"

namespace phrame {
namespace {

constexpr long ball_bits = 128;
constexpr int most_halvings = 48;    ///< of a part
constexpr long most_parts = 10'000;  ///< of a piece

using BallVector = Vector<RealBall>;

/// The Bernstein coefficients of three components, a list each.
using BallVectors = Vector<std::vector<RealBall>>;

BallVectors coefficients(const std::vector<Vector<Rational>>& v) {
  BallVectors result;
  for (const Vector<Rational>& x : v)
    for (std::size_t c = 0; c < 3; ++c) result[c].emplace_back(x[c], ball_bits);
  return result;
}

BallVector item(const BallVectors& a, std::size_t k) { return {a[0][k], a[1][k], a[2][k]}; }

RealBall dot_of_balls(const BallVector& a, const BallVector& b) {
  RealBall result = multiply(a[0], b[0], ball_bits);
  for (std::size_t c = 1; c < 3; ++c) result = add_product(result, a[c], b[c], ball_bits);
  return result;
}

RealBall length(const BallVector& a) { return sqrt_of_nonnegative(dot_of_balls(a, a), ball_bits); }

BallVector cross_of_balls(const BallVector& a, const BallVector& b) {
  const auto minor = [&](std::size_t i, std::size_t j) {
    return subtract(multiply(a[i], b[j], ball_bits), multiply(a[j], b[i], ball_bits), ball_bits);
  };
  return {minor(1, 2), minor(2, 0), minor(0, 1)};
}

BallVector sum(const BallVector& a, const BallVector& b) {
  return {add(a[0], b[0], ball_bits), add(a[1], b[1], ball_bits), add(a[2], b[2], ball_bits)};
}

/// Between the vectors; all of [−π, π], at worst, where one of them may be 0.
RealBall angle(const BallVector& a, const BallVector& b) {
  return argument(ComplexBall(dot_of_balls(a, b), length(cross_of_balls(a, b))), ball_bits);
}

/// Of finite balls, the one that goes farther.
RealBall greater(const RealBall& a, const RealBall& b) { return a.upper() < b.upper() ? b : a; }

/// A part of both curves: r̃′ and r′ − r̃′.
struct PairPart {
  BallVectors other;
  BallVectors difference;
  int halvings = 0;
};

/// De Casteljau's algorithm in the middle: means, of which balls do not grow.
std::pair<std::vector<RealBall>, std::vector<RealBall>> halves(std::vector<RealBall> row) {
  std::vector<RealBall> left;
  std::vector<RealBall> right(row.size());
  for (std::size_t length = row.size(); length > 0; --length) {
    left.push_back(row.front());
    right[length - 1] = row[length - 1];
    for (std::size_t k = 0; k + 1 < length; ++k)
      row[k] = times_power_of_two(add(row[k], row[k + 1], ball_bits), -1);
  }
  return {std::move(left), std::move(right)};
}

std::pair<PairPart, PairPart> halves(const PairPart& part) {
  std::pair<PairPart, PairPart> result;
  result.first.halvings = result.second.halvings = part.halvings + 1;
  for (std::size_t c = 0; c < 3; ++c) {
    std::tie(result.first.other[c], result.second.other[c]) = halves(part.other[c]);
    std::tie(result.first.difference[c], result.second.difference[c]) = halves(part.difference[c]);
  }
  return result;
}

/// Where one of the curves comes from, or goes to.
struct GivenEnd {
  BallVector given;
  RealBall tangent;  ///< tan(η/2) on the part next to it
};

/// The sum, part by part.
class DifferenceBound {
 public:
  /// Is it bounded?
  bool add_piece(const HodographPair& pair) {
    PairPart whole{coefficients(pair.other), {}, 0};
    for (std::size_t k = 0; k < pair.given.size(); ++k)
      for (std::size_t c = 0; c < 3; ++c)
        whole.difference[c].emplace_back(Rational(pair.given[k][c] - pair.other[k][c]), ball_bits);
    is_first_of_piece_ = true;
    std::vector<PairPart> todo{std::move(whole)};
    for (long k = 0; !todo.empty(); ++k) {
      if (k == most_parts) return false;
      PairPart part = std::move(todo.back());
      todo.pop_back();
      if (const auto tangent = tangent_of_half(part)) {
        add_part(part, *tangent);
      } else if (part.halvings == most_halvings) {
        return false;
      } else {
        auto [first, second] = halves(part);
        todo.push_back(std::move(second));
        todo.push_back(std::move(first));
      }
    }
    return true;
  }

  RealBall value() const { return sum_; }

 private:
  /// tan(η/2) at most; no value where the part is too long to tell it well.
  static std::optional<RealBall> tangent_of_half(const PairPart& part) {
    const std::size_t count = part.other[0].size();
    BallVector middle{};
    RealBall fastest;
    RealBall difference;
    for (std::size_t k = 0; k < count; ++k) {
      const BallVector v = item(part.other, k);
      middle = phrame::sum(middle, v);
      fastest = greater(fastest, length(v));
      difference = greater(difference, length(item(part.difference, k)));
    }
    const RealBall middle_length = length(middle);
    if (sign(middle_length) <= 0) return std::nullopt;
    std::optional<Rational> slowest;
    for (std::size_t k = 0; k < count; ++k) {
      const RealBall along =
          divide(dot_of_balls(middle, item(part.other, k)), middle_length, ball_bits);
      if (!along.is_finite()) return std::nullopt;
      if (!slowest || along.lower() < *slowest) slowest = along.lower();
    }
    if (*slowest < Rational(3, 4) * fastest.upper()) return std::nullopt;
    const Rational sine = difference.upper() / *slowest;
    if (sine > Rational(1, 2)) return std::nullopt;
    const RealBall s(sine, ball_bits);
    const RealBall cosine =
        sqrt(subtract({1, ball_bits}, multiply(s, s, ball_bits), ball_bits), ball_bits);
    return divide(s, add({1, ball_bits}, cosine, ball_bits), ball_bits);
  }

  void add_part(const PairPart& part, const RealBall& tangent) {
    const std::size_t count = part.other[0].size();
    const auto given = [&](std::size_t k) {
      return phrame::sum(item(part.other, k), item(part.difference, k));
    };
    RealBall turns;
    for (std::size_t k = 1; k < count; ++k) {
      turns = add(turns, absolute(angle(item(part.other, k - 1), item(part.other, k))), ball_bits);
      turns = add(turns, absolute(angle(given(k - 1), given(k))), ball_bits);
    }
    sum_ = add_product(sum_, tangent, turns, ball_bits);
    if (is_first_of_piece_ && last_)  // the given tangent may jump
      sum_ = add_product(sum_, greater(tangent, last_->tangent),
                         absolute(angle(last_->given, given(0))), ball_bits);
    last_ = GivenEnd{given(count - 1), tangent};
    is_first_of_piece_ = false;
  }

  RealBall sum_;
  std::optional<GivenEnd> last_;
  bool is_first_of_piece_ = true;
};

}  // namespace

std::optional<Rational> rmf_difference_bound(const std::vector<HodographPair>& pieces) {
  DifferenceBound bound;
  for (const HodographPair& piece : pieces)
    if (!bound.add_piece(piece)) return std::nullopt;
  return bound.value().is_finite() ? std::optional(bound.value().upper()) : std::nullopt;
}

}  // namespace phrame
