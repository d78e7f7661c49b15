#pragma once

#include <filesystem>
#include <optional>
#include <string>

/// Where what belongs to this program is: in the build that it runs from, or in the prefix that it is
/// installed in. Of these it knows one alone: an installed program looks in no tree.
namespace oddity {

/// The program's own file. Throws BadInput where /proc is not mounted.
std::filesystem::path program_file();
/// The tree of a program that runs from its build; empty for one that is installed.
std::filesystem::path own_tree();
/// share/oddity of an installed program.
std::filesystem::path own_data();
/// What it loads and runs: its build, or lib/oddity.
std::filesystem::path own_code();

/// Throws BadInput where the installed file or folder, with all in it, may be written by others than root,
/// this user and who installed the program: it is not run.
void require_own(const std::filesystem::path& code);

std::string program_as_typed();  ///< "oddity" where it is installed, "./oddity" in the tree
/// "" in the tree, whose entry builds what is missing; else where that has to be done: "in a clone of ... ".
std::string where_to_build();

/// A library of this program's; where it is.
std::optional<std::filesystem::path> own_library(const std::string& name);

/// The library's function of that name, loaded for as long as the program runs. Throws BadInput where the
/// file is no library, or has no such function.
void* function_in(const std::filesystem::path& library, const std::string& name);

template <class Function>
Function* function_of(const std::filesystem::path& library, const std::string& name) {
  return reinterpret_cast<Function*>(function_in(library, name));
}

}  // namespace oddity
