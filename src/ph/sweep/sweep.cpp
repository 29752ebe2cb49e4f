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
#include "phrame/ph/sweep/body_mesh.hpp"
#include "phrame/ph/sweep/mesh_sieve.hpp"
#include "phrame/ph/sweep/sweep_rates.hpp"
#include "phrame/ph/sweep/sweep_section.hpp"
#include "phrame/ph/sweep/sweep_stream.hpp"

namespace phrame::inline v0 {
namespace {

/// The sections from start to end, as they are found, and bounds of how far the triangles between
/// them are off.
struct SectionRun {
  BodyMesh& mesh;           ///< that they make
  SweepSection first = {};  ///< of them
  SweepSection last = {};   ///< so far
  std::size_t count = 0;
  double joint_error = 0;  ///< where a mitre stands for the sections on both its sides
  double patch_error = 0;
  double normal_error = 0;
  double rounding = 0;  ///< the greatest, of the corners of the sections

  void add(SweepSection next) {
    rounding = std::max(rounding, next.rounding);
    mesh.add(next);
    if (count++ == 0) first = next;
    last = std::move(next);
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
  void sections(SectionRun& found, const std::vector<SweepPart>& parts, double tolerance) const;
  /// So many equally spaced sections, one more for a closed path; beside them those of corners, and
  /// none inside a line between two mitres.
  void equal_sections(SectionRun& found, long wanted) const;

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
  void add_behind(SectionRun& found, std::size_t segment) const;
  void add_corner(SectionRun& found, std::size_t segment) const;
  /// Throws Undecided for too many sections.
  void require_few(std::size_t count) const;
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
void Tessellation::add_behind(SectionRun& found, std::size_t segment) const {
  if (!has_section_behind(segment)) return;
  SweepSection section = sections_.section(segment, 0);
  section.is_joint = true;
  found.add(std::move(section));
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

void Tessellation::require_few(std::size_t count) const {
  if (count * sections_.corners().size() > most_sweep_points)
    throw Undecided("sweep: more than 20000000 points are needed");
}

void Tessellation::sections(SectionRun& found, const std::vector<SweepPart>& parts,
                            double tolerance) const {
  require_few(parts.size());
  found.joint_error = joint_error_;
  found.add(start());
  if (has_corner(0)) add_behind(found, 0);
  std::vector<SweepPart> left(parts.rbegin(), parts.rend());
  Stage stage("parts", parts.size());
  std::size_t whole = parts.size();  // of the given parts those that are left
  while (!left.empty()) {
    const SweepPart part = left.back();
    SweepSection next = end_of(part, found.first);
    const SweepSection& last = found.last;
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
    require_few(found.count);
  }
}

/// Adds what is left of a corner, the section where the segment before it ends being there.
void Tessellation::add_corner(SectionRun& found, std::size_t segment) const {
  if (!has_corner(segment)) return;
  if (has_section_before(segment)) {
    SweepSection mitre = segment < count() ? sections_.mitre(segment) : found.first;
    const auto offsets = sections_.mitre_offsets(segment % count());
    const double rounding = 8 * mitre.rounding;
    mitre.folds = std::count_if(offsets.begin(), offsets.end(),
                                [&](double offset) { return offset > rounding; });
    mitre.is_joint = true;
    found.add(std::move(mitre));
  }
  if (segment < count()) add_behind(found, segment);
}

void Tessellation::equal_sections(SectionRun& found, long wanted) const {
  const auto segments = static_cast<long>(path_.series.segments);
  const long least = path_.is_closed ? 3 : 2;
  if (wanted < least)
    throw DomainError(fmt::format("sweep: {} sections of {} path bound no body, at least {} do",
                                  wanted, path_.is_closed ? "a closed" : "an open", least));
  const long steps = path_.is_closed ? wanted : wanted - 1;
  found.joint_error = joint_error_;
  Stage stage("sections", static_cast<std::size_t>(steps) + 1);
  std::size_t segment = 0;  // up to its start all is there
  found.add(start());
  if (has_corner(0)) add_behind(found, 0);
  const auto add_corners_up_to = [&](std::size_t last) {
    while (segment < last) {
      const SweepPart end{segment++, 0, 1};
      if (!has_corner(segment)) continue;
      found.add(end_of(end, found.first));
      add_corner(found, segment);
    }
  };
  for (long k = 1; k <= steps; ++k, stage.advance()) {
    const PathParameter at = locate_inside(count(), Rational(segments * k, steps));
    add_corners_up_to(at.segment);
    const bool is_there = (at.t == 0 && has_corner(at.segment)) || is_between_mitres(at.segment);
    if (k == steps || !is_there)
      found.add(end_of({at.segment, 0, round_to_double(at.t)}, found.first));
  }
  if (path_.is_closed) add_corner(found, count());
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
void make_within(SectionRun& found, Tessellation& tessellation, const SweepPath& path,
                 const SweepForm& form, double scale, SweptBody& body) {
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
  tessellation.sections(found, parts.parts, left * 0.35);
  body.error = of_profile + parts.error + found.patch_error + found.joint_error;
  if (form.normal_tolerance) body.normal_error = found.normal_error;
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

namespace {

/// A whole one.
class WholeMesh : public MeshSink {
 public:
  void add_point(const Vector<double>& point) override { mesh.points.push_back(point); }
  void add_triangle(const Triangle& triangle, const Corners& /*corners*/) override {
    mesh.triangles.push_back(triangle);
  }

  Mesh mesh = {};
};

/// The points and triangles go to `out`; check() is asked when all are there.
template <class Check>
SweptBody swept(const SweepPath& path, const SweepForm& form, MeshSink& out, Check check) {
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
  BodyMesh mesh(swept.profile, path.is_closed, tessellation.is_against(), out);
  SectionRun found{mesh};
  if (const auto* count = std::get_if<long>(&form.tolerance_or_sections)) {
    tessellation.parts(HUGE_VAL);  // throws where the path turns back
    tessellation.join_corners(1e-6 * swept.profile.reach() * scale);
    tessellation.equal_sections(found, *count);
  } else {
    make_within(found, tessellation, path, swept, scale, body);
  }
  mesh.finish();
  body.mesh.origin = *swept.origin;
  body.sections = mesh.sections();
  body.folds = mesh.folds();
  check();
  // The frames are within 2^−53, the turn within 2^−44.
  if (body.error) {
    const double reach = swept.profile.reach() * scale;
    *body.error += 0x1p-42 * reach + found.rounding;
    *body.error += turn.error() * reach;
    require_within(*body.error, form);
  }
  return body;
}

}  // namespace

SweptBody sweep(const SweepPath& path, const SweepForm& form) {
  WholeMesh whole;
  SweptBody body = swept(path, form, whole, [&] {
    if (!is_watertight(whole.mesh))
      throw Error("sweep: the check failed, the mesh is not watertight");
    require_apart(whole.mesh, form.numbers);
  });
  whole.mesh.origin = body.mesh.origin;
  body.mesh = std::move(whole.mesh);
  return body;
}

SweptBody sweep(const SweepPath& path, const SweepForm& form, MeshSink& out) {
  MeshSieve sieve(form.numbers, out);
  return swept(path, form, sieve, [&] {
    if (!sieve.is_proved()) sweep(path, form);
  });
}

}  // namespace phrame
