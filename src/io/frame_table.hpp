#pragma once
#include "phrame/io/curve_file.hpp"
#include "phrame/ph/frame.hpp"

namespace phrame {

/// The frames that a table can hold beside t, r and e₁.
enum class TabulatedFrame {
  rmf,     ///< f₂, f₃: rotation-minimizing, equal to (e₂, e₃) at t = 0
  erf,     ///< e₂, e₃: Euler–Rodrigues
  frenet,  ///< n, b
};

/// Numbers with a name for each column; all of them correctly rounded.
struct FrameTable {
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;
};

/// t, r, e₁ and the frames asked for, at each t.
/// Throws DomainError where the Frenet frame is undefined, Undecided where a number is too large
/// for a double.
FrameTable frame_table(const Curve& curve, const std::vector<TabulatedFrame>& frames,
                       const std::vector<Rational>& at);

/// Shortest decimal texts that read back to the same doubles.
std::string to_csv(const FrameTable& table);
std::string to_json(const FrameTable& table);  ///< frames/1
/// NumPy's .npy format, version 1.0: rows × columns of little-endian doubles, row after row.
std::string to_npy(const FrameTable& table);

}  // namespace phrame
