#pragma once

#include "verification/catalogue/catalogue.hpp"
#include "verification/record/record_files.hpp"

namespace talus::verification {

using records::Results;

/// Fills the parts that follow from the records and the catalogue: the cases that verify each requirement and each
/// check of a peer, the families of the cases, the errata proved by registered cases, and the bibliography.
void complete(Results& results, const Catalogue& catalogue);

}  // namespace talus::verification
