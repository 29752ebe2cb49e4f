#include "phrame/algebra/elementary.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/zero_bound.hpp"

namespace phrame::inline v0 {
namespace {

/// x, x − 1, 1 + x or 1 − x², which must not be negative.
enum class Domain { all, positive, from_one, from_minus_one, unit };

struct Function {
  std::string_view name;
  void (*at)(arb_t, const arb_t, slong);
  Domain domain;
  long zero;   ///< the one rational number at which the value is rational
  long value;  ///< the value there
};

constexpr Function functions[] = {
    {"exp", arb_exp, Domain::all, 0, 1},
    {"expm1", arb_expm1, Domain::all, 0, 0},
    {"log", arb_log, Domain::positive, 1, 0},
    {"log1p", arb_log1p, Domain::from_minus_one, 0, 0},
    {"sin", arb_sin, Domain::all, 0, 0},
    {"cos", arb_cos, Domain::all, 0, 1},
    {"tan", arb_tan, Domain::all, 0, 0},
    {"arcsin", arb_asin, Domain::unit, 0, 0},
    {"arccos", arb_acos, Domain::unit, 1, 0},
    {"arctan", arb_atan, Domain::all, 0, 0},
    {"sinh", arb_sinh, Domain::all, 0, 0},
    {"cosh", arb_cosh, Domain::all, 0, 1},
    {"tanh", arb_tanh, Domain::all, 0, 0},
    {"arcsinh", arb_asinh, Domain::all, 0, 0},
    {"arccosh", arb_acosh, Domain::from_one, 1, 0},
    {"arctanh", arb_atanh, Domain::unit, 0, 0},
};

bool is_outside(const RealBall& x, Domain domain, long bits) {
  const RealBall one(1, bits);
  switch (domain) {
    case Domain::positive:
      return sign(x) < 0;
    case Domain::from_one:
      return sign(subtract(x, one, bits)) < 0;
    case Domain::from_minus_one:
      return sign(add(x, one, bits)) < 0;
    case Domain::unit:
      return sign(subtract(one, multiply(x, x, bits), bits)) < 0;
    default:
      return false;
  }
}

/// log 0, log1p(−1), arctanh(±1).
bool is_pole(const Function& f, const Rational& x) {
  return (f.name == "log" && x == 0) || (f.name == "log1p" && x == -1) ||
         (f.name == "arctanh" && abs(x) == 1);
}

[[noreturn]] void refuse_domain(std::string_view name, const RealBall& x) {
  throw DomainError(fmt::format("{}: {} is outside of its domain", name, to_string(x, 12)));
}

Real square_root(const Real& x) {
  if (x.exact()) {
    if (*x.exact() < 0) refuse_domain("sqrt", RealBall(*x.exact(), 64));
    return square_root_of(*x.exact());
  }
  const auto root = [x](long bits) {
    const RealBall ball = x.enclose(bits + 8);
    if (sign(ball) < 0) refuse_domain("sqrt", ball);
    return sqrt(ball, bits + 8);
  };
  root(64);
  return Real(root, {false, x.origin().bits});
}

}  // namespace

std::vector<std::string_view> elementary_functions() {
  std::vector<std::string_view> names{"sqrt"};
  for (const Function& f : functions) names.push_back(f.name);
  return names;
}

Real elementary(std::string_view name, const Real& x, bool is_algebraic) {
  if (name == "sqrt") return square_root(x);
  const auto* found = std::find_if(std::begin(functions), std::end(functions),
                                   [&](const Function& f) { return f.name == name; });
  if (found == std::end(functions))
    throw DomainError(fmt::format("\"{}\" is no elementary function", name));
  const Function f = *found;
  if (x.exact() == Rational(f.zero)) return Rational(f.value);
  if (x.exact() && is_pole(f, *x.exact())) refuse_domain(name, RealBall(*x.exact(), 64));
  const auto value = [x, f](long bits) {
    RealBall ball = x.enclose(bits + 8);
    if (is_outside(ball, f.domain, bits + 8)) refuse_domain(f.name, ball);
    f.at(ball.raw(), ball.raw(), bits + 8);
    return ball;
  };
  value(64);
  const bool is_known = x.exact() || (is_algebraic && x.origin().is_irrational);
  return Real(value, {is_known, x.origin().bits});
}

Real arctan2_of(const Real& y, const Real& x) {
  if (y.exact() == Rational(0) && x.exact()) {
    if (*x.exact() == 0) throw DomainError("arctan2: both numbers are 0");
    if (*x.exact() > 0) return Rational(0);
  }
  return Real(
      [y, x](long bits) {
        RealBall ball = y.enclose(bits + 8);
        arb_atan2(ball.raw(), ball.raw(), x.enclose(bits + 8).raw(), bits + 8);
        return ball;
      },
      {x.exact() && y.exact(), x.origin().bits + y.origin().bits});
}

Real power_of(const Real& x, const Real& y) {
  if (x.exact() == Rational(0) && decided_sign(y, {}) == 1) return Rational(0);
  if (x.exact() && *x.exact() <= 0)
    throw DomainError(fmt::format("power: the base, {}, is not positive", to_string(*x.exact())));
  if (y.exact() && denominator(*y.exact()) == 2)
    return power_of(square_root(x), static_cast<long>(numerator(*y.exact())));
  return elementary("exp", y * elementary("log", x, false), false);
}

Real power_of(const Real& x, long k) {
  if (k == 0) return Rational(1);
  if (k < 0) {
    const Real over = power_of(x, -k);
    if (over.exact()) return Rational(1 / *over.exact());
    return Real(
        [over](long bits) { return divide(RealBall(1, bits), over.enclose(bits + 8), bits + 8); },
        over.origin());
  }
  if (x.exact()) {
    Rational power = 1;
    for (long i = 0; i < k; ++i) power *= *x.exact();
    return power;
  }
  if (k == 1) return x;
  const long guard = 8 + 2 * bit_length(Integer(k));
  return Real([x, k, guard](long bits) { return pow(x.enclose(bits + guard), k, bits + guard); },
              {false, std::min(x.origin().bits, (1L << 32) / k) * k});
}

}  // namespace phrame
