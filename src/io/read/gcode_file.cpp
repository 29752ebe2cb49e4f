#include "phrame/io/read/gcode_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/real.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/io/read/column_name.hpp"
#include "phrame/io/read/curve_choice.hpp"
#include "phrame/io/read/line_points.hpp"
#include "phrame/io/read/number.hpp"
#include "phrame/io/write/text.hpp"
#include "phrame/ph/curve/ellipse_arc.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

/// A letter and its number.
struct GcodeWord {
  char letter;
  Rational value;
};
using GcodeBlock = std::vector<GcodeWord>;

/// The words of a line without comments, (…) and ;…, and without its number.
GcodeBlock read_block(std::string_view line, long number) {
  const auto fail = [&](const std::string& reason) {
    throw InputError(line_place(number), reason);
  };
  GcodeBlock block;
  if (line.starts_with('%')) return block;
  for (std::size_t at = 0; at < line.size();) {
    const char c = static_cast<char>(std::toupper(static_cast<unsigned char>(line[at])));
    if (c == ';') break;
    if (c == '(') {
      const auto end = line.find(')', at);
      if (end == std::string_view::npos) fail("the comment is without its \")\"");
      at = end + 1;
    } else if (c == ' ' || c == '\t' || c == '\r' || (c == '/' && block.empty())) {
      ++at;
    } else if (c >= 'A' && c <= 'Z') {
      const auto first = line.find_first_not_of(" \t", at + 1);
      const auto end = std::min(line.find_first_not_of("+-.0123456789", first), line.size());
      const std::string_view text =
          first >= line.size() ? std::string_view() : line.substr(first, end - first);
      if (text.empty())
        fail(fmt::format("a number is expected behind {}: {}", c, abbreviated(line.substr(at))));
      try {
        block.push_back({c, parse_short_number(text)});
      } catch (const InputError& error) {
        fail(fmt::format("{}: {}", c, error.reason()));
      }
      at = end;
    } else {
      fail(fmt::format("{} is no word of a letter and a number; macros are not read",
                       abbreviated(line.substr(at))));
    }
  }
  if (!block.empty() && block.front().letter == 'N') block.erase(block.begin());
  return block;
}

/// G17, G18 and G19: the axes of the plane and the one across.
constexpr std::array<std::array<std::size_t, 3>, 3> arc_planes{{{0, 1, 2}, {2, 0, 1}, {1, 2, 0}}};

/// The moves between two rapid ones: segments begin … end − 1, and the lines they stand in.
struct GcodeRun {
  std::size_t begin;
  std::size_t end;
  long first_line;
  long last_line;
};

/// Half the angle of a piece of a circle: cos² α = w₁²/(w₀w₂).
double arc_half_angle(const RationalBezier& piece) {
  const std::vector<Rational>& w = piece.weights;
  const double cosine =
      round_to_double(w[1]) / std::sqrt(round_to_double(w[0]) * round_to_double(w[2]));
  return std::acos(std::clamp(cosine, -1.0, 1.0));
}

/// A piece of a circle in two, by de Casteljau's algorithm at t with t²w₂ ≈ (1 − t)²w₀, the middle
/// of its angle.
std::array<RationalBezier, 2> arc_halves(const RationalBezier& piece) {
  const std::vector<Rational>& w = piece.weights;
  const double a = std::sqrt(round_to_double(w[0]));
  const double b = std::sqrt(round_to_double(w[2]));
  const Rational t(std::lround(0x1p24 * a / (a + b)), 1L << 24);
  const auto between = [&](const Rational& u, const Vector<Rational>& p, const Rational& v,
                           const Vector<Rational>& q) { return 1 / (u + v) * (u * p + v * q); };
  const Rational rest = 1 - t;
  const Vector<Rational> p = between(rest * w[0], piece.points[0], t * w[1], piece.points[1]);
  const Vector<Rational> q = between(rest * w[1], piece.points[1], t * w[2], piece.points[2]);
  const Rational wp = rest * w[0] + t * w[1];
  const Rational wq = rest * w[1] + t * w[2];
  const Vector<Rational> m = between(rest * wp, p, t * wq, q);
  const Rational wm = rest * wp + t * wq;
  return {RationalBezier{{piece.points[0], p, m}, {w[0], wp, wm}},
          RationalBezier{{m, q, piece.points[2]}, {wm, wq, w[2]}}};
}

class GcodeProgram {
 public:
  explicit GcodeProgram(std::string_view text);

  std::vector<GivenSegment> segments;      ///< of all moves
  std::vector<GcodeRun> runs;              ///< between rapid moves
  std::vector<std::string> notes() const;  ///< what was assumed

 private:
  enum class Motion { none, rapid, line, clockwise, counterclockwise, cubic, quadratic };

  void read(const GcodeBlock& block);
  void take_code(const Rational& code);
  void move(const GcodeBlock& block);
  void add(const RationalBezier& bezier);
  void arc(const std::map<char, Rational>& words, const Vector<Rational>& to);
  void curve(const std::map<char, Rational>& words, const Vector<Rational>& to);
  std::vector<RationalBezier> flat_arc(const std::map<char, Rational>& words,
                                       const PlaneVector& from, const PlaneVector& to);
  void lift(std::vector<RationalBezier> pieces, const Vector<Rational>& to);
  [[noreturn]] void fail(const std::string& reason) const {
    throw InputError(line_place(line_), reason);
  }

  long line_ = 0;
  Motion motion_ = Motion::none;
  std::size_t plane_ = 0;
  bool is_relative_ = false;
  bool has_absolute_centers_ = false;
  Vector<Rational> here_;
  std::array<bool, 3> is_known_{};
  std::array<bool, 3> is_used_{};
  std::optional<Rational> unit_;  ///< in millimetres: 254/10 (G20) or 1 (G21)
  bool is_in_run_ = false;
  long rapid_moves_ = 0;
  long lifted_arcs_ = 0;
  Rational off_center_;  ///< how far ends of arcs are off their circles, at most
  bool has_rotary_ = false;
};

GcodeProgram::GcodeProgram(std::string_view text) {
  std::vector<std::pair<long, GcodeBlock>> blocks;
  long number = 0;
  while (!text.empty()) {
    ++number;
    blocks.emplace_back(number, read_block(take_line(text), number));
  }
  for (const auto& [line, block] : blocks)
    for (const GcodeWord& word : block)
      if (word.letter >= 'X' && word.letter <= 'Z')
        is_used_[static_cast<std::size_t>(word.letter - 'X')] = true;
  for (const auto& [line, block] : blocks) {
    line_ = line;
    read(block);
  }
  if (segments.empty()) fail("the program moves along no curve");
}

void GcodeProgram::take_code(const Rational& code) {
  const auto tenths = static_cast<long>(floor(10 * code));
  if (Rational(tenths, 10) != code) fail(fmt::format("G{} is not known", as_written(code)));
  switch (tenths) {
    case 0:
      motion_ = Motion::rapid;
      return;
    case 10:
      motion_ = Motion::line;
      return;
    case 20:
      motion_ = Motion::clockwise;
      return;
    case 30:
      motion_ = Motion::counterclockwise;
      return;
    case 50:
      motion_ = Motion::cubic;
      return;
    case 51:
      motion_ = Motion::quadratic;
      return;
    case 170:
    case 180:
    case 190:
      plane_ = static_cast<std::size_t>(tenths / 10 - 17);
      return;
    case 200:
    case 210: {
      const Rational unit = tenths == 200 ? Rational(254, 10) : Rational(1);
      if (unit_ && *unit_ != unit)
        fail("the unit changes between inches (G20) and millimetres (G21)");
      unit_ = unit;
      return;
    }
    case 900:
    case 910:
      is_relative_ = tenths == 910;
      if (is_relative_) is_known_ = {true, true, true};
      return;
    case 901:
    case 911:
      has_absolute_centers_ = tenths == 901;
      return;
    case 800:
      motion_ = Motion::none;
      return;
    default:
      break;
  }
  // Waiting, corrections that are off, coordinate systems, feeds and spindles.
  constexpr std::array harmless{40,  80,  90,  150, 160, 400, 490, 500, 540, 550,
                                560, 570, 580, 590, 591, 592, 593, 610, 611, 640,
                                690, 930, 940, 950, 960, 970, 980, 990};
  if (std::find(harmless.begin(), harmless.end(), tenths) == harmless.end() && tenths != 430)
    fail(fmt::format("G{} is not read: G0 to G3, G5, G5.1 and what says how these are meant is",
                     as_written(code)));
}

void GcodeProgram::read(const GcodeBlock& block) {
  bool is_waiting = false;
  for (const GcodeWord& word : block)
    if (word.letter == 'G') {
      take_code(word.value);
      is_waiting = is_waiting || word.value == 4;
    }
  const auto has = [&](std::string_view letters) {
    return std::any_of(block.begin(), block.end(), [&](const GcodeWord& word) {
      return letters.find(word.letter) != std::string_view::npos;
    });
  };
  has_rotary_ = has_rotary_ || has("ABC");
  const bool is_arc = motion_ == Motion::clockwise || motion_ == Motion::counterclockwise;
  if (is_waiting || !has(is_arc ? "XYZIJKR" : "XYZ")) return;
  if (motion_ == Motion::none) fail("a place without G0, G1, G2, G3 or G5");
  move(block);
}

void GcodeProgram::move(const GcodeBlock& block) {
  std::map<char, Rational> words;
  for (const GcodeWord& word : block)
    if (word.letter != 'G' && !words.emplace(word.letter, word.value).second)
      fail(fmt::format("{} is there twice", word.letter));
  Vector<Rational> to = here_;
  std::array<bool, 3> is_known = is_known_;
  for (std::size_t k = 0; k < 3; ++k)
    if (const auto found = words.find(static_cast<char>('X' + k)); found != words.end()) {
      to[k] = is_relative_ ? here_[k] + found->second : found->second;
      is_known[k] = true;
    }
  const auto is_told = [&](const std::array<bool, 3>& known) {
    for (std::size_t k = 0; k < 3; ++k)
      if (is_used_[k] && !known[k]) return false;
    return true;
  };
  if (!is_told(is_known_)) {
    if (motion_ != Motion::rapid && motion_ != Motion::line)
      fail("a curve begins before the places of X, Y and Z are told");
    here_ = to;
    is_known_ = is_known;
    return;
  }
  if (motion_ == Motion::rapid) {
    if (to != here_) ++rapid_moves_;
    is_in_run_ = false;
  }
  if (motion_ == Motion::rapid || motion_ == Motion::line)
    add({{here_, to}});
  else if (motion_ == Motion::cubic || motion_ == Motion::quadratic)
    curve(words, to);
  else
    arc(words, to);
  here_ = to;
}

void GcodeProgram::add(const RationalBezier& bezier) {
  if (std::all_of(bezier.points.begin(), bezier.points.end(),
                  [&](const auto& p) { return p == bezier.points.front(); }))
    return;
  segments.push_back(bezier_segment(bezier, line_place(line_)));
  if (motion_ == Motion::rapid) return;
  if (!std::exchange(is_in_run_, true)) runs.push_back({segments.size() - 1, 0, line_, line_});
  runs.back().end = segments.size();
  runs.back().last_line = line_;
}

void GcodeProgram::curve(const std::map<char, Rational>& words, const Vector<Rational>& to) {
  if (plane_ != 0) fail("G5 is of the plane G17");
  const auto offset = [&](char x, char y, bool is_needed) -> std::optional<Vector<Rational>> {
    const auto a = words.find(x);
    const auto b = words.find(y);
    if (is_needed && (a == words.end() || b == words.end()))
      fail(fmt::format("a curve of G5 has {} and {}", x, y));
    if (a == words.end() && b == words.end()) return std::nullopt;
    return Vector<Rational>{a == words.end() ? 0 : a->second, b == words.end() ? 0 : b->second, 0};
  };
  if (to[2] != here_[2]) fail("a curve of G5 has one Z");
  if (motion_ == Motion::quadratic) return add({{here_, here_ + *offset('I', 'J', true), to}});
  add({{here_, here_ + *offset('I', 'J', true), to + *offset('P', 'Q', true), to}});
}

/// The arc in its plane. A center that is at the same distance from both ends is exact: with a from
/// it to the start and b = a turned, the end is x·a + y·b with rational x and y.
std::vector<RationalBezier> GcodeProgram::flat_arc(const std::map<char, Rational>& words,
                                                   const PlaneVector& from, const PlaneVector& to) {
  const bool is_growing = motion_ == Motion::counterclockwise;
  if (const auto radius = words.find('R'); radius != words.end()) {
    if (from == to) fail("an arc with R ends elsewhere than it starts; a circle has I, J or K");
    if (radius->second == 0) fail("the radius is 0");
    return ellipse_arc(EndpointArc{from,
                                   to,
                                   {abs(radius->second), abs(radius->second)},
                                   {1, 0},
                                   radius->second < 0,
                                   is_growing});
  }
  PlaneVector center = from;
  bool has_center = false;
  for (std::size_t k = 0; k < 2; ++k)
    if (const auto found = words.find("IJK"[arc_planes[plane_][k]]); found != words.end()) {
      has_center = true;
      center[k] = has_absolute_centers_ ? found->second : from[k] + found->second;
    }
  if (!has_center) fail("an arc has I, J or K in its plane, or R");
  const PlaneVector a{from[0] - center[0], from[1] - center[1]};
  const PlaneVector c{to[0] - center[0], to[1] - center[1]};
  const Rational square = a[0] * a[0] + a[1] * a[1];
  if (square == 0) fail("the center of the arc is its start");
  if (const Rational other = c[0] * c[0] + c[1] * c[1]; other != square) {
    const double r = std::sqrt(round_to_double(square));
    const double off = std::abs(std::sqrt(round_to_double(other)) - r);
    if (off > r / 100)
      fail(fmt::format("the end is {:.3g} off the circle about the center, of the radius {:.6g}",
                       off, r));
    off_center_ = std::max(off_center_, exact_rational(off));
    // The angle from the start to the end, of doubles: half a turn is told from it well enough.
    const Rational cross = a[0] * c[1] - a[1] * c[0];
    const bool is_left = is_growing ? cross >= 0 : cross <= 0;
    return ellipse_arc(EndpointArc{
        from, to, {exact_rational(r), exact_rational(r)}, {1, 0}, !is_left, is_growing});
  }
  const PlaneVector end{(c[0] * a[0] + c[1] * a[1]) / square, (c[1] * a[0] - c[0] * a[1]) / square};
  return ellipse_arc(Ellipse{center, a, {-a[1], a[0]}}, {1, 0}, end, is_growing);
}

/// In each piece of half the angle α what is across the plane is (1 + sin φ/sin α)/2 for
/// (1 + φ/α)/2, φ from its middle: off by less than α²/31, so that with α ≤ π/64 it is less than
/// 10⁻⁵ of what a turn rises.
void GcodeProgram::lift(std::vector<RationalBezier> pieces, const Vector<Rational>& to) {
  const auto& [u, v, up] = arc_planes[plane_];
  const Rational from = here_[up];
  const Rational rise = to[up] - from;
  constexpr double widest = 0.0491;  // π/64
  while (rise != 0 &&
         arc_half_angle(*std::ranges::max_element(pieces, {}, arc_half_angle)) > widest) {
    std::vector<RationalBezier> finer;
    for (const RationalBezier& piece : pieces)
      for (RationalBezier& half : arc_halves(piece)) finer.push_back(std::move(half));
    pieces = std::move(finer);
  }
  if (rise != 0) ++lifted_arcs_;
  std::vector<double> angles{0};
  for (const RationalBezier& piece : pieces)
    angles.push_back(angles.back() + arc_half_angle(piece));
  const auto height = [&, up = up](std::size_t k) {
    if (k == 0 || rise == 0) return from;
    return k == pieces.size() ? to[up] : from + rise * exact_rational(angles[k] / angles.back());
  };
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const std::array<Rational, 3> heights{height(k), (height(k) + height(k + 1)) / 2,
                                          height(k + 1)};
    RationalBezier lifted{{}, pieces[k].weights};
    for (std::size_t i = 0; i < pieces[k].points.size(); ++i) {
      Vector<Rational> p;
      p[u] = pieces[k].points[i][0];
      p[v] = pieces[k].points[i][1];
      p[up] = pieces[k].points.size() == 3 ? heights[i] : heights[2 * i];
      lifted.points.push_back(p);
    }
    add(lifted);
  }
}

void GcodeProgram::arc(const std::map<char, Rational>& words, const Vector<Rational>& to) {
  const PlaneVector from{here_[arc_planes[plane_][0]], here_[arc_planes[plane_][1]]};
  lift(flat_arc(words, from, {to[arc_planes[plane_][0]], to[arc_planes[plane_][1]]}), to);
}

std::vector<std::string> GcodeProgram::notes() const {
  std::vector<std::string> found;
  if (rapid_moves_ > 0)
    found.push_back(
        fmt::format("{} (G0) {} lines of the path, too; --pick takes what is between "
                    "them, of 1 to {}",
                    counted(static_cast<std::size_t>(rapid_moves_), "rapid move"),
                    rapid_moves_ == 1 ? "is a line" : "are", runs.size()));
  if (off_center_ != 0)
    found.push_back(fmt::format(
        "ends of arcs are up to {:.2g} off the circles about their centers; the ends are kept",
        round_to_double(off_center_)));
  if (lifted_arcs_ > 0)
    found.push_back(
        fmt::format("{} across the plane of the arc, too, within 1e-5 of what a turn rises",
                    lifted_arcs_ == 1 ? "1 arc moves" : fmt::format("{} arcs move", lifted_arcs_)));
  if (has_rotary_) found.emplace_back("A, B and C are left out");
  return found;
}

// ---- APT

/// The points behind GOTO/ and FROM/; components beyond three, of the tool's axis, are left out.
struct GotoPoints {
  std::vector<LinePoint> points;
  bool has_axes = false;
};

/// What stands behind the name of a statement, and its slash; no value where it is another one.
std::optional<std::string_view> apt_statement(std::string_view line, std::string_view name) {
  if (lower_case(line.substr(0, name.size())) != name) return std::nullopt;
  line = trimmed(line.substr(name.size()));
  if (!line.starts_with('/')) return std::nullopt;
  return trimmed(line.substr(1));
}

GotoPoints read_goto(std::string_view text) {
  GotoPoints found;
  long number = 0;
  while (!text.empty()) {
    const std::string_view line = trimmed(take_line(text));
    ++number;
    auto rest = apt_statement(line, "goto");
    if (!rest) rest = apt_statement(line, "from");
    if (!rest) continue;
    std::vector<Rational> numbers;
    for (std::string_view list = *rest;;) {
      const auto comma = std::min(list.find(','), list.size());
      try {
        numbers.push_back(parse_short_number(trimmed(list.substr(0, comma))));
      } catch (const InputError& error) {
        throw InputError(line_place(number), error.reason());
      }
      if (comma == list.size()) break;
      list.remove_prefix(comma + 1);
    }
    if (numbers.size() < 3)
      throw InputError(line_place(number),
                       fmt::format("a point has three coordinates, not {}", numbers.size()));
    found.has_axes = found.has_axes || numbers.size() > 3;
    found.points.push_back({{numbers[0], numbers[1], numbers[2]}, number});
  }
  return found;
}

PointCurve read_apt(std::string_view text, const FileReading& reading) {
  auto [points, has_axes] = read_goto(text);
  if (points.empty()) throw InputError("line 1", "the program has no GOTO/ and no FROM/");
  FileReading how = reading;
  if (how.kind.empty()) how.kind = "polyline";
  PointCurve curve = spline_through(std::make_unique<LinePoints>(std::move(points)), false, how);
  if (has_axes) curve.notes.emplace_back("the axes of the tool are left out");
  return curve;
}

bool is_apt(std::string_view text) {
  return apt_statement(text, "goto") || apt_statement(text, "from") ||
         apt_statement(text, "partno");
}

/// The first line that says something, without a comment.
std::string_view first_line_place(std::string_view text) {
  for (;;) {
    const std::string_view line = trimmed(take_line(text));
    const bool is_comment = line.empty() || line[0] == ';' || line[0] == '%' || line[0] == '(' ||
                            line.starts_with("$$");
    if (!is_comment || text.empty()) return line;
  }
}

}  // namespace

bool is_gcode_file(std::string_view text) {
  const std::string_view line = first_line_place(text);
  if (is_apt(line)) return true;
  if (line.size() < 2) return false;
  const char letter = static_cast<char>(std::toupper(static_cast<unsigned char>(line[0])));
  const bool is_word = std::string_view("GNOTFS").find(letter) != std::string_view::npos;
  if ((!is_word && letter != 'M') || text.find_first_of("Gg") == std::string_view::npos)
    return false;
  if (is_word) return std::isdigit(static_cast<unsigned char>(line[1])) != 0;
  try {
    read_block(line, 1);  // "M1 2", path data, is none
    return true;
  } catch (const InputError&) {
    return false;
  }
}

PointCurve read_gcode(std::string_view text, const FileReading& reading) {
  if (is_apt(first_line_place(text))) {
    reading.refuse_picking("one path of a tool");
    return read_apt(text, reading);
  }
  reading.refuse_skipping("a program of G-code");
  GcodeProgram program(text);
  if (reading.pick.empty()) return {"", std::move(program.segments), program.notes()};
  std::vector<CurveLabel> labels;
  for (const GcodeRun& run : program.runs)
    labels.push_back({fmt::format("{}", labels.size() + 1),
                      fmt::format("lines {}-{}", run.first_line, run.last_line)});
  if (labels.empty()) throw InputError("line 1", "there are rapid moves (G0) only");
  const GcodeRun& run = program.runs[chosen_curve(labels, reading.pick)];
  const auto first = program.segments.begin();
  return {"", {first + static_cast<long>(run.begin), first + static_cast<long>(run.end)}};
}

}  // namespace phrame
