#include "phrame/answer/construction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/ph/along/arc_length.hpp"
#include "phrame/ph/construct/c2_hermite.hpp"
#include "phrame/ph/construct/c2_spline.hpp"
#include "phrame/ph/construct/cubic_spline.hpp"
#include "phrame/ph/construct/energy.hpp"
#include "phrame/ph/construct/helical_spline.hpp"
#include "phrame/ph/construct/length_spline.hpp"
#include "phrame/ph/construct/plane_quintics.hpp"
#include "phrame/ph/construct/rmf_spline.hpp"
#include "phrame/ph/construct/rrmf_spline.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/scale.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

struct Task {
  const HermiteSpline& data;
  const ConstructQuery& query;
  Deviation tolerance;
  std::vector<Rational> lengths;  ///< of the segments, where they are given
};

/// A row is all that a kind needs here; what it does is in a file of its own in ph/construct.
struct KindRow {
  NamedKind named;
  bool takes_accelerations = false;
  bool takes_poses = false;
  Construction (*construct)(const Task& task);
  /// Is the law true of it, decided exactly? None where there is no law.
  bool (*obeys_law)(const PhPath& path, bool is_closed) = nullptr;
};

/// @{ Of kinds that take nothing else, and of those with several solutions.
template <auto make>
Construction of_data(const Task& task) {
  return make(task.data, task.tolerance, task.query.points);
}
template <auto make>
Construction of_solution(const Task& task) {
  return make(task.data, task.query.solution, task.tolerance, task.query.points);
}
/// @}

template <bool (*is_lawful)(const PhPath&)>
bool of_path(const PhPath& path, bool) {
  return is_lawful(path);
}

constexpr std::string_view c2_law = "the second derivative by the parameter is continuous";

bool is_without_twist(const PhPath& path) {
  return std::ranges::all_of(path.segments(), [](const Curve& curve) {
    return twist_numerator(curve.preimage()).is_zero();
  });
}

bool is_in_plane(const PhPath& path) {
  return std::ranges::all_of(path.segments(), [](const Curve& curve) {
    return curve.start()[2] == 0 && rotated_i(curve.preimage())[2].is_zero();
  });
}

const std::vector<KindRow>& rows() {
  static const std::vector<KindRow> table{
      {.named = {.kind = CurveKind::quintic,
                 .name = "quintic",
                 .what = "C1 splines of PH quintics",
                 .continuity = Continuity::c1},
       .takes_poses = true,
       .construct =
           [](const Task& t) {
             return quintic_spline(t.data, t.query.choice, t.tolerance, t.query.points);
           }},
      {.named = {.kind = CurveKind::planar,
                 .name = "planar",
                 .what = "the same in the plane z = 0",
                 .continuity = Continuity::c1,
                 .solutions = plane_solutions,
                 .law = "the curve is in the plane z = 0"},
       .construct = of_solution<plane_quintics>,
       .obeys_law = of_path<is_in_plane>},
      {.named = {.kind = CurveKind::cubic,
                 .name = "cubic",
                 .what = "G1 splines of PH cubics",
                 .continuity = Continuity::g1,
                 .solutions = cubic_solutions,
                 .is_open = true},
       .construct = of_solution<cubic_spline>},
      {.named = {.kind = CurveKind::helical,
                 .name = "helical",
                 .what = "C1 splines of helical quintics",
                 .continuity = Continuity::c1,
                 .solutions = helical_solutions,
                 .law = "the tangent of each segment has a constant angle to an axis",
                 .is_open = true},
       .construct = of_solution<helical_spline>,
       .obeys_law = of_path<is_helical>},
      {.named = {.kind = CurveKind::rrmf,
                 .name = "rrmf",
                 .what = "G1 splines of RRMF quintics of class I",
                 .continuity = Continuity::g1,
                 .law = "each segment has a rational rotation-minimizing frame",
                 .is_open = true},
       .construct = of_data<rrmf_spline>,
       .obeys_law = of_path<is_rrmf_of_class_one>},
      {.named = {.kind = CurveKind::rmf,
                 .name = "rmf",
                 .what = "C1 splines of septics whose rational frame is rotation-minimizing",
                 .continuity = Continuity::c1,
                 .law = "h = 0: the Euler-Rodrigues frame is rotation-minimizing"},
       .construct = of_data<rmf_spline>,
       .obeys_law = of_path<is_without_twist>},
      {.named = {.kind = CurveKind::c2,
                 .name = "c2",
                 .what = "C2 splines of PH quintics through points",
                 .continuity = Continuity::c2,
                 .law = c2_law,
                 .is_through_points = true},
       .construct = of_data<c2_spline>,
       .obeys_law = is_c2},
      {.named = {.kind = CurveKind::c2_hermite,
                 .name = "c2-hermite",
                 .what = "C2 splines of degree 9 with accelerations",
                 .continuity = Continuity::c2,
                 .law = c2_law},
       .takes_accelerations = true,
       .construct = of_data<c2_hermite_spline>,
       .obeys_law = is_c2},
      {.named = {.kind = CurveKind::length,
                 .name = "length",
                 .what = "G1 splines of PH quintics of given lengths",
                 .continuity = Continuity::g1,
                 .is_open = true,
                 .takes_lengths = true},
       .construct = [](const Task& t) { return length_spline(t.data, t.lengths, t.tolerance); }}};
  return table;
}

/// f > 0: there is no way back on a curve that is made here.
ConstructionAnswer::Segment measured(const Curve& curve, std::optional<FreeAngles> angles) {
  return {std::move(angles), arc_length(curve)(1), proved_energy(curve)};
}

/// The orientations at the joints that are points of the data; there may be others between them.
FrameThrough frame_through(const GivenPoses& poses, const HermiteSpline& data,
                           const std::vector<Rational>& parameters) {
  FrameThrough through{{}, poses.is_smooth, poses.tangent};
  std::size_t joint = 0;
  for (std::size_t k = 0; k < data.frames.size(); ++k) {
    while (parameters[joint] != data.parameters[k]) ++joint;
    const long turns = k == 0 || k > poses.turns.size() ? 0 : poses.turns[k - 1];
    const Vector<Integer> f2 = rotated_j(data.frames[k]);
    const Integer divisor = gcd(gcd(f2[0], f2[1]), f2[2]);
    through.joints.push_back(
        {joint, each(f2, [&](const Integer& x) { return Rational(x / divisor); }), turns});
  }
  return through;
}

/// Between two vectors ≠ 0.
double angle_between(const Vector<double>& a, const Vector<double>& b) {
  const Vector<double> n = cross(a, b);
  return std::atan2(std::sqrt(dot(n, n)), dot(a, b));
}

/// Of all tangents to the chords beside them, the mean.
double angle_to_chords(const GivenPoses& poses, const HermiteSpline& data,
                       const TangentAxis& tangent) {
  const Rational scale = scale_for_doubles(size_of_points(data));
  double sum = 0;
  for (std::size_t k = 0; k < data.segments(); ++k) {
    const Vector<double> chord = scaled_to_doubles(scale, data.points[k + 1] - data.points[k]);
    for (const std::size_t j : {k, k + 1}) {
      const auto frame = frame_rotation(poses.bodies[j % poses.bodies.size()].rotation, tangent);
      const Rational size = norm(frame);
      const auto axis =
          each(rotated_i(frame), [&](const Integer& x) { return Rational(x / size); });
      sum += angle_between(scaled_to_doubles(1, axis), chord);
    }
  }
  return sum / (2 * static_cast<double>(data.segments()));
}

/// Another axis may have been meant where its angle is less than a third of that of the one asked
/// for, and that more than half a radian.
ConstructionAnswer::Poses facts_of(const GivenPoses& poses, const HermiteSpline& data) {
  ConstructionAnswer::Poses facts{};
  for (const Orientation& body : poses.bodies) facts.off = std::max(facts.off, body.off);
  facts.angle = facts.better_angle = angle_to_chords(poses, data, poses.tangent);
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const bool is_reversed : {false, true}) {
      const double angle = angle_to_chords(poses, data, {axis, is_reversed});
      if (angle < facts.better_angle) {
        facts.better_angle = angle;
        facts.better = TangentAxis{axis, is_reversed};
      }
    }
  if (facts.angle < 3 * facts.better_angle || facts.angle < 0.5) facts.better.reset();
  return facts;
}

}  // namespace

const std::vector<NamedKind>& curve_kinds() {
  static const std::vector<NamedKind> kinds = [] {
    std::vector<NamedKind> list;
    for (const KindRow& row : rows()) list.push_back(row.named);
    return list;
  }();
  return kinds;
}

ConstructionAnswer answer(const GivenPoints& given, const ConstructQuery& query) {
  const auto row = std::find_if(rows().begin(), rows().end(), [&](const KindRow& candidate) {
    return candidate.named.kind == query.kind;
  });
  if (!given.accelerations.empty() && !row->takes_accelerations)
    throw InputError("/accelerations",
                     fmt::format("the kind {} takes points and derivatives only", row->named.name));
  if (given.accelerations.empty() && row->takes_accelerations)
    throw InputError(fmt::format(
        "the kind {} wants accelerations; for points only there is the kind c2", row->named.name));
  if (given.poses && !row->takes_poses)
    throw InputError(
        fmt::format("the kind {} takes no orientations; quintic does", row->named.name));
  if (row->named.is_through_points && query.is_closed)
    for (const auto& [place, list] :
         {std::pair("/derivatives", &given.derivatives), std::pair("/tangents", &given.tangents)})
      if (!list->empty())
        throw InputError(place, fmt::format("a closed spline of the kind {} takes points only",
                                            row->named.name));
  if (query.tolerance <= 0 || query.tolerance >= 1)
    throw InputError(
        fmt::format("the tolerance {} is not between 0 and 1", as_written(query.tolerance)));
  if (query.solution < 1 || query.solution > row->named.solutions)
    throw InputError(
        fmt::format("the kind {} has no solution {}: {}", row->named.name, query.solution,
                    row->named.solutions == 1 ? std::string("there is one")
                                              : fmt::format("there are {}", row->named.solutions)));
  if (query.is_closed && row->named.is_open)
    throw InputError(fmt::format("the kind {} makes open curves only", row->named.name));
  if (query.lengths.empty() == row->named.takes_lengths)
    throw InputError(fmt::format("the kind {} {} lengths", row->named.name,
                                 row->named.takes_lengths ? "wants" : "takes no"));
  if (row->named.takes_lengths && query.points == PointRule::exact)
    throw InputError(fmt::format("the kind {} does not meet points exactly", row->named.name));
  if (query.kind == CurveKind::planar)
    for (const auto& [what, list] :
         {std::pair("point", &given.points), {"derivative at point", &given.derivatives}})
      for (std::size_t k = 0; k < list->size(); ++k)
        if ((*list)[k][2] != 0)
          throw InputError(
              fmt::format("the {} {} has z = {}, but a plane curve is wanted, in z = 0", what,
                          k + 1, as_written((*list)[k][2])));
  HermiteSpline data = hermite_spline(given, query.is_closed);
  const std::vector<Rational> lengths =
      query.lengths.empty() ? std::vector<Rational>() : segment_lengths(data, query.lengths);
  if (given.poses && !given.poses->turns.empty() && given.poses->turns.size() != data.segments() &&
      given.poses->turns.size() != given.points.size() - 1)
    throw InputError(
        "/turns",
        fmt::format("{} for {} points; {} wanted, one for each segment", given.poses->turns.size(),
                    given.points.size(),
                    data.segments() == 1 ? "1 is" : fmt::format("{} are", data.segments())));
  const Deviation tolerance{
      query.tolerance * size_of_points(data),
      row->named.continuity == Continuity::g1 ? query.tolerance
                                              : query.tolerance * size_of_derivatives(data),
      query.tolerance * size_of_accelerations(data), query.tolerance * size_of_points(data)};
  Construction found = row->construct({data, query, tolerance, lengths});
  if (row->obeys_law != nullptr && !row->obeys_law(found.path, data.is_closed))
    throw Error(fmt::format("construct: it is not true that {}", row->named.law));
  std::vector<ConstructionAnswer::Segment> segments;
  for (std::size_t k = 0; query.is_measured && k < found.path.segments().size(); ++k)
    segments.push_back(measured(found.path.segments()[k], found.angles.empty()
                                                              ? std::nullopt
                                                              : std::optional(found.angles[k])));
  NamedPhPath named(given.name, std::move(found.path));
  std::optional<ConstructionAnswer::Poses> poses;
  if (given.poses) {
    named.frame = frame_through(*given.poses, data, found.parameters);
    poses = facts_of(*given.poses, data);
  }
  return {std::move(named),
          row->named,
          query.choice,
          query.solution,
          query.points,
          std::move(data),
          std::move(found.parameters),
          derivative_source(given, query.is_closed),
          parameter_source(given),
          tolerance,
          found.deviation,
          found.bits,
          poses,
          std::move(segments)};
}

}  // namespace phrame
