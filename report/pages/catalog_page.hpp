#pragma once

#include <string>

namespace oddity {

/// The report's page on the algorithms of this build: orders, limits of stability, repairs.
std::string catalog_page();

}  // namespace oddity
