#include "cli/workshop.hpp"

using namespace phrame;
using namespace phrame::test;

namespace {

/// r′ = (1 − t², 2t, 0) from r(0) = (1, 0, 0): A = 1 + t·k.
constexpr auto bezier = R"({"phrame": "curve/1", "name": "cubic",
    "control_points": [[1, 0, 0], ["4/3", 0, 0], ["5/3", "1/3", 0], ["5/3", 1, 0]]})";
constexpr auto parabola = R"({"phrame": "curve/1", "name": "parabola",
    "control_points": [[0, 0, 0], [0.5, 0, 0], [1, 1, 0]]})";

}  // namespace

TEST_CASE("identify: a Bézier curve gives its preimage, in text and JSON") {
  const Workshop here;
  here.write("bezier.json", bezier);
  const Run text = here.run("identify bezier.json");
  check_success(text);
  CHECK(text.out.starts_with("cubic: PH cubic, degree 3 (preimage of degree 1)\n"));
  CHECK(contains(text.out, "Checked"));
  const Run json = here.run("identify bezier.json --print json");
  check_success(json);
  const Json answer = Json::parse(json.out);
  CHECK(answer["ph"] == true);
  CHECK(answer["preimage"]["u"] == Json{"1"});
  CHECK(answer["preimage"]["q"] == Json{"0", "1"});
  CHECK(answer["start"] == Json{"1", "0", "0"});
}

TEST_CASE("identify: --print curve makes a file that the other commands read as the same curve") {
  const Workshop here;
  here.write("bezier.json", bezier);
  CHECK(here.run("identify bezier.json --print curve -o ph.json").status == 0);
  check_success(here.run("info ph.json"));
  CHECK(here.run("info ph.json").out == here.run("info bezier.json").out);
  CHECK(here.run("angle ph.json --at 1").out == here.run("angle bezier.json --at 1").out);
  const Run again = here.run("identify - --print curve", bytes_of(here.file("ph.json")));
  check_success(again);
  CHECK(again.out == bytes_of(here.file("ph.json")));
}

TEST_CASE("identify: the preimage of least degree is found for any curve file") {
  const Workshop here;
  // A = (t + 2i)(1 + t·k)… from the right: α and β have t + 2i in common.
  here.write("common.json", R"({"phrame": "curve/1", "basis": "power", "multiplier": [-1],
      "hopf": {"alpha": [[0, 2], [1, 0]], "beta": [[0, 0], [0, 2], [1, 0]]}})");
  const Run run = here.run("identify common.json --print json");
  check_success(run);
  const Json answer = Json::parse(run.out);
  CHECK(answer["multiplier"] == Json{"4", "0", "1"});  // |t + 2i|²
  // f = −1 turns A i A* around: of A·j = (1 + t·k)·j = −t·i + j, times i on the right.
  CHECK(answer["preimage"]["u"] == Json{"0", "1"});
  CHECK(answer["preimage"]["v"] == Json::array());
  CHECK(answer["preimage"]["p"] == Json::array());
  CHECK(answer["preimage"]["q"] == Json{"-1"});
  check_success(here.run("identify quintic.json"));
  check_success(here.run("identify line.json"));
}

TEST_CASE("identify: a curve that is not PH has status 1 and a reason") {
  const Workshop here;
  here.write("parabola.json", parabola);
  const Run text = here.run("identify parabola.json");
  CHECK(text.status == 1);
  CHECK(text.err.empty());
  CHECK(contains(text.out, "parabola: not a PH curve"));
  CHECK(contains(text.out, "4t² + 1"));
  const Run json = here.run("identify parabola.json --print json -o answer.json");
  CHECK(json.status == 1);
  CHECK(json.out.empty());
  CHECK(Json::parse(bytes_of(here.file("answer.json")))["ph"] == false);
  check_failure(here.run("identify parabola.json --print curve -o ph.json"), 1,
                "no PH curve: |r'| is no polynomial: |r'|^2 has the factor 4*t^2 + 1");
  CHECK_FALSE(fs::exists(here.file("ph.json")));
  // To commands that need a PH curve it is bad input.
  check_failure(here.run("prove parabola.json --at 1"), 2,
                "phrame: parabola.json:/control_points: this is no PH curve");
}

// ((1 − t²), 2t)/(1 + t²) has W²r′ = 2(−2t, 1 − t²), along (1 + i − (1 − i)t)² i for complex
// numbers.
TEST_CASE("identify: a rational curve has A and f of its derivative times the weight's square") {
  const Workshop here;
  here.write("arc.json", R"({"phrame": "curve/1", "name": "arc", "weights": [1, 1, 2],
      "control_points": [[1, 0, 0], [1, 1, 0], [0, 1, 0]]})");
  const Run text = here.run("identify arc.json");
  check_success(text);
  CHECK(
      text.out.starts_with("arc: rational PH curve, degree 2 (preimage of degree 1)\n\n"
                           "r′ = f · A i A*/W² with"));
  CHECK(text.out.ends_with("Checked: f · A i A* is W²r′, exactly.\n"));
  const Json arc = Json::parse(here.run("identify arc.json --print json").out);
  CHECK(arc["ph"] == true);
  CHECK(arc["speed"] == Json{"2", "0", "2"});
  CHECK(arc["weight"] == Json{"1", "0", "1"});
  // By its preimage it is the same.
  CHECK(here.run("identify arc.json --print curve -o preimage.json").status == 0);
  CHECK(here.run("identify preimage.json").out == text.out);
  here.write("bent.json", R"({"phrame": "curve/1", "weights": [1, 1, 3],
      "control_points": [[1, 0, 0], [1, 1, 0], [0, 1, 0]]})");
  const Run bent = here.run("identify bent.json --print json");
  CHECK(bent.status == 1);
  CHECK(contains(std::string(Json::parse(bent.out)["reason"]),
                 "|W^2 r'| is no polynomial: |W^2 r'|^2 has"));
  check_failure(here.run("identify bent.json --near 1e-3"), 2,
                "bent.json:/: the curve is rational");
  const std::string arcs = R"({"phrame": "spline/1", "segments": [
      {"control_points": [[1, 0, 0], [1, 1, 0], [0, 1, 0]], "weights": [1, 1, 2]},
      {"control_points": [[0, 1, 0], [-1, 1, 0], [-1, 0, 0]], "weights": [1, 1, 2]}]})";
  const Run both = here.run("identify -", arcs);
  check_success(both);
  CHECK(contains(both.out, "Checked: all segments are as they were given"));
}

TEST_CASE("identify: bad files and options are refused") {
  const Workshop here;
  here.write("bezier.json", bezier);
  check_failure(here.run("identify bezier.json --print maple"), 2, "--print: \"maple\" is not one");
  check_failure(here.run("identify bezier.json --max-degree 2"), 2,
                "bezier.json:/control_points: 4 points make a degree beyond the limit 2");
  check_failure(here.run("identify missing.json"), 2, "missing.json: cannot be read");
  here.write("point.json", R"({"phrame": "curve/1", "control_points": [[0, 0, 0], [0, 0, 0]]})");
  check_failure(here.run("identify point.json"), 2, "single point");
}

namespace {

/// The control points of a curve file as doubles.
std::string rounded_points(const Workshop& here, const std::string& file, const char* format) {
  const Run run = here.run("info " + file + " --print json");
  check_success(run);
  const Json info = Json::parse(run.out);
  std::string text;
  for (const Json& point : info["control_points"]) {
    text += text.empty() ? "[" : ", [";
    for (std::size_t c = 0; c < 3; ++c) {
      const double x = static_cast<double>(parse_rational(point[c].get<std::string>()));
      std::array<char, 40> digits{};
      std::snprintf(digits.data(), digits.size(), format, x);
      text += std::string(c == 0 ? "" : ", ") + digits.data();
    }
    text += "]";
  }
  return "[" + text + "]";
}

}  // namespace

TEST_CASE(
    "identify --near: rounded control points give a curve, its distance and what frames differ") {
  const Workshop here;
  // Thirds and sevenths, so that the points are no doubles.
  here.write("exact.json", R"({"phrame": "curve/1", "basis": "bernstein", "preimage":
      {"u": [1, "1/3", 2], "v": ["2/7", 1, 0], "p": [0, -1, "1/3"], "q": [1, "1/7", 1]}})");
  here.write("near.json", R"({"phrame": "curve/1", "name": "rounded", "control_points": )" +
                              rounded_points(here, "exact.json", "%.17g") + "}");
  const Run refused = here.run("identify near.json");
  CHECK(refused.status == 1);
  CHECK(contains(refused.out, "not a PH curve over ℚ"));
  CHECK(contains(refused.out, "--near 1e-1"));
  CHECK(contains(refused.out, "takes the PH curve"));
  check_failure(here.run("prove near.json --at 1"), 2, "; --near 1e-1");

  const Run text = here.run("identify near.json --near 1e-15");
  check_success(text);
  CHECK(contains(text.out, "Within 1e-15 there is the PH quintic, degree 5"));
  CHECK(contains(text.out, "rotation-minimizing frames differ by at most"));

  const Run json = here.run("identify near.json --near 1e-12 --print json");
  check_success(json);
  const Json near = Json::parse(json.out)["near"];
  CHECK(Json::parse(json.out)["ph"] == false);
  CHECK(near["found"] == true);
  CHECK(parse_rational(near["distance"].get<std::string>()) <= parse_rational("1e-12"));
  CHECK(parse_rational(near["unrounded_distance"].get<std::string>()) <= parse_rational("1e-15"));
  CHECK(parse_rational(near["rmf_difference"].get<std::string>()) <= parse_rational("1e-10"));

  // The file that is written is PH, exactly.
  CHECK(here.run("identify near.json --near 1e-15 --print curve -o ph.json").status == 0);
  const Run again = here.run("identify ph.json");
  check_success(again);
  CHECK(again.out.starts_with("rounded: PH quintic"));
}

TEST_CASE("--near: other commands take the curve near the points, and say so") {
  const Workshop here;
  here.write("near.json", R"({"phrame": "curve/1", "control_points": )" +
                              rounded_points(here, "quintic.json", "%.9g") + "}");
  for (const char* command : {"info", "classify", "totals", "compile", "certify"}) {
    CAPTURE(command);
    const Run run = here.run(std::string(command) + " near.json --near 1e-6");
    CHECK(run.status == 0);
    CHECK_FALSE(run.out.empty());
    CHECK(contains(run.err, "phrame: near.json: in its place a PH curve at most "));
    CHECK(contains(run.err, "rotation-minimizing frames differ by at most "));
  }
  check_failure(here.run("prove near.json --at 1"), 2, "this is no PH curve");
  CHECK(contains(here.run("certify near.json").err, "with --near 1e-"));
  // Each answer in JSON says what identify says of the curve that stands there.
  here.write("frames.csv", "t,f2x,f2y,f2z\n0,0,1,0\n1,0,1,0\n");
  here.write("lines.jsonl", R"({"curve": )" + test::bytes_of(here.file("near.json")) + "}\n");
  const Json identified =
      Json::parse(here.run("identify near.json --near 1e-6 --print json").out)["near"];
  for (const std::string command :
       {"angle near.json --print json", "info near.json --print json",
        "classify near.json --print json", "totals near.json --print json",
        "frames near.json --at 0 --format json",
        "mtf near.json --from 0 --to 0 --exact-only --print json",
        "interpolate near.json --period 1 --feed 1 --format json",
        "check near.json frames.csv --print json", "batch lines.jsonl"}) {
    CAPTURE(command);
    const Json near = Json::parse(here.run(command + " --near 1e-6").out)["near"];
    CHECK(near["epsilon"] == "1/1000000");
    for (const char* key : {"epsilon", "distance", "rmf_difference", "bits"})
      CHECK(near[key] == identified[key]);
  }
  const std::string note = "at most " + identified["distance"].get<std::string>() + " from it; ";
  const Json certificate = Json::parse(here.run("certify near.json --near 1e-6").out);
  CHECK(contains(certificate["curve"]["note"].get<std::string>(), note));
  const Json file = Json::parse(here.run("identify near.json --near 1e-6 --print curve").out);
  CHECK(contains(file["note"].get<std::string>(), note));
  CHECK(here.run("certify near.json --near 1e-6 -o near.cert").status == 0);
  check_success(here.run("verify near.cert"));
  CHECK(contains(here.run("compile near.json --near 1e-6").out,
                 " * The curve is an exact one that is at most " +
                     identified["distance"].get<std::string>() +
                     " from the one that was given;\n * rotation-minimizing frames of the two "
                     "differ by at most "));
  // What is PH as it is stays what it is.
  const Run exact = here.run("angle quintic.json --near 1e-6");
  check_success(exact);
  CHECK(exact.out == here.run("angle quintic.json").out);
  CHECK_FALSE(
      Json::parse(here.run("info quintic.json --near 1e-6 --print json").out).contains("near"));
}

TEST_CASE("--near: splines get exact joints") {
  const Workshop here;
  // A cubic, and its mirror image behind it: the tangent is continuous, up to rounding.
  here.write("spline.json", R"({"phrame": "spline/1", "name": "two", "segments": [
    {"control_points": [[0, 0, 0], [0.3333333333333333, 0, 0],
                        [0.6666666666666666, 0.3333333333333333, 0], [0.6666666666666666, 1, 0]]},
    {"control_points": [[0.6666666666666666, 1, 0], [0.6666666666666666, 1.6666666666666667, 0],
                        [0.3333333333333333, 2, 0], [0, 2, 0]]}]})");
  const Run refused = here.run("sweep spline.json --exact --profile circle:1");
  CHECK(refused.status == 3);
  const Run angle = here.run("angle spline.json --near 1e-14 --at 2");
  CHECK(angle.status == 0);
  CHECK(contains(angle.err, "in its place a PH spline at most "));
  check_failure(here.run("identify spline.json"), 1, "segment 1 is no PH curve");
  const Run text = here.run("identify spline.json --near 1e-14");
  check_success(text);
  CHECK(contains(text.out, "two: PH spline of 2 segments"));
  CHECK(contains(text.out, "distance"));
  check_success(here.run("identify spline.json --near 1e-14 --print json"));
  check_failure(here.run("identify spline.json --near 1e-17"), 1,
                "no PH curve was found within 1e-17; the nearest one is ");
  const auto cubics = [&here](const std::string& second) {
    here.write("cubics.json",
               R"({"phrame": "spline/1", "segments": [
                   {"control_points": [[0, 0, 0], [1, 1, 0], [1, -1, 1], [2, 0, 0]]},
                   {"control_points": [[2, 0, 0], )" +
                   second + ", [3, -1, 1], [4, 0, 0]]}]}");
    return here.run("identify cubics.json --near 9");
  };
  check_failure(cubics("[3, 1, -1]"), 1, "those near its segments do not join smoothly\n");
  check_failure(cubics("[3, 1, 0]"), 2, "the tangent breaks where segment 2 begins\n");
  const Run certificate = here.run("certify spline.json --near 1e-14");
  CHECK(certificate.status == 0);
  CHECK(contains(certificate.out, "\"path-certificate/1\""));
  CHECK(here.run("identify spline.json --near 1e-14 --print curve -o ph.json").status == 0);
  // What it wrote is PH as it is.
  CHECK(contains(here.run("identify ph.json").out, "Checked: all segments are as they were given"));
  CHECK(here.run("identify ph.json --print curve").out ==
        here.run("identify ph.json --near 1e-14 --print curve").out);
  check_success(here.run("angle ph.json --at 2"));
  CHECK(here.run("angle ph.json --at 2").out == angle.out);
}

TEST_CASE("identify --near: too far is refused with the distance, and bad distances are") {
  const Workshop here;
  here.write("parabola.json", parabola);
  const Run text = here.run("identify parabola.json --near 1e-3");
  CHECK(text.status == 1);
  CHECK(contains(text.out, "no PH curve was found within 1e-3; the nearest one is 0."));
  const Run json = here.run("identify parabola.json --near 1e-3 --print json");
  CHECK(json.status == 1);
  CHECK(Json::parse(json.out)["near"]["found"] == false);
  check_failure(here.run("identify parabola.json --near 1e-3 --print curve"), 1,
                "no PH curve was found within 1e-3");
  check_failure(here.run("angle parabola.json --near 1e-3"), 2,
                "parabola.json: no PH curve was found within 1e-3; the nearest one is 0.");
  CHECK_FALSE(contains(here.run("identify parabola.json").out, "--near"));
  for (const char* epsilon : {"0", "-1", "nan", "1/0", "x", "''"}) {
    CAPTURE(epsilon);
    const Run run = here.run(std::string("angle parabola.json --near ") + epsilon);
    CHECK(run.status == 2);
    CHECK(contains(run.err, "--near"));
    CHECK(here.run(std::string("identify parabola.json --near ") + epsilon).status == 2);
  }
}

TEST_CASE("any curve: angle and frames answer what is no PH curve, and say what needs one") {
  const Workshop here;
  here.write("parabola.json", parabola);
  const Run angle = here.run("angle parabola.json --at 1");
  check_success(angle);
  CHECK(contains(angle.out, "no closed form: the curve is not Pythagorean-hodograph") !=
        contains(angle.out, "θ is constant"));
  CHECK(here.run("frames parabola.json --frame rmf,up,frenet --samples 3").status == 0);
  check_failure(here.run("angle parabola.json --frame erf"), 2, "needs a Pythagorean-hodograph");
  check_failure(here.run("angle parabola.json --route roots"), 2, "is of closed forms");
  check_failure(here.run("frames parabola.json --frame mtf --from 0 --to 0 --at 0"), 2,
                "needs a Pythagorean-hodograph");
}

TEST_CASE("identify: commands for PH curves read them in all formats, and say where one is none") {
  const Workshop here;
  here.write("segment.json", R"({"phrame": "bspline/1", "degree": 1, "knots": [0, 0, 1, 1],
      "control_points": [[0, 0, 0], [3, 4, 0]]})");
  const Run info = here.run("info segment.json --print json");
  check_success(info);
  CHECK(Json::parse(info.out)["arc_length"] == "5");
  here.write("points.csv", "x,y,z\n0,0,0\n1,1,0\n2,0,1\n");
  const Run none = here.run("mtf points.csv --wronskian");
  CHECK(none.status == 2);
  CHECK(
      none.err.starts_with("phrame: points.csv: this command needs a Pythagorean-hodograph curve, "
                           "and this is none (\"phrame identify"));
  // On a line nothing is to be looked for, and formulas have no control points to look near.
  here.write("line.json",
             R"({"phrame": "curve/1", "control_points": [[0, 0, 0], [0, 0, 0], [1, 2, 0]]})");
  check_failure(here.run("angle line.json --frame erf"), 2,
                "this is none but a straight line, where any frame");
  CHECK(contains(here.run("angle line.json").out, "the curve is a straight line, where any frame"));
  here.write("formulas.json", R"~({"phrame": "curve/1", "from": 0, "to": 1,
      "expressions": {"x": "cos(s)", "y": "sin(s)", "z": "s"}})~");
  check_failure(here.run("angle formulas.json --frame erf"), 2,
                "this is none (\"phrame construct\" finds");
  here.write("words.csv", "no curve\n");
  CHECK(contains(here.run("certify words.csv").err, "a curve file is JSON"));
}
