/// Divided differences (solver/integrate/differences.hpp) of polynomials, whose integrals are known.
#include "solver/integrate/differences.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "solver/base/error.hpp"

BOOST_AUTO_TEST_SUITE(differences_tests)

using namespace talus;

namespace {

/// Quantity c is (t - c/16)^power; its integrals over time from t0, once and twice.
constexpr int power = 5;
struct Known {
  double c{}, t0{};
  double at(double t, int p) const { return std::pow(t - c / 16.0, p); }
  double value(double t) const { return at(t, power); }
  double once(double t) const { return (at(t, power + 1) - at(t0, power + 1)) / (power + 1); }
  double twice(double t) const {
    return (at(t, power + 2) - at(t0, power + 2)) / ((power + 1) * (power + 2)) -
           (t - t0) * at(t0, power + 1) / (power + 1);
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(polynomials_are_integrated_exactly) {
  // Widths near that of a pack; times at unequal intervals.
  for (const std::size_t width : {1U, 7U, 8U, 9U, 24U}) {
    Differences differences;
    const auto rates = [&](double t) {
      std::vector<double> all;
      for (std::size_t c = 0; c < width; ++c)
        all.push_back(Known{static_cast<double>(c), 0.0}.value(t));
      return all;
    };
    differences.begin(0.0, rates(0.0));
    for (const double t : {0.1, 0.25, 0.3, 0.5, 0.55, 0.8})
      differences.add(t, rates(t));
    BOOST_TEST(differences.count() == 7U);
    const double t = 1.1;
    std::vector<Differences::Basis> basis(7);
    differences.basis(t, 7, basis);
    std::vector<double> value, once, twice;
    for (const auto& b : basis)
      value.push_back(b.value), once.push_back(b.once), twice.push_back(b.twice);
    const std::vector<double> ones(width, 1.0), twos(width, 2.0);
    std::vector<double> values(width), integrals(width), second(width), speeds(width);
    differences.sum(ones, 0, value, values);
    differences.sum(twos, 0, once, integrals);
    differences.move(ones, twos, t - 0.8, basis, second, speeds);
    for (std::size_t c = 0; c < width; ++c) {
      const Known known{static_cast<double>(c), 0.8};
      BOOST_TEST(values[c] == 1.0 + known.value(t), boost::test_tools::tolerance(1e-12));
      BOOST_TEST(integrals[c] == 2.0 + known.once(t), boost::test_tools::tolerance(1e-12));
      BOOST_TEST(second[c] == 1.0 + 2.0 * (t - 0.8) + known.twice(t), boost::test_tools::tolerance(1e-12));
      BOOST_TEST(speeds[c] == integrals[c]);
    }
    // Sums that start at a given quantity, and the largest sums.
    if (width < 3) continue;
    const std::vector<double> none(1, 0.0);
    std::vector<double> last(1);
    differences.sum(none, width - 1, value, last);
    BOOST_TEST(1.0 + last.front() == values[width - 1], boost::test_tools::tolerance(1e-12));
    std::vector<double> x(width, 0.0), factors(width, 1.0);
    x[width - 1] = -2.0, factors[width - 1] = 3.0;
    const auto maximum = differences.largest(x, 0, {Differences::Term{0, 0.0}, Differences::Term{6, 1e3}}, factors);
    BOOST_TEST(maximum[0] == 6.0);
    BOOST_TEST(maximum[1] == 6.0);
    BOOST_TEST(maximum[2] == 6.0, boost::test_tools::tolerance(1e-8));  // of degree 5: the seventh difference vanishes
  }
}

BOOST_AUTO_TEST_CASE(every_term_is_integrated_to_round_off) {
  // The 20-point Gauss rule is exact for these.
  using Rule = boost::math::quadrature::gauss<long double, 20>;
  for (const double growth : {1.0, 1.3, 4.0}) {
    Differences differences;
    std::vector<double> times{0.0};
    differences.begin(0.0, std::vector<double>{1.0});
    double h = 0.1;
    for (std::size_t n = 1; n < Differences::capacity; ++n, h *= n < 4 ? growth : std::min(growth, 1.3)) {
      times.insert(times.begin(), times.front() + h);
      differences.add(times.front(), std::vector<double>{1.0});
    }
    const double t = times.front() + h;
    std::vector<Differences::Basis> basis(Differences::capacity + 1);
    differences.basis(t, basis.size(), basis);
    for (std::size_t i = 0; i < basis.size(); ++i) {
      const auto value = [&](long double s) {
        long double product = 1.0L;
        for (std::size_t k = 0; k < i; ++k)
          product *= s - static_cast<long double>(times[k]);
        return product;
      };
      const auto integral = [&](auto&& f) {
        return static_cast<double>(
            Rule::integrate(f, static_cast<long double>(times.front()), static_cast<long double>(t)));
      };
      BOOST_TEST(basis[i].value == static_cast<double>(value(t)), boost::test_tools::tolerance(1e-13));
      BOOST_TEST(basis[i].once == integral(value), boost::test_tools::tolerance(1e-13));
      BOOST_TEST(basis[i].twice == integral([&](long double s) { return (t - s) * value(s); }),
                 boost::test_tools::tolerance(1e-13));
    }
  }
}

BOOST_AUTO_TEST_CASE(the_oldest_times_are_forgotten) {
  Differences differences;
  differences.begin(0.0, std::vector<double>{1.0});
  for (int n = 1; n < 40; ++n)
    differences.add(0.1 * n, std::vector<double>{1.0 + 0.1 * n});
  BOOST_TEST(differences.count() == Differences::capacity);
  BOOST_TEST(differences.newest() == 0.1 * 39);
  std::vector<Differences::Basis> basis(2);
  differences.basis(5.0, 2, basis);
  const std::vector<double> none{0.0};
  std::vector<double> line{0.0};
  differences.sum(none, 0, std::vector<double>{basis[0].value, basis[1].value}, line);
  BOOST_TEST(line.front() == 6.0, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(restored_times_must_decrease_and_fit_the_table) {
  Differences saved;
  saved.begin(0.0, std::vector<double>{1.0});
  saved.add(0.5, std::vector<double>{2.0});
  Archive archive;
  saved.serialize(archive, 1);
  const auto message = [&](const char* item, std::vector<double> value) {
    ArchiveItems items = archive.items();
    items.at(item) = std::move(value);
    Archive restoring{items};
    try {
      Differences{}.serialize(restoring, 1);
    } catch (const InputError& error) {
      return std::string{error.what()};
    }
    return std::string{};
  };
  BOOST_TEST(message("times", {0.5, 0.0}) == "");
  BOOST_TEST(message("times", {0.0, 0.5}) == "times: found 2 of them; at most 13 must be there, the newest first");
  BOOST_TEST(message("times", {0.5, 0.5}) == "times: found 2 of them; at most 13 must be there, the newest first");
  BOOST_TEST(message("times", {0.5}) == "differences: found 8 numbers; 1 times of 4 must be there");
}

BOOST_AUTO_TEST_SUITE_END()
