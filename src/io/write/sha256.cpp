// FIPS 180-4, §5.1.1, §5.3.3 and §6.2.2. The constants are the first 32 bits of the fractional
// parts of the square and cube roots of the first primes (§4.2.2), and are found as such.
#include "phrame/io/write/sha256.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstdint>

#include "phrame/algebra/integer.hpp"

namespace phrame::inline v0 {
namespace {

using State = std::array<std::uint32_t, 8>;

bool is_prime(int n) {
  for (int d = 2; d * d <= n; ++d)
    if (n % d == 0) return false;
  return true;
}

/// The 32 bits after the point of √p or ∛p: x² ≤ p·2^64, or x³ ≤ p·2^96, for the greatest x.
std::uint32_t fraction_of_root(int p, unsigned degree) {
  const Integer target = Integer(p) << (32 * degree);
  std::uint64_t x = 0;
  for (int bit = 37; bit >= 0; --bit) {
    const Integer y = static_cast<long>(x | (std::uint64_t{1} << bit));
    if ((degree == 2 ? Integer(y * y) : Integer(y * y * y)) <= target) x |= std::uint64_t{1} << bit;
  }
  return static_cast<std::uint32_t>(x);
}

template <std::size_t Count>
std::array<std::uint32_t, Count> fractions_of_roots(unsigned degree) {
  std::array<std::uint32_t, Count> list{};
  int p = 2;
  for (std::uint32_t& x : list) {
    while (!is_prime(p)) ++p;
    x = fraction_of_root(p++, degree);
  }
  return list;
}

/// The bytes, a bit 1, bits 0, and the number of bits in 64 bits.
std::string padded_message(std::string_view bytes) {
  std::string text(bytes);
  text += '\x80';
  while (text.size() % 64 != 56) text += '\0';
  for (int shift = 56; shift >= 0; shift -= 8)
    text += static_cast<char>((std::uint64_t{bytes.size()} * 8 >> shift) & 0xFF);
  return text;
}

void add_block(State& state, const char* block) {
  static const auto k = fractions_of_roots<64>(3);
  std::array<std::uint32_t, 64> w{};
  for (std::size_t t = 0; t < 16; ++t)
    for (std::size_t byte = 0; byte < 4; ++byte)
      w[t] = w[t] << 8 | static_cast<unsigned char>(block[4 * t + byte]);
  for (std::size_t t = 16; t < 64; ++t) {
    const std::uint32_t x = w[t - 15];
    const std::uint32_t y = w[t - 2];
    w[t] = (std::rotr(y, 17) ^ std::rotr(y, 19) ^ y >> 10) + w[t - 7] +
           (std::rotr(x, 7) ^ std::rotr(x, 18) ^ x >> 3) + w[t - 16];
  }
  auto [a, b, c, d, e, f, g, h] = state;
  for (std::size_t t = 0; t < 64; ++t) {
    const std::uint32_t one = h + (std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25)) +
                              ((e & f) ^ (~e & g)) + k[t] + w[t];
    const std::uint32_t two =
        (std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22)) + ((a & b) ^ (a & c) ^ (b & c));
    h = g, g = f, f = e, e = d + one, d = c, c = b, b = a, a = one + two;
  }
  const State added{a, b, c, d, e, f, g, h};
  for (std::size_t n = 0; n < state.size(); ++n) state[n] += added[n];
}

}  // namespace

std::string sha256(std::string_view bytes) {
  State state = fractions_of_roots<8>(2);
  const std::string text = padded_message(bytes);
  for (std::size_t at = 0; at < text.size(); at += 64) add_block(state, text.data() + at);
  std::string hash;
  for (const std::uint32_t word : state) hash += fmt::format("{:08x}", word);
  return hash;
}

}  // namespace phrame
