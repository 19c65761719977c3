#pragma once

#include <string>
#include <string_view>

namespace talus {

/// A number in Fortran 77's format E without the leading zero: `.827E-04` to three digits, correctly rounded; zero is
/// `.000E+00`. An exponent of three digits replaces the E: `.100-299`. `digits` in 1 .. 17. The number must be finite.
[[nodiscard]] std::string fortran_e(double value, int digits);

/// A number in format G: numbers in [0.1, 10^digits) after rounding, and zero, have no exponent: `55.0`, `.400`,
/// `.000`; all others are as in format E.
[[nodiscard]] std::string fortran_g(double value, int digits);

/// Reads a number in Fortran's notation: D may mark the exponent, and a leading plus is allowed. False if the text is
/// not a number. Errors: InputError for a number outside the range of a double.
[[nodiscard]] bool parse_fortran_real(std::string_view text, double& number);

/// The text `found "..."` of messages, with at most 40 characters quoted, control characters escaped.
[[nodiscard]] std::string found_text(std::string_view text);

}  // namespace talus
