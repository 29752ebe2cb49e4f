// Lines of `phrame batch`: the angle θ(1) of a random curve of preimage degree m; one thread.
#include <benchmark/benchmark.h>

#include "curves.hpp"
#include "phrame/cli/batch_line.hpp"

namespace phrame::inline v0::bench {
namespace {

void batch(benchmark::State& state, const std::string& more) {
  const std::string line =
      R"({"id": 1, "at": [1], )" + more + R"("curve": )" + random_curve_text(state.range(0)) + "}";
  for (auto _ : state) benchmark::DoNotOptimize(cli::batch_answer(line, {}));
  state.SetItemsProcessed(state.iterations());
}
void batch_17_digits(benchmark::State& state) { batch(state, ""); }
void batch_50_digits(benchmark::State& state) { batch(state, R"("digits": 50, )"); }
void batch_17_digits_values_only(benchmark::State& state) {
  batch(state, R"("values_only": true, )");
}

BENCHMARK(batch_17_digits)->Arg(2)->Arg(10);
BENCHMARK(batch_50_digits)->Arg(2)->Arg(10);
BENCHMARK(batch_17_digits_values_only)->Arg(2)->Arg(10);

}  // namespace
}  // namespace phrame::bench
