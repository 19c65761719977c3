#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>

/// Fifty decimal digits for references (heavy: include it in .cpp files only).
namespace talus::verification::reference {

/// 168 bits of mantissa, about 2.7e-51 to the nearest; values, not expression templates, so `auto` is safe.
using Real50 =
    boost::multiprecision::number<boost::multiprecision::backends::cpp_bin_float<50>, boost::multiprecision::et_off>;

/// The nearest double.
[[nodiscard]] inline double nearest(const Real50& value) { return value.convert_to<double>(); }

}  // namespace talus::verification::reference
