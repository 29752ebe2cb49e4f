#include "phrame/io/read/integral_certificate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/real.hpp"
#include "phrame/io/read/formula.hpp"
#include "phrame/io/write/names.hpp"
#include "phrame/ph/curve/formula_jet.hpp"

namespace phrame::inline v0 {
namespace {

/// Of a formula in a certificate: characters, parentheses in one another, digits of a number, and
/// the numerator and denominator of an exponent.
constexpr std::size_t most_characters = 10'000;
constexpr long most_depth = 60;
constexpr long most_digits = 5000;
constexpr long most_power = 1000;

long depth_of(const std::string& text) {
  long depth = 0;
  long most = 0;
  for (const char c : text) {
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    most = std::max(most, depth);
  }
  return most;
}

/// Of the longest number.
long digits_of(const std::string& text) {
  long digits = 0;
  long most = 0;
  for (const char c : text) {
    digits = c >= '0' && c <= '9' ? digits + 1 : 0;
    most = std::max(most, digits);
  }
  return most;
}

/// A formula in its canonical form.
Formula read_formula(const JsonNode& node, const std::string& variable) {
  const std::string& text = node.string();
  if (text.size() > most_characters || depth_of(text) > most_depth)
    node.fail(fmt::format("a formula of at most {} characters, {} parentheses deep, is wanted",
                          most_characters, most_depth));
  if (digits_of(text) > most_digits)
    node.fail(fmt::format("numbers of at most {} digits are wanted", most_digits));
  try {
    Formula f = parse_formula(text, variable).value;
    if (full_text(f, "s") != text)
      node.fail("this formula is not written as it would be written again");
    for (const Formula::Step& step : f.steps())
      if (step.operation == Formula::Operation::power &&
          (abs(numerator(step.number)) > most_power || denominator(step.number) > most_power))
        node.fail(fmt::format("exponents are limited to {}", most_power));
    return f;
  } catch (const InputError& error) {
    if (error.place() == node.place()) throw;
    node.fail(error.place() + ": " + error.reason());
  }
}

/// By its form.
bool is_rational(const Formula& f) {
  using Operation = Formula::Operation;
  return std::ranges::all_of(f.steps(), [](const Formula::Step& step) {
    switch (step.operation) {
      case Operation::number:
        return step.pi_multiple == 0;
      case Operation::power:
        return denominator(step.number) == 1;
      case Operation::variable:
      case Operation::add:
      case Operation::multiply:
      case Operation::divide:
        return true;
      default:
        return false;
    }
  });
}

/// Reads the parts, and counts what it takes to check them, in the units of docs/certificate.md.
class IntegralReader {
 public:
  explicit IntegralReader(const CurveLimits& limits) : most_(limits.max_degree + 1) {}

  Rational exact(const JsonNode& node) {
    Rational x = read_exact(node);
    volume_ += bits_of(x);
    return x;
  }

  Vector<Rational> vector(const JsonNode& node) {
    return read_vector(node, [this](const JsonNode& item) { return exact(item); });
  }

  IntegralSegment segment(const JsonNode& node) {
    node.require(JsonNode::Kind::object, "an object");
    node.require_known_keys({"x", "y", "z", "w", "square", "pieces"});
    length_ = bits_ = 0;
    ++count_;
    IntegralSegment s{
        {polynomial(node.at("x")), polynomial(node.at("y")), polynomial(node.at("z"))},
        polynomial(node.at("w")),
        polynomial(node.at("square")),
        {}};
    if (s.weight(0) == 0) node.at("w").fail("the weight is 0 at t = 0");
    if (s.square.is_zero()) node.at("square").fail("the polynomial is 0");
    const Integer d = length_;
    const Integer a = bits_;
    if (count_ == 1) std::tie(first_length_, first_bits_) = std::tie(d, a);
    work_ += 3000 * d * d * d * Integer(1 + bits_ / 64) + 2 * d * d * a * a;
    s.pieces = read_list(node.at("pieces"), [this](const JsonNode& item) { return piece(item); });
    return s;
  }

  /// A curve by formulas, with so many derivatives. At the joints of several segments the models
  /// are constants.
  FormulaSegment formulas(const JsonNode& node, long derivatives, bool is_joined) {
    node.require_known_keys({"expressions", "pieces"});
    const JsonNode expressions = node.at("expressions");
    expressions.require(JsonNode::Kind::object, "an object");
    expressions.require_known_keys({"x", "y", "z", "from", "to"});
    const auto formula = [&](const char* key) { return read_formula(expressions.at(key), "s"); };
    const auto constant = [&](const char* key) { return read_formula(expressions.at(key), ""); };
    FormulaSegment s{
        {formula("x"), formula("y"), formula("z")}, constant("from"), constant("to"), {}};
    ++count_;
    DistinctSteps steps;
    for (const Formula* f : {&s.position[0], &s.position[1], &s.position[2]}) steps.insert(*f);
    const FormulaWork coordinates = work_of(steps);
    DistinctSteps of_ends;
    of_ends.insert(s.from);
    of_ends.insert(s.to);
    const FormulaWork ends = work_of(of_ends);
    const Integer series = coordinates.series + ends.series + 3;
    const Integer products =
        (derivatives + 1) * (derivatives + 2) / 2 * (coordinates.products + ends.products) + 20;
    const Integer steps_of_all(steps.steps().size() + of_ends.steps().size());
    if (count_ == 1) first_steps_ = steps_of_all;
    const auto models = [&](const Integer& n, const Integer& b) {
      const Integer x = n * b;
      const Integer product = 2000 + 1000 * n + x * sqrt(x) / 18;
      const Integer one = product + n * n * (300000 + b * b) / 7800 + 700 * n + 2000 + b * b / 10;
      work_ += series * one + products * product + steps_of_all * derivatives * (200 * n + 10000);
    };
    std::set<long> bits{0};  // of all pieces
    s.pieces = read_list(node.at("pieces"), [&](const JsonNode& item) {
      item.require(JsonNode::Kind::object, "an object");
      item.require_known_keys({"to", "order", "bits"});
      ModelPiece piece{exact(item.at("to")),
                       read_count(item.at("order"), 2, most_certificate_count),
                       read_count(item.at("bits"), 0, most_certificate_count)};
      models(piece.order, piece.bits + bits_of(piece.to));
      bits.insert(piece.bits);
      longest_ = std::max(longest_, piece.order);
      return piece;
    });
    for (int side = 0; is_joined && side < 2; ++side) models(1, *bits.rbegin());
    for (const long b : bits) work_ += 6 * Integer(b) * Integer(b);
    return s;
  }

  /// Precondition: all segments are read. There may be turns at the joints.
  Rational parameter(const JsonNode& node, const std::string& value, const std::string& radius,
                     bool has_turns) {
    Rational t = exact(node);
    const Integer of_t = Integer(bits_of(t)) * (1 + longest_);
    const Integer of_radius = bits_of(parse_rational(radius));
    const Integer of_value = bits_of(parse_rational(value)) + of_radius;
    work_ += of_t * of_t / 500 + of_value * of_value / 1000 + 1000 * Integer(1 + count_);
    if (has_turns && count_ > 1) work_ += (2 * count_ + 8) * of_radius * of_radius;
    return t;
  }

  /// Of a claim about t. Precondition: all segments are read.
  std::optional<Antisymmetry> symmetry(const JsonNode& claim, const Rational& t) {
    const auto node = claim.find("symmetry");
    if (!node) return std::nullopt;
    work_ += first_steps_ * 20000 + 5000 * first_length_ * first_length_ *
                                        (1 + (first_bits_ + first_length_ * bits_of(t)) / 64);
    if (node->string() == "mirror") return Antisymmetry{};
    const Rational shift = exact(*node);
    if (shift <= 0) node->fail("a shift is positive");
    return Antisymmetry{shift};
  }

  /// Precondition: all is read.
  Integer work() const { return work_ + volume_ * volume_ / 63000; }

 private:
  Polynomial polynomial(const JsonNode& node) {
    Polynomial p =
        read_coefficients(node, most_, [this](const JsonNode& item) { return exact(item); });
    const long bits = written_bits(p);
    volume_ += Integer(p.degree() + 1) * Integer(bits);
    length_ = std::max(length_, p.degree() + 1);
    bits_ = std::max(bits_, bits);
    return p;
  }

  GridPolynomial on_grid(const JsonNode& terms, const JsonNode& bits) {
    GridPolynomial p{{}, read_count(bits, 0, most_certificate_count)};
    p.terms = read_list(terms, [this](const JsonNode& item) {
      if (item.string().find('/') != std::string::npos)
        item.fail(fmt::format("\"{}\" is not an integer", abbreviated(item.string())));
      return Integer(numerator(exact(item)));
    });
    return p;
  }

  IntegralPiece piece(const JsonNode& node) {
    node.require(JsonNode::Kind::object, "an object");
    node.require_known_keys({"to", "root_bits", "root", "rate_bits", "rate"});
    IntegralPiece p{exact(node.at("to")), on_grid(node.at("root"), node.at("root_bits")),
                    on_grid(node.at("rate"), node.at("rate_bits"))};
    long bits = std::max(p.root.bits, p.rate.bits);
    for (const auto* grid : {&p.root, &p.rate})
      for (const Integer& x : grid->terms) bits = std::max(bits, bit_length(x));
    const long terms = static_cast<long>(p.root.terms.size() + p.rate.terms.size());
    const Integer k = 6 * length_ + terms;
    const Integer b = Integer(bits + 4 * bits_) + Integer(3 * length_) * bits_of(p.to);
    work_ += k * k * (b + 2000) / 40 + k * b * b / 2000;
    longest_ = std::max(longest_, static_cast<long>(p.rate.terms.size()));
    return p;
  }

  long most_;
  long length_ = 0;   ///< of the lists of the segment
  long bits_ = 0;     ///< of its coefficients
  long longest_ = 0;  ///< of the rates
  long count_ = 0;    ///< of segments
  // Of the first segment:
  Integer first_steps_ = 0;   ///< of its formulas
  Integer first_length_ = 0;  ///< of its lists
  Integer first_bits_ = 0;    ///< of its coefficients
  Integer volume_ = 0;
  Integer work_ = 0;
};

std::optional<Reference> read_frame_of_integral(const JsonNode& node) {
  const std::string& name = node.string();
  if (name == "none") return std::nullopt;
  for (const auto& [known, reference] : reference_names())
    if (name == known && reference != Reference::euler_rodrigues) return reference;
  node.fail(
      fmt::format("the frame is \"up\", \"frenet\" or \"none\", not \"{}\"", abbreviated(name)));
}

bool is_by_formulas(const JsonNode& segment) {
  return segment.is(JsonNode::Kind::object) && segment.find("expressions");
}

/// Why there is no such curve, or "".
std::string objection_to(const FormulaSegment& s) {
  const bool is_quotient = is_rational(s.position[0]) && is_rational(s.position[1]) &&
                           is_rational(s.position[2]) && is_rational(s.from) && is_rational(s.to);
  return is_quotient ? "these are rational functions, for which x, y, z and w are" : "";
}
std::string objection_to(const IntegralSegment& s) {
  for (const Polynomial& x : s.position)
    if (!(differentiate(x) * s.weight == x * differentiate(s.weight))) return "";
  return "the curve is a single point";
}

}  // namespace

NamedIntegralCertificate read_integral_certificate(const JsonNode& node, const CurveLimits& limits,
                                                   WorkLimit& limit) {
  NamedIntegralCertificate found;
  IntegralCertificate& c = found.certificate;
  c.frame = read_frame_of_integral(node.at("frame"));
  std::vector<std::string_view> keys{"phrame", "name", "frame", "segments", "claims"};
  if (c.frame == Reference::up) keys.emplace_back("up");
  node.require_known_keys(keys);
  if (const auto name = node.find("name")) found.name = name->string();
  IntegralReader read(limits);
  if (c.frame == Reference::up) c.up = read.vector(node.at("up"));
  const JsonNode segments = node.at("segments");
  const long derivatives = !c.frame ? 1 : c.frame == Reference::up ? 2 : 3;
  c.segments = read_list(segments, [&](const JsonNode& item) -> CertifiedSegment {
    if (is_by_formulas(item)) return read.formulas(item, derivatives, segments.size() > 1);
    return read.segment(item);
  });
  if (c.segments.empty()) segments.fail("a path has at least one segment");
  const std::string value = c.frame ? "theta" : "length";
  read_list(node.at("claims"), [&](const JsonNode& item) {
    std::vector<std::string_view> known{"t", value, "radius"};
    if (c.frame) known.emplace_back("symmetry");
    item.require_known_keys(known);
    const std::string number = read_decimal(item.at(value));
    const std::string radius = read_radius(item.at("radius"));
    const Rational t = read.parameter(item.at("t"), number, radius, c.frame == Reference::up);
    if (c.frame)
      c.angles.push_back({t, number, radius, {}, read.symmetry(item, t)});
    else
      c.lengths.push_back({t, number, radius});
    return 0;
  });
  limit.add(node, read.work());
  for (std::size_t k = 0; k < c.segments.size(); ++k) {
    const std::string objection =
        std::visit([](const auto& s) { return objection_to(s); }, c.segments[k]);
    if (!objection.empty()) segments.item(k).fail(objection);
  }
  return found;
}

IntegralCertificate with_canonical_formulas(IntegralCertificate c) {
  for (CertifiedSegment& segment : c.segments) {
    auto* formulas = std::get_if<FormulaSegment>(&segment);
    if (formulas == nullptr) continue;
    for (Formula* f : {&formulas->position[0], &formulas->position[1], &formulas->position[2],
                       &formulas->from, &formulas->to})
      *f = canonical(*f);
  }
  return c;
}

}  // namespace phrame
