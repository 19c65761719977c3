#include "verification/driver/errata.hpp"

namespace talus::verification {

std::vector<Erratum> all_errata() {
  return {
      {"E1", "Eq. 20, section 3.6 (pp. 12-13)", R"($\dot\delta_n = (\vec v_{Pf} + \vec v_{Pr}) \cdot \hat n$)",
       R"($\dot\delta_n = (\vec v_{Pf} - \vec v_{Pr}) \cdot \hat n$)",
       "The overlap's rate is a difference of velocities: with the sum, two bodies that move together would be damped. "
       "The report's own Appendix I, Eq. 11, has the minus sign.",
       "restitution"},
      {"E2", "Eq. 21, range of validity, section 3.6 (pp. 12-13)",
       R"($c = 2 \ln(1/e) \sqrt{k_n m_r m_f/(m_r + m_f)} / \sqrt{\pi^2 + \ln^2(1/e)}$, of which the report says )"
       R"(itself that it "is only approximate when applied to a non-central impact between a spherical rock and a )"
       R"(cylindrical attenuator. Some numerical experimentation, therefore, is usually required".)",
       R"(The same with the effective mass at the contact point, $1/m_\mathrm{eff} = \sum (1/m + (r \times n)^2/I)$; )"
       R"($I_p/h^2$ replaces the mass of a body pivoted a distance $h$ from the line of impact. )"
       R"(It holds for stiff contacts.)",
       "Not a misprint but a limit. Exact for two free particles whose contact may pull, as long as the overlap is "
       "positive. In validation problem 2 the two particle masses give an effective e of .537 for the wanted .5; the "
       "pivoted mass 20.26 slug gives .5.",
       "restitution"},
      {"E3", "Eq. 28, section 5.0 (pp. 15-17), validation problem 2",
       R"($v_1 = M(1+e)(\ell^2/4) / [I_G + (M+m)\ell^2/4]$)",
       R"($v_1 = M(1+e)\,v_0\,(\ell^2/4) / [I_G + (M+m)\ell^2/4]$)",
       "The printed right-hand side has no velocity in it: .9714, a pure number. With v0 = 5 ft/s it is 4.857 ft/s, "
       "and the report's own result is 4.85.",
       "pivoted_cylinder"},
      {"E4", "Eq. 30, section 5.0 (pp. 15-17), validation problem 2",
       R"($\omega^2 = \omega_1^2 + 2 m g \ell (\cos\theta - 1)/(I_G + m\ell^2/4)$)",
       R"($\omega^2 = \omega_1^2 + m g \ell (\cos\theta - 1)/(I_G + m\ell^2/4)$)",
       "Energy: half the moment of inertia times the change of the squared angular velocity is the weight times the "
       "rise (l/2)(1 - cos theta). The largest angle is .3546 rad as printed and .5042 rad as corrected; the report "
       "found .503.",
       "pivoted_cylinder"},
      {"E5", "Data of validation problem 2, section 5.0 (pp. 15-17)", "$r = 1.2$ ft", "$r = 1.25$ ft",
       "A cylinder of m = 14.92 slug and l = 8 ft has I_G = m(3 r^2 + l^2)/12 = 84.94 slug ft^2 with r = 1.2 and 85.40 "
       "with r = 1.25; with the unrounded m = 14.9226 slug (.38 slug/ft^3) it is the printed 85.42.",
       "pivoted_cylinder"},
  };
}

}  // namespace talus::verification
