#pragma once
#include "phrame/algebra/least_squares.hpp"

namespace phrame::inline v0 {

// Guesses where there is one unknown more than there are equations, so that solutions are a curve:
// to it, and along it.

/// Newton's iteration to a solution of F(z) = 0, damped: of z − part·step(z, F(z)) the first that
/// makes |F| less, part = 1, 1/2, … down to `least_part`. The |F| that is reached, in so many steps
/// at most or when it is no more than `rounding`.
template <std::size_t n, class F, class Step>
double damped_newton(std::array<double, n>& z, const F& lack, const Step& step, int most_steps,
                     double rounding, double least_part) {
  auto off = lack(z);
  double size = euclidean_norm(off);
  for (int k = 0; k < most_steps && size > rounding; ++k) {
    const std::vector<double> change = step(z, off);
    std::array<double, n> next;
    double then = size;
    for (double part = 1; !(then < size); part /= 2) {
      next = moved(z, -part, change);
      off = lack(next);
      then = euclidean_norm(off);
      if (!(part > least_part)) break;
    }
    if (!(then < size)) break;
    z = next;
    size = then;
  }
  return size;
}

/// Downhill along the solutions, in steps that are halved where neither way goes down, until they
/// are no more than `least_step`: along(z) is the direction, solved(z) finds the solution next to
/// z, if it does. The energy that is reached.
template <std::size_t n, class Along, class Solve, class Energy>
double slide_downhill(std::array<double, n>& z, double step, double least_step, const Along& along,
                      const Solve& solved, const Energy& energy) {
  constexpr int most_moves = 200;
  double here = energy(z);
  for (int k = 0; k < most_moves && step > least_step; ++k) {
    const std::vector<double> direction = along(z);
    bool has_moved = false;
    for (const double way : {step, -step}) {
      std::array<double, n> next = moved(z, way, direction);
      if (!solved(next)) continue;
      const double there = energy(next);
      if (!(there < here * (1 - 1e-9))) continue;
      z = next;
      here = there;
      has_moved = true;
      break;
    }
    if (!has_moved) step /= 2;
  }
  return here;
}

}  // namespace phrame
