#include "phrame/ph/construct/helical_quintics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "phrame/algebra/root_guess.hpp"
#include "phrame/ph/construct/energy.hpp"

// f = 1. With B = 3A₀ + 4A₁ + 3A₂ and c(Δ) = B i B* the length is (|c| − 10g cos Δ)/120 and a
// constant. Its derivative is, by (I2), a multiple of Im(z̄₀z₂), where z₀, z₂ ∈ ℂ are what of A₀ and
// A₂ is not a complex multiple of B: z_k = α_B β_k − β_B α_k. So at the extrema of the length, and
// nowhere else, there are real X, Y with X z₀ + Y z₂ = 0, and B can be turned to be X A₀ + Y A₂:
// two curves each, ±B. The squared condition is, with S(A₀, A₂) = a cos Δ + b sin Δ,
// L = w·a cos Δ + w·b sin Δ, w = 120·step − 15(d₀ + d₁) and |a|² − |b|² = g²,
//   L′² − 20g²(w·b) sin Δ − g²(|w|² + 100|b|²) sin² Δ = 0,
// which has at most four zeros; two of them at least are extrema of −|c| − 10g cos Δ. So the length
// has two extrema, and there are four curves.
//
// Monotone. 30·step = (6 + 3f₁ + G)d₀ + (3 + 4f₁ + 3G)S(A₀, A₁) + (1 + 3f₁ + 6G)d₁/G with G = g²
// and S(A₀, A₁) = (a cos Δ + b sin Δ)/g. Write x × y for a product in the plane of d₀, d₁, and
//   K = (3 + 4f₁ + 3G)/g, k = K cos Δ, μ = K sin Δ = 30·step·b/|b|²,
//   D = (G d₀ + d₁) × a, N = (30G·step − (6G + G²)d₀ − (1 + 6G)d₁) × a,
//   n = G(30·step × d₀ + 5d₀ × d₁) + 30·step × d₁ − 5d₀ × d₁.
// Then f₁ = N/(3D), k = −n/D, and K² = k² + μ² is of degree 4 in G > 0:
//   (3(1 + G)D + 4N/3)² = G(n² + μ²D²).
// Where D = N = n = 0, as in symmetric data, f₁ is free and K² = k² + μ² says what it is.

namespace phrame::inline v0 {
namespace {

using DoubleComplex = ComplexOf<double>;
using Hamilton = Quaternion<double>;

double size(const DoubleComplex& z) { return std::hypot(z.re, z.im); }
/// Re(ā·b).
double real_product(const DoubleComplex& a, const DoubleComplex& b) {
  return a.re * b.re + a.im * b.im;
}

void append(std::vector<double>& list, const Hamilton& a) {
  list.insert(list.end(), {a.u, a.v, a.p, a.q});
}

class Search {
 public:
  Search(const HermiteData<double>& data, const HelicalStart<double>& start)
      : data_(data),
        start_(start),
        family_(data),
        a0_(start.factor * start.q),
        // The family has its own preimage of d₀; ours is that one turned.
        turn_(direction_of(hermitian_product(preimage(data.d0), a0_), 0.0)),
        least_(0x1p-40 *
               std::sqrt(norm(preimage(data.step)) + norm(a0_) + norm(preimage(data.d1)))) {}

  void add_extrema();
  bool add_nearly_straight();
  double extremum_near(double delta) const;
  void add_extremum(double delta);
  void add_dependent(double delta);
  void add_monotone();
  std::vector<HelicalGuess> found();

 private:
  Vector<double> c(const Hamilton& a2) const {
    return 120.0 * data_.step - integral_of_ends(a0_, a2);
  }
  void add(HelicalForm form, std::vector<double> parameters);
  void add_both(const Hamilton& a2, const Hamilton& b, double x, double y);
  void add_monotone(double square, double f1, double k, double mu, const Hamilton& a2);
  void add_monotone_where_free(double square, const Vector<double>& a, double mu,
                               const Hamilton& a2);

  const HermiteData<double>& data_;
  const HelicalStart<double>& start_;
  QuinticFamily family_;
  Hamilton a0_;
  DoubleComplex turn_;
  double least_;  ///< an |A| that is nothing
  std::vector<HelicalGuess> found_;
};

void Search::add(HelicalForm form, std::vector<double> parameters) {
  const auto finite = [](double x) { return std::isfinite(x); };
  if (!std::ranges::all_of(parameters, finite)) return;
  const HelicalMember<double> member = helical_member(form, start_, parameters);
  found_.push_back({form, std::move(parameters), approximate_energy(member.a, member.f)});
}

// Where the data are nearly straight, δ off, the length is (w + 10a cos Δ − 10a cos Δ)/120 but for
// something of size δ², which doubles do not see in it. Then with A = w·a, B = w·b and
// Q = A² − g²(|w|² + 100|b|²) = |b|²(|w|² − 100g²) − |w × a|² the equation above is, for
// t = tan Δ/2, (A − 10g²)B t² + Q t − (A + 10g²)B = 0 but for roots near 0 and ∞, which are no
// extrema. Its coefficients are of size δ².
bool Search::add_nearly_straight() {
  constexpr double small = 0x1p-16;
  const Hamilton end = family_.member(0, 0)[2];
  const Hamilton begin = family_.member(0, 0)[0];
  const Vector<double> a = symmetric_product(begin, end);
  const Vector<double> b = symmetric_product(begin, turned(end, DoubleComplex{0, 1}));
  const Vector<double> w = 120.0 * data_.step - 15.0 * (data_.d0 + data_.d1);
  const double gg = dot(a, a) - dot(b, b);
  const double along = dot(w, a);
  const Vector<double> across = cross(w, a);
  if (!(dot(b, b) < small * small * dot(a, a)) ||
      !(dot(across, across) < small * small * dot(a, a) * dot(w, w)) || !(along > 11 * gg))
    return false;
  const double off = dot(w, b);
  const double q = dot(b, b) * (dot(w, w) - 100 * gg) - dot(across, across);
  const double leading = (along - 10 * gg) * off;
  const double constant = -(along + 10 * gg) * off;
  if (leading == 0) {  // in a plane
    add_extremum(0);
    add_extremum(std::numbers::pi);
    return true;
  }
  // One root without cancellation, the other by their product.
  const double root = std::sqrt(q * q - 4 * leading * constant);
  const double sum = -0.5 * (q < 0 ? q - root : q + root);
  add_extremum(2 * std::atan(sum / leading));
  add_extremum(2 * std::atan(constant / sum));
  return true;
}

void Search::add_extrema() {
  if (add_nearly_straight()) return;
  for (const auto selection : {QuinticSelection::shortest, QuinticSelection::longest}) {
    const Angle delta = family_.choose(selection).delta;
    add_extremum(extremum_near(std::numbers::pi * static_cast<double>(delta.half_turns)));
  }
}

// Of nearly parallel derivatives it is very near 0 or a half turn, and all of its digits count.
double Search::extremum_near(double delta) const {
  const Hamilton end = family_.member(0, 0)[2];
  const Hamilton start = family_.member(0, 0)[0];
  const Vector<double> b = symmetric_product(start, turned(end, DoubleComplex{0, 1}));
  const Vector<double> a = symmetric_product(start, end);
  const double g = hermitian_product(start, end).re;
  const auto slope = [&](double x) {
    const Vector<double> target = 120.0 * data_.step - 15.0 * (data_.d0 + data_.d1) +
                                  10.0 * (std::cos(x) * a + std::sin(x) * b);
    return dot(target, std::cos(x) * b - std::sin(x) * a) +
           std::sqrt(dot(target, target)) * g * std::sin(x);
  };
  constexpr double around = 0x1p-15;
  double low = delta - around;
  double high = delta + around;
  const bool is_rising = slope(low) < 0;
  if (is_rising != (slope(high) > 0)) return delta;
  constexpr double least = 0x1p-80;
  for (double x = delta; low < x && x < high && high - low > least; x = (low + high) / 2) {
    const double here = slope(x);
    if (here == 0) return x;
    ((here < 0) == is_rising ? low : high) = x;
  }
  return (low + high) / 2;
}

void Search::add_extremum(double delta) {
  const Hamilton a2 = turned(family_.member(delta, 0)[2], turn_);
  const Hamilton b = preimage(c(a2));
  const DoubleComplex z0 = wedge(b, a0_);
  const DoubleComplex z2 = wedge(b, a2);
  const DoubleComplex e = direction_of(size(z0) < size(z2) ? z2 : z0, 0.0);
  double x = real_product(e, z2);
  double y = -real_product(e, z0);
  const double ratio = std::sqrt(norm(b) / norm(x * a0_ + y * a2));
  const double b_size = std::sqrt(norm(b));
  for (const double sign : {1.0, -1.0}) {
    const double s = b_size <= least_ ? 0 : sign * ratio;
    const double middle_x = (s * x - 3) / 4;
    const double middle_y = (s * y - 3) / 4;
    std::vector<double> parameters;
    constexpr double great = 1024;
    if (std::abs(middle_y) < great) {
      append(parameters, a2);
      parameters.insert(parameters.end(), {middle_x, middle_y});
      add(HelicalForm::middle, std::move(parameters));
    } else {
      append(parameters, middle_x * a0_ + middle_y * a2);
      parameters.insert(parameters.end(), {-middle_x / middle_y * start_.factor, 1 / middle_y});
      add(HelicalForm::end, std::move(parameters));
    }
    if (s == 0) break;
  }
}

// A₀ and A₂ are real multiples of one, so that any B will do: ±B without turning against A₀ + A₂.
void Search::add_dependent(double delta) {
  const double s0 = norm(a0_);
  const double s1 = std::sqrt(dot(data_.d1, data_.d1));
  const double kappa = (delta == 0 ? 1 : -1) * (s0 > 0 ? std::sqrt(s1 / s0) : 0.0);
  const Hamilton a2 = s0 > 0 ? kappa * a0_ : preimage(data_.d1);
  const Hamilton sum = a0_ + a2;
  Hamilton b = preimage(c(a2));
  const DoubleComplex h = hermitian_product(norm(sum) > least_ * least_ ? sum : a0_, b);
  b = turned(b, conjugate(direction_of(h, least_ * least_)));
  for (const double sign : {1.0, -1.0}) {
    std::vector<double> parameters;
    append(parameters, 0.25 * (sign * b - 3.0 * sum));
    if (s0 > 0 && s1 > 0)
      parameters.push_back(kappa * start_.factor);
    else if (s1 > 0)
      append(parameters, a2);
    add(s0 > 0 ? HelicalForm::end : HelicalForm::free, std::move(parameters));
    if (norm(b) <= least_ * least_) break;
  }
}

void Search::add_monotone(double square, double f1, double k, double mu, const Hamilton& a2) {
  const double g = std::sqrt(square);
  if (!(square > 0) || !(f1 > -g)) return;
  const double big_k = (3 + 4 * f1 + 3 * square) / g;
  const DoubleComplex phase = direction_of(DoubleComplex{k / big_k, mu / big_k}, 0.0);
  std::vector<double> parameters;
  append(parameters, (1 / g) * turned(a2, phase));
  parameters.insert(parameters.end(), {g, f1});
  const std::vector<double> off = helical_defect(
      helical_member(HelicalForm::monotone, start_, parameters), data_.step, data_.d1);
  constexpr double near = 1e-5;  // a double root of the quartic has half the digits
  const double scale = std::sqrt(dot(data_.step, data_.step)) + norm(a0_) + norm(a2);
  if (!std::ranges::all_of(off, [&](double x) { return std::abs(x) < near * scale; })) return;
  for (const HelicalGuess& other : found_)
    if (other.form == HelicalForm::monotone &&
        std::abs(other.parameters[4] - g) + std::abs(other.parameters[5] - f1) < near * (1 + g))
      return;
  add(HelicalForm::monotone, std::move(parameters));
}

/// D = 0, where G d₀ + d₁ is a multiple of a: k = (R·a − 3f₁ V·a)/(G|a|²).
void Search::add_monotone_where_free(double square, const Vector<double>& a, double mu,
                                     const Hamilton& a2) {
  const Vector<double> p = 30.0 * data_.step;
  const Vector<double> v = square * data_.d0 + data_.d1;
  const Vector<double> r =
      square * p - (6 * square + square * square) * data_.d0 - (1 + 6 * square) * data_.d1;
  const double aa = square * dot(a, a);
  const double k0 = dot(r, a) / aa;
  const double k1 = -3 * dot(v, a) / aa;
  // (3 + 3G + 4f₁)² = G((k₀ + k₁f₁)² + μ²)
  const double constant = 9 * (1 + square) * (1 + square) - square * (k0 * k0 + mu * mu);
  const double half_linear = 12 * (1 + square) - square * k0 * k1;
  const double leading = 16 - square * k1 * k1;
  const double root = std::sqrt(half_linear * half_linear - leading * constant);
  for (const double sign : {1.0, -1.0}) {
    const double f1 = (-half_linear + sign * root) / leading;
    add_monotone(square, f1, k0 + k1 * f1, mu, a2);
  }
}

/// Polynomials in G, from the constant on.
using Coefficients = std::array<double, 5>;

Coefficients times(const Coefficients& x, const Coefficients& y) {
  Coefficients z{};
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t j = 0; i + j < 5; ++j) z[i + j] += x[i] * y[j];
  return z;
}

double value_of(const Coefficients& x, double at) {
  return (((x[4] * at + x[3]) * at + x[2]) * at + x[1]) * at + x[0];
}

void Search::add_monotone() {
  const Hamilton a2 = turned(family_.member(0, 0)[2], turn_);
  const Vector<double> a = symmetric_product(a0_, a2);
  const Vector<double> b = symmetric_product(a0_, turned(a2, DoubleComplex{0, 1}));
  const double b_size = std::sqrt(dot(b, b));
  const Vector<double> normal = (1 / b_size) * b;
  const auto product = [&](const Vector<double>& x, const Vector<double>& y) {
    return dot(cross(x, y), normal);
  };
  const Vector<double> p = 30.0 * data_.step;
  const double mu = dot(p, normal) / b_size;
  const double da0 = product(data_.d0, a);
  const double da1 = product(data_.d1, a);
  const double d01 = product(data_.d0, data_.d1);
  const Coefficients d{da1, da0};
  const Coefficients big_n{-da1, product(p, a) - 6 * da0 - 6 * da1, -da0};
  const Coefficients n{product(p, data_.d1) - 5 * d01, product(p, data_.d0) + 5 * d01};
  Coefficients left = times({3, 3}, d);
  for (std::size_t k = 0; k < 5; ++k) left[k] += 4.0 / 3 * big_n[k];
  const Coefficients nn = times(n, n);
  const Coefficients dd = times(d, d);
  Coefficients quartic = times(left, left);
  for (std::size_t k = 0; k < 4; ++k) quartic[k + 1] -= nn[k] + mu * mu * dd[k];
  if (!std::ranges::all_of(quartic, [](double c) { return std::isfinite(c); })) return;
  for (const std::complex<double>& root : guess_roots({quartic.begin(), quartic.end()})) {
    const double square = root.real();
    if (!(square > 0) || std::abs(root.imag()) > 1e-6 * square) continue;
    const double at_d = value_of(d, square);
    add_monotone(square, value_of(big_n, square) / (3 * at_d), -value_of(n, square) / at_d, mu, a2);
  }
  add_monotone_where_free(-da1 / da0, a, mu, a2);
}

std::vector<HelicalGuess> Search::found() {
  std::ranges::stable_sort(found_, {}, [](const HelicalGuess& x) {
    return std::pair(x.form == HelicalForm::monotone, x.energy);
  });
  return std::move(found_);
}

}  // namespace

// With quadratic A: ∂/∂A₁ of the step is S(3A₀ + 4A₁ + 3A₂, ·)/15, ∂/∂A₂ is
// S(2A₀ + 6A₁ + 12A₂, ·)/30.
std::vector<double> helical_derivative(HelicalForm form, const HelicalStart<double>& start,
                                       const std::vector<double>& parameters, std::size_t k) {
  const HelicalMember<double> member = helical_member(form, start, parameters);
  const auto& a = member.a;
  const auto unit = [](std::size_t part) -> Hamilton {
    return {part == 0 ? 1.0 : 0.0, part == 1 ? 1.0 : 0.0, part == 2 ? 1.0 : 0.0,
            part == 3 ? 1.0 : 0.0};
  };
  const auto listed = [](const Vector<double>& x, const Vector<double>& y) -> std::vector<double> {
    return {x[0], x[1], x[2], y[0], y[1], y[2]};
  };
  const Hamilton zero{0, 0, 0, 0};
  if (form == HelicalForm::monotone) {
    const double g = parameters[4];
    const double f1 = parameters[5];
    const Vector<double> start_part = rotated_i(a[0]);
    const Vector<double> middle = symmetric_product(a[0], a[1]);
    const Vector<double> end = rotated_i(a[1]);
    if (k == 4) return listed((g / 15) * (start_part + 3.0 * middle + 6.0 * end), (2 * g) * end);
    if (k == 5) return listed(1.0 / 30 * (3.0 * start_part + 4.0 * middle + 3.0 * end), {0, 0, 0});
    const Hamilton slope = (3 + 4 * f1 + 3 * g * g) * a[0] + (2 * (1 + 3 * f1 + 6 * g * g)) * a[1];
    return listed(1.0 / 30 * symmetric_product(slope, unit(k)),
                  (2 * g * g) * symmetric_product(a[1], unit(k)));
  }
  Hamilton d1 = zero;
  Hamilton d2 = zero;
  if (form == HelicalForm::middle) {
    if (k < 4) d2 = unit(k);
    d1 = k < 4 ? parameters[5] * d2 : a[k == 4 ? 0 : 2];
  } else if (k < 4) {
    d1 = unit(k);
    if (form == HelicalForm::end && parameters.size() > 5) d2 = parameters[5] * d1;
  } else if (form == HelicalForm::end) {
    d2 = k == 4 ? start.q : a[1];
  } else {
    d2 = unit(k - 4);
  }
  return listed(1.0 / 15 * symmetric_product(3.0 * (a[0] + a[2]) + 4.0 * a[1], d1) +
                    1.0 / 15 * symmetric_product(a[0] + 3.0 * a[1] + 6.0 * a[2], d2),
                2.0 * symmetric_product(a[2], d2));
}

std::vector<HelicalGuess> helical_quintics(const HermiteData<double>& data,
                                           const HelicalStart<double>& start,
                                           DirectionsOfEnds ends) {
  Search search(data, start);
  if (ends == DirectionsOfEnds::parallel) {
    search.add_dependent(0);
    if (norm(start.q) != 0 && dot(data.d1, data.d1) != 0) search.add_dependent(std::numbers::pi);
    return search.found();
  }
  if (ends == DirectionsOfEnds::opposite_collinear) {
    search.add_extremum(0);
    search.add_extremum(std::numbers::pi);
    return search.found();
  }
  search.add_extrema();
  search.add_monotone();
  return search.found();
}

}  // namespace phrame
