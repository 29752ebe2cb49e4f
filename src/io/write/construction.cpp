#include "phrame/io/write/construction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "phrame/io/write/heading.hpp"
#include "phrame/io/write/json_text.hpp"
#include "phrame/io/write/text.hpp"

namespace phrame {
namespace {

/// "auto"; "angles" where they were given.
std::string choice_name(const QuinticChoice& choice) {
  const auto* selection = std::get_if<QuinticSelection>(&choice);
  if (selection == nullptr) return "angles";
  const auto& names = quintic_selections();
  return std::find_if(names.begin(), names.end(),
                      [&](const auto& named) { return named.second == *selection; })
      ->first;
}

/// ", auto", ", solution 1 of 4"; nothing where there is no choice.
std::string which_text(const ConstructionAnswer& answer) {
  if (answer.kind.kind == CurveKind::quintic) return ", " + choice_name(answer.choice);
  if (answer.kind.solutions == 1) return "";
  const bool are_all_there = answer.kind.kind == CurveKind::planar;
  return fmt::format(", solution {} of {}{}", answer.solution, are_all_there ? "" : "up to ",
                     answer.kind.solutions);
}

const char* name_of(DerivativeSource source) {
  switch (source) {
    case DerivativeSource::given:
      return "given";
    case DerivativeSource::tangents:
      return "tangents given, speeds of the chords";
    case DerivativeSource::natural_spline:
      return "natural C2 cubic spline";
    case DerivativeSource::periodic_spline:
      break;
  }
  return "periodic C2 cubic spline";
}

const char* name_of(ParameterSource source) {
  switch (source) {
    case ParameterSource::given:
      return "given";
    case ParameterSource::whole_numbers:
      return "0, 1, 2, ...";
    case ParameterSource::chord_lengths:
      break;
  }
  return "chord lengths";
}

std::string decimal(const Real& x, long digits) { return round_to_decimal(x, digits).value; }

std::string energy_text(double energy) {
  return std::isfinite(energy) ? decimal(exact_rational(energy), 6) : "∞";
}

const char* preimage_exception(const ConstructionAnswer& answer) {
  if (answer.points == PointRule::exact) return ", but for those between the points";
  if (!answer.data.is_closed) return "";
  return answer.kind.continuity == Continuity::c2 ? ", but for what closes the spline"
                                                  : ", but for the last two segments";
}

const char* joints_text(Continuity continuity) {
  switch (continuity) {
    case Continuity::g1:
      return "position and tangent are equal, exactly";
    case Continuity::c1:
      return "position and derivative by the parameter are equal fractions";
    case Continuity::c2:
      break;
  }
  return "position and both derivatives by the parameter are equal fractions";
}

Rational length(const ConstructionAnswer& answer) {
  Rational sum;
  for (const ConstructionAnswer::Segment& segment : answer.segments) sum += segment.length;
  return sum;
}

double energy(const ConstructionAnswer& answer) {
  double sum = 0;
  for (const ConstructionAnswer::Segment& segment : answer.segments) sum += segment.energy;
  return sum;
}

/// "within 6.9e-17, proved; asked for: 1e-15"
std::string bound_text(const Rational& bound, const Rational& asked) {
  return fmt::format("{}, proved; asked for: {}",
                     bound == 0 ? "exact" : "within " + upper_bound_text(bound),
                     upper_bound_text(asked));
}

std::string segment_table(const ConstructionAnswer& answer) {
  const bool have_angles = answer.segments.front().angles.has_value();
  const auto angle_text = [](const Angle& angle) { return decimal(to_real(angle), 6); };
  std::string head = fmt::format("\n  {:>7}", "segment");
  if (have_angles) head += fmt::format("  {:>11}  {:>11}", "Δ", "φ");
  head += fmt::format("  {:>12}  {:>12}\n", "length", "∫ κ² ds");
  std::string list;
  for (std::size_t k = 0; k < answer.segments.size(); ++k) {
    const auto& [angles, length, energy] = answer.segments[k];
    list += fmt::format("  {:>7}", k + 1);
    if (have_angles)
      list += fmt::format("  {:>11}  {:>11}", angle_text(angles->delta), angle_text(angles->phi));
    list += fmt::format("  {:>12}  {:>12}\n", decimal(length, 8), energy_text(energy));
  }
  constexpr std::size_t most = 20;
  if (answer.segments.size() <= most) return head + list;
  return head + passage(list, fmt::format("  ⟨{}⟩\n", counted(answer.segments.size(), "segment")));
}

}  // namespace

const std::vector<std::pair<std::string, QuinticSelection>>& quintic_selections() {
  static const std::vector<std::pair<std::string, QuinticSelection>> names{
      {"auto", QuinticSelection::automatic},
      {"minimal", QuinticSelection::minimal},
      {"bv", QuinticSelection::bv},
      {"cc", QuinticSelection::cc},
      {"shortest", QuinticSelection::shortest},
      {"longest", QuinticSelection::longest},
      {"energy", QuinticSelection::energy}};
  return names;
}

std::string to_text(const ConstructionAnswer& answer) {
  std::string text = heading(answer.path) + "\n\n";
  const auto row = [&](std::string_view label, const std::string& value) {
    text += phrame::row(label, value, 14);
  };
  row("kind", std::string(answer.kind.name) + which_text(answer));
  row("data", fmt::format("{}{}", counted(answer.data.points.size(), "point"),
                          answer.data.is_closed ? ", the last of them the first" : ""));
  const bool only_at_ends = answer.kind.is_through_points;
  if (!only_at_ends || !answer.data.is_closed)
    row("  derivatives",
        fmt::format("{}{}", name_of(answer.derivatives_from), only_at_ends ? ", at the ends" : ""));
  row("  parameters", name_of(answer.parameters_from));
  row("points met", answer.points == PointRule::exact
                        ? "exactly, as equal fractions"
                        : bound_text(answer.deviation.points, answer.tolerance.points));
  if (!only_at_ends || !answer.data.is_closed)
    row(answer.kind.continuity == Continuity::g1 ? "tangents" : "derivatives",
        bound_text(answer.deviation.derivatives, answer.tolerance.derivatives));
  if (!answer.data.accelerations.empty())
    row("accelerations",
        bound_text(answer.deviation.accelerations, answer.tolerance.accelerations));
  if (!answer.path.path.is_curve()) row("joints", joints_text(answer.kind.continuity));
  if (!answer.kind.law.empty()) row("shape", fmt::format("{}, checked", answer.kind.law));
  if (answer.kind.continuity != Continuity::g1 && answer.kind.kind != CurveKind::rmf)
    row("preimage", fmt::format("coefficients are multiples of 2^{}{}", -answer.bits,
                                preimage_exception(answer)));
  row("length", "≈ " + decimal(length(answer), 12));
  row("energy ∫ κ² ds", "about " + energy_text(energy(answer)));
  return text + segment_table(answer);
}

std::string to_json(const ConstructionAnswer& answer) {
  const auto energy_json = [](double energy) {
    return std::isfinite(energy) ? JsonOutput(energy_text(energy)) : JsonOutput("inf");
  };
  JsonOutput parameters = JsonOutput::array();
  for (const Rational& t : answer.parameters) parameters.push_back(to_string(t));
  JsonOutput segments = JsonOutput::array();
  for (const auto& [angles, length, energy] : answer.segments) {
    JsonOutput json = JsonOutput::object();
    if (angles) {
      json["delta"] = to_string(angles->delta);
      json["phi"] = to_string(angles->phi);
    }
    json["length"] = decimal(length, 17);
    json["energy"] = energy_json(energy);
    segments.push_back(std::move(json));
  }
  const auto deviation = [&](const Deviation& x) {
    JsonOutput json = {{"points", upper_bound_text(x.points)}};
    if (!answer.kind.is_through_points || !answer.data.is_closed)
      json["derivatives"] = upper_bound_text(x.derivatives);
    if (!answer.data.accelerations.empty())
      json["accelerations"] = upper_bound_text(x.accelerations);
    return json;
  };
  JsonOutput json = {
      {"phrame", "construct/1"}, {"name", answer.path.name}, {"kind", answer.kind.name}};
  if (answer.kind.kind == CurveKind::quintic) {
    json["select"] = choice_name(answer.choice);
  } else if (answer.kind.solutions > 1) {
    json["solution"] = answer.solution;
    json["solutions"] = answer.kind.solutions;
  }
  if (!answer.kind.law.empty()) json["law"] = answer.kind.law;
  json["closed"] = answer.path.path.closing_turn().has_value();
  json["derivatives_from"] = name_of(answer.derivatives_from);
  json["parameters_from"] = name_of(answer.parameters_from);
  json["parameters"] = parameters;
  json["tolerance"] = deviation(answer.tolerance);
  json["deviation"] = deviation(answer.deviation);
  json["bits"] = answer.bits;
  json["length"] = decimal(length(answer), 17);
  json["energy"] = energy_json(energy(answer));
  json["segments"] = segments;
  return pretty(json);
}

}  // namespace phrame
