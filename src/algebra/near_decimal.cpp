#include "phrame/algebra/near_decimal.hpp"

#include <cstdint>
#include <vector>

#include "phrame/algebra/near_arithmetic.hpp"
#include "phrame/algebra/rounding.hpp"

namespace phrame::inline v0 {
namespace {

constexpr long most_exponent = 290;
constexpr int most_digits = 19;  // 10^19 < 2^64

/// 10^k, |k| ≤ most_exponent.
const NearNumber& near_power_of_ten(long k) {
  static const std::vector<NearNumber> powers = [] {
    std::vector<NearNumber> list;
    for (long n = -most_exponent; n <= most_exponent; ++n)
      list.push_back(near_number(power_of_ten(n)));
    return list;
  }();
  return powers[static_cast<std::size_t>(k + most_exponent)];
}

/// Exactly.
NearNumber pair_of(std::uint64_t n) {
  const auto high = static_cast<double>(n);
  const auto rest = static_cast<std::int64_t>(n - static_cast<std::uint64_t>(high));
  return {{high, static_cast<double>(rest)}, 0};
}

/// The digits of a decimal, of which it has the first 38 that are significant.
struct Digits {
  std::uint64_t head = 0;  ///< the first 19
  std::uint64_t tail = 0;  ///< the next ones
  int in_head = 0;
  int in_tail = 0;
  long exponent = 0;  ///< it is a whole number times 10 to this
  bool is_any = false;

  const char* take(const char* at, const char* end, bool is_fraction) {
    for (; at != end && *at >= '0' && *at <= '9'; ++at) {
      const auto digit = static_cast<std::uint64_t>(*at - '0');
      is_any = true;
      if (in_head < most_digits) {
        head = 10 * head + digit;
        in_head += head != 0 ? 1 : 0;
      } else if (in_tail < most_digits) {
        tail = 10 * tail + digit;
        ++in_tail;
      } else {
        ++exponent;  // left out
      }
      if (is_fraction) --exponent;
    }
    return at;
  }

  /// Zeros at the end are none.
  void shorten() {
    if (tail == 0) {
      exponent += in_tail;
      in_tail = 0;
      for (; exponent < 0 && head != 0 && head % 10 == 0; ++exponent, --in_head) head /= 10;
    }
  }
};

/// The signed number at the end of a decimal; no value where it is none, or a long one.
std::optional<long> written_exponent(const char* at, const char* end) {
  const bool is_negative = at != end && *at == '-';
  if (at != end && (*at == '-' || *at == '+')) ++at;
  if (at == end || end - at > 4) return std::nullopt;
  long exponent = 0;
  for (; at != end; ++at) {
    if (*at < '0' || *at > '9') return std::nullopt;
    exponent = 10 * exponent + (*at - '0');
  }
  return is_negative ? -exponent : exponent;
}

/// n/10^k where that is a double.
std::optional<double> exact_quotient(std::uint64_t n, long k) {
  constexpr std::uint64_t most = std::uint64_t{1} << 53U;
  constexpr long most_power = 22;  // the greatest power of ten that is a double
  if (n > most || k > most_power) return std::nullopt;
  const double power = near_power_of_ten(k).value.high;
  const double quotient = static_cast<double>(n) / power;
  const DoubleDouble back = two_product(split_factor(quotient), split_factor(power));
  if (back.high != static_cast<double>(n) || back.low != 0) return std::nullopt;
  return quotient;
}

NearNumber value_of(const Digits& digits) {
  const NearNumber head = pair_of(digits.head);
  if (digits.in_tail == 0 && digits.exponent == 0) return head;
  if (digits.in_tail == 0 && digits.exponent < 0)
    if (const auto exact = exact_quotient(digits.head, -digits.exponent)) return {{*exact, 0}, 0};
  NearNumber whole = head;
  if (digits.in_tail > 0) whole = head * near_power_of_ten(digits.in_tail) + pair_of(digits.tail);
  NearNumber value = whole * near_power_of_ten(digits.exponent);
  // What is left out behind 38 digits is less than 2^−122.
  value.error = raised(value.error + size_of(value) * 0x1p-97);
  return value;
}

}  // namespace

std::optional<NearNumber> near_decimal(std::string_view text) {
  constexpr std::size_t longest = 1000;
  if (text.empty() || text.size() > longest) return std::nullopt;
  const char* at = text.data();
  const char* const end = at + text.size();
  const bool is_negative = *at == '-';
  if (*at == '-' || *at == '+') ++at;
  Digits digits;
  at = digits.take(at, end, false);
  if (at != end && *at == '.') at = digits.take(at + 1, end, true);
  if (!digits.is_any) return std::nullopt;
  if (at != end) {
    if (*at != 'e' && *at != 'E' && *at != 'd' && *at != 'D') return std::nullopt;
    const auto exponent = written_exponent(at + 1, end);
    if (!exponent) return std::nullopt;
    digits.exponent += *exponent;
  }
  if (digits.head == 0) return NearNumber{};
  digits.shorten();
  const long size = digits.exponent + digits.in_head + digits.in_tail;
  if (std::abs(size) > 270 || std::abs(digits.exponent) > most_exponent) return std::nullopt;
  const NearNumber value = value_of(digits);
  return is_negative ? NearNumber{{-value.value.high, -value.value.low}, value.error} : value;
}

}  // namespace phrame
