#include "phrame/answer/row_places.hpp"

namespace phrame::inline v0 {

RowPlaces::RowPlaces(std::vector<Place> at, std::vector<Rational> numbers, bool are_lengths)
    : at_(std::make_shared<const std::vector<Place>>(std::move(at))),
      numbers_(std::make_shared<const std::vector<Rational>>(std::move(numbers))),
      are_lengths_(are_lengths) {}

RowPlaces::RowPlaces(std::vector<Rational> t, std::function<Place(const Rational&)> locate)
    : numbers_(std::make_shared<const std::vector<Rational>>(std::move(t))),
      locate_(std::move(locate)) {}

RowPlaces::RowPlaces(std::vector<Rational> s, PathLength length)
    : numbers_(std::make_shared<const std::vector<Rational>>(std::move(s))),
      length_(std::move(length)),
      are_lengths_(true) {}

Place RowPlaces::place(std::size_t k) const {
  if (at_) return (*at_)[k];
  return length_ ? length_->point(numbers()[k]) : locate_(numbers()[k]);
}

std::optional<Rational> RowPlaces::arc_length(std::size_t k) const {
  return are_lengths_ ? std::optional(numbers()[k]) : std::nullopt;
}

std::optional<NearNumber> RowPlaces::number(std::size_t k) const {
  if (!at_) return near_number(numbers()[k]);
  const Place& at = (*at_)[k];
  // The end of a segment may be one side of a corner, and as a number it would be the other.
  if (!at.t.exact() || *at.t.exact() == 1) return std::nullopt;
  return near_number(Rational(static_cast<long>(at.segment)) + *at.t.exact());
}

}  // namespace phrame
