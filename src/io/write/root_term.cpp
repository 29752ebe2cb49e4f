#include "phrame/io/write/root_term.hpp"

#include <fmt/format.h>

#include "phrame/algebra/surd_root.hpp"
#include "phrame/io/write/text.hpp"

namespace phrame {
namespace {

bool is_unicode(const RadicalNotation& notation) { return &notation == &radical_notation::unicode; }

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
  Radical slope;
  Radical constant;
  Radical root;
};

Scaled scaled(const Surd& constant, const Surd& radicand) {
  const Radical c = to_radical(constant);
  const Radical root = times_root({1, 0}, radicand);
  const Rational m(lcm(denominator_of(c), denominator_of(root)));
  return {m, m * c, m * root};
}

}  // namespace

RootTerm written(const RealForm::Arctangent& term, std::string_view variable,
                 const RadicalNotation& notation) {
  const Surd slope = coefficient(term.of, 1);
  const Surd constant = coefficient(term.of, 0);
  const Radical factor = times_root(term.factor, term.radicand);
  if (has_simple_root(term.radicand))
    return {factor, linear(times_root(slope, term.radicand), times_root(constant, term.radicand),
                           variable, notation)};
  // √h·slope·(t + c) is (t + c)/√(1/(h·slope²)).
  const Scaled s = scaled(constant / slope, Surd{1, 0} / (term.radicand * slope * slope));
  return {factor, quotient(linear(s.slope, s.constant, variable, notation),
                           formatted(s.root, notation), notation)};
}

RootTerm written(const RealForm::LogQuotient& term, std::string_view variable,
                 const RadicalNotation& notation) {
  const Scaled s = scaled(coefficient(term.of, 0), term.radicand);
  return {times_root(term.factor, term.radicand),
          quotient(linear(s.slope, s.constant - s.root, variable, notation),
                   linear(s.slope, s.constant + s.root, variable, notation), notation)};
}

}  // namespace phrame
