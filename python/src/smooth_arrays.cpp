#include "frame_source.hpp"
#include "smooth.hpp"

namespace phrame::python {
namespace {}  // namespace

/// The frames and points of a path of any kind, each as exactly as rounding wants. What is found is
/// kept for later calls, which may come from any thread.
class SmoothSource {
 public:
  /// Without an angle there are points only.
  SmoothSource(const Path& path, std::optional<SmoothAngle> angle, TabulatedFrame kind, Real start,
               bool is_by_length)
      : path_(path),
        angle_(std::move(angle)),
        kind_(kind),
        start_(std::move(start)),
        length_(path),
        is_by_length_(is_by_length) {}

  /// To be called before the others are asked for these parameters.
  void prepare(const Parameters& at) {
    const std::lock_guard guard(lock_);
    if (!at.are_doubles() || is_by_length_) return;
    if (asked_ == 0) round_positions();
    asked_ += at.size();
    if (!angle_ || kind_ != TabulatedFrame::rmf || is_compiled_ || is_undecided_ ||
        asked_ < least_compiled * path_.segments().size())
      return;
    try {
      compiled_.emplace(compile_frames(*angle_, start_));
      is_compiled_ = true;
    } catch (const Undecided&) {
      is_undecided_ = true;  // all frames are computed exactly
    }
  }
  /// Has prepare() nothing left to do, and is hardly anything computed exactly?
  bool is_prepared(const Parameters& at) const {
    return at.are_doubles() && (angle_ ? bool(is_compiled_) : bool(is_rounded_));
  }

  Vector<double> point(const Parameters& at, std::size_t k) const {
    if (at.are_doubles() && is_rounded_) {
      const auto [segment, t] = place_at(at.doubles[k], rounded_.size());
      const auto& [x, y, z] = rounded_[segment];
      return finite(Vector<double>{x(t), y(t), z(t)});
    }
    return finite(round_to_double(position(path_, place(at, k))));
  }
  Frame<double> frame(const Parameters& at, std::size_t k) const {
    if (at.are_doubles() && is_compiled_)
      if (const auto found = compiled_->rounded(at.doubles[k])) return *found;
    const Frame<Real> exact = exact_frame(at, k);
    return {round_to_double(exact.e1), round_to_double(exact.e2), round_to_double(exact.e3)};
  }
  /// (x, y, z, w), up to its sign.
  std::array<double, 4> quaternion(const Parameters& at, std::size_t k) const {
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

 private:
  Place place(const Parameters& at, std::size_t k) const {
    return at_place("ts[" + std::to_string(k) + "]", [&] {
      return is_by_length_ ? length_.point(at[k]) : Place(locate(path_, at[k]));
    });
  }
  /// Where all segments are polynomials.
  void round_positions() {
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
  Frame<Real> exact_frame(const Parameters& at, std::size_t k) const {
    const Place here = place(at, k);
    if (kind_ == TabulatedFrame::rmf) return rotation_minimizing_frame(*angle_, here, start_);
    if (kind_ == TabulatedFrame::frenet) return frenet_frame(path_, here);
    return up_frame(path_, angle_->up(), here);
  }

  Path path_;
  std::optional<SmoothAngle> angle_;
  TabulatedFrame kind_;
  Real start_;
  SmoothLength length_;
  bool is_by_length_;
  std::mutex lock_;  ///< while something is made
  std::size_t asked_ = 0;
  std::optional<CompiledFrames> compiled_;
  std::vector<RoundedPoint> rounded_;
  std::atomic<bool> is_compiled_{false};
  std::atomic<bool> is_rounded_{false};
  bool is_undecided_ = false;
};

namespace {

/// What is asked of a path at many places.
struct SmoothArray {
  nb::handle ts;
  nb::handle start = nb::none();
  nb::handle start_normal = nb::none();
  nb::handle up = nb::none();
  std::string kind = "rmf";
  std::string by = "parameter";
  nb::handle progress = nb::none();
  bool wants_frames = true;
};

void require_inside(const Parameters& at, const Path& path, nb::handle ts) {
  const auto end = static_cast<double>(path.segments().size());
  for (std::size_t k = 0; k < at.size(); ++k) {
    if (at.are_doubles() ? at.doubles[k] >= 0 && at.doubles[k] <= end
                         : at[k] >= 0 && at[k] <= path.end())
      continue;
    refuse("ts[" + std::to_string(k) + "]",
           as_written(at[k]) + " is outside [0, " + to_string(path.end()) + "]", ts);
  }
}

/// The numbers that write(source, at, k, out) writes for each place.
template <class Write>
Numbers smooth_numbers(const SmoothPathObject& self, const SmoothArray& asked, std::size_t width,
                       const Write& write) {
  const auto kind = chosen<TabulatedFrame>(asked.kind, "kind",
                                           {{"rmf", TabulatedFrame::rmf},
                                            {"up", TabulatedFrame::up},
                                            {"frenet", TabulatedFrame::frenet}});
  const bool is_by_length =
      chosen<bool>(asked.by, "by", {{"parameter", false}, {"arc_length", true}});
  const auto at = std::make_shared<Parameters>(parameters(asked.ts, "ts"));
  if (!is_by_length) require_inside(*at, self.named.path, asked.ts);
  SmoothFrames frames{asked.wants_frames ? asked.kind : "", {}, {}, is_by_length};
  if (asked.wants_frames)
    frames.start = asked_start(asked.start, asked.start_normal, StartRule::least_rotation, "up");
  if (!asked.up.is_none()) frames.up = vector(asked.up, "up");
  const auto source = self.sources->of(frames, [&] {
    std::optional<SmoothAngle> angle;
    Real start = Rational(0);
    if (asked.wants_frames) {
      angle.emplace(angle_to_up(self.named.path, asked.up));
      start = start_angle(
          smooth_start(asked.start, asked.start_normal, StartRule::least_rotation, *angle), *angle);
    }
    return std::make_shared<SmoothSource>(self.named.path, angle, kind, start, is_by_length);
  });
  const auto numbers = std::make_shared<DoubleArray>(at->size() * width);
  return filled(numbers, asked.progress, source, at, at->are_doubles() && !is_by_length ? many : 4,
                [source, at, numbers, width, write](std::size_t from, std::size_t to) {
                  for (std::size_t k = from; k < to; ++k)
                    write(*source, *at, k, numbers->data() + k * width);
                });
}

nb::object smooth_frames(const SmoothPathObject& self, nb::handle ts, nb::handle start,
                         nb::handle start_normal, nb::handle up, const Text<"kind">& kind,
                         const Text<"by">& by, nb::handle progress) {
  const auto numbers =
      smooth_numbers(self, {ts, start, start_normal, up, kind, by, progress}, 9,
                     [](const SmoothSource& source, const Parameters& at, std::size_t k,
                        double* out) { write_rows(source.frame(at, k), out); });
  return array(numbers, {numbers->size() / 9, 3, 3});
}

nb::object smooth_matrices(const SmoothPathObject& self, nb::handle ts, nb::handle start,
                           nb::handle start_normal, nb::handle up, const Text<"kind">& kind,
                           const Text<"by">& by, nb::handle progress) {
  const auto numbers = smooth_numbers(
      self, {ts, start, start_normal, up, kind, by, progress}, 16,
      [](const SmoothSource& source, const Parameters& at, std::size_t k, double* out) {
        write_pose(source.frame(at, k), source.point(at, k), out);
      });
  return array(numbers, {numbers->size() / 16, 4, 4});
}

nb::object smooth_quaternions(const SmoothPathObject& self, nb::handle ts, nb::handle start,
                              nb::handle start_normal, nb::handle up, const Text<"kind">& kind,
                              const Text<"by">& by, nb::handle progress) {
  const auto numbers = smooth_numbers(
      self, {ts, start, start_normal, up, kind, by, progress}, 4,
      [](const SmoothSource& source, const Parameters& at, std::size_t k, double* out) {
        const auto q = source.quaternion(at, k);
        std::copy(q.begin(), q.end(), out);
      });
  make_continuous(*numbers);
  return array(numbers, {numbers->size() / 4, 4});
}

nb::object smooth_points(const SmoothPathObject& self, nb::handle ts, const Text<"by">& by,
                         nb::handle progress) {
  SmoothArray asked{ts};
  asked.by = by;
  asked.progress = progress;
  asked.wants_frames = false;
  const auto numbers = smooth_numbers(
      self, asked, 3,
      [](const SmoothSource& source, const Parameters& at, std::size_t k, double* out) {
        const Vector<double> r = source.point(at, k);
        std::copy(r.begin(), r.end(), out);
      });
  return array(numbers, {numbers->size() / 3, 3});
}

}  // namespace

nb::object smooth_angles(const SmoothAngle& angle, const Real& start, nb::handle ts,
                         nb::handle progress) {
  const auto at = std::make_shared<Parameters>(parameters(ts, "ts"));
  require_inside(*at, angle.path(), ts);
  const auto numbers = std::make_shared<DoubleArray>(at->size());
  const auto compiled = std::make_shared<std::optional<CompiledAngle>>();
  const bool is_compiled =
      at->are_doubles() && at->size() >= least_compiled * angle.path().segments().size();
  run({.n = at->size(),
       .grain = is_compiled ? many : 1,
       .prepare =
           [=] {
             if (!is_compiled) return;
             try {
               compiled->emplace(compile_angle(angle, start));
             } catch (const Undecided&) {
               // All angles are computed exactly.
             }
           },
       .work =
           [=](std::size_t from, std::size_t to) {
             for (std::size_t k = from; k < to; ++k) {
               const auto near = *compiled ? (*compiled)->rounded(at->doubles[k]) : std::nullopt;
               (*numbers)[k] = near ? *near
                                    : finite(round_to_double(
                                          angle.value(locate(angle.path(), (*at)[k])) + start));
             }
           }},
      progress);
  return array(numbers, {at->size()});
}

void bind_smooth_arrays(nb::class_<SmoothPathObject>& smooth) {
#define PHRAME_SMOOTH_OPTIONS \
  PHRAME_START_PARAMETERS, argument("up") = nb::none(), PHRAME_ARRAY_OPTIONS("rmf")
#define PHRAME_SMOOTH_SIG(name)                                    \
  nb::sig("def " name "(self, " PHRAME_TS ", *, " PHRAME_START_SIG \
          ", up: Vector | None = None, " PHRAME_ARRAY_OPTIONS_SIG ") -> " PHRAME_ARRAY)
  smooth
      .def("frames", smooth_frames, argument("ts"), nb::kw_only(), PHRAME_SMOOTH_OPTIONS,
           PHRAME_SMOOTH_SIG("frames"),
           "Frames as an array (n, 3, 3): [k, 0] is the tangent e1, [k, 1] and [k, 2] are f2, f3. "
           "Every number is correctly rounded. `kind` is rmf, up or frenet; `by` is parameter or "
           "arc_length; where a rotation-minimizing frame starts, `start` or `start_normal` "
           "says: see docs/python.md.")
      .def("quaternions", smooth_quaternions, argument("ts"), nb::kw_only(), PHRAME_SMOOTH_OPTIONS,
           PHRAME_SMOOTH_SIG("quaternions"),
           "The same as unit quaternions (x, y, z, w), scalar last as in SciPy, whose matrices "
           "have the columns e1, f2, f3; each the nearer to that before it of the two.")
      .def("matrices", smooth_matrices, argument("ts"), nb::kw_only(), PHRAME_SMOOTH_OPTIONS,
           PHRAME_SMOOTH_SIG("matrices"),
           "The same as an array (n, 4, 4) of matrices with the columns e1, f2, f3, r.")
      .def("points", smooth_points, argument("ts"), nb::kw_only(), argument("by") = "parameter",
           argument("progress") = nb::none(),
           nb::sig("def points(self, " PHRAME_TS ", *, by: str = 'parameter', " PHRAME_PROGRESS
                   ") -> " PHRAME_ARRAY),
           "r at each parameter, correctly rounded: an array (n, 3).");
#undef PHRAME_SMOOTH_SIG
#undef PHRAME_SMOOTH_OPTIONS
}

}  // namespace phrame::python
