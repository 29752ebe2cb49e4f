// glTF 2.0, Khronos Group 2021: 3.6 for buffers and accessors, 3.11 and appendix C for animations,
// 4.4 for binary files.
#include "phrame/io/read/gltf_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/io/read/curve_choice.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

using Kind = JsonNode::Kind;

std::uint32_t glb_word(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t k = 0; k < 4; ++k)
    word |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + k])) << (8 * k);
  return word;
}

std::string decoded_base64(std::string_view text, const JsonNode& node) {
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=') break;
    const bool is_capital = c >= 'A' && c <= 'Z', is_small = c >= 'a' && c <= 'z';
    const bool is_digit = c >= '0' && c <= '9';
    if (!is_capital && !is_small && !is_digit && c != '+' && c != '/')
      node.fail("the data is not base64");
    const int value = is_capital ? c - 'A'
                      : is_small ? c - 'a' + 26
                      : is_digit ? c - '0' + 52
                      : c == '+' ? 62
                                 : 63;
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 0xFF);
  }
  return bytes;
}

/// "a%20b" is "a b".
std::string decoded_percent(std::string_view text, const JsonNode& node) {
  std::string bytes;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] != '%') {
      bytes += text[k];
      continue;
    }
    unsigned value = 0;
    const char* first = text.data() + k + 1;
    if (k + 2 >= text.size() || std::from_chars(first, first + 2, value, 16).ptr != first + 2)
      node.fail("two hexadecimal digits are expected behind %");
    bytes += static_cast<char>(value);
    k += 2;
  }
  return bytes;
}

/// From where the data of buffers come that are not in the JSON.
struct GltfSource {
  const FileReading& reading;
  std::string_view binary;  ///< behind the JSON
};

std::string data_of(const JsonNode& uri, const GltfSource& source) {
  const std::string& text = uri.string();
  if (text.starts_with("data:")) {
    const auto comma = text.find(',');
    if (comma == std::string::npos) uri.fail("the data of an URI begin behind a comma");
    const std::string_view data = std::string_view(text).substr(comma + 1);
    return text.substr(0, comma).ends_with(";base64") ? decoded_base64(data, uri)
                                                      : decoded_percent(data, uri);
  }
  const std::string name = decoded_percent(text, uri);
  if (!source.reading.beside)
    uri.fail("the data is in another file: save it as binary (.glb) or embedded");
  const bool is_beside = !name.starts_with('/') && name.find(':') == std::string::npos &&
                         name.find("..") == std::string::npos;
  if (!is_beside) uri.fail("the data is to be in a file beside this one, or below");
  return source.reading.beside(name);
}

/// A whole number from 0 to 2³² − 1.
std::size_t gltf_index(const JsonNode& node) {
  const Rational x = node.number();
  if (denominator(x) != 1 || x < 0 || x >= power_of_two(32)) node.fail("an index is expected");
  return static_cast<std::size_t>(static_cast<long>(numerator(x)));
}

std::size_t gltf_index_or_zero(const JsonNode& node, const std::string& key) {
  const auto found = node.find(key);
  return found ? gltf_index(*found) : 0;
}

JsonNode gltf_item(const JsonNode& document, const std::string& list, const JsonNode& index) {
  const JsonNode items = document.at(list);
  items.require(Kind::array, "an array");
  const std::size_t k = gltf_index(index);
  if (k >= items.size()) index.fail(fmt::format("there are {} {}, from 0", items.size(), list));
  return items.item(k);
}

std::string gltf_text(const JsonNode& node, const std::string& key, const std::string& otherwise) {
  const auto found = node.find(key);
  return found && found->is(Kind::string) ? found->string() : otherwise;
}

/// Numbers of an accessor, all of floats, each exactly.
std::vector<Rational> read_accessor(const JsonNode& document, const JsonNode& index,
                                    std::string_view type, std::size_t width,
                                    const GltfSource& source) {
  const JsonNode accessor = gltf_item(document, "accessors", index);
  constexpr long float_type = 5126;
  if (accessor.at("componentType").number() != float_type || accessor.at("type").string() != type)
    accessor.fail(fmt::format("an accessor of floats of the type {} is expected", type));
  if (accessor.find("sparse")) accessor.fail("sparse accessors are not read");
  const JsonNode view = gltf_item(document, "bufferViews", accessor.at("bufferView"));
  const JsonNode buffer = gltf_item(document, "buffers", view.at("buffer"));
  std::string decoded;
  std::string_view bytes = source.binary;
  if (const auto uri = buffer.find("uri")) {
    decoded = data_of(*uri, source);
    bytes = decoded;
  } else if (bytes.empty()) {
    buffer.fail("the buffer has no data");
  }
  const std::size_t stride =
      view.find("byteStride") ? gltf_index(view.at("byteStride")) : 4 * width;
  if (stride < 4 * width)
    view.at("byteStride").fail(fmt::format("an element has {} bytes", 4 * width));
  const std::size_t start =
      gltf_index_or_zero(view, "byteOffset") + gltf_index_or_zero(accessor, "byteOffset");
  const std::size_t count = gltf_index(accessor.at("count"));
  if (count > 0 &&
      (start > bytes.size() || (count - 1) * stride + 4 * width > bytes.size() - start))
    accessor.fail("the buffer ends before the data of the accessor");
  std::vector<Rational> numbers;
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t c = 0; c < width; ++c) {
      const float x = std::bit_cast<float>(glb_word(bytes, start + k * stride + 4 * c));
      if (!std::isfinite(x))
        accessor.fail(fmt::format("number {} of element {} is not finite", c, k));
      numbers.push_back(exact_rational(x));
    }
  return numbers;
}

/// A channel that moves a node.
struct GltfMover {
  JsonNode animation;
  JsonNode channel;
  CurveLabel label;
};

std::vector<GltfMover> gltf_movers(const JsonNode& document) {
  std::vector<GltfMover> all;
  const auto animations = document.find("animations");
  if (!animations || !animations->is(Kind::array)) return all;
  for (std::size_t k = 0; k < animations->size(); ++k) {
    const JsonNode animation = animations->item(k);
    const JsonNode channels = animation.at("channels");
    for (std::size_t j = 0; j < channels.size(); ++j) {
      const JsonNode target = channels.item(j).at("target");
      const auto node = target.find("node");
      if (target.at("path").string() != "translation" || !node) continue;
      const std::string name = gltf_text(gltf_item(document, "nodes", *node), "name",
                                         fmt::format("node {}", gltf_index(*node)));
      all.push_back(
          {animation,
           channels.item(j),
           {name, gltf_text(animation, "name", fmt::format("animation {}", k)) + "/" + name}});
    }
  }
  return all;
}

}  // namespace

bool is_glb_file(std::string_view bytes) { return bytes.starts_with("glTF"); }

bool is_gltf_file(const JsonNode& node) {
  if (!node.is(Kind::object) || node.find("phrame")) return false;
  const auto asset = node.find("asset");
  return asset && asset->is(Kind::object) && asset->find("version");
}

PointCurve read_gltf(const JsonNode& node, const FileReading& reading, std::string_view binary) {
  const std::vector<GltfMover> all = gltf_movers(node);
  if (all.empty()) node.fail("there is no animation in the file that moves a node");
  std::vector<CurveLabel> labels;
  for (const GltfMover& mover : all) labels.push_back(mover.label);
  const GltfMover& mover = all[chosen_curve(labels, reading.pick, node.place())];
  const JsonNode sampler = gltf_item(mover.animation, "samplers", mover.channel.at("sampler"));
  const std::string interpolation = gltf_text(sampler, "interpolation", "LINEAR");
  const bool is_cubic = interpolation == "CUBICSPLINE";
  if (!is_cubic && interpolation != "LINEAR")
    sampler.fail(fmt::format("the node moves by {}, which is no curve", interpolation));
  const GltfSource source{reading, binary};
  const std::vector<Rational> times = read_accessor(node, sampler.at("input"), "SCALAR", 1, source);
  const std::vector<Rational> values = read_accessor(node, sampler.at("output"), "VEC3", 3, source);
  const std::size_t group = is_cubic ? 9 : 3;
  if (times.size() < 2) sampler.fail("a curve needs two keys at least");
  if (values.size() != group * times.size())
    sampler.fail(fmt::format("{} numbers for {} keys", values.size(), times.size()));
  const auto vector = [&](std::size_t key, std::size_t part) {
    const std::size_t at = group * key + 3 * part;
    return Vector<Rational>{values[at], values[at + 1], values[at + 2]};
  };
  PointCurve curve{mover.label.name, {}};
  for (std::size_t k = 0; k + 1 < times.size(); ++k) {
    const Rational step = times[k + 1] - times[k];
    if (step <= 0) sampler.fail(fmt::format("the time of key {} does not increase", k + 1));
    RationalBezier piece{{vector(k, is_cubic ? 1 : 0), vector(k + 1, is_cubic ? 1 : 0)}};
    if (is_cubic)
      piece.points = {piece.points[0], piece.points[0] + step / 3 * vector(k, 2),
                      piece.points[1] - step / 3 * vector(k + 1, 0), piece.points[1]};
    if (std::ranges::all_of(piece.points, [&](const auto& p) { return p == piece.points[0]; }))
      continue;  // it waits
    curve.segments.push_back(span_segment({piece, times[k], times[k + 1]}, sampler.place(),
                                          fmt::format("from key {} to {}", k, k + 1)));
  }
  if (curve.segments.empty()) sampler.fail("the node does not move");
  curve.notes.push_back(fmt::format(
      "the curve is the way of \"{}\" in the coordinates of its parent", mover.label.name));
  return curve;
}

PointCurve read_glb(std::string_view bytes, const FileReading& reading) {
  if (bytes.size() < 20 || glb_word(bytes, 4) != 2)
    throw InputError("header", "the binary glTF is cut off, or not of version 2");
  const std::size_t length = glb_word(bytes, 12);
  constexpr std::uint32_t json_type = 0x4E4F534A;
  constexpr std::uint32_t binary_type = 0x004E4942;
  if (glb_word(bytes, 16) != json_type || length > bytes.size() - 20)
    throw InputError("header", "the binary glTF does not begin with its JSON");
  const JsonValue document = parse_json(bytes.substr(20, length));
  const std::size_t next = 20 + length;
  std::string_view binary;
  if (bytes.size() >= next + 8 && glb_word(bytes, next + 4) == binary_type)
    binary = bytes.substr(next + 8, glb_word(bytes, next));
  return read_gltf(JsonNode(document), reading, binary);
}

}  // namespace phrame
