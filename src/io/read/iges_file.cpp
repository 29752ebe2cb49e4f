// Lines of 80 columns; in column 73 stands the letter of the section. A directory entry is two
// lines of ten fields of 8 columns, of which the second of the first line says where its parameters
// begin; those end with the delimiter of records, ";" where the global section does not say
// another.
#include "phrame/io/read/iges_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/io/read/number.hpp"
#include "phrame/io/read/plane_conic.hpp"
#include "phrame/io/read/space_conic.hpp"
#include "phrame/ph/curve/bspline.hpp"
#include "phrame/ph/curve/transform.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

struct IgesLine {
  std::string_view text;
  long line;  ///< of the file
};

/// A directory entry.
struct IgesEntity {
  long sequence;  ///< of its first line, as pointers have it
  long type;
  long form;
  long first_line;  ///< of its parameters, from 1
  long count;       ///< of lines of parameters
  long matrix;      ///< the sequence of its 124, or 0
  long level;
  long status;  ///< blank, subordinate, use and hierarchy, of two digits each
  long line;    ///< of the file

  [[noreturn]] void fail(const std::string& reason) const {
    throw InputError(line_place(line), fmt::format("entity {} (D{}): {}", type, sequence, reason));
  }
};

/// The parameters of an entity, one after the other.
class IgesNumbers {
 public:
  IgesNumbers(const IgesEntity& entity, std::vector<std::string_view> values)
      : entity_(entity), values_(std::move(values)) {}

  /// An empty one is 0.
  Rational number() {
    if (at_ == values_.size()) entity_.fail("there are too few parameters");
    const std::string_view value = trimmed(values_[at_++]);
    if (value.empty()) return 0;
    std::string text(value);
    std::ranges::replace_if(
        text, [](char c) { return c == 'D' || c == 'd'; }, 'E');
    return of_entity(entity_, [&] { return parse_short_number(text); });
  }
  long whole(long least, long most, const char* what) {
    const Rational x = number();
    if (denominator(x) != 1 || x < least || x > most)
      entity_.fail(fmt::format("{}: {} is not from {} to {}", what, as_written(x), least, most));
    return static_cast<long>(numerator(x));
  }
  Vector<Rational> vector() {
    Vector<Rational> v;
    for (Rational& x : v) x = number();
    return v;
  }
  std::size_t left() const { return values_.size() - at_; }

 private:
  const IgesEntity& entity_;
  std::vector<std::string_view> values_;
  std::size_t at_ = 0;
};

class IgesFile {
 public:
  explicit IgesFile(std::string_view text);

  const std::map<long, IgesEntity>& entities() const { return entities_; }
  const IgesEntity& entity(long sequence, const IgesEntity& from) const {
    const auto found = entities_.find(sequence);
    if (found == entities_.end()) from.fail(fmt::format("there is no D{}", sequence));
    return found->second;
  }
  /// Without the number of the type.
  IgesNumbers parameters(const IgesEntity& entity) const;

 private:
  void read_directory(const std::vector<IgesLine>& lines);

  char between_ = ',';
  char at_end_ = ';';
  std::map<long, IgesEntity> entities_;
  std::vector<std::string> parameters_;  ///< by the sequence of their lines
};

long whole_field(const IgesLine& line, std::size_t k) {
  const std::string_view field = trimmed(line.text.substr(std::min(8 * k, line.text.size()), 8));
  if (field.empty()) return 0;
  long value = 0;
  for (const char c : field.substr(field.front() == '-' ? 1 : 0)) {
    if (c < '0' || c > '9')
      throw InputError(line_place(line.line),
                       fmt::format("\"{}\" is no whole number", abbreviated(std::string(field))));
    value = 10 * value + (c - '0');
  }
  return field.front() == '-' ? -value : value;
}

void IgesFile::read_directory(const std::vector<IgesLine>& lines) {
  if (lines.size() % 2 != 0)
    throw InputError(line_place(lines.back().line), "directory entries have two lines");
  for (std::size_t k = 0; k < lines.size(); k += 2) {
    const IgesLine& a = lines[k];
    const IgesLine& b = lines[k + 1];
    const long sequence = static_cast<long>(k) + 1;
    entities_.insert(
        {sequence,
         {sequence, whole_field(a, 0), whole_field(b, 4), whole_field(a, 1), whole_field(b, 3),
          whole_field(a, 6), whole_field(a, 4), whole_field(a, 8), a.line}});
  }
}

IgesFile::IgesFile(std::string_view text) {
  std::vector<IgesLine> directory;
  std::string global;
  for (long number = 1; !text.empty(); ++number) {
    std::string_view line = take_line(text);
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (trimmed(line).empty()) continue;
    if (line.size() < 73)
      throw InputError(line_place(number),
                       "lines of IGES have 80 columns, with the letter of the "
                       "section in column 73");
    switch (line[72]) {
      case 'G':
        global += line.substr(0, 72);
        break;
      case 'D':
        directory.push_back({line.substr(0, 72), number});
        break;
      case 'P':
        parameters_.emplace_back(line.substr(0, 64));
        break;
      case 'S':
      case 'T':
        break;
      default:
        throw InputError(line_place(number),
                         fmt::format("\"{}\" in column 73 is no section of an IGES file in ASCII",
                                     std::string(1, line[72])));
    }
  }
  // "1H,,1H;," or nothing, where these are the delimiters.
  if (global.starts_with("1H") && global.size() > 7) {
    between_ = global[2];
    if (global.substr(4).starts_with("1H")) at_end_ = global[6];
  } else if (global.size() > 4 && global.substr(1).starts_with("1H")) {
    at_end_ = global[3];
  }
  read_directory(directory);
}

IgesNumbers IgesFile::parameters(const IgesEntity& entity) const {
  const auto total = static_cast<long>(parameters_.size());
  if (entity.first_line < 1 || entity.count < 1 || entity.first_line > total ||
      entity.count > total - entity.first_line + 1)
    entity.fail("its parameters are not in the file");
  std::vector<std::string_view> values;
  for (long k = entity.first_line - 1; k < entity.first_line - 1 + entity.count; ++k) {
    // No value goes over the end of a line but texts, which no curve has.
    std::string_view line = parameters_[static_cast<std::size_t>(k)];
    for (;;) {
      const auto end = line.find_first_of(std::string{between_, at_end_});
      if (end == std::string_view::npos) break;
      values.push_back(line.substr(0, end));
      if (line[end] == at_end_) {
        if (!values.empty()) values.erase(values.begin());
        return {entity, std::move(values)};
      }
      line.remove_prefix(end + 1);
    }
    if (!trimmed(line).empty()) entity.fail("a parameter has no delimiter behind it");
  }
  entity.fail("its parameters have no end");
}

constexpr std::string_view curve_types = "126, 112, 110, 106, 104, 102, 100";

/// Of 106 the forms 11 to 13 and 63 are lines through points; others are points, and what is drawn
/// of dimensions and sections.
bool is_curve(const IgesEntity& entity) {
  if (entity.type == 106) return (entity.form >= 11 && entity.form <= 13) || entity.form == 63;
  return entity.type == 126 || entity.type == 112 || entity.type == 110 || entity.type == 104 ||
         entity.type == 102 || entity.type == 100;
}

class IgesCurves {
 public:
  IgesCurves(const IgesFile& file, const CurveLimits& limits) : file_(file), limits_(limits) {}

  DrawnCurve curve(const IgesEntity& entity, int depth = 0) const;

 private:
  AffineMap map_of(const IgesEntity& entity, int depth = 0) const;
  DrawnCurve spline(const IgesEntity& entity) const;
  DrawnCurve cubics(const IgesEntity& entity) const;
  DrawnCurve polyline(const IgesEntity& entity) const;
  DrawnCurve arc(const IgesEntity& entity) const;
  DrawnCurve conic(const IgesEntity& entity) const;
  DrawnCurve composite(const IgesEntity& entity, int depth) const;

  static constexpr int deepest_ = 32;

  const IgesFile& file_;
  const CurveLimits& limits_;
};

AffineMap IgesCurves::map_of(const IgesEntity& entity, int depth) const {
  if (entity.matrix == 0) return {};
  const IgesEntity& matrix = file_.entity(entity.matrix, entity);
  if (matrix.type != 124) entity.fail(fmt::format("its matrix is of the type {}", matrix.type));
  if (depth > deepest_) entity.fail("matrices are of matrices more than 32 deep");
  IgesNumbers in = file_.parameters(matrix);
  AffineMap map;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) map.columns[column][row] = in.number();
    map.shift[row] = in.number();
  }
  return composed(map, map_of(matrix, depth + 1));
}

/// Do two parameters say the same, but for rounding to the digits that IGES files have?
bool is_same_parameter(const Rational& a, const Rational& b, const Rational& width) {
  return abs(a - b) * 1'000'000'000 <= width;
}

// K, M, four flags, K + M + 2 knots, K + 1 weights and points, the ends of the parameter, a normal.
DrawnCurve IgesCurves::spline(const IgesEntity& entity) const {
  IgesNumbers in = file_.parameters(entity);
  const long most = static_cast<long>(in.left());
  const long last = in.whole(1, most, "the index of the last point");
  BSpline spline;
  spline.degree = in.whole(1, limits_.max_degree, "the degree");
  for (int k = 0; k < 4; ++k) in.number();
  for (long k = 0; k < last + spline.degree + 2; ++k) spline.knots.push_back(in.number());
  for (long k = 0; k <= last; ++k) spline.weights.push_back(in.number());
  for (long k = 0; k <= last; ++k) spline.points.push_back(in.vector());
  if (const auto fault = fault_of(spline)) entity.fail(fault->reason);
  if (std::ranges::all_of(spline.weights,
                          [&](const Rational& w) { return w == spline.weights.front(); }))
    spline.weights.clear();
  const DrawnCurve whole = drawn_spline(spline);
  const Rational& first_knot = whole.knots.front();
  const Rational& last_knot = whole.knots.back();
  const Rational width = last_knot - first_knot;
  Rational from = first_knot;
  Rational to = last_knot;
  if (in.left() >= 2) {
    const Rational a = in.number();
    const Rational b = in.number();
    if (a != b && !is_same_parameter(a, from, width)) from = a;
    if (a != b && !is_same_parameter(b, to, width)) to = b;
    if (from < first_knot || to > last_knot || from >= to)
      entity.fail(fmt::format("its part from {} to {} is not between its knots", as_written(a),
                              as_written(b)));
  }
  return part_between(whole, from, to);
}

// Kind, continuity, dimension, their number, where they begin and the last one ends; of each
// x = a + b·s + c·s² + d·s³, y and z, with s from its beginning; then derivatives at the end.
DrawnCurve IgesCurves::cubics(const IgesEntity& entity) const {
  IgesNumbers in = file_.parameters(entity);
  const long most = static_cast<long>(in.left());
  in.number();
  in.number();
  const long dimension = in.whole(2, 3, "the dimension");
  const long count = in.whole(1, most, "the number of segments");
  DrawnCurve curve;
  for (long k = 0; k <= count; ++k) curve.knots.push_back(in.number());
  for (std::size_t k = 0; k + 1 < curve.knots.size(); ++k) {
    const Rational width = curve.knots[k + 1] - curve.knots[k];
    if (width <= 0) entity.fail("its parameters do not ascend");
    Vector<Polynomial> r;
    long degree = 1;
    for (long axis = 0; axis < 3; ++axis) {
      std::vector<Rational> c;
      for (Rational unit = 1; c.size() < 4; unit *= width) c.push_back(in.number() * unit);
      if (axis == 2 && dimension == 2) c = {c.front()};  // a plane
      r[static_cast<std::size_t>(axis)] = Polynomial(c);
      degree = std::max(degree, r[static_cast<std::size_t>(axis)].degree());
    }
    const auto x = to_bernstein(r[0], degree);
    const auto y = to_bernstein(r[1], degree);
    const auto z = to_bernstein(r[2], degree);
    RationalBezier piece;
    for (std::size_t n = 0; n < x.size(); ++n) piece.points.push_back({x[n], y[n], z[n]});
    curve.pieces.push_back(std::move(piece));
  }
  return curve;
}

// What a tuple is, how many there are, z of them all if they are pairs; what is more than a point
// in a tuple is a vector there. Form 63 is a closed line in a plane.
DrawnCurve IgesCurves::polyline(const IgesEntity& entity) const {
  IgesNumbers in = file_.parameters(entity);
  const long kind = in.whole(1, 3, "the kind of tuples");
  const long count = in.whole(2, static_cast<long>(in.left()), "the number of points");
  const Rational z = kind == 1 ? in.number() : Rational();
  std::vector<Vector<Rational>> points;
  for (long k = 0; k < count; ++k) {
    const Rational x = in.number();
    const Rational y = in.number();
    points.push_back({x, y, kind == 1 ? z : in.number()});
    if (kind == 3) in.vector();
  }
  if (entity.form == 63) points.push_back(points.front());
  DrawnCurve curve{lines_through(points)};
  if (curve.pieces.empty()) entity.fail("its points are one point");
  return curve;
}

// z, and in that plane the center, start and end, counterclockwise.
DrawnCurve IgesCurves::arc(const IgesEntity& entity) const {
  IgesNumbers in = file_.parameters(entity);
  const Rational z = in.number();
  const auto place = [&] {
    const Rational x = in.number();
    return Vector<Rational>{x, in.number(), z};
  };
  const Vector<Rational> center = place();
  const Vector<Rational> from = place();
  const Vector<Rational> to = place();
  const Vector<Rational> out = from - center;
  if (out == Vector<Rational>{}) entity.fail("the arc begins in its center");
  const Vector<Rational> x = near_unit(out);
  const Rational radius = dot(out, x);
  return of_entity(entity, [&]() -> DrawnCurve {
    return {arc_between(conic_about(center, {0, 0, 1}, x, {radius, radius}), from, to, true)};
  });
}

// Six coefficients, z, and in that plane start and end, counterclockwise for ellipses. The form
// says which conic it is, where it is not 0; for a parabola that is turned, rounded coefficients do
// not.
DrawnCurve IgesCurves::conic(const IgesEntity& entity) const {
  IgesNumbers in = file_.parameters(entity);
  PlaneConic conic;
  for (Rational& c : conic) c = in.number();
  const Rational z = in.number();
  const auto place = [&] {
    const Rational x = in.number();
    return PlaneVector{x, in.number()};
  };
  const PlaneVector from = place();
  const PlaneVector to = place();
  constexpr long ellipse = 1;
  constexpr long parabola = 3;
  if (entity.form < 0 || entity.form > parabola)
    entity.fail(fmt::format("the form of a conic is 0 to 3, not {}", entity.form));
  const Rational sign = discriminant(conic);
  const bool is_ellipse = entity.form == 0 ? sign < 0 : entity.form == ellipse;
  const bool is_parabola = entity.form == 0 ? sign == 0 : entity.form == parabola;
  return of_entity(entity, [&]() -> DrawnCurve {
    const auto at_height = [&](const PlaneVector& p) { return Vector<Rational>{p[0], p[1], z}; };
    for (const PlaneVector& p : {from, to})
      if (!points_meet(at_height(p), at_height(moved_onto(conic, p))))
        throw InputError("an end is not on the curve");
    DrawnCurve curve{is_ellipse ? closed_arc(conic, from, to)
                                : CurvePieces{open_arc(conic, is_parabola, from, to)}};
    for (RationalBezier& piece : curve.pieces)
      for (Vector<Rational>& p : piece.points) p[2] = z;
    return curve;
  });
}

DrawnCurve IgesCurves::composite(const IgesEntity& entity, int depth) const {
  IgesNumbers in = file_.parameters(entity);
  DrawnCurve curve;
  for (long left = in.whole(1, static_cast<long>(in.left()), "the number of curves"); left > 0;
       --left) {
    const long sequence = in.whole(1, 10'000'000, "a directory entry");
    DrawnCurve next = this->curve(file_.entity(sequence, entity), depth + 1);
    std::ranges::move(next.pieces, std::back_inserter(curve.pieces));
  }
  return curve;
}

DrawnCurve IgesCurves::curve(const IgesEntity& entity, int depth) const {
  if (depth > deepest_) entity.fail("curves are in curves more than 32 deep");
  DrawnCurve found;
  if (entity.type == 126) {
    found = spline(entity);
  } else if (entity.type == 110) {
    IgesNumbers in = file_.parameters(entity);
    const Vector<Rational> from = in.vector();
    found.pieces = {{{from, in.vector()}}};
  } else if (entity.type == 100) {
    found = arc(entity);
  } else if (entity.type == 104) {
    found = conic(entity);
  } else if (entity.type == 102) {
    found = composite(entity, depth);
  } else if (entity.type == 106 && is_curve(entity)) {
    found = polyline(entity);
  } else if (entity.type == 112) {
    found = cubics(entity);
  } else {
    entity.fail(fmt::format("this is not read; curves are {}", curve_types));
  }
  const AffineMap map = map_of(entity);
  for (RationalBezier& piece : found.pieces)
    for (Vector<Rational>& p : piece.points) p = map(p);
  return found;
}

/// Is it drawn by itself? Not what another entity is made of, nor what is not geometry, as curves
/// of parameters of surfaces are.
bool is_free_curve(const IgesEntity& entity) {
  const long subordinate = entity.status / 10'000 % 100;
  const long use = entity.status / 100 % 100;
  return is_curve(entity) && (subordinate == 0 || subordinate == 2) && use == 0;
}

}  // namespace

bool is_iges_file(std::string_view text) {
  // "S" in column 73 and the number 1, in seven columns.
  const std::string_view line = text.substr(0, text.find('\n'));
  return line.size() >= 80 && line[72] == 'S' && trimmed(line.substr(73, 7)).ends_with('1') &&
         line.substr(73, 6).find_first_not_of(" 0") == std::string_view::npos;
}

PointCurve read_iges(std::string_view text, const FileReading& reading, const CurveLimits& limits) {
  reading.refuse_skipping("an IGES file");
  const IgesFile file(text);
  const IgesCurves curves(file, limits);
  std::vector<DrawnChain> parts;
  std::map<long, int> others;
  for (const auto& [sequence, entity] : file.entities()) {
    if (!is_free_curve(entity)) {
      ++others[entity.type];
      continue;
    }
    parts.emplace_back(curves.curve(entity), entity.line, fmt::format("level {}", entity.level),
                       fmt::format("D{}", sequence));
  }
  std::vector<long> types;
  for (const auto& [type, count] : others) types.push_back(type);
  if (parts.empty())
    throw InputError("line 1",
                     fmt::format("there is no curve ({}) by itself in the IGES file: it has {}",
                                 curve_types, fmt::join(types, ", ")));
  return {"", chosen_chain(chains_of_drawing(std::move(parts)), reading.pick)};
}

}  // namespace phrame
