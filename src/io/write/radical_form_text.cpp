#include "phrame/io/write/radical_form_text.hpp"

#include <fmt/format.h>

#include "phrame/algebra/sturm.hpp"
#include "phrame/io/write/text.hpp"

namespace phrame::inline v0 {
namespace {

std::string in_pattern(std::string_view pattern, std::string_view a, std::string_view b = "") {
  return fmt::vformat(pattern, fmt::make_format_args(a, b));
}

/// A sum of signed terms.
class Terms {
 public:
  Terms(std::string_view minus, std::string_view separator)
      : minus_(minus), separator_(separator) {}

  void add(bool negative, std::string_view term) {
    if (!text_.empty())
      text_ += fmt::format("{}{} ", separator_, negative ? minus_ : "+");
    else if (negative)
      text_ += minus_;
    text_ += term;
  }
  /// A term that may begin with the minus sign.
  void add(std::string_view term) {
    const bool negative = term.starts_with(minus_);
    add(negative, negative ? term.substr(minus_.size()) : term);
  }
  std::string text() const { return text_.empty() ? "0" : text_; }

 private:
  std::string_view minus_;
  std::string_view separator_;
  std::string text_;
};

std::string power_text(std::string_view variable, std::size_t k, const RadicalNotation& notation) {
  if (k == 1) return std::string(variable);
  if (is_unicode(notation))
    return formatted(Polynomial::monomial(1, static_cast<long>(k)), Notation::unicode, variable);
  return in_pattern(notation.power, variable, std::to_string(k));
}

/// v(x, t) at the k-th root, highest power of t first.
std::string argument_text(const RadicalSum& sum, std::size_t root, std::string_view variable,
                          const RadicalNotation& notation) {
  Terms terms(notation.minus, " ");
  for (long k = sum.sum.argument.degree(); k >= 0; --k) {
    const Radical c = evaluate(sum.sum.argument.coefficient(k), sum.roots[root]);
    if (c == Radical(0)) continue;
    const bool negative = is_written_negative(c);
    const Radical size = negative ? -c : c;
    std::string term = formatted_factor(size, notation);
    if (k > 0) {
      if (is_unicode(notation) && term.find('/') != std::string::npos)
        term = fmt::format("({})", term);
      if (size == Radical(1))
        term.clear();
      else
        term += notation.times;
      term += power_text(variable, static_cast<std::size_t>(k), notation);
    }
    terms.add(negative, term);
  }
  return terms.text();
}

/// May the argument at a real root be negative somewhere?
bool needs_bars(const RadicalSum& sum, std::size_t root) {
  if (root >= sum.real_roots) return false;
  if (sum.sum.index.degree() > 1) return true;
  std::vector<Rational> argument;
  for (const Polynomial& c : sum.sum.argument.coefficients())
    argument.push_back(c(*sum.roots[root].rational()));
  return count_real_roots(Polynomial(argument), real_line()) > 0;
}

std::string log_text(const std::string& argument, bool bars, const RadicalNotation& notation) {
  if (!bars) return in_pattern(notation.log, argument);
  return is_unicode(notation) ? "log|" + argument + "|" : "\\log\\left|" + argument + "\\right|";
}

/// Σ residue·log(v), written out. `bars`: log|v| for real v.
void add_logs(Terms& terms, const RadicalSum& sum, std::string_view variable,
              const RadicalNotation& notation, bool bars) {
  for (std::size_t k = 0; k < sum.roots.size(); ++k) {
    const bool negative = is_written_negative(sum.residues[k]);
    const Radical size = negative ? -sum.residues[k] : sum.residues[k];
    const std::string factor =
        size == Radical(1) ? "" : formatted_factor(size, notation) + std::string(notation.dot);
    terms.add(negative, factor + log_text(argument_text(sum, k, variable, notation),
                                          bars && needs_bars(sum, k), notation));
  }
}

void add_algebraic_part(Terms& terms, const RadicalForm& F, Notation notation,
                        std::string_view variable) {
  if (!F.polynomial.is_zero()) terms.add(formatted(F.polynomial, notation, variable));
  if (F.rational.is_zero()) return;
  const bool negative = F.rational.numerator().leading_coefficient() < 0;
  const Polynomial size = negative ? -F.rational.numerator() : F.rational.numerator();
  terms.add(negative, fmt::format(fmt::runtime(notation == Notation::latex ? "\\frac{{{}}}{{{}}}"
                                                                           : "({})/({})"),
                                  formatted(size, notation, variable),
                                  formatted_factors(F.rational.denominator(), notation, variable)));
}

bool is_written_out(const RadicalSum& sum) { return sum.sum.index.degree() <= 2; }

/// "log(t − z)", "log(t² + (2z + 1)t − z)".
std::string log_of_unknown(const RadicalSum& sum, std::string_view variable,
                           const RadicalNotation& notation, std::string_view root, bool bars) {
  const Notation plain = is_unicode(notation) ? Notation::unicode : Notation::latex;
  Terms terms(notation.minus, " ");
  for (long k = sum.sum.argument.degree(); k >= 0; --k) {
    const Polynomial c = sum.sum.argument.coefficient(k);
    if (c.is_zero()) continue;
    const std::string factor = formatted(c, plain, root);
    if (k == 0) {
      terms.add(factor);
    } else {
      const std::string power = power_text(variable, static_cast<std::size_t>(k), notation);
      terms.add(c == Polynomial{1} ? power : in_pattern(notation.parentheses, factor) + power);
    }
  }
  return log_text(terms.text(), bars, notation);
}

}  // namespace

std::string to_text(const RadicalForm& F, std::string_view variable, std::string_view root) {
  static constexpr const char* subscripts[] = {"₁", "₂", "₃", "₄"};
  const RadicalNotation& notation = radical_notation::unicode;
  Terms terms(notation.minus, "\n");
  add_algebraic_part(terms, F, Notation::unicode, variable);
  for (const RadicalSum& sum : F.logs) {
    if (is_written_out(sum)) {
      add_logs(terms, sum, variable, notation, true);
      continue;
    }
    std::string text =
        fmt::format("Σ c({0})·{1} over the {2} roots {0} of {3}\n    c({0}) = {4}", root,
                    log_of_unknown(sum, variable, notation, root, false), sum.sum.index.degree(),
                    formatted(sum.sum.index, Notation::unicode, root),
                    formatted(sum.sum.residue, Notation::unicode, root));
    for (std::size_t k = 0; k < sum.roots.size(); ++k)
      text +=
          fmt::format("\n    {}{} = {}{}", root, subscripts[k], formatted(sum.roots[k], notation),
                      k < sum.real_roots ? "   (real, with log|·|)" : "");
    terms.add(false, text);
  }
  return terms.text();
}

std::string to_latex(const RadicalForm& F, std::string_view variable, std::string_view root,
                     std::string_view constant) {
  const RadicalNotation& notation = radical_notation::latex;
  Terms terms(notation.minus, " ");
  add_algebraic_part(terms, F, Notation::latex, variable);
  std::string roots;
  int count = 0;
  for (const RadicalSum& sum : F.logs) {
    if (is_written_out(sum)) {
      add_logs(terms, sum, variable, notation, true);
      continue;
    }
    // z_{jk} is the k-th root of the j-th sum.
    const std::string name = fmt::format("{}_{{{}k}}", root, ++count);
    const auto add_part = [&](std::size_t first, std::size_t last, bool bars) {
      if (first == last) return;
      const bool single = last == first + 1;
      const std::string z = single ? fmt::format("{}_{{{}{}}}", root, count, last) : name;
      terms.add(false,
                fmt::format("{}\\left({}\\right) {}",
                            single ? "" : fmt::format("\\sum_{{k={}}}^{{{}}} ", first + 1, last),
                            formatted(sum.sum.residue, Notation::latex, z),
                            log_of_unknown(sum, variable, notation, z, bars)));
    };
    add_part(0, sum.real_roots, true);
    add_part(sum.real_roots, sum.roots.size(), false);
    for (std::size_t k = 0; k < sum.roots.size(); ++k)
      roots += fmt::format(",\\quad {}_{{{}{}}} = {}", root, count, k + 1,
                           formatted(sum.roots[k], notation));
  }
  return with_constant(terms.text(), constant) + roots;
}

std::string to_cas(const std::vector<RadicalSum>& logs, const RadicalNotation& notation,
                   std::string_view variable) {
  Terms terms(notation.minus, " ");
  for (const RadicalSum& sum : logs) add_logs(terms, sum, variable, notation, false);
  return terms.text();
}

}  // namespace phrame
