#include "phrame/io/read/feedrate.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/error.hpp"

using namespace phrame;
using Of = Feedrate::Of;

TEST_CASE("feedrate text: the variable says what the speed depends on") {
  CHECK(parse_feedrate("50") == Feedrate{RationalFunction({50}, {1}), Of::arc_length});
  CHECK(parse_feedrate("10 + 2*s") == Feedrate{RationalFunction({10, 2}, {1}), Of::arc_length});
  CHECK(parse_feedrate("5+t^2") == Feedrate{RationalFunction({5, 0, 1}, {1}), Of::parameter});
  const Feedrate curved{RationalFunction({5}, {1, 2}), Of::curvature};
  CHECK(parse_feedrate("5/(1 + 2*kappa)") == curved);
  CHECK(parse_feedrate("5/(1+2*κ)") == curved);
  CHECK(parse_feedrate("0.1") ==
        Feedrate{RationalFunction({Rational(1, 10)}, {1}), Of::arc_length});
}

TEST_CASE("feedrate text: formulas, the least and the greatest, and pieces") {
  using Function = Feedrate::Function;
  const Formula s = Formula::variable();
  const auto pieces = [](const char* text) { return parse_feedrate(text).pieces; };
  CHECK(pieces("sqrt(s)") == std::vector<Feedrate::Piece>{{{{{sqrt(s), Of::arc_length}}}}});
  CHECK(parse_feedrate("s^2/(1 + s)").pieces.empty());
  const Function a{s, Of::arc_length};
  const Function b{s, Of::parameter};
  const Function c{s, Of::curvature};
  CHECK(pieces(" min(s, max( t , kappa)) ") == std::vector<Feedrate::Piece>{{{{a}, {b, c}}}});
  CHECK(pieces("max(min(s, t), kappa)") == std::vector<Feedrate::Piece>{{{{a, c}, {b, c}}}});
  const auto three = pieces("t < 1/2 ? s : t<3 ? min(t, s) : κ");
  CHECK(three == std::vector<Feedrate::Piece>{
                     {{{a}}, Rational(1, 2)}, {{{b}, {a}}, Rational(3)}, {{{c}}, std::nullopt}});
  CHECK(parse_feedrate("t < 1 ? 2 : 3").ends_are_parameters);
  CHECK_FALSE(parse_feedrate("s < 1 ? 2 : 3").ends_are_parameters);
}

TEST_CASE("feedrate text: what is wrong in formulas and pieces is told, with its column") {
  const auto refused = [](const char* text, const char* place, const char* reason) {
    try {
      parse_feedrate(text);
      FAIL(text);
    } catch (const InputError& error) {
      CHECK_MESSAGE(error.place() == place, text);
      CHECK_MESSAGE(error.reason().find(reason) != std::string::npos, error.reason());
    }
  };
  refused("2*min(s, 2)", "column 1", "outside of all else");
  refused("min(s, 2", "column 1", "not closed");
  refused("min(s, 2*x)", "", "not one of s");
  refused("min(κ, 2s)", "column 9", "no operator between");
  refused("s < 3 ? 1", "column 1", "no \":\"");
  refused("kappa < 3 ? 1 : 2", "column 1", "begins with");
  refused("s < 3 ? 1 : t < 4 ? 2 : 3", "column 13", "not by both");
  refused("s < 3 ? 1 : s < 2 ? 2 : 3", "column 17", "not greater");
  refused("s < x ? 1 : 2", "column 5", "not a number");
  refused("sqrt(s", "column 1", "never closed");
}

TEST_CASE("feedrate text: other variables and what is no rational function are refused") {
  CHECK_THROWS_WITH_AS(parse_feedrate("2*x"), doctest::Contains("\"x\" is not one of s"),
                       InputError);
  CHECK_THROWS_WITH_AS(parse_feedrate("s+t"), doctest::Contains("a second variable, \"t\""),
                       InputError);
  CHECK_THROWS_WITH_AS(parse_feedrate("2s"), doctest::Contains("2*s"), InputError);
  CHECK_THROWS_WITH_AS(parse_feedrate(""), doctest::Contains("empty"), InputError);
}
