#include "phrame/ph/twist_error.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "phrame/integrate/quadrature.hpp"

namespace phrame {
namespace {

/// Arithmetic at one precision.
struct Operations {
  long bits;
  using Ball = ComplexBall;
  Ball plus(const Ball& x, const Ball& y) const { return add(x, y, bits); }
  Ball minus(const Ball& x, const Ball& y) const { return subtract(x, y, bits); }
  Ball times(const Ball& x, const Ball& y) const { return multiply(x, y, bits); }
  Ball over(const Ball& x, const Ball& y) const { return divide(x, y, bits); }
  Ball twice(const Ball& x) const { return add(x, x, bits); }
};

/// What the piece brings to E, at a point of the complex plane.
class PieceFunction {
 public:
  PieceFunction(const TwistPiece& piece, long bits)
      : numerator_(piece.erf_rate.numerator(), bits),
        denominator_(piece.erf_rate.denominator(), bits),
        speed_(piece.speed, bits),
        twist_(piece.twist.enclose(bits)) {}

  struct Values {
    ComplexBall rate;  ///< erf_rate − T·speed
    ComplexBall speed;
  };

  Values operator()(const ComplexBall& z, long bits) const {
    const ComplexBall speed = evaluate(speed_, z, bits);
    const ComplexBall erf =
        divide(evaluate(numerator_, z, bits), evaluate(denominator_, z, bits), bits);
    return {subtract(erf, multiply(twist_, speed, bits), bits), speed};
  }

 private:
  BallPolynomial numerator_;
  BallPolynomial denominator_;
  BallPolynomial speed_;
  RealBall twist_;
};

/// a, b and their derivatives there.
class RotationFunction {
 public:
  RotationFunction(const Rotation& w, long bits)
      : w_(w), slope_{differentiate(w.a, bits), differentiate(w.b, bits)} {}

  struct Values {
    ComplexBall a;
    ComplexBall b;
    ComplexBall a_slope;
    ComplexBall b_slope;
  };

  Values operator()(const ComplexBall& z, long bits) const {
    return {evaluate(w_.a, z, bits), evaluate(w_.b, z, bits), evaluate(slope_.a, z, bits),
            evaluate(slope_.b, z, bits)};
  }

 private:
  Rotation w_;
  Rotation slope_;
};

/// What both make.
struct ErrorValues {
  ComplexBall error;       ///< erf_rate + θ′ − T·speed
  ComplexBall norm;        ///< D = a² + b²
  ComplexBall norm_slope;  ///< D′
};

ErrorValues error_values(const ComplexBall& rate, const RotationFunction::Values& w, long bits) {
  const Operations op{bits};
  const ComplexBall norm = op.plus(op.times(w.a, w.a), op.times(w.b, w.b));
  const ComplexBall half_turn =
      op.over(op.minus(op.times(w.a, w.b_slope), op.times(w.a_slope, w.b)), norm);
  const ComplexBall half_slope = op.plus(op.times(w.a, w.a_slope), op.times(w.b, w.b_slope));
  return {op.plus(rate, op.twice(half_turn)), norm, op.twice(half_slope)};
}

/// By how many bits the terms of a polynomial of the piece may be larger than its values.
long growth(const TwistPiece& piece) {
  return 2 * std::max(piece.erf_rate.denominator().degree(), piece.speed.degree());
}

/// A function and its derivative, on a ball.
struct Jet {
  RealBall value;
  RealBall slope;
};

/// E on intervals.
class ErrorJet {
 public:
  ErrorJet(const TwistPiece& piece, const Rotation& w, long bits)
      : bits_(bits),
        numerator_(with_slope({piece.erf_rate.numerator(), bits})),
        denominator_(with_slope({piece.erf_rate.denominator(), bits})),
        speed_(with_slope({piece.speed, bits})),
        cross_(with_slope(wronskian(w, bits))),
        norm_(with_slope(norm(w, bits))),
        twist_(piece.twist.enclose(bits)) {}

  Jet operator()(const Rational& a, const Rational& b) const {
    const auto at = [&](const WithSlope& p) {
      return Jet{range(p.p, a, b, bits_), range(p.slope, a, b, bits_)};
    };
    const Jet half_turn = over(at(cross_), at(norm_));
    const Jet erf = over(at(numerator_), at(denominator_));
    const Jet turn{add(erf.value, add(half_turn.value, half_turn.value, bits_), bits_),
                   add(erf.slope, add(half_turn.slope, half_turn.slope, bits_), bits_)};
    const Jet rate = over(turn, at(speed_));
    return {subtract(rate.value, twist_, bits_), rate.slope};
  }

 private:
  struct WithSlope {
    BallPolynomial p;
    BallPolynomial slope;
  };
  WithSlope with_slope(const BallPolynomial& p) const { return {p, differentiate(p, bits_)}; }
  Jet over(const Jet& x, const Jet& y) const {
    const RealBall ratio = divide(x.value, y.value, bits_);
    const RealBall change = subtract(x.slope, multiply(ratio, y.slope, bits_), bits_);
    return {ratio, divide(change, y.value, bits_)};
  }

  long bits_;
  WithSlope numerator_;
  WithSlope denominator_;
  WithSlope speed_;
  WithSlope cross_;
  WithSlope norm_;
  RealBall twist_;
};

}  // namespace

long working_precision(const TwistPiece& piece, long bits) {
  // The greatest degree is that of the slope of E, with w of degree 8 about twice this sum.
  return bits + 64 + 4 * (piece.erf_rate.denominator().degree() + piece.speed.degree() + 8);
}

BallPolynomial turn_numerator(const TwistPiece& piece, const Rotation& w, long bits) {
  const BallPolynomial n(piece.erf_rate.numerator(), bits);
  const BallPolynomial d(piece.erf_rate.denominator(), bits);
  const BallPolynomial turn =
      multiply(RealBall(2, bits), multiply(d, wronskian(w, bits), bits), bits);
  return add(multiply(n, norm(w, bits), bits), turn, bits);
}

RealBall mean_square(const TwistPiece& piece, const Rotation& w, long bits) {
  const long more = growth(piece);
  const PieceFunction piece_at(piece, bits + more + 64);
  const RotationFunction w_at(w, bits + more + 64);
  return quadrature(
      [&](const ComplexBall& z, long working) {
        const Operations op{working};
        const auto [rate, speed] = piece_at(z, working);
        const ComplexBall error = error_values(rate, w_at(z, working), working).error;
        return op.over(op.times(error, error), speed);
      },
      bits, more);
}

RealBall mean_square_slope(const TwistPiece& piece, const RotationFamily& family,
                           const Rational& parameter, long bits) {
  // ∂θ/∂p = 2 Im(w¹/w) = 2K/D with K = Im(w̄⁰w¹), which does not depend on p.
  const long more = growth(piece);
  const long precision = bits + more + 64;
  const PieceFunction piece_at(piece, precision);
  const RotationFunction w_at(member(family, {parameter}, precision), precision);
  const auto& p = family.basis[0];
  const auto& q = family.basis[1];
  const BallPolynomial k =
      subtract(multiply(p.a, q.b, precision), multiply(p.b, q.a, precision), precision);
  const BallPolynomial k_slope = differentiate(k, precision);
  return quadrature(
      [&](const ComplexBall& z, long working) {
        const Operations op{working};
        const auto at = [&](const BallPolynomial& polynomial) {
          return evaluate(polynomial, z, working);
        };
        const auto [rate, speed] = piece_at(z, working);
        const auto [error, norm, norm_slope] = error_values(rate, w_at(z, working), working);
        // θ′_p/2 = (K/D)′.
        const ComplexBall change =
            op.over(op.minus(op.times(at(k_slope), norm), op.times(at(k), norm_slope)),
                    op.times(norm, norm));
        return op.over(op.twice(op.twice(op.times(error, change))), speed);
      },
      bits, more);
}

/// The values that do not depend on the parameter, by points.
class MeanSquareBend::Points {
 public:
  struct Values {
    ComplexBall z;
    PieceFunction::Values piece;
    RotationFunction::Values p;  ///< of w⁰ and w¹
    RotationFunction::Values q;
  };

  Points(const TwistPiece& piece, const RotationFamily& family, long bits)
      : more(growth(piece)),
        piece_at_(piece, bits + more + 64),
        p_at_(family.basis[0], bits + more + 64),
        q_at_(family.basis[1], bits + more + 64) {}

  const Values& at(const ComplexBall& z, long bits) {
    std::optional<Values>& known = values_[key_of(z)];
    if (!known || acb_equal(known->z.raw(), z.raw()) == 0)
      known = Values{z, piece_at_(z, bits), p_at_(z, bits), q_at_(z, bits)};
    return *known;
  }

  const long more;

 private:
  /// Different points may share one: then the last one is kept.
  static std::array<double, 4> key_of(const ComplexBall& z) {
    return {approximate(z.re()), approximate(z.im()), mag_get_d(arb_radref(acb_realref(z.raw()))),
            mag_get_d(arb_radref(acb_imagref(z.raw())))};
  }

  PieceFunction piece_at_;
  RotationFunction p_at_;
  RotationFunction q_at_;
  std::map<std::array<double, 4>, std::optional<Values>> values_;
};

MeanSquareBend::MeanSquareBend(const TwistPiece& piece, const RotationFamily& family, long bits)
    : points_(std::make_unique<Points>(piece, family, bits)), bits_(bits) {}

MeanSquareBend::~MeanSquareBend() = default;

RealBall MeanSquareBend::operator()(const RealBall& parameter, long most_points) {
  return quadrature(
      [&](const ComplexBall& z, long working) {
        const Operations op{working};
        const Points::Values& here = points_->at(z, working);
        const RotationFunction::Values& p = here.p;
        const RotationFunction::Values& q = here.q;
        const auto moved = [&](const ComplexBall& x, const ComplexBall& y) {
          return op.plus(x, multiply(parameter, y, working));
        };
        const auto slope_of_product = [&](const ComplexBall& u, const ComplexBall& u_slope,
                                          const ComplexBall& v, const ComplexBall& v_slope) {
          return op.plus(op.times(u, v_slope), op.times(u_slope, v));
        };
        const RotationFunction::Values w{moved(p.a, q.a), moved(p.b, q.b),
                                         moved(p.a_slope, q.a_slope), moved(p.b_slope, q.b_slope)};
        const ErrorValues values = error_values(here.piece.rate, w, working);
        const ComplexBall& norm = values.norm;
        // θ_p = 2K/D with K = Im(w̄⁰w¹), D_p = 2L with L = Re(w̄w¹), so that θ_pp/4 = −K/D·L/D.
        const ComplexBall k = op.minus(op.times(p.a, q.b), op.times(p.b, q.a));
        const ComplexBall k_slope = op.minus(slope_of_product(p.a, p.a_slope, q.b, q.b_slope),
                                             slope_of_product(p.b, p.b_slope, q.a, q.a_slope));
        const ComplexBall l = op.plus(op.times(w.a, q.a), op.times(w.b, q.b));
        const ComplexBall l_slope = op.plus(slope_of_product(w.a, w.a_slope, q.a, q.a_slope),
                                            slope_of_product(w.b, w.b_slope, q.b, q.b_slope));
        const ComplexBall k_share = op.over(k, norm);
        const ComplexBall l_share = op.over(l, norm);
        const auto change = [&](const ComplexBall& share, const ComplexBall& slope) {
          return op.over(op.minus(slope, op.times(share, values.norm_slope)), norm);
        };
        const ComplexBall k_change = change(k_share, k_slope);
        const ComplexBall l_change = change(l_share, l_slope);
        const ComplexBall bend = slope_of_product(k_share, k_change, l_share, l_change);
        const ComplexBall sum =
            op.minus(op.times(k_change, k_change), op.times(values.error, bend));
        return op.over(multiply(RealBall(8, working), sum, working), here.piece.speed);
      },
      bits_, points_->more, most_points);
}

RealBall greatest_error(const TwistPiece& piece, const Rotation& w, long bits) {
  // Branch and bound: a part can be left where |E| is less than elsewhere, or E is monotone.
  const long precision = working_precision(piece, bits);
  const ErrorJet error(piece, w, precision);
  RealBall least;  // of what the maximum can be
  const auto look_at = [&](const Rational& tau) {
    const RealBall here = absolute(error(tau, tau).value);
    if (here.is_finite()) arb_max(least.raw(), least.raw(), here.raw(), precision);
    return here;
  };
  struct Part {
    Rational a;
    Rational b;
  };
  std::vector<Part> parts;
  constexpr long first_parts = 16;
  for (long k = 0; k < first_parts; ++k)
    parts.push_back({Rational(k, first_parts), Rational(k + 1, first_parts)});
  for (long k = 0; k <= first_parts; ++k) look_at(Rational(k, first_parts));
  const RealBall fine = RealBall(power_of_two(-bits), 53);
  for (long round = 0;; ++round) {
    RealBall most = least;
    std::vector<Part> left;
    for (const Part& part : parts) {
      const Rational middle = (part.a + part.b) / 2;
      const auto [value, slope] = error(part.a, part.b);
      if (slope.is_finite() && !slope.contains_zero()) continue;  // the ends were looked at
      const RealBall offset = hull(Rational(part.a - middle), Rational(part.b - middle), precision);
      const RealBall inside =
          absolute(add(error(middle, middle).value, multiply(offset, slope, precision), precision));
      look_at(middle);
      if (arb_lt(inside.raw(), least.raw()) != 0) continue;
      most = hull(most, inside, precision);
      left.push_back({part.a, middle});
      left.push_back({middle, part.b});
    }
    const RealBall bound = hull(least, most, precision);
    const RealBall allowed = multiply(fine, add(least, fine, 53), 53);
    flint::Mag radius;
    arb_get_mag_lower(radius.get(), allowed.raw());
    const bool is_fine = mag_cmp(arb_radref(bound.raw()), radius.get()) <= 0;
    constexpr std::size_t most_parts = 5000;
    if (left.empty() || is_fine || round > bits || left.size() > most_parts) return bound;
    parts = std::move(left);
  }
}

}  // namespace phrame
