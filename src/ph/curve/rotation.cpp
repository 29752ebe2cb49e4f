#include "phrame/ph/curve/rotation.hpp"

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/ellipse_arc.hpp"
#include "phrame/ph/curve/scale.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

using Columns = std::array<Vector<Rational>, 3>;

bool is_orthonormal(const Columns& m, const Rational& within) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j <= i; ++j)
      if (abs(dot(m[i], m[j]) - (i == j ? 1 : 0)) > within) return false;
  return dot(cross(m[0], m[1]), m[2]) > 0;
}

/// P of a rotation matrix, up to its length: of 4·P_a·P_b, of which the matrix has all, the row
/// with the greatest square (src/ph/frame/frame_quaternion.cpp).
RationalQuaternion quaternion_of(const Columns& m) {
  const auto& [x, y, z] = m;
  const std::array<RationalQuaternion, 4> rows{
      {{1 + x[0] + y[1] + z[2], y[2] - z[1], z[0] - x[2], x[1] - y[0]},
       {y[2] - z[1], 1 + x[0] - y[1] - z[2], x[1] + y[0], z[0] + x[2]},
       {z[0] - x[2], x[1] + y[0], 1 - x[0] + y[1] - z[2], y[2] + z[1]},
       {x[1] - y[0], z[0] + x[2], y[2] + z[1], 1 - x[0] - y[1] + z[2]}}};
  const std::array<Rational, 4> squares{rows[0].u, rows[1].v, rows[2].p, rows[3].q};
  return rows[static_cast<std::size_t>(std::max_element(squares.begin(), squares.end()) -
                                       squares.begin())];
}

// X ↦ (X + X⁻ᵀ)/2 squares the distance to the orthogonal factor of the polar decomposition, which
// is the nearest rotation [Higham 1986]; from 1/100 on five steps are enough for 100 bits.
Columns polar_factor(Columns m) {
  constexpr long places = 160;
  for (int step = 0; step < 6; ++step) {
    const Rational determinant = dot(cross(m[0], m[1]), m[2]);
    Columns next;
    for (std::size_t k = 0; k < 3; ++k) {
      next[k] = Rational(1, 2) *
                (m[k] + Rational(1 / determinant) * cross(m[(k + 1) % 3], m[(k + 2) % 3]));
      for (Rational& x : next[k]) x = rounded_to_places(x, places);
    }
    m = next;
  }
  return m;
}

}  // namespace

std::array<Vector<Rational>, 3> rotation_columns(const RationalQuaternion& p) {
  const Rational scale = 1 / norm(p);
  return {scale * rotated_i(p), scale * rotated_j(p), scale * rotated_k(p)};
}

std::string name_of(const TangentAxis& axis) {
  return std::string(axis.is_reversed ? "-" : "") + "xyz"[axis.axis];
}

const std::vector<std::pair<std::string, TangentAxis>>& tangent_axes() {
  static const auto axes = [] {
    std::vector<std::pair<std::string, TangentAxis>> list;
    for (const bool is_reversed : {false, true})
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const TangentAxis tangent{axis, is_reversed};
        list.emplace_back(name_of(tangent), tangent);
      }
    return list;
  }();
  return axes;
}

std::optional<Orientation> nearest_rotation(const std::array<Vector<Rational>, 3>& columns) {
  if (!is_orthonormal(columns, Rational(1, 100))) return std::nullopt;
  if (is_orthonormal(columns, 0)) return Orientation{quaternion_of(columns), 0};
  const RationalQuaternion near = quaternion_of(polar_factor(columns));
  const Rational size = std::max({abs(near.u), abs(near.v), abs(near.p), abs(near.q)});
  constexpr long places = 64;
  const RationalQuaternion p = rounded_to_places(Rational(1 / size) * near, places);
  const Columns axes = rotation_columns(p);
  Rational square;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector<Rational> off = axes[k] - columns[k];
    square = std::max(square, dot(off, off));
  }
  return Orientation{p, square_root_above(square)};
}

namespace {

/// The cosine of an angle where that and the angle over π are fractions, as of multiples of 60° and
/// 90° only [Niven 1956]; and is the sine < 0?
std::optional<std::pair<Rational, bool>> rational_cosine(const Angle& angle) {
  const Rational turns = angle.half_turns / 2;
  const Rational part = 12 * (turns - Rational(floor(turns)));
  if (angle.radians != 0 || denominator(part) != 1) return std::nullopt;
  const auto twelfth = static_cast<std::size_t>(static_cast<long>(numerator(part)));
  constexpr std::array<long, 12> twice_cosine{2, 9, 1, 0, -1, 9, -2, 9, -1, 0, 1, 9};
  if (twice_cosine[twelfth] == 9) return std::nullopt;
  return std::pair(Rational(twice_cosine[twelfth], 2), twelfth > 6);
}

}  // namespace

// P = 1 + tan(α/2)·n, and tan(α/2) = sin α/(1 + cos α), tan²(α/2) = (1 − cos α)/(1 + cos α).
RationalQuaternion rotation_about(const Vector<Rational>& axis, const Angle& angle) {
  const Rational square = dot(axis, axis);
  if (square == 0) throw DomainError("rotation: the axis is 0");
  if (const auto known = rational_cosine(angle)) {
    const auto& [cosine, is_negative] = *known;
    if (cosine == -1) return {0, axis[0], axis[1], axis[2]};
    if (const auto factor = square_root((1 - cosine) / ((1 + cosine) * square))) {
      const Vector<Rational> n = (is_negative ? -*factor : *factor) * axis;
      return {1, n[0], n[1], n[2]};
    }
  }
  const PlaneVector turns = rotation_by_degrees(180 * angle.half_turns);
  const PlaneVector rest = rotation_by_radians(angle.radians);
  const Rational cosine = turns[0] * rest[0] - turns[1] * rest[1];
  const Rational sine = turns[0] * rest[1] + turns[1] * rest[0];
  constexpr long bits = 160;
  const Rational length = sqrt_of_nonnegative(RealBall(square, bits), bits).midpoint();
  const Vector<Rational> n = Rational(sine / ((1 + cosine) * length)) * axis;
  return {1, n[0], n[1], n[2]};
}

// With G: i, j, k ↦ the axis and the next two, the frame of the body P is P·G; and j + k turns i,
// j, k to −i, k, j.
Quaternion<Integer> frame_rotation(const RationalQuaternion& body, const TangentAxis& tangent) {
  constexpr std::array<long, 3> next{0, 1, -1};  // 1 ± (i + j + k)
  const Rational s = next[tangent.axis];
  RationalQuaternion p = body * RationalQuaternion{1, s, s, s};
  if (tangent.is_reversed) p = p * RationalQuaternion{0, 0, 1, 1};
  const Rational size =
      common_content({Polynomial{p.u}, Polynomial{p.v}, Polynomial{p.p}, Polynomial{p.q}});
  return each(p, [&](const Rational& x) { return Integer(numerator(Rational(x / size))); });
}

}  // namespace phrame
