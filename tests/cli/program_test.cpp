#include <algorithm>

#include "cli/workshop.hpp"

namespace program_test {

using namespace phrame;
using namespace phrame::test;

namespace {

Json values(const Run& run) {
  check_success(run);
  return Json::parse(run.out)["values"];
}

/// All that there are, as the program lists them.
std::vector<std::string> commands(const Workshop& here) {
  const std::string help = here.run("--help").out;
  const std::size_t begin = help.find("\nCommands:\n") + 11;
  std::istringstream list(help.substr(begin, help.find("\n\n", begin) + 1 - begin));
  std::vector<std::string> names;
  for (std::string line; std::getline(list, line);)
    names.push_back(line.substr(2, line.find(' ', 2) - 2));
  return names;
}

}  // namespace

// The quintic has the length 71/15 and turns by 0.13516216082994722857… up to t = 1/2 and by
// 0.28585653009834106200… up to t = 1 [Farouki 2003].
TEST_CASE("program: each command succeeds, on the paper's quintic or a plane cubic") {
  const Workshop here;
  here.write("batch.jsonl",
             R"({"curve": )" + bytes_of(here.file("quintic.json")) + R"(, "at": ["1/2"]})" + "\n");
  here.write("points.csv", "x,y,z\n0,0,0\n1,1,0\n2,1,1\n");
  here.write("axis.json", R"({"phrame": "mph/1", "control_points": [[0, 0, 1], [5, 0, 4]]})");
  here.write("plane.json", bytes_of(test::root("/examples/curves/plane-cubic.json")));
  CHECK(here.run("frames quintic.json --samples 5 -o frames.csv").status == 0);
  CHECK(here.run("certify quintic.json --at 1 -o certificate.json").status == 0);
  struct Case {
    const char* arguments;
    const char* expected;
  };
  const Case cases[]{{"angle quintic.json --at 0,1/2,1", "  1/2   0.13516216082994723\n"},
                     {"info quintic.json", "length ∫₀¹ |f|σ     71/15\n"},
                     {"classify quintic.json", "  regular               yes\n"},
                     {"totals quintic.json", "  length ∫ ds"},
                     {"frames quintic.json --samples 11", "\n0,0,0,0,"},
                     {"frames quintic.json --samples 5 --format glb", "glTF"},
                     {"frames quintic.json --samples 5 --format gltf", "\"animations\":["},
                     {"frames quintic.json --samples 5 --format blender", "\nimport bpy\n"},
                     {"mtf quintic.json --from 0 --to 0", "71/15"},
                     {"interpolate quintic.json --feed 1 --period 1",
                      "\n5,4.733333333333333,1,4.733333333333333,"},
                     {"interpolate quintic.json --feed 1 --period 1 --format gcode",
                      // f₃(0) = (−5, −2, 14)/15 by Rodrigues' formula, A = acos(14/15)
                      "\nN2 G0 X0.0000 Y0.0000 Z0.0000 A21.0395 C-68.1986\n"},
                     {"construct points.csv", "  points met      within "},
                     {"identify quintic.json", "f|A|²  37t⁴ − 72t³ + 46t² − 12t + 6\n"},
                     {"integrate '1/(x^2+1)'", "arctan(x)"},
                     {"sweep quintic.json --profile circle:1/10", "\nf 1 2 "},
                     {"sweep quintic.json --profile circle:1/10 --exact --end-normal 0,0,1",
                      "\ndeg 2 13\nsurf 0 1 0 1 1 2 3 "},
                     {"offset plane.json --distance 1", "4/3 + π/2"},
                     {"envelope axis.json", "line segment, degree 1"},
                     {"transform quintic.json --scale 2", "\"preimage\""},
                     {"batch batch.jsonl", "0.13516216082994723"},
                     {"compile quintic.json", "#ifndef "},
                     {"check quintic.json frames.csv", "rotation-minimizing"},
                     {"certify quintic.json --at 1", "0.2858565300983410"},
                     {"verify certificate.json", "0.2858565300983410"},
                     {"prove quintic.json --at 1", "Theorem "},
                     {"page quintic.json", "</html>\n"},
                     {"reference plane-01", "{\"phrame\": \"curve/1\""},
                     {"help angle", "Usage: phrame angle "}};
  std::vector<std::string> tried;
  for (const Case& c : cases) {
    CAPTURE(c.arguments);
    const Run run = here.run(c.arguments);
    if (has_no_pages(run)) {
      check_failure(run, 2, "page: ");
    } else {
      check_success(run);
      CAPTURE(run.out);
      CHECK(contains(run.out, c.expected));
    }
    const std::string command(c.arguments, std::string_view(c.arguments).find(' '));
    if (tried.empty() || tried.back() != command) tried.push_back(command);
  }
  CHECK(tried == commands(here));
}

TEST_CASE("program: help and version succeed, for each command") {
  const Workshop here;
  std::vector<std::string> all = commands(here);
  all.emplace_back();
  for (const std::string& command : all) {
    CAPTURE(command);
    const Run help = here.run(command + " --help");
    check_success(help);
    CHECK(contains(help.out, "Usage: phrame"));
    CHECK(contains(help.out, command.empty() ? "Exit status: 0 done" : "Example"));
    CHECK_FALSE(contains(help.out, "INT"));
    const Run version = here.run(command + " --version");
    check_success(version);
    CHECK(version.out.starts_with("phrame 0."));
    CHECK(std::count(version.out.begin(), version.out.end(), '\n') == 1);
  }
  const std::string help = here.run("--help").out;
  for (const char* example :
       {"\n  phrame angle curve.json", "\n  phrame info curve.json", "\n  phrame frames curve.json",
        "\n  phrame interpolate curve.json", "\n  phrame integrate '"})
    CHECK(contains(help, example));
  CHECK(contains(here.run("angle -h").out, "--theta0"));
}

TEST_CASE("program: what is typed wrongly is refused by name") {
  const Workshop here;
  check_failure(
      here.run(""), 2,
      "a command is needed: there are angle, info, classify, totals, frames, mtf, "
      "interpolate, construct, identify, integrate, sweep, offset, envelope, transform, batch, "
      "compile, check, certify, verify, prove, page, reference, help "
      "(phrame --help)");
  check_failure(here.run("angel quintic.json"), 2, "\"angel\" is not a command");
  check_failure(here.run("''"), 2, "\"\" is not a command");
  check_failure(here.run("--frobnicate"), 2, "--frobnicate");
  check_failure(here.run("angle quintic.json --frobnicate"), 2,
                "--frobnicate is no option of angle (phrame angle --help)");
  check_failure(here.run("angle"), 2, "CURVE is required");
  check_failure(here.run("angle quintic.json line.json"), 2, "line.json");
  check_failure(here.run("frames quintic.json"), 2, "--samples N or --at");
  check_failure(here.run("angle quintic.json --frame rmf"), 2,
                "--frame: \"rmf\" is not one of erf, frenet");
  check_failure(here.run("angle quintic.json --form best"), 2,
                "--form: \"best\" is not one of auto,");
  check_failure(here.run("angle quintic.json --print npy"), 2,
                "--print: \"npy\" is not one of text,");
  check_failure(here.run("info quintic.json --print maple"), 2, "--print: \"maple\" is not one of");
  check_failure(here.run("frames quintic.json --at 0 --format xls"), 2, "--format: \"xls\"");
  check_failure(here.run("frames quintic.json --at 0 --frame rmf,,erf"), 2, "--frame: \"\" is not");
  check_failure(here.run("frames quintic.json --by foo"), 2, "--by: \"foo\" is not one of t, ");
  check_failure(here.run("construct points.csv --kind foo"), 2, "length, minkowski\n");
  check_failure(here.run("prove quintic.json --frame up"), 2,
                "--frame: \"up\" is not one of erf, frenet\n");
  check_failure(here.run("totals quintic.json --helicity 0,0,0"), 2,
                "--helicity: the up vector is 0\n");
  for (const std::string call : {"page", "sweep --profile circle:1/9"}) {
    const Run run = here.run(call + " quintic.json --end-normal 0,0,0 -o out");
    check_failure(run, 2,
                  has_no_pages(run)
                      ? "page: "
                      : "--end-normal: the vector (0, 0, 0) has no part in the normal plane\n");
  }
  check_failure(here.run("transform quintic.json --split 1/2,1/4"), 2,
                "--split: 1/4 is not behind");
}

TEST_CASE("program: options with numbers refuse what is none or too large") {
  const Workshop here;
  for (const char* digits : {"0", "-1", "abc", "1.5", "100001", "99999999999999999999", "''"})
    check_failure(here.run(std::string("angle quintic.json --digits ") + digits), 2, "--digits");
  for (const char* samples : {"0", "1", "-5", "abc", "99999999999999999999"})
    check_failure(here.run(std::string("angle quintic.json --samples ") + samples), 2, "--samples");
  check_failure(here.run("angle quintic.json --max-degree 0"), 2, "--max-degree");
  check_failure(here.run("angle quintic.json --theta0 pie"), 2,
                "--theta0: \"pie\" is not an angle");
}

TEST_CASE("program: every value of --at must be a number, an empty one is none") {
  const Workshop here;
  check_failure(here.run("angle quintic.json --at 1/0"), 2, "--at: \"1/0\" divides by zero");
  check_failure(here.run("angle quintic.json --at ''"), 2, "--at: \"\" is not a number");
  check_failure(here.run("angle quintic.json --at 1,,2"), 2, "--at: \"\" is not a number");
  check_failure(here.run("angle quintic.json --at 1,"), 2, "--at: \"\" is not a number");
  check_failure(here.run("angle quintic.json --at ,1"), 2, "--at: \"\" is not a number");
  check_failure(here.run("angle quintic.json --at nan"), 2, "--at: \"nan\" is not a number");
  check_failure(here.run("angle quintic.json --at 1,x"), 2, "--at: \"x\" is not a number");
}

TEST_CASE("program: t may be negative, repeated, and given in pieces") {
  const Workshop here;
  const Json some =
      values(here.run("angle quintic.json --print json --at -1/2,0 --at -.5,1 --samples 3"));
  std::vector<std::string> t;
  for (const Json& value : some) t.push_back(value["t"]);
  CHECK(t == std::vector<std::string>{"-1/2", "0", "-1/2", "1", "0", "1/2", "1"});
  CHECK(some[0] == some[2]);
  CHECK(some[3] == some[6]);
  // Before the curve, too: one list does not swallow what follows.
  CHECK(values(here.run("angle --print json --at 0,1 quintic.json")).size() == 2);
}

// θ′ = 8t(1 − t)/σ: from 1 on negative, and ∫ to infinity is finite; from 0, with σ = 6 − 12t + …,
// θ = ∫(4/3)(t − t²)(1 + 2t + …) = (2/3)t² + (4/9)t³ + O(t⁴), the term in t⁴ being 10⁻⁶⁰ times
// smaller.
TEST_CASE("program: huge and tiny t are no harder") {
  const Workshop here;
  const Json some =
      values(here.run("angle quintic.json --print json --digits 50 --at 1e-30,1e30,1e31"));
  const Rational t = power_of_ten(-30);
  const Rational series = Rational(2, 3) * t * t + Rational(4, 9) * t * t * t;
  const Rational theta = test::rational(some[0]["theta"]);
  CHECK(test::digit_count(some[0]["theta"]) == 50);
  CHECK(abs(theta - series) <= test::last_place(series, 50) / 2 + 10 * t * t * t * t);
  // Beyond T, |θ′| = 8t(t − 1)/σ < 8/(37t²)·2, so that less than 1/(2T) is left.
  const Rational far = test::rational(some[1]["theta"]);
  const Rational farther = test::rational(some[2]["theta"]);
  CHECK(farther < far);
  CHECK(far - farther < t / 2);
  CHECK(far > 0);
}

TEST_CASE("program: a t beyond the limits is refused, and named") {
  const Workshop here;
  // Neither undefined nor undecided: the table cannot hold what is asked for.
  for (const std::string format : {"csv", "json", "npy"}) {
    check_failure(here.run("frames quintic.json --at 1e200 --format " + format), 2,
                  "characters): x does not fit a double, of at most 1.8e308\n");
    check_failure(here.run("frames quintic.json --at 1,1e400 --format " + format), 2,
                  "characters): t does not fit a double");
    check_failure(here.run("interpolate line.json --period 1e400 --feed 1e-400 --format " + format),
                  2, "phrame: point 1: time does not fit a double, of at most 1.8e308\n");
  }
  check_failure(here.run("frames inflected.json --frame frenet --at 0"), 3, "t = 0");
}

TEST_CASE("program: many values of t") {
  const Workshop here;
  const Run run = here.run("frames quintic.json --samples 2001");
  check_success(run);
  CHECK(std::count(run.out.begin(), run.out.end(), '\n') == 2002);
  CHECK(values(here.run("angle quintic.json --print json --samples 501")).size() == 501);
}

// θ(1) − 1/3 with θ(1) of the paper, to 50 digits.
TEST_CASE("program: --theta0 is added, exactly") {
  const Workshop here;
  const Json some =
      values(here.run("angle quintic.json --print json --theta0 -1/3 --digits 40 --at 0,1"));
  CHECK(some[0]["theta"] == "-0." + std::string(40, '3'));
  const Rational truth =
      test::rational(test::farouki_2003()["quintic"]["theta_RMF_rel_ERF"]["1"]) - Rational(1, 3);
  const Rational error = abs(test::rational(some[1]["theta"]) - truth);
  CHECK(error <= test::last_place(truth, 40) / 2 + power_of_ten(-50));
  CHECK(error <= test::rational(some[1]["radius"]) + power_of_ten(-50));
  // θ(1) = 0.28585653009834106200165…: the first 17 digits cancel.
  const Json rest = values(
      here.run("angle quintic.json --print json --theta0 -0.28585653009834106 --digits 4 --at 1"));
  CHECK(rest[0]["theta"] == "2.002e-18");
}

TEST_CASE("program: a curve is read from standard input") {
  const Workshop here;
  const std::string quintic = bytes_of(here.file("quintic.json"));
  CHECK(here.run("info -", quintic).out == here.run("info quintic.json").out);
  check_failure(here.run("info -", ""), 2, "phrame: standard input:1:1: not valid JSON");
  check_failure(here.run("info - <&-"), 2, "phrame: standard input: cannot be read");
}

TEST_CASE("program: bad curve files are refused with file, place and value") {
  const Workshop here;
  here.write("bad.json", R"({"phrame": "curve/1", "basis": "power",
                             "preimage": {"u": [1, "1/0"], "v": [0], "p": [0], "q": [0]}})");
  check_failure(here.run("angle bad.json"), 2,
                "phrame: bad.json:/preimage/u/1: \"1/0\" divides by zero");
  here.write("cut.json", bytes_of(here.file("quintic.json")).substr(0, 40));
  check_failure(here.run("angle cut.json"), 2, "phrame: cut.json:1:");
  here.write("empty.json", "");
  check_failure(here.run("angle empty.json"), 2,
                "phrame: empty.json:1:1: not valid JSON: the input is empty");
  here.write("deep.json", std::string(1'000'000, '['));
  check_failure(here.run("angle deep.json"), 2, "nested deeper than 32 levels");
  std::string ones = "1";
  for (int k = 0; k < 100'000; ++k) ones += ",1";
  here.write("long.json", R"({"phrame": "curve/1", "basis": "power", "preimage": {"u": [)" + ones +
                              R"(], "v": [0], "p": [0], "q": [0]}})");
  check_failure(here.run("angle long.json"), 2, "beyond the limit 1001; --max-degree raises it");
  check_failure(here.run("angle quintic.json --max-degree 4"), 2,
                "quintic.json:/: the curve has degree 5, the limit is 4");
}

TEST_CASE("program: files that cannot be read are refused with the reason") {
  const Workshop here;
  check_failure(here.run("angle missing.json"), 2,
                "phrame: missing.json: cannot be read: No such file or directory");
  check_failure(here.run("angle ."), 2, "phrame: .: is a directory");
  check_failure(here.run("angle ''"), 2, "phrame: \"\": cannot be read");
  check_failure(here.run("angle quintic.json/x"), 2, "cannot be read: Not a directory");
  fs::permissions(here.file("line.json"), fs::perms::none);
  if (!std::ifstream(here.file("line.json")))  // root reads everything
    check_failure(here.run("angle line.json"), 2, "line.json: cannot be read: Permission denied");
}

TEST_CASE("program: control characters in names do not reach the terminal") {
  const Workshop here;
  check_failure(here.run("angle \"$(printf 'a\\nb\\033[31m')\""), 2,
                "phrame: a\\u000ab\\u001b[31m: cannot be read");
  check_failure(here.run("angle quintic.json \"$(printf 'a\\nb')\""), 2, "\"a?b\"");
  here.write("named.json", R"({"phrame": "curve/1", "name": "x\u001b[31m\ny", "basis": "power",
                               "preimage": {"u": [1], "v": [0], "p": [0], "q": [0]}})");
  CHECK(here.run("info named.json").out.starts_with("x\\u001b[31m\\u000ay: line segment"));
}

TEST_CASE("program: what is undefined has status 3 and its reason") {
  const Workshop here;
  check_failure(here.run("angle line.json --frame frenet --at 1"), 3, "straight line");
  check_failure(here.run("frames line.json --frame frenet --at 1"), 3, "straight line");
  check_failure(here.run("frames inflected.json --frame frenet --samples 3"), 3,
                "t = 0 is an inflection");
  check_success(here.run("angle inflected.json --frame frenet --samples 3"));
  check_success(here.run("frames inflected.json --frame rmf,erf --samples 3"));
  check_success(here.run("frames inflected.json --frame frenet --at 1/2,1"));
}

// A place on the terminal is a file, an option or a notion of the manual.
TEST_CASE("batch: the lines that failed are told by their numbers in the input") {
  const Workshop here;
  std::string line = bytes_of(here.file("line.json"));
  std::replace(line.begin(), line.end(), '\n', ' ');
  const std::string good = line + "\n";
  const Run run = here.run("batch", good + "\n \n" + "{bad\n" + good + "{\"curve\": 7}");
  CHECK(run.status == 1);
  CHECK(std::count(run.out.begin(), run.out.end(), '\n') == 4);
  CHECK(contains(run.err, "phrame: 2 of 4 lines failed: 4, 6; line 4: column 2: not valid JSON: "));
  CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
  // The number is that in the input, also where lines are left out.
  here.write("done.jsonl", R"({"id":"a","error":{"status":2}})"
                           "\n");
  const std::string skipped = R"({"id": "a", "curve": 0})"
                              "\n";
  CHECK(here.run("batch --skip-done done.jsonl", skipped + "{\"curve\": 7}").err ==
        "phrame: 1 of 1 line failed: 2; line 2: /curve: an object, or a file as text, is wanted, "
        "not the number 7\n");
  // A last line that is an answer is one without its end, too; half an answer is cut off.
  const std::string whole = R"({"id":"a","error":{"status":2}})";
  here.write("open.jsonl", whole);
  const Run rest = here.run("batch --skip-done open.jsonl >>open.jsonl", skipped);
  CHECK(rest.status == 0);
  CHECK(rest.err.empty());
  CHECK(bytes_of(here.file("open.jsonl")) == whole + "\n");
  here.write("half.jsonl", whole.substr(0, whole.size() - 1));
  CHECK(contains(here.run("batch -o half.jsonl --skip-done half.jsonl", skipped).err,
                 "half.jsonl: the last line was cut off; its 30 bytes are kept in"));
  std::string many;
  for (int k = 0; k < 12; ++k) many += "7\n";
  CHECK(contains(here.run("batch", many).err,
                 "12 of 12 lines failed: 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, …; line 1: /: an object"));
}

TEST_CASE("frames: the rows of --at come first, in their order, as the help says") {
  const Workshop here;
  const std::string table = here.run("frames line.json --samples 2 --at 3,2").out;
  std::string t;
  std::istringstream lines(table);
  for (std::string row; std::getline(lines, row);) t += row.substr(0, row.find(',')) + " ";
  CHECK(t == "t 3 2 0 1 ");
  CHECK(contains(here.run("frames --help").out, "(N ≥ 2), after those of --at\n"));
}

TEST_CASE("program: one of a kind is singular") {
  const Workshop here;
  CHECK(contains(here.run("angle quintic.json --at 1 --digits 1").out, "rounded to 1 digit\n"));
  here.write("table.csv", "t;f2x;f2y;f2z\n0\n");
  check_failure(here.run("check line.json table.csv"), 2, "1 number here, but 4 in the header");
  here.write("column.csv", "0\n1\n");
  check_failure(here.run("check line.json column.csv"), 2, "and of 1 column it is not known");
}

TEST_CASE("program: no message begins with the name of a function") {
  const Workshop here;
  const std::string cusped = R"({"phrame": "curve/1", "basis": "power",
      "preimage": {"u": [-1, 2], "v": [0], "p": [0], "q": [0, -1, 2]}})";
  here.write("cusped.json", cusped);
  check_failure(here.run("frames line.json --samples 2 --frame frenet"), 3,
                "phrame: Frenet frame: the curve is a straight line");
  check_failure(here.run("frames inflected.json --at 0 --frame frenet"), 3,
                "phrame: Frenet frame: t = 0 is an inflection");
  check_failure(here.run("frames cusped.json --at 1/2 --columns curvature"), 3,
                "phrame: curvature: infinite at t = 1/2");
  check_failure(here.run("frames quintic.json --at 3 --frame mtf --from 0 --to 1"), 3,
                "phrame: t = 3 is outside [0, 1]\n");
  check_failure(here.run("interpolate quintic.json --period 1 --feed kappa"), 3,
                "phrame: signed curvature: the curve is not plane");
  check_failure(here.run("prove cusped.json --at 1"), 3,
                "phrame: proof: the preimage has a zero between 0 and t = 1,");
  here.write("table.csv", "t,x,y,z\n0,0,0,0\n");
  check_failure(here.run("certify table.csv"), 2,
                "phrame: table.csv:line 2: there is one point; a curve needs two at least\n");
  check_failure(here.run("verify table.csv"), 2,
                "phrame: table.csv:1:2: a certificate is JSON, this begins with \"t,x,y,z\"\n");
  check_failure(here.run("check line.json ."), 2, "phrame: .: is a directory, not a file\n");
}

TEST_CASE("frames: cells that are undefined are left empty where this is asked for, and said") {
  const Workshop here;
  const std::string frames = "frames inflected.json --frame frenet --samples 3";
  check_failure(here.run(frames), 3, "(--skip-undefined leaves such cells empty)");
  const Run run = here.run(frames + " --skip-undefined");
  CHECK(run.status == 0);
  CHECK(contains(run.out, "\n0,0,0,0,1,0,0,,,,,,\n"));
  CHECK(run.err ==
        "phrame: 1 of 3 rows has empty cells; the first: Frenet frame: t = 0 is an inflection, the "
        "principal normal is undefined\n");
  check_failure(here.run("frames inflected.json --frame rmf --samples 3 --skip-undefined"), 2,
                "--skip-undefined: needs --frame frenet, --frame erf or --columns");
  // A straight line has no torsion anywhere.
  const Run line = here.run("frames line.json --columns torsion,s --at 1 --skip-undefined");
  CHECK(line.status == 0);
  CHECK(contains(line.out, ",,1\n"));
  check_failure(here.run("frames line.json --columns torsion --at 1"), 3,
                "its torsion is undefined (--skip-undefined leaves such cells empty)");
  // What is outside of the curve is no empty row.
  check_failure(
      here.run("frames quintic.json --frame frenet --by arc-length --at 99 --skip-undefined"), 3,
      "is outside [0, ");
}

TEST_CASE("program: text abridges what is long and says how to see it, --full prints it") {
  const Workshop here;
  // Coefficients of 99 digits, whose squares no line can bear; name, multiplier and points, too.
  const std::string nines(99, '9');
  here.write("long.json", R"({"phrame": "curve/1", "basis": "power", "name": ")" +
                              std::string(190, 'n') + R"(", "preimage": {"u": [)" + nines +
                              ", 1, 2], \"v\": [1, " + nines +
                              R"(], "p": [0, 0, 1], "q": [3, 1]}})");
  const std::string fraction = "'1/(x^6 + " + nines + "*x^5 + " + nines + "*x^2 + " + nines + ")'";
  for (const std::string& arguments :
       {std::string("angle long.json"),
        std::string("angle long.json --frame frenet --at 1/" + nines),
        std::string("info long.json"), std::string("classify long.json"),
        std::string("totals long.json"), std::string("identify long.json"),
        std::string("mtf long.json --from 0 --to 1 --exact-only"), "integrate " + fraction,
        "integrate " + fraction + " --form real"}) {
    CAPTURE(arguments);
    const Run brief = here.run(arguments);
    check_success(brief);
    CHECK(brief.out.ends_with("\nLong parts are abridged (--full prints it all).\n"));
    const Run full = here.run(arguments + " --full");
    check_success(full);
    CHECK_FALSE(contains(full.out, "characters)"));
    CHECK_FALSE(contains(full.out, "⟨"));
    CHECK(full.out.size() > brief.out.size());
    for (const Run* run : {&brief, &full})
      CHECK(std::none_of(run->out.begin(), run->out.end(),
                         [](char c) { return c != '\n' && c >= 0 && c < ' '; }));
  }
  CHECK(contains(here.run("info long.json --full").out, nines + "t + 1\n"));
  // What is short is the same, and what is printed for programs is never abridged.
  CHECK(here.run("info quintic.json").out == here.run("info quintic.json --full").out);
  for (const char* command : {"angle", "info", "classify", "totals", "identify"})
    check_failure(here.run(std::string(command) + " quintic.json --print json --full"), 2,
                  "--full: needs --print text");
}

TEST_CASE("program: more than 24 poles are counted, and listed by --full") {
  const Workshop here;
  const std::string integrate = "integrate '1/(x^30 - x - 1)'";
  CHECK(contains(here.run(integrate).out, "\n  ⟨30 poles and their residues⟩\n"));
  const std::string full = here.run(integrate + " --full").out;
  CHECK(contains(full, "\n  pole z"));
  CHECK(std::count(full.begin(), full.end(), '\n') > 16);  // two real poles, 14 pairs
}

TEST_CASE("program: a failure leaves an existing target as it was") {
  const Workshop here;
  here.write("out", "before");
  check_failure(here.run("frames inflected.json --frame frenet --samples 3 -o out"), 3,
                "inflection");
  check_failure(here.run("angle missing.json -o out"), 2, "missing.json");
  CHECK(bytes_of(here.file("out")) == "before");
  CHECK(here.names() ==
        std::vector<std::string>{"inflected.json", "line.json", "out", "quintic.json"});
}

TEST_CASE("program: -o writes what standard output would get, and nothing else") {
  const Workshop here;
  const Run direct = here.run("frames quintic.json --samples 5 --format npy");
  check_success(direct);
  here.write("out", std::string(100'000, 'x'));
  const Run run = here.run("frames quintic.json --samples 5 --format npy -o out");
  CHECK(run.status == 0);
  CHECK(run.out.empty());
  CHECK(run.err.empty());
  CHECK(bytes_of(here.file("out")) == direct.out);
  CHECK(here.run("frames quintic.json --samples 5 --format npy --output new").status == 0);
  CHECK(bytes_of(here.file("new")) == direct.out);
  CHECK(here.run("info quintic.json -o -").out == here.run("info quintic.json").out);
  CHECK(here.names() ==
        std::vector<std::string>{"inflected.json", "line.json", "new", "out", "quintic.json"});
}

// Another name of the old file still shows the old bytes: it was replaced, not written into.
TEST_CASE("program: -o replaces an existing file in one step") {
  const Workshop here;
  here.write("out", "before");
  fs::create_hard_link(here.file("out"), here.file("old"));
  CHECK(here.run("info quintic.json -o out").status == 0);
  CHECK(bytes_of(here.file("old")) == "before");
  CHECK(bytes_of(here.file("out")) == here.run("info quintic.json").out);
  // Even the curve itself, which was read before.
  here.write("curve", bytes_of(here.file("quintic.json")));
  CHECK(here.run("info curve -o curve").status == 0);
  CHECK(bytes_of(here.file("curve")) == bytes_of(here.file("out")));
}

TEST_CASE("program: -o keeps the permissions of what it replaces, and goes through a link") {
  const Workshop here;
  here.write("out", "before");
  const auto mode = fs::perms::owner_read | fs::perms::owner_write;
  fs::permissions(here.file("out"), mode);
  fs::create_symlink("out", here.file("link"));
  CHECK(here.run("info quintic.json -o link").status == 0);
  CHECK(fs::is_symlink(here.file("link")));
  CHECK(bytes_of(here.file("out")) == here.run("info quintic.json").out);
  CHECK(fs::status(here.file("out")).permissions() == mode);
}

TEST_CASE("program: what cannot be written is refused and leaves nothing behind") {
  const Workshop here;
  const auto before = here.names();
  check_failure(here.run("info quintic.json -o nowhere/out"), 2, "nowhere/out: cannot be written");
  check_failure(here.run("info quintic.json -o ."), 2, ".: cannot be written: Is a directory");
  check_failure(here.run("info quintic.json -o ''"), 2, "\"\": cannot be written");
  check_failure(here.run("info quintic.json -o quintic.json/out"), 2, "cannot be written");
  check_failure(here.run("info quintic.json -o " + std::string(300, 'x')), 2, "cannot be written");
  CHECK(here.names() == before);
  fs::create_directory(here.file("locked"));
  fs::permissions(here.file("locked"), fs::perms::owner_read | fs::perms::owner_exec);
  if (!std::ofstream(here.file("locked") / "probe"))  // root writes everywhere
    check_failure(here.run("info quintic.json -o locked/out"), 2, "Permission denied");
}

TEST_CASE("program: a full disk is an error") {
  const Workshop here;
  if (!fs::exists("/dev/full")) return;
  check_failure(here.run("info quintic.json >/dev/full"), 2,
                "standard output: cannot be written: No space left");
  check_failure(here.run("info quintic.json -o /dev/full"), 2, "/dev/full: cannot be written");
  check_failure(here.run("frames quintic.json --samples 2001 >/dev/full"), 2, "cannot be written");
  check_failure(here.run("--help >/dev/full"), 2, "standard output: cannot be written");
  check_failure(here.run("angle --version >/dev/full"), 2, "standard output: cannot be written");
}

TEST_CASE("program: a closed standard output is an error, unless nothing is written to it") {
  const Workshop here;
  check_failure(here.run("info quintic.json >&-"), 2, "standard output: cannot be written");
  check_failure(here.run("--version >&-"), 2, "standard output: cannot be written");
  CHECK(here.run("info quintic.json -o out >&-").status == 0);
  CHECK(bytes_of(here.file("out")) == here.run("info quintic.json").out);
}

TEST_CASE("program: a closed or full standard error changes no exit status") {
  const Workshop here;
  CHECK(here.run("angle missing.json 2>&-").status == 2);
  CHECK(here.run("angle line.json --frame frenet 2>&-").status == 3);
  CHECK(here.run("--frobnicate 2>&-").status == 2);
  if (fs::exists("/dev/full")) CHECK(here.run("angle missing.json 2>/dev/full").status == 2);
}

TEST_CASE("program: --form changes how the angle is written, not its values") {
  const Workshop here;
  const std::string common = "angle quintic.json --print json --samples 5 --form ";
  const Json poles = values(here.run(common + "partial-fractions"));
  CHECK(values(here.run(common + "rothstein-trager")) == poles);
  CHECK(values(here.run(common + "auto")) == poles);
  CHECK(values(here.run(common + "real")) == poles);
}

TEST_CASE("classify: in text and JSON; a bad curve is refused") {
  const Workshop here;
  const Run text = here.run("classify quintic.json");
  check_success(text);
  CHECK(contains(text.out, "ERF turns one way     yes"));
  const auto report = nlohmann::json::parse(here.run("classify quintic.json --print json").out);
  CHECK(report["phrame"] == "classify/1");
  CHECK(report["erf_monotone"]["zeros_of_h"].size() == 2);
  check_failure(here.run("classify quintic.json --print pdf"), 2,
                "\"pdf\" is not one of text, json");
  check_failure(here.run("classify nothing.json"), 2, "nothing.json");
}

TEST_CASE("program: angle: all routes to a value print the same digits") {
  const Workshop here;
  for (const char* frame : {"erf", "frenet"}) {
    const std::string command =
        std::string("angle quintic.json --at 1/3,1,-7 --digits 40 --print json --frame ") + frame;
    const Json expected = values(here.run(command));
    for (const char* route : {"auto", "roots", "quadrature", "both"}) {
      const Json found = values(here.run(command + " --route " + route));
      for (std::size_t k = 0; k < expected.size(); ++k)
        CHECK(found[k]["theta"] == expected[k]["theta"]);
    }
  }
  check_failure(here.run("angle quintic.json --route sampling"), 2,
                "--route: \"sampling\" is not one of auto, roots, quadrature, both");
}

}  // namespace program_test
