#include "phrame/io/read/certificate_file.hpp"

#include <fmt/format.h>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/io/read/json_node.hpp"
#include "phrame/io/write/names.hpp"

namespace phrame {
namespace {

using Kind = JsonNode::Kind;

constexpr long max_bits = 1'000'000;

Integer read_integer(const JsonNode& node) {
  const Rational x = node.number();
  if (denominator(x) != 1) node.fail(as_written(x) + " is not an integer");
  return Integer(numerator(x));
}

Integer read_integer(const JsonNode& node, const Integer& least) {
  Integer n = read_integer(node);
  if (n < least) node.fail(fmt::format("{} is less than {}", abbreviated(n.str()), least.str()));
  return n;
}

/// A JSON number, an integer in a range of machine words.
long read_count(const JsonNode& node, long least, long largest) {
  node.require(Kind::number, "a number");
  const Integer n = read_integer(node);
  if (n < least || n > largest)
    node.fail(fmt::format("{} is not in {} … {}", abbreviated(n.str()), least, largest));
  return static_cast<long>(n);
}

/// The items of an array, each read.
template <class Read>
auto read_list(const JsonNode& node, Read read) {
  node.require(Kind::array, "an array");
  std::vector<decltype(read(node))> list;
  for (std::size_t k = 0; k < node.size(); ++k) list.push_back(read(node.item(k)));
  return list;
}

Polynomial read_polynomial(const JsonNode& node) {
  node.require(Kind::array, "an array of coefficients");
  return Polynomial(node.numbers());
}

GaussianPolynomial read_gaussian_polynomial(const JsonNode& node) {
  node.require_known_keys({"re", "im"});
  return {read_polynomial(node.at("re")), read_polynomial(node.at("im"))};
}

Vector<Rational> read_vector(const JsonNode& node) {
  const auto list = node.numbers(3);
  return {list[0], list[1], list[2]};
}

GaussianInteger read_grid_point(const JsonNode& node) {
  const auto parts = read_list(node, [](const JsonNode& part) { return read_integer(part); });
  if (parts.size() != 2) node.fail(fmt::format("2 numbers are wanted, not {}", parts.size()));
  return {parts[0], parts[1]};
}

RootDisc read_disc(const JsonNode& node) {
  node.require_known_keys({"center", "radius", "residue", "residue_radius"});
  return {read_grid_point(node.at("center")), read_integer(node.at("radius"), 0),
          read_grid_point(node.at("residue")), read_integer(node.at("residue_radius"), 0)};
}

CertifiedLogs read_logs(const JsonNode& node) {
  node.require_known_keys({"index", "residue", "roots"});
  return {read_polynomial(node.at("index")), read_polynomial(node.at("residue")),
          read_list(node.at("roots"), read_disc)};
}

StatedPoint read_stated_point(const JsonNode& node) {
  node.require_known_keys({"t", "order"});
  const long order = read_count(node.at("order"), 1, 1'000'000'000);
  const JsonNode t = node.at("t");
  if (!t.is(Kind::object)) {
    const Rational at = t.number();
    return {primitive_part(Polynomial{-at, 1}), closed_interval(at, at), order};
  }
  t.require_known_keys({"polynomial", "interval"});
  Polynomial polynomial = read_polynomial(t.at("polynomial"));
  if (polynomial.is_constant()) t.at("polynomial").fail("the polynomial is constant");
  const auto ends = t.at("interval").numbers(2);
  if (ends[0] >= ends[1]) t.at("interval").fail("the interval is empty");
  return {std::move(polynomial), open_interval(ends[0], ends[1]), order};
}

/// A decimal number as it is written.
std::string read_decimal(const JsonNode& node) {
  const std::string& text = node.string();
  node.number();
  if (text.find_first_of("/xX") != std::string::npos)
    node.fail(fmt::format("a decimal number is wanted, not \"{}\"", abbreviated(text)));
  return text;
}

TurnCount read_turn(const JsonNode& node) {
  node.require_known_keys({"index", "signs"});
  const auto signs = read_list(node.at("signs"), [](const JsonNode& text) {
    if (text.string().find_first_not_of("+-0") != std::string::npos)
      text.fail(fmt::format("signs are +, - and 0, not \"{}\"", abbreviated(text.string())));
    return text.string();
  });
  if (signs.size() != 2) node.at("signs").fail("the signs at 0 and at t are wanted");
  constexpr long largest = 1'000'000'000;
  return {read_count(node.at("index"), -largest, largest), signs[0], signs[1]};
}

AngleClaim read_claim(const JsonNode& node, bool has_turn) {
  if (has_turn)
    node.require_known_keys({"t", "theta", "radius", "turn"});
  else
    node.require_known_keys({"t", "theta", "radius"});
  AngleClaim claim{
      node.at("t").number(), read_decimal(node.at("theta")), read_decimal(node.at("radius")), {}};
  if (has_turn) claim.turn = read_turn(node.at("turn"));
  return claim;
}

/// The answer to a question whose witness, under `keys`, is there where it is yes.
bool read_answer(const JsonNode& node, std::vector<std::string_view> keys) {
  const bool answer = node.at("answer").boolean();
  if (!answer) keys.clear();
  keys.emplace_back("answer");
  node.require_known_keys(keys);
  return answer;
}

StatedDecisions read_decisions(const JsonNode& node) {
  node.require_known_keys({"regular", "inflections", "line", "planar", "helical", "double_ph",
                           "primitive", "erf_is_rmf", "rrmf", "erf_monotone"});
  const auto listed = [&](const char* question, std::vector<std::string_view> keys) {
    const JsonNode item = node.at(question);
    keys.emplace_back("answer");
    item.require_known_keys(keys);
    return item;
  };
  const JsonNode regular = listed("regular", {"cusps"});
  const JsonNode inflections = listed("inflections", {"points"});
  const JsonNode primitive = listed("primitive", {"content"});
  const JsonNode monotone = listed("erf_monotone", {"zeros_of_h", "extrema"});
  const auto points = [](const JsonNode& list) { return read_list(list, read_stated_point); };
  StatedDecisions d{regular.at("answer").boolean(),
                    points(regular.at("cusps")),
                    inflections.at("answer").boolean(),
                    points(inflections.at("points")),
                    {},
                    {},
                    {},
                    {},
                    primitive.at("answer").boolean(),
                    read_polynomial(primitive.at("content")),
                    read_answer(node.at("erf_is_rmf"), {}),
                    {},
                    monotone.at("answer").boolean(),
                    points(monotone.at("zeros_of_h")),
                    points(monotone.at("extrema"))};
  if (const JsonNode line = node.at("line"); read_answer(line, {"direction"}))
    d.line = read_vector(line.at("direction"));
  if (const JsonNode planar = node.at("planar"); read_answer(planar, {"normal"}))
    d.normal = read_vector(planar.at("normal"));
  if (const JsonNode helix = node.at("helical"); read_answer(helix, {"axis", "cos_squared"}))
    d.helix = {read_vector(helix.at("axis")), helix.at("cos_squared").number()};
  if (const JsonNode square = node.at("double_ph"); read_answer(square, {"constant", "omega"}))
    d.double_ph = {square.at("constant").number(), read_polynomial(square.at("omega"))};
  if (const JsonNode rrmf = node.at("rrmf"); read_answer(rrmf, {"w"}))
    d.rational_frame = read_gaussian_polynomial(rrmf.at("w"));
  return d;
}

Reference read_frame(const JsonNode& node) {
  for (const auto& [name, reference] : reference_names())
    if (node.string() == name && reference != Reference::up) return reference;
  node.fail(
      fmt::format("the frame is \"erf\" or \"frenet\", not \"{}\"", abbreviated(node.string())));
}

RationalFunction read_rational_function(const JsonNode& node) {
  node.require_known_keys({"numerator", "denominator"});
  Polynomial denominator = read_polynomial(node.at("denominator"));
  if (denominator.is_zero()) node.at("denominator").fail("the denominator is 0");
  return {read_polynomial(node.at("numerator")), std::move(denominator)};
}

Vector<Polynomial> read_hodograph(const JsonNode& node) {
  auto list = read_list(node, read_polynomial);
  if (list.size() != 3) node.fail(fmt::format("3 polynomials are wanted, not {}", list.size()));
  return {list[0], list[1], list[2]};
}

}  // namespace

Certificate read_certificate(std::string_view text, const CurveLimits& limits) {
  const JsonValue document = parse_json_file(text, "certificate");
  const JsonNode node(document);
  node.require(Kind::object, "an object");
  if (const JsonNode format = node.at("phrame"); format.string() != "certificate/1")
    format.fail(
        fmt::format("the format is \"certificate/1\", not \"{}\"", abbreviated(format.string())));
  const Reference reference = read_frame(node.at("frame"));
  const bool is_frenet = reference == Reference::frenet;
  std::vector<std::string_view> keys{"phrame", "curve",    "frame", "hodograph", "sigma",
                                     "h",      "g",        "rate",  "bits",      "antiderivative",
                                     "claims", "decisions"};
  if (is_frenet) keys.emplace_back("bend");
  node.require_known_keys(keys);
  const JsonNode rate = node.at("rate");
  rate.require_known_keys({"numerator", "denominator", "common", "coprime_modulo"});
  const JsonNode antiderivative = node.at("antiderivative");
  antiderivative.require_known_keys({"rational", "logs"});
  const JsonNode curve = node.at("curve");
  curve.require_known_keys(
      {"phrame", "name", "note", "family", "basis", "start", "preimage", "multiplier"});
  if (const JsonNode basis = curve.at("basis"); basis.string() != "power")
    basis.fail(fmt::format("the basis is \"power\", not \"{}\"", abbreviated(basis.string())));
  const auto read_claims = [&](const JsonNode& claim) { return read_claim(claim, is_frenet); };
  Certificate c{read_curve(curve, limits).curve,
                reference,
                read_hodograph(node.at("hodograph")),
                read_polynomial(node.at("sigma")),
                read_polynomial(node.at("h")),
                read_gaussian_polynomial(node.at("g")),
                {read_polynomial(rate.at("numerator")), read_polynomial(rate.at("denominator")),
                 read_polynomial(rate.at("common")), read_integer(rate.at("coprime_modulo"), 2)},
                read_rational_function(antiderivative.at("rational")),
                read_list(antiderivative.at("logs"), read_logs),
                read_count(node.at("bits"), 0, max_bits),
                {},
                read_list(node.at("claims"), read_claims),
                read_decisions(node.at("decisions"))};
  if (is_frenet) {
    const JsonNode bend = node.at("bend");
    bend.require_known_keys({"polynomial", "content"});
    c.bend = {read_gaussian_polynomial(bend.at("polynomial")), read_polynomial(bend.at("content"))};
  }
  return c;
}

}  // namespace phrame
