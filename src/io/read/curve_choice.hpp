#pragma once
#include <string>
#include <vector>

namespace phrame::inline v0 {

/// What a curve of a file that may have several is called; either may be empty.
struct CurveLabel {
  std::string name;
  std::string id;

  const std::string& shown() const { return name.empty() ? id : name; }
};

/// The only curve, if none is picked; else the one with this name or id. `labels` are at least one.
/// Throws InputError, with this place, where there is none or several, with the list of them.
std::size_t chosen_curve(const std::vector<CurveLabel>& labels, const std::string& pick,
                         const std::string& place = "");

}  // namespace phrame
