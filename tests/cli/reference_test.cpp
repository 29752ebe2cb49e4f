#include <nlohmann/json.hpp>

#include "cli/workshop.hpp"

using namespace phrame;
using namespace phrame::test;

namespace reference_test {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

}  // namespace

TEST_CASE("reference: the collection is found, listed, and read by a batch as it is") {
  const Workshop here;
  const Run all = here.run("reference");
  check_success(all);
  const auto lines = lines_of(all.out);
  CHECK(lines.size() > 300);
  const auto list = lines_of(here.run("reference --list").out);
  CHECK(list.size() == lines.size() + 1);
  CHECK(here.run("reference --group rational-frames,plane -o some.jsonl").status == 0);
  const Run batch = here.run("batch some.jsonl --question totals --digits 50");
  check_success(batch);
  const auto some = lines_of(bytes_of(here.file("some.jsonl")));
  const auto answers = lines_of(batch.out);
  REQUIRE(answers.size() == some.size());
  for (std::size_t k = 0; k < some.size(); k += 5) {
    const auto curve = nlohmann::json::parse(some[k]);
    const auto length = nlohmann::json::parse(answers[k])["length"];
    CHECK((length.is_object() ? length["value"] : length) == curve["expected"]["length"]);
  }
  check_failure(here.run("reference --group wild"), 2, "--group: \"wild\" is not one of bezier, ");
  check_failure(here.run("reference tame-1"), 2, "NAME: \"tame-1\" is no curve of it");
  CHECK(nlohmann::json::parse(here.run("reference tame-01").out)["name"] == "tame-01");
}

TEST_CASE("reference: the tables of values have writhes and signed Frenet frames") {
  const Workshop here;
  for (const std::string name : {"knots-01", "signed-frenet-01"}) {
    CHECK(here.run("reference " + name + " --export " + name + " --samples 2").status == 0);
    const auto expected = nlohmann::json::parse(here.run("reference " + name).out)["expected"];
    const auto total = cells_of(lines_of(bytes_of(here.file(name + "/totals.csv")))[1]);
    CHECK(total.back() == expected.value("writhe", ""));
    const auto row = cells_of(lines_of(bytes_of(here.file(name + "/values.csv")))[3]);
    const bool is_frenet = expected.contains("signed_frenet");
    CHECK(row[24] ==
          (is_frenet ? expected["signed_frenet"]["frames"][2][0].get<std::string>() : ""));
    CHECK(row.back() ==
          (is_frenet ? expected["signed_frenet"]["curvature"][2].get<std::string>() : ""));
  }
}

// At t = 0, 1/3, 1/2 and 1, of which the collection has 50 digits.
TEST_CASE("reference: what is exported are the doubles nearest to the values") {
  const Workshop here;
  const std::string groups = "--group tame,minimal-twist,plane-offsets --samples 7,3";
  CHECK(here.run("reference --export out " + groups).status == 0);
  const auto curves = lines_of(bytes_of(here.file("out/curves.jsonl")));
  CHECK(lines_of(bytes_of(here.file("out/totals.csv"))).size() == curves.size() + 1);
  CHECK(lines_of(bytes_of(here.file("out/values.csv"))).size() == 4 * curves.size() + 1);
  for (std::size_t k = 0; k < curves.size(); k += 9) {
    const auto curve = nlohmann::json::parse(curves[k]);
    const std::string name = curve["name"];
    CAPTURE(name);
    CHECK(nlohmann::json::parse(bytes_of(here.file("out/curves/" + name + ".json"))) == curve);
    CHECK(fs::exists(here.file("out/frames/3/" + name + ".npy")));
    const auto table = lines_of(bytes_of(here.file("out/frames/7/" + name + ".csv")));
    REQUIRE(table.size() == 8);
    const std::size_t rows[] = {1, 3, 4, 7};
    for (std::size_t i = 0; i < 4; ++i) {
      const auto cells = cells_of(table[rows[i]]);
      REQUIRE(cells.size() == 13);
      for (std::size_t j = 0; j < 12; ++j)
        CHECK(std::strtod(cells[j + 1].c_str(), nullptr) ==
              std::strtod(curve["expected"]["frames"][i][j].get<std::string>().c_str(), nullptr));
    }
  }
  check_failure(here.run("reference --export out " + groups), 2, "out: is there already");
  check_failure(here.run("reference --export . --group tame"), 2, ".: is there already");
  check_failure(here.run("reference --export x --samples 1"), 2,
                "--samples: \"1\" is no whole number from 2 to 100000");
  check_failure(here.run("reference --export line.json/x --group plane"), 2, "line.json/x: ");
  CHECK(here.names() ==
        std::vector<std::string>{"inflected.json", "line.json", "out", "quintic.json"});
}

// theta_erf is computed by quadrature in another program, too (docs/reference.md).
TEST_CASE("reference: certificates claim the values of the collection, and are accepted") {
  const Workshop here;
  CHECK(here.run("reference tame-01 --export out --samples 2 --certificates").status == 0);
  const std::string file = "out/certificates/tame-01.json";
  const auto expected = nlohmann::json::parse(here.run("reference tame-01").out)["expected"];
  const auto claims = nlohmann::json::parse(bytes_of(here.file(file)))["claims"];
  REQUIRE(claims.size() == expected["at"].size());
  for (std::size_t k = 0; k < claims.size(); ++k) {
    CHECK(claims[k]["t"] == expected["at"][k]);
    CHECK(claims[k]["theta"] == expected["theta_erf"][k]);
  }
  check_success(here.run("verify " + file + " --curve out/curves/tame-01.json"));
  // Angles that are 0, by the symmetry of the curve.
  const Run closed = here.run("reference closed-03 --export closed --samples 2 --certificates");
  CHECK(closed.status == 0);
  CHECK(closed.err.empty());
  const std::string other = "closed/certificates/closed-03.json";
  const auto symmetric = nlohmann::json::parse(bytes_of(here.file(other)))["claims"];
  REQUIRE(symmetric.size() == 4);
  CHECK(symmetric[3] ==
        nlohmann::json::parse(R"({"t": "1", "theta": "0", "radius": "0", "symmetry": "mirror"})"));
  check_success(here.run("verify " + other));
  check_failure(here.run("reference tame-01 --certificates"), 2, "--certificates: ");
  CHECK(here.run("reference tame-01 --export plain --samples 2").status == 0);
  CHECK_FALSE(fs::exists(here.file("plain/certificates")));
}

}  // namespace reference_test
