#include "report/commands.hpp"
#include <iostream>
#include "reference/bad_input.hpp"
#include "reference/text.hpp"
#include "report/run.hpp"
#include "report/settings.hpp"
#include "report/text_view.hpp"

namespace oddity {
int command_line(int argc, char** argv) {
  try {
    const Reference truth(reference_folder());
    for (const Entry& e : registry()) {
      if (argc > 2 && to_string(e.number) != argv[2]) continue;
      Task task(e);
      for (int i = 3; i < argc; ++i) {
        std::string a = argv[i];
        auto eq = a.find('=');
        task.parameters.set(a.substr(0, eq), number_in(a.substr(eq + 1)).value());
      }
      const Results r = run(std::span(&task, 1), truth, false);
      std::cout << text_view(r.exercises[0]);
      for (auto& c : r.exercises[0].claims) {
        auto show = [&](const char* n, const Reading& g) {
          for (auto& k : g.checks)
            std::cout << c.claim.id << " " << n << " " << (k.holds() ? "holds " : "FAILS ") << k.quantity
                      << ": " << shown(k.left.value, 17) << " | " << shown(k.right.value, 17) << " diff "
                      << shown_error(k.difference()) << " tol " << shown_error(k.tolerance.allowed) << " "
                      << k.where << "\n";
        };
        show("printed", c.claim.printed);
        show("meant", c.claim.meant);
        show("corrected", c.claim.corrected);
        for (auto& m : c.claim.near_misses) show("near", m);
      }
    }
  } catch (const BadInput& e) {
    std::cerr << "oddity: " << e.what() << "\n";
    return 2;
  }
  return 0;
}
}  // namespace oddity
