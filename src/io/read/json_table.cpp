#include "phrame/io/read/json_table.hpp"

#include <fmt/format.h>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/column_name.hpp"
#include "phrame/io/write/text.hpp"

namespace phrame::inline v0 {
namespace {

using Kind = JsonNode::Kind;

/// Of a row of numbers, or of lists of them.
std::size_t width_of(const JsonNode& row) {
  std::size_t width = 0;
  for (std::size_t k = 0; k < row.size(); ++k)
    width += row.item(k).is(Kind::array) ? row.item(k).size() : 1;
  return width;
}

}  // namespace

bool is_frame_table(const JsonNode& node) {
  if (!node.is(Kind::object)) return false;
  const auto format = node.find("phrame");
  return format && format->is(Kind::string) && format->string() == "frames/1";
}

JsonNode JsonTable::list() const {
  const JsonNode whole(document_);
  return is_frame_table(whole) ? whole.at("rows") : whole;
}

JsonTable::JsonTable(JsonValue document) : document_(std::move(document)) {
  const JsonNode list = this->list();
  list.require(Kind::array, "a list of rows");
  if (list.size() == 0) list.fail("the list is empty");
  const JsonNode first = list.item(0);
  const Kind kind = first.is(Kind::object) ? Kind::object : Kind::array;
  for (std::size_t k = 0; k < list.size(); ++k)
    list.item(k).require(kind, k == 0 ? "a row" : "a row like the first");
  if (first.is(Kind::array))
    lay_out_lists(list);
  else
    lay_out_objects(first);
  if (columns_.empty()) first.fail("the row is empty");
  if (!is_frame_table(JsonNode(document_))) return;
  const JsonNode names = JsonNode(document_).at("columns");
  names.require(Kind::array, "an array of names");
  if (names.size() != columns_.size())
    names.fail(fmt::format("{} for rows of {}", counted(names.size(), "name"), columns_.size()));
  for (std::size_t k = 0; k < names.size(); ++k) names_.push_back(names.item(k).string());
}

void JsonTable::lay_out_lists(const JsonNode& list) {
  const JsonNode first = list.item(0);
  for (std::size_t k = 0; k < first.size(); ++k) {
    const JsonNode item = first.item(k);
    if (!item.is(Kind::array))
      columns_.push_back({{"", k}});
    else
      for (std::size_t j = 0; j < item.size(); ++j) columns_.push_back({{"", k}, {"", j}});
  }
  for (std::size_t row = 0; row < list.size(); ++row)
    if (const std::size_t width = width_of(list.item(row)); width != columns_.size())
      list.item(row).fail(fmt::format("{} here, but {} in the first row", counted(width, "number"),
                                      columns_.size()));
}

void JsonTable::lay_out_objects(const JsonNode& first) {
  const auto add = [&](const std::string& name, Steps steps) {
    ColumnName column = column_name(name);
    names_.push_back(std::move(column.name));
    units_.push_back(std::move(column.unit));
    columns_.push_back(std::move(steps));
  };
  for (const std::string& key : first.keys()) {
    const JsonNode member = first.at(key);
    if (member.is(Kind::object))
      for (const std::string& inner : member.keys()) add(key + "." + inner, {{key}, {inner}});
    else if (member.is(Kind::array) && (member.size() == 2 || member.size() == 3))
      for (std::size_t k = 0; k < member.size(); ++k)
        add(fmt::format("{}.{}", key, "xyz"[k]), {{key}, {"", k}});
    else
      add(key, {{key}});
  }
}

std::optional<JsonNode> JsonTable::find(std::size_t row, std::size_t column) const {
  std::optional<JsonNode> node = list().item(row);
  for (const Step& step : columns_[column]) {
    if (!step.key.empty() && node->is(Kind::object))
      node = node->find(step.key);
    else if (step.key.empty() && node->is(Kind::array) && step.index < node->size())
      node = node->item(step.index);
    else
      return std::nullopt;
    if (!node) return std::nullopt;
  }
  return node;
}

std::string JsonTable::place(std::size_t row) const { return list().item(row).place(); }

std::string JsonTable::place_in_row(std::size_t row, std::size_t column,
                                    std::string_view name) const {
  const auto node = find(row, column);
  return node ? node->place() : NumberTable::place_in_row(row, column, name);
}

Rational JsonTable::number(std::size_t row, std::size_t column) const {
  const auto node = find(row, column);
  if (!node) throw InputError("there is no number");
  try {
    return node->number();
  } catch (const InputError& error) {
    throw InputError(error.reason());
  }
}

bool JsonTable::is_missing(std::size_t row, std::size_t column) const {
  const auto node = find(row, column);
  if (!node || node->is(Kind::null)) return true;
  return node->is(Kind::string) && is_missing_text(node->text());
}

}  // namespace phrame
