#pragma once
#include "phrame/cli/command.hpp"
#include "phrame/integrate/integrate.hpp"
#include "phrame/integrate/radicals.hpp"
#include "phrame/integrate/real_form.hpp"
#include "phrame/io/write/cas_script.hpp"

namespace phrame::cli {

/// --form: what the logarithms run over, and how the result is written.
struct FormChoice {
  enum class Style { algebraic, textbook, real, radicals };
  Form form = Form::automatic;
  Style style = Style::algebraic;
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
};

/// Gives the report F in the style that was chosen.
template <class Report>
void set_style(Report& report, const FormChoice& choice, const Antiderivative& F) {
  if (choice.style == FormChoice::Style::textbook) report.textbook = textbook_form(F);
  if (choice.style == FormChoice::Style::real) report.real = real_form(F);
  if (choice.style == FormChoice::Style::radicals) report.radicals = radical_form(F);
}

/// What --print chooses: one of the three, or a script in the language with that name.
template <class Report>
struct Print {
  std::string (*text)(const Report&) = nullptr;
  Language language = Language::plain;
};

template <class Report>
Print<Report> chosen_print(const std::string& name) {
  return choose<Print<Report>>("--print", name,
                               {{"text", {to_text}},
                                {"json", {to_json}},
                                {"latex", {to_latex}},
                                {"sympy", {nullptr, Language::sympy}},
                                {"mathematica", {nullptr, Language::mathematica}},
                                {"maple", {nullptr, Language::maple}},
                                {"maxima", {nullptr, Language::maxima}},
                                {"pari", {nullptr, Language::pari}}});
}

}  // namespace phrame::cli
