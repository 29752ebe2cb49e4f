#include "phrame/ph/curve/shape.hpp"

#include "phrame/algebra/linear_system.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/special_points.hpp"

// The tangent is (x, y, z)/σ. It is constant where x, y, z are multiples of one polynomial, lies in
// a plane through 0 where n·(x, y, z) = 0, and in another plane, a·(x, y, z)/σ = c, where there is
// a relation that σ takes part in. That plane cuts the sphere in the circle of the tangents.

namespace phrame {
namespace {

/// The multiple of v ≠ 0 with coprime integer components by a positive number.
Vector<Rational> primitive(const Vector<Rational>& v) {
  const Rational factor = 1 / abs(content(Polynomial{v[0], v[1], v[2]}));
  return {factor * v[0], factor * v[1], factor * v[2]};
}

Rational squared_length(const Vector<Rational>& v) {
  return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
}

std::vector<std::vector<Rational>> relations_of_coordinates(const QuaternionPolynomial& a) {
  const auto [x, y, z] = rotated_i(a);
  return linear_relations({x, y, z});
}

}  // namespace

Polynomial dot(const Vector<Rational>& a, const Vector<Polynomial>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

std::optional<Vector<Rational>> line_direction(const QuaternionPolynomial& a) {
  if (relations_of_coordinates(a).size() != 2) return std::nullopt;
  const long m = degree(a);
  return primitive(rotated_i(RationalQuaternion{a.u.coefficient(m), a.v.coefficient(m),
                                                a.p.coefficient(m), a.q.coefficient(m)}));
}

std::optional<Vector<Rational>> plane_normal(const QuaternionPolynomial& a) {
  const auto relations = relations_of_coordinates(a);
  if (relations.empty()) return std::nullopt;
  const std::vector<Rational>& n = relations.front();
  return primitive({n[0], n[1], n[2]});
}

std::optional<Helix> helix(const QuaternionPolynomial& a) {
  if (!relations_of_coordinates(a).empty()) return std::nullopt;
  const auto [x, y, z] = rotated_i(a);
  const auto relations = linear_relations({x, y, z, sigma(a)});
  if (relations.empty()) return std::nullopt;
  // r₀x + r₁y + r₂z + σ = 0.
  const std::vector<Rational>& r = relations.front();
  const Vector<Rational> direction{-r[0], -r[1], -r[2]};
  Helix result;
  result.axis = primitive(direction);
  result.cosine_squared = 1 / squared_length(direction);
  for (std::size_t k = 0; k < 3; ++k)
    if (direction[k] != 0) result.constant = result.axis[k] / direction[k];
  result.map_degree = (degree(a) * 2 - gcd(gcd(x, y), z).degree()) / 2;
  result.is_monotone = odd(inflections(a, real_line())).empty();
  return result;
}

}  // namespace phrame
