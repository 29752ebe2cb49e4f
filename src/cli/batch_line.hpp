#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "phrame/cli/question.hpp"

namespace phrame::inline v0::cli {

/// What holds for the lines of a batch that do not say otherwise.
struct BatchDefaults {
  QuestionDefaults question = {default_question, {}};
  std::optional<double> seconds = {};  ///< the time limit of a line, whose answer is then an error
  /// Has the line with this id, given as JSON text, been answered before? Then it is left out.
  std::function<bool(const std::string& id)> is_done = {};
};

struct BatchAnswer {
  std::string line;  ///< without its end; empty where it is left out
  bool is_failure;
  std::string complaint = {};  ///< why it failed, as the line says
};

/// Answers a line by answer_question(): the object with the "id" of the line in front, which of a
/// bare curve is its name; or {"id": …, "error": {"status": 2, "message": "…"}}, where the status
/// is the exit status of the program for the same question. Depends on nothing but the line, and
/// may be called from several threads. Throws nothing but bad_alloc.
BatchAnswer batch_answer(std::string_view line, const BatchDefaults& defaults);

/// The id of an answer, errors included, "null" where it has none; no value where the line is no
/// answer.
std::optional<std::string> answered_id(std::string_view line);

}  // namespace phrame::cli
