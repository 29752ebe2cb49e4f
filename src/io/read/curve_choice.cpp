#include "phrame/io/read/curve_choice.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rational.hpp"

namespace phrame::inline v0 {
namespace {

std::string names_of(const std::vector<CurveLabel>& labels) {
  constexpr std::size_t most = 12;
  std::vector<std::string> names;
  for (const CurveLabel& label : labels)
    if (names.size() < most) names.push_back(abbreviated(label.shown()));
  return fmt::format("{}{}", fmt::join(names, ", "),
                     labels.size() > most ? fmt::format(" and {} more", labels.size() - most) : "");
}

}  // namespace

std::size_t chosen_curve(const std::vector<CurveLabel>& labels, const std::string& pick,
                         const std::string& place) {
  const auto fail = [&place](const std::string& reason) {
    throw place.empty() ? InputError(reason) : InputError(place, reason);
  };
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < labels.size(); ++k)
    if (pick.empty() || pick == labels[k].name || pick == labels[k].id) found.push_back(k);
  if (found.empty())
    fail(
        fmt::format("there is no curve \"{}\"; there are {}", abbreviated(pick), names_of(labels)));
  if (found.size() > 1 && pick.empty())
    fail(fmt::format("there are {} curves, and --pick names one: {}", labels.size(),
                     names_of(labels)));
  if (found.size() > 1)
    fail(fmt::format("{} curves are called \"{}\"", found.size(), abbreviated(pick)));
  return found.front();
}

}  // namespace phrame
