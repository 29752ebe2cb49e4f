#include "phrame/answer/end_normal.hpp"

#include "phrame/algebra/error.hpp"

namespace phrame::inline v0 {

void require_open(const std::optional<Vector<Rational>>& end_normal, bool is_closed) {
  if (end_normal && is_closed)
    throw DomainError("end normal: the path is closed, it ends with the normal it starts with");
}

std::optional<FrameStart> end_of_frame(const std::optional<Vector<Rational>>& end_normal) {
  if (!end_normal) return std::nullopt;
  return StartNormal(*end_normal);
}

}  // namespace phrame
