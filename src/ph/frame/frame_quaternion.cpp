#include "phrame/ph/frame/frame_quaternion.hpp"

#include <algorithm>

#include "phrame/ph/curve/real_vector.hpp"

namespace phrame::inline v0 {
namespace {

// The rotation matrix M = (e₁ e₂ e₃) of Q = u + v i + p j + q k has the diagonal
//   u² + v² − p² − q²,  u² − v² + p² − q²,  u² − v² − p² + q²,
// so that with u² + v² + p² + q² = 1 four times the squares are sums of it, and from rotated_i() to
// rotated_k() four times the products are sums and differences of entries beside it. One square is
// at least 1/4: divided by its root, the products with that component are the others, of which none
// loses accuracy.

/// 4·Q_a·Q_b for the components 0 … 3 = u, v, p, q.
using Products = std::array<std::array<Real, 4>, 4>;

Products products_of(const Frame<Real>& frame) {
  const auto& [x, y, z] = frame;  // the columns of M
  const Real one = Rational(1);
  const Real uv = y[2] + -z[1];
  const Real up = z[0] + -x[2];
  const Real uq = x[1] + -y[0];
  const Real vp = x[1] + y[0];
  const Real vq = z[0] + x[2];
  const Real pq = y[2] + z[1];
  return {{{one + x[0] + y[1] + z[2], uv, up, uq},
           {uv, one + x[0] + -y[1] + -z[2], vp, vq},
           {up, vp, one + -x[0] + y[1] + -z[2], pq},
           {uq, vq, pq, one + -x[0] + -y[1] + z[2]}}};
}

}  // namespace

Quaternion<Real> quaternion_of(const Frame<Real>& frame) {
  const Products products = products_of(frame);
  std::size_t pivot = 0;
  Rational greatest;  // of what is known of the squares
  for (long bits = 64; greatest < Rational(1, 2); bits *= 2)
    for (std::size_t k = 0; k < 4; ++k) {
      const RealBall ball = products[k][k].enclose(bits);
      if (!ball.is_finite() || ball.lower() <= greatest) continue;
      greatest = ball.lower();
      pivot = k;
    }
  const Real square = cached(Real(Rational(4)) * products[pivot][pivot]);  // (4·Q_pivot)²
  const auto component = [&](std::size_t k) {
    return over_square_root(products[pivot][k], square);
  };
  return {component(0), component(1), component(2), component(3)};
}

}  // namespace phrame
