#pragma once
#include <stdexcept>
#include <string>

#include "phrame/export.hpp"

namespace phrame::inline v0 {

/// The base class of all errors that phrame throws.
class PHRAME_API Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The question has no answer: a division by zero, a pole on the path, a Frenet frame of a line.
/// The message names the notion or the function, the reason and the value.
class PHRAME_API DomainError : public Error {
 public:
  using Error::Error;
};

/// The answer exists, but the limit that the message names was reached before it was proved.
class PHRAME_API Undecided : public Error {
 public:
  using Error::Error;
};

/// What was read is not what its format says. `place` is where (a JSON pointer, a column, an
/// option), `reason` what is wrong, with the value; what() is "place: reason".
class PHRAME_API InputError : public Error {
 public:
  /// Without a place, which a caller may add.
  explicit InputError(std::string reason) : Error(reason), reason_(std::move(reason)) {}
  /// With its place.
  InputError(std::string place, std::string reason)
      : Error(place + ": " + reason), place_(std::move(place)), reason_(std::move(reason)) {}

  const std::string& place() const noexcept { return place_; }  ///< where; empty if it is not known
  /// What is wrong, without the place.
  const std::string& reason() const noexcept { return reason_; }

 private:
  std::string place_;
  std::string reason_;
};

/// What an error says, without the place where it begins with that: it is told once.
inline std::string without_place(const std::string& what, const std::string& place) {
  return what.starts_with(place + ": ") ? what.substr(place.size() + 2) : what;
}

}  // namespace phrame
