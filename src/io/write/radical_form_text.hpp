#pragma once
#include "phrame/integrate/radicals.hpp"
#include "phrame/io/write/radical_text.hpp"

namespace phrame::inline v0 {

/// One term a line. Logarithms over rational and quadratic roots are written out, the others as
/// Σ c(z)·log(t − z) with c and a list of the roots; "0" for 0. `variable` is that of F, `root`
/// another.
std::string to_text(const RadicalForm& F, std::string_view variable = "t",
                    std::string_view root = "z");
/// The same on one line, without dollar signs; the roots stand at the end, after the constant.
std::string to_latex(const RadicalForm& F, std::string_view variable = "t",
                     std::string_view root = "z", std::string_view constant = "");
/// The logarithms on one line for a computer-algebra system, all of them written out and complex:
/// log(t − z) over real roots too, so that the sum is real up to a constant; "0" for none.
std::string to_cas(const std::vector<RadicalSum>& logs, const RadicalNotation& notation,
                   std::string_view variable = "t");

}  // namespace phrame
