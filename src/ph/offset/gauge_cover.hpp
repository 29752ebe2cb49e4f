#pragma once
#include "phrame/algebra/bivariate.hpp"
#include "phrame/ph/offset/disc_cover.hpp"
#include "phrame/ph/offset/gauge.hpp"

namespace phrame::inline v0 {

/// The form F(x, y, z) with F = 0 on U for z = 1, of the degree of the gauge: for z > 0 it is ≤ 0
/// inside of z·U, but for finitely many rays < 0, and > 0 outside, but for as many ≥ 0.
class GaugeForm {
 public:
  GaugeForm();  ///< that of the unit circle, x² + y² − z²
  /// Cost: the kernel of a matrix as large as there are monomials.
  explicit GaugeForm(const Gauge& gauge);

  /// @{ Of polynomials: that along curves, and that between the points of two of them.
  Polynomial operator()(const Polynomial& x, const Polynomial& y, const Polynomial& z) const;
  Bivariate operator()(const Bivariate& x, const Bivariate& y, const Bivariate& z) const;
  /// @}

 private:
  /// One of its terms, c·xⁱyʲzᵏ.
  struct Term {
    Rational c;
    long i;
    long j;
  };
  template <class T>
  T value(const T& one, const T& x, const T& y, const T& z) const;

  long degree_;
  std::vector<Term> terms_;
};

/// What is nearer than |d| to the curves of a path, in the norm of a gauge.
class GaugeCover {
 public:
  GaugeCover(const std::vector<RationalCurve>& curves, const Gauge& gauge, const Rational& d);

  /// A point of the path to which the point is nearer, if there is any: decided exactly. On the
  /// curve of that number (s − t)², `known`, is taken out, where the offset touches |d|·U about
  /// its point at t in that point.
  std::optional<Vector<Rational>> center_around(const Vector<Rational>& at, std::size_t curve,
                                                const Polynomial& known) const;
  /// The same where nothing is known.
  std::optional<Vector<Rational>> center_around(const Vector<Rational>& at) const;
  /// Are all points of that part nearer than |d| to this one?
  bool is_nearer_along(const RationalCurve& curve, const Rational& from, const Rational& to,
                       const Vector<Rational>& center) const;
  /// Are all points of the box seen to be? false says nothing.
  bool covers(const PlaneBox& box) const { return discs_.covers(box); }
  const GaugeForm& form() const { return form_; }  ///< that of the gauge

 private:
  std::vector<RationalCurve> curves_;
  GaugeForm form_;
  Rational d_;         ///< |d|
  DiscCover discs_;    ///< inside of |d|·U about the points
  DiscCover outside_;  ///< around it
};

}  // namespace phrame
