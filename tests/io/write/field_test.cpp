#include "phrame/io/write/field.hpp"
#include "phrame/answer/classification.hpp"
#include "phrame/answer/identification.hpp"
#include "phrame/answer/info.hpp"
#include "phrame/answer/minimal_twist.hpp"
#include "phrame/answer/totals.hpp"
#include "phrame/io/write/answers.hpp"

#include <fmt/format.h>

#include <cctype>

#include "io/reference.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::Json;

namespace {

/// (t³ − t)/2.
const Polynomial cubic{0, Rational(-1, 2), 0, Rational(1, 2)};

Fields example() {
  const Field half{"half", "half of $σ$", Rational(1, 2)};
  const auto notes = [](Notation) { return std::vector<std::string>{"one", "$t = 2$"}; };
  return {json_field("phrame", "example/1"),
          in_json(half),
          {"f", "$f$", cubic},
          object_field(
              "both", {{"h", "$h$", Factored{cubic}}, {"x", "about $x$", Decimal{"0.25", "1e-3"}}}),
          out_of_json({"notes", "note", {Value::Rows(notes), {}}}),
          {"line", "line", yes_or_no(true, {{"direction", "along", Vector<Rational>{1, 0, -2}}})},
          {"plane", "plane", yes_or_no(false, {{"factor", "", cubic}})},
          out_of_json(half)};
}

/// The letters of a label, which has signs in Unicode or commands of LaTeX, of which \exp is one.
std::string letters(std::string_view label) {
  std::string text;
  for (std::size_t k = 0; k < label.size();) {
    const auto is_letter = [&] {
      return k < label.size() && std::isalpha(static_cast<unsigned char>(label[k])) != 0;
    };
    if (label[k] != '\\') {
      if (is_letter()) text += label[k];
      ++k;
      continue;
    }
    const std::size_t begin = ++k;
    while (is_letter()) ++k;
    const std::string_view command = label.substr(begin, k - begin);
    if (command == "exp") text += command;
    if (command == "mathbb") k = label.find('}', k);
  }
  return text;
}

/// The labels of "  label      value", without the lines that go on or are no rows.
std::vector<std::string> labels_of_text(const std::string& text) {
  std::vector<std::string> labels;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t begin = line.find_first_not_of(' ');
    if (begin != 2 && begin != 4) continue;
    const std::size_t end = line.find("  ", begin);
    if (end != std::string::npos && line.find_first_not_of(' ', end) != std::string::npos)
      labels.push_back(letters(std::string_view(line).substr(begin, end - begin)));
  }
  return labels;
}

/// What stands before & in \begin{align*}.
std::vector<std::string> labels_of_latex(const std::string& text) {
  std::vector<std::string> labels;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (const auto end = line.find(" &"); end != std::string::npos)
      labels.push_back(letters(line.substr(0, end)));
  return labels;
}

/// With cusps, turns and signs of several kinds, and the first of the reference curves.
std::vector<NamedCurve> curves() {
  std::vector<NamedCurve> list{test::farouki_quintic(), test::rational_angle_curve(),
                               test::straight_line()};
  // r′ = (2t − 1)·(…): a cusp, and a negative multiplier.
  list.push_back({"cusp", Curve({{1}, {0, 1}, {0, 1}, {}}, {-1, 2})});
  std::istringstream lines(test::read_data("curves.jsonl"));
  std::string line;
  for (long k = 0; k < test::everyday(5, 30) && std::getline(lines, line); ++k)
    list.push_back(read_curve(line));
  return list;
}

}  // namespace

TEST_CASE("fields: a text has a row for each label") {
  CHECK(to_rows(example(), 9) ==
        "  f          (1/2)t³ − (1/2)t\n"
        "  h          (1/2)t(t − 1)(t + 1)\n"
        "  about x    0.25\n"
        "  note       one\n"
        "  note       t = 2\n"
        "  line       yes: along (1, 0, −2)\n"
        "  plane      no\n"
        "  half of σ  1/2\n");
}

TEST_CASE("fields: JSON has a member for each key, in their order") {
  CHECK(json_of(example()).dump() ==
        R"({"phrame":"example/1","half":"1/2","f":["0","-1/2","0","1/2"],)"
        R"("both":{"h":["0","-1/2","0","1/2"],"x":{"value":"0.25","radius":"1e-3"}},)"
        R"("line":{"answer":true,"direction":["1","0","-2"]},)"
        R"("plane":{"answer":false,"factor":["0","-1/2","0","1/2"]}})");
}

TEST_CASE("fields: LaTeX has an equation for each row of the text") {
  CHECK(to_align(example()) ==
        "\\begin{align*}\n"
        "f &= \\frac{1}{2}t^{3} - \\frac{1}{2}t \\\\\n"
        "h &= \\frac{1}{2}t(t - 1)(t + 1) \\\\\n"
        "\\text{about $x$} &\\approx 0.25 \\\\\n"
        "\\text{note} &\\quad \\text{one} \\\\\n"
        "\\text{note} &\\quad t = 2 \\\\\n"
        "\\text{line} &\\quad \\text{yes: along $\\left(1, 0, -2\\right)$} \\\\\n"
        "\\text{plane} &\\quad \\text{no} \\\\\n"
        "\\text{half of $\\sigma$} &= \\frac{1}{2}\n"
        "\\end{align*}\n");
}

TEST_CASE("fields: an answer in LaTeX has the fields of its text") {
  const auto check = [](const auto& answer, std::size_t least) {
    const std::string text = abridged(to_text(answer));
    CAPTURE(text);
    const auto labels = labels_of_latex(to_latex(answer));
    CHECK(labels.size() >= least);
    CHECK(labels_of_text(text) == labels);
  };
  for (const NamedCurve& curve : curves()) {
    CAPTURE(curve.name);
    check(answer(curve, InfoQuery{8}), 16);
    check(answer(curve, ClassificationQuery{}), 11);
    check(answer(NamedHodograph{curve.name, hodograph(curve.curve), {}}), 6);
  }
}

TEST_CASE("fields: the minimal twist in LaTeX has the fields of its text") {
  MinimalTwistQuery query{Angle(), Angle(Rational(1, 3))};
  query.rational = {RationalTwistOptions(), Subdivision(), true};
  const MinimalTwistAnswer twist = answer(test::farouki_quintic(), query);
  const std::string text = abridged(to_text(twist));
  CAPTURE(text);
  const auto labels = labels_of_latex(to_latex(twist));
  CHECK(labels.size() == 16);
  CHECK(labels_of_text(text.substr(text.find("  θ_i,"))) == labels);
}
