// The tangent is q i q* of a rational quaternion q, over |q|². Along an arc by the angle α about
// the axis a = cos φ f₂ + sin φ f₃ it is that of q·A with A = 1 − t + tωB and
//   B = cos(α/2) + sin(α/2)(cos φ j + sin φ k),
// rational where tan(α/4) and tan(φ/2) are. |A|² is the weight of an arc with the weights 1,
// ω cos(α/2), ω². From the center a point is at R·q A u A* q*, u = i × a, since a × u = i.
#include "phrame/ph/sweep/near_pipe.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/ellipse_arc.hpp"
#include "phrame/ph/curve/scale.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

/// Where a piece begins: a place, and a frame.
struct PipeEnd {
  Vector<Rational> place;
  RationalQuaternion frame;
};

/// X/W.
struct PipePiece {
  Vector<Polynomial> numerator;
  Polynomial weight;
};

/// q whose q i q* has the direction of T, or nearly.
RationalQuaternion frame_along(const Vector<Rational>& tangent) {
  const Rational size = near_root(dot(tangent, tangent));
  if (size + tangent[0] <= 0) return {0, 0, 1, 0};
  const Rational unit = 1 / size;
  return {1 + unit * tangent[0], 0, -unit * tangent[2], unit * tangent[1]};
}

/// The share of the way that the line has gone at t is that of the given one.
PipePiece line_from(PipeEnd& from, const RationalCurve& given) {
  const Vector<Rational> start = point(given, 0);
  const Vector<Rational> way = point(given, 1) - start;
  const Rational square = dot(way, way);
  if (square == 0) throw DomainError("near_pipe: a line ends where it begins");
  const Vector<Rational> step =
      Rational(near_root(square) / norm(from.frame)) * rotated_i(from.frame);
  const Vector<Polynomial> X = given.numerator();
  Polynomial gone;
  for (std::size_t k = 0; k < 3; ++k)
    gone += Rational(way[k] / square) * (X[k] - start[k] * given.weight());
  PipePiece piece{{}, given.weight()};
  for (std::size_t k = 0; k < 3; ++k)
    piece.numerator[k] = from.place[k] * piece.weight + step[k] * gone;
  from.place = from.place + step;
  return piece;
}

PipePiece arc_from(PipeEnd& from, const RationalCurve& given, const Vector<Rational>& axis) {
  const Vector<Rational> first = evaluate(given.direction(), 0);
  const Vector<Rational> last = evaluate(given.direction(), 1);
  const Rational sizes = near_root(dot(first, first) * dot(last, last));
  const auto [cosine, sine] =
      near_direction({sizes + dot(first, last), near_root(dot(axis, axis))});  // of half the angle
  const auto [c, s] =
      near_direction({dot(axis, rotated_j(from.frame)), dot(axis, rotated_k(from.frame))});
  const Vector<Rational> chord = point(given, 1) - point(given, 0);
  const Rational radius = near_root(dot(chord, chord)) / (2 * sine);
  const Rational ratio = near_root(given.weight()(1) / given.weight()(0));
  const Polynomial t{0, 1};
  const RationalQuaternion turn{cosine, 0, sine * c, sine * s};
  const QuaternionPolynomial A{Polynomial{1} - t + Rational(ratio * turn.u) * t,
                               {},
                               Rational(ratio * turn.p) * t,
                               Rational(ratio * turn.q) * t};
  const RationalQuaternion& q = from.frame;
  const QuaternionPolynomial Q = QuaternionPolynomial{{q.u}, {q.v}, {q.p}, {q.q}} * A;
  const auto radial = [c = c, s = s](const auto& frame) {
    const auto j = rotated_j(frame);
    const auto k = rotated_k(frame);
    auto sum = j;
    for (std::size_t n = 0; n < 3; ++n) sum[n] = c * k[n] - s * j[n];
    return sum;
  };
  const Rational scale = radius / norm(q);
  const Vector<Rational> center = from.place - scale * radial(q);
  const Vector<Polynomial> out = radial(Q);
  PipePiece piece{{}, norm(A)};
  for (std::size_t k = 0; k < 3; ++k)
    piece.numerator[k] = center[k] * piece.weight + scale * out[k];
  from = {Rational(1 / piece.weight(1)) * evaluate(piece.numerator, 1), q * turn};
  return piece;
}

/// |X/W − Y/V| ≤ this on [0, 1], by the Bernstein coefficients of XV − YW and of WV.
Rational greatest_distance(const RationalCurve& given, const PipePiece& piece) {
  const Polynomial below = given.weight() * piece.weight;
  const Vector<Polynomial> X = given.numerator();
  Rational square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Polynomial off = X[k] * piece.weight - piece.numerator[k] * given.weight();
    Rational most = 0;
    for (const Rational& c : to_bernstein(off, std::max(0L, off.degree())))
      most = std::max(most, Rational(abs(c)));
    square += most * most;
  }
  const std::vector<Rational> weights = to_bernstein(below, std::max(0L, below.degree()));
  const Rational least = *std::ranges::min_element(weights);
  if (least <= 0) throw DomainError("near_pipe: the weights of an arc are not positive");
  return square == 0 ? Rational(0) : Rational(square_root_above(square) / least);
}

}  // namespace

NearPipe near_pipe(const Path& path) {
  std::vector<Segment> segments;
  Rational distance = 0;
  std::optional<PipeEnd> end;
  for (std::size_t k = 0; k < path.segments().size(); ++k) {
    const RationalCurve* given = rational_curve(path.segments()[k]);
    if (given == nullptr || degree(*given) > 2)
      throw DomainError(fmt::format("near_pipe: segment {} is neither a line nor an arc", k + 1));
    const Vector<Rational> first = evaluate(given->direction(), 0);
    if (!end) end = PipeEnd{point(*given, 0), frame_along(first)};
    const Vector<Rational> axis = cross(first, evaluate(given->direction(), 1));
    const bool is_line = binormal(*given) == Vector<Polynomial>{};
    if (!is_line && axis == Vector<Rational>{})
      throw DomainError(fmt::format("near_pipe: segment {} is half a turn or more", k + 1));
    const PipePiece piece = is_line ? line_from(*end, *given) : arc_from(*end, *given, axis);
    distance = std::max(distance, greatest_distance(*given, piece));
    segments.emplace_back(RationalCurve(piece.numerator, piece.weight));
  }
  return {joined(std::move(segments)), distance};
}

}  // namespace phrame
