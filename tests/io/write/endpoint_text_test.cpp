#include "phrame/io/write/endpoint_text.hpp"

#include <doctest/doctest.h>

#include "phrame/io/read/endpoint.hpp"
#include "phrame/io/write/text.hpp"

using namespace phrame;

TEST_CASE("endpoints: are written for reading") {
  CHECK(to_text(parse_endpoint("-3/7")) == "−3/7");
  CHECK(to_text(parse_endpoint("-inf")) == "−∞");
  CHECK(to_text(parse_endpoint("inf")) == "∞");
  CHECK(to_text(parse_endpoint("root(t^2-2, 1, 2)")) == "√2");
  CHECK(to_text(parse_endpoint("root(t^2-t-1, -1, 0)")) == "1/2 − √5/2");
  CHECK(to_text(parse_endpoint("root(t^3-2, 1, 2)")) == "the root of x³ − 2 in (1, 2)");
  CHECK(to_text(parse_endpoint("-2*pi/3")) == "−2π/3");
  CHECK(to_text(parse_endpoint("pi^2 - 1")) == "(π − 1)(π + 1)");
  CHECK(to_latex(parse_endpoint("-sqrt(2)/2")) == "-\\frac{\\sqrt{2}}{2}");
  CHECK(to_latex(parse_endpoint("pi/2")) == "\\frac{\\pi }{2}");
  CHECK(to_latex(parse_endpoint("root(t^3-2, 1, 2)")) == "\\approx 1.2599210");
  // As long as a line can bear.
  CHECK(abridged(to_text(parse_endpoint("pi*(1+1e-3000)"))).size() < 300);
}
