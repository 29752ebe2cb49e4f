#include "phrame/io/read/curve_node.hpp"

#include <fmt/format.h>

#include <array>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/bspline_node.hpp"
#include "phrame/ph/curve/complex_form.hpp"
#include "phrame/ph/curve/rational_ph.hpp"

namespace phrame::inline v0 {

namespace {
using Kind = JsonValue::Kind;
using Node = JsonNode;
}  // namespace

CoefficientBasis::CoefficientBasis(const Node& curve, const CurveLimits& limits) : limits_(limits) {
  const Node node = curve.at("basis");
  const std::string& name = node.string();
  if (name != "bernstein" && name != "power")
    node.fail(
        fmt::format("the basis is \"bernstein\" or \"power\", not \"{}\"", abbreviated(name)));
  bernstein_ = name == "bernstein";
}

void CoefficientBasis::require_list(const Node& list) const {
  list.require(Kind::array, "an array of coefficients");
  if (list.size() == 0) list.fail("the list of coefficients is empty");
  if (static_cast<long>(list.size()) > limits_.max_degree + 1)
    list.fail(
        fmt::format("{} coefficients make a degree beyond the limit {}; --max-degree "
                    "raises it",
                    list.size(), limits_.max_degree));
}

void CoefficientBasis::require_equal_lengths(const Node& parent,
                                             const std::vector<Node>& lists) const {
  for (const Node& list : lists) {
    require_list(list);
    if (bernstein_ && list.size() != lists.front().size())
      parent.fail(fmt::format("Bernstein lists must have equal lengths, here {} and {}",
                              lists.front().size(), list.size()));
  }
}

Polynomial CoefficientBasis::polynomial(const std::vector<Rational>& coefficients) const {
  return bernstein_ ? from_bernstein(coefficients) : Polynomial(coefficients);
}

Vector<Rational> read_point(const Node& node) {
  const auto coordinates = node.numbers(3);
  return {coordinates[0], coordinates[1], coordinates[2]};
}

QuaternionPolynomial read_components(const Node& node, const CoefficientBasis& basis) {
  node.require_known_keys({"u", "v", "p", "q"});
  const std::vector<Node> lists{node.at("u"), node.at("v"), node.at("p"), node.at("q")};
  basis.require_equal_lengths(node, lists);
  return {basis.polynomial(lists[0]), basis.polynomial(lists[1]), basis.polynomial(lists[2]),
          basis.polynomial(lists[3])};
}

namespace {

/// An array of arrays of N numbers, transposed to N lists.
template <std::size_t N>
std::array<Polynomial, N> read_tuples(const Node& node, const CoefficientBasis& basis) {
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

QuaternionPolynomial read_quaternions(const Node& node, const CoefficientBasis& basis) {
  auto [u, v, p, q] = read_tuples<4>(node, basis);
  return {std::move(u), std::move(v), std::move(p), std::move(q)};
}

QuaternionPolynomial read_hopf(const Node& node, const CoefficientBasis& basis) {
  node.require_known_keys({"alpha", "beta"});
  const Node alpha = node.at("alpha");
  const Node beta = node.at("beta");
  basis.require_equal_lengths(node, {alpha, beta});
  const auto [a_re, a_im] = read_tuples<2>(alpha, basis);
  const auto [b_re, b_im] = read_tuples<2>(beta, basis);
  return from_hopf_form({{a_re, a_im}, {b_re, b_im}});
}

QuaternionPolynomial read_complex(const Node& node, const CoefficientBasis& basis) {
  const auto [re, im] = read_tuples<2>(node, basis);
  return from_complex_root({re, im});
}

QuaternionPolynomial read_preimage(const Node& curve, const CoefficientBasis& basis) {
  std::vector<std::string> given;
  for (const char* key : {"preimage", "quaternions", "hopf", "complex"})
    if (curve.find(key)) given.emplace_back(key);
  if (given.size() != 1)
    curve.fail(given.empty()
                   ? "a curve needs one of \"preimage\", \"quaternions\", \"hopf\", \"complex\" "
                     "and \"control_points\""
                   : fmt::format("\"{}\" and \"{}\" exclude each other", given[0], given[1]));
  const Node node = curve.at(given.front());
  QuaternionPolynomial preimage = given.front() == "preimage"      ? read_components(node, basis)
                                  : given.front() == "quaternions" ? read_quaternions(node, basis)
                                  : given.front() == "hopf"        ? read_hopf(node, basis)
                                                                   : read_complex(node, basis);
  if (is_zero(preimage)) node.fail("the preimage is zero, so the curve is a single point");
  return preimage;
}

}  // namespace

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
  node.require_known_keys({"phrame",      "name",        "basis",    "start",          "preimage",
                           "quaternions", "hopf",        "complex",  "control_points", "weights",
                           "position",    "expressions", "variable", "from",           "to",
                           "multiplier",  "tangents",    "note",     "family",         "expected",
                           "id",          "notes"});
}

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

namespace {

Polynomial read_polynomial(const Node& list, const CoefficientBasis& basis) {
  basis.require_list(list);
  return basis.polynomial(list.numbers());
}

/// A list, or {"numerator": …, "denominator": …}.
RationalFunction read_rational_function(const Node& node, const CoefficientBasis& basis) {
  if (!node.is(Kind::object)) return RationalFunction(read_polynomial(node, basis));
  node.require_known_keys({"numerator", "denominator"});
  Polynomial denominator = read_polynomial(node.at("denominator"), basis);
  if (denominator.is_zero()) node.at("denominator").fail("the denominator is zero");
  return {read_polynomial(node.at("numerator"), basis), std::move(denominator)};
}

RationalFunction read_multiplier(const Node& node, const CoefficientBasis& basis) {
  const auto given = node.find("multiplier");
  if (!given) return RationalFunction(Polynomial{1});
  RationalFunction f = read_rational_function(*given, basis);
  if (f.is_zero()) given->fail("the multiplier is zero, so the curve is a single point");
  return f;
}

/// A plane curve by its tangents.
Curve read_tangents(const Node& curve, const Node& node, const CoefficientBasis& basis) {
  for (const char* key : {"preimage", "quaternions", "hopf", "complex", "multiplier", "start"})
    if (curve.find(key)) curve.fail(fmt::format("\"tangents\" and \"{}\" exclude each other", key));
  node.require_known_keys({"a", "b", "support"});
  try {
    return curve_of_tangents({read_polynomial(node.at("a"), basis),
                              read_polynomial(node.at("b"), basis),
                              read_rational_function(node.at("support"), basis)});
  } catch (const DomainError& error) {
    node.fail(without_place(error.what(), "tangents"));
  }
}

Curve read_any_preimage(const Node& node, const CoefficientBasis& basis) {
  if (const auto tangents = node.find("tangents")) return read_tangents(node, *tangents, basis);
  const QuaternionPolynomial preimage = read_preimage(node, basis);
  const RationalFunction f = read_multiplier(node, basis);
  const auto point = node.find("start");
  const Vector<Rational> start = point ? read_point(*point) : Vector<Rational>{};
  try {
    return rational_ph_curve(preimage, f, start);
  } catch (const DomainError& error) {
    node.at("multiplier").fail(error.what());
  }
}

}  // namespace

NamedCurve read_preimage_curve(const Node& node, const CurveLimits& limits) {
  NamedCurve result{read_name(node), read_any_preimage(node, CoefficientBasis(node, limits))};
  if (degree(result.curve) > limits.max_degree)
    node.fail(fmt::format("the curve has degree {}, the limit is {}; --max-degree raises it",
                          degree(result.curve), limits.max_degree));
  return result;
}

// The points say all: where the curve starts and, by its hodograph, f.
NamedHodograph read_bezier(const Node& node, const Node& list, const CurveLimits& limits) {
  for (const char* key :
       {"preimage", "quaternions", "hopf", "complex", "tangents", "multiplier", "start"})
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
  const std::vector<Vector<Rational>> points = read_points_of_any_dimension(list);
  NamedHodograph result{read_name(node), bezier_hodograph(points), points.front()};
  if (result.hodograph == Vector<Polynomial>{})
    list.fail("the control points are all equal, so the curve is a single point");
  return result;
}

}  // namespace phrame
