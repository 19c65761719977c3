#pragma once

#include <array>

#include "verification/record/csv.hpp"
#include "verification/study/program/program_options.hpp"

/// Nodes of the maps of a capacity; part of the case `fence_capacity`.
namespace talus::verification::problems::fence_capacity {

/// The rock of the base: mass [kg], radius [m].
struct OwnRock {
  double mass{}, radius{};
};

/// Wilson's interval of 95 % for k of n: the roots of (k - n p)^2 = z^2 n p (1 - p).
[[nodiscard]] std::array<double, 2> wilson(double k, double n);

/// Compares the nodes of capacity.csv with the rows of its runs in results.csv: counts of ends, Wilson's interval of
/// the probability, quantiles of outputs. The maps must differ in speed and mass alone, and speeds be changed by less
/// than 2 %; a row belongs to the node of its speed and of its radius, which follows from the mass.
void compare_nodes(const records::Csv& nodes, const records::Csv& runs, const OwnRock& own, Differences& differ);

}  // namespace talus::verification::problems::fence_capacity
