#include "phrame/answer/frame_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "phrame/algebra/algebraic_point.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/answer/near_rows.hpp"
#include "phrame/answer/orientation_columns.hpp"
#include "phrame/ph/along/curvature.hpp"
#include "phrame/ph/along/path_length.hpp"
#include "phrame/ph/along/reduced_angle.hpp"
#include "phrame/ph/curve/real_vector.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/frame/path_frame.hpp"
#include "phrame/ph/frame/signed_frenet.hpp"

namespace phrame::inline v0 {
namespace {

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

}  // namespace

/// A scalar along a rational curve as a function of t: f, or its square root.
struct FrameRows::Scalar {
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

Real FrameRows::Scalar::at(const Place& at) const {
  if (!undefined.empty()) throw DomainError(undefined);
  if (const auto t = algebraic_number(at); t && sign_at(f.denominator(), *t) == 0)
    throw DomainError(fmt::format("{}: infinite at {}", name_of(kind), text_of(at).value()));
  if (kind == TabulatedScalar::torsion) return value(f, at);
  return at.algebraic ? at.algebraic->square_root(f) : square_root_of(value(f, at));
}

namespace {

/// Is it a function of κ and τ alone?
bool is_of_frenet(TabulatedScalar kind) {
  return kind == TabulatedScalar::curvature || kind == TabulatedScalar::torsion ||
         kind == TabulatedScalar::frenet_rate;
}

/// Is t outside [0, 1], on a PH curve by itself?
bool is_outside(const Place& at) {
  const auto t = algebraic_number(at);
  return t && (compare(*t, 0) < 0 || compare(*t, 1) > 0);
}

StartAngle reduced_start(const FrameStart& start, const PathAngle& angle) {
  const StartAngle at = start_angle(start, angle);
  return at.exact ? StartAngle(reduced(*at.exact)) : at;
}

}  // namespace

/// One row after the other. What a row of another kind would need is not prepared.
class FrameRows::State {
 public:
  State(const PathAngle& angle, const TableColumns& columns, RowPlaces at)
      : columns_(columns),
        orientations_(columns),
        angle_(angle),
        length_(angle.path()),
        start_(reduced_start(columns.start, angle)),
        scalars_(angle.path().segments().size()),
        places_(std::move(at)),
        near_(angle, columns, start_, places_) {}

  TableRow at(std::size_t k, const Place& at);
  const RowPlaces& places() const { return places_; }
  const NearRows& near() const { return near_; }
  const std::string& reason() const { return reason_; }

 private:
  const Path& path() const { return angle_.path(); }
  const Frame<Real>& erf(const Place& at);
  const Frame<Real>& rmf(const Place& at);
  bool has_long_fractions(const Place& at) const;
  TableRow row(std::size_t k, const Place& at);
  const SignedFrenet& signed_frenet();
  Frame<Real> frame(TabulatedFrame kind, const Place& at);
  Frame<Real> unrolled(TabulatedFrame kind, const Place& at);
  Frame<Real> of_least_twist(const Place& at);
  Frame<Real> rational_twist(const Place& at);
  Real arc_length(const Place& at) const;
  Real scalar(TabulatedScalar kind, const Place& at);
  Real turning(TabulatedScalar kind, const Place& at);
  Real twisting(TabulatedScalar kind, const Place& at) const;
  /// Those of the columns along this segment, where it is a rational curve.
  std::vector<Scalar> scalars_of(const Segment& segment) const;
  template <class Add>
  void add_where_defined(TableRow& row, std::size_t count, Add add);

  const TableColumns& columns_;
  OrientationColumns orientations_;
  PathAngle angle_;
  PathLength length_;
  StartAngle start_;                                         ///< of the rotation-minimizing frame
  std::vector<std::optional<std::vector<Scalar>>> scalars_;  ///< along the segments
  RowPlaces places_;
  NearRows near_;
  std::optional<Frame<Real>> erf_;  ///< of this row, once it is found
  std::optional<Frame<Real>> rmf_;  ///< likewise
  bool is_by_balls_ = false;        ///< the rotation-minimizing frame, even where it is rational
  std::optional<SignedFrenet> signed_frenet_;
  std::string reason_;
};

std::vector<FrameRows::Scalar> FrameRows::State::scalars_of(const Segment& segment) const {
  std::vector<Scalar> scalars;
  for (const TabulatedScalar kind : columns_.scalars) {
    if (!is_of_frenet(kind)) continue;
    if (const Curve* ph = ph_curve(segment))
      scalars.emplace_back(*ph, kind);
    else
      scalars.emplace_back(std::get<RationalCurve>(segment), kind);
  }
  return scalars;
}

/// `count` numbers, or empty cells where they are undefined and may be empty.
template <class Add>
void FrameRows::State::add_where_defined(TableRow& row, std::size_t count, Add add) {
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

const Frame<Real>& FrameRows::State::erf(const Place& at) {
  if (!erf_) erf_ = euler_rodrigues_frame(path(), at);
  return *erf_;
}

/// Is the rotation-minimizing frame there a product of rational ones of many segments?
bool FrameRows::State::has_long_fractions(const Place& at) const {
  constexpr std::size_t many_segments = 8;
  return at.segment >= many_segments && at.t.exact() && start_.exact &&
         angle_.reference() == Reference::euler_rodrigues && !angle_.is_zero() &&
         angle_.direction({0, Rational(1)});
}

const Frame<Real>& FrameRows::State::rmf(const Place& at) {
  if (!rmf_ && is_by_balls_) {
    const Real theta([this, at](long bits) {
      constexpr long most_bits = 1024;
      if (bits > most_bits) throw Undecided("by balls");
      return angle_.enclose(at, start_, bits);
    });
    rmf_ = turned(erf(at), theta);
  }
  if (!rmf_)
    rmf_ = angle_.reference() == Reference::euler_rodrigues
               ? rotation_minimizing_frame(angle_, at, start_, erf(at))
               : rotation_minimizing_frame(angle_, at, start_);
  return *rmf_;
}

const SignedFrenet& FrameRows::State::signed_frenet() {
  if (!signed_frenet_) signed_frenet_.emplace(path());
  return *signed_frenet_;
}

Frame<Real> FrameRows::State::of_least_twist(const Place& at) {
  const PathTwist& twist = columns_.exact_mtf.value();
  return twist.rmf().reference() == Reference::euler_rodrigues ? twist.frame(at, erf(at))
                                                               : twist.frame(at);
}

/// Where orientations are given between the ends they are met exactly.
Frame<Real> FrameRows::State::rational_twist(const Place& at) {
  const PathTwist& twist = columns_.exact_mtf.value();
  if (twist.legs().size() > 1 && twist.is_joint(at)) return twist.frame(at, erf(at));
  return turned(erf(at), value(columns_.mtf.at(twist.leg_at(at)), parameter(twist.on_leg(at))));
}

Frame<Real> FrameRows::State::frame(TabulatedFrame kind, const Place& at) {
  const Frame<Real> found = unrolled(kind, at);
  return columns_.roll.is_zero() || is_of_curve(kind) ? found : turned(found, columns_.roll.at(at));
}

Frame<Real> FrameRows::State::unrolled(TabulatedFrame kind, const Place& at) {
  switch (kind) {
    case TabulatedFrame::rmf:
      return rmf(at);
    case TabulatedFrame::euler_rodrigues:
      return erf(at);
    case TabulatedFrame::frenet:
      return frenet_frame(path(), at);
    case TabulatedFrame::signed_frenet:
      return signed_frenet().frame(at);
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
Real FrameRows::State::arc_length(const Place& at) const {
  if (!is_outside(at)) return length_.value(at);
  if (ph_curve(path().segments()[at.segment])->multiplier().is_constant())
    return value(length_.closed_form(at.segment)->polynomial(), at);
  throw DomainError(fmt::format(
      "s: {} is outside [0, 1], where the sign of the multiplier is known", text_of(at).value()));
}

/// What the rotation-minimizing frame turns by.
Real FrameRows::State::turning(TabulatedScalar kind, const Place& at) {
  const Vector<Real> bend = curvature_vector(path(), at);
  if (kind == TabulatedScalar::bend_f2) return dot(bend, rmf(at).e2);
  if (kind == TabulatedScalar::bend_f3) return dot(bend, rmf(at).e3);
  const Vector<Real> omega = cross(tangent(path(), at), bend);
  return kind == TabulatedScalar::omega_x   ? omega[0]
         : kind == TabulatedScalar::omega_y ? omega[1]
                                            : omega[2];
}

/// What the frame of minimal twist turns by, ω = β + φ′e₁ with β = e₁ × e₁′, and ω′.
Real FrameRows::State::twisting(TabulatedScalar kind, const Place& at) const {
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

Real FrameRows::State::scalar(TabulatedScalar kind, const Place& at) {
  if (kind == TabulatedScalar::arc_length) return arc_length(at);
  if (kind >= TabulatedScalar::twist_rate) return twisting(kind, at);
  if (kind == TabulatedScalar::signed_curvature) return signed_frenet().curvature(at);
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
  if (!scalars) scalars = scalars_of(segment);
  return std::find_if(scalars->begin(), scalars->end(),
                      [&](const Scalar& scalar) { return scalar.kind == kind; })
      ->at(at);
}

// Exact fractions of such a frame are as long as those of all segments before together, and are
// needed only where balls leave a rounding open, as that of a component 0 or ±1.
TableRow FrameRows::State::at(std::size_t k, const Place& at) {
  is_by_balls_ = has_long_fractions(at);
  if (is_by_balls_) {
    try {
      return row(k, at);
    } catch (const Undecided&) {
      is_by_balls_ = false;
    }
  }
  return row(k, at);
}

TableRow FrameRows::State::row(std::size_t k, const Place& at) {
  const std::optional<NearNumber> t = near_.parameter(k);
  const std::optional<Rational> s = places_.arc_length(k);
  reason_.clear();
  erf_.reset();
  rmf_.reset();
  TableRow row;
  row.digits = columns_.digits;
  row.add(parameter(at));
  const auto add_vector = [&](const Vector<double>& v) {
    row.values.insert(row.values.end(), v.begin(), v.end());
  };
  if (const auto r = t ? near_.position(*t) : std::nullopt)
    add_vector(*r);
  else
    row.add(position(path(), at));
  const auto rmf = t ? near_.frame(*t, at) : std::nullopt;
  if (rmf)
    add_vector(rmf->e1);
  else
    row.add(ph_curve(path().segments()[at.segment]) != nullptr ? erf(at).e1 : tangent(path(), at));
  for (const TabulatedFrame kind : columns_.frames) {
    if (rmf && kind == TabulatedFrame::rmf && !columns_.have_quaternions)
      orientations_.add(row.values, *rmf);
    else
      add_where_defined(row, orientations_.width(),
                        [&] { orientations_.add(row, kind, frame(kind, at)); });
  }
  for (const TabulatedScalar kind : columns_.scalars)
    add_where_defined(row, 1, [&] {
      row.add(s && kind == TabulatedScalar::arc_length ? Real(*s) : scalar(kind, at));
    });
  return row;
}

namespace {

void require_twists(const TableColumns& columns) {
  const bool has_mtf =
      !has_frame(columns, TabulatedFrame::mtf) || (columns.exact_mtf && !columns.mtf.empty());
  const bool has_exact = !has_frame(columns, TabulatedFrame::exact_mtf) || columns.exact_mtf;
  if (!has_mtf || !has_exact)
    throw DomainError("frame mtf: only Pythagorean-hodograph curves have it");
}

}  // namespace

FrameRows::FrameRows(const PathAngle& angle, const TableColumns& columns, RowPlaces places) {
  require_twists(columns);
  columns.roll.require_along(angle.path().segments().size());
  state_ = std::make_unique<State>(angle, columns, std::move(places));
  empty_.columns = names_of(columns);
  const bool has_rmf = has_frame(columns, TabulatedFrame::rmf);
  if (has_rmf) empty_.start = columns.start;
  if (has_frame(columns, TabulatedFrame::up) || (has_rmf && angle.reference() == Reference::up &&
                                                 std::holds_alternative<Angle>(columns.start)))
    empty_.up = angle.up();
}

FrameRows::~FrameRows() = default;

std::size_t FrameRows::size() const { return state_->places().size(); }

const std::string& FrameRows::reason() const { return state_->reason(); }

std::vector<std::size_t> FrameRows::near(std::size_t first,
                                         std::span<std::vector<double>> rows) const {
  return state_->near().make(first, rows);
}

std::vector<std::size_t> FrameRows::not_near(std::size_t first, std::size_t count) const {
  return state_->near().untold(first, count);
}

TableRow FrameRows::exact(std::size_t k) {
  const Place at = state_->places().place(k);
  try {
    TableRow row = state_->at(k, at);
    require_finite(empty_.columns, row.values,
                   [&] { return text_of(at).value_or(fmt::format("row {}", k)); });
    return row;
  } catch (const Undecided& undecided) {
    throw Undecided(
        fmt::format("{}: {}", text_of(at).value_or(fmt::format("row {}", k)), undecided.what()));
  }
}

}  // namespace phrame
