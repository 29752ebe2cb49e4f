// Rows of tables of frames: by t, by arc length, as CSV; beside them what no table of these rows
// can do without, their text of numbers that are there, and a compiled frame at a double.
#include <benchmark/benchmark.h>

#include "curves.hpp"
#include "phrame/answer/frame_rows.hpp"
#include "phrame/answer/interpolation.hpp"
#include "phrame/io/write/row_format.hpp"

namespace phrame::inline v0::bench {
namespace {

using State = benchmark::State;
constexpr long row_count = 20'001;

std::vector<Rational> shares_of(const Rational& end) {
  std::vector<Rational> numbers;
  for (long k = 0; k < row_count; ++k) numbers.push_back(end * Rational(k, row_count - 1));
  return numbers;
}

/// All rows, those that doubles are not enough for exactly; f(row) is called for each.
template <class F>
void for_rows(FrameRows& rows, const F& f) {
  std::vector<std::vector<double>> made(FrameRows::block);
  for (std::size_t first = 0; first < rows.size(); first += made.size()) {
    const auto block = std::span(made).first(std::min(made.size(), rows.size() - first));
    for (const std::size_t k : rows.near(first, block)) block[k - first] = rows.exact(k).values;
    for (const std::vector<double>& row : block) f(row);
  }
}

const TableColumns& rmf_columns() {
  static const TableColumns columns{{TabulatedFrame::rmf}};
  return columns;
}

template <class F>
void rows_by_t(State& state, const F& f) {
  const Path path(random_curve(state.range(0)));
  const PathAngle angle(path);
  FrameRows rows(angle, rmf_columns(), RowPlaces(shares_of(1), [path](const Rational& t) {
                   return Place(locate(path, t));
                 }));
  for (auto _ : state) for_rows(rows, f);
  state.SetItemsProcessed(state.iterations() * row_count);
}

void near_rows_by_t(State& state) {
  rows_by_t(state, [](const std::vector<double>& row) { benchmark::DoNotOptimize(row.data()); });
}

void csv_rows_by_t(State& state) {
  std::string text;
  rows_by_t(state, [&](const std::vector<double>& row) {
    text.clear();
    csv_rows().append(text, row);
    benchmark::DoNotOptimize(text.data());
  });
}

void near_rows_by_length(State& state) {
  const Path path(random_curve(state.range(0)));
  const PathAngle angle(path);
  const PathLength length(path);
  FrameRows rows(angle, rmf_columns(), RowPlaces(shares_of(*length.total().exact()), length));
  for (auto _ : state)
    for_rows(rows, [](const std::vector<double>& row) { benchmark::DoNotOptimize(row.data()); });
  state.SetItemsProcessed(state.iterations() * row_count);
}

/// Whole tables, all that is compiled included.
void interpolated_rows(State& state) {
  const NamedPath named{"", Path(random_curve(state.range(0)))};
  const Rational period = *PathLength(named.path).total().exact() / row_count;
  const InterpolationQuery query{{RationalFunction(Polynomial{1})}, period};
  for (auto _ : state) benchmark::DoNotOptimize(answer(named, query));
  state.SetItemsProcessed(state.iterations() * row_count);
}

/// Unavoidable: the text of the same numbers.
void csv_of_given_rows(State& state) {
  std::vector<double> row;
  for (int k = 1; k <= 13; ++k) row.push_back(1.0 / (k + 0.1));
  std::string text;
  for (auto _ : state) {
    text.clear();
    csv_rows().append(text, row);
    benchmark::DoNotOptimize(text.data());
  }
  state.SetItemsProcessed(state.iterations());
}

/// Unavoidable: one compiled frame at a double.
void compiled_frame_at_double(State& state) {
  const Curve curve = random_curve(state.range(0));
  const CompiledFrames frames(curve, RmfAngle(curve, Reference::euler_rodrigues), 0, 1);
  double t = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(frames.rounded(t));
    t = t < 0.99 ? t + 0.0011 : 0;
  }
  state.SetItemsProcessed(state.iterations());
}

}  // namespace

BENCHMARK(near_rows_by_t)->Name("rows/by_t")->Arg(2)->Arg(20)->Unit(benchmark::kMillisecond);
BENCHMARK(near_rows_by_length)
    ->Name("rows/by_arc_length")
    ->Arg(2)
    ->Arg(20)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(csv_rows_by_t)->Name("rows/by_t_as_csv")->Arg(2)->Unit(benchmark::kMillisecond);
BENCHMARK(interpolated_rows)
    ->Name("rows/interpolated")
    ->Arg(2)
    ->Arg(20)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(csv_of_given_rows)->Name("rows/unavoidable_csv");
BENCHMARK(compiled_frame_at_double)->Name("rows/unavoidable_frame")->Arg(2);

}  // namespace phrame::bench
