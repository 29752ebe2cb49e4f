#include "phrame/io/read/endpoint.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/integrate/endpoint.hpp"
#include "phrame/io/read/expression_token.hpp"
#include "phrame/io/write/text.hpp"

namespace phrame::inline v0 {
namespace {

/// Reads tokens from the left.
class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  /// Where the next token is.
  std::size_t at() { return at_ = std::min(text_.find_first_not_of(blanks, at_), text_.size()); }
  Token take() {
    const Token token = first_token(text_.substr(at()));
    at_ += token.text.size();
    return token;
  }
  bool done() { return at() == text_.size(); }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

std::optional<Infinity> infinity(std::string_view text) {
  Reader in(text);
  Token token = in.take();
  const bool negative = token.sign == '-';
  if (negative || token.sign == '+') token = in.take();
  if (token.text != "inf" && token.text != "infinity" && token.text != "oo" && token.text != "∞")
    return std::nullopt;
  if (!in.done()) return std::nullopt;
  return negative ? Infinity::negative : Infinity::positive;
}

/// The piece [begin, end) of the text with blanks before it, so that its columns are those of the
/// whole.
std::string in_place(std::string_view text, std::size_t begin, std::size_t end) {
  std::string piece(text_width(text.substr(0, begin)), ' ');
  return piece.append(text.substr(begin, end - begin));
}

[[noreturn]] void fail(std::string_view text, std::size_t at, const std::string& reason) {
  throw InputError(column_of(text, at), reason);
}

/// The end of an interval: no value where it is infinite, which is allowed on one side only.
std::optional<Rational> interval_end(const std::string& text, Infinity allowed,
                                     const ExpressionLimits& limits) {
  const auto infinite = infinity(text);
  if (!infinite) return parse_expression(text, "", limits).value(0);
  if (*infinite != allowed) fail(text, text.find_first_not_of(blanks), "the interval is empty");
  return std::nullopt;
}

/// `text` begins with "root(", the parenthesis being at `open`.
PathEnd parse_root(std::string_view text, std::size_t root, std::size_t open,
                   const ExpressionLimits& limits) {
  const std::size_t close = text.rfind(')');
  if (close == std::string_view::npos) fail(text, open, "this \"(\" is never closed");
  if (const auto rest = text.find_first_not_of(blanks, close + 1); rest != std::string_view::npos)
    fail(text, rest, "nothing may follow a root");
  const std::size_t first = text.find(',', open);
  const std::size_t second = text.find(',', std::min(first, close) + 1);
  if (second >= close || text.find(',', second + 1) < close)
    fail(text, root, "a root is given by a polynomial and two ends, as in root(x^2-2, 1, 2)");

  const std::string definition = in_place(text, open + 1, first);
  const Expression p = parse_expression(definition, std::nullopt, limits);
  const std::size_t start = std::min(text.find_first_not_of(blanks, open + 1), first);
  if (!p.value.is_polynomial()) fail(text, start, "this is not a polynomial");
  if (p.value.is_zero()) fail(text, start, "the zero polynomial vanishes everywhere");
  const Interval interval{
      interval_end(in_place(text, first + 1, second), Infinity::negative, limits),
      interval_end(in_place(text, second + 1, close), Infinity::positive, limits)};
  if (interval.lower && interval.upper && *interval.lower > *interval.upper)
    fail(text, root, "the first end of the interval is greater than the second");
  const Polynomial& f = p.value.numerator();
  if (const long count = count_real_roots(f, interval); count != 1)
    fail(text, root,
         fmt::format("{} has {} real roots in {}, not one",
                     abridged(readable(formatted(f, Notation::unicode, p.variable), f)),
                     count == 0 ? "no" : std::to_string(count), to_string(interval)));
  RealAlgebraic number = real_root(f, interval);
  if (auto exact = number.rational()) return *std::move(exact);
  return number;
}

/// The first piece of the text that is this name.
std::size_t place_of_name(std::string_view text, std::string_view name) {
  for (Reader in(text); !in.done();) {
    const std::size_t at = in.at();
    if (in.take().text == name) return at;
  }
  return std::string_view::npos;
}

/// "sqrt(…)", "√(…)" or "√2" in a text.
struct SquareRoot {
  std::size_t begin;
  std::size_t end;
  std::size_t radicand;  ///< where its radicand begins, without a parenthesis
  std::size_t radicand_end;
};

std::optional<SquareRoot> first_square_root(std::string_view text) {
  const std::size_t begin = std::min(place_of_name(text, "sqrt"), place_of_name(text, "√"));
  if (begin == std::string_view::npos) return std::nullopt;
  const bool is_sign = text.substr(begin).starts_with("√");
  Reader in(text.substr(begin));
  in.take();
  const std::size_t open = begin + in.at();
  const Token token = in.take();
  if (is_sign && token.kind == Token::Kind::number)
    return SquareRoot{begin, open + token.text.size(), open, open + token.text.size()};
  if (token.sign != '(') fail(text, open, "a square root is written sqrt(2)");
  std::size_t close = open + 1;
  for (int depth = 1; depth > 0; ++close) {
    if (close == text.size()) fail(text, open, "this \"(\" is never closed");
    depth += text[close] == '(' ? 1 : text[close] == ')' ? -1 : 0;
  }
  return SquareRoot{begin, close, open + 1, close - 1};
}

/// Messages say what the letter stands for.
RationalFunction in_letter(std::string_view text, std::string_view letter,
                           const ExpressionLimits& limits) {
  try {
    return parse_expression(text, std::string(letter), limits).value;
  } catch (const InputError& error) {
    std::string reason = error.reason();
    for (std::size_t at = 0; (at = reason.find(letter, at)) != std::string::npos;) {
      constexpr std::string_view root = "√(…)";
      const std::size_t end = reason.find_first_not_of(' ', at + letter.size());
      const bool is_padded = end != std::string::npos && end > at + letter.size() + 1;
      const std::size_t kept = is_padded && reason[end] != ')' ? 1 : 0;  // of its blanks
      reason.replace(at, is_padded ? end - at - kept : letter.size(), root);
      at += root.size();
    }
    throw InputError(error.place(), reason);
  }
}

/// A number u + v·√c with one radicand c, which may occur several times.
PathEnd parse_surd(std::string_view whole, const ExpressionLimits& limits) {
  constexpr std::string_view letter = "_";
  if (place_of_name(whole, letter) != std::string_view::npos)
    fail(whole, place_of_name(whole, letter), "\"_\" where a number is expected");
  std::string text(whole);
  std::optional<Rational> radicand;
  while (const auto root = first_square_root(text)) {
    const Rational c =
        parse_expression(in_place(text, root->radicand, root->radicand_end), "", limits).value(0);
    if (c < 0) fail(text, root->begin, "the square root of a negative number is not real");
    if (radicand && *radicand != c)
      fail(text, root->begin,
           "square roots of two numbers: such an end is written root(p, a, b), the root of a "
           "polynomial p between a and b");
    radicand = c;
    // The letter with blanks behind it, so that columns remain.
    const std::size_t width = text_width(text.substr(root->begin, root->end - root->begin));
    text.replace(root->begin, root->end - root->begin,
                 std::string(letter) + std::string(width - 1, ' '));
  }
  const RationalFunction f = in_letter(text, letter, limits);
  const auto denominator_is_zero = [&] { fail(whole, 0, "division by zero"); };
  if (const auto exact = square_root(*radicand)) {
    if (f.denominator()(*exact) == 0) denominator_is_zero();
    return f(*exact);
  }
  const QuotientRing field(Polynomial{-*radicand, 0, 1});
  const Polynomial denominator = field.reduce(f.denominator());
  if (denominator.is_zero()) denominator_is_zero();
  const Polynomial value = field.divide(field.reduce(f.numerator()), denominator);
  const Rational u = value.coefficient(0);
  const Rational v = value.coefficient(1);
  if (v == 0) return u;
  const Polynomial p{u * u - v * v * *radicand, -2 * u, 1};
  return real_root(p, v > 0 ? Interval{u, std::nullopt} : Interval{std::nullopt, u});
}

PathEnd parse_in_pi(std::string_view whole, const ExpressionLimits& limits) {
  constexpr std::string_view name = "π";
  std::string text(whole);
  // The sign for the word, with a blank behind it, so that columns remain.
  for (std::size_t at; (at = place_of_name(text, "pi")) != std::string_view::npos;)
    text.replace(at, 2, std::string(name) + " ");
  const RationalFunction f = parse_expression(text, std::string(name), limits).value;
  if (f.is_polynomial() && f.numerator().is_constant()) return f(0);
  return PiValue{f};
}

}  // namespace

PathEnd parse_endpoint(std::string_view text, const ExpressionLimits& limits) {
  if (text.size() > limits.max_length) return parse_expression(text, "", limits).value(0);
  if (const auto infinite = infinity(text)) return *infinite;
  Reader in(text);
  const std::size_t root = in.at();
  if (in.take().text == "root") {
    const std::size_t open = in.at();
    if (in.take().sign == '(') return parse_root(text, root, open, limits);
  }
  constexpr auto none = std::string_view::npos;
  const std::size_t pi = std::min(place_of_name(text, "pi"), place_of_name(text, "π"));
  const std::size_t square = std::min(place_of_name(text, "sqrt"), place_of_name(text, "√"));
  if (pi != none && square != none)
    fail(text, std::max(pi, square), "pi and a square root in one end are not supported");
  if (square != none) return parse_surd(text, limits);
  if (pi != none) return parse_in_pi(text, limits);
  return parse_expression(text, "", limits).value(0);
}

}  // namespace phrame
