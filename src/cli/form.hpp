#pragma once
#include "phrame/cli/command.hpp"
#include "phrame/integrate/integrate.hpp"
#include "phrame/integrate/real_form.hpp"
#include "phrame/io/cas_script.hpp"

namespace phrame::cli {

/// --form: how the logarithms are written, and whether with real functions.
struct FormChoice {
  Form form = Form::automatic;
  bool is_real = false;
};

/// --form and --print, which angle and integrate have in common.
struct FormOptions {
  std::string form = "auto";
  std::string print = "text";

  void add_to(CLI::App& command);
  /// Throws InputError for a name that is none.
  FormChoice chosen_form() const;
  bool is_automatic() const { return form == "auto"; }
};

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
