#include "phrame/ph/construct/rrmf_joint.hpp"

#include <algorithm>

#include "phrame/algebra/lattice.hpp"
#include "phrame/algebra/rounding.hpp"

// Let N be A at the start, integers with |N|² = n, and d | n with ι² ≡ −1 modulo d. With b = N⁻¹C
// the law A₂ = N(τi − (b i b*)i) is
//   A₂ = −(v − nτ)N i/n, v = C i C*.
// Rounded b and τ would make A₂ longer than N by all their digits, from one segment to the next.
// So they are chosen such that d divides (v − nτ)N: if (i − ι)C*N ≡ 0 modulo d, and τ′ ≡ ι|C|²,
// then vN − τ′N ≡ C(i − ι)C*N ≡ 0. Those C are a lattice of the index d, for the kernel of i − ι
// modulo a prime has half the dimension, and so has C*N: one linear condition. It has vectors as
// near to the direction of Nb as one likes. C·z with z ∈ ℚ(i) in the place of C makes A₂ |z|²
// times as long, so that nothing depends on the size and the phase of C, and what is wanted of the
// integer τ′ is a ratio τ′/(m|C|²) for some integer m, (mv − τ′)N ≡ 0: another lattice, of pairs.
//
// At its end, N′ in the direction of (mv − τ′)N i, N*N′ is, up to a factor, w′ = τ′i − mC′iC′*·i
// with |N|·|N′| = |w′|, so τ′² + (m|C|²)² ≡ 0 modulo |N′|²: the next ι is τ′ over m|C|². For this
// they have to be coprime, which of some C and m the first ones are; one of them is odd, so that
// |N′|² has no factor 2 more than n. With a precision of 2^−p C is of the size √|N| · 2^(p/2), m
// about 2^p, and N′ of the size √|N| · 2^p: |N| tends to 2^(2p).

namespace phrame::inline v0 {
namespace {

/// x·2^k, rounded.
Integer scaled(const Rational& x, long k) { return floor(x * power_of_two(k) + Rational(1, 2)); }

Integer content(const IntegerQuaternion& a) { return gcd(gcd(a.u, a.v), gcd(a.p, a.q)); }

/// Over their greatest common divisor.
IntegerQuaternion primitive(const RationalQuaternion& a) {
  const Integer common =
      lcm(lcm(denominator(a.u), denominator(a.v)), lcm(denominator(a.p), denominator(a.q)));
  const IntegerQuaternion whole =
      each(a, [&](const Rational& x) { return numerator(x) * (common / denominator(x)); });
  const Integer factor = content(whole);
  return each(whole, [&](const Integer& x) { return x / factor; });
}

Integer odd_part(Integer x) {
  while (x % 2 == 0) x >>= 1;
  return x;
}

/// With the modulus d | |a|², odd, and a root y/x of −1; no value where x has no inverse.
std::optional<RrmfJoint> joint_with_root(const IntegerQuaternion& a, const Integer& d,
                                         const Integer& y, const Integer& x) {
  const auto inverse = inverse_modulo(x, d);
  if (!inverse) return std::nullopt;
  return RrmfJoint{a, d, modulo(y * *inverse, d)};
}

/// The joint at N′ that a quintic from N leads to.
RrmfJoint joint_behind(const IntegerQuaternion& n, const IntegerQuaternion& next) {
  const IntegerQuaternion c = conjugate(n) * next;
  const Integer w = sqrt(c.u * c.u + c.p * c.p + c.q * c.q);
  Integer d = odd_part(norm(next));
  for (Integer common = gcd(w, d); common != 1; common = gcd(common, d)) d /= common;
  return *joint_with_root(next, d, c.v, w);
}

/// Σ c_y·row_y.
std::vector<Integer> combination(const std::vector<Integer>& c, const IntegerRows& rows) {
  std::vector<Integer> result(rows.front().size());
  for (std::size_t y = 0; y < rows.size(); ++y)
    for (std::size_t x = 0; x < result.size(); ++x) result[x] += c[y] * rows[y][x];
  return result;
}

/// Factors −1, 0 and 1 of the vectors of a basis, of which the first that is not 0 is 1: few of
/// these before many.
IntegerRows small_factors(std::size_t n) {
  IntegerRows list;
  std::vector<Integer> factors(n, -1);
  for (;;) {
    const auto first = std::ranges::find_if(factors, [](const Integer& c) { return c != 0; });
    if (first != factors.end() && *first == 1) list.push_back(factors);
    std::size_t k = 0;
    for (; k < n && factors[k] == 1; ++k) factors[k] = -1;
    if (k == n) break;
    factors[k] += 1;
  }
  std::ranges::stable_sort(list, {}, [](const std::vector<Integer>& factors_of_one) {
    return -std::ranges::count(factors_of_one, Integer(0));
  });
  return list;
}

/// What accept(vector, image) has first a value for, of vectors with short images: sums and
/// differences of a reduced basis.
template <class Accept>
auto first_short_vector(const IntegerRows& basis, const IntegerRows& images, const Accept& accept)
    -> decltype(accept(basis.front(), images.front())) {
  const ReducedBasis reduced = reduced_basis_with_transform(images);
  for (const std::vector<Integer>& factors : small_factors(basis.size()))
    if (auto found = accept(combination(combination(factors, reduced.transform), basis),
                            combination(factors, reduced.rows)))
      return found;
  return std::nullopt;
}

/// Those C, by a basis: d·e and e_k − x_k·e, with e such that the condition has an inverse modulo d
/// there. No value where none is found.
std::optional<IntegerRows> lattice_of_middles(const RrmfJoint& start) {
  const Integer& d = start.modulus;
  std::array<std::array<Integer, 2>, 4> parts;  // of (i − ι)C*N, for the four unit quaternions C
  for (std::size_t k = 0; k < 4; ++k) {
    const auto part = [k](std::size_t j) { return Integer(j == k ? 1 : 0); };
    const IntegerQuaternion unit{part(0), part(1), part(2), part(3)};
    const IntegerQuaternion c = conjugate(unit) * start.a;
    parts[k] = {c.v + start.root * c.u, c.q + start.root * c.p};
  }
  // All are multiples of one condition modulo each prime, but some may be 0 there.
  constexpr long most = 8;
  for (long s = 0; s < most; ++s)
    for (long t = 0; t < most; ++t)
      for (std::size_t pivot = 0; pivot < 4; ++pivot) {
        const auto condition = [&](std::size_t k) { return parts[k][0] + t * parts[k][1]; };
        const std::size_t other = (pivot + 1) % 4;
        const auto inverse = inverse_modulo(condition(pivot) + s * condition(other), d);
        if (!inverse) continue;
        IntegerRows rows(4, std::vector<Integer>(4));
        for (std::size_t k = 0; k < 4; ++k) {
          const Integer x = k == pivot ? d : modulo(-(condition(k) * *inverse), d);
          if (k != pivot) rows[k][k] = 1;
          rows[k][pivot] += x;
          rows[k][other] += s * x;
        }
        return rows;
      }
  return std::nullopt;
}

/// The quintics from a joint that are near one.
class JoinedQuintics {
 public:
  JoinedQuintics(const RrmfJoint& start, const RrmfQuintic<Rational>& x, long bits)
      : start_(start), x_(x), bits_(bits), middle_(exact(start.a, 1) * x.b) {}

  /// One whose end has no factor of |N′|² without a root more than its start; no value where none
  /// is found.
  std::optional<JoinedRrmf> short_one() const;
  /// The one with b and τ themselves.
  JoinedRrmf plain_one() const;

 private:
  std::optional<JoinedRrmf> with_middle(const IntegerQuaternion& c) const;
  JoinedRrmf joined(const IntegerQuaternion& c, const Integer& m, const Integer& factor,
                    RrmfJoint end) const;

  const RrmfJoint& start_;
  const RrmfQuintic<Rational>& x_;
  long bits_;
  RationalQuaternion middle_;  ///< Nb
};

/// Is the first half of this, 2^(bits + finer_bits) times as great as the error, small beside the
/// rest?
constexpr unsigned finer_bits = 8;
bool is_near(const std::vector<Integer>& image) {
  Integer error;
  Integer size;
  for (std::size_t k = 0; k < image.size(); ++k)
    (2 * k < image.size() ? error : size) += image[k] * image[k];
  return error < (size << (2 * (finer_bits - 2)));
}

std::optional<JoinedRrmf> JoinedQuintics::short_one() const {
  const auto basis = lattice_of_middles(start_);
  if (!basis || norm(x_.b) == 0) return std::nullopt;
  // Turned back by Nb, C is a complex number and an error.
  const long places = bits_ + 2 * finer_bits - binary_exponent(norm(middle_)) / 2;
  const IntegerQuaternion back =
      conjugate(each(middle_, [&](const Rational& x) { return scaled(x, places); }));
  IntegerRows images;
  for (const auto& row : *basis) {
    const IntegerQuaternion c = back * IntegerQuaternion{row[0], row[1], row[2], row[3]};
    const auto weight = static_cast<unsigned long>(bits_ + finer_bits);
    images.push_back({c.p << weight, c.q << weight, c.u, c.v});
  }
  return first_short_vector(*basis, images, [&](const auto& c, const auto& image) {
    return is_near(image) ? with_middle({c[0], c[1], c[2], c[3]}) : std::nullopt;
  });
}

/// τ′ ≡ ι|C|²m modulo d, and even where m|C|² is odd.
std::optional<JoinedRrmf> JoinedQuintics::with_middle(const IntegerQuaternion& c) const {
  const Integer& d = start_.modulus;
  const Integer size = norm(c);
  if (size % 2 == 0 || gcd(size, d) != 1) return std::nullopt;
  const Integer even_root = start_.root % 2 == 0 ? start_.root : start_.root + d;
  const Integer rest = modulo(even_root * size, 2 * d);
  const Rational wanted = x_.tau / norm(x_.b) * size;
  const long places = bits_ + finer_bits;
  const auto accept = [&](const auto& pair, const auto& image) -> std::optional<JoinedRrmf> {
    const Integer m = abs(pair[0]);
    const Integer tau = pair[0].sign() * (pair[0] * rest - 2 * pair[1] * d);
    if (m == 0 || !is_near(image) || gcd(tau, m * size) != 1) return std::nullopt;
    const Vector<Integer> v = m * rotated_i(c);
    const IntegerQuaternion turned =
        IntegerQuaternion{tau, -v[0], -v[1], -v[2]} * start_.a * IntegerQuaternion{0, 1, 0, 0};
    const Integer factor = content(turned);
    const IntegerQuaternion next = each(turned, [&](const Integer& a) { return a / factor; });
    return joined(c, m, factor, joint_behind(start_.a, next));
  };
  return first_short_vector({{1, 0}, {0, 1}},
                            {{scaled(rest - wanted, places), size}, {scaled(-2 * d, places), 0}},
                            accept);
}

/// (τ′ − mv)N i = factor·N′. With Cz next to Nb, A₂ = |z|²·factor/(mn)·N′.
JoinedRrmf JoinedQuintics::joined(const IntegerQuaternion& c, const Integer& m,
                                  const Integer& factor, RrmfJoint end) const {
  const ComplexOf<Rational> along = hermitian_product(exact(c, 1), middle_);
  const Rational size = norm(c);
  const long places = bits_ + 2 - binary_exponent(norm(along) / (size * size)) / 2;
  const ComplexOf<Rational> z{rounded_to_places(along.re / size, places),
                              rounded_to_places(along.im / size, places)};
  const Integer whole = m * norm(start_.a);
  const Integer common = gcd(whole, factor);
  const Rational to_integers = whole / common;
  const Rational last = norm(z) * (factor / common);
  return {to_integers, to_integers * turned(exact(c, 1), z), last * exact(end.a, 1),
          std::move(end)};
}

JoinedRrmf JoinedQuintics::plain_one() const {
  const RationalQuaternion a2 = exact(start_.a, 1) * last_coefficient(x_);
  return {1, middle_, a2, joint_behind(start_.a, primitive(a2))};
}

}  // namespace

RrmfJoint first_joint(const Vector<Rational>& d, long bits) {
  constexpr long spare = 12;
  IntegerQuaternion near = rounded_multiple(unit_preimage(d, bits + 2 * spare), bits + spare);
  for (;; ++near.u) {
    const IntegerQuaternion a = primitive(exact(near, 1));
    const Integer n = odd_part(norm(a));
    if (const auto root = easy_norm_root(n))
      if (auto joint = joint_with_root(a, n, root->im, root->re)) return *std::move(joint);
  }
}

JoinedRrmf joined_rrmf(const RrmfJoint& start, const RrmfQuintic<Rational>& x, long bits) {
  const JoinedQuintics quintics(start, x, bits);
  if (auto found = quintics.short_one()) return *std::move(found);
  return quintics.plain_one();
}

}  // namespace phrame
