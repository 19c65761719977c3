#include "tests/mutants/operators.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace talus::mutants {

namespace {

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return "";
  return std::string(text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1));
}

/// The text in one line, so that the lines of the source keep their numbers; nothing if it contains a comment.
std::optional<std::string> one_line(std::string text) {
  if (text.find("//") != std::string::npos || text.find("/*") != std::string::npos) return std::nullopt;
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

bool is_integer(const Node& node) {
  switch (node.type_kind()) {
    case CXType_Bool:
    case CXType_Enum:
      return false;
    case CXType_Double:
    case CXType_Float:
      return false;
    default:
      return node.type_kind() >= CXType_Char_U && node.type_kind() <= CXType_Int128;
  }
}

bool is_dependent(const Node& node) {
  return node.type_kind() == CXType_Dependent || node.type_kind() == CXType_Unexposed ||
         node.type_kind() == CXType_Invalid;
}

/// True for numbers and vectors of numbers, which can be added and multiplied; false for texts, iterators and paths.
bool is_number(const Node& node) {
  if (is_integer(node) || is_dependent(node)) return true;
  if (node.type_kind() == CXType_Double || node.type_kind() == CXType_Float || node.type_kind() == CXType_Vector ||
      node.type_kind() == CXType_ExtVector)
    return true;
  const std::string type = node.type();
  return type.find("std::") == std::string::npos && type.find('*') == std::string::npos &&
         (type.find("talus::") != std::string::npos || type.find("Eigen::") != std::string::npos);
}

/// Pairs of names that are easily confused: two bodies, two directions, two times.
const std::map<std::string, std::string>& partners() {
  static const std::map<std::string, std::string> both = [] {
    std::map<std::string, std::string> names;
    for (const auto& [one, other] :
         std::initializer_list<std::pair<const char*, const char*>>{{"a", "b"},
                                                                    {"i", "j"},
                                                                    {"x", "y"},
                                                                    {"first", "second"},
                                                                    {"before", "after"},
                                                                    {"previous", "current"},
                                                                    {"old", "now"},
                                                                    {"start", "finish"},
                                                                    {"from", "to"},
                                                                    {"low", "high"},
                                                                    {"min", "max"},
                                                                    {"normal", "tangent"},
                                                                    {"share_a", "share_b"},
                                                                    {"position", "velocity"},
                                                                    {"q", "v"},
                                                                    {"extent", "extent_rate"},
                                                                    {"front", "back"},
                                                                    {"sin", "cos"},
                                                                    {"left", "right"},
                                                                    {"mass", "inertia"},
                                                                    {"stiffness", "damping"},
                                                                    {"loading", "unloading"},
                                                                    {"upper", "lower"},
                                                                    {"body_a", "body_b"},
                                                                    {"last", "next"},
                                                                    {"begin", "end"},
                                                                    {"radius_a", "radius_b"},
                                                                    {"arm_a", "arm_b"}}) {
      names[one] = other;
      names[other] = one;
    }
    return names;
  }();
  return both;
}

/// Functions whose arguments may be swapped without effect.
bool is_symmetric(const std::string& function) {
  static const std::set<std::string> names{"min", "max", "dot", "hypot", "swap", "norm", "same_as", "minmax"};
  return names.count(function) > 0;
}

class Search {
 public:
  Search(const Source& source, std::string file) : source_{source}, file_{std::move(file)} {}

  std::vector<Mutant> found() {
    for (const Node& node : source_.top().children()) {
      if (node.in_main_file()) visit(node, false);
    }
    std::stable_sort(mutants_.begin(), mutants_.end(), [](const Mutant& a, const Mutant& b) {
      return a.edits[0].begin != b.edits[0].begin ? a.edits[0].begin < b.edits[0].begin
                                                  : a.edits[0].end > b.edits[0].end;
    });
    name_all();
    return std::move(mutants_);
  }

 private:
  [[nodiscard]] std::string text(const Node& node) const { return std::string(source_.text(node.extent())); }

  void add(const char* operation, Extent extent, Form form, const std::string& replacement) {
    const auto line = one_line(replacement);
    if (!line || extent.size() == 0) return;
    const std::string old = trimmed(source_.text(extent));
    if (old == *line) return;
    if (source_.text(extent).find("//") != std::string_view::npos) return;
    mutants_.push_back({.operation = operation, .edits = {{file_, extent.begin, extent.end, form, *line}}});
  }
  void express(const char* operation, const Node& node, const std::string& replacement) {
    add(operation, node.extent(), Form::expression, replacement);
  }

  /// Sets the ids FILE:LINE:COLUMN:OPERATION, with a number if there are several.
  void name_all() {
    std::map<std::string, int> used;
    for (Mutant& mutant : mutants_) {
      const std::size_t at = mutant.edits[0].begin;
      const std::string& all = source_.text();
      const auto line = 1 + std::count(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(at), '\n');
      const std::size_t start = at == 0 ? 0 : all.rfind('\n', at - 1) + 1;
      const std::string id = fmt::format("{}:{}:{}:{}", file_, line, at - start + 1, mutant.operation);
      const int count = ++used[id];
      mutant.id = count == 1 ? id : fmt::format("{}:{}", id, count);
    }
  }

  // --- Traversal -----------------------------------------------------------------------------------------------------
  /// True for declarations of constants and other code that the compiler evaluates.
  [[nodiscard]] bool is_constant(const Node& node) const {
    switch (node.kind()) {
      case CXCursor_EnumDecl:
      case CXCursor_StaticAssert:
      case CXCursor_TypedefDecl:
      case CXCursor_TypeAliasDecl:
      case CXCursor_TypeAliasTemplateDecl:
      case CXCursor_CXXThrowExpr:
      case CXCursor_TemplateTypeParameter:
      case CXCursor_NonTypeTemplateParameter:
      case CXCursor_TypeRef:
      case CXCursor_TemplateRef:
      case CXCursor_NamespaceRef:
        return true;
      case CXCursor_VarDecl: {
        const std::string code = text(node);
        return code.substr(0, code.find(node.name())).find("constexpr") != std::string::npos;
      }
      case CXCursor_UnexposedDecl:
        return text(node).find("concept ") != std::string::npos;
      default:
        return source_.text(node.extent()).starts_with("__builtin_shufflevector(");
    }
  }

  void collect_names(const Node& node) {
    if (node.kind() == CXCursor_VarDecl || node.kind() == CXCursor_ParmDecl) names_[node.name()] = node.type();
    for (const Node& child : node.children())
      collect_names(child);
  }

  void visit(const Node& node, bool as_statement) {
    if (is_constant(node)) return;
    switch (node.kind()) {
      case CXCursor_FunctionDecl:
      case CXCursor_FunctionTemplate:
      case CXCursor_CXXMethod:
      case CXCursor_Constructor:
      case CXCursor_ConversionFunction:
        names_.clear();
        collect_names(node);
        break;
      default:
        break;
    }
    const Node bare = node.bare();
    if (as_statement) drop_statement(bare);
    change(bare);
    const auto children = bare.children();
    for (std::size_t i = 0; i < children.size(); ++i) {
      if (bare.kind() == CXCursor_IfStmt && i == 0 && text(bare).substr(0, 14).find("constexpr") != std::string::npos)
        continue;
      if (bare.kind() == CXCursor_CaseStmt && i == 0) continue;
      visit(children[i], is_statement(bare, i, children.size()));
    }
  }

  /// True if child `i` is a statement of its parent.
  static bool is_statement(const Node& parent, std::size_t i, std::size_t count) {
    switch (parent.kind()) {
      case CXCursor_CompoundStmt:
        return true;
      case CXCursor_IfStmt:
        return i > 0;
      case CXCursor_ForStmt:
      case CXCursor_WhileStmt:
      case CXCursor_CXXForRangeStmt:
        return i + 1 == count;
      default:
        return false;
    }
  }

  // --- Operations ---------------------------------------------------------------------------------------------------
  void change(const Node& node) {
    switch (node.kind()) {
      case CXCursor_BinaryOperator:
        return change_binary(node);
      case CXCursor_CompoundAssignOperator:
        return change_assignment(node);
      case CXCursor_UnaryOperator:
        return change_unary(node);
      case CXCursor_ConditionalOperator:
        return change_choice(node);
      case CXCursor_FloatingLiteral:
        return change_number(node);
      case CXCursor_IntegerLiteral:
        return change_integer(node);
      case CXCursor_CallExpr:
        return change_call(node);
      case CXCursor_InitListExpr:
        return swap_arguments(node, node.children());
      case CXCursor_MemberRefExpr:
        return change_member(node);
      case CXCursor_DeclRefExpr:
        return change_name(node);
      default:
        return;
    }
  }

  /// The operator between two operands; empty if there is other text between them.
  [[nodiscard]] std::string operator_between(const Node& left, const Node& right) const {
    const Extent a = left.extent();
    const Extent b = right.extent();
    if (a.size() == 0 || b.size() == 0 || a.end > b.begin) return "";
    return trimmed(source_.text({a.end, b.begin}));
  }

  void change_binary(const Node& node) {
    const auto operands = node.children();
    if (operands.size() == 2) change_operation(node, operands[0], operands[1]);
  }

  void change_operation(const Node& node, const Node& left, const Node& right) {
    const std::string token = operator_between(left, right);
    const std::string a = text(left);
    const std::string b = text(right);
    const bool sums = is_number(node) && is_number(left) && is_number(right);
    const auto with = [&](const char* other) { return fmt::format("{} {} {}", a, other, b); };
    if (token == "+" && sums) {
      express("sign", node, with("-"));
      express("dropped_term", node, a);
      express("dropped_term", node, b);
    } else if (token == "-" && sums) {
      express("sign", node, with("+"));
      express("dropped_term", node, a);
    } else if (token == "*" && sums) {
      // A number in place of a vector does not compile.
      const auto fits = [&](const Node& factor) {
        return factor.type_kind() != CXType_Double || node.type_kind() == CXType_Double || is_dependent(node);
      };
      if (fits(left)) express("unit_factor", node, a);
      if (fits(right)) express("unit_factor", node, b);
    } else if (token == "/" && sums) {
      express("unit_factor", node, a);
    } else if (token == "<" || token == "<=" || token == ">" || token == ">=") {
      const bool edge_counts = (is_integer(left.bare()) && is_integer(right.bare())) || b == "0.0" || a == "0.0";
      if (edge_counts)
        express("comparison_edge", node, with(token.size() == 1 ? (token + "=").c_str() : token.substr(0, 1).c_str()));
      express("negated_condition", node, fmt::format("!({})", text(node)));
    } else if (token == "==") {
      express("negated_condition", node, with("!="));
    } else if (token == "!=") {
      express("negated_condition", node, with("=="));
    } else if (token == "&&" || token == "||") {
      express("dropped_condition", node, a);
      express("dropped_condition", node, b);
    }
  }

  void change_assignment(const Node& node) {
    const auto operands = node.children();
    if (operands.size() != 2 || !is_number(operands[0])) return;
    const std::string token = operator_between(operands[0], operands[1]);
    const auto with = [&](const char* other) {
      return fmt::format("{} {} {}", text(operands[0]), other, text(operands[1]));
    };
    if (token == "+=") express("sign", node, with("-="));
    if (token == "-=") express("sign", node, with("+="));
    if (token == "+=" || token == "-=") express("missing_sum", node, with("="));
  }

  void change_unary(const Node& node) {
    const auto operand = node.children();
    if (operand.size() != 1) return;
    const std::string code = text(node);
    const std::string inner = text(operand[0]);
    if (code.starts_with("-") && is_number(node)) express("sign", node, inner);
    if (code.starts_with("!")) express("negated_condition", node, fmt::format("static_cast<bool>({})", inner));
  }

  void change_choice(const Node& node) {
    const auto parts = node.children();
    if (parts.size() != 3) return;
    express("dropped_condition", node, text(parts[1]));
    express("dropped_condition", node, text(parts[2]));
  }

  void change_number(const Node& node) {
    const std::string code = text(node);
    const double value = std::strtod(code.c_str(), nullptr);
    if (std::abs(value) < 1e-6 || std::abs(value) > 1e15) return;
    express("factor", node, fmt::format("1.1 * {}", code));
  }

  void change_integer(const Node& node) {
    const Extent extent = node.extent();
    if (extent.size() == 0) return;
    // Not template arguments, sizes of arrays and index 0 (element 1 may not exist).
    const std::string& all = source_.text();
    const char before = extent.begin > 0 ? all[extent.begin - 1] : ' ';
    const char after = extent.end < all.size() ? all[extent.end] : ' ';
    if (before == '<' || after == '>' || before == '[' || before == '\'' || after == '\'') return;
    const std::string code = text(node);
    if (code.find_first_not_of("0123456789uUlLzZ") != std::string::npos) return;
    const std::string digits = code.substr(0, code.find_first_not_of("0123456789"));
    if (digits.size() > 6) return;
    const std::string suffix = code.substr(digits.size());
    const long value = std::strtol(digits.c_str(), nullptr, 10);
    express("off_by_one", node, fmt::format("{}{}", value == 1 ? 0 : value + 1, suffix));
  }

  void change_call(const Node& node) {
    const std::string function = node.name();
    const auto children = node.children();
    if (function.starts_with("operator")) {
      if (children.size() == 3) {
        change_operation_of_call(node, children);
      } else if (children.size() == 2 && function == "operator-") {
        const Node& operand = children[0].extent().size() == 1 ? children[1] : children[0];
        express("sign", node, text(operand));
      }
      return;
    }
    if (is_symmetric(function) || children.size() < 3) return;
    swap_arguments(node, {children.begin() + 1, children.end()});
  }

  /// The children of an overloaded operator's call are its two operands and its name, in any order.
  void change_operation_of_call(const Node& node, std::vector<Node> children) {
    std::sort(children.begin(), children.end(),
              [](const Node& a, const Node& b) { return a.extent().begin < b.extent().begin; });
    const Node* left = &children[0];
    const Node* right = &children[2];
    if (left->extent().end > right->extent().begin) return;
    change_operation(node, *left, *right);
  }

  /// Swaps adjacent arguments of the same type whose texts differ.
  void swap_arguments(const Node& whole, const std::vector<Node>& arguments) {
    const Extent all = whole.extent();
    for (std::size_t i = 0; i + 1 < arguments.size(); ++i) {
      const Extent a = arguments[i].extent();
      const Extent b = arguments[i + 1].extent();
      if (a.size() == 0 || b.size() == 0 || a.begin < all.begin || b.end > all.end || a.end >= b.begin) continue;
      if (is_dependent(arguments[i].bare()) || arguments[i].bare().type() != arguments[i + 1].bare().type()) continue;
      const std::string one(source_.text(a));
      const std::string other(source_.text(b));
      if (one == other || one.starts_with(".") || other.starts_with(".") || one.starts_with("{") ||
          other.starts_with("{") || one.starts_with("[") || other.starts_with("["))
        continue;
      const std::string between(source_.text({a.end, b.begin}));
      if (trimmed(between) != ",") continue;
      if (whole.kind() == CXCursor_InitListExpr) {
        // Swaps the two arguments by separate edits: an initialiser list is not an expression.
        mutants_.push_back({.operation = "swapped_argument",
                            .edits = {{file_, a.begin, a.end, Form::expression, other},
                                      {file_, b.begin, b.end, Form::expression, one}}});
        continue;
      }
      express("swapped_argument", whole,
              std::string(source_.text({all.begin, a.begin})) + other + between + one +
                  std::string(source_.text({b.end, all.end})));
    }
  }

  void change_member(const Node& node) {
    const std::string name = node.name();
    const auto partner = partners().find(name);
    if (partner == partners().end()) return;
    const std::string code = text(node);
    if (!code.ends_with(name)) return;
    const Node member = node.referenced();
    if (member.is_null() || member.kind() == CXCursor_InvalidFile || !has_sibling(member, partner->second)) return;
    express("other_of_pair", node, code.substr(0, code.size() - name.size()) + partner->second);
  }

  static bool has_sibling(const Node& member, const std::string& name) {
    for (const Node& other : member.owner().children()) {
      if (other.name() == name && other.type() == member.type() && other.kind() == member.kind()) return true;
    }
    return false;
  }

  void change_name(const Node& node) {
    const auto partner = partners().find(node.name());
    if (partner == partners().end() || text(node) != node.name()) return;
    const auto mine = names_.find(node.name());
    const auto other = names_.find(partner->second);
    if (mine == names_.end() || other == names_.end() || mine->second != other->second) return;
    express("other_of_pair", node, partner->second);
  }

  /// Removes an assignment, a call for its effect, or a jump.
  void drop_statement(const Node& node) {
    const auto children = node.children();
    switch (node.kind()) {
      case CXCursor_BinaryOperator:
        if (children.size() != 2 || operator_between(children[0], children[1]) != "=") return;
        break;
      case CXCursor_CompoundAssignOperator:
      case CXCursor_ContinueStmt:
      case CXCursor_BreakStmt:
        break;
      case CXCursor_UnaryOperator: {
        const std::string code = text(node);
        if (code.find("++") == std::string::npos && code.find("--") == std::string::npos) return;
        break;
      }
      case CXCursor_ReturnStmt:
        if (!children.empty()) return;
        break;
      case CXCursor_CallExpr: {
        static const std::set<std::string> without_effect{"reserve", "shrink_to_fit", "assert"};
        if (without_effect.count(node.name()) > 0) return;
        break;
      }
      default:
        return;
    }
    Extent extent = node.extent();
    if (extent.size() == 0) return;
    const std::size_t semicolon = source_.text().find_first_not_of(" \n", extent.end);
    if (semicolon == std::string::npos || source_.text()[semicolon] != ';') return;
    extent.end = semicolon + 1;
    add("missing_statement", extent, Form::statement, "");
  }

  const Source& source_;
  std::string file_;
  std::map<std::string, std::string> names_;  ///< Variables and parameters of the function, with their types.
  std::vector<Mutant> mutants_;
};

}  // namespace

const std::vector<Operation>& operations() {
  static const std::vector<Operation> all{
      {"sign", "+ for -, - for +, or a minus left out"},
      {"dropped_term", "a sum without one of its terms"},
      {"unit_factor", "a product or quotient without one of its factors"},
      {"factor", "a number 10 % too large"},
      {"missing_sum", "= for += or -="},
      {"off_by_one", "an integer larger by one (one: 0)"},
      {"comparison_edge", "< for <=, > for >=, or the reverse"},
      {"negated_condition", "a condition turned round"},
      {"dropped_condition", "one side of && or ||, or one branch of a choice, for all"},
      {"swapped_argument", "two neighbouring arguments of one type in the wrong order"},
      {"other_of_pair", "the other body, the other direction, the other time level"},
      {"missing_statement", "an assignment, update, reset, call or jump left out"},
  };
  return all;
}

std::vector<Mutant> mutants_of(const Source& source, const std::string& file) { return Search(source, file).found(); }

}  // namespace talus::mutants
