#include "phrame/io/write/json_text.hpp"

#include "io/reference.hpp"
#include "phrame/integrate/integrate.hpp"

using namespace phrame;
using test::Json;

TEST_CASE("JSON text: polynomials are ascending lists of exact strings") {
  CHECK(json_of(Polynomial{6, -12, Rational(1, 2)}).dump() == R"(["6","-12","1/2"])");
  CHECK(json_of(Polynomial()).dump() == "[]");
}

TEST_CASE("JSON text: Gaussian polynomials have re and im") {
  CHECK(json_of(GaussianPolynomial{Polynomial{1}, Polynomial{0, -2}}).dump() ==
        R"({"re":["1"],"im":["0","-2"]})");
}

TEST_CASE("JSON text: rational functions have a numerator and a denominator") {
  // t/(2t² + 2) = (t/2)/(t² + 1): whatever the scale, the quotient is the same.
  const Json f = Json::parse(json_of(RationalFunction({0, 1}, {2, 0, 2})).dump());
  CHECK(test::polynomial(f["numerator"]) * Polynomial{2, 0, 2} ==
        test::polynomial(f["denominator"]) * Polynomial{0, 1});
  CHECK(json_of(RationalFunction()).dump() == R"({"numerator":[],"denominator":["1"]})");
}

TEST_CASE("JSON text: points are three exact strings, decimals have a radius") {
  CHECK(json_of(Vector<Rational>{Rational(1, 15), 0, -2}).dump() == R"(["1/15","0","-2"])");
  CHECK(json_of(Decimal{"0.25", "1.2e-9"}).dump() == R"({"value":"0.25","radius":"1.2e-9"})");
}

TEST_CASE("JSON text: an antiderivative has the fields of angle/1") {
  // ∫ (2t + 1/t² + 1/(t² + 1)) dt = t² − 1/t + atan t.
  const RationalFunction f = RationalFunction({0, 2}, {1}) + RationalFunction({1}, {0, 0, 1}) +
                             RationalFunction({1}, {1, 0, 1});
  const Json F = Json::parse(json_of(integrate(f), "partial-fractions").dump());
  CHECK(test::polynomial(F["polynomial"]) == Polynomial{0, 0, 1});
  CHECK(test::rational_function(F["rational"]) == RationalFunction({-1}, {0, 1}));
  CHECK(F["form"] == "partial-fractions");
  CHECK(F["checked"] == true);
  // The poles ±i of 1/(t² + 1) have residues ∓i/2 = −z/2, and the argument is t − x.
  REQUIRE(F["logs"].size() == 1);
  CHECK(test::polynomial(F["logs"][0]["index"]) == Polynomial{1, 0, 1});
  CHECK(test::polynomial(F["logs"][0]["residue"]) == Polynomial{0, Rational(-1, 2)});
  CHECK(F["logs"][0]["argument"] == Json::parse(R"([["0", "-1"], ["1"]])"));
}

TEST_CASE("JSON text: pretty keeps lists on a line and gives every member its own") {
  const JsonOutput json = {{"a", {"1", "2"}},
                           {"b", {{"c", JsonOutput::array()}, {"d", {{"x"}, {"y"}}}}},
                           {"e", JsonOutput::array({JsonOutput{{"f", 1}}, JsonOutput{{"f", 2}}})},
                           {"g", JsonOutput::object()}};
  CHECK(pretty(json) ==
        "{\n"
        "  \"a\": [\"1\",\"2\"],\n"
        "  \"b\": {\n"
        "    \"c\": [],\n"
        "    \"d\": [[\"x\"],[\"y\"]]\n"
        "  },\n"
        "  \"e\": [\n"
        "    {\n"
        "      \"f\": 1\n"
        "    },\n"
        "    {\n"
        "      \"f\": 2\n"
        "    }\n"
        "  ],\n"
        "  \"g\": {}\n"
        "}\n");
}

TEST_CASE("JSON text: pretty text means the same as what it was made of") {
  const JsonOutput json = {{"quote \" and \n", "\x01 \\ é"}, {"list", {1, "2", nullptr, true}}};
  CHECK(JsonOutput::parse(pretty(json)) == json);
  for (const char* text : {"", "3/4", "\"", "a\\b", "\t", "\x7f", "é", "~ !"}) {
    const JsonOutput list = JsonOutput::array({JsonOutput::array({text, 1}), text});
    CHECK(pretty(list) == list.dump() + "\n");
  }
}

TEST_CASE("JSON text: the coefficients of a polynomial are in lowest terms, each") {
  const JsonOutput list =
      json_of(Polynomial{Rational(1, 6), -2, 0, Rational(-5, 6), Rational(3, 2)});
  CHECK(list.dump() == R"(["1/6","-2","0","-5/6","3/2"])");
  CHECK(json_of(Polynomial()).dump() == "[]");
}
