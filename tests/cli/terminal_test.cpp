// What is said to who types something wrong, and the documents that the program writes of itself.
#include <fmt/format.h>

#include <iterator>
#include <regex>

#include "cli/workshop.hpp"
#include "phrame/io/write/passage.hpp"
#include "support/random.hpp"

using namespace phrame;
using namespace phrame::test;

namespace {

std::vector<std::string> names_of_commands(const Workshop& here) {
  std::vector<std::string> names;
  const Run run = here.run("help --json");
  check_success(run);
  const Json program = Json::parse(run.out);
  for (const Json& command : program["commands"]) names.push_back(command["command"]);
  REQUIRE(names.size() > 10);
  return names;
}

}  // namespace

TEST_CASE("terminal: a misspelt command or option is answered with the one that was meant") {
  const Workshop here;
  check_failure(here.run("angel quintic.json"), 2,
                "\"angel\" is not a command; did you mean angle? (phrame --help)\n");
  check_failure(here.run("integ 1/x"), 2, "did you mean integrate?");
  check_failure(here.run("help frame"), 2, "\"frame\" is not a command; did you mean frames?");
  check_failure(here.run("frobnicate"), 2, "\"frobnicate\" is not a command: there are angle, ");
  check_failure(
      here.run("angle quintic.json --digit 5"), 2,
      "phrame: --digit is no option of angle; did you mean --digits? (phrame angle --help)");
  check_failure(here.run("angle quintic.json --out f"), 2, "did you mean --output?");
  check_failure(here.run("angle --sample=5 quintic.json"), 2, "did you mean --samples?");
  check_failure(here.run("angle quintic.json -digits 5"), 2, "did you mean --digits?");
  check_failure(here.run("frames quintic.json --form real --at 0"), 2,
                "--form is no option of frames; it is one of angle, integrate");
  check_failure(here.run("angle quintic.json --frobnicate"), 2,
                "phrame: --frobnicate is no option of angle (phrame angle --help)\n");
  check_failure(here.run("--versoin"), 2, "--versoin is no option; did you mean --version?");
}

TEST_CASE("terminal: what is missing, doubled or too much is said in our words") {
  const Workshop here;
  check_failure(here.run("angle"), 2, "phrame: CURVE is required: a curve file");
  check_failure(here.run("angle quintic.json --at"), 2,
                "phrame: --at: a value is needed, T,... (phrame angle --help)");
  check_failure(here.run("angle quintic.json --at --digits 5"), 2,
                "phrame: --at: a value is needed before --digits\n");
  check_failure(here.run("angle quintic.json -o --digits 5"), 2,
                "a value is needed before --digits");
  check_failure(here.run("angle quintic.json --digits 5 --digits 6"), 2,
                "phrame: --digits is given 2 times");
  check_failure(here.run("angle quintic.json line.json"), 2,
                "\"line.json\" is one argument too many: phrame angle takes CURVE");
  check_failure(here.run("mtf quintic.json --from 0 --closed=yes"), 2,
                "phrame: --closed takes no value");
  for (const char* digits :
       {"abc", "0", "-1", "1.5", "100001", "99999999999999999999", "''", "5x"}) {
    std::string shown = digits;
    if (shown == "''") shown.clear();
    check_failure(here.run(std::string("angle quintic.json --at 1 --digits ") + digits), 2,
                  "phrame: --digits: \"" + shown + "\" is not a whole number from 1 to 100000");
  }
  check_failure(here.run("--"), 2, "a command is needed");
}

TEST_CASE("terminal: an option before the command is told where it belongs") {
  const Workshop here;
  check_failure(here.run("--at 1 angle quintic.json"), 2,
                "--at: options come after the command (phrame --help)");
  check_failure(here.run("-o x.json info quintic.json"), 2, "-o: options come after the command");
  check_success(here.run("--version"));
}

TEST_CASE("terminal: an unknown key of a curve file is answered with what was meant") {
  const Workshop here;
  here.write("points.json", R"({"phrame": "curve/1", "points": [[0, 0, 0], [1, 0, 0]]})");
  check_failure(here.run("info points.json"), 2,
                "unknown key \"points\"; the nearest known key is \"control_points\"");
  here.write("odd.json", R"({"phrame": "curve/1", "radii": [1, 2]})");
  check_failure(here.run("info odd.json"), 2, "unknown key \"radii\"; the keys are phrame, name,");
}

TEST_CASE("terminal: blanks in lists, and quotients of decimals") {
  const Workshop here;
  const Run plain = here.run("angle quintic.json --at 0,1/2,3/5 --digits 20 --print json");
  check_success(plain);
  CHECK(here.run("angle quintic.json --at '0, 1/2 , 1.5/2.5' --digits ' 20' --print json").out ==
        plain.out);
  CHECK(here.run("frames quintic.json --at 0,1 --frame 'rmf, erf'").out ==
        here.run("frames quintic.json --at 0,1 --frame rmf,erf").out);
  CHECK(here.run("mtf quintic.json --from-vector '0, 0, 1' --to 1").out ==
        here.run("mtf quintic.json --from-vector 0,0,1 --to 1").out);
  check_failure(here.run("angle quintic.json --at 0.5/0.0"), 2,
                "--at: \"0.5/0.0\" divides by zero");
  check_failure(here.run("angle quintic.json --at 1/2/3"), 2, "--at: \"1/2/3\" is not a number");
}

TEST_CASE("terminal: minus signs may be U+2212, which the reports have; not in files") {
  const Workshop here;
  const std::vector<std::pair<std::string, std::string>> calls{
      {"angle quintic.json --at −1/2,−0.25 --theta0 −31pi/40",
       "angle quintic.json --at=-1/2,-0.25 --theta0=-31pi/40"},
      {"mtf quintic.json --from −pi/8 --to-vector 1,−2,3 --turns −1 --unproved",
       "mtf quintic.json --from=-pi/8 --to-vector 1,-2,3 --turns=-1 --unproved"},
      {"compile quintic.json --from −1 --to 2", "compile quintic.json --from=-1 --to 2"}};
  for (const auto& pair : calls) {
    const auto& [call, plain] = pair;
    CAPTURE(pair.first);
    const Run run = here.run(call);
    check_success(run);
    CHECK(run.out == here.run(plain).out);
  }
  here.write("minus.json", R"({"phrame": "curve/1", "basis": "power",
                               "preimage": {"u": [1], "v": ["−1"], "p": [0], "q": [0]}})");
  check_failure(here.run("info minus.json"), 2, "is not a number");
}

TEST_CASE("terminal: an empty text is not the same as an option that is not there") {
  const Workshop here;
  REQUIRE(here.run("frames quintic.json --samples 3 -o frames.csv").status == 0);
  const std::vector<std::pair<std::string, std::string>> complaints{
      {"compile quintic.json --prefix ''", "--prefix: \"\" is not a letter"},
      {"check quintic.json frames.csv --theta0 ''", "--theta0: \"\" is not an angle"},
      {"check quintic.json frames.csv --quaternion ''", "--quaternion: \"\" is not one of"},
      {"mtf quintic.json --from '' --to 1", "--from: \"\" is not an angle"},
      {"mtf quintic.json --from '' --from-vector 0,0,1 --to 1", "--from: the angle is given twice"},
      {"mtf quintic.json --from 0 --to 1 --subdivide ''", "--subdivide: \"\" is not one of"},
      {"batch --skip-done ''", "--skip-done: \"\" is not a file's name"}};
  for (const auto& pair : complaints) {
    CAPTURE(pair.first);
    check_failure(here.run(pair.first), 2, pair.second);
  }
}

// θ(1) = 0.28585653009834106200165… (2003 paper) and π = 3.14159265358979323846264…
TEST_CASE("terminal: angles are radians, multiples of pi and degrees") {
  const Workshop here;
  const auto theta = [&](const std::string& start) {
    const Run run =
        here.run("angle quintic.json --at 0,1 --digits 20 --print json --theta0 " + start);
    check_success(run);
    return Json::parse(run.out);
  };
  const Json quarter = theta("pi/4");
  CHECK(quarter["theta0"] == "pi/4");
  CHECK(quarter["values"][0]["theta"] == "0.78539816339744830962");
  CHECK(quarter["values"][1]["theta"] == "1.0712546934957893716");
  CHECK(theta("45deg") == quarter);
  CHECK(theta("' 45 deg '") == quarter);
  CHECK(theta("0.25pi") == quarter);
  const Json negative = theta("-31pi/40");
  CHECK(negative["theta0"] == "-31pi/40");
  CHECK(negative["values"][0]["theta"] == "-2.4347343065320897598");
  CHECK(theta("1/2")["theta0"] == "1/2");
  CHECK(contains(here.run("angle quintic.json --theta0 -pi/2").out, "θ(0) = −π/2\n"));
  CHECK(contains(here.run("angle quintic.json --theta0 pi/3 --print latex").out,
                 "\\theta(0) &= \\frac{\\pi}{3}"));
  check_failure(here.run("angle quintic.json --theta0 pie"), 2,
                "--theta0: \"pie\" is not an angle such as pi/8, -31pi/40, 45deg or");
  CHECK(contains(here.run("compile quintic.json --start erf --theta0 45deg").out,
                 "theta(0) = pi/4."));
  REQUIRE(here.run("frames quintic.json --samples 3 -o frames.csv").status == 0);
  const Run turned = here.run("check quintic.json frames.csv --theta0 pi/2");
  CHECK(turned.status == 1);
  CHECK(contains(turned.out, "1.57"));
  CHECK(here.run("mtf quintic.json --from 30deg --to 90deg").out ==
        here.run("mtf quintic.json --from pi/6 --to pi/2").out);
}

// A = 1 + ti: r′ = (1 + t²)(1, 0, 0), a straight line whose ERF turns, h = 1 and θ = −2 arctan t,
// θ(1) = −π/2.
TEST_CASE("terminal: a multiple of pi that cancels the angle leaves an exact number") {
  const Workshop here;
  here.write("turning.json", R"({"phrame": "curve/1", "basis": "power",
                                 "preimage": {"u": [1], "v": [0, 1], "p": [0], "q": [0]}})");
  const Run exact = here.run("angle turning.json --at 0,1,-1 --theta0 pi/2 --print json");
  check_success(exact);
  const Json values = Json::parse(exact.out)["values"];
  CHECK(values[1]["theta"] == "0");
  CHECK(values[1]["radius"] == "0");
  CHECK(values[2]["theta"] == "3.1415926535897932");
  // Two such segments, and a start that cancels both; compiled, too.
  here.write("two.json", R"({"phrame": "spline/1", "segments": [
      {"basis": "power", "preimage": {"u": [1], "v": [0, 1], "p": [0], "q": [0]}},
      {"basis": "power", "preimage": {"u": [1], "v": [0, 1], "p": [0], "q": [0]}}]})");
  const Run both = here.run("angle two.json --at 2 --theta0 180deg --print json");
  check_success(both);
  CHECK(Json::parse(both.out)["values"][0]["theta"] == "0");
  // The second segment is straight and does not turn: its angle is 0 throughout.
  here.write("straight.json", R"({"phrame": "spline/1", "segments": [
      {"basis": "power", "preimage": {"u": [1], "v": [0, 1], "p": [0], "q": [0]}},
      {"basis": "power", "preimage": {"u": [1], "v": [0], "p": [0], "q": [0]}}]})");
  check_success(here.run("compile straight.json --theta0 pi/2"));
}

TEST_CASE("terminal: the ending of -o chooses the format, and is refused where there is none") {
  const Workshop here;
  const std::string frames = "frames quintic.json --samples 3";
  for (const char* ending : {"svg", "pdf", "txt", "xlsx", "3mf"}) {
    check_failure(here.run(frames + " -o x." + ending), 2,
                  "phrame: --output: \"x." + std::string(ending) + "\": \"." + ending +
                      "\" is no format of frames; --format csv writes csv there");
    CHECK_FALSE(fs::exists(here.file(std::string("x.") + ending)));
  }
  for (const char* format : {"csv", "json", "npy"}) {
    const std::string file = std::string("x.") + format;
    CHECK(here.run(frames + " -o " + file).status == 0);
    CHECK(bytes_of(here.file(file)) == here.run(frames + " --format " + format).out);
  }
  CHECK(here.run(frames + " --format csv -o x.svg").status == 0);
  CHECK(bytes_of(here.file("x.svg")) == here.run(frames).out);
  CHECK(here.run(frames + " -o run.1").status == 0);  // no ending but a number
  CHECK(here.run("info quintic.json -o info.json").status == 0);
  CHECK(bytes_of(here.file("info.json")) == here.run("info quintic.json --print json").out);
  CHECK(here.run("angle quintic.json -o angle.tex").status == 0);
  CHECK(bytes_of(here.file("angle.tex")) == here.run("angle quintic.json --print latex").out);
  check_failure(here.run("info quintic.json -o info.py"), 2, "is no format of info");
  for (const std::string command : {"info", "totals", "classify", "identify"}) {
    CHECK(here.run(command + " quintic.json -o answer.tex").status == 0);
    CHECK(bytes_of(here.file("answer.tex"))
              .starts_with(command == "identify" ? "$r' = f" : "\\begin{align*}\n"));
  }
  CHECK(contains(here.run("mtf quintic.json --from 0 --to 1 --print latex").out,
                 "\n\\text{twist $T$} &\\approx "));
  check_failure(here.run("info quintic.json --print latex --full"), 2,
                "--full: needs --print text");
}

TEST_CASE("terminal: help, by command") {
  const Workshop here;
  CHECK(here.run("help").out == here.run("--help").out);
  for (const std::string& name : names_of_commands(here)) {
    CAPTURE(name);
    const Run help = here.run("help " + name);
    check_success(help);
    CHECK(help.out == here.run(name + " --help").out);
    CHECK(contains(help.out, "Examples:\n  phrame " + name));
    CHECK(contains(here.run("--help").out, "\n  " + name + " "));
    std::istringstream lines(help.out);
    for (std::string line; std::getline(lines, line);) CHECK(line.size() <= 110);
  }
  check_failure(here.run("help angle info"), 2, "\"info\" is one argument too many");
}

TEST_CASE("terminal: help is as wide as the terminal, and says the same at each width") {
  const Workshop here;
  const auto words = [](const std::string& text) {
    std::istringstream in(text);
    return std::vector<std::string>(std::istream_iterator<std::string>(in), {});
  };
  for (const std::string command : {"", "angle", "sweep"}) {
    const std::string plain = output_of(here, "phrame help " + command);
    for (const std::size_t width : {40UL, 60UL, 80UL, 110UL}) {
      CAPTURE(width);
      const std::string text =
          output_of(here, fmt::format("COLUMNS={} phrame help {}", width, command));
      CHECK(words(text) == words(plain));
      std::istringstream lines(text);
      // What stands behind two blanks in the notes, such as an example, is in one line always.
      for (std::string line; std::getline(lines, line) && line != "Examples:";)
        CHECK((text_width(line) <= width || line.starts_with("  {") || line.starts_with("   \"")));
    }
  }
}

TEST_CASE("terminal: no colours in files, nor with NO_COLOR; with CLICOLOR_FORCE anywhere") {
  const Workshop here;
  const std::string plain = output_of(here, "phrame help angle");
  CHECK_FALSE(contains(plain, "\033"));
  const std::string coloured = output_of(here, "CLICOLOR_FORCE=1 phrame help angle");
  CHECK(contains(coloured, "\n\033[1;34mOptions:\033[0m\n"));
  CHECK(std::regex_replace(coloured, std::regex("\033\\[[0-9;]*m"), "") == plain);
  CHECK(output_of(here, "NO_COLOR=1 CLICOLOR_FORCE=1 phrame help angle") == plain);
  CHECK(output_of(here, "CLICOLOR_FORCE=1 phrame angel 2>&1 || true")
            .starts_with("\033[1;31mphrame:\033[0m \"angel\" is not a command"));
}

TEST_CASE("terminal: a manual page for the program and for each command") {
  const Workshop here;
  const Run program = here.run("man");
  check_success(program);
  long pages = 0;
  for (const std::string& name : names_of_commands(here)) {
    CAPTURE(name);
    const Run page = here.run("man " + name);
    check_success(page);
    CHECK(page.out.starts_with(".TH \"PHRAME\\-"));
    for (const char* section : {"NAME", "SYNOPSIS", "OPTIONS", "EXAMPLES", "EXIT STATUS"})
      CHECK(contains(page.out, std::string("\n.SH ") + section + "\n"));
    CHECK(contains(program.out, "phrame\\-" + name + " (1)"));
    // Every other one is enough for every day.
    if (pages++ % everyday(2, 1) != 0 || !has_program("groff")) continue;
    here.write("page", page.out);
    const std::string read =
        output_of(here, "groff -man -Kutf8 -ww -Tutf8 page 2> warnings | col -bx");
    CHECK(bytes_of(here.file("warnings")) == "");  // every one is one too many
    CHECK(contains(read, "phrame " + name));
  }
  check_failure(here.run("man nothing"), 2, "COMMAND: \"nothing\" is not one of angle,");
}

TEST_CASE("terminal: help and manual pages say which options do not go together") {
  const Workshop here;
  long found = 0;
  const Json program = Json::parse(here.run("help --json").out);
  for (const Json& command : program["commands"]) {
    const std::string name = command["command"];
    CAPTURE(name);
    for (const std::string& page : std::vector{name + " --help", "man " + name}) {
      std::string text = here.run(page).out;
      std::erase(text, '\\');  // roff's
      std::replace(text.begin(), text.end(), '\n', ' ');
      for (const Json& option : command["options"]) {
        if (option["without"].empty()) continue;
        ++found;
        const std::string last = option["without"].back();
        // Several options may begin their sentences alike.
        const std::string first = "Not with " + option["without"][0].get<std::string>();
        bool is_said = false;
        for (auto at = text.find(first); at != std::string::npos; at = text.find(first, at + 1)) {
          const std::string sentence = text.substr(at, text.find('.', at) - at);
          is_said = is_said || (contains(sentence, last + ":") &&
                                contains(sentence, option["names"].back().get<std::string>()));
        }
        CHECK(is_said);
      }
    }
  }
  CHECK(found > 16);
}

TEST_CASE("terminal: bash completes commands, options, names, lists and files") {
  const Workshop here;
  if (!has_program("bash")) return;
  const auto completed = [&](const std::string& line) {
    return output_of(here, "source <(phrame completion bash)\nCOMP_WORDS=(" + line +
                               ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_phrame\n"
                               "(IFS=' '; echo \"${COMPREPLY[*]}\")\n");
  };
  CHECK(completed("phrame ang") == "angle\n");
  CHECK(completed("phrame in") == "info interpolate integrate\n");
  CHECK(completed("phrame angle quintic.json --di") == "--digits\n");
  CHECK(completed("phrame angle quintic.json --frame ''") == "erf frenet up\n");
  CHECK(completed("phrame angle --frame = f") == "frenet\n");
  CHECK(completed("phrame frames --frame rmf,mtf") == "rmf,mtf rmf,mtf-exact\n");
  CHECK(completed("phrame mtf c.json --subdivide ''") == "inflections extrema auto\n");
  CHECK(completed("phrame frames c.json --subdivide 1/2,e") == "1/2,extrema\n");
  CHECK(completed("phrame angle qu") == "quintic.json\n");
  CHECK(completed("phrame angle quintic.json -o qu") == "quintic.json\n");
  CHECK(completed("phrame angle quintic.json --at ''") == "\n");
  CHECK(completed("phrame help cer") == "certify\n");
  // Each option of each command.
  const Json program = Json::parse(here.run("help --json").out);
  for (const Json& command : program["commands"]) {
    const std::string all =
        " " + completed("phrame " + command["command"].get<std::string>() + " --");
    for (const Json& option : command["options"]) {
      const std::string name = option["names"].back();
      if (option["argument"] == true) continue;
      CHECK(contains(all.substr(0, all.size() - 1) + " ", " " + name + " "));
    }
  }
}

TEST_CASE("terminal: zsh and fish read their scripts") {
  const Workshop here;
  if (has_program("zsh")) {
    here.write("_phrame", here.run("completion zsh").out);
    CHECK(output_of(here,
                    "zsh -f -c 'autoload -U compinit; compinit -u -D; source ./_phrame;"
                    " [[ $_comps[phrame] == _phrame ]] && echo defined'") == "defined\n");
  }
  if (has_program("fish")) {
    here.write("phrame.fish", here.run("completion fish").out);
    const auto completed = [&](const std::string& line) {
      return output_of(here, "HOME=$PWD fish --no-config -c 'source phrame.fish; complete -C \"" +
                                 line + "\"' | cut -f 1 | sort | tr '\\n' ' '");
    };
    CHECK(completed("phrame ang") == "angle ");
    CHECK(completed("phrame angle --frame ") == "erf frenet ");
    CHECK(contains(completed("phrame frames --frame rmf,m"), "rmf,mtf-exact "));
    CHECK(completed("phrame angle --dig") == "--digits ");
  }
}
