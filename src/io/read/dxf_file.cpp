// A DXF file is a list of pairs, a group code in one line and its value in the next [AutoCAD DXF
// Reference]. The code 0 begins an entity.
//
// An arc from p to q with the bulge b, the tangent of a quarter of its angle, has the middle
// m = (p + q)/2 + b/2·n, n the chord q − p turned to the right. The tangents at p and m meet
// in m − (1 + b²)/4·(q − p), and of each half, which has the angle 4 arctan b/2, the weights are 1,
// 1, 1 + b², since cos² arctan b = 1/(1 + b²). So it is a curve over ℚ.
#include "phrame/io/read/dxf_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/io/read/drawn_chain.hpp"
#include "phrame/io/read/number.hpp"
#include "phrame/ph/curve/bspline.hpp"
#include "phrame/ph/curve/ellipse_arc.hpp"
#include "phrame/ph/curve/transform.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

struct DxfGroup {
  int code;
  std::string_view value;
  long line;  ///< of the value
};

std::vector<DxfGroup> read_dxf_groups(std::string_view text) {
  std::vector<DxfGroup> groups;
  long number = 0;
  const auto next = [&] {
    ++number;
    return trimmed(take_line(text));
  };
  while (!text.empty()) {
    const std::string_view code = next();
    if (code.empty() && text.empty()) break;
    int value = 0;
    const auto [end, error] = std::from_chars(code.data(), code.data() + code.size(), value);
    if (error != std::errc() || end != code.data() + code.size())
      throw InputError(line_place(number),
                       fmt::format("a group code is expected, not \"{}\"", abbreviated(code)));
    if (value == 999) {
      next();
      continue;
    }
    const std::string_view said = next();
    groups.push_back({value, said, number});
  }
  return groups;
}

Rational group_number(const DxfGroup& group) {
  try {
    return parse_short_number(group.value);
  } catch (const InputError& error) {
    throw InputError(line_place(group.line), error.reason());
  }
}

/// The groups from one code 0 to the next.
struct DxfEntity {
  std::string_view type;
  std::vector<DxfGroup> groups;
  long line;

  [[noreturn]] void fail(const std::string& reason) const {
    throw InputError(line_place(line), fmt::format("{}: {}", type, reason));
  }
  const DxfGroup* find(int code) const {
    const auto found = std::ranges::find(groups, code, &DxfGroup::code);
    return found == groups.end() ? nullptr : &*found;
  }
  std::string text(int code) const {
    const DxfGroup* found = find(code);
    return found == nullptr ? "" : std::string(found->value);
  }
  Rational number(int code, const std::optional<Rational>& otherwise = {}) const {
    const DxfGroup* found = find(code);
    if (found != nullptr) return group_number(*found);
    if (!otherwise) fail(fmt::format("the group {} is missing", code));
    return *otherwise;
  }
  long flags(int code) const {
    const Rational x = number(code, Rational(0));
    if (denominator(x) != 1 || x < 0 || x > 1'000'000)
      fail(fmt::format("the group {} is no small number", code));
    return static_cast<long>(numerator(x));
  }
  /// Codes `code`, `code` + 10 and `code` + 20; z may be missing.
  Vector<Rational> point(int code) const {
    return {number(code), number(code + 10), number(code + 20, Rational(0))};
  }
};

/// −1 where x is mirrored: the extrusion is along −z.
int sense_of(const DxfEntity& entity) {
  const Vector<Rational> n{entity.number(210, Rational(0)), entity.number(220, Rational(0)),
                           entity.number(230, Rational(1))};
  if (n[0] != 0 || n[1] != 0 || n[2] == 0) entity.fail("only extrusions along z and −z are read");
  return n[2] < 0 ? -1 : 1;
}

CurvePieces mirrored_pieces(CurvePieces pieces, int sense) {
  if (sense < 0)
    for (RationalBezier& piece : pieces)
      for (Vector<Rational>& p : piece.points) p = {-p[0], p[1], -p[2]};
  return pieces;
}

CurvePieces lifted_pieces(CurvePieces pieces, const Rational& z) {
  for (RationalBezier& piece : pieces)
    for (Vector<Rational>& p : piece.points) p[2] = z;
  return pieces;
}

CurvePieces circle_of(const DxfEntity& entity) {
  const Vector<Rational> center = entity.point(10);
  const Rational r = entity.number(40);
  if (r <= 0) entity.fail("the radius is not > 0");
  PlaneVector from{1, 0};
  PlaneVector to{1, 0};
  if (entity.type == "ARC") {
    from = rotation_by_degrees(entity.number(50));
    to = rotation_by_degrees(entity.number(51));
  }
  const Ellipse circle{{center[0], center[1]}, {r, 0}, {0, r}};
  return mirrored_pieces(lifted_pieces(ellipse_arc(circle, from, to, true), center[2]),
                         sense_of(entity));
}

/// Its center and axis are in space, whatever the extrusion is.
CurvePieces ellipse_of(const DxfEntity& entity) {
  const Vector<Rational> center = entity.point(10);
  const Vector<Rational> a = entity.point(11);
  if (a[2] != 0) entity.fail("only ellipses in planes across z are read");
  const Rational ratio = entity.number(40) * sense_of(entity);
  if (ratio == 0) entity.fail("the ratio of the axes is 0");
  const Rational first = entity.number(41, Rational(0));
  const DxfGroup* last = entity.find(42);
  PlaneVector from = rotation_by_radians(first);
  PlaneVector to = from;
  // 2π is rounded somehow.
  if (last != nullptr &&
      std::abs(round_to_double(group_number(*last) - first) - 2 * std::acos(-1.0)) > 1e-6)
    to = rotation_by_radians(group_number(*last));
  const Ellipse ellipse{{center[0], center[1]}, {a[0], a[1]}, {-ratio * a[1], ratio * a[0]}};
  return lifted_pieces(ellipse_arc(ellipse, from, to, true), center[2]);
}

/// A vertex of a polyline, and the bulge behind it.
struct DxfVertex {
  Vector<Rational> point;
  Rational bulge;
};

void add_bulged(CurvePieces& pieces, const DxfVertex& from, const Vector<Rational>& q) {
  const Vector<Rational>& p = from.point;
  const Rational& b = from.bulge;
  if (p == q) return;
  if (b == 0) {
    pieces.push_back({{p, q}});
    return;
  }
  const Vector<Rational> d = q - p;
  const Vector<Rational> right{d[1], -d[0], 0};
  const Vector<Rational> middle = Rational(1, 2) * (p + q) + b / 2 * right;
  const Vector<Rational> way = (1 + b * b) / 4 * d;
  pieces.push_back({{p, middle - way, middle}, {1, 1, 1 + b * b}});
  pieces.push_back({{middle, middle + way, q}, {1 + b * b, 1, 1}});
}

CurvePieces polyline_of(std::vector<DxfVertex> vertices, bool is_closed) {
  if (is_closed && !vertices.empty()) vertices.push_back({vertices.front().point, 0});
  CurvePieces pieces;
  for (std::size_t k = 1; k < vertices.size(); ++k)
    add_bulged(pieces, vertices[k - 1], vertices[k].point);
  return pieces;
}

CurvePieces light_polyline_of(const DxfEntity& entity) {
  const Rational z = entity.number(38, Rational(0));
  std::vector<DxfVertex> vertices;
  for (const DxfGroup& group : entity.groups) {
    if (group.code == 10) vertices.push_back({{group_number(group), 0, z}, 0});
    if (vertices.empty()) continue;
    if (group.code == 20) vertices.back().point[1] = group_number(group);
    if (group.code == 42) vertices.back().bulge = group_number(group);
  }
  return mirrored_pieces(polyline_of(std::move(vertices), (entity.flags(70) & 1) != 0),
                         sense_of(entity));
}

/// A POLYLINE; its vertices are the entities behind it.
CurvePieces old_polyline_of(const DxfEntity& entity, const std::vector<DxfEntity>& vertices) {
  const long flags = entity.flags(70);
  if ((flags & (16 | 64)) != 0) entity.fail("a mesh is no curve");
  const bool is_of_space = (flags & 8) != 0;
  std::vector<DxfVertex> found;
  for (const DxfEntity& vertex : vertices) {
    if ((vertex.flags(70) & 16) != 0) continue;  // a control point of the curve that was fitted
    found.push_back({vertex.point(10), is_of_space ? Rational(0) : vertex.number(42, Rational(0))});
  }
  CurvePieces pieces = polyline_of(std::move(found), (flags & 1) != 0);
  return is_of_space ? pieces : mirrored_pieces(std::move(pieces), sense_of(entity));
}

DrawnCurve spline_of(const DxfEntity& entity, const CurveLimits& limits) {
  BSpline spline;
  spline.degree = entity.flags(71);
  if (spline.degree < 1 || spline.degree > limits.max_degree)
    entity.fail(
        fmt::format("the degree {} is not between 1 and {}", spline.degree, limits.max_degree));
  for (const DxfGroup& group : entity.groups) {
    if (group.code == 40) spline.knots.push_back(group_number(group));
    if (group.code == 41) spline.weights.push_back(group_number(group));
    if (group.code == 10) spline.points.push_back({group_number(group), 0, 0});
    if (spline.points.empty()) continue;
    if (group.code == 20) spline.points.back()[1] = group_number(group);
    if (group.code == 30) spline.points.back()[2] = group_number(group);
  }
  if (spline.points.empty())
    entity.fail("the spline has fit points only: its control points are wanted");
  if (const auto fault = fault_of(spline)) entity.fail(fault->reason);
  return drawn_spline(spline);
}

/// What an entity draws; no value for one that is no curve.
std::optional<DrawnCurve> curve_of(const DxfEntity& entity, const std::vector<DxfEntity>& vertices,
                                   const CurveLimits& limits) {
  if (entity.type == "LINE") return DrawnCurve{{{{entity.point(10), entity.point(11)}}}};
  if (entity.type == "ARC" || entity.type == "CIRCLE") return DrawnCurve{circle_of(entity)};
  if (entity.type == "ELLIPSE") return DrawnCurve{ellipse_of(entity)};
  if (entity.type == "LWPOLYLINE") return DrawnCurve{light_polyline_of(entity)};
  if (entity.type == "POLYLINE") return DrawnCurve{old_polyline_of(entity, vertices)};
  if (entity.type == "SPLINE") return spline_of(entity, limits);
  return std::nullopt;
}

/// A drawing within the file, that INSERT puts somewhere.
struct DxfBlock {
  Vector<Rational> base;  ///< what comes to the place where it is put
  std::vector<DxfEntity> entities;
};

struct DxfSections {
  std::vector<DxfEntity> entities;
  std::map<std::string_view, DxfBlock> blocks;
};

DxfSections read_sections(std::string_view text) {
  std::vector<DxfEntity> entities;
  std::vector<DxfEntity> of_blocks;
  std::vector<DxfEntity>* inside = nullptr;
  bool is_named = true;
  for (const DxfGroup& group : read_dxf_groups(text)) {
    if (group.code == 0) {
      if (group.value == "SECTION") is_named = false;
      if (group.value == "SECTION" || group.value == "ENDSEC") inside = nullptr;
      if (inside != nullptr) inside->push_back({group.value, {}, group.line});
    } else if (group.code == 2 && !is_named) {
      is_named = true;
      if (group.value == "ENTITIES") inside = &entities;
      if (group.value == "BLOCKS") inside = &of_blocks;
    } else if (inside != nullptr && !inside->empty()) {
      inside->back().groups.push_back(group);
    }
  }
  DxfSections sections{std::move(entities), {}};
  DxfBlock* block = nullptr;
  for (DxfEntity& entity : of_blocks) {
    if (entity.type == "BLOCK") {
      const DxfGroup* name = entity.find(2);
      if (name == nullptr) entity.fail("a block without a name");
      block = &sections.blocks[name->value];
      *block = {{entity.number(10, Rational(0)), entity.number(20, Rational(0)),
                 entity.number(30, Rational(0))},
                {}};
    } else if (entity.type == "ENDBLK") {
      block = nullptr;
    } else if (block != nullptr) {
      block->entities.push_back(std::move(entity));
    }
  }
  return sections;
}

/// Reads the entities of a drawing, and those of the blocks that it has.
class DxfDrawing {
 public:
  DxfDrawing(std::string_view text, const CurveLimits& limits)
      : limits_(limits), sections_(read_sections(text)) {
    read(sections_.entities, {});
  }

  std::vector<DrawnChain> parts;
  std::map<std::string_view, int> skipped;  ///< entities that are no curves

 private:
  /// Where a block is put.
  struct Insertion {
    AffineMap map = {};
    std::string layer = {};   ///< of what is in the layer "0" of the block
    std::string handle = {};  ///< with a slash behind it
    int depth = 0;
  };

  void read(const std::vector<DxfEntity>& entities, const Insertion& in);
  void insert(const DxfEntity& entity, const Insertion& in);
  void add(const DxfEntity& entity, DrawnCurve curve, const Insertion& in);

  static constexpr long most_in_blocks = 200'000;

  const CurveLimits& limits_;
  DxfSections sections_;
  long count_ = 0;  ///< of entities in blocks
};

void DxfDrawing::add(const DxfEntity& entity, DrawnCurve curve, const Insertion& in) {
  CurvePieces& pieces = curve.pieces;
  for (RationalBezier& piece : pieces)
    for (Vector<Rational>& p : piece.points) p = in.map(p);
  std::erase_if(pieces, [](const RationalBezier& piece) {
    return std::ranges::all_of(piece.points,
                               [&](const auto& p) { return p == piece.points.front(); });
  });
  if (pieces.empty()) return;
  const std::string layer = entity.text(8);
  parts.emplace_back(std::move(curve), entity.line, in.depth > 0 && layer == "0" ? in.layer : layer,
                     in.handle + entity.text(5));
}

// A point p of the block comes to M(at + R(S(p − base) + k)), k a step of its rows and columns, S
// the scales, R the rotation about z, and M the mirror of an extrusion along −z.
void DxfDrawing::insert(const DxfEntity& entity, const Insertion& in) {
  const auto block = sections_.blocks.find(entity.find(2) == nullptr ? "" : entity.find(2)->value);
  if (block == sections_.blocks.end()) {
    ++skipped[entity.type];
    return;
  }
  constexpr int deepest = 32;
  if (in.depth == deepest) entity.fail("blocks are in blocks more than 32 deep");
  const Rational mirror = sense_of(entity);
  const auto [c, s] = rotation_by_degrees(entity.number(50, Rational(0)));
  AffineMap turned;
  turned.columns = {{{c, s, 0}, {-s, c, 0}, {0, 0, 1}}};
  turned.shift = {entity.number(10), entity.number(20), entity.number(30, Rational(0))};
  turned = composed(turned, {{{{mirror, 0, 0}, {0, 1, 0}, {0, 0, mirror}}}, {}});
  AffineMap scaled;
  for (std::size_t k = 0; k < 3; ++k)
    scaled.columns[k][k] = entity.number(41 + static_cast<int>(k), Rational(1));
  const Vector<Rational>& base = block->second.base;
  const AffineMap to_place = composed({AffineMap{}.columns, Rational(-1) * base}, scaled);
  const long columns = std::max(1L, entity.flags(70));
  const long rows = std::max(1L, entity.flags(71));
  if (columns * rows > most_in_blocks)
    entity.fail(fmt::format("there are more than {} copies of a block", most_in_blocks));
  Insertion next{{}, entity.text(8), in.handle + entity.text(5) + "/", in.depth + 1};
  if (in.depth > 0 && next.layer == "0") next.layer = in.layer;
  for (long row = 0; row < rows; ++row)
    for (long column = 0; column < columns; ++column) {
      AffineMap step;
      step.shift = {column * entity.number(44, Rational(0)), row * entity.number(45, Rational(0)),
                    0};
      next.map = composed(composed(composed(to_place, step), turned), in.map);
      read(block->second.entities, next);
    }
}

void DxfDrawing::read(const std::vector<DxfEntity>& entities, const Insertion& in) {
  for (std::size_t k = 0; k < entities.size(); ++k) {
    const DxfEntity& entity = entities[k];
    if (entity.type == "VERTEX" || entity.type == "SEQEND" || entity.type == "ATTRIB") continue;
    if (in.depth > 0 && ++count_ > most_in_blocks)
      entity.fail(fmt::format("blocks have more than {} entities", most_in_blocks));
    if (entity.type == "INSERT") {
      insert(entity, in);
      continue;
    }
    std::vector<DxfEntity> vertices;
    for (std::size_t j = k + 1; j < entities.size() && entities[j].type == "VERTEX"; ++j)
      vertices.push_back(entities[j]);
    if (auto curve = curve_of(entity, vertices, limits_))
      add(entity, *std::move(curve), in);
    else
      ++skipped[entity.type];
  }
}

}  // namespace

bool is_dxf_file(std::string_view text) {
  const auto take = [&] { return trimmed(take_line(text)); };
  for (std::string_view code = take(); code == "999"; code = take()) take();
  return !text.empty() && take() == "SECTION";
}

PointCurve read_dxf(std::string_view text, const FileReading& reading, const CurveLimits& limits) {
  reading.refuse_skipping("a DXF file");
  DxfDrawing drawing(text, limits);
  const std::vector<DrawnChain> chains = chains_of_drawing(std::move(drawing.parts));
  std::vector<std::string> skipped;
  for (const auto& [type, count] : drawing.skipped)
    skipped.push_back(count == 1 ? std::string(type) : fmt::format("{} {}", count, type));
  if (chains.empty())
    throw InputError(
        "line 1",
        fmt::format("there is no curve in the section ENTITIES{}",
                    skipped.empty() ? "" : fmt::format(": it has {}", fmt::join(skipped, ", "))));
  PointCurve curve{"", chosen_chain(chains, reading.pick)};
  if (!skipped.empty())
    curve.notes.push_back(fmt::format("left out are {}", fmt::join(skipped, ", ")));
  return curve;
}

}  // namespace phrame
