// A line of a batch asks what a command answers. The commands and their options are those that the
// program lists itself.
#include <map>

#include "cli/workshop.hpp"

namespace question_test {

using namespace phrame;
using namespace phrame::test;

namespace {

Json commands(const Workshop& here) {
  const Run run = here.run("help --json");
  check_success(run);
  return Json::parse(run.out)["commands"];
}

/// What commands are asked about is their argument.
bool is_question(const Json& command) {
  const Json& options = command["options"];
  return !options.empty() && options[0]["argument"] == true && options[0]["required"] == true;
}

/// What arguments and options are that must be given.
const std::map<std::string, std::string> needed{
    {"CURVE", "quintic.json"}, {"FRAMES", "frames.csv"},       {"CERT", "angle.cert"},
    {"DATA", "points.json"},   {"EXPR", "-1/(x^4 + 1)"},       {"--feed", "1 + s"},
    {"--period", "1/2"},       {"--profile", "polygon:3,1/9"}, {"--distance", "-1,1/2"},
    {"AXIS", "axis.json"}};

/// What else a command cannot do without, or wants in place of that, as command and option.
const std::map<std::string, std::map<std::string, std::string>> needed_by{
    {"frames", {{"--samples", "3"}}},
    {"mtf", {{"--from", "pi/8"}, {"--to", "1"}}},
    {"offset", {{"CURVE", "plane.json"}}}};

std::string key_of(std::string option) {
  option.erase(0, option.find_first_not_of('-'));
  for (char& c : option)
    c = c == '-' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return option;
}

/// The smallest call of a command that succeeds, on the command line and as a line of a batch.
struct Asked {
  std::string call;
  Json line;
};

Asked asked(const Workshop& here, const Json& command) {
  const std::string name = command["command"];
  Asked both{name, {{"id", name}, {"question", name}}};
  const auto more = needed_by.find(name);
  for (const Json& option : command["options"]) {
    const std::string as_typed = option["names"].back();
    std::string value;
    if (more != needed_by.end() && more->second.count(as_typed) == 1) {
      value = more->second.at(as_typed);
    } else if (option["required"] == true) {
      CAPTURE(name);
      REQUIRE_MESSAGE(needed.count(as_typed) == 1, as_typed << ": no value of it is known here");
      value = needed.at(as_typed);
    } else {
      continue;
    }
    both.call +=
        option["argument"] == true ? " '" + value + "'" : " " + as_typed + " '" + value + "'";
    if (option["file"] == true) value = bytes_of(here.file(value));
    both.line[key_of(as_typed)] = value.starts_with('{') ? Json::parse(value) : Json(value);
  }
  return both;
}

/// " --print json", where the command has that.
std::string json_option(const Json& command) {
  for (const Json& option : command["options"])
    for (const Json& choice : option["choices"])
      if (choice == "json") return " " + option["names"].back().get<std::string>() + " json";
  return "";
}

void prepare(const Workshop& here) {
  here.write("plane.json", bytes_of(test::root("/examples/curves/plane-cubic.json")));
  here.write("axis.json", R"({"phrame": "mph/1", "control_points": [[0, 0, 1], [5, 0, 4]]})");
  here.write("points.json", R"({"phrame": "points/1", "points": [[0, 0], [1, 0.25]],
      "tangents": [[1, 1], [1, "-2"]]})");
  REQUIRE(here.run("frames quintic.json --samples 3 -o frames.csv").status == 0);
  REQUIRE(here.run("certify quintic.json -o angle.cert").status == 0);
}

std::vector<Json> answers(const Run& run) {
  std::vector<Json> list;
  std::istringstream lines(run.out);
  for (std::string line; std::getline(lines, line);) list.push_back(Json::parse(line));
  return list;
}

std::vector<Json> answers(const Workshop& here, const std::vector<Json>& lines,
                          const std::string& options = "") {
  std::string text;
  for (const Json& line : lines) text += line.dump() + "\n";
  return answers(here.run("batch " + options, text));
}

Json quintic(const Workshop& here) { return Json::parse(bytes_of(here.file("quintic.json"))); }

}  // namespace

TEST_CASE("question: a line of a batch gives what the command gives, for each command") {
  const Workshop here;
  prepare(here);
  std::vector<Json> lines;
  std::vector<Json> expected;
  for (const Json& command : commands(here)) {
    if (!is_question(command)) continue;
    const Asked both = asked(here, command);
    CAPTURE(both.call);
    // What has its JSON only with --exact is what it is without.
    Run run = here.run(both.call + json_option(command));
    if (run.status == 2 && command["command"] == "sweep") run = here.run(both.call);
    if (has_no_pages(run)) continue;
    check_success(run);
    Json answer = run.out.starts_with('{') ? Json::parse(run.out) : Json{{"output", run.out}};
    answer["id"] = command["command"];
    expected.push_back(answer);
    lines.push_back(both.line);
  }
  const auto found = answers(here, lines);
  REQUIRE(found.size() == lines.size());
  for (std::size_t k = 0; k < lines.size(); ++k) {
    CAPTURE(lines[k].dump());
    CHECK(found[k] == expected[k]);
  }
  CHECK(lines.size() >= 16);
  CHECK(found.front()["phrame"] == "angle/1");
}

TEST_CASE("question: each argument and option of each command is a key, but for the output") {
  const Workshop here;
  prepare(here);
  std::vector<Json> lines;
  std::vector<std::string> expected;
  for (const Json& command : commands(here)) {
    if (!is_question(command)) continue;
    for (const Json& option : command["options"]) {
      const std::string as_typed = option["names"].back();
      const std::string key = key_of(as_typed);
      const bool is_shell_only =
          as_typed == "--output" || as_typed == "--help" || as_typed == "--version";
      lines.push_back(asked(here, command).line);
      lines.back()[key] = nullptr;
      expected.push_back(is_shell_only ? "/: unknown key \"" + key + "\"; " : "/" + key + ": ");
    }
  }
  const auto found = answers(here, lines);
  REQUIRE(found.size() == lines.size());
  for (std::size_t k = 0; k < lines.size(); ++k) {
    CAPTURE(lines[k].dump());
    const std::string message = found[k]["error"]["message"];
    CAPTURE(message);
    CHECK(found[k]["error"]["status"] == 2);
    CHECK(message.starts_with(expected[k]));
    // What lines knew that asked for an angle only, they tell as ever.
    if (expected[k].ends_with(": ") && lines[k]["question"] != "angle")
      CHECK(message.ends_with(" is wanted, not null"));
  }
  CHECK(lines.size() > 150);
}

TEST_CASE("question: values are strings, numbers, booleans, arrays and tables") {
  const Workshop here;
  const auto same = [&](const Json& keys, const std::string& call) {
    CAPTURE(call);
    Json line = keys;
    if (!line.contains("data") && !line.contains("expr")) line["curve"] = quintic(here);
    const Run run = here.run(call);
    check_success(run);
    Json expected = run.out.starts_with('{') ? Json::parse(run.out) : Json{{"output", run.out}};
    expected["id"] = nullptr;
    CHECK(answers(here, {line}).at(0) == expected);
  };
  same({{"question", "frames"}, {"at", {0, "1/3", 0.5}}, {"frame", {"rmf", "erf"}}},
       "frames quintic.json --at 0,1/3,0.5 --frame rmf,erf --format json");
  same({{"question", "frames"}, {"samples", 2}, {"start_normal", {0, "1/3", -1}}},
       "frames quintic.json --samples 2 --start-normal 0,1/3,-1 --format json");
  same({{"question", "mtf"}, {"wronskian", true}, {"exact_only", false}},
       "mtf quintic.json --wronskian --print json");
  same({{"question", "info"}, {"print", "latex"}}, "info quintic.json --print latex");
  same({{"question", "info"}, {"print", "text"}, {"full", true}}, "info quintic.json --full");
  // More of an angle than lines without a question knew.
  same({{"at", 1}, {"form", "real"}}, "angle quintic.json --at 1 --form real --print json");
  same({{"question", "angle"}, {"print", "sympy"}}, "angle quintic.json --print sympy");
  same({{"question", "integrate"},
        {"expr", "-1/x"},
        {"from", -1},
        {"to", 2},
        {"principal_value", true}},
       "integrate '-1/x' --from -1 --to 2 --principal-value --print json");
  here.write("points.csv", "x,y,z\n0,0,0\n1,0,1/3\n2,0.5,1\n");
  same({{"question", "construct"},
        {"data", {{"x", "y", "z"}, {0, 0, 0}, {1, 0, "1/3"}, {2, 0.5, 1}}}},
       "construct points.csv --print json");
  here.write("corners.csv", "0,0\n1,0\n0,1\n");
  same({{"question", "sweep"}, {"profile", {{0, 0}, {1, 0}, {0, 1}}}, {"sections", 3}},
       "sweep quintic.json --profile corners.csv --sections 3");
  same({{"question", "sweep"}, {"profile", "circle:1"}, {"exact", true}, {"end_normal", {0, 0, 1}}},
       "sweep quintic.json --profile circle:1 --exact --end-normal 0,0,1 --format json");
}

TEST_CASE("question: what is wrong is told as the command tells it, at its place in the line") {
  const Workshop here;
  struct Case {
    Json keys;
    int status;
    std::string message;
  };
  const Json parabola = {{"control_points", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}}};
  const Json broken = {{"basis", "power"},
                       {"preimage", {{"u", {1}}, {"v", {"1/0"}}, {"p", {0}}, {"q", {0}}}}};
  const std::vector<Case> cases{
      {{{"question", "total"}}, 2, "/question: \"total\" is not one of angle, info, "},
      {{{"question", "batch"}}, 2, "/question: \"batch\" is not one of "},
      {{{"question", 7}}, 2, "/question: a string is wanted, not the number 7"},
      {{{"question", "totals"}, {"digit", 7}},
       2,
       "/: unknown key \"digit\"; the nearest known key is \"digits\""},
      {{{"question", "totals"}, {"digits", 0}},
       2,
       "/digits: \"0\" is not a whole number from 1 to 100000"},
      {{{"question", "totals"}, {"digits", {7}}},
       2,
       "/digits: a string or a number is wanted, not an array of 1"},
      {{{"question", "totals"}, {"id", {1}}}, 2, "/id: an id is a string or a number"},
      {{{"question", "totals"}, {"curve", broken}},
       2,
       "/curve/preimage/v/0: \"1/0\" divides by zero"},
      {{{"question", "totals"}, {"curve", 7}},
       2,
       "/curve: an object, or a file as text, is wanted, not the number 7"},
      {{{"question", "prove"}, {"at", 1}, {"curve", parabola}},
       2,
       "/curve/control_points: this is no PH curve"},
      {{{"question", "frames"}}, 2, "/: --samples N or --at t,… is needed"},
      {{{"question", "frames"}, {"samples", 2}, {"format", "npy"}},
       2,
       "/format: \"npy\" is binary"},
      {{{"question", "frames"},
        {"samples", 2},
        {"frame", {"rmf", "mtf"}},
        {"from", 0},
        {"from_vector", {0, 0, 1}}},
       2,
       "/from: the angle is given twice"},
      {{{"question", "frames"}, {"samples", 2}, {"theta0", 1}, {"start_normal", {0, 0, 1}}},
       2,
       "/start_normal: does not apply with --theta0"},
      {{{"question", "frames"}, {"at", {1, "x"}}}, 2, "/at: \"x\" is not a number"},
      {{{"question", "frames"}, {"at", {1, "2,3"}}},
       2,
       "/at/1: an item of a list has no comma in it"},
      {{{"question", "integrate"}, {"curve", nullptr}}, 2, "/: unknown key \"curve\""},
      {{{"question", "sweep"}}, 2, "/: the key \"profile\" is missing"},
      {{{"question", "sweep"}, {"profile", "-"}}, 2, "/profile: \"-\" is standard input"},
      {{{"question", "sweep"}, {"profile", "profile.csv"}}, 2, "/profile: "},
      {{{"question", "identify"}, {"curve", parabola}, {"print", "curve"}},
       1,
       "this is no PH curve: "},
      {{{"question", "totals"},
        {"digits", 20'000},
        {"time_limit", "1e-3"},
        {"curve",
         {{"from", 0},
          {"to", 1},
          {"expressions", {{"x", "t"}, {"y", "exp(t)"}, {"z", "sin(t^2)"}}}}}},
       4,
       "undecided within the time limit"}};
  here.write("profile.csv", "0,0\n1,0\n0,1\n");  // a line names no files
  std::vector<Json> lines;
  for (const Case& c : cases) {
    lines.push_back(c.keys);
    if (!lines.back().contains("curve")) lines.back()["curve"] = quintic(here);
  }
  const auto found = answers(here, lines);
  REQUIRE(found.size() == cases.size());
  for (std::size_t k = 0; k < cases.size(); ++k) {
    CAPTURE(found[k].dump());
    CHECK(found[k]["error"]["status"] == cases[k].status);
    CHECK(found[k]["error"]["message"].get<std::string>().starts_with(cases[k].message));
  }
}

TEST_CASE("question: an answer that is no has its status where it has no JSON") {
  const Workshop here;
  prepare(here);
  Json certificate = Json::parse(bytes_of(here.file("angle.cert")));
  const auto found = answers(here, {{{"question", "verify"}, {"cert", certificate}},
                                    {{"question", "check"},
                                     {"curve", quintic(here)},
                                     {"theta0", 1},
                                     {"frames", bytes_of(here.file("frames.csv"))}}});
  CHECK_FALSE(found.at(0).contains("status"));
  CHECK(found.at(1)["verdict"] == "fail");
  certificate["claims"][0]["theta"] = "0.3";
  const Json broken{{"question", "verify"}, {"cert", certificate}};
  here.write("broken.cert", certificate.dump());
  const Run run = here.run("verify broken.cert");
  CHECK(run.status == 1);
  CHECK(answers(here, {broken}).at(0) == Json{{"id", nullptr}, {"status", 1}, {"output", run.out}});
}

TEST_CASE("question: what the command says on stderr is in the answer") {
  const Workshop here;
  const Json cubic = {{"control_points",
                       {{0, 0, 0},
                        {0.3333333333333333, 0, 0},
                        {0.6666666666666666, 0.3333333333333333, 0},
                        {0.6666666666666666, 1, 0}}}};
  const auto found = answers(here, {{{"question", "totals"}, {"curve", cubic}},
                                    {{"question", "totals"}, {"curve", cubic}, {"near", "1e-15"}}});
  CHECK(found.at(0)["notes"].size() == 1);
  CHECK(found.at(0)["notes"][0].get<std::string>().starts_with(
      "/curve: a PH curve is at most 1.4e-17"));
  CHECK(found.at(1)["notes"][0].get<std::string>().starts_with("/curve: in its place a PH curve"));
  CHECK(found.at(1)["near"]["epsilon"] == "1/1000000000000000");
}

TEST_CASE("question: options of the batch are for all lines whose question has them") {
  const Workshop here;
  const Json curve = quintic(here);
  const auto one = [&](const Json& line, const std::string& options) {
    return answers(here, {line}, options).at(0);
  };
  const auto by_line = [&](const Json& line) { return one(line, ""); };
  // A bare curve has no other keys, its name is the id.
  Json line = {{"id", "quintic"}, {"question", "totals"}, {"curve", curve}, {"digits", 30}};
  CHECK(one(curve, "--question totals --digits 30 --at 1 --values-only") == by_line(line));
  CHECK(one(line, "--question info --digits 40") == by_line(line));
  line = {{"question", "frames"}, {"curve", curve}, {"at", {1}}, {"frame", "erf"}};
  CHECK(one(line, "--at 0 --frame frenet --theta0 1") == by_line(line));
  Json start = {{"question", "frames"}, {"curve", curve}, {"at", 1}, {"start_normal", {0, 0, 1}}};
  CHECK(one(start, "--theta0 1") == by_line(start));
  CHECK(one({{"question", "frames"}, {"curve", curve}, {"at", 1}}, "--start-normal 0,0,1") ==
        by_line(start));
  // A fault of an option is not one of the line.
  CHECK(one({{"question", "frames"}, {"curve", curve}, {"at", 1}},
            "--start-normal 2,2,1")["error"]["message"]
            .get<std::string>()
            .starts_with("--start-normal: the vector (2, 2, 1)"));
  check_failure(here.run("batch --question total", "{}"), 2, "--question: \"total\" is not one of");
}

TEST_CASE("question: any number of threads gives the same bytes, and answers are not asked again") {
  const Workshop here;
  prepare(here);
  std::string lines;
  for (int k = 0; k < 2; ++k)
    for (const Json& command : commands(here))
      if (is_question(command)) {
        Json line = asked(here, command).line;
        line["id"] = std::to_string(k) + line["id"].get<std::string>();
        if (command["command"] != "page" && command["command"] != "sweep")
          lines += line.dump() + "\n";
      }
  const bool is_same =
      here.run("batch --threads 1", lines).out ==
      (here.run("batch --threads 4 -o out.jsonl", lines), bytes_of(here.file("out.jsonl")));
  CHECK(is_same);
  CHECK(here.run("batch --skip-done out.jsonl", lines).out.empty());
}

}  // namespace question_test
