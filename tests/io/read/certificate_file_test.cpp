#include "phrame/io/read/certificate_file.hpp"

#include "io/reference.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/io/write/certificate.hpp"
#include "phrame/ph/proof/certify.hpp"
#include "support/rational_curves.hpp"
#include "support/refusal.hpp"

using namespace phrame;
using namespace phrame::test;

// Lists of two texts each, which JSON libraries like to take for an object.
TEST_CASE("certificate: a hodograph of linear polynomials is a list of lists") {
  const Curve curve({{-2}, {9}, {}, {Rational(-2, 7)}}, Polynomial{2, 3});
  const Certificate c = certify(curve, Reference::euler_rodrigues, {1}, 30);
  CHECK(read_certificate(write_certificate(c, "")).certificate == c);
}

TEST_CASE("certificate: bad files are refused with their place") {
  const Json good = Json::parse(write_certificate(
      certify(farouki_quintic().curve, Reference::frenet, {Rational(1, 2)}, 30), "quintic"));
  const auto refusal = [&](const char* pointer, const Json& value) {
    Json bad = good;
    bad[Json::json_pointer(pointer)] = value;
    return test::refusal_of([&] { read_certificate(bad.dump()); });
  };
  CHECK(refusal("/phrame", "certificate/2").starts_with("/phrame: the format is"));
  CHECK(refusal("/extra", 1).starts_with("/: unknown key \"extra\""));
  CHECK(refusal("/bits", -1) == "/bits: -1 is not in 0 … 1000000");
  CHECK(refusal("/bits", 1.5) == "/bits: 1.5 is not an integer");
  CHECK(refusal("/frame", "erf").starts_with("/: unknown key \"bend\""));
  CHECK(refusal("/frame", "mtf").starts_with("/frame: the frame is"));
  CHECK(refusal("/curve/basis", "chebyshev").starts_with("/curve/basis: "));
  CHECK(refusal("/hodograph", Json::array()) == "/hodograph: 3 polynomials are wanted, not 0");
  CHECK(refusal("/sigma/0", "1/0").starts_with("/sigma/0: "));
  CHECK(refusal("/antiderivative/rational/denominator", Json::array())
            .starts_with("/antiderivative/rational/denominator: "));
  CHECK(refusal("/antiderivative/logs/0/roots/0/center", Json{"1"})
            .starts_with("/antiderivative/logs/0/roots/0/center: 2 numbers"));
  CHECK(refusal("/claims/0/theta", "pi").starts_with("/claims/0/theta: "));
  CHECK(refusal("/claims/0/radius", 1).starts_with("/claims/0/radius: a string is wanted"));
  CHECK(refusal("/claims/0/turn/signs/1", "+x").starts_with("/claims/0/turn/signs/1: "));
  CHECK(refusal("/antiderivative/logs/0/roots/0/residue_radius", "-5")
            .ends_with("/residue_radius: -5 is less than 0"));
  CHECK(refusal("/rate/coprime_modulo", "0") == "/rate/coprime_modulo: 0 is less than 2");
  CHECK(refusal("/claims/0/theta", "1/7").starts_with("/claims/0/theta: a decimal number"));
  CHECK(refusal("/bits", "64").starts_with("/bits: an integer without quotes is wanted"));
  CHECK(refusal("/curve/basis", "bernstein").starts_with("/curve/basis: the basis is \"power\""));
  CHECK(refusal("/decisions/line/answer", true)
            .starts_with("/decisions/line: the key \"direction\" is missing"));
  CHECK(refusal("/decisions/rrmf/w", Json::object()).starts_with("/decisions/rrmf: unknown key"));
  const auto place = std::string("/decisions/erf_monotone/extrema/0/t/interval");
  CHECK(refusal(place.c_str(), Json{"1", "1"}).starts_with(place + ": an interval has two ends"));
  CHECK(refusal("/decisions/zeros_of_h", Json::array()).starts_with("/decisions: unknown key"));
}

TEST_CASE("certificate: of a rational curve the position is that of its derivative") {
  const Json good = Json::parse(
      write_certificate(certify(quarter_circle(), Reference::euler_rodrigues, {1}, 20), "quarter"));
  const auto refusal = [&](const char* pointer, const Json& value) {
    Json bad = good;
    bad[Json::json_pointer(pointer)] = value;
    return test::refusal_of([&] { read_certificate(bad.dump()); });
  };
  CHECK(refusal("/curve/name", "another").empty());
  const auto wrong = "/position: Curve: f · A i A* is not X'W - XW'";
  CHECK(refusal("/position/x", Json{"1", "1", "-1"}) == wrong);
  CHECK(refusal("/position/w", Json{"2", "0", "2"}) == wrong);
  CHECK(refusal("/position/w", Json{"1", "1", "1"}).starts_with("/position: the multiplier times"));
  CHECK(refusal("/position/w", Json{"0", "1"}).starts_with("/position/w: the weight is to be no"));
  CHECK(refusal("/position/w", Json{"1"}).starts_with("/position/w: the weight is to be no"));
  CHECK(refusal("/position/v", Json{"1"}).starts_with("/position: unknown key \"v\""));
  CHECK(refusal("/curve/start", Json{"1", "0", "1"}) ==
        "/position: it does not begin at the start");
  CHECK(refusal("/curve/multiplier", Json{"1"}).starts_with("/: unknown key \"position\""));
  CHECK(refusal("/curve/multiplier/denominator", Json::array()) ==
        "/curve/multiplier/denominator: the polynomial is 0");
  CHECK(refusal("/curve/multiplier/numerator", Json::array())
            .starts_with("/curve: the multiplier is zero"));
  Json bad = good;
  bad.erase("position");
  CHECK(test::refusal_of([&] { read_certificate(bad.dump()); }) ==
        "/: the key \"position\" is missing");
  // D = 4m + 2 deg f + 2 deg W + 2 = 10.
  CHECK(refusal("/sigma", std::vector<std::string>(11, "1")).empty());
  CHECK(refusal("/sigma", std::vector<std::string>(12, "1")) ==
        "/sigma: 12 coefficients are more than 11");
}

TEST_CASE("certificate: numbers have one form") {
  const Json good = Json::parse(write_certificate(
      certify(farouki_quintic().curve, Reference::euler_rodrigues, {1}, 30), "quintic"));
  const auto is_read = [&](const char* pointer, const Json& value) {
    Json changed = good;
    changed[Json::json_pointer(pointer)] = value;
    try {
      read_certificate(changed.dump());
    } catch (const InputError& error) {
      CHECK(std::string(pointer).starts_with(error.place()));
      return false;
    }
    return true;
  };
  for (const char* text : {"7", "-07", "14/2", "0/5", "-0"}) CHECK(is_read("/sigma/0", text));
  for (const char* text : {"0.5", "1e2", "+7", " 7", "7 ", "0x1", ".5", "1/-2", "1/2/3", "", "-"})
    CHECK_FALSE(is_read("/sigma/0", text));
  CHECK_FALSE(is_read("/sigma/0", 7));
  CHECK_FALSE(is_read("/curve/preimage/u/0", 2));
  CHECK_FALSE(is_read("/curve/preimage/u", Json::array()));
  CHECK_FALSE(is_read("/rate/coprime_modulo", "14/2"));
  for (const char* text : {"1", "-1.50", "1e-10000", "2.5e3"})
    CHECK(is_read("/claims/0/theta", text));
  for (const char* text : {"1/2", "1e-10001", "1E5", "1e+5", "1.", ".5", "1e", "1e-", "0x1p3"})
    CHECK_FALSE(is_read("/claims/0/theta", text));
  CHECK_FALSE(is_read("/claims/0/radius", "-1"));
  CHECK_FALSE(is_read("/claims/0/theta", 0.25));
  CHECK_FALSE(is_read("/curve/family", "x"));
}

TEST_CASE("certificate: what takes more work than the page says is refused, or not") {
  const NamedCurve named = farouki_quintic();
  const Certificate c = certify(named.curve, Reference::euler_rodrigues, {1}, 3000);
  Json json = Json::parse(write_certificate(c, named.name));
  const NamedCertificate read = read_certificate(json.dump());
  CHECK(read.certificate == c);
  CHECK(read.name == named.name);
  const auto refusal = [&json](bool is_limited) {
    return test::refusal_of([&] { read_certificate(json.dump(), {.is_limited = is_limited}); });
  };
  json["claims"][0]["radius"] = "1e-9800";
  CHECK(refusal(true).starts_with("/: to check it is work of "));
  CHECK(refusal(true).ends_with(", beyond the limit 2000000000 (--unlimited)"));
  CHECK(refusal(false).empty());
  // D + 1 coefficients, D = 4m + 2, for m = 2.
  json = Json::parse(write_certificate(c, named.name));
  json["sigma"] = std::vector<std::string>(11, "1");
  CHECK(refusal(true).empty());
  json["sigma"].push_back("1");
  CHECK(refusal(false) == "/sigma: 12 coefficients are more than 11");
}
