#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "phrame/algebra/rational.hpp"

namespace phrame::inline v0 {

// Files of ISO 10303-21, "STEP": instances of entities, "#12=CIRCLE('',#3,5.);", that refer to each
// other by their numbers. What an entity means is not known here.

/// A parameter of an entity.
struct Part21Value {
  enum class Kind { number, reference, word, text, list, typed, none };
  Kind kind;
  /// As written: a number, that of an instance, a word without its points, a text without its
  /// quotes, or the name of the type. none is $ or *.
  std::string_view text;
  std::vector<Part21Value> items = {};  ///< of a list or a type
};

/// A name and its parameters.
struct Part21Entity {
  std::string_view name;
  std::vector<Part21Value> values;
  long instance;  ///< its number
  long line;      ///< where the instance begins

  /// @{ Throws InputError with the line, which names the instance and the entity.
  [[noreturn]] void fail(const std::string& reason) const;
  const Part21Value& at(std::size_t k, Part21Value::Kind kind, const char* what) const;
  Rational number(const Part21Value& value) const;
  Rational number(std::size_t k, const char* what) const;
  std::vector<Rational> numbers(std::size_t k, const char* what) const;
  long whole_number(const Part21Value& value, long most) const;
  long whole_number(std::size_t k, long most, const char* what) const;
  long reference(std::size_t k, const char* what) const;
  std::vector<long> references(std::size_t k, const char* what) const;
  bool flag(std::size_t k, const char* what) const;  ///< .T. or .F.
  /// @}
};

/// Does the text begin as such a file?
bool is_part21(std::string_view text);

/// The instances of a file, which is read when they are asked for. Refers to the text.
class Part21File {
 public:
  /// Throws InputError with the line of a statement that has no end, or a number that was there.
  explicit Part21File(std::string_view text);

  /// The name of an entity, empty where the instance has several.
  struct Entry {
    std::string_view name;
    std::string_view body;  ///< behind the "="
    long line;
  };
  const std::map<long, Entry>& entries() const { return entries_; }

  /// The entities of an instance: one, or of a complex one several. Throws InputError with the line
  /// where there is none of this number, asked for by `from`, and where it is not as it should be.
  std::vector<Part21Entity> instance(long number, const Part21Entity& from) const;
  /// An instance of `entries()`.
  std::vector<Part21Entity> instance(long number) const;

 private:
  std::map<long, Entry> entries_;
};

/// The entity of this name among those of an instance, or null.
const Part21Entity* find_entity(const std::vector<Part21Entity>& entities, std::string_view name);

}  // namespace phrame
