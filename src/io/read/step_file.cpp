// Entities of ISO 10303-42, geometry and topology, in files of ISO 10303-21.
#include "phrame/io/read/step_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/io/read/curve_choice.hpp"
#include "phrame/io/read/number.hpp"
#include "phrame/io/read/part21.hpp"
#include "phrame/io/read/space_conic.hpp"
#include "phrame/ph/curve/bspline.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

using StepKind = Part21Value::Kind;
using Entities = std::vector<Part21Entity>;

/// Where a curve is cut off: a place, its parameter, or both.
struct StepEnd {
  std::optional<Vector<Rational>> place = {};
  std::optional<Rational> parameter = {};
};

class StepCurves {
 public:
  StepCurves(const Part21File& file, const CurveLimits& limits)
      : file_(file), limits_(limits), is_in_degrees_(has_degrees()) {}

  /// A curve that has ends, or goes around.
  DrawnCurve curve(long number, const Part21Entity& from, int depth = 0) const;
  DrawnCurve curve(const Entities& entities, int depth = 0) const;

 private:
  bool has_degrees() const;
  Entities instance(long number, const Part21Entity& from) const {
    return file_.instance(number, from);
  }
  Vector<Rational> vector(const Part21Entity& entity, std::size_t k, const char* what) const;
  Vector<Rational> place(long number, const Part21Entity& from, const char* name) const;
  SpaceConic conic(const Part21Entity& entity) const;
  DrawnCurve spline(const Entities& entities) const;
  DrawnCurve polyline(const Part21Entity& entity) const;
  DrawnCurve composite(const Part21Entity& entity, int depth) const;
  DrawnCurve edge(const Part21Entity& entity, int depth) const;
  StepEnd trim(const Part21Entity& entity, std::size_t k) const;
  DrawnCurve between(long basis, const Part21Entity& from, const StepEnd& start, const StepEnd& end,
                     bool is_along, int depth) const;
  DrawnCurve line_between(const Part21Entity& line, const StepEnd& start, const StepEnd& end) const;
  DrawnCurve arc(const Part21Entity& entity, const StepEnd& start, const StepEnd& end,
                 bool is_along) const;
  DrawnCurve open_conic(const Part21Entity& entity, const StepEnd& start, const StepEnd& end) const;
  DrawnCurve part_of_spline(const Part21Entity& from, DrawnCurve whole, StepEnd start, StepEnd end,
                            bool is_along) const;

  const Part21File& file_;
  const CurveLimits& limits_;
  bool is_in_degrees_;
};

[[noreturn]] void fail_for_kind(const Entities& entities) {
  std::string names;
  for (const Part21Entity& entity : entities)
    names += (names.empty() ? "" : ", ") + std::string(entity.name);
  entities.front().fail(fmt::format(
      "{} is not read; curves are B-splines of all kinds, POLYLINE, and LINE, CIRCLE, ELLIPSE, "
      "PARABOLA or HYPERBOLA between ends",
      entities.size() == 1 ? "this" : abbreviated(names, 120)));
}

bool StepCurves::has_degrees() const {
  return std::ranges::any_of(file_.entries(), [](const auto& entry) {
    const std::string_view body = entry.second.body;
    return body.find("PLANE_ANGLE_UNIT") != std::string_view::npos &&
           body.find("CONVERSION_BASED_UNIT") != std::string_view::npos;
  });
}

Vector<Rational> StepCurves::vector(const Part21Entity& entity, std::size_t k,
                                    const char* what) const {
  const std::vector<Rational> numbers = entity.numbers(k, what);
  if (numbers.size() != 3) entity.fail(fmt::format("{} numbers, not 3", numbers.size()));
  return {numbers[0], numbers[1], numbers[2]};
}

Vector<Rational> StepCurves::place(long number, const Part21Entity& from, const char* name) const {
  const Entities entities = instance(number, from);
  const Part21Entity* found = find_entity(entities, name);
  if (found == nullptr)
    from.fail(fmt::format("#{} is no {} but {}", number, name, entities.front().name));
  return vector(*found, 1, "a list of 3 numbers");
}

// AXIS2_PLACEMENT_3D: location, axis (z), reference direction (x, or else y, where z is x).
SpaceConic StepCurves::conic(const Part21Entity& entity) const {
  const Entities entities = instance(entity.reference(1, "a placement"), entity);
  const Part21Entity* placement = find_entity(entities, "AXIS2_PLACEMENT_3D");
  if (placement == nullptr)
    entity.fail(
        fmt::format("its placement is no AXIS2_PLACEMENT_3D but {}", entities.front().name));
  const auto direction = [&](std::size_t k, const Vector<Rational>& otherwise) {
    if (k >= placement->values.size() || placement->values[k].kind == StepKind::none)
      return otherwise;
    return place(placement->reference(k, "a direction"), *placement, "DIRECTION");
  };
  const Vector<Rational> axis = direction(2, {0, 0, 1});
  const Vector<Rational> x = direction(
      3, axis[1] == 0 && axis[2] == 0 ? Vector<Rational>{0, 1, 0} : Vector<Rational>{1, 0, 0});
  const Rational a = entity.number(2, "a radius");
  const Rational b =
      entity.name == "CIRCLE" || entity.name == "PARABOLA" ? a : entity.number(3, "a radius");
  return of_entity(entity, [&] {
    return conic_about(place(placement->reference(1, "a point"), *placement, "CARTESIAN_POINT"),
                       axis, x, {a, b});
  });
}

/// A B-spline's kind, by which its knots are known.
const Part21Entity* spline_kind(const Entities& entities) {
  for (const char* name :
       {"B_SPLINE_CURVE_WITH_KNOTS", "BEZIER_CURVE", "QUASI_UNIFORM_CURVE", "UNIFORM_CURVE"})
    if (const Part21Entity* kind = find_entity(entities, name)) return kind;
  return nullptr;
}

/// The knots of the kinds that have none in the file: whole numbers, 0 at the start but for uniform
/// ones, where it is in the middle of them.
std::vector<Rational> implicit_knots(const Part21Entity& kind, long degree, std::size_t points) {
  const auto last = static_cast<long>(points) - 1;
  std::vector<Rational> knots;
  for (long k = 0; k <= last + degree + 1; ++k) {
    if (kind.name == "UNIFORM_CURVE")
      knots.emplace_back(k - degree);
    else if (kind.name == "BEZIER_CURVE")
      knots.emplace_back(k == 0 ? 0 : std::min(k - 1, last) / degree);
    else
      knots.emplace_back(std::clamp(k - degree, 0L, last + 1 - degree));
  }
  if (kind.name == "BEZIER_CURVE" && last % degree != 0)
    kind.fail(fmt::format("{} points are none of Bézier curves of degree {}", points, degree));
  return knots;
}

// The parameters of a complex instance are those of its parts, in their order; the name is that of
// REPRESENTATION_ITEM.
DrawnCurve StepCurves::spline(const Entities& entities) const {
  const Part21Entity& kind = *spline_kind(entities);
  const bool is_complex = entities.size() > 1;
  const Part21Entity* base = is_complex ? find_entity(entities, "B_SPLINE_CURVE") : &kind;
  if (base == nullptr) kind.fail("there is no B_SPLINE_CURVE with it");
  const std::size_t first = is_complex ? 0 : 1;
  BSpline spline;
  spline.degree = base->whole_number(first, limits_.max_degree, "the degree");
  if (spline.degree < 1) base->fail("the degree is 0");
  for (const long point : base->references(first + 1, "a list of points"))
    spline.points.push_back(place(point, *base, "CARTESIAN_POINT"));
  if (kind.name == "B_SPLINE_CURVE_WITH_KNOTS") {
    const std::size_t at = is_complex ? 0 : 6;
    const auto& multiplicities = kind.at(at, StepKind::list, "a list of multiplicities").items;
    const std::vector<Rational> values = kind.numbers(at + 1, "a list of knots");
    if (values.size() != multiplicities.size())
      kind.fail(
          fmt::format("{} multiplicities for {} knots", multiplicities.size(), values.size()));
    for (std::size_t k = 0; k < values.size(); ++k)
      spline.knots.insert(
          spline.knots.end(),
          static_cast<std::size_t>(kind.whole_number(multiplicities[k], spline.degree + 1)),
          values[k]);
  } else {
    spline.knots = implicit_knots(kind, spline.degree, spline.points.size());
  }
  if (const auto* rational = find_entity(entities, "RATIONAL_B_SPLINE_CURVE"))
    spline.weights = rational->numbers(0, "a list of weights");
  if (const auto fault = fault_of(spline)) kind.fail(fault->reason);
  return drawn_spline(spline);
}

DrawnCurve StepCurves::polyline(const Part21Entity& entity) const {
  std::vector<Vector<Rational>> points;
  for (const long number : entity.references(1, "a list of points"))
    points.push_back(place(number, entity, "CARTESIAN_POINT"));
  DrawnCurve curve{lines_through(points)};
  if (curve.pieces.empty()) entity.fail("two points are wanted");
  return curve;
}

DrawnCurve StepCurves::composite(const Part21Entity& entity, int depth) const {
  DrawnCurve curve;
  for (const long number : entity.references(1, "a list of segments")) {
    const Entities entities = instance(number, entity);
    const Part21Entity* segment = find_entity(entities, "COMPOSITE_CURVE_SEGMENT");
    if (segment == nullptr)
      entity.fail(
          fmt::format("#{} is no COMPOSITE_CURVE_SEGMENT but {}", number, entities.front().name));
    DrawnCurve next = this->curve(segment->reference(2, "a curve"), *segment, depth);
    if (!segment->flag(1, "the sense")) turn_back(next);
    std::ranges::move(next.pieces, std::back_inserter(curve.pieces));
  }
  if (curve.pieces.empty()) entity.fail("there are no segments");
  return curve;
}

StepEnd StepCurves::trim(const Part21Entity& entity, std::size_t k) const {
  StepEnd end;
  for (const Part21Value& item : entity.at(k, StepKind::list, "a list of trims").items) {
    if (item.kind == StepKind::reference) {
      const Part21Entity single{entity.name, {item}, entity.instance, entity.line};
      end.place = place(single.reference(0, "a point"), entity, "CARTESIAN_POINT");
    } else {
      end.parameter = entity.number(item);
    }
  }
  if (!end.place && !end.parameter) entity.fail("a trim is empty");
  return end;
}

DrawnCurve StepCurves::edge(const Part21Entity& entity, int depth) const {
  const auto vertex = [&](std::size_t k) {
    const Entities entities = instance(entity.reference(k, "a vertex"), entity);
    const Part21Entity* point = find_entity(entities, "VERTEX_POINT");
    if (point == nullptr) entity.fail("its vertices are no VERTEX_POINT");
    return StepEnd{place(point->reference(1, "a point"), *point, "CARTESIAN_POINT"), {}};
  };
  return between(entity.reference(3, "a curve"), entity, vertex(1), vertex(2),
                 entity.flag(4, "the sense"), depth);
}

DrawnCurve StepCurves::line_between(const Part21Entity& line, const StepEnd& start,
                                    const StepEnd& end) const {
  const auto place_of = [&](const StepEnd& at) {
    if (at.place) return *at.place;
    const Entities entities = instance(line.reference(2, "a vector"), line);
    const Part21Entity* along = find_entity(entities, "VECTOR");
    if (along == nullptr) line.fail("its direction is no VECTOR");
    const Vector<Rational> unit = of_entity(*along, [&] {
      return near_unit(place(along->reference(1, "a direction"), *along, "DIRECTION"));
    });
    return place(line.reference(1, "a point"), line, "CARTESIAN_POINT") +
           Rational(*at.parameter * along->number(2, "a length")) * unit;
  };
  return {{{{place_of(start), place_of(end)}}}};
}

DrawnCurve StepCurves::arc(const Part21Entity& entity, const StepEnd& start, const StepEnd& end,
                           bool is_along) const {
  const SpaceConic about = conic(entity);
  return of_entity(entity, [&]() -> DrawnCurve {
    if (start.place && end.place) return {arc_between(about, *start.place, *end.place, is_along)};
    if (!start.parameter || !end.parameter)
      entity.fail("one end is a place and the other a parameter");
    const auto turn = [&](const Rational& angle) {
      return is_in_degrees_ ? rotation_by_degrees(angle) : rotation_by_radians(angle);
    };
    return {arc_between(about, turn(*start.parameter), turn(*end.parameter), is_along)};
  });
}

/// There is one arc between two places of a parabola, and of a branch of a hyperbola.
DrawnCurve StepCurves::open_conic(const Part21Entity& entity, const StepEnd& start,
                                  const StepEnd& end) const {
  const bool is_parabola = entity.name == "PARABOLA";
  const SpaceConic about = conic(entity);
  return of_entity(entity, [&]() -> DrawnCurve {
    const auto place_of = [&](const StepEnd& at) {
      if (at.place) return *at.place;
      return (is_parabola ? on_parabola : on_hyperbola)(about, *at.parameter);
    };
    return {{(is_parabola ? parabola_between : hyperbola_between)(about, place_of(start),
                                                                  place_of(end))}};
  });
}

DrawnCurve StepCurves::part_of_spline(const Part21Entity& from, DrawnCurve whole, StepEnd start,
                                      StepEnd end, bool is_along) const {
  if (!is_along) std::swap(start, end);
  DrawnCurve part;
  if (start.parameter && end.parameter && !whole.knots.empty()) {
    const Rational& a = *start.parameter;
    const Rational& b = *end.parameter;
    if (!(whole.knots.front() <= a && a < b && b <= whole.knots.back()))
      from.fail(fmt::format("its part from {} to {} is not between its knots {} and {}",
                            as_written(a), as_written(b), as_written(whole.knots.front()),
                            as_written(whole.knots.back())));
    part = part_between(whole, a, b);
  } else {
    if (!start.place || !end.place ||
        !points_meet(*start.place, whole.pieces.front().points.front()) ||
        !points_meet(*end.place, whole.pieces.back().points.back()))
      from.fail("its ends are not those of its curve, and no parameters tell which part it is");
    part = std::move(whole);
  }
  if (!is_along) turn_back(part);
  return part;
}

DrawnCurve StepCurves::between(long basis, const Part21Entity& from, const StepEnd& start,
                               const StepEnd& end, bool is_along, int depth) const {
  const Entities entities = instance(basis, from);
  const Part21Entity& entity = entities.front();
  if (entity.name == "LINE") return line_between(entity, start, end);
  if (entity.name == "CIRCLE" || entity.name == "ELLIPSE") return arc(entity, start, end, is_along);
  if (entity.name == "PARABOLA" || entity.name == "HYPERBOLA")
    return open_conic(entity, start, end);
  if (entity.name == "SURFACE_CURVE" || entity.name == "SEAM_CURVE" ||
      entity.name == "INTERSECTION_CURVE")
    return between(entity.reference(1, "a curve"), entity, start, end, is_along, depth + 1);
  return part_of_spline(from, curve(entities, depth + 1), start, end, is_along);
}

DrawnCurve StepCurves::curve(long number, const Part21Entity& from, int depth) const {
  return curve(instance(number, from), depth + 1);
}

DrawnCurve StepCurves::curve(const Entities& entities, int depth) const {
  const Part21Entity& entity = entities.front();
  constexpr int deepest = 32;
  if (depth > deepest) entity.fail("curves are in curves more than 32 deep");
  if (spline_kind(entities) != nullptr) return spline(entities);
  if (entity.name == "POLYLINE") return polyline(entity);
  if (entity.name == "COMPOSITE_CURVE") return composite(entity, depth);
  if (entity.name == "EDGE_CURVE") return edge(entity, depth);
  if (entity.name == "TRIMMED_CURVE")
    return between(entity.reference(1, "a curve"), entity, trim(entity, 2), trim(entity, 3),
                   entity.flag(4, "the sense"), depth);
  if (entity.name == "CIRCLE" || entity.name == "ELLIPSE") {
    const StepEnd start{{}, Rational(0)};
    return arc(entity, start, start, true);
  }
  fail_for_kind(entities);
}

/// What its first parameter says, if that is a name.
std::string name_of(const Entities& entities) {
  const Part21Entity* item = find_entity(entities, "REPRESENTATION_ITEM");
  if (item == nullptr) item = &entities.front();
  return !item->values.empty() && item->values.front().kind == StepKind::text
             ? std::string(item->values.front().text)
             : "";
}

bool is_set_of_curves(std::string_view name) {
  return name == "GEOMETRIC_CURVE_SET" || name == "GEOMETRIC_SET";
}

/// May it be a curve by itself? A complex instance is one if it has a B-spline.
bool may_be_curve(const Part21File::Entry& entry) {
  static constexpr std::array<std::string_view, 9> names{"B_SPLINE_CURVE_WITH_KNOTS",
                                                         "BEZIER_CURVE",
                                                         "QUASI_UNIFORM_CURVE",
                                                         "UNIFORM_CURVE",
                                                         "POLYLINE",
                                                         "TRIMMED_CURVE",
                                                         "COMPOSITE_CURVE",
                                                         "CIRCLE",
                                                         "ELLIPSE"};
  if (!entry.name.empty()) return std::ranges::find(names, entry.name) != names.end();
  return entry.body.find("B_SPLINE_CURVE") != std::string_view::npos;
}

/// The instances that others refer to.
void add_references(const std::vector<Part21Value>& values, std::set<std::string_view>& found) {
  for (const Part21Value& value : values) {
    if (value.kind == StepKind::reference) found.insert(value.text);
    add_references(value.items, found);
  }
}

/// EDGE_CURVEs, or else curves that nothing refers to.
std::vector<long> single_curves(const Part21File& file) {
  std::vector<long> edges;
  for (const auto& [number, entry] : file.entries())
    if (entry.name == "EDGE_CURVE") edges.push_back(number);
  if (!edges.empty()) return edges;
  std::set<std::string_view> referred;
  for (const auto& [number, entry] : file.entries())
    for (const Part21Entity& entity : file.instance(number))
      add_references(entity.values, referred);
  std::vector<long> curves;
  for (const auto& [number, entry] : file.entries())
    if (may_be_curve(entry) && !referred.contains(std::to_string(number))) curves.push_back(number);
  return curves;
}

DrawnChain chain_of(DrawnCurve curve, const Entities& entities, const std::string& layer) {
  DrawnChain chain(std::move(curve), entities.front().line, layer,
                   fmt::format("#{}", entities.front().instance));
  if (const std::string name = name_of(entities); !name.empty()) chain.handles.push_back(name);
  return chain;
}

/// Of all sets, each as a layer. Points and surfaces in them are left out.
std::vector<DrawnChain> chains_of_sets(const Part21File& file, const StepCurves& curves) {
  std::vector<DrawnChain> parts;
  for (const auto& [number, entry] : file.entries()) {
    if (!is_set_of_curves(entry.name)) continue;
    const Entities set = file.instance(number);
    const std::string name = name_of(set);
    for (const long item : set.front().references(1, "a list of curves")) {
      const Entities entities = file.instance(item, set.front());
      const std::string_view kind = entities.front().name;
      if (kind == "CARTESIAN_POINT" || kind.ends_with("SURFACE") || kind.ends_with("POINT"))
        continue;
      parts.push_back(chain_of(curves.curve(entities), entities,
                               name.empty() ? fmt::format("#{}", number) : name));
    }
  }
  return chains_of_drawing(std::move(parts));
}

std::vector<std::string> notes_on(const Part21File& file) {
  const bool is_assembly = std::ranges::any_of(file.entries(), [](const auto& entry) {
    return entry.second.name == "NEXT_ASSEMBLY_USAGE_OCCURRENCE" ||
           entry.second.name == "MAPPED_ITEM";
  });
  if (!is_assembly) return {};
  return {"the file is of an assembly: the curve is where its part has it"};
}

}  // namespace

PointCurve read_step(std::string_view text, const FileReading& reading, const CurveLimits& limits) {
  reading.refuse_skipping("a STEP file");
  const Part21File file(text);
  const StepCurves curves(file, limits);
  const std::vector<long> singles = single_curves(file);
  std::vector<CurveLabel> labels;
  for (const long number : singles)
    labels.push_back({name_of(file.instance(number)), fmt::format("#{}", number)});
  const bool is_single_picked = std::ranges::any_of(labels, [&](const CurveLabel& label) {
    return !reading.pick.empty() && (label.name == reading.pick || label.id == reading.pick);
  });
  std::vector<DrawnChain> chains;
  if (!is_single_picked) chains = chains_of_sets(file, curves);
  if (chains.empty()) {
    if (singles.empty()) throw InputError("line 1", "there is no curve in the STEP file");
    const std::size_t second = std::min<std::size_t>(1, singles.size() - 1);
    const std::size_t at =
        chosen_curve(labels, reading.pick, line_place(file.entries().at(singles[second]).line));
    const Entities entities = file.instance(singles[at]);
    chains.push_back(chain_of(curves.curve(entities), entities, ""));
    return {labels[at].name, chosen_chain(chains, ""), notes_on(file)};
  }
  return {"", chosen_chain(chains, reading.pick), notes_on(file)};
}

}  // namespace phrame
