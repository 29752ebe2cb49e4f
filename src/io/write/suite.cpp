#include "phrame/io/write/suite.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/answer/rounded.hpp"
#include "phrame/io/write/json_text.hpp"
#include "phrame/io/write/text.hpp"

namespace phrame::inline v0 {
namespace {

/// The first row is the head.
using Table = std::vector<std::vector<std::string>>;

std::string table_text(Table table) {
  for (auto& row : table)
    for (std::string& cell : row) cell = with_minus_sign(cell);
  return columns_text(table, "  ");
}

constexpr const char* per_row_head = "µs a row";

/// "1.3e-7" as $1.3 \cdot 10^{-7}$, a dash as "--", µ as $\mu$.
std::string latex_cell(const std::string& cell) {
  if (cell == per_row_head) return R"($\mu$s a row)";
  const std::size_t e = cell.find('e');
  const bool is_number = !cell.empty() && cell.find_first_not_of("0123456789.e-") == cell.npos;
  if (!is_number) return cell == "–" ? "--" : cell;
  if (e == std::string::npos) return "$" + cell + "$";
  return fmt::format(R"(${} \cdot 10^{{{}}}$)", cell.substr(0, e), cell.substr(e + 1));
}

std::string table_latex(const Table& table) {
  std::string text =
      fmt::format("\\begin{{tabular}}{{l{}}}\n", std::string(table.front().size() - 1, 'r'));
  for (std::size_t k = 0; k < table.size(); ++k) {
    std::vector<std::string> cells;
    for (const std::string& cell : table[k]) cells.push_back(latex_cell(cell));
    text += fmt::format("{} \\\\{}\n", fmt::join(cells, " & "), k == 0 ? " \\hline" : "");
  }
  return text + "\\end{tabular}\n";
}

/// A table element, numbers on the right.
std::string table_html(const Table& table) {
  std::string text = "<table>\n";
  for (std::size_t k = 0; k < table.size(); ++k) {
    const char* name = k == 0 ? "th" : "td";
    text += "<tr>";
    for (std::size_t j = 0; j < table[k].size(); ++j)
      text += fmt::format("<{0}{1}>{2}</{0}>", name, j == 0 ? "" : " style=\"text-align:right\"",
                          element_text(with_minus_sign(table[k][j])));
    text += "</tr>\n";
  }
  return text + "</table>\n";
}

std::string bound_cell(const std::optional<Rational>& x) { return x ? upper_bound_text(*x) : "–"; }

std::string seconds_cell(const std::optional<Rational>& seconds) {
  return seconds ? round_to_decimal(Real(*seconds), 3).value : "–";
}

std::string order_cell(const std::optional<double>& order) {
  return order ? fmt::format("{:.2f}", *order) : "–";
}

Table group_table(const SuiteAnswer& answer) {
  Table table{{"group", "curves", "pass", "error", "order", "flips", "drift", "holonomy"}};
  const std::vector<SuiteGroup> groups = suite_groups(answer);
  const bool is_timed = groups.back().seconds.has_value();
  if (is_timed) table.front().insert(table.front().end(), {"seconds", per_row_head});
  for (const SuiteGroup& group : groups) {
    table.push_back({group.name.empty() ? "all" : group.name, std::to_string(group.curves),
                     std::to_string(group.passed), bound_cell(group.max_error),
                     order_cell(group.order), std::to_string(group.flips), bound_cell(group.drift),
                     bound_cell(group.holonomy)});
    if (!is_timed) continue;
    std::optional<Rational> per_row;
    if (group.seconds) per_row = *group.seconds * 1'000'000 / Rational(group.timed_samples);
    table.back().insert(table.back().end(), {seconds_cell(group.seconds), seconds_cell(per_row)});
  }
  return table;
}

std::optional<Rational> size_of(const std::optional<RealBall>& x) {
  if (!x) return std::nullopt;
  return absolute(*x).upper();
}

std::optional<double> order_of(const SuiteRow& row) {
  if (!row.convergence.order) return std::nullopt;
  return approximate(*row.convergence.order);
}

/// Those that fail, the worst first, so many at most.
std::string worst_rows(const SuiteAnswer& answer, std::size_t most) {
  std::vector<const SuiteRow*> failing;
  Table table{{"curve", "frames", "error", "order", "flips", "drift", "holonomy"}};
  for (const SuiteRow& row : answer.rows)
    if (row.failure.empty() && !row.passes) failing.push_back(&row);
  std::stable_sort(failing.begin(), failing.end(), [](const SuiteRow* a, const SuiteRow* b) {
    return a->max_error.midpoint() > b->max_error.midpoint();
  });
  const std::size_t count = failing.size();
  failing.resize(std::min(count, most));
  for (const SuiteRow* row : failing)
    table.push_back({row->name, std::to_string(row->samples), bound_cell(size_of(row->max_error)),
                     order_cell(order_of(*row)), std::to_string(row->flips),
                     bound_cell(size_of(row->drift)), bound_cell(size_of(row->holonomy))});
  if (count == 0) return "";
  const std::string which =
      count > most ? fmt::format("The worst {} of {} that fail", most, count) : "Those that fail";
  return "\n" + which + "\n" + table_text(table);
}

/// "a, b, c and 12 more".
std::string some_of(const std::vector<std::string>& names) {
  constexpr std::size_t most = 6;
  const std::size_t shown = names.size() <= most + 1 ? names.size() : most;
  const std::vector<std::string> first(names.begin(),
                                       names.begin() + static_cast<std::ptrdiff_t>(shown));
  return fmt::format("{}{}", fmt::join(first, ", "),
                     shown < names.size() ? fmt::format(" and {} more", names.size() - shown) : "");
}

JsonOutput number_json(const std::optional<RealBall>& x) {
  return x ? json_of(rounded_as_known(*x)) : JsonOutput();
}

JsonOutput bound_json(const std::optional<Rational>& x) {
  return x ? JsonOutput(upper_bound_text(*x)) : JsonOutput();
}

JsonOutput json_of(const Convergence& found) {
  JsonOutput steps = JsonOutput::array();
  for (std::size_t k = 0; k < found.steps.size(); ++k) {
    const StepError& at = found.steps[k];
    steps.push_back({{"samples", at.samples},
                     {"step", to_string(at.step)},
                     {"error", json_of_bounds(at.error)},
                     {"rate", k == 0 ? JsonOutput() : number_json(found.rates[k - 1])}});
    if (at.seconds) steps.back()["seconds"] = to_string(*at.seconds);
  }
  return {{"order", number_json(found.order)}, {"steps", steps}};
}

JsonOutput json_of(const SuiteRow& row) {
  JsonOutput json = {{"name", row.name}, {"group", row.group}};
  if (!row.failure.empty()) {
    json["failure"] = row.failure;
    return json;
  }
  json["verdict"] = row.passes ? "pass" : "fail";
  json["samples"] = row.samples;
  json["max_error"] = json_of_bounds(row.max_error);
  json["flips"] = row.flips;
  json["orthogonality"] = upper_bound_text(row.orthogonality.upper());
  json["drift"] = number_json(row.drift);
  json["holonomy"] = number_json(row.holonomy);
  json.update(json_of(row.convergence));
  return json;
}

JsonOutput json_of(const SuiteGroup& group) {
  JsonOutput json = {{"name", group.name},
                     {"curves", group.curves},
                     {"passed", group.passed},
                     {"failures", group.failures},
                     {"max_error", bound_json(group.max_error)},
                     {"order", group.order ? JsonOutput(*group.order) : JsonOutput()},
                     {"flips", group.flips},
                     {"drift", bound_json(group.drift)},
                     {"holonomy", bound_json(group.holonomy)}};
  if (group.seconds) {
    json["seconds"] = to_string(*group.seconds);
    json["timed_samples"] = group.timed_samples;
  }
  return json;
}

Table step_table(const OrderAnswer& answer) {
  Table table{{"frames", "step", "error", "rate"}};
  const Convergence& found = answer.convergence;
  const bool is_timed = std::any_of(found.steps.begin(), found.steps.end(),
                                    [](const StepError& at) { return at.seconds.has_value(); });
  if (is_timed) table.front().push_back("seconds");
  for (std::size_t k = 0; k < found.steps.size(); ++k) {
    const StepError& at = found.steps[k];
    std::optional<double> rate;
    if (k > 0 && found.rates[k - 1]) rate = approximate(*found.rates[k - 1]);
    table.push_back({std::to_string(at.samples), upper_bound_text(at.step, 4),
                     upper_bound_text(at.error.upper(), 6), order_cell(rate)});
    if (is_timed) table.back().push_back(seconds_cell(at.seconds));
  }
  return table;
}

}  // namespace

std::string to_text(const SuiteAnswer& answer) {
  const SuiteGroup all = suite_groups(answer).back();
  std::string text =
      fmt::format("{}: {} of {} pass, to within {}\n\n", answer.passes() ? "pass" : "fail",
                  all.passed, counted(all.curves, "curve"), to_string(answer.tolerance));
  text += table_text(group_table(answer)) + worst_rows(answer, 10);
  std::vector<std::string> failures;
  for (const SuiteRow& row : answer.rows)
    if (!row.failure.empty()) failures.push_back(fmt::format("  {}: {}\n", row.name, row.failure));
  if (!failures.empty()) text += "\nWithout a verdict\n";
  for (const std::string& line : failures) text += line;
  if (!answer.missing.empty())
    text += fmt::format("\n{} no table: {}\n",
                        answer.missing.size() == 1
                            ? "1 curve has"
                            : fmt::format("{} curves have", answer.missing.size()),
                        some_of(answer.missing));
  return text +
         "\nErrors, drift (radians per unit of length) and holonomy are proved bounds of the "
         "largest; the\norder is the median of those estimated" +
         (all.seconds ? "; seconds are sums of those in times.csv.\n" : ".\n");
}

std::string to_json(const SuiteAnswer& answer) {
  const std::vector<SuiteGroup> groups = suite_groups(answer);
  return pretty({{"phrame", "suite/1"},
                 {"verdict", answer.passes() ? "pass" : "fail"},
                 {"tolerance", to_string(answer.tolerance)},
                 {"groups", array_of(groups, [](const SuiteGroup& x) { return json_of(x); })},
                 {"missing", answer.missing},
                 {"curves", array_of(answer.rows, [](const SuiteRow& x) { return json_of(x); })}});
}

std::string to_latex(const SuiteAnswer& answer) { return table_latex(group_table(answer)); }

std::string to_html(const SuiteAnswer& answer) { return table_html(group_table(answer)); }

std::string to_text(const OrderAnswer& answer) {
  const Convergence& found = answer.convergence;
  std::string text = name_prefix(answer.name);
  text += found.order ? fmt::format("order about {:.2f}\n\n", approximate(*found.order))
                      : "no order: fewer than two errors above 1e-12\n\n";
  return text + table_text(step_table(answer)) +
         "\nErrors are proved, from above; a rate is log(error/error) : log(step/step) of a table "
         "and the one\nbefore.\n";
}

std::string to_json(const OrderAnswer& answer) {
  JsonOutput json = {{"phrame", "order/1"}, {"name", answer.name}};
  json.update(json_of(answer.convergence));
  return pretty(json);
}

std::string to_latex(const OrderAnswer& answer) { return table_latex(step_table(answer)); }

std::string to_html(const OrderAnswer& answer) { return table_html(step_table(answer)); }

}  // namespace phrame
