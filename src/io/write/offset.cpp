#include "phrame/answer/offset.hpp"

#include <fmt/format.h>

#include "phrame/algebra/as_written.hpp"
#include "phrame/io/write/answers.hpp"
#include "phrame/io/write/boundary_fields.hpp"
#include "phrame/io/write/cas_formula.hpp"
#include "phrame/io/write/closed_form.hpp"
#include "phrame/io/write/curve_file.hpp"
#include "phrame/io/write/field.hpp"
#include "phrame/io/write/heading.hpp"
#include "phrame/io/write/names.hpp"

namespace phrame::inline v0 {
namespace {

using Part = OffsetAnswer::Part;

JsonOutput json_of(const OffsetAnswer::Measure& x) {
  JsonOutput json = json_of(x.rounded);
  if (x.exact) json["exact"] = cas_formula(*x.exact, Language::plain);
  return json;
}

Value measure_value(const OffsetAnswer::Measure& x) {
  return {Value::Words([&](Notation notation) { return in_words(x, notation); }),
          [&] { return json_of(x); }};
}

Value cusps_value(const Part& part) {
  const auto rows = [&](Notation notation) {
    std::vector<std::string> list;
    for (const auto& [t, turns_back, point] : part.cusps)
      list.push_back(in_words(t, notation) +
                     (turns_back ? ", where it turns back" : ", where it goes on"));
    if (list.empty()) list.emplace_back("none");
    return list;
  };
  const auto json = [](const OffsetAnswer::Cusp& cusp) -> JsonOutput {
    return {{"t", json_of(cusp.t)},
            {"turns_back", cusp.turns_back},
            {"point", {json_of(cusp.at[0]), json_of(cusp.at[1])}}};
  };
  return {Value::Rows(rows), [&part, json] { return array_of(part.cusps, json); }};
}

JsonOutput json_of(const OffsetAnswer::Place& place) {
  JsonOutput json = json_of(place.t);
  json["join"] = place.is_join;
  return json;
}

JsonOutput json_of(const OffsetAnswer::Undecided& x) {
  const auto range = [](const std::array<Decimal, 2>& t) {
    return JsonOutput{json_of(t[0]), json_of(t[1])};
  };
  return {{"first", range(x.first)}, {"second", range(x.second)}};
}

/// How many there are at least, and whether these are all.
std::string count_text(const Part& part) {
  const std::string count = std::to_string(part.meetings.size());
  if (part.is_cut_off) return "at least " + count + "; the rest is undecided";
  if (part.undecided.empty())
    return part.meetings.empty() && part.coincident.empty() ? "none" : count;
  return fmt::format("{}, and {} undecided", count, counted(part.undecided.size(), "place"));
}

Value meetings_value(const Part& part) {
  const auto rows = [&](Notation notation) {
    std::vector<std::string> list{count_text(part)};
    for (const auto& [first, second, point, touches] : part.meetings)
      list.push_back(fmt::format("{}{} and {}: {}", touches ? "touches at " : "",
                                 in_words(first, notation), in_words(second, notation),
                                 formula(fmt::format("({}, {})", with_minus_sign(point[0].value),
                                                     with_minus_sign(point[1].value)),
                                         notation)));
    for (const auto& [first, second] : part.coincident)
      list.push_back(fmt::format("coincides from {} to {} with {} to {}",
                                 in_words(first[0], notation), in_words(first[1], notation),
                                 in_words(second[0], notation), in_words(second[1], notation)));
    for (const auto& [first, second] : part.undecided)
      list.push_back(fmt::format("undecided near {} and {}", at(first[0].value, notation),
                                 at(second[0].value, notation)));
    return list;
  };
  const auto json = [&] {
    const auto place = [](const OffsetAnswer::Meeting& x) {
      JsonOutput row{{"first", json_of(x.first)},
                     {"second", json_of(x.second)},
                     {"point", {json_of(x.at[0]), json_of(x.at[1])}}};
      if (x.touches) row["touches"] = true;
      return row;
    };
    const auto range = [](const OffsetAnswer::Coincident& x) {
      const auto ends = [](const std::array<OffsetAnswer::Place, 2>& t) {
        return JsonOutput{json_of(t[0]), json_of(t[1])};
      };
      return JsonOutput{{"first", ends(x.first)}, {"second", ends(x.second)}};
    };
    JsonOutput made{
        {"complete", part.undecided.empty() && !part.is_cut_off},
        {"count", part.meetings.size()},
        {"places", array_of(part.meetings, place)},
        {"undecided", array_of(part.undecided, [](const auto& x) { return json_of(x); })}};
    if (!part.coincident.empty()) made["coincident"] = array_of(part.coincident, range);
    return made;
  };
  return {Value::Rows(rows), json};
}

Value corners_value(const Part& part) {
  const auto rows = [&](Notation notation) {
    std::vector<std::string> list;
    for (const Rational& t : part.inner_corners)
      list.push_back(at(to_string(t), notation) + ", left as it is");
    return list;
  };
  return {Value::Rows(rows), [&] {
            return array_of(part.inner_corners, [](const Rational& t) { return to_string(t); });
          }};
}

Value stretches_value(const Part& part) {
  const auto rows = [&](Notation notation) {
    std::vector<std::string> list;
    if (part.stretches.size() > 1)
      for (const auto& [from, to, length] : part.stretches)
        list.push_back(fmt::format("from {} to {}: {}", in_words(from, notation),
                                   in_words(to, notation), in_words(length, notation)));
    return list;
  };
  const auto json = [](const OffsetAnswer::Stretch& x) -> JsonOutput {
    return {{"from", json_of(x.from)}, {"to", json_of(x.to)}, {"length", json_of(x.length)}};
  };
  return {Value::Rows(rows), [&part, json] { return array_of(part.stretches, json); }};
}

/// A long fraction as the decimal that it is.
std::string distance_in_words(const Rational& d, Notation notation) {
  return notation == Notation::unicode && is_long(d) ? with_minus_sign(as_written(d))
                                                     : in_words(d, notation);
}

Field distance_field(const Rational& d) {
  const auto words = [&](Notation notation) {
    return distance_in_words(d, notation) +
           (d > 0 ? ", to the right of travel" : ", to the left of travel");
  };
  return {"distance", "distance $d$", {Value::Words(words), [&] { return json_of(d); }}};
}

/// Stretches are of Euclidean offsets.
Fields fields(const Part& part) {
  const bool is_euclidean = !part.stretches.empty();
  Fields fields{distance_field(part.distance),
                {"paths", "exact", paths_value(part.paths)},
                {"cusps", is_euclidean ? "cusp, $1 + dκ = 0$" : "cusp", cusps_value(part)},
                {"self_intersections", "meets itself", meetings_value(part)},
                {"inner_corners", "inner corner", corners_value(part)},
                {"length", "length", measure_value(part.length)}};
  if (is_euclidean) fields.push_back({"stretches", "  stretch", stretches_value(part)});
  if (part.area) fields.push_back({"area", "signed area", measure_value(*part.area)});
  if (!part.paths.empty()) return fields;
  const auto none = [](Notation) { return std::string("none: nothing but points is left"); };
  for (std::size_t k = 1; k < fields.size(); ++k) fields[k] = in_json(std::move(fields[k]));
  fields.push_back({"", "exact", {Value::Words(none), nullptr}});
  return fields;
}

std::string is_join_text(const OffsetAnswer::TrimmedPiece& piece) {
  return piece.is_join ? "the join at " : "";
}

/// From cut to cut.
Value stretches_value(const OffsetAnswer::Branch& branch) {
  const auto rows = [&](Notation notation) {
    std::vector<std::string> list;
    const auto& pieces = branch.pieces;
    const auto is_cut_behind = [&](std::size_t k) {
      return pieces[k].is_cut_to || pieces[(k + 1) % pieces.size()].is_cut_from;
    };
    std::size_t first = 0;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      if (k + 1 < pieces.size() && !is_cut_behind(k)) continue;
      list.push_back(fmt::format(
          "from {} to {}", in_words(pieces[first].from, is_join_text(pieces[first]), notation),
          in_words(pieces[k].to, is_join_text(pieces[k]), notation)));
      if (k + 1 < pieces.size() || (branch.is_closed && is_cut_behind(k)))
        list.back() += ", cut in " + point_in_words(pieces[k].to.at, notation);
      first = k + 1;
    }
    return list;
  };
  const auto json = [](const OffsetAnswer::TrimmedPiece& x) -> JsonOutput {
    return {{"from", json_of(x.from)}, {"to", json_of(x.to)}, {"join", x.is_join}};
  };
  return {Value::Rows(rows), [&branch, json] { return array_of(branch.pieces, json); }};
}

Fields fields(const OffsetAnswer::Branch& branch) {
  Fields fields{json_field("closed", branch.is_closed),
                {"paths", "branch", paths_value(branch.paths)},
                {"parts", "  stretch", stretches_value(branch)},
                {"length", "  length", measure_value(branch.length)}};
  if (branch.area) fields.push_back({"area", "  signed area", measure_value(*branch.area)});
  return fields;
}

Value undecided_value(const OffsetAnswer::Trimmed& part) {
  const auto rows = [&](Notation notation) {
    std::vector<std::string> list;
    for (const auto& [t, is_join] : part.undecided)
      list.push_back((is_join ? "near the join at " : "near ") + at(t[0].value, notation));
    return list;
  };
  const auto json = [](const OffsetAnswer::UndecidedStretch& x) -> JsonOutput {
    return {{"from", json_of(x.t[0])}, {"to", json_of(x.t[1])}, {"join", x.is_join}};
  };
  return {Value::Rows(rows), [&part, json] { return array_of(part.undecided, json); }};
}

/// In words one after the other; in JSON a list.
Fields fields(const OffsetAnswer::Trimmed& part) {
  Fields list{distance_field(part.distance)};
  const auto json = [&] {
    return array_of(part.branches,
                    [](const OffsetAnswer::Branch& branch) { return json_of(fields(branch)); });
  };
  const auto none = [&](Notation) {
    std::vector<std::string> words;
    if (part.branches.empty())
      words.emplace_back("none: but for single points all of it is nearer to the path than |d|");
    return words;
  };
  list.push_back({"branches", "branch", {Value::Rows(none), json}});
  for (const auto& branch : part.branches)
    for (Field& field : fields(branch))
      if (!field.label.empty()) list.push_back({"", field.label, std::move(field.value)});
  list.push_back({"undecided", "undecided", undecided_value(part)});
  return list;
}

/// Of both sides of a curve that is not PH, by m.
Fields fields(const OffsetAnswer::Both& part) {
  const TwoSidedOffset& offset = part.offset;
  const auto by_m = [](const Polynomial& p) -> Value {
    return {Value::Words(
                [&p](Notation notation) { return formula(formatted(p, notation, "m"), notation); }),
            [&p] { return json_of(p); }};
  };
  const auto by = [&](Notation notation) {
    return formula(formatted_quotient(offset.parameter, notation, "m"), notation);
  };
  Fields list{{"distance",
               "distance $d$",
               {Value::Words([&](Notation notation) {
                  return distance_in_words(part.distance, notation) + ", to both sides";
                }),
                [&] { return json_of(part.distance); }}}};
  if (const auto& s = offset.once)
    list.push_back({"s",
                    "traced",
                    {Value::Words([&](Notation notation) {
                       return "several times, by " + formula("s =", notation) + " " +
                              formula(formatted_quotient(*s, notation, "t"), notation);
                     }),
                     [&] { return json_of(*s); }}});
  list.insert(list.end(), {{"parameter",
                            offset.once ? "$s$" : "$t$",
                            {Value::Words(by), [&] { return json_of(offset.parameter); }}},
                           {"x", "$X$", by_m(offset.numerator[0])},
                           {"y", "$Y$", by_m(offset.numerator[1])},
                           {"weight", "$W$", by_m(offset.weight)},
                           {"paths", "side", paths_value(part.paths)}});
  return list;
}

/// The gauge, and the segments without an offset under it.
Fields gauge_fields(const OffsetAnswer& answer) {
  const Gauge& gauge = *answer.gauge;
  const auto words = [&](Notation) {
    return fmt::format("closed convex rational curve of degree {}", gauge.degree());
  };
  const auto json = [&]() -> JsonOutput {
    return {
        {"x", json_of(gauge.x())}, {"y", json_of(gauge.y())}, {"weight", json_of(gauge.weight())}};
  };
  const auto rows = [&](Notation notation) {
    std::vector<std::string> list;
    for (const auto& [segment, degrees, kind] : answer.without) {
      list.push_back(fmt::format(
          "of segment {}: the irreducible factors of {} are of degree {} in {}", segment + 1,
          formula("r′ × U′", notation), fmt::join(degrees, ", "), formula("φ", notation)));
      if (kind) list.back() += "; " + in_words(*kind, "the discriminant of one", notation);
    }
    return list;
  };
  const auto without = [](const GaugeOffsets::None& none) {
    JsonOutput said = {{"segment", none.segment}, {"degrees", none.degrees}};
    if (none.kind) said["offset"] = json_of(*none.kind);
    return said;
  };
  return {{"gauge", "gauge $U(φ)$", {Value::Words(words), json}},
          {"without", "no rational offset", {Value::Rows(rows), [&answer, without] {
                                               return array_of(answer.without, without);
                                             }}}};
}

}  // namespace

std::string to_text(const OffsetAnswer& answer) {
  constexpr std::size_t width = 20;
  std::string text = heading(answer.path) + "\n";
  if (!answer.path.path.corners().empty() || closure(answer.path.path).at_corner)
    text += fmt::format("corners joined: {}\n", name_of(answer.join));
  if (answer.gauge) text += "\n" + to_rows(gauge_fields(answer), width);
  const auto ph = answer.path.path.with_preimages();
  const std::string signs = ph ? notes_on_signs(*ph) : "";
  if (!signs.empty()) text += "\n" + signs.substr(0, signs.size() - 1);
  for (const auto& part : answer.offsets) text += "\n" + to_rows(fields(part), width);
  for (const auto& part : answer.trimmed) text += "\n" + to_rows(fields(part), width);
  for (const auto& part : answer.both) text += "\n" + to_rows(fields(part), width);
  return text;
}

std::string to_json(const OffsetAnswer& answer) {
  const auto offset = [](const auto& part) { return json_of(fields(part)); };
  JsonOutput json = {{"phrame", "offset/1"},
                     {"name", answer.path.name},
                     {"closed", answer.is_closed},
                     {"join", name_of(answer.join)}};
  if (answer.gauge) json.update(json_of(gauge_fields(answer)));
  if (!answer.both.empty())
    json["both"] = array_of(answer.both, offset);
  else if (answer.trimmed.empty())
    json["offsets"] = array_of(answer.offsets, offset);
  else
    json["trimmed"] = array_of(answer.trimmed, offset);
  add_nearness(json, answer.path.near);
  return pretty(json);
}

std::string to_latex(const OffsetAnswer& answer) {
  std::string text;
  if (answer.gauge) text += to_align(gauge_fields(answer));
  for (const auto& part : answer.offsets) text += to_align(fields(part));
  for (const auto& part : answer.trimmed) text += to_align(fields(part));
  for (const auto& part : answer.both) text += to_align(fields(part));
  return text;
}

std::string write_offsets(const OffsetAnswer& answer) {
  return write_named(answer.path.name, all_paths(answer));
}

}  // namespace phrame
