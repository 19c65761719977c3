#include "solver/io/fence1993/out_listing.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "solver/io/fence1993/read_deck.hpp"
#include "solver/io/file/fortran.hpp"
#include "solver/io/file/toml_document.hpp"
#include "tests/solver/io/fence_run.hpp"

BOOST_AUTO_TEST_SUITE(out_listing_tests)

using namespace talus;

namespace {

const std::filesystem::path cases{TALUS_CASES};

/// Lines with words separated by single blanks, without comments and empty lines.
std::vector<std::string> token_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in{text};
  for (std::string line; std::getline(in, line);) {
    if (line.rfind("# ", 0) == 0) continue;
    std::istringstream tokens{line};
    std::string joined;
    for (std::string word; tokens >> word;)
      joined += joined.empty() ? word : " " + word;
    if (!joined.empty()) lines.push_back(joined);
  }
  return lines;
}

FenceInput input_of(scenes::Fence fence) {
  scenes::FenceScene made = scenes::fence_scene(fence);
  return {std::move(fence), std::move(made)};
}

std::string listing(const FenceInput& input, long steps) {
  const Dynamics dynamics{input.made.scene.model};
  OutListing listing{input.fence, input.made, input.made.scene.plan};
  run_fence(input, dynamics, steps, [&](const State& state, const StepInfo& info) { listing(state, info); });
  return listing.text();
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_head_is_the_manuals_word_for_word) {
  const FenceInput input = input_of(read_deck(cases / "fence/sample2.DAT"));
  const auto ours = token_lines(OutListing{input.fence, input.made, input.made.scene.plan}.text());
  const auto printed = token_lines(read_text(cases / "published/sample2_head.txt"));
  BOOST_TEST_REQUIRE(printed.size() > 150U);
  BOOST_TEST(ours == printed, boost::test_tools::per_element());
}

// In the manual's example the numbers of both cables, and both overlaps, are equal.
BOOST_AUTO_TEST_CASE(numbers_of_the_two_cables_and_of_the_two_overlaps_are_in_their_lines) {
  scenes::Fence fence = read_deck(cases / "fence/sample2.DAT");
  fence.area_top = 1.0 / 144.0, fence.area_bottom = 2.0 / 144.0;  // listed in square inches
  fence.limit_top = 3e5, fence.limit_bottom = 4e5;
  fence.rock_overlap = 0.5, fence.layer_overlap = 0.25;
  const FenceInput input = input_of(fence);
  const auto lines = token_lines(OutListing{input.fence, input.made, input.made.scene.plan}.text());
  for (const auto& [name, number] : {std::pair{"x-section area of top cable", fortran_g(1.0, 3)},
                                     {"x-section area of bottom cable", fortran_g(2.0, 3)},
                                     {"top cable breaking strength", fortran_g(3e5, 3)},
                                     {"bottom cable breaking strength", fortran_g(4e5, 3)},
                                     {"Maximum overlap (rock/fence)", fortran_e(0.5, 4)},
                                     {"Maximum overlap (fence/fence)", fortran_e(0.25, 4)}}) {
    const auto found =
        std::ranges::find_if(lines, [&, name = name](const std::string& line) { return line.starts_with(name); });
    BOOST_TEST_REQUIRE((found != lines.end()), name);
    BOOST_TEST(found->substr(found->find("= ") + 2) == number.substr(number.find_first_not_of(' ')), name);
  }
}

BOOST_AUTO_TEST_CASE(states_come_every_nprint_steps_and_not_at_the_start) {
  scenes::Fence fence = read_deck(cases / "fence/sample2.DAT");
  fence.print_every = 4;
  const std::string text = listing(input_of(fence), 9);
  std::vector<std::string> times;
  for (const std::string& line : token_lines(text)) {
    if (line.rfind("time = ", 0) == 0) times.push_back(line);
  }
  // 4 and 8 steps of 0.82737e-4 s.
  BOOST_TEST(times == (std::vector<std::string>{"time = .331E-03 secs", "time = .662E-03 secs"}),
             boost::test_tools::per_element());
}

// Fixed ends have their position and zeros; the ground is element 1; coordinates are half a step ahead of the
// velocities: in the first step from rest the rock's velocity changes by g h, and x moves by v (h/2 + h).
BOOST_AUTO_TEST_CASE(states_are_as_the_integrator_holds_them) {
  scenes::Fence fence = read_deck(cases / "fence/sample2.DAT");
  fence.print_every = 1;
  fence.rocks[0].position = {9.0, 0.0};  // does not touch the fence
  fence.rocks[0].spin = 0.0;
  const auto lines = token_lines(listing(input_of(fence), 1));
  const auto at = std::find_if(lines.begin(), lines.end(), [](const auto& l) { return l.rfind("time = ", 0) == 0; });
  BOOST_REQUIRE(lines.end() - at == 20);
  BOOST_TEST(at[1] == "el. x y theta vx vy ang-v");
  BOOST_TEST(at[2] == "1 .000E+00 -.500E+01 .000E+00 .000E+00 .000E+00 .000E+00");
  // h = 0.82737e-4: vy = -32.18 h = -0.2662e-2, y = h vy = -0.2203e-6, x = 9 - 65 (3/2) h = 8.9919.
  BOOST_TEST(at[3] == "2 .899E+01 -.220E-06 .000E+00 -.650E+02 -.266E-02 .000E+00");
  BOOST_TEST(at[11] == "10 .000E+00 .550E+01 .000E+00 .000E+00 .000E+00 .000E+00");
  BOOST_TEST(at[19] == "18 -.260E+01 .550E+01 .000E+00 .000E+00 .000E+00 .000E+00");
}

// A fence in metres and kilograms is listed in feet and slugs with the same numbers.
BOOST_AUTO_TEST_CASE(fences_in_other_units_are_listed_in_those_of_the_deck) {
  scenes::Fence fence = read_deck(cases / "fence/sample2.DAT");
  fence.rocks[0].position.x = 2.5;  // in the deck it just touches, and in other units round-off separates it
  scenes::Fence metric = fence;
  metric.units = si;
  const auto convert = [](auto& owner) {
    using T = std::decay_t<decltype(owner)>;
    for (const auto& field : T::fields())
      owner.*field.member *= si_size(us, field.dimension);
  };
  const auto convert_element = [&](scenes::FenceElement& element) {
    convert(element);
    for (const auto& field : scenes::FenceElement::vectors())
      element.*field.member = si_size(us, field.dimension) * (element.*field.member);
  };
  convert(metric);
  convert_element(metric.ground);
  convert_element(metric.rocks[0]);
  convert_element(metric.column);
  auto ours = token_lines(listing(input_of(metric), 60));
  auto theirs = token_lines(listing(input_of(fence), 60));
  // Head, time, and elements 1 to 5: values of elements that the wave has hardly reached are round-off, which depends
  // on the units.
  BOOST_TEST_REQUIRE(ours.size() == theirs.size());
  for (auto* lines : {&ours, &theirs})
    lines->resize(lines->size() - 13);
  BOOST_TEST(ours == theirs, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
