#include "phrame/answer/compiled.hpp"

#include <algorithm>

#include "phrame/answer/rounded.hpp"
#include "phrame/ph/frame/angle_polynomials.hpp"
#include "phrame/ph/frame/compiled_rotation.hpp"
#include "phrame/ph/frame/path_frame.hpp"

namespace phrame::inline v0 {
namespace {

double greatest_error(const PiecewisePolynomial& p) {
  double greatest = 0;
  for (const PolynomialPiece& piece : p.pieces())
    greatest = std::max(greatest, piece.error + piece.error_per_y);
  return greatest * (1 + 0x1p-50);  // not rounded down
}

}  // namespace

CompiledAnswer answer(const NamedPath& named, const CompiledQuery& query) {
  const PathAngle angle = angle_to(query.up, named.path, query.reference);
  const StartAngle start = start_angle(query.start, angle);
  const bool is_up = angle.reference() == Reference::up;
  const RmfAngle* curve = goes_on(named.path) && !is_up ? angle.closed_form(0) : nullptr;
  CompiledAnswer compiled{named, angle.reference(), query.start, FrameAngle(),
                          shared(curve != nullptr ? compiled_angle(*curve, *start.exact, query.from,
                                                                   query.to, plain_shape(1))
                                                  : compiled_angle(angle, start, plain_shape(1)))};
  if (start.exact)
    compiled.start_angle = *start.exact;
  else
    compiled.start_angle = rounded_or_zero(start.value, "theta at t = 0", 17);
  if (is_up) compiled.up = angle.up();
  if (angle.reference() == Reference::frenet) return compiled;
  compiled.rotation = shared(
      curve != nullptr ? compiled_rotation(*ph_curve(named.path.segments().front()), *curve,
                                           *start.exact, query.from, query.to, plain_shape(4))
                       : compiled_rotation(angle, start, plain_shape(4)));
  return compiled;
}

double angle_error(const CompiledAnswer& answer) { return greatest_error(*answer.angle); }

// A component is ((uu ± vv) ± pp) ± qq or twice a sum of two products. With |b| = 1, nearly, the
// products are off by 2^−53 together and each of the three sums by as much, at most; twice a sum of
// two products by half of that. Fused operations leave out some of it.
double component_error(const CompiledAnswer& answer) {
  if (!answer.rotation) return 0;
  return (4 * 0x1p-53 + frame_error(greatest_error(*answer.rotation))) * (1 + 0x1p-40);
}

}  // namespace phrame
