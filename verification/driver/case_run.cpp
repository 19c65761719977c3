#include "verification/driver/case_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "verification/driver/provenance.hpp"

namespace talus::verification {

namespace {

using Clock = std::chrono::steady_clock;

/// Runs `setup`; returns the message of an exception, or nothing. Findings::Decided (all required checks made) is no
/// error.
std::string thrown_by(const Case& verification_case, Findings& findings, const Setup& setup) {
  try {
    verification_case.run(findings, setup);
    return "";
  } catch (const Findings::Decided&) {
    return "";
  } catch (const std::bad_alloc&) {
    return "out of memory (std::bad_alloc)";
  } catch (const std::exception& fault) {
    return std::string("exception: ") + fault.what();
  } catch (...) {
    return "exception of unknown type";
  }
}

Control untried(const Fault& fault) {
  Control control;
  control.name = fault.name;
  control.what = fault.what;
  control.turns_red = fault.turns_red;
  return control;
}

Colour colour_of(const Check* check) {
  if (check == nullptr) return Colour::missing;
  return check->pass ? Colour::green : Colour::red;
}

std::string message_of(const Control& control, const std::string& thrown) {
  std::string message;
  if (control.observed == Colour::green) message = "the check stayed green with the fault";
  if (control.observed == Colour::missing) message = "the check was not made with the fault";
  if (control.observed == Colour::red && control.unplanted != Colour::green) {
    message = fmt::format("the check is {} at this resolution without the fault, too",
                          control.unplanted == Colour::red ? "red" : "missing");
  }
  if (!thrown.empty()) message += (message.empty() ? "" : "; ") + thrown;
  return message;
}

/// Injects `fault`, runs until the check that it names is made, and evaluates that check.
Control plant(const Case& verification_case, const Fault& fault, const Findings& unplanted) {
  Findings findings({fault.turns_red});
  const std::string thrown =
      thrown_by(verification_case, findings, {.fault = fault.name, .coarse = true, .needed = {fault.turns_red}});
  Control control = untried(fault);
  const Check* check = findings.find(fault.turns_red);
  control.observed = colour_of(check);
  control.unplanted = colour_of(unplanted.find(fault.turns_red));
  if (check != nullptr) {
    control.measured = check->measured;
    control.reference = check->reference;
    control.error = check->error;
    control.bound = check->bound;
  }
  control.message = message_of(control, thrown);
  return control;
}

void plant_all(const Case& verification_case, Record& record) {
  std::vector<std::string> needed;
  for (const Fault& fault : verification_case.faults) {
    if (std::find(needed.begin(), needed.end(), fault.turns_red) == needed.end()) needed.push_back(fault.turns_red);
  }
  Findings unplanted(needed);
  const std::string thrown = thrown_by(verification_case, unplanted, {.fault = "", .coarse = true, .needed = needed});
  if (!thrown.empty()) record.notes.push_back("The right setup at coarse resolution threw an " + thrown);
  for (const auto& fault : verification_case.faults) {
    record.controls.push_back(plant(verification_case, fault, unplanted));
  }
}

/// Main checks that were not made, and claims that no check or no run of the case supports; empty if there are none.
std::string missing_checks(const Record& record, bool must_claim) {
  std::string message;
  const auto add = [&](const std::string& more) { message += (message.empty() ? "" : "; ") + more; };
  for (const auto& name : record.main_checks) {
    const auto named = [&](const Check& check) { return check.name == name; };
    if (std::none_of(record.checks.begin(), record.checks.end(), named))
      add(fmt::format("main check '{}' was not made", name));
    const auto& names = record.main_checks;
    if (std::count(names.begin(), names.end(), name) > 1) add(fmt::format("main check '{}' is listed twice", name));
  }
  if (must_claim && record.requirements.empty()) add(fmt::format("case {}: it claims no requirement", record.id));
  for (const auto& trace : record.requirements) {
    const std::string prefix = fmt::format("case {}: claim {}", record.id, trace.requirement);
    if (!trace.unmatched.empty()) {
      add(fmt::format("{}: found '{}'; it must be the name of a check or the id of a group of checks of the case",
                      prefix, trace.unmatched));
    } else if (trace.checks.empty()) {
      add(fmt::format("{}: the case names no check for it", prefix));
    }
    if (!trace.used_instead.empty())
      add(fmt::format("{}: no run of the case used it; its runs used {}", prefix, trace.used_instead));
  }
  return message;
}

}  // namespace

Record run_case(const Case& verification_case, Tier tier, const Record* earlier) {
  const auto start = Clock::now();
  Record record = record_of(verification_case);
  Findings findings;
  Usage usage;
  if (!verification_case.has_full_part()) tier = Tier::quick;
  const std::string thrown = [&] {
    const UsageRecording recording;
    const std::string message =
        thrown_by(verification_case, findings, {.fault = "", .coarse = false, .tier = tier, .machine = machine_text()});
    usage = recording.usage();
    return message;
  }();
  const Case with_names = with_check_names(verification_case, findings);
  record.main_checks = with_names.main_checks;
  record.evaluations = findings.evaluations();
  record.checks = findings.checks();
  mark_main_checks(record);
  record.requirements = traced(verification_case, findings, usage);
  record.figures = findings.figures();
  record.tables = findings.tables();
  record.data = findings.data_files();
  record.notes = findings.notes();
  if (thrown.empty()) {
    if (earlier != nullptr) {
      record.controls = earlier->controls;
    } else {
      plant_all(with_names, record);
    }
    judge(verification_case, record);
  } else {
    record.status = Status::error;
    record.message = thrown;
    for (const auto& fault : with_names.faults)
      record.controls.push_back(untried(fault));
  }
  record.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return record;
}

Record unfinished(const Case& verification_case, Status status, const std::string& message) {
  Record record = record_of(verification_case);
  record.status = status;
  record.message = message;
  for (const auto& fault : verification_case.faults)
    record.controls.push_back(untried(fault));
  return record;
}

void judge(const Case& verification_case, Record& record) {
  const auto failed = std::count_if(record.checks.begin(), record.checks.end(), [](const Check& c) { return !c.pass; });
  const auto unshown = std::count_if(record.controls.begin(), record.controls.end(),
                                     [](const Control& c) { return !c.pass() && c.is_judged(); });
  const auto unjudged =
      std::count_if(record.controls.begin(), record.controls.end(), [](const Control& c) { return !c.is_judged(); });
  record.message.clear();
  if (record.checks.empty()) record.message = "no check was made";
  if (record.controls.empty())
    record.message += record.message.empty() ? "no fault is planted" : "; no fault is planted";
  if (failed > 0) record.message = fmt::format("{} of {} checks failed", failed, record.checks.size());
  if (unshown > 0) {
    record.message += fmt::format("{}{} of {} controls did not turn red", record.message.empty() ? "" : "; ", unshown,
                                  record.controls.size());
  }
  if (unjudged > 0) {
    record.message += fmt::format("{}{} of {} controls are not judged, as their checks fail without the fault",
                                  record.message.empty() ? "" : "; ", unjudged, record.controls.size());
  }
  // Without any check all of them are missing, which the message already says.
  const std::string message = missing_checks(record, verification_case.data_set.empty());
  if (!message.empty() && !record.checks.empty()) {
    record.message += (record.message.empty() ? "" : "; ") + message;
  }
  record.status = record.message.empty() ? Status::pass : Status::fail;
}

}  // namespace talus::verification
