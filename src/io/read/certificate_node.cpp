#include "phrame/io/read/certificate_node.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace phrame::inline v0 {
namespace {

// The limits of docs/certificate.md.
constexpr long greatest_exponent = 10'000;
constexpr long most_work = 2'000'000'000;
constexpr std::size_t full_size = 100'000;

bool take_one(std::string_view& text, char c) {
  if (text.empty() || text.front() != c) return false;
  text.remove_prefix(1);
  return true;
}

bool take_digits(std::string_view& text) {
  const std::size_t length = std::min(text.find_first_not_of("0123456789"), text.size());
  text.remove_prefix(length);
  return length > 0;
}

/// -?d+(/d+)?
bool is_exact(std::string_view text) {
  take_one(text, '-');
  return take_digits(text) && (!take_one(text, '/') || take_digits(text)) && text.empty();
}

/// -?d+(.d+)?(e-?d+)?; the exponent is left in `text`.
bool is_decimal(std::string_view& text) {
  take_one(text, '-');
  if (!take_digits(text) || (take_one(text, '.') && !take_digits(text))) return false;
  if (!take_one(text, 'e')) return text.empty();
  std::string_view rest = text;
  take_one(rest, '-');
  return take_digits(rest) && rest.empty();
}

}  // namespace

long read_count(const JsonNode& node, long least, long largest) {
  node.require(JsonNode::Kind::number, "an integer without quotes");
  if (node.text().find_first_not_of("-0123456789") != std::string::npos)
    node.fail(abbreviated(node.text()) + " is not an integer");
  const Integer n(numerator(node.number()));
  if (n < least || n > largest)
    node.fail(fmt::format("{} is not in {} … {}", abbreviated(n.str()), least, largest));
  return static_cast<long>(n);
}

Rational read_exact(const JsonNode& node) {
  if (!is_exact(node.string()))
    node.fail(
        fmt::format("an integer or a fraction is wanted, not \"{}\"", abbreviated(node.text())));
  return node.number();
}

std::string read_decimal(const JsonNode& node) {
  const std::string& text = node.string();
  std::string_view exponent = text;
  if (!is_decimal(exponent))
    node.fail(fmt::format("a decimal number is wanted, not \"{}\"", abbreviated(text)));
  constexpr std::size_t longest = 10;
  if (exponent.size() > longest ||
      (!exponent.empty() && std::abs(std::stol(std::string(exponent))) > greatest_exponent))
    node.fail(fmt::format("exponents are limited to {}", greatest_exponent));
  node.number();  // which refuses what is too long
  return text;
}

std::string read_radius(const JsonNode& node) {
  std::string radius = read_decimal(node);
  if (radius.front() == '-') node.fail("a radius has no sign");
  return radius;
}

long written_bits(const Polynomial& p) {
  const Integer d = denominator(p);
  long bits = bit_length(d);
  for (const Rational& c : p.coefficients())
    bits = std::max(bits, bit_length(Integer(numerator(c) * (d / denominator(c)))));
  return bits;
}

WorkLimit::WorkLimit(std::size_t bytes, bool is_limited) : is_limited_(is_limited) {
  const Integer size = static_cast<long>(std::max(bytes, full_size));
  const Integer full = static_cast<long>(full_size);
  most_ = Integer(most_work) * size * size / (full * full);
}

void WorkLimit::add(const JsonNode& part, const Integer& work) {
  work_ += work;
  if (is_limited_ && work_ > most_)
    part.fail(fmt::format("to check it is work of {}, beyond the limit {} (--unlimited)",
                          work_.str(), most_.str()));
}

}  // namespace phrame
