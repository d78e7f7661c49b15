#pragma once

#include <string>

#include "report/study/results.hpp"

namespace oddity {

/// The report's page of the cheapest models.
std::string cheapest_models_page(const Results&);

}  // namespace oddity
