#include "tests/mutation/record.hpp"

#include <fstream>
#include <iomanip>
#include <sstream>

#include "reference/bad_input.hpp"
#include "reference/csv.hpp"

namespace oddity::mutation {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t name_cells = 5;
constexpr std::string_view name_columns = "file,function,line,mutation,occurrence";

std::string quoted(const std::string& cell) {
  std::string text = "\"";
  for (const char c : cell) {
    if (c == '"' || c == '\\') text += '\\';
    text += c;
  }
  return text + "\"";
}

std::string cells_of(const Mutant& m) {
  return m.file + "," + quoted(m.function) + "," + quoted(m.line) + "," + quoted(m.mutation) + "," +
         std::to_string(m.occurrence);
}

std::string name_in(const CsvRow& row) {
  Mutant m;
  m.file = row.cells[0];
  m.function = row.cells[1];
  m.line = row.cells[2];
  m.mutation = row.cells[3];
  m.occurrence = static_cast<int>(row.number(4));
  return m.name();
}

CsvFile read_named(const fs::path& file, const std::string& others) {
  const CsvFile csv = read_csv(file);
  std::string columns;
  for (const std::string& cell : csv.header.cells) columns += (columns.empty() ? "" : ",") + cell;
  const std::string right = std::string(name_columns) + "," + others;
  if (columns != right) throw BadInput(csv.header.place + ": its columns are " + columns + ", not " + right);
  return csv;
}

Fate fate_in(const CsvRow& row) {
  for (const Fate f : {Fate::killed, Fate::survived, Fate::not_reached})
    if (name_of(f) == row.cells[name_cells]) return f;
  throw BadInput(row.place + ": '" + row.cells[name_cells] + "' is not killed, survived or not reached");
}

/// chapters, solvers, reference or report.
std::string room_of(const Mutant& m) { return m.file.substr(0, m.file.find('/')); }

}  // namespace

Reasons read_reasons(const fs::path& file) {
  Reasons reasons;
  if (!fs::exists(file)) return reasons;
  for (const CsvRow& row : read_named(file, "reason").rows) {
    if (row.cells[name_cells].empty()) throw BadInput(row.place + ": a survivor needs a reason");
    if (!reasons.emplace(name_in(row), row.cells[name_cells]).second)
      throw BadInput(row.place + ": this survivor has a row already");
  }
  return reasons;
}

Outcomes::Outcomes(fs::path file, bool killed_alone) : file_(std::move(file)) {
  if (!fs::exists(file_)) return;
  for (const CsvRow& row : read_named(file_, "outcome,by").rows) {
    const Judgement judgement{fate_in(row), row.cells[name_cells + 1]};
    all_.erase(name_in(row));
    if (!killed_alone || judgement.fate == Fate::killed) all_[name_in(row)] = judgement;
  }
}

const Judgement* Outcomes::of(const Mutant& m) const {
  const auto at = all_.find(m.name());
  return at == all_.end() ? nullptr : &at->second;
}

void Outcomes::add(const Mutant& m, const Judgement& judgement) {
  all_[m.name()] = judgement;
  const bool fresh = !fs::exists(file_);
  std::ofstream out(file_, std::ios::app);
  if (fresh) out << name_columns << ",outcome,by\n";
  out << cells_of(m) << "," << name_of(judgement.fate) << "," << quoted(judgement.by) << std::endl;
  if (!out) throw BadInput("cannot write to " + file_.string());
}

Scores scores_of(const std::vector<Mutant>& all, const Outcomes& outcomes, const Reasons& reasons) {
  Scores scores;
  for (const Mutant& m : all) {
    Score& score = scores[room_of(m)];
    ++score.mutants;
    const Judgement* judgement = outcomes.of(m);
    if (!judgement) continue;
    ++score.tried;
    if (judgement->fate == Fate::killed)
      ++score.killed;
    else if (judgement->fate == Fate::not_reached)
      ++score.not_reached;
    else
      ++(reasons.contains(m.name()) ? score.with_reason : score.survived);
  }
  return scores;
}

std::string text_of(const Scores& scores) {
  std::ostringstream out;
  out << std::left << std::setw(10) << "room" << std::right;
  for (const char* column : {"mutants", "tried", "killed", "with reason", "survived", "not reached"})
    out << std::setw(13) << column;
  out << "\n";
  for (const auto& [room, s] : scores) {
    out << std::left << std::setw(10) << room << std::right;
    for (const int n : {s.mutants, s.tried, s.killed, s.with_reason, s.survived, s.not_reached})
      out << std::setw(13) << n;
    out << "\n";
  }
  return out.str();
}

std::string csv_of(const Scores& scores, const std::string& date, const std::string& commit) {
  std::ostringstream out;
  out << "# Mutants tried by the suite, as oddity_mutate --record wrote it; with_reason: survivors of survivors.csv.\n"
      << "date,commit,room,mutants,tried,killed,with_reason,survived,not_reached\n";
  for (const auto& [room, s] : scores)
    out << date << "," << commit << "," << room << "," << s.mutants << "," << s.tried << "," << s.killed
        << "," << s.with_reason << "," << s.survived << "," << s.not_reached << "\n";
  return out.str();
}

std::string row_of(const Mutant& m) { return cells_of(m) + ",\n"; }

}  // namespace oddity::mutation
