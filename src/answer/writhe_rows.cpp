#include "phrame/answer/writhe_rows.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/answer/rounded.hpp"
#include "phrame/ph/along/curvature.hpp"
#include "phrame/ph/along/up_vector.hpp"
#include "phrame/ph/frame/closed_curve.hpp"

namespace phrame::inline v0 {
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

Row self_linking_row(const ClosedFrame& frame, const Path& path) {
  try {
    if (!has_continuous_frenet_frame(path))
      return reason_row(Quantity::self_linking,
                        "the Frenet frame is not defined and continuous all along");
    Row row{Quantity::self_linking};
    row.value = Decimal{std::to_string(self_linking_number(frame, total_torsion(path).value)), "0"};
    return row;
  } catch (const Undecided& undecided) {
    return undecided_row(Quantity::self_linking, undecided);
  }
}

}  // namespace

// In a plane the writhe is known without a frame.
std::vector<Row> writhe_rows(const Path& path, long digits) {
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

}  // namespace phrame
