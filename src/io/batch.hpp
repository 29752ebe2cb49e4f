#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "phrame/io/read/curve_file.hpp"
#include "phrame/ph/frame/frame_start.hpp"

namespace phrame::inline v0 {

/// What holds for the lines of a batch that do not say otherwise.
struct BatchDefaults {
  Reference frame = Reference::euler_rodrigues;
  std::vector<Rational> at;
  long digits = 17;
  bool values_only = false;  ///< answers without integrand and antiderivative
  CurveLimits limits;
  FrameStart start = Angle();
  std::optional<double> seconds = {};  ///< the time limit of a line, whose answer is then an error
  /// A curve that is not PH is replaced by a PH curve at most so far away.
  std::optional<Rational> near = {};
  /// Has the line with this id, given as JSON text, been answered before? Then it is left out.
  std::function<bool(const std::string& id)> is_done = {};
  std::string question = "angle";  ///< of a line without the key "question"
  /// Answers other questions than "angle", and angles that are asked for with further keys, as a
  /// JSON object in one line. It may throw a Failure. Without it such lines are refused.
  std::function<std::string(const JsonNode& line)> otherwise = {};
};

struct BatchAnswer {
  std::string line;  ///< without its end; empty where it is left out
  bool is_failure;
  std::string complaint = {};  ///< why it failed, as the line says
};

/// Answers a line
///   {"id": …, "curve": {…}, "frame": "erf", "at": ["1"], "digits": 17, "theta0": "0"},
/// of which all but the curve may be left out. "start_normal": ["0", "0", "1"] may stand for
/// "theta0". Of a curve that is not PH, "frame" is "up" or "frenet", and "up": ["0", "0", "1"] is
/// v. The curve is in a format of phrame, as read_any_path() reads it. A line may also be the curve
/// or spline by itself; its name is the id then. The answer is an object angle/1 or spline-angle/1
/// with the same "id", or {"id": …, "error": {"status": 2, "message": "…"}}, where the status is
/// the exit status of the program for the same curve. A line whose "question" is not "angle" is
/// answered by `otherwise`. Depends on nothing but the line, and may be called from several
/// threads. Throws nothing but bad_alloc.
BatchAnswer batch_answer(std::string_view line, const BatchDefaults& defaults);

/// The id of an answer, errors included, "null" where it has none; no value where the line is no
/// answer.
std::optional<std::string> answered_id(std::string_view line);

}  // namespace phrame
