#include "reports/pages/sketch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>
#include <tuple>

#include "reports/base/record.hpp"
#include "reports/figures/gnuplot_text.hpp"
#include "reports/pages/pages.hpp"
#include "reports/pages/sketch_elements.hpp"

namespace talus::reports {
namespace {

using Side = SketchLabel::Side;

constexpr double text_high = 12.0;     // of a sketch: half a page [cm]
constexpr double border_width = 0.12;  // around all elements [cm]

/// In the site, where letters are larger than on paper; pandoc/pdf.lua divides by it.
constexpr double em_per_centimetre = 4.0;

/// What a keyword allows.
struct Grammar {
  const char* keyword;
  std::size_t minimum, maximum;  ///< how many numbers
  std::size_t angles;            ///< index of the first number that is not a length
  std::size_t labels;            ///< how many labels at most
  const char* flags;
  void (SketchDrawer::*draw)(const SketchElement&);
};

constexpr std::size_t many = 1000;
constexpr Grammar grammar[] = {
    {"disc", 3, 3, many, 1, "held ghost", &SketchDrawer::body},
    {"box", 4, 5, 4, 1, "held ghost", &SketchDrawer::body},
    {"superellipse", 5, 6, 4, 1, "held ghost", &SketchDrawer::body},
    {"polygon", 6, many, many, 1, "held ghost", &SketchDrawer::body},
    {"ground", 4, many, many, 1, "below", &SketchDrawer::ground},
    {"anchor", 2, 3, 2, 1, "", &SketchDrawer::anchor},
    {"pin", 2, 2, many, 1, "", &SketchDrawer::pin},
    {"centre", 2, 2, many, 1, "", &SketchDrawer::centre},
    {"dot", 2, 2, many, 1, "", &SketchDrawer::dot},
    {"cable", 4, many, many, 1, "dashed below", &SketchDrawer::line},
    {"line", 4, many, many, 1, "dashed below", &SketchDrawer::line},
    {"curve", 4, many, many, 1, "dashed below", &SketchDrawer::line},
    {"spring", 4, 4, many, 1, "below", &SketchDrawer::spring},
    {"dashpot", 4, 4, many, 1, "below", &SketchDrawer::dashpot},
    {"velocity", 4, 4, many, 1, "", &SketchDrawer::arrow},
    {"force", 4, 4, many, 1, "", &SketchDrawer::arrow},
    {"turn", 5, 5, 3, 1, "", &SketchDrawer::turn},
    {"dimension", 4, 4, many, 1, "below", &SketchDrawer::dimension},
    {"axes", 3, 3, many, 2, "", &SketchDrawer::axes},
    {"text", 2, 2, many, 1, "left right", &SketchDrawer::text},
};

bool takes_pairs(const Grammar& rule) { return rule.maximum == many; }

double number_of(const std::string& word, std::size_t line) {
  double value{};
  const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (failure != std::errc{} || end != word.data() + word.size() || !std::isfinite(value))
    throw RecordError(fmt::format("sketch, line {}: '{}' is not a number", line, word));
  return value;
}

/// The parts of a line. Numbers precede flags, flags precede labels.
SketchElement element_of(const std::string& text, std::size_t line) {
  SketchElement e;
  const std::size_t quote = text.find('"');
  std::istringstream tokens(text.substr(0, quote));
  tokens >> e.keyword;
  for (std::string word; tokens >> word;) {
    if (std::isalpha(static_cast<unsigned char>(word.front())) != 0) {
      e.flags.insert(word);
    } else {
      e.numbers.push_back(number_of(word, line));
    }
  }
  for (std::size_t begin = quote; begin != std::string::npos; begin = text.find('"', begin)) {
    const std::size_t end = text.find('"', begin + 1);
    if (end == std::string::npos) throw RecordError(fmt::format("sketch, line {}: a label does not end", line));
    e.labels.push_back(text.substr(begin + 1, end - begin - 1));
    begin = end + 1;
    const std::size_t rest = text.find_first_not_of(" ", begin);
    if (rest != std::string::npos && text[rest] != '"')
      throw RecordError(fmt::format("sketch, line {}: '{}' follows a label; only labels may", line, text.substr(rest)));
  }
  return e;
}

std::string keywords() {
  std::string all = "unit";
  for (const Grammar& rule : grammar)
    all += fmt::format(", {}", rule.keyword);
  return all;
}

const Grammar& rule_of(const SketchElement& e, std::size_t line) {
  const auto* const rule =
      std::ranges::find_if(grammar, [&](const Grammar& each) { return e.keyword == each.keyword; });
  if (rule == std::end(grammar))
    throw RecordError(fmt::format("sketch, line {}: unknown keyword '{}'; allowed: {}", line, e.keyword, keywords()));
  const std::size_t count = e.numbers.size();
  if (count < rule->minimum || count > rule->maximum || (takes_pairs(*rule) && count % 2 != 0)) {
    const std::string allowed = takes_pairs(*rule) ? fmt::format("{} or more, in pairs", rule->minimum)
                                : rule->minimum == rule->maximum
                                    ? fmt::format("{}", rule->minimum)
                                    : fmt::format("{} or {}", rule->minimum, rule->maximum);
    throw RecordError(fmt::format("sketch, line {}: {} has {} numbers; allowed: {}", line, e.keyword, count, allowed));
  }
  for (const std::string& flag : e.flags) {
    std::istringstream allowed(rule->flags);
    if (std::find(std::istream_iterator<std::string>(allowed), {}, flag) == std::istream_iterator<std::string>())
      throw RecordError(fmt::format("sketch, line {}: {} has no flag '{}'; allowed: {}", line, e.keyword, flag,
                                    *rule->flags == '\0' ? "none" : rule->flags));
  }
  for (const auto& [keyword, first, end] :
       {std::tuple{"disc", 2U, 3U}, {"box", 2U, 4U}, {"superellipse", 2U, 5U}, {"turn", 2U, 3U}, {"axes", 2U, 3U}}) {
    for (std::size_t i = first; e.keyword == keyword && i < end; ++i) {
      if (!(e.numbers[i] > 0.0))
        throw RecordError(fmt::format("sketch, line {}: number {} of {} is {}; it must be > 0", line, i + 1, e.keyword,
                                      e.numbers[i]));
    }
  }
  const bool text = e.keyword == "text", axes = e.keyword == "axes";
  if (e.labels.size() > rule->labels || (text && e.labels.empty()) || (axes && e.labels.size() != 2))
    throw RecordError(fmt::format("sketch, line {}: {} has {} labels; allowed: {}", line, e.keyword, e.labels.size(),
                                  text   ? "1"
                                  : axes ? "2"
                                         : "none or 1"));
  return *rule;
}

std::string stroke_commands(const Stroke& stroke, std::size_t number, std::string& plots) {
  std::string block = fmt::format("$stroke{} << END\n", number);
  for (const SketchPoint& point : stroke.points)
    block += fmt::format("{:.4f} {:.4f}\n", point.x, point.y);
  const auto add = [&](const std::string& style) {
    plots += fmt::format("{}$stroke{} with {} notitle", plots.empty() ? "" : ", ", number, style);
  };
  if (!stroke.fill.empty())
    add(fmt::format("filledcurves closed fillcolor rgb '{}' fillstyle solid noborder", stroke.fill));
  if (!stroke.colour.empty())
    add(fmt::format("lines lc rgb '{}' lw {:g}{}", stroke.colour, stroke.width, stroke.dashed ? " dt (6,4)" : ""));
  return block + "END\n";
}

}  // namespace

Sketch read_sketch(const std::string& text) {
  constexpr double far = 1e9;
  Sketch sketch{{}, {}, {far, far}, {-far, -far}};
  SketchDrawer drawer(sketch);
  double scale = 1.0;
  std::istringstream lines(text);
  std::string line;
  for (std::size_t number = 1; std::getline(lines, line); ++number) {
    const std::size_t first = line.find_first_not_of(" ");
    if (first == std::string::npos || line[first] == '#') continue;
    SketchElement e = element_of(line, number);
    if (e.keyword == "unit") {
      if (e.numbers.size() != 1 || !(e.numbers[0] > 0.0) || !e.flags.empty() || !e.labels.empty())
        throw RecordError(fmt::format("sketch, line {}: unit is followed by one number > 0 alone", number));
      scale = e.numbers[0];
      continue;
    }
    const Grammar& rule = rule_of(e, number);
    for (std::size_t i = 0; i < std::min(e.numbers.size(), rule.angles); ++i)
      e.numbers[i] *= scale;
    (drawer.*rule.draw)(e);
  }
  if (sketch.strokes.empty() && sketch.labels.empty()) throw RecordError("sketch: it has no element");
  sketch.low = sketch.low - SketchPoint{border_width, border_width};
  sketch.high = sketch.high + SketchPoint{border_width, border_width};
  const double wide = sketch.high.x - sketch.low.x;
  if (wide > text_wide)
    throw RecordError(fmt::format("sketch: it is {:.1f} cm wide; at most {} cm are allowed (unit)", wide, text_wide));
  const double high = sketch.high.y - sketch.low.y;
  if (high > text_high)
    throw RecordError(fmt::format("sketch: it is {:.1f} cm high; at most {} cm are allowed (unit)", high, text_high));
  return sketch;
}

std::string sketch_script(const Sketch& sketch, const Canvas& canvas, const std::string& stem) {
  const SketchPoint size = sketch.high - sketch.low;
  std::string text = fmt::format("load {}\n", gnuplot_quoted(canvas.preamble.string()));
  text += fmt::format(
      "unset border\nunset tics\nunset grid\nset margins screen 0,screen 1,screen 0,screen 1\n"
      "set xrange [{:.4f}:{:.4f}]\nset yrange [{:.4f}:{:.4f}]\n",
      sketch.low.x, sketch.high.x, sketch.low.y, sketch.high.y);
  std::string plots;
  for (std::size_t i = 0; i < sketch.strokes.size(); ++i)
    text += stroke_commands(sketch.strokes[i], i + 1, plots);
  if (plots.empty()) plots = "NaN notitle";  // labels alone
  for (const SketchLabel& label : sketch.labels) {
    const char* const side = label.side == Side::left ? "left" : label.side == Side::right ? "right" : "center";
    text += fmt::format("set label {} at {:.4f},{:.4f} {} front{} textcolor rgb '{}'\n", gnuplot_text(label.text),
                        label.at.x, label.at.y, side, label.boxed ? " boxed" : "", label.colour);
  }
  Canvas own = canvas;
  own.width = size.x;
  return text + drawn_in_each_format(own, stem, "plot " + plots, size.y, {0.42, 10.0});
}

std::vector<PageSketch> page_sketches(const std::string& page) {
  static const std::string fence = "```", opening = "```sketch";
  std::vector<PageSketch> found;
  for (std::size_t at = 0; at < page.size();) {
    const std::size_t line_end = std::min(page.find('\n', at), page.size());
    if (page.compare(at, fence.size(), fence) != 0) {
      at = line_end + 1;
      continue;
    }
    const std::size_t close = page.find("\n" + fence, at);
    if (close == std::string::npos) throw RecordError("page: a code block does not end");
    const std::size_t end = close + 1 + fence.size();
    if (page.compare(at, opening.size(), opening) == 0) {
      const std::size_t title = page.find_first_not_of(" ", at + opening.size());
      if (title >= line_end)
        throw RecordError(fmt::format("page: the line '{}' has no alternative text for its sketch", opening));
      found.push_back(
          {at, end, page.substr(title, line_end - title), read_sketch(page.substr(line_end + 1, close - line_end))});
    }
    at = end;
  }
  return found;
}

std::string sketch_stem(const std::string& case_id, std::size_t index) {
  return fmt::format("{}-sketch-{}", case_id, index + 1);
}

std::string with_sketch_pictures(const std::string& page, const std::string& case_id) {
  std::string text;
  std::size_t from = 0, index = 0;
  for (const PageSketch& sketch : page_sketches(page)) {
    std::string title = sketch.title;
    std::erase(title, '"');
    text += page.substr(from, sketch.begin - from);
    const double wide = em_per_centimetre * (sketch.drawing.high.x - sketch.drawing.low.x);
    text += fmt::format("![](figures/{}.svg){{.sketch alt=\"{}\" width={:.2f}em}}", sketch_stem(case_id, index++),
                        title, wide);
    from = sketch.end;
  }
  return text + page.substr(from);
}

}  // namespace talus::reports
