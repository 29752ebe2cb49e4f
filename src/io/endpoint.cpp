#include "phrame/io/endpoint.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/io/expression_token.hpp"
#include "phrame/io/text.hpp"

namespace phrame {
namespace {

constexpr std::string_view blanks = " \t\r\n";

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
  if (token.text != "inf" && token.text != "infinity" && token.text != "∞") return std::nullopt;
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
Endpoint parse_root(std::string_view text, std::size_t root, std::size_t open,
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

}  // namespace

Endpoint parse_endpoint(std::string_view text, const ExpressionLimits& limits) {
  if (const auto infinite = infinity(text)) return *infinite;
  Reader in(text);
  const std::size_t root = in.at();
  if (text.size() <= limits.max_length && in.take().text == "root") {
    const std::size_t open = in.at();
    if (in.take().sign == '(') return parse_root(text, root, open, limits);
  }
  return parse_expression(text, "", limits).value(0);
}

std::string to_text(const Endpoint& end) {
  if (const auto* r = std::get_if<Rational>(&end)) return shown(*r);
  if (const auto* infinite = std::get_if<Infinity>(&end))
    return *infinite == Infinity::negative ? "−∞" : "∞";
  const auto& a = std::get<RealAlgebraic>(end);
  const Polynomial& p = a.polynomial();
  return fmt::format("the root of {} in {}", readable(formatted(p, Notation::unicode, "x"), p),
                     to_string(a.interval()));
}

}  // namespace phrame
