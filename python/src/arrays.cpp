#include <nanobind/ndarray.h>

#include <cmath>
#include <memory>

#include "jobs.hpp"
#include "paths.hpp"

namespace phrame::python {
namespace {

/// Parameters: doubles where all of them are, else fractions.
struct Parameters {
  std::vector<double> doubles;
  std::vector<Rational> fractions;

  std::size_t size() const { return doubles.empty() ? fractions.size() : doubles.size(); }
  bool are_doubles() const { return !doubles.empty(); }
  Rational operator[](std::size_t k) const {
    return are_doubles() ? exact_rational(doubles[k]) : fractions[k];
  }
};

/// Of an array of doubles, of one of another kind, or of a list of numbers.
Parameters parameters(nb::handle ts, const std::string& place) {
  Parameters found;
  nb::object list = nb::borrow(ts);
  if (nb::ndarray_check(ts) && nb::hasattr(ts, "dtype")) {
    if (nb::cast<long>(ts.attr("ndim")) != 1)
      refuse(place,
             "an array of one dimension is wanted, its shape is " +
                 nb::cast<std::string>(nb::str(nb::object(ts.attr("shape")))),
             ts);
    const std::string kind = nb::cast<std::string>(ts.attr("dtype").attr("kind"));
    if (kind == "f" && nb::cast<long>(ts.attr("dtype").attr("itemsize")) <= 8) {
      const auto array =
          nb::cast<nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>>(
              ts.attr("astype")("float64", nb::arg("order") = "C", nb::arg("copy") = false));
      found.doubles.assign(array.data(), array.data() + array.shape(0));
    } else {
      list = ts.attr("tolist")();
    }
  }
  if (found.doubles.empty()) found.fractions = rationals(list, place);
  if (found.size() == 0) refuse(place, "it is empty", ts);
  for (std::size_t k = 0; k < found.doubles.size(); ++k)
    if (!std::isfinite(found.doubles[k]))
      refuse(place + "[" + std::to_string(k) + "]", "not a finite number", ts);
  for (const Rational& t : found.fractions) {
    const double near = round_to_double(t);
    if (!std::isfinite(near) || exact_rational(near) != t) {
      found.doubles.clear();
      return found;
    }
    found.doubles.push_back(near);
  }
  return found;
}

/// An array of these dimensions, which shares the numbers.
nb::object array(const std::shared_ptr<std::vector<double>>& numbers,
                 const std::vector<std::size_t>& shape) {
  using Owner = std::shared_ptr<std::vector<double>>;
  const nb::capsule owner(new Owner(numbers),
                          [](void* p) noexcept { delete static_cast<Owner*>(p); });
  return nb::cast(
      nb::ndarray<nb::numpy, double>(numbers->data(), shape.size(), shape.data(), owner));
}

/// A number that no double can hold is no answer.
double finite(double x) {
  if (!std::isfinite(x)) throw InputError("the result is too large for a double");
  return x;
}

enum class FrameKind { rmf, erf, frenet };

/// Below so many, to approximate first takes longer.
constexpr std::size_t least_compiled = 16;

/// The frames of a path, each as exactly as rounding wants, and their unit quaternions.
class FrameSource {
 public:
  FrameSource(Path path, FrameKind kind, const FrameAngle& start)
      : path_(std::move(path)), kind_(kind), start_(start) {}

  /// To be called once, before the others, which any thread may call.
  void prepare(const Parameters& at);

  Frame<double> frame(const Parameters& at, std::size_t k) const;
  /// (x, y, z, w).
  std::array<double, 4> quaternion(const Parameters& at, std::size_t k) const;
  Vector<double> point(const Parameters& at, std::size_t k) const;

 private:
  /// B = A/|A|·e^{iφ}, φ half of θ + start, up to the sign that makes it continuous.
  std::array<Real, 4> rotation(const PathParameter& at) const;
  std::array<bool, 4> zeros() const;

  Path path_;
  FrameKind kind_;
  FrameAngle start_;
  std::vector<Vector<Polynomial>> positions_;
  std::vector<Frames> frames_;                   ///< of the segments
  std::vector<QuaternionPolynomial> preimages_;  ///< without real factors
  std::vector<int> signs_;                       ///< of the preimages
  std::optional<PathAngle> angle_;
  std::optional<CompiledFrames> compiled_;
  std::array<bool, 4> zeros_{};  ///< components u, v, p, q of B that are 0 everywhere
};

/// Of A: which of its components at a joint are those of what comes next, up to a positive factor.
int joint_sign(const QuaternionPolynomial& before, const QuaternionPolynomial& after) {
  const RationalQuaternion a = evaluate(before, 1);
  const RationalQuaternion b = evaluate(after, 0);
  return (a.u * b.u + a.v * b.v + a.p * b.p + a.q * b.q).sign() < 0 ? -1 : 1;
}

void FrameSource::prepare(const Parameters& at) {
  for (const Curve& curve : path_.segments()) {
    positions_.push_back(position(curve));
    frames_.emplace_back(curve);
    preimages_.push_back(without_real_content(curve.preimage()));
    const std::size_t k = preimages_.size() - 1;
    signs_.push_back(k == 0 ? 1 : signs_[k - 1] * joint_sign(preimages_[k - 1], preimages_[k]));
  }
  if (kind_ != FrameKind::rmf) return;
  angle_.emplace(path_);
  zeros_ = zeros();
  if (!at.are_doubles() || at.size() < least_compiled) return;
  try {
    if (!path_.is_curve()) {
      compiled_.emplace(*angle_, start_);
      return;
    }
    const auto [from, to] = std::minmax_element(at.doubles.begin(), at.doubles.end());
    if (*from < *to)
      compiled_.emplace(path_.segments().front(), angle_->segment(0), *from, *to, start_);
  } catch (const Undecided&) {
    // Poles of θ′ are too near: all frames are computed exactly.
  }
}

std::array<bool, 4> FrameSource::zeros() const {
  std::array<bool, 4> zero;
  zero.fill(true);
  for (std::size_t k = 0; k < preimages_.size(); ++k) {
    const auto& [u, v, p, q] = preimages_[k];
    const bool is_erf = angle_->segment(k).rate().is_zero() && start_ == FrameAngle();
    const bool uv = u.is_zero() && v.is_zero();
    const bool pq = p.is_zero() && q.is_zero();
    const std::array<bool, 4> of_segment{is_erf ? u.is_zero() : uv, is_erf ? v.is_zero() : uv,
                                         is_erf ? p.is_zero() : pq, is_erf ? q.is_zero() : pq};
    for (std::size_t i = 0; i < 4; ++i) zero[i] = zero[i] && of_segment[i];
  }
  return zero;
}

Frame<double> FrameSource::frame(const Parameters& at, std::size_t k) const {
  if (compiled_)
    if (const auto found = compiled_->rounded(at.doubles[k])) return *found;
  const PathParameter here = locate(path_, at[k]);
  const Frames& frames = frames_[here.segment];
  const Frame<Real> exact = [&] {
    if (kind_ == FrameKind::frenet) return frames.frenet(here.t);
    const Frame<Rational> erf = frames.euler_rodrigues(here.t);
    if (kind_ == FrameKind::erf) return as_real(erf);
    return turned(
        erf, angle_->direction(here),
        [&](const FrameAngle& start) { return angle_->value(here, start); }, start_);
  }();
  return {round_to_double(exact.e1), round_to_double(exact.e2), round_to_double(exact.e3)};
}

std::array<Real, 4> FrameSource::rotation(const PathParameter& at) const {
  RationalQuaternion a = evaluate(preimages_[at.segment], at.t);
  if (signs_[at.segment] < 0) a = {-a.u, -a.v, -a.p, -a.q};
  const Real theta = angle_->value(at, start_);
  if (theta.exact() == Rational(0)) {
    const Real over_size = square_root_of(1 / norm(a));
    return {over_size * a.u, over_size * a.v, over_size * a.p, over_size * a.q};
  }
  // (x + yi)·e^{±iφ}/|A|
  const auto turned = [&](const Rational& x, const Rational& y, int sign, bool imaginary) {
    return Real([=](long bits) {
      const CosSin unit = cos_sin(times_power_of_two(theta.enclose(bits), -1), bits);
      const RealBall sine = sign < 0 ? subtract(RealBall(), unit.sin, bits) : unit.sin;
      const RealBall first = multiply(RealBall(imaginary ? y : x, bits), unit.cos, bits);
      const RealBall second = multiply(RealBall(imaginary ? x : y, bits), sine, bits);
      const RealBall sum = imaginary ? add(first, second, bits) : subtract(first, second, bits);
      return divide(sum, sqrt(RealBall(norm(a), bits), bits), bits);
    });
  };
  return {turned(a.u, a.v, 1, false), turned(a.u, a.v, 1, true), turned(a.p, a.q, -1, false),
          turned(a.p, a.q, -1, true)};
}

std::array<double, 4> FrameSource::quaternion(const Parameters& at, std::size_t k) const {
  std::array<double, 4> b{};
  std::optional<std::array<Real, 4>> exact;
  const PathParameter here = locate(path_, at[k]);
  std::optional<CompiledFrames::Rotation> near;
  if (compiled_) near = compiled_->rotation(at.doubles[k]);
  for (std::size_t i = 0; i < 4; ++i) {
    if (zeros_[i]) continue;
    std::optional<double> common;
    if (near) {
      const auto& [u, v, p, q] = near->b;
      const DoubleDouble x = std::array{u, v, p, q}[i];
      common = common_double(x, near->error + 0x1p-94);
      if (common && signs_[here.segment] < 0) common = -*common;
    }
    if (!common && !exact) exact = rotation(here);
    b[i] = common ? *common : round_to_double((*exact)[i]);
  }
  return {b[1], b[2], b[3], b[0]};
}

Vector<double> FrameSource::point(const Parameters& at, std::size_t k) const {
  const PathParameter here = locate(path_, at[k]);
  Vector<double> r = round_to_double(evaluate(positions_[here.segment], here.t));
  for (double& x : r) x = finite(x);
  return r;
}

FrameKind frame_kind(const std::string& name) {
  if (name == "rmf") return FrameKind::rmf;
  if (name == "erf") return FrameKind::erf;
  if (name == "frenet") return FrameKind::frenet;
  refuse("kind", "\"" + abbreviated(name) + "\" is not one of rmf, erf, frenet",
         nb::str(name.c_str()));
}

/// What a caller asks for.
struct Asked {
  std::shared_ptr<FrameSource> source;
  std::shared_ptr<Parameters> at;
};

/// Of the places where the arc length from the start is s: a table of t, r and the frame.
nb::object by_arc_length(const PathObject& self, FrameKind kind, const FrameStart& start,
                         nb::handle s, nb::handle progress,
                         const std::function<void(const double* row, double* out)>& pick,
                         std::vector<std::size_t> shape) {
  auto at = std::make_shared<Parameters>(parameters(s, "ts"));
  std::size_t width = 1;
  for (const std::size_t n : shape) width *= n;
  shape.insert(shape.begin(), at->size());
  auto numbers = std::make_shared<std::vector<double>>(at->size() * width);
  const TabulatedFrame frame = kind == FrameKind::rmf   ? TabulatedFrame::rmf
                               : kind == FrameKind::erf ? TabulatedFrame::euler_rodrigues
                                                        : TabulatedFrame::frenet;
  TableColumns columns{.frames = {frame}};
  columns.start = start;
  run({.n = at->size(),
       .grain = 16,
       .work =
           [path = self.named.path, columns, at, numbers, pick, width](std::size_t from,
                                                                       std::size_t to) {
             const PathLength length(path);
             std::vector<PathPoint> points;
             for (std::size_t k = from; k < to; ++k) points.push_back(length.point((*at)[k]));
             const FrameTable table = frame_table(path, columns, points);
             for (std::size_t k = from; k < to; ++k)
               pick(table.rows[k - from].data(), numbers->data() + k * width);
           }},
      progress);
  return array(numbers, shape);
}

bool is_by_arc_length(const std::string& by) {
  if (by != "parameter" && by != "arc_length")
    refuse("by", "\"" + abbreviated(by) + "\" is not one of parameter, arc_length",
           nb::str(by.c_str()));
  return by == "arc_length";
}

Asked asked(const PathObject& self, nb::handle ts, FrameKind kind, const FrameStart& start) {
  auto at = std::make_shared<Parameters>(parameters(ts, "ts"));
  for (std::size_t k = 0; k < at->size() && !self.named.path.is_curve(); ++k)
    if (const Rational t = (*at)[k]; t < 0 || t > self.named.path.end())
      refuse("ts[" + std::to_string(k) + "]",
             to_string(t) + " is outside [0, " + to_string(self.named.path.end()) + "]", ts);
  const FrameAngle from =
      kind == FrameKind::rmf ? start_angle(start, self.named.path) : FrameAngle();
  return {std::make_shared<FrameSource>(self.named.path, kind, from), std::move(at)};
}

/// Runs write(source, at, k, out) for all k.
template <class Write>
nb::object filled(const Asked& asked, std::vector<std::size_t> shape, nb::handle progress,
                  std::size_t grain, const Write& write) {
  std::size_t width = 1;
  for (const std::size_t n : shape) width *= n;
  const auto& [source, at] = asked;
  shape.insert(shape.begin(), at->size());
  auto numbers = std::make_shared<std::vector<double>>(at->size() * width);
  run({.n = at->size(),
       .grain = at->are_doubles() ? grain : 16,
       .prepare = [source, at] { source->prepare(*at); },
       .work =
           [source, at, numbers, width, write](std::size_t from, std::size_t to) {
             for (std::size_t k = from; k < to; ++k)
               write(*source, *at, k, numbers->data() + k * width);
           }},
      progress);
  return array(numbers, shape);
}

void write_rows(const Frame<double>& f, double* out) {
  for (const auto* v : {&f.e1, &f.e2, &f.e3}) out = std::copy(v->begin(), v->end(), out);
}

/// A matrix with the columns e₁, f₂, f₃, r; (0, 0, 0, 1) below.
void write_pose(const Frame<double>& f, const Vector<double>& r, double* out) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::array row{f.e1[i], f.e2[i], f.e3[i], r[i]};
    out = std::copy(row.begin(), row.end(), out);
  }
  const std::array<double, 4> last{0, 0, 0, 1};
  std::copy(last.begin(), last.end(), out);
}

/// The columns of a table: t, r, e₁, f₂, f₃.
Frame<double> frame_of_row(const double* row) {
  const auto v = [row](std::size_t k) { return Vector<double>{row[k], row[k + 1], row[k + 2]}; };
  return {v(4), v(7), v(10)};
}

constexpr std::size_t many = 1024;

nb::object frames(const PathObject& self, nb::handle ts, nb::handle start, nb::handle start_normal,
                  const std::string& kind_name, const std::string& by, nb::handle progress) {
  const FrameKind kind = frame_kind(kind_name);
  const FrameStart from =
      frame_start(start, start_normal, self.named.path, Reference::euler_rodrigues);
  if (is_by_arc_length(by))
    return by_arc_length(self, kind, from, ts, progress,
                         [](const double* row, double* out) { write_rows(frame_of_row(row), out); },
                         {3, 3});
  return filled(asked(self, ts, kind, from), {3, 3}, progress, many,
                [](const FrameSource& source, const Parameters& at, std::size_t k, double* out) {
                  write_rows(source.frame(at, k), out);
                });
}

nb::object matrices(const PathObject& self, nb::handle ts, nb::handle start,
                    nb::handle start_normal, const std::string& kind_name, const std::string& by,
                    nb::handle progress) {
  const FrameKind kind = frame_kind(kind_name);
  const FrameStart from =
      frame_start(start, start_normal, self.named.path, Reference::euler_rodrigues);
  if (is_by_arc_length(by))
    return by_arc_length(self, kind, from, ts, progress,
                         [](const double* row, double* out) {
                           write_pose(frame_of_row(row), {row[1], row[2], row[3]}, out);
                         },
                         {4, 4});
  return filled(asked(self, ts, kind, from), {4, 4}, progress, many,
                [](const FrameSource& source, const Parameters& at, std::size_t k, double* out) {
                  write_pose(source.frame(at, k), source.point(at, k), out);
                });
}

nb::object quaternions(const PathObject& self, nb::handle ts, nb::handle start,
                       nb::handle start_normal, nb::handle progress) {
  const FrameStart from =
      frame_start(start, start_normal, self.named.path, Reference::euler_rodrigues);
  return filled(asked(self, ts, FrameKind::rmf, from), {4}, progress, many,
                [](const FrameSource& source, const Parameters& at, std::size_t k, double* out) {
                  const auto q = source.quaternion(at, k);
                  std::copy(q.begin(), q.end(), out);
                });
}

nb::object points(const PathObject& self, nb::handle ts, const std::string& by,
                  nb::handle progress) {
  if (is_by_arc_length(by))
    return by_arc_length(self, FrameKind::erf, Angle(), ts, progress,
                         [](const double* row, double* out) { std::copy(row + 1, row + 4, out); },
                         {3});
  return filled(asked(self, ts, FrameKind::erf, Angle()), {3}, progress, many,
                [](const FrameSource& source, const Parameters& at, std::size_t k, double* out) {
                  const Vector<double> r = source.point(at, k);
                  std::copy(r.begin(), r.end(), out);
                });
}

}  // namespace

nb::object angles(const PathAngle& angle, const FrameAngle& start, nb::handle ts,
                  nb::handle progress) {
  auto at = std::make_shared<Parameters>(parameters(ts, "ts"));
  auto numbers = std::make_shared<std::vector<double>>(at->size());
  auto compiled = std::make_shared<std::optional<CompiledAngle>>();
  const auto prepare = [=] {
    if (!at->are_doubles() || at->size() < least_compiled) return;
    const auto [from, to] = std::minmax_element(at->doubles.begin(), at->doubles.end());
    try {
      if (angle.path().is_curve() && *from < *to)
        compiled->emplace(angle.segment(0), *from, *to, start);
      else if (!angle.path().is_curve())
        compiled->emplace(angle, start);
    } catch (const Undecided&) {
      // Poles of θ′ are too near: all angles are computed exactly.
    }
  };
  run({.n = at->size(),
       .grain = at->are_doubles() && at->size() >= least_compiled ? many : 1,
       .prepare = prepare,
       .work =
           [=](std::size_t from, std::size_t to) {
             std::optional<CompiledAngle> mine = *compiled;  // it counts, so that each has its own
             for (std::size_t k = from; k < to; ++k)
               (*numbers)[k] = finite(mine ? (*mine)(at->doubles[k])
                                           : round_to_double(angle.value((*at)[k], start)));
           }},
      progress);
  return array(numbers, {at->size()});
}

#define PHRAME_ARRAY "numpy.typing.NDArray[numpy.float64]"
#define PHRAME_TS "ts: Numbers"
#define PHRAME_PROGRESS "progress: collections.abc.Callable[[int, int], object] | None = None"

void bind_arrays(nb::class_<PathObject>& path) {
  path.def("frames", frames, nb::arg("ts"), nb::kw_only(), PHRAME_START_PARAMETERS,
           nb::arg("kind") = "rmf", nb::arg("by") = "parameter", nb::arg("progress") = nb::none(),
           nb::sig("def frames(self, " PHRAME_TS ", *, " PHRAME_START_SIG
                   ", kind: str = 'rmf', by: str = 'parameter', " PHRAME_PROGRESS
                   ") -> " PHRAME_ARRAY),
           "Frames as an array (n, 3, 3): [k, 0] is the tangent e1, [k, 1] and [k, 2] are f2, f3. "
           "Every number is correctly rounded. `kind` is rmf, erf or frenet; `by` is parameter or "
           "arc_length; a rotation-minimizing frame starts at the angle `start` to the "
           "Euler–Rodrigues frame or with f2 along `start_normal`.")
      .def("quaternions", quaternions, nb::arg("ts"), nb::kw_only(), PHRAME_START_PARAMETERS,
           nb::arg("progress") = nb::none(),
           nb::sig("def quaternions(self, " PHRAME_TS ", *, " PHRAME_START_SIG ", " PHRAME_PROGRESS
                   ") -> " PHRAME_ARRAY),
           "Rotation-minimizing frames as unit quaternions (x, y, z, w), scalar last as in SciPy, "
           "whose matrices have the columns e1, f2, f3; continuous along the path.")
      .def("matrices", matrices, nb::arg("ts"), nb::kw_only(), PHRAME_START_PARAMETERS,
           nb::arg("kind") = "rmf", nb::arg("by") = "parameter", nb::arg("progress") = nb::none(),
           nb::sig("def matrices(self, " PHRAME_TS ", *, " PHRAME_START_SIG
                   ", kind: str = 'rmf', by: str = 'parameter', " PHRAME_PROGRESS
                   ") -> " PHRAME_ARRAY),
           "The same as an array (n, 4, 4) of matrices with the columns e1, f2, f3, r.")
      .def("points", points, nb::arg("ts"), nb::kw_only(), nb::arg("by") = "parameter",
           nb::arg("progress") = nb::none(),
           nb::sig("def points(self, " PHRAME_TS ", *, by: str = 'parameter', " PHRAME_PROGRESS
                   ") -> " PHRAME_ARRAY),
           "r at each parameter, correctly rounded: an array (n, 3).");
}

}  // namespace phrame::python
