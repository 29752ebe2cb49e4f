#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "phrame/io/read/any_path.hpp"
#include "phrame/io/write/curve_file.hpp"
#include "phrame/io/write/nurbs.hpp"

#include "cli/workshop.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/place.hpp"
#include "phrame/ph/curve/real_vector.hpp"
#include "phrame/ph/offset/offset.hpp"
#include "support/random.hpp"

namespace offset_cli_test {

using namespace phrame;
using namespace phrame::test;

namespace {

const char* const turn = R"({"phrame": "curve/1", "basis": "power",
    "preimage": {"u": [1], "v": [0], "p": [0], "q": [0, 1]}})";
const char* const corner = R"({"phrame": "spline/1", "segments": [
    {"control_points": [[0, 0, 0], [1, 0, 0]]}, {"control_points": [[1, 0, 0], [1, 1, 0]]}]})";

}  // namespace

TEST_CASE("offset: where it meets itself is told to the digits asked for") {
  Workshop here;
  here.write("septic.json",
             R"({"phrame": "curve/1", "basis": "bernstein", "preimage": {"u": [2, -6, 8, -7],
                 "v": [0, 0, 0, 0], "p": [0, 0, 0, 0], "q": [9, -9, -3, 7]}})");
  // mpmath: findroot() of the two equations, with r by quad().
  for (const auto& [digits, place] : {
           std::pair("4", "t = 0.7471 and t = 0.9448: (7.536, −3.447)"),
           std::pair("40",
                     "t = 0.7470516722398756938390351049582295777209 and "
                     "t = 0.9448108135501038992943214378588986202206: "
                     "(7.535715998130268809710208550035325764693, "
                     "−3.447385542646449385125314429376890139962)"),
       })
    CHECK(contains(
        here.run(std::string("offset septic.json --distance -15 --digits ") + digits).out, place));
}

TEST_CASE("offset: cusps, lengths and self-intersections, in text and JSON") {
  const Workshop here;
  here.write("turn.json", turn);
  const Run text = here.run("offset turn.json --distance -1 --digits 12");
  check_success(text);
  CHECK(contains(text.out, "−1, to the left of travel"));
  CHECK(contains(text.out, "0.643594252905…, where it turns back"));
  CHECK(contains(text.out, "0.411261664757"));
  CHECK(contains(text.out, "0.173798671296"));
  const Run json = here.run("offset turn.json --distance 1,-1 --print json");
  check_success(json);
  const Json answer = Json::parse(json.out);
  REQUIRE(answer["offsets"].size() == 2);
  CHECK(answer["offsets"][0]["cusps"].empty());
  CHECK(answer["offsets"][0]["length"]["exact"] == "4/3 + 1/2*pi");
  CHECK(answer["offsets"][1]["cusps"][0]["turns_back"] == true);
  CHECK(answer["offsets"][1]["self_intersections"]["complete"] == true);
  CHECK(contains(here.run("offset turn.json --distance 1 --print latex").out, "\\frac{4}{3}"));
}

// A rectangle of the sides 1 and 1 + 10⁻²⁰, less by 6·10⁻²⁰ each; the decimals are those of
// fractions in Python.
TEST_CASE("offset: long fractions are decimals in a text, and exact in JSON") {
  const Workshop here;
  here.write("box.json", R"({"phrame": "spline/1", "segments": [
      {"control_points": [[0, 0], ["1.00000000000000000001", 0]]},
      {"control_points": [["1.00000000000000000001", 0], ["1.00000000000000000001", 1]]},
      {"control_points": [["1.00000000000000000001", 1], [0, 1]]},
      {"control_points": [[0, 1], [0, 0]]}]})");
  const Run text =
      here.run("offset box.json --distance=-0.00000000000000000003 --trim --digits 22");
  check_success(text);
  CHECK(contains(text.out, "distance d            −3e-20, to the left"));
  CHECK(contains(text.out, "length              3.999999999999999999780"));
  CHECK(contains(text.out, "signed area         0.9999999999999999998900"));
  CHECK(
      contains(text.out, "from t = 2.999999999999999999970e-20 to t = 0.9999999999999999999700,"));
  const Run json =
      here.run("offset box.json --distance=-0.00000000000000000003 --trim --print json");
  const Json branch = Json::parse(json.out)["trimmed"][0]["branches"][0];
  CHECK(branch["length"]["exact"] == "199999999999999999989/50000000000000000000");
  CHECK(
      contains(here.run("offset box.json --distance=-1/4 --trim").out, "from t = 5/4 to t = 7/4"));
}

// The place is that of findroot() of mpmath: w = (s + i/10^20)(2 - 3i + (2 + 7i)s), s = t - 29/50.
TEST_CASE("offset: where it meets itself next to a near-cusp all digits are told") {
  const Workshop here;
  here.write("near.json", R"({"phrame": "curve/1", "basis": "power", "preimage": {
      "u": ["-2435999999999999999647/5000000000000000000000", "-32000000000000000007/100000000000000000000", "2"],
      "v": [0], "p": [0],
      "q": ["10237000000000000000021/2500000000000000000000", "-555999999999999999999/50000000000000000000", "7"]}})");
  CHECK(contains(here.run("offset near.json --distance=-0.25").out,
                 "t = 0.38689100951517133 and t = 0.58000000000000000: "
                 "(−2.1356665710586595, −1.0222379296488601)"));
}

TEST_CASE("offset: the file that is written is the offset, and other commands read it") {
  const Workshop here;
  here.write("turn.json", turn);
  const Run run = here.run("offset turn.json --distance -1 -o off.json");
  check_success(run);
  const NamedPath back = read_any_path(bytes_of(here.file("off.json")));
  REQUIRE(back.path.segments().size() == 1);
  const Curve curve({{1}, {}, {}, {0, 1}});
  CHECK(back.path == paths(offset(PhPath(curve), -1)).front());
  check_success(here.run("info off.json"));
  check_success(here.run("frames off.json --samples 3"));
  check_success(here.run("offset turn.json --distance -1 --print curve"));
}

TEST_CASE("offset: law: write, read, the same curves, with joins and with weights below 0") {
  for_samples(20, [](Random& random) {
    const auto p = [&] {
      return from_bernstein({random.integer(-6, 6), random.integer(-6, 6), random.integer(-6, 6)});
    };
    PhPath path(Curve({p(), {}, {}, p() + Polynomial{0, Rational(1, 7)}}));
    const Curve next({p(), {}, {}, p() + Polynomial{0, Rational(1, 7)}}, Polynomial{1},
                     control_points(path.segments().front()).back());
    try {
      path.append(next);
    } catch (const DomainError&) {
      return;  // the tangent turns back
    }
    for (const OffsetJoin join : {OffsetJoin::round, OffsetJoin::mitre})
      for (const Path& offset : paths(offset(path, random.integer(0, 1) == 0 ? -1 : 2, join))) {
        CHECK(read_any_path(write_path(NamedPath("", offset))).path == offset);
        const OffsetNurbs one{"offset", "", {{as_bspline(offset), offset.ends_meet()}}};
        const NamedPath nurbs = read_any_path(write_nurbs(one));
        const NamedPath dxf = read_any_path(write_dxf(one));
        for (long k = 0; k < 2; ++k) {
          const Rational t = offset.end() * Rational(2 * k + 1, 5);
          const auto at = position(offset, locate(offset, t));
          CHECK(exactly(position(nurbs.path, native_place(nurbs, t))) == exactly(at));
          const auto near = position(dxf.path, native_place(dxf, t));
          for (std::size_t j = 0; j < 3; ++j)
            CHECK(approximate(near[j].enclose(64)) ==
                  doctest::Approx(approximate(at[j].enclose(64))).epsilon(1e-9));
        }
      }
  });
}

TEST_CASE("offset: several paths are a line each, which a batch reads") {
  const Workshop here;
  here.write("corner.json", corner);
  const Run drawn = here.run("offset corner.json --distance -1/4 -o off.dxf");
  check_success(drawn);
  CHECK(contains(here.run("info off.dxf --pick offset-2").out, "line segment"));
  CHECK(contains(here.run("offset corner.json --distance -1/4 --print nurbs").out, "nurbs/1"));
  const Run run = here.run("offset corner.json --distance -1/4 -o off.jsonl");
  check_success(run);
  CHECK(contains(run.out, "inner corner"));
  const Run batch = here.run("batch off.jsonl --question info");
  check_success(batch);
  CHECK(std::count(batch.out.begin(), batch.out.end(), '\n') == 2);
}

TEST_CASE("offset: joins at corners") {
  const Workshop here;
  here.write("corner.json", corner);
  const auto length = [&](const std::string& join) {
    const Run run = here.run("offset corner.json --distance 1/2 --print json --join " + join);
    check_success(run);
    return Json::parse(run.out)["offsets"][0]["length"]["exact"].get<std::string>();
  };
  CHECK(length("round") == "2 + 1/4*pi");
  CHECK(length("mitre") == "3");
  CHECK(length("open") == "2");
}

TEST_CASE("offset: trimmed, in text, JSON and as a curve that other commands read") {
  const Workshop here;
  here.write("triangle.json", R"({"phrame": "spline/1", "segments": [
      {"control_points": [[0, 0, 0], [4, 0, 0]]}, {"control_points": [[4, 0, 0], [4, 3, 0]]},
      {"control_points": [[4, 3, 0], [0, 0, 0]]}]})");
  // Similar to it, with half the inradius.
  const Run text = here.run("offset triangle.json --distance -1/2,-3 --trim");
  check_success(text);
  CHECK(contains(text.out, "from t = 3/8 to t = 7/8"));
  CHECK(contains(text.out, "none: but for single points all of it is nearer"));
  const Run json = here.run("offset triangle.json --distance -1/2 --trim --print json -o in.json");
  check_success(json);
  const Json part = Json::parse(json.out)["trimmed"][0];
  REQUIRE(part["branches"].size() == 1);
  CHECK(part["undecided"].empty());
  CHECK(part["branches"][0]["closed"] == true);
  CHECK(part["branches"][0]["length"]["exact"] == "6");
  CHECK(part["branches"][0]["area"]["exact"] == "3/2");
  CHECK(part["branches"][0]["parts"][0]["from"]["t"] == "3/8");
  CHECK(contains(here.run("info in.json").out, "closed"));
  here.write("turn.json", turn);
  CHECK(contains(here.run("offset turn.json --distance -1 --trim --print latex").out, "stretch"));
  here.write("back.json", R"({"phrame": "curve/1", "basis": "power", "multiplier": [1, -3],
      "preimage": {"u": [1], "v": [0], "p": [0], "q": [0, 1]}})");
  const auto branches = [&](const std::string& options) {
    const std::string out = here.run("offset back.json --distance 1 --trim" + options).out;
    return out.substr(out.find("  branch"));
  };
  CHECK(contains(branches(""), "stretch"));
  here.write("circle.json", R"({"phrame": "curve/1", "basis": "power",
      "position": {"x": [1, 0, -1], "y": [0, 2], "w": [1, 0, 1]}})");
  CHECK(branches(" --gauge circle.json") == branches(""));
  here.write("ellipse.json", R"({"phrame": "curve/1", "basis": "power",
      "position": {"x": [1, 0, -1], "y": [0, 4], "w": [1, 0, 1]}})");
  check_failure(here.run("offset back.json --distance 1 --trim --gauge ellipse.json -o off.json"),
                3, "phrame: offset: the path has no rational offset under this gauge: ");
  here.write("parabola.json",
             R"({"phrame": "curve/1", "control_points": [[0, 0, 0], ["1/2", 0, 0], [1, 1, 0]]})");
  for (const char* more : {" --trim", " --pocket"})
    check_failure(
        here.run(std::string("offset parabola.json --distance 1 -o off.json") + more), 2,
        "phrame: parabola.json: the path is not PH: its offset is rational for both sides "
        "together, which is not trimmed; with --near EPS");
  const auto refused = [&](const std::string& curve, const std::string& why) {
    here.write("other.json",
               R"({"phrame": "curve/1", "basis": "power", "position": )" + curve + "}");
    check_failure(here.run("offset other.json --distance 1 -o off.json"), 2,
                  "other.json: the path is not PH" + why);
  };
  refused(R"({"x": [0, 1], "y": [0, 0, 0, 1]})", ", so that its offset is not rational; with");
  refused(R"({"x": [0, -1, 3], "y": [0, 0, 1, -6, 9]})",
          ", and runs more than once along a curve of which");
  here.write("two.json", R"({"phrame": "spline/1", "segments": [
      {"control_points": [[0, 0, 0], [1, 0, 0]]}, {"control_points": [[1, 0, 0], [2, 0, 0], [4, 1, 0]]}]})");
  check_failure(
      here.run("offset two.json --distance 1 -o off.json"), 2,
      "two.json: segment 2 is not PH: its offset is rational for both sides together, which is "
      "given of a path of one segment; with");
  CHECK_FALSE(std::filesystem::exists(here.file("off.json")));
}

TEST_CASE("offset: a parabola that is traced twice has the offset of the one that is traced once") {
  const Workshop here;
  here.write(
      "once.json",
      R"({"phrame": "curve/1", "basis": "power", "position": {"x": [0, 1], "y": [0, 0, 1]}})");
  here.write(
      "twice.json",
      R"({"phrame": "curve/1", "basis": "power", "position": {"x": [0, 0, 1], "y": [0, 0, 0, 0, 1]}})");
  const Run once = here.run("offset once.json --distance 1/3");
  const Run twice = here.run("offset twice.json --distance 1/3");
  check_success(once);
  check_success(twice);
  const auto behind = [](const std::string& text) { return text.substr(text.find("\n  X ")); };
  CHECK(behind(once.out) == behind(twice.out));
  CHECK(contains(twice.out, "traced                several times, by s = t²\n  s   "));
  CHECK(contains(here.run("info twice.json").out, "traced several times by s = t², by s = "));
  const Run json = here.run("offset twice.json --distance 1/3 --print json");
  CHECK(contains(json.out, R"("s": {)"));
}

TEST_CASE("offset: a path that comes back after one cusp, and points beyond those of doubles") {
  const Workshop here;
  here.write("odd.json",
             R"({"phrame": "spline/1", "segments": [{"control_points": [[0, 1], [0, 0]]},
      {"control_points": [[0, 0], [4, 0], [4, 0], [2, 0]]}, {"control_points": [[2, 0], [2, 2]]},
      {"control_points": [[2, 2], [0, 2]]}, {"control_points": [[0, 2], [0, 1]]}]})");
  CHECK(contains(here.run("offset odd.json --distance 1/4 --trim").out,
                 "its ends meet, e₁ being the opposite: an odd number of cusps"));
  check_failure(here.run("offset odd.json --distance -1/4 --pocket"), 2,
                "pocket: the path turns back at an odd number of cusps");
  here.write("cubic.json", R"({"phrame": "curve/1",
      "control_points": [[0, 0, 0], ["1/3", 0, 0], ["2/3", "1/3", 0], ["2/3", 1, 0]]})");
  check_failure(here.run("offset cubic.json --distance 1e1000 --trim"), 4, "points beyond 10^300");
}

TEST_CASE("offset --check: of a path with arcs, and of polylines in JSON that are not closed") {
  const Workshop here;
  // A line and a quarter of a circle around (1, 1).
  here.write("arc.json",
             R"({"phrame": "spline/1", "segments": [{"control_points": [[0, 0], [1, 0]]},
      {"control_points": [[1, 0], [2, 0], [2, 1]], "weights": [1, 1, 2]}]})");
  here.write("inside.json",
             R"({"phrame": "spline/1", "segments": [{"control_points": [[0, "1/2"], [1, "1/2"]]},
      {"control_points": [[1, "1/2"], ["3/2", "1/2"], ["3/2", 1]], "weights": [1, 1, 2]}]})");
  for (const char* more : {"", " --trim"})
    CHECK(here.run(std::string("offset arc.json --distance -1/2 --check inside.json") + more)
              .status == 0);
  CHECK(here.run("offset arc.json --distance -1/4 --check inside.json").status == 1);
  here.write("triangle.json", R"({"phrame": "spline/1", "segments": [
      {"control_points": [[0, 0, 0], [4, 0, 0]]}, {"control_points": [[4, 0, 0], [4, 3, 0]]},
      {"control_points": [[4, 3, 0], [0, 0, 0]]}]})");
  // The incircle's radius is 1: of half the size, with a spike on a side.
  for (const char* spike : {"", R"(, ["5/2", "1/2"], [2, "1/2"])"}) {
    here.write(
        "theirs.json",
        std::string(R"({"phrame": "points/1", "kind": "polyline", "points": [["3/2", "1/2"])") +
            spike + R"(, ["7/2", "1/2"], ["7/2", 2]]})");
    const Run run = here.run("offset triangle.json --distance -1/2 --trim --check theirs.json");
    CHECK(run.status == 0);
    CHECK(contains(run.out, "are closed, as the offset is: 1."));
  }
}

TEST_CASE("offset: a pocket, one room after the other, until nothing is left") {
  const Workshop here;
  // Two rooms of 10 by 10, and a neck of 1.8 between them, which is shut at 1.
  std::string segments;
  const std::array<const char*, 13> corners{"0, 0",   "10, 0",  "10, 4.1", "14, 4.1", "14, 0",
                                            "24, 0",  "24, 10", "14, 10",  "14, 5.9", "10, 5.9",
                                            "10, 10", "0, 10",  "0, 0"};
  for (std::size_t k = 0; k + 1 < corners.size(); ++k)
    segments += std::string(k == 0 ? "" : ", ") + R"({"control_points": [[)" + corners[k] +
                ", 0], [" + corners[k + 1] + ", 0]]}";
  here.write("rooms.json", R"({"phrame": "spline/1", "segments": [)" + segments + "]}");
  const Run run = here.run("offset rooms.json --distance -0.75 --pocket --join mitre --print json");
  check_success(run);
  const Json found = Json::parse(run.out)["trimmed"];
  // 0.75 leaves both in one; those of each are squares with the sides 10 - 2d, one inside another.
  REQUIRE(found.size() == 11);
  CHECK(found[0]["distance"] == "-3/4");
  for (std::size_t k = 1; k < 11; ++k) {
    const long level = static_cast<long>((k - 1) % 5) + 2;
    const Rational d(3 * level, 4);
    CHECK(found[k]["distance"] == to_string(Rational(-d)));
    REQUIRE(found[k]["branches"].size() == 1);
    const Json& branch = found[k]["branches"][0];
    CHECK(branch["area"]["exact"] == to_string(Rational((10 - 2 * d) * (10 - 2 * d))));
    const double x = std::stod(branch["parts"][0]["from"]["point"][0]["value"].get<std::string>());
    CHECK((x < 10) == (k < 6));
  }
  // Rooms with rounded corners, of which the arcs are left out at one distance, and pieces have
  // other numbers there than at the next ones.
  const std::string rounded =
      "M1,0 L9,0 A1,1 0 0 1 10,1 L10,4.1 L14,4.1 L14,0 L24,0 L24,10 L14,10 L14,5.9 L10,5.9 L10,9 "
      "A1,1 0 0 1 9,10 L1,10 A1,1 0 0 1 0,9 L0,1 A1,1 0 0 1 1,0 Z";
  here.write("rounded.svg", "<svg><path d='" + rounded + "'/></svg>");
  const Run of_rounded = here.run("offset rounded.svg --distance -1 --pocket --print json");
  check_success(of_rounded);
  const Json levels = Json::parse(of_rounded.out)["trimmed"];
  REQUIRE(levels.size() == 10);
  for (std::size_t k = 0; k < 10; ++k) {
    CHECK(levels[k]["distance"] == std::to_string(-static_cast<long>(k % 5) - 1));
    const Json& at = levels[k]["branches"][0]["parts"][0]["from"]["point"][0]["value"];
    CHECK((std::stod(at.get<std::string>()) < 12) == (k < 5));
  }
  check_failure(here.run("offset rooms.json --distance 1 --pocket -o off.dxf"), 2,
                "phrame: pocket: the distance 1 is to the outside of the path\n");
  here.write("corner.json", corner);
  check_failure(here.run("offset corner.json --distance -1 --pocket"), 2,
                "phrame: pocket: the path is open\n");
  here.write("triangle.svg", "<svg><path d='M0,0 L4,0 L4,3 Z'/></svg>");
  check_failure(here.run("offset triangle.svg --distance -1e-20 --pocket -o off.dxf"), 2,
                "phrame: pocket: something is left at more than 10000 multiples of "
                "-1/100000000000000000000\n");
  check_failure(
      here.run("offset rooms.json --distance -1e-9 --pocket"), 2,
      "phrame: pocket: something is left at more than 10000 multiples of -1/1000000000\n");
  check_failure(here.run("offset rooms.json --distance -1,-2 --pocket"), 2,
                "phrame: --pocket: one distance is wanted, of which the others are multiples\n");
}

TEST_CASE("offset: as SVG, cubics that are read again, within 10^-6 of it") {
  const Workshop here;
  here.write("turn.json", turn);
  check_success(here.run("offset turn.json --distance 1/2 -o off.svg"));
  const NamedPath back = read_any_path(bytes_of(here.file("off.svg")));
  CHECK(back.path.segments().size() >= 2);
  // Of each point the foot t of the perpendicular on r = (t - t^3/3, t^2), at the distance 1/2.
  for (const Segment& segment : back.path.segments())
    for (const double s : {0.0, 0.3, 0.7, 1.0}) {
      const Vector<Rational> at = point(*rational_curve(segment), Rational(long(s * 10), 10));
      const auto x = static_cast<double>(at[0]);
      const auto y = static_cast<double>(at[1]);
      double t = x;
      for (int steps = 0; steps < 50; ++steps)
        t += ((x - t + t * t * t / 3) * (1 - t * t) + (y - t * t) * 2 * t) /
             ((1 + t * t) * (1 + t * t) * 1.5);
      CHECK(std::abs(std::hypot(x - t + t * t * t / 3, y - t * t) - 0.5) < 5e-7);
      CHECK(t > -1e-6);
      CHECK(t < 1 + 1e-6);
    }
  here.write("triangle.json", R"({"phrame": "spline/1", "name": "a<b", "segments": [
      {"control_points": [[0, 0, 0], [4, 0, 0]]}, {"control_points": [[4, 0, 0], [4, 3, 0]]},
      {"control_points": [[4, 3, 0], [0, 0, 0]]}]})");
  check_success(here.run("offset triangle.json --distance -1/2,-1/3 --trim -o in.svg"));
  CHECK(contains(bytes_of(here.file("in.svg")), "<title>a&lt;b</title>"));
  CHECK(contains(here.run("info in.svg --pick offset-2").out, "closed"));
}

TEST_CASE("offset: as G-code, lines within --tol, and G0 from part to part") {
  const Workshop here;
  here.write("turn.json", turn);
  const auto lines = [&](const std::string& file) {
    std::vector<std::string> list;
    std::istringstream text(bytes_of(here.file(file)));
    for (std::string line; std::getline(text, line);) list.push_back(line);
    return list;
  };
  // Its points and middles of lines, without the reader: r = (t - t^3/3, t^2), n = (2t, t^2 - 1)/s.
  for (const double tolerance : {1e-3, 1e-5}) {
    CAPTURE(tolerance);
    check_success(
        here.run(fmt::format("offset turn.json --distance 1/2 -o off.nc --tol {}", tolerance)));
    std::vector<std::array<double, 2>> points;
    for (const std::string& line : lines("off.nc"))
      if (const std::size_t at = line.find(" X"); at != std::string::npos)
        points.push_back(
            {std::stod(line.substr(at + 2)), std::stod(line.substr(line.find('Y') + 1))});
    double most = 0;
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
      const double x = (points[k][0] + points[k + 1][0]) / 2;
      const double y = (points[k][1] + points[k + 1][1]) / 2;
      double t = x;
      for (int steps = 0; steps < 50; ++steps)
        t += ((x - t + t * t * t / 3) * (1 - t * t) + (y - t * t) * 2 * t) /
             ((1 + t * t) * (1 + t * t) * 1.5);
      most = std::max(most, std::abs(std::hypot(x - t + t * t * t / 3, y - t * t) - 0.5));
    }
    CHECK(most < tolerance);
    CHECK(most > tolerance / 2);  // no more lines than are of use
    CHECK(std::hypot(points.front()[0], points.front()[1] + 0.5) < tolerance / 4);
    CHECK(std::hypot(points.back()[0] - 7.0 / 6, points.back()[1] - 1) < tolerance / 4);
    check_success(here.run(
        fmt::format("offset turn.json --distance 1/2 --check off.nc --tol {}", tolerance)));
  }
  // Triangles in a triangle of sides 3, 4, 5, whose inner circle has the radius 1.
  here.write("triangle.json", R"({"phrame": "spline/1", "segments": [
      {"control_points": [[0, 0, 0], [4, 0, 0]]}, {"control_points": [[4, 0, 0], [4, 3, 0]]},
      {"control_points": [[4, 3, 0], [0, 0, 0]]}]})");
  check_success(here.run("offset triangle.json --distance -1/2 --pocket -o in.ngc --tol 0.1"));
  const std::vector<std::string> pocket{
      "N1 G90", "N2 G0 X1.50 Y0.50", "N3 G1 X3.50 Y0.50", "N4 G1 X3.50 Y2.00", "N5 G1 X1.50 Y0.50",
      "N6 M30"};
  std::vector<std::string> blocks;
  for (const std::string& line : lines("in.ngc"))
    if (line.starts_with("N")) blocks.push_back(line);
  CHECK(blocks == pocket);
  CHECK(contains(bytes_of(here.file("in.ngc")), "(phrame: lines within 1.0e-1 of the offset)"));
  // Two paths, as it turns back at a joint, of which the second begins where the first ends.
  here.write("arc.json", R"({"phrame": "spline/1", "segments": [
      {"control_points": [[1, 0, 0], [1, 1, 0], [0, 1, 0]], "weights": [1, 1, 2]},
      {"control_points": [[0, 1, 0], [-3, 1, 0]]}]})");
  check_success(here.run("offset arc.json --distance -2 -o turns.tap"));
  const std::string turns = bytes_of(here.file("turns.tap"));
  CHECK(turns.find(" G0 X") == turns.rfind(" G0 X"));
  CHECK(contains(turns, " G1 X-3.0000 Y-1.0000\n"));
  check_failure(here.run("offset arc.json --distance -2 -o far.nc --tol 1e-12"), 2,
                "phrame: --tol: 1.0e-12 is less than 1e-8 of the size of a path\n");
  check_failure(here.run("offset arc.json --distance -2 -o far.svg --tol 1e-3"), 2,
                "phrame: --tol: needs G-code, as of -o FILE.nc\n");
  CHECK_FALSE(std::filesystem::exists(here.file("far.nc")));
}

namespace {

/// What a page has between two texts.
std::string between(const std::string& page, const std::string& before, const std::string& behind) {
  const std::size_t start = page.find(before) + before.size();
  return page.substr(start, page.find(behind, start) - start);
}

std::ptrdiff_t count_of(const std::string& page, const std::string& what) {
  std::ptrdiff_t count = 0;
  for (std::size_t at = page.find(what); at != std::string::npos; at = page.find(what, at + 1))
    ++count;
  return count;
}

Json layers_of(const std::string& page) {
  return Json::parse(between(page, "id=\"data\">", "</script>"));
}

double number(const Json& json) {
  if (json.is_number()) return json.get<double>();
  std::string text = json.get<std::string>();
  if (text.starts_with("−")) text = "-" + text.substr(std::string("−").size());
  return std::stod(text);
}

}  // namespace

TEST_CASE("offset: as a page, with marks, points along it, measures and the report") {
  const Workshop here;
  here.write("turn.json", turn);
  const Run run = here.run("offset turn.json --distance -1,1/2 -o off.html");
  check_success(run);
  const std::string page = bytes_of(here.file("off.html"));
  for (const char* other : {"http://", "https://", "src=", "href", "url(", "import", "fetch"})
    CHECK_MESSAGE(!contains(page, other), other);
  CHECK(contains(page, "default-src 'none'"));
  CHECK(between(page, "<pre id=\"report\">", "</pre>") == run.out);
  // The cusp is at t = √(√2 − 1), in (t − t³/3 − 2t/(1 + t²), t² + (1 − t²)/(1 + t²)).
  CHECK(count_of(page, "class=\"mark\"") == 1);
  CHECK(count_of(page, "<circle r=\"5\"/>") == 1);
  CHECK(contains(page, "<title>d = −1, cusp: t = 0.643594252905…, (−0.35544"));
  CHECK(contains(page, "<td>1/2</td><td>all of it</td><td>4/3 + π/4 ≈ 2.1187314967307816</td>"));
  const Json layers = layers_of(page);
  REQUIRE(layers.size() == 2);
  CHECK(layers[0]["label"] == "d = −1");
  std::optional<double> scale;
  for (const Json& layer : layers) {
    const double d = layer["label"] == "d = −1" ? -1 : 0.5;
    CHECK(layer["samples"].size() == 201);
    for (const Json& sample : layer["samples"]) {
      const double t = static_cast<double>(parse_rational(sample[0].get<std::string>()));
      const double s = 1 + t * t;
      CHECK(std::abs(number(sample[1]) - (t - t * t * t / 3 + d * 2 * t / s)) < 1e-11);
      CHECK(std::abs(number(sample[2]) - (t * t + d * (t * t - 1) / s)) < 1e-11);
      // Drawn from the point of the path on, y upwards.
      if (!scale) scale = std::abs(number(sample[4]) - number(sample[6]));
      CHECK(number(sample[3]) - number(sample[5]) == doctest::Approx(*scale * d * 2 * t / s));
      CHECK(number(sample[6]) - number(sample[4]) ==
            doctest::Approx(*scale * d * (t * t - 1) / s).epsilon(1e-4));
    }
  }
  here.write("two.json", R"({"phrame": "curve/1", "basis": "bernstein", "preimage":
      {"u": [-4, 6, -6], "v": [0, 0, 0], "p": [0, 0, 0], "q": [1, "15/14", -6]}})");
  check_success(here.run("offset two.json --distance 33/25 -o two.html"));
  const std::string two = bytes_of(here.file("two.html"));
  CHECK(count_of(two, "<circle r=\"5\"/>") == 2);
  CHECK(count_of(two, "meets itself: t = ") == 3);
  CHECK(count_of(two, "touches itself") == 0);
  here.write("mirrored.json", R"({"phrame": "curve/1", "basis": "power", "preimage":
      {"u": ["1/2"], "v": [0], "p": [0], "q": [-1, 2]}})");
  check_success(here.run("offset mirrored.json --distance=-1/24 -o mirrored.html"));
  const std::string touching = bytes_of(here.file("mirrored.html"));
  CHECK(count_of(touching, "touches itself: t = 0.25000000000000000 and t = 0.75000000000000000") ==
        1);
  CHECK(count_of(touching, "meets itself: ") == 0);
}

TEST_CASE("offset: as a page, trimmed: what is left, what is cut away, and cuts") {
  const Workshop here;
  here.write("triangle.json", R"({"phrame": "spline/1", "name": "a<b", "segments": [
      {"control_points": [[0, 0, 0], [4, 0, 0]]}, {"control_points": [[4, 0, 0], [4, 3, 0]]},
      {"control_points": [[4, 3, 0], [0, 0, 0]]}]})");
  check_success(here.run("offset triangle.json --distance -1/2,-3 --trim -o in.html"));
  const std::string page = bytes_of(here.file("in.html"));
  CHECK(contains(page, "<title>a&lt;b</title>"));
  CHECK(count_of(page, "<rect x=") == 3);
  CHECK(contains(page, "d = −1/2, cut: t = 7/8 and t = 7/6, (3.5"));
  CHECK(count_of(page, "class=\"offset layer-0\"") == 1);
  CHECK(count_of(page, "class=\"whole layer-0\"") == 3);
  CHECK(count_of(page, "class=\"offset layer-1\"") == 0);
  CHECK(contains(page, "<td>−1/2</td><td>branch 1</td><td>6</td><td>3/2</td>"));
  CHECK(contains(page, "<td>−3</td><td>nothing is left</td>"));
  const Json layers = layers_of(page);
  REQUIRE(layers.size() == 2);
  CHECK(layers[1]["samples"].empty());
  // A triangle half as large, 1/2 from all sides, at t from 3/8 to 7/8, 7/6 to 5/3, 11/5 to 27/10.
  std::size_t left = 0;
  for (long k = 0; k <= 300; ++k)
    left += (k > 37 && k < 88) || (k > 116 && k < 167) || (k > 220 && k < 270) ? 1 : 0;
  CHECK(layers[0]["samples"].size() == left);
  for (const Json& sample : layers[0]["samples"]) {
    const double x = number(sample[1]), y = number(sample[2]);
    CHECK(std::min({y, 4 - x, (3 * x - 4 * y) / 5}) == doctest::Approx(0.5));
  }
}

TEST_CASE("offset: a page tells of points on joins") {
  const Workshop here;
  here.write("triangle.json", R"({"phrame": "spline/1", "segments": [
      {"control_points": [[0, 0, 0], [4, 0, 0]]}, {"control_points": [[4, 0, 0], [4, 3, 0]]},
      {"control_points": [[4, 3, 0], [0, 0, 0]]}]})");
  const std::array<std::array<double, 2>, 3> corners{{{4, 0}, {4, 3}, {0, 0}}};
  for (const char* options : {"", " --trim", " --trim --join mitre", " --trim --join open"}) {
    CAPTURE(options);
    check_success(
        here.run("offset triangle.json --distance 1/2 -o out.html" + std::string(options)));
    const Json layers = layers_of(bytes_of(here.file("out.html")));
    std::size_t on_joins = 0;
    for (const Json& sample : layers[0]["samples"]) {
      if (sample.size() == 7) continue;
      ++on_joins;
      const auto k = static_cast<std::size_t>(std::stol(sample[0].get<std::string>()) - 1);
      const double x = number(sample[1]) - corners[k][0];
      const double y = number(sample[2]) - corners[k][1];
      if (contains(options, "mitre"))
        CHECK(std::hypot(x, y) > 0.5 - 1e-9);
      else
        CHECK(std::hypot(x, y) == doctest::Approx(0.5));
    }
    // Of the arcs at the acute angles there are two each. Ends that are joints are left out where
    // it is trimmed.
    CHECK((on_joins > 300) == !contains(options, "open"));
    if (contains(options, "open")) CHECK(on_joins == 0);
  }
}

TEST_CASE("offset: drawn where distances are far apart, each within a share of its size") {
  const Workshop here;
  here.write("turn.json", turn);
  check_success(here.run("offset turn.json --distance 1,1e60,-1e-60 -o far.svg"));
  const std::string svg = bytes_of(here.file("far.svg"));
  CHECK(contains(svg, "cubics within 1.0e-10 to 1.0e51 of it"));
  CHECK(svg.size() < 200'000);
  check_success(here.run("offset turn.json --distance 1,1e60,-1e-60 -o far.html"));
  CHECK(contains(bytes_of(here.file("far.html")), "within 1.0e-10 to 1.0e51 of the exact curves"));
  // Next to each other they are as they were: 10^-6 of the least distance.
  check_success(here.run("offset turn.json --distance 1,1/2 -o near.svg"));
  CHECK(contains(bytes_of(here.file("near.svg")), "cubics within 5.0e-7 of it"));
}

TEST_CASE("offset --check: what somebody else has is judged from both sides, with proof") {
  const Workshop here;
  here.write("turn.json", turn);
  // r = (t - t³/3, t²) with n = (2t, t² - 1)/(1 + t²): points of the offset, off by e, in doubles.
  const auto write = [&](const std::string& file, double d, double from, double to) {
    std::string table = "x,y\n";
    for (int k = 0; k <= 400; ++k) {
      const double t = k / 400.0;
      if (t > from && t < to) continue;
      const double s = 1 + t * t;
      table +=
          fmt::format("{},{}\n", t - t * t * t / 3 + d * 2 * t / s, t * t + d * (t * t - 1) / s);
    }
    here.write(file, table);
  };
  const auto check = [&](const std::string& options) {
    const Run run = here.run("offset turn.json --print json --check " + options);
    CHECK(run.status == (contains(run.out, "\"passes\": true") ? 0 : 1));
    return Json::parse(run.out);
  };
  const auto number = [](const Json& json) { return std::stod(json.get<std::string>()); };
  // Chords are at most 2·10⁻⁶ from an arc.
  write("off.csv", 0.5 + 1e-4, 2, 2);
  const Json off = check("off.csv --distance 1/2 --tol 1e-3");
  CHECK(off["passes"] == true);
  for (const char* side : {"missing", "excess"}) {
    CHECK(number(off[side]["at_least"]) <= 1.001e-4);
    CHECK(number(off[side]["at_most"]) >= 0.98e-4);
    CHECK(number(off[side]["at_most"]) < 1.1e-4);
    CHECK(off[side]["count"] == 0);
  }
  CHECK(check("off.csv --distance 1/2 --tol 9e-5")["decided"] == true);
  // A tolerance beyond all that there is does not make the search coarse, nor endless.
  CHECK(check("off.csv --distance 1/2 --tol 1e400")["passes"] == true);
  // The part from 0.3 to 0.6 has a chord in its place.
  write("gap.csv", 0.5, 0.3, 0.6);
  const Json gap = check("gap.csv --distance 1/2 --tol 1e-5");
  CHECK(gap["passes"] == false);
  for (const char* side : {"missing", "excess"}) REQUIRE(gap[side]["stretches"].size() == 1);
  const Json missing = gap["missing"]["stretches"][0];
  CHECK(missing["proved"] == true);
  CHECK(std::abs(number(missing["from"]["t"]) - 0.3) < 0.01);
  CHECK(std::abs(number(missing["to"]["t"]) - 0.6) < 0.01);
  CHECK(gap["excess"]["stretches"][0]["farthest"]["t"].get<std::string>().starts_with("120."));
  // To the left there is a cusp at √(√2 - 1), and no trimmed offset before it.
  write("left.csv", -1, 2, 2);
  CHECK(check("left.csv --distance -1 --tol 1e-5")["passes"] == true);
  const Json left = check("left.csv --distance -1 --trim --tol 1e-5");
  CHECK(left["passes"] == false);
  CHECK(left["missing"]["count"] == 0);
  CHECK(number(left["excess"]["stretches"][0]["from"]["t"]) == 0);
  // What it writes itself, by cubics, and by curves a line each.
  check_success(here.run("offset turn.json --distance -1 -o own.svg"));
  CHECK(check("own.svg --distance -1")["passes"] == true);
  CHECK(check("own.svg --distance -1 --tol 1e-7")["passes"] == false);
  check_success(here.run("offset turn.json --distance -1 -o own.jsonl"));
  CHECK(check("own.jsonl --distance -1 --tol 1e-9")["passes"] == true);
  // A polygon around a triangle, whose last side is not said.
  here.write("triangle.json", R"({"phrame": "spline/1", "segments": [
      {"control_points": [[0, 0, 0], [4, 0, 0]]}, {"control_points": [[4, 0, 0], [4, 3, 0]]},
      {"control_points": [[4, 3, 0], [0, 0, 0]]}]})");
  here.write("inside.csv", "x,y\n1.5,0.5\n3.5,0.5\n3.5,2\n");
  const Run inside = here.run("offset triangle.json --distance -1/2 --trim --check inside.csv");
  check_success(inside);
  CHECK(contains(inside.out, "closed, as the offset is: 1"));
  check_failure(here.run("offset triangle.json --distance -3 --trim --check inside.csv"), 3,
                "phrame: offset: nothing is left of the trimmed offset to check against\n");
  check_failure(here.run("offset turn.json --distance 1,2 --check off.csv"), 2,
                "phrame: --check: one distance is wanted");
  check_failure(here.run("offset turn.json --distance 1 --check none.csv"), 2, "phrame: none.csv");
  here.write("twice.csv", "x,y\n0,-1\n0,-1\n1,1\n");
  check_failure(here.run("offset turn.json --distance 1 --check twice.csv"), 2,
                "phrame: twice.csv:line 3: the point");
  CHECK(here.run("offset turn.json --distance 1 --check twice.csv --skip-invalid").status == 1);
  here.write("far.csv", "x,y\n0,-1\n1e400,1\n");
  check_failure(here.run("offset turn.json --distance 1 --check far.csv"), 3,
                "phrame: greatest_gap: a coordinate is beyond the range of doubles\n");
}

TEST_CASE("offset: of a parabola both sides are one curve, which other commands read") {
  const Workshop here;
  here.write("parabola.json", R"({"phrame": "curve/1", "control_points": [[0, 0, 0], ["1/2", 0, 0],
      [1, 1, 0]]})");
  // W = 256(s² + 16)s² of Lü's form, at s = −4m.
  const Run text = here.run("offset parabola.json --distance 1/3");
  check_success(text);
  CHECK(contains(text.out, "m⁴ + m²\n"));
  CHECK(contains(here.run("offset parabola.json --distance 1/3 --print latex").out, "m^{4}"));
  const Run json = here.run("offset parabola.json --distance -1 --print json -o both.jsonl");
  check_success(json);
  const Json both = Json::parse(json.out)["both"][0];
  CHECK(both["weight"] == Json({"0", "0", "1", "0", "1"}));
  CHECK(both["paths"].size() == 2);
  // To the left first, from (0, 1) to (1, 1) + (−2, 1)/√5.
  const std::string lines = bytes_of(here.file("both.jsonl"));
  const NamedPath left = read_any_path(lines.substr(0, lines.find('\n')));
  const auto at = [&](long t) { return point(*rational_curve(left.path.segments().front()), t); };
  CHECK(std::abs(static_cast<double>(at(0)[1]) - 1) < 1e-15);
  CHECK(std::abs(static_cast<double>(at(1)[0]) - (1 - 2 / std::sqrt(5.0))) < 1e-15);
  check_success(here.run("offset parabola.json --distance 1 -o both.svg"));
  check_success(here.run("offset parabola.json --distance 1 -o both.dxf"));
  CHECK(contains(here.run("info parabola.json").out, "rational for both sides together, by t ="));
  here.write("cubic.json", R"({"phrame": "curve/1", "control_points": [[0, 0, 0], [1, 2, 0],
      [3, 0, 0], [1, 1, 0]]})");
  CHECK(contains(here.run("info cubic.json").out, "not rational: x′² + y′² has 4 simple roots"));
  check_failure(here.run("offset cubic.json --distance 1 -o off.json"), 2, "phrame: cubic.json");
  here.write("turn.json", turn);
  CHECK(Json::parse(here.run("info turn.json --print json").out)["offset"]["kind"] == "each-side");
}

TEST_CASE("offset --gauge: an ellipse, by its file or as SVG, and the unit circle as without it") {
  const Workshop here;
  here.write("turn.json", turn);
  here.write("corner.json", corner);
  here.write("circle.json", R"({"phrame": "curve/1", "basis": "power",
      "position": {"x": [1, 0, -1], "y": [0, 2], "w": [1, 0, 1]}})");
  here.write("ellipse.svg", R"(<svg><ellipse rx="3" ry="2"/></svg>)");
  for (const char* curve : {"turn.json", "corner.json"}) {
    const auto paths = [&](const std::string& options) {
      const Run run = here.run(std::string("offset ") + curve + " --distance -1,1/3 --print curve" +
                               " --join mitre" + options);
      check_success(run);
      CHECK(run.err.empty());
      return run.out;
    };
    CHECK(paths("") == paths(" --gauge circle.json"));
  }
  // (3(t - t³/3), 2t²) is the image of turn.json, of which the cusp at -1 is at √(√2 - 1).
  here.write("wide.json", R"({"phrame": "curve/1", "basis": "power",
      "position": {"x": [0, 3, 0, -1], "y": [0, 0, 2]}})");
  const Run text = here.run("offset wide.json --distance -1 --gauge ellipse.svg");
  check_success(text);
  CHECK(contains(text.out, "closed convex rational curve of degree 2"));
  CHECK(contains(text.out, "0.643594252905…, where it turns back"));
  const Run json = here.run("offset wide.json --distance 1 --gauge ellipse.svg --print json");
  check_success(json);
  const Json answer = Json::parse(json.out);
  CHECK(answer["without"].empty());
  // Of t = 0, where U = (0, -2).
  CHECK(answer["offsets"][0]["paths"][0]["control_points"][0] == Json({"0", "-2", "0"}));
  CHECK(contains(here.run("offset wide.json --distance 1 --gauge ellipse.svg --print latex").out,
                 "\\varphi"));
  check_failure(
      here.run("offset turn.json --distance 1 --gauge ellipse.svg -o off.json"), 3,
      "phrame: offset: the path has no rational offset under this gauge: the irreducible "
      "factors of r' x U' are of degree 2 in phi, and the discriminant of one has 4 simple "
      "roots, so that both sides together are not rational, either\n");
  here.write("slant.json", R"({"phrame": "spline/1", "segments": [
      {"control_points": [[0, 0, 0], [1, 0, 0]]}, {"control_points": [[1, 0, 0], [2, 1, 0]]}]})");
  const Run slant = here.run("offset slant.json --distance 1 --gauge ellipse.svg");
  CHECK(slant.status == 1);
  // 1/√(3² + 2²) is in U.
  CHECK(contains(slant.out,
                 "of segment 2: the irreducible factors of r′ × U′ are of degree 2 in φ; rational "
                 "to each side, over ℚ(√13)"));
  here.write("line.svg", "<svg><path d='M0,0 L1,1'/></svg>");
  check_failure(here.run("offset line.svg --distance 1"), 3,
                "phrame: offset: the offset is rational over ℚ(√2), not over ℚ\n");
  check_failure(here.run("offset line.svg --distance 1 --gauge ellipse.svg"), 3,
                "phrame: offset: the path has no rational offset under this gauge: the irreducible "
                "factors of r' x U' are of degree 2 in phi; it is rational to each side over "
                "ℚ(√13)\n");
  CHECK_FALSE(std::filesystem::exists(here.file("off.json")));
}

TEST_CASE("offset --gauge --trim: a rectangle under an ellipse is a smaller rectangle inside") {
  const Workshop here;
  here.write("ellipse.json", R"({"phrame": "curve/1", "basis": "power",
      "position": {"x": [3, 0, -3], "y": [0, 4], "w": [1, 0, 1]}})");
  here.write("box.svg", R"(<svg><path d="M0,0 L4,0 L4,2 L0,2 Z"/></svg>)");
  const Run run =
      here.run("offset box.svg --distance -1/4 --trim --gauge ellipse.json --print json");
  REQUIRE(run.status == 0);
  const auto branches = nlohmann::json::parse(run.out)["trimmed"][0]["branches"];
  REQUIRE(branches.size() == 1);
  // By 3/4 to the sides and by 1/2 up and down: 5/2 times 1.
  CHECK(branches[0]["length"]["exact"] == "7");
  CHECK(branches[0]["area"]["exact"] == "5/2");
}

TEST_CASE("offset --gauge --pocket: rectangles under an ellipse, until nothing is left") {
  const Workshop here;
  here.write("ellipse.json", R"({"phrame": "curve/1", "basis": "power",
      "position": {"x": [3, 0, -3], "y": [0, 4], "w": [1, 0, 1]}})");
  here.write("box.svg", R"(<svg><path d="M0,0 L4,0 L4,2 L0,2 Z"/></svg>)");
  const Run run =
      here.run("offset box.svg --distance -1/7 --pocket --gauge ellipse.json --print json");
  check_success(run);
  const Json found = Json::parse(run.out)["trimmed"];
  REQUIRE(found.size() == 3);
  for (long k = 1; k <= 3; ++k) {  // by 3/7 to the sides, and by 2/7 up and down
    const Json& level = found[static_cast<std::size_t>(k - 1)];
    const Rational a = 4 - Rational(6 * k, 7);
    const Rational b = 2 - Rational(4 * k, 7);
    REQUIRE(level["branches"].size() == 1);
    CHECK(level["distance"] == to_string(Rational(-k, 7)));
    CHECK(level["branches"][0]["area"]["exact"] == to_string(Rational(a * b)));
    CHECK(level["branches"][0]["length"]["exact"] == to_string(Rational(2 * (a + b))));
  }
  check_failure(here.run("offset box.svg --distance 1/7 --pocket --gauge ellipse.json"), 2,
                "phrame: pocket: the distance 1/7 is to the outside of the path\n");
  here.write("corner.json", corner);
  check_failure(here.run("offset corner.json --distance 1/7 --pocket --gauge ellipse.json"), 2,
                "phrame: pocket: the path is open\n");
}

TEST_CASE("offset --gauge: of a parabola both sides are one rational curve") {
  const Workshop here;
  here.write("ellipse.svg", R"(<svg><ellipse rx="3" ry="2"/></svg>)");
  here.write(
      "parabola.json",
      R"({"phrame": "curve/1", "basis": "power", "position": {"x": [0, 1], "y": [0, 0, 1]}})");
  const Run run = here.run(
      "offset parabola.json --distance 1/2,-1/2 --gauge ellipse.svg --print json -o both.html");
  check_success(run);
  const Json answer = Json::parse(run.out);
  CHECK(answer["without"].empty());
  REQUIRE(answer["both"].size() == 2);
  // U is (9·2t, −4·1)/√(9·4t² + 4) to the right of (1, 2t).
  const Json layers = layers_of(bytes_of(here.file("both.html")));
  for (const std::size_t layer : {0U, 1U}) {
    const double d = layer == 0 ? 0.5 : -0.5;
    const Json& samples = layers[layer]["samples"];
    REQUIRE(samples.size() == 2 * 199);
    for (std::size_t k = 0; k < samples.size(); ++k) {
      const auto t = static_cast<double>(parse_rational(samples[k][0].get<std::string>()));
      const double e = (k < 199 ? d : -d) / std::sqrt(36 * t * t + 4);
      CHECK(std::abs(number(samples[k][1]) - (t + e * 18 * t)) < 1e-11);
      CHECK(std::abs(number(samples[k][2]) - (t * t - e * 4)) < 1e-11);
    }
  }
}

TEST_CASE("offset --gauge: what is no gauge, or does not go with one, is refused in one line") {
  const Workshop here;
  here.write("turn.json", turn);
  const auto refuse = [&](const std::string& position, const std::string& reason) {
    here.write("gauge.json",
               R"({"phrame": "curve/1", "basis": "power", "position": )" + position + "}");
    check_failure(here.run("offset turn.json --distance 1 --gauge gauge.json -o off.json"), 2,
                  "phrame: gauge.json: gauge: it is not " + reason);
  };
  refuse(R"({"x": [0, 1], "y": [0, 0, 1]})", "closed: it goes to infinity at phi = infinity\n");
  refuse(R"({"x": [2], "y": [0, 2], "w": [1, 0, 1]})", "symmetric about (0, 0)");
  refuse(R"({"x": [2, 0, 0, 0, -2], "y": [0, 4, 0, 4], "w": [3, 0, -2, 0, 3]})",
         "strictly convex: U' x U'' = 0 at phi");
  here.write("circle.json", R"({"phrame": "curve/1", "basis": "power",
      "position": {"x": [1, 0, -1], "y": [0, 2], "w": [1, 0, 1]}})");
  check_failure(
      here.run("offset turn.json --distance 1 --gauge circle.json -o off.json --check turn.json"),
      2, "phrame: --");
  check_failure(here.run("offset turn.json --distance 0 --gauge circle.json -o off.json"), 2,
                "phrame: --distance: 0 is no distance\n");
  check_failure(
      here.run("offset quintic.json --distance 1 --gauge circle.json -o off.json"), 2,
      "phrame: quintic.json: under a gauge the path is of rational curves in a plane z = const\n");
  CHECK_FALSE(std::filesystem::exists(here.file("off.json")));
}

// Steiner: outwards A + L·d + π·d² and L + 2π·d, and with it the corners' arcs.
TEST_CASE("offset --near: of a drawing, by a PH path in its place") {
  const Workshop here;
  here.write("triangle.svg", "M0,0 L3,0 L0,2 Z");
  const auto found = here.run("offset triangle.svg --distance 1/2 --near 1e-9 --trim --print json");
  CHECK(found.status == 0);
  CHECK(found.err.starts_with("phrame: triangle.svg: in its place a PH spline of 3 segments, at "));
  const auto branch = nlohmann::json::parse(found.out)["trimmed"][0]["branches"][0];
  const auto number = [&](const char* key) {
    return std::stod(branch[key]["value"].get<std::string>());
  };
  const double perimeter = 5 + std::sqrt(13);
  CHECK(std::abs(number("length") - (perimeter + std::numbers::pi)) < 1e-8);
  CHECK(std::abs(number("area") - (3 + perimeter / 2 + std::numbers::pi / 4)) < 1e-8);
  here.write("points.csv", "x,y\n0,0\n1,1\n2,0\n");
  CHECK(here.run("offset points.csv --kind polyline --distance 1/2 --near 1e-9").status == 0);
  check_failure(
      here.run("offset triangle.svg --distance 1/2 -o off.json"), 2,
      "phrame: triangle.svg: segment 2 is not PH: its offset is rational over ℚ(√13), not over ℚ; "
      "with --near EPS that of a PH path at most EPS away is taken\n");
  check_failure(here.run("offset triangle.svg --distance 1/2 --near 1e-40 -o off.json"), 4,
                "phrame: undecided: segment 2: no PH curves were found that are near enough\n");
  CHECK_FALSE(std::filesystem::exists(here.file("off.json")));
}

TEST_CASE("offset: of an arc, a point at one of two distances") {
  const Workshop here;
  here.write("arc.json",
             R"({"phrame": "curve/1", "control_points": [[1, 0, 0], [1, 1, 0], [0, 1, 0]],
      "weights": [1, 1, 2]})");
  const Run run = here.run("offset arc.json --distance -1,1/2 -o off.json");
  CHECK(run.status == 1);
  CHECK(contains(
      run.out,
      "−1, to the left of travel\n  exact                 none: nothing but points is left\n\n"));
  CHECK(contains(run.out, "length                3π/4 ≈ 2.3561944901923449"));
  CHECK(contains(here.run("info off.json").out, "rational PH curve of degree 2"));
  const Json json = Json::parse(here.run("offset arc.json --distance -1,1/2 --print json").out);
  CHECK(json["offsets"][0]["paths"].empty());
  CHECK(json["offsets"][1]["paths"].size() == 1);
  check_failure(here.run("offset arc.json --distance -1"), 3,
                "phrame: offset: at the distance -1 nothing but points is left\n");
}

TEST_CASE("offset: numbers that would be too long to be read again are not written") {
  const Workshop here;
  here.write("turn.json", turn);
  check_success(here.run("offset turn.json --distance 1e-2000 -o off.json"));
  check_success(here.run("info off.json"));
  const std::string reason = " bits, of which phrame reads no more than 20000\n";
  check_failure(here.run("offset turn.json --distance 1e-5900 -o far.json"), 2, reason);
  check_failure(here.run("offset turn.json --distance 1e-5900 --print curve"), 2, reason);
  CHECK_FALSE(std::filesystem::exists(here.file("far.json")));
}

TEST_CASE("offset: what cannot be is refused in one line, and nothing is written") {
  const Workshop here;
  here.write("turn.json", turn);
  here.write("bezier.json", R"({"control_points": [[0, 0, 0], [1, 2, 0], [3, 0, 0]]})");
  check_failure(here.run("offset turn.json --distance 0 -o off.json"), 2,
                "phrame: --distance: 0 is no distance\n");
  check_failure(here.run("offset turn.json --distance 1,x -o off.json"), 2, "phrame: --distance: ");
  here.write("space.json",
             R"({"phrame": "curve/1", "control_points": [[0, 0, 0], [1, 2, 1], [3, 0, 0]]})");
  here.write("path.json", R"({"phrame": "spline/1", "segments": [
      {"control_points": [[0, 0, 0], [1, 0, 0]]}, {"control_points": [[1, 0, 0], [1, 0, 1]]}]})");
  for (const char* more : {"", " --trim", " --pocket", " --near 1e-3", " --check turn.json"}) {
    const auto refused = [&](const std::string& file, const std::string& what) {
      check_failure(here.run("offset " + file + " --distance 1 -o off.json" + more), 2,
                    "phrame: " + file + ": " + what + " is in no plane z = const\n");
    };
    refused("quintic.json", "the curve");
    refused("path.json", "segment 2");
    if (std::string(more) != " --check turn.json") refused("space.json", "the curve");
  }
  check_failure(here.run("offset bezier.json --distance 1 -o off.json"), 2, "phrame: bezier.json");
  check_failure(here.run("offset turn.json"), 2, "phrame: ");
  CHECK_FALSE(std::filesystem::exists(here.file("off.json")));
}

}  // namespace offset_cli_test
