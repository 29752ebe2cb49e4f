#include <array>
#include <cmath>
#include <numbers>

#include "cli/workshop.hpp"
#include "support/random.hpp"

using namespace phrame;
using namespace phrame::test;

// Example 1 of Farouki and Moon, with the angle at the end that its results need.
// A = (t³ − 1/5)(1 + 2k): a cusp at ∛(1/5) = 0.5848035476425732…
TEST_CASE("mtf: a cusp at an irrational t is told in decimals, by info and angle, too") {
  const Workshop here;
  here.write("cusp.json", R"({"phrame": "curve/1", "basis": "power",
      "preimage": {"u": ["-1/5", 0, 0, 1], "v": [0], "p": [0], "q": ["-2/5", 0, 0, 2]}})");
  check_failure(here.run("mtf cusp.json --from 0 --to 1 --degree 2"), 3,
                "phrame: the curve has a cusp at t ≈ 0.584803547643, where a frame");
  for (const std::string command : {"info", "angle"})
    CHECK(contains(here.run(command + " cusp.json").out, " t ≈ 0.584803547643"));
}

TEST_CASE("mtf: twist and angles of an example of the paper") {
  const Workshop here;
  here.write("example.json", R"({"phrame": "curve/1", "basis": "bernstein", "quaternions": [
      [-0.9515, 0.9515, 0.3941, -0.3941], [-0.2085, 1.4435, -0.2981, 1.0472],
      [1.2294, 0.6264, 1.3768, -0.0915]]})");
  const Run run =
      here.run("mtf example.json --from pi/8 --to -pi/2 --at 1/2 --digits 20 --print json");
  check_success(run);
  const Json answer = Json::parse(run.out);
  CHECK(answer["phrame"] == "mtf/1");
  CHECK(answer["length"] == "2796746489/1500000000");
  CHECK(answer["twist"]["erf"]["value"] == "-2.4067125535993797160");
  CHECK(answer["twist"]["total"]["value"] == "-4.3702079620930004900");
  CHECK(answer["twist"]["minimal"]["value"] == "1.9129773450865859869");
  CHECK(answer["mean_rate"]["value"] == "1.0260014731102354770");
  // θ − θ_i = 2.391898772922595071…
  const Rational theta = rational(answer["exact"]["values"][0]["theta"]);
  const Rational start = rational(answer["from"]["value"]);
  CHECK(abs(theta - start - parse_rational("2.391898772922595071493908")) < power_of_ten(-18));
  CHECK(contains(here.run("mtf example.json --from 0 --to 0 --turns -3").out, "\n  twist T"));
}

TEST_CASE("mtf: by vectors, and closing up") {
  const Workshop here;
  // r′(0) = (4, 4, 2); by the frames at 0 and 1, e2 itself is at angle 0.
  std::istringstream table(here.run("frames quintic.json --frame erf --at 0,1 --format csv").out);
  std::string header;
  std::string options = "mtf quintic.json --print json";
  std::getline(table, header);
  CHECK(header == "t,x,y,z,e1x,e1y,e1z,e2x,e2y,e2z,e3x,e3y,e3z");
  for (const char* option : {" --from-vector ", " --to-vector "}) {
    std::string line;
    std::getline(table, line);
    std::vector<std::string> fields;
    std::istringstream row(line);
    for (std::string field; std::getline(row, field, ',');) fields.push_back(field);
    options += option + fields.at(7) + "," + fields.at(8) + "," + fields.at(9);
  }
  const Run straight = here.run(options);
  check_success(straight);
  for (const char* end : {"from", "to"})  // the table has doubles
    CHECK(abs(rational(Json::parse(straight.out)[end]["value"])) < power_of_ten(-15));
  here.write("closed.json", bytes_of(test::root("/examples/curves/closed-spline.json")));
  const Run closed = here.run("mtf closed.json --from 1/3 --closed --digits 15 --print json");
  check_success(closed);
  // The twist that undoes the holonomy, 1.13263544456406872 by an ODE solver (docs/splines.md).
  CHECK(Json::parse(closed.out)["twist"]["minimal"]["value"] == "-1.13263544456407");
}

// Where r′ = H the least rotation takes the y axis to (−H₂, |H| + H₁, 0) in the normal plane;
// r′(0) = (4, 4, 2), and by points r′(1) of the table.
TEST_CASE("mtf: an end that is left out is the least rotation there") {
  const Workshop here;
  const auto frames = [&](const std::string& options) {
    const Run run =
        here.run("frames quintic.json --frame mtf-exact --at 0,1 --format json" + options);
    check_success(run);
    return Json::parse(run.out);
  };
  const Json none = frames("");
  const Json& last = none["rows"][1];
  const std::string y = std::to_string(1 + last[4].get<double>());
  const Json vectors = frames(" --from-vector -4,10,0 --to-vector " +
                              std::to_string(-last[5].get<double>()) + "," + y + ",0");
  for (const std::size_t row : {0UL, 1UL})
    for (const std::size_t cell : {7UL, 8UL, 9UL, 10UL, 11UL, 12UL})
      CHECK(std::abs(none["rows"][row][cell].get<double>() -
                     vectors["rows"][row][cell].get<double>()) < 1e-5);
  // That of the rotation-minimizing frame at the start.
  const Json rmf = Json::parse(here.run("frames quintic.json --at 0 --format json").out);
  for (const std::size_t cell : {7UL, 8UL, 9UL})
    CHECK(none["rows"][0][cell] == rmf["rows"][0][cell]);
  const Json both = Json::parse(here.run("mtf quintic.json --print json").out);
  CHECK(both["start"] == "least rotation");
  CHECK(both["end"] == "least rotation");
  const Json end = Json::parse(here.run("mtf quintic.json --from 0 --print json").out);
  CHECK_FALSE(end.contains("start"));
  CHECK(end["end"] == "least rotation");
  CHECK(end["to"] == both["to"]);
  CHECK(
      contains(here.run("mtf quintic.json").out,
               "\nAt both ends the least rotation that takes the x axis to e₁ takes the y axis to "
               "f₂.\n"));
  CHECK(contains(here.run("mtf quintic.json --to 0").out, "\nAt the start the least rotation"));
  CHECK(contains(here.run("mtf quintic.json --from 0").out, "\nAt the end the least rotation"));
}

TEST_CASE("mtf: bad input is refused with its place") {
  const Workshop here;
  check_failure(here.run("mtf quintic.json --from 0 --to 1 --at 2"), 3, "t = 2 is outside [0, 1]");
  check_failure(here.run("mtf quintic.json --from 0 --to 1 --to-vector 1,0,0"), 2,
                "--to: the angle is given twice");
  check_failure(here.run("mtf quintic.json --to 1 --closed"), 2, "--to: the angle is given twice");
  check_failure(here.run("mtf quintic.json --from pie --to 1"), 2,
                "--from: \"pie\" is not an angle");
  check_failure(here.run("mtf quintic.json --from 0 --to-vector 1,2"), 2,
                "--to-vector: \"1,2\" is not a vector x,y,z");
  check_failure(here.run("mtf quintic.json --from-vector 2,2,1 --to 0"), 2,
                "--from-vector: the vector (2, 2, 1) has no part in the normal plane");
  check_failure(here.run("mtf quintic.json --from 0 --closed"), 3,
                "--closed: the curve is not closed");
}

TEST_CASE("mtf: the rational frame, in one piece and in several") {
  const Workshop here;
  here.write("example.json", bytes_of(test::root("/examples/curves/farouki-moon-3.json")));
  const std::string ends = "mtf example.json --from -pi/4 --to 5pi/4 --digits 20 --print json ";
  const Run whole = here.run(ends);
  check_success(whole);
  const Json one = Json::parse(whole.out);
  REQUIRE(one["rational"].size() == 1);
  const Json& piece = one["rational"][0];
  CHECK(piece["degree"] == 8);
  CHECK(piece["optimum"]["proved"] == true);
  CHECK(rational(piece["optimum"]["gamma_radius"]) < power_of_ten(-20));
  CHECK(piece["gamma"]["value"] == "0.55718958215068116465");
  CHECK(piece["rms_relative"]["value"] == "0.55463591772394686060");
  CHECK(piece["monotone"] == false);
  REQUIRE(piece["inflections"].size() == 2);
  CHECK(abs(rational(piece["inflections"][0]) - parse_rational("0.540370263399618154793843787")) <
        power_of_ten(-19));
  CHECK(one["monotone"] == false);

  const Run divided = here.run(ends + "--subdivide inflections,extrema");
  check_success(divided);
  const Json four = Json::parse(divided.out);
  REQUIRE(four["rational"].size() == 4);
  CHECK(four["rational"][3]["gamma"]["value"] == "0.56313620096703034184");
  CHECK(four["rms_relative"]["value"] == "0.015687774704940557662");
  CHECK(four["monotone"] == true);
  CHECK(Json::parse(here.run(ends + "--subdivide auto").out)["monotone"] == true);
  const Json small = Json::parse(here.run(ends + "--subdivide rms:1/1000 --unproved").out);
  for (const Json& part : small["rational"]) {
    CHECK(rational(part["rms_relative"]["value"]) <= Rational(1, 1000));
    CHECK(part["optimum"]["proved"] == false);
  }
  CHECK_FALSE(contains(here.run("mtf example.json --from 0 --to 1 --subdivide 1/2 --unproved").out,
                       "proved to be"));
  const Json cubic = Json::parse(here.run(ends + "--degree 3").out);
  CHECK(cubic["rational"][0]["degree"] == 10);
  CHECK(rational(cubic["rational"][0]["rms_relative"]["value"]) < Rational(1, 20));
}

TEST_CASE("mtf: angles that are multiples of pi, turns that are whole, frames that stand still") {
  const Workshop here;
  here.write("example.json", bytes_of(test::root("/examples/curves/farouki-moon-1.json")));
  for (const char* ends : {"--from pi/2 --to 0", "--from pi --to 0", "--from 2pi --to 1",
                           "--from 1 --to 1", "--from -pi --to pi/3"}) {
    CAPTURE(ends);
    const Run run = here.run(std::string("mtf example.json --print json ") + ends);
    check_success(run);
    CHECK(Json::parse(run.out).contains("rational"));
  }
  here.write("plane.json", R"({"phrame": "curve/1", "basis": "power",
      "preimage": {"u": [1], "v": [0], "p": [0, 1], "q": [0]}})");
  const Run still = here.run("mtf plane.json --from 1/3 --to 1/3");
  check_success(still);
  CHECK(contains(still.out, "= 0\n"));
  CHECK(contains(still.out, "Ω₁ has one sign                  yes"));
}

TEST_CASE("mtf: whole turns in the angles given do not count") {
  const Workshop here;
  here.write("example.json", bytes_of(test::root("/examples/curves/farouki-moon-3.json")));
  const auto rational_frame = [&](const std::string& ends) {
    CAPTURE(ends);
    const Run run = here.run("mtf example.json --print json " + ends);
    check_success(run);
    const Json answer = Json::parse(run.out);
    return std::pair(answer["twist"]["minimal"]["value"], answer["rational"]);
  };
  const auto plain = rational_frame("--from pi/3 --to 5pi/4");
  REQUIRE(plain.second.size() == 1);
  // θ + 2πk, exactly.
  CHECK(rational_frame("--from 7pi/3 --to 5pi/4") == plain);
  CHECK(rational_frame("--from pi/3 --to -3pi/4") == plain);
  CHECK(rational_frame("--from -2000000000000000000000000000000000000000000000000003pi/3 "
                       "--to 4000000000000000000000000000000000000005pi/4") == plain);
  // 10²⁴ and 10³⁵ less whole turns, by mpmath with 1200 digits.
  for (const auto& [power, rest] :
       {std::pair("1e24", "-1.48677434103531370101561026317235323209512996036513602"),
        std::pair("1e35", "1.27828869541662225344699375782786095934245333633604199")}) {
    const auto large = rational_frame(std::string("--from 0 --to ") + power);
    const auto small = rational_frame(std::string("--from 0 --to ") + rest);
    CHECK(large.first == small.first);
    for (const char* key : {"gamma", "rms_relative", "greatest_relative"})
      CHECK(large.second[0][key]["value"] == small.second[0][key]["value"]);
    CHECK(large.second[0]["optimum"]["proved"] == true);
  }
  const auto one = rational_frame("--from 0 --to 1");
  const auto far =
      rational_frame("--from 1000000000000000000000000000000 --to 1000000000000000000000000000001");
  CHECK(one.first == far.first);
  CHECK(one.second[0]["gamma"]["value"] == far.second[0]["gamma"]["value"]);
}

// The numbers by mpmath (tests/ph/rational_twist_test.cpp).
TEST_CASE("mtf: next to a cusp rational frames are found, in one piece and in several") {
  const Workshop here;
  here.write("near.json", R"({"phrame": "curve/1", "basis": "power", "preimage": {
      "u": ["-15001/10000", 3], "v": ["2499/5000", -1], "p": [0], "q": [-1, 2]}})");
  const std::string ends = "mtf near.json --from 0.3 --to 1 --print json ";
  // The proof that it is the best one takes seconds; rational_twist_test.cpp has it.
  const Run run = here.run(ends + (test::multiplier() > 1 ? "" : "--unproved"));
  check_success(run);
  const Json whole = Json::parse(run.out);
  REQUIRE(whole["rational"].size() == 1);
  CHECK(whole["rational"][0]["gamma"]["value"].get<std::string>().starts_with("1.0006914"));
  CHECK(whole["rational"][0]["rms_relative"]["value"].get<std::string>().starts_with(
      "3998027.32296"));
  CHECK_FALSE(whole.contains("no_rational"));
  // Found or not is asked here, and 650 proofs take long.
  std::vector<const char*> options_tried{
      "--unproved --degree 1 --free-ends", "--unproved --subdivide inflections",
      "--unproved --subdivide auto", "--subdivide 1/2", "--degree 3"};
  options_tried.resize(static_cast<std::size_t>(test::everyday(2, 5)));
  for (const char* options : options_tried) {
    CAPTURE(options);
    check_success(here.run(ends + options));
  }
}

TEST_CASE("mtf: the table says of which pieces nothing is proved, and rounds once") {
  const Workshop here;
  here.write("example.json", bytes_of(test::root("/examples/curves/farouki-moon-1.json")));
  // To 12 digits 2.79220… and 0.0102775…: two digits of them are no reason to print 2.80000.
  const std::string ends = "mtf example.json --from 0 --to pi/2 --subdivide 1/2 --unproved ";
  const Run run = here.run(ends + "--digits 2");
  check_success(run);
  for (const char* number : {" 2.79220 ", " 0.0102775 "}) CHECK(contains(run.out, number));
  CHECK(contains(run.out, "No proof that w is the best one: that was not asked for\n"));
}

TEST_CASE("mtf: what is refused, and where there is no rational frame") {
  const Workshop here;
  here.write("example.json", bytes_of(test::root("/examples/curves/farouki-moon-1.json")));
  const std::string ends = "mtf example.json --from 0 --to 1 ";
  const auto check_refused = [&](const std::string& options, const std::string& message) {
    CAPTURE(options);
    const Run run = here.run(ends + options);
    CHECK(run.status == 2);
    CHECK(contains(run.err, message));
    CHECK(run.out.empty());
  };
  check_refused(
      "--subdivide foo",
      "--subdivide: \"foo\" is not one of inflections, extrema, auto, rms:X with a number "
      "X, and a parameter t\n");
  check_refused("--subdivide 2", "--subdivide: the parameter 2 is outside [0, 1]");
  check_refused("--subdivide middle", "--subdivide: \"middle\" is not one of inflections, ");
  check_refused("--subdivide rms:0", "the error must be positive");
  check_refused("--subdivide rms:1,rms:2", "rms: is given twice");
  check_refused("--degree 9", "--degree");
  here.write("cusp.json", R"({"phrame": "curve/1", "basis": "power", "multiplier": [1, -4, 4],
      "preimage": {"u": [1], "v": [0, 1], "p": [0, 2], "q": [0]}})");
  const Run cusp = here.run("mtf cusp.json --from 0 --to 1");
  check_success(cusp);
  CHECK(contains(cusp.out, "No rational frame: the curve has a cusp at t = 1/2, where"));
  // docs/minimal-twist.md: the statuses are for those who ask for it.
  const Run json = here.run("mtf cusp.json --from 0 --to 1 --print json");
  check_success(json);
  CHECK(Json::parse(json.out).contains("no_rational"));
  for (const char* options : {"--degree 3", "--degree 2", "--free-ends", "--unproved",
                              "--subdivide 1/4", "--degree 1 --free-ends"})
    CHECK(here.run(std::string("mtf cusp.json --from 0 --to 1 ") + options).status == 3);
  check_failure(here.run("frames cusp.json --frame mtf --from 0 --to 1 --at 0"), 3, "cusp");
  if (test::multiplier() == 1) return;
  // 10⁻³⁶ beside a cusp the errors of the rational frame cannot be rounded.
  here.write("near.json", R"({"phrame": "curve/1", "basis": "power", "preimage": {
      "u": ["-1/2", 1], "v": [0, -1, 2], "p": ["1e-36"], "q": [0]}})");
  const Run near = here.run("mtf near.json --from 0.3 --to 1 --print json");
  check_success(near);
  CHECK(Json::parse(near.out).contains("rational_undecided"));
  CHECK(here.run("mtf near.json --from 0.3 --to 1 --unproved").status == 4);
}

TEST_CASE("frames: of minimal twist, at both ends and in the middle") {
  const Workshop here;
  here.write("example.json", bytes_of(test::root("/examples/curves/farouki-moon-1.json")));
  const std::string ends = "frames example.json --from pi/8 --to -pi/2 --format json ";
  const Run run = here.run(ends + "--frame erf,mtf,mtf-exact --at 0,1/2,1");
  check_success(run);
  const Json table = Json::parse(run.out);
  const auto vector = [&](std::size_t row, std::size_t column) {
    std::array<double, 3> v{};
    for (std::size_t k = 0; k < 3; ++k) v[k] = table["rows"][row][column + k].get<double>();
    return v;
  };
  // Columns: t, r, e1, e2, e3, f2 and f3 of the rational frame, of the exact one.
  for (const std::size_t frame : {13UL, 19UL}) {
    CHECK(table["columns"][frame] == (frame == 13 ? "mtf2x" : "exact_mtf2x"));
    const double angles[] = {std::numbers::pi / 8, -std::numbers::pi / 2};
    for (const std::size_t end : {0UL, 1UL}) {
      const std::size_t row = 2 * end;
      for (std::size_t k = 0; k < 3; ++k)
        CHECK(vector(row, frame)[k] == doctest::Approx(std::cos(angles[end]) * vector(row, 7)[k] +
                                                       std::sin(angles[end]) * vector(row, 10)[k]));
    }
  }
  // θ(1/2) = π/8 + 2.391898772922595 of the exact frame, from the same source as the examples.
  const double theta = std::numbers::pi / 8 + 2.391898772922595071;
  for (std::size_t k = 0; k < 3; ++k)
    CHECK(vector(1, 19)[k] ==
          doctest::Approx(std::cos(theta) * vector(1, 7)[k] + std::sin(theta) * vector(1, 10)[k]));
  // By arc length the exact frame is the same at the same points.
  const Json by_length =
      Json::parse(here.run(ends + "--frame mtf,mtf-exact --by arc-length --samples 3").out);
  const std::string t = by_length["rows"][1][0].dump();
  const Json at_t = Json::parse(here.run(ends + "--frame mtf,mtf-exact --at " + t).out);
  for (std::size_t column = 1; column < 19; ++column)
    CHECK(by_length["rows"][1][column].get<double>() ==
          doctest::Approx(at_t["rows"][0][column].get<double>()));
}

TEST_CASE("frames: of minimal twist, closing up along a closed spline") {
  const Workshop here;
  here.write("closed.json", bytes_of(test::root("/examples/curves/closed-spline.json")));
  const Run run = here.run(
      "frames closed.json --from 1/3 --closed --frame mtf,mtf-exact --at 0,4 --format json");
  check_success(run);
  const Json rows = Json::parse(run.out)["rows"];
  // Where it starts there it ends, and all vectors with it.
  for (std::size_t column = 1; column < rows[0].size(); ++column)
    CHECK(rows[0][column].get<double>() == doctest::Approx(rows[1][column].get<double>()));
}

// The numbers are those of SciPy (Nelder and Mead's method in the best plane).
TEST_CASE("mtf --wronskian: the quintic of Peng, Pang and Pan") {
  const Workshop here;
  here.write("example.json", bytes_of(test::root("/examples/curves/peng-pang-pan-2023.json")));
  const std::string command = "mtf example.json --wronskian --digits 11 ";
  const Run run = here.run(command + "--print json");
  check_success(run);
  const Json answer = Json::parse(run.out);
  CHECK(answer["phrame"] == "wronskian/1");
  CHECK(answer["weight"] == "one");
  CHECK(answer["resolvent"] == Json({"31231336", "12466956", "1992728", "159229", "6340", "100"}));
  REQUIRE(answer["planes"].size() == 3);
  CHECK(answer["best"] == 2);
  const Json& best = answer["planes"][2];
  CHECK(best["objective"]["value"] == "173.37920852");
  CHECK(best["parameter"]["polynomial"] == answer["resolvent"]);
  CHECK(best["critical_points"] == 1);
  CHECK(best["tied"] == false);
  // (24) by the pair that is printed.
  const auto polynomial = [](const Json& list) {
    std::vector<Rational> c;
    for (const Json& x : list) c.push_back(rational(x));
    return Polynomial(c);
  };
  const Polynomial a = polynomial(answer["rational"]["a"]);
  const Polynomial b = polynomial(answer["rational"]["b"]);
  CHECK(a * differentiate(b) - differentiate(a) * b - polynomial(answer["wronskian"]) ==
        Polynomial::monomial(rational(answer["rational"]["residual"]), 6));
  CHECK(answer["rational"]["frame_degree"] == 12);
  CHECK(rational(answer["rms_times_length"]["value"]) >
        rational(answer["least_rms_times_length"]["value"]));

  const auto value = [&](const std::string& weight) {
    const Run weighted = here.run(command + "--print json --weight " + weight);
    check_success(weighted);
    return Json::parse(weighted.out)["planes"][2]["objective"]["value"].get<std::string>();
  };
  CHECK(value("speed") == "1063.0251767");
  CHECK(abs(rational(Json(value("torsion-curvature"))) - parse_rational("11.83033300")) <
        power_of_ten(-8));
  CHECK(contains(here.run(command).out,
                 "x = −10.3984092744…            J ≈ 173.37920852, 1 critical point of J, the "
                 "least\n"));
  const Run latex = here.run(command + "--print latex");
  CHECK(contains(latex.out, "\n\\text{multiplier $\\lambda$} &\\approx -15.698218105 \\\\\n"));
  CHECK(contains(latex.out, "\na_{0} &= 0 \\\\\n"));
}

TEST_CASE("mtf --wronskian: what does not apply is refused") {
  const Workshop here;
  for (const char* option :
       {"--degree 2", "--free-ends", "--subdivide 1/2", "--unproved", "--exact-only", "--from 0",
        "--to 0", "--from-vector 0,0,1", "--to-vector 0,0,1", "--closed", "--turns 1", "--at 1/2",
        "--samples 3"}) {
    CAPTURE(option);
    const std::string name = std::string(option).substr(0, std::string(option).find(' '));
    check_failure(here.run(std::string("mtf quintic.json --wronskian ") + option), 2,
                  "phrame: " + name + ": ");
  }
  check_failure(here.run("mtf quintic.json --from 0 --to 1 --weight speed"), 2, "--weight: ");
  check_failure(here.run("mtf quintic.json --wronskian --weight 2"), 2, "--weight: ");
  here.write("spline.json", bytes_of(test::root("/examples/curves/closed-spline.json")));
  check_failure(here.run("mtf spline.json --wronskian"), 2,
                "--wronskian: this is for single curves; this is a spline");
  check_failure(here.run("mtf line.json --wronskian"), 3,
                "there is nothing to turn: h = 0, the Euler-Rodrigues frame is");
  here.write("septic.json", bytes_of(test::root("/examples/curves/double-ph-septic.json")));
  check_failure(here.run("mtf septic.json --wronskian"), 3, "the preimage has degree 3: ");
  here.write("zero.json", R"({"phrame": "curve/1", "basis": "power",
      "preimage": {"u": [0, 1], "v": [0, -2, 1], "p": [0], "q": [-2, 3, 5]}})");
  const auto zero = here.run("mtf zero.json --wronskian");
  CHECK(zero.status == 0);
  for (const char* row :
       {"\n  common zero of a, b              t = 0, the frame is that of a/t, b/t\n",
        "\n    a0                             = 0\n", " t²(t − 1)⁴\n",
        "\n  degree of the frame              10\n"})
    CHECK(zero.out.find(row) != std::string::npos);
  CHECK(here.run("mtf zero.json --wronskian --print json").out.find("\"common_zero\": \"0\"") !=
        std::string::npos);
}
