#include "phrame/io/write/bytes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <string_view>
#include <utility>

namespace phrame::inline v0 {
namespace {

void append_chunk(std::string& bytes, std::string_view kind, std::string content, char filler) {
  content.resize((content.size() + 3) / 4 * 4, filler);
  append_number(bytes, static_cast<std::uint32_t>(content.size()));
  bytes += kind;
  bytes += content;
}

}  // namespace

void append_float(std::string& bytes, float x) {
  append_number(bytes, std::bit_cast<std::uint32_t>(x));
}

std::string base64(const std::string& bytes) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - k);
    std::uint32_t bits = 0;
    for (std::size_t j = 0; j < 3; ++j)
      bits = (bits << 8U) | (j < count ? static_cast<unsigned char>(bytes[k + j]) : 0U);
    for (std::size_t j = 0; j < 4; ++j)
      text += j <= count ? digits[(bits >> (18 - 6 * j)) & 63U] : '=';
  }
  return text;
}

std::string translation_json(const Vector<double>& to) {
  if (to == Vector<double>{}) return "";
  return fmt::format(",\"translation\":[{},{},{}]", to[0], to[1], to[2]);
}

std::string glb_file(std::string json, std::string buffer) {
  std::string chunks;
  append_chunk(chunks, "JSON", std::move(json), ' ');
  append_chunk(chunks, std::string_view("BIN\0", 4), std::move(buffer), '\0');
  std::string bytes = "glTF";
  append_number(bytes, std::uint32_t{2});
  append_number(bytes, static_cast<std::uint32_t>(12 + chunks.size()));
  return bytes + chunks;
}

}  // namespace phrame
