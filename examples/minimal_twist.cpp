// The three examples of R. T. Farouki and H. P. Moon, Rational frames of minimal twist along space
// curves under specified boundary conditions, Advances in Computational Mathematics 44 (2018), with
// the angles that their results need (docs/minimal-twist.md). With an argument, the folder for
// them, it writes the curves of figures 2, 3, 4, 6, 7, 8, 10, 11 and 12 as CSV.
#include <cmath>
#include <filesystem>
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

/// The rates of a rational frame about e₁ per unit of arc length, at τ on its piece.
struct Rates {
  double erf;       ///< ω₁
  double rotation;  ///< θ′/σ
  double speed;     ///< σ
};

Rates rates_at(const TwistPiece& piece, const Rotation& w, const Rational& tau) {
  const RealBall at(tau, 128);
  const double speed = static_cast<double>(piece.speed(tau)) * static_cast<double>(piece.length);
  const double turn = 2 * approximate(divide(evaluate(wronskian(w, 128), at, 128),
                                             evaluate(norm(w, 128), at, 128), 128));
  return {static_cast<double>(piece.erf_rate(tau)) / speed, turn / speed, speed};
}

constexpr long samples = 400;

/// ω₁, θ′/σ, Ω₁ and Ω̄₁ along a frame.
void write_rates(const std::filesystem::path& name, const MinimalTwist& mtf,
                 const std::vector<RationalTwist>& frame) {
  std::ofstream file(name);
  file.precision(12);
  file << "t,s,omega,theta,Omega,mean\n";
  const double mean = approximate(mtf.rate().enclose(64));
  const Polynomial length = arc_length(mtf.path().segments().front());
  for (const RationalTwist& twist : frame) {
    const TwistPiece& piece = twist.piece();
    for (long k = 0; k <= samples; ++k) {
      const Rational tau(k, samples);
      const Rational t = piece.from + (piece.to - piece.from) * tau;
      const Rates rates = rates_at(piece, twist.rotation(128), tau);
      file << static_cast<double>(t) << ',' << static_cast<double>(length(t)) << ',' << rates.erf
           << ',' << rates.rotation << ',' << rates.erf + rates.rotation << ',' << mean << '\n';
    }
  }
}

/// The frame with this γ: the parameter p of the line with γ(p) = γ.
RationalTwist with_gamma(const TwistPiece& piece, double gamma) {
  const RotationFamily family = rotation_family(piece, 2, EndRates::matched, 64);
  const double p = (gamma - approximate(family.end_factor[0])) / approximate(family.end_factor[1]);
  return {piece, 2, EndRates::matched, {exact_rational(p)}};
}

double relative_error(const RationalTwist& twist) {
  return approximate(twist.root_mean_square().enclose(40)) /
         std::abs(approximate(twist.piece().twist.enclose(64)));
}

void write_errors(const std::filesystem::path& name, const TwistPiece& piece) {
  std::ofstream file(name);
  file << "gamma,rms\n";
  for (double gamma = -2; gamma <= 2.001; gamma += 0.02)
    if (std::abs(gamma) > 0.05)
      file << gamma << ',' << relative_error(with_gamma(piece, gamma)) << '\n';
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

int main(int argc, char** argv) {
  const std::optional<std::filesystem::path> folder =
      argc > 1 ? std::optional<std::filesystem::path>(argv[1]) : std::nullopt;
  for (int number = 1; number <= 3; ++number) {
    const Curve curve = example(number);
    PathAngle rmf{Path(curve)};
    const FrameAngle end{differences[static_cast<std::size_t>(number - 1)], 0};
    const MinimalTwist mtf(rmf, FrameAngle{}, end);
    std::cout << "example " << number << ": T = " << rounded(mtf.nominal_twist(), 20)
              << ", T_min = " << rounded(mtf.twist(), 20) << "\n";
    const RationalTwistOptions options;
    const TwistFrame whole = twist_frame(mtf, options, {});
    const BestTwist& best = whole.pieces.front();
    if (!best.minimum) return 1;
    print(best.twist, *best.minimum);

    Subdivision sharp;  // at the sharper extremum of ω₁
    if (number == 3) {
      const RealRoot at = odd_inside(erf_turning(curve).extrema).back();
      sharp.at = {enclose(at.at, 100).midpoint()};
    }
    const TwistFrame divided = twist_frame(mtf, options, sharp);
    std::vector<RationalTwist> frame;
    for (const BestTwist& piece : divided.pieces) {
      if (!piece.minimum) return 1;
      if (number == 3) print(piece.twist, *piece.minimum);
      frame.push_back(piece.twist);
    }
    if (!folder) continue;
    std::filesystem::create_directories(*folder);
    const std::string suffix = std::to_string(number) + ".csv";
    write_errors(*folder / ("errors-" + suffix), best.twist.piece());
    write_rates(*folder / ("rates-" + suffix), mtf, {best.twist});
    if (number == 1)  // figure 6: the other sign of γ
      write_rates(*folder / "rates-1-poor.csv", mtf, {with_gamma(best.twist.piece(), -1)});
    if (number == 3) write_rates(*folder / "rates-3-divided.csv", mtf, frame);
  }
  return 0;
}
