#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "phrame/io/read/curve_file.hpp"
#include "phrame/ph/frame/frame_start.hpp"

namespace phrame {

/// What a line of a batch may leave out.
struct BatchDefaults {
  Reference frame = Reference::euler_rodrigues;
  std::vector<Rational> at;
  long digits = 17;
  bool values_only = false;  ///< answers without integrand and antiderivative
  CurveLimits limits;
  FrameStart start = Angle();
  std::optional<double> seconds = {};  ///< that a line may take; its answer is then an error
  std::optional<Rational> near = {};   ///< so far away may be the curve that stands for no PH curve
  /// Is there an answer to the line with this id, as JSON text? It is then left out.
  std::function<bool(const std::string& id)> is_done = {};
  std::string question = "angle";  ///< of a line without it
  /// Answers other questions, and angles that are asked for with more keys, by a JSON object in one
  /// line; it may throw a Failure. Without it there are none.
  std::function<std::string(const JsonNode& line)> otherwise = {};
};

struct BatchAnswer {
  std::string line;  ///< without its end; empty where it is left out
  bool is_failure;
  std::string complaint = {};  ///< why, as in the line
};

/// The answer to a line
///   {"id": …, "curve": {…}, "frame": "erf", "at": ["1"], "digits": 17, "theta0": "0"},
/// with "start_normal": ["0", "0", "1"] instead of "theta0", and of what is no PH curve with
/// "frame" "up" or "frenet" and "up": ["0", "0", "1"], of which all but the curve (in a format of
/// phrame, as read_any_path() reads them) may be left out, or to a line that is a bare curve or
/// spline, whose id is its name: an object angle/1 or spline-angle/1 with the same "id", or {"id":
/// …, "error": {"status": 2, "message": "…"}}, the status being the program's exit status for the
/// same curve. With a key "question" that is not "angle", what is answered otherwise. Depends on
/// nothing but the line, and may be called from several threads. Throws nothing but bad_alloc.
BatchAnswer batch_answer(std::string_view line, const BatchDefaults& defaults);

/// The id of an answer, errors included, "null" where it has none; no value where the line is no
/// answer.
std::optional<std::string> answered_id(std::string_view line);

}  // namespace phrame
