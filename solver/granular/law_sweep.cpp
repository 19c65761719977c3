#include "solver/granular/law_sweep.hpp"

template struct talus::LawSweeps<talus::DiscLaws>;
