#pragma once

#include <string>

#include "report/study/results.hpp"

/// Lists of the book's errors, for programs and for print.
namespace oddity {

/// errata.json: every erratum and misprint, by errata.schema.json.
std::string errata_json(const Results&);
/// errata.schema.json, a JSON schema (2020-12).
std::string errata_schema();
/// errata.html: a sheet of a few pages to print and lay into the book.
std::string errata_page(const Results&);

}  // namespace oddity
