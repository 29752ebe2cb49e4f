#include "phrame/integrate/pole_table.hpp"

#include <algorithm>
#include <optional>

#include "phrame/algebra/factor.hpp"
#include "phrame/algebra/resultant.hpp"
#include "phrame/algebra/roots.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/algebra/sturm.hpp"

// Which components are 0? A ball around 0 does not say, however small; counting does. The poles are
// the roots of q, the residues those of the residue polynomial, and how many roots of a polynomial
// lie on the real or on the imaginary axis Sturm's theorem says. Once no more balls meet the axis
// than numbers lie on it, these are the ones.

namespace phrame::inline v0 {
namespace {

constexpr long sufficient_bits = 48;  // 12 digits are 40 bits
constexpr long most_bits = 16384;
constexpr long longest_counted = 50'000;  // digits; beyond, the residue polynomial takes seconds

long real_roots(const Polynomial& p) { return count_real_roots(p, real_line()); }

/// The purely imaginary roots, 0 among them: p(iy) = P(y) + iQ(y) vanishes for real y iff both do.
long imaginary_roots(const Polynomial& p) {
  std::vector<Rational> parts[2];
  for (long k = 0; k <= p.degree(); ++k) {
    const Rational c = p.coefficient(k);
    parts[k % 2].push_back(k % 4 < 2 ? c : Rational(-c));
    parts[1 - k % 2].emplace_back(0);
  }
  return real_roots(gcd(Polynomial(parts[0]), Polynomial(parts[1])));
}

/// With multiplicity.
long count(long (*distinct)(const Polynomial&), const Polynomial& p) {
  long sum = 0;
  for (const auto& [base, exponent] : squarefree_factorization(p).factors)
    sum += exponent * distinct(base);
  return sum;
}

bool has_digits(const RealBall& x) {
  return !x.contains_zero() && x.accuracy_bits() >= sufficient_bits;
}

/// One component, real or imaginary part, of all poles or residues of a sum.
struct Component {
  std::vector<RealBall> balls;
  std::vector<long> weights;  ///< 2 for a pair of conjugates
  bool zeros_are_known = false;

  void add(const RealBall& ball, long weight) {
    balls.push_back(ball);
    weights.push_back(weight);
  }

  /// Settles which are 0; `count` says how many there are, and is asked only where it matters.
  template <class Count>
  void find_zeros(Count count) {
    long candidates = 0;
    bool exact = true;
    for (std::size_t k = 0; k < balls.size(); ++k) {
      if (!balls[k].contains_zero()) continue;
      candidates += weights[k];
      exact = exact && balls[k].radius() == 0;
    }
    zeros_are_known = exact || candidates == count();
  }

  bool is_settled() const {
    return std::all_of(balls.begin(), balls.end(), [&](const RealBall& x) {
      return x.contains_zero() ? zeros_are_known : has_digits(x);
    });
  }

  PolePart part(std::size_t k) const {
    return {balls[k], !balls[k].contains_zero() || zeros_are_known};
  }
};

/// A sum's poles and residues, at one precision.
struct Table {
  Component pole_re;
  Component pole_im;
  Component residue_re;
  Component residue_im;

  /// Are there digits of each residue, of the real or the imaginary part? No residue is 0. Until
  /// then that balls contain 0 says nothing, and counting, which takes longer, is not for them.
  bool has_residues() const {
    for (std::size_t k = 0; k < residue_re.balls.size(); ++k)
      if (!has_digits(residue_re.balls[k]) && !has_digits(residue_im.balls[k])) return false;
    return true;
  }

  bool is_settled() const {
    return pole_re.is_settled() && pole_im.is_settled() && residue_re.is_settled() &&
           residue_im.is_settled();
  }
};

/// How many poles and residues of a sum lie on an axis; each is counted when it is first asked for.
class Counts {
 public:
  explicit Counts(const LogSum& sum) : sum_(sum) {}

  long imaginary_poles() { return once(imaginary_poles_, imaginary_roots, sum_.index); }
  long imaginary_residues() { return once(imaginary_residues_, imaginary_roots, residues()); }
  long real_residues() { return once(real_residues_, real_roots, residues()); }

 private:
  static long once(std::optional<long>& kept, long (*distinct)(const Polynomial&),
                   const Polynomial& p) {
    if (!kept) kept = p.is_zero() ? -1 : count(distinct, p);
    return *kept;
  }

  /// 0, which makes the counts −1 and proves nothing, where it would take too long.
  const Polynomial& residues() {
    if (residues_) return *residues_;
    const Polynomial n = (sum_.residue * differentiate(sum_.index)) % sum_.index;
    std::size_t length = 0;
    for (const Polynomial* p : {&n, &sum_.index})
      for (const Rational& c : p->coefficients()) length += to_string(c).size();
    residues_ = length > longest_counted ? Polynomial() : residue_polynomial(n, sum_.index);
    return *residues_;
  }

  const LogSum& sum_;
  std::optional<Polynomial> residues_;
  std::optional<long> imaginary_poles_;
  std::optional<long> imaginary_residues_;
  std::optional<long> real_residues_;
};

Table table_of(const LogSum& sum, const Roots& roots, Counts& counts, long bits) {
  Table table;
  const auto add = [&](const ComplexBall& z, long weight) {
    const ComplexBall c = evaluate(sum.residue, z, bits);
    table.pole_re.add(z.re(), weight);
    table.pole_im.add(z.im(), weight);
    table.residue_re.add(c.re(), weight);
    table.residue_im.add(weight == 1 ? RealBall() : c.im(), weight);
  };
  for (const RealBall& x : roots.real) add({x, RealBall()}, 1);
  for (const ComplexBall& z : roots.upper) add(z, 2);
  if (!table.has_residues()) return table;
  table.pole_re.find_zeros([&] { return counts.imaginary_poles(); });
  table.pole_im.find_zeros([&] { return static_cast<long>(roots.real.size()); });
  table.residue_re.find_zeros([&] { return counts.imaginary_residues(); });
  table.residue_im.find_zeros([&] { return counts.real_residues(); });
  return table;
}

}  // namespace

std::optional<PoleTable> pole_table(const Antiderivative& F, long most) {
  PoleTable result;
  for (const LogSum& sum : F.logs) {
    if (!is_over_poles(sum)) return std::nullopt;
    result.poles += sum.index.degree();
  }
  if (result.poles == 0) return std::nullopt;
  if (result.poles > most) return result;
  for (const LogSum& sum : F.logs) {
    long bits = 128;
    Roots roots = isolate_roots(sum.index, bits);
    Counts counts(sum);
    Table table = table_of(sum, roots, counts, bits);
    while (!table.is_settled() && bits < most_bits) {
      bits *= 2;
      refine(sum.index, roots, bits);
      table = table_of(sum, roots, counts, bits);
    }
    for (std::size_t k = 0; k < table.pole_re.balls.size(); ++k)
      result.rows.push_back({table.pole_re.part(k), table.pole_im.part(k), table.residue_re.part(k),
                             table.residue_im.part(k)});
  }
  return result;
}

}  // namespace phrame
