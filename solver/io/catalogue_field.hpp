#pragma once

#include <string>
#include <vector>

#include "solver/base/dimension.hpp"

namespace talus {

/// How the value of a field is written in a file.
enum class FieldForm {
  quantity,      ///< a quantity in quotes; without dimension a bare number
  vector,        ///< [x, y] of quantities
  point,         ///< [x, y] or [x, y, z] of quantities
  pairs,         ///< [[first, second], ..] of quantities
  whole,         ///< a whole number
  wholes,        ///< an array of whole numbers
  one_or_two,    ///< a whole number, or two in an array: one for each body
  text,          ///< a text in quotes
  two_texts,     ///< an array of two texts
  name,          ///< one of a closed list of names, in quotes
  names,         ///< an array of such names
  table,         ///< a table
  table_or_off,  ///< a table, or "off"
  tables,        ///< an array of tables
  time_or_auto,  ///< a quantity in quotes, or "auto"
};

/// One field of a scene, fence or cell file.
struct CatalogueField {
  std::string name{};
  std::string meaning{};  ///< one line
  FieldForm form{FieldForm::quantity};
  Dimension dimension{};             ///< of a quantity, the components of a vector or point, or the first of a pair
  Dimension second{};                ///< of the second of a pair
  std::string range{};               ///< allowed values: "> 0", "1 .. 1000"; empty: all
  std::vector<std::string> names{};  ///< the closed list
  std::string absent{};              ///< default value; empty: none
  bool required{};                   ///< always, or if the conditions below hold
  std::string condition{};           ///< "if it can turn": when it is required or, if optional, allowed
  std::string alternative{};         ///< field that may replace it; one of the two is required
  std::string with{};                ///< field that requires it or, if it is optional, that it requires; empty: none
  std::string with_value{};          ///< value that this other field must have; empty: any
};

/// The fields of one kind of table.
struct FieldGroup {
  std::string id{};    ///< unique: "contact hertz"
  std::string head{};  ///< as written in a file: `[[contact]] law = "hertz"`
  std::string about{};
  std::string base{};  ///< id of a group whose fields it also has; empty: none
  std::vector<CatalogueField> fields{};
};

}  // namespace talus
