#include <filesystem>
#include <map>

#include "cli/workshop.hpp"

using namespace phrame;
using namespace phrame::test;

// Of commands with several formats an ending chooses one. All commands are tried that have -o.
TEST_CASE("endings: those that mean another format are refused, and nothing is written") {
  const Workshop here;
  here.write("points.csv", "x,y,z\n0,0,0\n1,1,0\n2,1,1\n");
  here.write("lines.jsonl", "");
  REQUIRE(here.run("certify quintic.json --at 1 -o angle.cert").status == 0);
  REQUIRE(here.run("frames quintic.json --samples 3 -o frames.csv").status == 0);
  const std::map<std::string, std::string> wrong{
      {"angle quintic.json", "glb"},
      {"info quintic.json", "h"},
      {"classify quintic.json", "csv"},
      {"totals quintic.json", "npy"},
      {"frames quintic.json --samples 2", "nc"},
      {"mtf quintic.json --from 0 --to 1", "obj"},
      {"interpolate quintic.json --feed 1 --period 1", "glb"},
      {"construct points.csv", "csv"},
      {"identify quintic.json", "html"},
      {"integrate 1/x", "npy"},
      {"sweep quintic.json --profile circle:1/9", "py"},
      {"offset quintic.json --distance 1", "csv"},
      {"envelope axis.json", "csv"},
      {"transform quintic.json", "csv"},
      {"batch lines.jsonl", "csv"},
      {"compile quintic.json", "py"},
      {"check quintic.json frames.csv", "v"},
      {"certify quintic.json", "tex"},
      {"reference", "csv"},
      {"verify angle.cert", "json"},
      {"prove quintic.json", "JSON"},
      {"page quintic.json", "pdf.json"}};
  std::size_t with_output = 0;
  const Json program = Json::parse(here.run("help --json").out);
  for (const Json& command : program["commands"])
    for (const Json& option : command["options"])
      if (option["names"].back() == "--output") ++with_output;
  CHECK(wrong.size() == with_output);
  for (const auto& one : wrong) {
    const auto& call = one.first;
    const auto& end = one.second;
    CAPTURE(call);
    const std::string name = call.substr(0, call.find(' '));
    check_failure(here.run(call + " -o out." + end), 2, " is no format of " + name);
    CHECK_FALSE(std::filesystem::exists(here.file("out." + end)));
  }
}

// What no command writes is refused as well, of those with one format, too.
TEST_CASE("endings: formats of others are refused") {
  const Workshop here;
  here.write("lines.jsonl", "");
  for (const std::string call : {"page quintic.json", "compile quintic.json",
                                 "certify quintic.json", "prove quintic.json", "batch lines.jsonl"})
    for (const std::string end : {"pdf", "PDF", "svg", "png", "docx", "md", "xlsx", "zip"}) {
      CAPTURE(call);
      const std::string name = call.substr(0, call.find(' '));
      check_failure(here.run(call + " -o out." + end), 2,
                    "--output: \"out." + end + "\": \"." + (end == "PDF" ? "pdf" : end) +
                        "\" is no format of " + name + ", which writes ");
      CHECK_FALSE(std::filesystem::exists(here.file("out." + end)));
    }
}

// Endings of any form: with digits first, or signs. Only digits are no ending.
TEST_CASE("endings: one that begins with a digit is an ending") {
  const Workshop here;
  const std::string sweep = "sweep quintic.json --profile circle:1/9 -o out.";
  for (const std::string end : {"3mf", "3MF", "7z", "obj~", "c++", "obj1_", "2d.3ds"}) {
    check_failure(here.run(sweep + end), 2, " is no format of sweep");
    CHECK_FALSE(std::filesystem::exists(here.file("out." + end)));
  }
  check_failure(here.run("compile quintic.json -o out.3mf"), 2, "\".3mf\" is no format of compile");
  CHECK(here.run(sweep + "5").status == 0);
}

TEST_CASE("endings: others are anybody's") {
  const Workshop here;
  for (const std::string call :
       {"compile quintic.json -o arm.h", "compile quintic.json -o arm.inc",
        "certify quintic.json -o a.cert", "certify quintic.json -o a.json",
        "certify quintic.json -o a.txt", "prove quintic.json -o a.v", "prove quintic.json -o a"})
    CHECK(here.run(call).status == 0);
}
