#include "phrame/io/read/point_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/real.hpp"
#include "phrame/io/read/npy.hpp"
#include "phrame/io/read/number.hpp"
#include "phrame/io/read/point_file.hpp"
#include "phrame/io/read/point_table.hpp"
#include "phrame/io/read/text_table.hpp"
#include "phrame/ph/construct/cubic_interpolation.hpp"
#include "phrame/ph/curve/bspline.hpp"
#include "phrame/ph/curve/gap.hpp"

namespace phrame::inline v0 {
namespace {

/// The text of a setting and how to complain of it.
struct Setting {
  std::string text;
  std::string place;
};
using Settings = std::map<std::string, Setting>;

/// The entry of the list that a setting names; the first where it is not there.
template <class T>
T chosen(const Settings& settings, const std::string& key,
         const std::vector<std::pair<std::string, T>>& list) {
  const auto found = settings.find(key);
  if (found == settings.end()) return list.front().second;
  std::string names;
  for (const auto& [name, value] : list) {
    if (found->second.text == name) return value;
    names += (names.empty() ? "" : ", ") + name;
  }
  throw InputError(found->second.place, fmt::format("the {} is one of {}, not \"{}\"", key, names,
                                                    abbreviated(found->second.text)));
}

ParameterChoice chosen_spacing(const Settings& settings) {
  return chosen<ParameterChoice>(settings, "spacing",
                                 {{"chord-length", ParameterChoice::chord_lengths},
                                  {"uniform", ParameterChoice::uniform},
                                  {"centripetal", ParameterChoice::centripetal}});
}

void refuse_setting(const Settings& settings, const std::string& key, const std::string& reason) {
  if (const auto found = settings.find(key); found != settings.end())
    throw InputError(found->second.place, reason);
}

/// The place of point k.
using PointPlace = std::function<std::string(std::size_t)>;

std::vector<GivenSegment> segments_of(const CubicInterpolation& data,
                                      const std::vector<Vector<Rational>>& derivatives,
                                      const PointPlace& place) {
  std::vector<GivenSegment> segments;
  segments.reserve(data.points.size());
  for (std::size_t k = 0; k + 1 < data.points.size(); ++k)
    segments.push_back(span_segment(
        {{cubic_piece(data, derivatives, k)}, data.parameters[k], data.parameters[k + 1]}, place(k),
        "the curve from here on"));
  return segments;
}

/// The spline, without the derivatives of a clamped one. Points and parameters are taken.
CubicInterpolation interpolation_of(GivenPoints& given, const Settings& settings, SplineEnds ends,
                                    const std::string& place) {
  CubicInterpolation data{std::move(given.points), std::move(given.parameters), ends};
  if (ends == SplineEnds::periodic && data.points.front() != data.points.back())
    data.points.push_back(data.points.front());
  try {
    if (data.parameters.empty())
      data.parameters = parameters_of(data.points, chosen_spacing(settings));
    else
      refuse_setting(settings, "spacing", "parameters are given, so that their spacing is known");
  } catch (const DomainError& error) {
    throw InputError(place, error.what());
  }
  if (data.parameters.size() != data.points.size())
    throw InputError(
        place,
        fmt::format("{} parameters for {} points{}", data.parameters.size(), data.points.size(),
                    ends == SplineEnds::periodic
                        ? ", of which the last is the first: the last parameter is that of "
                          "the end"
                        : ""));
  return data;
}

std::vector<GivenSegment> spline_segments(const CubicInterpolation& data, const std::string& place,
                                          const PointPlace& place_of_point) {
  std::vector<Vector<Rational>> derivatives;
  try {
    derivatives = cubic_derivatives(data);
  } catch (const DomainError& error) {
    throw InputError(place, error.what());
  }
  return segments_of(data, derivatives, place_of_point);
}

/// The lines from point to point.
std::vector<GivenSegment> polyline(const GivenPoints& given, const std::string& place,
                                   const PointPlace& place_of_point) {
  if (!given.derivatives.empty() || !given.parameters.empty())
    throw InputError(place, "the points of a polyline have neither derivatives nor parameters");
  std::vector<GivenSegment> lines;
  for (std::size_t k = 0; k + 1 < given.points.size(); ++k)
    lines.push_back(bezier_segment({{given.points[k], given.points[k + 1]}, {}},
                                   place_of_point(k + 1), "the line to this point"));
  return lines;
}

/// The C¹ spline with the derivatives given.
std::vector<GivenSegment> hermite_segments(GivenPoints& given, const Settings& settings,
                                           const std::string& place,
                                           const PointPlace& place_of_point) {
  refuse_setting(settings, "kind", "derivatives are given, so that the spline is known");
  const bool has_spacing = settings.count("spacing") > 0 || !given.parameters.empty();
  const Settings uniform{{"spacing", {"uniform", ""}}};
  CubicInterpolation data =
      interpolation_of(given, has_spacing ? settings : uniform, SplineEnds::natural, place);
  return segments_of(data, given.derivatives, place_of_point);
}

/// What a curve through points does not know what to do with.
void refuse_other_data(const GivenPoints& given, const std::string& place) {
  if (!given.tangents.empty())
    throw InputError(place,
                     "tangents without lengths make no cubic spline: derivatives do, or construct");
  if (!given.accelerations.empty())
    throw InputError(place, "accelerations are for construct; a cubic spline takes none");
}

void refuse_long_numbers(const GivenPoints& given, const std::vector<Rational>& weights,
                         const PointPlace& place) {
  for (std::size_t k = 0; k < given.points.size(); ++k) {
    const auto refuse = [](const Rational& x) {
      if (bits_of(x) > most_number_bits) refuse_long_number(x, to_string(x));
    };
    try {
      for (const Rational& x : given.points[k]) refuse(x);
      if (!given.derivatives.empty())
        for (const Rational& x : given.derivatives[k]) refuse(x);
      if (!given.parameters.empty()) refuse(given.parameters[k]);
      if (!weights.empty()) refuse(weights[k]);
    } catch (const InputError& error) {
      throw InputError(place(k), error.reason());
    }
  }
}

/// Lines "# key: value" of the keys that are known.
Settings read_comments(std::string_view text) {
  Settings settings;
  for (long line = 1; !text.empty(); ++line) {
    std::string_view content = trimmed(take_line(text));
    if (!content.starts_with('#')) continue;
    content.remove_prefix(std::min(content.find_first_not_of("# \t"), content.size()));
    const auto colon = content.find(':');
    if (colon == std::string_view::npos) continue;
    const std::string key = lower_case(trimmed(content.substr(0, colon)));
    if (key == "kind" || key == "spacing" || key == "degree")
      settings[key] = {std::string(trimmed(content.substr(colon + 1))), line_place(line)};
  }
  return settings;
}

/// The column w; none where there is no such name.
std::vector<Rational> read_weights(const NumberTable& table) {
  const auto& names = table.names();
  const auto column = std::ranges::find(names, "w", lower_case);
  std::vector<Rational> weights;
  if (column == names.end()) return weights;
  const auto at = static_cast<std::size_t>(column - names.begin());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    weights.push_back(table.number(row, {at}, "w"));
    if (weights.back() <= 0)
      throw InputError(table.place(row) + ", w", fmt::format("the weight {} is not greater than 0",
                                                             as_written(weights.back())));
  }
  return weights;
}

enum class TableKind { natural, periodic, polyline, bezier, bspline };

long read_degree(const Settings& settings, TableKind kind, std::size_t count,
                 const CurveLimits& limits) {
  const auto found = settings.find("degree");
  const long whole = static_cast<long>(count) - 1;
  const std::string place = found == settings.end() ? "line 1" : found->second.place;
  long degree = kind == TableKind::bezier ? whole : std::min(3L, whole);
  if (found != settings.end()) {
    const Rational given = [&] {
      try {
        return parse_rational(found->second.text);
      } catch (const InputError& error) {
        throw InputError(place, error.reason());
      }
    }();
    if (denominator(given) != 1 || given < 1 || given > whole)
      throw InputError(place, fmt::format("the degree {} is no whole number from 1 to {}, one less "
                                          "than there are points",
                                          as_written(given), whole));
    degree = static_cast<long>(numerator(given));
    if (kind == TableKind::bezier && degree != whole)
      throw InputError(place, fmt::format("{} control points make a Bézier curve of degree {}, not "
                                          "{}",
                                          count, whole, degree));
  }
  if (degree > limits.max_degree)
    throw InputError(
        place, fmt::format("the degree {} is beyond the limit {}; --max-degree raises it", degree,
                           limits.max_degree));
  return degree;
}

/// p + 1 times 0, then 1, 2, …, at the end p + 1 times the last.
BSpline clamped_uniform(long degree, std::vector<Vector<Rational>> points,
                        std::vector<Rational> weights) {
  const long spans = static_cast<long>(points.size()) - degree;
  BSpline spline{degree, {}, std::move(points), std::move(weights)};
  for (long k = -degree; k <= spans + degree; ++k)
    spline.knots.emplace_back(std::clamp(k, 0L, spans));
  return spline;
}

/// Parameters in a column that is not called t are not asked for where none are taken.
void fit_parameter_column(GivenPoints& given, const Settings& settings, TableKind kind) {
  if (given.parameter_column.empty()) return;
  if (kind == TableKind::bezier || kind == TableKind::bspline)
    leave_parameters_out(given, "control points have no parameters");
  else if (kind == TableKind::polyline)
    leave_parameters_out(given, "a polyline has no parameters");
  else if (settings.count("spacing") > 0)
    leave_parameters_out(given, "the spacing is given");
  else if (kind == TableKind::periodic && given.points.front() != given.points.back())
    leave_parameters_out(given, "without that of the end of the closed curve");
}

PointCurve control_curve(const GivenPoints& given, std::vector<Rational> weights, long degree,
                         const PointPlace& place) {
  PointCurve result;
  for (const auto& [curve, lower, upper] :
       bezier_pieces(clamped_uniform(degree, given.points, std::move(weights))))
    result.segments.push_back(
        bezier_segment(curve, place(static_cast<std::size_t>(static_cast<long>(floor(lower))))));
  return result;
}

PointCurve table_curve(const NumberTable& table, GivenPoints& given, const Settings& settings,
                       TableKind kind, const CurveLimits& limits) {
  std::vector<Rational> weights = read_weights(table);
  const PointPlace place = [&](std::size_t k) {
    return table.place(std::min(k, table.rows() - 1));
  };
  refuse_other_data(given, place(0));
  refuse_long_numbers(given, weights, place);
  if (kind == TableKind::bezier || kind == TableKind::bspline) {
    if (!given.derivatives.empty() || !given.parameters.empty())
      throw InputError(place(0), "control points have neither derivatives nor parameters");
    refuse_setting(settings, "spacing", "control points have no parameters");
    return control_curve(given, std::move(weights),
                         read_degree(settings, kind, given.points.size(), limits), place);
  }
  if (!weights.empty())
    throw InputError(place(0),
                     "weights, a column w, are those of control points: \"# kind: bezier\", or "
                     "bspline, says that the points are that");
  if (kind == TableKind::polyline) {
    refuse_setting(settings, "degree", "a polyline has the degree 1");
    refuse_setting(settings, "spacing", "a polyline has no parameters");
    return {"", polyline(given, place(0), place)};
  }
  refuse_setting(settings, "degree", "a cubic spline through points has the degree 3");
  if (!given.derivatives.empty()) return {"", hermite_segments(given, settings, place(0), place)};
  const SplineEnds ends = kind == TableKind::periodic ? SplineEnds::periodic : SplineEnds::natural;
  return {"", spline_segments(interpolation_of(given, settings, ends, place(0)), place(0), place)};
}

PointCurve table_curve(const NumberTable& table, GivenPoints given, const Settings& settings,
                       const CurveLimits& limits) {
  const auto kind = chosen<TableKind>(settings, "kind",
                                      {{"natural", TableKind::natural},
                                       {"periodic", TableKind::periodic},
                                       {"polyline", TableKind::polyline},
                                       {"bezier", TableKind::bezier},
                                       {"bspline", TableKind::bspline}});
  const bool is_closed = kind == TableKind::periodic && close_to_rounding(given.points);
  fit_parameter_column(given, settings, kind);
  PointCurve result = table_curve(table, given, settings, kind, limits);
  std::erase_if(given.skipped_columns, [](const auto& name) { return lower_case(name) == "w"; });
  result.notes = notes_on_columns(given);
  if (is_closed) result.notes.emplace_back("the last point is taken for the first one, rounded");
  return result;
}

}  // namespace

PointCurve read_point_curve(const JsonNode& node) {
  node.require_known_keys({"phrame", "name", "points", "derivatives", "tangents", "accelerations",
                           "parameters", "kind", "spacing", "start_derivative", "end_derivative",
                           "note"});
  GivenPoints given = read_points(node);
  refuse_other_data(given, node.place());
  if (const auto kind = node.find("kind"); kind && kind->string() == "periodic")
    close_to_rounding(given.points);
  Settings settings;
  for (const char* key : {"kind", "spacing"})
    if (const auto found = node.find(key)) settings[key] = {found->string(), found->place()};
  const std::string place = node.at("points").place();
  const PointPlace place_of_point = [&](std::size_t k) { return fmt::format("{}/{}", place, k); };
  if (settings.count("kind") > 0 && settings.at("kind").text == "polyline") {
    refuse_setting(settings, "spacing", "a polyline has no parameters");
    return {given.name, polyline(given, place, place_of_point)};
  }
  const auto ends = chosen<SplineEnds>(settings, "kind",
                                       {{"natural", SplineEnds::natural},
                                        {"clamped", SplineEnds::clamped},
                                        {"periodic", SplineEnds::periodic},
                                        {"polyline", SplineEnds::natural}});
  const auto start = node.find("start_derivative");
  const auto end = node.find("end_derivative");
  for (const auto& derivative : {start, end})
    if (derivative && ends != SplineEnds::clamped)
      derivative->fail("derivatives at the ends are for the kind \"clamped\"");
  if (!given.derivatives.empty())
    return {given.name, hermite_segments(given, settings, place, place_of_point)};
  CubicInterpolation data = interpolation_of(given, settings, ends, place);
  if (ends == SplineEnds::clamped) {
    const auto read = [&](const char* key) {
      const auto numbers = node.at(key).numbers(given.is_planar ? 2 : 3);
      Vector<Rational> v;
      std::copy(numbers.begin(), numbers.end(), v.begin());
      return v;
    };
    data.start_derivative = read("start_derivative");
    data.end_derivative = read("end_derivative");
  }
  return {given.name, spline_segments(data, place, place_of_point)};
}

PointCurve read_point_table(std::string_view bytes, const CurveLimits& limits,
                            const FileReading& reading) {
  const bool has_comments = !NpyTable::is_one(bytes) && !trimmed(bytes).starts_with('[');
  Settings settings = has_comments ? read_comments(bytes) : Settings();
  if (!reading.kind.empty()) settings = {{"kind", {reading.kind, "--kind"}}};
  PointTable read = read_points_of_table(bytes, reading);
  for (const std::string& other : reading.other_columns)
    std::erase(read.given.skipped_columns, other);
  return table_curve(*read.table, std::move(read.given), settings, limits);
}

PointCurve spline_through(std::unique_ptr<NumberTable> table, bool of_a_loop,
                          const FileReading& reading) {
  Settings settings;
  if (of_a_loop) settings["kind"] = {"periodic", ""};
  if (!reading.kind.empty()) settings = {{"kind", {reading.kind, "--kind"}}};
  PointTable read = read_point_rows(std::move(table), reading);
  PointCurve curve = table_curve(*read.table, std::move(read.given), settings, {});
  if (reading.kind.empty())
    curve.notes.emplace_back(of_a_loop
                                 ? "the curve is the periodic cubic spline through the points"
                                 : "the curve is the natural cubic spline through the points");
  return curve;
}

}  // namespace phrame
