#include "phrame/ph/curve/rotation.hpp"

#include <algorithm>

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

/// Its axes.
Columns axes_of(const RationalQuaternion& p) {
  const Rational scale = 1 / norm(p);
  return {scale * rotated_i(p), scale * rotated_j(p), scale * rotated_k(p)};
}

}  // namespace

std::string name_of(const TangentAxis& axis) {
  return std::string(axis.is_reversed ? "-" : "") + "xyz"[axis.axis];
}

std::optional<Orientation> nearest_rotation(const std::array<Vector<Rational>, 3>& columns) {
  if (!is_orthonormal(columns, Rational(1, 100))) return std::nullopt;
  if (is_orthonormal(columns, 0)) return Orientation{quaternion_of(columns), 0};
  const RationalQuaternion near = quaternion_of(polar_factor(columns));
  const Rational size = std::max({abs(near.u), abs(near.v), abs(near.p), abs(near.q)});
  constexpr long places = 64;
  const RationalQuaternion p = rounded_to_places(Rational(1 / size) * near, places);
  const Columns axes = axes_of(p);
  Rational square;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector<Rational> off = axes[k] - columns[k];
    square = std::max(square, dot(off, off));
  }
  return Orientation{p, square_root_above(square)};
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
