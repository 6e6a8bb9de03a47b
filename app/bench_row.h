// What the rows of all benchmarks share: quoting, what the contact methods did and where the energy
// went, and the last columns, which say what was measured with what and on what.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "state/contact_shares.h"

namespace wells {

/// Shares of the contact methods, and energy by source (J).
inline constexpr std::string_view kStepColumns =
    "exact_share,substep_share,impacts,handed_over,direct_contacts,unsolved_islands,contacts_J,"
    "friction_J,drag_J,wells_J,push_out_J,flight_J";

/// Their values; nothing between the commas where an engine doesn't count or keeps no books.
std::string stepColumns(const ContactShares& shares, const std::optional<Books>& books);

/// The last columns of every row.
inline constexpr std::string_view kBuildColumns = "commit,compiler,flags,cpu";

/// Their values.
std::string buildColumns();

/// Model name of the processor, or "unknown".
std::string processor();

/// The same, and the instruction set that vector code uses of it.
std::string processorInUse();

/// A CSV field: quoted where it holds a comma or a quote (RFC 4180).
std::string csvField(std::string_view text);

}  // namespace wells
