#include "verification/check/case.hpp"
#include "verification/problems/fence/fence_equation_findings.hpp"

namespace talus::verification::problems {

Case fence_equations();

namespace {

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
          .faults = {{"contact_on_one_body_left_out", "the column feels nothing of the contact",
                      "contact forces on column and rock, sum over one (Eqs. 5, 6, 8, 9)"},
                     {"joint_below", "the top cable's joint below the centre of mass",
                      "Eq. 7 corrected: moment of the cables"},
                     {"two_stiffnesses", "Eq. 14 with a stiffness nine tenths of that of Eq. 12",
                      "tension at the start, Eq. 14 with the k of Eq. 12"},
                     {"central_column_doubled", "the mass of one central column doubled",
                      "15 columns, N = 8: central column's speed at .01 s, half model"}},
          .run = run};
}

}  // namespace talus::verification::problems
