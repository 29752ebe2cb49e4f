// Any bytes: a certificate of any kind that `verify` decides, or an InputError of one line. What is
// read is written to the same certificate, and of one curve a claim that is proved is true: the
// angle is computed again.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <variant>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/certificate_file.hpp"
#include "phrame/io/write/certificate.hpp"
#include "phrame/ph/proof/path_certificate.hpp"
#include "phrame/ph/proof/verify.hpp"
#include "phrame/ph/proof/verify_integral.hpp"

namespace {

using namespace phrame;

long size(const Rational& x) { return bit_length(numerator(x)) + bit_length(denominator(x)); }

long size(const Polynomial& p) {
  long bits = 0;
  for (const Rational& c : p.coefficients()) bits += size(c);
  return bits;
}

/// Quick enough to verify.
bool is_small(const Certificate& c) {
  long bits = size(c.curve.multiplier()) + 64 * c.curve.multiplier().degree();
  for (const Polynomial* p :
       {&c.curve.preimage().u, &c.curve.preimage().v, &c.curve.preimage().p, &c.curve.preimage().q,
        &c.curve.weight(), &c.rational.numerator(), &c.decisions.content})
    bits += size(*p);
  for (const CertifiedLogs& sum : c.logs)
    bits += size(sum.index) + size(sum.residue) + 64 * (sum.index.degree() + sum.residue.degree());
  for (const auto* points : {&c.decisions.cusps, &c.decisions.inflections, &c.decisions.zeros_of_h,
                             &c.decisions.extrema})
    for (const StatedPoint& point : *points)
      bits += 64 * point.polynomial.degree() + size(point.polynomial);
  for (const AngleClaim& claim : c.claims) {
    const Rational radius = parse_rational(claim.radius);
    if (radius != 0 && size(radius) > 300) return false;
    bits += 100 * size(claim.t);
  }
  return bits < 8000 && c.bits < 1000 && c.claims.size() < 4;
}

bool is_small(const PathCertificate& c) {
  return c.segments.size() < 5 && !c.closed &&
         std::ranges::all_of(c.segments, [](const Certificate& part) { return is_small(part); });
}

bool is_small(const IntegralSegment& s) {
  long bits = size(s.weight) + size(s.square);
  for (const Polynomial& x : s.position) bits += size(x);
  for (const IntegralPiece& piece : s.pieces) {
    bits += piece.root.bits + piece.rate.bits + size(piece.to);
    for (const auto* list : {&piece.root.terms, &piece.rate.terms})
      for (const Integer& n : *list) bits += bit_length(n) + 64;
  }
  return bits < 50000;
}

bool is_small(const FormulaSegment& s) {
  long work = 0;
  for (const ModelPiece& piece : s.pieces)
    work += piece.order > 50 || piece.bits > 300 ? 1000 : piece.order;
  return work < 1000;
}

bool is_small(const IntegralCertificate& c) {
  const auto is_short = [](const Rational& x) { return size(x) < 300; };
  return c.segments.size() < 5 &&
         std::ranges::all_of(c.segments,
                             [](const auto& part) {
                               return std::visit([](const auto& s) { return is_small(s); }, part);
                             }) &&
         std::ranges::all_of(c.angles, is_short, &AngleClaim::t) &&
         std::ranges::all_of(c.lengths, is_short, &LengthClaim::t);
}

template <class C>
void check(const C& c) {
  const NamedAnyCertificate again = read_any_certificate(write_certificate(c, ""));
  const bool is_same = std::visit(
      [&](const auto& named) {
        if constexpr (requires { named.certificate == c; }) return named.certificate == c;
        return false;
      },
      again);
  if (!is_same) std::abort();
  if (!is_small(c)) return;
  for (const Statement& statement : verify(c))
    if (statement.objection.find('\n') != std::string::npos) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const NamedAnyCertificate read =
        read_any_certificate({reinterpret_cast<const char*>(data), size}, {.curve = {9}});
    std::visit([](const auto& named) { check(named.certificate); }, read);
    const auto* single = std::get_if<NamedCertificate>(&read);
    if (single == nullptr || !is_small(single->certificate)) return 0;
    const Certificate& c = single->certificate;
    RmfAngle angle(c.curve, Reference::euler_rodrigues);
    if (c.reference == Reference::frenet) return 0;
    for (std::size_t k = 0; k < c.claims.size(); ++k) {
      const auto& [t, theta, radius, turn] = c.claims[k];
      Certificate one = c;
      one.claims = {c.claims[k]};
      one.logs.clear();
      const auto list = verify(one);
      if (std::ranges::none_of(list, [](const Statement& statement) {
            return std::holds_alternative<AngleClaim>(statement.what) && statement.is_proved();
          }))
        continue;
      const RealBall truth = angle.enclose(t, 400);
      const Rational value = parse_rational(theta);
      if (truth.lower() > value + parse_rational(radius) ||
          truth.upper() < value - parse_rational(radius))
        std::abort();
    }
  } catch (const InputError& error) {
    if (std::string_view(error.what()).find('\n') != std::string_view::npos) std::abort();
  } catch (const DomainError&) {  // the Frenet frame of a line
  }
  return 0;
}
