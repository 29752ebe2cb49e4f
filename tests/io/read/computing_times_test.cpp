#include "phrame/io/read/computing_times.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/error.hpp"

using namespace phrame;

TEST_CASE("computing_times: names with folders and commas, quotes, comments and line ends") {
  const auto times = computing_times(
      "\xEF\xBB\xBF# of a laptop\r\nname,seconds\r\n\r\n51/tame-01,1.5e-3\r\n\"a,b\", \"1/4\"\n"
      "idle,0");
  REQUIRE(times.size() == 3);
  CHECK(times.at("51/tame-01").seconds == Rational(3, 2000));
  CHECK(times.at("51/tame-01").line == 4);
  CHECK(times.at("a,b").seconds == Rational(1, 4));
  CHECK(times.at("idle").seconds == 0);
  CHECK(computing_times("name,seconds\n").empty());
}

TEST_CASE("computing_times: what is no time is refused with its line") {
  const auto place_of = [](const char* text) {
    try {
      computing_times(text);
    } catch (const InputError& error) {
      return error.place();
    }
    return std::string("none");
  };
  CHECK(place_of("") == "line 1");
  CHECK(place_of("tame-01,1\n") == "line 1");
  CHECK(place_of("name,seconds\n\ntame-01,-1e-9\n") == "line 3");
  CHECK(place_of("name,seconds\ntame-01,nan\n") == "line 2");
  CHECK(place_of("name,seconds\ntame-01,\n") == "line 2");
  CHECK(place_of("name,seconds\ntame-01\n") == "line 2");
  CHECK(place_of("name,seconds\na,1\nb,1\na,1\n") == "line 4");
}
