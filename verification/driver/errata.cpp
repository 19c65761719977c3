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
      {"E6", "Eqs. 5, 6, 8 and 9, sections 3.1 and 3.2",
       R"($+P_x$, $+P_y$ on the attenuator and the same $+P_x$, $+P_y$ on the rock)",
       R"($P$ on the attenuator, $-P$ on the rock)",
       "Action and reaction. In a run of Table 2 the forces that the accelerations of column and rock demand cancel to "
       "1e-9 of one of them.",
       "fence_equations"},
      {"E7", "Eq. 7, section 3.1 (and Appendix I, Eq. 6), contact terms", R"($P_{xi}\Delta y_i + P_{yi}\Delta x_i$)",
       R"($P_{yi}\Delta x_i - P_{xi}\Delta y_i$)",
       "What is printed is no moment: it does not vanish for a force along the arm, and Eq. 10 has the right form. In "
       "a "
       "run with the impact 1.5 ft above the centroid the printed term is -626 165 ft lb, the corrected and the actual "
       "one 625 629 ft lb.",
       "fence_equations"},
      {"E8", "Eq. 7, section 3.1 (and Appendix I, Eq. 6), top cable",
       R"($+\overline T_{xi}\,a\cos\theta_i + \overline T_{yi}\,a\sin\theta_i$)",
       R"($-\overline T_{xi}\,a\cos\theta_i - \overline T_{yi}\,a\sin\theta_i$)",
       "With the angle counter-clockwise the top joint is at (-a sin, a cos) from the centroid. The bottom term, with "
       "the distance b > 0, is right. While only the cables act the printed sum is off by 29 % in the state tried, the "
       "corrected one by round-off.",
       "fence_equations"},
      {"E9", "Section 3.1 (and Appendix I), text after Eq. 7", R"("if $N$ is even" with $N = (N_a + 1)/2$)",
       R"("if $N_a$ is even")",
       "With 15 attenuators N is 8, even, yet one central attenuator is hit: doubled as printed, the rock of Table 2 "
       "is another by 66 % of its velocity after .01 s. For even numbers of attenuators (N_a + 1)/2 is no integer.",
       "fence_equations"},
      {"E10", "Eqs. 11, 12 and 14, section 3.3", R"($d_{i+1}$ in Eq. 11; $k_i$ in Eq. 12, $k_{oi}$ in Eq. 14)",
       R"($d_i$; one stiffness $k_i$)",
       "Only one stiffness gives the tension of static equilibrium at the start (11 026 lb beside the centre), and "
       "only "
       "the distance between attenuators i and i+1, as the text defines d_i, the segment's length.",
       "fence_equations"},
      {"E11", "Eq. 18, section 3.5 (and Appendix I, Eq. 8)",
       R"($F_s = \mu F_n$ for $k_s|\delta_s| \ge \mu|F_n|$; conditions $\delta_n > 0$ and $\delta_n < 0$)",
       R"($F_s = \mu |F_n|\,\mathrm{sign}(\delta_s)$; $\delta_n \ge 0$ as in Eq. 17)",
       "As printed the force of a contact that begins to slide backward jumps by 2 mu F_n and drives the sliding. At "
       "delta_n = 0, where Eq. 17 has a contact, Eq. 18 has nothing.",
       "fence_equations"},
      {"E12", "Eq. 25, text, section 3.7",
       R"(the largest natural frequency of any attenuator "is an approximate upper bound of $\omega_{\max}$")",
       "it may be too low by a factor of up to $\\sqrt 2$ along the cable",
       "One element between its two neighbours has 2 k/m, a chain of n up to 4 (k/m) sin^2(n pi/(2(n + 1))): 3.95 k/m "
       "for 13, 3 k/m for two already. For motion across the cable it is an order of magnitude only.",
       "fence_equations"},
      {"E13", "Appendix II, sample2.DAT, against Table 1", "rho = .76 slug/ft^3", "rho = .38 slug/ft^3",
       ".76 slug/ft^3 is 24.5 lb/ft^3, twice the 12.2 lb/ft^3 of Table 1. Tables 2 and 3 were made with .38: with a "
       "column of 14.92 slug 18 of their 21 elastic pairs of forces agree within their digits, with 29.85 slug two.",
       "fence_tables"},
      {"E14", "Appendix II, sample2.DAT, against Table 1", "attachment 2.67 ft (y_top = 6.67)",
       "2.5 ft (Table 1 and Appendix I)", "Two lengths of the same part; the program takes y_top.", "fence_equations"},
      {"E15", "Appendix II.4, totvar", R"("max. = 6")", "8",
       "The sample deck itself asks for eight history variables and the listing shows them.", "fence_equations"},
      {"E16", "Appendix II.4, f_penet", "a minimum penetration", "a maximum",
       R"(The stiffness made from it, $2 m v^2/(f r)^2$ by sample2's listing, lets the rock sink in by $f r/\sqrt 2$ at )"
       "most.",
       "fence_equations"},
      {"E17", "Appendix I, model data", R"(velocity 53 ft/s$^2$; $\Delta t \approx 2 \cdot 10^{-4}$ s)",
       R"(53 ft/s; the program's own rule gives $5.85\cdot10^{-5}$ s)",
       "The unit is an acceleration's. The step is 3.4 times that of the rule in the listing (T/100).",
       "fence_appendix"},
      {"E18", "Tables 2 and 3, head of the columns", R"("WITH BOTTOM CABLE NO SLACK")", "(to be left out)",
       "The rows below have .50 ft slack or no bottom cable.", "fence_tables"},
      {"E19", "Table 2, slack .50 ft, yc = -1.5", "9.02 and 2.62", "8.01 and 2.62, or 9.02 and 2.83",
       "An elastic cable ties the two by joint = 2 T sin; 18 of 21 printed pairs obey it within their digits, and all "
       "our runs to 1e-13. 2.62e5 lb gives 8.01e4 lb. (8.01 would also restore section 6.3's remark that the elastic "
       "forces are largest near and above the centroid.)",
       "fence_tables"},
      {"E20", "Table 3, slack .50 ft, yc = 3.0, and no bottom cable, yc = 1.5", "8.18 and 2.68; 9.21 and 2.89",
       "8.18 and 2.66; 9.21 and 2.87", "The same relation: the printed top forces are .02 too high.", "fence_tables"},
      {"E21", "Section 6.3, first paragraph",
       R"("In both fences ... the rock post-impact velocity decreases with increasing impact height")",
       "without the bottom cable only",
       "With it Table 2 prints 4.6, 5.6, 1.6, 1.1 and 15.5 ft/s (the last away from the fence).", "fence_tables"},
  };
}

}  // namespace talus::verification
