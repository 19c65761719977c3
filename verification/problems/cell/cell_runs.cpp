#include "verification/problems/cell/cell_runs.hpp"
#include "verification/study/runs/usage.hpp"

namespace talus::verification::problems {

CellPlan cell_plan(const ShearCell& cell, double time, double steps_in_contact, int loops) {
  CellPlan plan;
  plan.step = cell.contact_time() / steps_in_contact;
  plan.every = time / loops;
  plan.end = time;
  return plan;
}

CellRun& run_to_end(CellRun& run, const std::function<void(CellRun&)>& at_output) {
  std::visit([](const auto& law) { record_use(law); }, run.cell().law);
  record_use("integrator." + run.plan().integrator);
  while (!run.finished() && run.failure().empty()) {
    run.advance();
    if (at_output && run.due()) at_output(run);
  }
  return run;
}

}  // namespace talus::verification::problems
