#include "phrame/cli/form.hpp"

#include <fmt/format.h>

namespace phrame::cli {
namespace {

const std::vector<std::pair<std::string, FormChoice>>& forms() {
  static const std::vector<std::pair<std::string, FormChoice>> table{
      {"auto", {}},
      {"partial-fractions", {Form::partial_fractions}},
      {"rothstein-trager", {Form::rothstein_trager}},
      {"lazard-rioboo-trager", {Form::lazard_rioboo_trager}},
      // Written anew from the poles, whatever the form; this one costs least.
      {"real", {Form::partial_fractions, FormChoice::Style::real}},
      {"radicals", {Form::partial_fractions, FormChoice::Style::radicals}},
  };
  return table;
}

std::string names_of_forms() {
  std::string names;
  for (const auto& [name, choice] : forms()) names += (names.empty() ? "" : ", ") + name;
  return names;
}

}  // namespace

void FormOptions::add_to(CLI::App& command) {
  command
      .add_option(
          "--form", form,
          fmt::format("how the logarithms are written (default auto): {}", names_of_forms()))
      ->type_name("NAME");
  command
      .add_option("--print", print,
                  "text (default), json, latex, or for a computer-algebra system: sympy, "
                  "mathematica, maple, maxima, pari")
      ->type_name("NAME");
  length.add_to(command);
}

FormChoice FormOptions::chosen_form() const { return choose<FormChoice>("--form", form, forms()); }

}  // namespace phrame::cli
