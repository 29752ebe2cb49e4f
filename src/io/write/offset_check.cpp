#include "phrame/answer/offset_check.hpp"

#include <fmt/format.h>

#include "phrame/io/write/answers.hpp"
#include "phrame/io/write/boundary_fields.hpp"
#include "phrame/io/write/field.hpp"
#include "phrame/io/write/heading.hpp"
#include "phrame/io/write/names.hpp"

namespace phrame::inline v0 {
namespace {

using Check = OffsetCheckAnswer;

std::string at_words(const Check::Place& x, const char* t) {
  return fmt::format("{}{} = {}", x.is_join ? "the join at " : "", t, with_minus_sign(x.t.value));
}

JsonOutput json_of(const Check::Place& x) {
  return {{"t", x.t.value},
          {"join", x.is_join},
          {"point", JsonOutput::array({x.point[0].value, x.point[1].value})}};
}

JsonOutput json_of(const Check::Side& side) {
  const auto stretch = [](const Check::Stretch& x) -> JsonOutput {
    return {{"from", json_of(x.from)},
            {"to", json_of(x.to)},
            {"farthest", json_of(x.farthest)},
            {"at_least", lower_bound_text(x.at_least, 3)},
            {"proved", x.is_proved}};
  };
  return {{"at_least", lower_bound_text(side.at_least, 3)},
          {"at_most", upper_bound_text(side.at_most, 3)},
          {"farthest", json_of(side.farthest)},
          {"count", side.count},
          {"stretches", array_of(side.stretches, stretch)}};
}

std::string side_words(const Check::Side& side, const char* t) {
  return fmt::format("{} to {}, at {}: {}", lower_bound_text(side.at_least, 3),
                     upper_bound_text(side.at_most, 3), at_words(side.farthest, t),
                     point_in_words(side.farthest.point, Notation::unicode));
}

/// The worst ones.
std::vector<std::string> stretch_words(const Check::Side& side, const char* t) {
  constexpr std::size_t most = 8;
  std::vector<std::string> rows;
  for (const Check::Stretch& x : side.stretches) {
    if (rows.size() == most) break;
    rows.push_back(fmt::format("from {} to {}: {} at {}{}", at_words(x.from, t), at_words(x.to, t),
                               lower_bound_text(x.at_least, 3),
                               point_in_words(x.farthest.point, Notation::unicode),
                               x.is_proved ? "" : ", undecided"));
  }
  if (side.count > rows.size())
    rows.push_back(fmt::format("and {} more", side.count - rows.size()));
  return rows;
}

Fields check_fields(const Check& answer) {
  const OffsetCheckQuery& query = answer.query;
  const auto side = [](const Check::Side& x, const char* t) -> Value {
    return {Value::Words([&x, t](Notation) { return side_words(x, t); }),
            [&x] { return json_of(x); }};
  };
  const auto stretches = [](const Check::Side& x, const char* t) -> Value {
    return {Value::Rows([&x, t](Notation) { return stretch_words(x, t); }), nullptr};
  };
  const auto tolerance = [&](Notation) { return upper_bound_text(query.tolerance, 3); };
  const auto verdict = [&](Notation) -> std::string {
    return answer.passes ? "yes" : answer.is_decided ? "no" : "undecided";
  };
  return {{"distance", "distance d", query.distance},
          {"trimmed",
           "checked against",
           {Value::Words([&](Notation) -> std::string {
              return query.trim ? "the trimmed offset" : "all of the offset";
            }),
            [&] { return JsonOutput(query.trim); }}},
          {"tolerance",
           "tolerance",
           {Value::Words(tolerance), [&] { return json_of(query.tolerance); }}},
          json_field("closed_polylines", answer.closed),
          {"missing", "offset → given", side(answer.missing, "t")},
          {"", "  missing", stretches(answer.missing, "t")},
          {"excess", "given → offset", side(answer.excess, "u")},
          {"", "  too much", stretches(answer.excess, "u")},
          json_field("decided", answer.is_decided),
          {"passes", "within", {Value::Words(verdict), [&] { return JsonOutput(answer.passes); }}}};
}

}  // namespace

std::string to_text(const OffsetCheckAnswer& answer) {
  constexpr std::size_t width = 18;
  std::string text = heading(answer.path) + "\n\n" + to_rows(check_fields(answer), width);
  if (answer.closed > 0)
    text += fmt::format(
        "\nPolylines that do not end where they start are closed, as the offset is: {}.\n",
        answer.closed);
  return text;
}

std::string to_json(const OffsetCheckAnswer& answer) {
  JsonOutput json = {{"phrame", "offset-check/1"},
                     {"name", answer.path.name},
                     {"join", name_of(answer.query.join)}};
  json.update(json_of(check_fields(answer)));
  add_nearness(json, answer.path.near);
  return pretty(json);
}

}  // namespace phrame
