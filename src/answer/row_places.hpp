#pragma once
#include <memory>

#include "phrame/algebra/error_free.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/along/path_length.hpp"

namespace phrame::inline v0 {

/// Where the rows of a table are along a path, and by which numbers they were asked for. Where
/// these are parameters or arc lengths, places are found when they are asked for. Copies share the
/// numbers; any thread may ask.
class RowPlaces {
 public:
  /// These places, asked for by as many numbers, which may be arc lengths, or by no numbers.
  explicit RowPlaces(std::vector<Place> at, std::vector<Rational> numbers = {},
                     bool are_lengths = false);
  /// At t along the path, each found by `locate`. Throws what that throws, when it is asked.
  RowPlaces(std::vector<Rational> t, std::function<Place(const Rational& t)> locate);
  /// Where the arc length from the start is s.
  RowPlaces(std::vector<Rational> s, PathLength length);

  std::size_t size() const { return at_ ? at_->size() : numbers_->size(); }
  /// Of row k.
  Place place(std::size_t k) const;
  /// t along the path or s, as is_by_length() says; no value where it is no fraction,
  /// or the place is the end of a segment.
  std::optional<NearNumber> number(std::size_t k) const;
  bool is_by_length() const { return length_.has_value(); }
  /// s there, where the row was asked for by that.
  std::optional<Rational> arc_length(std::size_t k) const;
  const std::vector<Rational>& numbers() const { return *numbers_; }

 private:
  std::shared_ptr<const std::vector<Place>> at_;
  std::shared_ptr<const std::vector<Rational>> numbers_;
  std::function<Place(const Rational& t)> locate_;
  std::optional<PathLength> length_;
  bool are_lengths_ = false;
};

}  // namespace phrame
