#pragma once
#include "phrame/cli/command.hpp"
#include "phrame/integrate/integrate.hpp"
#include "phrame/integrate/other_form.hpp"
#include "phrame/io/write/cas_script.hpp"

namespace phrame::inline v0::cli {

/// --form: what the logarithms run over, and how the result is written.
struct FormChoice {
  Form form = Form::automatic;
  Style style = Style::logarithms;
};

/// What --print chooses: one of the three, or a script in the language with that name.
struct Print {
  enum class As { text, json, latex, script };
  As as;
  Language language = Language::plain;
};

/// --form, --print and --full, which angle and integrate have in common.
struct FormOptions {
  std::string form = "auto";
  std::string print = "text";
  TextLength length;

  void add_to(Command& command);
  /// The choices of --print that are the closed form only: "--print sympy".
  static std::vector<std::string> scripts();
  /// Throws InputError for a name that is none.
  FormChoice chosen_form() const;
  Print chosen_print() const;
  /// How many poles are listed in a text.
  std::optional<long> most_poles() const;
};

/// The answer as print says.
template <class Answer>
std::string printed(const Answer& answer, const Print& print) {
  switch (print.as) {
    case Print::As::text:
      return to_text(answer);
    case Print::As::json:
      return to_json(answer);
    case Print::As::latex:
      return to_latex(answer);
    case Print::As::script:
      break;
  }
  return to_script(answer, print.language);
}

}  // namespace phrame::cli
