#include "phrame/io/write/answers.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/answer/wronskian.hpp"
#include "phrame/io/write/field.hpp"
#include "phrame/io/write/heading.hpp"
#include "phrame/io/write/names.hpp"
#include "phrame/io/write/twist_frame.hpp"

namespace phrame::inline v0 {
namespace {

constexpr auto pair_definition =
    "The rational frame of a pair of polynomials $a$, $b$ is the Euler–Rodrigues frame turned by "
    "$θ$ about $e₁$:\n"
    "  $f₂ = \\cos θ\\, e₂ + \\sin θ\\, e₃$,  $f₃ = −\\sin θ\\, e₂ + \\cos θ\\, e₃$\n"
    "  $θ = 2 \\arg(b + i a)$,  $ab′ − a′b = 2hσ$,  $J = ∫₀¹ ρ(a² + b² − 2σ²)²$ least\n\n";

std::string formula_of(FrameWeight weight) {
  if (weight == FrameWeight::one) return "$1$";
  return weight == FrameWeight::speed ? "$|fσ|$" : "$|τκ|$";
}

/// "(t − 1)", for a power of it; "t".
std::string offset(const Rational& origin, Notation notation) {
  const std::string text = formatted(Polynomial{-origin, 1}, notation);
  return origin == 0 ? text : "(" + text + ")";
}

Value polynomial_value(const Polynomial& p, std::string_view variable) {
  const auto words = [p, variable = std::string(variable)](Notation notation) {
    const std::string text = formatted(p, notation, variable);
    return notation == Notation::latex ? formula(text, notation) : readable(text, p);
  };
  return {Value::Words(words), [p] { return json_of(p); }};
}

std::string latex_size(const std::string& x, Notation notation) {
  return notation == Notation::latex ? latex_decimal(x) : with_minus_sign(x);
}

Value size_value(const ErrorSize& x, const std::string& unit) {
  const auto words = [x, unit](Notation notation) {
    const char* const relation = x.is_bound ? "≤" : x.value.radius == "0" ? "=" : "≈";
    return formula(fmt::format("{} {}{}", relation, latex_size(x.value.value, notation),
                               x.value.value == "0" ? "" : unit),
                   notation);
  };
  return {Value::Words(words), [x]() -> JsonOutput {
            if (x.is_bound) return {{"at_most", x.value.value}};
            return json_of(x.value);
          }};
}

/// "real planes   3 of 5", and a row for each.
Fields plane_fields(const WronskianAnswer& answer) {
  const auto list = [&answer] {
    JsonOutput planes = JsonOutput::array();
    for (const auto& [basis, value, critical_points, is_tied] : answer.real) {
      JsonOutput plane = {{"parameter", json_of(basis.parameter)},
                          {"a", array_of(basis.a)},
                          {"b", array_of(basis.b)},
                          {"objective", size_value(value, "").json()}};
      plane["critical_points"] = critical_points ? JsonOutput(*critical_points) : JsonOutput();
      plane["tied"] = is_tied;
      planes.push_back(std::move(plane));
    }
    return planes;
  };
  Fields fields{{"planes",
                 "real planes",
                 {Value::Words([&answer](Notation) {
                    return fmt::format("{} of {}", answer.real.size(),
                                       answer.planes.degree == 2 ? 1 : 5);
                  }),
                  list}}};
  for (std::size_t k = 0; k < answer.real.size(); ++k) {
    const auto words = [&answer, k](Notation notation) {
      const auto& [basis, value, critical_points, is_tied] = answer.real[k];
      std::string text = fmt::format("$J$ {}", size_value(value, "").rows(notation).front());
      if (critical_points)
        text += fmt::format(", {} of $J$",
                            counted(static_cast<std::size_t>(*critical_points), "critical point"));
      if (k == answer.best) text += ", the least";
      if (is_tied) text += ", the same: the curve is symmetric";
      return text;
    };
    const auto parameter = in_words(answer.real[k].basis.parameter, Notation::unicode);
    fields.push_back({"", fmt::format("  $x$ = {}", parameter), {Value::Words(words), {}}});
  }
  return fields;
}

Fields system_fields(const WronskianAnswer& answer) {
  const auto weight = [&answer](Notation) { return formula_of(answer.weight); };
  const auto resolvent = [&answer](Notation notation) {
    const Polynomial& p = answer.planes.resolvent;
    return formula(formatted_factors(p, notation, "x") + " = 0", notation);
  };
  const auto origin = [&answer](Notation notation) {
    return fmt::format("$a = 1 + x{0}² + …$, $b = {1}{0} + …$",
                       offset(answer.planes.origin, notation),
                       formatted(answer.wronskian(answer.planes.origin), notation));
  };
  Fields fields{json_field("phrame", "wronskian/1"),
                json_field("name", answer.path.name),
                {"weight",
                 "weight $ρ$",
                 {Value::Words(weight), [&answer] { return name_of(answer.weight); }}},
                {"wronskian", "$2hσ$", polynomial_value(answer.wronskian, "t")},
                json_field("degree", answer.planes.degree),
                {"origin",
                 "planes, by their bases",
                 {Value::Words(origin), [&answer] { return to_string(answer.planes.origin); }}},
                {"resolvent", "where", {Value::Words(resolvent), [&answer] {
                                          return json_of(answer.planes.resolvent);
                                        }}}};
  for (Field& field : plane_fields(answer)) fields.push_back(std::move(field));
  return fields;
}

/// "a₀", … in rows; a list in JSON.
Field decimals_field(const std::string& key, const std::vector<Decimal>& numbers) {
  Fields parts;
  for (std::size_t k = 0; k < numbers.size(); ++k)
    parts.push_back({"", fmt::format("  ${}_{{{}}}$", key, k), compared_value(numbers[k])});
  return {key, "", {Value::Rows(), [&numbers] { return array_of(numbers); }}, parts};
}

Fields best_fields(const WronskianAnswer& answer) {
  Fields fields{json_field("best", answer.best)};
  if (const auto& zero = answer.real[answer.best].basis.zero)
    fields.push_back({"common_zero",
                      "common zero of a, b",
                      {Value::Words([zero](Notation notation) {
                         const std::string text = offset(*zero, notation);
                         return formula("t = " + formatted(*zero, notation), notation) +
                                ", the frame is that of " + formula("a/" + text, notation) + ", " +
                                formula("b/" + text, notation);
                       }),
                       [zero] { return to_string(*zero); }}});
  for (Field& field : Fields{{"multiplier", "multiplier $λ$", compared_value(answer.multiplier)},
                             json_field("form", array_of(answer.form)),
                             decimals_field("a", answer.a),
                             decimals_field("b", answer.b)})
    fields.push_back(std::move(field));
  return fields;
}

Fields pair_fields(const WronskianAnswer& answer) {
  const RationalPair& pair = answer.pair;
  const auto residual = [&answer](Notation notation) -> std::string {
    const Rational& defect = answer.pair.defect;
    if (defect == 0) return formula("= 0", notation);
    const std::string number = round_to_decimal(defect, 3).value;
    const std::string text = offset(answer.planes.origin, notation);
    const bool is_latex = notation == Notation::latex;
    std::string powers = text + (is_latex ? "^6" : "⁶");
    if (const auto& zero = answer.real[answer.best].basis.zero)
      powers = offset(*zero, notation) + (is_latex ? "^2 " : "²") + text + (is_latex ? "^4" : "⁴");
    return formula(is_latex ? fmt::format("\\approx {} {}", latex_decimal(number), powers)
                            : fmt::format("≈ {} {}", with_minus_sign(number), powers),
                   notation);
  };
  Fields fields{object_field(
      "rational",
      {{"a", "$a$", polynomial_value(pair.a, "t")},
       {"b", "$b$", polynomial_value(pair.b, "t")},
       json_field("parameter", to_string(pair.parameter)),
       {"residual",
        "$ab′ − a′b − 2hσ$",
        {Value::Words(residual), [&pair] { return to_string(pair.defect); }}},
       {"frame_degree",
        "degree of the frame",
        {Value::Words([&answer](Notation) { return std::to_string(answer.frame_degree); }),
         [&answer] { return answer.frame_degree; }}},
       {"greatest_angle", "greatest $|θ − θ_\\text{RMF}|$", size_value(answer.greatest_angle, "")},
       {"angle_at_end", "$θ − θ_\\text{RMF}$ at $t = 1$", compared_value(answer.angle_at_end)}})};
  if (answer.rates) {
    fields.push_back({"rms_times_length", "rms of $Ω₁$", size_value(answer.rates->here, "/S")});
    fields.push_back({"least_rms_times_length",
                      fmt::format("  mtf --degree {} --free-ends", answer.planes.degree),
                      size_value(answer.rates->least, "/S")});
  } else {
    fields.push_back({"no_rms",
                      "rms of $Ω₁$",
                      {Value::Words([&answer](Notation) { return "none: " + answer.why_no_rates; }),
                       [&answer] { return answer.why_no_rates; }}});
  }
  return fields;
}

}  // namespace

std::string to_text(const WronskianAnswer& answer) {
  constexpr std::size_t width = 31;
  return heading(answer.path) + "\n\n" + prose(pair_definition, Notation::unicode) +
         notes_on_signs(answer.path.path) + to_rows(system_fields(answer), width) +
         "\nThe best pair, proved\n" + to_rows(best_fields(answer), width) +
         "\nA pair over ℚ next to it, and its frame\n" + to_rows(pair_fields(answer), width);
}

std::string to_latex(const WronskianAnswer& answer) {
  constexpr auto latex = Notation::latex;
  return prose(pair_definition, latex) + notes_on_signs(answer.path.path, latex) +
         to_align(system_fields(answer)) + "\nThe best pair, proved:\n" +
         to_align(best_fields(answer)) +
         prose("\nA pair over ℚ next to it, and its frame:\n", latex) +
         to_align(pair_fields(answer));
}

std::string to_json(const WronskianAnswer& answer) {
  JsonOutput output = json_of(system_fields(answer));
  output.update(json_of(best_fields(answer)));
  output.update(json_of(pair_fields(answer)));
  return pretty(output);
}

}  // namespace phrame
