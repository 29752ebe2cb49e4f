#include "phrame/ph/twist/rational_twist.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/shared.hpp"
#include "phrame/ph/along/reduced_angle.hpp"
#include "phrame/ph/twist/rotation_family.hpp"
#include "phrame/ph/twist/twist_error.hpp"
#include "phrame/ph/twist/twist_minimum.hpp"
#include "phrame/ph/twist/twist_search.hpp"

namespace phrame::inline v0 {
namespace {

using Complex = std::complex<double>;

/// For what ends in doubles, and to tell turns apart. With its guard less than the bits that the
/// first value of an angle has.
constexpr long coarse_bits = 80;

/// The Bernstein coefficients of w of degree n, in doubles.
std::vector<Complex> bernstein(const RationalTwist& twist, long n) {
  std::vector<Complex> coefficients;
  for (const ComplexBall& c : to_bernstein(twist.rotation(64), n, 64))
    coefficients.emplace_back(approximate(c.re()), approximate(c.im()));
  return coefficients;
}

/// The parameters of the member of a family next to these coefficients, w₀ > 0.
std::vector<double> nearest_parameters(std::vector<Complex> w, const TwistPiece& piece,
                                       EndRates rates) {
  const std::size_t n = w.size() - 1;
  for (std::size_t k = n + 1; k-- > 0;) w[k] /= w[0].real();
  const Complex back = std::polar(1.0, -round_to_double(piece.turn) / 2);
  std::vector<double> parameters;
  for (std::size_t k = 1; k < n; ++k) {
    const bool is_bound = rates == EndRates::matched && (k == 1 || k + 1 == n);
    if (!is_bound)
      parameters.insert(parameters.end(), {w[k].real(), w[k].imag()});
    else
      parameters.push_back(k == 1 ? w[k].real() : (w[k] * back).real());
  }
  parameters.push_back((w[n] * back).real());
  return parameters;
}

/// Unit vectors at half the angles of the exact frame: they turn as it does.
std::vector<Complex> along_exact_frame(const TwistPiece& piece, long n) {
  const double twist = round_to_double(piece.twist);
  const Polynomial share = antiderivative(piece.speed);
  std::vector<Complex> w;
  for (long k = 0; k <= n; ++k) {
    const Rational tau(k, n);
    const double angle =
        twist * round_to_double(share(tau)) - round_to_double(piece.erf_twist(tau));
    w.push_back(std::polar(1.0, angle / 2));
  }
  return w;
}

std::vector<Rational> exact(const std::vector<double>& parameters) {
  std::vector<Rational> values;
  for (const double p : parameters) values.push_back(exact_rational(p));
  return values;
}

/// Enough to compare.
RealBall coarse_mean_square(const RationalTwist& twist) {
  return mean_square(twist.piece(), twist.rotation(working_precision(twist.piece(), 64)), 64);
}

/// Of a family with one parameter, or none.
BestTwist best_on_line(const TwistPiece& piece, long degree, EndRates rates,
                       const RationalTwistOptions& options) {
  const RotationFamily family = rotation_family(piece, degree, rates, coarse_bits);
  const auto member = [&](const LineGuess& guess) {
    return RationalTwist(piece, degree, rates, {exact_rational(guess.parameter)}, guess.value);
  };
  if (family.parameters() == 0) return {{piece, degree, rates, {}}, {}, {}, {}};
  TwistObjective objective(piece, family);
  const TwistObjective fresh = objective;
  auto best = search_line(objective, 1);
  std::optional<LineGuess> other;
  // By Cauchy and Schwarz G ≥ (2πk)² where a frame makes k turns too many: below 4π² it is the
  // right one, and the one with the other sign of γ is not.
  const double one_turn = 4 * std::numbers::pi * std::numbers::pi;
  if (options.prove || !best || best->value > one_turn) {
    objective = fresh;
    other = search_line(objective, -1);
  }
  if (!best && !other)
    throw Undecided(
        fmt::format("no rotation of degree {} without a zero was found; there may be one", degree));
  // A frame that turns by T goes before one that turns 2π more or less, and that by its error.
  const auto rank = [&](const LineGuess& guess) {
    if (guess.value < one_turn) return std::pair(0, guess.value);
    const Rotation w = phrame::member(family, {exact_rational(guess.parameter)}, coarse_bits);
    const auto turned = turn(w, 0, 1, coarse_bits);
    const bool is_right = turned && turned->overlaps(piece.turn.enclose(coarse_bits));
    return std::pair(is_right ? 0 : 1, guess.value);
  };
  if (!best || (other && rank(*other) < rank(*best))) std::swap(best, other);
  BestTwist found{member(*best), {}, {}, {}};
  if (other) found.other = member(*other);
  // The better one has to be better than both, the right one only than its own kind.
  if (other && other->value < best->value) other.reset();
  if (!options.prove) {
    found.doubt = "that was not asked for";
    return found;
  }
  try {
    found.minimum = twist_minimum(piece, degree, rates, *best, other, options.bits);
    found.twist = RationalTwist(piece, degree, rates, {found.minimum->parameter}, best->value);
  } catch (const Undecided& undecided) {
    found.doubt = undecided.what();
  }
  return found;
}

/// θ ≡ const, for a turn that is known to be 0.
BestTwist no_turn(const TwistPiece& piece) { return {{piece, 1, EndRates::free, {1}}, {}, {}, {}}; }

}  // namespace

struct RationalTwist::State {
  TwistPiece piece;
  long degree;
  EndRates rates;
  std::vector<Rational> parameters;
  double mean_square_guess;  ///< 0: none
  mutable std::mutex lock{};
  mutable std::map<long, Rotation> rotations{};  ///< by bits
  Refined<SignChanges> inflections{};
  Refined<RealBall> root_mean_square{};

  RotationFamily family(long bits) const { return rotation_family(piece, degree, rates, bits); }
};

RationalTwist::RationalTwist(TwistPiece piece, long degree, EndRates rates,
                             std::vector<Rational> parameters, double mean_square_guess)
    : state_(new State{std::move(piece), degree, rates, std::move(parameters), mean_square_guess}) {
}

const TwistPiece& RationalTwist::piece() const { return state_->piece; }

long RationalTwist::degree() const { return state_->degree; }

const Rotation& RationalTwist::rotation(long bits) const {
  const std::lock_guard lock(state_->lock);
  const auto known = state_->rotations.find(bits);
  if (known != state_->rotations.end()) return known->second;
  return state_->rotations.emplace(bits, member(state_->family(bits), state_->parameters, bits))
      .first->second;
}

Real RationalTwist::end_factor() const {
  return Real([twist = *this](long bits) {
    return phrame::end_factor(twist.state_->family(bits + 64), twist.state_->parameters, bits + 64);
  });
}

Rational RationalTwist::end_factor_change(const Rational& radius) const {
  const RealBall slope = state_->family(64).end_factor.back();
  return absolute(slope).upper() * radius;
}

std::vector<std::pair<Real, Real>> RationalTwist::coefficients() const {
  std::vector<std::pair<Real, Real>> w;
  for (std::size_t k = 0; k <= static_cast<std::size_t>(degree()); ++k) {
    const auto coefficient = [twist = *this, k](long bits) {
      const long precision = bits + 64;
      const RealBall half = multiply(twist.piece().start.enclose(precision),
                                     RealBall(Rational(1, 2), precision), precision);
      const auto [cosine, sine] = cos_sin(half, precision);
      const auto all = to_bernstein(twist.rotation(precision), twist.degree(), precision);
      return multiply(all[k], {cosine, sine}, precision);
    };
    w.emplace_back(Real([coefficient](long bits) { return coefficient(bits).re(); }),
                   Real([coefficient](long bits) { return coefficient(bits).im(); }));
  }
  return w;
}

Integer RationalTwist::extra_turns() const {
  constexpr long bits = 128;
  const auto turned = turn(rotation(bits), 0, 1, bits);
  if (!turned) throw Undecided("a rotation may have a zero");
  const RealBall extra = divide(subtract(*turned, piece().turn.enclose(bits), bits),
                                whole_turn(1).enclose(bits), bits);
  if (const auto turns = unique_integer(extra)) return *turns;
  throw Undecided("the turn of a rotation is not known well enough");
}

Real RationalTwist::root_mean_square() const {
  return Real([twist = *this](long bits) {
    return *twist.state_->root_mean_square.get(bits, [&](const RealBall*) {
      // √(G ± ε) is √G ± ε/(2√G), and at worst ±√ε.
      constexpr long guard = 24;  // not seen in the bounds of rounded numbers
      const double guess = twist.state_->mean_square_guess;
      const bool is_guessed = guess > 0 && std::isfinite(guess);
      const long smallness = is_guessed ? std::max(0, 1 - std::ilogb(guess) / 2) : bits;
      const Rational wanted = power_of_two(-bits);
      RealBall root;
      for (const long precision : {std::min(2 * bits, bits + guard + smallness), 2 * bits}) {
        const Rotation& w = twist.rotation(working_precision(twist.piece(), precision));
        root = sqrt_of_nonnegative(mean_square(twist.piece(), w, precision), bits + 64);
        if (root.is_finite() && root.radius() <= wanted) break;
      }
      return root;
    });
  });
}

Real RationalTwist::greatest_error() const {
  return Real([twist = *this](long bits) {
    const long precision = working_precision(twist.piece(), bits);
    return phrame::greatest_error(twist.piece(), twist.rotation(precision), bits);
  });
}

SignChanges RationalTwist::inflections(long bits) const {
  return *state_->inflections.get(bits, [&](const SignChanges*) {
    SignChanges found;
    for (long factor = 1; factor <= 4; factor *= 2) {
      const long precision = working_precision(piece(), factor * bits);
      found = sign_changes(turn_numerator(piece(), rotation(precision), precision), factor * bits);
      if (found.is_complete()) break;
    }
    return found;
  });
}

int RationalTwist::sign_of_rate(const Rational& tau) const {
  const long precision = working_precision(piece(), 64);
  const RealBall rate = evaluate(turn_numerator(piece(), rotation(precision), precision),
                                 RealBall(tau, precision), precision);
  return sign(rate);
}

Real RationalTwist::value(const Real& tau) const {
  if (tau.exact() == Rational(0)) return piece().start;
  // To a rational number close to τ, and on from there by a principal argument.
  const Rational near = tau.exact() ? *tau.exact() : tau.enclose(32).lower();
  return piece().start + Real([twist = *this, tau, near](long bits) {
           const long precision = bits + 64;
           const Rotation& w = twist.rotation(precision);
           const auto at = [&](const RealBall& x) {
             return ComplexBall(evaluate(w.a, x, precision), evaluate(w.b, x, precision));
           };
           const auto turned = turn(w, 0, std::clamp(near, Rational(0), Rational(1)), precision);
           if (!turned || tau.exact()) return turned.value_or(RealBall::unknown());
           const ComplexBall step = multiply(at(tau.enclose(precision)),
                                             conjugate(at(RealBall(near, precision))), precision);
           const RealBall half = argument(step, precision);
           return add(*turned, add(half, half, precision), precision);
         });
}

RationalTwist twist_with_end_factor(const TwistPiece& piece, const Rational& gamma) {
  if (gamma == 0) throw DomainError("with γ = 0 the frame would have no orientation at the end");
  if (piece.whole_turns)
    throw DomainError(
        "γ is fixed by the rates at the ends: it is by whole turns that the frame turns against "
        "the Euler-Rodrigues frame");
  const Rational tolerance = abs(gamma) * power_of_two(-100);
  for (long bits = 128; bits <= 8192; bits *= 2) {  // a small γ is what two large numbers leave
    const RotationFamily family = rotation_family(piece, 2, EndRates::matched, bits);
    const RealBall parameter = divide(subtract(RealBall(gamma, bits), family.end_factor[0], bits),
                                      family.end_factor[1], bits);
    if (!parameter.is_finite()) continue;
    const RealBall found = end_factor(family, {parameter.midpoint()}, bits);
    if (absolute(subtract(found, RealBall(gamma, bits), bits)).upper() <= tolerance)
      return {piece, 2, EndRates::matched, {parameter.midpoint()}};
  }
  throw Undecided("the w with this γ, with 8192 bits");
}

BestTwist best_twist(const TwistPiece& piece, const RationalTwistOptions& options) {
  const auto& [degree, rates, prove, bits] = options;
  if (degree < 1 || degree > 8)
    throw DomainError(fmt::format("the degree of the rotation is {}, not 1 to 8", degree));
  if (degree == 1) {
    // w = 1 − τ + γe^{iΔθ/2}τ is real where Δθ ∈ 2πℤ.
    if (piece.whole_turns == Integer(0)) return no_turn(piece);
    if (piece.whole_turns) throw DomainError("a rotation of degree 1 makes less than one turn");
    return best_on_line(piece, 1, EndRates::free, options);
  }
  if (degree == 2 && rates == EndRates::matched) return best_on_line(piece, 2, rates, options);

  const RotationFamily family = rotation_family(piece, degree, rates, coarse_bits);
  TwistObjective objective(piece, family);
  std::optional<RationalTwist> best;
  std::optional<RealBall> least;
  std::vector<std::vector<double>> starts{
      nearest_parameters(along_exact_frame(piece, degree), piece, rates)};
  try {
    best = best_twist(piece, {degree - 1, rates, false, bits}).twist;
    least = coarse_mean_square(*best);
    starts.push_back(nearest_parameters(bernstein(*best, degree), piece, rates));
  } catch (const DomainError&) {  // there is none
  } catch (const Undecided&) {    // none was found
  }
  for (const auto& start : starts) {
    const RationalTwist found(piece, degree, rates, exact(search(objective, start)));
    const RealBall value = coarse_mean_square(found);
    if (best && !is_less(value, *least)) continue;
    best = found;
    least = value;
  }
  return {*best, {}, "of more than one parameter a local optimum is looked for", {}};
}

}  // namespace phrame
