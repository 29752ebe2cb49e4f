#include "phrame/answer/totals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "phrame/answer/rounded.hpp"
#include "phrame/answer/writhe_rows.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/shape.hpp"

namespace phrame {
namespace {

using Row = TotalsAnswer::Row;

Row row(Quantity quantity, PathTotal total, long digits) {
  Row row{quantity, std::move(total)};
  row.value = rounded(row.total->value, name_of(quantity), digits);
  return row;
}

Row row(Quantity quantity, const std::variant<PathTotal, Infinite>& total, long digits) {
  if (const auto* finite = std::get_if<PathTotal>(&total)) return row(quantity, *finite, digits);
  Row row{quantity};
  row.infinite = std::get<Infinite>(total);
  return row;
}

Row without_value(Quantity quantity, std::string reason) {
  Row row{quantity};
  row.reason = std::move(reason);
  return row;
}

/// The first segment, counted from 1, for which that holds; 0 where there is none.
std::size_t first_segment(const PhPath& path, const std::function<bool(const Curve&)>& holds) {
  const auto& segments = path.segments();
  const auto found = std::find_if(segments.begin(), segments.end(), holds);
  return found == segments.end() ? 0 : static_cast<std::size_t>(found - segments.begin()) + 1;
}

/// Why there is no torsion; empty where there is.
std::string why_no_torsion(const PhPath& path) {
  const std::size_t line = first_segment(
      path, [](const Curve& curve) { return line_direction(curve.preimage()).has_value(); });
  if (line == 0) return "";
  if (path.is_curve()) return "a straight line has no torsion";
  return fmt::format("segment {} is a straight line, which has no torsion", line);
}

std::string why_no_curvature(const PhPath& path) {
  const std::string why = "κ is not rational, since ρ is not a constant times a square";
  if (path.is_curve()) return why;
  const std::size_t first = first_segment(
      path, [](const Curve& curve) { return !double_ph(curve.preimage()).has_value(); });
  return fmt::format("segment {}: {}", first, why);
}

}  // namespace

const char* name_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::length:
      return "length";
    case Quantity::erf_twist:
      return "twist of the ERF";
    case Quantity::torsion:
      return "total torsion";
    case Quantity::curvature:
      return "total curvature";
    case Quantity::rotation_index:
      return "absolute rotation index";
    case Quantity::bending_energy:
      return "bending energy";
    case Quantity::frenet_energy:
      return "energy of the Frenet frame";
    case Quantity::up_twist:
      return "twist of the frame of v";
    case Quantity::holonomy:
      return "holonomy";
    case Quantity::closing_turn:
      return "turn per length that closes a sweep";
    case Quantity::writhe:
      return "writhe";
    case Quantity::self_linking:
      break;
  }
  return "self-linking number";
}

TotalsAnswer answer(const NamedPhPath& named, const TotalsQuery& query) {
  const PhPath& path = named.path;
  const long digits = query.digits;
  const std::string no_torsion = why_no_torsion(path);
  TotalsAnswer answer{named, {}, digits};
  const auto add = [&](Row row) { answer.rows.push_back(std::move(row)); };
  add(row(Quantity::length, total_length(path), digits));
  add(row(Quantity::erf_twist, erf_twist(path), digits));
  add(no_torsion.empty() ? row(Quantity::torsion, total_torsion(path), digits)
                         : without_value(Quantity::torsion, no_torsion));
  const auto curvature = total_curvature(path);
  add(curvature ? row(Quantity::curvature, *curvature, digits)
                : without_value(Quantity::curvature, why_no_curvature(path)));
  Row index = without_value(Quantity::rotation_index,
                            path.is_curve() ? "not a plane curve" : "not in one plane");
  if (const auto found = absolute_rotation_index(path))
    index.value = rounded(*found, name_of(Quantity::rotation_index), digits);
  add(std::move(index));
  add(row(Quantity::bending_energy, bending_energy(path), digits));
  add(no_torsion.empty() ? row(Quantity::frenet_energy, frenet_energy(path), digits)
                         : without_value(Quantity::frenet_energy, no_torsion));
  if (!path.closing_turn()) return answer;
  for (Row& of_writhe : writhe_rows(path, digits)) add(std::move(of_writhe));
  return answer;
}

}  // namespace phrame
