// A cubic c with the positions and derivatives of a part of X/W at both ends, rounded; |X/W − c| is
// at most √(Dx² + Dy²)/w with the greatest Bernstein coefficients of D = X − Wc and the least one
// of W, w > 0. A part of which that is too much, or w ≤ 0, is halved.
#include "phrame/ph/curve/plane_cubics.hpp"

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"

namespace phrame::inline v0 {
namespace {

class CubicFit {
 public:
  explicit CubicFit(const Rational& tolerance)
      : tolerance_(tolerance), unit_(power_of_ten(decimal_exponent(tolerance) - 3)) {}

  void add(const RationalCurve& curve, const Rational& from, const Rational& to) {
    const Polynomial t{from, to - from};
    const std::array<Polynomial, 2> x{compose(curve.numerator()[0], t),
                                      compose(curve.numerator()[1], t)};
    const Polynomial w = compose(curve.weight(), t);
    PlaneCubic cubic;
    for (std::size_t k = 0; k < 2; ++k) {
      const auto rate = [&](const Rational& at) {
        return (differentiate(x[k])(at) * w(at) - x[k](at) * differentiate(w)(at)) /
               (w(at) * w(at));
      };
      const Rational start = x[k](0) / w(0);
      const Rational end = x[k](1) / w(1);
      cubic[0][k] = rounded(start);
      cubic[1][k] = rounded(start + rate(0) / 3);
      cubic[2][k] = rounded(end - rate(1) / 3);
      cubic[3][k] = rounded(end);
    }
    if (is_near(cubic, x, w)) {
      made_.push_back({cubic, from, to});
      return;
    }
    const Rational middle = (from + to) / 2;
    add(curve, from, middle);
    add(curve, middle, to);
  }

  std::vector<CubicPart> made() && { return std::move(made_); }

 private:
  Rational rounded(const Rational& x) const {
    return unit_ * Rational(floor(x / unit_ + Rational(1, 2)));
  }

  bool is_near(const PlaneCubic& cubic, const std::array<Polynomial, 2>& x,
               const Polynomial& w) const {
    const std::vector<Rational> weights = to_bernstein(w, std::max(w.degree(), 0L));
    const Rational least = *std::ranges::min_element(weights);
    if (least <= 0) return false;
    Rational square;
    for (std::size_t k = 0; k < 2; ++k) {
      const Polynomial c = from_bernstein({cubic[0][k], cubic[1][k], cubic[2][k], cubic[3][k]});
      const Polynomial gap = x[k] - w * c;
      Rational most;
      for (const Rational& b : to_bernstein(gap, std::max(gap.degree(), 0L)))
        most = std::max(most, abs(b));
      square += most * most;
    }
    return square <= tolerance_ * tolerance_ * least * least;
  }

  Rational tolerance_;
  Rational unit_;  ///< of the control points
  std::vector<CubicPart> made_;
};

}  // namespace

std::vector<CubicPart> plane_cubics(const RationalCurve& curve, const Rational& from,
                                    const Rational& to, const Rational& tolerance) {
  CubicFit fit(tolerance);
  fit.add(curve, from, to);
  return std::move(fit).made();
}

std::vector<PlaneCubic> plane_cubics(const Path& path, const Rational& tolerance) {
  std::vector<PlaneCubic> made;
  for (const Segment& segment : path.segments()) {
    const RationalCurve* curve = rational_curve(segment);
    if (curve == nullptr) throw DomainError("plane_cubics: a segment is given by formulas");
    for (const CubicPart& part : plane_cubics(*curve, 0, 1, tolerance)) made.push_back(part.cubic);
  }
  return made;
}

}  // namespace phrame
