#include "phrame/ph/construct/c2_equations.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "phrame/ph/construct/preimage.hpp"

using namespace phrame;

namespace {

/// Steps of the parameter that differ, and derivatives that are about those of the points.
C2Data data_of(bool is_plane) {
  C2Data data;
  data.steps = {1, 0.75, 1.5, 1.25};
  data.chords = {{1, 0.5, 0.25}, {1, -0.75, 0.5}, {1, 0.75, -0.5}, {1, -0.5, 0.125}};
  data.derivatives = {{1, 0, 0.5}, {1.25, 0, 0.25}, {1, -0.25, 0}, {0.75, 0, 0}, {1, 0.5, -0.25}};
  data.is_plane = is_plane;
  return data;
}

/// The chords and the end derivatives times their steps, as c2_step() has them.
std::vector<double> conditions(const C2Data& data, const std::vector<Quaternion<double>>& z) {
  const std::size_t n = data.steps.size();
  std::vector<Quaternion<double>> joints;
  for (std::size_t k = 0; k <= n; ++k) {
    const double before = data.steps[k > 0 ? k - 1 : 0];
    const double after = data.steps[k < n ? k : n - 1];
    joints.push_back((1 / (before + after)) * (after * z[k] + before * z[k + 1]));
  }
  std::vector<double> result;
  const auto put = [&](double factor, const Vector<double>& v) {
    for (std::size_t c = 0; c < (data.is_plane ? 2U : 3U); ++c) result.push_back(factor * v[c]);
  };
  put(data.steps.front(), rotated_i(joints.front()));
  for (std::size_t k = 0; k < n; ++k) {  // Simpson's rule would not do: r' has degree 4
    Vector<double> sum{};
    const double root = std::sqrt(0.6);
    for (const auto& [node, weight] :
         {std::pair(-root, 5.0 / 18), std::pair(0.0, 8.0 / 18), std::pair(root, 5.0 / 18)}) {
      const double t = (1 + node) / 2;
      const auto a =
          ((1 - t) * (1 - t)) * joints[k] + (2 * t * (1 - t)) * z[k + 1] + (t * t) * joints[k + 1];
      sum = sum + weight * rotated_i(a);
    }
    put(data.steps[k], sum);
  }
  put(data.steps.back(), rotated_i(joints.back()));
  return result;
}

std::vector<double> wanted(const C2Data& data) {
  std::vector<double> result;
  const auto put = [&](double factor, const Vector<double>& v) {
    for (std::size_t c = 0; c < (data.is_plane ? 2U : 3U); ++c) result.push_back(factor * v[c]);
  };
  put(data.steps.front(), data.derivatives.front());
  for (const Vector<double>& chord : data.chords) put(1, chord);
  put(data.steps.back(), data.derivatives.back());
  return result;
}

}  // namespace

TEST_CASE("c2_coefficients: the equations hold, by quadrature, in space and in the plane") {
  for (const bool is_plane : {false, true}) {
    const C2Data data = data_of(is_plane);
    C2Data flat = data;  // what the plane leaves out is not looked at
    if (is_plane)
      for (Vector<double>& d : flat.derivatives) d[2] = 0;
    const auto found = c2_coefficients(flat);
    REQUIRE(found);
    REQUIRE(found->z.size() == 6);
    const std::vector<double> has = conditions(data, found->z);
    const std::vector<double> should = wanted(data);
    REQUIRE(has.size() == should.size());
    for (std::size_t k = 0; k < has.size(); ++k) CHECK(std::abs(has[k] - should[k]) < 1e-13);
    if (is_plane)
      for (const auto& z : found->z) CHECK((z.v == 0 && z.p == 0));
  }
}

TEST_CASE("c2_step: the conditions change by as much as is wanted") {
  for (const bool is_plane : {false, true}) {
    C2Data data = data_of(is_plane);
    if (is_plane)
      for (Vector<double>& d : data.derivatives) d[2] = 0;
    const auto at = c2_coefficients(data);
    REQUIRE(at);
    const std::vector<double> before = conditions(data, at->z);
    std::vector<double> change(before.size());
    for (std::size_t k = 0; k < change.size(); ++k)
      change[k] = 1e-6 * std::cos(static_cast<double>(3 * k));
    const std::vector<double> parts = c2_step(data, *at)(change);
    REQUIRE(parts.size() == (is_plane ? 12 : 24));
    std::vector<Quaternion<double>> z = at->z;
    for (std::size_t k = 0; k < z.size(); ++k)
      z[k] = z[k] + (is_plane ? Quaternion<double>{parts[2 * k], 0, 0, parts[2 * k + 1]}
                              : Quaternion<double>{parts[4 * k], parts[4 * k + 1], parts[4 * k + 2],
                                                   parts[4 * k + 3]});
    const std::vector<double> after = conditions(data, z);
    for (std::size_t k = 0; k < change.size(); ++k)
      CHECK(std::abs(after[k] - before[k] - change[k]) < 1e-10);
  }
}

TEST_CASE("c2_coefficients: none where the parameters are far from the chords") {
  C2Data data = data_of(false);
  data.steps[1] = 1e-300;
  CHECK_FALSE(c2_coefficients(data));
}
