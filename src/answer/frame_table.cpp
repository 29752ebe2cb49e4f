#include "phrame/answer/frame_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "phrame/algebra/algebraic_point.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/progress.hpp"
#include "phrame/answer/orientation_columns.hpp"
#include "phrame/answer/rounded.hpp"
#include "phrame/answer/table_row.hpp"
#include "phrame/ph/along/curvature.hpp"
#include "phrame/ph/along/path_length.hpp"
#include "phrame/ph/along/reduced_angle.hpp"
#include "phrame/ph/curve/real_vector.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/frame/compiled_frame.hpp"
#include "phrame/ph/frame/path_frame.hpp"
#include "phrame/ph/frame/rounded_frames.hpp"

namespace phrame {
namespace {

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
    case TabulatedScalar::bend_f2:
      return "k1";
    case TabulatedScalar::bend_f3:
      return "k2";
    case TabulatedScalar::omega_x:
      return "omega_x";
    case TabulatedScalar::omega_y:
      return "omega_y";
    case TabulatedScalar::omega_z:
      return "omega_z";
    case TabulatedScalar::twist_rate:
      return "twist_rate";
    case TabulatedScalar::twist_omega_x:
      return "twist_omega_x";
    case TabulatedScalar::twist_omega_y:
      return "twist_omega_y";
    case TabulatedScalar::twist_omega_z:
      return "twist_omega_z";
    case TabulatedScalar::twist_alpha_x:
      return "twist_alpha_x";
    case TabulatedScalar::twist_alpha_y:
      return "twist_alpha_y";
    case TabulatedScalar::twist_alpha_z:
      return "twist_alpha_z";
  }
  return "";
}

/// "t = 3/2", "t ≈ 1.33"; no value where t is not known to be algebraic.
std::optional<std::string> text_of(const Place& at) {
  const auto t = algebraic_parameter(at);
  return t ? std::optional(place_text("t", *t)) : std::nullopt;
}

/// Of such a curve, but for the arc length.
template <class C>
RationalFunction function_of(const C& curve, TabulatedScalar kind) {
  if (kind == TabulatedScalar::curvature) return squared_curvature(curve);
  const RationalFunction tau = torsion(curve);
  return kind == TabulatedScalar::torsion ? tau : squared_curvature(curve) + tau * tau;
}

/// A scalar along a rational curve as a function of t: f, or its square root.
struct Scalar {
  TabulatedScalar kind;
  RationalFunction f = {};
  std::string undefined = {};  ///< why it is, for all t; empty where it is not

  template <class C>
  Scalar(const C& curve, TabulatedScalar of) : kind(of) {
    try {
      f = function_of(curve, of);
    } catch (const DomainError& error) {
      undefined = error.what();
    }
  }
  Real at(const Place& at) const;  ///< the value there
};

Real Scalar::at(const Place& at) const {
  if (!undefined.empty()) throw DomainError(undefined);
  if (const auto t = algebraic_number(at); t && sign_at(f.denominator(), *t) == 0)
    throw DomainError(fmt::format("{}: infinite at {}", name_of(kind), text_of(at).value()));
  if (kind == TabulatedScalar::torsion) return value(f, at);
  return at.algebraic ? at.algebraic->square_root(f) : square_root_of(value(f, at));
}

/// Is it a function of κ and τ alone?
bool is_of_frenet(TabulatedScalar kind) {
  return kind == TabulatedScalar::curvature || kind == TabulatedScalar::torsion ||
         kind == TabulatedScalar::frenet_rate;
}

/// Those of the columns along this segment, where it is a rational curve.
std::vector<Scalar> scalars_of(const Segment& segment, const TableColumns& columns) {
  std::vector<Scalar> scalars;
  for (const TabulatedScalar kind : columns.scalars) {
    if (!is_of_frenet(kind)) continue;
    if (const Curve* ph = ph_curve(segment))
      scalars.emplace_back(*ph, kind);
    else
      scalars.emplace_back(std::get<RationalCurve>(segment), kind);
  }
  return scalars;
}

/// Is t outside [0, 1], on a PH curve by itself?
bool is_outside(const Place& at) {
  const auto t = algebraic_number(at);
  return t && (compare(*t, 0) < 0 || compare(*t, 1) > 0);
}

/// One row after the other. What a row of another kind would need is not prepared.
class Rows {
 public:
  Rows(const PathAngle& angle, const TableColumns& columns)
      : columns_(columns),
        orientations_(columns),
        angle_(angle),
        length_(angle.path()),
        start_(start_angle(columns.start, angle)),
        scalars_(angle.path().segments().size()) {
    if (start_.exact) start_ = reduced(*start_.exact);
  }

  TableRow at(const Place& at);
  /// The same, where what is undecided says of which row it is.
  TableRow named_at(const Place& at, std::size_t row);
  /// Why the last row has empty cells; nothing where it has none.
  const std::string& reason() const { return reason_; }
  /// Prepares for rows at all of these points, where they are so many that it pays.
  void expect(const std::vector<Place>& points);

 private:
  const Path& path() const { return angle_.path(); }
  const Frame<Real>& erf(const Place& at);
  const Frame<Real>& rmf(const Place& at);
  Frame<Real> frame(TabulatedFrame kind, const Place& at);
  Frame<Real> unrolled(TabulatedFrame kind, const Place& at);
  Frame<Real> of_least_twist(const Place& at);
  Frame<Real> rational_twist(const Place& at);
  Real arc_length(const Place& at) const;
  Real scalar(TabulatedScalar kind, const Place& at);
  Real turning(TabulatedScalar kind, const Place& at);
  Real twisting(TabulatedScalar kind, const Place& at) const;
  template <class Add>
  void add_where_defined(TableRow& row, std::size_t count, Add add);

  const TableColumns& columns_;
  OrientationColumns orientations_;
  PathAngle angle_;
  PathLength length_;
  StartAngle start_;                                         ///< of the rotation-minimizing frame
  std::vector<std::optional<std::vector<Scalar>>> scalars_;  ///< along the segments
  std::optional<RoundedFrames> compiled_;
  std::optional<Frame<Real>> erf_;  ///< of this row, once it is found
  std::optional<Frame<Real>> rmf_;  ///< likewise
  std::string reason_;
};

/// `count` numbers, or empty cells where they are undefined and may be empty.
template <class Add>
void Rows::add_where_defined(TableRow& row, std::size_t count, Add add) {
  const std::size_t before = row.values.size();
  try {
    add();
  } catch (const DomainError& error) {
    if (!columns_.may_be_empty) throw;
    row.resize(before);
    row.add_empty(count);
    if (reason_.empty()) reason_ = error.what();
  }
}

void Rows::expect(const std::vector<Place>& points) {
  if (columns_.digits > 0 || !columns_.roll.is_zero()) return;
  if (!goes_on(path()) || angle_.reference() != Reference::euler_rodrigues || !start_.exact) return;
  const Curve& curve = *ph_curve(path().segments().front());
  const std::size_t many = 1000 + 20 * static_cast<std::size_t>(preimage_degree(curve));
  if (points.size() < many || columns_.have_quaternions ||
      !has_frame(columns_, TabulatedFrame::rmf))
    return;
  std::vector<double> at;
  for (const Place& point : points)
    if (point.t.exact()) at.push_back(round_to_double(*point.t.exact()));
  const auto [from, to] = std::minmax_element(at.begin(), at.end());
  if (at.size() < many || *from == *to) return;
  try {
    compiled_.emplace(curve, *angle_.closed_form(0), *from, *to, *start_.exact);
  } catch (const Undecided&) {  // then each row goes the exact way
  } catch (const DomainError&) {
  }
}

const Frame<Real>& Rows::erf(const Place& at) {
  if (!erf_) erf_ = euler_rodrigues_frame(path(), at);
  return *erf_;
}

const Frame<Real>& Rows::rmf(const Place& at) {
  if (!rmf_)
    rmf_ = angle_.reference() == Reference::euler_rodrigues
               ? rotation_minimizing_frame(angle_, at, start_, erf(at))
               : rotation_minimizing_frame(angle_, at, start_);
  return *rmf_;
}

Frame<Real> Rows::of_least_twist(const Place& at) {
  const PathTwist& twist = columns_.exact_mtf.value();
  return twist.rmf().reference() == Reference::euler_rodrigues ? twist.frame(at, erf(at))
                                                               : twist.frame(at);
}

/// Where orientations are given between the ends they are met exactly.
Frame<Real> Rows::rational_twist(const Place& at) {
  const PathTwist& twist = columns_.exact_mtf.value();
  if (twist.legs().size() > 1 && twist.is_joint(at)) return twist.frame(at, erf(at));
  return turned(erf(at), value(columns_.mtf.at(twist.leg_at(at)), parameter(twist.on_leg(at))));
}

/// Those of Euler and Rodrigues and of Frenet are as they are.
Frame<Real> Rows::frame(TabulatedFrame kind, const Place& at) {
  const Frame<Real> found = unrolled(kind, at);
  const bool is_fixed = kind == TabulatedFrame::euler_rodrigues || kind == TabulatedFrame::frenet;
  return columns_.roll.is_zero() || is_fixed ? found : turned(found, columns_.roll.at(at));
}

Frame<Real> Rows::unrolled(TabulatedFrame kind, const Place& at) {
  switch (kind) {
    case TabulatedFrame::rmf:
      return rmf(at);
    case TabulatedFrame::euler_rodrigues:
      return erf(at);
    case TabulatedFrame::frenet:
      return frenet_frame(path(), at);
    case TabulatedFrame::up:
      return up_frame(path(), angle_.up(), at);
    case TabulatedFrame::mtf:
      return rational_twist(at);
    case TabulatedFrame::exact_mtf:
      break;
  }
  return of_least_twist(at);
}

/// Along the path, also where f changes sign.
Real Rows::arc_length(const Place& at) const {
  if (!is_outside(at)) return length_.value(at);
  if (ph_curve(path().segments()[at.segment])->multiplier().is_constant())
    return value(length_.closed_form(at.segment)->polynomial(), at);
  throw DomainError(fmt::format(
      "s: {} is outside [0, 1], where the sign of the multiplier is known", text_of(at).value()));
}

/// What the rotation-minimizing frame turns by.
Real Rows::turning(TabulatedScalar kind, const Place& at) {
  const Vector<Real> bend = curvature_vector(path(), at);
  if (kind == TabulatedScalar::bend_f2) return dot(bend, rmf(at).e2);
  if (kind == TabulatedScalar::bend_f3) return dot(bend, rmf(at).e3);
  const Vector<Real> omega = cross(tangent(path(), at), bend);
  return kind == TabulatedScalar::omega_x   ? omega[0]
         : kind == TabulatedScalar::omega_y ? omega[1]
                                            : omega[2];
}

/// What the frame of minimal twist turns by, ω = β + φ′e₁ with β = e₁ × e₁′, and ω′.
Real Rows::twisting(TabulatedScalar kind, const Place& at) const {
  if (!columns_.exact_mtf)
    throw DomainError(std::string(name_of(kind)) + ": no frame of minimal twist is given");
  const PathTwist& twist = *columns_.exact_mtf;
  const Real rate = twist.rate(at);
  if (kind == TabulatedScalar::twist_rate) return rate;
  const Vector<Real> e1 = tangent(path(), at);
  const Vector<Real> bend = curvature_vector(path(), at);
  if (kind < TabulatedScalar::twist_alpha_x) {
    const auto k =
        static_cast<std::size_t>(kind) - static_cast<std::size_t>(TabulatedScalar::twist_omega_x);
    return cross(e1, bend)[k] + rate * e1[k];
  }
  const auto k =
      static_cast<std::size_t>(kind) - static_cast<std::size_t>(TabulatedScalar::twist_alpha_x);
  return turning_slope(path(), at)[k] + twist.rate_slope(at) * e1[k] + rate * bend[k];
}

Real Rows::scalar(TabulatedScalar kind, const Place& at) {
  if (kind == TabulatedScalar::arc_length) return arc_length(at);
  if (kind >= TabulatedScalar::twist_rate) return twisting(kind, at);
  if (!is_of_frenet(kind)) return turning(kind, at);
  const Segment& segment = path().segments()[at.segment];
  if (std::holds_alternative<ExpressionCurve>(segment)) {
    if (kind == TabulatedScalar::curvature) return curvature(path(), at);
    if (kind == TabulatedScalar::torsion) return torsion(path(), at);
    const Real kappa = curvature(path(), at);
    const Real tau = torsion(path(), at);
    return square_root_of(kappa * kappa + tau * tau);
  }
  auto& scalars = scalars_[at.segment];
  if (!scalars) scalars = scalars_of(segment, columns_);
  return std::find_if(scalars->begin(), scalars->end(),
                      [&](const Scalar& scalar) { return scalar.kind == kind; })
      ->at(at);
}

TableRow Rows::at(const Place& at) {
  reason_.clear();
  erf_.reset();
  rmf_.reset();
  std::optional<Frame<double>> rmf;
  if (compiled_ && at.t.exact()) rmf = compiled_->at(*at.t.exact());
  TableRow row;
  row.digits = columns_.digits;
  row.add(parameter(at));
  row.add(position(path(), at));
  if (rmf)
    row.values.insert(row.values.end(), rmf->e1.begin(), rmf->e1.end());
  else
    row.add(ph_curve(path().segments()[at.segment]) != nullptr ? erf(at).e1 : tangent(path(), at));
  for (const TabulatedFrame kind : columns_.frames) {
    if (rmf && kind == TabulatedFrame::rmf)
      orientations_.add(row.values, *rmf);
    else
      add_where_defined(row, orientations_.width(),
                        [&] { orientations_.add(row, kind, frame(kind, at)); });
  }
  for (const TabulatedScalar kind : columns_.scalars)
    add_where_defined(row, 1, [&] { row.add(scalar(kind, at)); });
  return row;
}

TableRow Rows::named_at(const Place& at, std::size_t row) {
  try {
    return this->at(at);
  } catch (const Undecided& undecided) {
    throw Undecided(
        fmt::format("{}: {}", text_of(at).value_or(fmt::format("row {}", row)), undecided.what()));
  }
}

void require_twists(const TableColumns& columns) {
  const bool has_mtf =
      !has_frame(columns, TabulatedFrame::mtf) || (columns.exact_mtf && !columns.mtf.empty());
  const bool has_exact = !has_frame(columns, TabulatedFrame::exact_mtf) || columns.exact_mtf;
  if (!has_mtf || !has_exact)
    throw DomainError("frame mtf: only Pythagorean-hodograph curves have it");
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

void TableRow::add(const Real& x) {
  values.push_back(round_to_double(x));
  if (digits > 0) decimals.push_back(rounded_or_zero(x, "a number", digits).value);
}

void TableRow::add(const Vector<Real>& v) {
  for (const Real& x : v) add(x);
}

void TableRow::add_empty(std::size_t count) {
  values.resize(values.size() + count, std::numeric_limits<double>::quiet_NaN());
  if (digits > 0) decimals.resize(values.size());
}

void TableRow::resize(std::size_t count) {
  values.resize(count);
  if (digits > 0) decimals.resize(count);
}

void add_row(FrameTable& table, std::vector<double> row,
             const std::function<std::string()>& place) {
  for (std::size_t k = 0; k < row.size(); ++k)
    if (std::isinf(row[k]))
      throw InputError(place(), table.columns[k] + " does not fit a double, of at most 1.8e308");
  table.rows.push_back(std::move(row));
}

void add_column(FrameTable& table, const std::string& name, const std::vector<Real>& numbers,
                long digits) {
  if (std::find(table.columns.begin(), table.columns.end(), name) != table.columns.end()) return;
  table.columns.push_back(name);
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    TableRow cell{.digits = digits};
    cell.add(numbers[k]);
    table.rows[k].push_back(cell.values.front());
    if (digits > 0) table.decimals[k].push_back(cell.decimals.front());
  }
}

FrameTable frame_table(const PathAngle& angle, const TableColumns& columns,
                       const std::vector<Place>& at) {
  require_twists(columns);
  columns.roll.require_along(angle.path().segments().size());
  Rows rows(angle, columns);
  rows.expect(at);
  FrameTable table{names_of(columns), {}};
  const bool has_rmf = has_frame(columns, TabulatedFrame::rmf);
  if (has_rmf) table.start = columns.start;
  if (has_frame(columns, TabulatedFrame::up) || (has_rmf && angle.reference() == Reference::up &&
                                                 std::holds_alternative<Angle>(columns.start)))
    table.up = angle.up();
  Stage stage("rows", at.size());
  for (const Place& point : at) {
    stage.advance();
    TableRow row = rows.named_at(point, table.rows.size());
    if (columns.digits > 0) table.decimals.push_back(std::move(row.decimals));
    add_row(table, std::move(row.values),
            [&] { return text_of(point).value_or(fmt::format("row {}", table.rows.size())); });
    if (rows.reason().empty()) continue;
    if (++table.incomplete_rows == 1) table.first_reason = rows.reason();
  }
  return table;
}

FrameTable frame_table(const Curve& curve, const TableColumns& columns,
                       const std::vector<RealAlgebraic>& at) {
  std::vector<Place> points;
  for (const RealAlgebraic& t : at) points.emplace_back(0, t);
  return frame_table(PathAngle(Path(curve)), columns, points);
}

FrameTable frame_table(const Curve& curve, const std::vector<TabulatedFrame>& frames,
                       const std::vector<Rational>& at) {
  return frame_table(curve, TableColumns{frames}, std::vector<RealAlgebraic>(at.begin(), at.end()));
}

}  // namespace phrame
