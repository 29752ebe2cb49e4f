#include "phrame/io/read/certificate_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/io/read/integral_certificate.hpp"
#include "phrame/io/write/names.hpp"

namespace phrame::inline v0 {
namespace {

using Kind = JsonNode::Kind;

TurnCount read_turn(const JsonNode& node) {
  node.require_known_keys({"index", "signs"});
  const auto signs = read_list(node.at("signs"), [](const JsonNode& text) {
    if (text.string().find_first_not_of("+-0") != std::string::npos)
      text.fail(fmt::format("signs are +, - and 0, not \"{}\"", abbreviated(text.string())));
    return text.string();
  });
  if (signs.size() != 2) node.at("signs").fail("the signs at 0 and at t are wanted");
  return {read_count(node.at("index"), -most_certificate_count, most_certificate_count), signs[0],
          signs[1]};
}

AngleClaim read_claim(const JsonNode& node) {
  return {{}, read_decimal(node.at("theta")), read_radius(node.at("radius")), {}};
}

/// The answer to a question. Where it is yes the witness stands beside it, under `keys`.
bool read_answer(const JsonNode& node, std::vector<std::string_view> keys) {
  const bool answer = node.at("answer").boolean();
  if (!answer) keys.clear();
  keys.emplace_back("answer");
  node.require_known_keys(keys);
  return answer;
}

/// The curve of a certificate as it is written.
struct WrittenCurve {
  QuaternionPolynomial preimage;
  Polynomial numerator{1};  ///< n, of the multiplier n/d
  Vector<Rational> start{};
  /// Of a rational curve, r = X/W.
  struct Position {
    Polynomial denominator;  ///< d
    Vector<Polynomial> x;    ///< X
    Polynomial weight;       ///< W
  };
  std::optional<Position> position = {};

  /// deg f, if f is a polynomial.
  long multiplier_degree() const {
    if (!position) return numerator.degree();
    return std::max(
        0L, numerator.degree() + 2 * position->weight.degree() - position->denominator.degree());
  }
};

/// Precondition: the work of it is within the limits.
Curve curve_of(WrittenCurve written, const JsonNode& certificate) {
  auto& [preimage, n, start, position] = written;
  if (!position) return Curve(std::move(preimage), std::move(n), std::move(start));
  auto& [d, x, w] = *position;
  const auto [f, rest] = divide(n * w * w, d);
  if (!rest.is_zero()) certificate.at("position").fail("the multiplier times w^2 is no polynomial");
  std::optional<Curve> curve;
  try {
    curve = Curve::quotient(std::move(preimage), f, std::move(x), std::move(w));
  } catch (const DomainError& error) {
    certificate.at("position").fail(error.what());
  }
  if (curve->start() != start) certificate.at("position").fail("it does not begin at the start");
  return *std::move(curve);
}

/// Reads what follows the curve, and adds up the work of checking it, in units of
/// docs/certificate.md.
class CertificateReader {
 public:
  /// The degrees of the curve say how long the other lists may be.
  CertificateReader(const JsonNode& certificate, const CurveLimits& limits)
      : most_(limits.max_degree + 1) {
    const JsonNode curve = certificate.at("curve");
    curve.require_known_keys(
        {"phrame", "name", "note", "basis", "start", "preimage", "multiplier"});
    if (const JsonNode format = curve.at("phrame"); format.string() != "curve/1")
      format.fail("the format is \"curve/1\"");
    for (const char* remark : {"name", "note"})
      if (const auto text = curve.find(remark)) text->string();
    if (const auto name = curve.find("name")) name_ = name->string();
    if (const JsonNode basis = curve.at("basis"); basis.string() != "power")
      basis.fail(fmt::format("the basis is \"power\", not \"{}\"", abbreviated(basis.string())));
    if (const auto point = curve.find("start")) curve_.start = vector(*point);
    std::size_t m = 0;
    const JsonNode preimage = curve.at("preimage");
    preimage.require_known_keys({"u", "v", "p", "q"});
    const auto part = [&](const JsonNode& list, std::size_t& longest) {
      Polynomial p = polynomial(list);
      if (list.size() == 0) list.fail("the list of coefficients is empty");
      longest = std::max(longest, list.size() - 1);
      bits_ = std::max(bits_, written_bits(p));
      return p;
    };
    curve_.preimage = {part(preimage.at("u"), m), part(preimage.at("v"), m),
                       part(preimage.at("p"), m), part(preimage.at("q"), m)};
    if (is_zero(curve_.preimage))
      preimage.fail("the preimage is zero, so the curve is a single point");
    std::size_t f = 0;
    long degree = 0;
    const auto multiplier = curve.find("multiplier");
    if (multiplier && multiplier->is(Kind::object)) {
      degree = rational_multiplier(*multiplier, certificate.at("position"));
      f = static_cast<std::size_t>(curve_.multiplier_degree() + curve_.position->weight.degree());
    } else {
      if (multiplier) curve_.numerator = part(*multiplier, f);
      degree = 2 * phrame::degree(curve_.preimage) + 1 + curve_.numerator.degree();
    }
    if (curve_.numerator.is_zero())
      curve.fail("the multiplier is zero, so the curve is a single point");
    if (degree > limits.max_degree)
      curve.fail(fmt::format("the curve has degree {}, the limit is {}; --max-degree raises it",
                             degree, limits.max_degree));
    longest_ = static_cast<long>(4 * m + 2 * f + 2);
    most_ = longest_ + 1;
  }

  const WrittenCurve& curve() const { return curve_; }
  /// @{ D and a of docs/certificate.md.
  long longest() const { return longest_; }
  long bits() const { return bits_; }
  /// @}
  const std::string& name() const { return name_; }

  Integer integer(const JsonNode& node) {
    const Rational x = exact(node);
    if (node.text().find('/') != std::string::npos) node.fail(as_written(x) + " is not an integer");
    return Integer(numerator(x));
  }

  Integer integer(const JsonNode& node, const Integer& least) {
    Integer n = integer(node);
    if (n < least) node.fail(fmt::format("{} is less than {}", abbreviated(n.str()), least.str()));
    return n;
  }

  Rational exact(const JsonNode& node) {
    Rational x = read_exact(node);
    volume_ += bits_of(x);
    return x;
  }

  Vector<Rational> vector(const JsonNode& node) {
    return read_vector(node, [this](const JsonNode& item) { return exact(item); });
  }

  Polynomial polynomial(const JsonNode& node) {
    Polynomial p =
        read_coefficients(node, most_, [this](const JsonNode& item) { return exact(item); });
    volume_ += Integer(p.degree() + 1) * Integer(written_bits(p));
    return p;
  }

  Polynomial nonzero(const JsonNode& node) {
    Polynomial p = polynomial(node);
    if (p.is_zero()) node.fail("the polynomial is 0");
    return p;
  }

  GaussianPolynomial gaussian(const JsonNode& node) {
    node.require_known_keys({"re", "im"});
    return {polynomial(node.at("re")), polynomial(node.at("im"))};
  }

  CertifiedLogs logs(const JsonNode& node, long bits) {
    node.require_known_keys({"index", "residue", "roots"});
    CertifiedLogs sum{polynomial(node.at("index")), polynomial(node.at("residue")), {}};
    if (sum.index.is_constant()) node.at("index").fail("the index is constant");
    sum.roots = read_list(node.at("roots"), [this](const JsonNode& item) { return disc(item); });
    const Integer k = sum.index.degree() + 1;
    const Integer b = std::max(written_bits(sum.index), written_bits(sum.residue));
    const Integer n = static_cast<long>(sum.roots.size());
    work_ += n * k * k * Integer(b + bits + 64) / 8 + k * k * k * b * b / 63000;
    discs_ += static_cast<long>(sum.roots.size());
    ++sums_;
    return sum;
  }

  /// Precondition: all logs are read.
  AngleClaim claim(const JsonNode& node, bool is_frenet) {
    if (is_frenet)
      node.require_known_keys({"t", "theta", "radius", "turn"});
    else
      node.require_known_keys({"t", "theta", "radius"});
    AngleClaim claim = read_claim(node);
    claim.t = exact(node.at("t"));
    if (is_frenet) claim.turn = read_turn(node.at("turn"));
    const Integer k = bits_of(parse_rational(claim.radius));
    const Integer theta = bits_of(parse_rational(claim.theta));
    const Integer t = longest_ * bits_of(claim.t);
    work_ += Integer(discs_ + 8) * k * k + theta * theta / 1000 +
             t * t * Integer(10 + (is_frenet ? longest_ : 0)) / 1000;
    return claim;
  }

  std::vector<StatedPoint> points(const JsonNode& node) {
    auto list = read_list(node, [this](const JsonNode& item) { return point(item); });
    struct Span {
      Integer length;
      Rational lower;
      Rational upper;
    };
    std::vector<Span> spans;
    for (const StatedPoint& p : list) {
      const Rational& a = *p.interval.lower;
      const Rational& b = *p.interval.upper;
      Span span{p.polynomial.degree() + 1, a == b ? a - 1 : a, a == b ? b + 1 : b};
      const Integer bits = bits_of(span.lower) + bits_of(span.upper);
      work_ += span.length * span.length * span.length * bits * bits / 2000;
      for (const Span& other : spans)
        if (std::max(span.lower, other.lower) < std::min(span.upper, other.upper))
          work_ += 200 * span.length * other.length;
      spans.push_back(std::move(span));
    }
    return list;
  }

  StatedDecisions decisions(const JsonNode& node);

  /// Precondition: all is read.
  Integer work(bool is_frenet) const {
    const Integer d = longest_;
    const Integer a = bits_;
    return work_ + 50 * d * d * d * Integer(1 + bits_ / 64) + d * d * a * a / 2 +
           volume_ * volume_ * Integer(sums_ + 1) / 63000 +
           (is_frenet ? Integer(d * d * d * d * a * a / 6000) : Integer(0));
  }

 private:
  /// n/d and X/W; the degree of the curve.
  long rational_multiplier(const JsonNode& multiplier, const JsonNode& position) {
    multiplier.require_known_keys({"numerator", "denominator"});
    position.require_known_keys({"x", "y", "z", "w"});
    long degree = 0;
    const auto measured = [&](Polynomial p) {
      bits_ = std::max(bits_, written_bits(p));
      return p;
    };
    const auto part = [&](const JsonNode& list) {
      Polynomial p = measured(polynomial(list));
      degree = std::max(degree, p.degree());
      return p;
    };
    curve_.numerator = measured(polynomial(multiplier.at("numerator")));
    Polynomial denominator = measured(nonzero(multiplier.at("denominator")));
    const Vector<Polynomial> x{part(position.at("x")), part(position.at("y")),
                               part(position.at("z"))};
    const JsonNode w = position.at("w");
    Polynomial weight = part(w);
    if (weight.is_constant() || weight(0) == 0)
      w.fail("the weight is to be no constant, and not 0 at t = 0");
    curve_.position = {std::move(denominator), x, std::move(weight)};
    return degree;
  }

  GaussianInteger grid_point(const JsonNode& node) {
    const auto parts = read_list(node, [this](const JsonNode& part) { return integer(part); });
    if (parts.size() != 2) node.fail(fmt::format("2 numbers are wanted, not {}", parts.size()));
    return {parts[0], parts[1]};
  }

  RootDisc disc(const JsonNode& node) {
    node.require_known_keys({"center", "radius", "residue", "residue_radius"});
    return {grid_point(node.at("center")), integer(node.at("radius"), 0),
            grid_point(node.at("residue")), integer(node.at("residue_radius"), 0)};
  }

  StatedPoint point(const JsonNode& node) {
    node.require_known_keys({"t", "order"});
    const long order = read_count(node.at("order"), 1, most_certificate_count);
    const JsonNode t = node.at("t");
    if (!t.is(Kind::object)) {
      const Rational at = exact(t);
      return {primitive_part(Polynomial{-at, 1}), closed_interval(at, at), order};
    }
    t.require_known_keys({"polynomial", "interval"});
    Polynomial w = polynomial(t.at("polynomial"));
    if (w.is_constant()) t.at("polynomial").fail("the polynomial is constant");
    const auto ends =
        read_list(t.at("interval"), [this](const JsonNode& item) { return exact(item); });
    if (ends.size() != 2 || ends[0] >= ends[1])
      t.at("interval").fail("an interval has two ends, the first the lower one");
    return {std::move(w), open_interval(ends[0], ends[1]), order};
  }

  std::string name_;
  WrittenCurve curve_;
  long most_;         ///< coefficients that a list may have
  long longest_ = 0;  ///< D of docs/certificate.md
  long bits_ = 1;     ///< of the curve
  long discs_ = 0;
  long sums_ = 0;
  Integer volume_ = 0;
  Integer work_ = 0;
};

StatedDecisions CertificateReader::decisions(const JsonNode& node) {
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
  StatedDecisions d{regular.at("answer").boolean(),
                    points(regular.at("cusps")),
                    inflections.at("answer").boolean(),
                    points(inflections.at("points")),
                    {},
                    {},
                    {},
                    {},
                    primitive.at("answer").boolean(),
                    polynomial(primitive.at("content")),
                    read_answer(node.at("erf_is_rmf"), {}),
                    {},
                    monotone.at("answer").boolean(),
                    points(monotone.at("zeros_of_h")),
                    points(monotone.at("extrema"))};
  if (const JsonNode line = node.at("line"); read_answer(line, {"direction"}))
    d.line = vector(line.at("direction"));
  if (const JsonNode planar = node.at("planar"); read_answer(planar, {"normal"}))
    d.normal = vector(planar.at("normal"));
  if (const JsonNode helix = node.at("helical"); read_answer(helix, {"axis", "cos_squared"}))
    d.helix = {vector(helix.at("axis")), exact(helix.at("cos_squared"))};
  if (const JsonNode square = node.at("double_ph"); read_answer(square, {"constant", "omega"}))
    d.double_ph = {exact(square.at("constant")), polynomial(square.at("omega"))};
  if (const JsonNode rrmf = node.at("rrmf"); read_answer(rrmf, {"w"}))
    d.rational_frame = gaussian(rrmf.at("w"));
  return d;
}

Reference read_frame(const JsonNode& node) {
  for (const auto& [name, reference] : reference_names())
    if (node.string() == name && reference != Reference::up) return reference;
  node.fail(
      fmt::format("the frame is \"erf\" or \"frenet\", not \"{}\"", abbreviated(node.string())));
}

/// What the curves of a path say of the work on it as a whole.
struct CurveSize {
  Integer longest;  ///< D of docs/certificate.md
  Integer bits;     ///< a
};

NamedCertificate read_of_curve(const JsonNode& node, const CurveLimits& limits, WorkLimit& limit,
                               CurveSize* size = nullptr) {
  if (const JsonNode format = node.at("phrame"); format.string() != "certificate/1")
    format.fail(
        fmt::format("the format is \"certificate/1\", not \"{}\"", abbreviated(format.string())));
  const Reference reference = read_frame(node.at("frame"));
  const bool is_frenet = reference == Reference::frenet;
  std::vector<std::string_view> keys{"phrame", "curve",    "frame", "hodograph", "sigma",
                                     "h",      "g",        "rate",  "bits",      "antiderivative",
                                     "claims", "decisions"};
  if (is_frenet) keys.emplace_back("bend");
  CertificateReader read(node, limits);
  if (read.curve().position) keys.emplace_back("position");
  node.require_known_keys(keys);
  const JsonNode rate = node.at("rate");
  rate.require_known_keys({"numerator", "denominator", "common", "coprime_modulo"});
  const JsonNode antiderivative = node.at("antiderivative");
  antiderivative.require_known_keys({"rational", "logs"});
  const JsonNode rational = antiderivative.at("rational");
  rational.require_known_keys({"numerator", "denominator"});
  const auto polynomial = [&](const JsonNode& item) { return read.polynomial(item); };
  const auto hodograph = read_list(node.at("hodograph"), polynomial);
  if (hodograph.size() != 3)
    node.at("hodograph").fail(fmt::format("3 polynomials are wanted, not {}", hodograph.size()));
  const long bits = read_count(node.at("bits"), 0, most_certificate_count);
  // In a list the order of evaluation is that of its items: the logs before the claims.
  Certificate c{Curve({{1}, {}, {}, {}}),  // until it is known what it takes
                reference,
                {hodograph[0], hodograph[1], hodograph[2]},
                polynomial(node.at("sigma")),
                polynomial(node.at("h")),
                read.gaussian(node.at("g")),
                {polynomial(rate.at("numerator")), polynomial(rate.at("denominator")),
                 polynomial(rate.at("common")), read.integer(rate.at("coprime_modulo"), 2)},
                {polynomial(rational.at("numerator")), read.nonzero(rational.at("denominator"))},
                read_list(antiderivative.at("logs"),
                          [&](const JsonNode& item) { return read.logs(item, bits); }),
                bits,
                {},
                read_list(node.at("claims"),
                          [&](const JsonNode& item) { return read.claim(item, is_frenet); }),
                read.decisions(node.at("decisions"))};
  if (is_frenet) {
    const JsonNode bend = node.at("bend");
    bend.require_known_keys({"polynomial", "content"});
    c.bend = {read.gaussian(bend.at("polynomial")), polynomial(bend.at("content"))};
  }
  limit.add(node, read.work(is_frenet));
  if (size != nullptr) *size = {read.longest(), read.bits()};
  c.curve = curve_of(read.curve(), node);
  return {read.name(), std::move(c)};
}

/// A claim about a path; the sum of it takes its part of the work.
AngleClaim read_path_claim(const JsonNode& node, WorkLimit& limit) {
  node.require_known_keys({"t", "theta", "radius"});
  AngleClaim claim = read_claim(node);
  claim.t = read_exact(node.at("t"));
  const Integer bits = bits_of(claim.t) + bits_of(parse_rational(claim.theta)) +
                       bits_of(parse_rational(claim.radius));
  limit.add(node, bits * bits / 1000 + 1000);
  return claim;
}

StatedArc read_arc(const JsonNode& node) {
  node.require_known_keys({"segment", "interval"});
  const auto ends = read_list(node.at("interval"), read_exact);
  if (ends.size() != 2) node.at("interval").fail("the two ends are wanted");
  return {read_count(node.at("segment"), 0, most_certificate_count), ends[0], ends[1]};
}

StatedCrossing read_crossing(const JsonNode& node) {
  node.require_known_keys({"first", "second", "sign"});
  const long sign = read_count(node.at("sign"), -1, 1);
  if (sign == 0) node.at("sign").fail("1 or -1 is wanted");
  return {read_arc(node.at("first")), read_arc(node.at("second")), static_cast<int>(sign)};
}

WritheClaim read_writhe(const JsonNode& node) {
  node.require_known_keys({"projection", "crossings", "value", "radius"});
  const auto v = read_vector(node.at("projection"), read_exact);
  if (v == Vector<Rational>{}) node.at("projection").fail("the vector is 0");
  return {v, read_list(node.at("crossings"), read_crossing), read_decimal(node.at("value")),
          read_radius(node.at("radius"))};
}

/// What is said of a closed path, and the work that it is but for the search for crossings.
ClosedClaims read_closed(const JsonNode& node, const std::vector<CurveSize>& sizes,
                         WorkLimit& limit) {
  node.require_known_keys({"holonomy", "writhe"});
  ClosedClaims closed;
  const auto add_number = [&](const std::string& value, const std::string& radius) {
    const Integer e = bits_of(parse_rational(radius));
    const Integer b = bits_of(parse_rational(value));
    limit.add(node, 10 * e * e * Integer(sizes.size()) + b * b / 1000);
  };
  if (const auto holonomy = node.find("holonomy")) {
    holonomy->require_known_keys({"turns", "value", "radius"});
    closed.holonomy = {
        read_count(holonomy->at("turns"), -most_certificate_count, most_certificate_count),
        read_decimal(holonomy->at("value")), read_radius(holonomy->at("radius"))};
    add_number(closed.holonomy->value, closed.holonomy->radius);
  }
  if (const auto writhe = node.find("writhe")) {
    closed.writhe = read_writhe(*writhe);
    add_number(closed.writhe->value, closed.writhe->radius);
    const auto& [x, y, z] = closed.writhe->projection;
    Integer most = 0;
    for (const auto& [d, a] : sizes) {
      most = std::max(most, d);
      const Integer bits = a + Integer(bits_of(x) + bits_of(y) + bits_of(z));
      limit.add(node, d * d * d * d * bits * bits / 6000);
    }
    for (const StatedCrossing& crossing : closed.writhe->crossings)
      for (const StatedArc* arc : {&crossing.first, &crossing.second}) {
        const Integer bits = bits_of(arc->lower) + bits_of(arc->upper);
        limit.add(node, most * most * bits * bits / 100);
      }
  }
  return closed;
}

NamedPathCertificate read_of_path(const JsonNode& node, const CurveLimits& limits,
                                  WorkLimit& limit) {
  node.require_known_keys({"phrame", "name", "segments", "claims", "closed"});
  NamedPathCertificate found;
  if (const auto name = node.find("name")) found.name = name->string();
  const JsonNode list = node.at("segments");
  list.require(Kind::array, "an array");
  if (list.size() == 0) list.fail("a path has at least one segment");
  std::vector<CurveSize> sizes;
  for (std::size_t k = 0; k < list.size(); ++k) {
    const JsonNode item = list.item(k);
    item.require(Kind::object, "an object");
    Certificate segment = read_of_curve(item, limits, limit, &sizes.emplace_back()).certificate;
    if (segment.reference != Reference::euler_rodrigues)
      item.at("frame").fail("the frame of segments is \"erf\"");
    found.certificate.segments.push_back(std::move(segment));
  }
  found.certificate.claims = read_list(
      node.at("claims"), [&](const JsonNode& item) { return read_path_claim(item, limit); });
  if (const auto closed = node.find("closed"))
    found.certificate.closed = read_closed(*closed, sizes, limit);
  return found;
}

}  // namespace

NamedAnyCertificate read_any_certificate(std::string_view text, const CertificateLimits& limits) {
  const JsonValue document = parse_json_file(text, "certificate");
  const JsonNode node(document);
  node.require(Kind::object, "an object");
  WorkLimit limit(text.size(), limits.is_limited);
  const std::string format = node.at("phrame").string();
  if (format == "path-certificate/1") return read_of_path(node, limits.curve, limit);
  if (format == "integral-certificate/1")
    return read_integral_certificate(node, limits.curve, limit);
  return read_of_curve(node, limits.curve, limit);
}

NamedCertificate read_certificate(std::string_view text, const CertificateLimits& limits) {
  auto found = read_any_certificate(text, limits);
  if (auto* of_curve = std::get_if<NamedCertificate>(&found)) return std::move(*of_curve);
  throw InputError("/phrame", "this is a certificate of a path; one of a curve is wanted");
}

}  // namespace phrame
