#include "phrame/cli/twist_options.hpp"

#include "phrame/ph/curve/scale.hpp"
#include "phrame/ph/frame/path_frame.hpp"

namespace phrame::inline v0::cli {
namespace {

/// The angle or vector that is given, at that end; the latter has a part across the tangent there.
FrameStart end_of(const std::string& name, const std::optional<std::string>& angle,
                  const std::optional<std::string>& vector, const Path& path, const Place& at) {
  if (angle && vector) throw InputError(name, "the angle is given twice");
  if (angle) return parse_angle_option(name, *angle);
  if (!vector) return LeastRotation();
  return StartNormal(parse_normal_option(name + "-vector", *vector, path, at));
}

/// What --subdivide takes besides words.
Rational at_parameter(const std::string& option, const std::string& text) {
  try {
    return parse_option(option, text);
  } catch (const InputError&) {
    if (text.find_first_of("+-.0123456789") == 0) throw;
    throw InputError(option, "\"" + abbreviated(text) +
                                 "\" is not one of inflections, extrema, auto, rms:X with a number "
                                 "X, and a parameter t");
  }
}

}  // namespace

void TwistOptions::add_to(Command& command) {
  command.add_option("--from", "ANGLE", from,
                     "the angle of f2 to e2 at the start (default: f2 by the least rotation\n"
                     "that takes the x axis to e1, where it takes the y axis)");
  command.add_option("--to", "ANGLE", to, "the same at the end");
  command.add_option("--from-vector", "X,Y,Z", from_vector,
                     "f2 at the start, projected to the normal plane");
  command.add_option("--to-vector", "X,Y,Z", to_vector, "f2 at the end, projected");
  command.add_flag("--closed", is_closed, "of a closed spline: the frame ends as it starts");
  command.add_number("--turns", turns, {-1'000'000, 1'000'000},
                     "so many revolutions more (default 0)", "K");
  command.add_number("--degree", degree, {1, 8}, "of w in the rational frame, 1 to 8 (default 2)");
  command.add_flag("--free-ends", has_free_ends,
                   "w need not have the mean rate at the ends of its pieces");
  command.add_option(
      "--subdivide", "WHERE,...", subdivide,
      "where to divide the rational frame: any of inflections, extrema (of the ERF's\n"
      "rate), auto (until the rate has one sign), rms:X (until the relative error is\n"
      "at most X), or parameters t");
  command.add_words("--subdivide", {"inflections", "extrema", "auto"});
  command.add_flag("--unproved", is_unproved,
                   "do not prove that w is the best one (of degree 1, of 2 without --free-ends):\n"
                   "faster");
}

std::pair<FrameStart, std::optional<FrameStart>> TwistOptions::ends(const Path& path) const {
  const FrameStart start = end_of("--from", from, from_vector, path, {0, Rational(0)});
  if (!is_closed) return {start, end_of("--to", to, to_vector, path, phrame::end_of(path))};
  if (to || to_vector) throw InputError("--to", "the angle is given twice");
  if (!path.is_closed()) throw DomainError("--closed: the curve is not closed");
  return {start, std::nullopt};
}

Subdivision TwistOptions::subdivision(const NamedPath& named, ParameterKind by) const {
  const Path& path = named.path;
  const std::string option = "--subdivide";
  Subdivision wanted;
  if (!subdivide) return wanted;
  for (const std::string& part : split({*subdivide})) {
    if (part == "inflections") {
      wanted.at_inflections = true;
    } else if (part == "extrema") {
      wanted.at_extrema = true;
    } else if (part == "auto") {
      wanted.until_monotone = true;
    } else if (part.starts_with("rms:")) {
      if (wanted.tolerance) throw InputError(option, "rms: is given twice");
      wanted.tolerance = parse_option(option, part.substr(4));
      if (*wanted.tolerance <= 0)
        throw InputError(option, "\"" + abbreviated(part) + "\": the error must be positive");
    } else {
      const Rational x = at_parameter(option, part);
      // At an irrational t it is divided next to that.
      wanted.at.push_back(by == ParameterKind::t
                              ? x
                              : rounded_to_places(t_by(named, by, x).enclose(128).midpoint(), 64));
      if (wanted.at.back() < 0 || wanted.at.back() > path.end())
        throw InputError(option, "the parameter " + abbreviated(part) + " is outside [0, " +
                                     to_string(path.end()) + "]");
    }
  }
  return wanted;
}

RationalTwistOptions TwistOptions::rotation(long digits) const {
  if (is_unproved && (degree > 2 || (degree == 2 && has_free_ends)))
    throw InputError("--unproved",
                     "needs --degree 1 or 2 without --free-ends: of others nothing is proved");
  return {degree, has_free_ends ? EndRates::free : EndRates::matched, !is_unproved,
          digits * 10 / 3 + 16};
}

std::vector<std::string> TwistOptions::of_ends() {
  return {"--from", "--to", "--from-vector", "--to-vector", "--closed", "--turns"};
}

std::vector<std::string> TwistOptions::of_rational_frame() {
  return {"--degree", "--free-ends", "--subdivide", "--unproved"};
}

}  // namespace phrame::cli
