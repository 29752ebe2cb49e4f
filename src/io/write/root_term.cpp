#include "phrame/io/write/root_term.hpp"

#include <fmt/format.h>

#include "phrame/algebra/surd_root.hpp"
#include "phrame/io/write/text.hpp"

namespace phrame::inline v0 {
namespace {

/// "√2·x + 1 − √3", slope > 0.
std::string linear(const Radical& slope, const Radical& constant, std::string_view variable,
                   const RadicalNotation& notation) {
  std::string text(variable);
  if (const auto r = slope.rational(); r && is_unicode(notation))
    text = formatted(Polynomial{0, *r}, Notation::unicode, variable);
  else if (!(slope == Radical(1)))
    text = fmt::format("{}{}{}", formatted_factor(slope, notation),
                       slope.rational() ? notation.times : notation.dot, variable);
  if (constant == Radical(0)) return text;
  const std::string rest = formatted(constant, notation);
  return rest.starts_with(notation.minus)
             ? fmt::format("{} {} {}", text, notation.minus, rest.substr(notation.minus.size()))
             : fmt::format("{} + {}", text, rest);
}

std::string quotient(const std::string& a, const std::string& b, const RadicalNotation& notation) {
  if (notation.quotient_encloses) return fmt::format(fmt::runtime(notation.quotient), a, b);
  const bool is_root = is_unicode(notation) && b.starts_with("√");
  const bool is_product = is_unicode(notation) && a.find(' ') == std::string::npos;
  return fmt::format("{}/{}", is_product ? a : "(" + a + ")", is_root ? b : "(" + b + ")");
}

/// The least m > 0 for which all coefficients of m·x are integers.
Integer denominator_of(const Radical& x) {
  Integer m = denominator(x.value().constant);
  for (const auto& term : x.value().terms) m = lcm(m, denominator(term.factor));
  return m;
}

/// m·(t + constant) and m·√radicand, without fractions.
struct Scaled {
  Rational scale;  // m
  Radical constant;
  Radical root;
};

Scaled scaled(const Surd& constant, const Surd& radicand) {
  const Radical c = to_radical(constant);
  const Radical root = times_root(Surd(1), radicand);
  const Rational m(lcm(denominator_of(c), denominator_of(root)));
  return {m, m * c, m * root};
}

/// factor·√radicand = numerator/root. Under the root there is at most one other; with several, what
/// is there would be long.
Radical product(const Surd& factor, const Surd& radicand, const Surd& numerator,
                const Radical& root) {
  const bool is_long = !simple_root(radicand) && (factor * factor * radicand).count_roots() > 1;
  return is_long ? to_radical(numerator) / root : times_root(factor, radicand);
}

}  // namespace

RootTerm written(const RealForm::Arctangent& term, std::string_view variable,
                 const RadicalNotation& notation) {
  const auto& [factor, of, radicand] = term;
  const Surd slope = coefficient(of, 1);
  const Surd constant = coefficient(of, 0);
  if (simple_root(radicand))
    return {
        times_root(factor, radicand),
        linear(times_root(slope, radicand), times_root(constant, radicand), variable, notation)};
  // √h·slope·(t + c) is (t + c)/√(1/(h·slope²)).
  const Scaled s = scaled(constant / slope, Surd(1) / (radicand * slope * slope));
  return {product(factor, radicand, s.scale * (factor / slope), s.root),
          quotient(linear(s.scale, s.constant, variable, notation), formatted(s.root, notation),
                   notation)};
}

RootTerm written(const RealForm::LogQuotient& term, std::string_view variable,
                 const RadicalNotation& notation) {
  const auto& [factor, of, radicand] = term;
  const Scaled s = scaled(coefficient(of, 0), radicand);
  return {product(factor, radicand, s.scale * (factor * radicand), s.root),
          quotient(linear(s.scale, s.constant - s.root, variable, notation),
                   linear(s.scale, s.constant + s.root, variable, notation), notation)};
}

}  // namespace phrame
