#include "phrame/algebra/shared.hpp"

#include <doctest/doctest.h>

#include <stdexcept>
#include <thread>
#include <vector>

using namespace phrame;

TEST_CASE("lazy: a value is made once for all copies, and not by a call that throws") {
  const Lazy<int> lazy;
  const Lazy<int> copy = lazy;  // NOLINT(performance-unnecessary-copy-initialization)
  int made = 0;
  CHECK_THROWS_AS(lazy.get([]() -> int { throw std::runtime_error("not yet"); }),
                  std::runtime_error);
  CHECK(copy.get([&] { return ++made; }) == 1);
  CHECK(lazy.get([&] { return ++made; }) == 1);
  CHECK(&lazy.get([&] { return ++made; }) == &copy.get([&] { return ++made; }));
  CHECK(made == 1);
}

TEST_CASE("lazy: of several threads one makes the value") {
  const Lazy<int> lazy;
  int made = 0;  // by one at a time
  std::vector<std::thread> threads;
  std::vector<int> seen(4);
  for (int& value : seen)
    threads.emplace_back([&, copy = lazy] { value = copy.get([&] { return ++made; }); });
  for (std::thread& thread : threads) thread.join();
  CHECK(made == 1);
  CHECK(seen == std::vector{1, 1, 1, 1});
}

TEST_CASE("refined: what is known is refined where more is asked for, and only then") {
  const Refined<long> refined;
  const Refined<long> copy = refined;  // NOLINT(performance-unnecessary-copy-initialization)
  std::vector<long> refinements;
  const auto ask = [&](const Refined<long>& of, long bits) {
    return *of.get(bits, [&](const long* known) {
      refinements.push_back(known == nullptr ? 0 : *known);
      return bits;
    });
  };
  CHECK(refined.known() == nullptr);
  CHECK(ask(refined, 10) == 10);
  CHECK(ask(copy, 5) == 10);
  CHECK(ask(copy, 20) == 20);
  CHECK(ask(refined, 20) == 20);
  CHECK(*refined.known() == 20);
  CHECK(refinements == std::vector<long>{0, 10});
  CHECK_THROWS_AS(refined.get(30, [](const long*) -> long { throw std::runtime_error("no"); }),
                  std::runtime_error);
  CHECK(*refined.known() == 20);
}

TEST_CASE("refined: what was handed out stays when more becomes known") {
  const Refined<std::vector<int>> refined;
  const auto first = refined.get(1, [](const auto*) { return std::vector{1}; });
  refined.get(2, [](const auto*) { return std::vector{1, 2}; });
  CHECK(*first == std::vector{1});
}
