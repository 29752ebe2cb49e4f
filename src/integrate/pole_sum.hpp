#pragma once
#include <memory>
#include <vector>

#include "phrame/algebra/near_poles.hpp"
#include "phrame/algebra/roots.hpp"
#include "phrame/algebra/shared.hpp"
#include "phrame/integrate/endpoint.hpp"

namespace phrame::inline v0 {

/// Σ c(z) · log(t − z) over the roots z of squarefree polynomials, which are isolated once, and
/// refined when more precision is asked for. Copies share what is known of the roots, and any
/// thread may ask them.
class PoleSum {
 public:
  /// n/d = Σ c(z)/(t − z) over the roots z of the squarefree d: c = n/d′.
  struct Term {
    Polynomial numerator;
    Polynomial denominator;
    Polynomial slope;  ///< d′
  };
  /// The z and c(z) of one d.
  struct Residues {
    Roots roots;
    std::vector<RealBall> real;      ///< c(z) at the real roots
    std::vector<ComplexBall> upper;  ///< and at those above the real axis
  };
  /// The same of all.
  struct Isolated {
    long precision;
    std::vector<Residues> poles;  ///< of each term
    long nearness;                ///< no pole is nearer to 0 than 2^nearness
  };

  /// One more term n/d, if n ≠ 0. What was known of the roots is forgotten.
  void add_term(const Polynomial& n, const Polynomial& d);
  const std::vector<Term>& terms() const { return terms_; }

  std::shared_ptr<const Isolated> isolate(long precision) const;
  /// What is known of the roots, null before anything was asked for.
  std::shared_ptr<const Isolated> known() const { return isolated_.known(); }

  /// Σ c(z) log((b − z)/(a − z)), the principal logarithm; a pair of conjugate poles gives twice
  /// the real part of one term. Precondition: no pole in [a, b].
  RealBall change(const Rational& a, const Rational& b, long bits) const;

  /// Σ c(z) log|t − z| over the real poles, and twice the real parts of c(z) log(t − z), principal
  /// branch, over those above the real axis. At ±∞ the limit without log|t|: for Im z > 0 t − z is
  /// below the axis, so that log(t − z) tends to log|t| − πi at −∞.
  RealBall branch(const Endpoint& t, long bits) const;

  /// Whether, for every root α of `residues`, Σ_{c(z)=α} arg − Σ_{c(z)=ᾱ} arg of (b − z)/(a − z),
  /// over the poles z above the real axis, is 0, given that it is a multiple of π; the other
  /// residues are roots of `others`. Poles z and z̄ turn in opposite directions, so there is nothing
  /// to ask for a real α. False where so many bits do not tell.
  bool turns_vanish(const Polynomial& residues, const Polynomial& others, const Rational& a,
                    const Rational& b, long bits) const;

 private:
  std::vector<Term> terms_;
  Refined<Isolated> isolated_;
};

}  // namespace phrame
