#include "solver/io/file/list_directed.hpp"

#include <algorithm>
#include <charconv>

#include "solver/base/error.hpp"

namespace talus {

bool ListDirected::take_line() {
  if (rest_.empty()) return false;
  const std::size_t end = std::min(rest_.find('\n'), rest_.size());
  left_ = rest_.substr(0, end);
  rest_.remove_prefix(std::min(end + 1, rest_.size()));
  if (!left_.empty() && left_.back() == '\r') left_.remove_suffix(1);
  ++line_;
  return true;
}

std::string_view ListDirected::whole_line() {
  if (!take_line()) throw InputError{"the file ends here; a line is missing"};
  return left_;
}

int ListDirected::next_line() const {
  int line = line_ + 1;
  for (std::string_view rest = rest_; !rest.empty(); ++line) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    if (rest.substr(0, end).find_first_not_of(" \t\r") != std::string_view::npos) return line;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return 0;
}

void ListDirected::start_record() {
  left_ = {};
  static_cast<void>(take_line());
  comma_ = true;
  repeats_ = 0;
}

void ListDirected::skip_separators() {
  for (;;) {
    const std::size_t at = std::min(left_.find_first_not_of(" \t"), left_.size());
    left_.remove_prefix(at);
    if (left_.empty()) {
      if (!take_line()) throw InputError{"the file ends here; a value is missing"};
    } else if (left_.front() == ',') {
      if (comma_) throw InputError{"found a comma where a value is due (a null value); write the value"};
      comma_ = true;
      left_.remove_prefix(1);
    } else if (left_.front() == '/') {
      throw InputError{"found \"/\", which ends the record; a value is missing"};
    } else {
      return;
    }
  }
}

std::string_view ListDirected::token() {
  skip_separators();
  const std::size_t end = std::min(left_.find_first_of(" \t,/"), left_.size());
  const std::string_view text = left_.substr(0, end);
  left_.remove_prefix(end);
  comma_ = false;
  return text;
}

std::string_view ListDirected::value() {
  if (repeats_ > 0) {
    --repeats_;
    return repeated_;
  }
  const std::string_view text = token();
  const std::size_t star = text.find('*');
  if (star == std::string_view::npos || text.find_first_not_of("0123456789") != star || star == 0) return text;
  const auto [end, error] = std::from_chars(text.data(), text.data() + star, repeats_);
  repeated_ = text.substr(star + 1);
  if (error != std::errc{} || end != text.data() + star || repeats_ == 0 || repeated_.empty()) {
    const std::string found{text.substr(0, 40)};
    throw InputError{"found \"" + found + "\"; a repeat is written r*value with r > 0"};
  }
  --repeats_;
  return repeated_;
}

}  // namespace talus
