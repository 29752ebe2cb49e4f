#include <nlohmann/json.hpp>

#include "cli/workshop.hpp"

using namespace phrame;
using namespace phrame::test;

namespace {

/// Two pieces of the x axis, [0, 1] and [1, 2], the speed of each falling or rising through a cusp
/// between them; then a plane quarter turn.
void add_splines(const Workshop& here) {
  here.write("s.json", R"({"phrame": "spline/1", "name": "s", "segments": [
    {"basis": "power", "quaternions": [[1, 0, 0, 0]], "multiplier": [2, -2]},
    {"basis": "power", "quaternions": [[1, 0, 0, 0]], "multiplier": [0, 2]},
    {"basis": "power", "quaternions": [[1, 0, 0, 0], [0, 0, 0, 1]]}]})");
  here.write("broken.json", R"({"phrame": "spline/1", "segments": [
    {"basis": "power", "quaternions": [[1, 0, 0, 0]]},
    {"basis": "power", "quaternions": [[0, 0, 1, 0]]}]})");
  here.write("other.json", R"({"phrame": "spline/2"})");
}

}  // namespace

TEST_CASE("splines: frames through a cusp at a joint, by t and by arc length") {
  const Workshop here;
  add_splines(here);
  const Run run = here.run("frames s.json --at 1,2,3 --columns s");
  check_success(run);
  CHECK(contains(run.out, "\n1,1,0,0,1,0,0,0,1,0,0,0,1,1\n2,2,0,0,1,0,0,0,1,0,0,0,1,2\n"));
  CHECK(contains(run.out, "\n3,2.6666666666666665,1,0,0,1,0,-1,0,0,0,0,1,3.3333333333333335\n"));
  // Half a length before and behind the cusp: s = 2t − t² and s = t².
  const Run by = here.run("frames s.json --by arc-length --at 3/4,5/4 --columns s");
  CHECK(contains(by.out,
                 "\n0.5,0.75,0,0,1,0,0,0,1,0,0,0,1,0.75\n1.5,1.25,0,0,1,0,0,0,1,0,0,0,1,1.25\n"));
  check_failure(here.run("frames s.json --by arc-length --at 4"), 3, "4 is outside [0, 10/3]");
  check_failure(here.run("frames s.json --at 7/2"), 3, "t = 7/2 is outside [0, 3]");
  check_failure(here.run("frames s.json --at 3/2 --columns torsion"), 3, "straight line");
}

TEST_CASE("splines: angle and info") {
  const Workshop here;
  add_splines(here);
  const auto angle = nlohmann::json::parse(here.run("angle s.json --at 5/2 --print json").out);
  CHECK(angle["phrame"] == "spline-angle/1");
  CHECK(angle["values"][0]["theta"] == "0");
  CHECK(angle["total"]["value"] == "0");
  const auto info = nlohmann::json::parse(here.run("info s.json --print json").out);
  CHECK(info["arc_length"] == "10/3");
  CHECK(info["segments"][2]["arc_length"] == "4/3");
  CHECK(info["closed"] == false);
}

TEST_CASE("splines: what is refused, and where") {
  const Workshop here;
  add_splines(here);
  check_failure(here.run("angle broken.json"), 2,
                "broken.json:/segments/1: the tangent turns back");
  check_failure(here.run("angle other.json"), 2,
                "/phrame: the format is \"curve/1\", \"spline/1\", \"bspline/1\", \"nurbs/1\" or "
                "\"points/1\", not \"spline/2\"");
  check_failure(here.run("prove s.json --at 1"), 2, "this is a spline; one curve is wanted");
  check_failure(here.run("interpolate s.json --period 1/10000000 --feed 1"), 2,
                "--period: 1e-7 asks for 33333335 rows, the limit is 10000000");
  check_failure(here.run("interpolate s.json --period 1 --feed '3 - s'"), 3,
                "feedrate: the speed is 0 at t ≈ 2.8");
  check_failure(here.run("angle s.json --frame frenet"), 3, "Frenet frame: ");
  check_failure(here.run("angle s.json --print sympy"), 2,
                "--print: \"sympy\" is for single curves");
  check_failure(here.run("angle s.json --at 4"), 3, "t = 4 is outside [0, 3]");
}

TEST_CASE("splines: totals, classify and interpolate") {
  const Workshop here;
  add_splines(here);
  const auto totals = nlohmann::json::parse(here.run("totals s.json --print json").out);
  CHECK(totals["phrame"] == "spline-totals/1");
  CHECK(totals["length"]["exact"] == "10/3");
  CHECK(totals["rotation_index"]["value"] == "0.25000000000000000");
  CHECK(totals["torsion"]["reason"] == "segment 1 is a straight line, which has no torsion");
  CHECK(totals["bending_energy"]["exact"] == "1 + 3/8*pi");
  const auto classes = nlohmann::json::parse(here.run("classify s.json --print json").out);
  CHECK(classes["regular"]["answer"] == false);
  CHECK(classes["planar"]["normal"] == nlohmann::json{"0", "0", "1"});
  CHECK(classes["segments"][1]["regular"]["cusps"][0]["t"] == "0");
  // Through the cusp: s = 2t − t², s = 1 + (t − 1)².
  const Run points = here.run("interpolate s.json --period 1/4 --feed 1");
  check_success(points);
  CHECK(contains(points.out,
                 "\n3,0.75,0.5,0.75,0.75,0,0\n4,1,1,1,1,0,0\n5,1.25,1.5,1.25,1.25,0,0\n"));
  CHECK(points.out.ends_with(
      "\n14,3.3333333333333335,3,3.3333333333333335,2.6666666666666665,1,0\n"));
}

// mpmath: quadrature of |r′|τ, |r′|κ², |r′|(κ² + τ²) and of |r′|/(1 + (k + t)²), these from
// r′, r″ and r‴ as vectors, and its root finder.
TEST_CASE("splines: the totals and motions of the closed spline of the examples") {
  const Workshop here;
  here.write("closed.json", bytes_of(root("/examples/curves/closed-spline.json")));
  const auto totals = nlohmann::json::parse(here.run("totals closed.json --print json").out);
  CHECK(totals["torsion"]["value"] == "-1.6782458621678584");
  CHECK(totals["bending_energy"]["value"] == "20.374612525767639");
  CHECK(totals["frenet_energy"]["value"] == "49.279344513875339");
  const Run points = here.run("interpolate closed.json --period 1 --feed '1 + t^2'");
  CHECK(contains(points.out, "\n4,4,1.4730938632589596,"));
  CHECK(contains(points.out, "\n6,5.970479698460352,4,20.441814595660748,"));
}
