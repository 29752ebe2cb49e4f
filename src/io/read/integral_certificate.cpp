#include "phrame/io/read/integral_certificate.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/real.hpp"
#include "phrame/io/write/names.hpp"

namespace phrame::inline v0 {
namespace {

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
    work_ += 3000 * d * d * d * Integer(1 + bits_ / 64) + 2 * d * d * a * a;
    s.pieces = read_list(node.at("pieces"), [this](const JsonNode& item) { return piece(item); });
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

/// Is r a point?
bool is_point(const IntegralSegment& s) {
  for (const Polynomial& x : s.position)
    if (!(differentiate(x) * s.weight == x * differentiate(s.weight))) return false;
  return true;
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
  c.segments = read_list(segments, [&](const JsonNode& item) { return read.segment(item); });
  if (c.segments.empty()) segments.fail("a path has at least one segment");
  const std::string value = c.frame ? "theta" : "length";
  read_list(node.at("claims"), [&](const JsonNode& item) {
    item.require_known_keys({"t", value, "radius"});
    const std::string number = read_decimal(item.at(value));
    const std::string radius = read_radius(item.at("radius"));
    const Rational t = read.parameter(item.at("t"), number, radius, c.frame == Reference::up);
    if (c.frame)
      c.angles.push_back({t, number, radius, {}});
    else
      c.lengths.push_back({t, number, radius});
    return 0;
  });
  limit.add(node, read.work());
  for (std::size_t k = 0; k < c.segments.size(); ++k)
    if (is_point(c.segments[k])) segments.item(k).fail("the curve is a single point");
  return found;
}

}  // namespace phrame
