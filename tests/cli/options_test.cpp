// Every option of every command is refused or has an effect. The commands, options and conditions
// are those that the program lists itself; only what to try is written here.
#include <algorithm>
#include <map>
#include <set>

#include "cli/workshop.hpp"
#include "support/random.hpp"

using namespace phrame;
using namespace phrame::test;

namespace {

/// A way to give an option: its name, and all of it as an argument.
struct Given {
  std::string option;
  std::string text;
};

Json commands(const Workshop& here) {
  const Run run = here.run("help --json");
  check_success(run);
  return Json::parse(run.out)["commands"];
}

/// What the commands are tried on.
void prepare(const Workshop& here) {
  here.write("example.json", bytes_of(test::root("/examples/curves/farouki-moon-1.json")));
  here.write("spline.json", bytes_of(test::root("/examples/curves/closed-spline.json")));
  here.write("plane.json", R"({"phrame": "curve/1", "basis": "power",
      "preimage": {"u": [1], "v": [0], "p": [0], "q": [0, "1/2"]}})");
  here.write("axis.json", R"({"phrame": "mph/1", "control_points": [[0, 0, 1], [5, 0, 4]]})");
  here.write("corner.json", R"({"phrame": "spline/1", "segments": [
      {"control_points": [[0, 0, 0], [1, 0, 0]]}, {"control_points": [[1, 0, 0], [1, 1, 0]]}]})");
  here.write("oval.json", R"({"phrame": "curve/1", "basis": "power",
      "position": {"x": [3, 0, -3], "y": [0, 4], "w": [1, 0, 1]}})");
  here.write("points.json", R"({"phrame": "points/1", "points": [[0, 0], [1, 0]],
      "tangents": [[1, 1], [1, -2]]})");
  std::string curve = bytes_of(here.file("quintic.json"));
  std::replace(curve.begin(), curve.end(), '\n', ' ');
  here.write("lines.jsonl", R"({"id": 1, "curve": )" + curve + "}\n");
  REQUIRE(here.run("frames quintic.json --samples 3 -o frames.csv").status == 0);
  REQUIRE(here.run("certify quintic.json -o angle.cert").status == 0);
}

/// Calls that succeed, for the options that are to be added; the first word is the command.
const std::vector<std::string> calls{
    "angle quintic.json",
    "angle quintic.json --at 1/2",
    "angle spline.json --at 1/2",
    "info quintic.json",
    "classify quintic.json",
    "totals quintic.json",
    "frames quintic.json --at 1/3",
    "frames example.json --at 1/3 --from pi/8 --to 1 --frame mtf,mtf-exact --unproved",
    "frames quintic.json --samples 3 --format glb",
    "frames quintic.json --samples 3 --format blender",
    "mtf example.json --from pi/8 --to 1 --exact-only",
    "mtf example.json --from pi/8 --to 1 --unproved",
    "mtf example.json --wronskian",
    "interpolate plane.json --period 1/4 --feed 1",
    "interpolate plane.json --period 1/2 --feed 1 --max-tangential-acceleration 2",
    "interpolate plane.json --period 1/4 --feed 1 --format gcode",
    "construct points.json",
    "construct points.json --kind length --lengths 8",
    "identify quintic.json",
    "integrate '1/(4*x^2-1)'",
    "integrate '1/(x^4-2)' --from 0 --to 1",
    "batch lines.jsonl --at 1",
    "sweep plane.json --profile circle:1/2",
    "sweep plane.json --profile circle:1/2 --exact --format json",
    "offset corner.json --distance 1/2",
    "envelope axis.json",
    "offset corner.json --distance 1/2 --check corner.json --tol 1",
    "envelope axis.json --trim",
    "transform spline.json",
    "transform oval.json --whole-line",
    "compile plane.json",
    "compile spline.json",
    "check quintic.json frames.csv",
    "certify quintic.json",
    "verify angle.cert",
    "prove quintic.json",
    "page quintic.json",
    "reference --group plane",
    "help angle"};

std::string command_of(const std::string& call) { return call.substr(0, call.find(' ')); }

Json find_command(const Json& commands, const std::string& name) {
  for (const Json& command : commands)
    if (command["command"] == name) return command;
  FAIL("a call of ", name, ", which is not in the list");
  return {};
}

/// What an option is tried with that takes no name of a list.
const std::map<std::string, std::string> values{{"--at", "1/3"},
                                                {"--samples", "3"},
                                                {"--digits", "5"},
                                                {"--start", "erf"},
                                                {"--theta0", "pi/3"},
                                                {"--up", "1,2,3"},
                                                {"--start-normal", "1,2,3"},
                                                {"--from", "1/8"},
                                                {"--to", "3/4"},
                                                {"--from-vector", "1,2,3"},
                                                {"--to-vector", "3,2,-1"},
                                                {"--turns", "1"},
                                                {"--degree", "3"},
                                                {"--subdivide", "1/2"},
                                                {"--period", "1/3"},
                                                {"--feed", "2"},
                                                {"--max-normal-acceleration", "1/2"},
                                                {"--max-tangential-acceleration", "3"},
                                                {"--start-speed", "1/3"},
                                                {"--end-speed", "1/4"},
                                                {"--prefix", "arm"},
                                                {"--tol", "1/1000"},
                                                {"--tolerance", "1/1000"},
                                                {"--normal-tolerance", "2deg"},
                                                {"--origin", "1,2,3"},
                                                {"--angles", "1/3,0"},
                                                {"--solution", "2"},
                                                {"--lengths", "9"},
                                                {"--helicity", "0,1,3"},
                                                {"--header", "t,f2x,f2y,f2z"},
                                                {"--frames", "frames.csv"},
                                                {"--profile", "polygon:3,1"},
                                                {"--end-normal", "1,2,3"},
                                                {"--twist", "pi/4"},
                                                {"--scale", "1+t"},
                                                {"--sections", "4"},
                                                {"--duration", "5"},
                                                {"--fps", "30"},
                                                {"--places", "3"},
                                                {"--distance", "1/4"},
                                                {"--check", "plane.json"},
                                                {"--gauge", "oval.json"},
                                                {"--part", "1/4,3/2"},
                                                {"--split", "1/3"},
                                                {"--rotate", "z,90deg"},
                                                {"--matrix", "1,2,0,0,1,0,0,0,1"},
                                                {"--move", "1,2,3"},
                                                {"--question", "info"},
                                                {"--linked-with", "spline.json"},
                                                {"--scale-column", "radius"},
                                                {"--roll", "t/3"},
                                                {"--roll-column", "bank"},
                                                {"--pick", "left"},
                                                {"--nearest", "1,2,3"},
                                                {"--group", "splines"},
                                                {"--table", "frames.csv"},
                                                {"--export", "collection"},
                                                {"--curve", "quintic.json"}};

/// These change no answer: limits, where it goes, how it is found, what is the default anyway.
const std::set<std::string> neutral{
    "--max-degree", "--max-corner", "--gap",          "--output",   "--threads", "--skip-done",
    "--help",       "--version",    "--route",        "--var",      "--full",    "--skip-undefined",
    "--near",       "--time-limit", "--skip-invalid", "--unlimited"};

/// All ways to give the options of a command, but the neutral ones.
std::vector<Given> given(const Json& command) {
  std::vector<Given> all;
  for (const Json& option : command["options"]) {
    const std::string name = option["names"].back();
    if (option["argument"] == true || neutral.count(name) == 1) continue;
    if (option["value"].get<std::string>().empty()) {
      all.push_back({name, name});
    } else if (!option["choices"].empty()) {
      // The first one is the default, but for --columns, which has none.
      for (std::size_t k = name == "--columns" ? 0 : 1; k < option["choices"].size(); ++k)
        all.push_back({name, name + " " + option["choices"][k].get<std::string>()});
    } else {
      CAPTURE(command["command"]);
      REQUIRE_MESSAGE(values.count(name) == 1, name << ": no value to try it with is known here");
      all.push_back({name, name + " " + values.at(name)});
    }
  }
  return all;
}

/// "--frame erf" for the choice "--frame rmf", where that is the default of the command; else
/// nothing.
std::string instead_of_default(const Json& command, const std::string& choice) {
  for (const Json& option : command["options"]) {
    const std::string name = option["names"].back();
    const Json& names = option["choices"];
    if (names.size() > 1 && choice == name + " " + names[0].get<std::string>())
      return name + " " + names[1].get<std::string>();
  }
  return "";
}

bool is_refused(const Run& run) { return run.status == 2; }

bool are_equal(const Run& a, const Run& b) { return a.status == b.status && a.out == b.out; }

/// Given with any other, these may leave the answer as it is: the form may be the one that is taken
/// anyway, a start may be the default, there may be no pole to be a principal value at, the w that
/// is not proved to be the best one may be it, a rule or a kind may have the same curve as another,
/// and of two tolerances the narrower one decides.
bool may_be_equal(const std::string& option) {
  return option == "--form" || option == "--principal-value" || option == "--unproved" ||
         option == "--select" || option == "--kind" || option == "--start" ||
         option == "--tolerance";
}

}  // namespace

TEST_CASE("options: an option that needs another choice is refused without it") {
  const Workshop here;
  prepare(here);
  const Json all = commands(here);
  std::size_t conditions = 0;
  std::set<std::string> done;
  for (const std::string& first_call : calls) {
    if (!done.insert(command_of(first_call)).second) continue;  // it has the fewest options
    // What is missing then is told later than what does not apply.
    const std::string call = command_of(first_call) == "mtf" ? "mtf example.json" : first_call;
    const Json command = find_command(all, command_of(call));
    for (const Json& option : command["options"])
      for (const Given& way : given(command)) {
        const std::string name = option["names"].back();
        if (way.option != name) continue;
        CAPTURE(call);
        CAPTURE(way.text);
        const bool is_there = std::any_of(
            option["with"].begin(), option["with"].end(),
            [&](const Json& choice) { return contains(call, choice.get<std::string>()); });
        if (!option["with"].empty() && !is_there && !contains(call, "--from")) {
          ++conditions;
          std::string other;
          for (const Json& choice : option["with"])
            other += " " + instead_of_default(command, choice);
          const Run without = here.run(call + " " + way.text + other);
          check_failure(without, 2, "phrame: " + name + ": needs ");
          for (const Json& choice : option["with"])
            CHECK(contains(without.err, choice.get<std::string>()));
        }
        std::string needed;
        if (!option["with"].empty()) {
          const std::string first = option["with"][0];
          needed = " " + first + (values.count(first) == 1 ? " " + values.at(first) : "");
        }
        for (const Json& choice : option["without"]) {
          ++conditions;
          const std::string other = choice;
          const std::string value = values.count(other) == 1 ? " " + values.at(other) : "";
          check_failure(here.run(call + " " + way.text + needed + " " + other + value), 2,
                        "phrame: " + name + ": does not apply with " + other + "\n");
        }
      }
  }
  CHECK(done.size() == all.size());
  CHECK(conditions > 20);
}

// Places are told by any parameter; of a batch its lines say by which, and functions are of t.
TEST_CASE("options: wherever one takes t, --by says what it is") {
  const Workshop here;
  long options = 0;
  for (const Json& command : commands(here)) {
    const std::string name = command["command"];
    std::set<std::string> by;
    for (const Json& option : command["options"])
      if (option["names"].back() == "--by")
        for (const Json& choice : option["with"]) by.insert(choice.get<std::string>());
    for (const Json& option : command["options"]) {
      const std::string value = option["value"], what = option["what"];
      const bool takes_t = value == "T" || value == "T,..." || value == "FROM,TO" ||
                           contains(what, "values of t") || contains(what, "parameters t");
      if (!takes_t || name == "batch" || option["names"].back() == "--by") continue;
      CAPTURE(name);
      CAPTURE(what);
      ++options;
      CHECK(by.count(option["names"].back()) == 1);
    }
  }
  CHECK(options >= 15);
}

TEST_CASE("options: each one, and each pair, is refused or changes the answer") {
  const Workshop here;
  prepare(here);
  const Json all = commands(here);
  long pairs = 0;
  for (const std::string& call : calls) {
    if (command_of(call) == "help") continue;
    const Run plain = here.run(call);
    CAPTURE(call);
    if (has_no_pages(plain)) continue;
    CHECK(plain.status == 0);
    std::vector<std::pair<Given, Run>> accepted;
    for (const Given& way : given(find_command(all, command_of(call)))) {
      if (way.option == way.text && contains(call, way.option)) continue;  // a flag that is there
      const Run run = here.run(call + " " + way.text);
      CAPTURE(way.text);
      if (is_refused(run)) continue;
      // Of a check v is what findings are looked for about: here there are none.
      const bool may_be_as_plain = way.option == "--form" || way.option == "--start" ||
                                   (way.option == "--up" && command_of(call) == "check");
      if (!may_be_as_plain) CHECK_FALSE(are_equal(run, plain));
      accepted.emplace_back(way, run);
    }
    for (std::size_t i = 0; i < accepted.size(); ++i)
      for (std::size_t j = i + 1; j < accepted.size(); ++j) {
        const auto& [a, only_a] = accepted[i];
        const auto& [b, only_b] = accepted[j];
        if (a.option == b.option) continue;
        // Every day of every two hundredth pair: a program that ignores an option is seen above.
        if (++pairs % everyday(200, 1) != 0) continue;
        const std::string both = a.text + " " + b.text;
        const Run run = here.run(call + " " + both);
        if (is_refused(run)) continue;
        CAPTURE(both);
        if (a.text == "--frame up" && b.text == "--start up") continue;  // which takes that frame
        // Of a batch an option is for the lines whose question has it.
        if (command_of(call) == "batch" && contains(both, "--question")) continue;
        if (only_a.status > 1 || only_b.status > 1) continue;  // what is undefined stays so
        if (a.text == "--join open" && b.option == "--digits")
          continue;  // of lines, which are exact
        if (command_of(call) == "envelope" && a.option == "--print" && b.option == "--digits")
          continue;  // of places where it is cut, which may all be rational
        if (!may_be_equal(b.option)) CHECK_FALSE(are_equal(run, only_a));
        if (!may_be_equal(a.option)) CHECK_FALSE(are_equal(run, only_b));
      }
  }
}
