#include "phrame/integrate/gaussian_logs.hpp"

#include <optional>

namespace phrame {
namespace {

struct Residue {
  Rational re;
  Rational im;  ///< ≥ 0
};

/// A root of q in ℚ(i), for irreducible q; no value where there is none.
std::optional<Residue> gaussian_root(const Polynomial& q) {
  const Rational lead = q.leading_coefficient();
  if (q.degree() == 1) return Residue{-q.coefficient(0) / lead, 0};
  if (q.degree() != 2) return std::nullopt;
  const Rational re = -q.coefficient(1) / (2 * lead);
  const auto im = square_root(q.coefficient(0) / lead - re * re);
  if (!im) return std::nullopt;
  return Residue{re, *im};
}

/// v(α, t) for deg v < 2 in x.
GaussianPolynomial argument_at(const Bivariate& v, const Residue& alpha) {
  std::vector<Rational> re;
  std::vector<Rational> im;
  for (const Polynomial& c : v.coefficients()) {
    re.push_back(c.coefficient(0) + c.coefficient(1) * alpha.re);
    im.push_back(c.coefficient(1) * alpha.im);
  }
  return {Polynomial(re), Polynomial(im)};
}

}  // namespace

GaussianLogs gaussian_logs(const std::vector<LogSum>& over_residues) {
  GaussianLogs form;
  for (const LogSum& sum : over_residues) {
    const auto alpha = gaussian_root(sum.index);
    if (!alpha) {
      form.others.push_back(sum);
      continue;
    }
    const GaussianPolynomial v = argument_at(sum.argument, *alpha);
    if (alpha->im == 0) {
      form.logarithms.push_back({alpha->re, v.re});
      continue;
    }
    if (alpha->re != 0) form.logarithms.push_back({alpha->re, norm(v)});
    form.arguments.push_back({-2 * alpha->im, v});
  }
  return form;
}

}  // namespace phrame
