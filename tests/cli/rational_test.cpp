#include "cli/workshop.hpp"

namespace rational_cli_test {

using namespace phrame;
using namespace phrame::test;

namespace {

/// The unit circle by four arcs, to the left.
const char* const circle = R"({"phrame": "spline/1", "segments": [
    {"control_points": [[1, 0, 0], [1, 1, 0], [0, 1, 0]], "weights": [1, 1, 2]},
    {"control_points": [[0, 1, 0], [-1, 1, 0], [-1, 0, 0]], "weights": [1, 1, 2]},
    {"control_points": [[-1, 0, 0], [-1, -1, 0], [0, -1, 0]], "weights": [1, 1, 2]},
    {"control_points": [[0, -1, 0], [1, -1, 0], [1, 0, 0]], "weights": [1, 1, 2]}]})";

std::string with_multiplier(const std::string& multiplier) {
  return R"({"phrame": "curve/1", "basis": "power", "preimage": {"u": [1], "v": [0, 1], "p": [0],
      "q": [0, 0, 1]}, "multiplier": )" +
         multiplier + "}";
}

}  // namespace

TEST_CASE("offset: of a circle all is known, trimmed and until nothing is left, too") {
  const Workshop here;
  here.write("circle.json", circle);
  const Json all =
      Json::parse(here.run("offset circle.json --distance 1/2,-1/2,-2 --print json").out);
  CHECK(all["offsets"][0]["length"]["exact"] == "3*pi");
  CHECK(all["offsets"][0]["area"]["exact"] == "9/4*pi");
  CHECK(all["offsets"][1]["length"]["exact"] == "pi");
  CHECK(all["offsets"][2]["length"]["exact"] == "2*pi");
  const Run pocket = here.run("offset circle.json --distance -2/5 --pocket --print json");
  check_success(pocket);
  const Json rooms = Json::parse(pocket.out)["trimmed"];
  REQUIRE(rooms.size() == 2);
  // 2π·3/5 and 2π·1/5.
  CHECK(std::string(rooms[0]["branches"][0]["length"]["value"]).starts_with("3.7699111843077"));
  CHECK(std::string(rooms[1]["branches"][0]["length"]["value"]).starts_with("1.2566370614359"));
  CHECK(contains(here.run("offset circle.json --distance -1 --pocket").out, "none"));
}

TEST_CASE("rational PH: what is of polynomial curves says that this is a rational one") {
  const Workshop here;
  here.write("circle.json", circle);
  here.write("arc.json", R"({"phrame": "curve/1", "control_points": [[1, 0], [1, 1], [0, 1]],
                             "weights": [1, 1, 2]})");
  const std::string need = "needs a polynomial Pythagorean-hodograph curve, and ";
  check_failure(here.run("mtf arc.json --from 0 --to 1 --degree 2"), 2,
                need + "this is a rational one\n");
  check_failure(here.run("frames circle.json --samples 2 --frame mtf"), 2,
                need + "segment 1 is a rational one\n");
}

TEST_CASE("rational PH: a multiplier is n/d, or one line says where there is a logarithm") {
  const Workshop here;
  // 1/(t + 2)⁴ times 1 + t² − t⁴, 2t²… has residues; (t + 2)⁻⁶ has none, as the degree is 4.
  here.write(
      "good.json",
      with_multiplier(R"({"numerator": [1], "denominator": [64, 192, 240, 160, 60, 12, 1]})"));
  const Run run = here.run("info good.json --print json");
  check_success(run);
  const Json info = Json::parse(run.out);
  CHECK(info["sigma"] == Json::array({"1", "0", "1", "0", "1"}));
  CHECK(info["weight"].size() == 6);
  const Run erf = here.run("angle good.json --frame erf --print json");
  check_success(erf);
  CHECK(!Json::parse(erf.out)["antiderivative"].is_null());
  // θ depends on A alone.
  here.write("poly.json", with_multiplier("[1]"));
  const auto value = [&](const std::string& file) {
    return Json::parse(
        here.run("angle " + file + " --frame erf --at 1 --digits 30 --print json").out)["values"];
  };
  CHECK(value("good.json") == value("poly.json"));
  here.write("log.json",
             with_multiplier(R"({"numerator": [1], "denominator": [16, 32, 24, 8, 1]})"));
  check_failure(here.run("info log.json"), 2,
                "x has a logarithm: its residues at the roots of t + 2");
  here.write("pole.json", with_multiplier(R"({"numerator": [1], "denominator": [1, -4, 4]})"));
  check_failure(here.run("info pole.json"), 2, "the multiplier has a pole at t = 1/2");
  here.write("null.json", with_multiplier(R"({"numerator": [1], "denominator": [0]})"));
  check_failure(here.run("info null.json"), 2, "the denominator is zero");
}

TEST_CASE("rational PH: a plane curve by its tangents") {
  const Workshop here;
  here.write("lines.json", R"({"phrame": "curve/1", "basis": "power", "tangents": {
      "a": [0, 1], "b": [1], "support": {"numerator": [1, 0, 1], "denominator": [2, 1]}}})");
  const Json info = Json::parse(here.run("info lines.json --print json").out);
  CHECK(info["tangents"]["L"] == Json::array({"0", "4", "2"}));
  here.write("wrong.json", R"({"phrame": "curve/1", "basis": "power", "tangents": {
      "a": [0, 1], "b": [0, 1], "support": [1]}})");
  check_failure(here.run("info wrong.json"), 2, "a and b have a common factor");
}

}  // namespace rational_cli_test
