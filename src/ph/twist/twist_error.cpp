#include "phrame/ph/twist/twist_error.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/integrate/quadrature.hpp"

namespace phrame::inline v0 {
namespace {

// Where the frame is nearly exact E is small against its terms. They cancel in the coefficients of
// one polynomial, once for all points:
//   E·speed = N/(dD),  N = (n − T·speed·d)·D + 2d(ab′ − a′b).

/// What the piece brings to E.
struct PieceFunction {
  BallPolynomial denominator;  ///< d
  BallPolynomial speed;
  BallPolynomial rest;  ///< n − T·speed·d

  PieceFunction(const TwistPiece& piece, long bits)
      : denominator(piece.erf_rate.denominator(), bits), speed(piece.speed, bits) {
    const BallPolynomial wanted =
        multiply(piece.twist.enclose(bits), multiply(speed, denominator, bits), bits);
    rest = subtract(BallPolynomial(piece.erf_rate.numerator(), bits), wanted, bits);
  }

  /// N, linear in D = norm and ab′ − a′b = cross.
  BallPolynomial numerator(const BallPolynomial& norm, const BallPolynomial& cross,
                           long bits) const {
    const BallPolynomial turn = multiply(denominator, add(cross, cross, bits), bits);
    return add(multiply(rest, norm, bits), turn, bits);
  }
};

/// Re(ūv) and Im(ūv).
BallPolynomial dot(const Rotation& u, const Rotation& v, long bits) {
  return add(multiply(u.a, v.a, bits), multiply(u.b, v.b, bits), bits);
}

BallPolynomial cross(const Rotation& u, const Rotation& v, long bits) {
  return subtract(multiply(u.a, v.b, bits), multiply(u.b, v.a, bits), bits);
}

/// By how many bits the terms of a polynomial may be larger than its values: on [0, 1] those of
/// degree n are at most 3ⁿ times its Bernstein coefficients. The greatest degree is that of the
/// denominator of E, with w of degree 8.
long growth(const TwistPiece& piece) {
  return 2 * (piece.erf_rate.denominator().degree() + piece.speed.degree() + 16);
}

/// A function and its derivatives, on a ball.
struct Jet {
  RealBall value;
  RealBall slope;
  RealBall second;
};

/// E on intervals.
class ErrorJet {
 public:
  ErrorJet(const TwistPiece& piece, const Rotation& w, long bits) : bits_(bits) {
    const PieceFunction of(piece, bits);
    const BallPolynomial d = norm(w, bits);
    numerator_ = of.numerator(d, wronskian(w, bits), bits);
    denominator_ = multiply(multiply(of.denominator, d, bits), of.speed, bits);
  }

  /// On [a, b] and in its middle: by the Taylor polynomials there, which cost most.
  struct OnPart {
    Jet all;
    Jet middle;
  };
  OnPart operator()(const Rational& a, const Rational& b) const {
    const Rational middle = (a + b) / 2;
    const auto in_middle_of_part = [&](const BallPolynomial& p) {
      return with_slopes(shifted(p, RealBall(middle, bits_), bits_));
    };
    const WithSlopes x = in_middle_of_part(numerator_);
    const WithSlopes y = in_middle_of_part(denominator_);
    const RealBall offset = hull(Rational(a - middle), Rational(b - middle), bits_);
    const auto on_part = [&](const BallPolynomial& p) { return evaluate(p, offset, bits_); };
    const auto in_middle = [&](const BallPolynomial& p) { return p.coefficient(0); };
    return {quotient(x.map(on_part), y.map(on_part)), quotient(x.map(in_middle), y.map(in_middle))};
  }

  RealBall value(const Rational& tau) const {
    const RealBall at(tau, bits_);
    return divide(evaluate(numerator_, at, bits_), evaluate(denominator_, at, bits_), bits_);
  }

 private:
  struct WithSlopes {
    BallPolynomial p;
    BallPolynomial slope;
    BallPolynomial second;

    template <class Function>
    Jet map(const Function& f) const {
      return {f(p), f(slope), f(second)};
    }
  };

  WithSlopes with_slopes(const BallPolynomial& p) const {
    const BallPolynomial slope = differentiate(p, bits_);
    return {p, slope, differentiate(slope, bits_)};
  }

  /// q = x/y: q′ = (x′ − qy′)/y and q″ = (x″ − 2q′y′ − qy″)/y.
  Jet quotient(const Jet& x, const Jet& y) const {
    const RealBall value = divide(x.value, y.value, bits_);
    const RealBall rest_of_slope = subtract(x.slope, multiply(value, y.slope, bits_), bits_);
    const RealBall slope = divide(rest_of_slope, y.value, bits_);
    const RealBall twice = multiply(add(slope, slope, bits_), y.slope, bits_);
    const RealBall rest =
        subtract(subtract(x.second, twice, bits_), multiply(value, y.second, bits_), bits_);
    return {value, slope, divide(rest, y.value, bits_)};
  }

  long bits_;
  BallPolynomial numerator_;
  BallPolynomial denominator_;
};

}  // namespace

long working_precision(const TwistPiece& piece, long bits) { return bits + 64 + growth(piece); }

BallPolynomial turn_numerator(const TwistPiece& piece, const Rotation& w, long bits) {
  const BallPolynomial n(piece.erf_rate.numerator(), bits);
  const BallPolynomial d(piece.erf_rate.denominator(), bits);
  const BallPolynomial turn =
      multiply(RealBall(2, bits), multiply(d, wronskian(w, bits), bits), bits);
  return add(multiply(n, norm(w, bits), bits), turn, bits);
}

RealBall mean_square(const TwistPiece& piece, const Rotation& w, long bits) {
  const long precision = working_precision(piece, bits);
  const PieceFunction of(piece, precision);
  const BallPolynomial d = norm(w, precision);
  const IntegrandPolynomial n = of.numerator(d, wronskian(w, precision), precision);
  const IntegrandPolynomial q = multiply(of.denominator, d, precision);
  const IntegrandPolynomial speed = of.speed;
  return quadrature(
      [&](const ComplexBall& z, long working) {
        const ComplexBall error = divide(n(z, working), q(z, working), working);
        return divide(multiply(error, error, working), speed(z, working), working);
      },
      bits, growth(piece));
}

Real root_mean_square(const TwistPiece& piece, const Polynomial& a, const Polynomial& b) {
  return Real([piece, a, b](long bits) {
    // √(G ± ε) is at worst √G ± √ε.
    const long precision = working_precision(piece, 2 * bits);
    const Rotation w{BallPolynomial(a, precision), BallPolynomial(b, precision)};
    return sqrt_of_nonnegative(mean_square(piece, w, 2 * bits), bits + 64);
  });
}

RealBall mean_square_slope(const TwistPiece& piece, const RotationFamily& family,
                           const Rational& parameter, long bits) {
  // ∂θ/∂p = 2 Im(w¹/w) = 2K/D with K = Im(w̄⁰w¹), which does not depend on p.
  const long precision = working_precision(piece, bits);
  const Rotation w = member(family, {parameter}, precision);
  const PieceFunction of(piece, precision);
  const BallPolynomial d = norm(w, precision);
  const IntegrandPolynomial n = of.numerator(d, wronskian(w, precision), precision);
  const IntegrandPolynomial q = multiply(of.denominator, d, precision);
  const IntegrandPolynomial speed = of.speed;
  const BallPolynomial k = cross(family.basis[0], family.basis[1], precision);
  // θ′_p/2 = (K/D)′ = (K′D − KD′)/D².
  const BallPolynomial change =
      subtract(multiply(differentiate(k, precision), d, precision),
               multiply(k, differentiate(d, precision), precision), precision);
  return quadrature(
      [&](const ComplexBall& z, long working) {
        const auto at = [&](const BallPolynomial& polynomial) {
          return evaluate(polynomial, z, working);
        };
        const ComplexBall norm = at(d);
        const ComplexBall error = divide(n(z, working), q(z, working), working);
        const ComplexBall product =
            divide(multiply(error, at(change), working), multiply(norm, norm, working), working);
        return divide(multiply(RealBall(4, working), product, working), speed(z, working), working);
      },
      bits, growth(piece));
}

/// With w = w^c + δ·w¹ from a centre c: N = N⁰ + δN¹ + δ²N², D = D⁰ + 2δL⁰ + δ²D¹. The values that
/// do not depend on δ, by points.
class MeanSquareConvexity::Points {
 public:
  struct Values {
    ComplexBall z;
    ComplexBall inverse_denominator;
    ComplexBall eight_over_speed;
    std::array<ComplexBall, 3> n;  ///< N⁰, N¹, N²
    /// And their slopes: D⁰ = |w^c|², L⁰ = Re(w̄^c w¹), D¹ = |w¹|², K = Im(w̄^c w¹).
    std::array<ComplexBall, 4> forms;
    std::array<ComplexBall, 4> slopes;
  };

  Points(const TwistPiece& piece, const RotationFamily& family, const Rational& at, long bits)
      : centre(at, bits) {
    const PieceFunction of(piece, bits);
    denominator_ = of.denominator;
    speed_ = of.speed;
    const Rotation w = member(family, {at}, bits);
    const Rotation& v = family.basis[1];
    const auto slope = [bits](const Rotation& u) {
      return Rotation{differentiate(u.a, bits), differentiate(u.b, bits)};
    };
    const BallPolynomial l = dot(w, v, bits);
    forms_ = {norm(w, bits), l, norm(v, bits), cross(w, v, bits)};
    for (std::size_t k = 0; k < forms_.size(); ++k) slopes_[k] = differentiate(forms_[k], bits);
    const BallPolynomial mixed = add(cross(w, slope(v), bits), cross(v, slope(w), bits), bits);
    n_ = {of.numerator(forms_[0], wronskian(w, bits), bits),
          of.numerator(add(l, l, bits), mixed, bits),
          of.numerator(forms_[2], wronskian(v, bits), bits)};
  }

  const Values& at(const ComplexBall& z, long bits) {
    std::optional<Values>& known = values_[key_of(z)];
    if (known && known->z.is_same_ball(z)) return *known;
    const auto over = [bits](long x, const ComplexBall& y) {
      return divide(ComplexBall(RealBall(x, bits), {}), y, bits);
    };
    known = Values{z, over(1, denominator_(z, bits)), over(8, speed_(z, bits)), {}, {}, {}};
    for (std::size_t k = 0; k < n_.size(); ++k) known->n[k] = n_[k](z, bits);
    for (std::size_t k = 0; k < forms_.size(); ++k) {
      known->forms[k] = evaluate(forms_[k], z, bits);
      known->slopes[k] = evaluate(slopes_[k], z, bits);
    }
    return *known;
  }

  const RealBall centre;

 private:
  /// Different points may share one: then the last one is kept.
  static std::array<double, 4> key_of(const ComplexBall& z) {
    const RealBall re = z.re();
    const RealBall im = z.im();
    return {approximate(re), approximate(im), approximate(radius_of(re)),
            approximate(radius_of(im))};
  }

  IntegrandPolynomial denominator_;
  IntegrandPolynomial speed_;
  std::array<IntegrandPolynomial, 3> n_;
  std::array<BallPolynomial, 4> forms_;
  std::array<BallPolynomial, 4> slopes_;
  std::map<std::array<double, 4>, std::optional<Values>> values_;
};

MeanSquareConvexity::MeanSquareConvexity(const TwistPiece& piece, const RotationFamily& family,
                                         const Rational& centre, long bits)
    : points_(std::make_unique<Points>(piece, family, centre, working_precision(piece, bits))),
      bits_(bits),
      more_(growth(piece)) {}

MeanSquareConvexity::~MeanSquareConvexity() = default;

RealBall MeanSquareConvexity::operator()(const RealBall& parameter, long most_points) {
  const RealBall delta = subtract(parameter, points_->centre, bits_ + 64 + more_);
  return quadrature(
      [&](const ComplexBall& z, long working) {
        const Points::Values& here = points_->at(z, working);
        const auto moved = [&](const ComplexBall& x, const ComplexBall& y) {
          return add(x, multiply(delta, y, working), working);
        };
        const auto l_at = [&](const auto& of) { return moved(of[1], of[2]); };
        // D⁰ + δ(L⁰ + L)
        const auto norm_at = [&](const auto& of) {
          return moved(of[0], add(of[1], l_at(of), working));
        };
        // θ_p = 2K/D with K = Im(w̄⁰w¹), D_p = 2L with L = Re(w̄w¹), so that θ_pp/4 = −K/D·L/D.
        const ComplexBall norm = norm_at(here.forms);
        const ComplexBall norm_slope = norm_at(here.slopes);
        const ComplexBall norm_inverse = inverse(norm, working);
        const auto over_norm = [&](const ComplexBall& x) {
          return multiply(x, norm_inverse, working);
        };
        const ComplexBall n = moved(here.n[0], moved(here.n[1], here.n[2]));
        const ComplexBall error = over_norm(multiply(n, here.inverse_denominator, working));
        const ComplexBall k_share = over_norm(here.forms[3]);
        const ComplexBall l_share = over_norm(l_at(here.forms));
        const auto change = [&](const ComplexBall& share, const ComplexBall& slope) {
          return over_norm(subtract(slope, multiply(share, norm_slope, working), working));
        };
        const ComplexBall k_change = change(k_share, here.slopes[3]);
        const ComplexBall l_change = change(l_share, l_at(here.slopes));
        const ComplexBall mixed = add(multiply(k_share, l_change, working),
                                      multiply(k_change, l_share, working), working);
        const ComplexBall sum = subtract(multiply(k_change, k_change, working),
                                         multiply(error, mixed, working), working);
        return multiply(sum, here.eight_over_speed, working);
      },
      bits_, more_, most_points);
}

namespace {

/// [a, b], in which the greatest error may be.
struct ErrorPart {
  Rational a;
  Rational b;
};

/// What of a part may have E′ = 0: where E″ ≠ 0, Newton's interval step m − E′(m)/E″(part) holds
/// what zero of E′ the part has. Nothing where there is no zero.
std::optional<ErrorPart> around_zero(const ErrorPart& part, const Rational& middle,
                                     const RealBall& slope, const RealBall& second,
                                     long precision) {
  const RealBall zero =
      subtract(RealBall(middle, precision), divide(slope, second, precision), precision);
  if (!zero.is_finite()) return part;
  const ErrorPart found{std::max(part.a, zero.lower()), std::min(part.b, zero.upper())};
  if (found.a > found.b) return std::nullopt;
  return found;
}

}  // namespace

RealBall greatest_error(const TwistPiece& piece, const Rotation& w, long bits) {
  // Branch and bound: the maximum is at an end or where E′ = 0, so that a part can be left where
  // E′ ≠ 0, or where |E| is less than elsewhere.
  const long precision = working_precision(piece, bits);
  const ErrorJet error(piece, w, precision);
  RealBall least;  // of what the maximum can be
  const auto look_at = [&](const RealBall& value) {
    const RealBall here = absolute(value);
    if (here.is_finite()) least = max(least, here, precision);
  };
  std::vector<ErrorPart> parts;
  constexpr long first_parts = 16;
  for (long k = 0; k < first_parts; ++k)
    parts.push_back({Rational(k, first_parts), Rational(k + 1, first_parts)});
  for (long k = 0; k <= first_parts; ++k) look_at(error.value(Rational(k, first_parts)));
  const RealBall fine = RealBall(power_of_two(-bits), 53);
  for (long round = 0;; ++round) {
    RealBall most = least;
    std::vector<ErrorPart> left;
    for (const ErrorPart& part : parts) {
      const auto [jet, in_middle] = error(part.a, part.b);
      if (jet.slope.is_finite() && !jet.slope.contains_zero()) continue;
      const Rational middle = (part.a + part.b) / 2;
      look_at(in_middle.value);
      const RealBall offset = hull(Rational(part.a - middle), Rational(part.b - middle), precision);
      const RealBall inside =
          absolute(add(in_middle.value, multiply(offset, jet.slope, precision), precision));
      if (is_less(inside, least)) continue;
      const auto near = around_zero(part, middle, in_middle.slope, jet.second, precision);
      if (!near) continue;
      most = hull(most, inside, precision);
      if (2 * (near->b - near->a) < part.b - part.a) {
        left.push_back(*near);
        continue;
      }
      left.push_back({part.a, middle});
      left.push_back({middle, part.b});
    }
    const RealBall bound = hull(least, most, precision);
    const RealBall allowed = multiply(fine, add(least, fine, 53), 53);
    const bool is_fine = is_at_most(radius_of(bound), allowed);
    constexpr std::size_t most_parts = 5000;
    if (left.empty() || is_fine || round > bits || left.size() > most_parts) return bound;
    parts = std::move(left);
  }
}

}  // namespace phrame
