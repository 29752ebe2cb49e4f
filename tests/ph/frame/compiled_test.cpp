#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <limits>
#include <span>
#include <sstream>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/io/read/curve_file.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/transform.hpp"
#include "phrame/ph/frame/angle_polynomials.hpp"
#include "phrame/ph/frame/compiled_angle.hpp"
#include "phrame/ph/frame/compiled_frame.hpp"
#include "phrame/ph/frame/compiled_frame_rotation.hpp"
#include "phrame/ph/frame/compiled_rotation.hpp"
#include "support/curves.hpp"
#include "support/data.hpp"
#include "support/random.hpp"

// Everything is compared with the exact angle and frame, which know nothing of piecewise
// polynomials.

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

constexpr long bits = 140;

/// In [0, 1], many near the ends of pieces, and some tiny.
double parameter(Random& random) {
  if (random.chance(20)) return std::ldexp(1.0, -static_cast<int>(random.integer(0, 1074)));
  const double t = std::ldexp(static_cast<double>(random.integer(0, 1L << 53)), -53);
  if (random.chance(5)) return std::nextafter(std::round(t * 64) / 64, t);
  return t;
}

RealBall exact_angle(RmfAngle& angle, const Rational& start, double t) {
  return add(angle.enclose(exact_rational(t), bits), RealBall(start, bits), bits);
}

/// Horner's rule in doubles, as in a compiled header.
double plain_value(const PiecewisePolynomial& p, double t) {
  const PolynomialPiece& piece = p.at(t);
  const double y = (t - piece.center) * piece.scale;
  const std::vector<double>& c = piece.coefficients;
  const auto degree = static_cast<std::size_t>(p.shape().degree);
  double s = c[0];
  for (std::size_t k = 1; k < degree; ++k) s = s * y + c[k];
  return c[degree] + (c[degree + 1] + s * y);
}

void check_angle(RmfAngle& angle, const Rational& start, const std::vector<double>& at, double from,
                 double to) {
  CompiledAngle compiled(angle, from, to, start);
  const auto plain = compiled_angle(angle, start, from, to, plain_shape(1));
  for (const double t : at) {
    CAPTURE(t);
    CHECK(compiled(t) == round_to_double(angle.value(exact_rational(t)) + start));
    const RealBall exact = exact_angle(angle, start, t);
    const PolynomialPiece& piece = plain.at(t);
    const Rational error =
        exact_rational(piece.error) +
        exact_rational(piece.error_per_y) *
            abs((exact_rational(t) - exact_rational(piece.center)) * exact_rational(piece.scale));
    CHECK(abs(exact_rational(plain_value(plain, t)) - exact.midpoint()) - exact.radius() <= error);
  }
}

void check_frame(const Curve& curve, RmfAngle& angle, const std::vector<double>& at, double from,
                 double to) {
  const CompiledFrames compiled(curve, angle, from, to);
  const Frames frames(curve);
  for (const double t : at) {
    CAPTURE(t);
    const Frame<double> found = compiled(t);
    const Frame<Real> exact = frames.rotation_minimizing(angle, exact_rational(t));
    const auto check = [](const Vector<double>& x, const Vector<Real>& y) {
      for (std::size_t k = 0; k < 3; ++k) {
        const RealBall off =
            subtract(RealBall(exact_rational(x[k]), bits), y[k].enclose(bits), bits);
        CHECK(absolute(off).upper() <= exact_rational(0x1p-53));
      }
    };
    check(found.e1, exact.e1);
    check(found.e2, exact.e2);
    check(found.e3, exact.e3);
    if (const auto rounded = compiled.rounded(t)) {
      CHECK(rounded->e1 == round_to_double(exact.e1));
      CHECK(rounded->e2 == round_to_double(exact.e2));
      CHECK(rounded->e3 == round_to_double(exact.e3));
    }
  }
}

std::vector<double> parameters(Random& random, long count) {
  std::vector<double> at{0, 1};
  while (static_cast<long>(at.size()) < count) at.push_back(parameter(random));
  return at;
}

Curve named(const std::string& name) {
  std::ifstream file(test::data("/curves.jsonl"));
  for (std::string line; std::getline(file, line);)
    if (const NamedCurve curve = read_curve(line); curve.name == name) return curve.curve;
  FAIL(name);
  return test::quintic;
}

/// A = 1 + (t − pole)·(i + j)/distance: σ = 0 near pole ± i·distance/√2.
Curve near_cusp(const Rational& pole, const Rational& distance) {
  const Polynomial line = (1 / distance) * Polynomial{-pole, 1};
  return Curve({Polynomial{1}, line, line, Polynomial{1, 1}});
}

}  // namespace

TEST_CASE("compiled angle and frame: every curve of the collection") {
  std::ifstream file(test::data("/curves.jsonl"));
  Random random(7);
  long curves = 0;
  for (std::string line; std::getline(file, line);) {
    const NamedCurve c = read_curve(line);
    if (preimage_degree(c.curve) > test::everyday(5, 8)) continue;
    CAPTURE(c.name);
    RmfAngle angle(c.curve, Reference::euler_rodrigues);
    const auto at = parameters(random, 12);
    check_angle(angle, 0, at, 0, 1);
    if (++curves % 4 == 0) check_frame(c.curve, angle, at, 0, 1);
  }
  CHECK(curves > 50);
}

TEST_CASE("compiled angle and frame: law: on any interval, from any angle, to both frames") {
  for_samples(12, [](Random& random) {
    const Curve curve = random.curve(3);
    const double from = static_cast<double>(random.integer(-12, 8)) / 7;
    const double to = from + static_cast<double>(random.integer(1, 40)) / 9;
    std::vector<double> at{from, to};
    for (int k = 0; k < 12; ++k) at.push_back(std::min(to, from + (to - from) * parameter(random)));
    if (from < 0 && to > 0) at.insert(at.end(), {0.0, 0x1p-1070, -1e-200});
    try {
      RmfAngle angle(curve, Reference::euler_rodrigues);
      check_angle(angle, random.rational(), at, from, to);
      check_frame(curve, angle, at, from, to);
      RmfAngle frenet(curve, Reference::frenet);
      check_angle(frenet, 0, at, from, to);
    } catch (const DomainError&) {  // a straight line
    } catch (const Undecided&) {    // a pole next to the interval
    }
  });
}

// What the functions of one t give is compared with the exact engine above.
TEST_CASE("compiled angle and frame: law: arrays are what each t gives, in any order") {
  const Curve plane({Polynomial{1, 1}, Polynomial{}, Polynomial{}, Polynomial{0, 2}});  // z = 0
  for_samples(12, [&](Random& random) {
    const Curve curve = random.chance(4)   ? plane
                        : random.chance(3) ? named("deg-nearcusp")
                                           : random.curve(3);
    const RmfAngle angle(curve, Reference::euler_rodrigues);
    std::vector<double> at = parameters(random, random.integer(2, 300));
    if (random.chance(2)) std::sort(at.begin(), at.end());
    std::vector<double> angles(at.size());
    std::vector<Frame<double>> frames(at.size());
    CompiledAngle theta(angle, 0, 1);
    theta(at, angles);
    std::vector<double> in_place = at;
    theta(in_place, in_place);
    CHECK(in_place == angles);
    const CompiledFrames frame(curve, angle, 0, 1);
    frame(at, frames);
    const std::vector<std::size_t> untold = frame.rounded(at, frames);
    frame(at, frames);
    for (std::size_t k = 0; k < at.size(); ++k) {
      CAPTURE(at[k]);
      CHECK(angles[k] == theta(at[k]));
      const auto rounded = frame.rounded(at[k]);
      CHECK(rounded.has_value() == !std::binary_search(untold.begin(), untold.end(), k));
      const Frame<double> one = rounded ? *rounded : frame(at[k]);
      CHECK(frames[k].e1 == one.e1);
      CHECK(frames[k].e2 == one.e2);
      CHECK(frames[k].e3 == one.e3);
    }
  });
}

TEST_CASE("compiled angle and frame: arrays are refused whole") {
  const RmfAngle angle(test::quintic, Reference::euler_rodrigues);
  CompiledAngle theta(angle, 0, 1);
  const CompiledFrames frame(test::quintic, angle, 0, 1);
  std::vector<double> angles(3, 7);
  std::vector<Frame<double>> frames(3, {{7}, {7}, {7}});
  for (const double outside : {-0x1p-1074, std::nextafter(1, 2), std::nan("")}) {
    const std::vector<double> at{0.25, 0.5, outside};
    CHECK_THROWS_WITH_AS(theta(at, angles), doctest::Contains("outside [0, 1]"), DomainError);
    CHECK_THROWS_WITH_AS(frame(at, frames), doctest::Contains("outside [0, 1]"), DomainError);
    CHECK(angles == std::vector<double>(3, 7));
    CHECK(frames[0].e1[0] == 7);
  }
  const std::vector<double> two{0.25, 0.5};
  CHECK_THROWS_WITH_AS(theta(two, angles), doctest::Contains("3 results for 2 values"),
                       DomainError);
  CHECK_THROWS_WITH_AS(frame(two, frames), doctest::Contains("3 results for 2 values"),
                       DomainError);
  theta(std::span<const double>(), std::span<double>());
  frame(std::span<const double>(), std::span<Frame<double>>());
}

// Half of the values were the neighbours of the right ones.
TEST_CASE("compiled angle and frame: whatever the rounding mode is, of making and of asking") {
  Random random(11);
  const Curve curve = random.curve(3);
  const RmfAngle angle(curve, Reference::euler_rodrigues);
  const CompiledAngle angles(angle, 0, 1);
  const CompiledFrames frames(curve, angle, 0, 1);
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const CompiledAngle made(angle, 0, 1);
    std::fesetround(FE_TONEAREST);
    for (int k = 0; k < 100; ++k) {
      const double t = parameter(random);
      std::fesetround(mode);
      const auto theta = angles.rounded(t);
      const auto theta_made = made.rounded(t);
      const auto frame = frames.rounded(t);
      double in_array = 0;
      angles.rounded(std::span(&t, 1), std::span(&in_array, 1));
      std::fesetround(FE_TONEAREST);
      CHECK(in_array == theta.value_or(in_array));
      CHECK(theta == angles.rounded(t));
      CHECK(theta_made.value_or(*theta) == *theta);
      CHECK(frame.has_value() == frames.rounded(t).has_value());
      if (frame) CHECK(frame->e2 == frames.rounded(t)->e2);
    }
  }
}

// t = k/7 is no double.
TEST_CASE("compiled frame: law: at fractions it is that of the exact frames, also beyond [0, 1]") {
  long found = 0;
  long all = 0;
  for_samples(10, [&](Random& random) {
    const Curve curve = random.curve(3);
    RmfAngle angle(curve, Reference::euler_rodrigues);
    try {
      const CompiledFrames compiled(curve, angle, -1, 2);
      const Frames exact(curve);
      for (int k = 0; k < 15; ++k, ++all) {
        const Rational t = k == 0 ? Rational(-1) : Rational(random.integer(-7, 14), 7);
        CAPTURE(t);
        const auto rounded = compiled.rounded(near_number(t));
        if (!rounded) continue;
        ++found;
        const Frame<Real> frame = exact.rotation_minimizing(angle, t);
        CHECK(rounded->e1 == round_to_double(frame.e1));
        CHECK(rounded->e2 == round_to_double(frame.e2));
        CHECK(rounded->e3 == round_to_double(frame.e3));
      }
    } catch (const Undecided&) {  // a pole next to the interval
    }
  });
  CHECK(2 * found > all);
}

// Where polynomials are proved to 2^−52 and better, their rounding hides what else is in the
// bounds.
TEST_CASE("compiled angle and frame: law: the bounds of crude polynomials hold, and are not wide") {
  double closest = 0;  // of all errors to their bounds
  double closest_frame = 0;
  for_samples(15, [&](Random& random) {
    const Curve curve = random.curve(2);
    RmfAngle angle(curve, Reference::euler_rodrigues);
    const long degree = random.integer(1, 6);
    const double goal = std::pow(10.0, -static_cast<double>(random.integer(1, 4)));
    const Rational start = random.rational();
    const auto at = parameters(random, 20);
    const auto share = [](const Rational& off, const Rational& bound) {
      return bound == 0 ? 0 : static_cast<double>(Rational(off / bound));
    };
    const DoubleShape shape{1, degree, 1, goal};
    const auto theta = compiled_angle(angle, start, 0, 1, shape);
    const DoubleShape shape_of_four{4, degree, 1, goal};
    const auto rotation = compiled_rotation(curve, angle, start, 0, 1, shape_of_four);
    const Frames frames(curve);
    for (const double t : at) {
      CAPTURE(t);
      const auto y = [t](const PolynomialPiece& piece) {
        return Rational((exact_rational(t) - exact_rational(piece.center)) *
                        exact_rational(piece.scale));
      };
      const PolynomialPiece& piece = theta.at(t);
      const BallPolynomial p = exact_polynomial(piece.coefficients, shape, 0);
      const RealBall off =
          subtract(evaluate(p, RealBall(y(piece), bits), bits), exact_angle(angle, start, t), bits);
      const Rational bound =
          exact_rational(piece.error) + exact_rational(piece.error_per_y) * abs(y(piece));
      CHECK(absolute(off).lower() <= bound);
      closest = std::max(closest, share(absolute(off).lower(), bound));

      const PolynomialPiece& turn = rotation.at(t);
      const Rational here = y(turn);
      Quaternion<Rational> b;
      Rational* component[] = {&b.u, &b.v, &b.p, &b.q};
      for (long k = 0; k < 4; ++k)
        *component[k] = evaluate(exact_polynomial(turn.coefficients, shape_of_four, k),
                                 RealBall(here, bits), bits)
                            .midpoint();
      const Rational frame_bound = exact_rational(frame_error(turn.error));
      const Frame<Real> exact = turned(as_real(frames.euler_rodrigues(exact_rational(t))),
                                       angle.value(exact_rational(t)) + start);
      const auto check = [&](const Vector<Rational>& found, const Vector<Real>& e) {
        for (std::size_t k = 0; k < 3; ++k) {
          const RealBall ball = subtract(RealBall(found[k], bits), e[k].enclose(bits), bits);
          CHECK(absolute(ball).lower() <= frame_bound);
          closest_frame = std::max(closest_frame, share(absolute(ball).lower(), frame_bound));
        }
      };
      check(rotated_i(b), exact.e1);
      check(rotated_j(b), exact.e2);
      check(rotated_k(b), exact.e3);
    }
  });
  CHECK(closest > 0.2);
  CHECK(closest_frame > 0.1);
}

TEST_CASE("compiled angle: next to a near-cusp, and where doubles are too far apart for it") {
  Random random(3);
  const auto near = [&](double place, double distance) {
    std::vector<double> at;
    for (int k = 0; k < 30; ++k)
      at.push_back(place +
                   distance * std::tan(static_cast<double>(random.integer(-156, 156)) / 100));
    std::erase_if(at, [](double t) { return !(0 <= t && t <= 1); });
    return at;
  };
  const Curve in_collection = named("deg-nearcusp");
  RmfAngle angle(in_collection, Reference::euler_rodrigues);
  check_angle(angle, 0, near(1.0 / 3, 1e-8), 0, 1);
  check_frame(in_collection, angle, near(1.0 / 3, 1e-8), 0, 1);

  const Curve at_zero = near_cusp(0, parse_rational("1e-40"));  // doubles are close there
  RmfAngle steep(at_zero, Reference::euler_rodrigues);
  check_angle(steep, 0, near(0, 1e-40), 0, 1);

  RmfAngle too_steep(near_cusp(Rational(1, 3), parse_rational("1e-19")),
                     Reference::euler_rodrigues);
  CHECK_THROWS_WITH_AS(CompiledAngle(too_steep, 0, 1), doctest::Contains("next to t = 0.33333"),
                       Undecided);
}

TEST_CASE("compiled angle and frame: large and tiny intervals, and angles beyond doubles") {
  Random random(11);
  const Curve curve = named("gen-m02-0");
  RmfAngle angle(curve, Reference::euler_rodrigues);
  for (const auto& [from, to] : {std::pair{3e15, 3e15 + 64}, {1e-200, 2e-200}, {-1e20, 1e20}}) {
    std::vector<double> at{from, to};
    for (int k = 0; k < 10; ++k) at.push_back(from + (to - from) * parameter(random));
    check_angle(angle, 0, at, from, to);
    check_frame(curve, angle, at, from, to);
  }
  for (const std::string start : {"1e30", "1e300"}) {  // the frame is not worse for it
    const auto p =
        compiled_rotation(curve, angle, parse_rational(start), 0, 1, compensated_shape(4));
    for (const PolynomialPiece& piece : p.pieces()) CHECK(piece.error < 0x1p-70);
  }
  const Rational beyond = parse_rational("1e309");
  CHECK_THROWS_AS(CompiledAngle(angle, 0, 1, beyond), Undecided);
}

TEST_CASE("compiled angle: the exact angle is rarely needed, but for 0") {
  RmfAngle angle(named("gen-m02-0"), Reference::euler_rodrigues);
  CompiledAngle compiled(angle, 0, 1);
  Random random(5);
  for (int k = 0; k < 100'000; ++k)
    compiled(std::ldexp(static_cast<double>(random.integer(1, 1L << 53)), -53));
  CHECK(compiled.exact_values() == 0);
  CHECK(compiled(0x1p-900) == round_to_double(angle.value(power_of_two(-900))));
  CHECK(compiled.exact_values() == 0);  // the errors are relative to θ, however small
  CHECK(compiled(0) == 0);
  CHECK(compiled.exact_values() == 1);

  RmfAngle zero(Curve({Polynomial{1, 1}, {}, {}, {}}), Reference::euler_rodrigues);
  CompiledAngle always_zero(zero, 0, 1);
  for (const double t : {0.0, 0.3, 1.0}) CHECK(always_zero(t) == 0);
  CHECK(always_zero.exact_values() == 0);
}

TEST_CASE("compiled angle: next to ties between doubles") {
  std::ifstream file(test::data("/hard-cases.csv"));
  long ties = 0;
  for (std::string line; std::getline(file, line);) {
    std::istringstream cells(line);
    std::string curve, t, quantity, value;
    for (std::string* cell : {&curve, &t, &quantity, &value}) std::getline(cells, *cell, ',');
    if (quantity != "theta" || t.find('/') == std::string::npos) continue;
    const double at = round_to_double(parse_rational(t));
    if (exact_rational(at) != parse_rational(t)) continue;
    CAPTURE(line);
    RmfAngle angle(named(curve), Reference::euler_rodrigues);
    CompiledAngle compiled(angle, std::min(at, 0.0) - 0.1, std::max(at, 0.0) + 0.1);
    CHECK(compiled(at) == std::strtod(value.c_str(), nullptr));
    ++ties;
  }
  CHECK(ties > 10);
}

TEST_CASE("compiled angle and frame: of a spline, through the joints") {
  // The two halves of a curve: the second one's preimage is turned by 3 + i, which append() undoes.
  const auto halves = [](const Curve& curve) {
    const Curve second = segment(curve, Rational(1, 3), 1);
    PhPath path(segment(curve, 0, Rational(1, 3)));
    path.append(
        Curve(second.preimage() * QuaternionPolynomial{Polynomial{3}, Polynomial{1}, {}, {}},
              Polynomial{Rational(1, 10)} * second.multiplier(), second.start()));
    return path;
  };
  Random random(13);
  for (const std::string name : {"gen-m02-0", "gen-m03-1", "deg-nearcusp"}) {
    CAPTURE(name);
    const Curve curve = named(name);
    RmfAngle whole(curve, Reference::euler_rodrigues);
    const Frames exact(curve);
    PathAngle angle(halves(curve));
    CompiledAngle compiled(angle, Rational(1, 7));
    const CompiledFrames frames(angle);
    for (int k = 0; k < 60; ++k) {
      const double t = k == 0 ? 1 : 2 * parameter(random);
      CAPTURE(t);
      const Rational s = exact_rational(t) <= 1 ? Rational(exact_rational(t) / 3)
                                                : Rational((1 + 2 * (exact_rational(t) - 1)) / 3);
      CHECK(compiled(t) == round_to_double(whole.value(s) + Rational(1, 7)));
      const Vector<Real> f2 = exact.rotation_minimizing(whole, s).e2;
      for (std::size_t i = 0; i < 3; ++i) {
        const RealBall off =
            subtract(RealBall(exact_rational(frames(t).e2[i]), bits), f2[i].enclose(bits), bits);
        CHECK(absolute(off).upper() <= exact_rational(0x1p-53));
      }
    }
  }
}

TEST_CASE(
    "compiled frames: all but a few components are rounded correctly without the closed form") {
  const Curve plane({Polynomial{1, 1}, Polynomial{}, Polynomial{}, Polynomial{0, 2}});  // z = 0
  const Curve tilted = rotated(plane, {1, 2, 0, -1});
  for (const Curve& curve : {test::quintic, plane, tilted}) {
    CAPTURE(curve);
    const RmfAngle angle(curve);
    const CompiledFrames compiled(curve, angle, 0, 1);
    const CompiledFrames of_path{PathAngle(Path(curve))};
    const Frames frames(curve);
    int left = 0;
    for (int k = 0; k < 300; ++k) {
      const double t = (k + 0.37) / 300;  // not next to a zero of a component
      const auto rounded = compiled.rounded(t);
      CHECK(rounded.has_value() == of_path.rounded(t).has_value());
      if (!rounded) {
        ++left;
        continue;
      }
      const Frame<Real> exact = frames.rotation_minimizing(angle, exact_rational(t));
      CHECK(rounded->e1 == round_to_double(exact.e1));
      CHECK(rounded->e2 == round_to_double(exact.e2));
      CHECK(rounded->e3 == round_to_double(exact.e3));
      CHECK(of_path.rounded(t)->e2 == rounded->e2);
    }
    CHECK(left <= 3);
  }
}

TEST_CASE("compiled frames: those of Euler and Rodrigues and of Frenet are rounded correctly") {
  // r″ of the cubic hodograph vanishes at t = 1/2: g has a real factor, n jumps.
  const Curve inflected({Polynomial{1, -1, 1}, Polynomial{}, Polynomial{2}, Polynomial{0, 1, -1}});
  for (const Curve& curve :
       {test::quintic, inflected, named("gen-m03-1"), rotated(inflected, {1, 2, 0, -1})}) {
    CAPTURE(curve);
    const Frames frames(curve);
    const CompiledFrames erf(curve, Reference::euler_rodrigues, 3, 4, 3);
    const CompiledFrames frenet(curve, Reference::frenet, 0, 1);
    int left = 0;
    for (int k = 0; k < 100; ++k) {
      const double t = (k + 0.37) / 100;
      const double later = 3 + t;
      const Frame<Rational> exact_erf = frames.euler_rodrigues(exact_rational(later) - 3);
      const auto found_erf = erf.rounded(later);
      const auto found = frenet.rounded(t);
      if (!found || !found_erf) {
        ++left;
        continue;
      }
      CHECK(found_erf->e1 == round_to_double(exact_erf.e1));
      CHECK(found_erf->e2 == round_to_double(exact_erf.e2));
      CHECK(found_erf->e3 == round_to_double(exact_erf.e3));
      const Frame<Real> exact = frames.frenet(exact_rational(t));
      const Vector<double> n = round_to_double(exact.e2);
      const Vector<double> minus_n =
          round_to_double(Vector<Real>{-exact.e2[0], -exact.e2[1], -exact.e2[2]});
      CHECK(found->e1 == round_to_double(exact.e1));
      // Continued through the inflection.
      const GaussianPolynomial g = bend_numerator(without_real_content(curve.preimage()));
      CHECK(found->e2 == (gcd(g.re, g.im)(exact_rational(t)) < 0 ? minus_n : n));
    }
    CHECK(left <= 2);
  }
  const Curve line({Polynomial{1, 1}, Polynomial{}, Polynomial{}, Polynomial{}});
  CHECK_THROWS_AS(CompiledFrames(line, Reference::frenet, 0, 1), DomainError);
}

TEST_CASE("compiled: one segment of a spline is that of the whole") {
  const Curve curve = named("gen-m03-1");
  PhPath path(segment(curve, 0, Rational(1, 3)));
  path.append(segment(curve, Rational(1, 3), 1));
  const PathAngle angle(path);
  const FrameAngle start(Rational(1, 7));
  const CompiledFrames whole(angle, start);
  const CompiledFrames second(angle, 1, start);
  CompiledAngle theta(angle, start);
  const CompiledAngle of_second(angle, 1, start);
  CHECK(second.from() == 1);
  CHECK(second.to() == 2);
  for (const double t : {1.0, 1.3, 1.99, 2.0}) {
    CHECK(second(t).e2 == whole(t).e2);
    CHECK(of_second.rounded(t) == theta(t));
  }
  CHECK_THROWS_AS(second(0.5), DomainError);
}

TEST_CASE("compiled frames: the rotation is a unit quaternion within its error") {
  const RmfAngle angle(test::quintic);
  const CompiledFrames compiled(test::quintic, angle, 0, 1);
  for (const double t : {0.0, 0.125, 0.7, 1.0}) {
    const auto [b, error] = compiled.rotation(t);
    Rational size = 0;
    for (const DoubleDouble& x : {b.u, b.v, b.p, b.q}) {
      const Rational value = exact_rational(x.high) + exact_rational(x.low);
      size += value * value;
    }
    CHECK(abs(size - 1) <= 3 * exact_rational(error));
    CHECK(error <= 0x1p-61);
  }
}

TEST_CASE("compiled angle and frame: outside the interval") {
  RmfAngle angle(test::quintic, Reference::euler_rodrigues);
  CompiledAngle compiled(angle, 0, 1);
  const CompiledFrames frames(test::quintic, angle, 0, 1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double t : {-0x1p-1074, std::nextafter(1.0, 2.0), nan}) {
    CHECK_THROWS_AS(compiled(t), DomainError);
    CHECK_THROWS_AS(frames(t), DomainError);
    CHECK_THROWS_AS(frames.rounded(t), DomainError);
    CHECK_THROWS_AS(frames.rotation(t), DomainError);
  }
  CHECK_THROWS_AS(CompiledAngle(angle, 1, 1), DomainError);
  CHECK_THROWS_AS(CompiledAngle(angle, 0, 1e-300), Undecided);
}
