#include "phrame/cli/batch_line.hpp"
#include "phrame/answer/angle.hpp"
#include "phrame/io/write/answers.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "io/reference.hpp"
#include "support/data.hpp"
#include "support/random.hpp"

namespace batch_line_test {

using namespace phrame;
using namespace phrame::cli;
using test::Json;

namespace {

using Options = std::vector<std::pair<std::string, std::string>>;

/// What holds for lines that say nothing else.
BatchDefaults with(const Options& options) { return {{"angle", options}}; }

Json quintic() {
  return {{"basis", "bernstein"},
          {"name", "quintic"},
          {"preimage", test::farouki_2003()["quintic"]["bernstein"]}};
}

Json answer(const Json& line, const BatchDefaults& defaults = {}) {
  const BatchAnswer found = batch_answer(line.dump(), defaults);
  CHECK(found.line.find('\n') == std::string::npos);
  const Json parsed = Json::parse(found.line);
  CHECK(found.is_failure == parsed.contains("error"));
  return parsed;
}

/// What a line is known by that may have an answer.
std::optional<std::string> batch_id(std::string_view line) {
  std::optional<std::string> found;
  BatchDefaults defaults;
  defaults.is_done = [&found](const std::string& id) {
    found = id;
    return true;
  };
  const bool is_left_out = batch_answer(line, defaults).line.empty();
  CHECK(is_left_out == found.has_value());
  return found;
}

void check_error(const std::string& line, int status, const std::string& message) {
  CAPTURE(line);
  const BatchAnswer found = batch_answer(line, {});
  CAPTURE(found.line);
  CHECK(found.is_failure);
  const Json error = Json::parse(found.line)["error"];
  CHECK(error["status"] == status);
  CHECK(error["message"].get<std::string>().find(message) != std::string::npos);
}

}  // namespace

TEST_CASE("batch: an answer is what the report of the same curve says, with the id") {
  for (const auto reference : {Reference::euler_rodrigues, Reference::frenet}) {
    const Json found =
        answer({{"id", "a\"7"},
                {"curve", quintic()},
                {"frame", reference == Reference::euler_rodrigues ? "erf" : "frenet"},
                {"at", {"1/2", 1, 0.25}},
                {"digits", 40},
                {"theta0", "1/3"}});
    Json file = quintic();
    file["phrame"] = "curve/1";
    AngleQuery query;
    query.reference = reference;
    query.start = Angle(Rational(1, 3));
    query.at = {Rational(1, 2), 1, Rational(1, 4)};
    query.digits = 40;
    Json expected = Json::parse(to_json(phrame::answer(read_path(file.dump()), query)));
    expected["id"] = "a\"7";
    CHECK(found == expected);
  }
}

TEST_CASE("batch: what a line leaves out is the default") {
  CHECK(answer({{"curve", quintic()}})["values"].empty());
  CHECK(answer({{"curve", quintic()}})["id"] == nullptr);
  const BatchDefaults defaults =
      with({{"--frame", "frenet"}, {"--at", "1"}, {"--digits", "30"}, {"--values-only", "true"}});
  const Json found = answer({{"id", 1e300}, {"curve", quintic()}}, defaults);
  CHECK(found["id"] == 1e300);
  CHECK(found["frame"] == "frenet");
  CHECK(found["values"][0]["theta"].get<std::string>().size() >= 31);
  CHECK_FALSE(found.contains("antiderivative"));
  CHECK(answer({{"curve", quintic()}, {"at", "1/3"}}, defaults)["values"][0]["t"] == "1/3");
}

TEST_CASE("batch: a frame starts at an angle or along a vector") {
  const auto error = [](const Json& more) {
    Json line = {{"id", 1}, {"curve", quintic()}};
    line.update(more);
    return answer(line)["error"];
  };
  CHECK(error({{"theta0", "0"}, {"start_normal", {0, 0, 1}}})["message"] ==
        "/start_normal: does not apply with --theta0");
  CHECK(error({{"start_normal", {2, 2, 1}}})["message"] ==
        "/start_normal: the vector (2, 2, 1) has no part in the normal plane: it is along the "
        "tangent");
  CHECK(error({{"start_normal", {2, 2}}})["status"] == 2);
  const BatchDefaults defaults = with({{"--start-normal", "2,2,1"}});
  const Json refused = answer({{"curve", quintic()}}, defaults)["error"];
  CHECK(refused["status"] == 2);
  CHECK(refused["message"] ==
        "--start-normal: the vector (2, 2, 1) has no part in the normal plane: it is along the "
        "tangent");
  CHECK(answer({{"curve", quintic()}, {"theta0", 1}}, defaults)["theta0"] == "1");
}

TEST_CASE("batch: a curve may stand for one that is no PH curve") {
  // A cubic with thirds in doubles, and a parabola.
  const Json cubic = {{"control_points",
                       {{0, 0, 0},
                        {0.3333333333333333, 0, 0},
                        {0.6666666666666666, 0.3333333333333333, 0},
                        {0.6666666666666666, 1, 0}}}};
  const Json parabola = {{"control_points", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}}};
  CHECK(answer({{"curve", cubic}})["frame"] == "up");
  const BatchDefaults defaults = with({{"--near", "1e-15"}});
  const Json found = answer({{"curve", cubic}}, defaults);
  CHECK(found["near"]["epsilon"] == "1/1000000000000000");
  CHECK(parse_rational(found["near"]["distance"].get<std::string>()) <= parse_rational("1e-15"));
  CHECK_FALSE(answer({{"curve", quintic()}}, defaults).contains("near"));
  CHECK(answer({{"curve", parabola}}, defaults)["error"]["message"].get<std::string>().starts_with(
      "/curve: no PH curve was found within 1e-15; the nearest one is 0."));
  Json bare = cubic;
  bare["phrame"] = "curve/1";
  bare["name"] = "bare";
  CHECK(answer(bare, defaults)["id"] == "bare");
  CHECK(answer({{"curve", {{"phrame", "spline/1"}, {"segments", {cubic}}}}}, defaults)
            .contains("near"));
}

// −∫ τ ds by mpmath's quad; n and b are the frame of v at both ends of this cubic.
TEST_CASE("batch: what is no PH curve is answered by angles to the frame of v, or Frenet's") {
  const Json cubic = {{"control_points", {{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 3}}}};
  const Json up =
      answer({{"id", 7}, {"curve", cubic}, {"up", {0, 0, 1}}, {"at", 1}, {"digits", 30}});
  CHECK(up["id"] == 7);
  CHECK(up["phrame"] == "angle/1");
  CHECK(up["frame"] == "up");
  CHECK(up["closed_form"].is_null());
  CHECK(up["values"][0]["theta"] == "-1.65740642390110110987772706379");
  const Json frenet = answer({{"curve", cubic}, {"frame", "frenet"}, {"theta0", "1"}, {"at", 1}});
  CHECK(frenet["frame"] == "frenet");
  CHECK(frenet["values"][0]["theta"] == "-0.65740642390110111");
  const Json spline =
      answer({{"curve", {{"phrame", "points/1"}, {"points", {{0, 0, 0}, {1, 2, 0}, {3, 1, 1}}}}}});
  CHECK(spline["phrame"] == "spline-angle/1");
  const auto line = [&](const char* key, const Json& value, const Json& curve) {
    return Json({{"curve", curve}, {key, value}}).dump();
  };
  check_error(line("frame", "erf", cubic), 2, "/frame: \"erf\" needs a Pythagorean-hodograph");
  check_error(line("frame", "other", cubic), 2, "/frame: \"other\" is not one of erf, frenet, up");
  check_error(line("up", {0, 0, 0}, cubic), 2, "/up: the up vector is 0");
  check_error(line("up", {1, 0, 0}, cubic), 2, "/up: the up vector (1, 0, 0) is along the tangent");
  check_error(line("start_normal", {2, 0, 0}, cubic), 2, "/start_normal: ");
  CHECK(answer(Json::parse(line("frame", "up", quintic())))["frame"] == "up");
}

TEST_CASE("batch: splines") {
  Json elsewhere = quintic();
  elsewhere["start"] = {9, 9, 9};
  const Json path = {{"phrame", "spline/1"}, {"segments", {quintic(), elsewhere}}};
  CHECK(answer({{"curve", path}})["error"]["status"] == 2);
  std::ifstream file(test::root("/examples/curves/closed-spline.json"));
  const Json four = Json::parse(file);
  const Json found = answer({{"id", 3}, {"curve", four}, {"at", {4}}, {"digits", 20}});
  CHECK(found["phrame"] == "spline-angle/1");
  CHECK(found["id"] == 3);
  CHECK(found["segments"].size() == 4);
  CHECK(found["values"][0]["theta"] == found["total"]["value"]);
  CHECK(answer({{"curve", four}, {"frame", "frenet"}})["error"]["status"] == 3);
  // A spline of one curve is this curve.
  const Json one = {
      {"phrame", "spline/1"}, {"name", "quintic"}, {"segments", Json::array({quintic()})}};
  CHECK(answer({{"curve", one}, {"at", {2}}}) == answer({{"curve", quintic()}, {"at", {2}}}));
}

TEST_CASE("batch: a line may be a bare curve or spline, its name being the id") {
  Json curve = quintic();
  curve["phrame"] = "curve/1";
  curve["family"] = "seed";
  curve["expected"] = {{"theta_erf_1", "0.2"}};
  const BatchDefaults defaults = with({{"--at", "1/2"}});
  const Json found = answer(curve, defaults);
  CHECK(found == answer({{"id", "quintic"}, {"curve", curve}}, defaults));
  CHECK(found["id"] == "quintic");
  CHECK(batch_id(curve.dump()) == "\"quintic\"");
  curve.erase("name");
  CHECK(answer(curve)["id"] == nullptr);
  CHECK(batch_id(curve.dump()) == std::nullopt);
  const Json path = {{"phrame", "spline/1"}, {"segments", Json::array({quintic()})}};
  CHECK(answer(path)["phrame"] == "angle/1");
  // Complaints have the places of the line itself, and an answer is no curve.
  check_error(
      R"({"phrame": "curve/1", "basis": "power", "preimage": {"u": ["1/0"], "v": [0], "p": [0], "q": [0]}})",
      2, "/preimage/u/0: ");
  check_error(R"({"phrame": "angle/1", "id": 1})", 2, "/phrame: the format is");
  check_error(R"({"phrame": "curve/1", "curve": 1})", 2, "unknown key \"phrame\"");
  CHECK(answered_id(answer(path).dump()) == "null");
  // Questions and other objects are no answers, errors are.
  CHECK(answered_id(R"({"id":8,"curve":0})") == std::nullopt);
  CHECK(answered_id(R"({"id":8})") == std::nullopt);
  CHECK(answered_id(batch_answer(R"({"id": 8, "curve": 0})", {}).line) == "8");
  // The answer to a spline has a name and an id; the id counts.
  CHECK(batch_id(R"({"id":null,"phrame":"spline-angle/1","name":"x"})") == std::nullopt);
}

TEST_CASE("batch: every line of tests/data/curves.jsonl is a line of a batch") {
  const BatchDefaults defaults = with({{"--at", "1"}, {"--digits", "30"}});
  std::istringstream lines(test::read_data("curves.jsonl"));
  int count = 0;
  for (std::string line; std::getline(lines, line);) {
    const Json curve = Json::parse(line);
    if (curve["preimage"]["u"].size() > 9) continue;  // quick ones
    ++count;
    CAPTURE(curve["name"].get<std::string>());
    const Json found = Json::parse(batch_answer(line, defaults).line);
    CHECK(found["id"] == curve["name"]);
    const Json& value = found["values"][0];
    test::check_rounded(value["theta"], value["radius"], curve["expected"]["theta_erf_1"], 30, 60);
  }
  CHECK(count > 50);
}

TEST_CASE("batch: a failure has the status that the program would have, and the place") {
  const std::string line =
      R"({"basis": "power", "preimage": {"u": [1], "v": [0], "p": [0], "q": [0]}})";
  check_error("", 2, "not valid JSON: the input is empty");
  check_error("{bad", 2, "column 2: not valid JSON: ");
  check_error("{}\r{}\r", 2, "a carriage return alone ends none)");
  check_error("{bad\r", 2, "each line is a JSON object by itself)");
  check_error("[1]", 2, "/: an object is wanted");
  check_error(R"({"id": 1})", 2, "the key \"curve\" is missing");
  check_error(R"({"id": 1, "spline": {}})", 2, "a spline stands at the key \"curve\", too");
  check_error(R"({"id": [1], "curve": )" + line + "}", 2, "/id: an id is a string or a number");
  check_error(
      R"({"curve": {"basis": "power", "preimage": {"u": ["1/0"], "v": [0], "p": [0], "q": [0]}}})",
      2, "/curve/preimage/u/0: ");
  check_error(R"({"frame": "bishop", "curve": )" + line + "}", 2,
              "/frame: \"bishop\" is not one of erf, frenet");
  check_error(R"({"digits": 1.5, "curve": )" + line + "}", 2,
              "/digits: \"1.5\" is not a whole number");
  check_error(R"({"at": ["x"], "curve": )" + line + "}", 2, "/at: \"x\" is not a number");
  check_error(R"({"att": [1], "curve": )" + line + "}", 2, "the nearest known key is \"at\"");
  check_error(R"({"frame": "frenet", "curve": )" + line + "}", 3, "straight line");
  CHECK(Json::parse(batch_answer(R"({"id": 8, "curve": 0})", {}).line)["id"] == 8);
}

TEST_CASE("batch: ids of lines and of answers") {
  CHECK(batch_id(R"({"id": "x", "curve": 1})") == "\"x\"");
  CHECK(batch_id(R"({"curve": 1, "id": 10})") == "10");
  CHECK(batch_id(R"({"curve": 1})") == std::nullopt);
  CHECK(batch_id(R"({"id": nul)") == std::nullopt);
  CHECK(batch_id(batch_answer(R"({"id": "ü"})", {}).line) == batch_id(R"({"id": "ü"})"));
}

TEST_CASE("batch: law: several threads give the answers that one gives") {
  std::vector<std::string> lines;
  test::for_samples(30, [&](test::Random& random) {
    const auto list = [&](long degree) {
      Json coefficients = Json::array();
      for (long k = 0; k <= degree; ++k) coefficients.push_back(to_string(random.rational()));
      return coefficients;
    };
    Json preimage;
    for (const char* name : {"u", "v", "p", "q"}) preimage[name] = list(random.integer(0, 6));
    lines.push_back(Json{{"id", lines.size()},
                         {"curve", {{"basis", "power"}, {"preimage", preimage}}},
                         {"frame", random.integer(0, 1) == 0 ? "erf" : "frenet"},
                         {"at", {"1/3", 1}},
                         {"digits", random.integer(10, 60)}}
                        .dump());
  });
  std::vector<std::string> expected;
  for (const std::string& line : lines) expected.push_back(batch_answer(line, {}).line);
  std::vector<std::vector<std::string>> found(4, std::vector<std::string>(lines.size()));
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < found.size(); ++k)
    threads.emplace_back([&lines, &mine = found[k], k] {
      for (std::size_t j = 0; j < lines.size(); ++j) {
        const std::size_t at = (j + k * lines.size() / 4) % lines.size();
        mine[at] = batch_answer(lines[at], {}).line;
      }
      release_caches();  // of this thread
    });
  for (std::thread& thread : threads) thread.join();
  for (const auto& answers : found) CHECK(answers == expected);
}

}  // namespace batch_line_test
