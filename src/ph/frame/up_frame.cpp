#include "phrame/ph/frame/up_frame.hpp"

#include <algorithm>
#include <cmath>

#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

RealBall inner_product(const Vector<Rational>& a, const Vector<RealBall>& b, long bits) {
  RealBall sum;
  for (std::size_t k = 0; k < 3; ++k) sum = add_product(sum, RealBall(a[k], bits), b[k], bits);
  return sum;
}

/// v/|v|; 0 where that is not finite.
Vector<double> unit(const Vector<double>& v) {
  const double size = std::sqrt(dot(v, v));
  return size > 0 && std::isfinite(size) ? 1 / size * v : Vector<double>{};
}

/// The two unit vectors across the tangent, f₂ and e₁ × f₂.
struct Normals {
  Vector<double> f2;
  Vector<double> f3;
};

std::vector<Normals> approximate_normals(const std::vector<GivenFrame>& frames,
                                         const std::vector<FrameDeviation>& deviations) {
  std::vector<Normals> normals;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    if (!deviations[k].f2) continue;
    Vector<double> e1;
    Vector<double> f;
    for (std::size_t i = 0; i < 3; ++i) {
      e1[i] = approximate(deviations[k].e1[i]);
      f[i] = round_to_double(frames[k].f2[i]);
    }
    f = unit(f);
    f = unit(f - dot(f, e1) * e1);
    normals.push_back({f, cross(e1, f)});
  }
  return normals;
}

/// What all of these are orthogonal to, if anything is; 0 where they are nearly parallel.
Vector<double> common_normal(const std::vector<Normals>& normals, Vector<double> Normals::*which) {
  Vector<double> best{};
  for (const Normals& at : normals) {
    const Vector<double> c = cross(normals.front().*which, at.*which);
    if (dot(c, c) > dot(best, best)) best = c;
  }
  return dot(best, best) > 1e-6 ? best : Vector<double>{};
}

/// Along v with a greatest component of ±1, each the simplest fraction within ±δ.
Vector<Rational> simple_direction(const Vector<double>& v, const Rational& delta) {
  const double size = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
  Vector<Rational> result;
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational x = exact_rational(v[k] / size);
    result[k] = simplest_between(x - delta, x + delta);
  }
  return result;
}

}  // namespace

RealBall angle_to_up(const Vector<Rational>& f, const Vector<Rational>& v,
                     const Vector<RealBall>& e1, long bits) {
  // f·(v × e₁) and f·(e₁ × (v × e₁)) = f·v − (f·e₁)(v·e₁).
  const RealBall x = inner_product(cross(f, v), e1, bits);
  const RealBall y =
      subtract(RealBall(dot(f, v), bits),
               multiply(inner_product(f, e1, bits), inner_product(v, e1, bits), bits), bits);
  // The argument of an exact 0 is 0, by agreement.
  if (x.contains_zero() && y.contains_zero())
    return hull(subtract(RealBall(), pi(bits), bits), pi(bits), bits);
  return argument(ComplexBall(x, y), bits);
}

std::vector<Vector<Rational>> guessed_up_vectors(const std::vector<GivenFrame>& frames,
                                                 const std::vector<FrameDeviation>& deviations) {
  std::vector<Vector<Rational>> guesses;
  const std::vector<Normals> normals = approximate_normals(frames, deviations);
  if (normals.empty()) return guesses;
  // Where f₂ is along v × e₁, f₂ ⊥ v, and f₃ is along the projection of v; where f₂ is along that,
  // f₃ ⊥ v. The sign of v is that for which the angle of f₂ is near 0 or π/2, away from the cut.
  const auto add = [&](Vector<double> v, const Vector<double>& along) {
    if (dot(v, v) == 0) return;
    if (dot(v, along) < 0) v = -1.0 * v;
    for (const Rational& delta : {Rational(1, 1L << 17), Rational(1, 1L << 40)})
      guesses.push_back(simple_direction(v, delta));
  };
  add(common_normal(normals, &Normals::f2), normals.front().f3);
  add(common_normal(normals, &Normals::f3), normals.front().f2);
  return guesses;
}

}  // namespace phrame
