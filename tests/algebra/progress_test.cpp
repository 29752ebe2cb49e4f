#include "phrame/algebra/progress.hpp"

#include <doctest/doctest.h>

#include <thread>
#include <vector>

using namespace phrame;

TEST_CASE("progress: of loops in loops the first is heard") {
  CHECK_FALSE(current_progress());
  {
    Stage rows("rows", 3);
    for (int k = 0; k < 2; ++k) {
      Stage inner("segments", 100);
      inner.advance();
      rows.advance();
    }
    const auto progress = current_progress();
    REQUIRE(progress);
    CHECK(progress->what == "rows");
    CHECK(progress->done == 2);
    CHECK(progress->all == 3);
  }
  CHECK_FALSE(current_progress());
  const Stage next("segments", 5);
  CHECK(current_progress()->what == "segments");
  CHECK(current_progress()->done == 0);
}

TEST_CASE("progress: threads share a stage") {
  constexpr long steps = 1000;
  Stage stage("rows", 4 * steps);
  std::vector<std::thread> threads;
  for (int n = 0; n < 4; ++n)
    threads.emplace_back([&stage] {
      const Stage unheard("segments", 1);
      for (long k = 0; k < steps; ++k) stage.advance();
    });
  for (std::thread& thread : threads) thread.join();
  CHECK(current_progress()->what == "rows");
  CHECK(current_progress()->done == 4 * steps);
}
