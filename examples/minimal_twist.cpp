// The three examples of R. T. Farouki and H. P. Moon, Rational frames of minimal twist along space
// curves under specified boundary conditions, Advances in Computational Mathematics 44 (2018), with
// the angles that their results need (docs/minimal-twist.md).
#include <fstream>
#include <iostream>
#include <sstream>

#include "phrame/phrame.hpp"

using namespace phrame;

namespace {

/// (θ_f − θ_i)/π of the three examples, whose curves are curves/farouki-moon-1.json and so on.
const std::vector<Rational> differences{Rational(-5, 8), Rational(-31, 40), Rational(3, 2)};

Curve example(int number) {
  std::ostringstream text;
  text << std::ifstream("curves/farouki-moon-" + std::to_string(number) + ".json").rdbuf();
  return read_curve(text.str()).curve;
}

std::string rounded(const Real& x, long digits) { return round_to_decimal(x, digits).value; }

Real ratio(const Real& a, const Real& b) {
  return Real([a, b](long bits) { return divide(a.enclose(bits), b.enclose(bits), bits); });
}

void print(const RationalTwist& twist, const TwistMinimum& minimum) {
  std::cout << "  [" << rounded(twist.piece().from, 6) << ", " << rounded(twist.piece().to, 6)
            << "]  gamma = " << rounded(twist.end_factor(), 20) << " (within "
            << upper_bound_text(twist.end_factor_change(minimum.radius))
            << ")  rms = " << rounded(ratio(twist.root_mean_square(), twist.piece().twist), 20)
            << "\n";
}

}  // namespace

int main() {
  for (int number = 1; number <= 3; ++number) {
    const Curve curve = example(number);
    PathAngle rmf{PhPath(curve)};
    const FrameAngle end{differences[static_cast<std::size_t>(number - 1)], 0};
    const MinimalTwist mtf(rmf, FrameAngle{}, end);
    std::cout << "example " << number << ": T = " << rounded(mtf.nominal_twist(), 20)
              << ", T_min = " << rounded(mtf.twist(), 20) << "\n";
    const RationalTwistOptions options;
    const TwistFrame whole = twist_frame(mtf, options, {});
    const BestTwist& best = whole.pieces.front();
    if (!best.minimum) return 1;
    print(best.twist, *best.minimum);

    if (number != 3) continue;
    Subdivision sharp;  // at the sharper extremum of ω₁
    const RealRoot at = odd_inside(erf_turning(curve).extrema).back();
    sharp.at = {enclose(at.at, 100).midpoint()};
    for (const BestTwist& piece : twist_frame(mtf, options, sharp).pieces) {
      if (!piece.minimum) return 1;
      print(piece.twist, *piece.minimum);
    }
  }
  return 0;
}
