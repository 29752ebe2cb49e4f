#include "phrame/io/write/cas_formula.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/io/write/algebraic_text.hpp"
#include "phrame/io/write/root_term.hpp"

namespace phrame::inline v0 {
namespace {

/// What differs from language to language. The functions are patterns of one argument.
struct Syntax {
  std::string_view power;
  std::string_view fraction;
  std::string_view log;
  std::string_view arctan;
  std::string_view abs;
  std::string_view sqrt;
  std::string_view pi;
  std::string_view root;     ///< the letter of a sum, in its terms; {} is z or w
  std::string_view unknown;  ///< the same letter in the polynomial
  std::string_view sum;      ///< {0} the term, {1} the polynomial, {2} the letter
};

const Syntax& syntax(Language language) {
  static constexpr Syntax plain{
      "^",        "{}/{}", "log({})", "atan({})", "abs({})",
      "sqrt({})", "pi",    "{}",      "{}",       "sum({0}, {2}: {1} = 0)"};
  static constexpr Syntax sympy{"**",      "Rational({}, {})",
                                "log({})", "atan({})",
                                "Abs({})", "sqrt({})",
                                "pi",      "{}",
                                "{}",      "RootSum(Poly({1}, {2}), Lambda({2}, {0}), auto=False)"};
  static constexpr Syntax mathematica{
      "^",        "({}/{})", "Log[{}]", "ArcTan[{}]", "Abs[{}]",
      "Sqrt[{}]", "Pi",      "#",       "#",          "RootSum[{1} &, {0} &]"};
  static constexpr Syntax maple{
      "^",        "({}/{})", "ln({})", "arctan({})", "abs({})",
      "sqrt({})", "Pi",      "_R",     "_Z",         "sum({0}, _R = RootOf({1}))"};
  static constexpr Syntax maxima{
      "^",        "({}/{})", "log({})", "atan({})", "abs({})",
      "sqrt({})", "%pi",     "{}",      "{}",       "lsum({0}, {2}, rootsof({1}, {2}))"};
  static constexpr Syntax pari{
      "^",        "({}/{})", "log({})", "atan({})", "abs({})",
      "sqrt({})", "Pi",      "{}",      "'{}",      "vecsum([{0} | {2} <- polroots({1})])"};
  switch (language) {
    case Language::sympy:
      return sympy;
    case Language::mathematica:
      return mathematica;
    case Language::maple:
      return maple;
    case Language::maxima:
      return maxima;
    case Language::pari:
      return pari;
    case Language::plain:
      break;
  }
  return plain;
}

template <class... T>
std::string filled(std::string_view pattern, const T&... arguments) {
  return fmt::format(fmt::runtime(pattern), arguments...);
}

/// A sum that is being written.
class Sum {
 public:
  /// Adds ±text; the text is a product, or a sum that comes first.
  void add(bool negative, const std::string& text) {
    if (text.starts_with('-'))
      add(!negative, text.substr(1));
    else if (text_.empty())
      text_ = (negative ? "-" : "") + text;
    else
      text_ += (negative ? " - " : " + ") + text;
  }
  std::string text() const { return text_.empty() ? "0" : text_; }

 private:
  std::string text_;
};

class Writer {
 public:
  Writer(Language language, std::string variable)
      : language_(language), syntax_(syntax(language)), variable_(std::move(variable)) {}

  std::string size_of(const Rational& c) const {
    const Integer n = abs(numerator(c));
    return denominator(c) == 1 ? n.str() : filled(syntax_.fraction, n.str(), denominator(c).str());
  }

  /// |c|·text, which is a product.
  std::string product(const Rational& c, const std::string& text) const {
    return abs(c) == 1 ? text : size_of(c) + "*" + text;
  }

  std::string power(const std::string& letter, long k) const {
    return k == 1 ? letter : fmt::format("{}{}{}", letter, syntax_.power, k);
  }

  std::string polynomial(const Polynomial& p, const std::string& letter) const {
    Sum sum;
    for (long k = p.degree(); k >= 0; --k)
      if (const Rational c = p.coefficient(k); c != 0)
        sum.add(c < 0, k == 0 ? size_of(c) : product(c, power(letter, k)));
    return sum.text();
  }

  /// A sum as it stands in a product.
  static std::string factor(const std::string& sum) {
    return sum.find(' ') == std::string::npos ? sum : "(" + sum + ")";
  }

  std::string polynomial(const Polynomial& p) const { return polynomial(p, variable_); }

  std::string root(const Integer& d) const { return filled(syntax_.sqrt, d.str()); }

  /// |c|·√d·text; the text is a product, or empty for 1.
  std::string multiple(const Rational& c, const Integer& d, const std::string& text) const {
    if (d == 1) return text.empty() ? size_of(c) : product(c, text);
    return product(c, root(d)) + (text.empty() ? "" : "*" + text);
  }

  std::string surd(const Surd& x) const {
    Sum sum;
    for (const auto& [d, c] : x.terms()) sum.add(c < 0, multiple(c, d, ""));
    return sum.text();
  }

  std::string polynomial(const SurdPolynomial& p) const {
    Sum sum;
    for (long k = degree(p); k >= 0; --k) {
      const Surd factor = coefficient(p, k);
      for (const auto& [d, c] : factor.terms())
        sum.add(c < 0, multiple(c, d, k == 0 ? "" : power(variable_, k)));
    }
    return sum.text();
  }

  /// v with x written `index`.
  std::string polynomial(const Bivariate& v, const std::string& index) const {
    Sum sum;
    for (long k = v.degree(); k >= 0; --k) {
      const Polynomial c = v.coefficient(k);
      if (c.is_zero()) continue;
      const Rational number = c.leading_coefficient();
      const std::string times = k == 0 ? "" : "*" + power(variable_, k);
      if (c.is_constant())
        sum.add(number < 0, k == 0 ? size_of(number) : product(number, power(variable_, k)));
      else if (c == Polynomial::monomial(number, c.degree()))
        sum.add(number < 0, product(number, power(index, c.degree())) + times);
      else
        sum.add(false, fmt::format("({})", polynomial(c, index)) + times);
    }
    return sum.text();
  }

  std::string quotient(const RationalFunction& f) const {
    if (f.is_polynomial()) return polynomial(f.numerator());
    return fmt::format("{}/({})", factor(polynomial(f.numerator())), polynomial(f.denominator()));
  }

  std::string log(const std::string& of) const { return filled(syntax_.log, of); }
  std::string abs_of(const std::string& of) const { return filled(syntax_.abs, of); }
  std::string arctan(const std::string& of) const { return filled(syntax_.arctan, of); }
  std::string_view pi() const { return syntax_.pi; }

  /// Adds polynomial + rational.
  void add_algebraic(Sum& sum, const Polynomial& p, const RationalFunction& f) const {
    if (!p.is_zero()) sum.add(false, polynomial(p));
    if (!f.is_zero()) sum.add(false, quotient(f));
  }

  /// v over its leading coefficient, which short arguments have: the logarithm of t − z stays on
  /// one side of its cut, that of a constant times it need not.
  std::string monic_argument(const LogSum& logs, const std::string& root) const {
    const std::string v = polynomial(logs.argument, root);
    const Polynomial& lead = logs.argument.coefficients().back();
    return lead.is_constant() ? v : fmt::format("({})/({})", v, polynomial(lead, root));
  }

  void add_sum(Sum& sum, const LogSum& logs) const {
    if (logs.index.degree() == 1) {
      const QuotientRing ring(logs.index);
      const Rational c = ring.reduce(logs.residue).coefficient(0);
      sum.add(c < 0, product(c, log(polynomial(ring.reduce(logs.argument), ""))));
      return;
    }
    const std::string letter = variable_ == "z" ? "w" : "z";
    const std::string root = filled(syntax_.root, letter);
    const std::string unknown = filled(syntax_.unknown, letter);
    sum.add(false, filled(syntax_.sum,
                          fmt::format("{}*{}", factor(polynomial(logs.residue, root)),
                                      log(monic_argument(logs, root))),
                          polynomial(logs.index, unknown), letter));
  }

  /// Its real part: of a sum over conjugate poles, up to a constant, the sum itself.
  void add_real_sum(Sum& sum, const LogSum& logs) const {
    if (language_ != Language::pari) {
      add_sum(sum, logs);
      return;
    }
    Sum one;
    add_sum(one, logs);
    sum.add(false, fmt::format("real({})", one.text()));
  }

  /// Adds c·function.
  void add(Sum& sum, const Surd& x, const std::string& function) const {
    if (x.terms().size() > 1) {
      sum.add(false, fmt::format("({})*{}", surd(x), function));
      return;
    }
    for (const auto& [d, c] : x.terms()) sum.add(c < 0, multiple(c, d, function));
  }

  void add(Sum& sum, const Radical& c, const std::string& function) const {
    const RadicalNotation& notation = radical_notation_of(language_);
    const bool negative = is_written_negative(c);
    const Radical size = negative ? -c : c;
    sum.add(negative, size == Radical(1)
                          ? function
                          : fmt::format("{}*{}", formatted_factor(size, notation), function));
  }

  /// Its sums over roots are not in it. `bars`: log|…| where the argument may be negative.
  void add_real(Sum& sum, const RealForm& F, bool bars) const {
    const RadicalNotation& notation = radical_notation_of(language_);
    add_algebraic(sum, F.polynomial, F.rational);
    const auto log_of = [&](const std::string& v, bool positive) {
      return log(positive || !bars ? v : abs_of(v));
    };
    for (const auto& [factor, of, positive] : F.logarithms)
      add(sum, factor, log_of(polynomial(of), positive));
    for (const RealForm::LogQuotient& term : F.quotients) {
      const auto [factor, argument] = written(term, variable_, notation);
      add(sum, factor, log_of(argument, false));
    }
    for (const RealForm::Arctangent& term : F.arctangents) {
      if (term.radicand == Surd(1)) {
        add(sum, term.factor, arctan(polynomial(term.of)));
        continue;
      }
      const auto [factor, argument] = written(term, variable_, notation);
      add(sum, factor, arctan(argument));
    }
  }

 private:
  Language language_;
  const Syntax& syntax_;
  std::string variable_;
};

}  // namespace

const RadicalNotation& radical_notation_of(Language language) {
  switch (language) {
    case Language::sympy:
      return radical_notation::sympy;
    case Language::mathematica:
      return radical_notation::mathematica;
    case Language::maxima:
      return radical_notation::maxima;
    case Language::pari:
      return radical_notation::pari;
    default:
      return radical_notation::maple;
  }
}

std::string cas_variable(const std::string& variable) {
  const bool plain = variable.size() == 1 && variable[0] >= 'a' && variable[0] <= 'z';
  return plain ? variable : "x";
}

std::string cas_formula(const RationalFunction& f, Language language, const std::string& variable) {
  return Writer(language, variable).quotient(f);
}

std::string cas_formula(const Antiderivative& F, Language language, const std::string& variable) {
  const Writer writer(language, variable);
  Sum sum;
  writer.add_algebraic(sum, F.polynomial, F.rational);
  for (const LogSum& logs : F.logs) writer.add_sum(sum, logs);
  return sum.text();
}

std::string cas_formula(const RealForm& F, Language language, const std::string& variable) {
  const Writer writer(language, variable);
  Sum sum;
  writer.add_real(sum, F, true);
  for (const LogSum& logs : F.others) writer.add_real_sum(sum, logs);
  return sum.text();
}

std::string cas_formula(const RealForm& F, const std::vector<LogSum>& sums_over_poles,
                        Language language, const std::string& variable) {
  const Writer writer(language, variable);
  Sum sum;
  writer.add_real(sum, F, false);
  for (const LogSum& logs : sums_over_poles) writer.add_sum(sum, logs);
  return sum.text();
}

std::string cas_formula(const ExactValue& x, Language language) {
  const Writer writer(language, "");
  Sum sum;
  if (x.rational != 0) sum.add(x.rational < 0, writer.size_of(x.rational));
  if (x.pi != 0) sum.add(x.pi < 0, writer.product(x.pi, std::string(writer.pi())));
  if (x.irrational_pi) sum.add(false, cas_multiple(*x.irrational_pi, writer.pi(), language));
  const auto number = [&](const Rational& of) { return writer.polynomial(Polynomial{of}); };
  for (const auto& [factor, of] : x.logarithms)
    writer.add(sum, Surd(factor), writer.log(number(of)));
  for (const auto& [factor, of] : x.arctangents)
    writer.add(sum, Surd(factor), writer.arctan(number(of)));
  return sum.text();
}

namespace {

/// x`p says in Mathematica that x is off by no more than |x|·10⁻ᵖ. Half a unit in the last of n
/// digits is that for p = n where they begin with 5 or more, for p = n − 1 where with less.
std::string mathematica_precision(char first_digit, long digits) {
  if (first_digit >= '5') return std::to_string(digits);
  return digits == 1 ? "0.3" : std::to_string(digits - 1);  // 10^-0.3 > 1/2
}

/// The digits without the point and the sign.
std::string digits_of(std::string_view decimal) {
  std::string digits;
  for (const char c : decimal)
    if (c >= '0' && c <= '9') digits += c;
  return digits;
}

}  // namespace

std::string cas_formula(const Decimal& x, Language language) {
  const auto e = x.value.find('e');
  const std::string significand = x.value.substr(0, e);
  const std::string exponent = e == std::string::npos ? "" : x.value.substr(e + 1);
  const std::string all = digits_of(significand);
  const std::size_t leading_zeros = all.find_first_not_of('0');
  if (leading_zeros == std::string::npos) return "0";
  const std::string digits = all.substr(leading_zeros);
  const auto count = static_cast<long>(digits.size());
  switch (language) {
    case Language::sympy: {
      // The strings that Python takes for numbers are short.
      constexpr long longest = 4300;
      if (count <= longest) return fmt::format("Float('{}', {})", x.value, count);
      const auto point = significand.find('.');
      const long decimals =
          point == std::string::npos ? 0 : static_cast<long>(significand.size() - point - 1);
      const long shift = (exponent.empty() ? 0 : std::stol(exponent)) - decimals;
      return fmt::format("Float(Rational({}{}*10**{}, 10**{}), {})",
                         significand.front() == '-' ? "-" : "", digits, std::max(0L, shift),
                         std::max(0L, -shift), count);
    }
    case Language::mathematica:
      return fmt::format("{}`{}{}", significand, mathematica_precision(digits.front(), count),
                         exponent.empty() ? "" : "*^" + exponent);
    case Language::maxima:
      return fmt::format("{}b{}", significand, exponent.empty() ? "0" : exponent);
    default:
      return x.value;
  }
}

}  // namespace phrame
