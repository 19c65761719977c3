#pragma once

#include "verification/catalogue/catalogue.hpp"
#include "verification/record/record_files.hpp"

namespace talus::verification {

using records::Results;

/// Fills what follows from the records and the catalogue: which cases show a requirement and what peers check, the
/// families of the cases, the errata that registered cases prove, and the bibliography.
void complete(Results& results, const Catalogue& catalogue);

}  // namespace talus::verification
