#pragma once

#include <optional>
#include <span>
#include <string>

#include "report/study/run.hpp"

/// The least model that a scene needs, and the value of its hard parameter at which each lesser model stops
/// being enough.
namespace oddity {

/// The ledger of the task's scene; nothing when it has no motion. Throws BadInput when no true motion is
/// known for the task's parameters.
std::optional<Ledger> ledger(const Task&, const Reference&);

/// The results with the ledger of every task that has a scene, made in parallel.
Results with_ledgers(Results, std::span<const Task>, const Reference&, const Progress& progress = {});

/// The report's page.
std::string ledger_page(const Results&);

}  // namespace oddity
