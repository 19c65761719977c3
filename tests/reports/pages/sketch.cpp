#include "reports/pages/sketch.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "reports/base/record.hpp"
#include "reports/pages/pages.hpp"

BOOST_AUTO_TEST_SUITE(sketch_tests)

using namespace talus::reports;

namespace {

/// One line for each keyword of the language.
const std::vector<std::string> every_keyword{
    "disc 0 0 0.5 \"m\"",
    "box 0 0 1 2 30 \"m\"",
    "superellipse 0 0 1 0.5 4 \"m\"",
    "polygon 0 0 1 0 0 1 \"m\"",
    "ground 0 0 2 0 \"g\"",
    "anchor 0 0 \"A\"",
    "pin 0 0 \"P\"",
    "centre 0 0 \"G\"",
    "dot 0 0 \"P\"",
    "cable 0 0 1 0 2 1 \"T\"",
    "spring 0 0 1 0 \"k\"",
    "dashpot 0 0 1 0 \"c\"",
    "line 0 0 1 0 \"l\"",
    "curve 0 0 1 1 2 0 \"y\"",
    "velocity 0 0 1 0 \"v\"",
    "force 0 0 0 1 \"F\"",
    "turn 0 0 1 0 90 \"w\"",
    "dimension 0 0 2 0 \"L\"",
    "axes 0 0 1 \"x\" \"y\"",
    "text 0 0 left \"t\"",
};

std::string error_of(const std::string& text) {
  try {
    (void)read_sketch(text);
  } catch (const RecordError& wrong) {
    return wrong.what();
  }
  return "no error";
}

std::string error_of_page(const std::string& page) {
  try {
    (void)page_sketches(page);
  } catch (const RecordError& wrong) {
    return wrong.what();
  }
  return "no error";
}

double width(const Sketch& sketch) { return sketch.high.x - sketch.low.x; }

}  // namespace

BOOST_AUTO_TEST_CASE(every_keyword_draws_its_label_within_the_limits) {
  for (const std::string& line : every_keyword) {
    const Sketch sketch = read_sketch(line);
    BOOST_TEST_INFO(line);
    BOOST_TEST(!sketch.labels.empty());
    BOOST_TEST((!sketch.strokes.empty() || line.starts_with("text")));
    for (const Stroke& stroke : sketch.strokes) {
      BOOST_TEST(stroke.points.size() >= 2U);
      BOOST_TEST((!stroke.fill.empty() || !stroke.colour.empty()));
      for (const SketchPoint& point : stroke.points)
        BOOST_TEST(
            (point.x > sketch.low.x && point.x < sketch.high.x && point.y > sketch.low.y && point.y < sketch.high.y));
    }
    for (const SketchLabel& label : sketch.labels)
      BOOST_TEST((label.at.x > sketch.low.x && label.at.x < sketch.high.x));
  }
}

BOOST_AUTO_TEST_CASE(shapes_are_where_they_are_said_to_be) {
  const auto inside = [](const Stroke& stroke, double x, double y) {  // crossings of a ray
    bool in = false;
    for (std::size_t i = 0; i + 1 < stroke.points.size(); ++i) {
      const SketchPoint a = stroke.points[i], b = stroke.points[i + 1];
      if ((a.y > y) != (b.y > y) && x < a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x)) in = !in;
    }
    return in;
  };
  const Stroke disc = read_sketch("disc 1 2 0.5").strokes.at(0);
  for (const SketchPoint& point : disc.points)
    BOOST_TEST(std::hypot(point.x - 1, point.y - 2) == 0.5, boost::test_tools::tolerance(1e-12));
  const Stroke box = read_sketch("box 1 0 4 1 90").strokes.at(0);
  BOOST_TEST(inside(box, 1.4, 1.9));
  BOOST_TEST(!inside(box, 1.6, 0.0));
  const Stroke tilted = read_sketch("superellipse 0 0 2 0.2 20 45").strokes.at(0);
  BOOST_TEST(inside(tilted, 1.2, 1.2));
  BOOST_TEST(!inside(tilted, 1.2, -1.2));
  // Hatching is to the right of the direction: below a surface drawn from left to right.
  BOOST_TEST(read_sketch("ground 0 0 3 0").low.y < -0.2);
  BOOST_TEST(read_sketch("ground 0 0 3 0").high.y < 0.2);
  BOOST_TEST(read_sketch("ground 3 0 0 0").high.y > 0.2);
  // A support is in the given direction from its point, by default above.
  BOOST_TEST(read_sketch("anchor 0 0").high.y > 0.4);
  BOOST_TEST(read_sketch("anchor 0 0 270").low.y < -0.4);
  const Sketch curve = read_sketch("curve 0 0 1 1 2 0");
  const auto passes = [&](double x, double y) {
    return std::ranges::any_of(curve.strokes.at(0).points,
                               [&](SketchPoint p) { return std::hypot(p.x - x, p.y - y) < 1e-12; });
  };
  BOOST_TEST((passes(0, 0) && passes(1, 1) && passes(2, 0)));
}

BOOST_AUTO_TEST_CASE(labels_are_beside_what_they_name) {
  BOOST_TEST(read_sketch("velocity 0 0 2 0 \"v\"").labels.at(0).at.x > 2.0);
  BOOST_TEST(read_sketch("force 0 0 0 -2 \"F\"").labels.at(0).at.y < -2.0);
  BOOST_TEST(read_sketch("cable 0 0 2 0 \"T\"").labels.at(0).at.y > 0.0);
  BOOST_TEST(read_sketch("cable 0 0 2 0 below \"T\"").labels.at(0).at.y < 0.0);
  const SketchLabel within = read_sketch("dimension 0 0 3 0 \"L\"").labels.at(0);
  BOOST_TEST((within.boxed && within.at.y == 0.0));
  const SketchLabel beside = read_sketch("dimension 0 0 0.5 0 \"long label\"").labels.at(0);
  BOOST_TEST((!beside.boxed && beside.at.y > 0.1));
}

BOOST_AUTO_TEST_CASE(flags_change_the_line) {
  const Stroke body = read_sketch("disc 0 0 1").strokes.at(0), held = read_sketch("disc 0 0 1 held").strokes.at(0),
               ghost = read_sketch("disc 0 0 1 ghost").strokes.at(0);
  BOOST_TEST((!body.fill.empty() && !held.fill.empty() && body.fill != held.fill && ghost.fill.empty()));
  BOOST_TEST((ghost.dashed && !body.dashed && !held.dashed));
  BOOST_TEST(read_sketch("line 0 0 1 0 dashed").strokes.at(0).dashed);
}

BOOST_AUTO_TEST_CASE(unit_scales_lengths_but_not_angles) {
  const std::vector<SketchPoint> large = read_sketch("unit 2\nbox 1 0 2 2 10").strokes.at(0).points;
  const std::vector<SketchPoint> small = read_sketch("box 1 0 2 2 10").strokes.at(0).points;
  for (std::size_t i = 0; i < small.size(); ++i)
    BOOST_TEST(large[i].x == 2.0 * small[i].x, boost::test_tools::tolerance(1e-12));
  const std::vector<SketchPoint> flat = read_sketch("unit 3\nsuperellipse 0 0 1 1 2").strokes.at(0).points;
  BOOST_TEST(std::hypot(flat[5].x, flat[5].y) == 3.0, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(errors_name_line_and_what_is_allowed) {
  BOOST_TEST(
      error_of("disc 0 0 1\n\ndisk 0 0 1").starts_with("sketch, line 3: unknown keyword 'disk'; allowed: unit, disc"));
  BOOST_TEST(error_of("disc 0 0") == "sketch, line 1: disc has 2 numbers; allowed: 3");
  BOOST_TEST(error_of("box 0 0 1 1 1 1") == "sketch, line 1: box has 6 numbers; allowed: 4 or 5");
  BOOST_TEST(error_of("line 0 0 1 1 2") == "sketch, line 1: line has 5 numbers; allowed: 4 or more, in pairs");
  BOOST_TEST(error_of("disc 0 0 1x") == "sketch, line 1: '1x' is not a number");
  BOOST_TEST(error_of("disc 0 0 1 dashed") == "sketch, line 1: disc has no flag 'dashed'; allowed: held ghost");
  BOOST_TEST(error_of("pin 0 0 held") == "sketch, line 1: pin has no flag 'held'; allowed: none");
  BOOST_TEST(error_of("disc 0 0 1 \"m") == "sketch, line 1: a label does not end");
  BOOST_TEST(error_of("disc 0 0 1 \"m\" held") == "sketch, line 1: 'held' follows a label; only labels may");
  BOOST_TEST(error_of("disc 0 0 1 \"m\" \"n\"") == "sketch, line 1: disc has 2 labels; allowed: none or 1");
  BOOST_TEST(error_of("text 0 0") == "sketch, line 1: text has 0 labels; allowed: 1");
  BOOST_TEST(error_of("axes 0 0 1 \"x\"") == "sketch, line 1: axes has 1 labels; allowed: 2");
  BOOST_TEST(error_of("unit 0\ndisc 0 0 1") == "sketch, line 1: unit is followed by one number > 0 alone");
  BOOST_TEST(error_of("turn 0 0 0 0 90") == "sketch, line 1: number 3 of turn is 0; it must be > 0");
  BOOST_TEST(error_of("superellipse 0 0 1 1 -2") == "sketch, line 1: number 5 of superellipse is -2; it must be > 0");
  BOOST_TEST(error_of("box 0 0 1 12") == "sketch: it is 12.2 cm high; at most 12 cm are allowed (unit)");
  BOOST_TEST(error_of("# nothing\n") == "sketch: it has no element");
  BOOST_TEST(error_of("box 0 0 18 1") == "sketch: it is 18.2 cm wide; at most 17.4 cm are allowed (unit)");
}

BOOST_AUTO_TEST_CASE(script_draws_a_unit_as_a_centimetre) {
  const Sketch sketch = read_sketch("box 0 0 4 2 \"k_n, \\omega\"");
  const std::string script = sketch_script(sketch, {"/p/preamble.gp", "/out", {"pdf"}}, "stem");
  BOOST_TEST(script.find("size 4.24cm,2.24cm") != std::string::npos);
  BOOST_TEST(script.find("set xrange [-2.1200:2.1200]") != std::string::npos);
  BOOST_TEST(script.find("'k_{n}, ω'") != std::string::npos);
  BOOST_TEST(script.find("/out/stem.pdf") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(sketches_of_a_page_become_pictures) {
  const std::string page =
      "Text.\n\n```sketch A \"round\" disc\ndisc 0 0 1\n```\n\n```\ncode\n```\n\n```sketch A box\nbox 0 0 1 "
      "1\n```\nEnd.\n";
  const std::vector<PageSketch> sketches = page_sketches(page);
  BOOST_TEST(sketches.size() == 2U);
  BOOST_TEST(sketches[1].title == "A box");
  const std::string width_of_disc = "8.96";
  BOOST_TEST(std::abs(width(sketches[0].drawing) - 2.24) < 1e-9);
  BOOST_TEST(with_sketch_pictures(page, "c") ==
             "Text.\n\n![](figures/c-sketch-1.svg){.sketch alt=\"A round disc\" width=" + width_of_disc +
                 "em}\n\n```\ncode\n```\n\n![](figures/c-sketch-2.svg){.sketch alt=\"A box\" width=4.96em}\nEnd.\n");
  BOOST_TEST(sketch_stem("c", 1) == "c-sketch-2");
  BOOST_TEST(error_of_page("```sketch\ndisc 0 0 1\n```\n") ==
             "page: the line '```sketch' has no alternative text for its sketch");
  BOOST_TEST(error_of_page("```sketch A disc\ndisc 0 0 1\n") == "page: a code block does not end");
  BOOST_TEST(error_of_page("```\n") == "page: a code block does not end");
}

BOOST_AUTO_TEST_SUITE_END()
