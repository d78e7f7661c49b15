#pragma once

#include <string>

#include "report/study/results.hpp"

/// What is wrong in the book as a list: for programs, and for paper.
namespace oddity {

/// errata.json: every erratum and misprint, as errata.schema.json has it.
std::string errata_json(const Results&);
/// errata.schema.json, a JSON schema (2020-12).
std::string errata_schema();
/// errata.html: a sheet of a few pages to print and lay into the book.
std::string errata_page(const Results&);

}  // namespace oddity
