#include "phrame/io/read/feedrate.hpp"

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/expression.hpp"
#include "phrame/io/read/expression_token.hpp"
#include "phrame/io/read/formula.hpp"
#include "phrame/io/read/number.hpp"

// A speed is condition ? speed : speed, or min and max of speeds, or a formula; what is inside a
// formula is read by parse_formula(), behind as many blanks as there are characters before it, so
// that columns are those of the whole text.

namespace phrame::inline v0 {
namespace {

using Functions = std::vector<std::vector<Feedrate::Function>>;  ///< the least of greatest ones

constexpr std::size_t most_functions = 256;

/// A part of a text.
struct FeedText {
  std::string_view whole;
  std::size_t begin;
  std::size_t end;

  std::string_view text() const { return whole.substr(begin, end - begin); }
  FeedText part(std::size_t from, std::size_t to) const {
    FeedText found{whole, begin + from, begin + to};
    while (found.begin < found.end && blanks.find(whole[found.begin]) != blanks.npos) ++found.begin;
    while (found.begin < found.end && blanks.find(whole[found.end - 1]) != blanks.npos) --found.end;
    return found;
  }
  [[noreturn]] void fail(const std::string& reason) const {
    throw InputError(column_of(whole, begin), reason);
  }
  /// The text behind blanks.
  std::string in_place() const {
    const auto characters =
        std::count_if(whole.begin(), whole.begin() + static_cast<long>(begin),
                      [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
    return std::string(static_cast<std::size_t>(characters), ' ') + std::string(text());
  }
};

/// The first of these characters outside of parentheses, from a place on.
std::size_t find_outside(std::string_view text, char wanted, std::size_t from = 0) {
  long depth = 0;
  for (std::size_t k = from; k < text.size(); ++k) {
    if (depth == 0 && text[k] == wanted) return k;
    if (text[k] == '(') ++depth;
    if (text[k] == ')') --depth;
  }
  return text.npos;
}

Feedrate::Of quantity(const std::string& variable) {
  if (variable.empty() || variable == "s") return Feedrate::Of::arc_length;
  if (variable == "t") return Feedrate::Of::parameter;
  if (variable == "kappa" || variable == "κ") return Feedrate::Of::curvature;
  throw InputError(in_quotes(variable) +
                   " is not one of s (arc length), t (parameter), kappa (curvature)");
}

Functions formula_of_feed(const FeedText& given) {
  for (const std::string_view name : {"min(", "max("})
    if (given.text().find(name) != std::string_view::npos)
      given.fail("min and max are outside of all else: min(2*s, 10), not 2*min(s, 5)");
  if (given.text().find_first_of("?:<>") != std::string_view::npos)
    given.fail("pieces are written \"s < 3 ? 10 : s < 5 ? 20 : 10\", and are outside of all else");
  const GivenFormula found = parse_formula(given.in_place());
  return {{{found.value, quantity(found.variable)}}};
}

/// The least, or the greatest, of the two.
Functions combined(bool is_least, const Functions& a, const Functions& b) {
  Functions found;
  if (is_least) {
    found = a;
    found.insert(found.end(), b.begin(), b.end());
    return found;
  }
  for (const auto& first : a)
    for (const auto& second : b) {
      found.push_back(first);
      found.back().insert(found.back().end(), second.begin(), second.end());
    }
  return found;
}

Functions functions_of(const FeedText& given) {
  const std::string_view text = given.text();
  const bool is_least = text.starts_with("min(");
  if (!is_least && !text.starts_with("max(")) return formula_of_feed(given);
  const std::size_t close = find_outside(text, ')', 4);
  if (close == text.npos) given.fail("its parenthesis is not closed");
  if (close != text.size() - 1) return formula_of_feed(given);
  Functions found;
  for (std::size_t from = 4; from < text.size();) {
    const std::size_t comma = find_outside(text, ',', from);
    const std::size_t to = std::min(comma, text.size() - 1);
    const Functions next = functions_of(given.part(from, to));
    found = from == 4 ? next : combined(is_least, found, next);
    std::size_t count = 0;
    for (const auto& group : found) count += group.size();
    if (count > most_functions) given.fail("min and max of too many functions");
    from = to + 1;
  }
  return found;
}

/// The pieces, one after the other.
Feedrate in_pieces(FeedText rest) {
  Feedrate feedrate;
  std::optional<bool> are_parameters;
  for (;;) {
    const std::size_t question = find_outside(rest.text(), '?');
    if (question == std::string_view::npos) break;
    const FeedText condition = rest.part(0, question);
    const std::size_t less = condition.text().find('<');
    const auto name = less == std::string_view::npos ? std::string_view()
                                                     : trimmed(condition.text().substr(0, less));
    if (name != "s" && name != "t")
      condition.fail("a piece begins with \"s < 3 ?\" or \"t < 3 ?\"");
    if (are_parameters && *are_parameters != (name == "t"))
      condition.fail("pieces are told apart by s or by t, not by both");
    are_parameters = name == "t";
    const FeedText end = condition.part(less + 1, condition.text().size());
    Rational value;
    try {
      value = parse_short_number(end.text());
    } catch (const InputError& error) {
      end.fail(error.reason());
    }
    const std::size_t colon = find_outside(rest.text(), ':', question + 1);
    if (colon == std::string_view::npos) rest.fail("there is no \":\" behind the piece");
    if (!feedrate.pieces.empty() && *feedrate.pieces.back().end >= value)
      end.fail("it is not greater than where the piece before ends");
    feedrate.pieces.push_back({functions_of(rest.part(question + 1, colon)), value});
    rest = rest.part(colon + 1, rest.text().size());
  }
  feedrate.pieces.push_back({functions_of(rest), std::nullopt});
  feedrate.ends_are_parameters = are_parameters.value_or(false);
  return feedrate;
}

bool is_beyond_rational(std::string_view text) {
  return text.find_first_of("?:<>") != text.npos || text.find("min(") != text.npos ||
         text.find("max(") != text.npos;
}

}  // namespace

Feedrate parse_feedrate(std::string_view text) {
  const FeedText all = FeedText{text, 0, text.size()}.part(0, text.size());
  if (is_beyond_rational(all.text())) return in_pieces(all);
  ExpressionLimits limits;
  limits.size.max_bits = most_number_bits;
  try {
    const auto [speed, variable] = parse_expression(text, std::nullopt, limits);
    return {speed, quantity(variable)};
  } catch (const InputError& error) {
    if (error.reason().find("only rational functions") == std::string::npos &&
        text.find("pi") == text.npos && text.find("π") == text.npos)
      throw;
  }
  return in_pieces(all);
}

}  // namespace phrame
