// Each stage twice after a warm-up, in a function of its own, for callgrind to count; names the
// stages in their order:
//   phrame_instructions [M [NAME FILE]...]...
// of each size M in turn, with a stage of that name for each curve file. Without M, what it was
// built by.
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "../curves.hpp"
#include "phrame/cli/batch_line.hpp"

namespace {

using namespace phrame;

constexpr int repetitions = 2;

/// A line of a batch, θ(1) to 17 digits.
std::function<void()> batch_line(const std::string& curve) {
  return
      [line = R"({"id": 1, "at": [1], "curve": )" + curve + "}"] { cli::batch_answer(line, {}); };
}

std::string text_of(const char* path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

/// What is counted, by this name.
extern "C" [[gnu::noinline]] void counted(const std::function<void()>& stage) {
  for (int k = 0; k < repetitions; ++k) stage();
}

namespace {

void count_stages(long m, const std::vector<std::pair<const char*, std::string>>& curves) {
  const std::string text = bench::random_curve_text(m);
  const Curve curve = bench::random_curve(m);
  RmfAngle angle(curve, Reference::euler_rodrigues);
  CompiledAngle compiled(angle, 0, 1);
  const CompiledFrames compiled_frames(curve, angle, 0, 1);
  const Path any = bench::bezier_path(m + 1);
  long k = 0;
  const auto other = [&k] { return static_cast<double>(++k) / 1009; };
  std::vector<std::pair<const char*, std::function<void()>>> stages{
      // From the text of a curve file to the checked antiderivative.
      {"symbolic",
       [&] { RmfAngle(read_curve(text).curve, Reference::euler_rodrigues).antiderivative(); }},
      // θ(1) to 50 digits, roots isolated anew.
      {"first-value",
       [&] {
         Evaluator evaluator(angle.angle_to_erf(), angle.rate());
         round_to_decimal(evaluator.value(0, 1), 50);
       }},
      // θ as a double at other and other t.
      {"value", [&] { round_to_double(angle.value(Rational(++k, 1009))); }},
      // Nine components of the frame as doubles.
      {"frame",
       [&] {
         const auto frame = rotation_minimizing_frame(curve, angle, Rational(++k, 1009));
         for (const auto& e : {frame.e1, frame.e2, frame.e3}) round_to_double(e);
       }},
      // The same by what is compiled.
      {"compiled-value", [&] { compiled(other()); }},
      {"compiled-frame", [&] { compiled_frames(other()); }},
      // All questions of a kind, witnesses checked.
      {"classify", [&] { classify(curve); }},
      // θ(1) to 17 digits of a curve of degree m + 1 by its control points, no PH curve.
      {"any-curve",
       [&] {
         round_to_decimal(PathAngle(any).value({0, Rational(1)}), 17);
       }},
      {"batch-line", batch_line(text)},
  };
  for (const auto& [name, curve_text] : curves) stages.emplace_back(name, batch_line(curve_text));
  for (const auto& [name, stage] : stages) {
    stage();
    counted(stage);
    std::puts(name);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 1) std::puts(PHRAME_BUILT_BY);
  for (int i = 1; i < argc;) {
    const long m = std::atol(argv[i++]);
    std::vector<std::pair<const char*, std::string>> curves;
    for (; i + 1 < argc && std::isdigit(argv[i][0]) == 0; i += 2)
      curves.emplace_back(argv[i], text_of(argv[i + 1]));
    count_stages(m, curves);
  }
}
