#pragma once

#include "verification/record/table.hpp"

namespace talus::verification {

using records::DataFile;
using records::Table;

}  // namespace talus::verification
