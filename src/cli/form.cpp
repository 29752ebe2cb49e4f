#include "phrame/cli/form.hpp"

#include <fmt/format.h>

namespace phrame::cli {
namespace {

/// No choice: the form has a name, but is not there yet.
const std::vector<std::pair<std::string, std::optional<FormChoice>>>& forms() {
  static const std::vector<std::pair<std::string, std::optional<FormChoice>>> table{
      {"auto", {{Form::automatic}}},
      {"partial-fractions", {{Form::partial_fractions}}},
      {"rothstein-trager", {{Form::rothstein_trager}}},
      {"lazard-rioboo-trager", {{Form::lazard_rioboo_trager}}},
      {"real", {{Form::automatic, true}}},
      {"radicals", std::nullopt},
  };
  return table;
}

std::string names_of_forms() {
  std::string names;
  for (const auto& [name, choice] : forms())
    if (choice) names += (names.empty() ? "" : ", ") + name;
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
}

FormChoice FormOptions::chosen_form() const {
  if (const auto choice = choose<std::optional<FormChoice>>("--form", form, forms()))
    return *choice;
  throw InputError("--form",
                   fmt::format("\"{}\" is not there yet; there are {}", form, names_of_forms()));
}

}  // namespace phrame::cli
