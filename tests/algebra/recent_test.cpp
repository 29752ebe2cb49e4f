#include "phrame/algebra/recent.hpp"

#include <doctest/doctest.h>

#include <stdexcept>
#include <thread>
#include <vector>

using namespace phrame;

TEST_CASE("recent: the last values are kept, those before are made again") {
  Recent<int> recent(3);
  int made = 0;
  const auto at = [&](std::size_t k) {
    return *recent.get(k, [&] { return ++made, static_cast<int>(10 * k); });
  };
  for (const std::size_t k : {0UL, 1UL, 2UL, 0UL, 1UL, 2UL})
    CHECK(at(k) == static_cast<int>(10 * k));
  CHECK(made == 3);
  CHECK(at(3) == 30);  // in the place of 0
  CHECK(at(2) == 20);
  CHECK(made == 4);
  const std::shared_ptr<const int> held = recent.get(1, [] { return -1; });
  CHECK(at(0) == 0);
  CHECK(at(1) == 10);
  CHECK(made == 6);
  CHECK(*held == 10);
}

TEST_CASE("recent: what throws is no value, and threads get what was made") {
  Recent<int> recent(64);
  CHECK_THROWS_AS(recent.get(5, []() -> int { throw std::runtime_error("not yet"); }),
                  std::runtime_error);
  CHECK(*recent.get(5, [] { return 7; }) == 7);
  std::vector<std::thread> threads;
  std::vector<int> wrong(4);
  for (int& count : wrong)
    threads.emplace_back([&] {
      for (std::size_t round = 0; round < 2000; ++round)
        for (const std::size_t k : {round % 100, (7 * round) % 100})
          if (*recent.get(k + 100, [&] { return static_cast<int>(k); }) != static_cast<int>(k))
            ++count;
    });
  for (std::thread& thread : threads) thread.join();
  CHECK(wrong == std::vector<int>(4));
}
