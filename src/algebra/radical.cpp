#include "phrame/algebra/radical.hpp"

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/surd.hpp"

namespace phrame::inline v0 {
namespace {

using Kind = Radical::Kind;
using Step = Radical::Step;
using Sum = Radical::Sum;
using Term = Radical::Term;

std::size_t add_step(std::vector<Step>& steps, Step step) {
  const auto found = std::find(steps.begin(), steps.end(), step);
  if (found != steps.end()) return static_cast<std::size_t>(found - steps.begin());
  steps.push_back(std::move(step));
  return steps.size() - 1;
}

/// Appends the steps that `sum` of `from` needs, unless they are there already; the same sum of the
/// steps there.
Sum import_sum(std::vector<Step>& steps, const std::vector<Step>& from, const Sum& sum) {
  std::vector<bool> needed(from.size());
  const auto need = [&](const Sum& s) {
    for (const Term& term : s.terms) needed[term.step] = true;
  };
  need(sum);
  for (std::size_t k = from.size(); k-- > 0;)
    if (needed[k]) need(from[k].left), need(from[k].right);
  std::vector<std::size_t> place(from.size());
  const auto moved = [&](Sum s) {
    for (Term& term : s.terms) term.step = place[term.step];
    std::sort(s.terms.begin(), s.terms.end(),
              [](const Term& a, const Term& b) { return a.step < b.step; });
    return s;
  };
  for (std::size_t k = 0; k < from.size(); ++k)
    if (needed[k])
      place[k] = add_step(steps, {from[k].kind, moved(from[k].left), moved(from[k].right)});
  return moved(sum);
}

Sum add(const Sum& a, const Sum& b) {
  Sum sum{a.constant + b.constant, {}};
  auto x = a.terms.begin();
  auto y = b.terms.begin();
  while (x != a.terms.end() || y != b.terms.end()) {
    if (y == b.terms.end() || (x != a.terms.end() && x->step < y->step)) {
      sum.terms.push_back(*x++);
    } else if (x == a.terms.end() || y->step < x->step) {
      sum.terms.push_back(*y++);
    } else {
      const Rational factor = x++->factor + y->factor;
      if (factor != 0) sum.terms.push_back({factor, y->step});
      ++y;
    }
  }
  return sum;
}

Sum scale(const Rational& c, Sum sum) {
  if (c == 0) return {};
  sum.constant *= c;
  for (Term& term : sum.terms) term.factor *= c;
  return sum;
}

/// sum = content · rest; the rest has coprime integer coefficients, and its first one is positive.
/// The content is 0 for 0.
Rational content(const Sum& sum) {
  std::vector<Rational> coefficients;
  if (sum.constant != 0) coefficients.push_back(sum.constant);
  for (const Term& term : sum.terms) coefficients.push_back(term.factor);
  if (coefficients.empty()) return 0;
  const Rational c = content(Polynomial(coefficients));
  return (c < 0) == (coefficients.front() < 0) ? c : Rational(-c);
}

/// x = rootᵏ·rest, as split_square does it.
SquareFactor split_cube(const Integer& x) {
  constexpr unsigned largest_divisor = 10'000;
  Integer rest = x;
  SquareFactor result{1, 1};
  for (unsigned p = 2; p <= largest_divisor && Integer(p) * p * p <= rest; ++p) {
    const Integer cube = Integer(p) * p * p;
    for (; rest % cube == 0; rest /= cube) result.root *= p;
    for (; rest % p == 0; rest /= p) result.rest *= p;
  }
  Integer root;
  if (fmpz_root(root.raw(), rest.raw(), 3) != 0)
    result.root *= root;
  else
    result.rest *= rest;
  return result;
}

/// c = outside²·inside or outside³·inside for c > 0: u/v = uv/v² = uv²/v³.
struct Extraction {
  Rational outside;
  Rational inside;
};

Extraction extract(const Rational& c, Kind kind) {
  const Integer u = numerator(c);
  const Integer v = denominator(c);
  const SquareFactor split =
      kind == Kind::square_root ? split_square(u * v) : split_cube(u * v * v);
  return {Rational(split.root, v), Rational(split.rest)};
}

ComplexBall enclose(const Sum& sum, const std::vector<ComplexBall>& steps, long bits) {
  ComplexBall value(RealBall(sum.constant, bits), RealBall());
  for (const Term& term : sum.terms) {
    ComplexBall product;
    acb_mul_arb(product.raw(), steps[term.step].raw(), RealBall(term.factor, bits).raw(), bits);
    acb_add(value.raw(), value.raw(), product.raw(), bits);
  }
  return value;
}

ComplexBall enclose(const Step& step, const std::vector<ComplexBall>& steps, long bits) {
  ComplexBall value;
  if (step.kind == Kind::imaginary_unit) {
    acb_onei(value.raw());
    return value;
  }
  const ComplexBall left = enclose(step.left, steps, bits);
  switch (step.kind) {
    case Kind::product:
      acb_mul(value.raw(), left.raw(), enclose(step.right, steps, bits).raw(), bits);
      break;
    case Kind::quotient:
      acb_div(value.raw(), left.raw(), enclose(step.right, steps, bits).raw(), bits);
      break;
    case Kind::square_root:
      acb_sqrt(value.raw(), left.raw(), bits);
      break;
    default:
      acb_root_ui(value.raw(), left.raw(), 3, bits);
  }
  return value;
}

/// Is the radius of both parts ≤ 2^−bits · max(1, |z|)?
bool is_accurate(const ComplexBall& z, long bits) {
  if (acb_is_finite(z.raw()) == 0) return false;
  flint::Mag allowed;
  acb_get_mag_lower(allowed.get(), z.raw());
  if (mag_cmp_2exp_si(allowed.get(), 0) < 0) mag_one(allowed.get());
  mag_mul_2exp_si(allowed.get(), allowed.get(), -bits);
  return mag_cmp(arb_radref(acb_realref(z.raw())), allowed.get()) <= 0 &&
         mag_cmp(arb_radref(acb_imagref(z.raw())), allowed.get()) <= 0;
}

}  // namespace

Radical Radical::combination(const std::vector<Step>& steps, const Sum& value) {
  Radical result;
  result.value_ = import_sum(result.steps_, steps, value);
  return result;
}

Radical Radical::of_step(std::vector<Step> steps, Step step) {
  const std::size_t place = add_step(steps, std::move(step));
  return combination(steps, {0, {{1, place}}});
}

Radical Radical::imaginary_unit() { return of_step({}, {Kind::imaginary_unit}); }

std::optional<Rational> Radical::rational() const {
  if (value_.terms.empty()) return value_.constant;
  return std::nullopt;
}

Radical operator+(const Radical& a, const Radical& b) {
  std::vector<Step> steps = a.steps_;
  const Sum right = import_sum(steps, b.steps_, b.value_);
  return Radical::combination(steps, add(a.value_, right));
}

Radical operator*(const Radical& a, const Radical& b) {
  if (const auto r = b.rational()) return Radical::combination(a.steps_, scale(*r, a.value_));
  if (a.rational()) return b * a;
  std::vector<Step> steps = a.steps_;
  const Rational factor = content(a.value_) * content(b.value_);
  const Sum left = scale(1 / content(a.value_), a.value_);
  const Sum right = scale(1 / content(b.value_), import_sum(steps, b.steps_, b.value_));
  if (left == right && left.constant == 0 && left.terms.size() == 1) {
    const Step& step = steps[left.terms.front().step];
    if (step.kind == Kind::imaginary_unit) return -factor;
    if (step.kind == Kind::square_root) {
      const Sum radicand = step.left;
      return Radical::combination(steps, scale(factor, radicand));
    }
  }
  return Radical::of_step(std::move(steps), {Kind::product, left, right}) * factor;
}

Radical operator/(const Radical& a, const Radical& b) {
  if (const auto r = b.rational()) {
    if (*r == 0) throw DomainError("radical: division by 0");
    return a * Rational(1 / *r);
  }
  if (a.rational() == Rational(0)) return {};
  std::vector<Step> steps = a.steps_;
  const Sum right = import_sum(steps, b.steps_, b.value_);
  const Rational factor = content(a.value_) / content(right);
  return Radical::of_step(std::move(steps), {Kind::quotient, scale(1 / content(a.value_), a.value_),
                                             scale(1 / content(right), right)}) *
         factor;
}

bool operator==(const Radical& a, const Radical& b) {
  std::vector<Step> steps = a.steps_;
  return import_sum(steps, b.steps_, b.value_) == a.value_ && steps.size() == a.steps_.size();
}

namespace {

/// The rational factor of the radicand that is taken out of the root: |content|, which leaves the
/// argument as it is.
template <class Build>
Radical root(const Sum& radicand, Kind kind, Build build) {
  const Rational c = abs(content(radicand));
  if (c == 0) return {};
  const Extraction factor = extract(c, kind);
  const Sum inside = scale(factor.inside / c, radicand);
  if (inside == Sum{1, {}}) return factor.outside;
  return build(inside) * factor.outside;
}

}  // namespace

Radical sqrt(const Radical& a) {
  if (const auto r = a.rational(); r && *r < 0) {
    const Radical i = Radical::imaginary_unit();
    return i * sqrt(Radical(Rational(-*r)));
  }
  return root(a.value_, Kind::square_root, [&](const Sum& inside) {
    return Radical::of_step(a.steps_, {Kind::square_root, inside});
  });
}

Radical cbrt(const Radical& a) {
  return root(a.value_, Kind::cube_root, [&](const Sum& inside) {
    return Radical::of_step(a.steps_, {Kind::cube_root, inside});
  });
}

Radical evaluate(const Polynomial& p, const Radical& x) {
  Radical value;
  for (long k = p.degree(); k >= 0; --k) value = value * x + p.coefficient(k);
  return value;
}

ComplexBall enclose(const Radical& x, long bits) {
  const long most = 64 * bits + 65536;
  for (long precision = bits + 32; precision <= most; precision *= 2) {
    std::vector<ComplexBall> steps;
    for (const Step& step : x.steps()) steps.push_back(enclose(step, steps, precision));
    const ComplexBall value = enclose(x.value(), steps, precision);
    if (is_accurate(value, bits)) return value;
  }
  throw Undecided("enclose: " + std::to_string(most) +
                  " bits do not suffice to enclose the radical to " + std::to_string(bits) +
                  " bits");
}

}  // namespace phrame
