#include "phrame/io/write/bytes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string_view>

namespace phrame::inline v0 {

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

std::string glb_head(std::string json, std::uint64_t buffer_size) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::string bytes = "glTF";
  append_number(bytes, std::uint32_t{2});
  append_number(bytes, static_cast<std::uint32_t>(28 + json.size() + buffer_size));
  append_number(bytes, static_cast<std::uint32_t>(json.size()));
  bytes += "JSON" + json;
  append_number(bytes, static_cast<std::uint32_t>(buffer_size));
  return bytes + std::string("BIN\0", 4);
}

}  // namespace phrame
