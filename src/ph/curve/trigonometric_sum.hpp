#pragma once
#include <map>
#include <optional>
#include <vector>

#include "phrame/ph/curve/formula_jet.hpp"
#include "phrame/ph/curve/quaternion.hpp"

namespace phrame::inline v0 {

/// Σ c·πʲ·xᵏ·e^{i(ωx + ρπ + κ)}, a function of x with fractions c, ω, ρ, κ, as a list of its terms.
/// Lists that are equal are equal functions. The converse is not always true: 1 + e^{2πi/3} +
/// e^{4πi/3} is 0, but no empty list.
class TrigonometricSum {
 public:
  /// All but the c of a term.
  struct Term {
    long pi_power = 0;   ///< j
    long power = 0;      ///< k
    Rational frequency;  ///< ω
    Rational turns;      ///< ρ in [0, 1): a half turn is the factor −1
    Rational phase;      ///< κ
    friend bool operator==(const Term&, const Term&) = default;
    friend std::strong_ordering operator<=>(const Term&, const Term&) = default;  ///< any order
  };

  TrigonometricSum() = default;  ///< 0
  /// number + pi_multiple·π.
  TrigonometricSum(const Rational& number,  // NOLINT(google-explicit-constructor)
                   const Rational& pi_multiple = 0);
  static TrigonometricSum variable();  ///< x

  bool is_zero() const { return terms_.empty(); }
  /// cos f for f = ωx + ρπ + κ; no value for another one.
  std::optional<TrigonometricSum> cosine() const;
  /// The same of the sine.
  std::optional<TrigonometricSum> sine() const;

  /// @{ By form.
  friend TrigonometricSum operator+(TrigonometricSum f, const TrigonometricSum& g);
  friend TrigonometricSum operator-(TrigonometricSum f, const TrigonometricSum& g);
  friend TrigonometricSum operator*(const TrigonometricSum& f, const TrigonometricSum& g);
  friend TrigonometricSum differentiate(const TrigonometricSum& f);
  friend bool operator==(const TrigonometricSum&, const TrigonometricSum&) = default;
  friend TrigonometricSum operator*(const Rational& x, TrigonometricSum f);
  /// @}
  /// Of its terms.
  std::size_t size() const { return terms_.size(); }
  /// Of the longest of the fractions in it; 0 for 0.
  long bits() const;

 private:
  void add(Term term, const Rational& c);
  std::optional<TrigonometricSum> cosine(const Rational& turned_back) const;

  std::map<Term, Rational> terms_;
};

/// Sums and products of these that are no more work than `most` together: of lists of m and n terms
/// (m + n)(b + 200)² and mn(b + 200)², with the bits b of the longest fractions of the one and of
/// the other. What is more work is 0, and so is all that follows.
class TrigonometricArithmetic {
 public:
  using Sum = TrigonometricSum;
  explicit TrigonometricArithmetic(Integer most) : room_(std::move(most)) {}

  bool is_within_limit() const { return room_ >= 0; }  ///< so far
  Sum add(const Sum& f, const Sum& g);
  Sum subtract(const Sum& f, const Sum& g);
  Sum multiply(const Sum& f, const Sum& g);
  Sum dot(const Vector<Sum>& f, const Vector<Sum>& g);
  Vector<Sum> cross(const Vector<Sum>& f, const Vector<Sum>& g);
  /// The values of the steps for a variable that is such a sum: numbers, sums, products, sines and
  /// cosines of what is linear in x. No value where a step is another one.
  std::optional<std::vector<Sum>> values(const DistinctSteps& steps, const Sum& variable);

 private:
  bool spends(std::size_t count, const Sum& f, const Sum& g);
  std::optional<Sum> value(const DistinctSteps& steps, const Formula::Step& step,
                           const std::vector<Sum>& values, const Sum& variable);

  Integer room_;
};

}  // namespace phrame
