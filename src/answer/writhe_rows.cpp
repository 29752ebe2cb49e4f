#include "phrame/answer/writhe_rows.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/answer/rounded.hpp"
#include "phrame/ph/along/smooth_shape.hpp"
#include "phrame/ph/along/smooth_totals.hpp"
#include "phrame/ph/along/up_vector.hpp"
#include "phrame/ph/curve/shape.hpp"
#include "phrame/ph/frame/closed_curve.hpp"

namespace phrame {
namespace {

using Row = TotalsAnswer::Row;

Row reason_row(Quantity quantity, std::string reason) {
  Row row{quantity};
  row.reason = std::move(reason);
  return row;
}

Row undecided_row(Quantity quantity, const Undecided& undecided) {
  return reason_row(quantity, std::string("undecided: ") + undecided.what());
}

bool bends_continuously(const PhPath& path) {
  return has_continuous_frenet_frame(by_positions(path));
}
bool bends_continuously(const Path& path) { return has_continuous_frenet_frame(path); }

Real torsion_of(const PhPath& path) { return total_torsion(path).value; }
Real torsion_of(const Path& path) { return total_torsion(path); }

template <class P>
Row self_linking_row(const ClosedFrame& frame, const P& path) {
  try {
    if (!bends_continuously(path))
      return reason_row(Quantity::self_linking,
                        "the Frenet frame is not defined and continuous all along");
    Row row{Quantity::self_linking};
    row.value = Decimal{std::to_string(self_linking_number(frame, torsion_of(path))), "0"};
    return row;
  } catch (const Undecided& undecided) {
    return undecided_row(Quantity::self_linking, undecided);
  }
}

/// Of a closed curve, or why there is none. In a plane the writhe is known without a frame.
template <class P>
std::vector<Row> rows_of(const P& path, long digits) {
  Row row{Quantity::writhe};
  const auto set = [&](const Real& value) {
    row.value = rounded_or_zero(value, name_of(Quantity::writhe), digits);
  };
  const bool is_plane = plane_normal(path).has_value();
  try {
    if (is_plane) set(writhe(path));
    const ClosedFrame frame = closed_frame(path);
    if (!is_plane) set(writhe(frame));
    return {row, self_linking_row(frame, path)};
  } catch (const DomainError& error) {
    row.reason = error.what();
  } catch (const Undecided& undecided) {
    if (row.value) return {row, undecided_row(Quantity::self_linking, undecided)};
    row = undecided_row(Quantity::writhe, undecided);
  }
  return {row, reason_row(Quantity::self_linking, "the writhe is not known")};
}

}  // namespace

std::vector<Row> writhe_rows(const PhPath& path, long digits) { return rows_of(path, digits); }
std::vector<Row> writhe_rows(const Path& path, long digits) { return rows_of(path, digits); }

}  // namespace phrame
