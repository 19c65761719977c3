/// The records of a verification run, as values. Their texts are of two kinds: *Markdown* (`page`, `notes`), inserted
/// literally, and *words* (all others), plain text in which only `$maths$` and `` `code` `` spans have a meaning.
#pragma once

#include "verification/record/plots.hpp"
#include "verification/record/record_files.hpp"

namespace talus::reports {

using records::Axis;
using records::Check;
using records::Colour;
using records::Control;
using records::Counts;
using records::Erratum;
using records::Figure;
using records::Kind;
using records::Line;
using records::Look;
using records::Mark;
using records::Peer;
using records::Provenance;
using records::Record;
using records::RecordError;
using records::Requirement;
using records::Results;
using records::Scale;
using records::Series;
using records::ShownBy;
using records::Slope;
using records::Status;
using records::Style;
using records::Table;

}  // namespace talus::reports
