// Lines of `phrame batch`: the angle θ(1) of a random curve of preimage degree m, and of cubics
// that are no PH curves; one thread. Beside them what is not to be avoided: to read the lines as
// JSON.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <random>

#include "curves.hpp"
#include "phrame/cli/batch_line.hpp"
#include "phrame/io/read/json_value.hpp"

namespace phrame::inline v0::bench {
namespace {

using State = benchmark::State;
using Lines = std::vector<std::string>;

Lines random_line(long m, const std::string& more = "") {
  return {R"({"id": 1, "at": [1], )" + more + R"("curve": )" + random_curve_text(m) + "}"};
}

/// By control points of six decimals, in no PH curve's places.
Lines random_cubics() {
  std::mt19937_64 engine(1);
  std::uniform_int_distribution<long> number(-5'000'000, 5'000'000);
  const auto coordinate = [&] { return static_cast<double>(number(engine)) / 1e6; };
  Lines lines;
  for (int k = 0; k < 64; ++k) {
    std::string points;
    for (int j = 0; j < 4; ++j)
      points += fmt::format("{}[{}, {}, {}]", j == 0 ? "" : ", ", coordinate(), coordinate(),
                            coordinate());
    lines.push_back(
        fmt::format(R"({{"id": 1, "at": [1], "curve": {{"control_points": [{}]}}}})", points));
  }
  return lines;
}

void answer_all(State& state, const Lines& lines) {
  std::size_t k = 0;
  for (auto _ : state) benchmark::DoNotOptimize(cli::batch_answer(lines[k++ % lines.size()], {}));
  state.SetItemsProcessed(state.iterations());
}
void read_all(State& state, const Lines& lines) {
  std::size_t k = 0;
  for (auto _ : state) benchmark::DoNotOptimize(parse_json(lines[k++ % lines.size()]));
  state.SetItemsProcessed(state.iterations());
}

void batch_17_digits(State& state) { answer_all(state, random_line(state.range(0))); }
void batch_50_digits(State& state) {
  answer_all(state, random_line(state.range(0), R"("digits": 50, )"));
}
void batch_17_digits_values_only(State& state) {
  answer_all(state, random_line(state.range(0), R"("values_only": true, )"));
}
void batch_reading(State& state) { read_all(state, random_line(state.range(0))); }
void batch_cubics(State& state) { answer_all(state, random_cubics()); }
void batch_cubics_reading(State& state) { read_all(state, random_cubics()); }

BENCHMARK(batch_17_digits)->Arg(2)->Arg(10);
BENCHMARK(batch_50_digits)->Arg(2)->Arg(10);
BENCHMARK(batch_17_digits_values_only)->Arg(2)->Arg(10);
BENCHMARK(batch_reading)->Arg(2)->Arg(10);
BENCHMARK(batch_cubics);
BENCHMARK(batch_cubics_reading);

}  // namespace
}  // namespace phrame::bench
