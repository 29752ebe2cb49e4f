#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "io/reference.hpp"
#include "phrame/ph/along/parametrization.hpp"

// tests/data/programs.json: files that other programs wrote, and points of them by these.
namespace programs_test {

using namespace phrame;
using test::Json;

namespace {

ParameterKind kind_of(const std::string& name) {
  return name == "native"     ? ParameterKind::native
         : name == "fraction" ? ParameterKind::fraction
                              : ParameterKind::t;
}

}  // namespace

TEST_CASE("files of other programs are the curves that these say") {
  std::size_t files = 0;
  for (const Json& entry : Json::parse(test::read_data("programs.json"))) {
    const std::string file = entry["file"];
    const std::string program = entry["program"];
    CAPTURE(file);
    CAPTURE(program);
    FileReading reading;
    reading.pick = entry.value("pick", "");
    reading.kind = entry.value("kind", "");
    CurveLimits limits;
    if (entry.contains("gap")) limits.gap = parse_rational(entry["gap"].get<std::string>());
    const double within = entry.value("within", 1e-14);
    const NamedPath named = read_any_path(test::read_data("programs/" + file), limits, reading);
    const Parametrization by(named, kind_of(entry["by"]));
    for (std::size_t k = 0; k < entry["at"].size(); ++k) {
      const Place at = by.point(exact_rational(entry["at"][k].get<double>())).at;
      const Vector<Real> r = position(named.path, at);
      for (std::size_t c = 0; c < 3; ++c) {
        const double wanted = entry["points"][k][c];
        CHECK(std::abs(round_to_double(r[c]) - wanted) <= within * std::max(1.0, std::abs(wanted)));
      }
    }
    if (entry.contains("length"))
      CHECK(round_to_double(PathLength(named.path).total()) ==
            doctest::Approx(entry["length"].get<double>()).epsilon(within));
    if (entry.value("closed", false)) CHECK(named.path.is_closed());
    ++files;
  }
  CHECK(files >= 40);
}

}  // namespace programs_test
