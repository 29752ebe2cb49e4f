#include "phrame/answer/totals.hpp"

#include <fmt/format.h>

#include <array>

#include "phrame/algebra/error.hpp"
#include "phrame/answer/rounded.hpp"
#include "phrame/answer/writhe_rows.hpp"
#include "phrame/ph/along/known_poles.hpp"
#include "phrame/ph/along/path_angle.hpp"
#include "phrame/ph/along/plane_turning.hpp"
#include "phrame/ph/along/segment_integral.hpp"
#include "phrame/ph/along/up_vector.hpp"
#include "phrame/ph/frame/closed_curve.hpp"
#include "phrame/ph/frame/signed_frenet.hpp"

namespace phrame::inline v0 {
namespace {

using Row = TotalsAnswer::Row;

/// Adds rows to an answer.
class Totals {
 public:
  explicit Totals(TotalsAnswer& answer) : answer_(answer) {}

  void add(Quantity quantity, PathTotal total) {
    const Decimal value = rounded(total, name_of(quantity), answer_.digits);
    const std::optional<Rational> exact = total.value.exact();
    answer_.rows.push_back(
        {.quantity = quantity, .total = std::move(total), .value = value, .exact = exact});
  }
  void add(Quantity quantity, const std::variant<PathTotal, Infinite>& value) {
    if (const auto* finite = std::get_if<PathTotal>(&value)) return add(quantity, *finite);
    answer_.rows.push_back({.quantity = quantity, .infinite = std::get<Infinite>(value)});
  }
  void add(Quantity quantity, const Real& value) {
    const Decimal rounded = rounded_or_zero(value, name_of(quantity), answer_.digits);
    answer_.rows.push_back({.quantity = quantity, .value = rounded, .exact = value.exact()});
  }
  /// What find() returns; where it throws, the reason.
  template <class Find>
  void add_found(Quantity quantity, const Find& find) {
    try {
      add(quantity, find());
    } catch (const DomainError& error) {
      add_reason(quantity, error.what());
    } catch (const Undecided& undecided) {
      add_reason(quantity, std::string("undecided: ") + undecided.what());
    }
  }
  void add_reason(Quantity quantity, std::string reason) {
    answer_.rows.push_back({.quantity = quantity, .reason = std::move(reason)});
  }

 private:
  TotalsAnswer& answer_;
};

/// Why there is no torsion; empty where there is.
std::string why_no_torsion(const Path& path) {
  const auto& segments = path.segments();
  for (std::size_t k = 0; k < segments.size(); ++k) {
    if (!is_straight(Path(segments[k]))) continue;
    if (segments.size() == 1) return "a straight line has no torsion";
    return fmt::format("segment {} is a straight line, which has no torsion", k + 1);
  }
  return "";
}

void add_absolute_rotation_index(Totals& totals, const Path& path, const PathTotal& curvature) {
  if (const auto index = absolute_rotation_index(path, curvature))
    totals.add(Quantity::rotation_index, *index);
  else
    totals.add_reason(Quantity::rotation_index,
                      path.segments().size() == 1 ? "not a plane curve" : "not in one plane");
}

/// Of a plane path.
void add_rotation_index(Totals& totals, const Path& path) {
  try {
    if (const auto index = rotation_index(path))
      totals.add(Quantity::signed_rotation_index, *index);
  } catch (const Undecided& undecided) {
    totals.add_reason(Quantity::signed_rotation_index,
                      std::string("undecided: ") + undecided.what());
  }
}

/// Of a closed path.
void add_holonomy(Totals& totals, const PathAngle& angle, const Real& length) {
  try {
    const Real turn = angle.holonomy().value();
    totals.add(Quantity::holonomy, turn);
    totals.add(Quantity::closing_turn,
               turn.exact() == Rational(0) ? turn : closing_turn_per_length(turn, length));
  } catch (const Undecided& undecided) {
    totals.add_reason(Quantity::holonomy, std::string("undecided: ") + undecided.what());
    totals.add_reason(Quantity::closing_turn, "the holonomy is undecided");
  }
}

}  // namespace

constexpr std::array quantity_names{"length",
                                    "twist of the ERF",
                                    "total torsion",
                                    "total curvature",
                                    "absolute rotation index",
                                    "bending energy",
                                    "energy of the Frenet frame",
                                    "twist of the frame of v",
                                    "rotation index",
                                    "holonomy",
                                    "turn per length that closes a sweep",
                                    "writhe",
                                    "self-linking number",
                                    "linking number",
                                    "helicity"};
static_assert(quantity_names.size() == static_cast<std::size_t>(Quantity::helicity) + 1);

const char* name_of(Quantity kind) { return quantity_names[static_cast<std::size_t>(kind)]; }

TotalsAnswer answer(const NamedPath& named, const TotalsQuery& query) {
  const Path& path = named.path;
  const PathAngle angle(path);
  TotalsAnswer answer{named, {}, query.digits};
  Totals totals(answer);
  const std::optional<PhPath> ph = path.ph();
  if (!ph) {
    answer.up = angle.up();
    find_together(path, {length_rate(), up_frame_rate(angle.up()), torsion_rate(), curvature_rate(),
                         bending_rate(), squared_torsion_rate()});
  }
  const std::string no_torsion = why_no_torsion(path);
  const PathTotal length = total_length(path);
  const PathTotal curvature = total_curvature(path);
  KnownPoles poles;
  totals.add(Quantity::length, length);
  if (ph)
    totals.add(Quantity::erf_twist, erf_twist(*ph, poles));
  else
    totals.add(Quantity::up_twist, reference_twist(angle));
  const auto add_frenet = [&](Quantity quantity, const auto& find) {
    no_torsion.empty() ? totals.add_found(quantity, find) : totals.add_reason(quantity, no_torsion);
  };
  add_frenet(Quantity::torsion, [&] { return total_torsion(path, poles); });
  totals.add(Quantity::curvature, curvature);
  add_absolute_rotation_index(totals, path, curvature);
  totals.add(Quantity::bending_energy, bending_energy(path, poles));
  add_frenet(Quantity::frenet_energy, [&] { return frenet_energy(path, poles); });
  add_rotation_index(totals, path);
  const Closure closed = closure(path);
  if (!closed.is_closed)
    for (const Quantity quantity :
         {Quantity::holonomy, Quantity::closing_turn, Quantity::writhe, Quantity::self_linking})
      totals.add_reason(quantity, "undecided: " + closed.undecided);
  if (closed.is_closed == true) {
    add_holonomy(totals, angle, length.value);
    for (Row& row : writhe_rows(path, query.digits)) answer.rows.push_back(std::move(row));
  }
  if (query.other)
    totals.add_found(Quantity::linking,
                     [&] { return Real(Rational(linking_number(path, query.other->path))); });
  if (query.helicity_about)
    totals.add_found(Quantity::helicity,
                     [&] { return Real(SignedFrenet(path).turns_about(*query.helicity_about)); });
  return answer;
}

}  // namespace phrame
