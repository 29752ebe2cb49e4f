#include "phrame/ph/sweep/rational_frame_piece.hpp"

#include <fmt/format.h>

#include <sstream>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/algebra/sturm.hpp"
#include "phrame/ph/curve/vector.hpp"

// The Euler–Rodrigues frame of A·w is that of A turned by 2·arg w, for w ∈ ℂ[t]. With w over ℚ(i)
// it is rational, whatever w is; which w makes it rotation-minimizing, or of minimal twist, is
// known from elsewhere.

namespace phrame::inline v0 {
namespace {

QuaternionPolynomial times(const QuaternionPolynomial& a, const GaussianPolynomial& w) {
  const auto [alpha, beta] = hopf_form(a);
  return without_real_content(from_hopf_form({alpha * w, beta * w}));
}

GaussianPolynomial constant(const GaussianRational& z) {
  return {Polynomial{z.re}, Polynomial{z.im}};
}

GaussianRational evaluate_at(const GaussianPolynomial& w, const Rational& t) {
  return {w.re(t), w.im(t)};
}

/// A short one with the same argument.
GaussianRational shortened(const GaussianRational& z) {
  const GaussianInteger multiple = primitive_multiple(z);
  return {multiple.re, multiple.im};
}

std::string why_not(const NoRationalFrame& none, std::size_t segment, bool is_curve) {
  std::ostringstream factor;
  factor << none.factor;
  const bool is_multiple = none.reason == NoRationalFrame::Reason::multiple_pole;
  return fmt::format(
      "sweep: the rotation-minimizing frame{} is not rational: its rate 2h/sigma has {} {}",
      is_curve ? "" : fmt::format(" of segment {}", segment + 1),
      is_multiple ? "multiple poles, the roots of" : "residues that are not in iZ, the roots of",
      abbreviated(factor.str(), 80));
}

Rational nearest_multiple(const Rational& x, const Rational& unit) {
  return Rational(floor(x / unit + Rational(1, 2))) * unit;
}

/// A number of ℚ(i) next to x + iy.
GaussianRational nearby(const std::pair<Real, Real>& z, long bits) {
  const Rational unit = power_of_two(-bits);
  return {nearest_multiple(z.first.enclose(bits + 4).midpoint(), unit),
          nearest_multiple(z.second.enclose(bits + 4).midpoint(), unit)};
}

/// The multiple of `direction` next to z, its factor rounded.
GaussianRational along(const GaussianRational& direction, const GaussianRational& z, long bits) {
  const Rational factor = (z * conjugate(direction)).re / norm(direction);
  const Rational unit = power_of_two(binary_exponent(abs(factor)) - bits);
  return nearest_multiple(factor, unit) * direction;
}

GaussianPolynomial polynomial_of(const std::vector<GaussianRational>& bernstein) {
  std::vector<Rational> re;
  std::vector<Rational> im;
  for (const GaussianRational& z : bernstein) {
    re.push_back(z.re);
    im.push_back(z.im);
  }
  return {from_bernstein(re), from_bernstein(im)};
}

/// What 2·arg of is the angle of an end, if that is rational.
std::optional<GaussianRational> exact_end(const FrameAngle& angle) {
  const auto z = direction_of(angle);
  return z ? half_turn_of(*z) : std::nullopt;
}

void require_no_zero(const QuaternionPolynomial& preimage) {
  if (count_real_roots(norm(preimage), closed_interval(0, 1)) > 0)
    throw Undecided("sweep: the rational frame of minimal twist is not told from one with a jump");
}

}  // namespace

std::optional<GaussianRational> half_turn_of(const GaussianRational& z) {
  const auto size = square_root(norm(z));
  if (!size) return std::nullopt;
  // z + |z| bisects the angle from 1 to z.
  if (z.im == 0 && z.re < 0) return GaussianRational{0, 1};
  return shortened({z.re + *size, z.im});
}

std::vector<RationalFramePiece> rational_rmf(const PhPath& path, const FrameStart& start) {
  const FrameAngle angle = start_angle(start, path);
  const auto first = exact_end(angle);
  if (!first)
    throw DomainError("sweep: at the start the angle of f2 to e2 is " + to_string(angle) +
                      ", whose sine and cosine are not rational");
  std::vector<RationalFramePiece> pieces;
  GaussianRational turned = *first;  // 2·arg of it is the angle where the segment starts
  for (const Curve& curve : path.segments()) {
    const std::size_t segment = pieces.size();
    const auto found = rational_frame(curve.preimage());
    if (const auto* none = std::get_if<NoRationalFrame>(&found))
      throw DomainError(why_not(*none, segment, path.is_curve()));
    const auto& frame = std::get<RationalFrame>(found);
    const GaussianRational c = shortened(turned * conjugate(evaluate_at(frame.w, 0)));
    pieces.push_back({segment, 0, 1, times(frame.preimage, constant(c))});
    turned = shortened(c * evaluate_at(frame.w, 1));
  }
  return pieces;
}

std::vector<RationalFramePiece> rational_mtf(const PhPath& path, const TwistFrame& frame,
                                             const FrameEnds& ends, long bits) {
  std::vector<RationalFramePiece> pieces;
  GaussianRational first;
  GaussianRational joint;  ///< 2·arg of it is the angle where the piece starts
  for (std::size_t k = 0; k < frame.pieces.size(); ++k) {
    const RationalTwist& twist = frame.pieces[k].twist;
    std::vector<GaussianRational> w;
    for (const auto& z : twist.coefficients()) w.push_back(nearby(z, bits));
    if (k == 0) joint = first = exact_end(ends.from).value_or(w.front());
    w.front() = along(joint, w.front(), bits);
    joint = w.back();
    if (k + 1 == frame.pieces.size())
      joint = ends.to ? exact_end(*ends.to).value_or(joint) : path.closing_turn().value() * first;
    w.back() = along(joint, w.back(), bits);
    const PathParameter at = locate_inside(path, twist.piece().from);
    const Rational to = at.t + twist.piece().to - twist.piece().from;
    const Polynomial t{at.t, to - at.t};
    const auto& [u, v, p, q] = path.segments()[at.segment].preimage();
    const QuaternionPolynomial preimage =
        times({compose(u, t), compose(v, t), compose(p, t), compose(q, t)}, polynomial_of(w));
    require_no_zero(preimage);
    pieces.push_back({at.segment, at.t, to, preimage});
  }
  return pieces;
}

bool is_closed(const std::vector<RationalFramePiece>& frames) {
  const RationalQuaternion first = evaluate(frames.front().preimage, 0);
  const RationalQuaternion last = evaluate(frames.back().preimage, 1);
  return norm(last) * rotated_i(first) == norm(first) * rotated_i(last) &&
         norm(last) * rotated_j(first) == norm(first) * rotated_j(last);
}

}  // namespace phrame
