#pragma once
#include <memory>
#include <optional>

#include "phrame/algebra/angle.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/export.hpp"
#include "phrame/integrate/antiderivative.hpp"
#include "phrame/integrate/endpoint.hpp"

namespace phrame::inline v0 {

struct SimpleFraction;

/// The way to F(b) − F(a) between rational ends. Roots, once isolated, serve all values; the
/// quadrature of F′ needs none, but is done anew for each.
enum class Route {
  automatic,   ///< roots; quadrature for the first value, within a limit of points, where they are
               ///< many and all in clusters; a Taylor series where b is near to a
  roots,       ///< of the denominator of F′
  quadrature,  ///< Arb's, certified
  both         ///< which must agree
};

/// Evaluates F(b) − F(a) = ∫ F′ between rational ends, for many ends and rising precisions: the
/// poles are isolated once and refined when more precision is asked for. Any form of F gives the
/// same values: they are computed from the poles z of F′ and its residues c(z) there,
///   Σ c(z) · log((b − z)/(a − z)),
/// where the principal logarithm is the right branch, because t − z stays in one open half plane
/// (for real z: keeps its sign) on the way from a to b. Copies are cheap and share the
/// poles, and any thread may ask them; to move one is to copy it.
class PHRAME_API Evaluator {
 public:
  Evaluator() : Evaluator(Antiderivative{}, RationalFunction{}) {}  ///< of F = 0
  /// Of F.
  explicit Evaluator(const Antiderivative& F) : Evaluator(F, differentiate(F)) {}
  /// Of F with F′ = derivative, which is not checked. To differentiate costs as much as to
  /// integrate where residues are algebraic numbers of high degree.
  Evaluator(const Antiderivative& F, const RationalFunction& derivative);
  /// The same, with squarefree fractions known whose sum is the derivative of the logarithms.
  Evaluator(const Antiderivative& F, const RationalFunction& derivative,
            const std::vector<SimpleFraction>& of_logs);

  Evaluator(const Evaluator&) = default;
  Evaluator& operator=(const Evaluator&) = default;
  ~Evaluator() = default;

  const RationalFunction& derivative() const;  ///< F′
  /// The way to values from now on; that of copies stays.
  void set_route(Route route) { route_ = route; }
  Route route() const { return route_; }  ///< the way to values

  /// A ball around F(b) − F(a) with a radius ≤ 2^−bits · max(1, |F(b) − F(a)|), and on the
  /// automatic route, where b is near to a beside the poles, as narrow as short_integral's. Throws
  /// DomainError where F′ has a pole in [a, b] (decided by Sturm's theorem, the message names the
  /// pole) and Undecided where 64·bits + 65536 bits of precision, more for ends with many digits,
  /// or the quadrature that was asked for do not reach the radius. Throws Error should two routes
  /// not agree.
  RealBall difference(const Rational& a, const Rational& b, long bits) const;

  /// The same between ends of any kind: a ball around G(b) − G(a) for the branch G of F with |t −
  /// z| in the logarithms of real poles z, continuous between them. So it is the principal value
  /// where there are simple poles between the ends. At ±∞ it is the limit of what remains without
  /// the polynomial, the rational part and log|t|; in a convergent integral they tend to 0.
  /// Precondition: no end is a pole. Throws Undecided as above.
  RealBall branch_difference(const Endpoint& a, const Endpoint& b, long bits) const;

  /// The same, exact where it is seen to be rational. By Baker's theorem it is transcendental
  /// unless its logarithms cancel, and so its origin says where they are seen not to, so that
  /// correct rounding of the result ends; except where cancelling logarithms were not recognised.
  /// Throws as above.
  Real value(const Rational& a, const Rational& b) const;

  /// F(b) − F(a) + arg phase(b) − arg phase(a) + offset, the argument continuous, in the same
  /// manner: exact where π, logarithms and arguments cancel, or where there are none. That they
  /// cancel is decided for residues in ℚ(i) (Baker) and recognised in many other cases.
  /// Precondition: no pole in [a, b], and `enclose` gives balls around this number.
  Real value(const Rational& a, const Rational& b, const GaussianPolynomial& phase,
             const Real::Enclosure& enclose, const Angle& offset = {}) const;

  /// The logarithms in F(b) − F(a) plus arg phase(b) − arg phase(a), over π, where this is
  /// rational: decided for residues in ℚ(i) (Baker) and recognised in many other cases; no value
  /// means that it is irrational or not recognised. Precondition: no pole in [a, b].
  std::optional<Rational> multiple_of_pi(const Rational& a, const Rational& b,
                                         const GaussianPolynomial& phase) const;

  /// P with F = arg P + constant, so that e^{iF} is P/|P| up to a constant factor. No value where
  /// there is none: where F has more than logarithms, or F′ a residue that is not in (i/2)ℤ, as a
  /// ball around it proves for most F. Cost: where there is one, that of over_residues().
  std::optional<GaussianPolynomial> single_argument() const;

 private:
  struct Function;  ///< F, and what has been found out about it

  std::optional<RealBall> cheap_quadrature(const Rational& a, const Rational& b, long bits) const;

  std::shared_ptr<const Function> function_;
  Route route_ = Route::automatic;
};

}  // namespace phrame
