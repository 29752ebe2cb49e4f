#include "phrame/io/write/algebraic_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/radical_roots.hpp"
#include "phrame/io/write/radical_text.hpp"

namespace phrame::inline v0 {
namespace {

/// x in radicals without i. The real roots come first, in ascending order.
std::optional<Radical> real_radical(const RealAlgebraic& x) {
  const Polynomial& p = x.polynomial();
  if (p.degree() > 4) return std::nullopt;
  const auto before = count_real_roots(p, {std::nullopt, *x.interval().lower});
  const Radical root = roots_by_radicals(p)[static_cast<std::size_t>(before)];
  const bool is_real = std::none_of(
      root.steps().begin(), root.steps().end(),
      [](const Radical::Step& step) { return step.kind == Radical::Kind::imaginary_unit; });
  // Cube roots of complex numbers are those of a + √b with b < 0, written with i, too.
  return is_real ? std::optional(root) : std::nullopt;
}

/// ±radical·name.
std::string product(const Radical& x, std::string_view dot, std::string_view name,
                    const RadicalNotation& notation) {
  const bool negative = is_written_negative(x);
  return fmt::format("{}{}{}{}", negative ? notation.minus : "",
                     formatted_factor(negative ? -x : x, notation), dot, name);
}

}  // namespace

std::string formatted_multiple(const RealAlgebraic& x, std::string_view name, Notation notation) {
  const bool is_latex = notation == Notation::latex;
  if (const auto radical = real_radical(x))
    return product(*radical, is_latex ? " " : "·", name,
                   is_latex ? radical_notation::latex : radical_notation::unicode);
  if (is_latex)  // There is no room for the polynomial.
    return fmt::format(
        "{} \\cdot {}", name,
        in_parentheses("\\approx " + round_to_decimal(to_real(x), 8).value, notation));
  const Polynomial& p = x.polynomial();
  return fmt::format("{}·(the root of {} in {})", name, readable(formatted(p, notation, "x"), p),
                     shown(x.interval()));
}

std::string cas_multiple(const RealAlgebraic& x, std::string_view name, Language language) {
  if (const auto radical = real_radical(x))
    return product(*radical, "*", name, radical_notation_of(language));
  const Polynomial& p = x.polynomial();
  const Rational low = *x.interval().lower;
  const Rational high = *x.interval().upper;
  const auto before = count_real_roots(p, {std::nullopt, low});
  const auto polynomial = [&](const std::string& letter) {
    return cas_formula(RationalFunction(p), language, letter);
  };
  const auto number = [&](const Rational& r) { return cas_formula(exact_value(r), language); };
  const auto times = [&](const std::string& root) { return fmt::format("{}*{}", root, name); };
  switch (language) {
    case Language::sympy:
      return times(fmt::format("CRootOf({}, {})", polynomial("Symbol('x')"), before));
    case Language::mathematica:
      return times(fmt::format("Root[{} &, {}]", polynomial("#"), before + 1));
    case Language::maple:
      return times(
          fmt::format("RootOf({}, {} .. {})", polynomial("_Z"), number(low), number(high)));
    case Language::maxima:
      return times(
          fmt::format("find_root({}, x, {}, {})", polynomial("x"), number(low), number(high)));
    case Language::pari:
      return times(fmt::format("polrootsreal({})[{}]", polynomial("'x"), before + 1));
    case Language::plain:
      break;
  }
  return times(fmt::format("root({}, {}, {})", polynomial("x"), number(low), number(high)));
}

}  // namespace phrame
