#pragma once
#include <nlohmann/json.hpp>

#include "phrame/answer/angle.hpp"
#include "phrame/integrate/path_end.hpp"

namespace phrame::inline v0 {

// The pieces of phrame's JSON output. Not a public header: it shows nlohmann's types.
using JsonOutput = nlohmann::ordered_json;

/// Ascending exact strings: ["6", "-12", "1/2"]; [] for 0.
JsonOutput json_of(const Polynomial& p);
/// {"re": […], "im": […]}.
JsonOutput json_of(const GaussianPolynomial& p);
/// {"numerator": […], "denominator": […]}.
JsonOutput json_of(const RationalFunction& f);
/// {"a": "…", "b": "…", "d": "…"}: a + b√d; {"a": "…", "roots": [{"b": "…", "d": "…"}, …]} where
/// there are several roots.
JsonOutput json_of(const Surd& x);
/// {"a": […], "b": […], "d": "…"}, or with "roots" likewise.
JsonOutput json_of(const SurdPolynomial& p);
/// {"index": …, "residue": …, "argument": […]}.
JsonOutput json_of(const LogSum& sum);
/// {"polynomial": …, "rational": …, "logs": […], "form": …, "checked": true}.
JsonOutput json_of(const Antiderivative& F);
/// Its "real" or "radicals", if it is one of these.
void add_other_form(JsonOutput& json, const OtherForm& form);
/// {"polynomial": …, "rational": …, "logarithms": [{"factor", "of", "positive"}], "arctangents":
/// [{"factor", "of"}], "log_quotients": [{"factor", "of", "radicand"}], "others": […], "checked":
/// true}. "factor" and "radicand" are as a Surd is, "of" as a SurdPolynomial; an arctangent has a
/// "radicand" unless it is 1. "others" are LogSums.
JsonOutput json_of(const RealForm& F);
/// {"logs": […]}, each with "roots" of the index, "residues" and "real_roots" beside what a LogSum
/// has; radicals as "(1 + sqrt(3)*I)/2".
JsonOutput json_of(const RadicalForm& F);
/// "3/7", "inf", "-inf", {"polynomial": …, "interval": […], "value": "…"}, and of a PiValue
/// {"expression": "2/3*pi", "value": "…"}.
JsonOutput json_of(const PathEnd& end);
/// {"value": "…", "radius": "…"}.
JsonOutput json_of(const Decimal& x);
/// {"lower": "…", "upper": "…"}, bounds of a number ≥ 0 with six digits.
JsonOutput json_of_bounds(const RealBall& x);
/// "values": [{"t": "…", "theta": "…", "radius": "…"}, …]; where they were asked for by another
/// parameter "by": "native" before it, and the value of that in each: {"native": "…", "t": …}.
void add_values(JsonOutput& json, const std::vector<AngleValue>& values, ParameterKind by);
/// The exact text, or the decimal x was rounded to.
JsonOutput json_of(const Real& x, const Decimal& rounded);
/// As a PathEnd; a text where it is rational.
JsonOutput json_of(const RealAlgebraic& x);
JsonOutput json_of(const Vector<Rational>& point);
/// @{ An array of what `json` gives for each of the list, or of the json_of() each.
template <class List, class Json>
JsonOutput array_of(const List& list, const Json& json) {
  JsonOutput array = JsonOutput::array();
  for (const auto& x : list) array.push_back(json(x));
  return array;
}
template <class List>
JsonOutput array_of(const List& list) {
  return array_of(list, [](const auto& x) { return json_of(x); });
}
/// @}
/// null where it is undecided.
JsonOutput json_if_known(const std::optional<bool>& x);
/// A "note" for a file with a curve that stands for another.
void add_note(JsonOutput& json, const std::optional<Nearness>& near);
/// A curve/1 object in the power basis.
JsonOutput json_of(const NamedCurve& named);
/// The same of a rational curve, by control points or by polynomials over w.
JsonOutput json_of(const RationalCurve& curve);
/// A curve/1 or spline/1 file.
JsonOutput json_of(const NamedPath& named);
/// {"epsilon": "…", "distance": "…", "unrounded_distance": "…", "bits": …, "rmf_difference":
/// "…"}, bounds; null where there is none of the last.
JsonOutput json_of(const Nearness& nearness);
/// The same as "near", where the path of an answer stands for another.
void add_nearness(JsonOutput& json, const std::optional<Nearness>& near);

/// Indented by 2, but with every list of strings, or of such lists, on one line.
std::string pretty(const JsonOutput& json);

}  // namespace phrame
