#include "phrame/io/read/svg_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/number.hpp"
#include "phrame/io/read/svg_number.hpp"

namespace phrame::inline v0 {
namespace {

PlaneVector plane_point_sum(const PlaneVector& a, const PlaneVector& b) {
  return {a[0] + b[0], a[1] + b[1]};
}

/// 2·center − p.
PlaneVector reflected(const PlaneVector& p, const PlaneVector& center) {
  return {2 * center[0] - p[0], 2 * center[1] - p[1]};
}

class PathDataReader {
 public:
  PathDataReader(std::string_view text, std::size_t begin, std::size_t end, const PlaneMap& map)
      : numbers_(text.substr(0, end), begin), map_(map) {}

  /// Only one, where one is wanted.
  std::vector<std::vector<GivenSegment>> read(bool wants_one);

 private:
  void end_subpath();
  void read_command(char command);
  void move(bool is_relative);
  void curve(char command, bool is_relative);
  void arc(bool is_relative);
  void close();
  void add(const std::vector<PlaneVector>& points, const std::vector<Rational>& weights = {});

  PlaneVector point(bool is_relative) {
    const Rational x = numbers_.number();
    const PlaneVector p{x, numbers_.number()};
    return is_relative ? plane_point_sum(here_, p) : p;
  }

  SvgNumbers numbers_;
  PlaneMap map_;
  std::string place_;  ///< of the command
  bool has_start_ = false;
  PlaneVector start_;  ///< of the subpath
  PlaneVector here_;
  char last_ = 0;        ///< the command before, a capital
  PlaneVector control_;  ///< its last control point
  bool wants_one_ = false;
  std::vector<GivenSegment> segments_;
  std::vector<std::vector<GivenSegment>> subpaths_;  ///< those before
};

void PathDataReader::add(const std::vector<PlaneVector>& points,
                         const std::vector<Rational>& weights) {
  here_ = points.back();
  const bool has_length = std::any_of(points.begin(), points.end(),
                                      [&](const PlaneVector& p) { return p != points.front(); });
  if (!has_length) return;
  RationalBezier bezier{{}, weights};
  for (const auto& [x, y] : points)
    bezier.points.push_back({x * map_.a[0] + y * map_.b[0] + map_.offset[0],
                             x * map_.a[1] + y * map_.b[1] + map_.offset[1], 0});
  segments_.push_back(bezier_segment(bezier, place_));
}

void PathDataReader::move(bool is_relative) {
  const PlaneVector p = point(is_relative && has_start_);
  if (!segments_.empty() && p != here_) {
    if (wants_one_) throw InputError(place_, "a second subpath begins here; one curve is wanted");
    end_subpath();
  }
  has_start_ = true;
  start_ = here_ = p;
}

void PathDataReader::end_subpath() {
  if (!segments_.empty()) subpaths_.push_back(std::move(segments_));
  segments_.clear();
}

void PathDataReader::close() { add({here_, start_}); }

void PathDataReader::curve(char command, bool is_relative) {
  const bool is_cubic = command == 'C' || command == 'S';
  const bool is_smooth = command == 'S' || command == 'T';
  std::vector<PlaneVector> points{here_};
  if (is_smooth) {
    const std::string_view same_kind = is_cubic ? "CS" : "QT";
    points.push_back(same_kind.find(last_) != std::string_view::npos ? reflected(control_, here_)
                                                                     : here_);
  }
  while (points.size() < (is_cubic ? 4U : 3U)) points.push_back(point(is_relative));
  control_ = points[points.size() - 2];
  add(points);
}

void PathDataReader::arc(bool is_relative) {
  EndpointArc arc;
  arc.from = here_;
  arc.semiaxes = {numbers_.number(), numbers_.number()};
  const Rational degrees = numbers_.number();
  arc.is_large = numbers_.flag();
  arc.is_growing = numbers_.flag();
  arc.to = point(is_relative);
  if (arc.to == arc.from) return;  // is left out
  for (Rational& r : arc.semiaxes) r = abs(r);
  if (arc.semiaxes[0] == 0 || arc.semiaxes[1] == 0) return add({arc.from, arc.to});
  const bool is_circle = arc.semiaxes[0] == arc.semiaxes[1];
  arc.axis = is_circle ? PlaneVector{1, 0} : rotation_by_degrees(degrees);
  for (const RationalBezier& piece : ellipse_arc(arc)) {
    std::vector<PlaneVector> points;
    for (const Vector<Rational>& p : piece.points) points.push_back({p[0], p[1]});
    add(points, piece.weights);
  }
}

void PathDataReader::read_command(char command) {
  const bool is_relative = std::islower(static_cast<unsigned char>(command)) != 0;
  const char capital = static_cast<char>(std::toupper(static_cast<unsigned char>(command)));
  if (!has_start_ && capital != 'M') throw InputError(place_, "a path begins with a moveto, M");
  if (last_ == 'Z' && capital != 'M' && capital != 'Z' && !wants_one_) end_subpath();
  switch (capital) {
    case 'M':
      move(is_relative);
      break;
    case 'L':
      add({here_, point(is_relative)});
      break;
    case 'H': {
      const Rational x = numbers_.number();
      add({here_, {is_relative ? here_[0] + x : x, here_[1]}});
      break;
    }
    case 'V': {
      const Rational y = numbers_.number();
      add({here_, {here_[0], is_relative ? here_[1] + y : y}});
      break;
    }
    case 'A':
      arc(is_relative);
      break;
    case 'Z':
      close();
      break;
    default:
      curve(capital, is_relative);
  }
  last_ = capital;
}

std::vector<std::vector<GivenSegment>> PathDataReader::read(bool wants_one) {
  wants_one_ = wants_one;
  char command = 0;
  while (!numbers_.at_end()) {
    place_ = numbers_.place();
    if (const char c = numbers_.take_letter("MmLlHhVvCcSsQqTtAaZz")) {
      command = c;
    } else if (command == 0 || command == 'Z' || command == 'z' || !numbers_.is_at_number()) {
      numbers_.fail("a command is expected, of M L H V C S Q T A Z");
    } else if (command == 'M' || command == 'm') {
      command = command == 'M' ? 'L' : 'l';
    }
    read_command(command);
  }
  end_subpath();
  if (subpaths_.empty()) throw InputError(numbers_.place(), "the path has no length");
  return std::move(subpaths_);
}

}  // namespace

std::vector<GivenSegment> read_path_data(std::string_view text, std::size_t begin, std::size_t end,
                                         const PlaneMap& map) {
  return PathDataReader(text, begin, end, map).read(true).front();
}

std::vector<std::vector<GivenSegment>> read_subpaths(std::string_view text, std::size_t begin,
                                                     std::size_t end, const PlaneMap& map) {
  return PathDataReader(text, begin, end, map).read(false);
}

bool is_path_data(std::string_view text) {
  text = trimmed(text);
  if (text.empty() || (text.front() != 'M' && text.front() != 'm')) return false;
  const auto next = text.find_first_not_of(" \t\r\n", 1);
  constexpr std::string_view first_of_number = "+-.0123456789";
  return next != std::string_view::npos &&
         first_of_number.find(text[next]) != std::string_view::npos;
}

}  // namespace phrame
