// With n × e₁ = 1, n′ = φ′e₁, r′ = ±|r′|·e₁ and r × n′ = (r × n)′ ± |r′| it is
//   r_d × r_d′ = r × r′ + d·((r × n)′ ± 2|r′|) + d²φ′,
// and d·n = r_d − r, so that of a part the area and the length are
//   [½∫ r × r′ + ½ r × r_d ± d·s + ½d²φ],   [s ± d·φ]:
// functions of the parameter that are rational but for φ. On an arc r is the corner, and s = 0. The
// sign is that of r_d′·e₁, too, as 1 + dκ ≥ 0 on what is left.
#include "phrame/ph/offset/trim_measure.hpp"

#include "phrame/ph/along/segment_integral.hpp"
#include "phrame/ph/curve/place.hpp"
#include "phrame/ph/curve/real_vector.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/offset/plane_tangent.hpp"
#include "phrame/ph/offset/turning_parts.hpp"

namespace phrame::inline v0 {
namespace {

/// The angle φ of H, continuous.
class DirectionAngle {
 public:
  explicit DirectionAngle(const RationalCurve& curve)
      : x_(curve.direction()[0]), y_(curve.direction()[1]) {
    const Polynomial turn = x_ * differentiate(y_) - y_ * differentiate(x_);
    if (!turn.is_zero()) knots_ = turning_cuts(turn, x_ * x_ + y_ * y_);
  }

  /// φ(to) − φ(from).
  Real between(const Real& from, const Real& to) const {
    if (knots_.empty()) return Rational(0);
    return cached(Real(Real::Enclosure([*this, from, to](long bits) {
      return subtract(from_start(to, bits + 16), from_start(from, bits + 16), bits);
    })));
  }

 private:
  RealBall turn(const RealBall& from, const RealBall& to, long bits) const {
    const auto at = [&](const RealBall& t) {
      return ComplexBall(evaluate(x_, t, bits), evaluate(y_, t, bits));
    };
    return argument(multiply(at(to), conjugate(at(from)), bits), bits);
  }

  RealBall from_start(const Real& t, long bits) const {
    const RealBall end = t.enclose(bits + 32);
    RealBall sum;
    Rational last = 0;
    for (const Rational& knot : knots_) {
      if (end.midpoint() <= knot) break;
      sum = add(sum, turn(RealBall(last, bits), RealBall(knot, bits), bits), bits);
      last = knot;
    }
    return add(sum, turn(RealBall(last, bits), end, bits), bits);
  }

  Polynomial x_;
  Polynomial y_;
  std::vector<Rational> knots_ = {};  ///< between two of them it turns by less than π
};

struct PartMeasure {
  Real length;
  Real area;
};

/// The ends of a part, known well enough to tell them apart.
struct PartEnds {
  Rational from;
  Rational to;

  explicit PartEnds(const OffsetPart& part) {
    long bits = 64;
    do {
      from = part.from.enclose(bits).midpoint();
      to = part.to.enclose(bits).midpoint();
      bits *= 4;
    } while (from == to && bits < 10'000);
  }
  int way() const { return from < to ? 1 : -1; }  ///< as way_along()
  /// The sign of p on it, where that does not change.
  int sign_of(const Polynomial& p) const {
    Rational at = (from + to) / 2;
    while (from != to && p(at) == 0) at = (at + to) / 2;
    return p(at).sign();
  }
};

/// Of a mitre, a straight line with a rational length.
PartMeasure measure_line(const RationalCurve& line, const OffsetPart& part) {
  const Vector<Rational> start = point(line, 0);
  const Vector<Rational> way = point(line, 1) - start;
  const Real share = part.to + -part.from;
  const Real size = square_root_of(Rational(way[0] * way[0] + way[1] * way[1]));
  return {Real(Rational(way_along(part))) * size * share,
          Real(Rational((start[0] * way[1] - start[1] * way[0]) / 2)) * share};
}

SegmentIntegral zero_integral() { return {PolynomialIntegral{}}; }

/// ½∫ r × r′.
SegmentIntegral inner_integral(const Curve& curve) {
  const auto& [x, y, z] = numerator(curve);
  const Polynomial rate = Rational(1, 2) * (x * differentiate(y) - y * differentiate(x));
  if (curve.is_polynomial()) return {PolynomialIntegral{antiderivative(rate), rate}};
  return {TaylorIntegral({rate, pow(curve.weight(), 2)})};
}

PartMeasure measure_part(const PhPath& path, const Offset& offset, const OffsetPart& part) {
  const OffsetPiece& piece = offset.pieces[part.piece];
  if (piece.is_join && piece.curve.weight().is_constant()) return measure_line(piece.curve, part);
  const Curve& curve = path.segments()[piece.segment];
  Vector<Polynomial> r{Polynomial{curve.start()[0]}, Polynomial{curve.start()[1]}, {}};
  Polynomial w{1};
  SegmentIntegral s = zero_integral();
  SegmentIntegral inner = zero_integral();
  if (!piece.is_join) {
    r = numerator(curve);
    w = curve.weight();
    s = arc_length(PhSegment(curve));
    inner = inner_integral(curve);
  }
  const auto grown = [&](const SegmentIntegral& f) {
    return cached(f.value(part.to) + -f.value(part.from));
  };
  const auto change = [&](const RationalFunction& f) {
    return cached(value(f, Place(0, part.to)) + -value(f, Place(0, part.from)));
  };
  const Rational half(1, 2);
  const Rational& d = offset.distance;
  const auto& [x, y, z] = piece.curve.numerator();
  const Real length = grown(s);
  const Real angle = DirectionAngle(piece.curve).between(part.from, part.to);
  const RationalFunction outer(half * (r[0] * y - r[1] * x), w * piece.curve.weight());
  const PartEnds ends(part);
  const Rational signed_d = ends.sign_of(piece.curve.multiplier()) * d;
  return {Real(Rational(ends.way())) * (length + Real(signed_d) * angle),
          grown(inner) + change(outer) + Real(signed_d) * length + Real(half * d * d) * angle};
}

}  // namespace

int way_along(const OffsetPart& part) { return PartEnds(part).way(); }

BranchMeasure measure(const PhPath& path, const TrimmedOffset& trimmed,
                      const TrimmedBranch& branch) {
  std::vector<Real> lengths;
  std::vector<Real> areas;
  for (const OffsetPart& part : branch.parts) {
    PartMeasure more = measure_part(path, trimmed.offset, part);
    lengths.push_back(std::move(more.length));
    areas.push_back(std::move(more.area));
  }
  return {sum_of(std::move(lengths)),
          branch.is_closed ? std::optional(sum_of(std::move(areas))) : std::nullopt};
}

}  // namespace phrame
