#pragma once

#include "verification/problems/program/pictures/thrown_discs.hpp"

/// Pictures of histories by `talus plot`; part of the case `picture_options`.
namespace talus::verification::problems::picture_options {

/// Compares what `talus plot` draws with the closed forms and with its options; requests that no fault concerns only in
/// the right setup. Returns the largest error of a point of a curve, over the larger of 1 and the exact value; NaN for
/// another number of points.
double check_histories(const Pictures& program, const Setup& setup, Differences& differ);

}  // namespace talus::verification::problems::picture_options
