#include "extras/mutation/record.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <set>
#include <sstream>
#include <tuple>

#include "reference/bad_input.hpp"
#include "reference/csv.hpp"
#include "reference/files.hpp"

namespace oddity::mutation {

namespace fs = std::filesystem;

namespace {

std::string quoted(const std::string& cell) {
  std::string text = "\"";
  for (const char c : cell) {
    if (c == '"' || c == '\\') text += '\\';
    text += c;
  }
  return text + "\"";
}

/// The rows of a file with these columns; empty if there is no file.
std::vector<CsvRow> rows_of(const fs::path& file, const std::string& right) {
  if (!fs::exists(file)) return {};
  const CsvFile csv = read_csv(file);
  std::string columns;
  for (const std::string& cell : csv.header.cells) columns += (columns.empty() ? "" : ",") + cell;
  if (columns != right) throw BadInput(csv.header.place + ": its columns are " + columns + ", not " + right);
  return csv.rows;
}

Fate fate_in(const CsvRow& row) {
  for (const Fate f : {Fate::killed, Fate::survived, Fate::not_reached})
    if (name_of(f) == row.cells[1]) return f;
  throw BadInput(row.place + ": '" + row.cells[1] + "' is not killed, survived or not reached");
}

const std::string near_miss = "a near miss: another wrong formula, as far off as recorded";

const std::string survivor_columns = "id,room,file,change,reason";
const std::string outcome_columns = "id,outcome,by";
const std::string score_columns =
    "date,commit,room,mutants,free,tried,killed,with_reason,survived,first_tried,first_killed";

}  // namespace

Survivors read_survivors(const fs::path& file) {
  Survivors survivors;
  for (const CsvRow& row : rows_of(file, survivor_columns))
    if (!survivors.emplace(row.cells[0], Survivor{row.cells[1], row.cells[2], row.cells[3], row.cells[4]})
             .second)
      throw BadInput(row.place + ": this survivor has a row already");
  return survivors;
}

Survivors updated(Survivors survivors, const std::vector<Mutant>& all, const std::vector<Mutant>& tried,
                  const Outcomes& outcomes) {
  std::set<std::string> files, ids;
  for (const Mutant& m : all) files.insert(m.file), ids.insert(m.id());
  std::erase_if(survivors,
                [&](const auto& row) { return files.contains(row.second.file) && !ids.contains(row.first); });
  for (const Mutant& m : tried) {
    const Judgement* judgement = outcomes.of(m);
    if (judgement->fate == Fate::killed) {
      survivors.erase(m.id());
      continue;
    }
    Survivor& row = survivors.try_emplace(m.id(), Survivor{m.room(), m.file, m.change(), ""}).first->second;
    if (m.in_near_miss && row.reason.empty()) row.reason = near_miss;
  }
  return survivors;
}

std::string csv_of(const Survivors& survivors) {
  std::vector<std::pair<std::string, Survivor>> rows(survivors.begin(), survivors.end());
  std::ranges::sort(rows, {}, [](const auto& row) { return std::tie(row.second.file, row.second.change); });
  std::string text =
      "# Mutants that the suite does not kill, as found by oddity_mutate --record. `reason`: why no test has "
      "to kill it,\n# written by hand except for near misses; if empty, a test is missing. `change`: function, line, "
      "mutation.\n" +
      survivor_columns + "\n";
  for (const auto& [id, s] : rows)
    text += id + "," + s.room + "," + s.file + "," + quoted(s.change) + "," + quoted(s.reason) + "\n";
  return text;
}

Outcomes::Outcomes(fs::path file, bool killed_alone) : file_(std::move(file)) {
  for (const CsvRow& row : rows_of(file_, outcome_columns)) {
    const Judgement judgement{fate_in(row), row.cells[2]};
    all_.erase(row.cells[0]);
    if (!killed_alone || judgement.fate == Fate::killed) all_[row.cells[0]] = judgement;
  }
  if (killed_alone && fs::exists(file_)) write();
}

void Outcomes::write() const {
  std::string text = outcome_columns + "\n";
  for (const auto& [id, judgement] : all_)
    text += id + "," + std::string(name_of(judgement.fate)) + "," + quoted(judgement.by) + "\n";
  write_whole(file_, text);
}

const Judgement* Outcomes::of(const Mutant& m) const {
  const auto at = all_.find(m.id());
  return at == all_.end() ? nullptr : &at->second;
}

void Outcomes::add(const Mutant& m, const Judgement& judgement) {
  all_[m.id()] = judgement;
  const bool fresh = !fs::exists(file_);
  std::ofstream out(file_, std::ios::app);
  if (fresh) out << outcome_columns << "\n";
  out << m.id() << "," << name_of(judgement.fate) << "," << quoted(judgement.by) << std::endl;
  if (!out) throw BadInput("cannot write to " + file_.string());
}

Scores scores_of(const std::vector<Mutant>& all, const std::vector<Mutant>& tried, const Outcomes& outcomes,
                 const Survivors& survivors) {
  Scores scores;
  for (const Mutant& m : all) ++scores[m.room()].mutants;
  for (const Mutant& m : tried) {
    Score& score = scores[m.room()];
    ++score.tried;
    const Judgement* judgement = outcomes.of(m);
    const auto known = survivors.find(m.id());
    if (judgement->fate == Fate::killed)
      ++score.killed;
    else
      ++(known != survivors.end() && !known->second.reason.empty() ? score.with_reason : score.survived);
  }
  std::erase_if(scores, [](const auto& room) { return room.second.tried == 0; });
  for (auto& [room, score] : scores) score.first_tried = score.tried, score.first_killed = score.killed;
  return scores;
}

Score after_again(Score score, const std::string& room, const Survivors& before, const Survivors& left,
                  const std::set<std::string>& killed) {
  int without_reason = 0;
  for (const auto& [id, s] : before) {
    if (s.room != room || left.contains(id)) continue;
    --(s.reason.empty() ? score.survived : score.with_reason);
    if (killed.contains(id))
      ++score.killed;
    else
      --score.tried;
  }
  for (const auto& [id, s] : left)
    if (s.room == room && s.reason.empty()) ++without_reason;
  score.with_reason += score.survived - without_reason;
  score.survived = without_reason;
  return score;
}

std::vector<std::string> noticed_less(const Scores& now, const Scores& on_record) {
  const auto tried = [](const Score& s) { return std::max(1.0, static_cast<double>(s.first_tried)); };
  const auto share = [&](const Score& s) { return s.first_killed / tried(s); };
  std::vector<std::string> rooms;
  for (const auto& [room, score] : now) {
    const auto found = on_record.find(room);
    const bool is_new = found == on_record.end();
    const double p = is_new ? 1 : share(found->second);
    const double before = is_new ? 1 : tried(found->second);
    const double varies = p * (1 - p) * (1 / before + 1 / tried(score));
    if (share(score) < p - 3 * std::sqrt(varies)) rooms.push_back(room);
  }
  return rooms;
}

std::string text_of(const Scores& scores) {
  std::ostringstream out;
  out << std::left << std::setw(32) << "room" << std::right;
  for (const char* column : {"mutants", "tried", "killed", "with reason", "survived"})
    out << std::setw(13) << column;
  out << "\n";
  for (const auto& [room, s] : scores) {
    out << std::left << std::setw(32) << room << std::right;
    for (const int n : {s.mutants, s.tried, s.killed, s.with_reason, s.survived}) out << std::setw(13) << n;
    out << "\n";
  }
  return out.str();
}

Scores read_scores(const fs::path& file) {
  Scores scores;
  for (const CsvRow& row : rows_of(file, score_columns)) {
    const auto count = [&](std::size_t i) { return static_cast<int>(row.number(i)); };
    scores[row.cells[2]] = {row.cells[0], row.cells[1], count(3), count(4), count(5),
                            count(6),     count(7),     count(8), count(9), count(10)};
  }
  return scores;
}

std::string csv_of(const Scores& scores) {
  std::ostringstream out;
  out << "# Mutants, and the outcomes of those tried, drawn at random, as recorded by oddity_mutate --record at "
         "that commit.\n"
         "# mutants: their number in the mutated files of the room; free: mutants that are not made, in code "
         "that draws samples\n# or writes numbers as text.\n"
         "# tried = killed + with_reason + survived; with_reason: survivors with a reason in survivors.csv. "
         "Mutants in code that\n# no test runs survive. first_tried, first_killed: numbers of the first sample, before "
         "tests were mended for it.\n# Rooms without a row were not tried.\n"
      << score_columns << "\n";
  for (const auto& [room, s] : scores)
    out << s.date << "," << s.commit << "," << room << "," << s.mutants << "," << s.free << "," << s.tried
        << "," << s.killed << "," << s.with_reason << "," << s.survived << "," << s.first_tried << ","
        << s.first_killed << "\n";
  return out.str();
}

}  // namespace oddity::mutation
