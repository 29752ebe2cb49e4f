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

constexpr std::size_t block_rows = 1024;

/// Of so many rows that follow one another.
struct Block {
  std::vector<std::vector<double>> rows{block_rows};
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
  template <class Use>
  void make_rows(const Use& use);

  FrameRows& rows_;
  std::vector<Block> blocks_;
  std::map<std::size_t, std::vector<double>> exact_;
};

/// make(block, number of its first row, how many) for the blocks from row `first` on, at once.
template <class Make>
void RowStream::make_blocks(std::size_t first, const Make& make) {
  const auto make_one = [&](std::size_t b) {
    const std::size_t from = std::min(first + b * block_rows, rows_.size());
    make(blocks_[b], from, std::min(block_rows, rows_.size() - from));
  };
  if (first + block_rows < rows_.size()) return on_all_cores(blocks_.size(), make_one);
  for (std::size_t b = 0; b < blocks_.size(); ++b) make_one(b);  // of which one has rows
}

/// use(number of the first row) for the blocks from there on, with all rows but the others.
template <class Use>
void RowStream::make_rows(const Use& use) {
  for (std::size_t first = 0; first < rows_.size(); first += blocks_.size() * block_rows) {
    make_blocks(first, [&](Block& block, std::size_t from, std::size_t count) {
      block.others.clear();
      for (std::size_t k = 0; k < count; ++k)
        if (!rows_.near(from + k, block.rows[k])) block.others.push_back(from + k);
    });
    use(first);
  }
}

WrittenRows RowStream::check() {
  WrittenRows found;
  Stage stage("rows", rows_.size());
  std::size_t done = 0;
  make_rows([&](std::size_t) {
    for (const Block& block : blocks_)
      for (const std::size_t k : block.others) {
        exact_.emplace(k, rows_.exact(k).values);
        for (; done <= k; ++done) stage.advance();
        if (!rows_.reason().empty() && ++found.incomplete == 1) found.first_reason = rows_.reason();
      }
  });
  return found;
}

void RowStream::write(Output& output, const RowFormat& format) {
  output.write(format.header(rows_.empty_table().columns, rows_.size()));
  make_rows([&](std::size_t first) {
    make_blocks(first, [&](Block& block, std::size_t from, std::size_t count) {
      block.text.clear();
      for (const std::size_t k : block.others) block.rows[k - from] = exact_.at(k);
      for (std::size_t k = 0; k < count; ++k) format.append(block.text, block.rows[k]);
    });
    for (const Block& block : blocks_) output.write(block.text);
  });
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
