#include "phrame/algebra/time_limit.hpp"

#include <doctest/doctest.h>

#include <thread>

#include "phrame/algebra/out_of_memory.hpp"
#include "phrame/algebra/polynomial.hpp"

using namespace phrame;

TEST_CASE("time limit: a computation in FLINT is stopped, and what is computed next is right") {
  throw_when_out_of_memory();
  Polynomial power{1, 3};
  const auto square_for_ever = [&] {
    for (;;) static_cast<void>(pow(power, 300) * pow(power, 200));
  };
  {
    const TimeLimit limit(0.02);
    CHECK_THROWS_AS(square_for_ever(), Stopped);
    CHECK_THROWS_AS(square_for_ever(), Stopped);  // whoever has caught it goes no further
  }
  CHECK(pow(power, 300) * pow(power, 200) == pow(power, 500));
}

TEST_CASE("time limit: of its thread only, as long as it lives") {
  {
    const TimeLimit limit(0.02);
    CHECK_THROWS_AS(for (;;) require_time(), Stopped);
    std::thread([] { require_time(); }).join();
  }
  require_time();
}
