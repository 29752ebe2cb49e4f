#pragma once
#include <complex>
#include <map>
#include <span>

#include "phrame/ph/twist/rotation_family.hpp"

namespace phrame::inline v0 {

/// How far a rotation is from the constant rate, in doubles, for a search: nothing of it is proved.
///   G(w) = ∫₀¹ (erf_rate + θ′ − T·speed)²/speed dτ,
/// so that √G/|T| is the root mean square of Ω₁ − Ω̄₁ over |Ω̄₁| along the piece
/// [Farouki, Moon 2018, (36)].
class TwistObjective {
 public:
  TwistObjective(const TwistPiece& piece, const RotationFamily& family);

  /// G; infinite where the quadrature is not fine enough, as where w has a zero close to [0, 1].
  /// With a gradient where that is asked for, which then has a place for each parameter.
  double operator()(std::span<const double> parameters, std::span<double> gradient = {}) const;
  /// G′ and G″ of a family with one parameter.
  std::pair<double, double> derivatives(double parameter) const;

  const RotationFamily& family() const { return family_; }

  /// From now on G is infinite where the quadrature does not see the turn of this w, which all have
  /// that it can be changed to without a zero.
  void expect_turn_of(std::span<const double> parameters);

  /// Makes the quadrature, Gauss's with 15 points on parts of [0, 1], fine enough for this w.
  void resolve(std::span<const double> parameters);

 private:
  struct Node {
    double weight;
    double rate;  ///< erf_rate − T·speed
    double speed;
  };
  struct Term {
    std::complex<double> w;
    std::complex<double> slope;
  };
  /// Nodes, and the terms of w at each: w⁰, w¹, …
  struct Nodes {
    std::vector<Node> nodes;
    std::vector<Term> terms;
    void append(const Nodes& others);
  };
  struct Sums {
    double square = 0;  ///< G
    double turn = 0;    ///< ∫ (erf_rate + θ′ − T·speed), a whole multiple of 2π
  };

  /// The rates at one precision.
  struct Balls {
    long bits;
    BallPolynomial numerator;
    BallPolynomial denominator;
    BallPolynomial speed;
  };

  Balls balls_at(long bits) const;
  /// At τ = middle + offset.
  Node node_at(double middle, double offset, double weight);
  /// Computed once.
  const Nodes& nodes_between(double a, double b);
  Term member_at(const Nodes& nodes, std::size_t node, std::span<const double> parameters) const;
  Sums sums(const Nodes& nodes, std::span<const double> parameters) const;
  /// What rounding errors change in one term of G: E is a difference of rates, and w may nearly
  /// vanish.
  double noise_at(const Nodes& nodes, std::size_t node, std::span<const double> parameters) const;

  RotationFamily family_;
  double turn_;                  ///< Δθ
  std::optional<double> turns_;  ///< (∫θ′ − Δθ)/2π, where it is expected
  double twist_;
  std::vector<double> rate_numerator_;  ///< in Bernstein form, as the two others
  std::vector<double> rate_denominator_;
  std::vector<double> speed_;
  bool are_doubles_stable_;  ///< where the last two have one sign; else balls are needed
  RationalFunction exact_rate_;
  Polynomial exact_speed_;
  Balls balls_;  ///< at the precision that nodes have needed so far
  std::vector<std::vector<std::complex<double>>> basis_;  ///< in powers of τ
  std::map<std::pair<double, double>, Nodes> known_;      ///< by parts of [0, 1]
  Nodes nodes_;
};

}  // namespace phrame
