#include "problem/abbreviations.hpp"

#include <algorithm>

namespace oddity::problem {

Abbreviations::Abbreviations(const File& file, const ModelText& model)
    : source_(file.source), texts_(file.given) {
  const bool moves = model.closed.empty();
  if (moves) texts_.insert(texts_.end(), model.vectors.begin(), model.vectors.end());
  formulas_.resize(texts_.size());
  for (const ParameterText& p : file.parameters) letters_.parameters.push_back(p.name);
  for (const auto& [name, formula] : texts_) letters_.given.push_back(name.text);
  const auto add = [&](const std::string& unknown) {
    if (std::ranges::find(letters_.unknowns, unknown) == letters_.unknowns.end())
      letters_.unknowns.push_back(unknown);
  };
  letters_.tables = file.tables;
  if (!moves) return;
  for (const auto& [key, formula] : model.start) add(key.text.substr(0, key.text.find('\'')));
  for (const EventText& event : model.events)
    if (!event.counts.text.empty()) add(event.counts.text);
}

const Formula& Abbreviations::operator[](std::size_t i) {
  if (!formulas_[i]) formulas_[i] = Formula(source_, texts_[i].second, letters_);
  return *formulas_[i];
}

Shape Abbreviations::shape(const Formula& of) {
  return of.shape([&](const Letter& letter) -> Shape {
    if (letter.is != Letter::Is::given) return {{1}};
    if (const auto known = shapes_.find(letter.index); known != shapes_.end()) return known->second;
    const Formula& abbreviation = (*this)[letter.index];
    const Inside inside(*this, abbreviation);
    return shapes_.emplace(letter.index, shape(abbreviation)).first->second;
  });
}

}  // namespace oddity::problem
