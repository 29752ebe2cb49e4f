#include "general_source.hpp"

namespace phrame::inline v0::python {

GeneralSource::GeneralSource(Parametrization along, std::optional<PathAngle> angle, FrameKind kind,
                             StartAngle start)
    : along_(std::move(along)),
      path_(along_.path()),
      angle_(std::move(angle)),
      kind_(kind),
      start_(std::move(start)) {}

void GeneralSource::prepare(const Parameters& at) {
  const std::lock_guard guard(lock_);
  if (!at.are_doubles() || along_.kind() != ParameterKind::t) return;
  if (asked_ == 0) round_positions();
  asked_ += at.size();
  if (!angle_ || kind_ != TabulatedFrame::rmf || is_compiled_ || is_undecided_ ||
      asked_ < least_compiled * path_.segments().size())
    return;
  try {
    compiled_.emplace(*angle_, start_);
    is_compiled_ = true;
  } catch (const Undecided&) {
    is_undecided_ = true;  // all frames are computed exactly
  }
}

bool GeneralSource::is_prepared(const Parameters& at) const {
  return at.are_doubles() && (angle_ ? bool(is_compiled_) : bool(is_rounded_));
}

Vector<double> GeneralSource::point(const Parameters& at, std::size_t k) const {
  if (at.are_doubles() && is_rounded_) {
    const auto [segment, t] = place_at(at.doubles[k], rounded_.size());
    const auto& [x, y, z] = rounded_[segment];
    return finite(Vector<double>{x(t), y(t), z(t)});
  }
  return finite(round_to_double(position(path_, place(at, k))));
}

Frame<double> GeneralSource::frame(const Parameters& at, std::size_t k) const {
  if (at.are_doubles() && is_compiled_)
    if (const auto found = compiled_->rounded(at.doubles[k])) return *found;
  const Frame<Real> exact = exact_frame(at, k);
  return {round_to_double(exact.e1), round_to_double(exact.e2), round_to_double(exact.e3)};
}

std::array<double, 4> GeneralSource::quaternion(const Parameters& at, std::size_t k) const {
  if (at.are_doubles() && is_compiled_) {
    const auto [b, error] = compiled_->rotation(at.doubles[k]);
    const auto rounded = [&, off = error + 0x1p-94](const DoubleDouble& x) {
      return common_double(x, off);
    };
    const auto u = rounded(b.u), v = rounded(b.v), p = rounded(b.p), q = rounded(b.q);
    if (u && v && p && q) return {*v, *p, *q, *u};
  }
  const Quaternion<Real> exact = quaternion_of(exact_frame(at, k));
  return {round_to_double(exact.v), round_to_double(exact.p), round_to_double(exact.q),
          round_to_double(exact.u)};
}

Place GeneralSource::place(const Parameters& at, std::size_t k) const {
  return at_place("ts[" + std::to_string(k) + "]", [&] { return along_.point(at[k]).at; });
}

/// Where all segments are polynomials.
void GeneralSource::round_positions() {
  std::vector<RoundedPoint> found;
  for (const Segment& segment : path_.segments()) {
    const RationalCurve* curve = rational_curve(segment);
    if (curve == nullptr || !curve->weight().is_constant()) return;
    const Rational over_weight = 1 / curve->weight().coefficient(0);
    const auto& [x, y, z] = curve->numerator();
    found.push_back({RoundedPolynomial(over_weight * x), RoundedPolynomial(over_weight * y),
                     RoundedPolynomial(over_weight * z)});
  }
  rounded_ = std::move(found);
  is_rounded_ = true;
}

Frame<Real> GeneralSource::exact_frame(const Parameters& at, std::size_t k) const {
  const Place here = place(at, k);
  if (kind_ == TabulatedFrame::rmf) return rotation_minimizing_frame(*angle_, here, start_);
  if (kind_ == TabulatedFrame::frenet) return frenet_frame(path_, here);
  if (kind_ == TabulatedFrame::euler_rodrigues) return euler_rodrigues_frame(path_, here);
  return up_frame(path_, angle_->up(), here);
}

}  // namespace phrame::python
