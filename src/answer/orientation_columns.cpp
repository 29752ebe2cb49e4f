#include "phrame/answer/orientation_columns.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/rounding.hpp"
#include "phrame/answer/table_row.hpp"
#include "phrame/ph/frame/frame_quaternion.hpp"

namespace phrame {
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

/// x to the right, y up, and z to the back.
Frame<Real> of_camera(const Frame<Real>& frame) {
  return {frame.e3, frame.e2, {-frame.e1[0], -frame.e1[1], -frame.e1[2]}};
}

}  // namespace

std::size_t OrientationColumns::width() const {
  return std::size_t{6} + (have_quaternions_ ? 4 : 0) + (have_matrices_ ? 16 : 0);
}

void OrientationColumns::add_quaternion(TableRow& row, TabulatedFrame kind,
                                        const Frame<Real>& frame) {
  const auto [u, v, p, q] = quaternion_of(are_cameras_ ? of_camera(frame) : frame);
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

/// After t, r, e₁ at the beginning of the row, and e₂, e₃ at these places of it.
template <class Cell>
void add_matrix(std::vector<Cell>& row, std::size_t e2, std::size_t e3, const Cell& zero,
                const Cell& one) {
  for (std::size_t k = 0; k < 3; ++k)
    for (const std::size_t from : {4 + k, e2 + k, e3 + k, 1 + k}) row.push_back(Cell(row[from]));
  row.insert(row.end(), {zero, zero, zero, one});
}

}  // namespace

void OrientationColumns::add(TableRow& row, TabulatedFrame kind, const Frame<Real>& frame) {
  const std::size_t second = row.values.size();
  row.add(frame.e2);
  row.add(frame.e3);
  if (have_quaternions_) add_quaternion(row, kind, frame);
  if (!have_matrices_) return;
  add_matrix<double>(row.values, second, second + 3, 0, 1);
  if (row.digits > 0) add_matrix<std::string>(row.decimals, second, second + 3, "0", "1");
}

void OrientationColumns::add(std::vector<double>& row, const Frame<double>& frame) const {
  const std::size_t second = row.size();
  row.insert(row.end(), frame.e2.begin(), frame.e2.end());
  row.insert(row.end(), frame.e3.begin(), frame.e3.end());
  if (have_matrices_) add_matrix<double>(row, second, second + 3, 0, 1);
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
