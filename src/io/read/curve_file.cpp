#include "phrame/io/read/curve_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/io/read/json_node.hpp"
#include "phrame/io/write/json_text.hpp"
#include "phrame/ph/construct/near.hpp"
#include "phrame/ph/curve/identify.hpp"

namespace phrame {
namespace {

using Kind = JsonValue::Kind;
using Node = JsonNode;

/// What turns lists of numbers into polynomials.
class Basis {
 public:
  Basis(const Node& curve, const CurveLimits& limits) : limits_(limits) {
    const Node node = curve.at("basis");
    const std::string& name = node.string();
    if (name != "bernstein" && name != "power")
      node.fail(
          fmt::format("the basis is \"bernstein\" or \"power\", not \"{}\"", abbreviated(name)));
    bernstein_ = name == "bernstein";
  }

  void require_list(const Node& list) const {
    list.require(Kind::array, "an array of coefficients");
    if (list.size() == 0) list.fail("the list of coefficients is empty");
    if (static_cast<long>(list.size()) > limits_.max_degree + 1)
      list.fail(
          fmt::format("{} coefficients make a degree beyond the limit {}; --max-degree "
                      "raises it",
                      list.size(), limits_.max_degree));
  }

  /// In the Bernstein basis a short list would silently mean another degree: an error.
  void require_equal_lengths(const Node& parent, const std::vector<Node>& lists) const {
    for (const Node& list : lists) {
      require_list(list);
      if (bernstein_ && list.size() != lists.front().size())
        parent.fail(fmt::format("Bernstein lists must have equal lengths, here {} and {}",
                                lists.front().size(), list.size()));
    }
  }

  Polynomial polynomial(const std::vector<Rational>& coefficients) const {
    return bernstein_ ? from_bernstein(coefficients) : Polynomial(coefficients);
  }
  Polynomial polynomial(const Node& list) const { return polynomial(list.numbers()); }

 private:
  CurveLimits limits_;
  bool bernstein_ = false;
};

QuaternionPolynomial read_components(const Node& node, const Basis& basis) {
  node.require_known_keys({"u", "v", "p", "q"});
  const std::vector<Node> lists{node.at("u"), node.at("v"), node.at("p"), node.at("q")};
  basis.require_equal_lengths(node, lists);
  return {basis.polynomial(lists[0]), basis.polynomial(lists[1]), basis.polynomial(lists[2]),
          basis.polynomial(lists[3])};
}

/// An array of arrays of N numbers, transposed to N lists.
template <std::size_t N>
std::array<Polynomial, N> read_tuples(const Node& node, const Basis& basis) {
  basis.require_list(node);
  std::array<std::vector<Rational>, N> lists;
  for (std::size_t k = 0; k < node.size(); ++k) {
    const auto tuple = node.item(k).numbers(N);
    for (std::size_t j = 0; j < N; ++j) lists[j].push_back(tuple[j]);
  }
  std::array<Polynomial, N> result;
  for (std::size_t j = 0; j < N; ++j) result[j] = basis.polynomial(lists[j]);
  return result;
}

QuaternionPolynomial read_quaternions(const Node& node, const Basis& basis) {
  auto [u, v, p, q] = read_tuples<4>(node, basis);
  return {std::move(u), std::move(v), std::move(p), std::move(q)};
}

QuaternionPolynomial read_hopf(const Node& node, const Basis& basis) {
  node.require_known_keys({"alpha", "beta"});
  const Node alpha = node.at("alpha");
  const Node beta = node.at("beta");
  basis.require_equal_lengths(node, {alpha, beta});
  const auto [a_re, a_im] = read_tuples<2>(alpha, basis);
  const auto [b_re, b_im] = read_tuples<2>(beta, basis);
  return from_hopf_form({{a_re, a_im}, {b_re, b_im}});
}

Vector<Rational> read_point(const Node& node) {
  const auto coordinates = node.numbers(3);
  return {coordinates[0], coordinates[1], coordinates[2]};
}

QuaternionPolynomial read_preimage(const Node& curve, const Basis& basis) {
  std::vector<std::string> given;
  for (const char* key : {"preimage", "quaternions", "hopf"})
    if (curve.find(key)) given.emplace_back(key);
  if (given.size() != 1)
    curve.fail(given.empty()
                   ? "a curve needs one of \"preimage\", \"quaternions\", \"hopf\" and "
                     "\"control_points\""
                   : fmt::format("\"{}\" and \"{}\" exclude each other", given[0], given[1]));
  const Node node = curve.at(given.front());
  QuaternionPolynomial preimage = given.front() == "preimage"      ? read_components(node, basis)
                                  : given.front() == "quaternions" ? read_quaternions(node, basis)
                                                                   : read_hopf(node, basis);
  if (is_zero(preimage)) node.fail("the preimage is zero, so the curve is a single point");
  return preimage;
}

/// The text at "phrame".
std::string format_of(const Node& node) {
  node.require(Kind::object, "an object");
  return node.at("phrame").string();
}

void require_format(const Node& node, std::string_view wanted) {
  const std::string format = format_of(node);
  if (format != wanted)
    node.at("phrame").fail(
        fmt::format("the format is \"{}\", not \"{}\"", wanted, abbreviated(format)));
}

void require_curve_keys(const Node& node) {
  node.require_known_keys({"phrame", "name", "basis", "start", "preimage", "quaternions", "hopf",
                           "control_points", "multiplier", "note", "family", "expected"});
}

/// Requires an object of the format curve/1 with known keys only.
void require_curve(const Node& node) {
  if (format_of(node) == "spline/1")
    node.at("phrame").fail("this is a spline; one curve is wanted");
  require_format(node, "curve/1");
  require_curve_keys(node);
}

std::string read_name(const Node& curve) {
  const auto name = curve.find("name");
  return name ? name->string() : "";
}

NamedCurve read_preimage_curve(const Node& node, const CurveLimits& limits) {
  std::string name = read_name(node);
  const Basis basis(node, limits);
  QuaternionPolynomial preimage = read_preimage(node, basis);
  Polynomial multiplier{1};
  if (const auto list = node.find("multiplier")) {
    basis.require_list(*list);
    multiplier = basis.polynomial(*list);
    if (multiplier.is_zero()) list->fail("the multiplier is zero, so the curve is a single point");
  }
  Vector<Rational> start{};
  if (const auto point = node.find("start")) start = read_point(*point);
  NamedCurve result{std::move(name),
                    Curve(std::move(preimage), std::move(multiplier), std::move(start))};
  if (degree(result.curve) > limits.max_degree)
    node.fail(fmt::format("the curve has degree {}, the limit is {}; --max-degree raises it",
                          degree(result.curve), limits.max_degree));
  return result;
}

/// The points say all: where the curve starts and, by its hodograph, f.
NamedHodograph read_bezier(const Node& node, const Node& list, const CurveLimits& limits) {
  for (const char* key : {"preimage", "quaternions", "hopf", "multiplier", "start"})
    if (node.find(key))
      node.fail(fmt::format("\"control_points\" and \"{}\" exclude each other", key));
  if (const auto basis = node.find("basis"); basis && basis->string() != "bernstein")
    basis->fail(fmt::format("control points have the basis \"bernstein\", not \"{}\"",
                            abbreviated(basis->string())));
  list.require(Kind::array, "an array of points");
  if (list.size() < 2)
    list.fail(fmt::format("a curve has at least 2 control points, not {}", list.size()));
  if (static_cast<long>(list.size()) > limits.max_degree + 1)
    list.fail(fmt::format("{} points make a degree beyond the limit {}; --max-degree raises it",
                          list.size(), limits.max_degree));
  std::vector<Vector<Rational>> points;
  for (std::size_t k = 0; k < list.size(); ++k) points.push_back(read_point(list.item(k)));
  NamedHodograph result{read_name(node), bezier_hodograph(points), points.front()};
  if (result.hodograph == Vector<Polynomial>{})
    list.fail("the control points are all equal, so the curve is a single point");
  return result;
}

/// What read_path_near() might do; empty where it would not help.
std::string suggestion_for(const NamedHodograph& bezier, const std::string& near_option) {
  if (near_option.empty()) return "";
  const auto near = near_suggestion(bezier.hodograph, bezier.start);
  if (!near) return "";
  return fmt::format("; {} {} takes the PH curve {} from it", near_option,
                     upper_bound_text(near->epsilon, 1), upper_bound_text(near->distance));
}

NamedCurve read_any_curve(const Node& node, const CurveLimits& limits) {
  const auto points = node.find("control_points");
  if (!points) return read_preimage_curve(node, limits);
  NamedHodograph bezier = read_bezier(node, *points, limits);
  auto result = identify(bezier.hodograph, bezier.start);
  if (const auto* reason = std::get_if<NotPythagorean>(&result))
    points->fail("this is no PH curve: " + to_string(*reason) +
                 suggestion_for(bezier, limits.near_option));
  return {std::move(bezier.name), std::get<Curve>(std::move(result))};
}

/// A segment says where it starts, or starts where the spline ends.
void append_segment(Path& path, const Node& node, const CurveLimits& limits) {
  const Curve read = read_any_curve(node, limits).curve;
  const bool says_start = node.find("start") || node.find("control_points");
  const Curve& last = path.segments().back();
  const Curve next =
      says_start ? read : Curve(read.preimage(), read.multiplier(), evaluate(position(last), 1));
  try {
    path.append(next);
  } catch (const DomainError& error) {
    node.fail(error.what());
  }
}

std::vector<Node> read_segments(const Node& spline) {
  spline.require_known_keys({"phrame", "name", "segments", "note", "family", "expected"});
  const Node list = spline.at("segments");
  list.require(Kind::array, "an array of curves");
  if (list.size() == 0) list.fail("a spline has at least one segment");
  std::vector<Node> segments;
  for (std::size_t k = 0; k < list.size(); ++k) {
    const Node& item = segments.emplace_back(list.item(k));
    item.require(Kind::object, "an object");
    if (item.find("phrame")) require_format(item, "curve/1");
    require_curve_keys(item);
  }
  return segments;
}

NamedPath read_spline(const Node& node, const CurveLimits& limits) {
  const std::vector<Node> segments = read_segments(node);
  NamedPath result{read_name(node), Path(read_any_curve(segments[0], limits).curve)};
  for (std::size_t k = 1; k < segments.size(); ++k)
    append_segment(result.path, segments[k], limits);
  return result;
}

using NearReading = std::variant<NamedPath, NotNear>;

/// What near_curve or near_path finds; what it cannot do is an error at this place.
template <class Find>
NearReading found_near(const Node& node, std::string name, Find find) {
  try {
    auto result = find();
    if (const auto* none = std::get_if<NotNear>(&result)) return *none;
    auto& [path, nearness] = std::get<0>(result);
    return NamedPath(std::move(name), std::move(path), std::move(nearness));
  } catch (const DomainError& error) {
    node.fail(error.what());
  }
}

/// No value where all its segments are PH as they are.
std::optional<NearReading> read_spline_near(const Node& node, const Rational& epsilon,
                                            const CurveLimits& limits) {
  std::vector<BezierPoints> curves;
  bool all_ph = true;
  for (const Node& segment : read_segments(node)) {
    const auto list = segment.find("control_points");
    if (list) {
      const NamedHodograph bezier = read_bezier(segment, *list, limits);
      all_ph = all_ph && std::holds_alternative<Curve>(identify(bezier.hodograph));
      curves.push_back(bezier_points(bezier.hodograph, bezier.start));
    } else {
      const Curve curve = read_preimage_curve(segment, limits).curve;
      const bool says_start = segment.find("start") || curves.empty();
      curves.push_back(
          bezier_points(hodograph(curve), says_start ? curve.start() : curves.back().back()));
    }
  }
  if (all_ph) return std::nullopt;
  return found_near(node.at("segments"), read_name(node),
                    [&] { return near_path(curves, epsilon); });
}

/// No value where it is PH as it is.
std::optional<NearReading> read_curve_near(const Node& node, const Rational& epsilon,
                                           const CurveLimits& limits) {
  require_curve_keys(node);
  const auto list = node.find("control_points");
  if (!list) return std::nullopt;
  NamedHodograph bezier = read_bezier(node, *list, limits);
  if (std::holds_alternative<Curve>(identify(bezier.hodograph))) return std::nullopt;
  return found_near(*list, std::move(bezier.name),
                    [&] { return near_curve(bezier.hodograph, bezier.start, epsilon); });
}

}  // namespace

NamedCurve read_curve(std::string_view text, const CurveLimits& limits) {
  const JsonValue document = parse_json_file(text, "curve file");
  return read_curve(JsonNode(document), limits);
}

NamedCurve read_curve(const JsonNode& node, const CurveLimits& limits) {
  require_curve(node);
  return read_any_curve(node, limits);
}

NamedPath read_path(std::string_view text, const CurveLimits& limits) {
  const JsonValue document = parse_json_file(text, "curve file");
  format_of(Node(document));
  return read_path(Node(document), limits);
}

NamedPath read_path(const JsonNode& node, const CurveLimits& limits) {
  node.require(Kind::object, "an object");
  const auto format = node.find("phrame");
  if (format && format->string() == "spline/1") return read_spline(node, limits);
  if (format && format->string() != "curve/1")
    format->fail(fmt::format("the format is \"curve/1\" or \"spline/1\", not \"{}\"",
                             abbreviated(format->string())));
  require_curve_keys(node);
  return read_any_curve(node, limits);
}

std::variant<NamedPath, NotNear> read_path_near(std::string_view text, const Rational& epsilon,
                                                const CurveLimits& limits) {
  const JsonValue document = parse_json_file(text, "curve file");
  format_of(Node(document));
  return read_path_near(Node(document), epsilon, limits);
}

std::variant<NamedPath, NotNear> read_path_near(const JsonNode& node, const Rational& epsilon,
                                                const CurveLimits& limits) {
  node.require(Kind::object, "an object");
  const std::string format = node.find("phrame") ? format_of(node) : "curve/1";
  std::optional<NearReading> near;
  if (format == "spline/1") near = read_spline_near(node, epsilon, limits);
  if (format == "curve/1") near = read_curve_near(node, epsilon, limits);
  if (near) return *std::move(near);
  return read_path(node, limits);
}

bool is_spline_file(std::string_view text) {
  const JsonValue document = parse_json_file(text, "curve file");
  return format_of(Node(document)) == "spline/1";
}

NamedHodograph read_hodograph(std::string_view text, const CurveLimits& limits) {
  const JsonValue document = parse_json_file(text, "curve file");
  const Node node(document);
  require_curve(node);
  if (const auto points = node.find("control_points")) return read_bezier(node, *points, limits);
  const NamedCurve named = read_preimage_curve(node, limits);
  return {named.name, hodograph(named.curve), named.curve.start()};
}

}  // namespace phrame
