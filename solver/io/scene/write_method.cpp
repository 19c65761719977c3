#include "solver/io/scene/write_method.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "solver/base/error.hpp"
#include "solver/io/file/quantity_text.hpp"
#include "solver/io/scene/read_fence.hpp"
#include "solver/io/scene/read_scene.hpp"
#include "solver/io/scene/write_fence.hpp"

namespace talus {
namespace {

/// Offset of a source position in the text: toml++ counts lines and, in a line, code points from 1.
std::size_t offset(std::string_view text, toml::source_position position) {
  std::size_t at = 0;
  for (toml::source_index line = 1; line < position.line; ++line)
    at = text.find('\n', at) + 1;
  for (toml::source_index column = 1; column < position.column && at < text.size(); ++column) {
    do
      ++at;
    while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U);
  }
  return at;
}

std::size_t line_start(std::string_view text, std::size_t at) {
  const std::size_t before = text.substr(0, at).rfind('\n');
  return before == std::string_view::npos ? 0 : before + 1;
}

/// Location of a key of [run] in the text.
struct KeySpan {
  std::size_t key{}, begin{}, end{};  ///< start of the key, start and end of its value
};

std::optional<KeySpan> span_of(std::string_view text, const toml::table& run, std::string_view wanted) {
  for (const auto& [key, value] : run) {
    if (key.str() == wanted)
      return KeySpan{offset(text, key.source().begin), offset(text, value.source().begin),
                     offset(text, value.source().end)};
  }
  return {};
}

/// [run] of a parsed file. (A copy of a table loses its source positions.)
const toml::table& run_of(const toml::table& document) { return *document["run"].as_table(); }

/// Removes a key and its value: its whole line, or from an inline table with one comma.
void take_out(std::string& text, std::string_view key) {
  const toml::table document = toml::parse(text);
  const toml::table& run = run_of(document);
  const auto span = span_of(text, run, key);
  if (!span) return;
  if (!run.is_inline()) {
    const std::size_t from = line_start(text, span->key), after = text.find('\n', span->end);
    text.erase(from, after == std::string::npos ? after : after + 1 - from);
    return;
  }
  const std::size_t next = text.find_first_not_of(" \t", span->end);
  if (text[next] == ',') {
    text.erase(span->key, text.find_first_not_of(" \t", next + 1) - span->key);
  } else {
    const std::size_t comma = text.rfind(',', span->key);
    text.erase(comma, span->end - comma);
  }
}

/// Whether [run] has a key.
bool has(std::string_view text, std::string_view key) {
  const toml::table document = toml::parse(text);
  return run_of(document).contains(key);
}

void put(std::string& text, std::string_view key, const std::string& value) {
  const toml::table document = toml::parse(text);
  const toml::table& run = run_of(document);
  if (const auto span = span_of(text, run, key)) {
    text.replace(span->begin, span->end - span->begin, value);
    return;
  }
  // Inserted after the integrator, or otherwise after the end, which is always present; on a line of the same form,
  // including a leading "run." and blanks.
  const auto integrator = span_of(text, run, "integrator");
  const KeySpan beside = integrator ? *integrator : span_of(text, run, "end").value();
  const std::size_t start = line_start(text, beside.key);
  const std::string front =
      run.is_inline() ? ", " : fmt::format("\n{}", std::string_view{text}.substr(start, beside.key - start));
  const std::size_t end_of_line = std::min(text.find_first_of("\r\n", beside.end), text.size());
  text.insert(run.is_inline() ? beside.end : end_of_line, fmt::format("{}{} = {}", front, key, value));
}

std::string changed_text(const Scene& wanted, std::string text, std::string_view name) {
  try {
    const double tolerance = talus::tolerance(wanted.integrator);
    put(text, "integrator", fmt::format("\"{}\"", talus::name(wanted.integrator)));
    const std::string step =
        fmt::format("\"{} s\"", decimal(wanted.plan.step, "s", dimension::time, wanted.model.units).text);
    put(text, "step", step);
    // with_method() raises an interval that is shorter than the new step.
    if (wanted.plan.interval == wanted.plan.step && has(text, "interval")) put(text, "interval", step);
    if (tolerance == 0.0) {
      take_out(text, "tolerance");
    } else {
      put(text, "tolerance", fmt::format("{}", tolerance));
    }
    const Scene read = read_scene(text, name);
    if (talus::name(read.integrator) == talus::name(wanted.integrator) &&
        talus::tolerance(read.integrator) == tolerance && read.plan.step == wanted.plan.step &&
        read.plan.end == wanted.plan.end && read.title == wanted.title)
      return text;
  } catch (const toml::parse_error&) {
  } catch (const InputError&) {
  }
  throw InputError{
      fmt::format("{}: run: its keys cannot be changed as they are written; write them below a head [run], "
                  "each on a separate line",
                  name)};
}

/// The count among `new_steps` steps whose time is nearest to that of `count` among `steps`; at least 1.
long at_same_time(long count, long steps, long new_steps) {
  return std::max(
      1L, std::lround(static_cast<double>(count) * static_cast<double>(new_steps) / static_cast<double>(steps)));
}

}  // namespace

scenes::Fence fence_with_method(const FenceInput& input, const RunMethod& method) {
  scenes::Fence fence = input.fence;
  const double end = input.made.scene.plan.end - input.made.scene.initial.t;
  fence.steps = method.steps;
  fence.step_factor = end / static_cast<double>(method.steps) / input.made.critical_step;
  fence.print_every = at_same_time(input.fence.print_every, input.fence.steps, method.steps);
  fence.history_every = at_same_time(input.fence.history_every, input.fence.steps, method.steps);
  fence.options.integrator = method.integrator;
  fence.options.tolerance = method.tolerance;
  fence.options.start = scenes::FenceStart::plain;
  return fence;
}

std::string text_with_method(const SceneFile& file, std::string_view text, std::string_view name,
                             const RunMethod& method, std::string_view comment) {
  std::string changed = file.fence ? write_fence(fence_with_method(*file.fence, method))
                                   : changed_text(with_method(file.scene, method), std::string{text}, name);
  if (!changed.empty() && changed.back() != '\n') changed += '\n';
  return fmt::format("{}# {}\n", changed, comment);
}

}  // namespace talus
