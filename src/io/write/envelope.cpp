#include "phrame/answer/envelope.hpp"

#include <fmt/format.h>

#include "phrame/io/write/answers.hpp"
#include "phrame/io/write/boundary_fields.hpp"
#include "phrame/io/write/field.hpp"

namespace phrame::inline v0 {
namespace {

using OneSide = EnvelopeAnswer::OneSide;
using EnvelopeKind = EnvelopePiece::Kind;

std::string name_of(EnvelopeKind kind) {
  return kind == EnvelopeKind::right ? "right" : kind == EnvelopeKind::left ? "left" : "arc";
}

std::string words_before(EnvelopeKind kind) {
  return kind == EnvelopeKind::right  ? "right, "
         : kind == EnvelopeKind::left ? "left, "
                                      : "arc at ";
}

JsonOutput places_json(const std::vector<RealAlgebraic>& places) {
  return array_of(places, [](const RealAlgebraic& t) { return json_of(t); });
}

Value spacelike_value(const EnvelopeAnswer::Segment& segment) {
  const auto rows = [&](Notation notation) {
    if (segment.lightlike.empty()) return std::vector<std::string>{"everywhere"};
    std::vector<std::string> list;
    for (const RealAlgebraic& t : segment.lightlike)
      list.push_back("but at " + at_place(t, notation) +
                     ", where both sides touch one point of the disc");
    return list;
  };
  return {Value::Rows(rows), [&] { return places_json(segment.lightlike); }};
}

Value side_value(const OneSide& side) {
  const auto rows = [&](Notation notation) {
    std::vector<std::string> list;
    if (side.curve)
      list = paths_value({*side.curve}).rows(notation);
    else
      list.push_back(formula(fmt::format("({}, {})", in_words(side.start[0], Notation::unicode),
                                         in_words(side.start[1], Notation::unicode)),
                             notation) +
                     ", in which all discs touch");
    for (const RealAlgebraic& t : side.cusps)
      list.push_back("cusp at " + at_place(t, notation) + ", where it turns back");
    return list;
  };
  const auto json = [&]() -> JsonOutput {
    JsonOutput found{{"start", {to_string(side.start[0]), to_string(side.start[1])}},
                     {"cusps", places_json(side.cusps)}};
    if (side.curve) found["curve"] = json_of(NamedPath("", *side.curve));
    return found;
  };
  return {Value::Rows(rows), json};
}

Fields fields(const EnvelopeAnswer::Segment& segment) {
  const auto& n = segment.null_factors;
  return {{"degree",
           "degree",
           {Value::Words([&](Notation) { return std::to_string(segment.degree); }),
            [&] { return JsonOutput(segment.degree); }}},
          {"multiplier", "$f$", segment.curve.multiplier},
          preimage_field(segment.curve.preimage),
          object_field(
              "null_factors",
              {{"a", "$a$", n[0]}, {"b", "$b$", n[1]}, {"c", "$c$", n[2]}, {"d", "$d$", n[3]}}),
          {"sigma", "$σ$", segment.sigma},
          {"lightlike", "spacelike", spacelike_value(segment)},
          {"right", "right", side_value(segment.right)},
          {"left", "left", side_value(segment.left)}};
}

Fields fields(const EnvelopeAnswer::Branch& branch) {
  const auto rows = [&](Notation notation) {
    std::vector<std::string> list;
    for (const auto& [from, to, kind] : branch.pieces)
      list.push_back(
          kind == EnvelopeKind::right || kind == EnvelopeKind::left
              ? fmt::format("{} to {}", in_words(from, words_before(kind), notation),
                            in_words(to, "", notation))
              : fmt::format("{} from {} to {}", in_words(from, words_before(kind), notation),
                            point_in_words(from.at, notation), point_in_words(to.at, notation)));
    return list;
  };
  const auto json = [](const EnvelopeAnswer::Piece& x) -> JsonOutput {
    return {{"from", json_of(x.from)}, {"to", json_of(x.to)}, {"on", name_of(x.kind)}};
  };
  return {json_field("closed", branch.is_closed),
          {"paths", "boundary", paths_value(branch.paths)},
          {"parts", "  part", {Value::Rows(rows), [&branch, json] {
                                 return array_of(branch.pieces, json);
                               }}}};
}

Value undecided_value(const EnvelopeAnswer& answer) {
  const auto rows = [&](Notation notation) {
    std::vector<std::string> list;
    for (const auto& [t, kind] : answer.undecided)
      list.push_back("near " + words_before(kind) + at(t[0].value, notation));
    return list;
  };
  const auto json = [](const EnvelopeAnswer::UndecidedStretch& x) -> JsonOutput {
    return {{"from", json_of(x.t[0])}, {"to", json_of(x.t[1])}, {"on", name_of(x.kind)}};
  };
  return {Value::Rows(rows), [&answer, json] { return array_of(answer.undecided, json); }};
}

/// What there is beside the segments.
std::vector<Fields> rest_of(const EnvelopeAnswer& answer) {
  if (!answer.is_trimmed) return {{{"paths", "envelope", paths_value(answer.paths)}}};
  std::vector<Fields> list;
  for (const auto& branch : answer.branches) list.push_back(fields(branch));
  if (!answer.undecided.empty()) list.push_back({{"", "undecided", undecided_value(answer)}});
  return list;
}

}  // namespace

std::string to_text(const EnvelopeAnswer& answer) {
  constexpr std::size_t width = 20;
  const std::size_t count = answer.segments.size();
  std::string text = answer.name.empty() ? "" : answer.name + ": ";
  text += count == 1 ? "curve with radii\n" : fmt::format("{} curves with radii\n", count);
  for (std::size_t k = 0; k < count; ++k) {
    if (count > 1) text += fmt::format("\nsegment {}, from t = {} to t = {}", k + 1, k, k + 1);
    text += "\n" + to_rows(fields(answer.segments[k]), width);
  }
  for (const Fields& more : rest_of(answer)) text += "\n" + to_rows(more, width);
  return text;
}

std::string to_json(const EnvelopeAnswer& answer) {
  const auto object = [](const auto& x) { return json_of(fields(x)); };
  JsonOutput json{{"phrame", "envelope/1"},
                  {"name", answer.name},
                  {"segments", array_of(answer.segments, object)}};
  if (answer.is_trimmed) {
    json["branches"] = array_of(answer.branches, object);
    json["undecided"] = undecided_value(answer).json();
  } else {
    json["paths"] = paths_value(answer.paths).json();
  }
  return pretty(json);
}

std::string to_latex(const EnvelopeAnswer& answer) {
  std::string text;
  for (const auto& segment : answer.segments) text += to_align(fields(segment));
  for (const Fields& more : rest_of(answer)) text += to_align(more);
  return text;
}

std::string write_envelope(const EnvelopeAnswer& answer) {
  return write_named(answer.name, all_paths(answer));
}

}  // namespace phrame
