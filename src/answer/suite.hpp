#pragma once
#include "phrame/answer/check.hpp"
#include "phrame/ph/frame/convergence.hpp"

namespace phrame::inline v0 {

/// What check finds in somebody's tables for one curve of a collection.
struct SuiteRow {
  std::string name;   ///< of the curve
  std::string group;  ///< that it is of
  /// Why there is no verdict; then nothing of what follows is there.
  std::string failure = {};
  bool passes = false;          ///< of the table with the least step, as all that follows
  std::size_t samples = 0;      ///< the number of its frames
  RealBall max_error = {};      ///< in radians
  std::size_t flips = 0;        ///< so often f₂ turns by more than 3 radians in one step
  RealBall orthogonality = {};  ///< cosines of angles that should be right
  /// By how much f₂ turns against the exact one, from first to last, over the arc length.
  std::optional<RealBall> drift = std::nullopt;
  /// Of a closed curve with frames at both ends, in [−π, π]: by how much the holonomy is off.
  std::optional<RealBall> holonomy = std::nullopt;
  Convergence convergence = {};  ///< over all tables of the curve

  /// That the table with the least step took to compute, where it is told.
  std::optional<Rational> seconds() const;
};

/// A table for a curve of it.
struct SuiteTable {
  CheckAnswer found;
  std::optional<Rational> seconds;  ///< that it took to compute; no value where it is not told
};

/// The row of these tables: at least one, with the frames of one curve.
SuiteRow suite_row(const std::string& name, const std::string& group,
                   const std::vector<SuiteTable>& tables);

/// How the errors of a method fall on one curve.
struct OrderAnswer {
  std::string name;  ///< of the curve
  Convergence convergence;
};

/// A folder of tables for a collection of curves.
struct SuiteAnswer {
  std::vector<SuiteRow> rows;        ///< a curve each, those of a group one after the other
  std::vector<std::string> missing;  ///< the curves without a table
  Rational tolerance;

  /// Is there a table for each curve, and do all pass?
  bool passes() const;
};

/// What the rows of a group come to.
struct SuiteGroup {
  std::string name;        ///< empty of all rows
  std::size_t curves = 0;  ///< with a table
  std::size_t passed = 0;
  std::size_t failures = 0;  ///< without a verdict
  std::size_t flips = 0;
  // The largest, in absolute value: bounds.
  std::optional<Rational> max_error = std::nullopt;
  std::optional<Rational> drift = std::nullopt;
  std::optional<Rational> holonomy = std::nullopt;
  /// The median of the orders; no value where no row has one.
  std::optional<double> order = std::nullopt;
  /// Of all tables with the least step of which it is told, which have so many frames.
  std::optional<Rational> seconds = std::nullopt;
  std::size_t timed_samples = 0;
};

/// Of each group, in their order, and of all.
std::vector<SuiteGroup> suite_groups(const SuiteAnswer& answer);

}  // namespace phrame
