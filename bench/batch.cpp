// Lines of `phrame batch`: the angle θ(1) of a random curve of preimage degree m; one thread.
#include <benchmark/benchmark.h>

#include "curves.hpp"
#include "phrame/io/batch.hpp"

namespace phrame::inline v0::bench {
namespace {

void batch(benchmark::State& state, long digits, bool values_only) {
  const std::string line =
      R"({"id": 1, "at": [1], "curve": )" + random_curve_text(state.range(0)) + "}";
  BatchDefaults defaults;
  defaults.digits = digits;
  defaults.values_only = values_only;
  for (auto _ : state) benchmark::DoNotOptimize(batch_answer(line, defaults));
  state.SetItemsProcessed(state.iterations());
}
void batch_17_digits(benchmark::State& state) { batch(state, 17, false); }
void batch_50_digits(benchmark::State& state) { batch(state, 50, false); }
void batch_17_digits_values_only(benchmark::State& state) { batch(state, 17, true); }

BENCHMARK(batch_17_digits)->Arg(2)->Arg(10);
BENCHMARK(batch_50_digits)->Arg(2)->Arg(10);
BENCHMARK(batch_17_digits_values_only)->Arg(2)->Arg(10);

}  // namespace
}  // namespace phrame::bench
