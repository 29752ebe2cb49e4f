#include "phrame/ph/sweep/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/progress.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/direction_span.hpp"
#include "phrame/ph/curve/local_origin.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/sweep/profile_triangles.hpp"
#include "phrame/ph/sweep/sweep_rates.hpp"
#include "phrame/ph/sweep/sweep_section.hpp"

namespace phrame::inline v0 {
namespace {

/// The sections from start to end, and bounds of how far the triangles between them are off.
struct SectionList {
  std::vector<SweepSection> sections;
  double joint_error = 0;  ///< where a mitre stands for the sections on both its sides
  double patch_error = 0;
  double normal_error = 0;
  double rounding = 0;  ///< the greatest, of the corners of the sections

  void add(SweepSection next) {
    rounding = std::max(rounding, next.rounding);
    sections.push_back(std::move(next));
  }
};

class Tessellation {
 public:
  Tessellation(const SweepPath& path, const SweepForm& form, const SweepTurn& turn)
      : path_(path),
        form_(form),
        scale_(form.scale, path.series.segments),
        sections_(path, form, turn),
        turn_(turn),
        is_against_(direction_of_motion(path) < 0) {}

  bool is_against() const { return is_against_; }  ///< does the path go against e₁?
  /// The parts of the path between sections; a line between two mitres is one part.
  SweepParts parts(double tolerance) const;
  /// Decides how the sections at corners are joined: a mitre that is nearer than `within` to the
  /// sections on its sides replaces them.
  void join_corners(double within);
  /// Throws Undecided where a corner has facets that lead back into the body.
  void require_no_facets() const;
  /// Sections so close that the triangles between them are within `tolerance` of their patches, and
  /// their normals within the tolerance of normals.
  SectionList sections(const std::vector<SweepPart>& parts, double tolerance) const;
  /// So many equally spaced sections, one more for a closed path; beside them those of corners, and
  /// none inside a line between two mitres.
  SectionList equal_sections(long wanted) const;

 private:
  static int direction_of_motion(const SweepPath& path);
  double normal_error(const SweepPart& part, const SweepSection& a, const SweepSection& b) const;
  /// Does the section at one of its ends fold over itself?
  bool folds_at(const SweepPart& part) const;
  bool has_corner(std::size_t segment) const { return corners_.contains(segment % count()); }
  std::size_t count() const { return path_.series.segments; }
  bool is_between_mitres(std::size_t segment) const;
  bool has_section_before(std::size_t corner) const;
  bool has_section_behind(std::size_t corner) const;
  SweepSection start() const;
  SweepSection end_of(const SweepPart& part, const SweepSection& first) const;
  void add_behind(SectionList& found, std::size_t segment) const;
  void add_corner(SectionList& found, std::size_t segment) const;
  /// Are two sections no farther from each other than some units in the last place?
  static bool is_rounded_away(const SweepSection& a, const SweepSection& b);

  const SweepPath& path_;
  const SweepForm& form_;
  ScaleRates scale_;
  SweepSections sections_;
  const SweepTurn& turn_;
  bool is_against_;
  /// For each segment that begins with a corner: does the mitre replace the sections beside it?
  std::map<std::size_t, bool> corners_{};
  std::vector<bool> between_mitres_{};  ///< for each segment: is it a line from mitre to mitre?
  double joint_error_ = 0;
};

// At a corner a body has the section where one segment ends, the mitre, and the section where the
// next one begins; towards the inner side the facets between them lead back. A line between two
// mitres is bounded by plane facets from the one to the other, if all its edges lead forward.

void Tessellation::join_corners(double within) {
  std::map<std::size_t, std::vector<double>> offsets;
  for (const std::size_t k : path_.corners) {
    const auto& of = offsets[k] = sections_.mitre_offsets(k);
    double farthest = 0;
    for (const double x : of) farthest = std::max(farthest, std::abs(x));
    corners_[k] = farthest <= within;
    if (corners_[k]) joint_error_ = std::max(joint_error_, farthest * sweep_slack);
  }
  if (corners_.empty()) return;
  const bool is_prism = form_.scale.is_constant() && turn_.is_zero();
  const std::vector<double> none(form_.profile.corners().size());
  const auto offset_at = [&](std::size_t k) -> const std::vector<double>& {
    const auto found = offsets.find(k % count());
    return found == offsets.end() ? none : found->second;
  };
  for (std::size_t k = 0; k < count(); ++k) {
    bool is_forward = is_prism && path_.are_lines[k];
    const double length = is_forward ? sections_.chord(k) : 0;
    for (std::size_t j = 0; is_forward && j < none.size(); ++j)
      is_forward = length - offset_at(k + 1)[j] - offset_at(k)[j] > length / 64;
    between_mitres_.push_back(is_forward);
  }
}

void Tessellation::require_no_facets() const {
  for (const auto& [corner, is_one] : corners_)
    if (has_section_before(corner) || has_section_behind(corner))
      throw Undecided(
          fmt::format("sweep: at the corner t = {} the body folds over itself, so that its normals "
                      "have no bound",
                      corner));
}

bool Tessellation::is_between_mitres(std::size_t segment) const {
  return !between_mitres_.empty() && between_mitres_[segment % count()];
}

bool Tessellation::has_section_before(std::size_t corner) const {
  return !corners_.at(corner % count()) && !is_between_mitres(corner + count() - 1);
}

bool Tessellation::has_section_behind(std::size_t corner) const {
  return !corners_.at(corner % count()) && !is_between_mitres(corner);
}

SweepParts Tessellation::parts(double tolerance) const {
  SweepParts found = sweep_parts(path_, scale_, turn_, form_.profile.reach(), tolerance);
  const auto is_superfluous = [&](const SweepPart& part) {
    return is_between_mitres(part.segment) && part.from > 0;
  };
  found.parts.erase(std::remove_if(found.parts.begin(), found.parts.end(), is_superfluous),
                    found.parts.end());
  for (SweepPart& part : found.parts)
    if (is_between_mitres(part.segment)) part.to = 1;
  return found;
}

/// Adds the section behind the mitre at the start of a segment, where there is one.
void Tessellation::add_behind(SectionList& found, std::size_t segment) const {
  if (!has_section_behind(segment)) return;
  found.add(sections_.section(segment, 0));
  found.sections.back().is_joint = true;
}

SweepSection Tessellation::start() const {
  return has_corner(0) ? sections_.mitre(0) : sections_.section(0, 0);
}

/// The section at the end of a part. At the end of a closed path it is the first one again.
SweepSection Tessellation::end_of(const SweepPart& part, const SweepSection& first) const {
  const std::size_t next = part.segment + 1;
  const bool is_end = part.to == 1 && (next < count() || path_.is_closed);
  const bool is_mitre = is_end && has_corner(next) && !has_section_before(next);
  SweepSection section =
      is_mitre && next < count() ? sections_.mitre(next) : sections_.section(part.segment, part.to);
  if (is_end && next == count() && (is_mitre || !has_corner(0))) section.points = first.points;
  return section;
}

/// 1 where the path goes along e₁, −1 where it goes against it.
int Tessellation::direction_of_motion(const SweepPath& path) {
  const RealBall start(0, 64);
  const auto motion =
      along_motion(path.series, 0, start, path.series.position(0, start, 2, 64), 1, 64);
  const Vector<double> e1 = path.frames(0).e1;
  double product = 0;
  for (std::size_t k = 0; k < 3; ++k) product += approximate(motion[k].coefficient(0)) * e1[k];
  return product < 0 ? -1 : 1;
}

double Tessellation::normal_error(const SweepPart& part, const SweepSection& a,
                                  const SweepSection& b) const {
  const auto rates = sweep_rates(path_, scale_, turn_, part);
  if (!rates) return HUGE_VAL;
  const Profile& profile = form_.profile;
  return phrame::normal_error(
      sections_, a, b,
      {sections_.motion(part.segment, part.from), sections_.motion(part.segment, part.to), *rates,
       part.step(), round_to_double(profile.angle()) * sweep_slack,
       round_to_double(profile.error()) * sweep_slack, profile.reach(), is_against_});
}

bool Tessellation::folds_at(const SweepPart& part) const {
  const auto folds = [&](double t) {
    return least_advance(sections_, sections_.motion(part.segment, t)) <= 0;
  };
  return folds(part.from) || folds(part.to);
}

bool Tessellation::is_rounded_away(const SweepSection& a, const SweepSection& b) {
  const double least = 64 * std::max(a.rounding, b.rounding);
  for (std::size_t k = 0; k < a.points.size(); ++k) {
    const Vector<double> step = b.points[k] - a.points[k];
    if (std::hypot(step[0], step[1], step[2]) > least) return false;
  }
  return true;
}

SectionList Tessellation::sections(const std::vector<SweepPart>& parts, double tolerance) const {
  SectionList found;
  found.joint_error = joint_error_;
  found.add(start());
  if (has_corner(0)) add_behind(found, 0);
  std::vector<SweepPart> left(parts.rbegin(), parts.rend());
  Stage stage("parts", parts.size());
  std::size_t whole = parts.size();  // of the given parts those that are left
  while (!left.empty()) {
    const SweepPart part = left.back();
    SweepSection next = end_of(part, found.sections.front());
    const SweepSection& last = found.sections.back();
    const double error = patch_error(sections_, last, next);
    const double of_normals = form_.normal_tolerance ? normal_error(part, last, next) : 0;
    const bool is_within = !(of_normals > form_.normal_tolerance.value_or(0));
    const bool is_enough = error <= tolerance && is_within;
    const bool is_last = !is_enough && is_rounded_away(last, next);
    if (is_last && (is_within || !folds_at(part)))
      fail_for_numbers(fmt::format("near t = {} the tolerance is too small beside the rounding of "
                                   "coordinates",
                                   part.start()),
                       form_.numbers);
    if (!is_enough && !is_last && part.step() > 0x1p-40) {
      const double middle = (part.from + part.to) / 2;
      left.back() = {part.segment, middle, part.to};
      left.push_back({part.segment, part.from, middle});
      continue;
    }
    if (!is_within)
      throw Undecided(
          fmt::format("sweep: near t = {} the body folds over itself, or its normals "
                      "turn faster than their tolerance allows",
                      part.start()));
    found.patch_error = std::max(found.patch_error, error);
    found.normal_error = std::max(found.normal_error, of_normals);
    left.pop_back();
    if (left.size() < whole) {
      --whole;
      stage.advance();
    }
    found.add(std::move(next));
    if (part.to == 1) add_corner(found, part.segment + 1);
    if (found.sections.size() * sections_.corners().size() > most_sweep_points)
      throw Undecided("sweep: more than 20000000 points are needed");
  }
  return found;
}

/// Adds what is left of a corner, the section where the segment before it ends being there.
void Tessellation::add_corner(SectionList& found, std::size_t segment) const {
  if (!has_corner(segment)) return;
  if (has_section_before(segment)) {
    SweepSection mitre = segment < count() ? sections_.mitre(segment) : found.sections.front();
    const auto offsets = sections_.mitre_offsets(segment % count());
    const double rounding = 8 * mitre.rounding;
    mitre.folds = std::count_if(offsets.begin(), offsets.end(),
                                [&](double offset) { return offset > rounding; });
    mitre.is_joint = true;
    found.add(std::move(mitre));
  }
  if (segment < count()) add_behind(found, segment);
}

SectionList Tessellation::equal_sections(long wanted) const {
  const auto segments = static_cast<long>(path_.series.segments);
  const long least = path_.is_closed ? 3 : 2;
  if (wanted < least)
    throw DomainError(fmt::format("sweep: {} sections of {} path bound no body, at least {} do",
                                  wanted, path_.is_closed ? "a closed" : "an open", least));
  const long steps = path_.is_closed ? wanted : wanted - 1;
  SectionList found;
  found.joint_error = joint_error_;
  Stage stage("sections", static_cast<std::size_t>(steps) + 1);
  std::size_t segment = 0;  // up to its start all is there
  found.add(start());
  if (has_corner(0)) add_behind(found, 0);
  const auto add_corners_up_to = [&](std::size_t last) {
    while (segment < last) {
      const SweepPart end{segment++, 0, 1};
      if (!has_corner(segment)) continue;
      found.add(end_of(end, found.sections.front()));
      add_corner(found, segment);
    }
  };
  for (long k = 1; k <= steps; ++k, stage.advance()) {
    const PathParameter at = locate_inside(count(), Rational(segments * k, steps));
    add_corners_up_to(at.segment);
    const bool is_there = (at.t == 0 && has_corner(at.segment)) || is_between_mitres(at.segment);
    if (k == steps || !is_there)
      found.add(end_of({at.segment, 0, round_to_double(at.t)}, found.sections.front()));
  }
  if (path_.is_closed) add_corner(found, count());
  return found;
}

/// Adds the points of the rings to the mesh, and returns their numbers, ring by ring. At a corner
/// the rings share the points that lie on the axis of the turn.
std::vector<std::uint32_t> ring_points(const std::vector<SweepSection>& sections, std::size_t rings,
                                       Mesh& mesh) {
  const std::size_t corners = sections.front().points.size();
  std::vector<std::uint32_t> numbers;
  numbers.reserve(rings * corners);
  const auto is_same = [&](const SweepSection& a, const SweepSection& b, std::size_t k) {
    const Vector<double> way = b.points[k] - a.points[k];
    return std::hypot(way[0], way[1], way[2]) <= 8 * (a.rounding + b.rounding);
  };
  const bool is_joint_at_end = rings < sections.size() && sections.back().is_joint;
  for (std::size_t ring = 0; ring < rings; ++ring)
    for (std::size_t k = 0; k < corners; ++k) {
      if (ring > 0 && sections[ring].is_joint && is_same(sections[ring - 1], sections[ring], k)) {
        numbers.push_back(numbers[numbers.size() - corners]);
      } else if (ring > 0 && ring + 1 == rings && is_joint_at_end &&
                 is_same(sections[ring], sections.front(), k)) {
        numbers.push_back(numbers[k]);
      } else {
        numbers.push_back(static_cast<std::uint32_t>(mesh.points.size()));
        mesh.points.push_back(sections[ring].points[k]);
      }
    }
  return numbers;
}

/// The mesh through these sections. The last section of a closed path is the first one again.
Mesh mesh_of(const std::vector<SweepSection>& sections, const Profile& profile, bool is_closed) {
  const std::size_t corners = profile.corners().size();
  const std::size_t rings = sections.size() - (is_closed ? 1 : 0);
  Mesh mesh;
  mesh.points.reserve(rings * corners);
  const std::vector<std::uint32_t> numbers = ring_points(sections, rings, mesh);
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a != b && b != c && c != a) mesh.triangles.push_back({a, b, c});
  };
  for (std::size_t ring = 0; ring + (is_closed ? 0 : 1) < rings; ++ring) {
    const std::uint32_t* here = &numbers[ring * corners];
    const std::uint32_t* there = &numbers[(ring + 1) % rings * corners];
    for (std::size_t k = 0; k < corners; ++k) {
      const std::size_t next = profile.next(k);
      add(here[k], here[next], there[next]);
      add(here[k], there[next], there[k]);
    }
  }
  if (is_closed) return mesh;
  const std::uint32_t* last = &numbers[(rings - 1) * corners];
  for (const auto& [i, j, k] : triangulated(profile)) {
    add(numbers[i], numbers[k], numbers[j]);  // seen from behind
    add(last[i], last[j], last[k]);
  }
  return mesh;
}

/// How many folds the first `count` sections have.
long folds_of(const std::vector<SweepSection>& sections, std::size_t count) {
  long folds = 0;
  for (std::size_t n = 0; n < count; ++n) folds += sections[n].folds;
  return folds;
}

/// Some points of all segments, in doubles.
std::vector<Vector<double>> places_of(const SweepPath& path) {
  const std::size_t steps = std::max(std::size_t{4}, 256 / path.series.segments);
  std::vector<Vector<double>> places;
  for (std::size_t segment = 0; segment < path.series.segments; ++segment)
    for (std::size_t k = 0; k <= steps; ++k) {
      const auto [x, y, z] = path.series.position(
          segment, RealBall(Rational(static_cast<long>(k), static_cast<long>(steps)), 64), 1, 64);
      places.push_back({approximate(x.coefficient(0)), approximate(y.coefficient(0)),
                        approximate(z.coefficient(0))});
    }
  return places;
}

/// The tolerance less about what the rounding of coordinates takes, but at least half of it. The
/// rounding that there is in fact is measured on all points later.
double beside_rounding(double tolerance, const SweepPath& path, const SweepForm& form,
                       double scale) {
  const Vector<double> origin = round_to_double(*form.origin);
  double greatest = 0;
  for (const Vector<double>& place : places_of(path)) {
    const Vector<double> from = place - origin;
    greatest = std::max(greatest, std::hypot(from[0], from[1], from[2]));
  }
  const double unit = form.numbers == Coordinates::floats ? 0x1p-24 : 0x1p-49;
  return std::max(tolerance / 2,
                  tolerance - 1.1 * unit * (greatest + form.profile.reach() * scale));
}

/// The sections of a mesh within the tolerance; sets the bounds of the body, but for rounding.
SectionList within(Tessellation& tessellation, const SweepPath& path, const SweepForm& form,
                   double scale, SweptBody& body) {
  const double all = round_to_double(std::get<Rational>(form.tolerance_or_sections)) / sweep_slack;
  const double of_profile = round_to_double(form.profile.error()) * scale * sweep_slack;
  if (!(of_profile <= all / 2))
    throw DomainError("sweep: the profile is not as near to its curve as the tolerance is small");
  if (form.normal_tolerance &&
      !(round_to_double(form.profile.angle()) < 0.9 * *form.normal_tolerance))
    throw DomainError(
        "sweep: the sides of the profile are not as near to its tangents as normals are to be");
  const double left = beside_rounding(all - of_profile, path, form, scale);
  tessellation.join_corners(left * 0.04);
  if (form.normal_tolerance) tessellation.require_no_facets();
  const SweepParts parts = tessellation.parts(left * 0.6);
  SectionList found = tessellation.sections(parts.parts, left * 0.35);
  body.error = of_profile + parts.error + found.patch_error + found.joint_error;
  if (form.normal_tolerance) body.normal_error = found.normal_error;
  return found;
}

/// Calls visit(motion) at 65 equally spaced t of each segment.
template <class Visit>
void visit_motions(const SweepPath& path, const SweepSections& sections, Visit visit) {
  constexpr double steps = 64;
  for (std::size_t segment = 0; segment < path.series.segments; ++segment)
    for (double k = 0; k <= steps; ++k) visit(sections.motion(segment, k / steps));
}

/// Where the profile turns or grows, the normal of the surface turns along a side. Divides the
/// sides into as many pieces as the tolerance needs at some sections; all are checked later.
Profile profile_for_normals(const SweepPath& path, const SweepForm& form, const SweepTurn& turn) {
  if (!form.normal_tolerance || (turn.is_zero() && form.scale.is_constant())) return form.profile;
  const SweepSections sections(path, form, turn);
  std::vector<double> greatest(form.profile.corners().size());
  visit_motions(path, sections, [&](const SweepMotion& motion) {
    const auto turns = normal_turns(sections, motion);
    for (std::size_t side = 0; side < turns.size(); ++side)
      greatest[side] = std::max(greatest[side], turns[side]);
  });
  std::vector<long> pieces;
  for (const double angle : greatest)
    pieces.push_back(
        std::max(1L, static_cast<long>(std::ceil(4 * angle / *form.normal_tolerance))));
  return subdivided(form.profile, pieces);
}

}  // namespace

double side_angle_factor(const SweepPath& path, const SweepForm& form) {
  const SweepTurn turn(path, form);
  if (turn.is_zero() && form.scale.is_constant()) return 1;
  const SweepSections sections(path, form, turn);
  double greatest = 1;
  visit_motions(path, sections, [&](const SweepMotion& motion) {
    const double rate = std::abs(motion.scale_rate) + std::abs(motion.turn_rate) * motion.scale;
    const double factor = 1 + rate * form.profile.reach() / least_advance(sections, motion);
    greatest = factor >= 1 ? std::max(greatest, factor) : 100;
  });
  return std::min(greatest, 100.0);
}

namespace {

void require_within(double error, const SweepForm& form) {
  if (std::isfinite(error) &&
      exact_rational(error) <= std::get<Rational>(form.tolerance_or_sections))
    return;
  fail_for_numbers(
      "the tolerance is too small beside the rounding of coordinates, with which the mesh is "
      "within " +
          (std::isfinite(error) ? upper_bound_text(exact_rational(error)) : "no distance"),
      form.numbers);
}

}  // namespace

SweepPath sweep_path(const Path& path, CompiledFrames frames) {
  SweepPath swept{series_of(path), std::move(frames), path.is_closed(), path.corners()};
  if (swept.is_closed && path.closes_at_corner()) swept.corners.insert(swept.corners.begin(), 0);
  if (!swept.corners.empty())
    for (const Segment& segment : path.segments())
      swept.are_lines.push_back(are_on_a_line(direction_span(segment)));
  return swept;
}

SweptBody sweep(const SweepPath& path, const SweepForm& form) {
  const double scale = form.scale.greatest(path.series.segments);
  const SweepTurn turn(path, form);
  SweepForm swept = form;
  if (!swept.origin) {
    const Vector<double> near = local_origin(places_of(path));
    swept.origin = {exact_rational(near[0]), exact_rational(near[1]), exact_rational(near[2])};
  }
  swept.profile = profile_for_normals(path, swept, turn);
  Tessellation tessellation(path, swept, turn);
  SweptBody body;
  SectionList found;
  if (const auto* count = std::get_if<long>(&form.tolerance_or_sections)) {
    tessellation.parts(HUGE_VAL);  // throws where the path turns back
    tessellation.join_corners(1e-6 * swept.profile.reach() * scale);
    found = tessellation.equal_sections(*count);
  } else {
    found = within(tessellation, path, swept, scale, body);
  }
  body.mesh = mesh_of(found.sections, swept.profile, path.is_closed);
  body.mesh.origin = *swept.origin;
  if (tessellation.is_against())
    for (auto& triangle : body.mesh.triangles) std::swap(triangle[1], triangle[2]);
  body.sections = found.sections.size() - (path.is_closed ? 1 : 0);
  body.folds = folds_of(found.sections, body.sections);
  if (!is_watertight(body.mesh)) throw Error("sweep: the check failed, the mesh is not watertight");
  require_apart(body.mesh, form.numbers);
  // The frames are within 2^−53, the turn within 2^−44.
  if (body.error) {
    const double reach = swept.profile.reach() * scale;
    *body.error += 0x1p-42 * reach + found.rounding;
    *body.error += turn.error() * reach;
    require_within(*body.error, form);
  }
  return body;
}

}  // namespace phrame
