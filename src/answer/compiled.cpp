#include "phrame/answer/compiled.hpp"

#include <algorithm>

#include "phrame/answer/rounded.hpp"
#include "phrame/ph/frame/compiled_angle.hpp"
#include "phrame/ph/frame/compiled_frame.hpp"
#include "phrame/ph/frame/path_frame.hpp"

namespace phrame {
namespace {

double greatest_error(const PiecewisePolynomial& p) {
  double greatest = 0;
  for (const PolynomialPiece& piece : p.pieces())
    greatest = std::max(greatest, piece.error + piece.error_per_y);
  return greatest * (1 + 0x1p-50);  // not rounded down
}

CompiledAnswer compiled_spline(const NamedPhPath& named, const CompiledQuery& query) {
  const PathAngle angle(named.path, query.reference);
  const FrameAngle start = start_angle(query.start, named.path, query.reference);
  CompiledAnswer compiled{
      named, query.reference, query.start, start, compiled_angle(angle, start, plain_shape(1)), {}};
  if (query.reference == Reference::euler_rodrigues)
    compiled.rotation = compiled_rotation(angle, start, plain_shape(4));
  return compiled;
}

}  // namespace

CompiledAnswer answer(const NamedPhPath& named, const CompiledQuery& query) {
  if (!named.path.is_curve()) return compiled_spline(named, query);
  const auto& [reference, asked, from, to] = query;
  const Curve& curve = named.path.segments().front();
  const RmfAngle angle(curve, reference);
  const FrameAngle start = start_angle(asked, named.path, reference);
  CompiledAnswer compiled{
      named, reference, asked, start, compiled_angle(angle, start, from, to, plain_shape(1)), {}};
  if (reference == Reference::euler_rodrigues)
    compiled.rotation = compiled_rotation(curve, angle, start, from, to, plain_shape(4));
  return compiled;
}

CompiledAnswer answer(const NamedPath& named, const SmoothCompiledQuery& query) {
  const bool is_up = query.reference == Reference::up;
  const PathAngle angle = !is_up     ? PathAngle(named.path, query.reference)
                          : query.up ? PathAngle(named.path, *query.up)
                                     : PathAngle(named.path, Reference::up);
  const StartAngle start = start_angle(query.start, angle);
  CompiledAnswer compiled{named,
                          is_up ? Reference::euler_rodrigues : Reference::frenet,
                          query.start,
                          rounded_or_zero(start.value, "theta at t = 0", 17),
                          compiled_angle(angle, start, plain_shape(1)),
                          {}};
  if (!is_up) return compiled;
  compiled.rotation = compiled_rotation(angle, start, plain_shape(4));
  compiled.up = angle.up();
  return compiled;
}

double angle_error(const CompiledAnswer& answer) { return greatest_error(answer.angle); }

// A component is ((uu ± vv) ± pp) ± qq or twice a sum of two products. With |b| = 1, nearly, the
// products are off by 2^−53 together and each of the three sums by as much, at most; twice a sum of
// two products by half of that. Fused operations leave out some of it.
double component_error(const CompiledAnswer& answer) {
  if (!answer.rotation) return 0;
  return (4 * 0x1p-53 + frame_error(greatest_error(*answer.rotation))) * (1 + 0x1p-40);
}

}  // namespace phrame
