#include "phrame/answer/orientation_columns.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/rounding.hpp"
#include "phrame/answer/table_row.hpp"
#include "phrame/ph/curve/scale.hpp"
#include "phrame/ph/frame/frame_quaternion.hpp"

namespace phrame::inline v0 {
namespace {

struct FrameNames {
  const char* frame;
  const char* second;
  const char* third;
};

FrameNames names_of(TabulatedFrame frame) {
  switch (frame) {
    case TabulatedFrame::rmf:
      return {"rmf", "f2", "f3"};
    case TabulatedFrame::euler_rodrigues:
      return {"erf", "e2", "e3"};
    case TabulatedFrame::frenet:
      return {"frenet", "n", "b"};
    case TabulatedFrame::up:
      return {"up", "up2", "up3"};
    case TabulatedFrame::mtf:
      return {"mtf", "mtf2", "mtf3"};
    case TabulatedFrame::exact_mtf:
      return {"exact_mtf", "exact_mtf2", "exact_mtf3"};
    case TabulatedFrame::signed_frenet:
      return {"signed_frenet", "sn", "sb"};
  }
  return {"", "", ""};
}

/// Is −q the one to write after `last`, which has no value in the first row?
bool is_to_be_negated(const std::array<double, 4>& q,
                      const std::optional<std::array<double, 4>>& last) {
  if (last) {
    Rational product;  // exact, so that whoever has the table can decide it, too
    for (std::size_t k = 0; k < 4; ++k)
      product += exact_rational(q[k]) * exact_rational((*last)[k]);
    if (product != 0) return product < 0;
  }
  const auto nonzero = std::find_if(q.rbegin(), q.rend(), [](double x) { return x != 0; });
  return nonzero != q.rend() && *nonzero < 0;
}

/// The axes of the body of which one is the tangent.
template <class T>
Frame<T> axes_of(const Frame<T>& frame, const TangentAxis& tangent) {
  const auto& [e1, f2, f3] = frame;
  const std::array<Vector<T>, 3> from =
      tangent.is_reversed
          ? std::array<Vector<T>, 3>{each(e1, [](const T& x) { return T(-x); }), f3, f2}
          : std::array<Vector<T>, 3>{e1, f2, f3};
  const auto axis = [&](std::size_t k) { return from[(k + 3 - tangent.axis) % 3]; };
  return {axis(0), axis(1), axis(2)};
}

}  // namespace

std::size_t OrientationColumns::width() const {
  return std::size_t{6} + (have_quaternions_ ? 4 : 0) + (have_matrices_ ? 16 : 0);
}

void OrientationColumns::add_quaternion(TableRow& row, TabulatedFrame kind,
                                        const Frame<Real>& frame) {
  const auto [u, v, p, q] = quaternion_of(axes_of(frame, axis_of(kind)));
  std::array<Real, 4> exact{v, p, q, u};
  const auto rounded = [&] {
    return std::array<double, 4>{round_to_double(exact[0]), round_to_double(exact[1]),
                                 round_to_double(exact[2]), round_to_double(exact[3])};
  };
  const auto last = last_.find(kind);
  if (is_to_be_negated(rounded(), last == last_.end() ? std::nullopt : std::optional(last->second)))
    for (Real& x : exact) x = -x;
  last_[kind] = rounded();
  for (const Real& x : exact) row.add(x);
}

namespace {

double negative(double x) { return x == 0 ? x : -x; }
std::string negative(const std::string& x) {
  if (x == "0" || x.empty()) return x;
  return x.front() == '-' ? x.substr(1) : "-" + x;
}

/// After t, r, e₁ at the beginning of the row, and e₂, e₃ from this place of it on: the axes of the
/// body, and r.
template <class Cell>
void add_matrix(std::vector<Cell>& row, std::size_t e2, const TangentAxis& tangent,
                const Cell& zero, const Cell& one) {
  std::array<std::size_t, 3> from{};
  from[tangent.axis] = 4;
  from[(tangent.axis + 1) % 3] = tangent.is_reversed ? e2 + 3 : e2;
  from[(tangent.axis + 2) % 3] = tangent.is_reversed ? e2 : e2 + 3;
  for (std::size_t k = 0; k < 3; ++k) {
    for (const std::size_t axis : from) {
      const Cell cell = row[axis + k];
      row.push_back(axis == 4 && tangent.is_reversed ? negative(cell) : cell);
    }
    row.push_back(Cell(row[1 + k]));
  }
  row.insert(row.end(), {zero, zero, zero, one});
}

}  // namespace

void OrientationColumns::add(TableRow& row, TabulatedFrame kind, const Frame<Real>& frame) {
  const std::size_t second = row.values.size();
  row.add(frame.e2);
  row.add(frame.e3);
  if (have_quaternions_) add_quaternion(row, kind, frame);
  if (!have_matrices_) return;
  const TangentAxis axis = axis_of(kind);
  add_matrix<double>(row.values, second, axis, 0, 1);
  if (row.digits > 0) add_matrix<std::string>(row.decimals, second, axis, "0", "1");
}

void OrientationColumns::add(std::vector<double>& row, const Frame<double>& frame) const {
  const std::size_t second = row.size();
  row.insert(row.end(), frame.e2.begin(), frame.e2.end());
  row.insert(row.end(), frame.e3.begin(), frame.e3.end());
  if (have_matrices_) add_matrix<double>(row, second, {}, 0, 1);
}

void add_names(std::vector<std::string>& names, TabulatedFrame kind, const TableColumns& columns) {
  const FrameNames called = names_of(kind);
  for (const char* vector : {called.second, called.third})
    for (const char axis : {'x', 'y', 'z'}) names.push_back(fmt::format("{}{}", vector, axis));
  if (columns.have_quaternions)
    for (const char axis : {'x', 'y', 'z', 'w'})
      names.push_back(fmt::format("{}_q{}", called.frame, axis));
  if (columns.have_matrices)
    for (int k = 0; k < 16; ++k)
      names.push_back(fmt::format("{}_m{}{}", called.frame, 1 + k / 4, 1 + k % 4));
}

}  // namespace phrame
