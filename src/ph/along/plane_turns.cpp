// Along a plane curve its normal N is in the normal plane, and at rest: it keeps its angle to the
// rotation-minimizing frame. Seen from the frame of v, e₂ ~ v × H and e₃ ~ H × (v × H)/|H|,
//   N·(v × H) + i·(N·v)·|H|
// has the argument of N. At a joint, or behind a line, the next normal M is turned against it about
// e₁ by the argument of
//   N·M + i·(N × M)·e₁,  (N × M)·e₁ = ±|N × M|.
// The least rotation at a corner with the tangents a and b leaves a × b at rest, which is the
// normal of a plane that the frame is in for a moment.

#include "phrame/ph/along/plane_turns.hpp"

#include <algorithm>
#include <mutex>

#include "phrame/ph/curve/direction_span.hpp"
#include "phrame/ph/curve/real_vector.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

/// Sums of arguments of more different roots take too long.
constexpr std::size_t most_turn_roots = 256;

/// H there, up to a positive factor; no value where that is not seen to be rational.
std::optional<Vector<Rational>> rational_direction(const Path& path, const Place& at) {
  return exactly(direction(path, at));
}

}  // namespace

struct PlaneTurns::State {
  /// A segment that is no line, or a corner.
  struct Piece {
    Vector<Rational> normal;  ///< of its plane
    Vector<Rational> axis{};  ///< the normal before × this one, along the tangent where it begins
    int side = 0;  ///< 1 where that has the direction of e₁, −1 the opposite, 0 for 0
  };

  Path path;
  Vector<Rational> v;
  std::vector<Piece> pieces{};
  std::vector<std::size_t> count{};  ///< of the pieces up to the end of a segment

  std::mutex lock{};
  std::size_t last = 0;   ///< the number of a piece
  AlgebraicAngle turn{};  ///< by which its normal is turned against the first one

  State(const Path& along, const Vector<Rational>& up);
  bool add_piece(const Vector<Rational>& normal, const Place& start);
  bool add_corner(std::size_t segment);
  std::optional<AlgebraicAngle> turn_of(std::size_t piece);
  AlgebraicAngle seen(std::size_t piece, const Vector<Rational>& H) const;
};

PlaneTurns::State::State(const Path& along, const Vector<Rational>& up) : path(along), v(up) {
  for (std::size_t k = 0; k < path.segments().size(); ++k) {
    if (path.has_corner(k) && !add_corner(k)) return;
    const auto span = direction_span(path.segments()[k]);
    if (!are_on_a_line(span)) {
      const auto normal = common_normal(span);
      if (!normal || !add_piece(*normal, {k, Rational(0)})) return;
    }
    count.push_back(pieces.size());
  }
}

/// No where the sign of what is not 0 is not seen.
bool PlaneTurns::State::add_piece(const Vector<Rational>& normal, const Place& start) {
  Piece piece{normal};
  if (!pieces.empty()) piece.axis = cross(pieces.back().normal, normal);
  piece.side = sign_of(dot(as_reals(piece.axis), direction(path, start)));
  pieces.push_back(piece);
  return piece.side != 0 || piece.axis == Vector<Rational>{};
}

/// That at the start of the segment. No likewise, and where its plane is not seen to be rational.
bool PlaneTurns::State::add_corner(std::size_t segment) {
  const Place before{segment - 1, Rational(1)};
  const auto a = rational_direction(path, before);
  const auto b = rational_direction(path, {segment, Rational(0)});
  return a && b && add_piece(cross(*a, *b), before);
}

/// By which the normal of this piece is turned against that of the first.
std::optional<AlgebraicAngle> PlaneTurns::State::turn_of(std::size_t piece) {
  const std::lock_guard locked(lock);
  if (last > piece) {
    last = 0;
    turn = {};
  }
  for (; last < piece; ++last) {
    const auto& [normal, axis, side] = pieces[last + 1];
    const Rational cosine = dot(pieces[last].normal, normal);
    if (turn.count_roots() > most_turn_roots) return std::nullopt;
    turn = turn + (side == 0 ? AlgebraicAngle::argument(cosine, 0, 1)
                             : AlgebraicAngle::argument(cosine, side, dot(axis, axis)));
  }
  return turn;
}

/// The angle of the normal to the frame of v where the tangent is along H.
AlgebraicAngle PlaneTurns::State::seen(std::size_t piece, const Vector<Rational>& H) const {
  const Vector<Rational>& normal = pieces[piece].normal;
  return AlgebraicAngle::argument(dot(normal, cross(v, H)), dot(normal, v), dot(H, H));
}

PlaneTurns::PlaneTurns(const Path& path, const Vector<Rational>& v)
    : state_(std::make_shared<State>(path, v)) {}

std::optional<AngleForm> PlaneTurns::at(const Place& at) const {
  if (at.segment >= state_->count.size()) return std::nullopt;
  const std::size_t count = state_->count[at.segment];
  if (count == 0) return AngleForm{0, [] { return AlgebraicAngle(); }};
  const bool is_line = at.segment > 0 && state_->count[at.segment - 1] == count;
  const auto start = rational_direction(state_->path, {0, Rational(0)});
  const auto end = rational_direction(state_->path, is_line ? Place(at.segment, Rational(0)) : at);
  if (!start || !end) return std::nullopt;
  const auto rest = [state = state_, piece = count - 1, start = *start,
                     end = *end]() -> std::optional<AlgebraicAngle> {
    const auto turn = state->turn_of(piece);
    if (!turn) return std::nullopt;
    return state->seen(piece, end) + -state->seen(0, start) + -*turn;
  };
  return AngleForm{0, rest};
}

}  // namespace phrame
