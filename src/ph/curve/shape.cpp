#include "phrame/ph/curve/shape.hpp"

#include "phrame/algebra/linear_system.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/special_points.hpp"
#include "phrame/ph/curve/vector.hpp"

// The tangent is (x, y, z)/σ. It is constant where x, y, z are multiples of one polynomial, lies in
// a plane through 0 where n·(x, y, z) = 0, and in another plane, a·(x, y, z)/σ = c, where there is
// a relation that σ takes part in. That plane cuts the sphere in the circle of the tangents.

namespace phrame::inline v0 {
namespace {

/// The multiple of v ≠ 0 with coprime integer components by a positive number.
Vector<Rational> primitive(const Vector<Rational>& v) {
  const Rational factor = 1 / abs(content(Polynomial{v[0], v[1], v[2]}));
  return {factor * v[0], factor * v[1], factor * v[2]};
}

/// x, y, z and σ of the preimages, those of all in one polynomial each, one behind the other: the
/// relations that they have in common are relations of these.
std::vector<Polynomial> coordinates(const std::vector<QuaternionPolynomial>& preimages) {
  std::vector<Polynomial> all(4);
  long next = 0;
  for (const QuaternionPolynomial& a : preimages) {
    const auto [x, y, z] = rotated_i(a);
    const Polynomial behind = Polynomial::monomial(1, next);
    all[0] += behind * x;
    all[1] += behind * y;
    all[2] += behind * z;
    all[3] += behind * sigma(a);
    next += 2 * degree(a) + 1;
  }
  return all;
}

/// Without σ.
std::vector<std::vector<Rational>> relations_of_coordinates(std::vector<Polynomial> coordinates) {
  coordinates.pop_back();
  return linear_relations(coordinates);
}

std::vector<QuaternionPolynomial> preimages(const PhPath& path) {
  std::vector<QuaternionPolynomial> all;
  for (const Curve& curve : path.segments()) all.push_back(curve.preimage());
  return all;
}

std::optional<Vector<Rational>> common_normal(const std::vector<QuaternionPolynomial>& preimages) {
  const auto relations = relations_of_coordinates(coordinates(preimages));
  if (relations.empty()) return std::nullopt;
  const std::vector<Rational>& n = relations.front();
  return primitive({n[0], n[1], n[2]});
}

bool are_on_one_line(const std::vector<QuaternionPolynomial>& preimages) {
  return relations_of_coordinates(coordinates(preimages)).size() == 2;
}

std::optional<ConstantAngle> constant_angle(const std::vector<QuaternionPolynomial>& preimages) {
  const std::vector<Polynomial> all = coordinates(preimages);
  if (!relations_of_coordinates(all).empty()) return std::nullopt;
  const auto relations = linear_relations(all);
  if (relations.empty()) return std::nullopt;
  // r₀x + r₁y + r₂z + σ = 0.
  const std::vector<Rational>& r = relations.front();
  const Vector<Rational> direction{-r[0], -r[1], -r[2]};
  ConstantAngle result;
  result.axis = primitive(direction);
  result.cosine_squared = 1 / dot(direction, direction);
  for (std::size_t k = 0; k < 3; ++k)
    if (direction[k] != 0) result.constant = result.axis[k] / direction[k];
  return result;
}

}  // namespace

Polynomial dot(const Vector<Rational>& a, const Vector<Polynomial>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

std::optional<Vector<Rational>> line_direction(const QuaternionPolynomial& a) {
  if (!are_on_one_line({a})) return std::nullopt;
  const long m = degree(a);
  return primitive(rotated_i(RationalQuaternion{a.u.coefficient(m), a.v.coefficient(m),
                                                a.p.coefficient(m), a.q.coefficient(m)}));
}

std::optional<Vector<Rational>> line_direction(const PhPath& path) {
  if (!are_on_one_line(preimages(path))) return std::nullopt;
  return line_direction(path.segments().front().preimage());
}

std::optional<Vector<Rational>> plane_normal(const QuaternionPolynomial& a) {
  return common_normal({a});
}

std::optional<Vector<Rational>> plane_normal(const PhPath& path) {
  return common_normal(preimages(path));
}

std::optional<Helix> helix(const QuaternionPolynomial& a) {
  const auto angle = constant_angle({a});
  if (!angle) return std::nullopt;
  return Helix{*angle, (degree(a) * 2 - gcd(rotated_i(a)).degree()) / 2,
               odd(inflections(a, real_line())).empty()};
}

std::optional<ConstantAngle> helix(const PhPath& path) { return constant_angle(preimages(path)); }

}  // namespace phrame
