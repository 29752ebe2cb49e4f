#include "phrame/integrate/gaussian_logs.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/surd.hpp"

namespace phrame::inline v0 {
namespace {

/// v(α, t) for deg v < 2 in x and α = a + bi.
GaussianPolynomial argument_at(const Bivariate& v, const QuadraticNumber& alpha) {
  std::vector<Rational> re;
  std::vector<Rational> im;
  for (const Polynomial& c : v.coefficients()) {
    re.push_back(c.coefficient(0) + c.coefficient(1) * alpha.a);
    im.push_back(c.coefficient(1) * alpha.b);
  }
  return {Polynomial(re), Polynomial(im)};
}

GaussianPolynomial power(const GaussianPolynomial& a, const Integer& k) {
  GaussianPolynomial result{{1}, {}};
  for (Integer i = 0; i < k; ++i) result = result * a;
  return result;
}

}  // namespace

// arg g = Im log g = −(i/2)·log g + (i/2)·log ḡ, and v = P − 2xQ for the monic g = P + iQ.
LogSum argument_as_logs(const GaussianPolynomial& g) {
  const auto [p, q] = monic(g);
  std::vector<Polynomial> v;
  for (long k = 0; k <= p.degree(); ++k)
    v.push_back(Polynomial{p.coefficient(k), -2 * q.coefficient(k)});
  return LogSum{Polynomial{1, 0, 4}, Polynomial{0, 1}, Bivariate(std::move(v))};
}

GaussianLogs gaussian_logs(const std::vector<LogSum>& over_residues) {
  GaussianLogs form;
  for (const LogSum& sum : over_residues) {
    if (!(sum.residue == Polynomial{0, 1} % sum.index))
      throw DomainError("gaussian_logs: a sum that is not over its residues");
    const std::optional<QuadraticNumber> alpha =
        sum.index.degree() <= 2 ? std::optional(quadratic_root(sum.index)) : std::nullopt;
    if (!alpha || abs(alpha->d) != 1) {
      form.others.push_back(sum);
      continue;
    }
    const GaussianPolynomial v = argument_at(sum.argument, *alpha);
    if (alpha->d == 1) {
      form.logarithms.push_back({alpha->a, v.re});
      continue;
    }
    if (alpha->a != 0) form.logarithms.push_back({alpha->a, norm(v)});
    form.arguments.push_back({-2 * alpha->b, v});
  }
  return form;
}

std::optional<GaussianPolynomial> single_argument(const GaussianLogs& logs) {
  if (!logs.logarithms.empty() || !logs.others.empty()) return std::nullopt;
  GaussianPolynomial product{{1}, {}};
  for (const auto& [factor, of] : logs.arguments) {
    if (denominator(factor) != 1) return std::nullopt;
    const Integer k = numerator(factor);
    product = product * power(k > 0 ? of : conjugate(of), abs(k));
  }
  return product;
}

}  // namespace phrame
