#pragma once
#include <string>
#include <string_view>

#include "phrame/algebra/angle.hpp"
#include "phrame/algebra/bivariate.hpp"
#include "phrame/algebra/gaussian_polynomial.hpp"
#include "phrame/algebra/surd.hpp"
#include "phrame/export.hpp"
#include "phrame/ph/along/frame_angle.hpp"

namespace phrame::inline v0 {

/// How formulas are written: for a screen, or for a paper.
enum class Notation { unicode, latex };

/// "37t⁴ − 72t³ + 1/2", highest power first; "0" for 0.
PHRAME_API std::string formatted(const Polynomial& p, Notation notation,
                                 std::string_view variable = "t");
/// "4t(t − 1)", factored over ℚ. Cost: the factorization.
PHRAME_API std::string formatted_factors(const Polynomial& p, Notation notation,
                                         std::string_view variable = "t");
/// "(4t² − 24t + 12) + (2t² + 14t − 6)i".
PHRAME_API std::string formatted(const GaussianPolynomial& p, Notation notation,
                                 std::string_view variable = "t");
/// "t² − t + (2x + 1)", by powers of t: coefficients with an x stand in parentheses.
PHRAME_API std::string formatted(const Bivariate& v, Notation notation,
                                 std::string_view variable = "t", std::string_view index = "x");
/// "3/7", `\frac{3}{7}`; a minus sign is "−" in Unicode.
PHRAME_API std::string formatted(const Rational& x, Notation notation);
/// "(…)", in LaTeX as high as what it holds.
PHRAME_API std::string in_parentheses(std::string_view text, Notation notation);
/// c times a number with a name: "√2", "−3π/4".
PHRAME_API std::string formatted_multiple(const Rational& c, std::string_view name,
                                          Notation notation);
/// "x + C", and "C" where the sum is "0"; without a constant the sum.
PHRAME_API std::string with_constant(const std::string& sum, std::string_view constant);
/// A decimal, "1.5e-12", as `1.5 \cdot 10^{-12}`.
PHRAME_API std::string latex_decimal(const std::string& decimal);
/// "1/3", "−3π/4", "1/3 + π/4".
PHRAME_API std::string formatted(const Angle& angle, Notation notation);
/// "π/4", "atan2(4, 3)", "1/3 + atan2(−1, 2)".
PHRAME_API std::string formatted(const FrameAngle& angle, Notation notation);
/// "1/2 + 3√2/8".
PHRAME_API std::string formatted(const Surd& x, Notation notation);
/// "t² − √2·t + (1 + √2)", highest power first.
PHRAME_API std::string formatted(const SurdPolynomial& p, Notation notation,
                                 std::string_view variable = "t");

}  // namespace phrame
