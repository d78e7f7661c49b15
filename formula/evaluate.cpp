#include "formula/evaluate.hpp"

namespace oddity::formula {

template class Evaluation<double>;

}  // namespace oddity::formula
