#include "phrame/integrate/endpoint.hpp"

#include "phrame/algebra/error.hpp"

namespace phrame::inline v0 {
namespace {

/// −1, 0, 1 for −∞, a finite end, ∞.
int region(const Endpoint& end) {
  const auto* infinity = std::get_if<Infinity>(&end);
  return infinity == nullptr ? 0 : *infinity == Infinity::positive ? 1 : -1;
}

}  // namespace

std::optional<RealAlgebraic> finite(const Endpoint& end) {
  if (const auto* r = std::get_if<Rational>(&end)) return RealAlgebraic(*r);
  if (const auto* a = std::get_if<RealAlgebraic>(&end)) return *a;
  return std::nullopt;
}

RealBall enclose(const Endpoint& end, long bits) {
  const auto x = finite(end);
  if (!x) throw DomainError("enclose: an infinite end");
  return enclose(*x, bits);
}

long bits_of(const Endpoint& end) {
  const auto x = finite(end);
  return x ? bits_of(*x) : 0;
}

std::strong_ordering compare(const Endpoint& a, const Endpoint& b) {
  if (region(a) != region(b) || region(a) != 0) return region(a) <=> region(b);
  return compare(*finite(a), *finite(b));
}

}  // namespace phrame
