#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "phrame/algebra/near_arithmetic.hpp"
#include "phrame/algebra/piecewise_polynomial.hpp"
#include "phrame/ph/frame/compiled_length.hpp"
#include "phrame/ph/frame/frame_check.hpp"

namespace phrame::inline v0 {

/// A GivenFrame in sums of two doubles.
struct NearFrame {
  NearNumber t;  ///< or the arc length from the start of the path
  Vector<NearNumber> f2;
  std::optional<Vector<NearNumber>> f3 = std::nullopt;
  std::optional<Vector<NearNumber>> tangent = std::nullopt;
};

/// Finds among very many frames, a microsecond each, the few that check_frames() decides by: of
/// these alone it finds what it finds of all, but for the numbers of the samples. It does where the
/// angles of all are less than 3/2 in size, and said so by these few, so that no step from one to
/// the next is a flip or a whole turn. They are
///   - the first frame, with which the others are compared, and the last, to which there is a
///   drift;
///   - those of the least and greatest angle and the greatest cosine and error of a length: only
///     those are left out that bounds prove to be less;
///   - those of which guessed_up_vectors() makes its guesses, of which the same holds;
///   - those of which doubles do not tell whether they are at fault, or not orthonormal, or how
///     they are wrong, with their neighbours;
///   - the first fault of a kind, and some on the way, so that what is no frame of another kind is
///     seen not to be one.
class FrameSieve {
 public:
  /// A frame, and where it is found again.
  struct Row {
    std::size_t number;   ///< from 0
    std::uint64_t place;  ///< whatever add() was told
  };
  /// A number is between these.
  struct Bounds {
    double lower;
    double upper;
  };
  /// Faults that doubles tell of frames, which may be all.
  static constexpr std::array told_faults{FrameFinding::Kind::wrong_tangent,
                                          FrameFinding::Kind::not_orthogonal,
                                          FrameFinding::Kind::not_unit};

  /// Throws Undecided or DomainError where the path is not compiled, as where f or p is not > 0.
  FrameSieve(const PathAngle& angle, const FrameCheckOptions& options, bool is_by_length);

  /// The next frame; in the order of t, from 0 to the end of the path. False where the sieve is of
  /// no use: another order, an angle of more than 1.48 to the first, or too many frames that
  /// decide. In rounding to nearest.
  bool add(const NearFrame& frame, std::uint64_t place);
  /// So many were added.
  std::size_t size() const { return count_; }
  /// Those that decide, in order. Precondition: there is one.
  std::vector<Row> rows() const;
  /// The numbers of all frames of which doubles tell that fault, in order.
  const std::array<std::vector<std::size_t>, told_faults.size()>& faults() const { return faults_; }
  /// The greatest difference of the error of a frame from that of the one before is at least the
  /// lower bound, and at most the upper one where the two are not among the rows().
  const Bounds& greatest_step() const { return greatest_step_; }

 private:
  struct Deviation {
    Bounds angle;  ///< the tangent of that to the first frame
    NearBounds orthogonality;
    NearBounds length;
    NearBounds tangent_sine;
    std::array<double, 2> turned;  ///< |n × n₀|² for f₂ and for e₁ × f₂, about
  };
  /// The frames that may have the greatest of some numbers.
  class Greatest {
   public:
    void offer(const Row& row, const Bounds& x);
    bool is_full() const { return rows_.size() > most_rows; }
    void add_to(std::vector<Row>& rows) const;

   private:
    double least_ = -HUGE_VAL;  ///< the maximum is no less
    std::vector<std::pair<Row, double>> rows_;
  };
  /// A few frames on the way, of which the next is where the angle is another by some gap.
  class Waypoints {
   public:
    void offer(const Row& row, double angle);
    void add_to(std::vector<Row>& rows) const;

   private:
    double gap_ = 0;
    std::vector<std::pair<Row, double>> rows_;
  };
  static constexpr std::size_t most_rows = 2000;

  static Bounds tangent_of(const NearNumber& x, const NearNumber& y);
  bool follows(const NearNumber& t) const;
  std::optional<NearNumber> parameter(const NearNumber& t) const;
  std::optional<Deviation> deviation(const NearFrame& frame);
  std::array<double, 2> turned(const Vector<NearNumber>& tangent, const Vector<NearNumber>& f2);
  bool find_faults(const Row& row, const Deviation& found);
  void step_to(const Row& row, const std::optional<Deviation>& found);

  Path path_;
  PiecewisePolynomial rotation_;  ///< of a rotation-minimizing frame
  std::optional<CompiledLength> length_;
  bool has_corners_ = false;
  Bounds tolerance_;
  std::optional<std::pair<NearNumber, NearNumber>> first_;  ///< f₂ of the first frame to that
  std::array<Vector<double>, 2> first_normals_{};           ///< and its normals
  std::size_t count_ = 0;
  NearNumber t_;  ///< of the last frame
  std::optional<Bounds> last_angle_;
  Bounds greatest_step_{0, 0};
  Row first_row_{};
  Row last_row_{};
  std::vector<Row> rows_;  ///< those that are chosen one by one
  std::array<std::vector<std::size_t>, told_faults.size()> faults_;
  Greatest highest_, lowest_, cosines_, lengths_;
  std::array<Greatest, 2> turned_;
  Waypoints by_angle_, by_number_;
};

}  // namespace phrame
