// L = log(1 − t/ζ), a root adds 2·Re(cL) to the angle, and |dL/dζ| = |t|/|ζ(t − ζ)|.
#include "phrame/ph/proof/disc_laws.hpp"

#include <algorithm>

#include "phrame/algebra/ball_log.hpp"
#include "phrame/algebra/ball_order.hpp"

namespace phrame::inline v0 {
namespace {

/// Does the disc meet none of another sum?
bool is_alone(const RootDisc& disc, const CertifiedLogs& its,
              const std::vector<CertifiedLogs>& logs) {
  for (const CertifiedLogs& sum : logs)
    for (const RootDisc& other : sum.roots)
      if (&sum != &its && !are_apart(disc, other)) return false;
  return true;
}

}  // namespace

bool shows_residue_outside_multiples_of_i(const std::vector<CertifiedLogs>& logs, long bits) {
  const Integer unit = Integer(1) << static_cast<unsigned long>(bits);
  for (const CertifiedLogs& sum : logs)
    for (const RootDisc& disc : sum.roots) {
      const Integer above = modulo(disc.residue.im, unit);  // of the next lower point of iℤ
      const Integer distance = std::min(above, Integer(unit - above));
      if (norm(GaussianInteger{disc.residue.re, distance}) >
              disc.residue_radius * disc.residue_radius &&
          is_alone(disc, sum, logs))
        return true;
    }
  return false;
}

LogsByDiscs logs_by_discs(const Certificate& c, const Rational& t, long precision) {
  const long p = precision;
  const auto real = [&](const Integer& n) {
    return times_power_of_two(RealBall(Rational(n), p), -c.bits);
  };
  const auto sum = [&](const RealBall& a, const RealBall& b) { return add(a, b, p); };
  const auto product = [&](const RealBall& a, const RealBall& b) { return multiply(a, b, p); };
  const RealBall at(t, p);
  LogsByDiscs found;
  for (const CertifiedLogs& log_sum : c.logs)
    for (const RootDisc& disc : log_sum.roots) {
      const RealBall x = real(disc.center.re);
      const RealBall y = real(disc.center.im);
      const RealBall r = real(disc.radius);
      const RealBall s = real(disc.residue_radius);
      const RealBall re = real(disc.residue.re);
      const RealBall im = real(disc.residue.im);
      const RealBall minus_y = subtract(RealBall(), y, p);
      const ComplexBall to_t(subtract(at, x, p), minus_y);
      const ComplexBall to_zero(subtract(RealBall(), x, p), minus_y);
      const ComplexBall L = subtract(log(to_t, p), log(to_zero, p), p);
      found.at_centers =
          sum(found.at_centers,
              times_power_of_two(subtract(product(re, L.re()), product(im, L.im()), p), 1));
      const RealBall size = sum(absolute(ComplexBall(re, im), p), s);
      const RealBall near =
          product(subtract(absolute(to_t, p), r, p), subtract(absolute(to_zero, p), r, p));
      const RealBall by_root = divide(product(product(size, r), absolute(at)), near, p);
      const RealBall by_residue = product(s, sum(absolute(L.re()), absolute(L.im())));
      found.off = sum(found.off, times_power_of_two(sum(by_root, by_residue), 1));
    }
  return found;
}

}  // namespace phrame
