/// Laws with a hook of the right name and a wrong signature: none of them is a law, so that no list accepts it.
#include "solver/laws/law.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <typeinfo>
#include <vector>

#include "solver/laws/coulomb_friction.hpp"
#include "solver/laws/law_list.hpp"
#include "tests/solver/laws/cohesive.hpp"

BOOST_AUTO_TEST_SUITE(wrong_laws_tests)

using namespace talus;

namespace {

using Memory = std::span<const double>;

/// The required members of a law, without any hook.
struct Plain {
  static constexpr std::string_view name = "plain";
  static constexpr std::array<std::string_view, 2> modes{"open", "acting"};
  static constexpr std::size_t memory_size = 0;
  static constexpr Mechanism dissipation = Mechanism::contact_damping;
  static constexpr Mechanism release = Mechanism::contact_release;
  double stiffness{};
  static constexpr std::array<Field<Plain>, 1> fields() {
    return {{{"stiffness", dimension::stiffness, &Plain::stiffness, Range::positive, "stiffness"}}};
  }
  static constexpr bool acts(Mode mode) { return mode == 1; }
  constexpr LawForce operator()(Kinematics, Memory, Mode) const { return {}; }
  constexpr double stored_energy(Kinematics, Memory, Mode) const { return 0.0; }
  constexpr double guard(Kinematics, Memory, Mode) const { return 1.0; }
  constexpr Reset reset(Kinematics, std::span<double>, Mode mode) const { return {mode, 0.0}; }
  constexpr Tangent tangent() const { return {}; }
  friend constexpr bool operator==(const Plain&, const Plain&) = default;
};
static_assert(Plain{} == Plain{});  // used here because clang otherwise warns
static_assert(Law<Plain> && Law<Cohesive> && Law<LatchingSpring> && Law<ElasticPlastic>);

// Each of these is Plain with one mistake.
struct TracksWithoutMode : Plain {
  void track(Kinematics, std::span<double>) const;
  static bool memory_follows(Mode);
};
struct TracksButNeverSaysWhen : Plain {
  void track(Kinematics, std::span<double>, Mode) const;
};
struct FollowsWithoutTracking : Plain {
  static bool memory_follows(Mode);
};
struct TracksAndChangesItself : Plain {
  void track(Kinematics, std::span<double>, Mode);
  static bool memory_follows(Mode);
};
struct TrackIsAMode : Plain {
  static constexpr Mode track = 1;
};
struct CountsInInt : Plain {
  int memory_count() const;
};
struct OrdersOfAnother : Plain {
  static std::array<FieldOrder<Cohesive>, 1> orders();
};
struct PartOfTheMemoryAlone : Plain {
  Tangent linear_part(Memory) const;
};
struct PieceIsATangent : Plain {
  Tangent linear_branch(Memory, Mode) const;
};
struct PieceOfTwoNumbers : Plain {
  static constexpr std::size_t memory_size = 2;
  LinearBranch linear_branch(Memory, Mode) const;
};
struct ElongationOfTheMode : Plain {
  double natural_elongation(Memory, Mode) const;
};
struct YieldsWithoutElongation : Plain {
  static bool yields(Mode);
};
struct YieldsWithoutLimit : Plain {
  double natural_elongation(Memory) const;
  static bool yields(Mode);
};
struct BrokenIsAMode : Plain {
  static constexpr Mode is_broken = 3;
};
struct BreaksByTheInstance : Plain {
  bool is_broken(Mode) const;
};
struct ReachIsAParameter : Plain {
  double reach;
};
struct StartsWithoutTangent : Plain {
  void start_contact(std::span<double>, double) const;
};
struct StartsWithoutMass : Plain {
  void start_contact(std::span<double>) const;
  Tangent tangent() const;
  Tangent tangent(double) const;
};
struct RetardsWithoutMemory : Plain {
  double retardation_time() const;
};
struct KnowsTheTimeAlone : Plain {
  double contact_time(double, double) const;
};
struct KnowsNoSpeed : Plain {
  double contact_time(double) const;
  double restitution(double, double) const;
  double largest_overlap(double, double) const;
};
struct SetsNoField : Plain {
  void set_restitution(double, double, double);
};
struct FieldIsAName : Plain {
  static constexpr std::string_view restitution_field = "stiffness";
  void set_restitution(double, double, double);
};
struct SetsEveryAlone : Plain {
  void set_every_restitution(double, double);
};
struct VariesAlone : Plain {
  bool restitution_varies() const;
};
struct DashpotIsANumber : Plain {
  double dashpot;
};
struct ClampedWithoutSlopes : Plain {
  bool is_clamped() const;
};
struct SecantWithoutEnergy : Plain {
  bool is_clamped() const;
  template <class Number>
  void secant(const Number&, Number&, Number&) const;
};
struct SecantOfTheMode : Plain {
  bool is_clamped() const;
  double secant_energy_ratio() const;
  void secant(const double&, double&, double&, Mode) const;
};
struct KernelWithoutPower : Plain {
  bool needs_rate() const;
  template <class Number>
  void force(const Number&, const Number&, Number&, Number&) const;
};
struct KernelOfThePast : KernelWithoutPower {
  double hysteresis_loss(double) const;  // of a law without memory
};
struct ForceByValue : Plain {
  bool needs_rate() const;
  double force(double, double) const;
  template <class Number>
  void dissipated_power(const Number&, const Number&, const Number&, const Number&, Number&, Number&) const;
};
struct EndRuleIsANumber : Plain {
  int end_rule;
};
struct DampingIsAFunction : Plain {
  double damping() const;
};
struct RatioIsAFloat : Plain {
  float damping_ratio;
};
struct TableWithoutYield : Plain {
  std::vector<YieldPoint> table;
};
struct HiddenHook : Plain {
 private:
  [[maybe_unused]] double reach() const { return 1.0; }
};

// Required members of a law.
struct ActsIsUnknown : Plain {
  static void acts(Mode);
};
struct ForceIsADouble : Plain {
  double operator()(Kinematics, Memory, Mode) const;
};

/// Checks that ForceLawList<L> would not compile.
template <class L>
void refuse_one() {
  BOOST_TEST_CONTEXT(typeid(L).name()) { BOOST_TEST(!Law<L>); }
}
template <class... L>
void refuse() {
  (refuse_one<L>(), ...);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_hook_with_a_wrong_signature_makes_no_law) {
  refuse<TracksWithoutMode, TracksButNeverSaysWhen, FollowsWithoutTracking, TracksAndChangesItself, TrackIsAMode,
         CountsInInt, OrdersOfAnother, PartOfTheMemoryAlone, PieceIsATangent, PieceOfTwoNumbers, ElongationOfTheMode,
         YieldsWithoutElongation, YieldsWithoutLimit, BrokenIsAMode, BreaksByTheInstance, ReachIsAParameter,
         StartsWithoutTangent, StartsWithoutMass, RetardsWithoutMemory, KnowsTheTimeAlone, KnowsNoSpeed, SetsNoField,
         FieldIsAName, SetsEveryAlone, VariesAlone, DashpotIsANumber, ClampedWithoutSlopes, SecantWithoutEnergy,
         SecantOfTheMode, KernelWithoutPower, KernelOfThePast, ForceByValue, EndRuleIsANumber, DampingIsAFunction,
         RatioIsAFloat, TableWithoutYield, HiddenHook>();
}

BOOST_AUTO_TEST_CASE(a_law_without_a_part_is_none) { refuse<ActsIsUnknown, ForceIsADouble, Frictionless, int>(); }

BOOST_AUTO_TEST_SUITE_END()
