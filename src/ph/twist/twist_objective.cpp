#include "phrame/ph/twist/twist_objective.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "phrame/algebra/rounding.hpp"

namespace phrame::inline v0 {
namespace {

constexpr unsigned gauss_points = 15;
using Gauss = boost::math::quadrature::gauss<double, gauss_points>;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// In doubles, those of p/scale.
std::vector<double> bernstein_terms(const Polynomial& p, const Rational& scale) {
  const long n = std::max(p.degree(), 0L);
  const Polynomial scaled = scaled_bernstein(p, n);
  std::vector<double> c;
  for (long k = 0; k <= n; ++k)
    c.push_back(static_cast<double>(Rational(scaled.coefficient(k) / scale)));
  return c;
}

/// Σ c_k tᵏ (1 − t)ⁿ⁻ᵏ: stable where the coefficients have one sign.
double evaluate(const std::vector<double>& c, double t) {
  double value = 0;
  double power = 1;
  for (std::size_t k = c.size(); k-- > 0; power *= 1 - t) value = value * t + c[k] * power;
  return value;
}

bool are_positive(const std::vector<double>& c) {
  return std::all_of(c.begin(), c.end(), [](double x) { return x > 0; });
}

double square(double x) { return x * x; }

using Complex = std::complex<double>;

// Those of the standard library are slow, as they look after infinities.
Complex product(Complex x, Complex y) {
  return {x.real() * y.real() - x.imag() * y.imag(), x.real() * y.imag() + x.imag() * y.real()};
}

Complex quotient(Complex x, Complex y) { return product(x, std::conj(y)) / std::norm(y); }

/// θ′ = 2 Im(w′/w).
double turn_rate(Complex w, Complex slope) {
  return 2 * (w.real() * slope.imag() - w.imag() * slope.real()) / std::norm(w);
}

}  // namespace

TwistObjective::TwistObjective(const TwistPiece& piece, const RotationFamily& family)
    : family_(family),
      turn_(approximate(piece.turn.enclose(64))),
      twist_(approximate(piece.twist.enclose(64))),
      exact_rate_(piece.erf_rate),
      exact_speed_(piece.speed),
      balls_(balls_at(64)) {
  Rational scale = 0;
  for (const Rational& c : piece.erf_rate.denominator().coefficients())
    scale = std::max(scale, Rational(abs(c)));
  rate_numerator_ = bernstein_terms(piece.erf_rate.numerator(), scale);
  rate_denominator_ = bernstein_terms(piece.erf_rate.denominator(), scale);
  speed_ = bernstein_terms(piece.speed, 1);
  // NOLINTNEXTLINE(*-prefer-member-initializer): it needs what is above
  are_doubles_stable_ = are_positive(rate_denominator_) && are_positive(speed_);
  for (const Rotation& w : family.basis) {
    std::vector<Complex> c;
    const long n = std::max({w.a.degree_bound(), w.b.degree_bound(), 0L});
    for (long k = 0; k <= n; ++k)
      c.emplace_back(approximate(w.a.coefficient(k)), approximate(w.b.coefficient(k)));
    basis_.push_back(std::move(c));
  }
  for (int k = 0; k < 4; ++k) nodes_.append(nodes_between(k / 4.0, (k + 1) / 4.0));
}

void TwistObjective::Nodes::append(const Nodes& others) {
  nodes.insert(nodes.end(), others.nodes.begin(), others.nodes.end());
  terms.insert(terms.end(), others.terms.begin(), others.terms.end());
}

TwistObjective::Node TwistObjective::node_at(double middle, double offset, double weight) {
  const auto node = [&](double erf_rate, double speed) {
    return Node{weight, erf_rate - twist_ * speed, speed};
  };
  if (are_doubles_stable_) {
    const double tau = middle + offset;
    return node(evaluate(rate_numerator_, tau) / evaluate(rate_denominator_, tau),
                evaluate(speed_, tau));
  }
  // Beside a cusp the speed and the denominator are small against their terms, and τ has to be more
  // exact than a double is.
  const RealBall tau = exact_sum(middle, offset);
  constexpr long enough = 60;
  for (;; balls_ = balls_at(2 * balls_.bits)) {
    const long bits = balls_.bits;
    const RealBall speed = phrame::evaluate(balls_.speed, tau, bits);
    const RealBall denominator = phrame::evaluate(balls_.denominator, tau, bits);
    if (std::min(speed.accuracy_bits(), denominator.accuracy_bits()) < enough) continue;
    const RealBall numerator = phrame::evaluate(balls_.numerator, tau, bits);
    return node(approximate(divide(numerator, denominator, bits)), approximate(speed));
  }
}

TwistObjective::Balls TwistObjective::balls_at(long bits) const {
  return {bits,
          {exact_rate_.numerator(), bits},
          {exact_rate_.denominator(), bits},
          {exact_speed_, bits}};
}

const TwistObjective::Nodes& TwistObjective::nodes_between(double a, double b) {
  Nodes& nodes = known_[{a, b}];
  if (!nodes.nodes.empty()) return nodes;
  const double middle = (a + b) / 2;  // exact, as half is: the ends are multiples of 2^−50
  const double half = (b - a) / 2;
  const auto append = [&](double x, double weight) {
    nodes.nodes.push_back(node_at(middle, x * half, weight * half));
    for (const auto& c : basis_) {
      Term term{0, 0};
      for (std::size_t k = c.size(); k-- > 0;) {
        term.slope = term.slope * (middle + x * half) + term.w;
        term.w = term.w * (middle + x * half) + c[k];
      }
      nodes.terms.push_back(term);
    }
  };
  for (std::size_t k = 0; k < Gauss::abscissa().size(); ++k) {
    const double x = Gauss::abscissa()[k];
    append(x, Gauss::weights()[k]);
    if (x != 0) append(-x, Gauss::weights()[k]);
  }
  return nodes;
}

TwistObjective::Term TwistObjective::member_at(const Nodes& nodes, std::size_t node,
                                               std::span<const double> parameters) const {
  const Term* terms = &nodes.terms[node * basis_.size()];
  Term member = terms[0];
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    member.w += parameters[i] * terms[i + 1].w;
    member.slope += parameters[i] * terms[i + 1].slope;
  }
  return member;
}

TwistObjective::Sums TwistObjective::sums(const Nodes& nodes,
                                          std::span<const double> parameters) const {
  Sums total;
  for (std::size_t k = 0; k < nodes.nodes.size(); ++k) {
    const auto& [weight, rate, speed] = nodes.nodes[k];
    const Term w = member_at(nodes, k, parameters);
    const double error = rate + turn_rate(w.w, w.slope);
    total.square += weight * square(error) / speed;
    total.turn += weight * error;
  }
  return total;
}

double TwistObjective::operator()(std::span<const double> parameters,
                                  std::span<double> gradient) const {
  const Sums total = sums(nodes_, parameters);
  const double turns = total.turn / (2 * std::numbers::pi);
  const double expected = turns_.value_or(std::round(turns));
  if (!std::isfinite(total.square) || !(std::abs(turns - expected) < 0.01)) return infinity;
  if (gradient.empty()) return total.square;
  std::fill(gradient.begin(), gradient.end(), 0.0);
  for (std::size_t k = 0; k < nodes_.nodes.size(); ++k) {
    const auto& [weight, rate, speed] = nodes_.nodes[k];
    const Term* terms = &nodes_.terms[k * basis_.size()];
    const auto [w, slope] = member_at(nodes_, k, parameters);
    const double factor = 2 * weight * (rate + turn_rate(w, slope)) / speed;
    const Complex square_of_w = product(w, w);
    for (std::size_t i = 0; i < gradient.size(); ++i) {
      // ∂θ′/∂pᵢ = 2 Im (wⁱ/w)′.
      const Complex change = product(terms[i + 1].slope, w) - product(terms[i + 1].w, slope);
      gradient[i] += factor * 2 * std::imag(quotient(change, square_of_w));
    }
  }
  return total.square;
}

std::pair<double, double> TwistObjective::derivatives(double parameter) const {
  double first = 0;
  double second = 0;
  for (std::size_t k = 0; k < nodes_.nodes.size(); ++k) {
    const auto& [weight, rate, speed] = nodes_.nodes[k];
    const auto [w, slope] = member_at(nodes_, k, std::span(&parameter, 1));
    const auto& [q, q_slope] = nodes_.terms[2 * k + 1];
    const double error = rate + turn_rate(w, slope);
    const Complex ratio_slope =
        quotient(product(q_slope, w) - product(q, slope), product(w, w));  // (q/w)′
    const double change = 2 * std::imag(ratio_slope);
    const double second_change = -4 * std::imag(product(ratio_slope, quotient(q, w)));
    first += 2 * weight * error * change / speed;
    second += 2 * weight * (square(change) + error * second_change) / speed;
  }
  return {first, second};
}

void TwistObjective::expect_turn_of(std::span<const double> parameters) {
  std::vector<Rational> exact;
  for (const double p : parameters) exact.push_back(exact_rational(p));
  const auto turned = turn(member(family_, exact, 64), 0, 1, 64);
  if (turned) turns_ = std::round((approximate(*turned) - turn_) / (2 * std::numbers::pi));
}

double TwistObjective::noise_at(const Nodes& nodes, std::size_t node,
                                std::span<const double> parameters) const {
  constexpr double epsilon = 1e-16;
  const auto& [weight, rate, speed] = nodes.nodes[node];
  const Term* terms = &nodes.terms[node * basis_.size()];
  const Term w = member_at(nodes, node, parameters);
  double size = std::abs(terms[0].w);
  double slope_size = std::abs(terms[0].slope);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    size += std::abs(parameters[i] * terms[i + 1].w);
    slope_size += std::abs(parameters[i] * terms[i + 1].slope);
  }
  const double length = std::abs(w.w);
  const double error = std::abs(rate + turn_rate(w.w, w.slope));
  const double off =
      epsilon * (std::abs(rate) + 2 * (slope_size + std::abs(w.slope) * size / length) / length);
  return weight * (2 * error + off) * off / speed;
}

void TwistObjective::resolve(std::span<const double> parameters) {
  constexpr std::size_t most_parts = 700;
  constexpr int most_halvings = 48;
  struct Part {
    double a;
    double b;
    const Nodes* nodes;
    double value;
    double left;  ///< of its halves
    double right;
    double noise;  ///< what rounding errors may amount to
    double gap;    ///< by how much its halves have another value
  };
  double total = 0;
  double noise = 0;
  const auto value = [&](const Nodes& nodes) { return sums(nodes, parameters).square; };
  // The greatest gap goes first, so that a limit on the parts does not leave out a peak.
  const auto is_before = [](const Part& x, const Part& y) { return x.gap < y.gap; };
  std::vector<Part> parts;
  const auto insert = [&](double a, double b, double here) {
    const Nodes& nodes = nodes_between(a, b);
    const double half = (a + b) / 2;
    const double left = value(nodes_between(a, half));
    const double right = value(nodes_between(half, b));
    const bool is_last = b - a < std::ldexp(1, -most_halvings);
    Part part{a, b, &nodes, here, left, right, 0, is_last ? 0 : std::abs(left + right - here)};
    for (std::size_t k = 0; k < nodes.nodes.size(); ++k)
      part.noise += noise_at(nodes, k, parameters);
    total += part.value;
    noise += part.noise;
    parts.push_back(part);
    std::push_heap(parts.begin(), parts.end(), is_before);
  };
  for (int k = 0; k < 4; ++k) {
    const double a = k / 4.0;
    const double b = (k + 1) / 4.0;
    insert(a, b, value(nodes_between(a, b)));
  }
  while (parts.front().gap > 1e-13 * total + noise && parts.size() < most_parts) {
    std::pop_heap(parts.begin(), parts.end(), is_before);
    const Part part = parts.back();
    parts.pop_back();
    total -= part.value;
    noise -= part.noise;
    const double half = (part.a + part.b) / 2;
    insert(part.a, half, part.left);
    insert(half, part.b, part.right);
  }
  nodes_ = {};
  for (const Part& part : parts) nodes_.append(*part.nodes);
}

}  // namespace phrame
