#pragma once

#include <string>
#include <string_view>

namespace talus {

/// A number as Fortran 77's format E prints it without the leading zero: `.827E-04` to three digits, correctly rounded;
/// zero is `.000E+00`. An exponent of three digits takes the place of the E: `.100-299`. `digits` in 1 .. 17.
/// The number must be finite.
[[nodiscard]] std::string fortran_e(double value, int digits);

/// The same in format G: numbers in [.1, 10^digits) after rounding, and zero, stand without an exponent: `55.0`,
/// `.400`, `.000`; all others as in format E.
[[nodiscard]] std::string fortran_g(double value, int digits);

/// Reads a number as Fortran writes one: the exponent may be marked by D, a plus may stand in front. False if the text
/// is none. Errors: InputError for one that no double can hold.
[[nodiscard]] bool parse_fortran_real(std::string_view text, double& number);

/// "found "..."", cut to 40 characters, for messages.
[[nodiscard]] std::string found_text(std::string_view text);

}  // namespace talus
