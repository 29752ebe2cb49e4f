#include "cli/workshop.hpp"

using namespace phrame;
using namespace phrame::test;

TEST_CASE("certify and verify: a certificate is proved, a changed one is not") {
  const Workshop here;
  CHECK(here.run("certify quintic.json --at 1/2,1 --digits 40 -o angle.cert").status == 0);
  const Run proved = here.run("verify angle.cert");
  check_success(proved);
  CHECK(contains(proved.out, "proved      |theta(1) - 0.28585653009834106200165626280309220136"));
  // sha256sum of the exact form, which is in docs/certificate.md.
  CHECK(proved.out.starts_with(
      "curve       quintic\nsha256      "
      "7985d7fd344538aee7e37f39529e1a938ad4fd6bef3774f7c79276f22822139f\nframe       erf\nproved"));
  CHECK(contains(proved.out, "\nproved      decision regular: yes\n"));
  CHECK(contains(proved.out, "\nproved      decision line: no\n"));
  CHECK(proved.out.ends_with("all 17 statements are proved\n"));
  std::string text = bytes_of(here.file("angle.cert"));
  text.replace(text.find("0.2858565300"), 12, "0.2858565301");
  here.write("wrong.cert", text);
  const Run wrong = here.run("verify wrong.cert");
  CHECK(wrong.status == 1);
  CHECK(wrong.err.empty());
  CHECK(contains(wrong.out, "not proved  |theta(1) - 0.2858565301"));
  CHECK(contains(wrong.out, ": theta is further off\n"));
  CHECK(wrong.out.ends_with("1 of 17 statements is not proved\n"));
}

TEST_CASE("certify: without --at it is the angle at 1; the Frenet frame has its turn") {
  const Workshop here;
  const Run erf = here.run("certify quintic.json");
  check_success(erf);
  const Json c = Json::parse(erf.out);
  CHECK(c["claims"].size() == 1);
  CHECK(c["claims"][0]["t"] == "1");
  CHECK(c["claims"][0]["theta"] == "0.28585653009834106");
  CHECK(c["claims"][0]["radius"] == "5e-18");
  CHECK(c["curve"]["name"] == "quintic");
  CHECK_FALSE(c.contains("bend"));
  const Run frenet = here.run("certify quintic.json --frame frenet");
  check_success(frenet);
  CHECK(Json::parse(frenet.out)["claims"][0]["turn"]["signs"].size() == 2);
  check_success(here.run("verify -", frenet.out));
}

TEST_CASE("verify: a long t is abridged, unless --full is given") {
  const Workshop here;
  const std::string t = "1/" + std::string(1500, '3');
  CHECK(here.run("certify quintic.json --at " + t + " -o long.cert").status == 0);
  const Run brief = here.run("verify long.cert");
  check_success(brief);
  CHECK(contains(brief.out, "proved      |theta(1/333"));
  CHECK(contains(brief.out, " (1502 characters)) - "));
  CHECK_FALSE(contains(brief.out, t));
  CHECK(brief.out.ends_with("\nLong parts are abridged (--full prints it all).\n"));
  const Run full = here.run("verify long.cert --full");
  check_success(full);
  CHECK(contains(full.out, "proved      |theta(" + t + ") - "));
  CHECK(full.out.ends_with(" statements are proved\n"));
}

TEST_CASE("verify: with --curve it must be of that curve, whatever it is called") {
  const Workshop here;
  CHECK(here.run("certify quintic.json -o angle.cert").status == 0);
  const Run same = here.run("verify angle.cert --curve quintic.json");
  check_success(same);
  CHECK(contains(same.out, "proved      curve of "));
  CHECK(same.out.ends_with("all 17 statements are proved\n"));
  const Run other = here.run("verify angle.cert --curve line.json");
  CHECK(other.status == 1);
  CHECK(contains(other.out, "not proved  curve of "));
  CHECK(contains(other.out, ": that one has sha256 "));
  CHECK(other.out.ends_with("1 of 17 statements is not proved\n"));
  Json curve = Json::parse(here.run("certify quintic.json").out)["curve"];
  curve["start"] = {"0", "0", "1"};
  here.write("moved.json", curve.dump());
  CHECK(here.run("verify angle.cert --curve moved.json").status == 1);
  check_failure(here.run("verify angle.cert --curve nowhere.json"), 2, "nowhere.json");
}

TEST_CASE("certify and verify: an arc in space and the exact offset of a PH curve") {
  const Workshop here;
  here.write("arc.json", R"({"control_points": [[1, 0, 0], [1, "3/5", "4/5"], [0, "3/5", "4/5"]],
      "phrame": "curve/1", "weights": [1, 1, 2]})");
  CHECK(here.run("certify arc.json --at 0,1/2,1 --digits 40 -o arc.cert").status == 0);
  const Run arc = here.run("verify arc.cert --curve arc.json");
  check_success(arc);
  CHECK(contains(arc.out, "\nproved      weight\n"));
  here.write("plane.json",
             R"({"phrame": "curve/1", "basis": "power", "complex": [[1, 0], [1, 3]]})");
  CHECK(here.run("offset plane.json --distance 1/9 --print curve -o offset.json").status == 0);
  CHECK(here.run("certify offset.json -o offset.cert").status == 0);
  CHECK(here.run("frames offset.json --at 1 -o frames.csv").status == 0);
  check_success(here.run("verify offset.cert --curve offset.json --table frames.csv"));
  check_failure(here.run("certify arc.json --at 2"), 3, "t = 2 is outside [0, 1]");
}

TEST_CASE("certify and verify: curves that are not PH, and lengths") {
  const Workshop here;
  here.write("cubic.json", R"({"control_points": [[0, 0, 0], [1, 3, -2], [4, 1, 5], [2, -3, 1]],
      "name": "cubic", "phrame": "curve/1"})");
  CHECK(here.run("certify cubic.json --at 1/3,1 --digits 30 -o angle.cert").status == 0);
  const Run angle = here.run("verify angle.cert --curve cubic.json");
  check_success(angle);
  CHECK(contains(angle.out, "\nframe       up ("));
  CHECK(contains(angle.out, "\nproved      pieces of segment 0\n"));
  CHECK(angle.out.ends_with("all 5 statements are proved\n"));
  CHECK(here.run("certify quintic.json --length -o length.cert").status == 0);
  const Run length = here.run("verify length.cert --curve quintic.json");
  check_success(length);
  CHECK(contains(length.out, "\nproved      |length(1) - "));
  const Run other = here.run("verify length.cert --curve cubic.json");
  CHECK(other.status == 1);
  CHECK(contains(other.out, ": that one has sha256 "));
  here.write("frames.csv", "t,x,y,z,e1x,e1y,e1z,f2x,f2y,f2z,f3x,f3y,f3z\n");
  CHECK(contains(here.run("verify angle.cert --table frames.csv").out, "it has 0 rows, and there"));
  CHECK(contains(here.run("verify length.cert --table frames.csv").out,
                 "the angles are not those to the frame of a vector"));
  check_failure(here.run("certify cubic.json --length --frame up"), 2, "--frame");
  check_failure(here.run("certify cubic.json --frame erf"), 2, "--frame: \"erf\" needs a");
}

TEST_CASE("certify and verify: bad input is refused with its place") {
  const Workshop here;
  check_failure(here.run("certify line.json --frame frenet"), 3, "straight line");
  check_failure(here.run("certify quintic.json --frame mtf"), 2, "--frame: \"mtf\" is not one of");
  here.write("spline.json", R"({"phrame": "spline/1", "segments": []})");
  check_failure(here.run("certify spline.json"), 2, "spline.json:/segments: a spline has at least");
  here.write("closed.json", bytes_of(root("/examples/curves/closed-spline.json")));
  check_failure(here.run("certify closed.json --frame frenet"), 3,
                "Frenet frame: at the joint t = 1 it jumps");
  check_failure(here.run("certify closed.json --at 9"), 3, "t = 9 is outside [0, 4]");
  check_failure(here.run("verify quintic.json"), 2,
                "quintic.json:/phrame: the format is \"certificate/1\", not \"curve/1\"");
  check_failure(here.run("verify nowhere.cert"), 2, "nowhere.cert: ");
  here.write("half.cert", here.run("certify quintic.json").out.substr(0, 1000));
  check_failure(here.run("verify half.cert"), 2, "half.cert:");
}
