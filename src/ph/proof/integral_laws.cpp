#include "phrame/ph/proof/integral_laws.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/along/antisymmetric_rate.hpp"
#include "phrame/ph/curve/corner.hpp"
#include "phrame/ph/curve/formula_jet.hpp"
#include "phrame/ph/curve/real_vector.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/proof/check_decisions.hpp"

namespace phrame::inline v0 {
namespace {

Vector<Polynomial> quotient_of(const Vector<Polynomial>& v, const Polynomial& by) {
  return {exact_quotient(v[0], by), exact_quotient(v[1], by), exact_quotient(v[2], by)};
}

/// H × H′ = g·B, the parts of B coprime.
struct SplitBinormal {
  Polynomial g;  ///< 0 for a straight line
  Vector<Polynomial> b;
};

SplitBinormal split_binormal(const Vector<Polynomial>& h) {
  const Vector<Polynomial> b = cross(h, differentiate(h));
  const Polynomial g = gcd(b);
  return g.is_zero() ? SplitBinormal{} : SplitBinormal{g, quotient_of(b, g)};
}

bool are_parallel(const Vector<Rational>& a, const Vector<Rational>& b) {
  return cross(a, b) == Vector<Rational>{};
}

/// ⌊x·2^bits⌋/2^bits.
Rational rounded_down(const Rational& x, long bits) {
  return floor(x * power_of_two(bits)) * power_of_two(-bits);
}

/// 1 where p ≥ 0 from a to b, −1 where p ≤ 0, by its Bernstein coefficients; 0 where these have
/// both signs. Those of p(x) on [0, 1] are, but for positive factors, the coefficients of (1 +
/// s)ⁿ·p(1/(1 + s)).
int sign_on_piece(const Polynomial& p, const Rational& from, const Rational& to) {
  std::vector<Rational> c = compose(p, {from, to - from}).coefficients();
  std::reverse(c.begin(), c.end());
  c = compose(Polynomial(c), {1, 1}).coefficients();
  const auto [least, greatest] = std::minmax_element(c.begin(), c.end());
  return *least >= 0 ? 1 : *greatest <= 0 ? -1 : 0;
}

/// What is on the grid.
Polynomial polynomial_of(const GridPolynomial& p) {
  return power_of_two(-p.bits) * Polynomial(std::vector<Rational>(p.terms.begin(), p.terms.end()));
}

/// What may be spent on the symmetries of all claims along formulas.
constexpr long most_symmetry_work = 4'000'000'000;

const std::string no_line = "a straight line has no Frenet frame";

/// Taylor models of vectors.
class VectorModels {
 public:
  explicit VectorModels(const TaylorModels& models) : m_(models) {}

  TaylorModel dot(const Vector<TaylorModel>& a, const Vector<TaylorModel>& b) const {
    return m_.add(m_.add(m_.multiply(a[0], b[0]), m_.multiply(a[1], b[1])),
                  m_.multiply(a[2], b[2]));
  }
  Vector<TaylorModel> cross(const Vector<TaylorModel>& a, const Vector<TaylorModel>& b) const {
    const auto part = [&](std::size_t i, std::size_t j) {
      return m_.subtract(m_.multiply(a[i], b[j]), m_.multiply(a[j], b[i]));
    };
    return {part(1, 2), part(2, 0), part(0, 1)};
  }

 private:
  TaylorModels m_;
};

/// The numbers over the greatest of their absolute values; 0 remains 0.
Vector<TaylorModel> over_greatest(const Vector<Rational>& v, const TaylorModels& m) {
  const Rational size = std::max({abs(v[0]), abs(v[1]), abs(v[2])});
  const Rational most = size == 0 ? Rational(1) : size;
  return {m.number(v[0] / most), m.number(v[1] / most), m.number(v[2] / most)};
}

/// Where a segment ends.
struct ModelEnd {
  Vector<TaylorModel> position;
  Vector<TaylorModel> direction;  ///< e₁, of any length
  Vector<TaylorModel> binormal;   ///< with the Frenet frame: that or the opposite, of any length
};

/// At t = 0 or 1. Throws Undecided. Precondition: a weight is not 0 there.
ModelEnd end_of(const CertifiedSegment& segment, const DirectedCurve& curve, long t, bool is_frenet,
                const TaylorModels& m) {
  ModelEnd end;
  if (const auto* s = std::get_if<IntegralSegment>(&segment)) {
    for (std::size_t k = 0; k < 3; ++k)
      end.position[k] = m.number(s->position[k](t) / s->weight(t));
    end.direction = over_greatest(evaluate(curve.direction, t), m);
    if (is_frenet) end.binormal = over_greatest(evaluate(split_binormal(curve.direction).b, t), m);
    return end;
  }
  const auto& formulas = std::get<FormulaSegment>(segment);
  FormulaJets constants(m, ModelJet(1));
  const TaylorModel from = constants.of(formulas.from)[0];
  const TaylorModel to = constants.of(formulas.to)[0];
  ModelJet variable{t == 0 ? from : to, m.subtract(to, from)};
  if (is_frenet) variable.emplace_back();
  FormulaJets jets(m, variable);
  Vector<TaylorModel> bend;
  for (std::size_t k = 0; k < 3; ++k) {
    const ModelJet jet = jets.of(formulas.position[k]);
    end.position[k] = jet[0];
    end.direction[k] = m.multiply(curve.multiplier(0), jet[1]);
    if (is_frenet) bend[k] = jet[2];
  }
  if (is_frenet) end.binormal = VectorModels(m).cross(end.direction, bend);
  return end;
}

/// Of length 1. Throws Undecided.
Vector<TaylorModel> unit_of(Vector<TaylorModel> c, const TaylorModels& m) {
  const TaylorModel size = m.inverse(m.sqrt(VectorModels(m).dot(c, c)));
  for (TaylorModel& x : c) x = m.multiply(x, size);
  return c;
}

/// By how much the angle to the frame of v grows where the least rotation takes e₁ from along a to
/// along b. Of unit vectors v × a becomes v × a − det(v, a, b)(a + b)/(1 + a·b), and that, times 1
/// + a·b, has the components C and −S along v × b and b × (v × b). Throws Undecided.
TaylorModel turn_of(const Vector<Rational>& up, const Vector<TaylorModel>& along_a,
                    const Vector<TaylorModel>& along_b, const TaylorModels& m) {
  const VectorModels on(m);
  const Vector<TaylorModel> a = unit_of(along_a, m);
  const Vector<TaylorModel> b = unit_of(along_b, m);
  const Vector<TaylorModel> v = over_greatest(up, m);
  const TaylorModel d = on.dot(v, on.cross(a, b));
  const TaylorModel C =
      m.add(m.multiply(on.dot(on.cross(v, a), on.cross(v, b)), m.add(m.number(1), on.dot(a, b))),
            m.multiply(d, d));
  const TaylorModel S = m.multiply(d, m.add(on.dot(v, a), on.dot(v, b)));
  const TaylorModel size = m.sqrt(m.add(m.multiply(C, C), m.multiply(S, S)));
  return m.multiply(-2, m.atan(m.multiply(S, m.inverse(m.add(size, C)))));
}

/// The same of the Frenet frame, up to half a turn: the binormal B becomes B − (B·b)(a + b)/(1 +
/// a·b), which, times 1 + a·b, has the components C and S along the new one and b × that.
TaylorModel turn_of_frenet(const ModelEnd& before, const ModelEnd& after, const TaylorModels& m) {
  const VectorModels on(m);
  const Vector<TaylorModel> a = unit_of(before.direction, m);
  const Vector<TaylorModel> b = unit_of(after.direction, m);
  const Vector<TaylorModel> B = unit_of(before.binormal, m);
  const Vector<TaylorModel> to = unit_of(after.binormal, m);
  const TaylorModel c = m.add(m.number(1), on.dot(a, b));
  const TaylorModel along = on.dot(B, b);
  const auto part = [&](const Vector<TaylorModel>& w) {
    return m.subtract(m.multiply(c, on.dot(B, w)),
                      m.multiply(along, m.add(on.dot(a, w), on.dot(b, w))));
  };
  m.least(c, "the tangent turns back");
  return m.atan(m.multiply(part(on.cross(b, to)), m.inverse(part(to))));
}

/// Of the segments beside joint k that are by formulas the least bits of the pieces there; none if
/// there are no such segments.
std::optional<long> bits_of_joint(const IntegralCertificate& c, std::size_t k) {
  std::optional<long> least;
  for (const std::size_t j : {k - 1, k}) {
    const auto* formulas = std::get_if<FormulaSegment>(&c.segments[j]);
    if (formulas == nullptr) continue;
    const auto& pieces = formulas->pieces;
    const long bits = pieces.empty() ? 0 : j == k ? pieces.front().bits : pieces.back().bits;
    least = std::min(bits, least.value_or(bits));
  }
  return least;
}

/// Of places and frames beside formulas, as far as models tell.
std::string objection_to_joint(const IntegralCertificate& c, std::size_t k, long bits,
                               const DirectedCurve& before, DirectedCurve& after) {
  if (sign_before_one(before.multiplier) < 0) {
    after.multiplier = -after.multiplier;
    for (Polynomial& p : after.direction) p = -p;
  }
  const auto* a = std::get_if<IntegralSegment>(&c.segments[k - 1]);
  if (a != nullptr && a->weight(1) == 0) return "the weight of the segment before is 0 at its end";
  try {
    const TaylorModels m(2, bits);
    const bool is_frenet = c.frame == Reference::frenet;
    const ModelEnd end = end_of(c.segments[k - 1], before, 1, is_frenet, m);
    const ModelEnd start = end_of(c.segments[k], after, 0, is_frenet, m);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const TaylorModel gap = m.subtract(start.position[axis], end.position[axis]);
      if (abs(gap.constant()) + gap.radius > numerator(power_of_two(bits - bits / 2)))
        return "the segment does not begin where the one before ends";
    }
    if (!c.frame) return "";
    const TaylorModel turn = is_frenet ? turn_of_frenet(end, start, m)
                                       : turn_of(c.up, end.direction, start.direction, m);
    const Rational unit = power_of_two(-bits);
    after.turn_of_models = {Rational(turn.constant() - turn.radius) * unit,
                            Rational(turn.constant() + turn.radius) * unit};
    return "";
  } catch (const Undecided& error) {
    return error.what();
  }
}

/// What is integrated along a curve by formulas, for t = m + hz. Throws Undecided.
TaylorModel rate_of(const IntegralCertificate& c, const FormulaSegment& curve, const Rational& side,
                    const TaylorModels& m, const Rational& middle, const Rational& half) {
  const std::size_t most = !c.frame ? 1 : c.frame == Reference::up ? 2 : 3;
  FormulaJets constants(m, ModelJet(1));
  const TaylorModel from = constants.of(curve.from)[0];
  const TaylorModel span = m.subtract(constants.of(curve.to)[0], from);
  const TaylorModel t = m.add(m.number(middle), m.multiply(half, m.variable()));
  ModelJet s(most + 1);
  s[0] = m.add(from, m.multiply(span, t));
  s[1] = span;
  FormulaJets jets(m, s);
  std::vector<Vector<TaylorModel>> r(most + 1);  // derivatives over factorials
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const ModelJet jet = jets.of(curve.position[axis]);
    for (std::size_t k = 0; k <= most; ++k) r[k][axis] = jet[k];
  }
  const VectorModels v(m);
  const TaylorModel square = v.dot(r[1], r[1]);
  constexpr long least_exponent = 1000;
  if (bit_length(m.least(square, "r' may be 0")) + least_exponent <= m.bits())
    throw Undecided("r' is too small");
  const TaylorModel root = m.sqrt(square);
  if (!c.frame) return root;
  if (c.frame == Reference::frenet) {
    const Vector<TaylorModel> bend = v.cross(r[1], r[2]);
    const TaylorModel turn = m.multiply(-3, v.dot(bend, r[3]));
    return m.multiply(m.multiply(turn, m.inverse(v.dot(bend, bend))), root);
  }
  const Vector<TaylorModel> up{m.number(c.up[0]), m.number(c.up[1]), m.number(c.up[2])};
  const Vector<TaylorModel> across = v.cross(up, r[1]);
  const TaylorModel turn = m.multiply(-2, m.multiply(v.dot(up, r[1]), v.dot(across, r[2])));
  return m.multiply(
      side, m.multiply(m.multiply(turn, m.inverse(v.dot(across, across))), m.inverse(root)));
}

}  // namespace

DirectedCurve directed_curve(const CertifiedSegment& segment) {
  if (std::holds_alternative<FormulaSegment>(segment)) return {Polynomial{1}, {}};
  const auto& [X, W, square, pieces] = std::get<IntegralSegment>(segment);
  const Polynomial slope = differentiate(W);
  Vector<Polynomial> velocity = differentiate(X);
  for (std::size_t k = 0; k < 3; ++k) velocity[k] = velocity[k] * W - X[k] * slope;
  DirectedCurve curve;
  curve.multiplier = gcd(velocity);
  curve.direction = quotient_of(velocity, curve.multiplier);
  const auto& [x, y, z] = curve.direction;
  const Rational unit = common_content({x, y, z}) * Rational(sign_after_zero(curve.multiplier));
  curve.multiplier *= unit;
  for (Polynomial& p : curve.direction) p *= 1 / unit;
  return curve;
}

std::string name_of_joint(const IntegralCertificate& c, std::size_t k) {
  const auto bits = bits_of_joint(c, k);
  return fmt::format("joint {}", k) + (bits ? fmt::format(", to 2^-{}", *bits / 2) : "");
}

std::string objection_to_joint(const IntegralCertificate& c, std::size_t k,
                               const DirectedCurve& before, DirectedCurve& after) {
  if (const auto bits = bits_of_joint(c, k)) return objection_to_joint(c, k, *bits, before, after);
  const auto& a = std::get<IntegralSegment>(c.segments[k - 1]);
  const auto& b = std::get<IntegralSegment>(c.segments[k]);
  if (a.weight(1) == 0) return "the weight of the segment before is 0 at its end";
  if (Rational(1) / a.weight(1) * evaluate(a.position, 1) !=
      Rational(1) / b.weight(0) * evaluate(b.position, 0))
    return "the segment does not begin where the one before ends";
  if (!c.frame) return "";
  const Vector<Rational> x = evaluate(before.direction, 1);
  const Vector<Rational> y = evaluate(after.direction, 0);
  const bool is_corner = !are_parallel(x, y);
  const bool goes_on = is_corner ? sign_before_one(before.multiplier) > 0 : dot(x, y) > 0;
  if (!goes_on) {
    after.multiplier = -after.multiplier;
    for (Polynomial& p : after.direction) p = -p;
  }
  if (c.frame == Reference::up) {
    if (are_parallel(c.up, x) || are_parallel(c.up, y)) return "v is along the tangent";
    const Vector<Rational> to = goes_on ? y : Rational(-1) * y;
    const Vector<Rational> S = cross(c.up, x);
    const Vector<Rational> T = cross(c.up, to);
    const bool is_carried = (dot(c.up, x) == 0 && dot(c.up, y) == 0) ||  // about v, or v stays
                            (dot(S, to) == 0 && dot(S, T) > 0);          // in the plane of both
    if (is_corner && !is_carried)
      after.turn = carried_angle(as_reals(x), as_reals(S), as_reals(to), as_reals(T));
    return "";
  }
  const SplitBinormal m = split_binormal(before.direction);
  const SplitBinormal n = split_binormal(after.direction);
  if (m.g.is_zero() || n.g.is_zero()) return no_line;
  return are_parallel(evaluate(m.b, 1), evaluate(n.b, 0)) ? "" : "the Frenet frame does not go on";
}

std::variant<RootQuotient, std::string> integrand(const IntegralCertificate& c, std::size_t k,
                                                  const DirectedCurve& curve) {
  const Polynomial& f = curve.multiplier;
  const Vector<Polynomial>& H = curve.direction;
  const auto& segment = std::get<IntegralSegment>(c.segments[k]);
  const Polynomial& root = segment.square;
  if (root(0) <= 0) return "square is not positive at t = 0";
  const auto [S, rest] = divide(dot(H, H), root * root);
  if (!rest.is_zero()) return "|H|^2 is not divisible by the square of that";
  if (!c.frame) return RootQuotient{f * root * S, segment.weight * segment.weight, S};
  if (c.frame == Reference::up) {
    const Vector<Polynomial> v = as_polynomials(c.up);
    const Vector<Polynomial> across = cross(v, H);
    return RootQuotient{-(dot(v, H) * dot(across, differentiate(H))), dot(across, across) * root,
                        S};
  }
  const auto [g, B] = split_binormal(H);
  if (g.is_zero()) return no_line;
  const Polynomial turn = exact_quotient(dot(B, differentiate(differentiate(H))), g);
  return RootQuotient{-(turn * root * S), dot(B, B), S};
}

std::string objection_to_symmetry(const IntegralCertificate& c, const DirectedCurve& curve,
                                  const Rational& t, const Antisymmetry& symmetry,
                                  std::size_t claims) {
  if (!c.frame) return "lengths have no such symmetry";
  if (symmetry.shift && denominator(t / (2 * *symmetry.shift)) != 1)
    return "t is no multiple of twice the shift";
  constexpr const char* none = "the rate does not have that symmetry";
  if (const auto* formulas = std::get_if<FormulaSegment>(&c.segments.front())) {
    const auto v = c.frame == Reference::up ? std::optional(c.up) : std::nullopt;
    const Integer most = most_symmetry_work / Integer(claims);
    return unless(
        has_antisymmetry(formulas->position, formulas->from, formulas->to, v, t, symmetry, most),
        none);
  }
  const auto f = integrand(c, 0, curve);
  if (const auto* objection = std::get_if<std::string>(&f)) return *objection;
  return unless(has_antisymmetry(std::get<RootQuotient>(f), t, symmetry), none);
}

Polynomial on_piece(const Polynomial& p, const Rational& from, const Rational& to) {
  return compose(p, {(from + to) / 2, (to - from) / 2});
}

Rational sum_of_sizes(const Polynomial& p) {
  Rational sum = 0;
  for (const Rational& c : p.coefficients()) sum += abs(c);
  return sum;
}

// With |1 − Su²| ≤ δ < 1 and u > 0, u√S is the root of a number between 1 − δ and 1 + δ, so that
// N/(D√S) differs from Nu/D by |Nu/D|·δ/(1 − δ) at most, and that from p by |Nu − Dp|/|D|.
PieceProof::PieceProof(const RootQuotient& f, const IntegralPiece& piece, const Rational& start)
    : start_(start),
      middle_((start + piece.to) / 2),
      half_((piece.to - start) / 2),
      bits_(piece.rate.bits + 64 + bit_length(denominator(half_))) {
  const auto there = [&](const Polynomial& p) { return on_piece(p, start, piece.to); };
  const Polynomial D = there(f.denominator);
  const Polynomial u = polynomial_of(piece.root);
  const Polynomial p = polynomial_of(piece.rate);
  const Rational delta = sum_of_sizes(Polynomial{1} - there(f.radicand) * u * u);
  const Rational least = 2 * D.coefficient(0) - sum_of_sizes(D);
  if (delta >= 1 || u.coefficient(0) <= 0) {
    objection_ = "the root of it is too far off";
    return;
  }
  if (least <= 0) {
    objection_ = "the denominator is not proved to be positive on it";
    return;
  }
  const Polynomial product = there(f.numerator) * u;
  error_ = (sum_of_sizes(product - D * p) + sum_of_sizes(product) * delta / (1 - delta)) / least;
  size_ = sum_of_sizes(p);
  integral_ = antiderivative(p);
}

PieceProof::PieceProof(const IntegralCertificate& c, const FormulaSegment& segment,
                       const DirectedCurve& curve, const ModelPiece& piece, const Rational& start)
    : start_(start),
      middle_((start + piece.to) / 2),
      half_((piece.to - start) / 2),
      bits_(piece.bits + 64 + bit_length(denominator(half_))) {
  constexpr long least_piece = 30;
  if (piece.to - start < power_of_two(-least_piece)) {
    is_too_short_ = true;
    objection_ = "it is too short";
    return;
  }
  try {
    const TaylorModel rate = rate_of(c, segment, curve.multiplier(0),
                                     TaylorModels(piece.order, piece.bits), middle_, half_);
    const Polynomial p = polynomial_of({rate.terms, piece.bits});
    error_ = Rational(rate.radius) * power_of_two(-piece.bits);
    size_ = sum_of_sizes(p);
    integral_ = antiderivative(p);
  } catch (const Undecided& error) {
    objection_ = error.what();
  }
}

PieceProof& PieceProof::of_size(const Polynomial& multiplier) {
  sign_ = sign_on_piece(multiplier, start_, start_ + 2 * half_);
  return *this;
}

IntegralBounds PieceProof::bounds(const Rational& t) const {
  const Rational way = t - start_;
  const Rational value =
      Rational(sign_) * half_ * (integral_((t - middle_) / half_) - integral_(-1));
  const Rational lower = sign_ == 0 ? Rational(0) : value - error_ * way;
  const Rational upper = sign_ == 0 ? (size_ + error_) * way : value + error_ * way;
  return {rounded_down(lower, bits_), -rounded_down(-upper, bits_)};
}

}  // namespace phrame
