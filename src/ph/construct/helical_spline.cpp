#include "phrame/ph/construct/helical_spline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/linear_system.hpp"
#include "phrame/algebra/progress.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/construct/preimage_grid.hpp"
#include "phrame/ph/construct/refine.hpp"
#include "phrame/ph/construct/spline_builder.hpp"

// The parameters of a segment are refined and rounded until its end, from where it does start on
// the exact curve, and its derivative there are within the tolerance. All of them are multiples of
// 2^−p, A(0) of the next segment is A(1) of this one or g·A₁, a product of two such, and A(0)
// enters the rest but does not enter A(1): numbers do not grow along the spline. (They do where
// tangents are so nearly parallel that the form `end` with y is taken.)

namespace phrame::inline v0 {
namespace {

RationalQuaternion rounded_preimage(const Vector<Rational>& d, const Rational& tolerance) {
  const Rational size = largest(d);
  if (size == 0) return {};
  const long size_bits = binary_exponent(size) / 2 + 1;  // of A
  constexpr long least_bits = 24;
  for (long p = std::max(least_bits - size_bits, size_bits + 3 - binary_exponent(tolerance));;
       p += 8) {
    const RationalQuaternion q =
        rounded_to_places(preimage(big_floats(d, p + std::max(size_bits, 0L) + 96)), p);
    const Vector<Rational> off = rotated_i(q) - d;
    if (dot(off, off) <= tolerance * tolerance) return q;
  }
}

DirectionsOfEnds directions(const Vector<Rational>& step, const Vector<Rational>& d0,
                            const Vector<Rational>& d1) {
  const auto collinear = [](const Vector<Rational>& x, const Vector<Rational>& y) {
    return cross(x, y) == Vector<Rational>{};
  };
  if (!collinear(d0, d1)) return DirectionsOfEnds::general;
  if (dot(d0, d1) >= 0) return DirectionsOfEnds::parallel;
  return collinear(d0, step) ? DirectionsOfEnds::opposite_collinear : DirectionsOfEnds::general;
}

/// A segment of unit step of the parameter, of about the size 1: all in units where A is `root`
/// times as great.
struct ScaledSegment {
  Vector<Rational> step;
  Vector<Rational> d1;
  HelicalStart<Rational> start;
  Rational points;  ///< how far off the end may be, …
  Rational derivatives;
};

bool is_met(const ScaledSegment& wanted, const std::vector<Rational>& defect) {
  const auto square = [&](std::size_t k) {
    return Rational(defect[k] * defect[k] + defect[k + 1] * defect[k + 1] +
                    defect[k + 2] * defect[k + 2]);
  };
  return square(0) <= wanted.points * wanted.points &&
         square(3) <= wanted.derivatives * wanted.derivatives;
}

/// They are computed as if the curve started along x: where it is nearly straight, what is across
/// has all of its digits then.
std::vector<HelicalGuess> helical_guesses(const ScaledSegment& wanted,
                                          const HelicalStart<double>& start,
                                          DirectionsOfEnds ends) {
  const RationalQuaternion& q = wanted.start.q;
  const bool is_zero = norm(q) == 0;
  const RationalQuaternion frame = is_zero ? RationalQuaternion{1, 0, 0, 0} : q;
  const Rational shrink = 1 / norm(frame);
  const double size = std::sqrt(norm(start.q));
  const Quaternion<double> turn = is_zero ? Quaternion<double>{1, 0, 0, 0} : (1 / size) * start.q;
  const double speed = start.factor * start.factor * norm(start.q);
  std::vector<HelicalGuess> guesses =
      helical_quintics({scaled_to_doubles(shrink, turned_back(wanted.step, frame)),
                        {speed, 0, 0},
                        scaled_to_doubles(shrink, turned_back(wanted.d1, frame))},
                       {{size, 0, 0, 0}, start.factor}, ends);
  for (HelicalGuess& guess : guesses) {
    std::vector<double>& x = guess.parameters;
    const bool has_two = guess.form == HelicalForm::free && x.size() > 4;
    for (const std::size_t k : {std::size_t{0}, std::size_t{4}}) {
      if (k == 4 && !has_two) break;
      const Quaternion<double> a = turn * Quaternion<double>{x[k], x[k + 1], x[k + 2], x[k + 3]};
      std::tie(x[k], x[k + 1], x[k + 2], x[k + 3]) = std::tie(a.u, a.v, a.p, a.q);
    }
  }
  return guesses;
}

/// What a step has to be so that the defect changes by so much, to first order, and no longer than
/// needed. Where the data are nearly straight two of the six directions hardly count, but do: all
/// digits of the derivative are wanted, so it is no quotient of differences.
ParameterStep newton_step(const HelicalGuess& at, const HelicalStart<double>& start) {
  constexpr double nothing = 1e-14;
  JacobianRows rows(6, std::vector<double>(at.parameters.size()));
  for (std::size_t k = 0; k < at.parameters.size(); ++k) {
    const std::vector<double> column = helical_derivative(at.form, start, at.parameters, k);
    for (std::size_t j = 0; j < 6; ++j) rows[j][k] = column[j];
  }
  return least_change(rows, nothing);
}

/// The guess, refined and rounded.
std::optional<std::vector<Rational>> fit(const ScaledSegment& wanted, HelicalGuess guess,
                                         const HelicalStart<double>& start) {
  const ExactDefect defect = [&](const std::vector<Rational>& x) {
    return helical_defect(helical_member(guess.form, wanted.start, x), wanted.step, wanted.d1);
  };
  std::vector<Rational> parameters;
  for (const double x : guess.parameters) parameters.push_back(exact_rational(x));
  // Until the derivative is that at the solution.
  constexpr long bits_of_doubles = 50;
  for (int pass = 0; pass < 4; ++pass) {
    std::vector<Rational> next =
        refine(parameters, defect, newton_step(guess, start), bits_of_doubles).parameters;
    if (next == parameters) break;
    parameters = std::move(next);
    for (std::size_t k = 0; k < parameters.size(); ++k)
      guess.parameters[k] = static_cast<double>(parameters[k]);
  }
  const long bits = std::max(24L, 4 - binary_exponent(std::min(wanted.points, wanted.derivatives)));
  return rounded_solution(
      std::move(parameters), [&](long) { return defect; }, newton_step(guess, start), bits, 12,
      [&](const std::vector<Rational>& rounded, long) {
        return is_met(wanted, defect(rounded)) ? std::optional(rounded) : std::nullopt;
      });
}

/// Is f > 0 on [0, 1]?
bool is_positive(const HelicalMember<Rational>& member, const std::vector<Rational>& parameters) {
  return member.f.size() == 1 || (parameters[4] > 0 && parameters[5] > -parameters[4]);
}

/// The least k such that all coefficients are multiples of 2^−k, for those whose denominators are
/// powers of 2.
long bits_after_point(const std::vector<RationalQuaternion>& a) {
  long bits = 0;
  for (const RationalQuaternion& x : a)
    for (const Rational& part : {x.u, x.v, x.p, x.q})
      bits = std::max(bits, binary_exponent(Rational(denominator(part))));
  return bits;
}

class Helices {
 public:
  Helices(const HermiteSpline& data, long solution, const Deviation& tolerance, PointRule rule)
      : data_(data), solution_(solution), tolerance_(tolerance), builder_(data, rule) {}

  Construction run();

 private:
  void add(std::size_t k);
  /// Adds a member of the form of the guess that meets the end as the rule asks, A times `back`.
  void add(const HelicalGuess& guess, ScaledSegment wanted, const HelicalStart<double>& start,
           const Rational& back);

  const HermiteSpline& data_;
  long solution_;
  const Deviation& tolerance_;
  SplineBuilder builder_;
  HelicalStart<Rational> start_;
  long bits_ = 0;
};

Construction Helices::run() {
  start_ = {rounded_preimage(data_.derivatives.front(), tolerance_.derivatives), 1};
  builder_.meter().derivative(rotated_i(start_.q) - data_.derivatives.front());
  Stage stage("segments", data_.segments());
  for (std::size_t k = 0; k < data_.segments(); ++k, stage.advance()) add(k);
  return builder_.finished(data_.parameters, bits_);
}

void Helices::add(const HelicalGuess& guess, ScaledSegment wanted,
                  const HelicalStart<double>& start, const Rational& back) {
  constexpr int most_passes = 3;
  const std::size_t k = builder_.next();
  for (int pass = 0; pass <= most_passes; ++pass, wanted.points *= power_of_two(-24)) {
    const auto found = fit(wanted, guess, start);
    HelicalMember<Rational> member;
    if (found) member = helical_member(guess.form, wanted.start, *found);
    if (!found || !is_positive(member, *found))
      throw Undecided(fmt::format(
          "segment {}: the end of the helical quintic is too sensitive to its coefficients",
          k + 1));
    for (RationalQuaternion& a : member.a) a = back * a;
    for (Rational& f : member.f) f *= data_.step(k);
    if (!builder_.add(member.a, member.f, MultiplierFreedom::inner_only)) continue;
    member.end = back * member.end;
    builder_.meter().derivative(rotated_i(member.end) - data_.derivatives[k + 1]);
    bits_ = std::max(bits_, bits_after_point(member.a));
    if (guess.form == HelicalForm::end && found->size() == 5)
      start_.factor = found->back();
    else
      start_ = {member.end, 1};
    return;
  }
  throw unmet_segment(k);
}

void Helices::add(std::size_t k) {
  const Rational h = data_.step(k);
  const Vector<Rational>& d0 = data_.derivatives[k];
  const Vector<Rational>& d1 = data_.derivatives[k + 1];
  const Vector<Rational> step = (1 / h) * builder_.wanted();
  const Rational scale = scale_for_doubles(std::max({largest(step), largest(d0), largest(d1)}));
  const Rational root = *square_root(scale);
  const ScaledSegment wanted{scale * step,
                             scale * d1,
                             {root * start_.q, start_.factor},
                             tolerance_.points / h * scale,
                             tolerance_.derivatives * scale};
  const HelicalStart<double> start{quaternion_in_doubles(wanted.start.q),
                                   static_cast<double>(wanted.start.factor)};
  const std::vector<HelicalGuess> guesses =
      helical_guesses(wanted, start, directions(data_.points[k + 1] - data_.points[k], d0, d1));
  if (static_cast<long>(guesses.size()) < solution_)
    throw DomainError(
        fmt::format("segment {}: there are {} helical quintics with these ends and "
                    "derivatives, so no solution {}",
                    k + 1, guesses.size(), solution_));
  add(guesses[static_cast<std::size_t>(solution_ - 1)], wanted, start, 1 / root);
}

}  // namespace

Construction helical_spline(const HermiteSpline& data, long solution, const Deviation& tolerance,
                            PointRule rule) {
  require_regular(data);
  return Helices(data, solution, tolerance, rule).run();
}

bool is_helical(const PhPath& path) {
  return std::ranges::all_of(path.segments(), [](const Curve& curve) {
    const QuaternionPolynomial& a = curve.preimage();
    return linear_relations({a.u, a.v, a.p, a.q}).size() >= 2;
  });
}

}  // namespace phrame
