#include "phrame/cli/form.hpp"

#include <limits>

namespace phrame::inline v0::cli {
namespace {

const std::vector<std::pair<std::string, FormChoice>>& forms() {
  static const std::vector<std::pair<std::string, FormChoice>> table{
      {"auto", {Form::automatic, Style::textbook}},
      {"partial-fractions", {Form::partial_fractions}},
      {"rothstein-trager", {Form::rothstein_trager}},
      {"lazard-rioboo-trager", {Form::lazard_rioboo_trager}},
      // Written anew from the poles, whatever the form; this one costs least.
      {"real", {Form::partial_fractions, Style::real}},
      {"radicals", {Form::partial_fractions, Style::radicals}},
  };
  return table;
}

}  // namespace

void FormOptions::add_to(Command& command) {
  command.add_choice("--form", form, keys(forms()),
                     "how the logarithms are written: auto (default), partial-fractions,\n"
                     "rothstein-trager, lazard-rioboo-trager, real, radicals");
  command.add_format("--print", print,
                     {"text", "json", "latex", "sympy", "mathematica", "maple", "maxima", "pari"},
                     "text (default), json, latex, or for a computer-algebra system: sympy,\n"
                     "mathematica, maple, maxima, pari");
  length.add_to(command);
}

std::vector<std::string> FormOptions::scripts() {
  return {"--print sympy", "--print mathematica", "--print maple", "--print maxima",
          "--print pari"};
}

FormChoice FormOptions::chosen_form() const { return choose<FormChoice>("--form", form, forms()); }

Print FormOptions::chosen_print() const {
  using As = Print::As;
  return choose<Print>("--print", print,
                       {{"text", {As::text}},
                        {"json", {As::json}},
                        {"latex", {As::latex}},
                        {"sympy", {As::script, Language::sympy}},
                        {"mathematica", {As::script, Language::mathematica}},
                        {"maple", {As::script, Language::maple}},
                        {"maxima", {As::script, Language::maxima}},
                        {"pari", {As::script, Language::pari}}});
}

std::optional<long> FormOptions::most_poles() const {
  constexpr long most = 24;
  if (print != "text") return std::nullopt;
  return length.is_full ? std::numeric_limits<long>::max() : most;
}

}  // namespace phrame::cli
