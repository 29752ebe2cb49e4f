#include "phrame/io/write/prose.hpp"

#include <doctest/doctest.h>

using namespace phrame;
using enum Notation;

TEST_CASE("prose: signs of formulas are commands in LaTeX, and stay what they are in Unicode") {
  constexpr auto words = "length $∫₀¹ |f|σ\\, dt$, $\\cos²ψ = 1/2$ and $T_\\text{ERF}$";
  CHECK(prose(words, unicode) == "length ∫₀¹ |f|σ dt, cos²ψ = 1/2 and T_ERF");
  CHECK(prose(words, latex) ==
        "length $\\int_0^1 |f|\\sigma\\, dt$, $\\cos^2\\psi = 1/2$ and $T_\\text{ERF}$");
  CHECK(prose("$(r′ × r″)·r‴$, $w_{0}$", unicode) == "(r′ × r″)·r‴, w0");
  CHECK(prose("$(r′ × r″)·r‴$, $w_{0}$", latex) == "$(r' \\times r'')\\cdot r'''$, $w_{0}$");
  CHECK(prose("$A i A*$, $Ω₁ − Ω̄₁$", latex) == "$A i A^*$, $\\Omega_1 - \\bar\\Omega_1$");
}

TEST_CASE("prose: the name of a command ends where no letter follows") {
  CHECK(prose("$σt + πi·√2$", latex) == "$\\sigma t + \\pi i\\cdot\\sqrt2$");
}

TEST_CASE("prose: a sign among words becomes a formula, and what LaTeX would read is escaped") {
  CHECK(prose("κ is not rational, ρ < 0", latex) == "$\\kappa$ is not rational, $\\rho$ $<$ 0");
  CHECK(prose("100% of A_1 & {Euler–Rodrigues} \\x", latex) ==
        "100\\% of A\\_1 \\& \\{Euler--Rodrigues\\} \\textbackslash{}x");
  CHECK(prose("κ < 0, {A_1} \\x", unicode) == "κ < 0, {A_1} \\x");
}

TEST_CASE("prose: a formula that is LaTeX already stays as it is, and goes on after a relation") {
  const std::string fraction = formula("\\frac{1}{2}t^{2}", latex);
  CHECK(fraction == "$\\frac{1}{2}t^{2}$");
  CHECK(prose("yes: " + fraction, latex) == "yes: $\\frac{1}{2}t^{2}$");
  CHECK(prose("$ω =$ " + fraction, latex) == "$\\omega = \\frac{1}{2}t^{2}$");
  CHECK(prose("$γ ≈$ $0.5$, $γ$ $t$", latex) == "$\\gamma \\approx 0.5$, $\\gamma$ $t$");
  CHECK(formula("t²", unicode) == "t²");
  CHECK(prose("$ω =$ t²", unicode) == "ω = t²");
}
