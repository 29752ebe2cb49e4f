#include "phrame/cli/row_stream.hpp"

#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <map>

#include "phrame/algebra/progress.hpp"
#include "phrame/cli/command.hpp"

namespace phrame::cli {
namespace {

constexpr std::size_t block_rows = 1024;

/// Of so many rows that follow one another.
struct Block {
  std::vector<std::vector<double>> rows{block_rows};
  std::vector<std::size_t> others;  ///< those that doubles are not enough for
  std::string text;
};

/// All rows, several blocks at a time.
class RowStream {
 public:
  explicit RowStream(FrameRows& rows)
      : rows_(rows),
        blocks_(4 * static_cast<std::size_t>(oneapi::tbb::info::default_concurrency())) {}

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
  if (first + block_rows < rows_.size())
    return oneapi::tbb::parallel_for(std::size_t{0}, blocks_.size(), make_one);
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
