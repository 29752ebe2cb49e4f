#include "phrame/answer/totals.hpp"

#include "phrame/answer/rounded.hpp"
#include "phrame/ph/curve/shape.hpp"

namespace phrame {
namespace {

using Row = TotalsAnswer::Row;

std::string name(Quantity quantity) {
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
      break;
  }
  return "energy of the Frenet frame";
}

Row row(Quantity quantity, Total total, long digits) {
  Row row{quantity, std::move(total)};
  row.value = rounded(row.total->value, name(quantity), digits);
  return row;
}

Row row(Quantity quantity, const std::variant<Total, Infinite>& total, long digits) {
  if (const auto* finite = std::get_if<Total>(&total)) return row(quantity, *finite, digits);
  Row row{quantity};
  row.infinite = std::get<Infinite>(total);
  return row;
}

Row without_value(Quantity quantity, std::string reason) {
  Row row{quantity};
  row.reason = std::move(reason);
  return row;
}

}  // namespace

TotalsAnswer answer(const NamedCurve& named, const TotalsQuery& query) {
  const Curve& curve = named.curve;
  const long digits = query.digits;
  const bool is_line = line_direction(curve.preimage()).has_value();
  constexpr auto why_no_torsion = "a straight line has no torsion";
  TotalsAnswer answer{named, {}, digits};
  const auto add = [&](Row row) { answer.rows.push_back(std::move(row)); };
  add(row(Quantity::length, total_length(curve), digits));
  add(row(Quantity::erf_twist, erf_twist(curve), digits));
  add(is_line ? without_value(Quantity::torsion, why_no_torsion)
              : row(Quantity::torsion, total_torsion(curve), digits));
  const auto curvature = total_curvature(curve);
  add(curvature ? row(Quantity::curvature, *curvature, digits)
                : without_value(Quantity::curvature,
                                "κ is not rational, since ρ is not a constant times a square"));
  Row index = without_value(Quantity::rotation_index, "not a plane curve");
  if (const auto found = absolute_rotation_index(curve))
    index.value = rounded(*found, name(Quantity::rotation_index), digits);
  add(std::move(index));
  add(row(Quantity::bending_energy, bending_energy(curve), digits));
  add(is_line ? without_value(Quantity::frenet_energy, why_no_torsion)
              : row(Quantity::frenet_energy, frenet_energy(curve), digits));
  return answer;
}

}  // namespace phrame
