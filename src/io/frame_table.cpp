#include "phrame/io/frame_table.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>

#include "phrame/algebra/error.hpp"
#include "phrame/io/json_text.hpp"
#include "phrame/ph/algebraic_frame.hpp"
#include "phrame/ph/arc_length.hpp"

namespace phrame {
namespace {

void add_columns(std::vector<std::string>& columns, std::string_view vector) {
  for (const char* axis : {"x", "y", "z"}) columns.push_back(fmt::format("{}{}", vector, axis));
}

void add_values(std::vector<double>& row, const Vector<double>& values) {
  row.insert(row.end(), values.begin(), values.end());
}

/// "t = 1/2", "t ≈ 0.33".
std::string text_of(const RealAlgebraic& t) {
  if (const auto r = t.rational()) return "t = " + abbreviated(to_string(*r));
  return "t ≈ " + to_string(enclose(t, 64), 12);
}

/// Throws Undecided where a number was rounded to infinity, which is no answer.
void require_finite(const std::vector<double>& row, const std::vector<std::string>& columns,
                    const RealAlgebraic& t) {
  for (std::size_t k = 0; k < row.size(); ++k)
    if (!std::isfinite(row[k]))
      throw Undecided(fmt::format("frame_table: at {}, {} is beyond the range of doubles",
                                  text_of(t), columns[k]));
}

std::pair<const char*, const char*> vector_names(TabulatedFrame frame) {
  switch (frame) {
    case TabulatedFrame::rmf:
      return {"f2", "f3"};
    case TabulatedFrame::erf:
      return {"e2", "e3"};
    case TabulatedFrame::frenet:
      return {"n", "b"};
  }
  return {"", ""};
}

/// A scalar as a function of t: f, or its square root.
struct Scalar {
  std::string name;
  RationalFunction f;
  bool is_square = false;
  bool is_on_segment = false;  ///< known for t in [0, 1] only

  Scalar(const Curve& curve, TabulatedScalar kind);
  double at(const AlgebraicPoint& t) const;
};

Scalar::Scalar(const Curve& curve, TabulatedScalar kind) {
  switch (kind) {
    case TabulatedScalar::arc_length:
      name = "s";
      f = RationalFunction(ArcLength(curve).polynomial());
      is_on_segment = !curve.multiplier().is_constant();
      return;
    case TabulatedScalar::curvature:
      name = "curvature";
      f = squared_curvature(curve);
      is_square = true;
      return;
    case TabulatedScalar::torsion:
      name = "torsion";
      f = torsion(curve);
      return;
    case TabulatedScalar::frenet_rate:
      name = "frenet_rate";
      f = squared_frenet_rate(curve);
      is_square = true;
      return;
  }
}

double Scalar::at(const AlgebraicPoint& t) const {
  if (is_on_segment && (compare(t.number(), 0) < 0 || compare(t.number(), 1) > 0))
    throw DomainError(
        fmt::format("frame_table: {} is outside [0, 1], where the sign of the multiplier is known",
                    text_of(t.number())));
  if (sign_at(f.denominator(), t.number()) == 0)
    throw DomainError(fmt::format("frame_table: {} is infinite at {}", name, text_of(t.number())));
  return round_to_double(is_square ? t.square_root(f) : t.value(f));
}

/// One row after the other. What a row of another kind would need is not prepared.
class Rows {
 public:
  Rows(const Curve& curve, const TableColumns& columns)
      : curve_(curve), columns_(columns), position_(position(curve)), frames_(curve) {
    for (const TabulatedScalar kind : columns.scalars) scalars_.emplace_back(curve, kind);
  }

  std::vector<std::string> names() const;
  std::vector<double> at(const RealAlgebraic& t);

 private:
  void add_rational(std::vector<double>& row, const Rational& t);
  void add_irrational(std::vector<double>& row, const AlgebraicPoint& t);

  const Curve& curve_;
  const TableColumns& columns_;
  Vector<Polynomial> position_;
  Frames frames_;
  std::vector<Scalar> scalars_;
  std::optional<RmfAngle> angle_;
  std::optional<AlgebraicFrames> algebraic_;
};

std::vector<std::string> Rows::names() const {
  std::vector<std::string> names{"t", "x", "y", "z"};
  add_columns(names, "e1");
  for (const TabulatedFrame frame : columns_.frames) {
    const auto [second, third] = vector_names(frame);
    add_columns(names, second);
    add_columns(names, third);
  }
  for (const Scalar& scalar : scalars_) names.push_back(scalar.name);
  return names;
}

std::vector<double> Rows::at(const RealAlgebraic& t) {
  const AlgebraicPoint point(t);
  std::vector<double> row{round_to_double(to_real(t))};
  if (const auto r = t.rational())
    add_rational(row, *r);
  else
    add_irrational(row, point);
  for (const Scalar& scalar : scalars_) row.push_back(scalar.at(point));
  return row;
}

template <class AnyFrame>
void add_normals(std::vector<double>& row, const AnyFrame& frame) {
  add_values(row, round_to_double(frame.e2));
  add_values(row, round_to_double(frame.e3));
}

void Rows::add_rational(std::vector<double>& row, const Rational& t) {
  const Frame<Rational> erf = frames_.euler_rodrigues(t);
  add_values(row, round_to_double(evaluate(position_, t)));
  add_values(row, round_to_double(erf.e1));
  for (const TabulatedFrame frame : columns_.frames) {
    if (frame == TabulatedFrame::erf) add_normals(row, erf);
    if (frame == TabulatedFrame::frenet) add_normals(row, frames_.frenet(t));
    if (frame != TabulatedFrame::rmf) continue;
    if (!angle_) angle_.emplace(curve_, Reference::erf);
    add_normals(row, frames_.rotation_minimizing(*angle_, t));
  }
}

void Rows::add_irrational(std::vector<double>& row, const AlgebraicPoint& t) {
  if (!algebraic_) algebraic_.emplace(curve_);
  for (const Polynomial& x : position_) row.push_back(round_to_double(t.value(x)));
  const Frame<Real> erf = algebraic_->euler_rodrigues(t);
  add_values(row, round_to_double(erf.e1));
  for (const TabulatedFrame frame : columns_.frames) {
    if (frame == TabulatedFrame::erf) add_normals(row, erf);
    if (frame == TabulatedFrame::frenet) add_normals(row, algebraic_->frenet(t));
    if (frame == TabulatedFrame::rmf) add_normals(row, algebraic_->rotation_minimizing(t));
  }
}

}  // namespace

FrameTable frame_table(const Curve& curve, const TableColumns& columns,
                       const std::vector<RealAlgebraic>& at) {
  Rows rows(curve, columns);
  FrameTable table{rows.names(), {}};
  for (const RealAlgebraic& t : at) {
    table.rows.push_back(rows.at(t));
    require_finite(table.rows.back(), table.columns, t);
  }
  return table;
}

FrameTable frame_table(const Curve& curve, const std::vector<TabulatedFrame>& frames,
                       const std::vector<Rational>& at) {
  return frame_table(curve, TableColumns{frames}, std::vector<RealAlgebraic>(at.begin(), at.end()));
}

std::string to_csv(const FrameTable& table) {
  std::string text = fmt::format("{}\n", fmt::join(table.columns, ","));
  for (const auto& row : table.rows) text += fmt::format("{}\n", fmt::join(row, ","));
  return text;
}

std::string to_json(const FrameTable& table) {
  const JsonOutput json = {
      {"phrame", table.format}, {"columns", table.columns}, {"rows", table.rows}};
  return json.dump() + "\n";
}

std::string to_npy(const FrameTable& table) {
  std::string header =
      fmt::format("{{'descr': '<f8', 'fortran_order': False, 'shape': ({}, {}), }}",
                  table.rows.size(), table.columns.size());
  constexpr std::size_t preamble = 10;  // magic, version, length of the header
  header.append(63 - (preamble + header.size()) % 64, ' ');
  header += '\n';
  std::string bytes("\x93NUMPY\x01\x00", 8);
  bytes += static_cast<char>(header.size() & 0xFFU);
  bytes += static_cast<char>(header.size() >> 8U);
  bytes += header;
  for (const auto& row : table.rows)
    for (const double x : row) {
      const auto bits = std::bit_cast<std::uint64_t>(x);
      for (unsigned shift = 0; shift < 64; shift += 8)
        bytes += static_cast<char>((bits >> shift) & 0xFFU);
    }
  return bytes;
}

}  // namespace phrame
