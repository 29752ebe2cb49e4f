// Runs every benchmark five times, shows the medians, and closes with a table of what phrame takes
// beside what FLINT and Arb alone take. Options of Google Benchmark come after ours and win, e.g.
//   phrame_bench --benchmark_filter='erf_.*/20$' --benchmark_repetitions=20
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace {

class MedianReporter : public benchmark::ConsoleReporter {
 public:
  MedianReporter() : ConsoleReporter(OO_None) {}

  void ReportRuns(const std::vector<Run>& runs) override {
    std::vector<Run> shown;
    for (const Run& run : runs) {
      if (run.aggregate_name != "median" && (run.repetitions > 1 || run.error_occurred)) continue;
      shown.push_back(run);
      shown.back().run_type = Run::RT_Iteration;  // no suffix to the name
      shown.back().run_name.repetitions.clear();
      if (const auto error = run.counters.find("error"); error != run.counters.end())
        errors_[{run.run_name.function_name, run.run_name.args}] = error->second;
      milliseconds_[{run.run_name.function_name, run.run_name.args}] =
          1e3 * run.GetAdjustedCPUTime() / benchmark::GetTimeUnitMultiplier(run.time_unit);
    }
    if (!shown.empty()) ConsoleReporter::ReportRuns(shown);
  }

  void Finalize() override {
    table("erf");
    table("frenet");
    targets();
    against_double_reflection();
    growth({"erf_symbolic", "erf_value", "erf_from_scratch", "roots_of_sigma"});
  }

 private:
  /// CPU time in ms, NaN where it was not measured.
  double time(const std::string& name, const std::string& m) const {
    const auto at = milliseconds_.find({name, m});
    return at == milliseconds_.end() ? std::nan("") : at->second;
  }

  void table(const std::string& frame) const {
    std::printf("\n%s, CPU ms\n%3s %10s %10s %6s %10s %10s %6s %10s\n", frame.c_str(), "m",
                "symbolic", "FLINT", "ratio", "value", "roots", "ratio", "scratch");
    for (const char* m : {"1", "2", "3", "5", "10", "20", "40", "80", "200"}) {
      const double symbolic = time(frame + "_symbolic", m);
      const double flint = time(frame + "_flint", m);
      const double value = time(frame + "_value", m);
      const double roots = time("roots_alone", m);
      const double scratch = time(frame + "_from_scratch", m);
      if (std::isnan(symbolic) && std::isnan(value)) continue;
      std::printf("%3s %10.4f %10.4f %6.2f %10.4f %10.4f %6.2f %10.4f\n", m, symbolic, flint,
                  symbolic / flint, value, roots, value / roots, scratch);
    }
  }

  /// What we want to reach, in ms, and beside it what FLINT and Arb, or doubles without a proof,
  /// alone take for what cannot be left out, where there is such a thing.
  void targets() const {
    struct Target {
      const char* what;
      std::string name;
      std::string m;
      double limit;
      double unavoidable;
    };
    const double nan = std::nan("");
    const double quintic = time("erf_flint", "2") + time("roots_alone", "2");
    const double angle = 1.0 / 2'000, frame = 1.0 / 500;
    const std::vector<Target> all{
        {"all roots, degree 400", "roots_of_sigma", "200", 2'000, time("values_at_roots", "200")},
        {"all roots, degree 1000", "roots_of_sigma", "500", 30'000, time("values_at_roots", "500")},
        {"batch, a quintic to 17 digits", "batch_17_digits", "2", 1.0 / 5, quintic},
        {"batch, a quintic to 50 digits", "batch_50_digits", "2", 1, quintic},
        {"compiled angle, quintic", "compiled_angle", "2", angle, nan},
        {"compiled angle, degree 41", "compiled_angle", "20", 3 * angle, nan},
        {"compiled frame, quintic", "compiled_frame", "2", frame, nan},
        {"compiled frame, degree 41", "compiled_frame", "20", 3 * frame, nan},
        {"angle by a header, quintic", "header_angle", "", 2e-5, nan},
        {"angle of a spline, 1000 points", "points_angle", "1000", 50,
         time("points_angle_doubles", "1000")},
        {"angle of a spline, 10 000 points", "points_angle", "10000", 500,
         time("points_angle_doubles", "10000")},
        {"info of 1000 PH segments", "ph_spline_info", "1000", 300, nan},
        {"minimal twist, not proved", "rational_twist_frame", "", 0.2, nan},
        {"minimal twist, proved to 12 digits", "rational_twist_frame_proved_12", "", 10, nan}};
    bool is_first = true;
    for (const Target& target : all) {
      const double reached = time(target.name, target.m);
      if (std::isnan(reached)) continue;
      if (std::exchange(is_first, false))
        std::printf("\n%-36s %12s %12s %8s %20s\n", "targets, CPU ms", "target", "reached", "share",
                    "ratio to that alone");
      std::printf("%-36s %12.6g %12.6g %7.1f%%", target.what, target.limit, reached,
                  100 * reached / target.limit);
      if (!std::isnan(target.unavoidable)) std::printf(" %20.2f", reached / target.unavoidable);
      std::printf("\n");
    }
  }

  /// N steps along the same curve.
  void against_double_reflection() const {
    const std::string numerical = "steps_by_double_reflection";
    for (const std::string name : {"steps_by_header", "steps_by_compiled_frames"})
      for (const char* steps : {"100", "1000", "100000"}) {
        const double ratio = time(name, steps) / time(numerical, steps);
        if (std::isnan(ratio)) continue;
        std::printf("\n%s, N = %s: %.2f times the time of double reflection, %.2g times its error",
                    name.c_str(), steps, ratio,
                    errors_.at({name, steps}) / errors_.at({numerical, steps}));
      }
    std::printf("\n");
  }

  /// The slope of the line through log time over log m, m ≥ 5, by least squares.
  void growth(const std::vector<std::string>& names) const {
    for (const std::string& name : names) {
      double n = 0, x = 0, y = 0, xx = 0, xy = 0;
      for (const auto& [run, ms] : milliseconds_) {
        if (run.first != name || std::stol(run.second) < 5) continue;
        const double u = std::log(std::stod(run.second));
        const double v = std::log(ms);
        n += 1, x += u, y += v, xx += u * u, xy += u * v;
      }
      if (n >= 3)
        std::printf("\n%s grows like m^%.2f", name.c_str(), (n * xy - x * y) / (n * xx - x * x));
    }
    std::printf("\n");
  }

  using Name = std::pair<std::string, std::string>;  ///< of the function, and its arguments
  std::map<Name, double> milliseconds_;
  std::map<Name, double> errors_;  ///< where they were counted
};

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> defaults{"--benchmark_repetitions=5", "--benchmark_min_time=0.1"};
  std::vector<char*> arguments{argv[0]};
  for (std::string& option : defaults) arguments.push_back(option.data());
  arguments.insert(arguments.end(), argv + 1, argv + argc);
  int count = static_cast<int>(arguments.size());
  arguments.push_back(nullptr);
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
  MedianReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  benchmark::Shutdown();
}
