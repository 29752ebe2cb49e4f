#include "phrame/cli/row_stream.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <map>
#include <mutex>
#include <thread>

#include "phrame/algebra/flint.hpp"
#include "phrame/algebra/out_of_memory.hpp"
#include "phrame/algebra/progress.hpp"
#include "phrame/cli/command.hpp"

namespace phrame::inline v0::cli {
namespace {

/// Of so many rows that follow one another.
struct Block {
  std::vector<std::vector<double>> rows{FrameRows::block};
  std::vector<std::size_t> others;  ///< those that doubles are not enough for
  std::string text;
};

std::size_t cores() { return std::max(1U, std::thread::hardware_concurrency()); }

/// make(k) for k = 0 … n − 1, on all cores; what the first throws that does is thrown. (Not by TBB,
/// which the Python package has no need of else.)
template <class Make>
void on_all_cores(std::size_t n, const Make& make) {
  std::atomic<std::size_t> next{0};
  std::mutex lock;
  std::exception_ptr failure;
  const auto work = [&] {
    try {
      for (std::size_t k = next++; k < n; k = next++) make(k);
    } catch (...) {
      const std::lock_guard guard(lock);
      if (!failure) failure = std::current_exception();
      next = n;
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t k = 1; k < std::min(n, cores()); ++k)
      others.emplace_back([&] {
        prepare_thread();
        work();
        release_caches();
      });
    work();
  }
  if (failure) std::rethrow_exception(failure);
}

/// All rows, several blocks at a time.
class RowStream {
 public:
  explicit RowStream(FrameRows& rows) : rows_(rows), blocks_(4 * cores()) {}

  /// Finds that all are there.
  WrittenRows check();
  /// Precondition: check().
  void write(Output& output, const RowFormat& format);

 private:
  template <class Make>
  void make_blocks(std::size_t first, const Make& make);
  /// So many rows are made at once, several blocks.
  std::size_t at_once() const { return blocks_.size() * FrameRows::block; }

  FrameRows& rows_;
  std::vector<Block> blocks_;
  std::map<std::size_t, std::vector<double>> exact_;
};

/// make(block, number of its first row, how many) for the blocks from row `first` on, at once.
template <class Make>
void RowStream::make_blocks(std::size_t first, const Make& make) {
  const auto make_one = [&](std::size_t b) {
    const std::size_t from = std::min(first + b * FrameRows::block, rows_.size());
    make(blocks_[b], from, std::min(FrameRows::block, rows_.size() - from));
  };
  if (first + FrameRows::block < rows_.size()) return on_all_cores(blocks_.size(), make_one);
  for (std::size_t b = 0; b < blocks_.size(); ++b) make_one(b);  // of which one has rows
}

WrittenRows RowStream::check() {
  WrittenRows found;
  Stage stage("rows", rows_.size());
  std::size_t done = 0;
  for (std::size_t first = 0; first < rows_.size(); first += at_once()) {
    make_blocks(first, [&](Block& block, std::size_t from, std::size_t count) {
      block.others = rows_.not_near(from, count);
    });
    for (const Block& block : blocks_)
      for (const std::size_t k : block.others) {
        exact_.emplace(k, rows_.exact(k).values);
        for (; done <= k; ++done) stage.advance();
        if (!rows_.reason().empty() && ++found.incomplete == 1) found.first_reason = rows_.reason();
      }
  }
  return found;
}

void RowStream::write(Output& output, const RowFormat& format) {
  output.write(format.header(rows_.empty_table().columns, rows_.size()));
  for (std::size_t first = 0; first < rows_.size(); first += at_once()) {
    make_blocks(first, [&](Block& block, std::size_t from, std::size_t count) {
      const std::span rows = std::span(block.rows).first(count);
      for (const std::size_t k : rows_.near(from, rows)) rows[k - from] = exact_.at(k);
      block.text.clear();
      for (const std::vector<double>& row : rows) format.append(block.text, row);
    });
    for (const Block& block : blocks_) output.write(block.text);
  }
}

}  // namespace

WrittenRows write_rows(const std::string& output, FrameRows& rows, const RowFormat& format) {
  RowStream stream(rows);
  const WrittenRows found = stream.check();
  Output file(output);
  stream.write(file, format);
  file.finish();
  return found;
}

}  // namespace phrame::cli
