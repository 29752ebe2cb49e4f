#pragma once
#include <doctest/doctest.h>

#include <string>

#include "phrame/io/read/formula.hpp"
#include "phrame/ph/curve/expression_curve.hpp"

namespace phrame::inline v0::test {

/// The curve with these components, s from `from` to `to`.
inline ExpressionCurve expression_curve(const Vector<const char*>& r, const char* from,
                                        const char* to) {
  const auto read = [](const char* text) { return parse_formula(text, "s").value; };
  return ExpressionCurve({read(r[0]), read(r[1]), read(r[2])}, read(from), read(to));
}

/// On the torus (2 + cos φ)(cos ψ, sin ψ), sin φ: φ goes q times around while ψ goes p times.
inline ExpressionCurve torus_knot(long p, long q) {
  const std::string tube = "(2 + cos(" + std::to_string(q) + "*s))";
  const std::string turn = "(" + std::to_string(p) + "*s)";
  const std::string x = tube + "*cos" + turn;
  const std::string y = tube + "*sin" + turn;
  const std::string z = "sin(" + std::to_string(q) + "*s)";
  return expression_curve({x.c_str(), y.c_str(), z.c_str()}, "0", "2*pi");
}

}  // namespace phrame::test
