#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "extras/sweep/plan.hpp"
#include "report/study/parallel.hpp"

/// A sweep's folder: plan.json, and a file for each chunk that is done, whole or not there.
namespace oddity::sweep {

std::filesystem::path plan_file(const std::filesystem::path& folder);
std::filesystem::path chunk_file(const std::filesystem::path& folder, std::size_t chunk);

/// Looks at a chunk's cells. `tick` is called before each tile; what it throws ends it.
std::vector<Tile> worked_out(const Plan&, std::size_t chunk, const Look&,
                             const std::function<void()>& tick = {});

/// Throws BadInput when it cannot be written.
void keep(const std::filesystem::path& folder, const Plan&, std::size_t chunk, const std::vector<Tile>&);
/// Nothing when the file is not there, or not as it was written. Throws BadInput when it is of another sweep.
std::optional<std::vector<Tile>> kept(const std::filesystem::path& folder, const Plan&, std::size_t chunk);

/// Those that are not kept, the heaviest first.
std::vector<std::size_t> missing(const std::filesystem::path& folder, const Plan&);

/// The chunks in the order of their weight, dealt out like cards.
std::vector<std::size_t> dealt(const Plan&, const std::vector<std::size_t>& chunks, const Shard&);

/// Works out these chunks and keeps them, each thread one after the other. Throws what a chunk throws, when
/// the others under way are kept.
void work_through(const std::filesystem::path& folder, const Plan&, const std::vector<std::size_t>& chunks,
                  int threads, const Reference&, const Progress& = {});

}  // namespace oddity::sweep
