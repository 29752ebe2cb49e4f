#include "phrame/ph/proof/check_decisions.hpp"

#include "phrame/algebra/error.hpp"

namespace phrame::inline v0 {
namespace {

StatedPoint stated(const RealRoot& root) {
  return {root.at.polynomial(), root.at.interval(), root.order};
}

std::vector<StatedPoint> stated(const std::vector<RealRoot>& roots) {
  std::vector<StatedPoint> list;
  for (const RealRoot& root : roots) list.push_back(stated(root));
  return list;
}

/// The root on [0, 1] that is meant; none where it is not the only one in the interval, or an end
/// of that is a root, too. In a long interval roots are counted sooner than isolated.
std::optional<RealRoot> meant(const StatedPoint& point) {
  const auto& [lower, upper] = std::pair(*point.interval.lower, *point.interval.upper);
  if (lower != upper && (point.polynomial(lower) == 0 || point.polynomial(upper) == 0))
    return std::nullopt;
  if (count_real_roots(point.polynomial, point.interval) != 1) return std::nullopt;
  Interval part = point.interval;
  if (lower < 0) part.lower = 0, part.lower_closed = true;
  if (upper > 1) part.upper = 1, part.upper_closed = true;
  try {
    return RealRoot{real_root(point.polynomial, part), point.order};
  } catch (const DomainError&) {
    return std::nullopt;
  }
}

/// In any order.
std::string objection_to_points(const std::vector<StatedPoint>& stated,
                                std::vector<RealRoot> roots) {
  if (stated.size() != roots.size()) return "the points are not as many";
  for (const StatedPoint& point : stated) {
    const auto root = meant(point);
    if (!root) return "an interval does not hold one root of its polynomial";
    if (std::erase(roots, *root) == 0) return "a point or its order is another one";
  }
  return "";
}

/// One decision: the answer is that of classify, and its witness, if there is one, is a witness.
template <class T, class Holds>
std::string objection_to_witness(const std::optional<T>& stated, bool answer, Holds holds) {
  if (stated.has_value() != answer) return "the answer is the other one";
  return unless(!stated || holds(*stated), "the witness is none");
}

// What makes a witness one. r is A i A*, which has the direction of the tangent, s is σ.

bool is_nonzero(const Vector<Rational>& v) { return v != Vector<Rational>{}; }

/// v × r = 0.
bool witnesses_line(const Vector<Rational>& v, const Vector<Polynomial>& r) {
  for (std::size_t k = 0; k < 3; ++k)
    if (!(v[k] * r[(k + 1) % 3] == v[(k + 1) % 3] * r[k])) return false;
  return is_nonzero(v);
}

/// n·r = 0.
bool witnesses_plane(const Vector<Rational>& n, const Vector<Polynomial>& r) {
  return is_nonzero(n) && dot(n, r).is_zero();
}

/// (axis·r)² = cos²ψ |axis|²σ².
bool witnesses_helix(const StatedDecisions::Helix& helix, const Vector<Polynomial>& r,
                     const Polynomial& s) {
  const auto& [x, y, z] = helix.axis;
  const Rational square = helix.cosine_squared * (x * x + y * y + z * z);
  return is_nonzero(helix.axis) && pow(dot(helix.axis, r), 2) == square * pow(s, 2);
}

/// im(w′ w̄)σ = −h|w|².
bool witnesses_rational_frame(const GaussianPolynomial& w, const QuaternionPolynomial& a,
                              const Polynomial& s) {
  return !is_zero(w) &&
         (differentiate(w) * conjugate(w)).im * s == Rational(-1) * twist_numerator(a) * norm(w);
}

}  // namespace

StatedDecisions stated(const Classification& c) {
  StatedDecisions d{c.cusps.empty(),
                    stated(c.cusps),
                    !c.inflections.empty(),
                    stated(c.inflections),
                    c.line,
                    c.normal,
                    {},
                    c.double_ph,
                    c.content.is_constant(),
                    c.content,
                    c.erf_is_rotation_minimizing,
                    {},
                    c.erf_turning.is_monotone,
                    stated(c.erf_turning.zeros),
                    stated(c.erf_turning.extrema)};
  if (c.helix) d.helix = {c.helix->axis, c.helix->cosine_squared};
  if (const auto* frame = std::get_if<RationalFrame>(&c.rational_frame))
    d.rational_frame = frame->w;
  return d;
}

std::vector<Statement> check_decisions(const StatedDecisions& d, const Curve& curve) {
  const Classification c = classify(curve);
  const QuaternionPolynomial& a = curve.preimage();
  const Vector<Polynomial> r = rotated_i(a);
  const Polynomial s = sigma(a);
  const auto answer = [](bool stated, bool true_one) {
    return unless(stated == true_one, "the answer is the other one");
  };
  const auto points = [&](bool stated, bool true_one, const std::vector<StatedPoint>& list,
                          const std::vector<RealRoot>& roots) {
    const std::string objection = answer(stated, true_one);
    return objection.empty() ? objection_to_points(list, roots) : objection;
  };
  std::string monotone =
      points(d.erf_monotone, c.erf_turning.is_monotone, d.zeros_of_h, c.erf_turning.zeros);
  if (monotone.empty()) monotone = objection_to_points(d.extrema, c.erf_turning.extrema);
  std::string primitive = answer(d.primitive, c.content.is_constant());
  if (primitive.empty() &&
      (d.content.is_zero() || !(primitive_part(d.content) == primitive_part(c.content))))
    primitive = "the content is another polynomial";
  const auto line = objection_to_witness(d.line, c.line.has_value(),
                                         [&](const auto& v) { return witnesses_line(v, r); });
  const auto plane = objection_to_witness(d.normal, c.normal.has_value(),
                                          [&](const auto& n) { return witnesses_plane(n, r); });
  const auto helix = objection_to_witness(d.helix, c.helix.has_value(), [&](const auto& witness) {
    return witnesses_helix(witness, r, s);
  });
  const auto double_ph = objection_to_witness(
      d.double_ph, c.double_ph.has_value(),
      [&](const auto& square) { return rho(a) == square.constant * pow(square.omega, 2); });
  const auto rrmf = objection_to_witness(
      d.rational_frame, std::holds_alternative<RationalFrame>(c.rational_frame),
      [&](const auto& w) { return witnesses_rational_frame(w, a, s); });
  const auto decision = [](const char* name, bool is_yes, std::string objection) {
    return Statement{std::string("decision ") + name + (is_yes ? ": yes" : ": no"),
                     std::move(objection)};
  };
  return {decision("regular", d.regular, points(d.regular, c.cusps.empty(), d.cusps, c.cusps)),
          decision("inflections", d.has_inflections,
                   points(d.has_inflections, !c.inflections.empty(), d.inflections, c.inflections)),
          decision("line", d.line.has_value(), line),
          decision("planar", d.normal.has_value(), plane),
          decision("helical", d.helix.has_value(), helix),
          decision("double_ph", d.double_ph.has_value(), double_ph),
          decision("primitive", d.primitive, primitive),
          decision("erf_is_rmf", d.erf_is_rmf, answer(d.erf_is_rmf, c.erf_is_rotation_minimizing)),
          decision("rrmf", d.rational_frame.has_value(), rrmf),
          decision("erf_monotone", d.erf_monotone, monotone)};
}

}  // namespace phrame
