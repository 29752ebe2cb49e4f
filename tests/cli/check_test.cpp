#include <nlohmann/json.hpp>

#include "cli/workshop.hpp"

using namespace phrame;
using namespace phrame::test;

TEST_CASE("check: the program's own frames pass, others are told what they are") {
  const Workshop here;
  CHECK(here.run("frames quintic.json --samples 21 -o frames.csv").status == 0);
  const Run pass = here.run("check quintic.json frames.csv --tol 1e-15");
  check_success(pass);
  CHECK(contains(pass.out, "\npass: f2 is at most "));
  const std::string table = here.run("frames quintic.json --samples 21 --frame frenet").out;
  std::string renamed = table;
  for (const auto& [from, to] : {std::pair("nx,ny,nz", "f2x,f2y,f2z"), {"bx,by,bz", "f3x,f3y,f3z"}})
    renamed.replace(renamed.find(from), 8, to);
  here.write("frenet.csv", renamed);
  const Run fail = here.run("check quintic.json frenet.csv --print json");
  CHECK(fail.status == 1);
  CHECK(fail.err.empty());
  const auto out = nlohmann::json::parse(fail.out);
  CHECK(out["phrame"] == "check/1");
  CHECK(out["verdict"] == "fail");
  CHECK(out["max_error"]["lower"] == "2.99504");
  CHECK(out["max_error"]["upper"] == "2.99505");
  CHECK(out["findings"][0]["kind"] == "frenet");
  CHECK(out["samples"].size() == 21);
  CHECK(contains(here.run("check quintic.json frenet.csv").out, "  - these are Frenet frames"));
}

TEST_CASE("check: bad input is refused with its place") {
  const Workshop here;
  here.write("bad.csv", "t,f2x,f2y,f2z\n0,1,zero,0\n");
  check_failure(here.run("check quintic.json bad.csv"), 2, "bad.csv:line 2, f2y: ");
  check_failure(here.run("check quintic.json nowhere.csv"), 2, "nowhere.csv: ");
  check_failure(here.run("check quintic.json bad.csv --tol -1"), 2, "--tol: -1 is negative");
  check_failure(here.run("check quintic.json bad.csv --tangent-axis w"), 2,
                "--tangent-axis: \"w\" is not one of x, y, z");
  check_failure(here.run("check - - < quintic.json"), 2, "check: the curve and the frames");
}
