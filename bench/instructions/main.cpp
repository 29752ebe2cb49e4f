// One stage, ten times after a warm-up, in a function of its own, for callgrind to count:
//   phrame_instructions STAGE M
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "../curves.hpp"
#include "phrame/cli/batch_line.hpp"

namespace {

using namespace phrame;

constexpr int repetitions = 10;

}  // namespace

/// What is counted, by this name.
extern "C" [[gnu::noinline]] void counted(const std::function<void()>& stage) {
  for (int k = 0; k < repetitions; ++k) stage();
}

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const long m = std::atol(argv[2]);
  const std::string text = bench::random_curve_text(m);
  const Curve curve = bench::random_curve(m);
  RmfAngle angle(curve, Reference::euler_rodrigues);
  CompiledAngle compiled(angle, 0, 1);
  const CompiledFrames compiled_frames(curve, angle, 0, 1);
  long k = 0;
  const auto other = [&k] { return static_cast<double>(++k) / 1009; };
  const std::map<std::string, std::function<void()>> stages{
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
      // A line of a batch, θ(1) to 17 digits.
      {"batch-line",
       [&] { cli::batch_answer(R"({"id": 1, "at": [1], "curve": )" + text + "}", {}); }},
  };
  const auto stage = stages.find(argv[1]);
  if (stage == stages.end()) return 2;
  stage->second();
  counted(stage->second);
}
