#include "verification/check/case.hpp"
#include "verification/problems/fence/fence_equation_findings.hpp"

namespace talus::verification::problems {

Case fence_equations();

namespace {

constexpr const char* page = R"(
**Problem.** Some equations of the report cannot be what its program computed. Each is tried here, as printed and as
corrected, on a state of a run of Table 2: what the bodies' accelerations say is the judge.

```
              y_top o---- T (both segments)
                    |
   P ->  (M) . . . .G       moments about G, counter-clockwise > 0
                    |
              y_bot o---- B (both segments)
```

**Equations.** With $a$, $b$ the distances of the joints above and below the centre of mass, $\theta$ counter-clockwise
from upright, $P$ the contact force on the column at $(\Delta x, \Delta y)$ from its centre:
$$\sum M = -a(\bar T_x\cos\theta + \bar T_y\sin\theta) + b(\bar B_x\cos\theta + \bar B_y\sin\theta)
+ \Delta x\,P_y - \Delta y\,P_x,$$
and the rock receives $-P$. Printed are $+a$, $P_x\Delta y + P_y\Delta x$, and $+P$ for both bodies.

A chain of $n$ masses $m$ and springs $k$ between fixed ends has the largest eigenvalue
$4 (k/m) \sin^2\frac{n\pi}{2(n+1)}$; one mass between its two springs has $2k/m$.

**Source.** Mustoe & Huttelmaier 1993, Eqs. 5-12, 14, 18, 25, section 3.1, Appendix II; decks `table_2.DAT` and
`sample2.DAT`.

**What would break it.** A contact force on one body only; the top joint below the centre; a cable whose free length
follows from another stiffness than its tension; a central column doubled where there is one.
)";

void run(Findings& findings, const Setup& setup) {
  check_resultants(findings, setup);
  check_initial_tension(findings, setup);
  check_doubling(findings, setup);
  if (!setup.coarse) check_texts(findings);
}

}  // namespace

Case fence_equations() {
  return {.id = "fence_equations",
          .title = "Equations of the fence, as printed and as corrected",
          .family = "the fence",
          .requirements = {{"Eq. 2", {"contact forces on column and rock"}},
                           {"Eq. 5", {"contact forces on column and rock"}},
                           {"Eq. 6", {"contact forces on column and rock"}},
                           {"Eq. 7", {"Eq. 7 corrected"}},
                           {"Eq. 8", {"contact forces on column and rock"}},
                           {"Eq. 10", {"Eq. 10"}},
                           {"Eq. 11", {"tension at the start"}},
                           {"Eq. 12", {"tension at the start"}},
                           {"Eq. 14", {"tension at the start"}},
                           {"Eq. 15", {"moment of the cables"}},
                           {"Eq. 16", {"moment of the cables"}},
                           {"Eq. 18", {"Eq. 18"}},
                           {"Eq. 25", {"Eq. 25"}},
                           {"law.elastic_plastic", {"tension at the start"}}},
          .main_checks = {"contact forces on column and rock, sum over one (Eqs. 5, 6, 8, 9)",
                          "Eq. 7 corrected: contact's moment on the column", "Eq. 7 corrected: moment of the cables",
                          "15 columns, N = 8: central column's speed at .01 s, half model"},
          .source = "Mustoe & Huttelmaier 1993, sections 3.1-3.7, Appendix II",
          .page = page,
          .faults = {{"contact_on_one_body_left_out", "the column feels nothing of the contact",
                      "contact forces on column and rock, sum over one (Eqs. 5, 6, 8, 9)"},
                     {"joint_below", "the top cable's joint below the centre of mass",
                      "Eq. 7 corrected: moment of the cables"},
                     {"two_stiffnesses", "Eq. 14 with a stiffness nine tenths of that of Eq. 12",
                      "tension at the start, Eq. 14 with the k of Eq. 12"},
                     {"central_column_doubled", "the mass of one central column doubled",
                      "15 columns, N = 8: central column's speed at .01 s, half model"}},
          .tier = Tier::quick,
          .time_limit = 60.0,
          .run = run};
}

}  // namespace talus::verification::problems
