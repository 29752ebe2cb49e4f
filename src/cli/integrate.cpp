#include <fmt/format.h>

#include "phrame/answer/integral.hpp"
#include "phrame/cli/form.hpp"
#include "phrame/io/read/endpoint.hpp"
#include "phrame/io/write/answers.hpp"

namespace phrame::inline v0::cli {
namespace {

struct IntegrateOptions {
  std::string expression;
  std::optional<std::string> variable;
  std::optional<std::string> from;
  std::optional<std::string> to;
  bool principal_value = false;
  bool is_silent = false;
  FormOptions form;
  ExpressionLimits limits;
  std::string output = "-";
  long digits = 17;
};

/// As it was typed: without the blank before a minus sign.
std::string_view typed(std::string_view text) {
  return text.starts_with(" -") ? text.substr(1) : text;
}

Expression integrand(const IntegrateOptions& options) {
  const bool is_stream = options.expression == "-";
  ExpressionLimits limits = options.limits;
  limits.variable_option = "--var";
  const std::string text = is_stream ? read_file("-") : std::string(typed(options.expression));
  if (options.variable && !is_variable_name(*options.variable))
    throw InputError("--var", "\"" + abbreviated(*options.variable) + "\" is not a name");
  Expression f = at_place(is_stream ? "standard input" : "EXPR", ", ",
                          [&] { return parse_expression(text, options.variable, limits); });
  if (f.variable.empty()) f.variable = "x";
  return f;
}

std::optional<std::pair<PathEnd, PathEnd>> ends(const IntegrateOptions& options) {
  if (options.from.has_value() != options.to.has_value())
    throw InputError("integrate", "--from and --to go together");
  if (!options.from) return std::nullopt;
  const auto end = [&](const std::string& option, const std::string& text) {
    return at_place(option, ", ", [&] { return parse_endpoint(typed(text), options.limits); });
  };
  return std::pair(end("--from", *options.from), end("--to", *options.to));
}

std::string shown(const IntegralAnswer& answer, const Print& print, bool is_silent) {
  if (print.as == Print::As::text) return to_text(answer, !is_silent);
  return printed(answer, print);
}

void run(const IntegrateOptions& options) {
  const auto [form, style] = options.form.chosen_form();
  const Print print = options.form.chosen_print();
  const auto path = ends(options);
  const Expression f = integrand(options);
  if (style == Style::radicals && f.variable == "i")
    throw InputError("--form radicals", "i is the imaginary unit there, not a variable");

  IntegralQuery query{f.value, f.variable};
  query.form = form;
  query.style = print.as == Print::As::json && style == Style::textbook ? Style::logarithms : style;
  query.most_poles = options.form.most_poles();
  query.digits = options.digits;
  if (path)
    query.ends = {path->first, path->second,
                  options.principal_value ? AtPoles::principal_value : AtPoles::refuse};
  options.form.length.write(options.output, shown(answer(query), print, options.is_silent));
}

}  // namespace

void add_integrate(Program& program) {
  Command& command = program.add("integrate", "the exact integral of a rational function");
  const auto options = std::make_shared<IntegrateOptions>();
  command.add_argument(
      "EXPR", options->expression,
      "a rational function of one variable, such as 1/(x^4+1), \"-\" for standard input");
  command.add_option("--var", "NAME", options->variable,
                     "the variable (default: the one that occurs)");
  command.add_option("--from", "END", options->from,
                     "integrate from here: a number, as 3/7, sqrt(2) or pi/4, inf (or oo), or\n"
                     "root(p, a, b), the root of p in [a, b]");
  command.add_option("--to", "END", options->to, "to here");
  command.add_flag(
      "--principal-value", options->principal_value,
      "Cauchy's principal value at simple poles between the ends, and from -inf to inf");
  add_digits(command, options->digits);
  options->form.add_to(command);
  command.add_flag("--no-derivative-check", options->is_silent,
                   "do not say that the derivative was checked (it always is)");
  command.add_hidden_flag("--derivative-check");  // the default
  command.add_number("--max-degree", options->limits.size.max_degree, {1, 1'000'000},
                     fmt::format("refuse functions of a higher degree (default {})",
                                 options->limits.size.max_degree));
  command.add_output(options->output);
  command.only_with({"--principal-value", "--digits"}, {"--from and --to"});
  std::vector<std::string> others = FormOptions::scripts();
  others.insert(others.end(), {"--print json", "--print latex"});
  command.not_with({"--no-derivative-check"}, others);  // of which none says so
  command.set_notes(
      "Numbers are exact: 0.1 is 1/10. A product needs its sign: 2*x, not 2x.\n"
      "Examples:\n"
      "  phrame integrate '(3*x^2+x+1)/(x^3+x)'\n"
      "  phrame integrate '1/(x^4+1)' --from 0 --to 1 --digits 50\n"
      "  phrame integrate '1/(t^2-2)' --form real --from 'root(t^2-3, 1, 2)' --to inf\n"
      "  phrame integrate '1/(x^5+x+1)' --print sympy");
  command.does(options, run);
}

}  // namespace phrame::cli
