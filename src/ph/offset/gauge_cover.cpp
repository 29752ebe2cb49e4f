// U is traced once by complex φ, so that F, of the degree of U, is irreducible, and the only
// relation between the monomials in X, Y, W of that degree. Its real zeros are U and finitely many
// points, which complex φ lead to. So inside of U, and outside, its sign is one; it changes through
// U, as F has no double points but finitely many.
//
// A polynomial along a path that touches such a point inside has a zero there, and is negative
// next to it, unless the path is that point.
#include "phrame/ph/offset/gauge_cover.hpp"

#include <algorithm>
#include <cmath>

#include "phrame/algebra/linear_system.hpp"
#include "phrame/algebra/real_algebraic.hpp"

namespace phrame::inline v0 {
namespace {

/// A number near the least or greatest |U|, from which to start.
double extreme_size(const Gauge& gauge, bool is_greatest) {
  constexpr long count = 64;
  double found = is_greatest ? 0 : std::numeric_limits<double>::infinity();
  for (long k = 0; k < count; ++k) {
    // φ goes around the projective line.
    const Rational phi = Rational(2 * k + 1 - count, count);
    for (const bool is_far : {false, true}) {
      if (is_far && phi == 0) continue;
      const Rational at = is_far ? Rational(1 / phi) : phi;
      const Rational w = gauge.weight()(at);
      const auto x = static_cast<double>(Rational(gauge.x()(at) / w));
      const auto y = static_cast<double>(Rational(gauge.y()(at) / w));
      found = is_greatest ? std::max(found, std::hypot(x, y)) : std::min(found, std::hypot(x, y));
    }
  }
  return found;
}

/// Is |U| > size, or < size, for all φ?
bool is_beyond(const Gauge& gauge, const Rational& size, bool is_greatest) {
  const Polynomial gap =
      gauge.x() * gauge.x() + gauge.y() * gauge.y() - size * size * gauge.weight() * gauge.weight();
  const int sign = gap(0).sign();
  return sign == (is_greatest ? -1 : 1) && gap.degree() == 2 * gauge.degree() &&
         count_real_roots(gap, real_line()) == 0;
}

/// A radius of a disc about 0 inside of U, or of one around it.
Rational disc_size(const Gauge& gauge, bool is_greatest) {
  const Rational step(is_greatest ? Rational(9, 8) : Rational(8, 9));
  const double near = extreme_size(gauge, is_greatest);
  Rational size = exact_rational(near * (is_greatest ? 1.01 : 0.99));
  while (!is_beyond(gauge, size, is_greatest)) size *= step;
  return size;
}

std::vector<DiscTrack> tracks_of(const std::vector<RationalCurve>& curves, const Rational& radius) {
  std::vector<DiscTrack> tracks;
  for (const RationalCurve& curve : curves)
    tracks.push_back(
        {curve.numerator()[0], curve.numerator()[1], radius * curve.weight(), curve.weight()});
  return tracks;
}

}  // namespace

GaugeForm::GaugeForm() : degree_(2), terms_{{1, 2, 0}, {1, 0, 2}, {-1, 0, 0}} {}

GaugeForm::GaugeForm(const Gauge& gauge) : degree_(gauge.degree()) {
  std::vector<Polynomial> monomials;
  for (long i = 0; i <= degree_; ++i)
    for (long j = 0; i + j <= degree_; ++j) {
      terms_.push_back({0, i, j});
      monomials.push_back(pow(gauge.x(), i) * pow(gauge.y(), j) *
                          pow(gauge.weight(), degree_ - i - j));
    }
  const std::vector<Rational> relation = linear_relations(monomials).front();
  for (std::size_t k = 0; k < terms_.size(); ++k) terms_[k].c = relation[k];
  std::erase_if(terms_, [](const Term& term) { return term.c == 0; });
  // On the way from 0 to a point of U there are finitely many zeros.
  const Rational w = gauge.weight()(0);
  for (Rational share = 0;; share = (1 + share) / 2) {
    const auto at = (*this)(Polynomial{share * gauge.x()(0) / w},
                            Polynomial{share * gauge.y()(0) / w}, Polynomial{1})(0);
    if (at == 0) continue;
    if (at > 0)
      for (Term& term : terms_) term.c = -term.c;
    return;
  }
}

template <class T>
T GaugeForm::value(const T& one, const T& x, const T& y, const T& z) const {
  const auto powers = [&](const T& p) {
    std::vector<T> list{one};
    for (long k = 0; k < degree_; ++k) list.push_back(list.back() * p);
    return list;
  };
  const auto of_x = powers(x);
  const auto of_y = powers(y);
  const auto of_z = powers(z);
  const auto at = [](const std::vector<T>& list, long k) -> const T& {
    return list[static_cast<std::size_t>(k)];
  };
  T sum;
  for (const auto& [c, i, j] : terms_)
    sum = sum + c * (at(of_x, i) * at(of_y, j) * at(of_z, degree_ - i - j));
  return sum;
}

Polynomial GaugeForm::operator()(const Polynomial& x, const Polynomial& y,
                                 const Polynomial& z) const {
  return value(Polynomial{1}, x, y, z);
}

Bivariate GaugeForm::operator()(const Bivariate& x, const Bivariate& y, const Bivariate& z) const {
  return value(Bivariate({Polynomial{1}}), x, y, z);
}

GaugeCover::GaugeCover(const std::vector<RationalCurve>& curves, const Gauge& gauge,
                       const Rational& d)
    : curves_(curves),
      form_(gauge),
      d_(abs(d)),
      discs_(tracks_of(curves, d_ * disc_size(gauge, false))),
      outside_(tracks_of(curves, d_ * disc_size(gauge, true))) {}

std::optional<Vector<Rational>> GaugeCover::center_around(const Vector<Rational>& at,
                                                          std::size_t curve,
                                                          const Polynomial& known) const {
  std::optional<Vector<Rational>> found;
  outside_.any_near(at, [&](std::size_t k) {
    const RationalCurve& of = curves_[k];
    const Polynomial& w = of.weight();
    Polynomial gap = form_(at[0] * w - of.numerator()[0], at[1] * w - of.numerator()[1], d_ * w);
    if (k == curve) gap = exact_quotient(gap, known);
    if (const auto t = negative_place(gap)) found = point(of, *t);
    return found.has_value();
  });
  return found;
}

std::optional<Vector<Rational>> GaugeCover::center_around(const Vector<Rational>& at) const {
  return center_around(at, curves_.size(), Polynomial{1});
}

bool GaugeCover::is_nearer_along(const RationalCurve& curve, const Rational& from,
                                 const Rational& to, const Vector<Rational>& center) const {
  const Polynomial& w = curve.weight();
  const Polynomial gap =
      form_(curve.numerator()[0] - center[0] * w, curve.numerator()[1] - center[1] * w, d_ * w);
  return gap(from) < 0 && (from == to || count_real_roots(gap, closed_interval(from, to)) == 0);
}

}  // namespace phrame
