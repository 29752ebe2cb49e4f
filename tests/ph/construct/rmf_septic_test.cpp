#include "phrame/ph/construct/rmf_septic.hpp"

#include <algorithm>
#include <cmath>

#include "phrame/ph/construct/energy.hpp"
#include "phrame/ph/construct/exact_fit.hpp"
#include "phrame/ph/construct/quintic_family.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

double size(const Vector<double>& v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

/// As seen from the preimage of d₀.
SepticData seen_from_start(const HermiteData<double>& data) {
  const Quaternion<double> a0 = preimage(data.d0);
  const Quaternion<double> a3 = preimage(data.d1);
  const double s = norm(a0);
  const auto [re, im] = direction_of(hermitian_product(a0, a3), 1e-14 * std::sqrt(s * norm(a3)));
  const Quaternion<double> step{0, data.step[0], data.step[1], data.step[2]};
  const Quaternion<double> v = conjugate(a0) * step * a0;
  Quaternion<double> c = (1 / s) * (conjugate(a0) * turned(a3, ComplexOf<double>{re, -im}));
  c.v = 0;
  return {{v.v / (s * s), v.p / (s * s), v.q / (s * s)}, c};
}

/// The curve of these doubles, exactly.
Curve curve_of(const SepticData& data, const SepticShape& shape) {
  std::vector<RationalQuaternion> a;
  for (const Quaternion<double>& x : septic_preimage(data, shape)) a.push_back(exact_quaternion(x));
  return Curve(from_bernstein(a));
}

double greatest(const Polynomial& p) {
  double result = 0;
  for (const Rational& x : to_bernstein(p, 4))
    result = std::max(result, std::abs(static_cast<double>(x)));
  return result;
}

/// Is it a solution, as nearly as doubles are? Integrated exactly, h and r′ from their definitions.
void check_solution(const SepticData& data, const SepticShape& shape, double tolerance) {
  const Curve curve = curve_of(data, shape);
  const double scale = std::max({1.0, norm(data.c0), size(data.step)});
  CHECK(greatest(twist_numerator(curve.preimage())) < tolerance * scale);
  const Vector<Rational> end = evaluate(position(curve), 1);
  const Vector<Rational> derivative = evaluate(hodograph(curve), 1);
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(std::abs(static_cast<double>(end[k]) - data.step[k]) < tolerance * scale);
    CHECK(std::abs(static_cast<double>(derivative[k]) - rotated_i(data.c0)[k]) < tolerance * scale);
  }
}

double energy(const HermiteData<double>& data) {
  const SepticData seen = seen_from_start(data);
  const auto shape = rmf_septic(seen);
  REQUIRE(shape);
  return approximate_energy(septic_preimage(seen, *shape)) / size(data.d0);
}

HermiteData<double> random_ends(Random& random, double from_chord) {
  const auto number = [&] {
    return from_chord * static_cast<double>(random.integer(-1000, 1000)) / 1000;
  };
  const auto vector = [&] { return Vector<double>{1 + number(), number(), number()}; };
  const Vector<double> d0 = vector();
  return {{1, 0, 0}, d0, vector()};
}

}  // namespace

TEST_CASE("RM-ERF septics: there is one for data near the chord and far from it, with h = 0") {
  for (const double from_chord : {0.1, 0.5, 2.0})
    for_samples(20, [&](Random& random) {
      const SepticData data = seen_from_start(random_ends(random, from_chord));
      const auto shape = rmf_septic(data);
      REQUIRE(shape);
      check_solution(data, *shape, 1e-5);  // 24 bits
      const SepticSection section(data, *shape);
      check_solution(data, section.solution(), 1e-10);
    });
}

// By the prototype in Python (SciPy), which has the same start values: of Farouki's left and right
// data, of others near the chord, in a plane, with tangents that are opposite and nearly parallel.
TEST_CASE("RM-ERF septics: their energies are those found elsewhere") {
  struct Row {
    HermiteData<double> data;
    double energy;
  };
  for (const Row& row : {Row{{{1, 1, 1}, {-.8, .3, 1.2}, {.5, -1.3, -1}}, 9.206459005950808},
                         Row{{{1, 1, 1}, {.4, -1.5, -1.2}, {-1.2, -.6, -1.2}}, 19.052788581236832},
                         Row{{{1, 0, 0}, {1.2, .5, -.3}, {.8, .1, .6}}, 1.965931332610138},
                         Row{{{1, .2, .1}, {1, 0, 0}, {1, .4, -.5}}, 1.4398622395827942},
                         Row{{{1, 1, 0}, {1, 0, 0}, {0, 1, 0}}, 2.1350567395175686},
                         Row{{{1, 0, 0}, {0, 1, 0}, {0, -1, 0}}, 9.455884003137829},
                         Row{{{1, .3, .2}, {1, 0, 1e-7}, {1, 1e-7, -1e-7}}, 1.3408515605760634}})
    CHECK(energy(row.data) == doctest::Approx(row.energy).epsilon(1e-5));
}

TEST_CASE("RM-ERF septics: rotated and scaled data have the septic rotated and scaled") {
  for_samples(10, [](Random& random) {
    const HermiteData<double> data = random_ends(random, 0.5);
    const Quaternion<double> u{0.5, -0.5, 0.5, 0.5};
    const double scale = 3;
    const auto moved = [&](const Vector<double>& v) {
      const Quaternion<double> w = u * Quaternion<double>{0, v[0], v[1], v[2]} * conjugate(u);
      return Vector<double>{scale * w.v, scale * w.p, scale * w.q};
    };
    CHECK(scale * energy({moved(data.step), moved(data.d0), moved(data.d1)}) ==
          doctest::Approx(energy(data)).epsilon(1e-6));
  });
}

TEST_CASE("RM-ERF septics: plane data and nearly parallel tangents are no exception") {
  for (const double e : {1e-1, 1e-3, 1e-6, 1e-9, 1e-12, 1e-15, 0.0}) {
    CAPTURE(e);
    const SepticData near_plane = seen_from_start({{1, .1, .7 * e}, {1, .5, 0}, {1, -.5, e}});
    const auto shape = rmf_septic(near_plane);
    REQUIRE(shape);
    check_solution(near_plane, SepticSection(near_plane, *shape).solution(), 1e-11);
  }
  for (const double e : {1e-1, 1e-3, 1e-6, 1e-9}) {
    CAPTURE(e);
    // c₀ with the digits that e has, which doubles of the derivatives do not have.
    const SepticData data{{1, .3, .2}, {1, 0, e, -e / 3}};
    CHECK(phase_unit(data) <= 2 * e);
    CHECK(phase_unit(data) >= e / 2);
    const auto shape = rmf_septic(data);
    REQUIRE(shape);
    check_solution(data, SepticSection(data, *shape).solution(), 1e-11);
  }
}

TEST_CASE("RM-ERF septics: a change moves the end as wanted, and h stays 0") {
  for_samples(20, [](Random& random) {
    const SepticData data = seen_from_start(random_ends(random, random.chance(2) ? 0.5 : 2));
    const auto shape = rmf_septic(data);
    REQUIRE(shape);
    const SepticSection section(data, *shape);
    constexpr double small = 1e-5;
    const Vector<double> wanted{small, -small / 2, small / 3};
    const std::vector<double> change = section.change({wanted[0], wanted[1], wanted[2]});
    SepticShape moved = section.solution();
    moved.turn += change[0];
    if (section.keeps_phase()) CHECK(change[0] == 0);
    for (std::size_t k = 0; k < 3; ++k) {
      moved.b[k] += change[1 + k];
      moved.b_prime[k] += change[4 + k];
    }
    SepticData other = data;
    for (std::size_t k = 0; k < 3; ++k) other.step[k] += wanted[k];
    check_solution(other, moved, 1e-7);  // small², times what curves
  });
}
