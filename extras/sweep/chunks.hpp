#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "extras/sweep/plan.hpp"
#include "report/study/parallel.hpp"

/// A sweep's folder: plan.json, and a file for each finished chunk, complete or absent.
namespace oddity::sweep {

std::filesystem::path plan_file(const std::filesystem::path& folder);
std::filesystem::path chunk_file(const std::filesystem::path& folder, std::size_t chunk);

/// Computes a chunk's cells. `tick` is called before each tile, and may throw to end it.
std::vector<Tile> worked_out(const Plan&, std::size_t chunk, const Look&,
                             const std::function<void()>& tick = {});

/// Throws BadInput if it cannot be written.
void keep(const std::filesystem::path& folder, const Plan&, std::size_t chunk, const std::vector<Tile>&);
/// nullopt if the file is missing or damaged. Throws BadInput if it belongs to another sweep.
std::optional<std::vector<Tile>> kept(const std::filesystem::path& folder, const Plan&, std::size_t chunk);

/// The chunks that are not kept, the heaviest first.
std::vector<std::size_t> missing(const std::filesystem::path& folder, const Plan&);

/// The shard's chunks: in order of their weight, dealt out like cards.
std::vector<std::size_t> dealt(const Plan&, const std::vector<std::size_t>& chunks, const Shard&);

/// Computes these chunks and keeps them, each thread one after the other. Rethrows a chunk's exception once
/// the others under way are kept.
void work_through(const std::filesystem::path& folder, const Plan&, const std::vector<std::size_t>& chunks,
                  int threads, const Reference&, const Progress& = {});

}  // namespace oddity::sweep
