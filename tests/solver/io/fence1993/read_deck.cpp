#include "solver/io/fence1993/read_deck.hpp"

#include <boost/test/unit_test.hpp>

#include "solver/base/error.hpp"
#include "solver/io/fence1993/write_deck.hpp"
#include "solver/io/file/toml_document.hpp"

BOOST_AUTO_TEST_SUITE(read_deck_tests)

using namespace talus;
using scenes::ElementSolid;
using scenes::ElementType;
using scenes::Fence;

namespace {

std::filesystem::path sample() { return std::filesystem::path{TALUS_CASES} / "fence" / "sample2.DAT"; }

/// The sample with `part` replaced.
std::string changed(std::string_view part, std::string_view replacement) {
  std::string text = read_text(sample());
  const std::size_t at = text.find(part);
  BOOST_REQUIRE(at != std::string::npos);
  return text.replace(at, part.size(), replacement);
}

std::string message_of(std::string_view text) {
  try {
    static_cast<void>(read_deck(text, "s.DAT"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// The message of the sample with `part` replaced.
std::string message(std::string_view part, std::string_view replacement) {
  return message_of(changed(part, replacement));
}

Fence with(std::string_view part, std::string_view replacement) {
  return read_deck(changed(part, replacement), "s.DAT");
}

constexpr std::string_view layers =
    "span, sag, dcol, young, y_top, y_bot, nocab, ncol, ecoeff, area_top, area_bot, frict, slack, brek_top, brek_bot: ";

}  // namespace

// Compared with the listing of Mustoe & Huttelmaier 1993, II.5.1; 1 lb/in^2 = 144 lb/ft^2.
BOOST_AUTO_TEST_CASE(sample_of_the_manual) {
  const Fence f = read_deck(sample());
  BOOST_TEST(f.title == "DOUBLE LAYER FENCE\tROCK WEIGHT = 1200 LBS");
  BOOST_TEST((f.units == us));
  BOOST_TEST((f.step_factor == 0.0 && f.steps == 3000 && f.print_every == 60 && f.history_every == 30));
  BOOST_TEST((f.penetration == 0.05 && f.gravity_sign == -1 && f.gravity == 32.18));
  BOOST_TEST((f.history_elements == std::vector<int>{2, 3, 4, 5, 6}));
  BOOST_TEST((f.history_codes == std::vector<int>{51, 52, 48, 6, 7, 8, 35, 36}));
  BOOST_TEST((f.ground.type == ElementType::rock && f.ground.solid == ElementSolid::block && f.ground.points == 2));
  BOOST_TEST((f.ground.a == 10.0 && f.ground.b == 0.5 && f.ground.density == 0.1 && f.ground.bar_length == 0.5));
  BOOST_TEST((f.ground.position == Vec2{0.0, -5.0} && f.ground.held == std::array<bool, 3>{true, true, true}));
  BOOST_REQUIRE(f.rocks.size() == 1U);
  const scenes::FenceElement& rock = f.rocks.front();
  BOOST_TEST((rock.solid == ElementSolid::ellipsoid && rock.points == 4 && rock.a == 1.201 && rock.b == 1.201));
  BOOST_TEST((rock.density == 5.13 && rock.position == Vec2{2.451, 0.0} && rock.velocity == Vec2{-65.0, 0.0}));
  BOOST_TEST((rock.spin == 34.0 && rock.held == std::array<bool, 3>{}));
  BOOST_TEST((f.column.type == ElementType::column && f.column.solid == ElementSolid::cylinder));
  BOOST_TEST((f.column.a == 1.25 && f.column.b == 4.0 && f.column.density == 0.76 && f.column.bar_length == 2.67));
  BOOST_TEST((f.span == 55.0 && f.sag == 5.5 && f.spacing == 2.5 && f.young == 2e7 * 144.0));
  BOOST_TEST((f.y_top == 6.67 && f.y_bottom == -4.0 && f.connections == 2 && f.columns == 13));
  BOOST_TEST((f.restitution == 0.4 && f.area_top == 1.076 / 144.0 && f.area_bottom == 0.25 / 144.0));
  BOOST_TEST((f.friction == 0.0 && f.slack == 0.5 && f.limit_top == 1e8 && f.limit_bottom == 1e8));
  BOOST_TEST((f.layers == 2 && f.layer_spacing == 2.6 && f.rock_overlap == 0.6 && f.layer_overlap == 0.5));
  BOOST_TEST((f.options == scenes::FenceOptions{}));
}

BOOST_AUTO_TEST_CASE(ways_to_write_the_same) {
  const Fence sound = read_deck(sample());
  BOOST_TEST((with("2.0e7", "2.0D7") == sound));
  BOOST_TEST((with("2.0e7", "+.2d+08") == sound));
  BOOST_TEST((with("13 0.4", "13.0\n0.4") == sound));
  BOOST_TEST((with("0. 0. 0.\txc", "3*0.\txc") == sound));
  BOOST_TEST((with("2, 2.6", "2 , 2.6") == sound));
  BOOST_TEST((with("8\ttotvar", "8 / totvar") == sound));
  BOOST_TEST((with("*****", "anything\n after the end") == sound));
  std::string crlf;
  for (const char c : read_text(sample()))
    crlf += c == '\n' ? std::string{"\r\n"} : std::string{c};
  BOOST_TEST((read_deck(crlf, "s.DAT") == sound));
  BOOST_TEST((read_deck(write_deck(sound), "s.DAT") == sound));
}

// READ(iin,*) (variab(i),i=1,hvmax): codes beyond totvar are dropped; an empty list still takes a line.
BOOST_AUTO_TEST_CASE(histories) {
  BOOST_TEST((with("8\ttotvar", "2\ttotvar").history_codes == std::vector<int>{51, 52}));
  const Fence none = with("5\telstore\n2,3,4,5,6", "0\telstore\n");
  BOOST_TEST(none.history_elements.empty());
  BOOST_TEST((read_deck(write_deck(none), "s.DAT") == none));
  BOOST_TEST(write_deck(none).find("\n51 52 48 6 7 8 35 36 0\t") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(wrong_numbers) {
  const std::string prefix = "s.DAT:20: " + std::string{layers};
  BOOST_TEST(message("2.0e7", "abc") == prefix + "young: found \"abc\"; it must be a number > 0");
  BOOST_TEST(message("2.0e7", "-2.0e7") == prefix + "young: found \"-2.0e7\"; it must be a number > 0");
  BOOST_TEST(message("2.0e7", "1e999") ==
             prefix + "young: found \"1e999\"; the number is too large or too small for a double");
  BOOST_TEST(message("2.0e7", "1e308") == prefix + "young: found \"1e308\"; the number is too large");
  BOOST_TEST(message("2.0e7", "nan") == prefix + "young: found \"nan\"; it must be a number > 0");
  BOOST_TEST(message("6.67", "inf") == prefix + "y_top: found \"inf\"; it must be a number");
  BOOST_TEST(message("6.67", "6.67ft") == prefix + "y_top: found \"6.67ft\"; it must be a number");
  BOOST_TEST(message("0.4 1.076", "1.5 1.076") == prefix + "ecoeff: found \"1.5\"; it must be a number in (0, 1]");
  BOOST_TEST(message("0.4 1.076", "0 1.076") == prefix + "ecoeff: found \"0\"; it must be a number in (0, 1]");
  BOOST_TEST(message("0.25 0.0", "-0.25 0.0") == prefix + "area_bot: found \"-0.25\"; it must be a number > 0");
  BOOST_TEST(message("0.5 1e8", "-0.5 1e8") == prefix + "slack: found \"-0.5\"; it must be a number >= 0");
  BOOST_TEST(message("1e8 1e8", "0 1e8") == prefix + "brek_top: found \"0\"; it must be a number > 0");
  BOOST_TEST(message("2 13", "3 13") == prefix + "nocab: found \"3\"; it must be 1 or 2");
  BOOST_TEST(message("2 13", "2 0") == prefix + "ncol: found \"0\"; it must be a whole number between 1 and 1000");
  BOOST_TEST(message("0.0 3000", "-1 3000") ==
             "s.DAT:2: fact_dt, niter, nprint, nhisto, f_penet: fact_dt: found \"-1\"; it must be a number >= 0");
  BOOST_TEST(
      message("3000", "30.5") ==
      "s.DAT:2: fact_dt, niter, nprint, nhisto, f_penet: niter: found \"30.5\"; it must be a whole number between "
      "1 and 1000000000");
  BOOST_TEST(
      message("0.0 0.76", "1.1 0.76") ==
      "s.DAT:17: element 3: xlen, ylen, power, rho, barlen: power: found \"1.1\"; it must be a number in [0, 1]");
  BOOST_TEST(message("1.0 1.0 1.0 0.", "1.0 2 1.0 0.") ==
             "s.DAT:11: element 1: bc(1), bc(2), bc(3), xfix, yfix: bc(2): found \"2\"; it must be 0 or 1");
  BOOST_TEST(message("2, 2.6", "3, 2.6") == "s.DAT:21: no_fence, sp_fence: no_fence: found \"3\"; it must be 1 or 2");
  BOOST_TEST(
      message("0.0 1.0 2.0", "0.0 1.0 1.0") ==
      "s.DAT:8: element 1: type, shape, points: points: found \"1.0\"; it must be a whole number between 2 and 1000");
}

BOOST_AUTO_TEST_CASE(missing_values) {
  const std::string text = read_text(sample());
  BOOST_TEST(message_of(text.substr(0, text.find("0.6, 0.5"))) ==
             "s.DAT:21: rf_overlap, ff_overlap: rf_overlap: the file ends here; a value is missing");
  BOOST_TEST(message_of("") == "s.DAT:1: title: the file ends here; a line is missing");
  BOOST_TEST(message_of("T\n0 10 1 1") ==
             "s.DAT:2: fact_dt, niter, nprint, nhisto, f_penet: f_penet: the file ends here; a value is missing");
  BOOST_TEST(message("3 -1 32.18", "3 -1") ==
             "s.DAT:3: nel, igrav, grav: grav: found \"nel\"; it must be a number > 0");
  BOOST_TEST(message("2,3,4", "2,,4") ==
             "s.DAT:5: elno(2): found a comma where a value is due (a null value); write the value");
  BOOST_TEST(message("3 -1", "3 /") ==
             "s.DAT:3: nel, igrav, grav: igrav: found \"/\", which ends the record; a value is missing");
}

// Wherever a deck is truncated, and whichever value is not a number, a message gives the position; only the record of
// the last value may lose the rest of its line.
BOOST_AUTO_TEST_CASE(every_value_is_needed) {
  const std::string text = write_deck(read_deck(sample()));
  const std::size_t last = text.rfind("0.5\trf_overlap");
  for (std::size_t size = 0; size <= last; ++size)
    BOOST_TEST(message_of(text.substr(0, size)).rfind("s.DAT:", 0) == 0U);
  BOOST_TEST(message_of(text.substr(0, last + 3)) == "no error");

  int line = 2;
  int values = 0;
  bool data = true;
  for (std::size_t at = text.find('\n') + 1; at < text.size(); ++at) {
    if (text[at] == '\t') data = false;
    if (text[at] == '\n') {
      ++line;
      data = true;
    }
    const bool starts = data && text[at] > ' ' && text[at - 1] <= ' ';
    if (!starts || text.compare(at, 3, "0\tv") == 0) continue;  // the last code is beyond totvar
    ++values;
    const std::string message = message_of(text.substr(0, at) + "x" + text.substr(at));
    BOOST_TEST(message.rfind("s.DAT:" + std::to_string(line) + ": ", 0) == 0U);
    BOOST_TEST(message.find("found \"x") != std::string::npos);
  }
  // 5 control, 3 + 1 + 5 + 1 + 8, three elements of 3 + 5 + 9 + 5, and 15 + 2 + 2.
  BOOST_TEST(values == 5 + 3 + 1 + 5 + 1 + 8 + 3 * 22 + 15 + 2 + 2);
}

BOOST_AUTO_TEST_CASE(elements_and_their_count) {
  BOOST_TEST(message("3 -1", "2 -1") ==
             "s.DAT:3: nel, igrav, grav: nel: found \"2\"; it must be a whole number between 3 and 1002");
  BOOST_TEST(
      message("3 -1", "4 -1") ==
      "s.DAT:16: element 3: type, shape, points: type: found 1; with nel = 4 this element must be 0, a rock, since "
      "it is between the ground and the column; does nel count the elements below?");
  const std::string text = read_text(sample());
  const std::size_t rock = text.find("0.0 0.0 4.0");
  const std::string lines = text.substr(rock, text.find("1.0 2.0 2.0") - rock);
  BOOST_TEST(
      message("0.0 0.0 4.0", lines + "0.0 0.0 4.0") ==
      "s.DAT:16: element 3: type, shape, points: type: found 0; with nel = 3 this element must be 1, the column, "
      "since it is the last; does nel count the elements below?");
  BOOST_TEST(message("0.0 1.0 2.0", "1.0 2.0 2.0") ==
             "s.DAT:8: element 1: type, shape, points: type: found 1; with nel = 3 this element must be 0, the ground, "
             "since it is the first; does nel count the elements below?");
  BOOST_TEST(message("0.0 1.0 2.0", "2.0 1.0 2.0") ==
             "s.DAT:8: element 1: type, shape, points: type: found \"2.0\"; it must be 0 or 1");
  BOOST_TEST(
      message("0.0 0.0 4.0", "0.0 3.0 4.0") ==
      "s.DAT:12: element 2: type, shape, points: shape: found \"3.0\"; it must be a whole number between 0 and 2");
  BOOST_TEST(
      message("0.0 0.0 4.0", "0.0 2.0 4.0") ==
      "s.DAT:12: element 2: type, shape, points: shape: found 2 (cylinder); it must be 0 (ellipsoid) or 1 (block) "
      "for the ground and rocks");
  BOOST_TEST(message("1.0 2.0 2.0", "1.0 1.0 2.0") ==
             "s.DAT:16: element 3: type, shape, points: shape: found 1 (block); it must be 2 (cylinder) for a column");
}

BOOST_AUTO_TEST_CASE(records_that_do_not_fit_each_other) {
  BOOST_TEST(message("3 -1", "3 0") == "s.DAT:3: nel, igrav, grav: igrav: found 0; it must be 1 or -1");
  BOOST_TEST(message("2 13", "2 23") ==
             "s.DAT:20: " + std::string{layers} +
                 "ncol: found 23: 2.5 ft apart they take 55 ft; it must be less than the span, "
                 "55 ft");
  BOOST_TEST(message("6.67", "-4") ==
             "s.DAT:20: " + std::string{layers} + "y_top: found -4 ft; it must be above the bottom joint, -4 ft");
  BOOST_TEST(message("2, 2.6", "2, 0") ==
             "s.DAT:21: no_fence, sp_fence: sp_fence: found 0; it must be > 0 for two layers");
  BOOST_TEST(message("8\ttotvar", "9\ttotvar") ==
             "s.DAT:6: totvar: found \"9\"; it must be a whole number between 0 and 8");
  BOOST_TEST(message("51 52", "51 62") == "s.DAT:7: variab: found 62; it must be in 1 .. 61");
  // Two layers of 7 columns and a fixed end each, ground and one rock: 18 elements.
  BOOST_TEST((with("5,6", "5,18").history_elements.back() == 18));
  BOOST_TEST(message("5,6", "5,19") ==
             "s.DAT:5: elno: found 19; it must be in 1 .. 18: the ground, the rocks (1), then for each layer half its "
             "columns and a fixed end");
  BOOST_TEST(
      message("0.0 -5.0 0.0 0.0 0.0 0.0", "0.0 -5.0 0.0 0.0 0.0 1.0") ==
      "s.DAT:10: element 1: xcent, ycent, theta, vx, vy, omega, fx, fy, mz: omega: found 1 as spin; it must be 0, "
      "since this motion is held");
}

// What is found only when the fence is built is reported at its record, too.
BOOST_AUTO_TEST_CASE(fences_that_cannot_be_built) {
  const auto built = [](std::string_view part, std::string_view replacement) {
    const std::string text = changed(part, replacement);
    const Fence fence = read_deck(text, "s.DAT");
    try {
      static_cast<void>(deck_scene(fence, text, "s.DAT"));
    } catch (const InputError& error) {
      return std::string{error.what()};
    }
    return std::string{"no error"};
  };
  BOOST_TEST(built("30 0.05", "30 1e-200") ==
             "s.DAT:2: fact_dt, niter, nprint, nhisto, f_penet: f_penet: found 1e-200; the contact stiffness of a mass "
             "of 37.225 that stops from 65 within 1.201e-200 is inf; it must be > 0 and finite");
  BOOST_TEST(
      built("0.6, 0.5", "1e-200, 0.5").starts_with("s.DAT:22: rf_overlap, ff_overlap: rf_overlap: found 1e-200; "));
  BOOST_TEST(
      built("0.6, 0.5", "0.6, 1e200").starts_with("s.DAT:22: rf_overlap, ff_overlap: ff_overlap: found 1e+200; "));
  BOOST_TEST(built("-65.", "0.") ==
             "s.DAT:14: element 2: xcent, ycent, theta, vx, vy, omega, fx, fy, mz: vx, vy: no rock moves; one must, "
             "since the contact stiffnesses follow from its speed");
  BOOST_TEST(built("1.0 1.0 1.0 0. 0.", "1.0 0.0 1.0 0. 0.").starts_with("s.DAT:11: element 1: bc(1), bc(2), bc(3), "));
  BOOST_TEST(built("0.6, 0.5", "0.6, 0.5") == "no error");
}

BOOST_AUTO_TEST_CASE(titles) {
  BOOST_TEST(with("DOUBLE LAYER FENCE\tROCK WEIGHT = 1200 LBS", "").title.empty());
  BOOST_TEST(with("DOUBLE", "Zaun, 5 \xc2\xb0").title.substr(0, 9) == "Zaun, 5 \xc2");
  // Text that is not UTF-8 is Latin-1; characters that are letters only in a DOS code page are refused.
  BOOST_TEST(with("DOUBLE", "B\xf6schung \xff").title.substr(0, 12) == "B\xc3\xb6schung \xc3\xbf");
  BOOST_TEST(with("DOUBLE", "B\xc3\xb6schung").title.substr(0, 9) == "B\xc3\xb6schung");
  BOOST_TEST(with("DOUBLE", "\xc3\xb6 \xf6").title.substr(0, 8) == "\xc3\x83\xc2\xb6 \xc3\xb6 ");
  BOOST_TEST(message("DOUBLE", "B\x94schung") ==
             "s.DAT:1: title: found the control character 0x94; a title is one line of UTF-8 or Latin-1 text");
  BOOST_TEST(message("DOUBLE", "\x1a") ==
             "s.DAT:1: title: found the control character 0x1a; a title is one line of UTF-8 or Latin-1 text");
}

BOOST_AUTO_TEST_CASE(options_that_no_record_carries) {
  Fence fence = read_deck(sample());
  fence.options.symmetry = scenes::FenceSymmetry::full;
  fence.options.integrator = "rk4";
  try {
    static_cast<void>(write_deck(fence));
    BOOST_TEST(false);
  } catch (const InputError& error) {
    const std::string expected = error.what();
    BOOST_TEST(expected.find("found symmetry = \"full\", integrator = \"rk4\"; it must be symmetry = \"half\", ") !=
               std::string::npos);
  }
}

BOOST_AUTO_TEST_SUITE_END()
