/// Types that the concepts of methods, systems and motions refuse (solver/integrate/concepts.hpp, hybrid_system.hpp,
/// located_steps.hpp): an optional member of the wrong form must not be treated as a missing one.
#include <boost/test/unit_test.hpp>
#include <string>
#include <vector>

#include "solver/integrate/integrator_list.hpp"
#include "tests/solver/integrate/smooth_systems.hpp"

BOOST_AUTO_TEST_SUITE(contract_tests)

using namespace talus;

namespace {

// Methods. The first two are valid.
struct OfVerlet : VelocityVerlet {};
struct OfStormerCowell : StormerCowell {};
struct FailsByValue : VelocityVerlet {
  std::string failure() const;
};
struct HidesFailure : VelocityVerlet {
 private:
  const std::string& failure() const;
};
struct CountsInInt : VelocityVerlet {
  int events() const;
};
struct ChangesToSynchronize : VelocityVerlet {
  template <class System>
  void synchronize(System&, State&, double);
};
struct LimitOfObject : VelocityVerlet {
  double linear_limit(double) const;
};
struct LimitWithoutSteps : StormerCowell {
  static double linear_limit(double);
};
struct GrowsByWholes : VelocityVerlet {
  static constexpr int amplitude_growth_rate = 1;
};
struct FallsByFunction : VelocityVerlet {
  static double free_fall_error();
};
struct KicksByNumber : VelocityVerlet {
  static constexpr int kick_and_drift = 1;
};
struct EndsByNumber : VelocityVerlet {
  static constexpr int ends_with_evaluation = 1;
};
struct WithoutTolerance : VelocityVerlet {
  static constexpr StepControl step_control = StepControl::fixed_or_tolerance;
};
struct WithoutOrder : VelocityVerlet {
  static constexpr int order = 0;
};
struct WithoutEvaluations : VelocityVerlet {
  static constexpr int evaluations = 0;
};
// Systems.
struct GuardsWithoutTheRest : Oscillator {
  GuardBounds guards(const State&, bool, double, std::vector<double>&);
};
struct GuardsOfOneKind : Oscillator {
  void guards(const State&, std::vector<double>&);
};
struct AccountsByNumber : Duffing {
  int keeps_accounts() const;
};
struct PieceByValue : Duffing {
  LinearSegment linear_segment(const State&) const;
};
struct DriftsInPlace : Duffing {
  void drifted(State&, double) const;
};

// Motions.
struct NeverProbes : LinearMotion {
  void shorten_to_probe() = delete;
};
struct SaysNothing : LinearMotion {
  void advance(HybridSystem&, const State&, State&, double);
};

template <class I>
constexpr bool fits = IntegratorFor<I, Duffing>;

}  // namespace

BOOST_AUTO_TEST_CASE(methods_of_the_wrong_form_are_refused) {
  BOOST_TEST(fits<OfVerlet>);
  BOOST_TEST(fits<OfStormerCowell>);
  BOOST_TEST(!fits<FailsByValue>);
  BOOST_TEST(!fits<HidesFailure>);
  BOOST_TEST(!fits<CountsInInt>);
  BOOST_TEST(!fits<ChangesToSynchronize>);
  BOOST_TEST(!fits<LimitOfObject>);
  BOOST_TEST(!fits<LimitWithoutSteps>);
  BOOST_TEST(!fits<GrowsByWholes>);
  BOOST_TEST(!fits<FallsByFunction>);
  BOOST_TEST(!fits<KicksByNumber>);
  BOOST_TEST(!fits<EndsByNumber>);
  BOOST_TEST(!fits<WithoutTolerance>);
  BOOST_TEST(!fits<WithoutOrder>);
  BOOST_TEST(!fits<WithoutEvaluations>);
}

BOOST_AUTO_TEST_CASE(systems_of_the_wrong_form_are_refused) {
  BOOST_TEST(Hybrid<Duffing>);
  BOOST_TEST(Hybrid<Oscillator>);
  BOOST_TEST(!Hybrid<GuardsWithoutTheRest>);
  BOOST_TEST(!Hybrid<GuardsOfOneKind>);
  BOOST_TEST(!Hybrid<AccountsByNumber>);
  BOOST_TEST(!Hybrid<PieceByValue>);
  BOOST_TEST(Splittable<Duffing>);
  BOOST_TEST(!Splittable<DriftsInPlace>);
}

BOOST_AUTO_TEST_CASE(motions_of_the_wrong_form_are_refused) {
  BOOST_TEST(Motion<LinearMotion>);
  BOOST_TEST(Motion<PolynomialMotion>);
  BOOST_TEST(!Motion<NeverProbes>);
  BOOST_TEST(!Motion<SaysNothing>);
}

BOOST_AUTO_TEST_SUITE_END()
