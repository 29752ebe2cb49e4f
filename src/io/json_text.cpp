#include "phrame/io/json_text.hpp"

#include <algorithm>

namespace phrame {
namespace {

bool fits_a_line(const JsonOutput& json) {
  if (json.is_object()) return false;
  return !json.is_array() || std::all_of(json.begin(), json.end(), fits_a_line);
}

/// nlohmann's own dump puts either everything on one line or every number on a line of its own.
void append(std::string& text, const JsonOutput& json, std::size_t depth) {
  const bool object = json.is_object();
  if (!json.is_structured() || json.empty() || (!object && fits_a_line(json))) {
    text += json.dump();
    return;
  }
  const std::string indent(2 * depth + 2, ' ');
  text += object ? "{\n" : "[\n";
  std::size_t left = json.size();
  for (const auto& [key, value] : json.items()) {
    text += indent;
    if (object) text += JsonOutput(key).dump() + ": ";
    append(text, value, depth + 1);
    text += --left > 0 ? ",\n" : "\n";
  }
  text += std::string(2 * depth, ' ') + (object ? "}" : "]");
}

}  // namespace

std::string pretty(const JsonOutput& json) {
  std::string text;
  append(text, json, 0);
  return text + "\n";
}

JsonOutput json_of(const Polynomial& p) {
  JsonOutput list = JsonOutput::array();
  for (const Rational& c : p.coefficients()) list.push_back(to_string(c));
  return list;
}

JsonOutput json_of(const GaussianPolynomial& p) {
  return {{"re", json_of(p.re)}, {"im", json_of(p.im)}};
}

JsonOutput json_of(const RationalFunction& f) {
  return {{"numerator", json_of(f.numerator())}, {"denominator", json_of(f.denominator())}};
}

JsonOutput json_of(const Antiderivative& F, const std::string& form) {
  JsonOutput logs = JsonOutput::array();
  for (const LogSum& sum : F.logs) {
    JsonOutput argument = JsonOutput::array();
    for (const Polynomial& c : sum.argument.coefficients()) argument.push_back(json_of(c));
    logs.push_back(
        {{"index", json_of(sum.index)}, {"residue", json_of(sum.residue)}, {"argument", argument}});
  }
  return {{"polynomial", json_of(F.polynomial)},
          {"rational", json_of(F.rational)},
          {"logs", logs},
          {"form", form},
          {"checked", true}};  // nothing unchecked leaves integrate()
}

JsonOutput json_of(const Decimal& x) { return {{"value", x.value}, {"radius", x.radius}}; }

JsonOutput json_of(const Vector<Rational>& point) {
  return {to_string(point[0]), to_string(point[1]), to_string(point[2])};
}

}  // namespace phrame
