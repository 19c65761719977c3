#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstring>
#include <random>

#include "solver/io/fence1993/read_deck.hpp"
#include "solver/io/fence1993/write_deck.hpp"
#include "solver/io/file/quantity_text.hpp"
#include "solver/io/scene/read_fence.hpp"
#include "solver/io/scene/write_fence.hpp"

BOOST_AUTO_TEST_SUITE(fence_round_trip_tests)

// Every number of a fence is unchanged to the last bit by deck -> scene file -> deck, whatever its digits.

using namespace talus;
using scenes::Fence;
using scenes::FenceElement;

namespace {

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

/// Random numbers that use all 53 bits, or that have few decimal digits, as people write them.
class Numbers {
 public:
  explicit Numbers(unsigned seed) : random_{seed} {}

  /// A number > 0 between 1e-6 and 1e6.
  double positive() {
    const double number = std::pow(10.0, uniform(-6.0, 6.0));
    return random_() % 2 == 0 ? number : std::stod(few_digits(number));
  }
  double any() { return random_() % 8 == 0 ? -0.0 : random_() % 2 == 0 ? positive() : -positive(); }
  double fraction() { return uniform(1e-9, 1.0); }

 private:
  double uniform(double minimum, double maximum) {
    return std::uniform_real_distribution<double>{minimum, maximum}(random_);
  }
  std::string few_digits(double number) {
    std::string text(32, '\0');
    const int digits = 1 + static_cast<int>(random_() % 6);
    text.resize(static_cast<std::size_t>(std::snprintf(text.data(), text.size(), "%.*g", digits, number)));
    return text;
  }

  std::mt19937 random_;
};

template <class T>
void randomize(T& value, Numbers& numbers) {
  for (const auto& field : T::fields()) {
    double& number = value.*field.member;
    const bool fraction = field.range == Range::fraction || field.range == Range::positive_fraction;
    number = fraction ? numbers.fraction() : field.range == Range::any ? numbers.any() : numbers.positive();
    // As if read from a deck: not every double is a number of square inches or of lb/in^2.
    if (!fraction) number = consistent(number, deck_unit(field.dimension), field.dimension, us);
  }
}

FenceElement random_element(Numbers& numbers, scenes::ElementType type) {
  FenceElement element;
  element.type = type;
  element.solid = type == scenes::ElementType::column ? scenes::ElementSolid::cylinder : scenes::ElementSolid::block;
  randomize(element, numbers);
  for (const auto& field : FenceElement::vectors())
    element.*field.member = {numbers.any(), numbers.any()};
  return element;
}

Fence random_fence(unsigned seed) {
  Numbers numbers{seed};
  Fence fence;
  randomize(fence, numbers);
  fence.title = "Quotes \" and \\ and\ttabs";
  fence.steps = fence.print_every = fence.history_every = 1 + static_cast<long>(seed);
  fence.history_elements = {1, 2, 3};
  fence.history_codes = {61, 1};
  fence.columns = 1;
  fence.y_bottom = fence.y_top - 1.0;
  fence.layers = 2;
  fence.ground = random_element(numbers, scenes::ElementType::rock);
  fence.rocks = {random_element(numbers, scenes::ElementType::rock),
                 random_element(numbers, scenes::ElementType::rock)};
  fence.column = random_element(numbers, scenes::ElementType::column);
  fence.rocks[1].velocity.x = fence.rocks[1].spin = 0.0;
  fence.rocks[1].held = {true, false, true};
  return fence;
}

Fence from_toml(const std::string& text) {
  const TomlValue document = parse_toml(text, "f.toml");
  SceneSource source{"f.toml", si};
  SceneTable table{source, document, ""};
  return read_fence(table, source);
}

template <class T>
bool same_numbers(const T& a, const T& b) {
  bool same = true;
  for (const auto& field : T::fields())
    same = same && same_bits(a.*field.member, b.*field.member);
  return same;
}

/// True for equal numbers, with zeros of the same sign: == treats 0 and -0 as equal.
bool same(const Fence& a, const Fence& b) {
  bool elements =
      same_numbers(a.ground, b.ground) && same_numbers(a.column, b.column) && a.rocks.size() == b.rocks.size();
  for (std::size_t i = 0; elements && i < a.rocks.size(); ++i) {
    elements = same_numbers(a.rocks[i], b.rocks[i]);
    for (const auto& field : FenceElement::vectors()) {
      const Vec2 u = a.rocks[i].*field.member;
      const Vec2 v = b.rocks[i].*field.member;
      elements = elements && same_bits(u.x, v.x) && same_bits(u.y, v.y);
    }
  }
  return elements && same_numbers(a, b) && a == b;
}

}  // namespace

BOOST_AUTO_TEST_CASE(deck_to_scene_file_and_back) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    const Fence fence = random_fence(seed);
    const std::string deck = write_deck(fence);
    const Fence read = read_deck(deck, "f.DAT");
    BOOST_TEST(same(read, fence));
    const Fence again = from_toml(write_fence(read));
    BOOST_TEST(same(again, fence));
    BOOST_TEST(write_deck(again) == deck);
  }
}

BOOST_AUTO_TEST_CASE(scene_files_keep_any_number_of_any_system) {
  for (unsigned seed = 1000; seed < 1100; ++seed) {
    Fence fence = random_fence(seed);
    Numbers numbers{seed};
    fence.units = seed % 2 == 0 ? si : us;
    fence.young = numbers.positive();
    fence.area_top = numbers.positive();
    fence.options.contact = scenes::FenceContact::resultant;
    fence.options.integrator = "rk4";
    BOOST_TEST(same(from_toml(write_fence(fence)), fence));
  }
}

// A fence in SI units becomes one in US units: each number to within the rounding of one unit conversion, which is
// three operations of half a unit in the last place (2^-53) each, once in each direction.
BOOST_AUTO_TEST_CASE(metric_fences_become_decks) {
  Fence fence = random_fence(7);
  fence.units = si;
  const Fence read = read_deck(write_deck(fence), "f.DAT");
  BOOST_TEST((read.units == us));
  BOOST_TEST(read.span * exact::foot_in_m == fence.span, boost::test_tools::tolerance(6.0 * 0x1p-53));
  BOOST_TEST(read.limit_top * exact::pound_force_in_N == fence.limit_top, boost::test_tools::tolerance(6.0 * 0x1p-53));
  BOOST_TEST(read.rocks[0].density * exact::slug_in_kg / std::pow(exact::foot_in_m, 3) == fence.rocks[0].density,
             boost::test_tools::tolerance(12.0 * 0x1p-53));
}

// Every unit of a deck, for numbers of all magnitudes: a value that was read is written with digits that give the same
// value, and with no more digits.
BOOST_AUTO_TEST_CASE(shortest_digits_of_every_unit) {
  Numbers numbers{5};
  for (const Dimension dimension : {dimension::number, dimension::length, dimension::density, dimension::angle,
                                    dimension::velocity, dimension::angular_velocity, dimension::force,
                                    dimension::moment, dimension::acceleration, dimension::pressure, dimension::area}) {
    const std::string unit = deck_unit(dimension);
    for (int i = 0; i < 20000; ++i) {
      const double number = numbers.positive();
      const double value = consistent(number, unit, dimension, us);
      const Decimal text = decimal(value, unit, dimension, us);
      BOOST_REQUIRE(text.exact);
      BOOST_REQUIRE(same_bits(consistent(std::stod(text.text), unit, dimension, us), value));
      char digits[32];
      std::snprintf(digits, sizeof digits, "%.15g", number);
      if (std::stod(digits) == number) BOOST_REQUIRE(text.text.size() <= std::strlen(digits));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
