#include "phrame/answer/construction.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/construct/cubic_spline.hpp"
#include "phrame/ph/construct/plane_quintics.hpp"
#include "phrame/ph/construct/quintic_family.hpp"
#include "phrame/ph/construct/scale.hpp"

namespace phrame {
namespace {

struct Task {
  const HermiteSpline& data;
  const ConstructQuery& query;
  Deviation tolerance;
};

/// A row is all that a kind needs here; what it does is in a file of its own in ph/construct.
struct KindRow {
  NamedKind named;
  bool takes_accelerations;
  Construction (*construct)(const Task& task);
};

Construction quintics(const Task& task) {
  return quintic_spline(task.data, task.query.choice, task.tolerance);
}

Construction cubics(const Task& task) {
  if (task.data.is_closed) throw InputError("the kind cubic makes open curves only");
  return cubic_spline(task.data, task.query.solution, task.tolerance);
}

Construction planar(const Task& task) {
  return plane_quintics(task.data, task.query.solution, task.tolerance);
}

const std::vector<KindRow>& rows() {
  static const std::vector<KindRow> table{
      {{CurveKind::quintic, "quintic", "C1 splines of PH quintics"}, false, quintics},
      {{CurveKind::planar, "planar", "the same in the plane z = 0", plane_solutions},
       false,
       planar},
      {{CurveKind::cubic, "cubic", "G1 splines of PH cubics", cubic_solutions, true},
       false,
       cubics}};
  return table;
}

/// Of a segment with a constant multiplier. With A times √s, ∫ κ² ds is s times as small.
ConstructionAnswer::Segment measured(const Curve& curve, std::optional<FreeAngles> angles) {
  const QuaternionPolynomial& a = curve.preimage();
  const Rational h = curve.multiplier().coefficient(0);
  const Polynomial sigma = norm(a);
  const Rational length = h * antiderivative(sigma)(1);
  const Rational scale = scale_for_doubles(length / h);  // of σ, so that of A it is the root
  const Rational root = *square_root(scale);
  std::array<std::vector<Rational>, 4> b{to_bernstein(a.u, 2), to_bernstein(a.v, 2),
                                         to_bernstein(a.p, 2), to_bernstein(a.q, 2)};
  QuinticFamily::Member member;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto value = [&](std::size_t j) { return static_cast<double>(root * b[j][k]); };
    member[k] = {value(0), value(1), value(2), value(3)};
  }
  const double of_unit_size = approximate_energy(member);
  return {angles, length, of_unit_size * static_cast<double>(scale / h)};
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
  if (query.tolerance <= 0 || query.tolerance >= 1)
    throw InputError(fmt::format("the tolerance {} is not between 0 and 1",
                                 abbreviated(to_string(query.tolerance))));
  if (query.solution < 1 || query.solution > row->named.solutions)
    throw InputError(
        fmt::format("the kind {} has no solution {}: {}", row->named.name, query.solution,
                    row->named.solutions == 1 ? std::string("there is one")
                                              : fmt::format("there are {}", row->named.solutions)));
  HermiteSpline data = hermite_spline(given, query.is_closed);
  const Deviation tolerance{
      query.tolerance * size_of_points(data),
      row->named.is_geometric ? query.tolerance : query.tolerance * size_of_derivatives(data)};
  Construction found = row->construct({data, query, tolerance});
  std::vector<ConstructionAnswer::Segment> segments;
  for (std::size_t k = 0; k < found.path.segments().size(); ++k)
    segments.push_back(measured(found.path.segments()[k], found.angles.empty()
                                                              ? std::nullopt
                                                              : std::optional(found.angles[k])));
  return {{given.name, std::move(found.path)},
          row->named,
          query.choice,
          query.solution,
          std::move(data),
          std::move(found.parameters),
          derivative_source(given, query.is_closed),
          parameter_source(given),
          tolerance,
          found.deviation,
          found.bits,
          std::move(segments)};
}

}  // namespace phrame
