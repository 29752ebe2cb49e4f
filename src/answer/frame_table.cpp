#include "phrame/answer/frame_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/progress.hpp"
#include "phrame/answer/orientation_columns.hpp"
#include "phrame/ph/along/path_angle.hpp"
#include "phrame/ph/along/path_length.hpp"
#include "phrame/ph/along/reduced_angle.hpp"
#include "phrame/ph/frame/algebraic_frame.hpp"
#include "phrame/ph/frame/compiled_frame.hpp"

namespace phrame {
namespace {

void add_values(std::vector<double>& row, const Vector<double>& values) {
  row.insert(row.end(), values.begin(), values.end());
}

[[noreturn]] void throw_no_up() {
  throw DomainError("frame up: only tables of curves that are not Pythagorean-hodograph have it");
}

const char* name_of(TabulatedScalar kind) {
  switch (kind) {
    case TabulatedScalar::arc_length:
      return "s";
    case TabulatedScalar::curvature:
      return "curvature";
    case TabulatedScalar::torsion:
      return "torsion";
    case TabulatedScalar::frenet_rate:
      return "frenet_rate";
  }
  return "";
}

/// Of the arc length, where it is known for all t.
RationalFunction function_of(const Curve& curve, TabulatedScalar kind) {
  switch (kind) {
    case TabulatedScalar::arc_length:
      if (!curve.multiplier().is_constant()) break;
      return RationalFunction(ArcLength(curve).polynomial());
    case TabulatedScalar::curvature:
      return squared_curvature(curve);
    case TabulatedScalar::torsion:
      return torsion(curve);
    case TabulatedScalar::frenet_rate:
      return squared_frenet_rate(curve);
  }
  return {};
}

/// t of a place, which has to be algebraic.
RealAlgebraic number_of(const Place& at) {
  if (const auto t = algebraic_number(at)) return *t;
  throw DomainError("arc length: the multiplier changes sign at an irrational t before this one");
}

/// "t = 3/2", "t ≈ 1.33".
std::string text_of(const Place& at) { return place("t", algebraic_parameter(at).value()); }

/// A scalar as a function of t: f, or its square root.
struct Scalar {
  TabulatedScalar kind;
  RationalFunction f;
  bool is_square;
  std::string undefined;  ///< why it is, for all t; empty where it is not

  Scalar(const Curve& curve, TabulatedScalar of)
      : kind(of),
        is_square(of == TabulatedScalar::curvature || of == TabulatedScalar::frenet_rate) {
    try {
      f = function_of(curve, of);
    } catch (const DomainError& error) {
      undefined = error.what();
    }
  }
  /// The value at t of the point.
  Real at(const Place& point, const AlgebraicPoint& t) const;
};

Real Scalar::at(const Place& point, const AlgebraicPoint& t) const {
  if (!undefined.empty()) throw DomainError(undefined);
  if (sign_at(f.denominator(), t.number()) == 0)
    throw DomainError(fmt::format("{}: infinite at {}", name_of(kind), text_of(point)));
  return is_square ? t.square_root(f) : t.value(f);
}

/// What the rows along one segment share.
struct SegmentRows {
  Vector<Polynomial> position;
  Frames frames;
  std::vector<Scalar> scalars;
  std::optional<AlgebraicFrames> algebraic;  ///< made for the first irrational t

  SegmentRows(const Curve& curve, const TableColumns& columns)
      : position(phrame::position(curve)), frames(curve) {
    for (const TabulatedScalar kind : columns.scalars) scalars.emplace_back(curve, kind);
  }
};

/// One row after the other. What a row of another kind would need is not prepared.
class Rows {
 public:
  Rows(const PhPath& path, const TableColumns& columns)
      : spline_(path),
        columns_(columns),
        orientations_(columns),
        start_(reduced(start_angle(columns.start, path))),
        segments_(path.segments().size()) {}

  std::vector<double> at(const Place& point);
  /// Why the last row has empty cells; nothing where it has none.
  const std::string& reason() const { return reason_; }
  /// Prepares for rows at all of these points, where they are so many that it pays.
  void expect(const std::vector<Place>& points);

 private:
  SegmentRows& segment(std::size_t k);
  const PathAngle& angle();
  const PathLength& length();
  Frame<Real> rotation_minimizing(const Frame<Rational>& erf, const PathParameter& at);
  void add_rational(std::vector<double>& row, const PathParameter& at);
  void add_irrational(std::vector<double>& row, const Place& point, const AlgebraicPoint& t);
  Real value(const Scalar& scalar, const Place& point, const AlgebraicPoint& t);
  template <class Add>
  void add_where_defined(std::vector<double>& row, std::size_t count, Add add);

  const PhPath& spline_;
  const TableColumns& columns_;
  OrientationColumns orientations_;
  FrameAngle start_;  ///< of the rotation-minimizing frame
  std::vector<std::unique_ptr<SegmentRows>> segments_;
  std::optional<PathLength> length_;
  std::optional<PathAngle> angle_;
  std::optional<RoundedFrames> compiled_;
  std::string reason_;
};

/// `count` numbers, or empty cells where they are undefined and may be empty.
template <class Add>
void Rows::add_where_defined(std::vector<double>& row, std::size_t count, Add add) {
  if (!columns_.may_be_empty) return add();
  const std::size_t before = row.size();
  try {
    add();
  } catch (const DomainError& error) {
    row.resize(before);
    row.resize(before + count, std::numeric_limits<double>::quiet_NaN());
    if (reason_.empty()) reason_ = error.what();
  }
}

SegmentRows& Rows::segment(std::size_t k) {
  if (!segments_[k]) segments_[k] = std::make_unique<SegmentRows>(spline_.segments()[k], columns_);
  return *segments_[k];
}

const PathAngle& Rows::angle() {
  if (!angle_) angle_.emplace(spline_);
  return *angle_;
}

const PathLength& Rows::length() {
  if (!length_) length_.emplace(Path(spline_));
  return *length_;
}

Frame<Real> Rows::rotation_minimizing(const Frame<Rational>& erf, const PathParameter& at) {
  return turned(
      erf, angle().direction(at), [&](const FrameAngle& start) { return angle().value(at, start); },
      start_);
}

void Rows::expect(const std::vector<Place>& points) {
  const std::size_t many =
      1000 + 20 * static_cast<std::size_t>(preimage_degree(spline_.segments().front()));
  if (points.size() < many || segments_.size() > 1 || columns_.have_quaternions ||
      !has_frame(columns_, TabulatedFrame::rmf))
    return;
  std::vector<double> at;
  for (const Place& point : points)
    if (point.t.exact()) at.push_back(round_to_double(*point.t.exact()));
  const auto [from, to] = std::minmax_element(at.begin(), at.end());
  if (at.size() < many || *from == *to) return;
  const Curve& curve = spline_.segments().front();
  try {
    compiled_.emplace(curve, RmfAngle(curve), *from, *to, start_);
  } catch (const Undecided&) {  // then each row goes the exact way
  } catch (const DomainError&) {
  }
}

/// The arc length along the path, also where f changes sign.
Real Rows::value(const Scalar& scalar, const Place& point, const AlgebraicPoint& t) {
  if (scalar.kind != TabulatedScalar::arc_length) return scalar.at(point, t);
  if (compare(t.number(), 0) >= 0 && compare(t.number(), 1) <= 0) return length().value(point);
  if (spline_.segments()[point.segment].multiplier().is_constant()) return scalar.at(point, t);
  throw DomainError(
      fmt::format("{}: {} is outside [0, 1], where the sign of the multiplier is known",
                  name_of(scalar.kind), text_of(point)));
}

std::vector<double> Rows::at(const Place& point) {
  reason_.clear();
  const AlgebraicPoint t = point.algebraic ? *point.algebraic : AlgebraicPoint(number_of(point));
  std::vector<double> row{round_to_double(parameter(point))};
  if (const auto& r = point.t.exact())
    add_rational(row, {point.segment, *r});
  else
    add_irrational(row, point, t);
  for (const Scalar& scalar : segment(point.segment).scalars) {
    add_where_defined(row, 1, [&] { row.push_back(round_to_double(value(scalar, point, t))); });
  }
  return row;
}

void Rows::add_rational(std::vector<double>& row, const PathParameter& at) {
  const SegmentRows& here = segment(at.segment);
  std::optional<Frame<Rational>> known_erf;
  const auto erf = [&]() -> const Frame<Rational>& {
    if (!known_erf) known_erf = here.frames.euler_rodrigues(at.t);
    return *known_erf;
  };
  std::optional<Frame<double>> compiled_rmf;
  if (compiled_) compiled_rmf = compiled_->at(at.t);
  add_values(row, round_to_double(evaluate(here.position, at.t)));
  add_values(row, compiled_rmf ? compiled_rmf->e1 : round_to_double(erf().e1));
  for (const TabulatedFrame frame : columns_.frames) {
    switch (frame) {
      case TabulatedFrame::rmf:
        if (compiled_rmf)
          orientations_.add(row, *compiled_rmf);
        else
          orientations_.add(row, frame, rotation_minimizing(erf(), at));
        break;
      case TabulatedFrame::euler_rodrigues:
        orientations_.add(row, frame, as_real(erf()));
        break;
      case TabulatedFrame::frenet:
        add_where_defined(row, orientations_.width(),
                          [&] { orientations_.add(row, frame, here.frames.frenet(at.t)); });
        break;
      case TabulatedFrame::up:
        throw_no_up();
      case TabulatedFrame::mtf:
        orientations_.add(
            row, frame, turned(as_real(erf()), phrame::value(*columns_.mtf, Real(parameter(at)))));
        break;
      case TabulatedFrame::exact_mtf:
        orientations_.add(row, frame,
                          turned(as_real(erf()), columns_.exact_mtf->value(parameter(at))));
        break;
    }
  }
}

void Rows::add_irrational(std::vector<double>& row, const Place& point, const AlgebraicPoint& t) {
  SegmentRows& here = segment(point.segment);
  if (!here.algebraic) here.algebraic.emplace(spline_.segments()[point.segment]);
  for (const Polynomial& x : here.position) row.push_back(round_to_double(t.value(x)));
  const Frame<Real> erf = here.algebraic->euler_rodrigues(t);
  add_values(row, round_to_double(erf.e1));
  const auto rmf_angle = [&] {
    return angle().value(PathParameter{point.segment, 0}) + here.algebraic->angle(t);
  };
  for (const TabulatedFrame frame : columns_.frames) {
    switch (frame) {
      case TabulatedFrame::rmf:
        orientations_.add(row, frame, turned(erf, rmf_angle() + to_real(start_)));
        break;
      case TabulatedFrame::euler_rodrigues:
        orientations_.add(row, frame, erf);
        break;
      case TabulatedFrame::frenet:
        add_where_defined(row, orientations_.width(),
                          [&] { orientations_.add(row, frame, here.algebraic->frenet(t)); });
        break;
      case TabulatedFrame::up:
        throw_no_up();
      case TabulatedFrame::mtf:
        orientations_.add(row, frame, turned(erf, phrame::value(*columns_.mtf, parameter(point))));
        break;
      case TabulatedFrame::exact_mtf:
        orientations_.add(
            row, frame, turned(erf, columns_.exact_mtf->value(length().value(point), rmf_angle())));
        break;
    }
  }
}

}  // namespace

bool has_frame(const TableColumns& columns, TabulatedFrame frame) {
  return std::find(columns.frames.begin(), columns.frames.end(), frame) != columns.frames.end();
}

std::vector<std::string> names_of(const TableColumns& columns) {
  std::vector<std::string> names{"t", "x", "y", "z", "e1x", "e1y", "e1z"};
  for (const TabulatedFrame frame : columns.frames) add_names(names, frame, columns);
  for (const TabulatedScalar kind : columns.scalars) names.emplace_back(name_of(kind));
  return names;
}

void add_row(FrameTable& table, std::vector<double> row,
             const std::function<std::string()>& place) {
  for (std::size_t k = 0; k < row.size(); ++k)
    if (std::isinf(row[k]))
      throw InputError(place(), table.columns[k] + " does not fit a double, of at most 1.8e308");
  table.rows.push_back(std::move(row));
}

FrameTable frame_table(const PhPath& path, const TableColumns& columns,
                       const std::vector<Place>& at) {
  Rows rows(path, columns);
  rows.expect(at);
  FrameTable table{names_of(columns), {}};
  if (has_frame(columns, TabulatedFrame::rmf)) table.start = columns.start;
  Stage stage("rows", at.size());
  for (const Place& point : at) {
    stage.advance();
    add_row(table, rows.at(point), [&] { return text_of(point); });
    if (rows.reason().empty()) continue;
    if (++table.incomplete_rows == 1) table.first_reason = rows.reason();
  }
  return table;
}

FrameTable frame_table(const Curve& curve, const TableColumns& columns,
                       const std::vector<RealAlgebraic>& at) {
  std::vector<Place> points;
  for (const RealAlgebraic& t : at) points.emplace_back(0, t);
  return frame_table(PhPath(curve), columns, points);
}

FrameTable frame_table(const Curve& curve, const std::vector<TabulatedFrame>& frames,
                       const std::vector<Rational>& at) {
  return frame_table(curve, TableColumns{frames}, std::vector<RealAlgebraic>(at.begin(), at.end()));
}

}  // namespace phrame
