#include "phrame/ph/along/smooth_totals.hpp"

#include <fmt/format.h>

#include "phrame/algebra/error.hpp"
#include "phrame/answer/rounded.hpp"
#include "phrame/answer/writhe_rows.hpp"
#include "phrame/ph/along/path_angle.hpp"
#include "phrame/ph/along/path_length.hpp"
#include "phrame/ph/along/segment_integral.hpp"
#include "phrame/ph/along/up_vector.hpp"
#include "phrame/ph/frame/closed_curve.hpp"

namespace phrame {
namespace {

/// Adds rows to an answer.
class SmoothTotals {
 public:
  explicit SmoothTotals(TotalsAnswer& answer) : answer_(answer) {}

  void add(Quantity quantity, const Real& value) {
    TotalsAnswer::Row row{quantity};
    row.value = rounded_or_zero(value, name_of(quantity), answer_.digits);
    row.exact = value.exact();
    answer_.rows.push_back(std::move(row));
  }
  void add(Quantity quantity, const std::variant<Real, Infinite>& value) {
    if (const auto* finite = std::get_if<Real>(&value)) return add(quantity, *finite);
    TotalsAnswer::Row row{quantity};
    row.infinite = std::get<Infinite>(value);
    answer_.rows.push_back(std::move(row));
  }
  /// What there is without straight lines and, along formulas, inflections; else the reason.
  template <class Find>
  void add_frenet(Quantity quantity, const std::string& why_not, const Find& find) {
    if (!why_not.empty()) return add_reason(quantity, why_not);
    try {
      add(quantity, find());
    } catch (const DomainError& error) {
      add_reason(quantity, error.what());
    } catch (const Undecided& undecided) {
      add_reason(quantity, std::string("undecided: ") + undecided.what());
    }
  }
  void add_reason(Quantity quantity, std::string reason) {
    TotalsAnswer::Row row{quantity};
    row.reason = std::move(reason);
    answer_.rows.push_back(std::move(row));
  }

 private:
  TotalsAnswer& answer_;
};

/// Why there is no torsion; empty where there is.
std::string why_no_torsion(const Path& path) {
  const auto& segments = path.segments();
  if (segments.size() == 1) return is_straight(path) ? "a straight line has no torsion" : "";
  for (std::size_t k = 0; k < segments.size(); ++k)
    if (is_straight(Path(segments[k])))
      return fmt::format("segment {} is a straight line, which has no torsion", k + 1);
  return "";
}

/// x/2π.
Real in_turns(const Real& x) {
  if (x.exact() == Rational(0)) return x;
  return Real([x](long bits) {
    return divide(x.enclose(bits + 8), times_power_of_two(pi(bits + 8), 1), bits + 8);
  });
}

void add_holonomy(SmoothTotals& totals, const PathAngle& angle, const Real& length) {
  try {
    const Real turn = *angle.holonomy();
    totals.add(Quantity::holonomy, turn);
    totals.add(Quantity::closing_turn,
               turn.exact() == Rational(0) ? turn : closing_turn_per_length(turn, length));
  } catch (const Undecided& undecided) {
    totals.add_reason(Quantity::holonomy, std::string("undecided: ") + undecided.what());
    totals.add_reason(Quantity::closing_turn, "the holonomy is undecided");
  }
}

}  // namespace

TotalsAnswer answer(const NamedPath& named, const TotalsQuery& query) {
  const Path& path = named.path;
  const PathAngle angle(path, Reference::up);
  TotalsAnswer answer{named, {}, query.digits, angle.up()};
  SmoothTotals totals(answer);
  const std::string no_torsion = why_no_torsion(path);
  find_together(path, {length_rate(), up_frame_rate(angle.up()), torsion_rate(), curvature_rate(),
                       bending_rate(), squared_torsion_rate()});
  const Real length = PathLength(path).total();
  const Real curvature = total_curvature(path);
  totals.add(Quantity::length, length);
  totals.add(Quantity::up_twist, up_frame_twist(angle));
  totals.add_frenet(Quantity::torsion, no_torsion, [&] { return total_torsion(path); });
  totals.add(Quantity::curvature, curvature);
  is_straight(path) || plane_normal(path)
      ? totals.add(Quantity::rotation_index, in_turns(curvature))
      : totals.add_reason(Quantity::rotation_index,
                          path.segments().size() == 1 ? "not a plane curve" : "not in one plane");
  totals.add(Quantity::bending_energy, bending_energy(path));
  totals.add_frenet(Quantity::frenet_energy, no_torsion, [&] { return frenet_energy(path); });
  const Closure closed = closure(path);
  if (!closed.is_closed)
    for (const Quantity quantity :
         {Quantity::holonomy, Quantity::closing_turn, Quantity::writhe, Quantity::self_linking})
      totals.add_reason(quantity, "undecided: " + closed.undecided);
  if (closed.is_closed != true) return answer;
  add_holonomy(totals, angle, length);
  for (TotalsAnswer::Row& row : writhe_rows(path, query.digits))
    answer.rows.push_back(std::move(row));
  return answer;
}

}  // namespace phrame
