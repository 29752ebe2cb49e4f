#include "phrame/io/write/field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "phrame/io/write/closed_form.hpp"

namespace phrame::inline v0 {
namespace {

using enum Notation;

/// Without those around it, which are for a text.
std::string_view without_blanks(std::string_view label) {
  const auto first = std::min(label.find_first_not_of(' '), label.size());
  return label.substr(first, label.find_last_not_of(' ') + 1 - first);
}

/// Words in LaTeX within a formula.
std::string as_formula(std::string_view words) {
  const bool is_one =
      words.size() > 1 && words.front() == '$' && words.find('$', 1) + 1 == words.size();
  return is_one ? std::string(words.substr(1, words.size() - 2))
                : fmt::format("\\text{{{}}}", words);
}

bool begins_with_relation(std::string_view text) {
  return text.starts_with("=") || text.starts_with("\\approx") || text.starts_with("\\le ");
}

/// "&= 1/2"; what is no formula, or an equation by itself ("t = 1/2"), stands apart.
std::string right_side(const std::string& words) {
  const std::string text = as_formula(words);
  const bool is_equation = text.starts_with("t ") && begins_with_relation(text.substr(2));
  if (is_equation || text.starts_with("\\text{")) return "&\\quad " + text;
  return (begins_with_relation(text) ? "&" : "&= ") + text;
}

}  // namespace

std::string in_words(const Rational& x, Notation notation) {
  return notation == latex ? formula(formatted(x, latex), latex) : shown(x);
}

std::string in_words(const Polynomial& p, Notation notation) {
  return notation == latex ? formula(formatted(p, latex), latex) : shown(p);
}

std::string in_words(const GaussianPolynomial& p, Notation notation) {
  return notation == latex ? formula(formatted(p, latex), latex) : readable(p);
}

std::string in_words(const Vector<Rational>& v, Notation notation) {
  if (notation == unicode) return shown(v);
  return fmt::format("$\\left({}, {}, {}\\right)$", formatted(v[0], latex), formatted(v[1], latex),
                     formatted(v[2], latex));
}

std::string in_words(const Decimal& x, Notation notation) {
  if (notation == unicode) return shown(x);
  return fmt::format("${}{}$", x.radius == "0" ? "" : "\\approx ", latex_decimal(x.value));
}

std::string in_words(const RealAlgebraic& x, Notation notation) {
  const auto exact = x.rational();
  return exact ? in_words(*exact, notation) : formula(shown(x), notation);
}

std::string in_words(const Factored& x, Notation notation) {
  return notation == latex ? formula(formatted_factors(x.p, latex), latex) : readable_factors(x.p);
}

std::string upper_bound_words(const Rational& x, Notation notation) {
  const std::string text = upper_bound_text(x);
  return notation == latex ? formula(latex_decimal(text), notation) : text;
}

JsonOutput json_of(const Factored& x) { return json_of(x.p); }

JsonOutput json_of(const Rational& x) { return to_string(x); }

Field json_field(const std::string& key, const JsonOutput& value) {
  return {key, "", {Value::Rows(), [value] { return value; }}};
}

Field object_field(const std::string& key, Fields parts) { return {key, "", {}, std::move(parts)}; }

Field preimage_field(const QuaternionPolynomial& a) {
  return object_field("preimage",
                      {{"u", "$u$", a.u}, {"v", "$v$", a.v}, {"p", "$p$", a.p}, {"q", "$q$", a.q}});
}

Field in_json(Field field) {
  field.label.clear();
  return field;
}

Field out_of_json(Field field) {
  field.key.clear();
  return field;
}

Value yes_or_no(bool answer, const Fields& parts) {
  const auto words = [answer, parts](Notation notation) {
    std::string text = answer ? "yes" : "no";
    std::string before = ": ";
    for (const Field& part : parts) {
      if (part.label.empty()) continue;
      for (const std::string& row : part.value.rows(notation))
        text += std::exchange(before, ", ") + part.label + (row.empty() ? "" : " ") + row;
    }
    return text;
  };
  return {Value::Words(words), [answer, parts] {
            JsonOutput json = {{"answer", answer}};
            json.update(json_of(parts));
            return json;
          }};
}

std::vector<LabelledRow> rows(const Fields& fields, Notation notation) {
  std::vector<LabelledRow> list;
  for (const Field& field : fields) {
    for (LabelledRow& row : rows(field.parts, notation)) list.push_back(std::move(row));
    if (field.label.empty()) continue;
    for (const std::string& words : field.value.rows(notation))
      list.push_back({prose(field.label, notation), prose(words, notation)});
  }
  return list;
}

std::string to_rows(const Fields& fields, std::size_t width) {
  std::string text;
  for (const auto& [label, words] : rows(fields, unicode)) text += row(label, words, width);
  return text;
}

JsonOutput json_of(const Fields& fields) {
  JsonOutput json = JsonOutput::object();
  for (const Field& field : fields)
    if (!field.key.empty())
      json[field.key] = field.value.has_json() ? field.value.json() : json_of(field.parts);
  return json;
}

std::string to_align(const Fields& fields) {
  std::string text;
  for (const auto& [label, words] : rows(fields, latex))
    text += fmt::format("{}{} {}", text.empty() ? "" : " \\\\\n", as_formula(without_blanks(label)),
                        right_side(words));
  return "\\begin{align*}\n" + text + "\n\\end{align*}\n";
}

}  // namespace phrame
