#include "phrame/integrate/pole_sum.hpp"

#include <algorithm>

#include "phrame/algebra/ball_log.hpp"
#include "phrame/algebra/ball_order.hpp"

namespace phrame::inline v0 {
namespace {

/// z ↦ log((b − z)/(a − z)) = log(1 + (a − b)/(z − a)), accurate also for b close to a.
class LogRatio {
 public:
  LogRatio(const Rational& a, const Rational& b, long bits)
      : a_(RealBall(a, bits), {}), a_minus_b_(a - b, bits), bits_(bits) {}

  ComplexBall operator()(const ComplexBall& z) const {
    return log1p(multiply(a_minus_b_, inverse(subtract(z, a_, bits_), bits_), bits_), bits_);
  }
  RealBall operator()(const RealBall& z) const {
    return log1p(divide(a_minus_b_, subtract(z, a_.re(), bits_), bits_), bits_);
  }

 private:
  ComplexBall a_;
  RealBall a_minus_b_;
  long bits_;
};

/// z·w + z̄·w̄.
RealBall twice_real_part(const ComplexBall& z, const ComplexBall& w, long bits) {
  return times_power_of_two(multiply(z, w, bits).re(), 1);
}

}  // namespace

void PoleSum::add_term(const Polynomial& n, const Polynomial& d) {
  if (n.is_zero()) return;
  terms_.push_back({n, d, differentiate(d)});
  isolated_ = {};
}

std::shared_ptr<const PoleSum::Isolated> PoleSum::isolate(long precision) const {
  return isolated_.get(precision, [&](const Isolated* known) {
    Isolated found{precision, {}, unbounded_exponent};
    for (std::size_t k = 0; k < terms_.size(); ++k) {
      const Term& p = terms_[k];
      Residues here;
      if (known == nullptr) {
        here.roots = isolate_roots(p.denominator, precision);
      } else {
        here.roots = known->poles[k].roots;
        refine(p.denominator, here.roots, precision);
      }
      const auto residue = [&](const ComplexBall& z) {
        return divide(evaluate(p.numerator, z, precision), evaluate(p.slope, z, precision),
                      precision);
      };
      for (const RealBall& z : here.roots.real) {
        here.real.push_back(residue(ComplexBall(z, RealBall())).re());
        found.nearness = std::min(found.nearness, exponent_below(z));
      }
      for (const ComplexBall& z : here.roots.upper) {
        here.upper.push_back(residue(z));
        found.nearness =
            std::min(found.nearness, std::max(exponent_below(z.re()), exponent_below(z.im())));
      }
      found.poles.push_back(std::move(here));
    }
    return found;
  });
}

RealBall PoleSum::change(const Rational& a, const Rational& b, long bits) const {
  const auto known = isolate(bits);
  const LogRatio log_ratio(a, b, bits);
  RealBall sum;
  for (const Residues& p : known->poles) {
    for (std::size_t k = 0; k < p.roots.real.size(); ++k)
      sum = add_product(std::move(sum), p.real[k], log_ratio(p.roots.real[k]), bits);
    for (std::size_t k = 0; k < p.roots.upper.size(); ++k) {
      const ComplexBall term = log_ratio(p.roots.upper[k]);
      sum = add(sum, twice_real_part(term, p.upper[k], bits), bits);
    }
  }
  return sum;
}

RealBall PoleSum::branch(const Endpoint& t, long bits) const {
  const auto known = isolate(bits);
  RealBall sum;
  if (const auto* infinity = std::get_if<Infinity>(&t)) {
    if (*infinity == Infinity::positive) return sum;
    const ComplexBall half_turn(RealBall(), subtract({}, pi(bits), bits));
    for (const Residues& p : known->poles)
      for (const ComplexBall& c : p.upper)
        sum = add(sum, twice_real_part(half_turn, c, bits), bits);
    return sum;
  }
  const RealBall at = enclose(t, bits);
  for (const Residues& p : known->poles) {
    for (std::size_t k = 0; k < p.roots.real.size(); ++k) {
      const RealBall distance = absolute(subtract(at, p.roots.real[k], bits));
      sum = add_product(std::move(sum), p.real[k], log(distance, bits), bits);
    }
    for (std::size_t k = 0; k < p.roots.upper.size(); ++k) {
      const ComplexBall term = log(subtract({at, {}}, p.roots.upper[k], bits), bits);
      sum = add(sum, twice_real_part(term, p.upper[k], bits), bits);
    }
  }
  return sum;
}

bool PoleSum::turns_vanish(const Polynomial& residues, const Polynomial& others, const Rational& a,
                           const Rational& b, long bits) const {
  if (residues.is_constant()) return true;
  const auto known = isolate(bits);
  const auto roots_of = [&](const Polynomial& p) {
    return p.is_constant() ? Roots() : isolate_roots(p, known->precision);
  };
  const Roots alphas = roots_of(residues);
  const Roots other_alphas = roots_of(others);
  const LogRatio log_ratio(a, b, known->precision);
  std::vector<RealBall> turns(alphas.upper.size());
  for (const Residues& p : known->poles)
    for (std::size_t k = 0; k < p.roots.upper.size(); ++k) {
      const ComplexBall& c = p.upper[k];
      long matches = 0;
      for (const Roots* roots : {&alphas, &other_alphas}) {
        for (const RealBall& alpha : roots->real) matches += c.overlaps({alpha, {}}) ? 1 : 0;
        for (const ComplexBall& alpha : roots->upper)
          matches += (c.overlaps(alpha) ? 1 : 0) + (c.overlaps(conjugate(alpha)) ? 1 : 0);
      }
      if (matches != 1) return false;  // the balls are too wide to tell the residues apart
      const RealBall turn = log_ratio(p.roots.upper[k]).im();
      for (std::size_t j = 0; j < turns.size(); ++j) {
        if (c.overlaps(alphas.upper[j])) turns[j] = add(turns[j], turn, known->precision);
        if (c.overlaps(conjugate(alphas.upper[j])))
          turns[j] = subtract(turns[j], turn, known->precision);
      }
    }
  return std::all_of(turns.begin(), turns.end(), [](const RealBall& turn) {
    return turn.is_finite() && turn.lower() > -1 && turn.upper() < 1;
  });
}

}  // namespace phrame
