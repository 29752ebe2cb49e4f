#include "phrame/ph/construct/quintic_family.hpp"

#include <cmath>
#include <numbers>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/construct/energy.hpp"
#include "support/random.hpp"

using namespace phrame;

using test::for_samples;
using test::Random;

namespace {

constexpr double half_turn = std::numbers::pi;

using Data = HermiteData<double>;

// Data of Farouki's talk on helical curves, "left" and "right". All numbers of these tests that
// have many digits were computed by a program in Python, with mpmath.
const Data left{{1, 1, 1}, {-0.8, 0.3, 1.2}, {0.5, -1.3, -1}};
const Data right{{1, 1, 1}, {0.4, -1.5, -1.2}, {-1.2, -0.6, -1.2}};

double value(const Angle& angle) { return round_to_double(to_real(angle)); }

double energy(const QuinticFamily& family, const FreeAngles& angles) {
  return approximate_energy(family.member(value(angles.delta), value(angles.phi)));
}

double energy(const Data& data, QuinticSelection selection) {
  const QuinticFamily family(data);
  return energy(family, family.choose(selection));
}

bool is_near(double a, double b, double tolerance) {
  return std::abs(a - b) <= tolerance * std::max({1.0, std::abs(a), std::abs(b)});
}

Vector<double> displacement(const QuinticFamily::Member& a) {
  const Quaternion<double> b = 3.0 * (a[0] + a[2]) + 4.0 * a[1];
  return (1.0 / 120) * (rotated_i(b) + 15.0 * (rotated_i(a[0]) + rotated_i(a[2])) -
                        10.0 * symmetric_product(a[0], a[2]));
}

double normal(Random& random) {
  double sum = 0;
  for (int k = 0; k < 12; ++k) sum += static_cast<double>(random.integer(0, 1'000'000)) * 1e-6;
  return sum - 6;
}

Vector<double> normal_vector(Random& random) {
  return {normal(random), normal(random), normal(random)};
}

/// Every other near the chord.
Data random_hermite(Random& random) {
  const Vector<double> step{1, 0, 0};
  const Vector<double> a = normal_vector(random);
  const Vector<double> b = normal_vector(random);
  if (random.chance(2)) return {step, a, b};
  return {step, step + 0.5 * a, step + 0.5 * b};
}

const std::vector<QuinticSelection> all_selections{
    QuinticSelection::automatic, QuinticSelection::minimal,  QuinticSelection::bv,
    QuinticSelection::cc,        QuinticSelection::shortest, QuinticSelection::longest,
    QuinticSelection::energy};

}  // namespace

TEST_CASE("quintics: lengths and energies of the solutions with angles φ₀, φ₁, φ₂") {
  struct Row {
    Data data;
    SolutionAngles angles;
    double length;
    double energy;
  };
  for (const Row& row :
       {Row{left, {0, 0, 0}, 2.31036187855954887, 8.86009090365239988},
        Row{left, {half_turn / 4, 0, -half_turn / 3}, 2.29863983414699782, 10.88704276390110641},
        Row{right, {0, 0, 0}, 2.31808574387981922, 50.45427402057894178},
        Row{right,
            {half_turn / 4, 0, -half_turn / 3},
            2.74879039181415918,
            21.49660241857558372}}) {
    const QuinticFamily family(row.data);
    const FreeAngles angles = family.angles(row.angles);
    CHECK(is_near(family.length(value(angles.delta)), row.length, 1e-13));
    CHECK(is_near(energy(family, angles), row.energy, 1e-8));
    // The same number more in all three turns A alone.
    const auto [a, b, c] = row.angles;
    const FreeAngles same = family.angles({a + 1, b + 1, c + 1});
    CHECK(
        is_near(std::remainder(value(same.delta) - value(angles.delta), 2 * half_turn), 0, 1e-14));
    CHECK(is_near(std::remainder(value(same.phi) - value(angles.phi), 2 * half_turn), 0, 1e-14));
  }
}

TEST_CASE("quintics: the shortest and the longest are as long as the helical ones") {
  const auto length = [](const Data& data, QuinticSelection selection) {
    const QuinticFamily family(data);
    return family.length(value(family.choose(selection).delta));
  };
  CHECK(is_near(length(left, QuinticSelection::longest), 2.35974267543260545, 1e-11));
  CHECK(is_near(length(left, QuinticSelection::shortest), 2.06886961655150659, 1e-11));
  CHECK(is_near(length(right, QuinticSelection::longest), 2.87797896696405226, 1e-11));
  CHECK(is_near(length(right, QuinticSelection::shortest), 2.30316776436017593, 1e-11));
}

TEST_CASE("quintics: energies of the selections, as another program in Python has them") {
  CHECK(is_near(energy(left, QuinticSelection::bv), 8.30223, 1e-6));
  CHECK(is_near(energy(right, QuinticSelection::bv), 16.14590, 1e-6));
  CHECK(is_near(energy(left, QuinticSelection::cc), 8.29871, 1e-6));
  CHECK(is_near(energy(right, QuinticSelection::cc), 16.16634, 1e-6));
  CHECK(is_near(energy(left, QuinticSelection::energy), 8.26259, 1e-6));
  CHECK(is_near(energy(right, QuinticSelection::energy), 16.12280, 1e-6));
}

TEST_CASE("quintics: every member has the data, and its length does not depend on φ") {
  for_samples(60, [](Random& random) {
    const Data data = random_hermite(random);
    const QuinticFamily family(data);
    const double delta = normal(random);
    for (const double phi : {0.0, normal(random)}) {
      const auto a = family.member(delta, phi);
      const Vector<double> off = displacement(a) - data.step;
      CHECK(std::sqrt(dot(off, off)) < 1e-13);
      for (std::size_t k = 0; k < 3; ++k) {
        CHECK(is_near(rotated_i(a[0])[k], data.d0[k], 1e-14));
        CHECK(is_near(rotated_i(a[2])[k], data.d1[k], 1e-14));
      }
      // ∫|A|² by Bernstein products: Σ C(2,i)C(2,j)/(5·C(4,i+j))·A_i·A_j.
      const auto scalar = [&](std::size_t i, std::size_t j) {
        return hermitian_product(a[i], a[j]).re;
      };
      const double length = (scalar(0, 0) + scalar(0, 1) + scalar(1, 2) + scalar(2, 2) +
                             (2 * scalar(1, 1) + scalar(0, 2)) / 3) /
                            5;
      CHECK(is_near(length, family.length(delta), 1e-13));
      const auto h = hermitian_product(a[0], a[2]);
      CHECK(is_near(std::remainder(std::atan2(h.im, h.re) - delta, 2 * half_turn), 0, 1e-12));
    }
  });
}

TEST_CASE("quintics: auto has the least energy of minimal, bv and cc; energy has not more") {
  for_samples(40, [](Random& random) {
    const Data data = random_hermite(random);
    const double automatic = energy(data, QuinticSelection::automatic);
    for (const auto selection :
         {QuinticSelection::minimal, QuinticSelection::bv, QuinticSelection::cc})
      CHECK(automatic <= energy(data, selection) * (1 + 1e-9));
    CHECK(energy(data, QuinticSelection::energy) <= automatic * (1 + 1e-9));
  });
}

// Of A linear, in degree 2.
TEST_CASE("quintics: bv and cc give a PH cubic back, as far as angles of 20 bits do") {
  for_samples(40, [](Random& random) {
    const auto quaternion = [&] {
      return Quaternion<double>{normal(random), normal(random), normal(random), normal(random)};
    };
    const Quaternion<double> a0 = quaternion();
    const Quaternion<double> a2 = quaternion();
    const QuinticFamily::Member cubic{a0, 0.5 * (a0 + a2), a2};
    const QuinticFamily family({displacement(cubic), rotated_i(a0), rotated_i(a2)});
    for (const auto selection : {QuinticSelection::bv, QuinticSelection::cc}) {
      const FreeAngles angles = family.choose(selection);
      const auto a = family.member(value(angles.delta), value(angles.phi));
      const Quaternion<double> second = a[0] + a[2] - 2.0 * a[1];
      CHECK(norm(second) <= 1e-9 * (norm(a0) + norm(a2)));
      CHECK(is_near(approximate_energy(a), approximate_energy(cubic), 1e-4));
    }
  });
}

TEST_CASE(
    "quintics: Δ and φ do not change where the data are rotated, mirrored in time or scaled") {
  for_samples(30, [](Random& random) {
    const Data data = random_hermite(random);
    // v ↦ U v U*: scaled by |U|², too.
    const Quaternion<double> u{normal(random), normal(random), normal(random), normal(random)};
    const auto moved = [&](const Vector<double>& v) {
      const Quaternion<double> image =
          u * Quaternion<double>{0, v[0], v[1], v[2]} * Quaternion<double>{u.u, -u.v, -u.p, -u.q};
      return Vector<double>{image.v, image.p, image.q};
    };
    const QuinticFamily family(data);
    const QuinticFamily rotated({moved(data.step), moved(data.d0), moved(data.d1)});
    // r(1 − t), turned around: −r′(1 − t), and −1 in space once more.
    const QuinticFamily reversed({data.step, data.d1, data.d0});
    for (const auto selection : all_selections) {
      const FreeAngles angles = family.choose(selection);
      CAPTURE(static_cast<int>(selection));
      CAPTURE(energy(family, angles));
      CAPTURE(energy(rotated, rotated.choose(selection)) * norm(u));
      CHECK(is_near(energy(family, angles), energy(rotated, rotated.choose(selection)) * norm(u),
                    1e-4));
      CHECK(is_near(energy(family, angles), energy(reversed, reversed.choose(selection)), 1e-4));
      CHECK(is_near(rotated.length(value(angles.delta)) / norm(u),
                    family.length(value(angles.delta)), 1e-12));
      CHECK(is_near(energy(rotated, angles) * norm(u), energy(family, angles), 1e-9));
    }
  });
}

TEST_CASE("quintics: symmetric plane data have Δ = 0 and φ = 0, or half a turn, exactly") {
  const QuinticFamily arch({{1, 0, 0}, {1, 1, 0}, {1, -1, 0}});
  for (const auto selection : all_selections) {
    const FreeAngles angles = arch.choose(selection);
    CHECK(angles.delta.radians == 0);
    CHECK(denominator(angles.delta.half_turns) == 1);
    CHECK(denominator(angles.phi.half_turns) == 1);
  }
  // The good one of four plane quintics with these data, E in Python: 2.285.
  CHECK(is_near(approximate_energy(arch.member(0, 0)), 2.285, 1e-3));
  CHECK(approximate_energy(arch.member(0, half_turn)) > 1800);
}

TEST_CASE(
    "quintics: data at the edge have a member, or the direction that has no angles is named") {
  for (const Data& data :
       {Data{{1, 0, 0}, {0, 1, 0}, {0, -1, 0}},     // antiparallel
        Data{{1, 0, 0}, {1, 2, 3}, {-1, -2, -3}},   // the same, not along axes
        Data{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},      // a loop
        Data{{-1, 0, 0}, {-1, 0, 0}, {-1, 0, 0}},   // straight, backwards
        Data{{1, 0, 0}, {9, 0, 0}, {9, 0, 0}},      // straight, too fast
        Data{{1, 0.2, 0}, {0, 0, 0}, {1, 0, 0.3}},  // a cusp
        Data{{0.25, 0, 0}, {1, 0, 0}, {1, 0, 0}}, Data{{1, 0, 0}, {0, 1, 0}, {0, -1, 1e-13}},
        Data{{-1, 1e-12, 0}, {-1, 1e-15, 1e-16}, {-1, 0, 1e-14}}}) {
    const QuinticFamily family(data);
    for (const auto selection : all_selections) {
      const FreeAngles angles = family.choose(selection);
      const auto a = family.member(value(angles.delta), value(angles.phi));
      const Vector<double> off = displacement(a) - data.step;
      CHECK(std::sqrt(dot(off, off)) < 1e-12);
    }
  }
  const QuinticFamily backwards({{1, 0, 0}, {-1, 0, 0}, {1, 0, 0}});
  CHECK_THROWS_WITH_AS(backwards.angles({0, 0, 0}),
                       "the angles phi0, phi1, phi2: the derivative at the start has the direction "
                       "(-1, 0, 0), where they mean nothing",
                       DomainError);
}

// r is the integral of the hodograph; by Simpson's rule, which is exact for its pieces to 1e-12.
TEST_CASE("quintics: the order of minimal, bv, cc, auto and energy is four") {
  for (const QuinticSelection selection :
       {QuinticSelection::minimal, QuinticSelection::bv, QuinticSelection::cc,
        QuinticSelection::automatic, QuinticSelection::energy}) {
    CAPTURE(static_cast<int>(selection));
    const auto error = [&](double h) {
      const auto r = [](double t) {
        return Vector<double>{std::cos(t), std::sin(2 * t) / 2, t * t / 3};
      };
      const auto d = [&](double t) {
        return h * Vector<double>{-std::sin(t), std::cos(2 * t), 2 * t / 3};
      };
      constexpr double start = 0.25;
      const QuinticFamily family({r(start + h) - r(start), d(start), d(start + h)});
      const FreeAngles angles = family.choose(selection);
      const auto a = family.member(value(angles.delta), value(angles.phi));
      const auto hodograph = [&](double t) {
        const Quaternion<double> w =
            (1 - t) * (1 - t) * a[0] + 2 * t * (1 - t) * a[1] + t * t * a[2];
        return rotated_i(w);
      };
      constexpr int steps = 400;
      Vector<double> at = r(start);
      double greatest = 0;
      for (int k = 0; k < steps; ++k) {
        const double t = static_cast<double>(k) / steps;
        const double half = 0.5 / steps;
        at = at + (half / 3) * (hodograph(t) + 4.0 * hodograph(t + half) + hodograph(t + 2 * half));
        const Vector<double> off = at - r(start + h * (t + 2 * half));
        greatest = std::max(greatest, std::sqrt(dot(off, off)));
      }
      return greatest;
    };
    const double ratio = error(0.1) / error(0.05);
    CHECK(ratio > 13);
    CHECK(ratio < 22);
  }
}

// Δ and φ come out as multiples of π/2²⁰, so that they may differ by one or two of these.
TEST_CASE("quintics: law: the curves are turned, scaled and reversed with their data") {
  for_samples(40, [](Random& random) {
    const Data data = random_hermite(random);
    const Quaternion<double> q{normal(random), normal(random), normal(random), normal(random)};
    const double scale = std::exp(normal(random));
    const auto turned = [&](const Vector<double>& v) -> Vector<double> {
      const Quaternion<double> w = q * Quaternion<double>{0, v[0], v[1], v[2]} * conjugate(q);
      return scale / norm(q) * Vector<double>{w.v, w.p, w.q};
    };
    const QuinticFamily family(data);
    const QuinticFamily other({turned(data.step), turned(data.d0), turned(data.d1)});
    const QuinticFamily back({-1.0 * data.step, -1.0 * data.d1, -1.0 * data.d0});
    for (const QuinticSelection selection :
         {QuinticSelection::minimal, QuinticSelection::bv, QuinticSelection::cc,
          QuinticSelection::shortest, QuinticSelection::longest}) {
      CAPTURE(static_cast<int>(selection));
      const FreeAngles angles = family.choose(selection);
      const FreeAngles of_other = other.choose(selection);
      const double off = std::remainder(value(angles.delta) - value(of_other.delta), 2 * half_turn);
      CHECK(std::abs(off) < 1e-5);
      CHECK(is_near(energy(family, angles), scale * energy(other, of_other), 1e-3));
      CHECK(is_near(family.length(value(angles.delta)), other.length(value(of_other.delta)) / scale,
                    1e-9));
      const FreeAngles of_back = back.choose(selection);
      CHECK(is_near(family.length(value(angles.delta)), back.length(value(of_back.delta)), 1e-9));
    }
  });
}
