#include "phrame/io/write/identification.hpp"

#include <fmt/format.h>

#include "phrame/io/write/closed_form.hpp"
#include "phrame/io/write/field.hpp"
#include "phrame/io/write/heading.hpp"
#include "phrame/ph/curve/invariants.hpp"

namespace phrame {
namespace {

std::string reason_text(const NotPythagorean& reason, Notation notation) {
  const bool is_latex = notation == Notation::latex;
  const std::string radicand = reason.radicand.str();
  if (reason.odd_factor == Polynomial{1})
    return fmt::format(
        "  $|r′|$ is ${}$ times a polynomial: the curve is PH over $ℝ$, but has no preimage with\n"
        "  rational coefficients, whatever the multiplier\n",
        is_latex ? "\\sqrt{" + radicand + "}" : "√" + abbreviated(radicand));
  return fmt::format(
      "  $|r′|$ is no polynomial: $|r′|²$ has these factors to an odd power:\n    {}\n",
      in_words(Factored{reason.odd_factor}, notation));
}

/// The curve, or why there is none.
Fields fields(const IdentificationAnswer& answer) {
  Fields fields{json_field("phrame", "identify/1"), json_field("name", answer.name)};
  const auto append = [&](const Fields& more) {
    fields.insert(fields.end(), more.begin(), more.end());
  };
  if (const auto* curve = std::get_if<Curve>(&answer.result)) {
    const QuaternionPolynomial& a = curve->preimage();
    append({json_field("ph", true),
            json_field("degree", degree(*curve)),
            {"multiplier", "$f$", curve->multiplier()},
            preimage_field(a),
            json_field("start", json_of(curve->start())),
            {"speed", "$f|A|²$", Factored{curve->multiplier() * sigma(a)}},
            json_field("checked", true)});  // nothing unchecked leaves identify()
  } else {
    const auto& reason = std::get<NotPythagorean>(answer.result);
    append({json_field("ph", false), json_field("reason", to_string(reason)),
            json_field("odd_factor", json_of(reason.odd_factor)),
            json_field("radicand", reason.radicand.str())});
  }
  return fields;
}

}  // namespace

std::string to_text(const IdentificationAnswer& answer) {
  const auto* curve = std::get_if<Curve>(&answer.result);
  if (curve == nullptr)
    return name_prefix(answer.name) + "not a PH curve over ℚ\n\n" +
           prose(reason_text(std::get<NotPythagorean>(answer.result), Notation::unicode),
                 Notation::unicode);
  return fmt::format(
      "{}\n\nr′ = f · A i A* with A = u + v i + p j + q k\n\n{}\n"
      "  Checked: f · A i A* is r′, exactly.\n",
      heading(answer.name, *curve), to_rows(fields(answer), 5));
}

std::string to_latex(const IdentificationAnswer& answer) {
  if (const auto* reason = std::get_if<NotPythagorean>(&answer.result))
    return "Not a PH curve over $\\mathbb{Q}$:\n" +
           prose(reason_text(*reason, Notation::latex), Notation::latex);
  return "$r' = f \\cdot A i A^*$ with $A = u + v i + p j + q k$:\n" + to_align(fields(answer));
}

std::string to_json(const IdentificationAnswer& answer) { return pretty(json_of(fields(answer))); }

}  // namespace phrame
