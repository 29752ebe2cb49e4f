#include "phrame/ph/frame/frame_start.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/along/path_angle.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/frame/compiled_frame.hpp"
#include "phrame/ph/frame/path_frame.hpp"
#include "support/curves.hpp"
#include "support/paths.hpp"
#include "support/random.hpp"
#include "support/refusal.hpp"

namespace frame_start_test {

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

constexpr long bits = 300;

RealBall dot(const Vector<Real>& a, const Vector<Real>& b) {
  RealBall sum;
  for (std::size_t k = 0; k < 3; ++k)
    sum = add(sum, multiply(a[k].enclose(bits), b[k].enclose(bits), bits), bits);
  return sum;
}

/// v − (v·e₁)e₁.
Vector<Rational> projected(const Vector<Rational>& v, const Vector<Rational>& e1) {
  return v - dot(v, e1) * e1;
}

Vector<Rational> random_vector(Random& random) {
  return {random.rational(), random.rational(), random.rational()};
}

/// x/√s.
RealBall over_root(const Rational& x, const Rational& s) {
  return divide(RealBall(x, bits), sqrt(RealBall(s, bits), bits), bits);
}

bool are_equal(const RealBall& x, const RealBall& y) {
  const RealBall difference = subtract(x, y, bits);
  return difference.contains_zero() && difference.radius() < power_of_two(-200);
}

Vector<Real> second_vector(const Curve& curve, const Rational& t, const StartNormal& normal) {
  return Frames(curve)
      .rotation_minimizing(RmfAngle(curve), t, start_angle(normal, PhPath(curve)))
      .e2;
}

std::string digits(const Real& x, long count) { return round_to_decimal(x, count).value; }

}  // namespace

TEST_CASE("frame start: law: f2 starts along the projected vector, to all digits") {
  for_samples(60, [](Random& random) {
    const Curve curve = PhPath(random.curve(2)).segments().front();
    const Vector<Rational> e1 = euler_rodrigues_frame(curve, 0).e1;
    const Vector<Rational> v = random_vector(random);
    const Vector<Rational> p = projected(v, e1);
    if (dot(p, p) == 0) {
      CHECK_THROWS_AS(start_angle(StartNormal(v), PhPath(curve)), DomainError);
      return;
    }
    const Vector<Real> f2 = second_vector(curve, 0, StartNormal(v));
    for (std::size_t k = 0; k < 3; ++k)
      CHECK(are_equal(f2[k].enclose(bits), over_root(p[k], dot(p, p))));
  });
}

TEST_CASE("frame start: law: frames with different starts keep their angle") {
  for_samples(25, [](Random& random) {
    const Curve curve = PhPath(random.curve(2)).segments().front();
    const Vector<Rational> e1 = euler_rodrigues_frame(curve, 0).e1;
    const Vector<Rational> v = random_vector(random);
    const Vector<Rational> w = random_vector(random);
    const Vector<Rational> p = projected(v, e1);
    const Vector<Rational> q = projected(w, e1);
    if (dot(p, p) == 0 || dot(q, q) == 0) return;
    const Rational t = random.rational();
    const Vector<Real> f = second_vector(curve, t, StartNormal(v));
    const Vector<Real> g = second_vector(curve, t, StartNormal(w));
    CHECK(are_equal(dot(f, g), over_root(dot(p, q), dot(p, p) * dot(q, q))));
  });
}

// By Rodrigues' formula with the axis i × e₁: v + n × v + n × (n × v)/(1 + cos), n = i × e₁.
Vector<Rational> turned_least(const Vector<Rational>& v, const Vector<Rational>& e1) {
  const Vector<Rational> n{0, -e1[2], e1[1]};
  const Vector<Rational> once = cross(n, v);
  return v + once + 1 / (1 + e1[0]) * cross(n, once);
}

TEST_CASE("frame start: law: the least rotation takes the y axis to f2, and an angle turns it") {
  for_samples(60, [](Random& random) {
    const Curve curve = PhPath(random.curve(2)).segments().front();
    const Frame<Rational> erf = euler_rodrigues_frame(curve, 0);
    if (erf.e1[0] == -1) return;
    const auto start = [&](const Angle& turn) {
      return Frames(curve).rotation_minimizing(RmfAngle(curve), 0,
                                               start_angle(LeastRotation{turn}, PhPath(curve)));
    };
    const Frame<Real> f = start({});
    const Frame<Real> quarter = start({Rational(1, 2), 0});
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(f.e2[k].exact() == turned_least({0, 1, 0}, erf.e1)[k]);
      CHECK(f.e3[k].exact() == turned_least({0, 0, 1}, erf.e1)[k]);
      CHECK(quarter.e2[k].exact() == f.e3[k].exact());
    }
  });
}

TEST_CASE("frame start: along the negative x axis there is no least rotation") {
  CHECK(least_rotation_normal({-1, 0, 0}) == Vector<Rational>{0, 1, 0});
  const PhPath backwards(Curve({{}, {}, {1}, {}}));  // j i j* = −i
  CHECK(Frames(backwards.segments().front())
            .rotation_minimizing(RmfAngle(backwards.segments().front()), 0,
                                 start_angle(LeastRotation{}, backwards))
            .e2[1]
            .exact() == Rational(1));
}

TEST_CASE("frame start: law: it does not depend on how the curve is given") {
  for_samples(30, [](Random& random) {
    const PhPath path(random.curve(2));
    const Path smooth = test::by_positions(path);
    const PathAngle angle(smooth);
    const Frame<Real> g =
        rotation_minimizing_frame(angle, {0, Rational(1)}, start_angle(LeastRotation{}, angle));
    const Curve& curve = path.segments().front();
    const Frame<Real> f =
        Frames(curve).rotation_minimizing(RmfAngle(curve), 1, start_angle(LeastRotation{}, path));
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(are_equal(f.e1[k].enclose(bits), g.e1[k].enclose(bits)));
      CHECK(are_equal(f.e2[k].enclose(bits), g.e2[k].enclose(bits)));
      CHECK(are_equal(f.e3[k].enclose(bits), g.e3[k].enclose(bits)));
    }
  });
}

TEST_CASE("frame start: e1 is the tangent where the multiplier is negative at the start") {
  const Curve curve({{1}, {0, 1}, {2}, {0, 0, 1}}, {-1, 0, -1});
  const Vector<Rational> slope = evaluate(hodograph(curve), 0);
  CHECK(dot(euler_rodrigues_frame(PhPath(curve).segments().front(), 0).e1, slope) > 0);
  CHECK(dot(euler_rodrigues_frame(curve, 0).e1, slope) < 0);
}

// Angles to the Euler–Rodrigues frame and to the Frenet frame, which know nothing of each other.
TEST_CASE("frame start: law: from both frames that angles are measured from it is the same") {
  for_samples(25, [](Random& random) {
    const Curve curve = PhPath(random.curve(2)).segments().front();
    const GaussianPolynomial g = bend_numerator(curve.preimage());
    const StartNormal normal(random_vector(random));
    const Vector<Rational> p = projected(normal.vector, euler_rodrigues_frame(curve, 0).e1);
    const Rational t = random.rational();
    // Frenet's frame is continued through inflections; here there are none.
    if (dot(p, p) == 0 || is_zero(g) || count_real_roots(norm(g), real_line()) > 0) return;
    const FrameAngle start = start_angle(normal, PhPath(curve), Reference::frenet);
    const Real theta = RmfAngle(curve, Reference::frenet).value(t, start);
    const Vector<Real> f = turned(frenet_frame(curve, t), theta).e2;
    const Vector<Real> g2 = second_vector(curve, t, normal);
    for (std::size_t k = 0; k < 3; ++k) CHECK(are_equal(f[k].enclose(bits), g2[k].enclose(bits)));
  });
}

// A = 1 + t²k: r′ = (1 − t⁴, 2t², 0) is in a plane and turns left for t > 0.
TEST_CASE("frame start: at an inflection the Frenet frame is that behind it") {
  const PhPath path(Curve({{1}, {}, {}, {0, 0, 1}}));
  const auto over_pi_of = [&](const Vector<Rational>& v) {
    return over_pi(start_angle(StartNormal(v), path, Reference::frenet));
  };
  CHECK(over_pi_of({5, 1, 0}) == Rational(0));
  CHECK(over_pi_of({0, 0, 1}) == Rational(1, 2));
  CHECK(over_pi_of({0, -1, 1}) == Rational(3, 4));
  const PhPath line(Curve({{1}, {0, 1}, {}, {}}));
  CHECK_THROWS_AS(start_angle(StartNormal({0, 1, 0}), line, Reference::frenet), DomainError);
}

TEST_CASE("frame start: a cusp there is no matter") {
  const StartNormal normal({0, 1, 2});
  const FrameAngle regular = start_angle(normal, PhPath(test::quintic));
  const QuaternionPolynomial& a = test::quintic.preimage();
  const Polynomial t{0, 1};
  CHECK(start_angle(normal, PhPath(Curve(a, t))) == regular);
  CHECK(start_angle(normal, PhPath(Curve({t * a.u, t * a.v, t * a.p, t * a.q}))) == regular);
}

TEST_CASE("frame start: what has no direction is refused, with the reason") {
  const PhPath path(test::quintic);  // e₁ = (2, 2, 1)/3 at t = 0
  const auto message = [&](const Vector<Rational>& v) -> std::string {
    return test::refusal_of<DomainError>([&] { start_angle(StartNormal(v), path); });
  };
  CHECK(message({0, 0, 0}) == "the vector (0, 0, 0) has no part in the normal plane");
  CHECK(message({Rational(-1, 2), Rational(-1, 2), Rational(-1, 4)}) ==
        "the vector (-1/2, -1/2, -1/4) has no part in the normal plane: it is along the tangent");
  CHECK(message({2, 2, 1 + parse_rational("1e-1000")}).empty());
  CHECK(start_angle(Angle(Rational(1, 3), 7), path) == FrameAngle(Rational(1, 3), 7));
}

TEST_CASE("frame start: the frame of a vector is refused where there is no vector") {
  CHECK(test::refusal_of<DomainError>([] { RmfAngle(test::quintic, Reference::up); }) ==
        "the angle to the frame of a vector v is RmfAngle(preimage, v)");
  CHECK(test::refusal_of<DomainError>([] { CompiledFrames(test::quintic, Reference::up, 0, 1); }) ==
        "compiled frames: that of a vector v is not among them");
  CHECK(test::refusal_of<DomainError>([] {
          start_angle(LeastRotation(), PhPath(test::quintic), Reference::up);
        }) == "the angle to the frame of a vector v is that of PathAngle(path, v)");
  CHECK(test::refusal_of<DomainError>([] {
          start_angle(LeastRotation(), test::quintic, Reference::up);
        }) == "the up vector is 0");
}

// A = 1 + ti has θ = −2 arctan t: θ(1/2) = −arctan(4/3), θ(1) = −π/2.
TEST_CASE("frame start: angles that it cancels are exact, also through joints") {
  const Curve turning({{1}, {0, 1}, {}, {}});
  const FrameAngle start = angle_of(GaussianRational{3, 4});
  const RmfAngle angle(turning);
  CHECK(angle.value(Rational(1, 2), start).exact() == Rational(0));
  CHECK(angle.value(Rational(1, 2), {0, 5, {3, 4}}).exact() == Rational(5));
  // −arctan(3/4), by mpmath.
  CHECK(digits(angle.value(1, start), 30) == "-0.643501108793284386802809228717");
  CHECK(digits(angle.value(0, start), 30) == "0.927295218001612232428512462922");
  const PathAngle twice(test::chain({turning, turning}));
  CHECK(twice.value(Rational(3, 2), FrameAngle(Rational(1, 2), 0, {3, 4})).exact() == Rational(0));
  CHECK(digits(twice.value(Rational(3, 2), start), 30) ==
        digits(-angle.value(1), 30).insert(0, "-"));
}

TEST_CASE("frame start: of a spline it is that of the first segment") {
  const StartNormal normal({1, 2, -3});
  const PhPath whole(test::quintic);
  const PhPath pieces = test::cut(test::quintic, {Rational(1, 3), Rational(3, 4)});
  CHECK(digits(PathAngle(pieces).value(3, start_angle(normal, pieces)), 40) ==
        digits(PathAngle(whole).value(1, start_angle(normal, whole)), 40));
}

}  // namespace frame_start_test
