#include "phrame/io/write/endpoint_text.hpp"

#include <fmt/format.h>

#include <optional>

#include "phrame/algebra/surd.hpp"
#include "phrame/io/write/closed_form.hpp"
#include "phrame/io/write/text.hpp"

namespace phrame::inline v0 {
namespace {

/// No value for an algebraic number of a degree > 2.
std::optional<std::string> short_text(const PathEnd& end, Notation notation) {
  const bool is_unicode = notation == Notation::unicode;
  if (const auto* r = std::get_if<Rational>(&end))
    return is_unicode ? shown(*r) : formatted(*r, notation);
  if (const auto* infinite = std::get_if<Infinity>(&end))
    return std::string(*infinite == Infinity::negative ? (is_unicode ? "−" : "-") : "") +
           (is_unicode ? "∞" : "\\infty");
  if (const auto* p = std::get_if<PiValue>(&end)) {
    const std::string_view pi = is_unicode ? "π" : "\\pi ";
    const Polynomial& f = p->of_pi.numerator();
    if (p->of_pi.is_polynomial() && f == Polynomial::monomial(f.leading_coefficient(), 1))
      return formatted_multiple(f.leading_coefficient(), pi, notation);
    return formatted_quotient(p->of_pi, notation, pi);
  }
  const auto& a = std::get<RealAlgebraic>(end);
  if (a.polynomial().degree() > 2) return std::nullopt;
  const auto [middle, distance, d] = quadratic_root(a.polynomial());
  const bool is_greater = compare(a, middle) > 0;
  return formatted(Surd(middle, is_greater ? distance : -distance, d), notation);
}

}  // namespace

std::string to_text(const PathEnd& end) {
  constexpr std::size_t limit = 240;
  if (auto text = short_text(end, Notation::unicode)) return readable_exact(*text, limit);
  const auto& a = std::get<RealAlgebraic>(end);
  const Polynomial& p = a.polynomial();
  return fmt::format("the root of {} in {}", readable(formatted(p, Notation::unicode, "x"), p),
                     shown(a.interval()));
}

std::string to_latex(const PathEnd& end) {
  if (auto text = short_text(end, Notation::latex)) return *text;
  return "\\approx " + round_to_decimal(to_real(std::get<RealAlgebraic>(end)), 8).value;
}

}  // namespace phrame
