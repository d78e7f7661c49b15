#pragma once

#include <string>

#include "report/study/is_enough.hpp"
#include "report/text/screen.hpp"
#include "report/text/table_text.hpp"

namespace oddity {

std::string is_enough_text(const IsEnough&, const Screen& = {});
/// A row per model.
Table is_enough_table(const IsEnough&);

}  // namespace oddity
