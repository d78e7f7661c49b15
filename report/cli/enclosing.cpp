#include "report/cli/enclosing.hpp"

#ifdef ODDITY_ARB
#include "reference/enclosures/enclose.hpp"

oddity::Enclosing oddity::enclosing() { return enclosed_on_demand; }
#else
#include "reference/bad_input.hpp"
#include "report/study/sibling_program.hpp"

oddity::Enclosing oddity::enclosing() {
  throw BadInput("--enclosed: this program was built without Arb, which computes enclosures; " +
                 where_to_build() +
                 "'./oddity packages "
                 "libflint-dev libflint-arb-dev' and 'cmake --preset release' have the next build find it");
}
#endif
