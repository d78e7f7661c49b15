#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>

#include "reference/proofs.hpp"
#include "reference/reference.hpp"
#include "report/site/parts.hpp"
#include "report/study/embedded.hpp"
#include "report/study/engines.hpp"
#include "report/study/run.hpp"
#include "report/study/trust.hpp"

/// The site: one folder, opened by double click, which needs no network. Pages, scripts and data are files
/// in it; scripts are classic ones and data are scripts too, as a browser loads neither modules nor data from
/// a file.
///
/// - index.html, 3.5.html, ...: pages.
/// - errata.json: errors of the book, for programs, with errata.schema.json.
/// - assets/*.js, *.css: report/site/assets, unchanged.
/// - assets/models.js: the models, compiled (players.hpp); empty without the module.
/// - assets/own.js: compiled reader and runner of problems' files, for own.html (own_page.hpp).
/// - data/problems.js: the initial files of own.html.
/// - data/search.js: the index of the search.
/// - bouncing_ball.html: an example that is no exercise (example.hpp).
/// - data/3.5.js: an exercise's methods, trials, limits and motions (data.hpp).
namespace oddity {

/// The files of report/site/assets.
std::span<const EmbeddedFile> embedded_assets();
/// The files of chapters/examples/problems.
std::span<const EmbeddedFile> embedded_problems();

/// All pages by file name. Proved claims are marked; each page reports the missing parts of this copy.
std::map<std::string, std::string> site_pages(const Results&, const ProvedClaims& = {},
                                              const SiteParts& = parts_at_hand(),
                                              std::span<const EngineContest> = {}, const Trust& = {});

/// An exercise's page as one file that can be mailed.
std::string single_page(const Results&, const ExerciseResult&, const Reference&,
                        std::span<const EngineContest> contests = {}, const ProvedClaims& = {});

struct OwnFile;
/// A problem's file, played and answered in one page, as one file.
std::string own_in_one_file(const OwnFile&);

/// Writes the site into `folder`, with engines' results on its scenes, and returns the page to open first.
/// Each file is written whole or not at all. Throws BadInput when the folder cannot be written.
std::filesystem::path write_site(const Results&, const Reference&, const std::filesystem::path& folder,
                                 const Progress& progress = {}, std::span<const EngineContest> contests = {},
                                 const Trust& = {});

}  // namespace oddity
