#include "phrame/io/write/radical_text.hpp"

#include <fmt/format.h>

#include <boost/multiprecision/integer.hpp>

// A sum is written over its common denominator, (n₀ + n₁x₁ + …)/d with integers nₖ. Every text
// carries how tightly it binds, and gets parentheses where that is not enough.

namespace phrame::inline v0 {

namespace radical_notation {

const RadicalNotation unicode{"−",   "",  "·",   "({})", "{}/{}", "{}/{}",
                              false, "i", "√{}", "∛{}",  "{}^{}", "log({})"};
const RadicalNotation latex{"-",
                            "",
                            " ",
                            "\\left({}\\right)",
                            "\\frac{{{}}}{{{}}}",
                            "\\frac{{{}}}{{{}}}",
                            true,
                            "i",
                            "\\sqrt{{{}}}",
                            "\\sqrt[3]{{{}}}",
                            "{}^{{{}}}",
                            "\\log\\left({}\\right)"};
const RadicalNotation sympy{"-",   "*", "*",        "({})",     "Rational({}, {})", "{}/{}",
                            false, "I", "sqrt({})", "cbrt({})", "{}**{}",           "log({})"};
const RadicalNotation mathematica{"-",   "*", "*",        "({})",     "({}/{})", "{}/{}",
                                  false, "I", "Sqrt[{}]", "{}^(1/3)", "{}^{}",   "Log[{}]"};
const RadicalNotation maple{"-",   "*", "*",        "({})",     "({}/{})", "{}/{}",
                            false, "I", "sqrt({})", "{}^(1/3)", "{}^{}",   "ln({})"};
const RadicalNotation maxima{"-",   "*",  "*",        "({})",     "({}/{})", "{}/{}",
                             false, "%i", "sqrt({})", "{}^(1/3)", "{}^{}",   "log({})"};
const RadicalNotation pari{"-",   "*", "*",        "({})",     "({}/{})", "{}/{}",
                           false, "I", "sqrt({})", "{}^(1/3)", "{}^{}",   "log({})"};

}  // namespace radical_notation

namespace {

template <class... Arguments>
std::string fill(std::string_view pattern, const Arguments&... arguments) {
  return fmt::vformat(pattern, fmt::make_format_args(arguments...));
}

enum class Binding { sum, product, atom };

struct Written {
  std::string text;
  Binding binding;
};

class Writer {
 public:
  Writer(const Radical& x, const RadicalNotation& notation) : notation_(notation), x_(x) {
    for (const Radical::Step& step : x.steps()) texts_.push_back(written(step));
  }
  Written whole() const { return written(x_.value()); }

 private:
  std::string enclosed(const Written& x, Binding at_least) const {
    return x.binding >= at_least ? x.text : fill(notation_.parentheses, x.text);
  }

  Written quotient(const Written& a, const Written& b) const {
    if (notation_.quotient_encloses)
      return {fill(notation_.quotient, a.text, b.text), Binding::atom};
    return {fill(notation_.quotient, enclosed(a, Binding::product), enclosed(b, Binding::atom)),
            Binding::product};
  }

  /// n·x, n > 1.
  Written product(const Integer& n, const Written& x) const {
    const bool digits_meet =
        notation_.times.empty() && x.text.front() >= '0' && x.text.front() <= '9';
    return {n.str() + std::string(notation_.times) +
                enclosed(x, digits_meet ? Binding::atom : Binding::product),
            Binding::product};
  }

  /// n times a step, n ≥ 1.
  Written multiple(const Integer& n, std::size_t step) const {
    const Written& x = texts_[step];
    if (n == 1) return x;
    const Radical::Step& s = x_.steps()[step];
    if (s.kind == Radical::Kind::quotient && s.left == Radical::Sum{1, {}})
      return quotient({n.str(), Binding::atom}, written(s.right));
    return product(n, x);
  }

  Written written(const Radical::Sum& sum) const {
    Integer denominator = phrame::denominator(sum.constant);
    for (const auto& term : sum.terms)
      denominator = lcm(denominator, phrame::denominator(term.factor));
    if (sum.terms.empty()) return rational(sum.constant);
    Written all{"", Binding::product};
    const auto append = [&](const Rational& factor, const auto& text_of) {
      if (factor == 0) return;
      const Written term = text_of(numerator(Rational(abs(factor) * denominator)));
      const bool negative = factor < 0;
      if (all.text.empty()) {
        all = negative ? Written{std::string(notation_.minus) + term.text, Binding::sum} : term;
        return;
      }
      all = {fmt::format("{} {} {}", all.text, negative ? notation_.minus : "+", term.text),
             Binding::sum};
    };
    append(sum.constant, [](const Integer& n) { return Written{n.str(), Binding::atom}; });
    for (const auto& [factor, step] : sum.terms)
      append(factor, [&, at = step](const Integer& n) { return multiple(n, at); });
    if (denominator == 1) return all;
    // −x/2 is −(x/2).
    const bool negative = sum.constant == 0 && sum.terms.size() == 1 && sum.terms[0].factor < 0;
    if (sum.constant == 0 && sum.terms.size() == 1)
      all = multiple_over(numerator(abs(sum.terms[0].factor)), denominator, sum.terms[0].step);
    else
      all = quotient(all, {denominator.str(), Binding::atom});
    return negative ? Written{std::string(notation_.minus) + all.text, Binding::sum} : all;
  }

  /// n/d times a step, d > 1; (a/b)/d is a/(d·b).
  Written multiple_over(const Integer& n, const Integer& d, std::size_t step) const {
    const Radical::Step& s = x_.steps()[step];
    if (s.kind != Radical::Kind::quotient)
      return quotient(multiple(n, step), {d.str(), Binding::atom});
    const Written left = s.left == Radical::Sum{1, {}} ? Written{n.str(), Binding::atom}
                         : n == 1                      ? written(s.left)
                                                       : product(n, written(s.left));
    return quotient(left, product(d, written(s.right)));
  }

  Written rational(const Rational& r) const {
    const bool whole = denominator(r) == 1;
    const Integer n = abs(numerator(r));
    const std::string text =
        whole ? n.str() : fill(notation_.rational, n.str(), denominator(r).str());
    if (r < 0) return {std::string(notation_.minus) + text, Binding::sum};
    return {text, whole || notation_.quotient_encloses ? Binding::atom : Binding::product};
  }

  Written written(const Radical::Step& step) const {
    const Written left = written(step.left);
    switch (step.kind) {
      case Radical::Kind::imaginary_unit:
        return {std::string(notation_.imaginary_unit), Binding::atom};
      case Radical::Kind::quotient:
        return quotient(left, written(step.right));
      case Radical::Kind::product: {
        const bool after_i = left.text == notation_.imaginary_unit;
        const std::string dot(after_i ? notation_.times : notation_.dot);
        return {
            enclosed(left, Binding::product) + dot + enclosed(written(step.right), Binding::atom),
            Binding::product};
      }
      default: {
        const std::string_view pattern =
            step.kind == Radical::Kind::square_root ? notation_.square_root : notation_.cube_root;
        const bool is_open = pattern.starts_with("{}") || pattern.ends_with("{}");
        const bool bare = left.text.find_first_not_of("0123456789") == std::string::npos;
        return {
            fill(pattern, is_open && !bare ? fill(notation_.parentheses, left.text) : left.text),
            Binding::atom};
      }
    }
  }

  const RadicalNotation& notation_;
  const Radical& x_;
  std::vector<Written> texts_;
};

}  // namespace

std::string formatted(const Radical& x, const RadicalNotation& notation) {
  return Writer(x, notation).whole().text;
}

std::string formatted_factor(const Radical& x, const RadicalNotation& notation) {
  const Written text = Writer(x, notation).whole();
  return text.binding == Binding::sum ? fill(notation.parentheses, text.text) : text.text;
}

bool is_written_negative(const Radical& x) {
  const Radical::Sum& sum = x.value();
  if (sum.constant != 0 || sum.terms.empty()) return sum.constant < 0;
  return sum.terms.front().factor < 0;
}

}  // namespace phrame
