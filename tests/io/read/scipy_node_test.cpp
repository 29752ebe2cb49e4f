#include "phrame/io/read/scipy_node.hpp"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "io/reference.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/io/read/any_path.hpp"

namespace scipy_node_test {

using namespace phrame;
using test::refusal;

namespace {

Vector<Rational> at(const Path& path, std::size_t segment, const Rational& t) {
  return point(*rational_curve(path.segments()[segment]), t);
}

}  // namespace

TEST_CASE("SciPy: B-splines, piecewise polynomials and splprep's lists have the points of SciPy") {
  const auto entries = nlohmann::json::parse(test::read_data("scipy.json"));
  CHECK(entries.size() == 7);
  for (const auto& entry : entries) {
    CAPTURE(entry["name"].get<std::string>());
    const NamedPath named = read_any_path(entry["curve"].dump());
    for (const auto& sample : entry["points"]) {
      const auto p =
          at(named.path, sample[0].get<std::size_t>(), exact_rational(sample[1].get<double>()));
      for (std::size_t c = 0; c < sample[2].size(); ++c)
        CHECK(static_cast<double>(p[c]) ==
              doctest::Approx(sample[2][c].get<double>()).epsilon(1e-13));
    }
    const bool is_cubic_in_pieces = entry["curve"].is_object() && entry["curve"].contains("x");
    CHECK(named.notes.size() == (is_cubic_in_pieces ? 1U : 0U));
  }
}

// On [0, 2] the first is (x, x² − x³/4), which ends in (2, 2) with the slope (1, 1); on [2, 3] the
// second goes on.
TEST_CASE("SciPy: piecewise polynomials that meet are taken exactly, and no note is needed") {
  const std::string text = R"({"x": [0, 2, 3], "c": [[[0, "-1/4"], [0, 1]], [[0, 1], [0, 0]],
                                                     [[1, 0], [1, 1]], [[0, 0], [2, 2]]]})";
  const NamedPath named = read_any_path(text);
  CHECK(named.notes.empty());
  CHECK(at(named.path, 0, Rational(1, 2)) == Vector<Rational>{1, Rational(3, 4), 0});
  CHECK(at(named.path, 1, 1) == Vector<Rational>{3, 4, 0});
}

TEST_CASE("SciPy: what is no smooth curve of two or three dimensions is refused at its place") {
  CHECK(refusal(R"({"c": [[[0, 1], [0, 1]], [[0, 0], [0, 0]], [[1, 0], [1, 0]], [[0, 0], [2, 0]]],
                    "x": [0, 1, 2]})")
            .starts_with("/c: the pieces are apart at the breakpoints"));
  CHECK(refusal(R"({"c": [[[1, 1]], [[0, 0]]], "x": [0, 0]})") ==
        "/x/1: the breakpoint is not greater than that before it");
  CHECK(refusal(R"({"c": [[[1, 1]], [[0, 0]]], "x": [0, 1, 2]})") ==
        "/c/0: 1 piece for 3 breakpoints");
  CHECK(refusal(R"({"c": [[1], [2]], "x": [0, 1]})").starts_with("/c/0/0: a list of numbers"));
  CHECK(refusal(R"({"t": [0, 0, 1, 1], "c": [[0, 0], [1, 1]], "k": 1.5})") ==
        "/k: the degree 3/2 is no whole number");
  CHECK(refusal(R"({"t": [0, 0, 1, 1], "c": [[0], [1]], "k": 1})") ==
        "/c: the curve has 1 coordinate: 2 and 3 are read");
  CHECK(refusal(R"({"t": [0, 0, 1, 1], "c": [[0, 0]], "k": 1})").starts_with("/c: "));
  CHECK(refusal(R"({"t": [0, 1], "c": [[0, 0], [1, 1]], "k": 3})") ==
        "/t: 2 knots are too few for the degree 3");
  CHECK(refusal("[[0, 0, 1, 1], [[0, 1], [0, null]], 1]") ==
        "/1/1/1: a number is wanted, not null");
}

}  // namespace scipy_node_test
