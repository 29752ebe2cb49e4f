#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "phrame/answer/check.hpp"
#include "phrame/io/read/frame_csv.hpp"
#include "phrame/ph/along/parametrization.hpp"
#include "phrame/ph/frame/frame_sieve.hpp"

namespace phrame::inline v0 {

/// The bytes of a file from some place on: so many, or those that there are.
using ReadBytes = std::function<std::string(std::uint64_t from, std::size_t count)>;

/// The few rows of a long table that decide what is found of all of them.
struct SiftedTable {
  std::string text;                  ///< a table of these rows, below what is above the first row
  std::vector<std::size_t> numbers;  ///< theirs in the whole table, from 0
  std::size_t rows;                  ///< so many it has
  /// As FrameSieve has them.
  std::array<std::vector<std::size_t>, FrameSieve::told_faults.size()> faults;
  FrameSieve::Bounds greatest_step;
};

/// Reads a table that has `size` bytes, in pieces, and puts it through a FrameSieve. Its t is what
/// `by` says, or ours, where the table is too long for better_parameters(). No value where that
/// does not pay or is of no use, as where the table is no plain text of vectors in the order of t:
/// then read_frames() is the way. Throws as a FrameSieve, and
/// InputError for a table that read_frames() refuses.
std::optional<SiftedTable> sifted_frames(const ReadBytes& read, std::uint64_t size,
                                         const FrameReading& reading, const NamedPath& named,
                                         std::optional<ParameterKind> by,
                                         const FrameCheckOptions& options);

/// Is what was found of these rows what would be found of all?
bool is_for_all(const CheckAnswer& found, const SiftedTable& few);
/// Of each finding the samples in the whole table.
std::vector<std::vector<std::size_t>> samples_of_all(const FrameVerdict& verdict,
                                                     const SiftedTable& few);

}  // namespace phrame
