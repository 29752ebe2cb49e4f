#pragma once
#include <optional>

#include "phrame/io/read/json_node.hpp"
#include "phrame/io/read/number_table.hpp"

namespace phrame::inline v0 {

/// Is it a frames/1?
bool is_frame_table(const JsonNode& node);

/// A table in JSON: a list of rows. Each is a list of numbers, or of lists of them, as a matrix is;
/// or an object, whose keys are the columns: those of the first row. A member that is an object has
/// columns "position.x", and so has a list of two or three numbers. Members that are missing or
/// null are no numbers. Or an object frames/1, as phrame frames writes it, with the names of the
/// columns beside the rows.
class JsonTable : public NumberTable {
 public:
  /// Throws InputError for what is no such list, or has no row, and for rows of unequal widths; its
  /// place is a JSON pointer.
  explicit JsonTable(JsonValue document);

  std::string header_place() const override { return list().item(0).place(); }
  std::size_t rows() const override { return list().size(); }
  std::size_t columns() const override { return columns_.size(); }
  std::string place(std::size_t row) const override;
  std::string place_in_row(std::size_t row, std::size_t column,
                           std::string_view name) const override;
  using NumberTable::number;
  Rational number(std::size_t row, std::size_t column) const override;
  bool is_missing(std::size_t row, std::size_t column) const override;

 private:
  /// Where a number is within its row: at a key or an index, perhaps within what is there.
  struct Step {
    std::string key;
    std::size_t index = 0;
  };
  using Steps = std::vector<Step>;
  JsonNode list() const;
  void lay_out_lists(const JsonNode& list);
  void lay_out_objects(const JsonNode& first);
  std::optional<JsonNode> find(std::size_t row, std::size_t column) const;

  JsonValue document_;
  std::vector<Steps> columns_;
};

}  // namespace phrame
