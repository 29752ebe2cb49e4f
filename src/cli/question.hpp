#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "phrame/cli/command.hpp"
#include "phrame/cli/option_list.hpp"
#include "phrame/io/read/json_node.hpp"

namespace phrame::inline v0::cli {

/// For lines that do not say otherwise.
struct QuestionDefaults {
  std::string question;
  /// Options of all lines whose question has them, where they apply.
  std::vector<std::pair<std::string, std::string>> options;
  std::optional<NamedPath> curve = {};  ///< of a line without "curve"
};

/// The answer to a line {"question": "totals", "curve": {…}, "digits": 30}: what the command writes
/// with these arguments and options, in JSON where it can. A key is the name of an argument or an
/// option, with _ for -; for a file stands what is in it; a list or a vector is an array or the
/// text, a table an array of rows. A line may also be a bare curve or spline.
///
/// It is a JSON object in one line: that of the command; or {"output": "…"}, with "status": 1 where
/// the answer is no. Before the rest there are "notes" where the command says something on stderr.
/// Throws what the command does, the place being a JSON pointer, and Failure for a command that
/// says no without an output. May be called from several threads.
std::string answer_question(const JsonNode& line, const QuestionDefaults& defaults,
                            const CommandTable& table = answering_commands());

}  // namespace phrame::cli
