#include "cli/workshop.hpp"
#include "phrame/io/read/curve_file.hpp"

using namespace phrame;
using namespace phrame::test;

namespace {

/// Data of Farouki's talk on helical curves.
constexpr auto hermite = R"({"phrame": "points/1", "name": "left",
    "points": [[0, 0, 0], [1, 1, 1]], "derivatives": [[-0.8, 0.3, 1.2], [0.5, -1.3, -1]]})";
constexpr auto table = "x,y,z\n0,0,0\n1,1,0\n2,0,1\n3,1,1\n";

double number(const Json& text) { return std::stod(text.get<std::string>()); }

}  // namespace

TEST_CASE("construct: points go to a spline that the other commands read") {
  const Workshop here;
  here.write("points.csv", table);
  const Run run = here.run("construct points.csv -o spline.json");
  check_success(run);
  CHECK(run.out.starts_with("PH spline of 3 segments, open\n"));
  CHECK(contains(run.out, "proved; asked for: 3.0e-15"));
  const Json spline = Json::parse(bytes_of(here.file("spline.json")));
  CHECK(spline["phrame"] == "spline/1");
  CHECK(spline["segments"].size() == 3);
  CHECK(spline["segments"][0]["start"] == Json{"0", "0", "0"});
  CHECK_FALSE(spline["segments"][1].contains("start"));
  check_success(here.run("frames spline.json --at 0,1,2,3"));
  const Run info = here.run("info spline.json");
  check_success(info);
  CHECK(info.out.starts_with("PH spline of 3 segments, open\n"));
}

TEST_CASE("construct: a segment is a curve file, with the length and the twist that Python has") {
  const Workshop here;
  here.write("hermite.json", hermite);
  const Run run = here.run(
      "construct hermite.json --angles 0,0,0 --tolerance 1e-20 --print json -o curve.json");
  check_success(run);
  const Json report = Json::parse(run.out);
  CHECK(report["phrame"] == "construct/1");
  CHECK(report["select"] == "angles");
  CHECK(number(report["length"]) == doctest::Approx(2.31036187855954887).epsilon(1e-14));
  CHECK(number(report["energy"]) == doctest::Approx(8.86009090365239988).epsilon(1e-5));
  CHECK(number(report["deviation"]["points"]) <= 1e-20);
  CHECK(number(report["deviation"]["derivatives"]) <= 1.3e-20);
  const Run totals = here.run("totals curve.json --print json");
  check_success(totals);
  const Json found = Json::parse(totals.out);
  CHECK(number(found["erf_twist"]["value"]) == doctest::Approx(0.86264582773312778).epsilon(1e-13));
  CHECK(number(found["bending_energy"]["value"]) ==
        doctest::Approx(8.86009090365239988).epsilon(1e-13));
}

TEST_CASE("construct: --print curve is what -o writes, and nothing more is printed beside it") {
  const Workshop here;
  here.write("hermite.json", hermite);
  const Run printed = here.run("construct hermite.json --print curve");
  check_success(printed);
  const Run quiet = here.run("construct hermite.json --print curve -o curve.json");
  CHECK(quiet.status == 0);
  CHECK(quiet.out.empty());
  CHECK(bytes_of(here.file("curve.json")) == printed.out);
  CHECK(here.run("construct - --print curve", hermite).out == printed.out);
}

TEST_CASE("construct: every rule has a curve, and each says which it is") {
  const Workshop here;
  here.write("hermite.json", hermite);
  for (const std::string name : {"auto", "minimal", "bv", "cc", "shortest", "longest", "energy"}) {
    const Run run = here.run("construct hermite.json --print json --select " + name);
    check_success(run);
    CHECK(Json::parse(run.out)["select"] == name);
  }
  const Run turned = here.run("construct hermite.json --angles pi/4,-0.5 --print json");
  check_success(turned);
  CHECK(Json::parse(turned.out)["segments"][0]["delta"] == "pi/4");
  CHECK(Json::parse(turned.out)["segments"][0]["phi"] == "-1/2");
}

TEST_CASE("construct: bad data and options are refused in a line") {
  const Workshop here;
  here.write("points.csv", table);
  const auto refused = [&](const std::string& data, int status, std::string_view part) {
    check_failure(here.run("construct -", data), status, part);
  };
  refused("1,2,3\n1,2,3\n", 2, "standard input:line 2: the point (1, 2, 3) is that before it");
  refused("1,2,3\n1,nan,3\n", 2, "standard input:line 2, y: \"nan\" is not a number");
  refused("1,2,3\n", 2, "standard input:line 1: there is one point");
  refused("1,2,3\n1,2\n", 2, "standard input:line 2: 2 numbers here");
  refused(R"({"phrame": "points/1", "points": [[0, 0], [1, 0]],
              "accelerations": [[0, 0], [0, 0]]})",
          2, "standard input:/accelerations: the kind quintic takes points and derivatives only");
  refused(R"({"phrame": "points/1", "points": [[0, 0], [1, 0]], "tangents": [[0, 0], [1, 0]]})", 2,
          "/tangents/0: the tangent is 0");
  refused(R"({"phrame": "points/1", "points": [[0, 0], [1, 0], [2, 0]],
              "derivatives": [[1, 0], [0, 0], [1, 0]]})",
          3, "the derivative at point 2 is 0: the tangent would break there");
  refused(R"({"phrame": "points/1", "points": [[0, 0], [0, 0]], "derivatives": [[0, 0], [0, 0]]})",
          3, "segment 1 is a point");
  check_failure(here.run("construct points.csv --tolerance 0"), 2,
                "--tolerance: 0 is not between 0 and 1");
  check_failure(here.run("construct points.csv --tolerance 1"), 2,
                "--tolerance: 1 is not between 0 and 1");
  check_failure(here.run("construct points.csv --angles 1"), 2, "--angles: two angles are wanted");
  check_failure(here.run("construct points.csv --angles 0,0 --select bv"), 2,
                "--select: does not apply with --angles");
  check_failure(here.run("construct points.csv --select best"), 2, "--select: \"best\"");
  check_failure(here.run("construct points.csv --kind sextic"), 2, "--kind: \"sextic\"");
  check_failure(here.run("construct missing.csv"), 2, "missing.csv: cannot be read");
}

TEST_CASE("construct: antiparallel tangents and data of any size have a curve") {
  const Workshop here;
  for (const std::string size : {"1", "1e150", "1e-150"}) {
    const Run run =
        here.run("construct - --print json", R"({"phrame": "points/1", "points": [[0, 0, 0], [")" +
                                                 size + R"(", 0, 0]], "tangents": [[0, 1, 0],
                                                 [0, -1, 0]]})");
    check_success(run);
    CHECK(number(Json::parse(run.out)["deviation"]["points"]) <= 1e-15 * std::stod(size));
  }
}

TEST_CASE("construct: a closed spline is one, exactly, and has a holonomy") {
  const Workshop here;
  here.write("points.csv", table);
  const Run run = here.run("construct points.csv --closed --print json -o spline.json");
  check_success(run);
  const Json report = Json::parse(run.out);
  CHECK(report["closed"] == true);
  CHECK(report["segments"].size() == 5);  // the last of four in two halves
  CHECK(report["parameters"].size() == 6);
  const Run info = here.run("info spline.json");
  check_success(info);
  CHECK(info.out.starts_with("PH spline of 5 segments, closed\n"));
  CHECK(contains(info.out, "holonomy"));
}

TEST_CASE("construct: --kind planar makes the four plane curves, the good one first") {
  const Workshop here;
  const std::string arch = R"({"phrame": "points/1", "points": [[0, 0], [1, 0]],
                               "derivatives": [[1, 1], [1, -1]]})";
  double energy = 0;
  for (const std::string solution : {"1", "4"}) {
    const Run run = here.run("construct - --kind planar --print json --solution " + solution, arch);
    check_success(run);
    const Json report = Json::parse(run.out);
    CHECK(report["solutions"] == 4);
    CHECK(std::to_string(report["solution"].get<long>()) == solution);
    CHECK_FALSE(report.contains("select"));
    CHECK(number(report["energy"]) > 100 * energy);
    energy = number(report["energy"]);
  }
  CHECK(contains(here.run("construct - --kind planar", arch).out, "planar, solution 1 of 4"));
  check_failure(here.run("construct - --kind planar", "0,0,0\n1,1,1\n"), 2,
                "standard input: the point 2 has z = 1, but a plane curve is wanted, in z = 0\n");
  check_failure(here.run("construct - --solution 2", arch), 2,
                "--solution: needs --kind planar, --kind cubic or --kind helical");
  check_failure(here.run("construct - --kind planar --select bv", arch), 2,
                "--select: needs --kind quintic");
}

TEST_CASE(
    "construct: --kind cubic makes PH cubics of ends and tangents, or says that there is none") {
  const Workshop here;
  // A = 1 + t·k has r' = (1 - t^2, 2t, 0): from (1, 0) in the direction (1, 0) to (5/3, 1), (0, 1).
  const Run run = here.run("construct - --kind cubic --print json -o cubic.json",
                           R"({"phrame": "points/1", "points": [[1, 0], ["5/3", 1]],
                               "tangents": [[1, 0], [0, 1]]})");
  check_success(run);
  const Json report = Json::parse(run.out);
  CHECK(report["kind"] == "cubic");
  CHECK_FALSE(report["segments"][0].contains("delta"));
  CHECK(number(report["length"]) == doctest::Approx(4.0 / 3).epsilon(1e-14));
  CHECK(here.run("info cubic.json").out.starts_with("PH cubic, degree 3"));
  check_failure(here.run("construct - --kind cubic", R"({"phrame": "points/1",
                         "points": [[0, 0], [1, 1]], "tangents": [[1, 0], [1, 0]]})"),
                3, "segment 1: there is no PH cubic with these ends and tangents");
  check_failure(here.run("construct - --kind cubic --closed", table), 2,
                "--closed: does not apply with --kind cubic");
}

TEST_CASE("construct: --exact-points meets the points as fractions, in space and in the plane") {
  const Workshop here;
  here.write("points.csv", "x,y,z\n0,0,0\n1,1/3,0\n2,0,1/7\n");
  const Run run = here.run("construct points.csv --exact-points -o spline.json");
  check_success(run);
  CHECK(contains(run.out, "points met      exactly, as equal fractions"));
  // t = 2 is the second point.
  CHECK(contains(here.run("frames spline.json --at 2").out, "\n2,1,0.3333333333333333,0,"));
  const Json spline = Json::parse(bytes_of(here.file("spline.json")));
  CHECK(spline["segments"].size() == 4);
  here.write("plane.csv", "x,y\n0,0\n1,1/3\n2,0\n");
  const Run plane = here.run("construct plane.csv --kind planar --exact-points --print json");
  check_success(plane);
  const Json report = Json::parse(plane.out);
  CHECK(report["law"] == "the curve is in the plane z = 0");
  CHECK(number(report["deviation"]["points"]) == 0);
}

TEST_CASE("construct: --exact-points keeps the shape of every kind") {
  const Workshop here;
  here.write("points.csv", "x,y,z\n0,0,0\n1,1,0.3\n2,1.5,1\n3,1.6,2\n");
  for (const std::string kind : {"rmf", "helical", "rrmf", "cubic"}) {
    CAPTURE(kind);
    const Run run = here.run("construct points.csv --exact-points -o spline.json --kind " + kind);
    check_success(run);
    CHECK(contains(run.out, "points met      exactly, as equal fractions"));
    CHECK(contains(run.out, ", checked\n") == (kind != "cubic"));
    const NamedPhPath read = read_path(bytes_of(here.file("spline.json")));
    const std::vector<Curve>& segments = read.path.segments();
    REQUIRE(segments.size() == 3);
    const std::vector<Vector<Rational>> points{
        {0, 0, 0}, {1, 1, Rational(3, 10)}, {2, Rational(3, 2), 1}, {3, Rational(8, 5), 2}};
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(segments[k].start() == points[k]);
      CHECK(evaluate(position(segments[k]), 1) == points[k + 1]);
    }
    const Json classified = Json::parse(here.run("classify spline.json --print json").out);
    for (const Json& segment : classified["segments"]) {
      if (kind == "rmf") CHECK(segment["erf_is_rmf"]["answer"] == true);
      if (kind == "helical") CHECK(segment["helical"]["answer"] == true);
      if (kind == "rrmf") CHECK(segment["rrmf"]["answer"] == true);
    }
  }
  check_failure(here.run("construct - --kind cubic --exact-points", R"({"phrame": "points/1",
                         "points": [[0, 0, 0], [1, 2, 3]], "tangents": [[1, 2, 3], [1, 2, 3]]})"),
                4, "segment 1: no slight change of its speed leads to its point exactly");
}

TEST_CASE("construct: --print latex has the rows of the text, and a table of the segments") {
  const Workshop here;
  const Run run = here.run("construct - --print latex", hermite);
  check_success(run);
  CHECK(run.out.starts_with("\\begin{align*}\n\\text{kind} &\\quad \\text{quintic, auto}"));
  CHECK(contains(run.out, "\\text{points met} &\\quad \\text{within $"));
  CHECK(contains(run.out, "multiples of $2^{-"));
  CHECK(contains(run.out, "\\text{length} &\\approx 2.35693900088"));
  CHECK(contains(run.out, "1 & $-2.31797$ & $0$ & $2.3569390$ & $8.29871$"));
  CHECK(run.out.ends_with("\\end{tabular}\n"));
  for (const char* sign : {"≈", "²", "∫", "Δ"}) CHECK_FALSE(contains(run.out, sign));
}

// Lengths and energies of Farouki's talk.
TEST_CASE("construct: --kind helical makes the helices there are, and classify finds them") {
  const Workshop here;
  const auto report = [&](const std::string& solution) {
    const Run run = here.run(
        "construct - --kind helical --print json -o curve.json --solution " + solution, hermite);
    check_success(run);
    return Json::parse(run.out);
  };
  const Json first = report("1");
  CHECK(first["law"] == "the tangent of each segment has a constant angle to an axis");
  CHECK_FALSE(first.contains("select"));
  CHECK(number(first["length"]) == doctest::Approx(2.35974267543260545).epsilon(1e-14));
  CHECK(number(first["energy"]) == doctest::Approx(8.43828938599157977).epsilon(1e-5));
  const Json classified = Json::parse(here.run("classify curve.json --print json").out);
  CHECK(classified["helical"]["answer"] == true);
  CHECK(number(report("4")["energy"]) == doctest::Approx(1484.97155).epsilon(1e-4));
  report("5");
  check_failure(here.run("construct - --kind helical --solution 6", hermite), 3,
                "segment 1: there are 5 helical quintics with these ends and derivatives, so no "
                "solution 6");
  check_failure(here.run("construct - --kind helical --closed", table), 2,
                "--closed: does not apply with --kind helical");
  const Run spline = here.run("construct - --kind helical -o spline.json", table);
  check_success(spline);
  CHECK(contains(spline.out, "helical, solution 1 of up to 8"));
  check_success(here.run("frames spline.json --at 0,1,2,3"));
}

TEST_CASE(
    "construct: --kind rrmf makes quintics with a rational frame, or says that none is found") {
  const Workshop here;
  const Run run = here.run("construct - --kind rrmf --print json -o spline.json",
                           "x,y,z\n0,0,0\n1,1,0.3\n2,1.5,1\n3,1.6,2\n");
  check_success(run);
  const Json report = Json::parse(run.out);
  CHECK(report["law"] == "each segment has a rational rotation-minimizing frame");
  CHECK_FALSE(report.contains("select"));
  CHECK_FALSE(report.contains("solution"));
  CHECK(number(report["deviation"]["derivatives"]) <= 1e-15);
  const Json classified = Json::parse(here.run("classify spline.json --print json").out);
  REQUIRE(classified["segments"].size() == 3);
  for (const Json& segment : classified["segments"]) CHECK(segment["rrmf"]["answer"] == true);
  check_failure(here.run("construct - --kind rrmf",
                         R"({"phrame": "points/1", "points": [[0, 0, 0], [1, 1, 1]],
                             "tangents": [[0.4, -1.5, -1.2], [-1.2, -0.6, -1.2]]})"),
                4, "segment 1: no quintic with these ends and tangents and a rational");
  check_failure(here.run("construct - --kind rrmf --closed", table), 2,
                "--closed: does not apply with --kind rrmf");
}

TEST_CASE("construct: --kind rmf makes curves whose rational frame is rotation-minimizing") {
  const Workshop here;
  const Run run =
      here.run("construct - --kind rmf --tolerance 1e-30 --print json -o curve.json", hermite);
  check_success(run);
  const Json report = Json::parse(run.out);
  CHECK(report["kind"] == "rmf");
  CHECK(report["law"] == "h = 0: the Euler-Rodrigues frame is rotation-minimizing");
  CHECK_FALSE(report.contains("select"));
  CHECK_FALSE(report.contains("solution"));
  // The prototype in Python has 9.206459.
  CHECK(number(report["energy"]) == doctest::Approx(9.206459).epsilon(1e-5));
  CHECK(number(report["deviation"]["points"]) <= 1e-30);
  CHECK(contains(here.run("classify curve.json").out, "ERF is an RMF         yes"));
  const Run angle = here.run("angle curve.json --at 1");
  check_success(angle);
  CHECK(contains(angle.out, "θ  = 0"));
  const Run text = here.run("construct - --kind rmf", table);
  check_success(text);
  CHECK(contains(text.out, "\n  kind            rmf\n"));
  CHECK(contains(text.out, "is rotation-minimizing, checked\n"));
  CHECK_FALSE(contains(text.out, "multiples of"));
  CHECK_FALSE(contains(text.out, "Δ"));
}

TEST_CASE("construct: --kind rmf closes splines, and says which segment has no septic") {
  const Workshop here;
  const Run run = here.run("construct - --kind rmf --closed -o spline.json", table);
  check_success(run);
  CHECK(run.out.starts_with("PH spline of 4 segments, closed\n"));
  const Run classified = here.run("classify spline.json --print json");
  check_success(classified);
  const Json classes = Json::parse(classified.out);
  for (const Json& segment : classes["segments"]) CHECK(segment["erf_is_rmf"]["answer"] == true);
  check_failure(here.run("construct - --kind rmf", R"({"phrame": "points/1",
                    "points": [[0, 0, 0], [1, 0.1, 0.2]],
                    "derivatives": [[1e8, 0, 1], [0, 1e-8, 0]]})"),
                4, "segment 1: no septic with h = 0 was found");
  check_failure(here.run("construct - --kind rmf --select bv", table), 2,
                "--select: needs --kind quintic");
}

TEST_CASE("construct: --kind c2 makes C2 splines through points, open and closed") {
  const Workshop here;
  here.write("points.csv", table);
  const Run open = here.run("construct points.csv --kind c2 --print json -o open.json");
  check_success(open);
  const Json report = Json::parse(open.out);
  CHECK(report["kind"] == "c2");
  CHECK(report["law"] == "the second derivative by the parameter is continuous");
  CHECK_FALSE(report.contains("select"));
  CHECK_FALSE(report["segments"][0].contains("delta"));
  CHECK(report["segments"].size() == 3);
  CHECK(number(report["deviation"]["points"]) <= 3e-15);
  CHECK(number(report["deviation"]["derivatives"]) <= 3e-15);
  CHECK(here.run("info open.json").out.starts_with("PH spline of 3 segments, open\n"));
  const Run closed = here.run("construct points.csv --kind c2 --closed --print json -o ring.json");
  check_success(closed);
  const Json ring = Json::parse(closed.out);
  CHECK(ring["closed"] == true);
  CHECK(ring["segments"].size() == 9);  // one of four in six parts
  CHECK(ring["parameters"].size() == 10);
  CHECK_FALSE(ring["deviation"].contains("derivatives"));
  CHECK(here.run("info ring.json").out.starts_with("PH spline of 9 segments, closed\n"));
  const std::string text = here.run("construct points.csv --kind c2 --closed").out;
  CHECK(contains(text, "position and both derivatives by the parameter are equal fractions"));
  CHECK_FALSE(contains(text, "\n    derivatives "));
  CHECK_FALSE(contains(text, "Δ"));
  const Run exact = here.run("construct points.csv --kind c2 --exact-points --print json");
  check_success(exact);
  CHECK(Json::parse(exact.out)["segments"].size() == 18);
}

TEST_CASE("construct: --kind c2 takes derivatives at the ends of open splines") {
  const Workshop here;
  here.write("hermite.json", hermite);
  const Run run = here.run("construct hermite.json --kind c2 -o curve.json");
  check_success(run);
  CHECK(contains(run.out, "given, at the ends\n"));
  check_failure(here.run("construct hermite.json --kind c2 --closed"), 2,
                "hermite.json:/derivatives: a closed spline of the kind c2 takes points only");
  check_failure(here.run("construct - --kind c2 --closed", R"({"phrame": "points/1",
                         "points": [[0, 0], [1, 0], [0, 1]],
                         "tangents": [[0, 1], [1, 0], [1, 1]]})"),
                2, "/tangents: a closed spline of the kind c2 takes points only");
  check_failure(here.run("construct hermite.json --kind c2 --select bv"), 2,
                "--select: needs --kind quintic");
  check_failure(here.run("construct - --kind c2 --closed", "0,0,0\n1,0,0\n"), 3,
                "a closed C2 spline wants three different points at least");
  check_success(
      here.run("construct - --kind c2", "t,x,y,z\n0,0,0,0\n1,1,1,0\n1.001,2,1,1\n2,3,0,0\n"));
  check_failure(
      here.run("construct - --kind c2", "t,x,y,z\n0,0,0,0\n1,1,1,0\n1.000000001,2,1,1\n2,3,0,0\n"),
      4, "the C2 spline: Newton's method finds none");
}

TEST_CASE("construct: --kind c2-hermite meets accelerations") {
  const Workshop here;
  const std::string data = R"({"phrame": "points/1", "points": [[0, 0, 0], [1, 1, 1], [2, 4, 8]],
      "derivatives": [[1, 0, 0], [1, 2, 3], [1, 4, 12]],
      "accelerations": [[0, 2, 0], [0, 2, 6], [0, 2, 12]]})";
  const Run run =
      here.run("construct - --kind c2-hermite --tolerance 1e-30 --print json -o curve.json", data);
  check_success(run);
  const Json report = Json::parse(run.out);
  CHECK(report["segments"].size() == 2);
  CHECK(number(report["deviation"]["accelerations"]) <= 1.2e-29);
  CHECK(number(report["tolerance"]["accelerations"]) == doctest::Approx(1.2e-29));
  CHECK(
      contains(here.run("construct - --kind c2-hermite", data).out, "\n  accelerations   within "));
  check_failure(here.run("construct - --kind c2-hermite --exact-points", R"({"phrame": "points/1",
                         "points": [[0, 0, 0], [1, 1, 1]], "derivatives": [[1, 0, 0], [1, 2, 3]],
                         "accelerations": [[0, 2, 0], [1e150, 2, 6]]})"),
                4, "the exact end: the sum of two squares would have ");
  check_failure(here.run("construct - --kind c2-hermite", table), 2,
                "the kind c2-hermite wants accelerations; for points only there is the kind c2");
  check_failure(here.run("construct - --kind c2", data), 2,
                "/accelerations: the kind c2 takes points and derivatives only");
}

TEST_CASE("construct --kind minkowski: curves with radii, which envelope reads, exact or near") {
  const Workshop here;
  here.write("radii.json", R"({"phrame": "points/1", "name": "bone",
      "points": [[0, 0, 2], [3, 1, 1], [6, 0, "3/2"]],
      "derivatives": [[3, 2, "-3/2"], [3, 0, 0], [3, -1, 1]]})");
  const Run run = here.run("construct radii.json --kind minkowski --print json -o axis.json");
  check_success(run);
  const Json report = Json::parse(run.out);
  CHECK(report["phrame"] == "construct-axis/1");
  CHECK(number(report["deviation"]["points"]) <= 6e-15);
  CHECK(number(report["deviation"]["derivatives"]) <= 3e-15);
  CHECK(report["lightlike"] == Json::array({Json::array(), Json::array()}));
  const Run text = here.run("construct radii.json --kind minkowski --tolerance 1e-30");
  check_success(text);
  CHECK(contains(text.out, "bone: 2 curves with radii"));
  CHECK(contains(text.out, "proved; asked for: 6.0e-30"));
  CHECK(contains(text.out, "spacelike       everywhere"));
  const Run envelope = here.run("envelope axis.json --trim --print json");
  check_success(envelope);
  const Json found = Json::parse(envelope.out);
  REQUIRE(found["segments"].size() == 2);
  for (const Json& segment : found["segments"]) CHECK(segment["degree"] == 5);
  // Neighbours have the derivative in common, so that there is no arc between them.
  REQUIRE(found["branches"].size() == 1);
  for (const Json& part : found["branches"][0]["parts"])
    CHECK((part["on"] != "arc" || part["from"]["t"] != "1"));
  const std::string curves = here.run("construct radii.json --kind minkowski --print curve").out;
  CHECK(curves == bytes_of(here.file("axis.json")));
  const Run line = here.run("construct - --kind minkowski",
                            R"({"phrame": "points/1", "points": [[0, 0, 1], [5, 0, 4]],
                                "derivatives": [[5, 0, 3], [5, 0, 3]]})");
  CHECK(contains(line.out, "points met      exact, proved"));
  CHECK(contains(here.run("construct radii.json --kind minkowski --print latex").out, "align*"));
  // Columns are r, or z; dr, or dz.
  const std::string rows = "0,0,2,3,2,-3/2\n3,1,1,3,0,0\n6,0,3/2,3,-1,1\n";
  const auto axis = [&](const std::string& header) {
    return here.run("construct - --kind minkowski --print curve", header + "\n" + rows);
  };
  const Run radii = axis("x,y,r,dx,dy,dr");
  check_success(radii);
  CHECK(radii.out == axis("x,y,z,dx,dy,dz").out);
  const std::string named = curves.substr(curves.find("segments"));
  CHECK(radii.out.substr(radii.out.find("segments")) == named);
}

TEST_CASE("construct --kind minkowski: what has no curve with radii is refused in one line") {
  const Workshop here;
  const auto refuse = [&](const std::string& options, const std::string& data, int status,
                          const std::string& reason) {
    check_failure(here.run("construct - --kind minkowski -o axis.json " + options, data), status,
                  "phrame: " + reason);
    CHECK_FALSE(std::filesystem::exists(here.file("axis.json")));
  };
  const auto points = [](const std::string& rest) {
    return R"({"phrame": "points/1", "points": )" + rest + "}";
  };
  refuse("", points("[[0, 0], [1, 1]]"), 2,
         "standard input:/points: the kind minkowski wants points x, y, r");
  refuse("", points("[[0, 0, 1], [1, 1, -1]]"), 2, "standard input: the radius at point 2 is -1\n");
  refuse("", points(R"([[0, 0, 1], [1, 1, 1]], "derivatives": [[1, 0, 0], [1, 1, 2]])"), 3,
         "the derivative at point 2 has x'^2 + y'^2 < r'^2");
  refuse("--closed", points("[[0, 0, 1], [1, 1, 1], [2, 0, 1]]"), 2, "--closed");
  refuse("--exact-points", points("[[0, 0, 1], [1, 1, 1]]"), 2, "--exact-points");
}
