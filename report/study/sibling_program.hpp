#pragma once

#include <filesystem>
#include <optional>
#include <string>

/// Finds the files that belong to this program: in the build that it runs from, or in the prefix that it is
/// installed in. It knows only one of them: an installed program looks in no tree.
namespace oddity {

/// The program's own file. Throws BadInput if /proc is not mounted.
std::filesystem::path program_file();
/// The tree of a program that runs from its build; empty for one that is installed.
std::filesystem::path own_tree();
/// share/oddity of an installed program.
std::filesystem::path own_data();
/// The folder of the code that it loads and runs: its build, or lib/oddity.
std::filesystem::path own_code();

/// Throws BadInput if anyone except root, this user and whoever installed the program may write to the
/// installed file or folder, or to anything in it. Such code is not run.
void require_own(const std::filesystem::path& code);

std::string program_as_typed();  ///< "oddity" if installed, "./oddity" in the tree
/// "" in the tree, whose entry script builds missing parts; otherwise the place to build them: "in a clone of
/// ... ".
std::string where_to_build();

/// Path of one of this program's libraries.
std::optional<std::filesystem::path> own_library(const std::string& name);

/// The library's function of that name, loaded for as long as the program runs. Throws BadInput if the file
/// is no library or has no such function.
void* function_in(const std::filesystem::path& library, const std::string& name);

template <class Function>
Function* function_of(const std::filesystem::path& library, const std::string& name) {
  return reinterpret_cast<Function*>(function_in(library, name));
}

}  // namespace oddity
